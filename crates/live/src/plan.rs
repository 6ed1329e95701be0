//! Passage plans in the form in which pages get them.

use fenderline_contact::Vec2;
use fenderline_sim::track::{OnPlan, PassagePlan};

use crate::message::{Pair, PlanInfo, PlanNow, WaypointInfo, WheelOverInfo};

/// A plan, for the greeting.
pub(crate) fn info(plan: &PassagePlan) -> PlanInfo {
    let waypoints = plan.waypoints().iter().map(|way| WaypointInfo {
        name: way.name.clone(),
        at_m: place(way.at_m),
        speed_mps: way.speed_mps,
    });
    let wheel_overs = plan.wheel_overs().map(|wheel| WheelOverInfo {
        waypoint: wheel.waypoint,
        at_m: place(wheel.at_m),
        course_rad: wheel.course_rad,
    });
    let edges = plan.corridor_m().into_iter();
    PlanInfo {
        name: plan.name.clone(),
        waypoints: waypoints.collect(),
        wheel_overs: wheel_overs.collect(),
        track: places(&plan.path().points_m(0.0, plan.length_m())),
        corridor: edges.map(|edges| edges.map(|edge| places(&edge))).collect(),
    }
}

/// Where a ship is on her plan, for a frame.
pub(crate) fn now(on: &OnPlan) -> PlanNow {
    PlanNow {
        leg: on.leg,
        cross_track_m: on.cross_track_m,
        to_waypoint_m: on.to_waypoint_m,
        to_wheel_over_m: on.to_wheel_over_m,
        course_rad: on.course_rad,
        speed_mps: on.speed_mps,
        half_width_m: on.half_width_m,
    }
}

fn places(line: &[Vec2]) -> Vec<Pair> {
    line.iter().copied().map(place).collect()
}

/// A place to a centimetre, which is enough for drawing.
fn place(at_m: Vec2) -> Pair {
    [at_m.x, at_m.y].map(|coordinate| libm::round(coordinate * 100.0) / 100.0)
}
