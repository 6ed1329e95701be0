//! Response amplitude operators as a table.

use core::f64::consts::{PI, TAU};

use super::complex::Complex;
use crate::environment::error::EnvironmentError;
use crate::environment::table::{check_axis, place};
use crate::range::within;

/// Response amplitude operators of a symmetric ship: the complex amplitude of each motion in a wave of 1 m amplitude,
/// by frequency and direction.
///
/// The complex numbers of the table are interpolated linearly. Outside the table's range of frequencies, the entry at
/// the end of the range is used. A table should extend from frequencies at which the ship follows the wave to
/// frequencies at which she does not respond.
#[derive(Clone, Debug, PartialEq)]
pub struct RaoTable {
    frequencies_radps: Vec<f64>,
    directions_rad: Vec<f64>,
    /// The response amplitude operators of the table; the index of direction varies fastest.
    operators: Vec<[Complex; 6]>,
}

impl RaoTable {
    /// Makes a table from wave frequencies (rad/s, not frequencies of encounter), directions μ from 0 to π (rad), and
    /// operators: surge, sway, heave down (m/m), roll, pitch bow up, yaw (rad/m). In the list of operators the index of
    /// direction varies fastest.
    ///
    /// # Errors
    /// Fails for axes that do not increase, directions that do not cover 0 to π, a wrong number of operators, or an
    /// operator out of range.
    pub fn new(
        frequencies_radps: Vec<f64>,
        directions_rad: Vec<f64>,
        operators: Vec<[Complex; 6]>,
    ) -> Result<RaoTable, EnvironmentError> {
        check_axis("frequencies of the response [rad/s]", frequencies_radps.iter().copied(), 1)?;
        check_axis("directions of the response [rad]", directions_rad.iter().copied(), 2)?;
        within("first direction of the response [rad]", directions_rad[0], -1e-9, 1e-9)?;
        let last = directions_rad[directions_rad.len() - 1];
        within("last direction of the response [rad]", last, PI - 1e-3, PI + 1e-3)?;
        let expected = frequencies_radps.len() * directions_rad.len();
        if operators.len() != expected {
            let found = operators.len();
            return Err(EnvironmentError::Length {
                table: "the response's table",
                expected,
                found,
            });
        }
        for part in operators.iter().flatten().flat_map(|c| [c.re, c.im]) {
            within("response amplitude operator", part, -1e3, 1e3)?;
        }
        Ok(RaoTable { frequencies_radps, directions_rad, operators })
    }

    /// The first and the last frequency of the table (rad/s). Beyond its first and last frequency, [`RaoTable::at`]
    /// uses the operators at the end of the table.
    #[must_use]
    pub fn range_radps(&self) -> [f64; 2] {
        [self.frequencies_radps[0], self.frequencies_radps[self.frequencies_radps.len() - 1]]
    }

    /// The response amplitude operators for a wave frequency and a direction μ relative to the bow. The operators for
    /// waves from starboard are those for waves from port, mirrored, so that sway, roll and yaw change their sign.
    #[must_use]
    pub fn at(&self, frequency_radps: f64, direction_rad: f64) -> [Complex; 6] {
        let wrapped_rad = libm::remainder(direction_rad, TAU);
        let columns = self.directions_rad.len();
        let row =
            place(self.frequencies_radps.len(), |i| self.frequencies_radps[i], frequency_radps);
        let column = place(columns, |i| self.directions_rad[i], wrapped_rad.abs());
        let side = if wrapped_rad < 0.0 { -1.0 } else { 1.0 };
        std::array::from_fn(|motion| {
            let entry = |r: usize, c: usize| self.operators[r * columns + c][motion];
            let on_row = |r| mix(entry(r, column.low), entry(r, column.high), column.share);
            let mixed = mix(on_row(row.low), on_row(row.high), row.share);
            let sideways = motion == 1 || motion == 3 || motion == 5;
            if sideways { mixed * side } else { mixed }
        })
    }
}

fn mix(low: Complex, high: Complex, share: f64) -> Complex {
    low * (1.0 - share) + high * share
}
