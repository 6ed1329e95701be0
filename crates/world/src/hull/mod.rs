//! The hull by height: outlines at several heights, and the one that each fender meets (docs/contact_model.md, section 8).
//!
//! | file | content |
//! |---|---|
//! | `hull/levels.rs` | outlines at several heights, checked |
//! | `hull/resample.rs` | outlines with different numbers of vertices, at common stations |
//! | `hull/cut.rs` | the outline at a height, with heel and trim |
//! | `hull/sides.rs` | the outlines that the fenders of a run meet, renewed before each step |

mod cut;
mod levels;
mod resample;
mod sides;

pub use levels::{HullByHeight, HullError, Level};
pub use sides::{HeightWork, Heights, Sides, larger_force_n, place_m};
pub use sides::{HullTouch, SideMissed};
