//! The values of a tick for strip charts.

use fenderline_contact::Rotation;
use fenderline_contact::number::greater;

use super::alarms::Input;
use crate::cast::Cast;
use crate::past::Sample;

/// The values of the pilot's ship, or, without a vessel, of the first body that floats.
pub(super) fn sample(of: &Input<'_>, cast: &Cast) -> Sample {
    let simulation = of.simulation;
    let (setup, states) = (simulation.setup(), simulation.states());
    let vessel = cast.own.map(|own| &of.vessels[own]);
    let body = match cast.own {
        Some(own) => Some(setup.world.vessels[own].body),
        None => of.info.bodies.iter().position(|body| !body.fixed),
    };
    let state = body.map(|body| &states[body]);
    let ahead_mps = match (vessel, state) {
        (Some(vessel), _) => vessel.ground_mps[0],
        (None, Some(state)) => {
            Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps).x
        }
        (None, None) => 0.0,
    };
    let berth = vessel.and_then(|vessel| vessel.berth.as_ref());
    let fenders = |share: fn(&crate::message::FenderNow) -> f64| {
        of.fenders.iter().map(share).fold(0.0, greater)
    };
    let lines = of.lines.iter().zip(&of.info.lines);
    Sample {
        t_s: simulation.time_s(),
        bow_mps: berth.map(|berth| berth.bow_mps).or(vessel.map(|vessel| vessel.bow_mps)),
        stern_mps: berth.map(|berth| berth.stern_mps).or(vessel.map(|vessel| vessel.stern_mps)),
        ahead_mps,
        turn_radps: state.map_or(0.0, |state| state.yaw_rate_radps),
        bow_m: berth.map(|berth| berth.bow_m),
        stern_m: berth.map(|berth| berth.stern_m),
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
