//! The constant part of a world.

/// What surrounds the bodies of a [`crate::Setup`]; empty by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldSetup {
    /// Programs that put forces on bodies.
    pub providers: Vec<ProviderSetup>,
}

/// A program that puts a force on a body each step: see [`crate::external`].
#[derive(Clone, Debug, PartialEq)]
pub struct ProviderSetup {
    /// Index of the body in [`crate::Setup::bodies`].
    pub body: usize,
    /// Program and arguments.
    pub command: Vec<String>,
    /// How long a step waits for its answer [s].
    pub timeout_s: f64,
    /// How long its last wrench is held when it falls silent [s].
    pub hold_s: f64,
}
