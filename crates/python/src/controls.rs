//! Controls: each a number that stands until it is set again.

use std::f64::consts::FRAC_PI_2;

use fenderline_sim::tug::TugOrder;
use fenderline_sim::{Action, Order, Setup};

/// What a control moves: indices into the set-up's vessels and tugs, and into a vessel's own.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Rudder(usize),
    Engine(usize),
    Thruster(usize, usize),
    AzimuthPower(usize, usize),
    AzimuthDirection(usize, usize),
    Tug { tug: usize, vessel: usize, away_rad: f64 },
}

/// A control of a set-up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Control {
    /// As users name it: `ship.rudder_rad`.
    pub(crate) name: String,
    kind: Kind,
}

/// All controls of a set-up, in their order.
pub(crate) fn controls(setup: &Setup) -> Vec<Control> {
    let world = &setup.world;
    let mut all = Vec::new();
    let mut add = |name: String, kind| all.push(Control { name, kind });
    for (index, vessel) in world.vessels.iter().enumerate() {
        let ship = &setup.bodies[vessel.body].name;
        if vessel.ship.propulsion.is_some() {
            add(format!("{ship}.rudder_rad"), Kind::Rudder(index));
            add(format!("{ship}.engine"), Kind::Engine(index));
        }
        for (thruster, of) in vessel.thrusters.iter().enumerate() {
            add(format!("{ship}.thruster.{}", of.name), Kind::Thruster(index, thruster));
        }
        for (azimuth, of) in vessel.azimuths.iter().enumerate() {
            let of = format!("{ship}.azimuth.{}", of.name);
            add(format!("{of}.power"), Kind::AzimuthPower(index, azimuth));
            add(format!("{of}.direction_rad"), Kind::AzimuthDirection(index, azimuth));
        }
    }
    for (tug, of) in world.tugs.iter().enumerate() {
        // As in a scenario without a direction: square to the ship, away from the tug's side.
        let away_rad = -FRAC_PI_2.copysign(of.tug.push_at_m.y);
        let kind = Kind::Tug { tug, vessel: of.vessel, away_rad };
        add(format!("tug.{}.force_n", of.tug.name), kind);
    }
    all
}

impl Control {
    /// The order that sets this control to a value at a time.
    pub(crate) fn order(&self, value: f64, at_s: f64) -> Order {
        let (vessel, action) = match self.kind {
            Kind::Rudder(vessel) => (vessel, Action::Rudder(value)),
            Kind::Engine(vessel) => (vessel, Action::Engine(value)),
            Kind::Thruster(vessel, index) => (vessel, Action::Thruster(index, value)),
            Kind::AzimuthPower(vessel, unit) => {
                (vessel, Action::Azimuth { unit, power: Some(value), direction_rad: None })
            }
            Kind::AzimuthDirection(vessel, unit) => {
                (vessel, Action::Azimuth { unit, power: None, direction_rad: Some(value) })
            }
            Kind::Tug { tug, vessel, away_rad } => {
                let order = if value > 0.0 {
                    TugOrder::Push { force_n: value, direction_rad: away_rad }
                } else if value < 0.0 {
                    TugOrder::Pull { force_n: -value, direction_rad: -away_rad }
                } else {
                    TugOrder::StandBy
                };
                (vessel, Action::Tug(tug, order))
            }
        };
        Order { at_s, vessel, action }
    }
}
