//! Draws the values of the variables in each run, by the plan, the laws and the expressions. The values depend only on
//! the campaign and the number of the run.

mod copula;
mod formula;
mod plan;
mod prepared;
mod source;

pub use self::formula::Formula;
pub use self::prepared::{Drawn, Draws};
