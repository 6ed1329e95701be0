//! The names of fenders and dolphins in a row: NAME_1, NAME_2 and so on.

/// The name of the fender or dolphin with the number `number` in a row; the numbers start from 1.
pub fn name_in_row(row: &str, number: usize) -> String {
    format!("{row}_{number}")
}

/// The number in the row `row` of the fender or dolphin `name`; `None` if the name is not a name in this row.
pub fn number_in_row(row: &str, name: &str) -> Option<usize> {
    let digits = name.strip_prefix(row)?.strip_prefix('_')?;
    let is_number = !digits.starts_with('0') && digits.bytes().all(|byte| byte.is_ascii_digit());
    digits.parse().ok().filter(|_| is_number)
}

#[cfg(test)]
mod tests {
    use super::{name_in_row, number_in_row};

    #[test]
    fn members_are_numbered_from_one() {
        assert_eq!(name_in_row("a", 12), "a_12");
        assert_eq!(number_in_row("a", "a_12"), Some(12));
        for other in ["a_0", "a_012", "a_", "a_+1", "a12", "b_1", "a_1x", "a"] {
            assert_eq!(number_in_row("a", other), None, "{other}");
        }
    }
}
