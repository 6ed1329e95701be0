//! Frozen instruments: the values that they show on board in place of the true values.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::{Fault, Simulation};

use crate::speeds::{Speeds, speeds};

/// The last values of a vessel's frozen instruments.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Frozen {
    pub(crate) heading_rad: Option<f64>,
    pub(crate) speeds: Option<Speeds>,
    pub(crate) place: Option<Place>,
}

/// The position of a vessel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// The vessel's centre of gravity (m).
    pub(crate) centre_m: Vec2,
    /// Midship, where the vessel's antenna is (m).
    pub(crate) midship_m: Vec2,
}

impl Frozen {
    /// For each vessel an entry that says that no instrument is frozen.
    pub(crate) fn none(simulation: &Simulation) -> Vec<Frozen> {
        vec![Frozen::default(); simulation.vessels().len()]
    }

    /// True if any instrument of the vessel is frozen.
    pub(crate) fn any(&self) -> bool {
        *self != Frozen::default()
    }

    /// The speeds that frozen instruments show; `None` if they are not frozen.
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
pub(crate) fn place(simulation: &Simulation, index: usize) -> Place {
    let of = &simulation.setup().world.vessels[index];
    let state = &simulation.states()[of.body];
    let ahead_m = of.ship.particulars.centre_of_gravity_m;
    Place { centre_m: state.position_m, midship_m: state.pose().apply(vec2(-ahead_m, 0.0)) }
}

/// The value that a frozen instrument kept, or the present value if its fault has just begun.
fn kept<T>(is_frozen: bool, before: Option<T>, now: T) -> Option<T> {
    is_frozen.then(|| before.unwrap_or(now))
}
