//! The world around the bodies of a set-up: everything that acts on them besides contact and plain loads.

mod setup;

pub use setup::{ProviderSetup, WorldSetup};
