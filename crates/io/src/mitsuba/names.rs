//! The names of properties in files of older versions.

/// The name that version 3 has for a property of versions 0.5 and 0.6: `toWorld` is `to_world`,
/// `intIOR` is `int_ior`.
pub(super) fn modern(name: &str) -> String {
    let mut modern = String::with_capacity(name.len() + 4);
    let mut was_small = false;
    for letter in name.chars() {
        if letter.is_ascii_uppercase() && was_small {
            modern.push('_');
        }
        was_small = letter.is_ascii_lowercase();
        modern.push(letter.to_ascii_lowercase());
    }
    modern
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn capitals_begin_words() {
        for (old, new) in [
            ("toWorld", "to_world"),
            ("intIOR", "int_ior"),
            ("fovAxis", "fov_axis"),
            ("specularReflectance", "specular_reflectance"),
            ("alpha", "alpha"),
            ("maxDepth", "max_depth"),
        ] {
            assert_eq!(modern(old), new);
        }
    }
}
