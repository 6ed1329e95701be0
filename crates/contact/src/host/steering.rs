//! Steering: wrenches with which the host's own integration lands where the engine's motion did.
//!
//! A semi-implicit host moves by Δt v_{n+1} in a step. It lands where the engine did if v_{n+1} is the
//! *mean* velocity v̄ of the engine's motion over the step, and the wrench for that is
//! W = M(v̄ − v_n)/Δt − load. The engine's velocity at the end, V, is kept apart: V less what the host
//! has, to be handed on with the next step's wrench. To give the host V at once, with W the mean of the
//! contact force, would leave it elsewhere than the engine, by up to half the contact's depth at
//! long Δt; and a host that comes to rest within a step would stay there.
//!
//! A forward Euler host moves by Δt v_n: where it will be at the end of the step, y_n = x_n + Δt v_n,
//! no wrench can change. But y_{n+1} = y_n + Δt v_{n+1}: it is a semi-implicit host that shows its
//! positions one step late. So the engine begins at y_n, and nothing else differs.
//!
//! Loads: by a steady load, too, such a host's velocities are means over a step, half a kick ΔtM⁻¹W/2
//! behind the place. The engine begins with as much of it added as its own velocities, of the middle of its last
//! sub-step, are not behind; at rest on a fender, contact's and load's halves cancel.
//!
//! All of this is for a step that is as long as the last one. For others see [`super::lead`].

use crate::host::inertia;
use crate::host::settings::HostIntegration;
use crate::mass::InverseMatrix;
use crate::model::Mobility;
use crate::report::Wrench;
use crate::state::BodyState;
use crate::vec2::Vec2;

/// Velocity of the centre of gravity and rate of turn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Velocity {
    pub(super) linear_mps: Vec2,
    pub(super) yaw_radps: f64,
}

impl Velocity {
    pub(super) fn of(state: &BodyState) -> Velocity {
        Velocity { linear_mps: state.velocity_mps, yaw_radps: state.yaw_rate_radps }
    }

    /// The steady velocity that leads from one state to the other in `step_s`.
    pub(super) fn mean(from: &BodyState, to: &BodyState, step_s: f64) -> Velocity {
        Velocity {
            linear_mps: (to.position_m - from.position_m) * (1.0 / step_s),
            yaw_radps: (to.heading_rad - from.heading_rad) / step_s,
        }
    }

    /// How fast a point so far from the centre of gravity may go by it, as a measure of both its parts (m/s).
    pub(super) fn at(self, radius_m: f64) -> f64 {
        self.linear_mps.length() + self.yaw_radps.abs() * radius_m
    }

    /// How far it leads in a time.
    pub(super) fn way(self, step_s: f64) -> Way {
        Way { linear_m: self.linear_mps * step_s, rotation_rad: self.yaw_radps * step_s }
    }

    pub(super) fn times(self, factor: f64) -> Velocity {
        Velocity { linear_mps: self.linear_mps * factor, yaw_radps: self.yaw_radps * factor }
    }

    pub(super) fn plus(self, other: Velocity) -> Velocity {
        Velocity {
            linear_mps: self.linear_mps + other.linear_mps,
            yaw_radps: self.yaw_radps + other.yaw_radps,
        }
    }

    pub(super) fn minus(self, other: Velocity) -> Velocity {
        Velocity {
            linear_mps: self.linear_mps - other.linear_mps,
            yaw_radps: self.yaw_radps - other.yaw_radps,
        }
    }

    /// The state moved with this velocity for `step_s`; its own velocity stays.
    pub(super) fn carry(self, state: &BodyState, step_s: f64) -> BodyState {
        BodyState {
            position_m: state.position_m + self.linear_mps * step_s,
            heading_rad: state.heading_rad + self.yaw_radps * step_s,
            ..*state
        }
    }

    /// The state with this velocity.
    pub(super) fn of_a_body_at(self, state: &BodyState) -> BodyState {
        BodyState { velocity_mps: self.linear_mps, yaw_rate_radps: self.yaw_radps, ..*state }
    }
}

/// How far a body is from another place, and turned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Way {
    pub(super) linear_m: Vec2,
    pub(super) rotation_rad: f64,
}

impl Way {
    pub(super) fn between(from: &BodyState, to: &BodyState) -> Way {
        Way {
            linear_m: to.position_m - from.position_m,
            rotation_rad: to.heading_rad - from.heading_rad,
        }
    }

    pub(super) fn plus(self, other: Way) -> Way {
        Way {
            linear_m: self.linear_m + other.linear_m,
            rotation_rad: self.rotation_rad + other.rotation_rad,
        }
    }

    /// The velocity that goes it in that time.
    pub(super) fn per(self, step_s: f64) -> Velocity {
        Velocity {
            linear_mps: self.linear_m * (1.0 / step_s),
            yaw_radps: self.rotation_rad / step_s,
        }
    }

    /// The state so far on; its velocity stays.
    pub(super) fn from(self, state: &BodyState) -> BodyState {
        BodyState {
            position_m: state.position_m + self.linear_m,
            heading_rad: state.heading_rad + self.rotation_rad,
            ..*state
        }
    }
}

/// What half a step of the load does.
pub(super) fn half_kick(
    inverse: &InverseMatrix,
    present: &BodyState,
    load: &Wrench,
    step_s: f64,
) -> Velocity {
    inertia::kick(inverse, present, load, 0.5 * step_s)
}

/// Where the engine begins, `lead` ahead of the host's velocity.
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
    velocity.plus(lead).of_a_body_at(&place)
}

/// Where a host comes to in a step that it ends with velocity `after`.
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

/// The wrench that brings the host's velocity to `after`, with its load.
pub(super) fn wrench(
    mobility: &Mobility,
    present: &BodyState,
    after: Velocity,
    load: &Wrench,
    step_s: f64,
) -> Wrench {
    let impulse = inertia::impulse_for(mobility, present, after.minus(Velocity::of(present)));
    let rate = 1.0 / step_s;
    Wrench {
        force_n: impulse.force_n * rate - load.force_n,
        moment_nm: impulse.moment_nm * rate - load.moment_nm,
    }
}
