//! Reaction curves of fenders: the force that belongs to a deflection, and the piecewise linear functions behind the
//! curves.

use alloc::vec::Vec;

use crate::error::ModelError;
use crate::maths::number::{bounded, greater};

/// The law that gives the reaction R from the deflection δ.
#[derive(Clone, Debug, PartialEq)]
pub enum FenderLaw {
    /// The paper's law, an elastic foundation: the force is N = k S with the material's stiffness k and the area S of
    /// the overlap. In [`FenderLaw::Area`] the stored energy is ½ k ∫ d² ds, where d(s) is the depth of the hull behind
    /// the face. The deflection δ is the largest depth d(s).
    Area,
    /// The reaction is given by points (δ (m), R (N)), from (0, 0) on, with straight lines between them. Beyond the
    /// last point, a rising last line is extended; after a falling last line the reaction stays constant. The
    /// deflection δ is the mean of the depth d(s) over the width of the face. If a flat side of a hull covers the face,
    /// δ is the deflection of the fender's axis. The stored energy of a reaction curve is ∫ R dδ.
    Curve(Vec<[f64; 2]>),
}

/// The stop at the end of a fender's travel: beyond `from_m` a second spring acts in addition to the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Deflection of the fender at which the stop begins (m).
    pub from_m: f64,
    /// Stiffness (N/m).
    pub stiffness_npm: f64,
}

impl FenderLaw {
    /// R = k δ.
    #[must_use]
    pub fn linear(stiffness_npm: f64) -> FenderLaw {
        FenderLaw::Curve(alloc::vec![[0.0, 0.0], [1.0, stiffness_npm]])
    }

    /// The reaction R at a deflection, without the fender's factors and stop (N). The reaction is 0 for
    /// [`FenderLaw::Area`], because the force of this law does not depend on δ alone.
    #[must_use]
    pub fn reaction_n(&self, deflection_m: f64) -> f64 {
        match self {
            FenderLaw::Area => 0.0,
            FenderLaw::Curve(points) => on_line(points, deflection_m),
        }
    }

    /// The stored energy ∫ R dδ up to a deflection, without the fender's factors and stop (J).
    #[must_use]
    pub fn energy_j(&self, deflection_m: f64) -> f64 {
        let FenderLaw::Curve(points) = self else { return 0.0 };
        integral(points, deflection_m)
    }

    /// The steepest rise of the reaction R up to a deflection (N/m).
    pub(crate) fn steepest_npm(&self, up_to_m: f64) -> f64 {
        let FenderLaw::Curve(points) = self else { return 0.0 };
        points
            .windows(2)
            .take_while(|two| two[0][0] <= up_to_m)
            .map(|two| (two[1][1] - two[0][1]) / (two[1][0] - two[0][0]))
            .fold(0.0, greater)
    }
}

/// The integral of [`on_line`] from the first point to `x`.
pub(crate) fn integral(points: &[[f64; 2]], x: f64) -> f64 {
    let mut sum = 0.0;
    for two in points.windows(2) {
        let [[from, low], [to, high]] = [two[0], two[1]];
        if x <= to {
            return sum + 0.5 * (low + on_line(points, x)) * (x - from);
        }
        sum += 0.5 * (low + high) * (to - from);
    }
    let [end, last] = points[points.len() - 1];
    sum + 0.5 * (last + on_line(points, x)) * (x - end)
}

/// Interpolates a value on straight lines between the points. Beyond the last point a rising last line is extended;
/// after a falling last line the value stays constant.
pub(crate) fn on_line(points: &[[f64; 2]], x: f64) -> f64 {
    let index = points[1..points.len() - 1].iter().take_while(|p| p[0] < x).count();
    let [[x0, y0], [x1, y1]] = [points[index], points[index + 1]];
    if x > x1 && y1 < y0 {
        return y1;
    }
    y0 + (y1 - y0) * ((x - x0) / (x1 - x0))
}

/// Interpolates a value on straight lines between the points; the value is constant beyond both ends. The interpolated
/// value is 1 if there are no points.
pub(crate) fn held(points: &[[f64; 2]], x: f64) -> f64 {
    match points {
        [] => 1.0,
        [only] => only[1],
        [first, .., last] => on_line(points, bounded(x, first[0], last[0])),
    }
}

/// Checks the points of a reaction curve, which must begin at (0, 0). In errors, `owner` names the fender, and `fields`
/// names the curve and its deflections.
pub(crate) fn check_curve(
    owner: &str,
    [curve, deflection]: [&'static str; 2],
    points: &[[f64; 2]],
) -> Result<(), ModelError> {
    if points.len() < 2 || points[0] != [0.0, 0.0] {
        let value = points.first().map_or(f64::NAN, |p| p[0]);
        let must = "a curve of two or more points, the first of which is (0, 0)";
        return Err(ModelError::OutOfRange { owner: owner.into(), field: curve, value, must });
    }
    check_points(owner, deflection, points, 0.0..=1e15)
}

/// Checks that the abscissae of the points rise and that the ordinates lie within their bounds. In errors, `owner`
/// names the fender.
pub(crate) fn check_points(
    owner: &str,
    field: &'static str,
    points: &[[f64; 2]],
    bounds: core::ops::RangeInclusive<f64>,
) -> Result<(), ModelError> {
    let bad = |value, must| Err(ModelError::OutOfRange { owner: owner.into(), field, value, must });
    for &[x, y] in points {
        if !(0.0..=1e9).contains(&x) {
            return bad(x, "between 0 and 1e9");
        }
        if !bounds.contains(&y) {
            return bad(y, "within its bounds: reactions 0 to 1e15, factors 1e-3 to 1e3");
        }
    }
    match points.windows(2).find(|two| two[1][0] <= two[0][0]) {
        None => Ok(()),
        Some(two) => bad(two[1][0], "larger than the abscissa of the point before it"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn reaction_and_energy_follow_the_points_and_the_last_segment_is_extended() {
        let law = FenderLaw::Curve(vec![[0.0, 0.0], [1.0, 10.0], [2.0, 8.0], [3.0, 12.0]]);
        for (deflection_m, reaction_n, energy_j) in [
            (0.0, 0.0, 0.0),
            (0.5, 5.0, 1.25),
            (1.5, 9.0, 9.75),
            (3.0, 12.0, 24.0),
            (4.0, 16.0, 38.0),
        ] {
            assert_eq!(law.reaction_n(deflection_m), reaction_n);
            assert_eq!(law.energy_j(deflection_m), energy_j);
        }
        assert_eq!(law.steepest_npm(0.5), 10.0);
        assert_eq!(FenderLaw::linear(7.0).reaction_n(3.0), 21.0);
        let buckled = FenderLaw::Curve(vec![[0.0, 0.0], [1.0, 10.0], [2.0, 8.0]]);
        assert_eq!((buckled.reaction_n(3.0), buckled.energy_j(3.0)), (8.0, 22.0));
    }
}
