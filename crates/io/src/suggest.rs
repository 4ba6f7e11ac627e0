//! "Did you mean".

/// The candidate nearest to a misspelt word, if one is near: at most a third of
/// its letters differ, and case does not count.
pub(crate) fn nearest<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let word = word.to_lowercase();
    let distance = |candidate: &str| strsim::damerau_levenshtein(&word, &candidate.to_lowercase());
    let (distance, best) =
        candidates.into_iter().map(|c| (distance(c), c)).min_by_key(|&(d, _)| d)?;
    let near = distance <= (best.chars().count() / 3).max(1);
    near.then_some(best)
}

/// Names in backquotes with commas between.
pub(crate) fn quoted_list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
    names.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_understood() {
        let fields = ["diffuse", "specular", "exponent"];
        assert_eq!(nearest("exponnt", fields), Some("exponent"));
        assert_eq!(nearest("Specualr", fields), Some("specular"));
        assert_eq!(nearest("colour", fields), None);
        assert_eq!(nearest("x", []), None);
    }
}
