//! The quantities of a chain of a fender that was touched.

use fenderline_sim::{ChainKind, ChainSetup, ChainSummary};

use super::scales::{
    KILONEWTONS, MEGANEWTONS_PER_M, METRES, MILLIMETRES, PERCENT, SECONDS, TONNES_FORCE, WORD,
};
use super::{Catalogue, given, known, number, shown, word};

/// Chains of fenders.
pub static CHAINS: Catalogue<ChainSetup, ChainSummary> = Catalogue {
    subject: "chain",
    quantities: &[
        word("kind", "the motion or load that the chain holds", |_, c| Some(c.kind.word())),
        given("break_load_n", "N", "break load", |s| Some(s.break_load_n)),
        number("peak_tension_n", "N", "largest tension", |_, c| c.peak_tension_n),
        number("peak_tension_at_s", "s", "start of the step of the largest tension", |_, c| {
            c.peak_tension_at_s
        }),
        number(
            "share_of_break_load",
            "1",
            "largest tension as a share of the break load",
            |_, c| c.share_of_break_load,
        ),
        given("at_m", "m", "place of a tension chain to the right of the panel's middle", |s| {
            (s.kind == ChainKind::Tension).then_some(s.at_m)
        }),
        given(
            "slack_m",
            "m",
            "slack: motion of the panel before the chain holds",
            |s: &ChainSetup| (s.kind != ChainKind::Weight).then_some(s.slack_m),
        )
        .not_in_summary(),
        given("stiffness_npm", "N/m", "stiffness", |s: &ChainSetup| {
            (s.kind != ChainKind::Weight).then_some(s.stiffness_npm)
        })
        .not_in_summary(),
        known("parted_at_s", "s", "start of the step in which the chain parted", |_, c| {
            c.parted_at_s
        }),
    ],
    shown: &[
        shown("Kind", "kind", WORD).sheet(10.0),
        shown("Right of the middle", "at_m", METRES).sheet(11.0),
        shown("Slack", "slack_m", MILLIMETRES).sheet(9.0),
        shown("Stiffness", "stiffness_npm", MEGANEWTONS_PER_M).sheet(10.0),
        shown("Peak tension", "peak_tension_n", KILONEWTONS).sheet(11.0),
        shown("Peak tension", "peak_tension_n", TONNES_FORCE).sheet(11.0),
        shown("At", "peak_tension_at_s", SECONDS).sheet(10.0),
        shown("Break load", "break_load_n", KILONEWTONS).sheet(11.0),
        shown("Break load", "break_load_n", TONNES_FORCE).sheet(11.0),
        shown("of break load", "share_of_break_load", PERCENT).sheet(11.0),
        shown("Parted", "parted_at_s", SECONDS).sheet(10.0),
    ],
};
