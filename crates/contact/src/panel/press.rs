//! Computes the force of a hull on a panel, and the deflections of the panel's cones.

use alloc::vec::Vec;

use crate::maths::number::{bounded, greater};
use crate::maths::vec2::{Vec2, vec2};
use crate::panel::Panel;
use crate::panel::chains::ChainState;
use crate::panel::law::{PanelLaw, Springs};
use crate::panel::least::{self, Pose};
use crate::panel::touching::{HullPoint, Reach, collect};

/// Buffers and result of the last press on a panel.
#[derive(Clone, Debug, Default)]
pub(crate) struct PanelPress {
    points: Vec<HullPoint>,
    /// State of the panel's chains, to be used for the next press.
    pub(crate) state: ChainState,
    pub(crate) pressed: Pressed,
}

/// A panel on which a hull presses: motion, forces and energy, not yet multiplied by the fender's factors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pressed {
    /// Deflection d of the panel's middle (m), and turn θ of the panel (rad).
    pub(crate) middle_m: f64,
    pub(crate) tilt: f64,
    /// Deflection δ of each cone (m).
    pub(crate) deflections_m: [f64; Panel::MOST_CONES],
    /// The largest deflection of a cone (m).
    pub(crate) deepest_m: f64,
    /// Force of the hull on the panel in the frame of the face (N), and the moment of this force about the middle of
    /// the undeflected face, positive from x to y (N·m).
    pub(crate) force_n: Vec2,
    pub(crate) torque_nm: f64,
    /// Share of the cones' stops in the reaction of the panel.
    pub(crate) stop_share: f64,
    /// Tension of each chain (N).
    pub(crate) tensions_n: [f64; Panel::MOST_CHAINS],
    /// Moment Σ R x of the forces of cones and chains about the middle of the panel (N·m).
    pub(crate) moment_nm: f64,
    pub(crate) energy_j: f64,
}

impl PanelPress {
    /// Presses a panel with a hull that has these edges; `to_face` transforms the edges into the frame of the face.
    pub(crate) fn press(
        &mut self,
        law: &PanelLaw,
        edges: impl Iterator<Item = [Vec2; 2]>,
        to_face: impl Fn(Vec2) -> Vec2,
        reach: Reach,
    ) -> &Pressed {
        let PanelPress { points, .. } = self;
        points.clear();
        collect(edges, to_face, reach, |point| points.push(point));
        if points.is_empty() {
            // The hull covers the whole zone, so it is pushed out along the axis.
            let ends = [-reach.half_width_m, reach.half_width_m];
            points.extend(ends.map(|y| HullPoint { at: vec2(reach.far_m, y), side: None }));
        }
        let springs = Springs { law, state: self.state };
        self.pressed = match least::pose(springs, &self.points) {
            Some(pose) => pressed(springs, &self.points, &pose),
            None => Pressed::default(),
        };
        &self.pressed
    }
}

/// Depth of the deepest point of a hull behind the face (m); 0 if the hull does not reach behind the face.
pub(crate) fn deepest_m(
    edges: impl Iterator<Item = [Vec2; 2]>,
    to_face: impl Fn(Vec2) -> Vec2,
    reach: Reach,
) -> f64 {
    let mut deepest_m = 0.0;
    collect(edges, to_face, reach, |point| deepest_m = greater(deepest_m, point.at.x));
    deepest_m
}

/// Computes force, deflections and moment of the panel in a pose.
fn pressed(springs: Springs<'_>, points: &[HullPoint], pose: &Pose) -> Pressed {
    let (law, state) = (springs.law, springs.state);
    let mut tensions_n = [0.0; Panel::MOST_CHAINS];
    let mut deflections_m = [0.0; Panel::MOST_CONES];
    let (mut deepest_m, mut force_n, mut moment_nm, mut stop_n) = (0.0, 0.0, 0.0, 0.0);
    for (&place_m, deflection_m) in law.places_m.iter().zip(&mut deflections_m) {
        *deflection_m = pose.middle_m + pose.tilt * place_m;
        let (reaction_n, _) = law.cone.at(*deflection_m);
        force_n += reaction_n;
        moment_nm += reaction_n * place_m;
        deepest_m = greater(deepest_m, *deflection_m);
        stop_n += law
            .stop
            .map_or(0.0, |stop| stop.stiffness_npm * greater(*deflection_m - stop.from_m, 0.0));
    }
    for (index, (chain, tension_n)) in law.chains.iter().zip(&mut tensions_n).enumerate() {
        if state.parted & (1 << index) != 0 {
            continue;
        }
        *tension_n = greater(-chain.line.at(pose.middle_m + pose.tilt * chain.at_m).0, 0.0);
        force_n -= state.scale * *tension_n;
        moment_nm -= state.scale * *tension_n * chain.at_m;
    }
    let force_n = greater(force_n, 0.0);
    let (mut push_n, mut torque_nm) = (Vec2::ZERO, 0.0);
    let mut add = |index: usize, share_n: f64| {
        let HullPoint { at, side } = points[index];
        // There is no friction here, so the force is perpendicular to the hull's side, or to the panel.
        let own_n = vec2(share_n, -share_n * side.unwrap_or(pose.tilt));
        push_n += own_n;
        torque_nm += at.cross(own_n);
    };
    match pose.on {
        (only, None) => add(only, force_n),
        (left, Some(right)) => {
            let (left_m, right_m) = (points[left].at.y, points[right].at.y);
            let on_right_n = (moment_nm - force_n * left_m) / (right_m - left_m);
            let on_right_n = bounded(on_right_n, 0.0, force_n);
            add(left, force_n - on_right_n);
            add(right, on_right_n);
        }
    }
    Pressed {
        middle_m: pose.middle_m,
        tilt: pose.tilt,
        deflections_m,
        deepest_m,
        force_n: push_n,
        torque_nm,
        stop_share: if force_n > 0.0 { stop_n / force_n } else { 0.0 },
        tensions_n,
        moment_nm,
        energy_j: pose.energy_j,
    }
}
