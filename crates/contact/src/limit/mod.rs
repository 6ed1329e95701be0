//! Stage 5, limit: contact forces that the momentum of the bodies allows.

pub(crate) mod effective_mass;
pub(crate) mod paper;
