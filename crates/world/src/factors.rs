//! Partial factors on the results of a run. The user gives the partial factors, with their source.
//!
//! fenderline contains no factors of any guideline. The program multiplies its results by the factors that the user
//! gives, compares them with limits, and names the user's source in all outputs.

use crate::fender::FenderSummary;
use fenderline_ship::mooring::LineKind;
use fenderline_ship::range::{OutOfRange, within};

/// The user's partial factors on energies, reactions and line loads.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartialFactors {
    /// The source of the factors, in the user's words.
    pub source: String,
    /// Factor on the energy that a fender absorbs. The absorbed energy times this factor is compared with the fender's
    /// rated energy.
    pub energy: Option<f64>,
    /// Factor on the reaction of a fender.
    pub reaction: Option<f64>,
    /// The limit with which a factored reaction is compared (N); `None`: the factored reaction is only shown.
    pub reaction_limit_n: Option<f64>,
    /// Factor on the tension of a line.
    pub line_load: Option<f64>,
    /// The capacity of a line with which its factored tension is compared.
    pub line_capacity: LineCapacity,
}

/// The capacity with which the factored tension of a line is compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LineCapacity {
    /// The working load of the line.
    #[default]
    WorkingLoad,
    /// The break load of the line: the smaller one of the break loads of rope and tail.
    BreakLoad,
}

impl LineCapacity {
    /// The capacity in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            LineCapacity::WorkingLoad => "working load",
            LineCapacity::BreakLoad => "break load",
        }
    }
}

/// A result of the run multiplied by its partial factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factored {
    /// The partial factor.
    pub factor: f64,
    /// The result times the factor (J or N).
    pub value: f64,
    /// Capacity with which the factored result is compared (J or N), if the capacity is known.
    pub capacity: Option<f64>,
}

impl Factored {
    /// Factored result divided by the capacity; `None` if the capacity is not known.
    #[must_use]
    pub fn share(&self) -> Option<f64> {
        self.capacity.map(|capacity| self.value / capacity)
    }
}

impl PartialFactors {
    /// True if the user gives no partial factor.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.energy.is_none() && self.reaction.is_none() && self.line_load.is_none()
    }

    /// Checks that every number is within its range.
    ///
    /// # Errors
    /// Returns the first number that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        for factor in [self.energy, self.reaction, self.line_load].into_iter().flatten() {
            within("partial factor", factor, 0.1, 10.0)?;
        }
        if let Some(limit_n) = self.reaction_limit_n {
            within("limit of a factored reaction [N]", limit_n, 1.0, 1e10)?;
        }
        Ok(())
    }

    /// The factored energy of a fender, and the fender's rated energy with the correction factors of the run; `None` if
    /// there is no partial factor on energies.
    #[must_use]
    pub fn energy_of(&self, fender: &FenderSummary) -> Option<Factored> {
        let of = |factor: f64| {
            let value = factor * fender.peak_energy_j;
            // The share governs: a fender of several cones is rated by its most used cone.
            let capacity = fender
                .share_of_rated_energy
                .filter(|share| *share > 0.0)
                .map(|share| fender.peak_energy_j / share);
            Factored { factor, value, capacity }
        };
        self.energy.map(of)
    }

    /// The factored reaction of a fender; `None` if there is no partial factor on reactions.
    #[must_use]
    pub fn reaction_of(&self, fender: &FenderSummary) -> Option<Factored> {
        let of = |factor: f64| Factored {
            factor,
            value: factor * fender.peak_reaction_n,
            capacity: self.reaction_limit_n,
        };
        self.reaction.map(of)
    }

    /// The factored tension of a line; `None` if there is no partial factor on line loads.
    #[must_use]
    pub fn line_load_of(&self, kind: &LineKind, peak_n: f64) -> Option<Factored> {
        let capacity = match self.line_capacity {
            LineCapacity::WorkingLoad => kind.working_load_n(),
            LineCapacity::BreakLoad => Some(kind.break_load_n()),
        };
        self.line_load.map(|factor| Factored { factor, value: factor * peak_n, capacity })
    }
}
