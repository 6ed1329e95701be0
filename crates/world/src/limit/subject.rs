//! Says in words what a limit of motions, lines or fenders limits.

use super::{LimitSetup, Limited};
use crate::setup::Setup;

impl LimitSetup {
    /// The motion or load that the limit limits, in words.
    #[must_use]
    pub fn subject(&self, setup: &Setup) -> String {
        match self.what {
            Limited::Motion { vessel, motion, measure } => {
                let name = &setup.bodies[setup.world.vessels[vessel].body].name;
                format!("{} of {name}, {}", motion.word(), measure.word())
            }
            Limited::Lines => "largest tension of a line divided by its break load".to_owned(),
            Limited::Fenders => {
                "largest energy, deflection or reaction of a fender divided by its rating"
                    .to_owned()
            }
        }
    }
}
