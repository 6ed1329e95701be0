//! The predictor: a state shown, carried on as the host itself carried it on since.

use crate::host::cosim::Given;
use crate::host::inertia;
use crate::host::settings::HostIntegration;
use crate::host::steering::Velocity;
use crate::mass::InverseMatrix;
use crate::report::Wrench;
use crate::state::BodyState;

/// One step of the host, with the wrench that it was given and its load.
pub(super) fn next(
    integration: HostIntegration,
    inverse: &InverseMatrix,
    state: &BodyState,
    given: &Given,
    load: &Wrench,
) -> BodyState {
    let sum = Wrench {
        force_n: given.wrench.force_n + load.force_n,
        moment_nm: given.wrench.moment_nm + load.moment_nm,
    };
    let before = Velocity::of(state);
    let after = before.plus(inertia::kick(inverse, state, &sum, given.step_s));
    let mean = match integration {
        HostIntegration::ForwardEuler => before,
        HostIntegration::SemiImplicit => after,
    };
    after.of_a_body_at(&mean.carry(state, given.step_s))
}
