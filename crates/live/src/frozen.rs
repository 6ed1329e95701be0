//! Frozen instruments: what they show on board in place of the true values.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::{Fault, Simulation};

use crate::frame::{Speeds, speeds};
use crate::message::{Frame, Role};
use crate::session::Session;

/// The last values of a vessel's frozen instruments.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Frozen {
    heading_rad: Option<f64>,
    speeds: Option<Speeds>,
    place: Option<Place>,
}

/// The position of a vessel.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    /// The vessel's centre of gravity (m).
    centre_m: Vec2,
    /// Midship, where the vessel's antenna is (m).
    midship_m: Vec2,
}

/// The values that a vessel's instruments show: the true values, or the values at which an instrument froze.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// Heading by the gyro compass, clockwise from north (rad).
    pub heading_rad: f64,
    /// Rate of turn, positive to starboard (rad/s). The rate is 0 while the compass is frozen.
    pub turn_radps: f64,
    /// Position of the antenna, which is at midship (m).
    pub midship_m: Vec2,
    /// Speeds by the log and the satellite receiver.
    pub speeds: Speeds,
}

impl Frozen {
    /// For each vessel, no frozen instrument.
    pub(crate) fn none(simulation: &Simulation) -> Vec<Frozen> {
        vec![Frozen::default(); simulation.vessels().len()]
    }

    /// True if any instrument is frozen.
    pub(crate) fn any(&self) -> bool {
        *self != Frozen::default()
    }

    /// The speeds that the instruments show, if they are frozen.
    pub(crate) fn speeds(&self) -> Option<Speeds> {
        self.speeds
    }

    /// The rate of turn that the compass shows, given the true rate of turn (rad/s).
    pub(crate) fn turn_radps(&self, now_radps: f64) -> f64 {
        if self.heading_rad.is_some() { 0.0 } else { now_radps }
    }
}

/// Keeps the values of instruments whose fault has begun, and forgets the values of instruments whose fault is over.
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

/// The present position of a vessel.
fn place(simulation: &Simulation, index: usize) -> Place {
    let of = &simulation.setup().world.vessels[index];
    let state = &simulation.states()[of.body];
    let ahead_m = of.ship.particulars.centre_of_gravity_m;
    Place { centre_m: state.position_m, midship_m: state.pose().apply(vec2(-ahead_m, 0.0)) }
}

/// The value that was kept, or the present value if the fault has just begun.
fn kept<T>(is_frozen: bool, before: Option<T>, now: T) -> Option<T> {
    is_frozen.then(|| before.unwrap_or(now))
}

impl Session {
    /// The values that the instruments of a vessel show. `vessel` is her index.
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

    /// The vessel of a pilot or a tug master, if an instrument whose values pages show is frozen.
    pub(crate) fn frozen_vessel(&self, role: &Role) -> Option<usize> {
        let name = match role {
            Role::Pilot { vessel } => self.cast().ship_of(vessel)?,
            Role::Tugmaster { tug } => tug.as_str(),
            Role::Instructor | Role::Observer => return None,
        };
        let vessel = self.cast().vessels.iter().position(|of| of == name)?;
        self.now().frozen[vessel].any().then_some(vessel)
    }

    /// Replaces true values in a frame by the values of frozen instruments.
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
