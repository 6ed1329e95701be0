//! How a run calculates motion and contact.

/// Time integrator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Forward Euler, as in Moreno et al. (2023): positions move with the old velocities.
    Euler,
    /// Semi-implicit Euler: first the velocities, then the positions with the new velocities. In the coupled method,
    /// the contact engine moves the bodies itself, as a leapfrog, in sub-steps where needed.
    SemiImplicit,
    /// Classical fourth-order Runge–Kutta. In the method of Moreno et al. (2023), each stage computes its own contact
    /// forces. In the coupled method, the mean contact wrench of the step acts in all stages.
    Rk4,
}

/// Contact method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The engine solves all contacts and loads of a step together, in sub-steps where needed, with the full mass
    /// matrix of each body.
    Coupled,
    /// The method of Moreno et al. (2023): the contact force of each pair of bodies is limited by itself (eq. 9–26 of
    /// their paper), with the smaller added mass in all directions.
    Paper,
}
