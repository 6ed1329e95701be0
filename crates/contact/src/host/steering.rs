//! Steering: wrenches with which the host's own integration ends at the position of the engine's motion.
//!
//! A semi-implicit host moves by Δt v_{n+1} in a step. The host ends at the engine's position if v_{n+1} is v̄, the
//! *mean* velocity of the engine's motion over the step. The wrench for this is W = M(v̄ − v_n)/Δt − load. The engine's
//! velocity at the end, V, is remembered, and the difference from the host's velocity is applied with the next step's
//! wrench. If the mean contact force gave the host the velocity V at once, the positions would differ by up to half the
//! penetration with long Δt, and a host that stops within a step would never move again.
//!
//! A forward Euler host moves by Δt v_n. No wrench can change its position at the end of the step, y_n = x_n + Δt v_n.
//! But y_{n+1} = y_n + Δt v_{n+1}: in y the host is a semi-implicit host that passes its positions one step late. So
//! the engine starts from y_n, and all else is the same.
//!
//! Under a steady load the velocities of such a host are also means over a step: they lag behind the position by half a
//! kick, ΔtM⁻¹W/2. The engine's velocities belong to the middle of its last sub-step, so their lag is smaller. The
//! engine starts with the difference added. At rest on a fender the halves of contact and load cancel.
//!
//! All of this is for a step that is as long as the last one. For other steps see [`super::lead`].

use crate::body::Mobility;
use crate::host::inertia;
use crate::host::settings::HostIntegration;
use crate::host::velocity::Velocity;
use crate::mass::InverseMatrix;
use crate::report::Wrench;
use crate::state::BodyState;

/// Velocity change by the load in half a step.
pub(super) fn half_kick(
    inverse: &InverseMatrix,
    present: &BodyState,
    load: &Wrench,
    step_s: f64,
) -> Velocity {
    inertia::kick(inverse, present, load, 0.5 * step_s)
}

/// The state from which the engine starts, `lead` ahead of the host's velocity.
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

/// The state of a host at the end of a step that it ends with the velocity `after`.
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

/// The wrench that, together with the load, brings the host's velocity to `after`.
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
