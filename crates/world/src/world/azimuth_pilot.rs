//! Pilots that use azimuth units: under way, to keep a station, and to assist a ship.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Rotation, Vec2, vec2};

use super::abilities::Abilities;
use super::azimuth::{AzimuthOrder, AzimuthSetup};
use super::line::MooringLines;
use super::vessel::{VesselForces, VesselSetup, VesselState};
use fenderline_ship::control::{
    AssistDemand, Demand, Handling, LateralDevice, Reach, Sway, Task, ThrustDevice, ThrustShares,
    UnitUse, assist as work,
};
use fenderline_ship::hydro::{Force, Velocity, Water};

/// Time constant of the integral part of the yaw control, which balances the moment of the contact at a tug's bow (s).
const INTEGRAL_S: f64 = 15.0;
/// A unit that gets less than this share of its greatest thrust keeps its direction.
const IDLE: f64 = 0.01;

/// The velocity of a vessel through the water, and the properties of the water.
pub(super) struct Stream {
    pub(super) velocity: Velocity,
    pub(super) water: Water,
}

/// A vessel that a pilot steers, her abilities, and her velocity through the water.
#[derive(Clone, Copy)]
pub(super) struct Steered<'a> {
    pub(super) setup: &'a VesselSetup,
    pub(super) abilities: &'a Abilities,
    pub(super) stream: &'a Stream,
}

/// The greatest force of all units together on each axis.
pub(super) fn largest_of_azimuths(setup: &VesselSetup) -> Demand {
    let mut largest = Demand::default();
    for azimuth in &setup.azimuths {
        largest.surge_n += azimuth.bollard_n;
        largest.sway_n += azimuth.bollard_n;
        largest.yaw_nm += azimuth.bollard_n * azimuth_place(setup, azimuth).length();
    }
    largest
}

/// Force of hull, wind and waves in the last step, about the centre of gravity.
fn disturbance(setup: &VesselSetup, forces: &VesselForces) -> Demand {
    let Force { surge_n, sway_n, yaw_nm } = forces.disturbance();
    let ahead_m = setup.ship.particulars.centre_of_gravity_m;
    Demand { surge_n, sway_n, yaw_nm: yaw_nm - ahead_m * sway_n }
}

/// Keeps course and speed of a vessel that azimuth units alone propel and steer. The function uses the buffer `shares`
/// again in each step.
pub(super) fn under_way(
    vessel: &mut VesselState,
    shares: &mut ThrustShares,
    Steered { setup, abilities, stream }: Steered<'_>,
    forces: &VesselForces,
    state: &BodyState,
    step_s: f64,
) {
    let VesselState { pilots, .. } = vessel;
    if !setup.steers_with_azimuths() || (pilots.course.is_none() && pilots.speed.is_none()) {
        return;
    }
    let surge_mps = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps).x;
    let surge_n = match &mut pilots.speed {
        // Thrust is proportional to the square of the revolutions.
        Some(speed) => {
            let share = speed.revolutions(surge_mps, step_s);
            share * share.abs() * largest_of_azimuths(setup).surge_n
        }
        None => pilots.ahead_n,
    };
    let handling = Handling::of(abilities.inertia, setup.ship.particulars.length_m);
    let yaw_nm = pilots.course.map_or(0.0, |course| {
        let disturbance = disturbance(setup, forces);
        handling.turning_moment(state, course.heading_rad, disturbance.yaw_nm)
    });
    let demand = Demand { surge_n, sway_n: 0.0, yaw_nm };
    azimuths_alone(setup, &mut shares.devices);
    shares.meet(&demand, Sway::Free);
    order_azimuths(vessel, setup, &shares.forces_n, IDLE, stream);
}

/// Sets the orders to the azimuth units of a tug that assists. The function uses the buffer `shares` again in each
/// step.
pub(super) fn assist(
    vessel: &mut VesselState,
    shares: &mut ThrustShares,
    Steered { setup, abilities, stream }: Steered<'_>,
    forces: &VesselForces,
    states: &[BodyState],
    lines: MooringLines<'_>,
    step_s: f64,
) {
    let Some(pilot) = &mut vessel.pilots.assist else { return };
    let ship = &setup.ship.particulars;
    let state = &states[setup.body];
    let disturbance = disturbance(setup, forces);
    let handling = Handling::of(abilities.inertia, ship.length_m);
    let task = pilot.task(setup.body, states, lines);
    let AssistDemand { demand, sway, units } =
        work(&task, &handling, state, &disturbance, pilot.order.fastest_mps, pilot.steady_nm);
    // The integral grows while the tug's bow is held at the ship's side, and decays otherwise.
    let is_held = matches!(task, Task::Push { .. }) && sway == Sway::Free;
    let most_nm: f64 =
        setup.azimuths.iter().map(|a| a.bollard_n * azimuth_place(setup, a).length()).sum();
    let growth = demand.yaw_nm - pilot.steady_nm;
    let rate = if is_held { growth } else { -pilot.steady_nm };
    let steady_nm =
        bounded(pilot.steady_nm + rate * lesser(step_s / INTEGRAL_S, 1.0), -most_nm, most_nm);
    pilot.steady_nm = steady_nm;
    azimuths_alone(setup, &mut shares.devices);
    let own = setup.thrusters.iter().map(|thruster| ThrustDevice {
        at_m: vec2(thruster.tunnel.along_m - ship.centre_of_gravity_m, 0.0),
        reach: Reach::Across([-thruster.tunnel.bollard_n, thruster.tunnel.bollard_n]),
    });
    shares.devices.extend(own);
    shares.meet(&demand, sway);
    if sway == Sway::Held || units == UnitUse::Braking {
        shares.bias_pairs();
    }
    // A unit that steers keeps no old direction, which would be a rudder angle.
    let idle = if units == UnitUse::Steering { 0.0 } else { IDLE };
    let (units_n, thrusters_n) = shares.forces_n.split_at(setup.azimuths.len());
    order_azimuths(vessel, setup, units_n, idle, stream);
    for (index, (thruster, force_n)) in setup.thrusters.iter().zip(thrusters_n).enumerate() {
        vessel.orders.thrusters[index] = force_n.y / thruster.tunnel.bollard_n;
    }
}

/// Divides a demand among the engine, lateral devices and azimuth units. Returns the force of the engine (N). The
/// function uses the buffer `shares` again in each step.
pub(super) fn share_with_azimuths(
    vessel: &mut VesselState,
    shares: &mut ThrustShares,
    Steered { setup, abilities, stream }: Steered<'_>,
    demand: &Demand,
    across: &[LateralDevice],
    across_n: &mut [f64],
) -> f64 {
    azimuths_alone(setup, &mut shares.devices);
    shares.devices.extend(across.iter().map(|device| ThrustDevice {
        at_m: vec2(device.forward_m, 0.0),
        reach: Reach::Across(device.limits_n),
    }));
    if setup.ship.propulsion.is_some() {
        let reach = Reach::Ahead(abilities.bollard_n);
        shares.devices.push(ThrustDevice { at_m: Vec2::ZERO, reach });
    }
    shares.meet(demand, Sway::Held);
    shares.bias_pairs();
    let (own, forces_n) = (setup.azimuths.len(), &shares.forces_n);
    order_azimuths(vessel, setup, &forces_n[..own], IDLE, stream);
    for (given_n, force_n) in across_n.iter_mut().zip(&forces_n[own..]) {
        *given_n = force_n.y;
    }
    forces_n.get(own + across.len()).map_or(0.0, |force_n| force_n.x)
}

/// Replaces the devices in the list by the azimuth units.
fn azimuths_alone(setup: &VesselSetup, devices: &mut Vec<ThrustDevice>) {
    let device = |azimuth| ThrustDevice {
        at_m: azimuth_place(setup, azimuth),
        reach: Reach::Round(azimuth.bollard_n),
    };
    devices.clear();
    devices.extend(setup.azimuths.iter().map(device));
}

/// Position of a unit, measured from the centre of gravity (m).
fn azimuth_place(setup: &VesselSetup, azimuth: &AzimuthSetup) -> Vec2 {
    let ahead_m = setup.ship.particulars.centre_of_gravity_m;
    vec2(azimuth.unit.along_m - ahead_m, azimuth.unit.across_m)
}

/// Orders a force of each unit, and the power that the unit needs for this force at this velocity through the water.
/// While a unit still turns, the order gives it the power for the component of the force in the unit's present
/// direction. A unit that gets less than the share `idle` of its greatest thrust keeps its direction.
fn order_azimuths(
    vessel: &mut VesselState,
    setup: &VesselSetup,
    forces_n: &[Vec2],
    idle: f64,
    stream: &Stream,
) {
    let VesselState { orders, azimuths, .. } = vessel;
    for (index, (azimuth, force_n)) in setup.azimuths.iter().zip(forces_n).enumerate() {
        let before = orders.azimuths[index];
        let is_idle = force_n.length() < idle * azimuth.bollard_n;
        let direction_rad =
            if is_idle { before.direction_rad } else { libm::atan2(force_n.y, force_n.x) };
        let now_rad = azimuths[index].direction.angle_rad;
        let (sin, cos) = libm::sincos(now_rad);
        let useful_n = greater(force_n.dot(vec2(cos, sin)), 0.0);
        let Stream { velocity, water } = *stream;
        let full_rps = azimuth.unit.revolutions_for(azimuth.bollard_n, water);
        let rps = azimuth.unit.revolutions_at(useful_n, now_rad, &velocity, water, full_rps);
        let power = (rps / full_rps) * (rps / full_rps);
        orders.azimuths[index] = AzimuthOrder { power, direction_rad };
    }
}
