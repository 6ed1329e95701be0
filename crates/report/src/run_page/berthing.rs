//! The report's section that compares a berthing by PIANC's formula with the run.

use fenderline_sim::berthing::{
    AddedMass, AddedMassFormula, BerthingError, BerthingOutcome, BerthingSetup, LaterHit,
};
use maud::{Markup, html};

use super::tables::number;
use crate::plot::{decimals_for, fixed, ordinal, plain, significant};
use crate::{Head, table_head};
use fenderline_results::Outcome;

/// Differences of the eccentricity coefficient Ce below this share are within the uncertainty of the formula.
const ALIKE: f64 = 0.05;

/// Writes the section; empty if the scenario does not ask for a berthing study.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let Some(setup) = &outcome.setup.berthing else { return html! {} };
    html! {
        h2 { "Berthing energy by formula and in the run" }
        @match outcome.berthing {
            None => p { "The ship touched no fender, so there is nothing to compare with the formula." },
            Some(Err(error)) => (refused(error)),
            Some(Ok(berthing)) => {
                (particulars(outcome, setup, berthing))
                (factors(berthing))
                (abnormal(outcome, berthing))
                (meaning(outcome, berthing))
            }
        }
    }
}

/// The factors of the formula in one sentence, with the added mass coefficient Cm that is used, and the Cm of the other
/// formulas.
pub(super) fn factors_in_words(berthing: &BerthingOutcome) -> String {
    let chosen = match berthing.chosen {
        AddedMass::By(formula) => format!("by {}", formula.name()),
        AddedMass::Given(_) => "as given".to_owned(),
    };
    let others = AddedMassFormula::ALL.into_iter().zip(berthing.added_mass);
    let others = others.filter(|(formula, _)| berthing.chosen != AddedMass::By(*formula));
    let others: Vec<String> = others
        .filter_map(|(formula, cm)| Some(format!("{} {}", formula.name(), fixed(cm?, 2))))
        .collect();
    format!(
        "Cm {} {chosen} (others: {}; in the run {}); Ce {}; Cs {}; Cc {}",
        fixed(berthing.chosen_added_mass, 3),
        if others.is_empty() { "none applies".to_owned() } else { others.join(", ") },
        fixed(berthing.added_mass_simulated, 2),
        fixed(berthing.eccentricity, 3),
        fixed(berthing.softness, 3),
        fixed(berthing.configuration, 3)
    )
}

fn refused(error: &BerthingError) -> Markup {
    html! { p { (format!("The formulas do not apply to this first touch: {error}.")) } }
}

fn particulars(outcome: &Outcome<'_>, setup: &BerthingSetup, berthing: &BerthingOutcome) -> Markup {
    let ship = &outcome.setup.bodies[setup.ship].name;
    let fenders: Vec<&str> =
        berthing.fenders.iter().map(|&index| outcome.setup.fenders[index].name.as_str()).collect();
    let decimals = decimals_for(outcome.setup.step_s);
    let side = if berthing.along_m < 0.0 { "aft" } else { "forward" };
    html! {
        dl {
            dt { "Ship" }
            dd {
                (ship) ", " (plain(berthing.displacement_kg / 1e3, 6)) " t"
                @if let Some(other) = berthing.other {
                    " (the reduced mass M₁M₂/(M₁ + M₂) of two ships; the other ship has "
                    (plain(other.displacement_kg / 1e3, 6)) " t)"
                }
                "; length between perpendiculars "
                (plain(setup.length_bp_m, 5)) " m, beam " (plain(setup.beam_m, 5)) " m, draught "
                (plain(setup.draught_m, 4)) " m, under-keel clearance "
                (plain(setup.under_keel_clearance_m, 4)) " m, block coefficient "
                (plain(setup.block_coefficient, 3))
            }
            dt { "First touch" }
            dd {
                "on " (fenders.join(", ")) @if fenders.len() > 1 { " at once" } " at "
                (fixed(berthing.first_touch_s, decimals)) " s, "
                @if fenders.len() > 1 && berthing.along_m == 0.0 {
                    "on both sides of the centre of gravity, which leaves no rotation"
                } @else {
                    @if fenders.len() > 1 { "the nearest " }
                    (fixed(berthing.along_m.abs(), 1)) " m " (side) " of the centre of gravity"
                }
                "; " (fixed(berthing.speed_mps, 3)) " m/s square to the face, berthing angle "
                (fixed(berthing.angle_rad.to_degrees(), 1)) "°"
            }
            dt { "Energy by the formula" }
            dd {
                (significant(berthing.energy_j / 1e3, 4)) " kJ with Cm "
                (fixed(berthing.chosen_added_mass, 3)) " "
                @match berthing.chosen {
                    AddedMass::By(formula) => { "by " (formula.name()) }
                    AddedMass::Given(_) => "as given",
                }
                ", and "
                @if berthing.design_speed_mps.is_some() { "the design speed of the approach, " }
                @else { "the speed at the first touch, " }
                (fixed(berthing.formula_speed_mps(), 3)) " m/s"
                @if berthing.energies_differ() {
                    "; " (significant(berthing.energy_at_touch_j / 1e3, 4)) " kJ with the "
                    (fixed(berthing.speed_mps.abs(), 3)) " m/s at the first touch: " (berthing.why_speeds_differ())
                }
            }
            dt { "Added mass" }
            dd { (berthing.mass_of_run()) ". The Cm differ because " (berthing.why_masses_differ()) "." }
        }
    }
}

fn factors(berthing: &BerthingOutcome) -> Markup {
    let factor = |value: f64| number(&fixed(value, 3));
    let energy = |value_j: f64| number(&significant(value_j / 1e3, 4));
    let later_j = berthing.later.map(|later| later.energy_j);
    let twice = |text: &str| html! { (number(text)) (number(text)) };
    let same = |value: f64| html! { @for _ in AddedMassFormula::ALL { (factor(value)) } };
    let or_none = |value: Option<Markup>| value.unwrap_or_else(|| number("–"));
    let abnormal = berthing.abnormal_energy_j.map(|abnormal_j| abnormal_j / berthing.energy_j);
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("E = ½ M V² · Cm · Ce · Cs · Cc"),
                    Head::Number("PIANC 2002", "Cm by draught and clearance"),
                    Head::Number("Ueda", "Cm by block coefficient"),
                    Head::Number("Vasco Costa", "Cm by draught over beam"),
                    Head::Number("UFC 4-152-01", "Cm by draught, beam, depth"),
                    Head::Number("Run", "first hit"),
                    Head::Number("Run", "largest later hit"),
                ]))
                tbody {
                    tr {
                        td class="name" { "Added mass Cm" }
                        @for cm in berthing.added_mass { (or_none(cm.map(factor))) }
                        (twice(&fixed(berthing.added_mass_simulated, 3)))
                    }
                    tr {
                        td class="name" { "Eccentricity Ce" }
                        (same(berthing.eccentricity))
                        (factor(berthing.eccentricity_measured))
                        (or_none(later_j.map(|later_j| factor(later_j / berthing.kinetic_j))))
                    }
                    tr {
                        td class="name" { "Softness Cs" }
                        (same(berthing.softness))
                        (twice("1"))
                    }
                    tr {
                        td class="name" { "Configuration Cc" }
                        (same(berthing.configuration))
                        (twice("1"))
                    }
                    tr class="sum" {
                        td class="name" { "Energy into the fenders [kJ]" }
                        @for energy_j in berthing.energies_j { (or_none(energy_j.map(energy))) }
                        (energy(berthing.fender_energy_j))
                        (or_none(later_j.map(energy)))
                    }
                    @if berthing.pile_energy_j > 0.0 {
                        tr {
                            td class="name" { "Energy into the piles of dolphins [kJ]" }
                            @for _ in berthing.energies_j { (or_none(None)) }
                            (energy(berthing.pile_energy_j))
                            (or_none(None))
                        }
                    }
                    @if let Some(factor) = abnormal {
                        tr {
                            td class="name" { "Abnormal berthing [kJ]" }
                            // One factor, whatever Cm.
                            @for energy_j in berthing.energies_j {
                                (or_none(energy_j.map(|energy_j| energy(energy_j * factor))))
                            }
                            (twice("–"))
                        }
                    }
                }
            }
        }
        div class="wide" {
            table class="narrow" {
                (table_head(&[
                    Head::Name("Eccentricity"),
                    Head::Number("Radius of gyration K", "m"),
                    Head::Number("Ce", "–"),
                ]))
                tbody {
                    tr {
                        td class="name" { "Formula, with the radius of gyration K by the formula" }
                        (number(&fixed(berthing.gyradius_m, 1)))
                        (factor(berthing.eccentricity))
                    }
                    tr {
                        td class="name" { "Formula, with the K of the simulated ship, added mass included" }
                        (number(&fixed(berthing.gyradius_simulated_m, 1)))
                        (factor(berthing.eccentricity_of_run))
                    }
                    tr class="strong" {
                        td class="name" {
                            "Measured in the first hit: energy in the fenders divided by ½ M V² Cm of the run"
                        }
                        (number(&fixed(berthing.gyradius_simulated_m, 1)))
                        (factor(berthing.eccentricity_measured))
                    }
                }
            }
        }
    }
}

/// Compares the abnormal energy with the capacity of the fender that took the most energy; empty if no factor or no
/// rating is given.
fn abnormal(outcome: &Outcome<'_>, berthing: &BerthingOutcome) -> Markup {
    let most = outcome.fenders.iter().max_by(|a, b| a.peak_energy_j.total_cmp(&b.peak_energy_j));
    let capacity = most.and_then(|fender| fender.capacity_j.map(|capacity_j| (fender, capacity_j)));
    let Some((abnormal_j, (fender, capacity_j))) = berthing.abnormal_energy_j.zip(capacity) else {
        return html! {};
    };
    html! {
        p {
            (format!(
                "The abnormal energy by the formula is {} % of the rated energy of one fender. This \
                 fender is {}, which took the largest energy; with its factors the rated energy is \
                 {} kJ. The formula gives the energy of one contact. How many fenders share this \
                 energy depends on their spacing and on the hull.",
                fixed(100.0 * abnormal_j / capacity_j, 0),
                outcome.setup.fenders[fender.fender].name,
                significant(capacity_j / 1e3, 4),
            ))
        }
    }
}

/// Explains the difference between the Ce that was measured in the run and the Ce of the formula.
fn meaning(outcome: &Outcome<'_>, berthing: &BerthingOutcome) -> Markup {
    let (measured, formula) = (berthing.eccentricity_measured, berthing.eccentricity_of_run);
    let off = measured / formula - 1.0;
    let larger = |later: &LaterHit| later.energy_j > (1.0 + ALIKE) * berthing.fender_energy_j;
    html! {
        p {
            "The formula's Ce is the share of the energy that one contact takes if it does not slip and ends \
            when the hull stops there. The rest of the energy remains as rotation of the ship. "
            @if off.abs() <= ALIKE {
                (format!(
                    "With the radius of gyration of the simulated ship, the energy that the fenders \
                     took in the first hit is within {} % of this share. ",
                    fixed(100.0 * ALIKE, 0),
                ))
            } @else {
                (format!(
                    "In the first hit the fenders took {} % {} than this share, with the radius of \
                     gyration of the simulated ship. ",
                    fixed(100.0 * off.abs(), 0),
                    if off > 0.0 { "more" } else { "less" },
                ))
                @if off > 0.0 {
                    "The loads during the hit, an initial turn or speed along the berth, or \
                     neighbouring fenders on the other side of the centre of gravity add energy. "
                } @else {
                    "Friction and damping took a part of the energy, or the hull slid along the face. "
                }
            }
            @if let Some(later) = berthing.later.filter(larger) {
                (format!(
                    "In the {} hit, at {} s, the fenders took {} times as much: the energy that the \
                     formula leaves in the ship's rotation reaches the fenders when the ship swings \
                     in, together with the work of the loads. ",
                    ordinal(later.number),
                    fixed(later.at_s, decimals_for(outcome.setup.step_s)),
                    fixed(later.energy_j / berthing.fender_energy_j, 1),
                ))
            }
        }
        p class="note" {
            "In the run the hull is rigid and there is no water cushion between hull and berth: Cs \
             and Cc are 1. If the hull meets several fenders at once, Ce is for a point on the \
             line between the two outermost of these fenders: the point nearest to the centre of \
             gravity. The formula of UFC 4-152-01 is taken from a public calculator, the other \
             formulas from public manuals; we did not read the text of PIANC's guidelines, and no \
             conformity with them is claimed."
        }
    }
}
