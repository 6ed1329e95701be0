//! Inverse effective mass at a contact: the change of relative velocity by a force (eq. 13–19, 23).

use crate::maths::vec2::Vec2;
use crate::model::ranked::RankedBody;

/// The matrix K = Σ_j [1/m_j + (‖r_j‖² 1 − r_j r_jᵀ)/I_j] in the axes n, t (1/kg), which gives the change of the
/// relative velocity at the contact: ΔV_C = Δt K F.
///
/// Eq. 16 of the paper divides the torque by m_j, but the right divisor is I_j. All values are inverse masses, so that
/// a fixed body is a zero and not an infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InverseMass {
    /// 1/E_x: n·K n.
    pub(crate) normal: f64,
    /// 1/E_y: t·K t.
    pub(crate) tangential: f64,
    /// Coupling of the axes, t·K n = −Σ (r·n)(r·t)/I (eq. 22 and 25 print (r·t)(r·t)).
    pub(crate) cross: f64,
}

/// K of both bodies. The matrix K of both bodies together; `arm_*` is the vector from the centre of gravity of a body
/// to the contact point C.
#[inline]
pub(crate) fn inverse_mass(
    a: &RankedBody,
    arm_a_m: Vec2,
    b: &RankedBody,
    arm_b_m: Vec2,
    normal: Vec2,
) -> InverseMass {
    let tangent = normal.quarter_turn();
    let (a_n, a_t) = (arm_a_m.dot(normal), arm_a_m.dot(tangent));
    let (b_n, b_t) = (arm_b_m.dot(normal), arm_b_m.dot(tangent));
    let (a_turn, b_turn) = (a.inverse_inertia, b.inverse_inertia);
    InverseMass {
        normal: (a.inverse_mass + a_t * a_t * a_turn) + (b.inverse_mass + b_t * b_t * b_turn),
        tangential: (a.inverse_mass + a_n * a_n * a_turn) + (b.inverse_mass + b_n * b_n * b_turn),
        cross: -(a_n * a_t * a_turn + b_n * b_t * b_turn),
    }
}
