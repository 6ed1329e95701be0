//! Stage 4 of a step, the force laws: normal and tangential force of a contact before the momentum limit.

pub(crate) mod damper;
pub(crate) mod friction;
pub(crate) mod normal;
