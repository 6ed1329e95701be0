//! Drawings of a fender system: plan and elevation of a face with its fenders, and a section through one of the
//! fenders.

mod face;
mod panel;
mod scale;
mod section;

pub use face::{Face, FaceFender, Hull, Level, LevelKind};
pub use panel::{ConeDrawn, PanelPlan};
pub use section::{Chain, Section, Side};
