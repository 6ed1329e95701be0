//! The forces of passing ships, of other vessels and of banks on each vessel, in a step, from the flow of
//! [`fenderline_ship::passing`].

mod act;
mod banks;

pub use act::{FULL_FLOW_GAP, Vessels, act, gap_in_beams, shallowest_on_track_m};
pub use banks::act_of_banks;
