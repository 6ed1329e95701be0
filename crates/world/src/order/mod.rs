//! Orders from a person, a file or another program to a vessel, a tug, a line or an anchor.
//!
//! [`OrderName`] is the table of all orders. For each order the table has the word, the target, the arguments with
//! units, limits and defaults, and the required gear. Scenario files, live sessions, Python and FMUs translate only
//! their own names into [`Arguments`] and call [`OrderName::build`]. [`check()`] is the only place where limits and
//! gear are checked. `docs/design/orders.md` explains the way of an order from a button on a page to the rudder.

mod action;
mod arguments;
mod build;
mod check;
mod error;
mod table;
mod tug_words;

pub use action::{Action, AnchorAction, LineAction, Order, Station, Target, VesselAction};
pub use arguments::{Arguments, Value};
pub use check::check;
pub use check::check_order;
pub use error::OrderError;
pub use table::{
    Absent, Argument, ArgumentKind, Frame, Gear, Named, OrderName, OrderSpec, TargetKind, Unit,
};
pub use tug_words::{Lead, SidePlace, TugWord, TugWords, Word, towline};
