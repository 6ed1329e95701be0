//! What is known of a host.

/// How the host goes from a state to the next with the wrench it was given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HostIntegration {
    /// Positions with the old velocities, then the velocities.
    #[default]
    ForwardEuler,
    /// Velocities first, then positions with the new velocities.
    SemiImplicit,
}

/// What is known of a host.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HostSettings {
    /// Age of the states that the host shows, in its steps: 0 where it shows the present ones. In its
    /// first steps such a host shows its initial states until they are that old.
    pub delay_steps: u32,
    /// The host's integrator.
    pub integration: HostIntegration,
}
