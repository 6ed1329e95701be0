//! Computes the pose of least energy of a fender panel on which a hull presses.
//!
//! The hull demands of the panel that d + θ y ≥ x at each of the hull's points (x, y). For a given turn θ the panel
//! lies on the hull at the *support* of θ, the point at which d(θ) = max (x − θ y). The support is one point for a
//! range of turns, and two points if the panel lies along a side. While one point supports the panel, the deflection of
//! each cone is linear in θ, and so the energy is piecewise quadratic in θ. A walk from one corner of the springs'
//! force laws to the next finds the minima of the energy without iteration. Among all minima of the energy, the pose
//! with the least energy is taken.

use crate::maths::number::greater;
use crate::panel::law::Springs;
use crate::panel::touching::HullPoint;

/// Points of the hull that are nearer to each other than this along the panel count as one point (m).
const SAME_PLACE_M: f64 = 1e-9;

/// A pose of the panel, and the points of the hull that support it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    /// θ (rad).
    pub(crate) tilt: f64,
    /// d (m).
    pub(crate) middle_m: f64,
    pub(crate) energy_j: f64,
    /// Indices of the supporting points in the list of the hull's points. The second index of a supporting point is
    /// there if the panel lies along a side of the hull.
    pub(crate) on: (usize, Option<usize>),
}

/// Computes the pose of least energy; returns `None` if the hull has no points before the panel.
pub(crate) fn pose(springs: Springs<'_>, points: &[HullPoint]) -> Option<Pose> {
    let mut search = Search { springs, points, best: None };
    let mut index = leftmost(points)?;
    let mut high = f64::INFINITY;
    // Each pass of the loop goes to a point farther right.
    loop {
        let next = next_right(points, index);
        let low = next.map_or(f64::NEG_INFINITY, |(_, slope)| slope);
        search.around(index, low, high);
        let Some((right, slope)) = next else { return search.best };
        search.consider(index, slope, Some(right));
        (index, high) = (right, slope);
    }
}

/// The hull's point that is farthest left, and among several such points the deepest.
fn leftmost(points: &[HullPoint]) -> Option<usize> {
    let least_m = points.iter().map(|p| p.at.y).fold(f64::INFINITY, crate::maths::number::lesser);
    let mut best: Option<usize> = None;
    for (index, point) in points.iter().enumerate() {
        let is_left = point.at.y <= least_m + SAME_PLACE_M;
        if is_left && best.is_none_or(|best| point.at.x > points[best].at.x) {
            best = Some(index);
        }
    }
    best
}

/// The next corner to the right on the convex cover of the hull, and the slope of the line to this corner. Among
/// several corners on one line, the farthest corner is taken.
fn next_right(points: &[HullPoint], from: usize) -> Option<(usize, f64)> {
    let start = points[from].at;
    let mut best: Option<(usize, f64)> = None;
    for (index, point) in points.iter().enumerate() {
        let by = point.at - start;
        if by.y <= SAME_PLACE_M {
            continue;
        }
        let slope = by.x / by.y;
        let is_better = best.is_none_or(|(other, most)| {
            slope > most || (slope == most && point.at.y > points[other].at.y)
        });
        if is_better {
            best = Some((index, slope));
        }
    }
    best
}

struct Search<'p> {
    springs: Springs<'p>,
    points: &'p [HullPoint],
    best: Option<Pose>,
}

impl Search<'_> {
    /// Considers all minima of the energy at the point `index`, which supports the panel at turns from `low` to `high`.
    fn around(&mut self, index: usize, low: f64, high: f64) {
        if low.is_finite() {
            self.walk(index, low, high);
        } else if high.is_finite() {
            self.walk(index, high, low);
        } else {
            self.consider(index, 0.0, None);
            self.walk(index, 0.0, high);
            self.walk(index, 0.0, low);
        }
    }

    /// Considers the minima of the energy between two turns of the panel.
    fn walk(&mut self, index: usize, from: f64, to: f64) {
        let springs = self.springs;
        let count = springs.count();
        let vertex = self.points[index].at;
        let sign = if to > from { 1.0 } else { -1.0 };
        let arm = |spring: usize| springs.at_m(spring) - vertex.y;
        let rises = |spring: usize| sign * arm(spring) > 0.0;
        let mut pieces = [0; Springs::MOST];
        for (spring, piece) in pieces.iter_mut().enumerate().take(count) {
            let deflection_m = vertex.x + from * arm(spring);
            *piece = springs.line(spring).0.piece_at(deflection_m, rises(spring));
        }
        let mut tilt = from;
        // Each pass of the loop takes one spring to its next piece.
        for _ in 0..=springs.pieces() {
            let mut end = (to, None);
            let (mut slope, mut curvature) = (0.0, 0.0);
            for (spring, &piece) in pieces.iter().enumerate().take(count) {
                let arm_m = arm(spring);
                if arm_m == 0.0 {
                    continue;
                }
                let (line, scale) = springs.line(spring);
                let (force_n, stiffness_npm) = line.force_on(piece, vertex.x + tilt * arm_m);
                slope += sign * (scale * force_n) * arm_m;
                curvature += (scale * stiffness_npm) * arm_m * arm_m;
                if let Some(end_m) = line.end_m(piece, rises(spring)) {
                    let at = (end_m - vertex.x) / arm_m;
                    if sign * (at - end.0) < 0.0 {
                        end = (at, Some(spring));
                    }
                }
            }
            let room = greater(sign * (end.0 - tilt), 0.0);
            if slope < 0.0 && curvature > 0.0 && slope + curvature * room >= 0.0 {
                self.consider(index, tilt - sign * slope / curvature, None);
            }
            let (at, Some(spring)) = end else { return };
            tilt = if sign * (at - tilt) > 0.0 { at } else { tilt };
            pieces[spring] = if rises(spring) { pieces[spring] + 1 } else { pieces[spring] - 1 };
        }
    }

    /// Takes a pose if its energy is the least energy so far.
    fn consider(&mut self, index: usize, tilt: f64, also: Option<usize>) {
        let at = self.points[index].at;
        let middle_m = at.x - tilt * at.y;
        let energy_of = |spring: usize| {
            let (line, scale) = self.springs.line(spring);
            scale * line.at(at.x + tilt * (self.springs.at_m(spring) - at.y)).1
        };
        let energy_j: f64 = (0..self.springs.count()).map(energy_of).sum();
        if self.best.is_none_or(|best| energy_j < best.energy_j) {
            self.best = Some(Pose { tilt, middle_m, energy_j, on: (index, also) });
        }
    }
}
