//! Stage 4, force laws: normal and tangential force of a contact before the momentum limit.

pub(crate) mod damper;
pub(crate) mod friction;
pub(crate) mod normal;
