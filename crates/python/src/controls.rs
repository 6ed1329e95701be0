//! The controls of a simulation: numbers that hold until they are set again. The limits of controls come from the table
//! of orders in `fenderline_sim`.

use fenderline_sim::order::OrderName;
use fenderline_sim::tug::TugOrder;
use fenderline_sim::{Action, Order, Setup, VesselAction};

/// Which order the value of a control gives.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Rudder,
    Engine,
    /// The thrust of the thruster that has this index.
    Thruster(usize),
    /// The power of the azimuth unit that has this index.
    AzimuthPower(usize),
    /// The direction of the azimuth unit that has this index.
    AzimuthDirection(usize),
    /// The force of a vector tug, square to the ship: a push if positive, a pull if negative.
    TugForce,
}

/// A control of a scenario's vessel or tug.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Control {
    /// The name by which users know the control, such as `ship.rudder_rad`.
    pub(crate) name: String,
    /// Index of the vessel or tug that the control belongs to.
    target: usize,
    kind: Kind,
}

/// All controls of a scenario: first those of vessels, then those of tugs.
pub(crate) fn controls(setup: &Setup) -> Vec<Control> {
    let world = &setup.world;
    let mut all = Vec::new();
    for (target, vessel) in world.vessels.iter().enumerate() {
        let ship = &setup.bodies[vessel.body].name;
        let mut add = |name: String, kind| {
            all.push(Control { name: format!("{ship}.{name}"), target, kind });
        };
        if OrderName::Rudder.spec().gear.is_on(target, setup) {
            add("rudder_rad".to_owned(), Kind::Rudder);
            add("engine".to_owned(), Kind::Engine);
        }
        for (part, of) in vessel.thrusters.iter().enumerate() {
            add(format!("thruster.{}", of.name), Kind::Thruster(part));
        }
        for (part, of) in vessel.azimuths.iter().enumerate() {
            let name = format!("azimuth.{}", of.name);
            add(format!("{name}.power"), Kind::AzimuthPower(part));
            add(format!("{name}.direction_rad"), Kind::AzimuthDirection(part));
        }
    }
    for (target, of) in world.tugs.iter().enumerate() {
        let name = format!("tug.{}.force_n", of.tug.name);
        all.push(Control { name, target, kind: Kind::TugForce });
    }
    all
}

impl Control {
    /// The smallest and the largest value of the control.
    pub(crate) fn limits(&self) -> [f64; 2] {
        match self.kind {
            Kind::Rudder => OrderName::Rudder.limits("angle"),
            Kind::Engine => OrderName::Engine.limits("share"),
            Kind::Thruster(_) => OrderName::Thruster.limits("power"),
            Kind::AzimuthPower(_) => OrderName::Azimuth.limits("power"),
            Kind::AzimuthDirection(_) => OrderName::Azimuth.limits("direction"),
            Kind::TugForce => {
                let [_, most_n] = OrderName::Push.limits("force");
                [-most_n, most_n]
            }
        }
    }

    /// The order that sets the control to a value at a time. The simulation checks the order of a control like any
    /// other order.
    pub(crate) fn order(&self, value: f64, at_s: f64, setup: &Setup) -> Order {
        let of_unit =
            |unit, power, direction_rad| VesselAction::Azimuth { unit, power, direction_rad };
        let action = match self.kind {
            Kind::Rudder => VesselAction::Rudder(value),
            Kind::Engine => VesselAction::Engine(value),
            Kind::Thruster(part) => VesselAction::Thruster(part, value),
            Kind::AzimuthPower(unit) => of_unit(unit, Some(value), None),
            Kind::AzimuthDirection(unit) => of_unit(unit, None, Some(value)),
            Kind::TugForce => {
                let action = Action::Tug(self.target, self.tug_order(value, setup));
                return Order { at_s, action };
            }
        };
        Order { at_s, action: Action::Vessel(self.target, action) }
    }

    fn tug_order(&self, force_n: f64, setup: &Setup) -> TugOrder {
        let push_rad = setup.world.tugs[self.target].square_push_rad();
        if force_n > 0.0 {
            TugOrder::Push { force_n, direction_rad: push_rad }
        } else if force_n < 0.0 {
            TugOrder::Pull { force_n: -force_n, direction_rad: -push_rad }
        } else {
            TugOrder::StandBy
        }
    }
}
