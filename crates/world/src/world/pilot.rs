//! The pilots of a vessel. In each step, the pilots turn orders for course, speed or station into orders to rudder,
//! engine and thrusters.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{BodyState, Rotation};

use super::abilities::Abilities;
use super::assist::AssistPilot;
use super::azimuth_pilot::{Steered, largest_of_azimuths, share_with_azimuths};
use super::pilots::Pilots;
use super::vessel::{VesselSetup, VesselState};
use crate::order::{Station, VesselAction};
use fenderline_ship::control::{
    CoursePilot, Demand, Gains, LateralDevice, SpeedPilot, StationPilot, ThrustShares, allocate,
};

/// Carries out an order to a vessel: sets the vessel's controls or switches on a pilot.
pub(super) fn take(
    action: &VesselAction,
    vessel: &mut VesselState,
    setup: &VesselSetup,
    abilities: &Abilities,
    state: &BodyState,
) {
    let speed_mps = state.velocity_mps.length();
    let pilots = &mut vessel.pilots;
    match *action {
        VesselAction::Rudder(angle_rad) => {
            (pilots.course, pilots.station) = (None, None);
            vessel.orders.rudder_rad = angle_rad;
        }
        VesselAction::Engine(share) => {
            (pilots.speed, pilots.station) = (None, None);
            vessel.orders.shaft = share;
        }
        VesselAction::Thruster(index, power) => {
            (pilots.station, pilots.assist) = (None, None);
            vessel.orders.thrusters[index] = power;
        }
        VesselAction::Azimuth { unit, power, direction_rad } => {
            (pilots.station, pilots.assist) = (None, None);
            if setup.steers_with_azimuths() {
                (pilots.course, pilots.speed) = (None, None);
            }
            let order = &mut vessel.orders.azimuths[unit];
            order.power = power.unwrap_or(order.power);
            order.direction_rad = direction_rad.unwrap_or(order.direction_rad);
        }
        VesselAction::Assist(order) => {
            *pilots = Pilots { assist: Some(AssistPilot::new(order)), ..Pilots::default() };
        }
        VesselAction::Course(heading_rad) => {
            (pilots.station, pilots.assist) = (None, None);
            let length_m = setup.ship.particulars.length_m;
            let stop_rad = setup.rudder.stop;
            let units = vessel.orders.azimuths.iter().zip(&setup.azimuths);
            pilots.ahead_n = units
                .map(|(order, of)| order.power * libm::cos(order.direction_rad) * of.bollard_n)
                .sum();
            pilots.course = Some(CoursePilot::of_ship(heading_rad, length_m, speed_mps, stop_rad));
        }
        VesselAction::Speed(wanted_mps) => {
            (pilots.station, pilots.assist) = (None, None);
            pilots.speed = Some(SpeedPilot {
                speed_mps: wanted_mps,
                full_speed_mps: abilities.full_speed_mps,
                integral_s: 120.0,
                integral: 0.0,
            });
        }
        VesselAction::Station(station) => {
            (pilots.course, pilots.speed, pilots.assist) = (None, None, None);
            let steady = pilots.station.map_or([0.0; 3], |before| before.steady);
            pilots.station = Some(station_pilot(&station, abilities, setup, steady));
        }
        VesselAction::Hands => *pilots = Pilots::default(),
    }
}

fn station_pilot(
    station: &Station,
    abilities: &Abilities,
    setup: &VesselSetup,
    steady: [f64; 3],
) -> StationPilot {
    let [surge, sway] = station.fastest_mps;
    StationPilot {
        position_m: station.position_m,
        heading_rad: station.heading_rad,
        gains: Gains {
            inertia: abilities.inertia,
            period_s: 240.0,
            damping: 0.9,
            integral_s: 300.0,
            // The limit on turning: it moves the ship's ends no faster than sway does.
            fastest: [surge, sway, 2.0 * sway / setup.ship.particulars.length_m],
        },
        steady,
    }
}

/// Buffers of the pilots, which each step uses again.
#[derive(Clone, Debug, Default)]
pub(super) struct PilotWork {
    /// Other lateral devices that serve the vessel, that is tugs.
    pub(super) helpers: Vec<LateralDevice>,
    /// Forces of the helpers, if a pilot uses the helpers (N).
    pub(super) helpers_n: Vec<f64>,
    /// Thrusters and helpers together; `across_n` has the forces of these devices (N).
    across: Vec<LateralDevice>,
    across_n: Vec<f64>,
    /// Azimuth units and all other devices, which together give the demanded force, and the force of each device.
    pub(super) shares: ThrustShares,
}

/// Sets the orders of the vessel for this step. The field `helpers` of `work` has the other lateral devices. The
/// function writes the forces of these devices to `helpers_n` of `work`.
pub(super) fn pilot(
    vessel: &mut VesselState,
    steered: Steered<'_>,
    state: &BodyState,
    work: &mut PilotWork,
    step_s: f64,
) {
    let Steered { setup, abilities, .. } = steered;
    let PilotWork { helpers, helpers_n, across: devices, across_n: forces_n, shares } = work;
    helpers_n.clear();
    if !setup.steers_with_azimuths() {
        under_way(vessel, state, step_s);
    }
    let Some(station) = &mut vessel.pilots.station else { return };
    let ahead_m = setup.ship.particulars.centre_of_gravity_m;
    devices.clear();
    devices.extend(setup.thrusters.iter().map(|thruster| LateralDevice {
        forward_m: thruster.tunnel.along_m - ahead_m,
        limits_n: [-thruster.tunnel.bollard_n, thruster.tunnel.bollard_n],
    }));
    devices.extend_from_slice(helpers);
    let [astern_n, forward_n] = abilities.bollard_n;
    let reach = |device: &LateralDevice| greater(device.limits_n[1], -device.limits_n[0]);
    let mut largest = Demand {
        surge_n: lesser(forward_n, -astern_n),
        sway_n: devices.iter().map(reach).sum(),
        yaw_nm: devices.iter().map(|d| reach(d) * d.forward_m.abs()).sum(),
    };
    let units = largest_of_azimuths(setup);
    largest.surge_n += units.surge_n;
    largest.sway_n += units.sway_n;
    largest.yaw_nm += units.yaw_nm;
    let demand = station.demand(state, &largest, step_s);
    vessel.orders.rudder_rad = 0.0;
    forces_n.clear();
    forces_n.resize(devices.len(), 0.0);
    if setup.azimuths.is_empty() {
        vessel.orders.shaft = abilities.revolutions(demand.surge_n);
        allocate(devices, demand.sway_n, demand.yaw_nm, forces_n);
    } else {
        let engine_n = share_with_azimuths(vessel, shares, steered, &demand, devices, forces_n);
        vessel.orders.shaft = abilities.revolutions(engine_n);
    }
    let own = setup.thrusters.len();
    for (index, thruster) in setup.thrusters.iter().enumerate() {
        vessel.orders.thrusters[index] = forces_n[index] / thruster.tunnel.bollard_n;
    }
    helpers_n.extend_from_slice(&forces_n[own..]);
}

/// Keeps the course and the speed with rudder and engine.
fn under_way(vessel: &mut VesselState, state: &BodyState, step_s: f64) {
    let surge_mps = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps).x;
    if let Some(course) = &vessel.pilots.course {
        vessel.orders.rudder_rad =
            course.rudder_rad(state.heading_rad, state.yaw_rate_radps, surge_mps);
    }
    if let Some(speed) = &mut vessel.pilots.speed {
        vessel.orders.shaft = speed.revolutions(surge_mps, step_s);
    }
}
