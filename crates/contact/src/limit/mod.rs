//! Stage 5 of a step, the limit: contact forces that the momentum of the bodies allows.

pub(crate) mod effective_mass;
pub(crate) mod paper;
