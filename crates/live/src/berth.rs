//! The berth: the line of a quay's fenders, and how a ship lies to it.

use fenderline_contact::{BodyState, Outline, Rotation, Vec2, vec2};
use fenderline_sim::Setup;

use crate::cast::Cast;
use crate::info::pair;
use crate::message::{BerthInfo, BerthNow};

/// Fenders belong to one berth where they face the same way to within this angle [rad].
const SAME_WAY_RAD: f64 = 0.1;
/// The flat of a ship's side: where she is at least this part of her greatest half breadth.
const FLAT: f64 = 0.98;

/// A straight line through fender faces on something that is fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Berth {
    /// One end of it, earth-fixed [m].
    pub from_m: Vec2,
    /// The other.
    pub to_m: Vec2,
    /// Unit vector to where the water is.
    pub facing: Vec2,
}

impl Berth {
    /// The berth with the most fenders; of those with as many, the one that is nearest to the pilot's own ship at the
    /// start. `None` where nothing fixed has fenders, or there is no ship.
    #[must_use]
    pub fn of(setup: &Setup, cast: &Cast) -> Option<Berth> {
        let own = &setup.bodies[setup.world.vessels[cast.own?].body];
        let mut faces: Vec<(Vec2, f64)> = Vec::new();
        for fender in &setup.fenders {
            let on = &setup.bodies[fender.body];
            if on.mass.is_some() {
                continue;
            }
            let facing_rad = on.heading_rad + fender.facing_rad;
            let mounted =
                on.position_m + Rotation::from_angle(on.heading_rad).apply(fender.position_m);
            faces.push((mounted + towards(facing_rad) * fender.projection_m, facing_rad));
        }
        let mut best: Option<(usize, f64, Berth)> = None;
        for &(_, facing_rad) in &faces {
            let facing = towards(facing_rad);
            let same = |other_rad: f64| {
                libm::fabs(libm::remainder(other_rad - facing_rad, core::f64::consts::TAU))
                    < SAME_WAY_RAD
            };
            let own_row: Vec<Vec2> =
                faces.iter().filter(|(_, other)| same(*other)).map(|(at, _)| *at).collect();
            let berth = Berth::through(&own_row, facing);
            let off_m = ((berth.from_m + berth.to_m) * 0.5 - own.position_m).length();
            let better = best.as_ref().is_none_or(|(count, least_m, _)| {
                own_row.len() > *count || own_row.len() == *count && off_m < *least_m
            });
            if better {
                best = Some((own_row.len(), off_m, berth));
            }
        }
        best.map(|(.., berth)| berth)
    }

    /// Through the faces that stand out farthest, from the first to the last of the row.
    fn through(faces: &[Vec2], facing: Vec2) -> Berth {
        let along = facing.quarter_turn();
        let out_m = faces.iter().map(|at| at.dot(facing)).fold(f64::NEG_INFINITY, f64::max);
        let ways = faces.iter().map(|at| at.dot(along));
        let (least, most) = ways.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), way| {
            (least.min(way), most.max(way))
        });
        let at = |way: f64| facing * out_m + along * way;
        Berth { from_m: at(least), to_m: at(most), facing }
    }

    /// As pages are told.
    #[must_use]
    pub fn info(&self) -> BerthInfo {
        BerthInfo { from: pair(self.from_m), to: pair(self.to_m), facing: pair(self.facing) }
    }

    /// How a ship lies to it: distances of the two ends of the flat of her side, on the side that the berth is on,
    /// positive off the fenders; the speeds of these ends, positive towards the berth; the angle between her and the
    /// berth, positive with the bow nearer.
    pub(crate) fn seen_from(&self, outline: &Outline, state: &BodyState) -> BerthNow {
        let attitude = Rotation::from_angle(state.heading_rad);
        // The berth is to starboard where its water side faces her port.
        let starboard = attitude.apply_inverse(self.facing).y <= 0.0;
        let [bow, stern] = flat_of_side(outline, starboard);
        let off_m =
            |at: Vec2| (state.position_m + attitude.apply(at) - self.from_m).dot(self.facing);
        let closing_mps = |at: Vec2| {
            let velocity = state.velocity_mps + attitude.apply(at).spun_by(state.yaw_rate_radps);
            -velocity.dot(self.facing)
        };
        let (bow_m, stern_m) = (off_m(bow), off_m(stern));
        let length_m = (bow - stern).length();
        BerthNow {
            bow_m,
            stern_m,
            bow_mps: closing_mps(bow),
            stern_mps: closing_mps(stern),
            angle_rad: libm::asin(((stern_m - bow_m) / length_m).clamp(-1.0, 1.0)),
        }
    }

    /// Is any of a ship abreast of it, and her middle within a distance of its line?
    pub(crate) fn is_near(&self, outline: &Outline, state: &BodyState, within_m: f64) -> bool {
        let along = self.facing.quarter_turn();
        let middle = state.position_m - self.from_m;
        let length_m = (self.to_m - self.from_m).dot(along);
        let reach_m = outline.radius_m();
        let way_m = middle.dot(along);
        let off_m = middle.dot(self.facing);
        way_m > -reach_m && way_m < length_m + reach_m && off_m > -reach_m && off_m < within_m
    }
}

fn towards(angle_rad: f64) -> Vec2 {
    vec2(libm::cos(angle_rad), libm::sin(angle_rad))
}

/// The fore and after end of the flat of a side, in the body's frame. A hull without one has them at one third of
/// her length from either end, where her side is there.
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
        let berth =
            Berth { from_m: vec2(-60.0, 30.0), to_m: vec2(60.0, 30.0), facing: vec2(0.0, -1.0) };
        let state = BodyState {
            position_m: vec2(0.0, 10.0),
            heading_rad: 0.1,
            velocity_mps: vec2(0.0, 0.2),
            yaw_rate_radps: 0.002,
        };
        let now = berth.seen_from(&ship(), &state);
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
        let now = berth.seen_from(&ship(), &turned);
        assert!((now.bow_m - off(-30.0)).abs() < 1e-9 && (now.angle_rad + 0.1).abs() < 1e-9);
        assert!(berth.is_near(&ship(), &state, 100.0) && !berth.is_near(&ship(), &state, 10.0));
    }
}
