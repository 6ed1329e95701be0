//! Checks that contact does not generate energy: `cargo xtask passivity [EPISODES]`.
//!
//! The program simulates random impacts on fender faces with γ ≤ 0.9, half of them on panels with two cones and a
//! tension chain, and the same impacts on fenders with unloading laws. No body may leave an impact with more kinetic
//! energy than it had before. The program then makes two measurements: the gain of energy with γ = 1 for each time
//! step, which must decrease with the step; and the work of a closed loop round a corner, with the force along the
//! normal of the overlap's chord and along the normal of a fender's face.
//!
//! The exit code of the program is 1 if a check fails.

#![allow(clippy::disallowed_methods, reason = "these are expected values, not results")]

#[path = "../../tests/support/mod.rs"]
mod support;

mod draw;
mod episode;
mod loops;

use std::process::ExitCode;

use episode::{Outcome, play};

/// Default number of random impacts of each kind.
const EPISODES: u64 = 100_000;
/// Number of random impacts with restitution γ = 1, for each length of the time step.
const ELASTIC_EPISODES: u64 = 2_000;
/// Rounding error of the energy balance of a run with some hundred sub-steps.
const ROUNDING: f64 = 1e-9;

fn main() -> ExitCode {
    let episodes = match std::env::args().nth(1).map(|text| text.parse()) {
        None => EPISODES,
        Some(Ok(episodes)) => episodes,
        Some(Err(_)) => {
            eprintln!("usage: passivity [EPISODES]");
            return ExitCode::from(2);
        }
    };
    let mut passive = true;
    for unloads in [false, true] {
        passive &= impacts("the same mass in surge and sway", episodes, false, unloads);
        passive &= impacts("different added masses in surge and sway", episodes, true, unloads);
    }
    let decreases = elastic();
    let closed = loops::report();
    if passive && decreases && closed { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Simulates random impacts with γ up to 0.9, or with unloading laws. Returns false if energy was gained in an impact.
fn impacts(what: &str, episodes: u64, anisotropic: bool, unloads: bool) -> bool {
    let of_seed = |seed| episode::random(seed, anisotropic, unloads);
    let all = in_two_threads(episodes, |seed| play(&of_seed(seed)));
    let touched = all.iter().filter(|o| o.touched).count();
    let structure = all.iter().filter(|o| o.touched && o.touched_structure).count();
    let law = if unloads { "unloading laws" } else { "γ ≤ 0.9" };
    println!("{law}, {what}: {episodes} impacts");
    println!(
        "  in {touched} the tug touched a fender, in {structure} of these also the structure behind it"
    );
    let (gain, worst) = largest(&all, Outcome::gain);
    println!(
        "  largest energy gain {gain:+.3e} of the kinetic energy before the impact, seed {worst}"
    );
    if anisotropic {
        let (gain, worst) = largest(&all, Outcome::gain_with_turning);
        println!(
            "  largest energy gain with the error of the Coriolis terms {gain:+.3e}, seed {worst}"
        );
        let (most, worst) = largest(&all, |o| o.turning.abs());
        println!("  largest error of the Coriolis terms {most:.3e}, seed {worst}");
    }
    let passive = gain <= ROUNDING;
    for (seed, outcome) in (0..).zip(&all).filter(|(_, o)| o.gain() > ROUNDING) {
        println!("  {:+.3e}, seed {seed}: {:?}", outcome.gain(), of_seed(seed));
    }
    println!("  {}", if passive { "no gain" } else { "ENERGY WAS GENERATED" });
    passive
}

/// Measures for γ = 1 the gain of energy that the integrator makes, for each time step. Only impacts on faces are
/// counted, because the force of the structure behind the fenders acts along the normal of the overlap's chord. Returns
/// false if the gain does not decrease with the time step.
fn elastic() -> bool {
    println!("γ = 1, {ELASTIC_EPISODES} impacts at each time step, only impacts on fender faces:");
    let mut largest_gains = vec![];
    for step_s in [1.0, 0.5, 0.1, 0.05, 0.01] {
        let all = in_two_threads(ELASTIC_EPISODES, |seed| {
            let mut episode = episode::random(seed, false, false);
            (episode.restitution, episode.panel) = (1.0, None);
            episode.step_s = step_s;
            play(&episode)
        });
        let on_faces = |o: &Outcome| if o.touched_structure { f64::NEG_INFINITY } else { o.gain() };
        let (most, worst) = largest(&all, on_faces);
        let faces = all.iter().filter(|o| o.touched && !o.touched_structure).count();
        let gains: Vec<f64> = all.iter().map(on_faces).filter(|&gain| gain > ROUNDING).collect();
        let mean = gains.iter().sum::<f64>() / gains.len().max(1) as f64;
        println!(
            "  Δt {step_s:4} s: {} of {faces} gained energy, mean {mean:.2e}, largest {most:+.2e}, seed {worst}",
            gains.len()
        );
        largest_gains.push(most);
    }
    let decreases = largest_gains[4] < 0.5 * largest_gains[0].max(ROUNDING);
    println!(
        "  {}",
        if decreases {
            "the energy gain decreases with the time step"
        } else {
            "THE ENERGY GAIN DOES NOT DECREASE WITH THE TIME STEP"
        }
    );
    decreases
}

/// The largest value among the outcomes of the impacts, and the seed of the impact that has this value.
fn largest(all: &[Outcome], value: impl Fn(&Outcome) -> f64) -> (f64, usize) {
    let values = all.iter().enumerate().map(|(seed, outcome)| (value(outcome), seed));
    values.fold((f64::NEG_INFINITY, 0), |most, one| if one.0 > most.0 { one } else { most })
}

/// The outcomes of the impacts for all seeds below `count`, in the order of the seeds.
fn in_two_threads(count: u64, one: impl Fn(u64) -> Outcome + Sync) -> Vec<Outcome> {
    let half = count / 2;
    std::thread::scope(|scope| {
        let one = &one;
        let first = scope.spawn(move || (0..half).map(one).collect::<Vec<_>>());
        let second: Vec<_> = (half..count).map(one).collect();
        let mut all = first.join().expect("an episode panicked");
        all.extend(second);
        all
    })
}
