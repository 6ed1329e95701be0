//! Placeholder until the waves are written.
