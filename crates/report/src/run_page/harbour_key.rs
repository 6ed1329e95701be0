//! The legend for the parts of a harbour in the plan views.

use fenderline_results::Outcome;
use maud::{Markup, html};

use super::scene::depth_limits;
use crate::plot::{chart_note, harbour_legend, planned_legend};

/// The legend for mooring lines, tugs, banks and passing ships, if there are any.
pub(super) fn harbour(outcome: &Outcome<'_>) -> Markup {
    let world = &outcome.setup.world;
    let (has_lines, has_tugs) = (!world.lines.is_empty(), !world.tugs.is_empty());
    let has_banks = !world.environment.banks.is_empty();
    let has = [has_lines, has_tugs, has_banks, !world.flow.passing.is_empty()];
    html! {
        @if has.contains(&true) { (harbour_legend(has)) }
        @if world.vessels.iter().any(|vessel| vessel.plan.is_some()) { (planned_legend()) }
        @if !world.chart.features.is_empty() {
            (chart_note(&world.chart, world.environment.bottom.is_some(), depth_limits(outcome).as_ref()))
        }
    }
}
