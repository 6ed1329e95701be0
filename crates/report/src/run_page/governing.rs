//! The numbers that govern a design, in one list for the title page and the workbook.

use fenderline_contact::number::greater;
use fenderline_results::{LineTotals, Outcome, worst_first};
use fenderline_sim::berthing::BerthingOutcome;
use fenderline_sim::statistics::Limited;
use fenderline_sim::{DolphinSummary, FenderSummary, Finding, PanelSummary, Rated};

/// A governing number.
#[derive(Clone, Debug, PartialEq)]
pub struct Governing {
    /// Name of the quantity, such as `Reaction of a fender`.
    pub quantity: &'static str,
    /// The fender, mooring line, ship or contact to which the number belongs; empty if the number belongs to all
    /// together.
    pub subject: String,
    /// Value of the number, in `unit`.
    pub value: f64,
    /// Unit of the value.
    pub unit: &'static str,
    /// The number as a share of a limit, and the limit's name.
    pub share: Option<(f64, &'static str)>,
    /// Time at which the number occurred (s).
    pub at_s: Option<f64>,
    /// The hit of the berthing in which the number occurred, 1 for the first.
    pub hit: Option<u32>,
    /// Whether the number is above its limit.
    pub is_over: bool,
}

/// The governing numbers of a run, those of the fenders first.
#[must_use]
pub fn governing(outcome: &Outcome<'_>) -> Vec<Governing> {
    let mut all = Vec::new();
    fenders(outcome, &mut all);
    panels(outcome, &mut all);
    chains(outcome, &mut all);
    dolphins(outcome, &mut all);
    note_hits(outcome, &mut all);
    energies(outcome, &mut all);
    structure(outcome, &mut all);
    lines(outcome, &mut all);
    motions(outcome, &mut all);
    approach(outcome, &mut all);
    under_keel(outcome, &mut all);
    for of in &mut all {
        of.is_over = match of.share {
            // A curve that buckles can peak a little above its rated reaction.
            Some((_, RATED_REACTION)) => of.is_over,
            Some((share, _)) => share > 1.0,
            None => false,
        };
    }
    all
}

/// Notes for each governing number the hit of the berthing in which it occurred.
fn note_hits(outcome: &Outcome<'_>, all: &mut [Governing]) {
    let Some(Ok(berthing)) = outcome.berthing else { return };
    for of in all {
        of.hit = of.at_s.and_then(|at_s| berthing.hit_at(at_s));
    }
}

fn fenders(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let setups = &outcome.setup.fenders;
    let name = |summary: &FenderSummary| setups[summary.fender].name.clone();
    let first = worst_first(setups, outcome.fenders).first().map(|&i| &outcome.fenders[i]);
    let governing = first.and_then(|summary| {
        let (quantity, share) = summary.governing()?;
        let rated = setups[summary.fender].rated?;
        Some(of_fender(summary, rated, quantity, share))
    });
    let governs = governing.as_ref().map(|of| of.quantity);
    all.extend(
        governing.zip(first).map(|(of, summary)| Governing { subject: name(summary), ..of }),
    );
    let most =
        outcome.fenders.iter().max_by(|a, b| a.peak_reaction_n.total_cmp(&b.peak_reaction_n));
    if let Some(summary) = most.filter(|_| governs != Some(REACTION)) {
        all.push(Governing {
            quantity: "Largest reaction of a fender",
            subject: name(summary),
            value: summary.peak_reaction_n / 1e3,
            unit: "kN",
            share: summary.share_of_rated_reaction.map(|share| (share, RATED_REACTION)),
            at_s: Some(summary.peak_reaction_at_s),
            hit: None,
            is_over: summary.share_of_largest_reaction.is_some_and(|share| share > 1.0),
        });
    }
    let most = outcome.fenders.iter().max_by(|a, b| a.peak_energy_j.total_cmp(&b.peak_energy_j));
    if let Some(summary) = most.filter(|_| governs != Some(ENERGY)) {
        all.push(Governing {
            quantity: "Largest energy of a fender",
            subject: name(summary),
            value: summary.peak_energy_j / 1e3,
            unit: "kJ (kN·m)",
            share: summary.share_of_rated_energy.map(|share| (share, "rated energy")),
            at_s: Some(summary.peak_energy_at_s),
            hit: None,
            is_over: false,
        });
    }
    // Without a permissible pressure it governs nothing.
    let pressed = |f: &&FenderSummary| f.share_of_hull_pressure.is_some();
    let pressure = |f: &FenderSummary| f.peak_hull_pressure_npm2.unwrap_or(0.0);
    let share = |f: &FenderSummary| f.share_of_hull_pressure.unwrap_or(0.0);
    let most = outcome.fenders.iter().filter(pressed);
    if let Some(summary) = most.max_by(|a, b| share(a).total_cmp(&share(b))) {
        all.push(Governing {
            quantity: "Largest pressure on the hull",
            subject: name(summary),
            value: pressure(summary) / 1e3,
            unit: "kN/m²",
            share: summary.share_of_hull_pressure.map(|share| (share, "permissible pressure")),
            at_s: Some(summary.peak_reaction_at_s),
            hit: None,
            is_over: false,
        });
    }
}

const RATED_REACTION: &str = "rated reaction";
const ENERGY: &str = "Governing fender, energy";
const REACTION: &str = "Governing fender, reaction";

/// The governing number of the most used fender.
fn of_fender(summary: &FenderSummary, rated: Rated, quantity: &str, share: f64) -> Governing {
    let (quantity, value, unit, limit, at_s) = match quantity {
        "deflection" => (
            "Governing fender, deflection",
            share * rated.deflection_m * 1e3,
            "mm",
            "rated deflection",
            Some(summary.peak_deflection_at_s),
        ),
        "reaction" => {
            let peak_n = summary.peak_reaction_n;
            (REACTION, peak_n / 1e3, "kN", RATED_REACTION, Some(summary.peak_reaction_at_s))
        }
        _ => {
            let at_s = Some(summary.peak_energy_at_s);
            (ENERGY, summary.peak_energy_j / 1e3, "kJ (kN·m)", "rated energy", at_s)
        }
    };
    Governing {
        quantity,
        subject: String::new(),
        value,
        unit,
        share: Some((share, limit)),
        at_s,
        hit: None,
        // The reaction governs only where it is over.
        is_over: share > 1.0,
    }
}

/// Adds the largest moment of a panel on several cones.
fn panels(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let panels = outcome.fenders.iter().filter_map(|of| Some((of.fender, of.panel.as_ref()?)));
    let size = |of: &(usize, &PanelSummary)| of.1.peak_moment_nm.abs();
    all.extend(panels.max_by(|a, b| size(a).total_cmp(&size(b))).map(|(fender, panel)| {
        Governing {
            quantity: "Largest moment of a panel",
            subject: outcome.setup.fenders[fender].name.clone(),
            value: panel.peak_moment_nm.abs() / 1e3,
            unit: "kN·m",
            share: None,
            at_s: Some(panel.peak_moment_at_s),
            hit: None,
            is_over: false,
        }
    }));
}

/// Adds the tension of the chain that came nearest to its break load.
fn chains(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let each = outcome.fenders.iter();
    let each = each.flat_map(|of| of.chains.iter().map(move |chain| (of.fender, chain)));
    let most = each.max_by(|a, b| a.1.share_of_break_load.total_cmp(&b.1.share_of_break_load));
    all.extend(most.map(|(fender, chain)| Governing {
        quantity: "Chain of highest share",
        subject: format!("{} ({})", outcome.setup.fenders[fender].name, chain.kind.word()),
        value: chain.peak_tension_n / 1e3,
        unit: "kN",
        share: Some((chain.share_of_break_load, "break load")),
        at_s: Some(chain.peak_tension_at_s),
        hit: None,
        is_over: false,
    }));
}

/// Adds the load of the dolphin that came nearest to its yield load; if no yield load is known, that of the dolphin
/// with the largest load.
fn dolphins(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let share = |of: &DolphinSummary| of.share_of_yield_load.unwrap_or(0.0);
    let most = outcome
        .dolphins
        .iter()
        .max_by(|a, b| share(a).total_cmp(&share(b)).then(a.peak_load_n.total_cmp(&b.peak_load_n)));
    all.extend(most.map(|of| Governing {
        quantity: "Largest load of a dolphin",
        subject: outcome.setup.bodies[of.body].name.clone(),
        value: of.peak_load_n / 1e3,
        unit: "kN",
        share: of.share_of_yield_load.map(|share| (share, "yield load")),
        at_s: Some(of.peak_load_at_s),
        hit: None,
        is_over: false,
    }));
}

/// Adds the berthing energies by formula and in the run.
fn energies(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let Some(Ok(berthing)) = outcome.berthing else { return };
    let ship = outcome.setup.berthing.as_ref();
    let ship = ship.map_or_else(String::new, |of| outcome.setup.bodies[of.ship].name.clone());
    all.push(Governing {
        quantity: "Berthing energy by formula",
        subject: ship.clone(),
        value: berthing.energy_j / 1e3,
        unit: "kJ (kN·m)",
        share: None,
        at_s: None,
        hit: None,
        is_over: false,
    });
    all.extend(berthing.abnormal_energy_j.map(|abnormal_j| {
        Governing {
            quantity: "Abnormal energy by formula",
            subject: ship.clone(),
            value: abnormal_j / 1e3,
            unit: "kJ (kN·m)",
            share: capacity_of_one_j(outcome, berthing)
                .map(|capacity_j| (abnormal_j / capacity_j, "rated energy of one")),
            at_s: None,
            hit: None,
            is_over: false,
        }
    }));
    all.push(Governing {
        quantity: "Energy into all fenders, first hit",
        subject: ship.clone(),
        value: berthing.fender_energy_j / 1e3,
        unit: "kJ (kN·m)",
        share: None,
        at_s: Some(berthing.first_touch_s),
        hit: Some(1),
        is_over: false,
    });
    all.extend(berthing.later.map(|later| Governing {
        quantity: "Energy into all fenders, largest later hit",
        subject: ship,
        value: later.energy_j / 1e3,
        unit: "kJ (kN·m)",
        share: None,
        at_s: Some(later.at_s),
        hit: Some(later.number),
        is_over: false,
    }));
}

/// The rated energy (J), with its factors, of the fender that the ship meets first; `None` if she meets several fenders
/// at once, which share the energy.
fn capacity_of_one_j(outcome: &Outcome<'_>, berthing: &BerthingOutcome) -> Option<f64> {
    let [one] = berthing.fenders[..] else { return None };
    outcome.fenders.iter().find(|of| of.fender == one)?.capacity_j
}

/// Adds the largest force on a structure that was struck; if none was struck, the largest contact force without a
/// fender.
fn structure(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let strikes = outcome.findings.iter().filter_map(|finding| match finding {
        Finding::StructureStruck { bodies, first_s, peak_force_n, .. } => {
            Some((bodies, *first_s, *peak_force_n))
        }
        _ => None,
    });
    let names = |bodies: &[usize; 2]| {
        bodies.map(|body| outcome.setup.bodies[body].name.as_str()).join(" – ")
    };
    if let Some((bodies, first_s, force_n)) = strikes.max_by(|a, b| a.2.total_cmp(&b.2)) {
        all.push(Governing {
            quantity: "Structure struck",
            subject: names(bodies),
            value: force_n / 1e3,
            unit: "kN",
            share: None,
            at_s: Some(first_s),
            hit: None,
            is_over: false,
        });
    } else if outcome.setup.fenders.is_empty() {
        let most = outcome.pairs.iter();
        let most = most.max_by(|a, b| a.peak_normal_force_n.total_cmp(&b.peak_normal_force_n));
        all.extend(most.map(|pair| Governing {
            quantity: "Largest contact force",
            subject: names(&pair.bodies),
            value: pair.peak_normal_force_n / 1e3,
            unit: "kN",
            share: None,
            at_s: Some(pair.peak_normal_force_at_s),
            hit: None,
            is_over: false,
        }));
    }
}

fn lines(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let lines = outcome.setup.world.lines.iter().zip(&outcome.world.lines);
    let share = |totals: &LineTotals| {
        let working = totals.working_load_n.map(|load_n| totals.tension_n.value / load_n);
        working.or_else(|| totals.share_of_break_load())
    };
    let used = lines.filter_map(|(line, totals)| Some((line, totals, share(totals)?)));
    if let Some((line, totals, share)) = used.max_by(|a, b| a.2.total_cmp(&b.2)) {
        let of = totals.working_load_n.map_or("break load", |_| "working load");
        all.push(Governing {
            quantity: "Line of highest share",
            subject: line.line.name.clone(),
            value: totals.tension_n.value / 1e3,
            unit: "kN",
            share: Some((share, of)),
            at_s: Some(totals.tension_n.at_s),
            hit: None,
            is_over: false,
        });
    }
}

/// Adds the ship motion that is nearest to its limit in the scenario.
fn motions(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let limits = outcome.setup.world.statistics.limits.iter().zip(outcome.limit_values);
    let shares = limits.filter_map(|(limit, value)| match limit.what {
        Limited::Motion { motion, .. } if limit.most > 0.0 => {
            Some((limit, motion, value, value / limit.most))
        }
        _ => None,
    });
    let most = shares.max_by(|one, other| one.3.total_cmp(&other.3));
    all.extend(most.map(|(limit, motion, value, share)| {
        let (unit, factor) =
            if motion.is_angle() { ("deg", 1.0_f64.to_degrees()) } else { ("m", 1.0) };
        Governing {
            quantity: "Motion nearest to its limit",
            subject: limit.subject(outcome.setup),
            value: factor * value,
            unit,
            share: Some((share, "limit")),
            at_s: None,
            hit: None,
            is_over: false,
        }
    }));
}

/// Adds the largest speed at the first touch of a fender, or of two bodies if no fender was touched.
fn approach(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let setups = &outcome.setup.fenders;
    let of_fenders = outcome.fenders.iter().map(|summary| {
        (setups[summary.fender].name.clone(), summary.approach_speed_mps, summary.first_touch_s)
    });
    let of_pairs = outcome.pairs.iter().map(|pair| {
        let names = pair.bodies.map(|body| outcome.setup.bodies[body].name.as_str());
        (names.join(" – "), pair.approach_speed_mps, pair.first_touch_s)
    });
    let fastest = if outcome.fenders.is_empty() {
        of_pairs.max_by(|a, b| a.1.total_cmp(&b.1))
    } else {
        of_fenders.max_by(|a, b| a.1.total_cmp(&b.1))
    };
    all.extend(fastest.map(|(subject, speed_mps, at_s)| Governing {
        quantity: "Largest speed at first touch",
        subject,
        value: greater(speed_mps, 0.0),
        unit: "m/s",
        share: None,
        at_s: Some(at_s),
        hit: None,
        is_over: false,
    }));
}

fn under_keel(outcome: &Outcome<'_>, all: &mut Vec<Governing>) {
    let vessels = outcome.setup.world.vessels.iter().zip(&outcome.world.vessels);
    let clear = vessels.filter_map(|(vessel, totals)| Some((vessel.body, totals.under_keel_m?)));
    let least = clear.min_by(|a, b| a.1.value.total_cmp(&b.1.value));
    all.extend(least.map(|(body, clear)| Governing {
        quantity: "Least under-keel clearance",
        subject: outcome.setup.bodies[body].name.clone(),
        value: clear.value,
        unit: "m",
        share: None,
        at_s: Some(clear.at_s),
        hit: None,
        is_over: false,
    }));
}
