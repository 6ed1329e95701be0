//! Hours that a berth loses to the weather.
//!
//! | file | content |
//! |---|---|
//! | `downtime/quantity.rs` | the columns of a weather, and the keys that they set |
//! | `downtime/time.rs` | times of a series |
//! | `downtime/weather.rs` | reads and checks a series or scatter diagram |
//! | `downtime/states.rs` | puts hours that are alike together |
//! | `downtime/plan.rs` | the runs: a state each, and hours as they are |
//! | `downtime/outcome.rs` | how a run ended |
//! | `downtime/count.rs` | counts the hours that are lost, by reason, month and direction |
//! | `downtime/check.rs` | compares hours as they are with their states |
//! | `downtime/files.rs` | the tables of it |

mod check;
mod count;
mod files;
mod outcome;
mod plan;
mod quantity;
mod states;
mod time;
mod weather;

pub use check::StatesCheck;
pub use count::{Count, DowntimeError, DowntimeTable, Group, Reason, SECTOR_NAMES};
pub use files::{DOWNTIME_CSV, DOWNTIME_JSON, HOURS_CSV, downtime_csv, downtime_json, hours_csv};
pub use outcome::Outcome;
pub use plan::DowntimePlan;
pub use quantity::{Agent, Quantity};
pub use weather::{HOURS_OF_A_YEAR, Weather};

pub(crate) use plan::{BETWEEN, Given, LOST_BY};
