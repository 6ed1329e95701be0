//! The berth in its own axes, and where a ship's hull lies in front of its fenders.
//!
//! The axes of a berth: `along` runs along the line of the fenders towards the bow of the scenario's ship, from the
//! middle of the fenders; `off` is the distance from the line of the fenders' faces, towards the water. The angle of a
//! ship is that between her centre line and the quay, positive if her bow is nearer to the quay.

use core::f64::consts::PI;

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Rotation, Vec2, vec2};
use fenderline_sim::berth::Berth;
use fenderline_sim::{BodyStart, BodyVelocity, Setup};

/// Where a ship lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lie {
    /// Place of the centre of gravity along the quay (m).
    pub along_m: f64,
    /// Distance of the centre of gravity from the line of the fenders (m).
    pub off_m: f64,
    /// Angle to the quay, positive with the bow towards it (rad).
    pub angle_rad: f64,
}

/// Where a ship lies, and how she moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Where.
    pub lie: Lie,
    /// Rates of along, off and angle (m/s, m/s, rad/s).
    pub rates: [f64; 3],
}

/// A face of a fender in the axes of the berth.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Face {
    /// Index in the set-up's fenders.
    fender: usize,
    along_m: f64,
    off_m: f64,
    half_width_m: f64,
}

/// The fender that a hull is nearest to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Index in the set-up's fenders.
    pub fender: usize,
    /// Distance of the hull from the fender's face, square to the quay (m); negative where the fender is deflected.
    pub gap_m: f64,
    /// Place of the nearest point of the hull along the quay (m).
    pub along_m: f64,
    /// Distance of that point from the line of the fenders (m).
    pub off_m: f64,
}

/// A berth with the hull of its ship.
#[derive(Clone, Debug, PartialEq)]
pub struct BerthAxes {
    /// Index of the ship in the set-up's bodies.
    pub ship: usize,
    origin_m: Vec2,
    /// Unit vector along the quay, towards the bow of the scenario's ship.
    along: Vec2,
    /// Unit vector towards the water.
    out: Vec2,
    /// 1 if the ship has the quay to starboard, else −1.
    hand: f64,
    faces: Vec<Face>,
    /// The ship's outline in her own axes.
    hull_m: Vec<Vec2>,
    /// Lie of the ship at the start of the scenario.
    pub start: Lie,
    /// Length of the line of the fenders (m).
    pub length_m: f64,
}

impl BerthAxes {
    /// The berth of a set-up for the body `ship`, or for the ship of its `[berthing]`.
    ///
    /// # Errors
    /// Says what the set-up lacks: a berthing, the body, or fenders on a fixed body.
    pub fn of(setup: &Setup, ship: Option<&str>) -> Result<BerthAxes, String> {
        let Some(berthing) = &setup.berthing else {
            let why = "the scenario of the berth has no [berthing], whose particulars the energy by formula needs";
            return Err(why.to_owned());
        };
        let ship = match ship {
            None => berthing.ship,
            Some(name) => {
                let found = setup.bodies.iter().position(|body| body.name == name);
                found.ok_or_else(|| format!("the scenario of the berth has no body `{name}`"))?
            }
        };
        if ship != berthing.ship {
            let name = &setup.bodies[berthing.ship].name;
            return Err(format!("the [berthing] of the scenario is about the body `{name}`"));
        }
        BerthAxes::of_ship(setup, ship)
    }

    /// The berth of a set-up for the body with the index `ship`.
    ///
    /// # Errors
    /// The set-up has no fenders on a fixed body.
    pub fn of_ship(setup: &Setup, ship: usize) -> Result<BerthAxes, String> {
        let is_fixed = |body: usize| setup.bodies[body].is_fixed() && body != ship;
        let berth = Berth::of(setup, ship, is_fixed)
            .ok_or("the scenario of the berth has no fenders on a fixed body")?;
        let quay = &setup.bodies[berth.body];
        let turned = Rotation::from_angle(quay.heading_rad);
        let earth = |at: Vec2| quay.position_m + turned.apply(at);
        let origin_m = (earth(berth.from_m) + earth(berth.to_m)) * 0.5;
        let out = turned.apply(berth.facing);
        let body = &setup.bodies[ship];
        let ahead = Rotation::from_angle(body.heading_rad).apply(vec2(1.0, 0.0));
        let along = out.quarter_turn();
        let along = if along.dot(ahead) < 0.0 { -along } else { along };
        let hand = if along.cross(-out) > 0.0 { 1.0 } else { -1.0 };
        let facing_rad = libm::atan2(berth.facing.y, berth.facing.x);
        let mut faces: Vec<Face> = Vec::new();
        for (index, fender) in setup.fenders.iter().enumerate() {
            let beside_rad = libm::remainder(fender.facing_rad - facing_rad, 2.0 * PI);
            if fender.body != berth.body || beside_rad.abs() > SAME_WAY_RAD {
                continue;
            }
            let forward = Rotation::from_angle(fender.facing_rad).apply(vec2(1.0, 0.0));
            let at = earth(fender.position_m + forward * fender.projection_m) - origin_m;
            faces.push(Face {
                fender: index,
                along_m: at.dot(along),
                off_m: at.dot(out),
                half_width_m: 0.5 * fender.width_m,
            });
        }
        let ends = faces.iter().map(|face| face.along_m);
        let length_m =
            ends.clone().fold(f64::NEG_INFINITY, greater) - ends.fold(f64::INFINITY, lesser);
        let mut axes = BerthAxes {
            ship,
            origin_m,
            along,
            out,
            hand,
            faces,
            hull_m: body.outline.vertices().to_vec(),
            start: Lie { along_m: 0.0, off_m: 0.0, angle_rad: 0.0 },
            length_m,
        };
        axes.start = axes.lie(body.position_m, body.heading_rad);
        Ok(axes)
    }

    /// Lie of a ship at a position (m) with a heading (rad).
    #[must_use]
    pub fn lie(&self, position_m: Vec2, heading_rad: f64) -> Lie {
        let from = position_m - self.origin_m;
        let along_rad = libm::atan2(self.along.y, self.along.x);
        let angle_rad = self.hand * libm::remainder(heading_rad - along_rad, 2.0 * PI);
        Lie { along_m: from.dot(self.along), off_m: from.dot(self.out), angle_rad }
    }

    /// Position, heading and velocity of a ship in the scenario.
    #[must_use]
    pub fn start_of(&self, motion: &Motion) -> BodyStart {
        let Motion { lie, rates } = motion;
        let position_m = self.origin_m + self.along * lie.along_m + self.out * lie.off_m;
        let along_rad = libm::atan2(self.along.y, self.along.x);
        let heading_rad = along_rad + self.hand * lie.angle_rad;
        let velocity_mps = self.along * rates[0] + self.out * rates[1];
        let own = Rotation::from_angle(heading_rad).apply_inverse(velocity_mps);
        BodyStart {
            position_m,
            heading_rad,
            velocity: BodyVelocity {
                surge_mps: own.x,
                sway_mps: own.y,
                yaw_radps: self.rate_of_turn(rates[2]),
            },
        }
    }

    /// Heading of a ship at an angle to the quay, from 0 to 2π (rad).
    #[must_use]
    pub fn heading(&self, angle_rad: f64) -> f64 {
        let along_rad = libm::atan2(self.along.y, self.along.x);
        let turn = 2.0 * PI;
        let rest = libm::fmod(along_rad + self.hand * angle_rad, turn);
        if rest < 0.0 { rest + turn } else { rest }
    }

    /// Rate of turn, positive to starboard, of a rate of the angle (rad/s).
    #[must_use]
    pub fn rate_of_turn(&self, angle_radps: f64) -> f64 {
        self.hand * angle_radps
    }

    /// Place along and off the quay of a point in the ship's axes (m).
    #[must_use]
    pub fn point(&self, lie: &Lie, at: Vec2) -> [f64; 2] {
        let (sin, cos) = (libm::sin(lie.angle_rad), libm::cos(lie.angle_rad));
        let inward = self.hand * at.y;
        [lie.along_m + at.x * cos - inward * sin, lie.off_m - (at.x * sin + inward * cos)]
    }

    /// Point in the ship's axes of a place along and off the quay (m).
    #[must_use]
    pub fn in_ship(&self, lie: &Lie, at: [f64; 2]) -> Vec2 {
        let (sin, cos) = (libm::sin(lie.angle_rad), libm::cos(lie.angle_rad));
        let (along_m, inward_m) = (at[0] - lie.along_m, lie.off_m - at[1]);
        let forward_m = along_m * cos + inward_m * sin;
        vec2(forward_m, self.hand * (inward_m * cos - along_m * sin))
    }

    /// Corners of the hull in the ship's axes (m).
    #[must_use]
    pub fn hull(&self) -> &[Vec2] {
        &self.hull_m
    }

    /// Corners of the hull of a ship, earth-fixed (m).
    #[must_use]
    pub fn hull_on_earth(&self, lie: &Lie) -> Vec<Vec2> {
        self.hull_m.iter().map(|corner| self.from_axes(self.point(lie, *corner))).collect()
    }

    /// Place forward of the centre of gravity (m), and speed towards the quay (m/s), of the point of a ship that is at
    /// a place along and off the quay (m).
    #[must_use]
    pub fn at_ship(&self, motion: &Motion, at: [f64; 2]) -> (f64, f64) {
        let Motion { lie, rates } = motion;
        let (sin, cos) = (libm::sin(lie.angle_rad), libm::cos(lie.angle_rad));
        let (along_m, inward_m) = (at[0] - lie.along_m, lie.off_m - at[1]);
        let forward_m = along_m * cos + inward_m * sin;
        // The point turns with the ship: her bow goes towards the quay as the angle grows.
        (forward_m, rates[2] * along_m - rates[1])
    }

    /// The least distance of the hull from the line of the fenders at a place along the quay (m); `None` beyond the
    /// ends of the hull.
    #[must_use]
    pub fn hull_at(&self, lie: &Lie, along_m: f64) -> Option<f64> {
        self.lowest(lie, along_m, along_m).map(|at| at[1])
    }

    /// The point of the hull nearest to the line of the fenders, between two places along the quay.
    fn lowest(&self, lie: &Lie, from_m: f64, to_m: f64) -> Option<[f64; 2]> {
        let mut best: Option<[f64; 2]> = None;
        let mut take = |at: [f64; 2]| {
            if best.is_none_or(|best| at[1] < best[1]) {
                best = Some(at);
            }
        };
        let count = self.hull_m.len();
        for index in 0..count {
            let one = self.point(lie, self.hull_m[index]);
            let other = self.point(lie, self.hull_m[(index + 1) % count]);
            if one[0] >= from_m && one[0] <= to_m {
                take(one);
            }
            for end_m in [from_m, to_m] {
                let (low, high) = if one[0] <= other[0] { (one, other) } else { (other, one) };
                if low[0] <= end_m && high[0] >= end_m && high[0] > low[0] {
                    let share = (end_m - low[0]) / (high[0] - low[0]);
                    take([end_m, low[1] + share * (high[1] - low[1])]);
                }
            }
        }
        best
    }

    /// The fender that the hull is nearest to; `None` if no fender is abreast of the hull.
    #[must_use]
    pub fn nearest(&self, lie: &Lie) -> Option<Nearest> {
        let of = |face: &Face| {
            let (low_m, high_m) =
                (face.along_m - face.half_width_m, face.along_m + face.half_width_m);
            let at = self.lowest(lie, low_m, high_m)?;
            Some(Nearest {
                fender: face.fender,
                gap_m: at[1] - face.off_m,
                along_m: at[0],
                off_m: at[1],
            })
        };
        self.faces.iter().filter_map(of).min_by(|one, other| one.gap_m.total_cmp(&other.gap_m))
    }

    /// The lie of a ship whose hull is at two distances from the line of the fenders at two places along the quay;
    /// `None` if there is none. The hull's outline is met where the sensors look, by Newton's method.
    #[must_use]
    pub fn lie_of(&self, along_m: f64, places_m: [f64; 2], distances_m: [f64; 2]) -> Option<Lie> {
        let slope = (distances_m[1] - distances_m[0]) / (places_m[0] - places_m[1]);
        let half_m = self.hull_m.iter().map(|at| self.hand * at.y).fold(0.0, greater);
        let mut lie = Lie { along_m, off_m: 0.0, angle_rad: libm::atan(slope) };
        let middle_m = 0.5 * (places_m[0] + places_m[1]);
        let middle_off_m = 0.5 * (distances_m[0] + distances_m[1]);
        lie.off_m = half_m + middle_off_m + slope * (middle_m - along_m);
        for _ in 0..NEWTON_STEPS {
            let off = |lie: &Lie| {
                let [bow, stern] = places_m.map(|place_m| self.hull_at(lie, place_m));
                Some([bow? - distances_m[0], stern? - distances_m[1]])
            };
            let wrong = off(&lie)?;
            if greater(wrong[0].abs(), wrong[1].abs()) < 1e-10 {
                return Some(lie);
            }
            let by_rad = 1e-6;
            let turned = off(&Lie { angle_rad: lie.angle_rad + by_rad, ..lie })?;
            let rate = [(turned[0] - wrong[0]) / by_rad, (turned[1] - wrong[1]) / by_rad];
            if rate[0] == rate[1] {
                return None;
            }
            let turn_rad = (wrong[1] - wrong[0]) / (rate[0] - rate[1]);
            lie.angle_rad += turn_rad;
            lie.off_m -= wrong[0] + rate[0] * turn_rad;
            if lie.angle_rad.abs() > 0.7 {
                return None;
            }
        }
        None
    }

    /// Lie of a ship whose antenna is at a position (m), with a heading (rad).
    #[must_use]
    pub fn lie_of_antenna(&self, antenna_m: Vec2, at_m: Vec2, heading_rad: f64) -> Lie {
        self.lie(at_m - Rotation::from_angle(heading_rad).apply(antenna_m), heading_rad)
    }

    /// North and east of the scenario's origin (m) as along and off.
    #[must_use]
    pub fn in_axes(&self, at_m: Vec2) -> [f64; 2] {
        let from = at_m - self.origin_m;
        [from.dot(self.along), from.dot(self.out)]
    }

    /// North and east of the scenario's origin (m) of a point along and off the quay.
    #[must_use]
    pub fn from_axes(&self, at: [f64; 2]) -> Vec2 {
        self.origin_m + self.along * at[0] + self.out * at[1]
    }

    /// Width of the face of a fender of the berth (m); 0 for another fender.
    #[must_use]
    pub fn face_width_m(&self, fender: usize) -> f64 {
        let face = self.faces.iter().find(|face| face.fender == fender);
        face.map_or(0.0, |face| 2.0 * face.half_width_m)
    }

    /// Number of the fenders of the berth.
    #[must_use]
    pub fn fenders(&self) -> usize {
        self.faces.len()
    }

    /// Length of the hull (m).
    #[must_use]
    pub fn hull_length_m(&self) -> f64 {
        let ends = self.hull_m.iter().map(|at| at.x);
        ends.clone().fold(f64::NEG_INFINITY, greater) - ends.fold(f64::INFINITY, lesser)
    }

    /// Place of an antenna in the ship's axes, of which the distances to bow, stern, port and starboard side are known
    /// (m).
    #[must_use]
    pub fn antenna_of(&self, extent_m: [f64; 4]) -> Vec2 {
        let bow_m = self.hull_m.iter().map(|at| at.x).fold(f64::NEG_INFINITY, greater);
        let side_m = self.hull_m.iter().map(|at| at.y).fold(f64::NEG_INFINITY, greater);
        vec2(bow_m - extent_m[0], side_m - extent_m[3])
    }
}

/// The fenders of a berth face the same way, within this angle (rad).
const SAME_WAY_RAD: f64 = 0.1;
/// Largest number of steps of Newton's method.
const NEWTON_STEPS: usize = 30;
