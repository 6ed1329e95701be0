//! Compares the branches of a recorded live session. A branch begins where people went back to an earlier time and
//! steered anew; each branch is simulated again from the start of the session.

use fenderline_contact::number::{greater, lesser};
use fenderline_live::{Repeat, Session};
use fenderline_results::{BranchOutcome, WayPoint};
use fenderline_sim::Simulation;
use fenderline_sim::berth::Berth;

use crate::failure::Failure;
use crate::interrupt::Interrupt;

/// Largest number of branches that are shown beside each other: the lines of more branches cannot be told apart. The
/// latest branches are shown.
const MOST: usize = 8;
/// Simulated time between two points of a ship's path (s).
const EVERY_S: f64 = 1.0;

/// The outcomes of all branches that have time steps. The list is empty if only one branch has steps, or if the user
/// interrupts.
///
/// # Errors
/// Fails if the simulation cannot make a time step.
pub(crate) fn outcomes(
    session: &Session,
    interrupt: &Interrupt,
) -> Result<Vec<BranchOutcome>, Failure> {
    let with_steps: Vec<usize> = session
        .branches()
        .iter()
        .enumerate()
        .filter(|(_, branch)| branch.ends_tick > 0)
        .map(|(id, _)| id)
        .collect();
    if with_steps.len() < 2 {
        return Ok(Vec::new());
    }
    let latest = &with_steps[with_steps.len().saturating_sub(MOST)..];
    let mut all = Vec::with_capacity(latest.len());
    for &id in latest {
        all.push(outcome(session, id, interrupt)?);
        if interrupt.is_asked() {
            return Ok(Vec::new());
        }
    }
    Ok(all)
}

/// Steps through a branch.
fn outcome(session: &Session, id: usize, interrupt: &Interrupt) -> Result<BranchOutcome, Failure> {
    let mut repeat = Repeat::of(session.clone(), id)
        .map_err(|why| Failure::input(format_args!("error: branch {id}: {why}")))?;
    let ship = Ship::of(session);
    let step_s = session.simulation().setup().step_s;
    let every = greater(libm::round(EVERY_S / step_s), 1.0) as u64;
    let mut way = vec![ship.now(repeat.simulation())];
    let (mut line_share, mut approach_mps) = (0.0, None);
    let mut tick = 0;
    while !repeat.is_done() && !interrupt.is_asked() {
        repeat.step(|_| ()).map_err(|why| Failure::case(format_args!("error: {why}")))?;
        tick += 1;
        let simulation = repeat.simulation();
        line_share = greater(line_share, largest_line_share(simulation));
        if let Some(closing_mps) = ship.approach_mps(simulation) {
            approach_mps = Some(greater(approach_mps.unwrap_or(0.0), closing_mps));
        }
        if tick % every == 0 {
            way.push(ship.now(simulation));
        }
    }
    let simulation = repeat.simulation();
    let branch = &session.branches()[id];
    let from_s = branch.from_tick as f64 * step_s;
    let shares = simulation.fender_summaries().filter_map(|fender| fender.share_of_rated_energy);
    let state = simulation.states()[ship.body];
    let outline = simulation.setup().bodies[ship.body].outline.vertices();
    Ok(BranchOutcome {
        id,
        parent: branch.parent,
        from_s,
        ends_s: simulation.time_s(),
        verdict: simulation.verdict(),
        findings: simulation.findings(),
        score: repeat.exercise().map(|of| (of.score(), of.is_passed())),
        fender_share: shares.fold(None, |most, share| Some(greater(most.unwrap_or(0.0), share))),
        line_share,
        approach_mps,
        commands: repeat.log().commands.iter().filter(|of| of.t_s >= from_s).count(),
        alarms: repeat.log().alarms.len(),
        way,
        hull_m: outline.iter().map(|&corner| state.pose().apply(corner)).collect(),
    })
}

fn largest_line_share(simulation: &Simulation) -> f64 {
    let setups = simulation.setup().world.lines.iter();
    let lines = simulation.lines().iter().zip(setups);
    let share = |(line, of): (&fenderline_sim::Mooring, &fenderline_sim::MooringSetup)| {
        line.load.tension_n / of.line.kind.break_load_n()
    };
    lines.map(share).fold(0.0, greater)
}

/// The ship by which the branches are compared, namely the pilot's own ship, and the berth that she comes to.
struct Ship {
    body: usize,
    berth: Option<Berth>,
}

impl Ship {
    fn of(session: &Session) -> Ship {
        let world = &session.simulation().setup().world;
        let body = session.cast().own.map_or(0, |own| world.vessels[own].body);
        Ship { body, berth: session.info().berth }
    }

    fn now(&self, simulation: &Simulation) -> WayPoint {
        let state = simulation.states()[self.body];
        let outline = &simulation.setup().bodies[self.body].outline;
        let off_m = self.berth.map(|berth| {
            let [bow_m, stern_m] =
                berth.lie(&simulation.states()[berth.body], outline, &state).off_m;
            lesser(bow_m, stern_m)
        });
        WayPoint {
            t_s: simulation.time_s(),
            at_m: state.position_m,
            speed_mps: state.velocity_mps.length(),
            off_m,
        }
    }

    /// Speed of the ship's bow or stern towards the fenders (m/s): of those ends that are near the berth, the faster
    /// one.
    fn approach_mps(&self, simulation: &Simulation) -> Option<f64> {
        let berth = self.berth?;
        let outline = &simulation.setup().bodies[self.body].outline;
        let state = simulation.states()[self.body];
        let lie = berth.lie(&simulation.states()[berth.body], outline, &state);
        let near = (0..2).filter(|&end| {
            lie.off_m[end] > 0.0
                && lie.off_m[end] <= BranchOutcome::NEAR_M
                && !berth.is_past_the_end(&lie, end)
        });
        near.map(|end| greater(lie.closing_mps[end], 0.0)).reduce(greater)
    }
}
