//! The quantities of an anchor.

use fenderline_sim::AnchorSetup;

use super::{Catalogue, number, word};
use crate::world_totals::AnchorTotals;

/// Anchors.
pub static ANCHORS: Catalogue<AnchorSetup, AnchorTotals> = Catalogue {
    subject: "anchor",
    quantities: &[
        word("verdict", "the verdict on the anchor", |_, a| Some(a.verdict().key())),
        number("break_load_n", "N", "break load of the chain", |_, a| a.break_load_n),
        number("peak_tension_n", "N", "largest tension of the chain at the hawse pipe", |_, a| {
            a.tension_n.value
        }),
        number("peak_tension_at_s", "s", "start of the step of the largest tension", |_, a| {
            a.tension_n.at_s
        }),
        number("most_chain_out_m", "m", "most chain out", |_, a| a.chain_m.value),
        number("on_bottom_s", "s", "time on the bottom", |_, a| a.on_bottom.s()),
        number("dragged_m", "m", "distance by which the anchor dragged", |_, a| a.dragged_m),
        number("dragging_s", "s", "time in which the anchor dragged", |_, a| a.dragging.s()),
        number("dragged_j", "J", "energy that the bottom absorbed from the anchor", |_, a| {
            a.dragged_j
        }),
        number("rendered_m", "m", "chain that the brake rendered", |_, a| a.rendered_m),
        word("state_at_end", "where the anchor is at the end of the run", |_, a| {
            Some(a.position.word())
        }),
        number("last_chain_out_m", "m", "chain out at the end of the run", |_, a| a.last_chain_m),
        number("last_tension_n", "N", "tension at the end of the run", |_, a| a.last_tension_n),
    ],
    shown: &[],
};
