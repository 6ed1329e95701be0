//! Plan views of the report: the whole scene, and the contact at its peak force.

mod bodies;
mod harbour;

use std::collections::BTreeSet;

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_sim::{BodySetup, Setup};
use maud::{Markup, html};

use self::bodies::{NAME_LENGTH, body_label, joined, outlined, outlined_in, styles};
use super::fenders::{boxes, names};
use super::recorder::{PairTrace, Recorder};
use super::strongest::strongest;
use crate::plot::{
    Arrow, Frame, Harbour, Label, Place, Plan, PlannedDrawn, STYLES, Scaled, Stage, Track,
    chart_labels, plain, shortened, significant,
};
use fenderline_results::Outcome;

pub(super) use harbour::{depth_limits, moored, under_keel_limit_m, weather_texts};

/// Largest number of drawn bodies.
const DRAWN: usize = 300;
/// Largest number of names in a view; more names would cover the view.
const NAMED: usize = 16;
/// If the whole scene is larger than the berth by this factor, the title page shows only the berth, with some room
/// around it (as a share of its size).
const FAR: f64 = 1.8;
const BERTH_ROOM: f64 = 0.12;
/// Fixed bodies are shown whole if this widens the view by no more than this factor.
const WIDEN: f64 = 3.0;

/// The plan view of the title page: the berth if the ships come from far away, otherwise the whole scene. Empty if
/// there are no bodies.
pub(super) fn first(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    scene(outcome, recorder, berth_frame(outcome, recorder))
}

/// The plan view of the whole scene, if it is not on the title page.
pub(super) fn whole(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    if berth_frame(outcome, recorder).is_none() {
        return html! {};
    }
    scene(outcome, recorder, None)
}

/// The frame of the berth: around floating bodies and fenders at the moment of the largest force; `None` if the whole
/// scene is not much larger.
fn berth_frame(outcome: &Outcome<'_>, recorder: &Recorder) -> Option<Frame> {
    let peak = recorder.peak.as_ref()?;
    let setup = outcome.setup;
    let around = |body: usize, state: &BodyState| {
        let outline = outlined(&setup.bodies[body], state, Stage::Peak, 0);
        Frame::around(outline.vertices_m)
    };
    let floating = || (0..setup.bodies.len()).filter(|&body| !setup.bodies[body].is_fixed());
    let fenders = setup.fenders.iter().filter_map(|fender| {
        let pose = peak.states.get(fender.body)?.pose();
        Frame::around(std::iter::once(pose.apply(fender.position_m)))
    });
    let at_berth = floating().filter_map(|body| around(body, peak.states.get(body)?));
    let near = at_berth.chain(fenders).fold(None, |all, one| joined(all, Some(one)))?;
    let stages = floating().flat_map(|body| {
        let stages = stages(body, outcome, recorder).into_iter();
        stages.filter_map(move |(state, _)| around(body, state))
    });
    let all = stages.fold(None, |all, one| joined(all, Some(one)))?;
    let extent = |frame: Frame| greater(frame.size().x, frame.size().y);
    let room = vec2(1.0, 1.0) * (BERTH_ROOM * extent(near));
    (extent(all) > FAR * extent(near))
        .then_some(Frame { low: near.low - room, high: near.high + room })
}

/// The plan view with the bodies at the start, at the peak force and at the end, and their tracks; of the whole scene,
/// or of the frame `berth`.
fn scene(outcome: &Outcome<'_>, recorder: &Recorder, berth: Option<Frame>) -> Markup {
    let setup = outcome.setup;
    let styles = styles(setup);
    let order = by_importance(setup, recorder);
    let is_drawn = |body: &usize| !setup.bodies[*body].outline.is_of_parts();
    let drawn: BTreeSet<usize> = order.iter().copied().filter(is_drawn).collect();
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
    let labels = order.iter().filter(|body| is_drawn(body)).take(NAMED).filter_map(|&i| {
        let (state, _) = stages(i, outcome, recorder).into_iter().next()?;
        Some(body_label(&setup.bodies[i], state))
    });
    let tracks = recorder.bodies.iter().filter(|trace| drawn.contains(&trace.body));
    let tracks = tracks.map(|trace| Track {
        points_m: trace.track_to(&outcome.states[trace.body]),
        style: styles[trace.body],
        is_one_of_many: false,
    });
    let contact_point = recorder.peak.iter().map(|peak| Arrow {
        from_m: peak.contact.point_m,
        direction: Vec2::ZERO,
        label: String::new(),
    });
    let title = match &recorder.peak {
        Some(peak) => {
            let what = if berth.is_some() { "The berth" } else { "Whole scene" };
            format!("{what}; largest contact force at {} s", plain(peak.t_s, 4))
        }
        None => "Whole scene; no contact".to_owned(),
    };
    let Some(frame) = berth.or_else(|| scene_frame(floating, fixed)) else { return html! {} };
    // Passing ships where they were nearest.
    let frame = harbour::passing(outcome).iter().fold(frame, |frame, ship| {
        Frame::around(ship.outline_m.iter().copied()).map_or(frame, |ship| frame.with(ship))
    });
    // Passage plans are shown whole, except at the berth.
    let plans = harbour::plans(setup);
    let whole = plans.iter().filter(|_| berth.is_none()).filter_map(PlannedDrawn::frame);
    let frame = whole.fold(frame, Frame::with);
    // Both ends of the mooring lines.
    let frame = harbour::lines_at_peak(outcome, recorder).iter().fold(frame, |frame, line| {
        Frame::around(line.ends_m).map_or(frame, |ends| frame.with(ends))
    });
    // Anchors on the bottom at the end of the run.
    let frame = harbour::anchors(outcome).fold(frame, |frame, (chain_m, _)| {
        Frame::around(chain_m).map_or(frame, |chain| frame.with(chain))
    });
    let note = if setup.bodies.len() > drawn.len() {
        format!("{} of {} bodies are drawn.", drawn.len(), setup.bodies.len())
    } else if berth.is_some() {
        "One of the plan views shows the whole scene.".to_owned()
    } else {
        String::new()
    };
    let pressed_m = recorder.peak.as_ref().map_or(&[][..], |peak| &peak.deflections_m);
    let shown = |body: usize| {
        let (state, _) = stages(body, outcome, recorder).into_iter().next()?;
        drawn.contains(&body).then_some(state)
    };
    let fenders = boxes(outcome, pressed_m, shown);
    let passing = harbour::passing_names(outcome);
    let of_chart = chart_labels(&setup.world.chart.features, frame);
    let anchors = harbour::anchor_names(outcome);
    let labels = names(outcome, shown).into_iter().chain(labels).chain(passing).chain(anchors);
    let of_plans = plans.iter().flat_map(PlannedDrawn::labels);
    let labels = labels.chain(of_plans).chain(of_chart);
    Plan {
        title,
        frame,
        outlines,
        fenders,
        harbour: harbour::around(outcome, recorder, frame),
        tracks: tracks.collect(),
        arrows: contact_point.collect(),
        labels: labels.collect(),
        note,
    }
    .render()
}

/// The bodies to draw: first those with the largest forces, then the others in the order of the scenario.
fn by_importance(setup: &Setup, recorder: &Recorder) -> Vec<usize> {
    let peak = recorder.peak.iter().map(|peak| &peak.contact);
    let peak = peak.flat_map(|contact| [contact.body_1.0 as usize, contact.body_2.0 as usize]);
    let strongest = strongest(recorder).into_iter().flat_map(|pair| pair.bodies);
    let mut seen = BTreeSet::new();
    peak.chain(strongest)
        .chain(0..setup.bodies.len())
        .filter(|body| seen.insert(*body))
        .take(DRAWN)
        .collect()
}

/// The states in which a body is drawn. The name of the body stands at the first state.
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

/// The frame of the whole scene, around the floating bodies. Fixed bodies are included unless they are so large that
/// the floating bodies could hardly be seen.
fn scene_frame(floating: Option<Frame>, fixed: Option<Frame>) -> Option<Frame> {
    let (Some(floating), Some(fixed)) = (floating, fixed) else { return floating.or(fixed) };
    let extent = |frame: Frame| greater(frame.size().x, frame.size().y);
    let both = floating.with(fixed);
    if extent(both) <= WIDEN * extent(floating) {
        return Some(both);
    }
    // Room to see what the floating bodies touch.
    let room = floating.size() * 0.25;
    Some(Frame { low: floating.low - room, high: floating.high + room })
}

/// Points on a body where its name may stand, away from a contact at `centre`: along the vector `off_m`, then to both
/// sides of this vector.
fn points_on(body: &BodySetup, state: &BodyState, centre: Vec2, off_m: Vec2) -> Vec<Vec2> {
    let across_m = off_m.quarter_turn();
    let off = [0.8, 0.6, 0.4, 0.25];
    let aside = [0.0, 0.35, -0.35, 0.7, -0.7];
    let points =
        aside.into_iter().flat_map(|aside| off.map(|off| centre + off_m * off + across_m * aside));
    let is_on_body = |point_m: &Vec2| {
        let own = state.pose().apply_inverse(*point_m);
        body.outline.pieces().iter().any(|piece| is_in_convex(piece, own))
    };
    points.filter(is_on_body).collect()
}

/// Whether a point lies in a convex polygon.
fn is_in_convex(ring: &[Vec2], point: Vec2) -> bool {
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    let mut turns = sides.map(|(a, b)| (*b - *a).cross(point - *a));
    let Some(first) = turns.next() else { return false };
    turns.all(|turn| turn * first >= 0.0)
}

/// The close-up view of the contact of one pair in the step of its largest force.
pub(super) fn close_up(outcome: &Outcome<'_>, pair: &PairTrace) -> Markup {
    let setup = outcome.setup;
    let styles = styles(setup);
    let peak = &pair.peak;
    let bodies = pair.bodies.map(|i| &setup.bodies[i]);
    let stage = |body: &BodySetup| if body.mass.is_none() { Stage::Fixed } else { Stage::Peak };
    let [style_1, style_2] = pair.bodies.map(|i| styles[i]);
    // Colours repeat after a few bodies; the colours of this pair must differ.
    let pair_styles =
        if style_1 % STYLES == style_2 % STYLES { [0, 1] } else { [style_1, style_2] };
    let smaller_m = lesser(bodies[0].outline.radius_m(), bodies[1].outline.radius_m());
    let half_m = bounded(12.0 * peak.contact.depth_m, 0.25 * smaller_m, smaller_m);
    let centre = peak.contact.point_m;
    let frame = Frame::about(centre, half_m);
    let outlines = [0, 1].into_iter().flat_map(|k| {
        outlined_in(frame, bodies[k], &peak.states[k], stage(bodies[k]), pair_styles[k])
    });
    // Along the normal, body 1 is behind the contact and body 2 before it.
    let labels = [0, 1].map(|k| {
        let normal = peak.contact.normal * [-1.0, 1.0][k];
        Label {
            text: shortened(&bodies[k].name, NAME_LENGTH),
            place: Place::At(points_on(bodies[k], &peak.states[k], centre, normal * half_m)),
        }
    });
    let shown =
        |body: usize| pair.bodies.iter().position(|other| *other == body).map(|k| &peak.states[k]);
    // The force of the strongest patch. The pair's force is a sum over fenders far from each other.
    let force = Scaled::for_largest(peak.contact.normal_force_n);
    let by = peak.contact.fender.map(|id| setup.fenders[id.0 as usize].name.as_str());
    let arrow = Arrow {
        from_m: centre,
        // The push on body 2.
        direction: peak.contact.normal,
        label: format!(
            "N = {} {}",
            significant(peak.contact.normal_force_n * force.factor, 4),
            force.unit("N")
        ),
    };
    Plan {
        title: format!(
            "{} – {} at their largest force, {} s; {} {} m",
            bodies[0].name,
            bodies[1].name,
            plain(peak.t_s, 4),
            by.map_or_else(|| "penetration".to_owned(), |name| format!("deflection of {name}")),
            significant(peak.contact.depth_m, 3)
        ),
        frame,
        outlines: outlines.collect(),
        fenders: boxes(outcome, &peak.deflections_m, shown),
        harbour: Harbour::default(),
        tracks: Vec::new(),
        arrows: vec![arrow],
        labels: names(outcome, shown).into_iter().chain(labels).collect(),
        note: format!(
            "N is the force on {}{}: a mean over the time step. The {} that is shown is that at the \
             start of the step. The tables have the peaks within steps.",
            bodies[1].name,
            // A fender of a dolphin often has the dolphin's name.
            by.filter(|name| *name != bodies[1].name)
                .map_or_else(String::new, |name| format!(" through {name}")),
            if by.is_some() { "deflection" } else { "penetration" },
        ),
    }
    .render()
}
