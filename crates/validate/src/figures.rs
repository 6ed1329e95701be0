//! Draws the figures of the paper of Moreno et al. (2023) from our runs, and the outlines of the bodies in these runs.

use fenderline_contact::{BodyState, Pose, Vec2, vec2};
use fenderline_sim::BodySetup;
use maud::{Markup, html};

use super::play::{Played, Sample};
use super::row::Runs;
use fenderline_report::plot::{
    Axis, Chart, Frame, Harbour, Label, Outlined, Place, Plan, Point, Reference, Series, Stage,
    plain,
};

/// Runs of experiment 1 of Moreno et al. (2023), in which the time step varies: names of the runs and of their lines in
/// the charts.
const STEPS: [(&str, &str); 4] = [
    ("paper/experiment_1_step_0.1s", "Δt 0.1 s"),
    ("paper/experiment_1_step_0.5s", "Δt 0.5 s"),
    ("paper/experiment_1_step_1s", "Δt 1 s"),
    ("paper/experiment_1_step_2s", "Δt 2 s"),
];
/// Runs of experiment 2 of Moreno et al. (2023), in which the approach speed varies: names of the runs and of their
/// lines in the charts.
const SPEEDS: [(&str, &str); 4] = [
    ("paper/experiment_2_4kn", "4 kn"),
    ("paper/experiment_2_2kn", "2 kn"),
    ("paper/experiment_2_1kn", "1 kn"),
    ("paper/experiment_2_0.5kn", "0.5 kn"),
];
/// Time at which the charts of experiment 1 end (s); tug and ship no longer push each other then.
const END_OF_EXPERIMENT_1_S: f64 = 10.0;
const END_OF_EXPERIMENT_2_S: f64 = 12.0;
/// Shortest time step (s) with which each step of a run is marked in the chart; such runs have few steps.
const MARKED_STEP_S: f64 = 0.5;

const FORCE: (&str, &str, f64) = ("normal force", "MN", 1e-6);

/// Draws Fig. 9 of Moreno et al. (2023): normal force over time for the four time steps.
pub(super) fn figure_9(runs: &Runs) -> Markup {
    let (label, unit, factor) = FORCE;
    chart(
        "Fig. 9 – Normal contact force for four time steps, 4 kn",
        (label, unit),
        series(&STEPS, runs, END_OF_EXPERIMENT_1_S, |s, _| s.normal_force_n * factor),
        Vec::new(),
        "Each mark is at the start of the time step over which its force acts. With a time step \
         of 2 s only two steps have a force.",
    )
}

/// Draws Fig. 10 of Moreno et al. (2023): relative speed for the four time steps, with the expected final speed.
pub(super) fn figure_10(runs: &Runs) -> Markup {
    let run = &runs[STEPS[0].0];
    chart(
        "Fig. 10 – Relative speed for four time steps, 4 kn",
        ("relative speed", "m/s"),
        series(&STEPS, runs, END_OF_EXPERIMENT_1_S, |s, _| s.closing_mps),
        vec![Reference { label: "−γV⁰".to_owned(), value: expected_final_mps(run) }],
        "Positive when closing. The dashed line is the final speed expected by eq. 9 of the paper.",
    )
}

/// Draws Fig. 11 of Moreno et al. (2023): relative speed for the four approach speeds.
pub(super) fn figure_11(runs: &Runs) -> Markup {
    let references = SPEEDS.iter().enumerate().map(|(index, (name, _))| Reference {
        // The lines of the slow runs are too close together for texts of their own.
        label: if index == 0 { "−γV⁰ of each".to_owned() } else { String::new() },
        value: expected_final_mps(&runs[name]),
    });
    chart(
        "Fig. 11 – Relative speed for four approach speeds, Δt 0.1 s",
        ("relative speed", "m/s"),
        series(&SPEEDS, runs, END_OF_EXPERIMENT_2_S, |s, _| s.closing_mps),
        references.collect(),
        "Positive when closing. The bodies start 2 m apart, so that tug and ship touch late in \
         the slow runs.",
    )
}

/// Draws Fig. 11 of Moreno et al. (2023) again, with each speed as a share of its initial value.
pub(super) fn figure_11_scaled(runs: &Runs) -> Markup {
    let run = &runs[SPEEDS[0].0];
    let value = expected_final_mps(run) / run.pair.approach_speed_mps;
    chart(
        "Fig. 11, each speed divided by its own initial speed",
        ("speed over initial speed", ""),
        series(&SPEEDS, runs, END_OF_EXPERIMENT_2_S, |s, run| {
            s.closing_mps / run.pair.approach_speed_mps
        }),
        vec![Reference { label: "−γ".to_owned(), value }],
        "This figure is our own and not in the paper: the final speed is the same share of each \
         initial speed.",
    )
}

/// Draws Fig. 12 of Moreno et al. (2023): normal force over time for the four approach speeds.
pub(super) fn figure_12(runs: &Runs) -> Markup {
    let (label, unit, factor) = FORCE;
    chart(
        "Fig. 12 – Normal contact force for four approach speeds, Δt 0.1 s",
        (label, unit),
        series(&SPEEDS, runs, END_OF_EXPERIMENT_2_S, |s, _| s.normal_force_n * factor),
        Vec::new(),
        "",
    )
}

fn chart(
    title: &str,
    (label, unit): (&str, &str),
    series: Vec<Series>,
    references: Vec<Reference>,
    note: &str,
) -> Markup {
    Chart {
        title: title.to_owned(),
        x: Axis::new("time", "s").including(0.0).tight(),
        y: Axis::new(label, unit).including(0.0),
        series,
        references,
        linked: Some("time"),
        note: note.to_owned(),
    }
    .render()
}

fn series(
    lines: &[(&str, &str)],
    runs: &Runs,
    end_s: f64,
    value: impl Fn(&Sample, &Played) -> f64,
) -> Vec<Series> {
    let drawn = lines.iter().map(|(name, label)| {
        let run = &runs[name];
        let samples = run.trace.iter().take_while(|sample| sample.t_s <= end_s);
        let points = samples.map(|s| Point { x: s.t_s, y: value(s, run) }).collect();
        let line = Series::line(label, points);
        if run.setup.step_s >= MARKED_STEP_S { line.with_marks() } else { line }
    });
    drawn.collect()
}

/// −γV⁰ (m/s).
fn expected_final_mps(run: &Played) -> f64 {
    -run.restitution * run.pair.approach_speed_mps
}

/// Draws the outlines of tug and ship, each with its dimensions, and how the bodies lie at the start.
pub(super) fn outlines(runs: &Runs) -> Markup {
    let run = &runs[STEPS[0].0];
    html! {
        @for (style, body) in run.setup.bodies.iter().enumerate() { (outline(body, style)) }
        (start(run))
    }
}

/// Draws one outline by itself, the bow to the right.
fn outline(body: &BodySetup, style: usize) -> Markup {
    // Heading east, so that a long ship lies along the page.
    let pose = BodyState { heading_rad: core::f64::consts::FRAC_PI_2, ..Default::default() }.pose();
    let vertices_m = body.outline.vertices().iter().map(|v| pose.apply(*v)).collect();
    let frame = frame_of(body, &pose);
    let (length_m, breadth_m) = size(body);
    // Room for the scale bar below and the arrow above.
    let room = vec2(0.25 * breadth_m, 0.0);
    let frame = Frame { low: frame.low - room, high: frame.high + room };
    let text = format!("{}, {} m × {} m", body.name, plain(length_m, 4), plain(breadth_m, 4));
    Plan {
        title: format!("Outline of the {text}"),
        frame,
        outlines: vec![Outlined { vertices_m, stage: Stage::Peak, style }],
        fenders: Vec::new(),
        harbour: Harbour::default(),
        tracks: Vec::new(),
        arrows: Vec::new(),
        labels: vec![Label { text, place: Place::At(vec![Vec2::ZERO]) }],
        note: format!(
            "The bow is to the right; the vertices, in m forward and to starboard, are: {}.",
            corners(body)
        ),
    }
    .render()
}

/// A body at the start of a run, with its outline and label.
struct Placed<'r> {
    body: &'r BodySetup,
    outlined: Outlined,
    frame: Frame,
}

impl<'r> Placed<'r> {
    fn of(body: &'r BodySetup, style: usize) -> Placed<'r> {
        let state = BodyState {
            position_m: body.position_m,
            heading_rad: body.heading_rad,
            ..Default::default()
        };
        let pose = state.pose();
        let vertices_m = body.outline.vertices().iter().map(|v| pose.apply(*v)).collect();
        let outlined = Outlined { vertices_m, stage: Stage::Peak, style };
        Placed { body, outlined, frame: frame_of(body, &pose) }
    }

    fn label(&self) -> Label {
        let place = Place::At(vec![(self.frame.low + self.frame.high) * 0.5]);
        Label { text: self.body.name.clone(), place }
    }
}

/// The smallest frame of a drawing round the bounds of a body.
fn frame_of(body: &BodySetup, pose: &Pose) -> Frame {
    let (low, high) = body.outline.bounds();
    let diagonal = |a: Vec2, b: Vec2| Frame::between(pose.apply(a), pose.apply(b));
    diagonal(low, high).with(diagonal(vec2(low.x, high.y), vec2(high.x, low.y)))
}

/// Draws how tug and ship lie at the start of experiment 1, near where they will touch (Fig. 8): the tug west of the
/// ship.
fn start(run: &Played) -> Markup {
    let [one, other] = run.bodies.map(|body| Placed::of(&run.setup.bodies[body], body));
    let [tug_placed, ship_placed] =
        if one.frame.low.y < other.frame.low.y { [one, other] } else { [other, one] };
    let (tug, ship) = (tug_placed.frame, ship_placed.frame);
    let gap_m = ship.low.y - tug.high.y;
    let bow = vec2(0.0, tug.high.y);
    let room = vec2(24.0, 6.0);
    let frame =
        Frame { low: vec2(-room.x, tug.low.y - room.y), high: vec2(room.x, ship.high.y + room.y) };
    let gap = Label {
        text: format!("gap {} m", plain(gap_m, 3)),
        place: Place::At(vec![bow + vec2(9.0, 0.5 * gap_m)]),
    };
    let labels = vec![ship_placed.label(), tug_placed.label(), gap];
    let outlines = vec![ship_placed.outlined, tug_placed.outlined];
    Plan {
        title: "Fig. 8 – Start of experiment 1: the tug bow-on to the ship's side amidships"
            .to_owned(),
        frame,
        outlines,
        fenders: Vec::new(),
        harbour: Harbour::default(),
        tracks: Vec::new(),
        arrows: Vec::new(),
        labels,
        note: "The ship extends beyond the frame of the drawing, above and below.".to_owned(),
    }
    .render()
}

/// Length and breadth of an outline (m).
fn size(body: &BodySetup) -> (f64, f64) {
    let (low, high) = body.outline.bounds();
    (high.x - low.x, high.y - low.y)
}

fn corners(body: &BodySetup) -> String {
    let corner = |v: &Vec2| format!("({}, {})", plain(v.x, 4), plain(v.y, 4));
    body.outline.vertices().iter().map(corner).collect::<Vec<_>>().join(", ")
}
