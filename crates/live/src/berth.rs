//! The berth: a line through the fenders of a quay or of another ship; distances and speeds of a ship relative to it.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Outline, Rotation, Vec2, vec2};
use fenderline_sim::Setup;

use crate::approach::Light;
use crate::cast::Cast;
use crate::info::pair;
use crate::message::{BerthEnd, BerthInfo, BerthNow, Lamp};

/// Fenders of one berth face the same direction to within this angle (rad).
const SAME_WAY_RAD: f64 = 0.1;
/// The flat of a ship's side is where her half breadth is at least this share of the greatest one.
const FLAT: f64 = 0.98;

/// A straight line through fender faces, in the frame of the body that carries them: a quay or another ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Berth {
    /// Index of that body.
    pub body: usize,
    /// One end of the line (m).
    pub from_m: Vec2,
    /// The other end (m).
    pub to_m: Vec2,
    /// Unit normal towards the water.
    pub facing: Vec2,
    /// Mean distance between neighbouring fenders (m); `None` for a single fender.
    pub apart_m: Option<f64>,
}

/// The two ends of the flat of a ship's side towards the berth.
pub(crate) struct Ends {
    /// Positions of the ends at bow and stern (m).
    pub(crate) at_m: [Vec2; 2],
    /// Distance of each end along the berth from `from_m` (m).
    pub(crate) along_m: [f64; 2],
    /// Length of the berth (m).
    pub(crate) length_m: f64,
}

impl Berth {
    /// The berth with the most fenders; among equals, the one nearest to the pilot's own ship at the start. Fenders on the
    /// own ship and on tugs do not count. `None` without a ship or without such fenders.
    #[must_use]
    pub fn of(setup: &Setup, cast: &Cast) -> Option<Berth> {
        let vessels = &setup.world.vessels;
        let own = vessels[cast.own?].body;
        let is_tug = |body: usize| {
            vessels.iter().zip(&cast.is_tug).any(|(vessel, &tug)| tug && vessel.body == body)
        };
        let faces: Vec<Face> = setup
            .fenders
            .iter()
            .filter(|fender| fender.body != own && !is_tug(fender.body))
            .map(|fender| Face {
                body: fender.body,
                at_m: fender.position_m + towards(fender.facing_rad) * fender.projection_m,
                facing_rad: fender.facing_rad,
            })
            .collect();
        let mut best: Option<(usize, f64, Berth)> = None;
        for face in &faces {
            let row: Vec<Vec2> =
                faces.iter().filter(|f| f.is_beside(face)).map(|f| f.at_m).collect();
            let berth = Berth::through(face.body, &row, towards(face.facing_rad));
            let on = &setup.bodies[face.body];
            let middle_m = (berth.from_m + berth.to_m) * 0.5;
            let middle_m = on.position_m + Rotation::from_angle(on.heading_rad).apply(middle_m);
            let off_m = (middle_m - setup.bodies[own].position_m).length();
            let better = best.as_ref().is_none_or(|(count, least_m, _)| {
                row.len() > *count || row.len() == *count && off_m < *least_m
            });
            if better {
                best = Some((row.len(), off_m, berth));
            }
        }
        best.map(|(.., berth)| berth)
    }

    /// The line along a row of fenders, from the first to the last, through the face farthest out.
    fn through(body: usize, faces: &[Vec2], facing: Vec2) -> Berth {
        let along = facing.quarter_turn();
        let out_m = faces.iter().map(|at| at.dot(facing)).fold(f64::NEG_INFINITY, greater);
        let ways = faces.iter().map(|at| at.dot(along));
        let (least, most) = ways.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), way| {
            (lesser(least, way), greater(most, way))
        });
        let at = |way: f64| facing * out_m + along * way;
        let apart_m = (faces.len() > 1).then(|| (most - least) / (faces.len() - 1) as f64);
        Berth { body, from_m: at(least), to_m: at(most), facing, apart_m }
    }

    /// The message to pages.
    #[must_use]
    pub fn info(&self) -> BerthInfo {
        let [from, to, facing] = [self.from_m, self.to_m, self.facing].map(pair);
        BerthInfo { body: self.body, from, to, facing }
    }

    /// The ends of the ship's side towards the berth.
    pub(crate) fn ends(&self, on: &BodyState, outline: &Outline, state: &BodyState) -> Ends {
        let attitude = Rotation::from_angle(state.heading_rad);
        let quay = Rotation::from_angle(on.heading_rad);
        // The berth is to starboard where its water side faces her port.
        let starboard = attitude.apply_inverse(quay.apply(self.facing)).y <= 0.0;
        let at_m = flat_of_side(outline, starboard).map(|at| state.position_m + attitude.apply(at));
        let along = self.facing.quarter_turn();
        let way = |at: Vec2| (quay.apply_inverse(at - on.position_m) - self.from_m).dot(along);
        Ends { at_m, along_m: at_m.map(way), length_m: (self.to_m - self.from_m).dot(along) }
    }

    /// A ship relative to the berth on a body in state `on`: distances of the two ends of the flat of her side towards the
    /// berth, positive off the fenders; the closing speeds of these ends, positive towards the berth; her speed along the
    /// berth, positive ahead; the angle between her and the berth, positive with the bow nearer. The docking board fills in
    /// lamps, limit and what each end is at.
    pub(crate) fn seen_from(
        &self,
        on: &BodyState,
        outline: &Outline,
        state: &BodyState,
    ) -> BerthNow {
        let attitude = Rotation::from_angle(state.heading_rad);
        let quay = Rotation::from_angle(on.heading_rad);
        let facing = quay.apply(self.facing);
        // The berth is to starboard where its water side faces her port.
        let starboard = attitude.apply_inverse(facing).y <= 0.0;
        let [bow, stern] = flat_of_side(outline, starboard);
        let from_m = on.position_m + quay.apply(self.from_m);
        let off_m = |at: Vec2| (state.position_m + attitude.apply(at) - from_m).dot(facing);
        // Relative to the moving body of the berth.
        let velocity_mps = |at: Vec2| {
            let arm_m = state.position_m + attitude.apply(at) - on.position_m;
            let ours = state.velocity_mps + attitude.apply(at).spun_by(state.yaw_rate_radps);
            ours - on.velocity_mps - arm_m.spun_by(on.yaw_rate_radps)
        };
        let closing_mps = |at: Vec2| -velocity_mps(at).dot(facing);
        let (bow_m, stern_m) = (off_m(bow), off_m(stern));
        let length_m = (bow - stern).length();
        BerthNow {
            bow: BerthEnd::Off,
            stern: BerthEnd::Off,
            limit_mps: 0.0,
            bow_lamp: Lamp { light: Light::Ok, text: "" },
            stern_lamp: Lamp { light: Light::Ok, text: "" },
            bow_m,
            stern_m,
            bow_mps: closing_mps(bow),
            stern_mps: closing_mps(stern),
            along_mps: velocity_mps(Vec2::ZERO).dot(attitude.apply(vec2(1.0, 0.0))),
            angle_rad: libm::asin(bounded((stern_m - bow_m) / length_m, -1.0, 1.0)),
        }
    }

    /// True if some part of the ship is abreast of the berth and her origin is within a distance of its line.
    pub(crate) fn is_near(
        &self,
        on: &BodyState,
        outline: &Outline,
        state: &BodyState,
        within_m: f64,
    ) -> bool {
        let along = self.facing.quarter_turn();
        let quay = Rotation::from_angle(on.heading_rad);
        let middle = quay.apply_inverse(state.position_m - on.position_m) - self.from_m;
        let length_m = (self.to_m - self.from_m).dot(along);
        let reach_m = outline.radius_m();
        let way_m = middle.dot(along);
        let off_m = middle.dot(self.facing);
        way_m > -reach_m && way_m < length_m + reach_m && off_m > -reach_m && off_m < within_m
    }
}

/// The face of a fender, in the frame of the body that it is on.
struct Face {
    body: usize,
    at_m: Vec2,
    facing_rad: f64,
}

impl Face {
    /// True if both belong to one berth: on the same body, facing the same direction.
    fn is_beside(&self, other: &Face) -> bool {
        let between_rad =
            libm::remainder(self.facing_rad - other.facing_rad, core::f64::consts::TAU);
        self.body == other.body && libm::fabs(between_rad) < SAME_WAY_RAD
    }
}

fn towards(angle_rad: f64) -> Vec2 {
    vec2(libm::cos(angle_rad), libm::sin(angle_rad))
}

/// The fore and after end of the flat of a side, in the body's frame. For a hull without a flat side: one third of the length
/// from either end.
fn flat_of_side(outline: &Outline, starboard: bool) -> [Vec2; 2] {
    let sign = if starboard { 1.0 } else { -1.0 };
    let (least, most) = outline.bounds();
    let half_m = if starboard { most.y } else { -least.y };
    let wide = |at: &&Vec2| sign * at.y >= FLAT * half_m;
    let mut ends: Option<[Vec2; 2]> = None;
    for &at in outline.vertices().iter().filter(wide) {
        let [bow, stern] = ends.unwrap_or([at, at]);
        ends = Some([if at.x > bow.x { at } else { bow }, if at.x < stern.x { at } else { stern }]);
    }
    let third_m = (most.x - least.x) / 3.0;
    match ends {
        Some([bow, stern]) if bow.x - stern.x > 0.1 * (most.x - least.x) => [bow, stern],
        _ => [vec2(most.x - third_m, sign * half_m), vec2(least.x + third_m, sign * half_m)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ship() -> Outline {
        let points = [
            vec2(-50.0, -8.0),
            vec2(-40.0, -10.0),
            vec2(30.0, -10.0),
            vec2(50.0, 0.0),
            vec2(30.0, 10.0),
            vec2(-40.0, 10.0),
            vec2(-50.0, 8.0),
        ];
        Outline::new(&points).expect("a hull").0
    }

    #[test]
    fn distances_speeds_and_angle_are_those_of_the_flat_of_the_side() {
        // A quay to the east of her; she lies 5 m off, her bow 0.1 rad in, and turns in.
        let quay = BodyState::default();
        let berth = Berth {
            body: 1,
            from_m: vec2(-60.0, 30.0),
            to_m: vec2(60.0, 30.0),
            facing: vec2(0.0, -1.0),
            apart_m: None,
        };
        let state = BodyState {
            position_m: vec2(0.0, 10.0),
            heading_rad: 0.1,
            velocity_mps: vec2(0.0, 0.2),
            yaw_rate_radps: 0.002,
        };
        let now = berth.seen_from(&quay, &ship(), &state);
        let (sin, cos) = (libm::sin(0.1), libm::cos(0.1));
        let off = |x: f64| 30.0 - (10.0 + x * sin + 10.0 * cos);
        assert!((now.bow_m - off(30.0)).abs() < 1e-12 && (now.stern_m - off(-40.0)).abs() < 1e-12);
        assert!((now.angle_rad - 0.1).abs() < 1e-12);
        // East speed of a point at (x, y): v + r times its northing from the centre.
        let speed = |x: f64| 0.2 + 0.002 * (x * cos - 10.0 * sin);
        assert!((now.bow_mps - speed(30.0)).abs() < 1e-12);
        assert!((now.stern_mps - speed(-40.0)).abs() < 1e-12);
        // Turned round she has her port side to it, and her bow is the farther end.
        let turned = BodyState { heading_rad: 0.1 + core::f64::consts::PI, ..state };
        let now = berth.seen_from(&quay, &ship(), &turned);
        assert!((now.bow_m - off(-30.0)).abs() < 1e-9 && (now.angle_rad + 0.1).abs() < 1e-9);
        assert!(berth.is_near(&quay, &ship(), &state, 100.0));
        assert!(!berth.is_near(&quay, &ship(), &state, 10.0));
    }

    #[test]
    fn a_berth_on_a_ship_that_moves_is_seen_from_that_ship() {
        // The larger one heads east at 2 m/s and turns; the smaller one keeps her place on her, and drifts in.
        let mother = BodyState {
            position_m: vec2(500.0, 200.0),
            heading_rad: core::f64::consts::FRAC_PI_2,
            velocity_mps: vec2(0.0, 2.0),
            yaw_rate_radps: 0.01,
        };
        let berth = Berth {
            body: 0,
            from_m: vec2(-50.0, -25.0),
            to_m: vec2(50.0, -25.0),
            facing: vec2(0.0, -1.0),
            apart_m: None,
        };
        // 15 m of water between the fenders at her port side and the other's starboard side.
        let arm_m = vec2(50.0, 0.0);
        let state = BodyState {
            position_m: mother.position_m + arm_m,
            velocity_mps: mother.velocity_mps + arm_m.spun_by(0.01) + vec2(-0.1, 0.3),
            ..mother
        };
        let now = berth.seen_from(&mother, &ship(), &state);
        assert!((now.bow_m - 15.0).abs() < 1e-9 && (now.stern_m - 15.0).abs() < 1e-9, "{now:?}");
        assert!((now.bow_mps - 0.1).abs() < 1e-9 && (now.stern_mps - 0.1).abs() < 1e-9, "{now:?}");
        assert!((now.along_mps - 0.3).abs() < 1e-9 && now.angle_rad.abs() < 1e-9, "{now:?}");
        assert!(berth.is_near(&mother, &ship(), &state, 50.0));
    }
}
