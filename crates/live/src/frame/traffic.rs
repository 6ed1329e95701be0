//! Traffic: ships that pass on tracks of their own. They touch nothing; a vessel that runs into one raises an alarm.

use fenderline_contact::{BodyState, Pose, Vec2, vec2};
use fenderline_sim::Simulation;

use crate::alarm_book::{Alarm, Level};
use crate::info::Info;
use crate::message::Pair;

/// Position, heading, velocity and rate of turn of each passing ship now, as those of bodies.
pub(super) fn now(simulation: &Simulation) -> Vec<[f64; 6]> {
    let passing = &simulation.setup().world.flow.passing;
    let at = passing.iter().map(|ship| ship.track.at(simulation.time_s()));
    at.map(|now| {
        let (position, velocity) = (now.pose.position_m, now.velocity_mps);
        [position.x, position.y, now.heading_rad, velocity.x, velocity.y, now.yaw_rate_radps]
    })
    .collect()
}

/// An alarm for each vessel whose outline lies over that of a passing ship.
pub(super) fn collisions(simulation: &Simulation, info: &Info) -> Vec<Alarm> {
    let mut all = Vec::new();
    for (ship, of) in info.traffic.iter().zip(&simulation.setup().world.flow.passing) {
        let there = on_earth(&ship.outline, &of.track.at(simulation.time_s()).pose);
        for vessel in &info.vessels {
            let state: &BodyState = &simulation.states()[vessel.body];
            let here = on_earth(&info.bodies[vessel.body].outline, &state.pose());
            if overlap(&here, &there) {
                all.push(Alarm {
                    level: Level::Alarm,
                    key: format!("collision {} {}", vessel.name, ship.name),
                    text: format!("{} collides with {}", vessel.name, ship.name),
                    about: vec![vessel.name.clone(), ship.name.clone()],
                });
            }
        }
    }
    all
}

fn on_earth(outline: &[Pair], pose: &Pose) -> Vec<Vec2> {
    outline.iter().map(|at| pose.apply(vec2(at[0], at[1]))).collect()
}

/// True if two simple polygons share a point: their edges cross, or one lies in the other.
fn overlap(one: &[Vec2], other: &[Vec2]) -> bool {
    let (Some(first), Some(of_other)) = (one.first(), other.first()) else { return false };
    let crosses = edges(one).any(|a| edges(other).any(|b| cross(a, b)));
    crosses || contains(other, *first) || contains(one, *of_other)
}

fn edges(of: &[Vec2]) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
    (0..of.len()).map(|index| (of[index], of[(index + 1) % of.len()]))
}

/// True if two segments cross.
fn cross((a, b): (Vec2, Vec2), (c, d): (Vec2, Vec2)) -> bool {
    let side = |from: Vec2, to: Vec2, at: Vec2| (to - from).cross(at - from);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// True if a point is in a simple polygon: a ray from it crosses the outline an odd number of times.
fn contains(outline: &[Vec2], at: Vec2) -> bool {
    let crossings = edges(outline).filter(|(from, to)| {
        (from.y > at.y) != (to.y > at.y)
            && at.x < (to.x - from.x) * (at.y - from.y) / (to.y - from.y) + from.x
    });
    crossings.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(north_m: f64, east_m: f64, half_m: f64) -> Vec<Vec2> {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| vec2(north_m + half_m * x, east_m + half_m * y))
            .to_vec()
    }

    #[test]
    fn outlines_overlap_if_they_cross_or_one_lies_in_the_other() {
        let here = square(0.0, 0.0, 10.0);
        for (there, expected) in [
            (square(15.0, 3.0, 10.0), true),
            (square(21.0, 0.0, 10.0), false),
            (square(1.0, 2.0, 3.0), true),
            (square(1.0, 2.0, 50.0), true),
            (square(30.0, 30.0, 5.0), false),
        ] {
            assert_eq!(overlap(&here, &there), expected, "{there:?}");
            assert_eq!(overlap(&there, &here), expected, "{there:?}");
        }
    }
}
