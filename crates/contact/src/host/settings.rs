//! Properties of a co-simulation host: its delay and its integration method.

/// How the host integrates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HostIntegration {
    /// The host moves positions with the old velocities, and then updates the velocities.
    #[default]
    ForwardEuler,
    /// The host updates velocities first, and then moves positions with the new velocities.
    SemiImplicit,
}

/// Properties of a co-simulation host: its delay and its integration method.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HostSettings {
    /// Age of the states that the host passes, in steps; 0 for present states. In the first `delay_steps` steps of a
    /// run the host passes the initial states.
    pub delay_steps: u32,
    /// The host's integrator.
    pub integration: HostIntegration,
}
