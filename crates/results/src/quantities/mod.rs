//! The catalogue of summary quantities. The catalogue defines once the name, unit, meaning and value of each quantity,
//! and how tables show it. `summary.json`, the summary that `run` prints, the tables of the report, the workbook, the
//! outputs of campaigns, outputs of FMUs, the tables of Python and the types of the npm package all come from here.

mod anchors;
mod chains;
mod dolphins;
mod fenders;
mod lines;
mod pairs;
mod scale;
mod tugs;
mod vessels;

use core::fmt;

use crate::json::Json;

pub use anchors::ANCHORS;
pub use chains::CHAINS;
pub use dolphins::DOLPHINS;
pub use fenders::FENDERS;
pub use lines::LINES;
pub use pairs::PAIRS;
pub use scale::{Scale, scales};
pub use tugs::TUGS;
pub use vessels::VESSELS;

/// The quantities of one kind of part, such as fenders or lines. `S` is the set-up of a part (a fender, a line), `T`
/// the summary of the part after a run.
pub struct Catalogue<S: 'static, T: 'static> {
    /// The kind of part, such as `fender`.
    pub subject: &'static str,
    /// The quantities, in the order of `summary.json`.
    pub quantities: &'static [Quantity<S, T>],
    /// The columns of the tables that people read, in order.
    pub shown: &'static [Shown],
}

/// One quantity of the summary of a part, such as the largest reaction of a fender.
pub struct Quantity<S, T> {
    /// Key of the quantity in `summary.json` and column of Python's tables; the key ends with the unit, if the quantity
    /// has one.
    pub name: &'static str,
    /// Unit of the quantity in SI as a reader writes it; `1` for a pure number, `-` for a word or a truth value.
    pub unit: &'static str,
    /// Meaning of the quantity.
    pub meaning: &'static str,
    /// Takes the value of the quantity from the set-up and the summary.
    pub value: Taken<S, T>,
    /// Name and unit of the quantity as an output of a campaign, for example `fender.NAME.reaction`; `None` if it is no
    /// such output.
    pub output: Option<(&'static str, Scale)>,
    /// Whether the FMU of a simulation has the quantity as an output.
    pub is_in_fmu: bool,
    /// Whether `summary.json` has the quantity.
    pub is_in_summary: bool,
}

/// The way in which a value is taken, which sets the type of the quantity.
pub enum Taken<S, T> {
    /// A number.
    Number(fn(&S, &T) -> f64),
    /// A number that some parts lack, such as a share of the rating for a fender without a rating.
    Known(fn(&S, &T) -> Option<f64>),
    /// A number of the set-up alone, which some parts lack, such as a fender's rated energy.
    Given(fn(&S) -> Option<f64>),
    /// A truth value.
    Flag(fn(&S, &T) -> bool),
    /// A word, which some parts lack.
    Word(fn(&S, &T) -> Option<&'static str>),
}

/// A value of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// A number in the unit of the quantity.
    Number(f64),
    /// A truth value.
    Flag(bool),
    /// A word.
    Word(&'static str),
    /// The part (the fender, the line) has no value of this quantity.
    Missing,
}

/// A column of the tables that people read: the sheet of the workbook, the table of the report, and the table that
/// `run` prints.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Head of the column in workbook and report.
    pub head: &'static str,
    /// Name of the quantity in the catalogue.
    pub quantity: &'static str,
    /// Unit of the column.
    pub scale: Scale,
    /// Width of the column in the workbook (characters); `None`: the workbook does not have the column.
    pub sheet_width: Option<f64>,
    /// How `run` prints the column; `None` if `run` does not print it.
    pub printed: Option<Printed>,
    /// How the report shows the column; `None` if the report does not show it.
    pub reported: Option<Reported>,
}

/// A column of the summary that `run` prints.
#[derive(Clone, Copy, Debug)]
pub struct Printed {
    /// Head of the column.
    pub head: &'static str,
    /// Width (characters).
    pub width: usize,
    /// Digits after the point.
    pub decimals: usize,
}

/// A column of a table of the report.
#[derive(Clone, Copy, Debug)]
pub struct Reported {
    /// Digits of the value.
    pub digits: Digits,
    /// Name of the quantity that gives the share of a limit, which stands below the value.
    pub share: Option<&'static str>,
    /// Name of the quantity that gives the share of the catalogue's rating, which stands in brackets if it differs.
    pub catalogue_share: Option<&'static str>,
    /// Name of the quantity whose share decides whether the value is over its limit, if this is not `share`.
    pub over: Option<&'static str>,
}

/// How many digits of a number are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// Digits after the point.
    Fixed(usize),
    /// Digits that count.
    Significant(i32),
    /// As many decimals as the time step has.
    OfStep,
}

impl<S, T> Catalogue<S, T> {
    /// The quantity that has the given name.
    ///
    /// # Panics
    /// Panics if the catalogue has no such quantity; a test looks up every name that a [`Shown`] has.
    pub fn get(&self, name: &str) -> &Quantity<S, T> {
        let quantity = self.quantities.iter().find(|quantity| quantity.name == name);
        quantity.unwrap_or_else(|| panic!("no quantity of a {} is `{name}`", self.subject))
    }

    /// The number of the quantity with the given name, in SI; `None` if the part does not have it.
    ///
    /// # Panics
    /// As [`Catalogue::get`].
    pub fn number(&self, name: &str, setup: &S, summary: &T) -> Option<f64> {
        self.get(name).amount(setup, Some(summary)).number()
    }

    /// Adds the quantities of a part to the part's object in `summary.json`. A missing value gets no key.
    pub(crate) fn put(&self, object: &mut Json, setup: &S, summary: &T) {
        for quantity in self.quantities.iter().filter(|quantity| quantity.is_in_summary) {
            match quantity.amount(setup, Some(summary)) {
                Amount::Number(value) => object.put(quantity.name, value),
                Amount::Flag(value) => object.put(quantity.name, value),
                Amount::Word(value) => object.put(quantity.name, value),
                Amount::Missing => {}
            }
        }
    }
}

impl<S, T> Quantity<S, T> {
    /// The value of the quantity for a part; `summary` is `None` for a part without results, such as a fender that was
    /// not touched.
    pub fn amount(&self, setup: &S, summary: Option<&T>) -> Amount {
        let known = |value: Option<f64>| value.map_or(Amount::Missing, Amount::Number);
        match (&self.value, summary) {
            (Taken::Given(value), _) => known(value(setup)),
            (_, None) => Amount::Missing,
            (Taken::Number(value), Some(summary)) => Amount::Number(value(setup, summary)),
            (Taken::Known(value), Some(summary)) => known(value(setup, summary)),
            (Taken::Flag(value), Some(summary)) => Amount::Flag(value(setup, summary)),
            (Taken::Word(value), Some(summary)) => {
                value(setup, summary).map_or(Amount::Missing, Amount::Word)
            }
        }
    }

    /// Makes the quantity an output of campaigns, with the name `name` and in the unit of `scale`.
    #[must_use]
    pub const fn output(mut self, name: &'static str, scale: Scale) -> Self {
        self.output = Some((name, scale));
        self
    }

    /// Makes the quantity also an output of the FMU of a simulation.
    #[must_use]
    pub(crate) const fn in_fmu(mut self) -> Self {
        self.is_in_fmu = true;
        self
    }

    /// Leaves the quantity out of `summary.json`.
    #[must_use]
    pub(crate) const fn not_in_summary(mut self) -> Self {
        self.is_in_summary = false;
        self
    }

    const fn new(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Taken<S, T>,
    ) -> Self {
        Quantity { name, unit, meaning, value, output: None, is_in_fmu: false, is_in_summary: true }
    }
}

impl<S, T> fmt::Debug for Quantity<S, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Quantity").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Amount {
    /// The number of the amount, if it is a number.
    #[must_use]
    pub fn number(self) -> Option<f64> {
        match self {
            Amount::Number(value) => Some(value),
            _ => None,
        }
    }
}

impl Shown {
    /// Shows the quantity in the workbook, in a column of the given width (characters).
    const fn sheet(mut self, width: f64) -> Shown {
        self.sheet_width = Some(width);
        self
    }

    /// Shows the quantity in the summary that `run` prints.
    const fn printed(mut self, head: &'static str, width: usize, decimals: usize) -> Shown {
        self.printed = Some(Printed { head, width, decimals });
        self
    }

    /// Shows the quantity in the table of the report, with the share of a limit below the value.
    const fn reported(mut self, digits: Digits, share: Option<&'static str>) -> Shown {
        self.reported = Some(Reported { digits, share, catalogue_share: None, over: None });
        self
    }

    /// Adds to the report's column the share of the catalogue's rating, and the share that decides whether the value is
    /// over its limit.
    const fn with_catalogue(mut self, share: &'static str, over: &'static str) -> Shown {
        if let Some(reported) = &mut self.reported {
            reported.catalogue_share = Some(share);
            reported.over = Some(over);
        }
        self
    }
}

/// Makes a quantity that is a number and that every part has.
pub const fn number<S, T>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&S, &T) -> f64,
) -> Quantity<S, T> {
    Quantity::new(name, unit, meaning, Taken::Number(value))
}

/// Makes a quantity that is a number and that some parts lack.
const fn known<S, T>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&S, &T) -> Option<f64>,
) -> Quantity<S, T> {
    Quantity::new(name, unit, meaning, Taken::Known(value))
}

const fn given<S, T>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&S) -> Option<f64>,
) -> Quantity<S, T> {
    Quantity::new(name, unit, meaning, Taken::Given(value))
}

const fn flag<S, T>(
    name: &'static str,
    meaning: &'static str,
    value: fn(&S, &T) -> bool,
) -> Quantity<S, T> {
    Quantity::new(name, "-", meaning, Taken::Flag(value))
}

const fn word<S, T>(
    name: &'static str,
    meaning: &'static str,
    value: fn(&S, &T) -> Option<&'static str>,
) -> Quantity<S, T> {
    Quantity::new(name, "-", meaning, Taken::Word(value))
}

const fn shown(head: &'static str, quantity: &'static str, scale: Scale) -> Shown {
    Shown { head, quantity, scale, sheet_width: None, printed: None, reported: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<S, T>(catalogue: &Catalogue<S, T>) {
        for (index, quantity) in catalogue.quantities.iter().enumerate() {
            let Quantity { name, unit, meaning, .. } = quantity;
            assert!(!unit.is_empty() && !meaning.is_empty(), "{}: {name}", catalogue.subject);
            let before = &catalogue.quantities[..index];
            assert!(
                before.iter().all(|other| other.name != *name),
                "{}: {name}",
                catalogue.subject
            );
        }
        for column in catalogue.shown {
            let shares = column.reported.iter();
            let shares = shares.flat_map(|of| [of.share, of.catalogue_share, of.over]);
            for name in shares.flatten().chain([column.quantity]) {
                assert_eq!(catalogue.get(name).name, name);
            }
        }
    }

    #[test]
    fn every_quantity_has_one_name_a_unit_and_a_meaning_and_every_column_a_quantity() {
        check(&ANCHORS);
        check(&CHAINS);
        check(&DOLPHINS);
        check(&FENDERS);
        check(&LINES);
        check(&PAIRS);
        check(&TUGS);
        check(&VESSELS);
    }
}
