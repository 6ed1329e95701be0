//! Motion of a ship with hydrodynamic data in six degrees of freedom, by Cummins' equation.
//!
//! | file | content |
//! |---|---|
//! | `data.rs` | the data of a panel code, checked and moved to the centre of gravity |
//! | `check.rs` | the checks |
//! | `passive.rs` | the check that the hydrodynamic data give energy to no combination of motions |
//! | `waves_check.rs` | the check of the sizes of exciting and drift forces |
//! | `error.rs` | the errors that hydrodynamic data can have |
//! | `retardation.rs` | the retardation function, and added mass from damping |
//! | `memory.rs` | the memory of the water as a bank of resonators |
//! | `least_squares.rs`, `matrix.rs` | linear algebra |
//! | `between.rs` | wave forces, interpolated between the headings and frequencies of the hydrodynamic data |
//! | `resolution.rs` | the waves whose forces the hydrodynamic data do not resolve |
//! | `forces.rs` | exciting forces, mean drift and slow drift of a sea |
//! | `motion.rs` | the time step |
//! | `sub_steps.rs` | the times at which loads act, where contact takes several sub-steps |
//! | `place.rs` | the place of the ship at which the waves act on her |
//!
//! `docs/design/at_the_berth.md` has the reasons.

mod between;
mod check;
mod checked;
mod data;
mod error;
mod forces;
mod least_squares;
pub mod matrix;
mod memory;
mod motion;
mod ogilvie;
mod passive;
mod place;
mod raw;
mod resolution;
mod retardation;
mod spline;
mod sub_steps;
mod unknown_damping;
mod waves_check;

use std::sync::Arc;

pub use data::Hydrodynamics;
pub use error::{Part, Reason, SeakeepingError};
pub use forces::{DriftSource, WaveForces, WaveLoad};
pub use memory::Memory;
pub use motion::{Motion, MotionState, StepLoad};
pub use place::SlowPlace;
pub use raw::RawHydrodynamics;
pub use resolution::Unresolved;
pub use retardation::Retardation;
pub use sub_steps::SubSteps;

/// The names of the six motions of a ship.
pub const MOTIONS: [&str; 6] = ["surge", "sway", "heave", "roll", "pitch", "yaw"];

/// A ship that moves by hydrodynamic data.
#[derive(Clone, Debug, PartialEq)]
pub struct Seakeeping {
    /// The data.
    pub data: Arc<Hydrodynamics>,
    /// Viscous damping of roll, as a share of the critical damping. Viscous damping of roll comes from bilge keels and
    /// the edges of the hull; no panel code includes it.
    pub roll_damping: f64,
}

impl Seakeeping {
    /// Whether the hydrodynamic data hold in water of a depth (m; `None`: deep), for a ship of the given draught (m).
    /// The depth of the data and that of the run must agree within a tenth, or both count as deep. Water deeper than
    /// ten draughts counts as deep. The limits of a tenth of the depth and of ten draughts are our choice.
    #[must_use]
    pub fn is_for_depth(&self, depth_m: Option<f64>, draught_m: f64) -> bool {
        let [of_data_m, of_run_m] =
            [self.data.depth_m(), depth_m].map(|depth_m| depth_m.unwrap_or(f64::INFINITY));
        let both_deep = of_data_m > DEEP * draught_m && of_run_m > DEEP * draught_m;
        both_deep || (of_data_m - of_run_m).abs() <= DEPTH * of_run_m
    }
}

/// Largest difference between the depth of water of the hydrodynamic data and the depth of the run, as a share of the
/// depth of the run.
const DEPTH: f64 = 0.1;
/// Depth from which water counts as deep, in draughts.
const DEEP: f64 = 10.0;
