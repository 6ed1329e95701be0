//! The springs behind a fender panel: forces that are piecewise linear in the deflection, with the energies of the
//! springs.

use alloc::vec;
use alloc::vec::Vec;

use crate::maths::number::{greater, lesser};
use crate::model::reaction::{FenderLaw, Stop, on_line};
use crate::panel::chains::{Broken, ChainState};
use crate::panel::{Panel, TensionChain};

/// All springs behind a fender panel.
#[derive(Clone, Debug)]
pub(crate) struct PanelLaw {
    /// Places of the cones along the panel (m).
    pub(crate) places_m: Vec<f64>,
    /// Force of each cone.
    pub(crate) cone: Line,
    /// The stop of each cone behind the panel.
    pub(crate) stop: Option<Stop>,
    pub(crate) chains: Vec<ChainLaw>,
    /// The largest distance of a cone or chain from the middle of the panel (m).
    pub(crate) reach_m: f64,
}

impl PanelLaw {
    /// Makes the springs of a panel that has passed its checks, from the law and the stop of the cones. Returns `None`
    /// if the law of the cones is not a curve.
    pub(crate) fn of(panel: &Panel, law: &FenderLaw, stop: Option<Stop>) -> Option<PanelLaw> {
        let FenderLaw::Curve(points) = law else { return None };
        Some(PanelLaw {
            places_m: panel.cones_m.clone(),
            cone: Line::of_cone(points, stop),
            stop,
            chains: panel.tension_chains.iter().map(ChainLaw::of).collect(),
            reach_m: panel.cones_m.iter().fold(0.0, |reach, at| greater(reach, at.abs())),
        })
    }

    /// Finds the chains whose tensions reach their break loads.
    pub(crate) fn breaking(&self, tensions_n: &[f64; Panel::MOST_CHAINS]) -> Broken {
        let mut broken = Broken { overshoot: 1.0, ..Broken::default() };
        for (index, (chain, &tension_n)) in self.chains.iter().zip(tensions_n).enumerate() {
            if tension_n >= chain.break_load_n {
                broken.chains |= 1 << index;
                broken.tensions_n[index] = chain.break_load_n;
                broken.overshoot = lesser(broken.overshoot, chain.break_load_n / tension_n);
            }
        }
        broken
    }
}

/// A tension chain.
#[derive(Clone, Debug)]
pub(crate) struct ChainLaw {
    pub(crate) at_m: f64,
    pub(crate) line: Line,
    pub(crate) break_load_n: f64,
}

impl ChainLaw {
    fn of(chain: &TensionChain) -> ChainLaw {
        let corner = Corner { at_m: -chain.slack_m, force_n: 0.0, energy_j: 0.0 };
        let line = Line { corners: vec![corner], before_npm: chain.stiffness_npm, beyond_npm: 0.0 };
        ChainLaw { at_m: chain.at_m, line, break_load_n: chain.break_load_n }
    }
}

/// The springs of a panel for a state of its chains: first the cones, then the chains.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Springs<'p> {
    pub(crate) law: &'p PanelLaw,
    pub(crate) state: ChainState,
}

impl<'p> Springs<'p> {
    pub(crate) const MOST: usize = Panel::MOST_CONES + Panel::MOST_CHAINS;

    pub(crate) fn count(&self) -> usize {
        self.law.places_m.len() + self.law.chains.len()
    }

    /// Returns the chain if the spring with this number is a chain, else `None`.
    fn chain(&self, spring: usize) -> Option<(usize, &'p ChainLaw)> {
        let index = spring.checked_sub(self.law.places_m.len())?;
        Some((index, &self.law.chains[index]))
    }

    /// The place of the spring along the panel (m).
    pub(crate) fn at_m(&self, spring: usize) -> f64 {
        self.chain(spring).map_or_else(|| self.law.places_m[spring], |(_, chain)| chain.at_m)
    }

    /// The force law of the spring, and the factor on its force.
    pub(crate) fn line(&self, spring: usize) -> (&'p Line, f64) {
        match self.chain(spring) {
            None => (&self.law.cone, 1.0),
            Some((index, chain)) if self.state.parted & (1 << index) == 0 => {
                (&chain.line, self.state.scale)
            }
            Some((_, chain)) => (&chain.line, 0.0),
        }
    }

    /// Number of linear pieces of the force laws of all springs.
    pub(crate) fn pieces(&self) -> usize {
        let of_chains: usize = self.law.chains.iter().map(|chain| chain.line.pieces()).sum();
        self.law.places_m.len() * self.law.cone.pieces() + of_chains
    }
}

/// A force that is linear between corners, and the integral of the force.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    /// Corners of the force law in the order of rising deflection.
    corners: Vec<Corner>,
    /// Stiffness before the first corner and beyond the last corner (N/m).
    before_npm: f64,
    beyond_npm: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Corner {
    at_m: f64,
    force_n: f64,
    /// The integral of the force from the first corner to this corner (J).
    energy_j: f64,
}

impl Line {
    /// Makes the force law of a cone from its reaction curve and its stop. A stretched cone has the stiffness of the
    /// first line of its curve.
    fn of_cone(points: &[[f64; 2]], stop: Option<Stop>) -> Line {
        let stop_n = |at_m: f64| {
            stop.map_or(0.0, |stop| stop.stiffness_npm * greater(at_m - stop.from_m, 0.0))
        };
        let mut places: Vec<f64> = points.iter().map(|p| p[0]).collect();
        if let Some(stop) = stop
            && let Err(index) = places.binary_search_by(|at_m| at_m.total_cmp(&stop.from_m))
        {
            places.insert(index, stop.from_m);
        }
        let mut corners: Vec<Corner> = Vec::with_capacity(places.len());
        for at_m in places {
            let force_n = on_line(points, at_m) + stop_n(at_m);
            let energy_j = corners.last().map_or(0.0, |last| {
                last.energy_j + 0.5 * (last.force_n + force_n) * (at_m - last.at_m)
            });
            corners.push(Corner { at_m, force_n, energy_j });
        }
        let [.., [x0, y0], [x1, y1]] = points else {
            unreachable!("a reaction curve has two points or more")
        };
        let last_m = corners[corners.len() - 1].at_m;
        let in_stop = stop.filter(|stop| stop.from_m <= last_m).map_or(0.0, |s| s.stiffness_npm);
        Line {
            before_npm: points[1][1] / points[1][0],
            beyond_npm: greater((y1 - y0) / (x1 - x0), 0.0) + in_stop,
            corners,
        }
    }

    /// Number of linear pieces of the force law.
    pub(crate) fn pieces(&self) -> usize {
        self.corners.len() + 1
    }

    /// The piece of the force law at a deflection, which is the number of corners before it. At a corner the result is
    /// the piece into which the deflection moves.
    pub(crate) fn piece_at(&self, deflection_m: f64, rises: bool) -> usize {
        let is_before =
            |corner: &Corner| corner.at_m < deflection_m || (rises && corner.at_m <= deflection_m);
        self.corners.partition_point(is_before)
    }

    /// The deflection at which a piece ends when the deflection rises or falls (m); `None` if the piece does not end.
    pub(crate) fn end_m(&self, piece: usize, rises: bool) -> Option<f64> {
        let corner = if rises { piece } else { piece.checked_sub(1)? };
        self.corners.get(corner).map(|corner| corner.at_m)
    }

    /// Force and stiffness at a deflection on a given piece of the force law (N, N/m).
    pub(crate) fn force_on(&self, piece: usize, deflection_m: f64) -> (f64, f64) {
        let (from, stiffness_npm) = self.line(piece);
        (from.force_n + stiffness_npm * (deflection_m - from.at_m), stiffness_npm)
    }

    /// Force and stored energy at a deflection (N, J).
    pub(crate) fn at(&self, deflection_m: f64) -> (f64, f64) {
        let (from, stiffness_npm) = self.line(self.piece_at(deflection_m, false));
        let by_m = deflection_m - from.at_m;
        let force_n = from.force_n + stiffness_npm * by_m;
        (force_n, from.energy_j + 0.5 * (from.force_n + force_n) * by_m)
    }

    /// A corner at an end of a piece, and the stiffness of the piece.
    fn line(&self, piece: usize) -> (Corner, f64) {
        let last = self.corners.len();
        if piece == 0 {
            (self.corners[0], self.before_npm)
        } else if piece >= last {
            (self.corners[last - 1], self.beyond_npm)
        } else {
            let (from, to) = (self.corners[piece - 1], self.corners[piece]);
            (from, (to.force_n - from.force_n) / (to.at_m - from.at_m))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cone_has_its_curve_its_stop_and_its_stretch() {
        let points = [[0.0, 0.0], [0.3, 9e5], [0.5, 8e5], [0.7, 1e6]];
        let stop = Stop { from_m: 0.6, stiffness_npm: 1e7 };
        let line = Line::of_cone(&points, Some(stop));
        for at_m in [0.0, 0.1, 0.3, 0.45, 0.55, 0.6, 0.65, 0.7, 0.9] {
            let law = FenderLaw::Curve(points.to_vec());
            let past_m = greater(at_m - 0.6, 0.0);
            let (force_n, energy_j) = line.at(at_m);
            let wanted_n = law.reaction_n(at_m) + 1e7 * past_m;
            let wanted_j = law.energy_j(at_m) + 5e6 * past_m * past_m;
            assert!((force_n - wanted_n).abs() < 1e-6, "{at_m}: {force_n} for {wanted_n} N");
            assert!((energy_j - wanted_j).abs() < 1e-6, "{at_m}: {energy_j} for {wanted_j} J");
        }
        let (force_n, energy_j) = line.at(-0.1);
        assert!((force_n + 3e5).abs() < 1e-6 && (energy_j - 1.5e4).abs() < 1e-6);
    }
}
