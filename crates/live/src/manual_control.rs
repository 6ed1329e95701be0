//! The vessels, tugs, lines and anchors that people have taken over from the scenario.

use std::collections::BTreeSet;

use fenderline_sim::order::Target;

/// The vessels, tugs, lines and anchors under manual control; the scenario's later orders to them are cancelled.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ManualControl(pub(crate) BTreeSet<Target>);
