//! Writes the places and speeds of the bodies into the scenario file.

use fenderline_author::Edit;
use fenderline_contact::Rotation;
use fenderline_sim::Simulation;

use super::written::{degrees, place, rounded};

/// Writes the position, speed and shaft revolutions of every floating body.
pub(super) fn edit(simulation: &Simulation, edits: &mut Vec<Edit>) {
    let setup = simulation.setup();
    for (index, (body, state)) in setup.bodies.iter().zip(simulation.states()).enumerate() {
        if body.is_fixed() || body.dolphin.is_some() {
            continue;
        }
        let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
        let velocity = format!(
            "{{ surge = {}, sway = {}, yaw = {} }}",
            rounded(own.x, 6),
            rounded(own.y, 6),
            rounded(state.yaw_rate_radps, 9)
        );
        let of = |key| ["body", body.name.as_str(), key];
        edits.push(Edit::remove(&of("approach")));
        edits.push(Edit::set(&of("position"), place(state.position_m)));
        edits.push(Edit::set(&of("heading"), degrees(state.heading_rad)));
        edits.push(Edit::set(&of("velocity"), velocity));
        let vessel = setup.world.vessels.iter().position(|vessel| vessel.body == index);
        let has_propeller = |vessel: &usize| setup.world.vessels[*vessel].ship.propulsion.is_some();
        if let Some(vessel) = vessel.filter(has_propeller) {
            let shaft = &simulation.vessels()[vessel].shaft;
            edits.push(Edit::set(&of("running"), rounded(shaft.value / shaft.stop, 6).to_string()));
        }
    }
}
