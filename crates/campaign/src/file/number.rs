//! Reads numbers of a campaign in the unit that the user wrote: a campaign computes in that unit.

/// The number at the beginning of a text, and its unit.
///
/// # Errors
/// Gives the reason why the text does not begin with a number.
pub(super) fn split(text: &str) -> Result<(f64, &str), String> {
    let text = text.trim();
    let is_of_number = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    let mut end = text.find(|c: char| !is_of_number(c)).unwrap_or(text.len());
    while end > 0 {
        if let Ok(value) = text[..end].parse::<f64>()
            && value.is_finite()
        {
            return Ok((value, text[end..].trim()));
        }
        end -= 1;
    }
    Err(format!("\"{text}\" does not begin with a number"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_units() {
        assert_eq!(split("7.1 cm/s"), Ok((7.1, "cm/s")));
        assert_eq!(split("-5deg"), Ok((-5.0, "deg")));
        assert_eq!(split(" 1e-3 m"), Ok((1e-3, "m")));
        assert_eq!(split("2 erg"), Ok((2.0, "erg")));
        assert_eq!(split("2erg"), Ok((2.0, "erg")));
        assert_eq!(split("13"), Ok((13.0, "")));
        assert_eq!(split("9 m draught"), Ok((9.0, "m draught")));
        assert!(split("fast").is_err());
        assert!(split("1e999").is_ok_and(|(value, _)| value.is_finite()));
    }
}
