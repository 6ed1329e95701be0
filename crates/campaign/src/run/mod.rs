//! One run of a campaign, and the numbers that are kept from the run.

mod columns;
mod motion;
mod named;
mod numbers;
mod outputs;
mod runner;
mod seen;

pub use self::runner::{Runner, Runs};
pub use self::seen::Seen;
