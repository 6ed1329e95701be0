//! The frame of a fender's face: x runs from the face inwards, and s along it.

use crate::maths::vec2::{Pose, Vec2, vec2};

/// The face of a fender, seen in another frame: the direction inwards, the direction along the face, and the middle of
/// the face.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) inward: Vec2,
    pub(crate) along: Vec2,
    pub(crate) face_m: Vec2,
}

impl Frame {
    /// The frame of a face whose inward direction and middle are given in the axes of a body with the pose `host`.
    pub(crate) fn of(inward: Vec2, face_m: Vec2, host: Pose) -> Frame {
        let inward = host.rotation.apply(inward);
        Frame { inward, along: inward.quarter_turn(), face_m: host.apply(face_m) }
    }

    /// Transforms a point into the frame of the face.
    #[inline(always)]
    pub(crate) fn to_face(self, v: Vec2) -> Vec2 {
        self.turned_to_face(v - self.face_m)
    }

    /// Transforms a direction into the frame of the face.
    #[inline(always)]
    pub(crate) fn turned_to_face(self, v: Vec2) -> Vec2 {
        vec2(v.dot(self.inward), v.dot(self.along))
    }

    /// Transforms a direction from the frame of the face into the other frame.
    pub(crate) fn turned(self, v: Vec2) -> Vec2 {
        self.inward * v.x + self.along * v.y
    }
}
