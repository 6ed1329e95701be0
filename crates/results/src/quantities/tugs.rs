//! The quantities of a tug that is a force at a ship's side.

use fenderline_sim::TugSetup;

use super::scales::{KILONEWTONS, SECONDS, TONNES_FORCE};
use super::{Catalogue, given, number, shown};
use crate::world_totals::TugTotals;

/// Tugs.
pub static TUGS: Catalogue<TugSetup, TugTotals> = Catalogue {
    subject: "tug",
    quantities: &[
        given("bollard_pull_n", "N", "bollard pull", |s| Some(s.tug.envelope.bollard_pull_n)),
        number("peak_force_n", "N", "largest force", |_, t: &TugTotals| t.force_n.value)
            .output("force", KILONEWTONS),
        number("peak_force_at_s", "s", "start of the step of the largest force", |_, t| {
            t.force_n.at_s
        }),
        number("at_work_s", "s", "time at work", |_, t: &TugTotals| t.at_work.s())
            .output("at_work", SECONDS),
        number(
            "limited_s",
            "s",
            "time in which speed and angle allowed less than the ordered force",
            |_, t| t.limited.s(),
        ),
    ],
    shown: &[
        shown("Bollard pull", "bollard_pull_n", KILONEWTONS).sheet(11.0),
        shown("Bollard pull", "bollard_pull_n", TONNES_FORCE).sheet(11.0),
        shown("Peak force", "peak_force_n", KILONEWTONS).sheet(11.0),
        shown("Peak force", "peak_force_n", TONNES_FORCE).sheet(11.0),
        shown("At", "peak_force_at_s", SECONDS).sheet(10.0),
        shown("Time at work", "at_work_s", SECONDS).sheet(10.0),
        shown("Time with limited force", "limited_s", SECONDS).sheet(13.0),
    ],
};
