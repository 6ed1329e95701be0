//! A column of a table: its title and its cells.

/// The title of a column: its name in small letters, with `_` between words, and its unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Title {
    pub(super) plain: String,
    pub(super) unit: String,
}

impl Title {
    /// Takes a title such as `Bow Dist. (ft)` apart.
    pub(super) fn of(head: &str) -> Title {
        let head = head.trim().trim_start_matches('\u{feff}');
        let within =
            |open, close| head.strip_suffix(close).and_then(|rest: &str| rest.rsplit_once(open));
        let parts = within('[', ']').or_else(|| within('(', ')'));
        let (name, unit) = parts.unwrap_or((head, ""));
        let lower = name.to_lowercase();
        let words = lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        Title { plain: words.collect::<Vec<_>>().join("_"), unit: unit.trim().to_owned() }
    }
}

/// The place of a column in a table, and the factor of its numbers to SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Column {
    pub(super) place: usize,
    pub(super) factor: f64,
}

/// A number of a cell, and the step of its last digit; `None` for an empty cell or another text.
pub(super) fn number(cell: &str, has_decimal_comma: bool) -> Option<(f64, f64)> {
    let cell = cell.trim();
    let text = if has_decimal_comma { cell.replace(',', ".") } else { cell.to_owned() };
    let value = text.parse::<f64>().ok().filter(|value| value.is_finite())?;
    let digits = text.split(['e', 'E']).next().unwrap_or_default();
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    Some((value, libm::pow(10.0, -(decimals.min(15) as f64))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_name_and_unit() {
        let of = |head: &str| {
            let title = Title::of(head);
            (title.plain, title.unit)
        };
        assert_eq!(of(" Bow Dist. (ft)"), ("bow_dist".into(), "ft".into()));
        assert_eq!(of("\u{feff}Speed-Aft [cm/s]"), ("speed_aft".into(), "cm/s".into()));
        assert_eq!(of("Time"), ("time".into(), String::new()));
    }

    #[test]
    fn a_number_has_the_step_of_its_last_digit() {
        assert_eq!(number(" 12.30 ", false), Some((12.3, 0.01)));
        assert_eq!(number("12,3", true), Some((12.3, 0.1)));
        assert_eq!(number("12", false), Some((12.0, 1.0)));
        for cell in ["", "---", "12,3", "inf", "NaN"] {
            assert_eq!(number(cell, false), None, "{cell}");
        }
    }
}
