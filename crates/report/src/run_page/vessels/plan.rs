//! The report's section on passage plans: a table of the legs, and the way along the plan.

use fenderline_sim::VesselSetup;
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::exercise::Assessment;
use fenderline_sim::track::PassagePlan;
use maud::{Markup, html};

use crate::plot::{Axis, Chart, Point, Reference, Series, fixed, waypoint_name};
use crate::run_page::recorder::{LegTrace, PlanTrace, Recorder};
use crate::run_page::scene::under_keel_limit_m;
use crate::{Head, table_head};
use fenderline_results::Outcome;

/// The sections of the vessels that have a passage plan.
pub(super) fn section(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let vessels = outcome.setup.world.vessels.iter().zip(&recorder.world.vessels);
    let planned = vessels.filter_map(|(vessel, trace)| {
        let name = outcome.setup.bodies[vessel.body].name.as_str();
        Some((vessel, name, vessel.plan.as_ref()?, trace.plan.as_ref()?))
    });
    html! {
        @for (vessel, name, plan, trace) in planned {
            h3 { "Passage plan " (plan.name) ", " (name) }
            (legs(plan, trace))
            (cross_track(name, plan, trace))
            (under_keel(outcome, vessel, name, plan, trace))
            (speed(name, plan, trace))
        }
    }
}

/// The table of the legs: what was planned, and what happened.
fn legs(plan: &PassagePlan, trace: &PlanTrace) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Leg to"),
                    Head::Number("Course", "deg"),
                    Head::Number("Length", "m"),
                    Head::Number("Turn at its end", "radius m"),
                    Head::Number("Planned speed", "kn"),
                    Head::Number("Speed over ground", "kn, from to"),
                    Head::Number("Corridor", "half width m"),
                    Head::Number("Largest cross-track distance", "m"),
                    Head::Number("Time on the leg", "min"),
                ]))
                tbody {
                    @for (index, (leg, own)) in plan.legs().zip(&trace.legs).enumerate() {
                        @let to = &plan.waypoints()[index + 1];
                        @let is_last = index + 2 == plan.waypoints().len();
                        tr {
                            td { (waypoint_name(plan, index + 1)) }
                            td class="number" { (course(leg.course_rad)) }
                            td class="number" { (fixed(leg.length_m, 0)) }
                            td class="number" {
                                @if is_last { "–" } @else { (fixed(to.turning_radius_m, 0)) }
                            }
                            td class="number" { (known(to.speed_mps, 1.0 / KNOT_MPS, 1)) }
                            td class="number" { (speeds(own)) }
                            td class="number" { (known(to.half_width_m, 1.0, 0)) }
                            td class="number" { (off(own, to.half_width_m)) }
                            td class="number" {
                                (own.times_s.map_or_else(|| "–".to_owned(), |[from, to]| fixed((to - from) / 60.0, 1)))
                            }
                        }
                    }
                }
            }
        }
        p class="note" {
            "The cross-track distance is that of midship from the planned track, which goes round each waypoint on an \
             arc. The wheel-over points lie " (fixed(plan.reach_m(), 0)) " m before the arcs."
        }
    }
}

fn known(value: Option<f64>, factor: f64, decimals: usize) -> String {
    value.map_or_else(|| "–".to_owned(), |value| fixed(value * factor, decimals))
}

/// A course in degrees from 0 to 360.
fn course(course_rad: f64) -> String {
    let degrees = course_rad.to_degrees();
    fixed(if degrees < 0.0 { degrees + 360.0 } else { degrees }, 1)
}

fn speeds(leg: &LegTrace) -> String {
    if leg.times_s.is_none() {
        return "–".to_owned();
    }
    let [low, high] = leg.speeds_mps.map(|speed_mps| fixed(speed_mps / KNOT_MPS, 1));
    format!("{low} to {high}")
}

/// The largest cross-track distance of a leg with its side, and whether it is outside the corridor.
fn off(leg: &LegTrace, half_width_m: Option<f64>) -> String {
    if leg.times_s.is_none() {
        return "–".to_owned();
    }
    let side = if leg.cross_track_m < 0.0 { "port" } else { "starboard" };
    let outside = half_width_m.is_some_and(|half_m| leg.cross_track_m.abs() > half_m);
    let outside = if outside { ", outside" } else { "" };
    format!("{} to {side}{outside}", fixed(leg.cross_track_m.abs(), 0))
}

/// A chart along the planned track, in kilometres from the first waypoint.
fn along(title: String, plan: &PassagePlan, y: Axis, series: Vec<Series>) -> Chart {
    let in_km = |p: &Point| Point { x: p.x / 1e3, y: p.y };
    Chart {
        title,
        x: Axis::new("distance along the plan", "km")
            .including(0.0)
            .including(plan.length_m() / 1e3),
        y,
        series: series.into_iter().map(|line| line.mapped(in_km)).collect(),
        references: Vec::new(),
        linked: None,
        note: String::new(),
    }
}

/// A line of steps: a value for each leg from one waypoint to the next, where the leg has one.
fn by_leg(name: &str, plan: &PassagePlan, of: impl Fn(usize) -> Option<f64>) -> Option<Series> {
    let points = (0..plan.legs().len()).filter_map(|leg| {
        let value = of(leg)?;
        Some([leg, leg + 1].map(|way| Point { x: plan.passed_m(way), y: value }))
    });
    let points: Vec<Point> = points.flatten().collect();
    (!points.is_empty()).then(|| Series::line(name, points))
}

fn cross_track(name: &str, plan: &PassagePlan, trace: &PlanTrace) -> Markup {
    let half = |leg: usize| plan.waypoints()[leg + 1].half_width_m;
    let edges = [
        by_leg("corridor, to starboard", plan, half),
        by_leg("corridor, to port", plan, |leg| half(leg).map(|half_m| -half_m)),
    ];
    let mut series = vec![Series::line("cross-track distance", trace.cross_track_m.points())];
    series.extend(edges.into_iter().flatten().map(|edge| edge.styled(2)));
    let title = format!("Cross-track distance along the plan, positive to starboard, {name}");
    let mut chart = along(title, plan, Axis::new("distance", "m").including(0.0), series);
    chart.note = waypoints_note(plan);
    html! { (chart.render()) }
}

/// The clearances under the keel along the plan, with the limit of the exercise, or with that of the cautions if the
/// exercise has no such limit. Empty in deep water.
fn under_keel(
    outcome: &Outcome<'_>,
    vessel: &VesselSetup,
    name: &str,
    plan: &PassagePlan,
    trace: &PlanTrace,
) -> Markup {
    let [fore, aft] = &trace.under_keel_m;
    let series = vec![
        Series::line("forward half", fore.points()),
        Series::line("after half", aft.points()).styled(1),
    ];
    if fore.points().is_empty() {
        return html! {};
    }
    let title = format!("Least clearance under the keel along the plan, squat included, {name}");
    let axis = Axis::new("clearance", "m").including(0.0);
    let mut chart = along(title, plan, axis, series);
    let exercise = outcome.exercise.map(Assessment::setup);
    let own = exercise.filter(|of| outcome.setup.world.vessels[of.vessel].body == vessel.body);
    let (label, value) = match own.and_then(under_keel_limit_m) {
        Some(bound_m) => ("limit of the exercise", bound_m),
        None => ("a tenth of her draught", vessel.under_keel_caution_m()),
    };
    chart.references = vec![Reference { label: label.to_owned(), value }];
    chart.note = format!(
        "The clearance is the least of the stations under each half, midship included, without trim and waves. {}",
        waypoints_note(plan)
    );
    html! { (chart.render()) }
}

fn speed(name: &str, plan: &PassagePlan, trace: &PlanTrace) -> Markup {
    let mut series = vec![Series::line("over ground", trace.speed_mps.points())];
    series.extend(by_leg("planned", plan, |leg| plan.waypoints()[leg + 1].speed_mps));
    let series = series.into_iter().map(|line| line.scaled(1.0 / KNOT_MPS)).collect();
    let title = format!("Speed along the plan, {name}");
    html! { (along(title, plan, Axis::new("speed", "kn").including(0.0), series).render()) }
}

/// Where the waypoints are on the axis of a chart.
fn waypoints_note(plan: &PassagePlan) -> String {
    let places = (0..plan.waypoints().len()).map(|index| {
        format!("{} at {} km", waypoint_name(plan, index), fixed(plan.passed_m(index) / 1e3, 2))
    });
    format!("{}.", places.collect::<Vec<_>>().join(", "))
}
