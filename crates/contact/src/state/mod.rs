//! What a step reads and writes: states of bodies, memory of contacts, buffers, results and snapshots.

pub(crate) mod body_state;
pub(crate) mod bytes;
pub(crate) mod events;
pub(crate) mod memory;
pub(crate) mod report;
pub(crate) mod results;
pub(crate) mod snapshot;
pub(crate) mod workspace;
