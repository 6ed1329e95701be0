//! Instruments that stay as they are: what they show on board instead of the truth.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::{Fault, Simulation};

use crate::frame::{Speeds, speeds};
use crate::message::{Frame, Role};
use crate::session::Session;

/// The last values of a vessel's instruments that are frozen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Frozen {
    heading_rad: Option<f64>,
    speeds: Option<Speeds>,
    place: Option<Place>,
}

/// Where a vessel is.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    /// Her centre of gravity (m).
    centre_m: Vec2,
    /// Midship, where her antenna is (m).
    midship_m: Vec2,
}

/// What the instruments of a vessel show: the true values, or those at which an instrument is frozen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// By the gyro compass, from north (rad).
    pub heading_rad: f64,
    /// Rate of turn, positive to starboard (rad/s); none while the compass is frozen.
    pub turn_radps: f64,
    /// Where the antenna is, which is midship (m).
    pub midship_m: Vec2,
    /// By log and satellite receiver.
    pub speeds: Speeds,
}

impl Frozen {
    /// None, for each vessel.
    pub(crate) fn none(simulation: &Simulation) -> Vec<Frozen> {
        vec![Frozen::default(); simulation.vessels().len()]
    }

    /// Whether an instrument is frozen.
    pub(crate) fn any(&self) -> bool {
        *self != Frozen::default()
    }

    /// What the speed instruments show, if they are frozen.
    pub(crate) fn speeds(&self) -> Option<Speeds> {
        self.speeds
    }

    /// The rate of turn that is shown, of which this is the true one (rad/s).
    pub(crate) fn turn_radps(&self, now_radps: f64) -> f64 {
        if self.heading_rad.is_some() { 0.0 } else { now_radps }
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
        own.place = kept(faults.has(Fault::PositionFrozen), own.place, place(simulation, index));
    }
}

/// Where a vessel is now.
fn place(simulation: &Simulation, index: usize) -> Place {
    let of = &simulation.setup().world.vessels[index];
    let state = &simulation.states()[of.body];
    let ahead_m = of.ship.particulars.centre_of_gravity_m;
    Place { centre_m: state.position_m, midship_m: state.pose().apply(vec2(-ahead_m, 0.0)) }
}

/// The value that was kept, or that of now if the fault has just begun.
fn kept<T>(is_frozen: bool, before: Option<T>, now: T) -> Option<T> {
    is_frozen.then(|| before.unwrap_or(now))
}

impl Session {
    /// What the instruments of a vessel show, by her index.
    #[must_use]
    pub fn shown(&self, vessel: usize) -> Shown {
        let (simulation, frozen) = (self.simulation(), &self.now().frozen[vessel]);
        let state = &simulation.states()[simulation.setup().world.vessels[vessel].body];
        Shown {
            heading_rad: frozen.heading_rad.unwrap_or(state.heading_rad),
            turn_radps: frozen.turn_radps(state.yaw_rate_radps),
            midship_m: frozen.place.unwrap_or_else(|| place(simulation, vessel)).midship_m,
            speeds: frozen.speeds.unwrap_or_else(|| speeds(simulation, vessel)),
        }
    }

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
        let Frozen { heading_rad, speeds, place } = self.now().frozen[vessel];
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
        if let Some(Place { centre_m, .. }) = place {
            (*north_m, *east_m) = (centre_m.x, centre_m.y);
        }
    }
}
