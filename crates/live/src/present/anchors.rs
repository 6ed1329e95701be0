//! Writes anchors into the scenario file: an anchor is home, or on the bottom with its chain. An anchor that hangs on
//! its chain is lowered again, when the file starts, from home to the length of its chain.

use fenderline_author::Edit;
use fenderline_sim::anchor::{AnchorFaults, AnchorPosition, WindlassOrder};
use fenderline_sim::{Action, AnchorAction, AnchorAtWork, Simulation};

use super::written::{place, rounded};

/// Writes every anchor into the file as it is now. A lost anchor is left out of the file, with its orders.
pub(super) fn edit(simulation: &Simulation, edits: &mut Vec<Edit>, notes: &mut Vec<String>) {
    for (anchor, setup) in simulation.anchors().iter().zip(&simulation.setup().world.anchors) {
        let name = setup.gear.name.as_str();
        let of = |key| ["anchor", name, key];
        if anchor.state.faults != AnchorFaults::default() {
            notes.push(format!("The anchor {name} has a fault, which the file leaves out."));
        }
        match anchor.state.position {
            AnchorPosition::OnBottom(at_m) => {
                let chain_m = rounded(anchor.state.chain_m, 4).to_string();
                edits.push(Edit::set(&of("placed"), place(at_m)));
                edits.push(Edit::set(&of("chain_out"), chain_m));
            }
            AnchorPosition::Housed => {
                edits.extend(["placed", "chain_out"].map(|key| Edit::remove(&of(key))));
            }
            AnchorPosition::Hanging => {
                edits.extend(["placed", "chain_out"].map(|key| Edit::remove(&of(key))));
                notes.push(format!(
                    "The anchor {name} hung on its chain: in the file it is lowered anew."
                ));
            }
            AnchorPosition::Lost(_) => {
                edits.push(Edit::remove(&["anchor", name]));
                notes.push(format!("The anchor {name} is lost: the file leaves it out."));
            }
        }
    }
}

/// True if the anchor is lost from its chain.
pub(super) fn is_lost(anchor: &AnchorAtWork) -> bool {
    matches!(anchor.state.position, AnchorPosition::Lost(_))
}

/// The orders to anchors that are in force at present.
pub(super) fn orders(simulation: &Simulation) -> impl Iterator<Item = Action> {
    simulation.anchors().iter().enumerate().filter_map(|(index, anchor)| {
        let hangs = anchor.state.position == AnchorPosition::Hanging;
        let action = match anchor.state.order {
            WindlassOrder::LetGo(chain_m) => AnchorAction::LetGo { chain_m },
            WindlassOrder::Veer(chain_m) => AnchorAction::Veer { chain_m },
            WindlassOrder::Heave(_) if hangs => return None,
            WindlassOrder::Heave(chain_m) => AnchorAction::Heave { chain_m },
            WindlassOrder::Hold if hangs => AnchorAction::Veer { chain_m: anchor.state.chain_m },
            WindlassOrder::Hold => return None,
        };
        (!is_lost(anchor)).then_some(Action::Anchor(index, action))
    })
}
