//! The mass matrix of a body at its heading, in the form in which the host integrates with it.

use crate::host::velocity::Velocity;
use crate::maths::vec2::{Rotation, vec2};
use crate::model::body::Mobility;
use crate::model::mass::InverseMatrix;
use crate::state::body_state::BodyState;
use crate::state::report::Wrench;

/// The momentum M v of a body with the heading of `state`, in earth-fixed axes (N·s, N·m·s). The momentum is zero for a
/// fixed body.
pub(super) fn impulse_for(mobility: &Mobility, state: &BodyState, v: Velocity) -> Wrench {
    match mobility {
        // A host does not move bodies on piles.
        Mobility::Fixed | Mobility::OnPile { .. } => Wrench::default(),
        Mobility::Free { mass_kg, yaw_inertia_kgm2 } => {
            Wrench { force_n: v.linear_mps * *mass_kg, moment_nm: v.yaw_radps * *yaw_inertia_kgm2 }
        }
        Mobility::FullMatrix { .. } | Mobility::SurgeSway { .. } => {
            let matrix = mobility.matrix().expect("a floating body");
            let rotation = Rotation::from_angle(state.heading_rad);
            let own = rotation.apply_inverse(v.linear_mps);
            let along = |row: &[f64; 3]| row[0] * own.x + row[1] * own.y + row[2] * v.yaw_radps;
            let [surge, sway, yaw] = matrix.each_ref().map(along);
            Wrench { force_n: rotation.apply(vec2(surge, sway)), moment_nm: yaw }
        }
    }
}

/// The velocity change M⁻¹ W Δt that a wrench gives to a body in `step_s`. The inverse mass matrix M⁻¹ is given in the
/// body's own axes; the body has the heading of `state`.
pub(super) fn kick(
    inverse: &InverseMatrix,
    state: &BodyState,
    wrench: &Wrench,
    step_s: f64,
) -> Velocity {
    if !inverse.floats() {
        return Velocity::default();
    }
    let inverse = match inverse.is_isotropic() {
        true => *inverse,
        false => inverse.turned(Rotation::from_angle(state.heading_rad)),
    };
    let (linear_mps, yaw_radps) =
        inverse.response(wrench.force_n * step_s, wrench.moment_nm * step_s);
    Velocity { linear_mps, yaw_radps }
}
