//! Passage plans in a plan view: track, corridor, waypoints and wheel-over points.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::track::PassagePlan;
use maud::{Markup, html};

use super::map::{Frame, Label, Map, Place};

/// Colour of a passage plan.
const COLOUR: &str = "#b03a06";
/// Half of the length of the stroke at a wheel-over point (px).
const WHEEL: f64 = 9.0;

/// A passage plan in a plan view.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedDrawn {
    /// The planned track (m).
    pub track_m: Vec<Vec2>,
    /// Edges of the corridor (m).
    pub edges_m: Vec<Vec<Vec2>>,
    /// Places of the waypoints (m), with their names.
    pub waypoints: Vec<(Vec2, String)>,
    /// Wheel-over points (m), with the course of the track there (rad).
    pub wheel_overs: Vec<(Vec2, f64)>,
}

impl PlannedDrawn {
    /// What is drawn of a plan.
    pub fn of(plan: &PassagePlan) -> PlannedDrawn {
        let waypoints = plan.waypoints().iter().enumerate();
        PlannedDrawn {
            track_m: plan.path().points_m(0.0, plan.length_m()),
            edges_m: plan.corridor_m().into_iter().flatten().collect(),
            waypoints: waypoints
                .map(|(index, way)| (way.at_m, waypoint_name(plan, index)))
                .collect(),
            wheel_overs: plan.wheel_overs().map(|wheel| (wheel.at_m, wheel.course_rad)).collect(),
        }
    }

    /// The names of the waypoints.
    pub fn labels(&self) -> impl Iterator<Item = Label> {
        self.waypoints.iter().map(|(at_m, name)| Label {
            text: name.clone(),
            place: Place::Beside { point_m: *at_m, side: vec2(0.0, 1.0) },
        })
    }

    /// The frame around the waypoints.
    pub fn frame(&self) -> Option<Frame> {
        Frame::around(self.waypoints.iter().map(|(at_m, _)| *at_m))
    }
}

/// The name of a waypoint, or its number if it has no name.
pub fn waypoint_name(plan: &PassagePlan, index: usize) -> String {
    match plan.waypoints()[index].name.as_str() {
        "" => format!("waypoint {}", index + 1),
        name => name.to_owned(),
    }
}

pub(super) fn planned(plan: &PlannedDrawn, map: &Map) -> Markup {
    html! {
        @for edge in &plan.edges_m {
            path d=(map.path(edge)) fill="none" stroke=(COLOUR) stroke-width="0.8" stroke-dasharray="3 3"
                stroke-opacity="0.8" {}
        }
        path d=(map.path(&plan.track_m)) fill="none" stroke=(COLOUR) stroke-width="1.4" {}
        @for (at_m, _) in &plan.waypoints {
            @let (x, y) = map.px(*at_m);
            circle cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r="4" fill="#fff" stroke=(COLOUR)
                stroke-width="1.6" {}
        }
        @for (at_m, course_rad) in &plan.wheel_overs {
            @let (x, y) = map.px(*at_m);
            // Square to the track; north is up.
            @let (dx, dy) = (libm::cos(*course_rad) * WHEEL, libm::sin(*course_rad) * WHEEL);
            path d=(format!("M{:.1},{:.1}L{:.1},{:.1}", x - dx, y - dy, x + dx, y + dy)) fill="none"
                stroke=(COLOUR) stroke-width="2" {}
        }
    }
}

/// The legend for passage plans.
pub fn planned_legend() -> Markup {
    html! {
        ul class="legend" {
            li {
                svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                    path d="M1,6H29" fill="none" stroke=(COLOUR) stroke-width="1.4" {}
                    circle cx="22" cy="6" r="4" fill="#fff" stroke=(COLOUR) stroke-width="1.6" {}
                    path d="M8,1V11" fill="none" stroke=(COLOUR) stroke-width="2" {}
                }
                "passage plan: track, waypoint (ring) and wheel-over point (stroke)"
            }
            li {
                svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                    path d="M1,6H29" fill="none" stroke=(COLOUR) stroke-width="0.8" stroke-dasharray="3 3" {}
                }
                "corridor of the plan"
            }
        }
    }
}
