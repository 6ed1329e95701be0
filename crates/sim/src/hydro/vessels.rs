//! A ship's numbers with where they come from and how sure they are. The numbers themselves are data, in
//! `vessels/` at the root of the repository.

use fenderline_contact::number::bounded;

use super::actuator::RateLimited;
use super::estimate::{EstimateMethod, RatioOutOfRange};
use super::mmg::Mmg;

/// How well the source of a number or of a formula is known, the surest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// Read in a public source.
    Found,
    /// Computed from others.
    Derived,
    /// To be checked against the document before it is relied on.
    Recalled,
    /// Nobody's but ours.
    Assumed,
    /// A user's own.
    Given,
}

impl Standing {
    /// Its word in files and in print.
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

/// A number of a ship, to be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Its key, or its symbol.
    pub name: String,
    /// Its value with its unit.
    pub text: String,
}

impl Figure {
    /// A number and its unit, to four significant digits.
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

/// Where one group of a ship's numbers comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Which numbers.
    pub group: String,
    /// The numbers.
    pub figures: Vec<Figure>,
    /// Where from: a document, or the formula that gave them.
    pub source: String,
    /// How well that is known.
    pub standing: Standing,
    /// They are not the ship's own but come from a formula, whose standing this is: not validated for her.
    pub is_estimate: bool,
}

impl Source {
    /// Its standing in a word, an estimate said to be one.
    #[must_use]
    pub fn word(&self) -> String {
        let word = self.standing.word();
        if self.is_estimate { format!("estimated, {word}") } else { word.to_owned() }
    }
}

/// What a vessel is, and where her numbers come from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// Her name, with her scale.
    pub title: String,
    /// Every number of hers.
    pub sources: Vec<Source>,
    /// The formulas by which her hull, propeller or rudder are estimated; `None` where they are her own.
    pub estimate_method: Option<EstimateMethod>,
    /// Where she is outside the range in which those formulas were held against ships.
    pub outside: Vec<RatioOutOfRange>,
}

impl Origin {
    /// What was estimated for want of numbers of her own.
    pub fn estimates(&self) -> impl Iterator<Item = &Source> {
        self.sources.iter().filter(|source| source.is_estimate)
    }
}

/// A ship ready for manoeuvres.
#[derive(Clone, Debug, PartialEq)]
pub struct Vessel {
    /// Who she is.
    pub origin: Origin,
    /// Her manoeuvring model.
    pub ship: Mmg,
    /// Speed of approach of the standard manoeuvres (m/s); `None` where nobody said.
    pub approach_mps: Option<f64>,
    /// Rudder amidships, with its rate and stop.
    pub steering: RateLimited,
    /// A model in a tank of fresh water.
    pub is_model: bool,
    /// Length of the model whose resistance a full-scale ship has in `ship` (m), where it is known.
    pub resistance_of_model_m: Option<f64>,
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
