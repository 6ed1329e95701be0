//! Charts of vessels, tugs and mooring lines over time.

use fenderline_contact::number::greater;
use fenderline_sim::VesselSetup;
use fenderline_sim::constants::KNOT_MPS;
use maud::{Markup, html};

use crate::plot::{Axis, Decimator, Reference, STYLES, Series, plain};
use crate::run_page::charts::{Charts, scaled};
use crate::run_page::recorder::Recorder;
use crate::run_page::recorder::{DockingTrace, VesselTrace};

/// Largest number of vessels that have charts of their own.
const VESSELS: usize = 3;
/// Motions smaller than this are not drawn (m, rad).
const STILL: f64 = 1e-9;
/// Largest number of mooring lines in a chart; more cannot be told apart.
const LINES: usize = 4;
/// The break load or working load is drawn in a chart of mooring lines only if their largest tension is at least this
/// share of the load.
const NEAR_LIMIT: f64 = 0.4;
/// Squat smaller than this is not drawn (m).
const SEEN_M: f64 = 0.01;

/// The charts of each vessel.
pub(super) fn vessels(page: &Charts<'_>, recorder: &Recorder) -> Markup {
    let setup = page.outcome.setup;
    let all = setup.world.vessels.iter().zip(&recorder.world.vessels);
    html! {
        @for (vessel, trace) in all.take(VESSELS) {
            (of_vessel(page, &setup.bodies[vessel.body].name, vessel, trace))
        }
        @if setup.world.vessels.len() > VESSELS {
            p class="note" {
                (format!(
                    "Charts of the first {VESSELS} of {} vessels; all vessels are in the table of \
                     vessels.",
                    setup.world.vessels.len(),
                ))
            }
        }
    }
}

fn line(name: &str, of: &Decimator, factor: f64) -> Series {
    Series::line(name, of.points()).scaled(factor)
}

/// The two series of the ordered and the actual value.
fn both([order, actual]: &[Decimator; 2], factor: f64) -> Vec<Series> {
    vec![line("ordered", order, factor).styled(1), line("actual", actual, factor).styled(0)]
}

fn of_vessel(page: &Charts<'_>, name: &str, setup: &VesselSetup, trace: &VesselTrace) -> Markup {
    let degrees = 1.0_f64.to_degrees();
    let zero = |label: &str, unit: &str| Axis::new(label, unit).including(0.0);
    let chart = |title: &str, axis: Axis, series: Vec<Series>| {
        page.chart(&format!("{title}, {name}"), axis, series).render()
    };
    let moves = |of: &Decimator| Series::line("", of.points()).largest() > STILL;
    html! {
        (chart("Speed over ground", zero("speed", "kn"), vec![
            line("ahead", &trace.along_mps, 1.0 / KNOT_MPS),
            line("to starboard", &trace.across_mps, 1.0 / KNOT_MPS),
        ]))
        @if let Some(docking) = &trace.docking { (of_docking(page, name, docking)) }
        @if page.outcome.statistics.is_none() {
            (chart("Heading", Axis::new("heading", "deg"), vec![
                line("heading", &trace.heading_rad, degrees),
            ]))
        }
        (chart("Rate of turn, positive to starboard", zero("rate of turn", "deg/min"), vec![
            line("rate of turn", &trace.turn_radps, 60.0 * degrees),
        ]))
        @if trace.rudder_rad.iter().any(moves) {
            (chart("Rudder, positive turns to starboard", zero("rudder", "deg"),
                both(&trace.rudder_rad, degrees)))
        }
        @if trace.shaft_rps.iter().any(moves) {
            (chart("Revolutions, positive ahead", zero("revolutions", "rpm"),
                both(&trace.shaft_rps, 60.0)))
        }
        @let thrusters = setup.thrusters.iter().zip(&trace.thrusters);
        @let thrusters = thrusters.filter(|(_, thruster)| thruster.iter().any(moves));
        @for (of, thruster) in thrusters.take(STYLES / 2) {
            (chart(&format!("Thruster {}, positive to starboard", of.name), zero("thrust", "%"),
                both(thruster, 100.0)))
        }
        @for (of, unit) in setup.azimuths.iter().zip(&trace.azimuths).take(STYLES / 2) {
            (chart(&format!("Azimuth unit {}, power", of.name), zero("thrust at rest", "%"),
                both(&unit.power, 100.0)))
            (chart(&format!("Azimuth unit {}, direction of its thrust from the bow", of.name),
                zero("direction", "deg"), both(&unit.direction_rad, degrees)))
        }
        @if Series::line("", trace.squat_m.points()).largest() > SEEN_M {
            (chart("Squat", zero("squat", "m"), vec![line("squat", &trace.squat_m, 1.0)]))
        }
        @if moves(&trace.under_keel_m) {
            (chart("Under-keel clearance, squat included", zero("clearance", "m"), vec![
                line("clearance", &trace.under_keel_m, 1.0),
            ]))
        }
        // Beside the statistics of motions, if the scenario asks for them.
        @if page.outcome.statistics.is_none() { (attitude(page, name, trace)) }
    }
}

/// The charts of the motions of each vessel in six degrees of freedom.
pub(super) fn motions(page: &Charts<'_>, recorder: &Recorder) -> Markup {
    let setup = page.outcome.setup;
    let all = setup.world.vessels.iter().zip(&recorder.world.vessels);
    let degrees = 1.0_f64.to_degrees();
    html! {
        @for (vessel, trace) in all.take(VESSELS) {
            @let name = &setup.bodies[vessel.body].name;
            @let [ahead, starboard] = &trace.place_m;
            @let chart = |title: &str, axis: Axis, of: &Decimator, factor: f64| {
                page.chart(&format!("{title}, {name}"), axis, vec![line("", of, factor)]).render()
            };
            (chart("Surge, ahead of the place at the start", Axis::new("surge", "m").including(0.0), ahead, 1.0))
            (chart("Sway, to starboard of the place at the start", Axis::new("sway", "m").including(0.0), starboard, 1.0))
            (attitude(page, name, trace))
            (chart("Yaw, her heading", Axis::new("heading", "deg"), &trace.heading_rad, degrees))
        }
    }
}

/// The charts of heave, roll and pitch of a vessel, if she has these motions.
fn attitude(page: &Charts<'_>, name: &str, trace: &VesselTrace) -> Markup {
    let degrees = 1.0_f64.to_degrees();
    let moves = |of: &Decimator| Series::line("", of.points()).largest() > STILL;
    html! {
        @if moves(&trace.heave_m) {
            (page.chart(&format!("Heave, positive down, {name}"), Axis::new("heave", "m").including(0.0), vec![
                line("heave", &trace.heave_m, 1.0),
            ]).render())
        }
        @if moves(&trace.roll_rad) || moves(&trace.pitch_rad) {
            (page.chart(&format!("Roll (to starboard) and pitch (bow up), {name}"), Axis::new("angle", "deg").including(0.0), vec![
                line("roll", &trace.roll_rad, degrees),
                line("pitch", &trace.pitch_rad, degrees),
            ]).render())
        }
    }
}

/// The charts of the forces on each vessel by the flow around passing ships and other vessels.
pub(super) fn passing(page: &Charts<'_>, recorder: &Recorder) -> Markup {
    let setup = page.outcome.setup;
    let all = setup.world.vessels.iter().zip(&recorder.world.vessels);
    html! {
        @for (vessel, trace) in all.take(VESSELS) {
            @let [surge, sway, yaw] = &trace.passing;
            @let name = &setup.bodies[vessel.body].name;
            (page.chart(
                &format!("Force of passing ships, {name}"),
                Axis::new("force", "kN").including(0.0),
                vec![line("surge", surge, 1e-3), line("sway", sway, 1e-3)],
            ).render())
            (page.chart(
                &format!("Yaw moment of passing ships, {name}"),
                Axis::new("moment", "MN·m").including(0.0),
                vec![line("yaw", yaw, 1e-6)],
            ).render())
        }
    }
}

/// The charts of distance and speed towards the fenders, as a docking aid shows them.
fn of_docking(page: &Charts<'_>, name: &str, docking: &DockingTrace) -> Markup {
    let two = |of: &[Decimator; 2], factor: f64| {
        vec![line("bow", &of[0], factor), line("stern", &of[1], factor)]
    };
    let distance = Axis::new("distance", "m").including(0.0);
    let title = format!("Distance to the line of the fenders, {name}");
    let mut distance = page.chart(&title, distance, two(&docking.distance_m, 1.0));
    distance.note =
        "Nearest points of the forward and the after third of the hull to the line through the \
                     fenders' faces. Below 0 the hull compresses the fenders, or is on the other \
                     side."
            .to_owned();
    let speed = Axis::new("speed", "cm/s").including(0.0);
    let title = format!("Speed towards the fenders, {name}");
    html! {
        (distance.render())
        (page.chart(&title, speed, two(&docking.closing_mps, 100.0)).render())
    }
}

/// The chart of the forces and orders of all tugs.
pub(super) fn tugs(page: &Charts<'_>, recorder: &Recorder) -> Markup {
    let setup = page.outcome.setup;
    let traces = setup.world.tugs.iter().zip(&recorder.world.tugs).take(STYLES / 2);
    let series = traces.enumerate().flat_map(|(index, (tug, trace))| {
        let name = &tug.tug.name;
        [
            line(name, &trace.force_n, 1.0).styled(2 * index),
            line(&format!("{name}, ordered"), &trace.ordered_n, 1.0).styled(2 * index + 1),
        ]
    });
    let (unit, series) = scaled(series.collect(), "N");
    page.chart("Forces of the tugs", Axis::new("force", &unit).including(0.0), series).render()
}

/// The charts of the tensions of the recorded mooring lines, a few in each chart, with break load and working load if
/// these are the same for all lines of the chart.
pub(super) fn lines(page: &Charts<'_>, recorder: &Recorder) -> Markup {
    let all: Vec<usize> = (0..recorder.world.lines.len()).collect();
    let charts: Vec<&[usize]> = all.chunks(LINES).collect();
    html! {
        @for (index, lines) in charts.iter().enumerate() {
            @let title = if charts.len() > 1 {
                format!("Tension of the lines, {} of {}", index + 1, charts.len())
            } else {
                "Tension of the lines".to_owned()
            };
            (some_lines(page, recorder, &title, lines))
        }
        @if page.outcome.setup.world.lines.len() > all.len() {
            p class="note" {
                (format!(
                    "The first {} lines of {}; all lines are in the table.",
                    all.len(),
                    page.outcome.setup.world.lines.len(),
                ))
            }
        }
    }
}

/// The chart of the tensions of some mooring lines.
fn some_lines(page: &Charts<'_>, recorder: &Recorder, title: &str, lines: &[usize]) -> Markup {
    let setup = page.outcome.setup;
    let totals = &page.outcome.world.lines;
    let series =
        lines.iter().map(|&k| line(&setup.world.lines[k].line.name, &recorder.world.lines[k], 1.0));
    let (unit, series) = scaled(series.collect(), "N");
    let factor = if unit == "N" { 1.0 } else { series_factor(&unit) };
    let common = |of: fn(&fenderline_results::LineTotals) -> Option<f64>| {
        let mut values = lines.iter().filter_map(|&k| of(&totals[k]));
        let first = values.next()?;
        values.all(|value| value == first).then_some(first)
    };
    let limits = [
        ("break load", common(|line| line.break_load_n)),
        ("working load", common(|line| line.working_load_n)),
    ];
    let limits = limits.into_iter().filter_map(|(label, value_n)| {
        Some(Reference { label: label.to_owned(), value: value_n? * factor })
    });
    // Lines far below their loads are drawn at their own scale.
    let largest = series.iter().fold(0.0, |most, one: &Series| greater(most, one.largest()));
    let (drawn, far): (Vec<Reference>, Vec<Reference>) =
        limits.partition(|limit| largest >= NEAR_LIMIT * limit.value);
    let mut chart = page.chart(title, Axis::new("tension", &unit).including(0.0), series);
    chart.references = drawn;
    let far = far.iter().map(|limit| format!("{} {} {unit}", limit.label, plain(limit.value, 4)));
    let far: Vec<String> = far.collect();
    if !far.is_empty() {
        chart.note = format!("Above the chart: {}.", far.join(", "));
    }
    chart.render()
}

/// The chart of the tensions of anchor chains, and of the holding forces of anchors and chains.
pub(super) fn anchors(page: &Charts<'_>, recorder: &Recorder) -> Markup {
    let setup = page.outcome.setup;
    let traces = setup.world.anchors.iter().zip(&recorder.world.anchors).take(STYLES / 2);
    let series = traces.enumerate().flat_map(|(index, (anchor, trace))| {
        let name = &anchor.gear.name;
        [
            line(name, &trace.tension_n, 1.0).styled(2 * index),
            line(&format!("{name}, holds"), &trace.holding_n, 1.0).styled(2 * index + 1),
        ]
    });
    let series = series.filter(|series| series.largest() > 0.0);
    let (unit, series) = scaled(series.collect(), "N");
    let mut chart = page.chart(
        "Anchors: tension of the chain",
        Axis::new("tension", &unit).including(0.0),
        series,
    );
    chart.note =
        "Tension at the hawse pipe; the holding force of anchor and chain is a horizontal \
        force at the bottom."
            .to_owned();
    chart.render()
}

/// The factor from newtons to a unit of force.
fn series_factor(unit: &str) -> f64 {
    match unit {
        "kN" => 1e-3,
        "MN" => 1e-6,
        _ => 1e-9,
    }
}
