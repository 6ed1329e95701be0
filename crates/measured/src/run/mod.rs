//! The run that starts from a measured state and is driven by nothing but the water.

mod follow;
mod start;
mod water;

use fenderline_sim::{FenderSummary, Gravity, Setup, Simulation, Verdict};

use crate::estimate::Uncertain;
use crate::estimate::find::Way;
use crate::estimate::touch::Touch;
use crate::geometry::BerthAxes;

pub use self::follow::Followed;
pub(crate) use self::follow::follow;
use self::start::starts;
pub(crate) use self::water::water_only;

/// The run lasts this long after the measured touch (s), so that the other end of the ship lands too. Later the ship would
/// drift without the lines and tugs that hold her.
const AFTER_S: f64 = 60.0;
/// Longest way to the touch (s).
const LONGEST_S: f64 = 1800.0;

/// What one fender did in the run.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderUse {
    /// Index in the set-up's fenders.
    pub fender: usize,
    /// Largest reaction (N).
    pub reaction_n: f64,
    /// Largest deflection (m).
    pub deflection_m: f64,
    /// Largest energy (J).
    pub energy_j: f64,
    /// The quantity nearest to its rated value, and its share of it.
    pub governing: Option<(&'static str, f64)>,
}

/// The run from the measured state.
#[derive(Clone, Debug, PartialEq)]
pub struct Rerun {
    /// Distance of the hull from the nearest fender at the start (m).
    pub from_m: f64,
    /// Speed of the hull towards the first fender when she touches it in the run (m/s).
    pub speed_mps: f64,
    /// Index of the first fender of the run in the set-up's fenders.
    pub fender: usize,
    /// Energy of all fenders in the first hit (J). The deviation is NaN if a state within it leads to no touch.
    pub energy_j: Uncertain,
    /// Berthing energy by the formula of the scenario's `[berthing]`, with the measured speed (J).
    pub formula_j: Uncertain,
    /// Every fender that was touched, in the order of the set-up.
    pub fenders: Vec<FenderUse>,
    /// The worst finding's verdict.
    pub verdict: Verdict,
    /// Findings of the run that ask for attention, in sentences.
    pub exceeded: Vec<String>,
}

/// Numbers of one run.
struct Outcome {
    speed_mps: f64,
    fender: usize,
    energy_j: f64,
    formula_j: f64,
    formula_speed_mps: f64,
}

/// Runs the ship from the measured state on her way, and runs from states beside it for the deviation of the energy.
///
/// # Errors
/// Says why there is no run: no readings before the touch, a start that the simulator refuses, or no touch.
pub(crate) fn rerun(
    setup: &Setup,
    way: &Way,
    axes: &BerthAxes,
    touch: &Touch,
    run_from_m: f64,
) -> Result<Rerun, String> {
    let starts = starts(way, axes, touch, run_from_m)?;
    let mut setup = water_only(setup);
    setup.duration_s =
        fenderline_contact::number::lesser(starts.until_touch_s, LONGEST_S) + AFTER_S;
    let mut simulation = begun(&mut setup, axes, &starts.measured)?;
    run_to_end(&mut simulation, false)?;
    let own = outcome(&simulation)?;
    let mut variance = 0.0;
    for motion in &starts.beside {
        // A state beside the measured one that leads to no touch leaves the deviation unknown.
        let by_j = energy_of(&mut setup, axes, motion)
            .map_or(f64::NAN, |energy_j| energy_j - own.energy_j);
        variance += by_j * by_j;
    }
    let setup = simulation.setup();
    let mut fenders: Vec<FenderUse> = simulation.fender_summaries().map(fender_use).collect();
    fenders.sort_by_key(|own| own.fender);
    let findings = simulation.findings();
    let asks = findings.iter().filter(|own| own.verdict().gravity() >= Gravity::Attention);
    let speed = touch.centre_mps;
    let scale = speed.value / own.formula_speed_mps;
    let formula_j = own.formula_j * scale * scale;
    Ok(Rerun {
        from_m: starts.gap_m,
        speed_mps: own.speed_mps,
        fender: own.fender,
        energy_j: Uncertain { value: own.energy_j, sd: libm::sqrt(variance) },
        formula_j: Uncertain {
            value: formula_j,
            sd: 2.0 * formula_j * speed.sd / speed.value.abs(),
        },
        fenders,
        verdict: Verdict::of(&findings),
        exceeded: asks.map(|own| own.sentence(setup)).collect(),
    })
}

/// Energy of the first hit of a run from a state (J).
fn energy_of(
    setup: &mut Setup,
    axes: &BerthAxes,
    motion: &crate::geometry::Motion,
) -> Result<f64, String> {
    let mut simulation = begun(setup, axes, motion)?;
    run_to_end(&mut simulation, true)?;
    Ok(outcome(&simulation)?.energy_j)
}

fn begun(
    setup: &mut Setup,
    axes: &BerthAxes,
    motion: &crate::geometry::Motion,
) -> Result<Simulation, String> {
    let mut start = setup.start();
    start.bodies[axes.ship] = axes.start_of(motion);
    setup.set_start(&start);
    Simulation::new(setup.clone())
        .map_err(|error| format!("the run from the measured state: {error}"))
}

/// Steps to the end of the run, or to the end of the first hit.
fn run_to_end(simulation: &mut Simulation, only_first_hit: bool) -> Result<(), String> {
    while !simulation.is_done() {
        simulation.step().map_err(|error| format!("the run from the measured state: {error}"))?;
        let is_over = || {
            let outcome = simulation.berthing().and_then(Result::ok);
            outcome.is_some_and(|outcome| outcome.first_hit_until_s.is_some())
        };
        if only_first_hit && is_over() {
            return Ok(());
        }
    }
    Ok(())
}

fn outcome(simulation: &Simulation) -> Result<Outcome, String> {
    let first = simulation
        .fender_summaries()
        .min_by(|one, other| one.first_touch_s.total_cmp(&other.first_touch_s));
    let Some(first) = first else {
        return Err("the run from the measured state touches no fender".to_owned());
    };
    let berthing = match simulation.berthing() {
        Some(Ok(berthing)) => berthing,
        Some(Err(error)) => return Err(format!("the energy by formula: {error}")),
        None => return Err("the run from the measured state touches no fender".to_owned()),
    };
    Ok(Outcome {
        speed_mps: first.approach_speed_mps,
        fender: first.fender,
        energy_j: berthing.fender_energy_j + berthing.pile_energy_j,
        formula_j: berthing.energy_at_touch_j,
        formula_speed_mps: berthing.speed_mps.abs(),
    })
}

fn fender_use(of: &FenderSummary) -> FenderUse {
    FenderUse {
        fender: of.fender,
        reaction_n: of.peak_reaction_n,
        deflection_m: of.peak_deflection_m,
        energy_j: of.peak_energy_j,
        governing: of.governing(),
    }
}
