//! The quantities of a mooring line.

use fenderline_sim::MooringSetup;

use super::scales::{KILONEWTONS, METRES, PERCENT, SECONDS, TONNES_FORCE};
use super::{Catalogue, flag, known, number, shown, word};
use crate::world_totals::LineTotals;

/// Mooring lines.
pub static LINES: Catalogue<MooringSetup, LineTotals> = Catalogue {
    subject: "line",
    quantities: &[
        word("verdict", "the verdict on the line", |_, l| Some(l.verdict().key())),
        number("peak_tension_n", "N", "largest tension", |_, l: &LineTotals| l.tension_n.value)
            .output("tension", KILONEWTONS),
        number("peak_tension_at_s", "s", "start of the step of the largest tension", |_, l| {
            l.tension_n.at_s
        }),
        number("over_working_load_s", "s", "time with a tension above the working load", |_, l| {
            l.over_working.s()
        }),
        number("rendered_m", "m", "length that the brake of the winch rendered", |_, l| {
            l.rendered_m
        }),
        flag("parted", "whether the line parted", |_, l| l.parted_s.is_some()),
        flag("fast_at_end", "whether the line is fast at the end of the run", |_, l| l.is_fast),
        number("last_tension_n", "N", "tension at the end of the run", |_, l| l.last_tension_n),
        known("made_fast_s", "s", "start of the first step in which the line was fast", |_, l| {
            l.made_fast_s
        }),
        known(
            "break_load_n",
            "N",
            "break load of the line: that of the weaker of rope and tail",
            |_, l| l.break_load_n,
        ),
        known("working_load_n", "N", "working load", |_, l| l.working_load_n),
        known(
            "share_of_break_load",
            "1",
            "largest tension as a share of the break load",
            |_, l: &LineTotals| l.share_of_break_load(),
        )
        .output("break_share", PERCENT),
        known(
            "share_of_working_load",
            "1",
            "largest tension as a share of the working load",
            |_, l: &LineTotals| l.share_of_working_load(),
        )
        .output("working_share", PERCENT)
        .not_in_summary(),
        known("parted_at_s", "s", "start of the step in which the line parted", |_, l| l.parted_s),
    ],
    shown: &[
        shown("Made fast", "made_fast_s", SECONDS).sheet(10.0),
        shown("Peak tension", "peak_tension_n", KILONEWTONS).sheet(12.0).printed(
            "peak tension",
            12,
            1,
        ),
        shown("Peak tension", "peak_tension_n", TONNES_FORCE).sheet(12.0),
        shown("At", "peak_tension_at_s", SECONDS).sheet(10.0).printed("at", 9, 1),
        shown("Break load", "break_load_n", KILONEWTONS).sheet(12.0),
        shown("of break load", "share_of_break_load", PERCENT).sheet(12.0).printed(
            "of break load",
            13,
            0,
        ),
        shown("Working load", "working_load_n", KILONEWTONS).sheet(12.0),
        shown("of working load", "share_of_working_load", PERCENT).sheet(12.0),
        shown("Time above working load", "over_working_load_s", SECONDS).sheet(13.0),
        shown("Rendered by its winch", "rendered_m", METRES).sheet(12.0),
        shown("Parted", "parted_at_s", SECONDS).sheet(10.0),
        shown("Tension at the end", "last_tension_n", KILONEWTONS).sheet(12.0),
    ],
};
