//! Collects the values of a tick for strip charts.

use fenderline_contact::Rotation;
use fenderline_contact::number::greater;

use super::alarms::{Input, on_plan};
use crate::cast::Cast;
use crate::frozen::Frozen;
use crate::past::{Sample, ShipSample};

/// The strip-chart values of every ship that can be conned, and of the loads. Without a vessel, the values are those of
/// the first floating body. `frozen` has one entry for each vessel: the values at which her instruments are frozen.
pub(super) fn sample(of: &Input<'_>, cast: &Cast, frozen: &[Frozen]) -> Sample {
    let ships = cast.ships();
    let floats = || of.info.bodies.iter().position(|body| !body.fixed);
    let fenders = |share: fn(&crate::message::FenderNow) -> f64| {
        of.fenders.iter().map(share).fold(0.0, greater)
    };
    let lines = of.lines.iter().zip(&of.info.lines);
    Sample {
        t_s: of.simulation.time_s(),
        shown: ships
            .iter()
            .enumerate()
            .filter(|(_, ship)| frozen[**ship].any())
            .map(|(place, &ship)| (place, ship_sample(of, ship, &frozen[ship])))
            .collect(),
        ships: match ships.is_empty() {
            true => vec![body_sample(of, floats())],
            false => {
                let truth = Frozen::default();
                ships.into_iter().map(|ship| ship_sample(of, ship, &truth)).collect()
            }
        },
        of_energy: fenders(|fender| fender.of_energy),
        of_reaction: fenders(|fender| fender.of_reaction),
        of_working: lines
            .map(|(line, info)| line.tension_n / greater(info.working_n, 1.0))
            .fold(0.0, greater),
        contact_n: of
            .contacts
            .iter()
            .map(|contact| libm::hypot(contact.force_n[0], contact.force_n[1]))
            .sum(),
    }
}

/// The strip-chart values that a ship's instruments show; frozen instruments show the values in `frozen`. The docking
/// board belongs to the berth, so that its values are never frozen.
fn ship_sample(of: &Input<'_>, ship: usize, frozen: &Frozen) -> ShipSample {
    let (now, berth) = (&of.vessels[ship], of.vessels[ship].berth.as_ref());
    let (bow_mps, stern_mps, ahead_mps) = match frozen.speeds() {
        Some(shown) => (shown.bow_mps, shown.stern_mps, shown.ground_mps[0]),
        None => (now.bow_mps, now.stern_mps, now.ground_mps[0]),
    };
    let body = of.simulation.setup().world.vessels[ship].body;
    ShipSample {
        bow_mps: Some(berth.map_or(bow_mps, |berth| berth.bow_mps)),
        stern_mps: Some(berth.map_or(stern_mps, |berth| berth.stern_mps)),
        ahead_mps,
        turn_radps: frozen.turn_radps(of.simulation.states()[body].yaw_rate_radps),
        bow_m: berth.map(|berth| berth.bow_m),
        stern_m: berth.map(|berth| berth.stern_m),
        // After the last waypoint the plan is over.
        cross_track_m: on_plan(of, ship, frozen)
            .filter(|on| on.to_waypoint_m >= 0.0)
            .map(|on| on.cross_track_m),
        under_keel_m: now.under_keel_m,
    }
}

/// The strip-chart values of a body that is not a vessel.
fn body_sample(of: &Input<'_>, body: Option<usize>) -> ShipSample {
    let state = body.map(|body| &of.simulation.states()[body]);
    let ahead_mps = state.map_or(0.0, |state| {
        Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps).x
    });
    let turn_radps = state.map_or(0.0, |state| state.yaw_rate_radps);
    ShipSample {
        bow_mps: None,
        stern_mps: None,
        ahead_mps,
        turn_radps,
        bow_m: None,
        stern_m: None,
        cross_track_m: None,
        under_keel_m: None,
    }
}
