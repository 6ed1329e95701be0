//! The table of anchors.

use fenderline_contact::number::greater;
use fenderline_sim::AnchorAtWork;
use fenderline_sim::anchor::AnchorPosition;

use super::{Column, Layout, List, flag, float, known, name, word};
use crate::row::Row;

/// A row of the table of anchors: one anchor in one output interval.
pub(crate) struct AnchorRow {
    t_s: f64,
    anchor: usize,
    state: &'static str,
    place_m: Option<[f64; 2]>,
    chain_m: f64,
    on_bottom_m: f64,
    tension_n: f64,
    peak_tension_n: f64,
    lead_rad: Option<f64>,
    holding_n: f64,
    dragged_m: f64,
    dragging: bool,
}

impl AnchorRow {
    /// The row of anchor number `anchor` of a ship with the given heading.
    pub(crate) fn new(t_s: f64, anchor: usize, heading_rad: f64, now: &AnchorAtWork) -> AnchorRow {
        let AnchorAtWork { state, load, .. } = now;
        let place_m = match state.position {
            AnchorPosition::OnBottom(at_m) => Some([at_m.x, at_m.y]),
            _ => None,
        };
        AnchorRow {
            t_s,
            anchor,
            state: state.position.word(),
            place_m,
            chain_m: state.chain_m,
            on_bottom_m: load.on_bottom_m,
            tension_n: load.tension_n,
            peak_tension_n: greater(load.tension_n, load.lost_at_n.unwrap_or(0.0)),
            lead_rad: load.lead_rad(heading_rad),
            holding_n: load.holding_n,
            dragged_m: load.moved_m,
            dragging: state.dragging,
        }
    }
}

impl Row for AnchorRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.anchor
    }

    fn join(&mut self, later: AnchorRow) {
        self.tension_n += later.tension_n;
        self.peak_tension_n = greater(self.peak_tension_n, later.peak_tension_n);
        self.dragged_m += later.dragged_m;
        self.dragging |= later.dragging;
    }

    fn close(&mut self, own: f64, _all: f64) {
        self.tension_n /= own;
    }
}

/// The table `anchors`.
pub(crate) fn anchors_table() -> Layout<AnchorRow> {
    let columns: Vec<Column<AnchorRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("anchor", "name of the anchor", List::Anchors, |r| Some(r.anchor)),
        word(
            "state",
            "`housed`, `hanging`, `on_bottom` or `lost`, at the start of the interval",
            |r| r.state,
        ),
        known(
            "x_m",
            "m",
            "place of the anchor on the bottom, north, at the start of the interval",
            |r| r.place_m.map(|[north_m, _]| north_m),
        ),
        known(
            "y_m",
            "m",
            "place of the anchor on the bottom, east, at the start of the interval",
            |r| r.place_m.map(|[_, east_m]| east_m),
        ),
        float(
            "chain_out_m",
            "m",
            "length of chain out from the hawse pipe at the start of the interval",
            |r| r.chain_m,
        ),
        float(
            "on_bottom_m",
            "m",
            "length of chain on the bottom at the start of the interval",
            |r| r.on_bottom_m,
        ),
        float("tension_n", "N", "mean tension of the chain at the hawse pipe", |r| r.tension_n),
        float(
            "peak_tension_n",
            "N",
            "largest tension in a step of the interval; for a chain that parts or runs out, the \
             tension at that moment",
            |r| r.peak_tension_n,
        ),
        known(
            "lead_rad",
            "rad",
            "direction of the chain from the bow, positive to starboard, at the start of the \
             interval; empty if the chain leads straight down",
            |r| r.lead_rad,
        ),
        float(
            "holding_n",
            "N",
            "holding force of anchor and chain against a horizontal pull at the start of the \
             interval",
            |r| r.holding_n,
        ),
        float("dragged_m", "m", "how far the anchor dragged in the interval", |r| r.dragged_m),
        flag("dragging", "whether the anchor dragged in the interval", |r| r.dragging),
    ];
    Layout { name: "anchors", rows: "one row per anchor and interval", columns }
}
