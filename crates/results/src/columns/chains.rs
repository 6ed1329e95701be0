//! The table of chains of fenders.

use fenderline_contact::number::greater;
use fenderline_sim::ChainTension;

use super::{Column, Layout, List, Value, flag, float, name};
use crate::row::Row;

/// A row of the table of chains: one fender chain in one output interval.
pub(crate) struct ChainRow {
    pub(crate) t_s: f64,
    pub(crate) chain: ChainTension,
}

impl Row for ChainRow {
    /// Fender, chain.
    type Key = (usize, usize);

    fn key(&self) -> Self::Key {
        (self.chain.fender, self.chain.chain)
    }

    fn join(&mut self, later: ChainRow) {
        let (now, next) = (&mut self.chain, &later.chain);
        now.peak_tension_n = greater(now.peak_tension_n, next.peak_tension_n);
        now.share_of_break_load = greater(now.share_of_break_load, next.share_of_break_load);
        now.has_parted |= next.has_parted;
    }

    fn close(&mut self, _own: f64, _all: f64) {}
}

/// The table `chains`.
pub(crate) fn chains_table() -> Layout<ChainRow> {
    let columns: Vec<Column<ChainRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("fender", "name of the fender", List::Fenders, |r| Some(r.chain.fender)),
        Column {
            name: "chain",
            unit: "1",
            meaning: "number of the chain in the fender's list, from 1",
            value: Value::Count(|r| r.chain.chain as u32 + 1),
        },
        Column {
            name: "kind",
            unit: "-",
            meaning: "tension, shear or weight",
            value: Value::Word(|r| r.chain.kind.word()),
        },
        float(
            "peak_tension_n",
            "N",
            "largest tension within the interval; for a chain that parts, the tension at which it \
             parts; 0 after that",
            |r| r.chain.peak_tension_n,
        ),
        float("share_of_break_load", "1", "largest tension as a share of the break load", |r| {
            r.chain.share_of_break_load
        }),
        flag("parted", "whether the chain has parted, in this interval or before", |r| {
            r.chain.has_parted
        }),
    ];
    Layout {
        name: "chains",
        rows: "one row per chain and interval in which the chain's fender is touched",
        columns,
    }
}
