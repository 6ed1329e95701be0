//! Computes the force of a hull on a fender's face as the gradient of the stored energy.
//!
//! In the frame of the fender's face, x runs from the face inwards and s along the face. d(s) is the depth of the hull
//! behind the face at s, and A is the overlap of hull and fender. The stored energy U has one of two forms, each of
//! which needs one integral over the overlap A:
//!
//! - U = E(S/w), for a fender of width w with a reaction curve R = E', where S is the area of the overlap A. A
//!   displacement of the hull changes the area by ∂S = ∮ n·∂r over the hull's part of A's boundary. As ∮ n over the
//!   whole boundary is 0, ∂S is minus the integral over the fender's own sides. The fender's own sides are straight
//!   lines along the axes, so the integral has a closed form.
//! - U = ½ k ∫ d² ds = k ∬ x dA, for an elastic foundation. The force of an elastic foundation follows in the same way
//!   from the identity ∮ x n = (S, 0).
//!
//! The method needs only the overlap's outline, not the hull's shape, and the force is exactly conservative for any
//! hull. The simpler form (N = kS along the face's normal, through the centroid) lacks the lateral part ½k·Δ(d²) at the
//! ends of the face. With the simpler form, sliding along a tilted hull would create energy.

use crate::maths::angle::tilt_rad;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::{Pose, Vec2, vec2};
use crate::model::fender::{Fender, RankedFender};
use crate::model::reaction::FenderLaw;
use crate::panel::press::Pressed;
use crate::touch::face_frame::Frame;

/// A corner nearer than this to a side of the fender's zone counts as on the side (m). Crossings of outlines are
/// computed with an error of about 1e-12 m.
const ON_SIDE_M: f64 = 1e-9;

/// Smallest area of an overlap with a meaningful centroid (m²), and smallest force with a meaningful line of action
/// (N): for smaller values both would be quotients of rounding errors.
const SMALLEST_AREA_M2: f64 = 1e-18;
const SMALLEST_FORCE_N: f64 = 1e-6;

/// How a hull presses on a fender: force, deflection and energy, not yet multiplied by the fender's factors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Press {
    /// Direction in which the hull pushes the fender, and a point on the line of the force. Direction and point of the
    /// force are in the frame in which the outline is given.
    pub(crate) push: Vec2,
    pub(crate) point_m: Vec2,
    /// The two parts of the force along `push`: spring and stop (N).
    pub(crate) spring_n: f64,
    pub(crate) stop_n: f64,
    /// Deflection δ (m).
    pub(crate) deflection_m: f64,
    /// Energy stored in the fender's spring and stop (J).
    pub(crate) stored_j: f64,
    /// Growth of the overlap's area per metre of the hull's displacement along `push` (m).
    pub(crate) chord_m: f64,
    /// Angle between hull and face (rad).
    pub(crate) tilt_rad: f64,
}

/// Integrals over those sides of the overlap that are the fender's own sides, in the frame of the face.
#[derive(Clone, Copy, Debug, Default)]
struct Integrals {
    /// Largest x.
    depth: f64,
    /// Derivatives of the area S and of the moment ∬x dA with respect to the hull's displacement along x and s, and to
    /// its rotation about the middle of the face.
    of_area: [f64; 3],
    of_moment: [f64; 3],
}

impl Frame {
    /// Computes the integrals of an overlap with this area and centroid, and the centroid in the frame of the fender's
    /// face.
    // Inlined: a call costs a twelfth of a step of a ship at eight faces.
    #[inline(always)]
    fn integrals<'a>(
        self,
        width_m: f64,
        (area_m2, centroid_m): (f64, Vec2),
        outlines: impl Iterator<Item = &'a [Vec2]>,
    ) -> (Integrals, Vec2) {
        let mut sums = Integrals::default();
        for outline in outlines {
            let corner = |&v: &Vec2| Corner::new(self.to_face(v), 0.5 * width_m);
            let Some((first, others)) = outline.split_first() else { continue };
            let first = corner(first);
            let mut from = first;
            for to in others.iter().map(corner) {
                sums.add(&from, &to);
                from = to;
            }
            sums.add(&from, &first);
        }
        // If the centroid is not meaningful, the middle of the face is used.
        let is_meaningful = area_m2 > SMALLEST_AREA_M2;
        let centroid = if is_meaningful { self.to_face(centroid_m) } else { Vec2::ZERO };
        sums.complete(area_m2, centroid * area_m2);
        (sums, centroid)
    }
}

/// Computes how the hull presses on the fender in a patch with this area and centroid. `outlines` are the outlines of
/// the patch's overlaps, in a frame in which the fender's body has the pose `host`.
pub(crate) fn press<'a>(
    ranked: &RankedFender,
    fender: &Fender,
    stiffness_npm2: f64,
    host: Pose,
    within: (f64, Vec2),
    outlines: impl Iterator<Item = &'a [Vec2]>,
) -> Press {
    let frame = Frame::of(ranked.inward, ranked.face_m, host);
    let (sums, centroid) = frame.integrals(ranked.width_m, within, outlines);
    let area_m2 = within.0;
    let moment = centroid * area_m2;
    let mean_m = area_m2 / ranked.width_m;
    let (spring, spring_j, deflection_m) = match fender.law {
        FenderLaw::Area => {
            let g = sums.of_moment.map(|d| stiffness_npm2 * d);
            (g, stiffness_npm2 * moment.x, sums.depth)
        }
        FenderLaw::Curve(_) => {
            let per_area = fender.law.reaction_n(mean_m) / ranked.width_m;
            (sums.of_area.map(|d| per_area * d), fender.law.energy_j(mean_m), mean_m)
        }
    };
    let past_m = fender.stop.map_or(0.0, |stop| greater(mean_m - stop.from_m, 0.0));
    let stop_npm = fender.stop.map_or(0.0, |stop| stop.stiffness_npm);
    let per_area = stop_npm * past_m / ranked.width_m;
    let stop = sums.of_area.map(|d| per_area * d);
    let pushed = vec2(spring[0] + stop[0], spring[1] + stop[1]);
    let torque = spring[2] + stop[2];
    let size_n = pushed.length();
    let (push, point) = line_of_action(pushed, size_n, torque, centroid);
    let stop_n = vec2(stop[0], stop[1]).dot(push);
    Press {
        push: frame.turned(push),
        point_m: frame.face_m + frame.turned(point),
        spring_n: size_n - stop_n,
        stop_n,
        deflection_m,
        stored_j: spring_j + 0.5 * stop_npm * past_m * past_m,
        chord_m: vec2(sums.of_area[0], sums.of_area[1]).dot(push),
        tilt_rad: tilt_rad(sums.of_area[1].abs(), greater(sums.of_area[0], 0.0)),
    }
}

/// Does the same as [`press`] for a fender with a panel, on which the whole hull presses.
pub(crate) fn press_panel<'a>(
    ranked: &RankedFender,
    pressed: &Pressed,
    host: Pose,
    within: (f64, Vec2),
    outlines: impl Iterator<Item = &'a [Vec2]>,
) -> Press {
    let frame = Frame::of(ranked.inward, ranked.face_m, host);
    let (sums, centroid) = frame.integrals(ranked.width_m, within, outlines);
    let size_n = pressed.force_n.length();
    let (push, point) = line_of_action(pressed.force_n, size_n, pressed.torque_nm, centroid);
    let stop_n = size_n * pressed.stop_share;
    Press {
        push: frame.turned(push),
        point_m: frame.face_m + frame.turned(point),
        spring_n: size_n - stop_n,
        stop_n,
        deflection_m: pressed.deepest_m,
        stored_j: pressed.energy_j,
        chord_m: vec2(sums.of_area[0], sums.of_area[1]).dot(push),
        tilt_rad: tilt_rad(push.y.abs(), greater(push.x, 0.0)),
    }
}

/// For a force of this size with this torque about the face's middle: the direction of the force, and the point of its
/// line that is nearest to the centroid.
#[inline(always)]
fn line_of_action(force_n: Vec2, size_n: f64, torque_nm: f64, centroid_m: Vec2) -> (Vec2, Vec2) {
    if size_n > SMALLEST_FORCE_N {
        let off = (centroid_m.cross(force_n) - torque_nm) / (size_n * size_n);
        (force_n * (1.0 / size_n), centroid_m + force_n.quarter_turn() * off)
    } else {
        // A hull wholly within the zone has no energy gradient: the force pushes it out along the axis.
        (vec2(1.0, 0.0), centroid_m)
    }
}

/// A corner of an outline in the frame of the fender's face, and the fender's own sides on which the corner lies.
// The far end of the zone does not count as a side: a hull that deep is still pushed out.
#[derive(Clone, Copy, Debug)]
struct Corner {
    at: Vec2,
    sides: u8,
}

impl Corner {
    const FACE: u8 = 1;
    const RIGHT: u8 = 2;
    const LEFT: u8 = 4;

    #[inline(always)]
    fn new(at: Vec2, half_width_m: f64) -> Corner {
        // Every corner is within the zone.
        let lies_on = |off_m: f64, side: u8| u8::from(off_m <= ON_SIDE_M) * side;
        let sides = lies_on(at.x, Corner::FACE)
            | lies_on(half_width_m - at.y, Corner::RIGHT)
            | lies_on(half_width_m + at.y, Corner::LEFT);
        Corner { at, sides }
    }
}

impl Integrals {
    /// Adds one edge of an outline to the integrals. The edges of the outline must be added in the positive sense of
    /// turning.
    #[inline(always)]
    fn add(&mut self, Corner { at: from, sides }: &Corner, to: &Corner) {
        let (both, to) = (sides & to.sides, to.at);
        self.depth = greater(self.depth, to.x);
        if both & Corner::FACE != 0 {
            // The edge lies on the face: outward normal −x.
            let (length, middle) = (from.y - to.y, 0.5 * (from.y + to.y));
            self.of_area[0] += length;
            self.of_area[2] -= middle * length;
        } else if both != 0 {
            let outward = if both & Corner::RIGHT != 0 { 1.0 } else { -1.0 };
            self.side(lesser(from.x, to.x), greater(from.x, to.x), outward);
        }
    }

    /// Subtracts the integrals over a segment of a lateral side of the fender, whose outward normal is ±s.
    fn side(&mut self, low: f64, high: f64, outward: f64) {
        let squares = 0.5 * (high * high - low * low);
        let cubes = (high * high * high - low * low * low) * (1.0 / 3.0);
        self.of_area[1] -= outward * (high - low);
        self.of_area[2] -= outward * squares;
        self.of_moment[1] -= outward * squares;
        self.of_moment[2] -= outward * cubes;
    }

    /// Adds the terms of the whole outline to the integrals. `area` is the area of the outline, and `moment` its
    /// moments ∬ x dA and ∬ s dA.
    fn complete(&mut self, area: f64, moment: Vec2) {
        self.of_moment[0] += area;
        self.of_moment[2] -= moment.y;
    }
}
