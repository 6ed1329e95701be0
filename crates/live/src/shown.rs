//! Finds what the instruments of a vessel show on board, including frozen instruments.

use fenderline_contact::Vec2;

use crate::frozen::{Frozen, Place, place};
use crate::message::{EyesNow, Frame, Role};
use crate::plan;
use crate::session::Session;
use crate::speeds::{Speeds, speeds};

/// What the instruments of a vessel show: the true values, or the values at which an instrument is frozen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// Heading that the gyro compass shows, from north (rad).
    pub heading_rad: f64,
    /// Rate of turn, positive to starboard (rad/s); 0 while the compass is frozen.
    pub turn_radps: f64,
    /// Position that the satellite receiver shows: that of its antenna, which is midship (m).
    pub midship_m: Vec2,
    /// Speeds that the log and the satellite receiver show.
    pub speeds: Speeds,
}

impl Session {
    /// What the instruments of the vessel with this index show.
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

    /// The vessel of a pilot or a tug master, if one of her instruments that pages show is frozen.
    pub(crate) fn frozen_vessel(&self, role: &Role) -> Option<usize> {
        let name = match role {
            Role::Pilot { vessel } => self.cast().ship_of(vessel)?,
            Role::Tugmaster { tug } => tug.as_str(),
            Role::Instructor | Role::Observer => return None,
        };
        let vessel = self.cast().vessels.iter().position(|of| of == name)?;
        self.now().frozen[vessel].any().then_some(vessel)
    }

    /// Puts the values of frozen instruments in the place of the true values of a frame. The true motion moves to `eyes`:
    /// the person finds a frozen instrument because the view out of the window contradicts it.
    pub(crate) fn freeze(&self, vessel: usize, frame: &mut Frame) {
        let Frozen { heading_rad, speeds, place } = self.now().frozen[vessel];
        let body = self.simulation().setup().world.vessels[vessel].body;
        let Some(own) = &mut frame.bodies[body] else { return };
        let water_mps = frame.vessels[vessel].water_mps;
        frame.eyes = Some(EyesNow { body, now: *own, water_mps });
        let [north_m, east_m, heading, north_mps, east_mps, turn_radps] = own;
        if let Some(frozen_rad) = heading_rad {
            (*heading, *turn_radps) = (frozen_rad, 0.0);
        }
        if let Some(shown) = speeds {
            [*north_mps, *east_mps] = shown.velocity_mps;
            let own = &mut frame.vessels[vessel];
            (own.ground_mps, own.water_mps) = (shown.ground_mps, shown.water_mps);
            (own.bow_mps, own.stern_mps) = (shown.bow_mps, shown.stern_mps);
        }
        if let Some(Place { centre_m, midship_m }) = place {
            (*north_m, *east_m) = (centre_m.x, centre_m.y);
            let of = &self.simulation().setup().world.vessels[vessel];
            frame.vessels[vessel].plan =
                of.plan.as_ref().map(|plan| plan::now(&plan.at(midship_m)));
        }
    }
}
