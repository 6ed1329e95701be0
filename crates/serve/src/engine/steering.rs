//! Orders of a controller that steers by NMEA sentences: numbers of engines and thrusters become names of the scenario.

use core::f64::consts::TAU;

use fenderline_live::message::VesselInfo;
use fenderline_live::{Action, Conduct, Control, NamedOrder, Refusal, Request};
use fenderline_nautical::read::{ControlOrder, EngineDemand};
use fenderline_sim::OrderName;

use super::Engine;
use crate::claims::ClientId;

/// A thruster of a ship, by name.
enum Unit<'a> {
    Tunnel(&'a str),
    Azimuth(&'a str),
}

impl Unit<'_> {
    fn name(&self) -> &str {
        match self {
            Unit::Tunnel(name) | Unit::Azimuth(name) => name,
        }
    }
}

impl Engine {
    /// Carries out the order of a controller to the pilot's own ship, or refuses the order.
    pub(super) fn steer(&mut self, client: ClientId, order: ControlOrder) {
        let request = match self.own_ship() {
            Some(ship) => {
                let helm = Control::Vessel(ship.name.clone());
                if order == ControlOrder::Release && !self.claims.holds(&helm, client) {
                    return;
                }
                request(ship, helm, order)
            }
            None => Err(Refusal::new("the scenario has no ship that can be steered")),
        };
        self.command(client, None, request);
    }

    fn own_ship(&self) -> Option<&VesselInfo> {
        self.session.info().vessels.get(self.session.cast().own?)
    }

    /// Gives the helm of a controller back that has given no order for some time. The last order stands.
    pub(super) fn silent(&mut self, client: ClientId) {
        let Some(label) = self.clients.get(&client).map(|of| of.label.clone()) else { return };
        let left = self.claims.gone(client, None);
        if !left.is_empty() {
            self.tell_all_left(&format!("{label} is silent"), &left);
            self.greet_all();
        }
    }
}

/// The request of an order to a ship.
fn request(ship: &VesselInfo, helm: Control, order: ControlOrder) -> Result<Request, Refusal> {
    let name = ship.name.as_str();
    let order = match order {
        ControlOrder::Release => {
            return Ok(Request::Conduct(Conduct::Release { control: helm }));
        }
        ControlOrder::Heading(deg) => {
            NamedOrder::new(OrderName::Course, name).number("heading", deg.to_radians() % TAU)
        }
        ControlOrder::Rudder(deg) => {
            NamedOrder::new(OrderName::Rudder, name).number("angle", deg.to_radians())
        }
        ControlOrder::Engine { number, demand } => engine(ship, number, demand)?,
        ControlOrder::Thruster { number, share, azimuth_deg } => {
            thruster(ship, number, share, azimuth_deg)?
        }
    };
    Ok(Request::Action(Action::from(order)))
}

/// The order to the engine. A ship here has one engine: the number 0 stands for the only engine, 1 for the first.
fn engine(ship: &VesselInfo, number: u32, demand: EngineDemand) -> Result<NamedOrder, Refusal> {
    let name = ship.name.as_str();
    if number > 1 {
        return Err(Refusal::new(format_args!("{name} has no engine {number}: use 0 or 1")));
    }
    let share = match (demand, ship.full_rps) {
        (EngineDemand::Share(share), _) => share,
        (EngineDemand::Revolutions(per_min), Some(full_rps)) => per_min / 60.0 / full_rps,
        (EngineDemand::Revolutions(_), None) => {
            return Err(Refusal::new(format_args!("{name} has no propeller")));
        }
    };
    Ok(NamedOrder::new(OrderName::Engine, name).number("share", share))
}

/// The thrusters of a ship with their numbers: odd for those of the forward half, even for those of the after half, in
/// the order of the scenario, tunnel thrusters before azimuth units.
fn units(ship: &VesselInfo) -> Vec<(u32, Unit<'_>)> {
    let tunnels = ship.thrusters.iter().map(|of| (of.along_m, Unit::Tunnel(&of.name)));
    let azimuths = ship.azimuths.iter().map(|of| (of.at_m[0], Unit::Azimuth(&of.name)));
    let mut next = [1, 2];
    let mut numbered = |along_m: f64| {
        let number = &mut next[usize::from(along_m < 0.0)];
        *number += 2;
        *number - 2
    };
    tunnels.chain(azimuths).map(|(along_m, unit)| (numbered(along_m), unit)).collect()
}

fn thruster(
    ship: &VesselInfo,
    number: u32,
    share: f64,
    azimuth_deg: Option<f64>,
) -> Result<NamedOrder, Refusal> {
    let units = units(ship);
    let Some((_, unit)) = units.iter().find(|(own, _)| *own == number) else {
        let own: Vec<String> =
            units.iter().map(|(number, unit)| format!("{number} is {}", unit.name())).collect();
        let own = if own.is_empty() { "none".to_owned() } else { own.join(", ") };
        return Err(Refusal::new(format_args!(
            "{} has no thruster {number}; her thrusters: {own}",
            ship.name
        )));
    };
    let order = match unit {
        Unit::Tunnel(name) => NamedOrder::new(OrderName::Thruster, &ship.name)
            .name("name", name)
            .number("power", share),
        Unit::Azimuth(name) => {
            let order = NamedOrder::new(OrderName::Azimuth, &ship.name);
            let order = order.name("name", name).number("power", share);
            match azimuth_deg {
                Some(deg) => order.number("direction", deg.to_radians()),
                None => order,
            }
        }
    };
    Ok(order)
}
