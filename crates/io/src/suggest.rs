//! "Did you mean".

/// Words that are tried first, and what they may be meant for.
const SYNONYMS: [(&str, &[&str]); 12] = [
    ("color", &["intensity", "emission", "reflectance", "diffuse"]),
    ("colour", &["intensity", "emission", "reflectance", "diffuse"]),
    ("power", &["intensity", "emission"]),
    ("radiance", &["emission"]),
    ("albedo", &["reflectance", "diffuse"]),
    ("roughness", &["exponent"]),
    ("ior", &["index"]),
    ("lookat", &["target"]),
    ("wrap", &["Repeat"]),
    ("clamp", &["Once"]),
    ("cube", &["Box"]),
    ("diffuse", &["Lambert"]),
];

/// Longer words are not compared: the time goes with the square of their length.
const LONGEST: usize = 100;

/// Names of a list that are shown.
const MOST_LISTED: usize = 16;

/// The candidate nearest to a misspelt word, if one is near: at most a third of
/// its letters differ, and case does not count. Else one that means the same.
pub(crate) fn nearest<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    if word.len() > LONGEST {
        return None;
    }
    let word = word.to_lowercase();
    let distance = |candidate: &str| strsim::damerau_levenshtein(&word, &candidate.to_lowercase());
    let candidates: Vec<&str> = candidates.into_iter().filter(|c| c.len() <= LONGEST).collect();
    let (distance, best) = candidates.iter().map(|&c| (distance(c), c)).min_by_key(|&(d, _)| d)?;
    let near = distance <= (best.chars().count() / 3).max(1);
    if near { Some(best) } else { synonym(&word, &candidates) }
}

fn synonym<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let (_, meant) = SYNONYMS.iter().find(|(known, _)| *known == word)?;
    meant.iter().find_map(|meant| candidates.iter().find(|c| *c == meant)).copied()
}

/// Names in backquotes with commas between; of many, the first.
pub(crate) fn quoted_list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut names = names.into_iter();
    let first: Vec<String> =
        names.by_ref().take(MOST_LISTED).map(|name| format!("`{}`", shown(name))).collect();
    match names.count() {
        0 => first.join(", "),
        more => format!("{} and {more} more", first.join(", ")),
    }
}

/// A name for a message: as it is, or its beginning.
pub(crate) fn shown(name: &str) -> String {
    const LONGEST: usize = 60;
    match name.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_understood() {
        let fields = ["diffuse", "specular", "exponent"];
        assert_eq!(nearest("exponnt", fields), Some("exponent"));
        assert_eq!(nearest("Specualr", fields), Some("specular"));
        assert_eq!(nearest("sheen", fields), None);
        assert_eq!(nearest("x", []), None);
    }

    #[test]
    fn other_words_for_the_same_are_understood() {
        assert_eq!(nearest("color", ["position", "intensity"]), Some("intensity"));
        assert_eq!(nearest("Wrap", ["Repeat", "Mirror", "Once"]), Some("Repeat"));
        assert_eq!(nearest("color", ["position"]), None);
    }

    #[test]
    fn lists_and_names_of_any_length_are_short() {
        let names: Vec<String> = (0..2000).map(|n| n.to_string()).collect();
        let list = quoted_list(names.iter().map(String::as_str));
        assert!(list.starts_with("`0`, `1`, ") && list.ends_with("`15` and 1984 more"), "{list}");
        assert_eq!(shown(&"x".repeat(1000)).chars().count(), 61);
        assert_eq!(nearest(&"x".repeat(1_000_000), ["x"]), None);
    }
}
