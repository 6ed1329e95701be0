//! The berth: a line through the fenders of a quay or of another ship. The module also computes distances and speeds of
//! a ship relative to this line.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Outline, Rotation, Vec2, vec2};

use fenderline_world::setup::Setup;

/// The fenders of one berth face the same direction, within this angle (rad).
const SAME_WAY_RAD: f64 = 0.1;
/// The flat of a ship's side is the part where her half breadth is at least this share of the greatest half breadth.
const FLAT: f64 = 0.98;

/// A straight line through fender faces, in the frame of the body that carries them: a quay or another ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Berth {
    /// Index of the body that carries the fenders.
    pub body: usize,
    /// One end of the line of the berth (m).
    pub from_m: Vec2,
    /// The other end (m).
    pub to_m: Vec2,
    /// Unit normal of the line of the berth, towards the water.
    pub facing: Vec2,
    /// Mean distance between neighbouring fenders (m); `None` for a single fender.
    pub apart_m: Option<f64>,
}

/// Position and speed of a ship relative to a berth. In pairs of values, the first value is for the bow and the second
/// for the stern. Bow and stern stand for the two ends of the flat of the ship's side towards the berth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lie {
    /// Positions of the two ends of the flat of the ship's side (m).
    pub at_m: [Vec2; 2],
    /// Distance of each end of the flat from the line of the berth, positive on the water side of the fenders (m).
    pub off_m: [f64; 2],
    /// Speed of each end of the flat towards the berth (m/s).
    pub closing_mps: [f64; 2],
    /// Speed of each end of the flat relative to the berth, in any direction (m/s).
    pub speed_mps: [f64; 2],
    /// Distance of each end of the flat along the berth from [`Berth::from_m`] (m).
    pub along_m: [f64; 2],
    /// The ship's speed relative to the berth, positive ahead (m/s).
    pub ahead_mps: f64,
    /// Angle between ship and berth, positive if the bow is nearer to the berth (rad).
    pub angle_rad: f64,
}

impl Berth {
    /// Finds the berth with the most fenders, among the bodies that `serves` selects. Of several berths with equally
    /// many fenders, the berth nearest to `ship` at the start is taken. `ship` is the index of the ship in
    /// [`Setup::bodies`]. Returns `None` if none of the selected bodies has fenders.
    #[must_use]
    pub fn of(setup: &Setup, ship: usize, serves: impl Fn(usize) -> bool) -> Option<Berth> {
        let faces: Vec<Face> = setup
            .fenders
            .iter()
            .filter(|fender| serves(fender.body))
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
            let off_m = (middle_m - setup.bodies[ship].position_m).length();
            let better = best.as_ref().is_none_or(|(count, least_m, _)| {
                row.len() > *count || row.len() == *count && off_m < *least_m
            });
            if better {
                best = Some((row.len(), off_m, berth));
            }
        }
        best.map(|(.., berth)| berth)
    }

    /// The line along a row of fenders, from the first to the last fender, through the face that stands out farthest.
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

    /// Length of the line of the berth (m).
    #[must_use]
    pub fn length_m(&self) -> f64 {
        (self.to_m - self.from_m).dot(self.facing.quarter_turn())
    }

    /// Position and speed, relative to the berth, of a ship with this outline and this state. `on` is the state of the
    /// body that carries the berth.
    #[must_use]
    pub fn lie(&self, on: &BodyState, outline: &Outline, state: &BodyState) -> Lie {
        let attitude = Rotation::from_angle(state.heading_rad);
        let quay = Rotation::from_angle(on.heading_rad);
        let facing = quay.apply(self.facing);
        // The berth is to starboard if its water side faces to port of the ship.
        let starboard = attitude.apply_inverse(facing).y <= 0.0;
        let flat = flat_of_side(outline, starboard);
        let from_m = on.position_m + quay.apply(self.from_m);
        let at_m = flat.map(|at| state.position_m + attitude.apply(at));
        // Velocities are relative to the body of the berth, which may move.
        let velocity_mps = |at: Vec2| {
            let arm_m = state.position_m + attitude.apply(at) - on.position_m;
            let ours = state.velocity_mps + attitude.apply(at).spun_by(state.yaw_rate_radps);
            ours - on.velocity_mps - arm_m.spun_by(on.yaw_rate_radps)
        };
        let off_m = at_m.map(|at| (at - from_m).dot(facing));
        let along = self.facing.quarter_turn();
        let way_m = |at: Vec2| (quay.apply_inverse(at - on.position_m) - self.from_m).dot(along);
        let [bow, stern] = flat;
        Lie {
            at_m,
            off_m,
            closing_mps: flat.map(|at| -velocity_mps(at).dot(facing)),
            speed_mps: flat.map(|at| velocity_mps(at).length()),
            along_m: at_m.map(way_m),
            ahead_mps: velocity_mps(Vec2::ZERO).dot(attitude.apply(vec2(1.0, 0.0))),
            angle_rad: libm::asin(bounded(
                (off_m[1] - off_m[0]) / (bow - stern).length(),
                -1.0,
                1.0,
            )),
        }
    }

    /// Distance along the berth that a ship has to go ahead until a place on her axis, forward of her origin (m), is abeam of
    /// a mark of the berth; negative if the ship has to go astern. The mark is in the frame of the body that carries the
    /// berth (m), and `on` is the state of this body.
    #[must_use]
    pub fn to_go_m(&self, on: &BodyState, state: &BodyState, mark_m: Vec2, of_ship_m: f64) -> f64 {
        let quay = Rotation::from_angle(on.heading_rad);
        let ahead = Rotation::from_angle(state.heading_rad).apply(vec2(1.0, 0.0));
        let along = quay.apply(self.facing.quarter_turn());
        let along = if along.dot(ahead) < 0.0 { along * -1.0 } else { along };
        let mark_m = on.position_m + quay.apply(mark_m);
        (mark_m - (state.position_m + ahead * of_ship_m)).dot(along)
    }

    /// Returns true if an end of the ship (0 for the bow) is past the last fender by more than the distance between
    /// fenders: the line through the fenders has no fender there. At dolphins a ship's ends are usually past the last
    /// dolphin, but by less. With a single fender both ends of a ship are past the fender; the result is then true if
    /// the fender is not abreast of the ship's side.
    #[must_use]
    pub fn is_past_the_end(&self, lie: &Lie, end: usize) -> bool {
        let [bow_m, stern_m] = lie.along_m;
        match self.apart_m {
            Some(apart_m) => {
                let at_m = lie.along_m[end];
                at_m < -apart_m || at_m > self.length_m() + apart_m
            }
            None => lesser(bow_m, stern_m) > 0.0 || greater(bow_m, stern_m) < 0.0,
        }
    }

    /// Returns true if some part of the ship is abreast of the berth and the ship's origin is within this distance of
    /// the berth's line.
    #[must_use]
    pub fn is_near(
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

/// The face of a fender, in the frame of the body that carries the fender.
struct Face {
    body: usize,
    at_m: Vec2,
    facing_rad: f64,
}

impl Face {
    /// Returns true if the two faces belong to one berth: they are on the same body and face the same direction.
    fn is_beside(&self, other: &Face) -> bool {
        let between_rad =
            libm::remainder(self.facing_rad - other.facing_rad, core::f64::consts::TAU);
        self.body == other.body && libm::fabs(between_rad) < SAME_WAY_RAD
    }
}

fn towards(angle_rad: f64) -> Vec2 {
    vec2(libm::cos(angle_rad), libm::sin(angle_rad))
}

/// The fore and the after end of the flat of a ship's side, in the frame of the ship. For a hull without a flat side
/// these two ends are a third of the hull's length from bow and stern.
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
