//! What a tug that assists a ship must do in each step: its task for the pilot.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_ship::control::Task;

use super::assist::{AssistPilot, Job, PushJob};
use super::line::{MooringLines, MooringSetup};
use super::line_end::LineEnd;

impl AssistPilot {
    /// What the pilot of the tug must do in a step: follow a place, push or pull, with the present positions and
    /// velocities.
    pub fn task(&self, own: usize, states: &[BodyState], lines: MooringLines<'_>) -> Task {
        let velocity_at = |body: usize, at_m: Vec2| {
            let state = &states[body];
            let arm_m = state.pose().rotation.apply(at_m);
            state.velocity_mps + arm_m.spun_by(state.yaw_rate_radps)
        };
        match self.order.job {
            Job::Follow { ship, at_m, heading_rad } => Task::Follow {
                place_m: states[ship].pose().apply(at_m),
                velocity_mps: velocity_at(ship, at_m),
                heading_rad: states[ship].heading_rad + heading_rad,
            },
            Job::Push(PushJob { ship, at_m, inward, bow_m, force_n }) => Task::Push {
                place_m: states[ship].pose().apply(at_m),
                velocity_mps: velocity_at(ship, at_m),
                inward: states[ship].pose().rotation.apply(inward),
                bow_m,
                force_n,
                contact_n: self.contact_n,
            },
            Job::Pull { line, direction_rad, force_n } => {
                let setup = &lines.setups[line];
                let [(ship, at_m), (_, own_at_m)] = ends_for(setup, own);
                let direction = vec2(libm::cos(direction_rad), libm::sin(direction_rad));
                let place_m = states[ship].pose().apply(at_m);
                let span_m = (states[own].pose().apply(own_at_m) - place_m).length();
                let length_m =
                    lines.now[line].line.as_ref().map_or(0.0, |(_, state)| state.length_m);
                Task::Pull {
                    place_m,
                    velocity_mps: velocity_at(ship, at_m),
                    outward: states[ship].pose().rotation.apply(direction),
                    over_bow: own_at_m.x >= 0.0,
                    slack_m: greater(length_m - span_m, 0.0),
                    force_n,
                    tension_n: lines.now[line].load.tension_n,
                }
            }
        }
    }
}

/// The two ends of a line: first the end at the other body, then the end at the tug's own body. Each end has the index
/// of the body and the position in the frame of the body.
fn ends_for(line: &MooringSetup, own: usize) -> [(usize, Vec2); 2] {
    let near = (line.ship, line.fairlead_m);
    match line.end {
        Some(LineEnd::OnBody { body, at_m, .. }) if body == own => [near, (body, at_m)],
        Some(LineEnd::OnBody { body, at_m, .. }) => [(body, at_m), near],
        Some(LineEnd::Fixed(_)) | None => {
            unreachable!("the check of the set-up refuses an order with such a line")
        }
    }
}
