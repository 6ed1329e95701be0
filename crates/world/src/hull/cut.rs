//! The outline of a hull at the height of a fender, with heel and trim.

use fenderline_contact::number::bounded;
use fenderline_contact::{Slice, Vec2, vec2};

use super::levels::HullByHeight;

/// The height of a fender on a hull is rounded to multiples of `HEIGHT_M` (m), and roll and pitch are rounded to
/// multiples of `ANGLE_RAD` (rad); 1e-5 rad are 1.5 mm at the bow of a ship of 300 m. Because of this rounding, an
/// outline depends only on the present motion, is the same in a run and in its replay, and need not be cut anew in each
/// step.
pub(super) const HEIGHT_M: f64 = 1e-3;
pub(super) const ANGLE_RAD: f64 = 1e-5;

/// The height of a fender on a hull, and the hull's roll and pitch, in multiples of [`HEIGHT_M`] and [`ANGLE_RAD`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Posture {
    /// Height of the fender above the keel at the centre of gravity, in multiples of [`HEIGHT_M`].
    height: i64,
    roll: i64,
    pitch: i64,
}

impl Posture {
    pub(super) fn new(height_m: f64, roll_rad: f64, pitch_rad: f64) -> Posture {
        let whole = |value: f64, unit: f64| libm::rint(value / unit) as i64;
        Posture {
            height: whole(height_m, HEIGHT_M),
            roll: whole(roll_rad, ANGLE_RAD),
            pitch: whole(pitch_rad, ANGLE_RAD),
        }
    }

    /// Height of the fender above the keel at the centre of gravity (m), and roll and pitch of the hull (rad).
    pub(super) fn values(self) -> (f64, f64, f64) {
        let value = |whole: i64, unit: f64| whole as f64 * unit;
        (value(self.height, HEIGHT_M), value(self.roll, ANGLE_RAD), value(self.pitch, ANGLE_RAD))
    }

    /// Height of the fender above the keel at a place on the hull (m), for small angles. Heel to starboard and trim by
    /// the bow take a place on the starboard bow down, so that the fender meets the ship's side higher up.
    pub(super) fn height_at_m(self, place_m: Vec2) -> f64 {
        let (height_m, roll_rad, pitch_rad) = self.values();
        height_m - place_m.x * pitch_rad + place_m.y * roll_rad
    }

    /// Horizontal shift of a place of the hull by heel and trim, for each metre above the centre of gravity (m/m).
    fn lean(self) -> Vec2 {
        let (_, roll_rad, pitch_rad) = self.values();
        vec2(-pitch_rad, roll_rad)
    }

    /// The place on the upright hull that is now at the fender (m), and the height of this place above the keel (m),
    /// within the range `range_m`.
    pub(super) fn upright(
        self,
        place_m: Vec2,
        gravity_m: f64,
        [low_m, high_m]: [f64; 2],
    ) -> (Vec2, f64) {
        let mut upright_m = place_m;
        let mut height_m = 0.0;
        for _ in 0..3 {
            height_m = bounded(self.height_at_m(upright_m), low_m, high_m);
            upright_m = place_m - self.lean() * (height_m - gravity_m);
        }
        (upright_m, height_m)
    }
}

impl HullByHeight {
    /// Cuts the outline of the hull at a fender. Each vertex of the outline is taken at the height at which the heeled
    /// and trimmed hull cuts the fender's plane. Heel and trim then move the vertex about the centre of gravity, which
    /// is `gravity_m` above the keel. Above the hull's highest outline the highest outline is used, and below the
    /// lowest outline the lowest.
    ///
    /// Between two valid outlines, heel could in theory fold the hull over itself. If the hull is folded in this way,
    /// the nearest given outline is used.
    pub(super) fn cut(&self, posture: Posture, gravity_m: f64) -> Slice {
        let (height_m, roll_rad, pitch_rad) = posture.values();
        let [low_m, high_m] = self.range_m();
        let count = self.levels()[0].vertices_m.len();
        let (mut vertices_m, mut rates) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for index in 0..count {
            let mut own_m = height_m;
            let (mut at_m, mut rate) = self.vertex(index, own_m);
            if roll_rad != 0.0 || pitch_rad != 0.0 {
                // Sides lean by less than 1/angle, so each round reduces the error of the height by the factor angle ×
                // slope.
                for _ in 0..4 {
                    own_m = posture.height_at_m(at_m);
                    (at_m, rate) = self.vertex(index, own_m);
                }
                let is_side = (low_m..=high_m).contains(&own_m);
                at_m += posture.lean() * (bounded(own_m, low_m, high_m) - gravity_m);
                // The rate with respect to the fender's height h₀: dv/dh₀ = (v′ + lean) dh/dh₀, with h = h₀ − x θ + y
                // φ.
                let by_fender = 1.0 / (1.0 + rate.x * pitch_rad - rate.y * roll_rad);
                rate = if is_side { (rate + posture.lean()) * by_fender } else { Vec2::ZERO };
            }
            vertices_m.push(at_m);
            rates.push(rate);
        }
        Slice::new(&vertices_m, &rates).unwrap_or_else(|_| self.given(height_m))
    }

    /// The given outline that is nearest in height, taken as a hull with vertical sides.
    pub(super) fn given(&self, height_m: f64) -> Slice {
        let off_m = |level: &super::Level| (level.height_m - height_m).abs();
        let levels = self.levels();
        let nearest = levels[1..]
            .iter()
            .fold(&levels[0], |best, one| if off_m(one) < off_m(best) { one } else { best });
        Slice::new(&nearest.vertices_m, &[]).expect("a given outline was checked")
    }
}
