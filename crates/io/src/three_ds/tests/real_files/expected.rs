//! The list of what is expected.

use super::super::super::{Document, decode};
use ron::Value;
use std::path::{Path, PathBuf};

#[allow(clippy::print_stderr, reason = "a test that is skipped has to say so")]
pub(super) fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("TRAYLIB_DATA").map(|folder| Path::new(&folder).join("3ds"));
    if folder.is_none() {
        eprintln!("skipped: TRAYLIB_DATA names no folder with 3ds/expected.json");
    }
    folder
}

/// Every file with what is expected of it. JSON is RON but for its name for
/// nothing.
pub(super) fn expectations(folder: &Path) -> Vec<(String, Document, Value)> {
    let text = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let expected: Value = ron::from_str(&text.replace(": null", ": None")).unwrap();
    let Value::Map(files) = get(&expected, "files") else { panic!("no map of files") };
    let read = |(name, expected): (&Value, &Value)| {
        let name = text_of(name);
        let document = decode(&std::fs::read(folder.join(&name)).unwrap()).unwrap();
        (name, document, expected.clone())
    };
    files.iter().map(read).collect()
}

pub(super) fn find<'a>(value: &'a Value, key: &str) -> Option<&'a Value> {
    let Value::Map(map) = value else { panic!("{key}: not in a map") };
    map.get(&Value::String(key.to_string()))
}

pub(super) fn get<'a>(value: &'a Value, key: &str) -> &'a Value {
    find(value, key).unwrap_or_else(|| panic!("{key} is missing"))
}

pub(super) fn text_of(value: &Value) -> String {
    let Value::String(text) = value else { panic!("{value:?} is no text") };
    text.clone()
}

pub(super) fn list_of(value: &Value) -> &[Value] {
    let Value::Seq(values) = value else { panic!("{value:?} is no list") };
    values
}

#[expect(clippy::wildcard_enum_match_arm, reason = "lists hold nothing else")]
pub(super) fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(number) => vec![number.into_f64()],
        Value::Seq(values) => values.iter().flat_map(numbers).collect(),
        Value::Option(None) => Vec::new(),
        other => panic!("{other:?} is no number"),
    }
}

fn wide(values: &[f32]) -> Vec<f64> {
    values.iter().copied().map(f64::from).collect()
}

/// Tells whether numbers agree within 10⁻⁴ of their size; within 10⁻⁴ below one.
fn agree(found: &[f32], expected: &Value) -> bool {
    let (found, expected) = (wide(found), numbers(expected));
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-4 * b.abs().max(1.0);
    found.len() == expected.len() && found.iter().zip(&expected).all(close)
}

pub(super) fn check(what: &str, found: &[f32], expected: &Value) {
    assert!(agree(found, expected), "{what}: {found:?}, expected {expected:?}");
}

pub(super) fn optional<T: Copy + Into<f64>>(value: Option<T>) -> Vec<f32> {
    value.into_iter().map(|value| value.into() as f32).collect()
}
