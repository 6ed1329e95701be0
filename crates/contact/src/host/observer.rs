//! The load observer computes the load W_ext = M (v_n − v_{n−1})/Δt − W_{n−1} on a body from two input states and the
//! wrench of the step between them. The load W_ext contains all forces on the body except contact.

use crate::admit::is_sound_load;
use crate::host::inertia;
use crate::host::past_step::PastStep;
use crate::host::settings::HostIntegration;
use crate::host::velocity::Velocity;
use crate::model::body::{Body, Mobility};
use crate::state::body_state::BodyState;
use crate::state::report::Wrench;

/// Largest deviation of a body's position from the path that its velocity gives, as a share of the body's radius. The
/// engine's contact memory uses the same share of the radius.
const ALLOWANCE: f64 = 0.1;

/// Computes the load on a body between two states; zero for a fixed body. Returns `None` if the load is larger than any
/// load that the engine accepts: then the host has set the velocity, and no load can be observed.
pub(super) fn load(
    body: &Body,
    before: &BodyState,
    after: &BodyState,
    given: &PastStep,
) -> Option<Wrench> {
    if body.mobility == Mobility::Fixed {
        return Some(Wrench::default());
    }
    let change = Velocity::of(after).minus(Velocity::of(before));
    let impulse = inertia::impulse_for(&body.mobility, before, change);
    let load = impulse.times(1.0 / given.step_s).minus(&given.wrench);
    is_sound_load(&load).then_some(load)
}

/// Returns true if the host teleported the body between the two states.
pub(super) fn was_teleported(
    integration: HostIntegration,
    body: &Body,
    before: &BodyState,
    after: &BodyState,
    given: &PastStep,
) -> bool {
    let velocity_mps = match integration {
        HostIntegration::ForwardEuler => before.velocity_mps,
        HostIntegration::SemiImplicit => after.velocity_mps,
    };
    let expected_m = before.position_m + velocity_mps * given.step_s;
    (after.position_m - expected_m).length() > ALLOWANCE * body.outline.radius_m()
}
