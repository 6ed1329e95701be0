//! Reads the text of a single order to a vessel, tug, mooring line or anchor, for a simulation that is running.

use fenderline_sim::{Order, Setup};

use crate::assemble;
use fenderline_keys::error::ScenarioError;
use fenderline_keys::keys::order::ORDER;
use fenderline_keys::sources::Sources;
use fenderline_keys::{reader, syntax};

/// Reads the keys of one `[[order]]`, written without the line `[[order]]`, as an order within a set-up. `name` is the
/// name of the text in messages.
///
/// ```
/// # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/berth/alongside_with_two_tugs.toml");
/// # let scenario = fenderline_scenario::Scenario::load(file.as_ref(), &[])?;
/// use fenderline_scenario::order;
/// use fenderline_sim::{Action, VesselAction};
/// let port_ten = order("vessel = 'ship'\nrudder = '-10 deg'", "helm", &scenario.setup)?;
/// assert_eq!(port_ten.action, Action::Vessel(0, VesselAction::Rudder(-10f64.to_radians())));
/// let error = order("vessel = 'ship'\nruder = 0", "helm", &scenario.setup).unwrap_err();
/// assert_eq!((error.line(), error.key()), (Some(2), Some("order.ruder")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Returns the first mistake found in the text, as for a scenario.
pub fn order(text: &str, name: &str, setup: &Setup) -> Result<Order, ScenarioError> {
    let sources = Sources::new(name, text, &[]);
    let document = syntax::parse(&sources)?;
    let end = text.trim_end().len();
    let table = reader::table(&sources, &ORDER, "order", end..end, &document)?;
    assemble::order(&sources, table.of(), setup)
}
