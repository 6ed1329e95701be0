//! Load curves of ropes.

use std::borrow::Cow;

use super::error::RopeError;

/// Load curve of a rope: tension as a share of the break load, by strain; piecewise linear from (0, 0) on, and
/// extrapolated beyond the last point.
#[derive(Clone, Debug, PartialEq)]
pub struct RopeCurve {
    /// Points of the load curve (strain, share of the break load).
    points: Cow<'static, [[f64; 2]]>,
}

/// A rope: break load and load curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Rope {
    /// Line design break force of the rope (N).
    pub break_load_n: f64,
    /// Load curve.
    pub curve: RopeCurve,
}

impl RopeCurve {
    /// Makes a load curve from two or more points (strain, share of the break load).
    ///
    /// # Errors
    /// Fails for a first point other than (0, 0), values that do not increase, or a number above 10.
    pub fn new(points: Vec<[f64; 2]>) -> Result<RopeCurve, RopeError> {
        if points.first() != Some(&[0.0, 0.0]) {
            return Err(RopeError { point: 0 });
        }
        if points.len() < 2 {
            return Err(RopeError { point: 1 });
        }
        let good =
            |a: &[f64; 2], b: &[f64; 2]| b[0] > a[0] && b[1] > a[1] && b[0] <= 10.0 && b[1] <= 10.0;
        match points.windows(2).position(|two| !good(&two[0], &two[1])) {
            Some(before) => Err(RopeError { point: before + 1 }),
            None => Ok(RopeCurve { points: Cow::Owned(points) }),
        }
    }

    /// Makes the straight load curve of a rope with an axial stiffness EA (N) and a break load (N).
    ///
    /// # Errors
    /// Fails for a strain at break above 10, or numbers that are not above zero.
    pub fn of_stiffness(axial_stiffness_n: f64, break_load_n: f64) -> Result<RopeCurve, RopeError> {
        RopeCurve::new(vec![[0.0, 0.0], [break_load_n / axial_stiffness_n, 1.0]])
    }

    /// The share of the break load at the last point of the load curve.
    #[must_use]
    pub fn last_share(&self) -> f64 {
        self.points[self.points.len() - 1][1]
    }

    const fn built_in(points: &'static [[f64; 2]]) -> RopeCurve {
        RopeCurve { points: Cow::Borrowed(points) }
    }

    /// Load curve of steel wire rope with a steel core: 0.8 % strain at half of the break load, 1.8 % at break (from
    /// memory; a public page gives 1 to 2 % in use).
    #[must_use]
    pub const fn wire() -> RopeCurve {
        RopeCurve::built_in(&[[0.0, 0.0], [0.008, 0.5], [0.018, 1.0]])
    }

    /// Load curve of high-modulus polyethylene rope: 2 % strain at half of the break load, 3.5 % at break (found in one
    /// public table, not a maker's; for worn-in rope).
    #[must_use]
    pub const fn hmpe() -> RopeCurve {
        RopeCurve::built_in(&[[0.0, 0.0], [0.020, 0.5], [0.035, 1.0]])
    }

    /// Load curve of polyester rope: 6.5 % strain at half of the break load, 12 % at break (found in the same table as
    /// for polyethylene).
    #[must_use]
    pub const fn polyester() -> RopeCurve {
        RopeCurve::built_in(&[[0.0, 0.0], [0.065, 0.5], [0.12, 1.0]])
    }

    /// Load curve of nylon rope, used for tails: 15 % strain at half of the break load, 25 % at break (found in the
    /// same table as for polyethylene).
    #[must_use]
    pub const fn nylon() -> RopeCurve {
        RopeCurve::built_in(&[[0.0, 0.0], [0.15, 0.5], [0.25, 1.0]])
    }

    /// Share of the break load that a rope bears at a strain; 0 if the rope is slack.
    #[must_use]
    pub fn share(&self, strain: f64) -> f64 {
        if strain <= 0.0 {
            return 0.0;
        }
        let [a, b] = self.piece(0, strain);
        a[1] + (b[1] - a[1]) * (strain - a[0]) / (b[0] - a[0])
    }

    /// Strain of the rope at a share of the break load.
    #[must_use]
    pub fn strain(&self, share: f64) -> f64 {
        let [a, b] = self.piece(1, share);
        a[0] + (b[0] - a[0]) * (share - a[1]) / (b[1] - a[1])
    }

    /// The shares of the break load at which the load curve has a corner.
    pub(super) fn corners(&self) -> impl Iterator<Item = f64> {
        self.points.iter().map(|point| point[1])
    }

    /// The segment of the load curve that contains a value of a column (0: strain, 1: share).
    fn piece(&self, column: usize, value: f64) -> [&[f64; 2]; 2] {
        let last = self.points.len() - 1;
        let upper = (1..last).find(|&k| self.points[k][column] >= value).unwrap_or(last);
        [&self.points[upper - 1], &self.points[upper]]
    }
}
