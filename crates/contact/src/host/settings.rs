//! Properties of a co-simulation host.

/// How the host integrates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HostIntegration {
    /// Moves positions with the old velocities, then updates the velocities.
    #[default]
    ForwardEuler,
    /// Updates velocities first, then moves positions with the new velocities.
    SemiImplicit,
}

/// Properties of a co-simulation host.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HostSettings {
    /// Age of the states that the host passes, in steps; 0 for present states. In its first `delay_steps` steps the
    /// host passes the initial states.
    pub delay_steps: u32,
    /// The host's integrator.
    pub integration: HostIntegration,
}
