//! Shared by the tests of the contact engine.

#![allow(dead_code, reason = "each test binary uses its own part")]
#![allow(unreachable_pub, reason = "modules of a test binary")]

pub mod exact;
pub mod harbour;
pub mod plain;
pub mod shapes;
