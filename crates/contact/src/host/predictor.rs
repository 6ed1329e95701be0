//! The predictor integrates an old input state of a body to the present time, in the same way as the host.

use crate::host::inertia;
use crate::host::past_step::PastStep;
use crate::host::settings::HostIntegration;
use crate::host::velocity::Velocity;
use crate::model::mass::InverseMatrix;
use crate::state::body_state::BodyState;
use crate::state::report::Wrench;

/// Computes the state of a body after one past step of the host, with the wrench and the load of this step.
pub(super) fn next(
    integration: HostIntegration,
    inverse: &InverseMatrix,
    state: &BodyState,
    given: &PastStep,
    load: &Wrench,
) -> BodyState {
    let sum = given.wrench.plus(load);
    let before = Velocity::of(state);
    let after = before.plus(inertia::kick(inverse, state, &sum, given.step_s));
    let mean = match integration {
        HostIntegration::ForwardEuler => before,
        HostIntegration::SemiImplicit => after,
    };
    after.of_body_at(&mean.carry(state, given.step_s))
}
