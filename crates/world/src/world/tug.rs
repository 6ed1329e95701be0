//! Vector tugs of a simulation.

use core::f64::consts::FRAC_PI_2;

use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};

use super::environment::Environment;
use super::vessel::VesselSetup;
use fenderline_ship::control::LateralDevice;
use fenderline_ship::hydro::Force;
use fenderline_ship::hydro::Particulars;
use fenderline_ship::step_time::StepTime;
use fenderline_ship::tug::{TugForce, TugOrder, TugState, VectorTug};

/// A vector tug of a set-up.
#[derive(Clone, Debug, PartialEq)]
pub struct TugSetup {
    /// Index of the vessel that the tug serves, in [`crate::world::WorldSetup::vessels`].
    pub vessel: usize,
    /// The tug.
    pub tug: VectorTug,
    /// Height above the still water at which the tug pushes, and at which the fairlead of the tug's line is (m).
    /// Because of this height, the tug's force heels and trims a vessel with hydrodynamic data.
    pub above_water_m: f64,
}

/// The state of a vector tug, as plain data.
#[derive(Clone, Debug, PartialEq)]
pub struct TugAtWork {
    /// Orders, force and direction.
    pub state: TugState,
    /// Force of the tug in the last step, in the vessel's axes about midship.
    pub force: Force,
    /// Point at which the force acts, measured from midship (m).
    pub at_m: Vec2,
    /// True if the tug could not give the ordered force in the last step.
    pub limited: bool,
    /// True if the tug has dropped out: the tug then carries out no orders and gives no force.
    pub out: bool,
}

impl TugAtWork {
    /// Becomes a copy of another state. The copy allocates only if a buffer is too small.
    pub fn copy_from(&mut self, other: &TugAtWork) {
        let mut waiting = std::mem::take(&mut self.state.waiting);
        waiting.clone_from(&other.state.waiting);
        let state = TugState { waiting, ..other.state };
        *self = TugAtWork { state, ..*other };
    }

    /// The state of the tug at the start of a run.
    pub fn new(setup: &TugSetup) -> TugAtWork {
        TugAtWork {
            state: TugState::default(),
            force: Force::default(),
            at_m: setup.tug.push_at_m,
            limited: false,
            out: false,
        }
    }

    /// Orders a force to starboard of the vessel (N): a push if the force points away from the tug's side, otherwise a
    /// pull on the tug's line.
    pub fn push_or_pull(&mut self, setup: &TugSetup, t_s: f64, starboard_n: f64) {
        let direction_rad = FRAC_PI_2.copysign(starboard_n);
        let force_n = starboard_n.abs();
        let away = setup.tug.push_at_m.y * starboard_n <= 0.0;
        let order = if force_n == 0.0 {
            TugOrder::StandBy
        } else if away {
            TugOrder::Push { force_n, direction_rad }
        } else {
            TugOrder::Pull { force_n, direction_rad }
        };
        let taken = setup.tug.order(&mut self.state, t_s, order);
        debug_assert!(taken.is_ok(), "a pilot stays within the limits of a tug");
    }

    /// Does one step of the tug. Returns the wrench (force and moment) of the tug on the vessel's body.
    pub fn step(
        &mut self,
        setup: &TugSetup,
        ship: &Particulars,
        state: &BodyState,
        environment: &Environment,
        step: StepTime,
    ) -> Wrench {
        if self.out {
            self.state.waiting.clear();
            self.state.order = TugOrder::StandBy;
        }
        let attitude = Rotation::from_angle(state.heading_rad);
        let current = environment.current(state.position_m, step.t_s, ship.draught_m);
        let water_mps = attitude.apply_inverse(state.velocity_mps - current);
        let density = environment.water_density_kgpm3;
        let TugForce { force: [surge_n, sway_n, yaw_nm], at_m, limited, .. } =
            setup.tug.step(&mut self.state, step, water_mps, density);
        (self.limited, self.at_m) = (limited, at_m);
        self.force = Force { surge_n, sway_n, yaw_nm };
        Wrench {
            force_n: attitude.apply(vec2(surge_n, sway_n)),
            moment_nm: yaw_nm - ship.centre_of_gravity_m * sway_n,
        }
    }
}

impl TugSetup {
    /// Direction of a push square to the ship, away from the tug's side, measured from the ship's bow (rad). A pull has
    /// the opposite direction.
    #[must_use]
    pub fn square_push_rad(&self) -> f64 {
        -FRAC_PI_2.copysign(self.tug.push_at_m.y)
    }

    /// Describes the tug as a device for an automatic pilot of the ship. The tug can pull on the line with the same
    /// force with which the tug can push.
    pub fn device(&self, vessel: &VesselSetup) -> LateralDevice {
        let most_n = 0.95 * self.tug.envelope.bollard_pull_n;
        LateralDevice {
            forward_m: self.tug.push_at_m.x - vessel.ship.particulars.centre_of_gravity_m,
            limits_n: [-most_n, most_n],
        }
    }
}
