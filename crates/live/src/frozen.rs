//! Instruments that stay as they are: what they show on board instead of the truth.

use fenderline_contact::Vec2;
use fenderline_sim::{Fault, Simulation};

use crate::frame::{Speeds, speeds};
use crate::message::{Frame, Role};
use crate::session::Session;

/// The last values of a vessel's instruments that are frozen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Frozen {
    heading_rad: Option<f64>,
    speeds: Option<Speeds>,
    position_m: Option<Vec2>,
}

impl Frozen {
    /// None, for each vessel.
    pub(crate) fn none(simulation: &Simulation) -> Vec<Frozen> {
        vec![Frozen::default(); simulation.vessels().len()]
    }

    fn any(&self) -> bool {
        *self != Frozen::default()
    }
}

/// Takes the values of instruments whose fault has begun, and forgets those whose fault is over.
pub(crate) fn renew(all: &mut [Frozen], simulation: &Simulation) {
    for (index, own) in all.iter_mut().enumerate() {
        let state = &simulation.states()[simulation.setup().world.vessels[index].body];
        let faults = simulation.vessels()[index].faults;
        let now = speeds(simulation, index);
        own.heading_rad =
            kept(faults.has(Fault::HeadingFrozen), own.heading_rad, state.heading_rad);
        own.speeds = kept(faults.has(Fault::SpeedFrozen), own.speeds, now);
        own.position_m = kept(faults.has(Fault::PositionFrozen), own.position_m, state.position_m);
    }
}

/// The value that was kept, or that of now if the fault has just begun.
fn kept<T>(is_frozen: bool, before: Option<T>, now: T) -> Option<T> {
    is_frozen.then(|| before.unwrap_or(now))
}

impl Session {
    /// The vessel of a pilot or a tug master if one of her instruments that pages show is frozen.
    pub(crate) fn frozen_vessel(&self, role: &Role) -> Option<usize> {
        let name = match role {
            Role::Pilot { vessel } => self.cast().ship_of(vessel)?,
            Role::Tugmaster { tug } => tug.as_str(),
            Role::Instructor | Role::Observer => return None,
        };
        let vessel = self.cast().vessels.iter().position(|of| of == name)?;
        self.now().frozen[vessel].any().then_some(vessel)
    }

    /// Puts frozen values in the place of true ones.
    pub(crate) fn freeze(&self, vessel: usize, frame: &mut Frame) {
        let Frozen { heading_rad, speeds, position_m } = self.now().frozen[vessel];
        let body = self.simulation().setup().world.vessels[vessel].body;
        let Some([north_m, east_m, heading, north_mps, east_mps, turn_radps]) =
            &mut frame.bodies[body]
        else {
            return;
        };
        if let Some(frozen_rad) = heading_rad {
            (*heading, *turn_radps) = (frozen_rad, 0.0);
        }
        if let Some(shown) = speeds {
            [*north_mps, *east_mps] = shown.velocity_mps;
            let own = &mut frame.vessels[vessel];
            (own.ground_mps, own.water_mps) = (shown.ground_mps, shown.water_mps);
            (own.bow_mps, own.stern_mps) = (shown.bow_mps, shown.stern_mps);
        }
        if let Some(position) = position_m {
            (*north_m, *east_m) = (position.x, position.y);
        }
    }
}
