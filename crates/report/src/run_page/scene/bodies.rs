//! Bodies in a plan view: their outlines, colours and names, and the frame around them.

use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_sim::{BodySetup, Setup};

use crate::plot::{Frame, Label, Outlined, Place, Stage, shortened};

/// Longest name in a plan view (characters).
pub(super) const NAME_LENGTH: usize = 26;

pub(super) fn outlined(
    body: &BodySetup,
    state: &BodyState,
    stage: Stage,
    style: usize,
) -> Outlined {
    let pose = state.pose();
    let vertices_m = body.outline.vertices().iter().map(|v| pose.apply(*v)).collect();
    Outlined { vertices_m, stage, style }
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
