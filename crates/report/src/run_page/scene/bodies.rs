//! Bodies in a plan view: their outlines, colours and names, and the frame around them.

use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_sim::{BodySetup, Setup};

use crate::plot::{Frame, Label, Outlined, Place, Stage, shortened};

/// Longest name in a plan view (characters).
pub(super) const NAME_LENGTH: usize = 26;

/// The outline of a body for drawing; without vertices for the shore, which the chart draws.
pub(super) fn outlined(
    body: &BodySetup,
    state: &BodyState,
    stage: Stage,
    style: usize,
) -> Outlined {
    let pose = state.pose();
    let drawn = if body.outline.is_of_parts() { &[] } else { body.outline.vertices() };
    let vertices_m = drawn.iter().map(|v| pose.apply(*v)).collect();
    Outlined { vertices_m, stage, style }
}

/// The outlines of a body within a frame: those rings of a shore that come into the frame, or the one outline of another
/// body.
pub(super) fn outlined_in(
    frame: Frame,
    body: &BodySetup,
    state: &BodyState,
    stage: Stage,
    style: usize,
) -> Vec<Outlined> {
    if !body.outline.is_of_parts() {
        return vec![outlined(body, state, stage, style)];
    }
    let pose = state.pose();
    let rings = body.outline.rings().map(|ring| ring.iter().map(|v| pose.apply(*v)));
    let comes_in = |of: &Frame| {
        of.low.x <= frame.high.x
            && of.low.y <= frame.high.y
            && of.high.x >= frame.low.x
            && of.high.y >= frame.low.y
    };
    let near = rings.filter(|ring| Frame::around(ring.clone()).as_ref().is_some_and(comes_in));
    near.map(|ring| Outlined { vertices_m: ring.collect(), stage, style }).collect()
}

/// Number of the colour of each body: floating bodies take the colours in the order of the scenario.
pub(super) fn styles(setup: &Setup) -> Vec<usize> {
    let mut next = 0;
    let styles = setup.bodies.iter().map(|body| {
        let style = next;
        next += usize::from(body.mass.is_some());
        style
    });
    styles.collect()
}

pub(super) fn joined(a: Option<Frame>, b: Option<Frame>) -> Option<Frame> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.with(b)),
        (a, b) => a.or(b),
    }
}

/// The label with a body's name, which stands on the body.
pub(super) fn body_label(body: &BodySetup, state: &BodyState) -> Label {
    let (low, high) = body.outline.bounds();
    let half = (high - low) * 0.5;
    let half_length = if half.x >= half.y { vec2(half.x, 0.0) } else { vec2(0.0, half.y) };
    Label {
        text: shortened(&body.name, NAME_LENGTH),
        place: Place::On {
            middle_m: middle(body, state),
            half_length_m: state.pose().rotation.apply(half_length),
        },
    }
}

/// The middle of a body's outline, earth-fixed (m).
pub(super) fn middle(body: &BodySetup, state: &BodyState) -> Vec2 {
    let (low, high) = body.outline.bounds();
    state.pose().apply((low + high) * 0.5)
}
