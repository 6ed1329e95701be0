//! "Did you mean …?"

/// The candidate that the user most likely meant by the misspelt `word`, if a candidate is near enough.
///
/// A candidate is near if at most a third of its letters differ from the word, or one letter of a short word. Two
/// swapped neighbouring letters count as one difference, and upper and lower case count as equal. If several candidates
/// are equally near, the first of these candidates wins.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // Computing the distance takes time in proportion to the product of both lengths.
    const LONGEST: usize = 100;
    if word.len() > LONGEST {
        return None;
    }
    // Limits the time to a fraction of a second for the longest words.
    const MOST: usize = 10_000;
    let lower = word.to_lowercase();
    let letters = lower.chars().count();
    let allowed = (letters / 3).max(1);
    candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= LONGEST)
        .filter(|candidate| candidate.chars().count().abs_diff(letters) <= allowed + 1)
        .take(MOST)
        .map(|candidate| (strsim::osa_distance(&lower, &candidate.to_lowercase()), candidate))
        .filter(|(distance, candidate)| {
            *distance <= allowed && *distance < candidate.chars().count()
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn finds_typing_errors_and_rejects_other_words() {
        let keys = ["stiffness", "shear_stiffness", "damping"];
        assert_eq!(nearest("stifness", keys), Some("stiffness"));
        assert_eq!(nearest("dampnig", keys), Some("damping"));
        assert_eq!(nearest("Damping", keys), Some("damping"));
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest(&"x".repeat(1000), keys), None);
        assert_eq!(nearest("", keys), None);
    }
}
