//! Properties of a co-simulation host.

/// How the host integrates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HostIntegration {
    /// Positions with the old velocities, then the velocities.
    #[default]
    ForwardEuler,
    /// Velocities first, then positions with the new velocities.
    SemiImplicit,
}

/// Properties of a co-simulation host.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HostSettings {
    /// Age of the states that the host passes, in steps; 0 for present states. In its first steps such a host passes its
    /// initial states until they are that old.
    pub delay_steps: u32,
    /// The host's integrator.
    pub integration: HostIntegration,
}
