//! What a limit is on, in words.

use super::{LimitSetup, Limited};
use crate::setup::Setup;

impl LimitSetup {
    /// What is limited, in words.
    #[must_use]
    pub fn subject(&self, setup: &Setup) -> String {
        match self.what {
            Limited::Motion { vessel, motion, measure } => {
                let name = &setup.bodies[setup.world.vessels[vessel].body].name;
                format!("{} of {name}, {}", motion.word(), measure.word())
            }
            Limited::Lines => "largest tension of a line over its break load".to_owned(),
            Limited::Fenders => "largest use of a fender over its rating".to_owned(),
        }
    }
}
