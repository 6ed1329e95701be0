//! Campaigns: many runs of one scenario with values that are drawn from distributions, their tables and statistics.

pub mod downtime;
mod draw;
mod error;
mod file;
mod limit;
pub mod report;
mod row;
mod run;
mod run_numbers;
pub mod statistics;
mod stop;
pub mod store;
pub mod table;
mod work;

pub use draw::{Drawn, Draws, Formula};
pub use error::CampaignError;
pub use file::law::{Law, LawFamily};
pub use file::schema::campaign_schema;
pub use file::{
    Campaign, Change, Choice, Correlation, Design, Downtime, Draw, MOST_CASES, Output, Plan,
    Statistic, Stop, Target, TargetOrigins, Variable,
};
pub use limit::Limit;
pub use row::{Cell, Head, Row};
pub use run::{Runner, Runs, Seen};
pub use run_numbers::RunNumbers;
pub use stop::StopRule;
pub use work::{MOST_THREADS, make};
