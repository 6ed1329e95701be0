//! The numbers that a campaign keeps from every run.

use fenderline_contact::number::greater;
use fenderline_results::{WorldTotals, worst_first};
use fenderline_sim::{FenderSummary, Finding, Gravity, Setup, Simulation, Verdict};

use crate::downtime::BETWEEN;

/// The result numbers of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Numbers {
    pub(super) verdict: Verdict,
    /// The worst finding in a sentence; empty if all is well.
    pub(super) finding: String,
    /// Fenders that were touched.
    pub(super) touched: usize,
    /// The most used fender, the quantity that governs it, and that quantity's share of its rating.
    pub(super) governing: Option<(String, &'static str, f64)>,
    /// Largest reaction of one fender (N), the fender, and the share of its rated reaction.
    pub(super) reaction: Option<Peak>,
    /// Largest deflection (m).
    pub(super) deflection: Option<Peak>,
    /// Largest energy of one fender (J).
    pub(super) energy: Option<Peak>,
    /// Largest pressure on the hull (N/m²).
    pub(super) pressure: Option<Peak>,
    /// Berthing energy by formula, and energy of all fenders in the first hit (J).
    pub(super) formula_j: Option<f64>,
    pub(super) first_hit_j: Option<f64>,
    /// Speed (m/s) and angle (rad) of the first touch of a fender.
    pub(super) first_touch: Option<(f64, f64)>,
    /// Largest force on structure that was struck (N).
    pub(super) struck_n: Option<f64>,
    /// Largest normal force (N) and depth (m) between two bodies.
    pub(super) contact: Option<(f64, f64)>,
    /// Largest share of a line's working load, or of its break load if it has no working load.
    pub(super) line_share: Option<f64>,
    /// Least under-keel clearance (m).
    pub(super) under_keel_m: Option<f64>,
    /// Notices of the scenario.
    pub(super) notices: usize,
    /// Time in which a fender was touched (s).
    pub(super) alongside_s: f64,
    /// Lines that parted.
    pub(super) lines_parted: usize,
    /// Names of the exceeded limits, and verdicts of findings that are at least as grave, the gravest first; empty if
    /// there are none.
    pub(super) lost_by: String,
}

/// The largest value of a quantity among the fenders.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Peak {
    pub(super) value: f64,
    pub(super) fender: String,
    pub(super) share: Option<f64>,
}

impl Numbers {
    /// Collects the result numbers of a run that has ended. `alongside_s` is the time in which a fender was touched,
    /// `notices` the number of the scenario's notices.
    pub(super) fn of(
        simulation: &Simulation,
        world: &WorldTotals,
        alongside_s: f64,
        notices: usize,
    ) -> Numbers {
        let setup = simulation.setup();
        let fenders: Vec<FenderSummary> = simulation.fender_summaries().cloned().collect();
        let findings = simulation.findings();
        let name = |summary: &FenderSummary| setup.fenders[summary.fender].name.clone();
        let worst = worst_first(&setup.fenders, &fenders).first().map(|&index| &fenders[index]);
        let governing = worst.and_then(|summary| {
            let (quantity, share) = summary.governing()?;
            Some((name(summary), quantity, share))
        });
        let largest = |value: &dyn Fn(&FenderSummary) -> Option<f64>,
                       share: &dyn Fn(&FenderSummary) -> Option<f64>| {
            let known = fenders.iter().filter_map(|summary| Some((summary, value(summary)?)));
            let (summary, value) = known.max_by(|a, b| a.1.total_cmp(&b.1))?;
            Some(Peak { value, fender: name(summary), share: share(summary) })
        };
        let berthing = simulation.berthing().and_then(Result::ok);
        let first = fenders.iter().min_by(|a, b| a.first_touch_s.total_cmp(&b.first_touch_s));
        Numbers {
            verdict: Verdict::of(&findings),
            finding: findings.first().map_or_else(String::new, |finding| finding.sentence(setup)),
            touched: fenders.len(),
            governing,
            reaction: largest(&|f| Some(f.peak_reaction_n), &|f| f.share_of_rated_reaction),
            deflection: largest(&|f| Some(f.peak_deflection_m), &|f| f.share_of_rated_deflection),
            energy: largest(&|f| Some(f.peak_energy_j), &|f| f.share_of_rated_energy),
            pressure: largest(&|f| f.peak_hull_pressure_npm2, &|f| f.share_of_hull_pressure),
            formula_j: berthing.map(|of| of.energy_j),
            first_hit_j: berthing.map(|of| of.fender_energy_j),
            first_touch: first.map(|f| (f.approach_speed_mps, f.approach_angle_rad)),
            struck_n: struck_n(&findings),
            contact: contact(simulation),
            line_share: line_share(world),
            under_keel_m: under_keel_m(setup, world),
            notices,
            alongside_s,
            lost_by: lost_by(setup, &findings),
            lines_parted: world.lines.iter().filter(|line| line.parted_s.is_some()).count(),
        }
    }
}

/// The reasons why the ship cannot stay at the berth: first graver findings by their verdicts, then exceeded limits by
/// their names, the most exceeded limit first. A run that left the range of its data is in doubt, as its verdict says;
/// doubt alone is no reason to leave the berth.
fn lost_by(setup: &Setup, findings: &[Finding]) -> String {
    let limits = &setup.world.statistics.limits;
    let is_reason = |of: Verdict| of.gravity() >= Gravity::Attention && of != Verdict::OutsideData;
    let grave = findings.iter().filter(|own| is_reason(own.verdict()));
    let mut reasons: Vec<(Verdict, f64, &str)> = grave
        .map(|own| match own {
            Finding::LimitExceeded { limit, value } => {
                let limit = &limits[*limit];
                (own.verdict(), value / limit.most, limit.name.as_str())
            }
            other => (other.verdict(), 0.0, other.verdict().text()),
        })
        .collect();
    reasons.sort_by(|one, other| other.0.cmp(&one.0).then(other.1.total_cmp(&one.1)));
    let mut names: Vec<&str> = Vec::new();
    for (_, _, name) in reasons {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.join(BETWEEN)
}

fn contact(simulation: &Simulation) -> Option<(f64, f64)> {
    let peaks =
        simulation.pair_summaries().iter().map(|own| (own.peak_normal_force_n, own.peak_depth_m));
    peaks.reduce(|most, own| (greater(most.0, own.0), greater(most.1, own.1)))
}

fn struck_n(findings: &[Finding]) -> Option<f64> {
    let forces = findings.iter().filter_map(|finding| match finding {
        Finding::StructureStruck { peak_force_n, .. } => Some(*peak_force_n),
        _ => None,
    });
    forces.max_by(f64::total_cmp)
}

fn line_share(world: &WorldTotals) -> Option<f64> {
    let shares = world.lines.iter().filter_map(|line| match line.working_load_n {
        Some(load_n) => Some(line.tension_n.value / load_n),
        None => line.share_of_break_load(),
    });
    shares.max_by(f64::total_cmp)
}

fn under_keel_m(setup: &Setup, world: &WorldTotals) -> Option<f64> {
    let vessels = setup.world.vessels.iter().zip(&world.vessels);
    let clearances = vessels.filter_map(|(_, totals)| Some(totals.under_keel_m?.value));
    clearances.min_by(f64::total_cmp)
}
