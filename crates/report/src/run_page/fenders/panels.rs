//! Tables of panels on several cones, and of chains.

use fenderline_contact::number::greater;
use fenderline_results::Outcome;
use fenderline_sim::{
    ChainKind, ChainSetup, ChainSummary, ConeSummary, ConeUse, FenderSetup, FenderSummary,
};
use maud::{Markup, html};

use crate::plot::{decimals_for, fixed, plain, significant};
use crate::run_page::signed::signed;
use crate::run_page::tables::{ROWS, TONNE_N, more, number};
use crate::table::breakable;
use crate::{Head, table_head};

/// The tables of the touched fenders' panels and their cones; empty if there are none.
pub(super) fn panels(outcome: &Outcome<'_>) -> Markup {
    let with = outcome.fenders.iter().filter_map(|summary| {
        Some((&outcome.setup.fenders[summary.fender], summary, summary.panel.as_ref()?))
    });
    let all: Vec<_> = with.collect();
    if all.is_empty() {
        return html! {};
    }
    let decimals = decimals_for(outcome.setup.step_s);
    let cones = all.iter().flat_map(|(fender, summary, panel)| {
        let worst_m = panel.cones.iter().map(|cone| cone.peak_deflection_m).fold(0.0, greater);
        panel.cones.iter().enumerate().map(move |(index, cone)| {
            (*fender, *summary, index, cone, cone.peak_deflection_m >= worst_m && worst_m > 0.0)
        })
    });
    let cones: Vec<_> = cones.collect();
    html! {
        h3 { "Panels" }
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Panel of"),
                    Head::Number("Cones", ""),
                    Head::Number("Largest turn", "deg"),
                    Head::Number("at", "s"),
                    Head::Number("Largest moment", "kN·m (t·m)"),
                    Head::Number("at", "s"),
                ]))
                tbody {
                    @for (fender, _, panel) in all.iter().take(ROWS) {
                        tr {
                            td class="name" { (breakable(&fender.name)) }
                            (number(&panel.cones.len().to_string()))
                            (number(&fixed(panel.peak_tilt_rad.to_degrees(), 2)))
                            (number(&fixed(panel.peak_tilt_at_s, decimals)))
                            (number(&format!(
                                "{} ({})",
                                significant(panel.peak_moment_nm / 1e3, 3),
                                significant(panel.peak_moment_nm / TONNE_N, 3)
                            )))
                            (number(&fixed(panel.peak_moment_at_s, decimals)))
                        }
                    }
                }
            }
        }
        (more(all.len()))
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Cone of panel"),
                    Head::Number("No.", ""),
                    Head::Number("Place", "right of the middle, m"),
                    Head::Number("Deflection", "mm, % of rated"),
                    Head::Number("Reaction", "kN, % of rated"),
                    Head::Number("Energy", "kJ (kN·m), % of rated"),
                    Head::Number("Stretched", "mm"),
                ]))
                tbody {
                    @for &(fender, summary, index, cone, is_worst) in cones.iter().take(ROWS) {
                        tr class=[is_worst.then_some("strong")] {
                            (cone_cells(fender, summary, index, cone))
                        }
                    }
                }
            }
        }
        (more(cones.len()))
        ul class="note" {
            li {
                "The most compressed cone of each panel is marked: this cone governs, and the \
                 shares of the fender in the tables are those of this cone. The rating of a cone \
                 is its part of the panel's rating."
            }
            li {
                strong { "Turn and moment" }
                ". The turn of the panel is about the vertical axis, and the moment is that of the \
                 cones' reactions about the panel's middle. Both are positive if the right end, as \
                 seen from the water, is pressed more."
            }
            li {
                strong { "Reaction and energy" }
                ". Reaction and energy of a cone are those of its curve at its largest deflection, \
                 with the factor of the run."
            }
        }
    }
}

fn cone_cells(
    fender: &FenderSetup,
    summary: &FenderSummary,
    index: usize,
    cone: &ConeSummary,
) -> Markup {
    let used = ConeUse::of(fender, summary, cone.peak_deflection_m);
    let or_none = |text: Option<String>| text.unwrap_or_else(|| "–".to_owned());
    let deflection = fixed(cone.peak_deflection_m * 1e3, 0);
    let stretch_mm = fixed(cone.peak_stretch_m * 1e3, 0);
    html! {
        td class="name" { (breakable(&fender.name)) }
        (number(&(index + 1).to_string()))
        (number(&signed(cone.at_m)))
        (number(&with_share(deflection, used.and_then(|of| of.share_of_rated_deflection))))
        (number(&or_none(used.map(|of| {
            with_share(significant(of.peak_reaction_n / 1e3, 3), of.share_of_rated_reaction)
        }))))
        (number(&or_none(used.map(|of| {
            with_share(significant(of.peak_energy_j / 1e3, 3), of.share_of_rated_energy)
        }))))
        (number(&stretch_mm))
    }
}

/// The text of a value with its share of the rating beside it.
fn with_share(text: String, share: Option<f64>) -> String {
    match share {
        Some(share) => format!("{text} · {} %", fixed(100.0 * share, 0)),
        None => text,
    }
}

/// The table of the touched fenders' chains; empty if there are none.
pub(super) fn chains(outcome: &Outcome<'_>) -> Markup {
    let all: Vec<_> = outcome
        .fenders
        .iter()
        .flat_map(|summary| {
            let fender = &outcome.setup.fenders[summary.fender];
            fender
                .chains
                .iter()
                .zip(&summary.chains)
                .map(move |(chain, bore)| (fender, chain, bore))
        })
        .collect();
    if all.is_empty() {
        return html! {};
    }
    let decimals = decimals_for(outcome.setup.step_s);
    html! {
        h3 { "Chains" }
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Chain of"),
                    Head::Text("Kind", ""),
                    Head::Number("Slack", "mm"),
                    Head::Number("Stiffness", "MN/m"),
                    Head::Number("Peak tension", "kN (t)"),
                    Head::Number("at", "s"),
                    Head::Number("Break load", "kN (t)"),
                    Head::Number("Share", "% of break load"),
                    Head::Text("Verdict", ""),
                ]))
                tbody {
                    @for (fender, chain, bore) in all.iter().take(ROWS) {
                        tr { (chain_cells(fender, chain, bore, decimals)) }
                    }
                }
            }
        }
        (more(all.len()))
        p class="note" {
            "A chain is slack until the panel has moved by its slack in the direction that the \
             chain holds. The break load is from the scenario, without a safety factor. Place of a \
             tension chain: metres to the right of the panel's middle, as seen from the water."
        }
    }
}

fn chain_cells(
    fender: &FenderSetup,
    chain: &ChainSetup,
    bore: &ChainSummary,
    decimals: usize,
) -> Markup {
    let load = |force_n: f64| {
        format!("{} ({})", significant(force_n / 1e3, 3), significant(force_n / TONNE_N, 3))
    };
    html! {
        td class="name" { (breakable(&fender.name)) }
        td {
            (chain.kind.word())
            @if chain.kind == ChainKind::Tension { " at " (signed(chain.at_m)) " m" }
        }
        (number(&if chain.kind == ChainKind::Weight { "–".to_owned() } else { plain(chain.slack_m * 1e3, 4) }))
        (number(&if chain.kind == ChainKind::Weight { "–".to_owned() } else { plain(chain.stiffness_npm / 1e6, 4) }))
        (number(&load(bore.peak_tension_n)))
        (number(&if bore.peak_tension_n > 0.0 { fixed(bore.peak_tension_at_s, decimals) } else { "–".to_owned() }))
        (number(&load(chain.break_load_n)))
        (number(&fixed(100.0 * bore.share_of_break_load, 0)))
        td {
            @match bore.parted_at_s {
                Some(at_s) => {
                    span class="verdict failed" { "PARTED" }
                    small { "at " (fixed(at_s, decimals)) " s" }
                }
                None => span class="verdict ok" { "OK" },
            }
        }
    }
}
