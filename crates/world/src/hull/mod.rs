//! Hulls with outlines at several heights, and the outline that each fender meets (docs/contact_model.md, section 8).
//!
//! | file | content |
//! |---|---|
//! | `hull/level.rs` | an outline at a height |
//! | `hull/levels.rs` | a hull with outlines at several heights, and the checks of the outlines |
//! | `hull/resample.rs` | resampling of outlines with different numbers of vertices at common stations |
//! | `hull/cut.rs` | the outline at a height, with heel and trim |
//! | `hull/heights.rs` | heights of fenders and hulls in a step |
//! | `hull/lean.rs` | fenders that lean with their ship |
//! | `hull/sides.rs` | the outlines that the fenders of a run meet, renewed before each step |

mod cut;
mod heights;
mod lean;
mod level;
mod levels;
mod resample;
mod sides;

pub use heights::{HeightWork, Heights};
pub use lean::leaning_bodies;
pub use level::Level;
pub use levels::{HullByHeight, HullError};
pub use sides::{HullTouch, SideMissed};
pub use sides::{Sides, larger_force_n, place_m};
