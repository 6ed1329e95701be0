//! Plane vectors and rotations.
//!
//! Axes of vectors: x north (or forward, in a body's frame), y east (or to starboard). The positive sense of rotation
//! is from x to y, clockwise on a chart, so that a positive heading turns to starboard.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use crate::maths::angle::sin_cos;

/// A vector in the horizontal plane; the name of the variable states the unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2 {
    /// North component, or forward component in a body's frame.
    pub x: f64,
    /// East component, or starboard component in a body's frame.
    pub y: f64,
}

/// Makes a [`Vec2`].
///
/// ```
/// use fenderline_contact::vec2;
/// assert_eq!(vec2(3.0, 4.0).length(), 5.0);
/// ```
#[must_use]
pub const fn vec2(x: f64, y: f64) -> Vec2 {
    Vec2 { x, y }
}

impl Vec2 {
    /// The zero vector.
    pub const ZERO: Vec2 = vec2(0.0, 0.0);

    /// Scalar product a·b.
    #[must_use]
    #[inline]
    pub fn dot(self, other: Vec2) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// Cross product a×b = a_x b_y − a_y b_x; positive when b lies in the positive sense of rotation from a.
    #[must_use]
    #[inline]
    pub fn cross(self, other: Vec2) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Velocity ω×r = ω(−r_y, r_x) of a point at the arm `self` of a body that turns at the rate `omega`.
    #[must_use]
    #[inline]
    pub fn spun_by(self, omega: f64) -> Vec2 {
        vec2(-omega * self.y, omega * self.x)
    }

    /// The vector rotated by +90° (from x to y).
    #[must_use]
    #[inline]
    pub fn quarter_turn(self) -> Vec2 {
        vec2(-self.y, self.x)
    }

    /// The vector rotated by −90°: for an edge of a boundary walked in the positive sense, the result points outward.
    #[must_use]
    #[inline]
    pub fn quarter_turn_back(self) -> Vec2 {
        vec2(self.y, -self.x)
    }

    /// Square of the length.
    #[must_use]
    #[inline]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }

    /// Length.
    #[must_use]
    #[inline]
    pub fn length(self) -> f64 {
        libm::sqrt(self.length_squared())
    }

    /// Returns true if neither component is infinite or NaN.
    #[must_use]
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Add for Vec2 {
    type Output = Vec2;
    #[inline]
    fn add(self, other: Vec2) -> Vec2 {
        vec2(self.x + other.x, self.y + other.y)
    }
}

impl AddAssign for Vec2 {
    #[inline]
    fn add_assign(&mut self, other: Vec2) {
        *self = *self + other;
    }
}

impl Sub for Vec2 {
    type Output = Vec2;
    #[inline]
    fn sub(self, other: Vec2) -> Vec2 {
        vec2(self.x - other.x, self.y - other.y)
    }
}

impl SubAssign for Vec2 {
    #[inline]
    fn sub_assign(&mut self, other: Vec2) {
        *self = *self - other;
    }
}

impl Neg for Vec2 {
    type Output = Vec2;
    #[inline]
    fn neg(self) -> Vec2 {
        vec2(-self.x, -self.y)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Vec2;
    #[inline]
    fn mul(self, factor: f64) -> Vec2 {
        vec2(self.x * factor, self.y * factor)
    }
}

/// A rotation by an angle, stored as its cosine and sine so that a step computes them only once per body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// Cosine of the angle.
    pub cos: f64,
    /// Sine of the angle.
    pub sin: f64,
}

impl Default for Rotation {
    fn default() -> Rotation {
        Rotation::IDENTITY
    }
}

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Rotation = Rotation { cos: 1.0, sin: 0.0 };

    /// The rotation by `angle_rad`, from x to y. The rotation has the same bits on every platform.
    #[must_use]
    #[inline]
    pub fn from_angle(angle_rad: f64) -> Rotation {
        if angle_rad == 0.0 {
            return Rotation::IDENTITY;
        }
        let (sin, cos) = sin_cos(angle_rad);
        Rotation { cos, sin }
    }

    /// Transforms a vector from the body's frame to the earth-fixed frame.
    #[must_use]
    #[inline]
    pub fn apply(self, v: Vec2) -> Vec2 {
        vec2(self.cos * v.x - self.sin * v.y, self.sin * v.x + self.cos * v.y)
    }

    /// Transforms a vector from the earth-fixed frame to the body's frame.
    #[must_use]
    #[inline]
    pub fn apply_inverse(self, v: Vec2) -> Vec2 {
        vec2(self.cos * v.x + self.sin * v.y, -self.sin * v.x + self.cos * v.y)
    }

    /// The rotation `self⁻¹ · other`: the attitude of `other` as seen from `self`.
    #[must_use]
    #[inline]
    pub fn to(self, other: Rotation) -> Rotation {
        Rotation {
            cos: self.cos * other.cos + self.sin * other.sin,
            sin: self.cos * other.sin - self.sin * other.cos,
        }
    }
}

/// Position and attitude of a body, which map the body's frame to the earth-fixed frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Position of the body's centre of gravity (m).
    pub position_m: Vec2,
    /// Attitude.
    pub rotation: Rotation,
}

impl Pose {
    /// The identity pose: no translation, no rotation.
    pub(crate) const IDENTITY: Pose =
        Pose { position_m: Vec2::ZERO, rotation: Rotation { cos: 1.0, sin: 0.0 } };

    /// Makes a pose from a position and a heading.
    #[must_use]
    #[inline]
    pub fn new(position_m: Vec2, heading_rad: f64) -> Pose {
        Pose { position_m, rotation: Rotation::from_angle(heading_rad) }
    }

    /// Transforms a point from the body's frame to the earth-fixed frame.
    #[must_use]
    #[inline]
    pub fn apply(self, point_m: Vec2) -> Vec2 {
        self.position_m + self.rotation.apply(point_m)
    }

    /// Transforms a point from the earth-fixed frame to the body's frame.
    #[must_use]
    #[inline]
    pub fn apply_inverse(self, point_m: Vec2) -> Vec2 {
        self.rotation.apply_inverse(point_m - self.position_m)
    }

    /// The pose of `other` as seen from `self`. The function takes the difference of the positions first, so that no
    /// digits are lost far from the origin. (At UTM coordinates, 1e7 m, an area computed from earth-fixed vertices
    /// would be wrong by 1e-3 m².)
    #[must_use]
    #[inline]
    pub fn to(self, other: Pose) -> Pose {
        Pose {
            position_m: self.rotation.apply_inverse(other.position_m - self.position_m),
            rotation: self.rotation.to(other.rotation),
        }
    }
}
