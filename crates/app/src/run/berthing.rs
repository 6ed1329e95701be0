//! Lines about the berthing energy, by formula and in the run, for the summary that `run` prints.

use core::fmt::Write as _;

use fenderline_report::plot::ordinal;
use fenderline_results::Outcome;
use fenderline_sim::berthing::{AddedMass, AddedMassFormula, BerthingOutcome};

use super::cells::{decimal, one_line};

/// Lines with the energy by the chosen formula and its factors, the energies by the other formulas, and the energy that
/// the fenders absorbed; empty if the scenario has no berthing study.
pub(super) fn lines(outcome: &Outcome<'_>) -> String {
    let Some(Ok(berthing)) = outcome.berthing else { return String::new() };
    let mut text = String::new();
    let _ = writeln!(text, "\nberthing: {}", by_formula(outcome, berthing));
    if berthing.energies_differ() {
        let _ = writeln!(
            text,
            "  {} kJ with the speed at the first touch, {} m/s: {}",
            decimal(berthing.energy_at_touch_j / 1e3, 0),
            decimal(berthing.speed_mps.abs(), 3),
            berthing.why_speeds_differ()
        );
    }
    let _ = writeln!(text, "  {}", by_other_formulas(berthing));
    let _ = writeln!(text, "  in the run the fenders took {}", in_the_run(berthing));
    let _ = writeln!(text, "  {}", berthing.mass_of_run());
    let _ = writeln!(text, "  it differs from the formula's: {}", berthing.why_masses_differ());
    text
}

fn by_formula(outcome: &Outcome<'_>, berthing: &BerthingOutcome) -> String {
    let abnormal = berthing.abnormal_energy_j.map_or_else(String::new, |abnormal_j| {
        format!(" ({} kJ abnormal)", decimal(abnormal_j / 1e3, 0))
    });
    let touched = match berthing.fenders.as_slice() {
        [one] => one_line(&outcome.setup.fenders[*one].name),
        several => format!("{} fenders at once", several.len()),
    };
    let speed = if berthing.design_speed_mps.is_some() {
        "the speed of the approach"
    } else {
        "the speed at the first touch"
    };
    format!(
        "{} kJ by the formula{abnormal}, on {touched} with {speed}, {} m/s, Cm {} {} and Ce {}",
        decimal(berthing.energy_j / 1e3, 0),
        decimal(berthing.formula_speed_mps(), 3),
        decimal(berthing.chosen_added_mass, 2),
        by(berthing.chosen),
        decimal(berthing.eccentricity, 2)
    )
}

fn by_other_formulas(berthing: &BerthingOutcome) -> String {
    let all = AddedMassFormula::ALL.iter().zip(berthing.added_mass).zip(berthing.energies_j);
    let others = all.filter(|((formula, _), _)| AddedMass::By(**formula) != berthing.chosen);
    let others: Vec<String> = others
        .filter_map(|((formula, cm), energy_j)| {
            let (cm, kj) = (decimal(cm?, 2), decimal(energy_j? / 1e3, 0));
            Some(format!("{kj} kJ with Cm {cm} by {}", formula.name()))
        })
        .collect();
    others.join(", ")
}

/// The energy that the fenders absorbed in the first hit, and in the largest later hit.
fn in_the_run(berthing: &BerthingOutcome) -> String {
    let piles = match berthing.pile_energy_j {
        pile_j if pile_j > 0.0 => format!(" and their piles {} kJ", decimal(pile_j / 1e3, 0)),
        _ => String::new(),
    };
    let fender_kj = decimal(berthing.fender_energy_j / 1e3, 0);
    let mut text = format!("{fender_kj} kJ{piles} in the first hit");
    if let Some(later) = berthing.later {
        let (energy_kj, at_s) = (decimal(later.energy_j / 1e3, 0), decimal(later.at_s, 1));
        text += &format!(", {energy_kj} kJ in the {} hit at {at_s} s", ordinal(later.number));
    }
    text
}

/// Says by which formula an added mass coefficient Cm was computed.
fn by(added_mass: AddedMass) -> String {
    match added_mass {
        AddedMass::By(formula) => format!("by {}", formula.name()),
        AddedMass::Given(_) => "as given".to_owned(),
    }
}
