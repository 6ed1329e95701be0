//! Does contact make energy? `cargo xtask passivity [EPISODES]`.
//!
//! Random hits on fender faces with γ ≤ 0.9, and the same hits on fenders with unloading laws: nobody may leave with
//! more kinetic energy than it came with. Then two things that are measured rather than forbidden: what γ = 1 gains at each time step,
//! and what the chord's normal puts into a closed loop round a corner beside a fender's face.
//!
//! Ends with 1 where a hit gained.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

#[path = "../../tests/support/mod.rs"]
mod support;

mod draw;
mod episode;
mod loops;

use std::process::ExitCode;

use episode::{Outcome, play};

/// Of each kind, where the caller does not say.
const EPISODES: u64 = 100_000;
/// Episodes at each time step with γ = 1.
const ELASTIC_EPISODES: u64 = 2_000;
/// Rounding of a run of some hundred sub-steps.
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
        passive &= hits("the same mass in surge and sway", episodes, false, unloads);
        passive &= hits("added mass that differs", episodes, true, unloads);
    }
    let falls = elastic();
    let closed = loops::report();
    if passive && falls && closed { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Plays episodes with γ up to 0.9, or with unloading laws; false where one gained.
fn hits(what: &str, episodes: u64, anisotropic: bool, unloads: bool) -> bool {
    let drawn = |seed| episode::drawn(seed, anisotropic, unloads);
    let all = in_two_threads(episodes, |seed| play(&drawn(seed)));
    let touched = all.iter().filter(|o| o.touched).count();
    let structure = all.iter().filter(|o| o.touched && o.touched_structure).count();
    let law = if unloads { "unloading laws" } else { "γ ≤ 0.9" };
    println!("{law}, {what}: {episodes} episodes");
    println!("  {touched} touched a fender, {structure} of them the structure behind it too");
    let (gain, worst) = largest(&all, Outcome::gain);
    println!("  largest gain of a hit {gain:+.3e} of the kinetic energy before it, seed {worst}");
    if anisotropic {
        let (gain, worst) = largest(&all, Outcome::gain_with_turning);
        println!(
            "  with what the turning of the added mass makes in a step {gain:+.3e}, seed {worst}"
        );
        let (most, worst) = largest(&all, |o| o.turning.abs());
        println!("  which is up to {most:.3e}, seed {worst}");
    }
    let passive = gain <= ROUNDING;
    for (seed, outcome) in (0..).zip(&all).filter(|(_, o)| o.gain() > ROUNDING) {
        println!("  {:+.3e}, seed {seed}: {:?}", outcome.gain(), drawn(seed));
    }
    println!("  {}", if passive { "none gained" } else { "ENERGY WAS MADE" });
    passive
}

/// γ = 1: what the integrator gains, by time step. Hits on faces alone: those on the structure behind
/// them have the chord's normal. False where it does not fall.
fn elastic() -> bool {
    println!("γ = 1, {ELASTIC_EPISODES} hits at each time step, those on faces alone:");
    let mut largest_gains = vec![];
    for step_s in [1.0, 0.5, 0.1, 0.05, 0.01] {
        let all = in_two_threads(ELASTIC_EPISODES, |seed| {
            let mut episode = episode::drawn(seed, false, false);
            episode.restitution = 1.0;
            episode.step_s = step_s;
            play(&episode)
        });
        let on_faces = |o: &Outcome| if o.touched_structure { f64::NEG_INFINITY } else { o.gain() };
        let (most, worst) = largest(&all, on_faces);
        let faces = all.iter().filter(|o| o.touched && !o.touched_structure).count();
        let gains: Vec<f64> = all.iter().map(on_faces).filter(|&gain| gain > ROUNDING).collect();
        let mean = gains.iter().sum::<f64>() / gains.len().max(1) as f64;
        println!(
            "  Δt {step_s:4} s: {} of {faces} gained, {mean:.2e} in the mean, {most:+.2e} at most, \
             seed {worst}",
            gains.len()
        );
        largest_gains.push(most);
    }
    let falls = largest_gains[4] < 0.5 * largest_gains[0].max(ROUNDING);
    println!("  {}", if falls { "it falls with the time step" } else { "IT DOES NOT FALL" });
    falls
}

/// The largest value and its seed.
fn largest(all: &[Outcome], value: impl Fn(&Outcome) -> f64) -> (f64, usize) {
    let values = all.iter().enumerate().map(|(seed, outcome)| (value(outcome), seed));
    values.fold((f64::NEG_INFINITY, 0), |most, one| if one.0 > most.0 { one } else { most })
}

/// `one` of each seed below `count`, in their order.
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
