//! Plan views of the report: the whole scene, and the contact at its peak force.

mod harbour;

use std::collections::BTreeSet;

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Vec2};
use fenderline_sim::{BodySetup, Setup};
use maud::Markup;

use super::fenders::{boxes, names};
use super::recorder::{PairTrace, Recorder};
use crate::plot::{
    Arrow, Frame, Harbour, Label, Outlined, Plan, STYLES, Scaled, Stage, Track, plain, shortened,
    significant,
};
use fenderline_results::Outcome;

pub(super) use harbour::moored;

/// Bodies drawn at most.
const DRAWN: usize = 300;
/// Names written at most: more would cover the view.
const NAMED: usize = 16;
/// Longest name in a view (characters).
const NAME_LENGTH: usize = 26;
/// Fixed bodies are shown whole where that widens the view by no more than this factor.
const WIDEN: f64 = 3.0;

fn outlined(body: &BodySetup, state: &BodyState, stage: Stage, style: usize) -> Outlined {
    let pose = state.pose();
    let vertices_m = body.outline.vertices().iter().map(|v| pose.apply(*v)).collect();
    Outlined { vertices_m, stage, style }
}

/// Colour numbers: floating bodies take them in the order of the scenario.
fn styles(setup: &Setup) -> Vec<usize> {
    let mut next = 0;
    let styles = setup.bodies.iter().map(|body| {
        let style = next;
        next += usize::from(body.mass.is_some());
        style
    });
    styles.collect()
}

/// The whole scene: start, peak force, end, tracks.
pub(super) fn whole(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let setup = outcome.setup;
    let styles = styles(setup);
    let order = by_importance(setup, recorder);
    let drawn: BTreeSet<usize> = order.iter().copied().collect();
    let mut outlines = Vec::new();
    let (mut floating, mut fixed) = (None::<Frame>, None::<Frame>);
    for &i in &drawn {
        let body = &setup.bodies[i];
        for (state, stage) in stages(i, outcome, recorder) {
            let outline = outlined(body, state, stage, styles[i]);
            let frame = if body.mass.is_none() { &mut fixed } else { &mut floating };
            *frame = joined(*frame, Frame::around(outline.vertices_m.iter().copied()));
            outlines.push(outline);
        }
    }
    let labels = order.iter().take(NAMED).filter_map(|&i| {
        let (state, _) = stages(i, outcome, recorder).into_iter().next()?;
        let body = &setup.bodies[i];
        let text = shortened(&body.name, NAME_LENGTH);
        Some(Label { at_m: middle(body, state), reach_m: reach(body), side: Vec2::ZERO, text })
    });
    let tracks = recorder.bodies.iter().filter(|trace| drawn.contains(&trace.body));
    let tracks = tracks.map(|trace| Track {
        points_m: trace.track_to(&outcome.states[trace.body]),
        style: styles[trace.body],
    });
    let contact_point = recorder.peak.iter().map(|peak| Arrow {
        from_m: peak.contact.point_m,
        direction: Vec2::ZERO,
        label: String::new(),
    });
    let title = match &recorder.peak {
        Some(peak) => {
            format!("Whole scene; largest step mean of the force at {} s", plain(peak.t_s, 4))
        }
        None => "Whole scene; no contact".to_owned(),
    };
    let Some(frame) = scene_frame(floating, fixed) else {
        unreachable!("a scenario has a body, and a body has an outline");
    };
    let note = if setup.bodies.len() > drawn.len() {
        format!("{} of {} bodies are drawn.", drawn.len(), setup.bodies.len())
    } else {
        String::new()
    };
    let pressed_m = recorder.peak.as_ref().map_or(&[][..], |peak| &peak.deflections_m);
    let shown = |body: usize| {
        let (state, _) = stages(body, outcome, recorder).into_iter().next()?;
        drawn.contains(&body).then_some(state)
    };
    let fenders = boxes(outcome, pressed_m, shown);
    let labels = labels.chain(names(outcome, shown));
    Plan {
        title,
        frame,
        outlines,
        fenders,
        harbour: harbour::around(setup, recorder),
        tracks: tracks.collect(),
        arrows: contact_point.collect(),
        labels: labels.collect(),
        note,
    }
    .render()
}

/// The bodies to draw: those of the largest forces first, then in the order of the scenario.
fn by_importance(setup: &Setup, recorder: &Recorder) -> Vec<usize> {
    let peak = recorder.peak.iter().map(|peak| &peak.contact);
    let peak = peak.flat_map(|contact| [contact.body_1.0 as usize, contact.body_2.0 as usize]);
    let strongest = super::strongest(recorder).into_iter().flat_map(|pair| pair.bodies);
    let mut seen = BTreeSet::new();
    peak.chain(strongest)
        .chain(0..setup.bodies.len())
        .filter(|body| seen.insert(*body))
        .take(DRAWN)
        .collect()
}

/// The states in which a body is drawn, the one that its name goes with first.
fn stages<'a>(
    body: usize,
    outcome: &Outcome<'a>,
    recorder: &'a Recorder,
) -> Vec<(&'a BodyState, Stage)> {
    let end = &outcome.states[body];
    if outcome.setup.bodies[body].mass.is_none() {
        return vec![(end, Stage::Fixed)];
    }
    let peak = recorder.peak.as_ref().map(|peak| (&peak.states[body], Stage::Peak));
    let start = recorder.start.get(body).map(|state| (state, Stage::Start));
    peak.into_iter().chain(start).chain([(end, Stage::End)]).collect()
}

/// Round the floating bodies, and the fixed ones where they are not so large as to make the others
/// vanish.
fn scene_frame(floating: Option<Frame>, fixed: Option<Frame>) -> Option<Frame> {
    let (Some(floating), Some(fixed)) = (floating, fixed) else { return floating.or(fixed) };
    let extent = |frame: Frame| greater(frame.size().x, frame.size().y);
    let both = floating.with(fixed);
    if extent(both) <= WIDEN * extent(floating) {
        return Some(both);
    }
    // Room to see against what the floating bodies lie.
    let room = floating.size() * 0.25;
    Some(Frame { low: floating.low - room, high: floating.high + room })
}

fn joined(a: Option<Frame>, b: Option<Frame>) -> Option<Frame> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.with(b)),
        (a, b) => a.or(b),
    }
}

/// Half the largest extent of a body's outline (m).
fn reach(body: &BodySetup) -> f64 {
    let (low, high) = body.outline.bounds();
    (high - low).length() * 0.5
}

/// The middle of a body's outline, earth-fixed (m).
fn middle(body: &BodySetup, state: &BodyState) -> Vec2 {
    let (low, high) = body.outline.bounds();
    state.pose().apply((low + high) * 0.5)
}

/// The contact of one pair in the step of its largest force.
pub(super) fn close_up(outcome: &Outcome<'_>, pair: &PairTrace) -> Markup {
    let setup = outcome.setup;
    let styles = styles(setup);
    let peak = &pair.peak;
    let bodies = pair.bodies.map(|i| &setup.bodies[i]);
    let stage = |body: &BodySetup| if body.mass.is_none() { Stage::Fixed } else { Stage::Peak };
    let [style_1, style_2] = pair.bodies.map(|i| styles[i]);
    // Colours come again after a few bodies; here the two must differ.
    let pair_styles =
        if style_1 % STYLES == style_2 % STYLES { [0, 1] } else { [style_1, style_2] };
    let outlines =
        [0, 1].map(|k| outlined(bodies[k], &peak.states[k], stage(bodies[k]), pair_styles[k]));
    let smaller_m = lesser(bodies[0].outline.radius_m(), bodies[1].outline.radius_m());
    let half_m = bounded(12.0 * peak.contact.depth_m, 0.25 * smaller_m, smaller_m);
    let centre = peak.contact.point_m;
    let frame = Frame::about(centre, half_m);
    // Names stand off from the contact along the normal: body 1 behind it, body 2 before it.
    let labels = [-0.8, 0.8].into_iter().zip(bodies).map(|(share, body)| Label {
        at_m: centre + peak.contact.normal * (share * half_m),
        reach_m: f64::INFINITY,
        side: Vec2::ZERO,
        text: shortened(&body.name, NAME_LENGTH),
    });
    let shown =
        |body: usize| pair.bodies.iter().position(|other| *other == body).map(|k| &peak.states[k]);
    // The strongest patch's own force: the pair's is the sum over fenders far from each other.
    let force = Scaled::for_largest(peak.contact.normal_force_n);
    let by = peak.contact.fender.map(|id| setup.fenders[id.0 as usize].name.as_str());
    let arrow = Arrow {
        from_m: centre,
        // The push on body 2.
        direction: peak.contact.normal,
        label: format!(
            "N = {} {} on {}{}",
            significant(peak.contact.normal_force_n * force.factor, 4),
            force.unit("N"),
            shortened(&bodies[1].name, NAME_LENGTH),
            if by.is_some() { ", of this fender" } else { "" }
        ),
    };
    Plan {
        title: format!(
            "{} – {} at the largest step mean of their force, {} s; {} {} m",
            bodies[0].name,
            bodies[1].name,
            plain(peak.t_s, 4),
            by.map_or_else(|| "depth".to_owned(), |name| format!("deflection of {name}")),
            significant(peak.contact.depth_m, 3)
        ),
        frame,
        outlines: outlines.to_vec(),
        fenders: boxes(outcome, &peak.deflections_m, shown),
        harbour: Harbour::default(),
        tracks: Vec::new(),
        arrows: vec![arrow],
        labels: labels.chain(names(outcome, shown)).collect(),
        note:
            "Forces here are means over a step, depths those at its start; the tables have the peaks within steps."
                .to_owned(),
    }
    .render()
}
