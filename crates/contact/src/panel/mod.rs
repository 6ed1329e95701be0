//! A rigid panel on several fenders, which moves inwards and turns about the vertical axis.
//!
//! The panel has no mass. The pose of the panel is d, the deflection of the panel's middle, and θ, the panel's turn
//! (small). The cone at the place x along the panel has the deflection δ = d + θ x. The panel takes the pose of least
//! stored energy E(d, θ) = Σ E_i(d + θ x_i) among the poses in which the hull does not pass through the panel
//! ([`least`]). This least energy is a single-valued function of the hull's pose, even for cones that buckle, for which
//! a panel has several positions of equilibrium. The force on the panel is the gradient of the least energy, so this
//! force creates no energy on any closed path. The unloading law needs a stored energy of this kind, and holds for a
//! panel as it does for one fender.
//!
//! | file | content |
//! |---|---|
//! | `law.rs` | piecewise linear springs behind the panel |
//! | `least.rs` | the pose of least energy |
//! | `touching.rs` | the points of a hull that a panel can meet |
//! | `press.rs` | force, deflections and moment |
//! | `chains.rs` | chains that have parted, and chains that part in a sub-step |

pub(crate) mod chains;
pub(crate) mod law;
mod least;
pub(crate) mod press;
pub(crate) mod report;
pub(crate) mod touching;

use alloc::vec::Vec;

use crate::error::ModelError;
use crate::maths::number::{greater, lesser};
use crate::model::reaction::FenderLaw;
use crate::model::unloading::Unloading;

/// A rigid panel without mass in front of several equal fenders ("cones") on the same mounting line.
///
/// With a panel, the curve, the stop and the rated deflection of a [`crate::Fender`] are those of each cone, and
/// [`crate::Fender::width_m`] is the width of the panel. A stretched cone pulls back with the stiffness of the first
/// line of its curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Places of the cones along the panel, from the panel's middle (m), positive to the right as seen by a viewer who
    /// faces the panel. A panel has two to [`Panel::MOST_CONES`] cones, and not all of them at one place.
    pub cones_m: Vec<f64>,
    /// Tension chains, at most [`Panel::MOST_CHAINS`]: they hold a panel that turns outwards.
    pub tension_chains: Vec<TensionChain>,
}

/// A chain from the structure to the panel. The chain is slack until the panel has moved outwards by `slack_m` at the
/// place of the chain. Beyond the slack the chain is a linear spring, and it parts at its break load. A chain that has
/// parted stays parted for the rest of the run ([`crate::Memory`] keeps this), and the energy that it stored is lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TensionChain {
    /// Place of the chain along the panel from the panel's middle (m), as in [`Panel::cones_m`].
    pub at_m: f64,
    /// How far the panel moves outwards before the chain holds (m).
    pub slack_m: f64,
    /// Stiffness (N/m).
    pub stiffness_npm: f64,
    /// Tension at which the chain parts (N).
    pub break_load_n: f64,
}

impl Panel {
    /// Largest number of cones behind one panel.
    pub const MOST_CONES: usize = 8;

    /// Largest number of tension chains of one panel.
    pub const MOST_CHAINS: usize = 4;

    /// Smallest allowed distance between the outermost cones (m). The distance is needed because cones at one place
    /// would not hold the panel against turning.
    pub const LEAST_SPREAD_M: f64 = 1e-2;

    /// The numbers that distinguish this panel from other panels, for fingerprints of models.
    pub(crate) fn words(&self) -> impl Iterator<Item = f64> + '_ {
        let of_chain = |c: &TensionChain| [c.at_m, c.slack_m, c.stiffness_npm, c.break_load_n];
        self.cones_m.iter().copied().chain(self.tension_chains.iter().flat_map(of_chain))
    }

    /// Checks the values of the panel, together with the name, width and laws of its fender.
    pub(crate) fn check(
        &self,
        owner: &str,
        width_m: f64,
        law: &FenderLaw,
        unloading: Option<&Unloading>,
    ) -> Result<(), ModelError> {
        let bad = |field, value, must| {
            Err(ModelError::OutOfRange { owner: owner.into(), field, value, must })
        };
        let count = self.cones_m.len();
        if !(2..=Panel::MOST_CONES).contains(&count) {
            return bad("number of cones", count as f64, "between 2 and 8");
        }
        let half_m = 0.5 * width_m;
        for &at_m in &self.cones_m {
            if !(-half_m..=half_m).contains(&at_m) {
                return bad("place of a cone", at_m, "within the width of the panel");
            }
        }
        let low_m = self.cones_m.iter().copied().fold(f64::INFINITY, lesser);
        let high_m = self.cones_m.iter().copied().fold(f64::NEG_INFINITY, greater);
        if high_m - low_m < Panel::LEAST_SPREAD_M {
            return bad("spread of the cones", high_m - low_m, "at least 0.01 m along the panel");
        }
        let chains = self.tension_chains.len();
        if chains > Panel::MOST_CHAINS {
            return bad("number of tension chains", chains as f64, "at most 4");
        }
        for chain in &self.tension_chains {
            if !(-half_m..=half_m).contains(&chain.at_m) {
                return bad("place of a chain", chain.at_m, "within the width of the panel");
            }
            if !(0.0..=1e3).contains(&chain.slack_m) {
                return bad("slack of a chain", chain.slack_m, "between 0 and 1000 m");
            }
            if !(1.0..=1e15).contains(&chain.stiffness_npm) {
                return bad("stiffness of a chain", chain.stiffness_npm, "between 1 and 1e15 N/m");
            }
            if !(1.0..=1e15).contains(&chain.break_load_n) {
                return bad("break load of a chain", chain.break_load_n, "between 1 and 1e15 N");
            }
        }
        match law {
            FenderLaw::Area => {
                return bad("law", 0.0, "a reaction curve, because the fender has a panel");
            }
            FenderLaw::Curve(points) if points.len() >= 2 && points[1][1] <= 0.0 => {
                return bad(
                    "first line of the curve",
                    points[1][1],
                    "rising, because the fender has a panel",
                );
            }
            FenderLaw::Curve(_) => {}
        }
        if let Some(Unloading::Curve(_)) = unloading {
            let must = "a returned share of the energy, because the fender has a panel";
            return bad("unloading curve", 0.0, must);
        }
        Ok(())
    }
}
