//! The report's section on passing ships.

use fenderline_results::Outcome;
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::passing::{Berth, DepthFactors, PassingSetup};
use maud::{Markup, html};

use crate::plot::{fixed, plain, significant};
use crate::run_page::tables::{ROWS, more, number};
use crate::{Head, table_head};

/// The tables of the passing ships, of their distances and speeds, and of the forces on the vessels.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let (setup, world) = (outcome.setup, outcome.world);
    let flow = &setup.world.flow;
    let name = |vessel: usize| setup.bodies[setup.world.vessels[vessel].body].name.as_str();
    html! {
        @if !flow.passing.is_empty() {
            div class="wide" {
                table {
                    (table_head(&[
                        Head::Name("Passing ship"),
                        Head::Number("Length × beam × draught", "m"),
                        Head::Name("Nearest vessel"),
                        Head::Number("Least gap", "m"),
                        Head::Number("at", "s"),
                        Head::Number("Speed there", "kn"),
                        Head::Name("Depth and berth"),
                    ]))
                    tbody {
                        @for (ship, totals) in flow.passing.iter().zip(&world.passing).take(ROWS) {
                            tr {
                                td class="name" { (ship.name) }
                                (number(&size(ship)))
                                @if let Some((vessel, nearest)) = totals.nearest {
                                    td class="name" { (name(vessel)) }
                                    (number(&fixed(nearest.distance_m, 1)))
                                    (number(&fixed(nearest.t_s, 0)))
                                    (number(&fixed(totals.speed_mps / KNOT_MPS, 1)))
                                }
                                td class="name" { (factors(ship)) }
                            }
                        }
                    }
                }
            }
            (more(flow.passing.len()))
        }
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Pushed vessel"),
                    Head::Number("Largest surge", "kN"),
                    Head::Number("at", "s"),
                    Head::Number("Largest sway", "kN"),
                    Head::Number("at", "s"),
                    Head::Number("Largest yaw", "MN·m"),
                    Head::Number("at", "s"),
                ]))
                tbody {
                    @for (vessel, totals) in world.vessels.iter().enumerate().take(ROWS) {
                        tr {
                            td class="name" { (name(vessel)) }
                            @for (peak, unit) in totals.passing.iter().zip([1e3, 1e3, 1e6]) {
                                (number(&significant(peak.value / unit, 3)))
                                (number(&fixed(peak.at_s, 0)))
                            }
                        }
                    }
                }
            }
        }
        p class="note" {
            "Forces by the flow of slender ships (Wang 1975), about midship: surge positive \
             forward, sway and yaw to starboard. When a ship passes abreast, the sway force is \
             towards the passing ship. The flow has no waves and no lift."
            @if flow.passing.iter().any(|ship| ship.depth == DepthFactors::Kriebel) {
                " " strong { "Recalled" }
                ": the factors for the depth (Kriebel 2005) are recalled, and were compared with \
                 one worked case."
            }
            @if flow.passing.iter().any(|ship| ship.berth == Berth::Quay) {
                " " strong { "Estimate" } ": the factors for a quay are an estimate."
            }
        }
    }
}

fn size(ship: &PassingSetup) -> String {
    let hull = &ship.hull;
    let [length, beam, draught] =
        [hull.length_m, hull.beam_m, hull.draught_m].map(|value| plain(value, 4));
    format!("{length} × {beam} × {draught}")
}

fn factors(ship: &PassingSetup) -> &'static str {
    match (ship.depth, ship.berth) {
        (DepthFactors::DeepWater, Berth::Open) => "deep water, open jetty",
        (DepthFactors::DeepWater, Berth::Quay) => "deep water, quay",
        (DepthFactors::Kriebel, Berth::Open) => "factors for depth, open jetty",
        (DepthFactors::Kriebel, Berth::Quay) => "factors for depth, quay",
    }
}
