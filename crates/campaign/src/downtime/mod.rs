//! Hours that a berth loses to the weather.
//!
//! | file | content |
//! |---|---|
//! | `downtime/quantity.rs` | the columns of a weather file, and the scenario keys that these columns set |
//! | `downtime/time.rs` | times of a series |
//! | `downtime/weather.rs` | reads and checks the weather: a series of hours or a scatter diagram |
//! | `downtime/states.rs` | groups similar hours of the weather into states |
//! | `downtime/plan.rs` | the runs: one for each state, and one for each sampled hour |
//! | `downtime/outcome.rs` | how a run ended |
//! | `downtime/count.rs` | counts the hours that are lost, by reason, month and direction |
//! | `downtime/check.rs` | compares sampled hours with the states that stand for them |
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
