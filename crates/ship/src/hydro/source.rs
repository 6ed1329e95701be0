//! The sources of a ship's data, and how well they are known. The data of ships are in `vessels/` at the root of the
//! repository.

use fenderline_contact::number::bounded;

/// How well the source of a number or a formula is known, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// The number or formula was read in a public source.
    Found,
    /// Computed from other numbers.
    Derived,
    /// The number or formula is from memory, and is to be checked against the document.
    Recalled,
    /// Assumed by this project.
    Assumed,
    /// Given by the user.
    Given,
}

impl Standing {
    /// The word for how well a source is known, in files and reports.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Standing::Found => "found",
            Standing::Derived => "derived",
            Standing::Recalled => "recalled",
            Standing::Assumed => "assumed",
            Standing::Given => "given",
        }
    }
}

/// A number of a ship as a report shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Key or symbol.
    pub name: String,
    /// Value with unit.
    pub text: String,
}

impl Figure {
    /// Writes a number with its unit, to four significant digits.
    pub(crate) fn of(name: &str, value: f64, unit: &str) -> Figure {
        let decimals = if value == 0.0 {
            0.0
        } else {
            bounded(3.0 - libm::floor(libm::log10(value.abs())), 0.0, 6.0)
        };
        let text = format!(
            "{value:.*}{}{unit}",
            decimals as usize,
            [" ", ""][usize::from(unit.is_empty())]
        );
        Figure { name: name.to_owned(), text }
    }
}

/// The source of a group of numbers of a ship.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// The group.
    pub group: String,
    /// The numbers.
    pub figures: Vec<Figure>,
    /// The document from which the numbers are, or the formula that gave them.
    pub source: String,
    /// How well the source of the numbers is known.
    pub standing: Standing,
    /// True if the numbers come from a formula, not from data of the ship. If the numbers come from a formula,
    /// `standing` is how well the formula is known.
    pub is_estimate: bool,
}

impl Source {
    /// The standing in words. Estimates are marked.
    #[must_use]
    pub fn word(&self) -> String {
        let word = self.standing.word();
        if self.is_estimate { format!("estimated, {word}") } else { word.to_owned() }
    }
}

#[cfg(test)]
mod tests {
    use super::Figure;

    #[test]
    fn figures_have_four_digits_and_their_unit() {
        let text = |value, unit| Figure::of("x", value, unit).text;
        assert_eq!(text(-0.137_04, ""), "-0.1370");
        assert_eq!(text(320.0, "m"), "320.0 m");
        assert_eq!(text(0.0, "m"), "0 m");
        assert_eq!(text(123_456.7, "m³"), "123457 m³");
    }
}
