//! Instruments that stay as they are: what they show on board instead of the truth.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::{Fault, Simulation};

use crate::speeds::{Speeds, speeds};

/// The last values of a vessel's instruments that are frozen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Frozen {
    pub(crate) heading_rad: Option<f64>,
    pub(crate) speeds: Option<Speeds>,
    pub(crate) place: Option<Place>,
}

/// Where a vessel is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// Her centre of gravity (m).
    pub(crate) centre_m: Vec2,
    /// Midship, where her antenna is (m).
    pub(crate) midship_m: Vec2,
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
pub(crate) fn place(simulation: &Simulation, index: usize) -> Place {
    let of = &simulation.setup().world.vessels[index];
    let state = &simulation.states()[of.body];
    let ahead_m = of.ship.particulars.centre_of_gravity_m;
    Place { centre_m: state.position_m, midship_m: state.pose().apply(vec2(-ahead_m, 0.0)) }
}

/// The value that was kept, or that of now if the fault has just begun.
fn kept<T>(is_frozen: bool, before: Option<T>, now: T) -> Option<T> {
    is_frozen.then(|| before.unwrap_or(now))
}
