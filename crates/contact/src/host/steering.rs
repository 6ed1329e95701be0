//! Steering computes wrenches with which the host's own integration ends at the position of the engine's motion.
//!
//! A semi-implicit host moves a body by Δt v_{n+1} in a step. A semi-implicit host ends at the engine's position if
//! v_{n+1} is v̄, the *mean* velocity of the engine's motion over the step. The wrench that gives the body this
//! velocity is W = M(v̄ − v_n)/Δt − load. The engine's velocity V at the end of the step is remembered, and its
//! difference from the host's velocity is applied with the wrench of the next step. If the mean contact force gave the
//! host the velocity V at once, the positions would differ by up to half the penetration with long Δt, and a host that
//! stops within a step would never move again.
//!
//! A forward Euler host moves a body by Δt v_n in a step. No wrench can change the position at the end of a forward
//! Euler step, y_n = x_n + Δt v_n. But y_{n+1} = y_n + Δt v_{n+1}: in terms of y the forward Euler host is a
//! semi-implicit host that passes its positions one step late. So for a forward Euler host the engine starts from y_n,
//! and all else is as for a semi-implicit host.
//!
//! Under a steady load the velocities of a host are means over a step: they lag behind the position by half of the
//! velocity change in a step, which is ΔtM⁻¹W/2 ("half a kick"). The engine's velocities belong to the middle of its
//! last sub-step, so their lag is smaller than the host's. The engine starts with the difference of the two lags added
//! to the velocity. For a ship at rest on a fender the half kicks of contact and load cancel.
//!
//! This way of steering holds for a step that is as long as the last step. For a host whose steps vary see
//! [`super::lead`].

use crate::host::inertia;
use crate::host::settings::HostIntegration;
use crate::host::velocity::Velocity;
use crate::model::body::Mobility;
use crate::model::mass::InverseMatrix;
use crate::state::body_state::BodyState;
use crate::state::report::Wrench;

/// Velocity change of a body by its load in half a step.
pub(super) fn half_kick(
    inverse: &InverseMatrix,
    present: &BodyState,
    load: &Wrench,
    step_s: f64,
) -> Velocity {
    inertia::kick(inverse, present, load, 0.5 * step_s)
}

/// The state of a body from which the engine starts; its velocity is `lead` ahead of the host's velocity.
pub(super) fn start(
    integration: HostIntegration,
    present: &BodyState,
    lead: Velocity,
    step_s: f64,
) -> BodyState {
    let velocity = Velocity::of(present);
    let place = match integration {
        HostIntegration::ForwardEuler => velocity.carry(present, step_s),
        HostIntegration::SemiImplicit => *present,
    };
    velocity.plus(lead).of_body_at(&place)
}

/// The state of a body in the host at the end of a step, if its velocity is then `after`.
pub(super) fn arrival(
    integration: HostIntegration,
    present: &BodyState,
    after: Velocity,
    step_s: f64,
) -> BodyState {
    match integration {
        HostIntegration::ForwardEuler => Velocity::of(present).carry(present, step_s),
        HostIntegration::SemiImplicit => after.carry(present, step_s),
    }
}

/// The wrench that, together with the load, brings the velocity of the body in the host to `after`.
pub(super) fn wrench(
    mobility: &Mobility,
    present: &BodyState,
    after: Velocity,
    load: &Wrench,
    step_s: f64,
) -> Wrench {
    let impulse = inertia::impulse_for(mobility, present, after.minus(Velocity::of(present)));
    impulse.times(1.0 / step_s).minus(load)
}
