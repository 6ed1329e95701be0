//! The direct solve of an island with several floating bodies and no force at a bound: a raft that lies quietly.
//!
//! As in [`super::direct`], N_i = f_i and T_i is a line in V_t⁺. The change Δv of the bodies' velocities by the contacts is
//! that of one system with a sparse matrix,
//!
//! (M + h Σ c_i j_t j_tᵀ) Δv = h Σ (−f_i j_n + T_i(V_t at Δv = 0) j_t).

use crate::coupled::block_cholesky::Triple;
use crate::coupled::constraint::{Constraint, Speeds};
use crate::coupled::newton::NewtonBuffers;
use crate::coupled::unknowns::{Row, Unknowns};
use crate::mass::InverseMatrix;
use crate::state::Velocity;

/// Computes new velocities in `bodies` and the forces in `constraints`, from velocities without contact. The island is that
/// of `buffers.unknowns`. Returns false if a bound would be passed: `bodies` are unchanged then, the forces undefined.
pub(crate) fn solve(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    buffers: &mut NewtonBuffers,
    h: f64,
) -> bool {
    let NewtonBuffers { unknowns, step: change, .. } = buffers;
    change.clear();
    change.resize(unknowns.bodies(), Triple::default());
    unknowns.begin();
    for (index, constraint) in constraints.iter().enumerate() {
        let seat = unknowns.seats()[index];
        let tangential_n = constraint.shear.force_n(constraint.speeds(bodies).tangential_mps);
        let slope = constraint.shear.slope;
        unknowns.add(seat, &Row::normal(constraint), -h * constraint.law_n, 0.0, change);
        unknowns.add(seat, &Row::tangential(constraint), h * tangential_n, h * slope, change);
    }
    if !unknowns.solve(change) {
        return false;
    }
    for (constraint, &seat) in constraints.iter_mut().zip(unknowns.seats()) {
        let (free, more) = (constraint.speeds(bodies), Unknowns::speeds(seat, constraint, change));
        let speeds = Speeds {
            normal_mps: free.normal_mps + more.normal_mps,
            tangential_mps: free.tangential_mps + more.tangential_mps,
        };
        let tangential_n = constraint.shear.force_n(speeds.tangential_mps);
        if !constraint.is_within_bounds(speeds, tangential_n, h) {
            return false;
        }
        constraint.set_sticking(speeds, tangential_n);
    }
    // From the forces: so momentum is conserved to rounding, however stiff the springs.
    for constraint in constraints {
        constraint.apply_impulse(bodies, inverses, constraint.forces.change(), h);
    }
    true
}
