//! Mooring lines, tugs, wind, current and waves of a plan view, and the view of the moored ship.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::environment::Bank;
use fenderline_sim::environment::current::Current;
use fenderline_sim::exercise::{Assessment, ExerciseSetup, Measure};
use fenderline_sim::{Environment, LineEnd, Setup, VesselSetup};
use maud::{Markup, html};

use super::bodies::{NAME_LENGTH, body_label, joined, middle, outlined, styles};
use crate::plot::{
    DepthLimits, Frame, Harbour, Label, LineDrawn, PassingDrawn, Place, Plan, PlannedDrawn, Stage,
    TugDrawn, Weather, chart_labels, charted_in, fixed, plain, shortened, significant,
};
use crate::run_page::fenders::boxes;
use crate::run_page::recorder::{Recorder, TugMark, WindTrace, both};
use crate::run_page::vessels::compass;
use fenderline_results::Outcome;

/// The mooring lines that were made fast, with the bodies where they were at the largest contact force, or at the end
/// of a run without contact.
pub(super) fn lines_at_peak(outcome: &Outcome<'_>, recorder: &Recorder) -> Vec<LineDrawn> {
    let states = recorder.peak.as_ref().map_or(outcome.states, |peak| peak.states.as_slice());
    lines(outcome, states)
}

/// The mooring lines that were made fast, drawn with the bodies in the given states.
fn lines(outcome: &Outcome<'_>, states: &[BodyState]) -> Vec<LineDrawn> {
    let lines = outcome.setup.world.lines.iter().zip(&outcome.world.lines);
    let drawn = lines.filter(|(_, totals)| totals.is_fast || totals.parted_s.is_some());
    let drawn = drawn.filter_map(|(line, totals)| {
        let far_m = match totals.end? {
            LineEnd::Fixed([north_m, east_m, _]) => vec2(north_m, east_m),
            LineEnd::OnBody { body, at_m, .. } => states[body].pose().apply(at_m),
        };
        Some(LineDrawn {
            ends_m: [states[line.ship].pose().apply(line.fairlead_m), far_m],
            share: totals.share_of_break_load().unwrap_or(0.0),
            has_parted: totals.parted_s.is_some(),
        })
    });
    drawn.collect()
}

/// Chains of the anchors that are on the bottom at the end of the run, from hawse pipe to anchor (m), with their names.
pub(super) fn anchors<'o>(outcome: &'o Outcome<'_>) -> impl Iterator<Item = ([Vec2; 2], &'o str)> {
    let world = &outcome.setup.world;
    let all = world.anchors.iter().zip(&outcome.world.anchors);
    all.filter_map(|(anchor, totals)| {
        let body = world.vessels[anchor.vessel].body;
        let hawse_m = outcome.states[body].pose().apply(anchor.hawse_m);
        Some(([hawse_m, totals.place_m()?], anchor.gear.name.as_str()))
    })
}

/// Labels with the names of the anchors that are on the bottom at the end of the run; each stands beside its anchor.
pub(super) fn anchor_names(outcome: &Outcome<'_>) -> impl Iterator<Item = Label> {
    anchors(outcome).map(|([hawse_m, place_m], name)| {
        let east = if place_m.y < hawse_m.y { -1.0 } else { 1.0 };
        Label {
            place: Place::Beside { point_m: place_m, side: vec2(0.0, east) },
            text: format!("anchor {}", shortened(name, NAME_LENGTH)),
        }
    })
}

/// The tugs as a plan view draws them.
fn tugs(setup: &Setup, marks: &[TugMark]) -> Vec<TugDrawn> {
    let drawn = marks.iter().map(|mark| {
        let name = shortened(&setup.world.tugs[mark.tug].tug.name, NAME_LENGTH);
        let force_n = mark.force_n.length();
        // A tug with less than a kilonewton is standing by.
        let works = force_n >= 1e3;
        TugDrawn {
            at_m: mark.at_m,
            direction: if works { mark.force_n * (1.0 / force_n) } else { Vec2::ZERO },
            on_line: works && mark.on_line,
            label: match (works, mark.on_line) {
                (false, _) => format!("{name}: standing by"),
                (true, false) => format!("{name} pushes {} kN", significant(force_n / 1e3, 2)),
                (true, true) => format!("{name} pulls {} kN", significant(force_n / 1e3, 2)),
            },
        }
    });
    drawn.collect()
}

/// The clearance under the keel with which water counts as safe, if no exercise limits the clearance (m). The page of a
/// live session begins with the same clearance.
const USUAL_CLEARANCE_M: f64 = 1.5;

/// The under-keel clearance that an exercise asks for (m); `None` if the exercise has no such limit.
pub(in crate::run_page) fn under_keel_limit_m(exercise: &ExerciseSetup) -> Option<f64> {
    let limits = exercise.limits.iter().filter(|limit| limit.measure == Measure::UnderKeel);
    limits.map(|limit| limit.bound).reduce(greater)
}

/// Depths at which the shades of the chart change: for the ship of the exercise; without an exercise for the ship with
/// a passage plan, or else for the ship with the largest draught. `None` if there is no vessel.
pub(in crate::run_page) fn depth_limits(outcome: &Outcome<'_>) -> Option<DepthLimits> {
    let setup = outcome.setup;
    let exercise = outcome.exercise.map(Assessment::setup);
    let vessels = &setup.world.vessels;
    let draught_m = |vessel: &VesselSetup| vessel.ship.particulars.draught_m;
    let of_exercise = exercise.and_then(|of| vessels.get(of.vessel));
    let ship = of_exercise
        .or_else(|| vessels.iter().find(|vessel| vessel.plan.is_some()))
        .or_else(|| {
            // Of equal draughts the first counts.
            vessels.iter().reduce(
                |most, next| {
                    if draught_m(next) > draught_m(most) { next } else { most }
                },
            )
        })?;
    let clearance_m = exercise.and_then(under_keel_limit_m);
    Some(DepthLimits {
        ship: setup.bodies[ship.body].name.clone(),
        draught_m: draught_m(ship),
        clearance_m: clearance_m.unwrap_or(USUAL_CLEARANCE_M),
    })
}

/// The tugs at the moment of the peak force (or at the end of a run without contact), and the weather.
pub(super) fn around(outcome: &Outcome<'_>, recorder: &Recorder, frame: Frame) -> Harbour {
    let setup = outcome.setup;
    let marks = recorder.peak.as_ref().map_or(&recorder.last_tugs, |peak| &peak.tugs);
    Harbour {
        chart: charted_in(&setup.world.chart.features, frame),
        limits: depth_limits(outcome),
        lines: lines_at_peak(outcome, recorder),
        anchors: anchors(outcome).map(|(chain_m, _)| chain_m).collect(),
        tugs: tugs(setup, marks),
        banks: banks(&setup.world.environment),
        passing: passing(outcome),
        approached: Vec::new(),
        plans: plans(setup),
        weather: weather(&setup.world.environment, recorder, WindTrace::range),
    }
}

/// Passing ships where they were nearest, with their tracks of the run.
pub(super) fn passing(outcome: &Outcome<'_>) -> Vec<PassingDrawn> {
    let end_s = outcome.duration_s();
    let ships = outcome.setup.world.flow.passing.iter().zip(&outcome.world.passing);
    let drawn = ships.map(|(ship, totals)| {
        let track = &ship.track;
        let at_s = totals.nearest.map_or(0.0, |(_, nearest)| nearest.t_s);
        let pose = track.at(at_s).pose;
        let [from_m, to_m] = [0.0, end_s].map(|t_s| track.pace.distance_m(t_s));
        PassingDrawn {
            outline_m: ship.outline_m.iter().map(|point| pose.apply(*point)).collect(),
            track_m: track.path.points_m(from_m, to_m),
        }
    });
    drawn.collect()
}

/// Names of passing ships, which stand on the ships where they were nearest.
pub(super) fn passing_names(outcome: &Outcome<'_>) -> Vec<Label> {
    let ships = outcome.setup.world.flow.passing.iter().zip(&outcome.world.passing);
    let named = ships.map(|(ship, totals)| {
        let at_s = totals.nearest.map_or(0.0, |(_, nearest)| nearest.t_s);
        let now = ship.track.at(at_s);
        let text = format!(
            "{}, {} kn",
            shortened(&ship.name, NAME_LENGTH),
            fixed(now.speed_mps / KNOT_MPS, 1)
        );
        let half_length_m = now.pose.rotation.apply(vec2(0.5 * ship.hull.length_m, 0.0));
        Label { text, place: Place::On { middle_m: now.pose.position_m, half_length_m } }
    });
    named.collect()
}

/// The passage plans of the vessels.
pub(super) fn plans(setup: &Setup) -> Vec<PlannedDrawn> {
    let plans = setup.world.vessels.iter().filter_map(|vessel| vessel.plan.as_ref());
    plans.map(PlannedDrawn::of).collect()
}

fn banks(environment: &Environment) -> Vec<[Vec2; 2]> {
    environment.banks.iter().map(Bank::ends_m).collect()
}

/// The wind of the run, waves at the start, and the fastest current. As is usual at sea, the direction of wind and
/// waves is that from which they come, and the direction of a current is that to which it flows.
fn weather(
    environment: &Environment,
    recorder: &Recorder,
    of_changed: fn(&WindTrace) -> String,
) -> Vec<Weather> {
    let changed = recorder.wind.as_ref().filter(|trace| trace.has_changed());
    let of_setup = || {
        let wind = environment.wind.as_ref()?;
        let (speed_mps, from_rad) = wind.mean_at(0.0);
        let when = if wind.is_series() { ", at the start" } else { "" };
        let text = format!("wind {} from {}{when}", both(speed_mps), compass(from_rad));
        (speed_mps > 0.0).then_some((from_rad, text))
    };
    let of_run = changed.map(|trace| (trace.first_from_rad(), of_changed(trace)));
    let has_gusts = environment.wind.as_ref().is_some_and(|wind| wind.gusts().is_some());
    let wind = of_run.or_else(of_setup).map(|(from_rad, text)| Weather {
        towards: direction(from_rad) * -1.0,
        text: if has_gusts { text + ", with gusts" } else { text },
        colour: "#0072B2",
    });
    let current = environment.current.as_ref().and_then(|current| {
        // A current that varies: where and when it is fastest, at the surface.
        let which = match current {
            Current::Uniform(_) => "",
            Current::Layered(_) => " (at the surface)",
            Current::Grid(_) => ", the fastest of a table",
        };
        let velocity = current.fastest();
        let speed_mps = velocity.length();
        let towards_rad = libm::atan2(velocity.y, velocity.x);
        (speed_mps > 0.0).then(|| Weather {
            towards: velocity * (1.0 / speed_mps),
            text: format!("current {} towards {}{which}", both(speed_mps), compass(towards_rad)),
            colour: "#009E73",
        })
    });
    let waves = environment.sea.as_ref().map(|sea| {
        let from_rad = sea.towards_rad() + core::f64::consts::PI;
        Weather {
            towards: direction(sea.towards_rad()),
            text: format!(
                "waves Hs {} m, mean period {} s, from {}{}",
                plain(sea.significant_height_m(), 2),
                plain(sea.mean_period_s(), 3),
                compass(from_rad),
                if sea.is_short_crested() { ", short-crested" } else { "" }
            ),
            colour: "#7F5F3F",
        }
    });
    let long_waves = environment.long_waves.as_ref().map(|waves| {
        let velocity = waves.velocity_deviation();
        let speed_mps = velocity.length();
        let along = if speed_mps > 0.0 { velocity * (1.0 / speed_mps) } else { vec2(1.0, 0.0) };
        Weather {
            towards: along,
            text: format!(
                "long waves Hs {} m, significant velocity {} m/s along {}",
                plain(waves.significant_height_m(), 2),
                plain(2.0 * speed_mps, 2),
                compass(libm::atan2(along.y, along.x))
            ),
            colour: "#56B4E9",
        }
    });
    wind.into_iter().chain(current).chain(waves).chain(long_waves).collect()
}

/// Words for wind, current and waves, each with its direction; if the wind changed, with the times of its changes.
pub(in crate::run_page) fn weather_texts(
    environment: &Environment,
    recorder: &Recorder,
) -> Vec<String> {
    let weather = weather(environment, recorder, WindTrace::by_time);
    weather.into_iter().map(|weather| weather.text).collect()
}

fn direction(angle_rad: f64) -> Vec2 {
    vec2(libm::cos(angle_rad), libm::sin(angle_rad))
}

/// The plan view of the moored ships at the end of the run; empty if no mooring line was made fast.
pub(in crate::run_page) fn moored(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let setup = outcome.setup;
    let states = outcome.states;
    let lines = lines(outcome, states);
    if lines.is_empty() {
        return html! {};
    }
    let styles = styles(setup);
    let moored: Vec<usize> = setup.world.lines.iter().map(|line| line.ship).collect();
    let mut outlines = Vec::new();
    let mut frame = Frame::around(lines.iter().flat_map(|line| line.ends_m));
    for (index, body) in setup.bodies.iter().enumerate() {
        let stage = if body.mass.is_none() { Stage::Fixed } else { Stage::Peak };
        let outline = outlined(body, &states[index], stage, styles[index]);
        if moored.contains(&index) {
            let around = Frame::around(outline.vertices_m.iter().copied());
            frame = joined(frame, around);
        }
        if !outline.vertices_m.is_empty() {
            outlines.push(outline);
        }
    }
    let Some(frame) = frame else { return html! {} };
    let marks = |mark: &&TugMark| {
        moored.contains(&setup.world.vessels[setup.world.tugs[mark.tug].vessel].body)
    };
    let marks: Vec<TugMark> = recorder.last_tugs.iter().filter(marks).copied().collect();
    let names =
        moored.iter().take(1).map(|&index| body_label(&setup.bodies[index], &states[index]));
    let lines_named = setup.world.lines.iter().zip(&outcome.world.lines);
    let lines_named = lines_named.filter(|(_, totals)| totals.is_fast || totals.parted_s.is_some());
    let line_names = lines_named.zip(&lines).map(|((line, totals), drawn)| {
        let share = totals.share_of_break_load().unwrap_or(0.0);
        let bollard_m = drawn.ends_m[1];
        // On the side away from the ship.
        let ship_m = middle(&setup.bodies[line.ship], &states[line.ship]);
        let east = if bollard_m.y < ship_m.y { -1.0 } else { 1.0 };
        Label {
            place: Place::Beside { point_m: bollard_m, side: vec2(0.0, east) },
            text: format!(
                "{} {} %",
                shortened(&line.line.name, NAME_LENGTH),
                fixed(100.0 * share, 0)
            ),
        }
    });
    Plan {
        title: "Moored, at the end of the run".to_owned(),
        frame,
        outlines,
        fenders: boxes(outcome, &[], |body| Some(&states[body])),
        harbour: Harbour {
            chart: charted_in(&setup.world.chart.features, frame),
            limits: depth_limits(outcome),
            lines: lines.clone(),
            anchors: anchors(outcome).map(|(chain_m, _)| chain_m).collect(),
            tugs: tugs(setup, &marks),
            banks: banks(&setup.world.environment),
            passing: Vec::new(),
            approached: Vec::new(),
            plans: plans(setup),
            weather: weather(&setup.world.environment, recorder, WindTrace::range),
        },
        tracks: Vec::new(),
        arrows: Vec::new(),
        labels: names
            .chain(line_names)
            .chain(chart_labels(&setup.world.chart.features, frame))
            .collect(),
        note: "Each line is marked with its peak tension as a share of its break load.".to_owned(),
    }
    .render()
}
