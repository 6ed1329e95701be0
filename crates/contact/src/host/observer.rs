//! The load observer: W_ext = M (v_n − v_{n−1})/Δt − W_{n−1}, from two states that the host showed and
//! the wrench that it was given between them. All that is not contact is in it.

use crate::admit::LARGEST_LOAD;
use crate::host::cosim::Given;
use crate::host::inertia;
use crate::host::settings::HostIntegration;
use crate::host::steering::Velocity;
use crate::model::{Body, Mobility};
use crate::number::greater;
use crate::report::Wrench;
use crate::state::BodyState;

/// Share of the body's radius that it may be away from where its velocity leads; as for the engine's
/// own memory of contacts.
const ALLOWANCE: f64 = 0.1;

/// The load between two states; zero for a fixed body. `None` where it is larger than any that a host
/// could tell: then the host has set the velocity anew, and that is no load.
pub(super) fn load(
    body: &Body,
    before: &BodyState,
    after: &BodyState,
    given: &Given,
) -> Option<Wrench> {
    if body.mobility == Mobility::Fixed {
        return Some(Wrench::default());
    }
    let change = Velocity::of(after).minus(Velocity::of(before));
    let impulse = inertia::impulse_for(&body.mobility, before, change);
    let rate = 1.0 / given.step_s;
    let force_n = impulse.force_n * rate - given.wrench.force_n;
    let moment_nm = impulse.moment_nm * rate - given.wrench.moment_nm;
    let largest = greater(greater(force_n.x.abs(), force_n.y.abs()), moment_nm.abs());
    (largest <= LARGEST_LOAD).then_some(Wrench { force_n, moment_nm })
}

/// Did the host put the body elsewhere between two states?
pub(super) fn was_moved(
    integration: HostIntegration,
    body: &Body,
    before: &BodyState,
    after: &BodyState,
    given: &Given,
) -> bool {
    let velocity_mps = match integration {
        HostIntegration::ForwardEuler => before.velocity_mps,
        HostIntegration::SemiImplicit => after.velocity_mps,
    };
    let expected_m = before.position_m + velocity_mps * given.step_s;
    (after.position_m - expected_m).length() > ALLOWANCE * body.outline.radius_m()
}
