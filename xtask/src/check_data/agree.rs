//! Figures against figures.

use serde_json::Value;

/// Relative, of numbers that are not whole: others sum in another order.
const TOLERANCE: f64 = 1e-4;

/// Lists the differences between what was expected and what was found; keys that were not looked
/// for are left alone, but one that is found must be expected.
pub(super) fn differences(expected: &Value, found: &Value) -> Vec<String> {
    let Some(keys) = found.as_object() else {
        return vec![String::from("nothing was found")];
    };
    let differs = |(key, found): (&String, &Value)| {
        let expected = expected.get(key).unwrap_or(&Value::Null);
        (!agree(expected, found)).then(|| format!("{key}: found {found}, expected {expected}"))
    };
    keys.iter().filter_map(differs).collect()
}

fn agree(expected: &Value, found: &Value) -> bool {
    match (expected, found) {
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| agree(a, b))
        }
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| agree(a, b)))
        }
        (Value::Number(a), Value::Number(b)) => match (a.as_u64(), b.as_u64()) {
            (Some(a), Some(b)) => a == b,
            _ => a.as_f64().zip(b.as_f64()).is_some_and(|(a, b)| near(a, b)),
        },
        _ => expected == found,
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= TOLERANCE * a.abs().max(b.abs()).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn counts_are_exact_and_lengths_nearly() {
        let expected = json!({"faces": 12, "box": [0.0, 1.5], "more": 1});
        assert!(differences(&expected, &json!({"faces": 12, "box": [1e-6, 1.500_01]})).is_empty());
        for wrong in [json!({"faces": 13}), json!({"box": [0.0, 1.6]}), json!({"new": 1})] {
            assert_eq!(differences(&expected, &wrong).len(), 1, "{wrong}");
        }
        assert!(!differences(&expected, &json!(7)).is_empty());
    }

    #[test]
    fn maps_have_the_same_keys() {
        let expected = json!({"by_kind": {"f": 3}});
        assert!(!differences(&expected, &json!({"by_kind": {"f": 3, "sph": 1}})).is_empty());
        assert!(differences(&expected, &json!({"by_kind": {"f": 3}})).is_empty());
    }
}
