//! Benches that time the contact engine and its peers in one process, because the ratios of times hold where the times
//! differ from machine to machine. The benches write nothing but the file that `--out` names, and no figure makes a
//! build pass or fail.
//!
//! ```text
//! cargo run --release -p fenderline-bench -- clip [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- step [--scene SCENE] [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- accuracy [--markdown] [--out FILE]
//! cargo run --release -p fenderline-bench -- mmg [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- berth [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- fenders [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- fleet [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- fleet-steps SHIPS N
//! cargo run --release -p fenderline-bench -- fender-steps FENDERS N
//! cargo run --release -p fenderline-bench -- berth-steps N
//! cargo run --release -p fenderline-bench -- islands [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- threads [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- first [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- outlines [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- many [--markdown] [--rounds N]
//! cargo run --release -p fenderline-bench -- runs METHOD anew|restart N
//! cargo run --release -p fenderline-bench -- instructions SCENE METHOD anew|steady N
//! ```
#![allow(
    clippy::disallowed_methods,
    reason = "a bench only measures and prints, so the rules for equal bits do not hold here"
)]

mod accuracy;
mod berth;
#[cfg(feature = "peers")]
mod c_engines;
mod campaign;
mod clip;
mod fenders;
mod first;
mod fleet;
mod islands;
mod many;
mod mmg;
mod ours;
mod outlines;
mod paths;
mod peers;
mod rapier;
mod rounds;
mod shapes;
mod step;
mod threads;
mod world;

use std::process::ExitCode;

use fenderline_bench_scenes::play::{self, Play};
use fenderline_bench_scenes::scenes::Scene;
use fenderline_bench_scenes::table::Style;
use world::Engine;

const USAGE: &str = "\
usage: fenderline-bench clip [--markdown] [--rounds N]   the overlap of two convex polygons
       fenderline-bench step [--scene SCENE] [--markdown] [--rounds N]
                                                         a whole step of the engine, in all scenes or in one
       fenderline-bench accuracy [--markdown] [--out FILE]
                                                         forces, depths and speeds at five time steps
       fenderline-bench mmg [--markdown] [--rounds N]    steps a second of a ship in three degrees of freedom
       fenderline-bench berth [--markdown] [--rounds N]  a whole berthing beside real time
       fenderline-bench fenders [--markdown] [--rounds N]
                                                         one ship along 100, 300 and 1,000 fenders
       fenderline-bench fleet [--markdown] [--rounds N]  many ships, each in a simulation of its own
       fenderline-bench islands [--markdown] [--rounds N]
                                                         chains of tugs and rafts of barges
       fenderline-bench threads [--markdown] [--rounds N]
                                                         10,000 independent pairs on several threads
       fenderline-bench first [--markdown] [--rounds N]  the first step of many tugs beside a warm one
       fenderline-bench outlines [--markdown] [--rounds N]
                                                         two outlines of up to 1,000 corners that are not convex
       fenderline-bench campaign [--markdown] [--rounds N]  a campaign beside its bare steps
       fenderline-bench many [--markdown] [--rounds N]   many runs of one scenario with other numbers
       fenderline-bench runs METHOD SET_UP N             N such runs, to be counted by a profiler; SET_UP is
                                                         anew or restart
       fenderline-bench fleet-steps SHIPS N              N steps of a fleet, likewise
       fenderline-bench fender-steps FENDERS N           N steps of a simulation along so many fenders, likewise
       fenderline-bench berth-steps N                    the first N steps of the berthing, likewise
       fenderline-bench instructions SCENE METHOD PLAY N
                                                         N warm steps, to be counted by a profiler; PLAY is anew
                                                         (a restart every 17 steps) or steady
SCENE is tug, ship, faces, fenders-100, fenders-300, fenders-1000, blocks-100, blocks-1000, pairs-1000,
pairs-10000, chain-N, raft-N, stars-N, coast-N or combs-N; METHOD is coupled, paper, either
with -brief, or rapier2d; with the feature `peers` also Box2D and Chipmunk;
--out writes the figures as JSON too";

/// Rounds of a bench where the caller gives no number: enough that the medians of two runs agree to a few per cent.
const ROUNDS: usize = 41;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments.iter().map(String::as_str).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &[&str]) -> Result<(), String> {
    match arguments {
        ["clip", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", clip::bench(rounds).printed(style));
        }
        ["step", "--scene", scene, options @ ..] => {
            let scene = scene_of(scene)?;
            let (style, rounds) = options_of(options)?;
            println!("{}", step::bench(rounds, Some(scene)).printed(style));
        }
        ["step", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", step::bench(rounds, None).printed(style));
        }
        ["mmg", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", mmg::bench(rounds).printed(style));
        }
        ["berth", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", berth::bench(rounds).printed(style));
        }
        ["many", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", many::bench(rounds).printed(style));
        }
        ["campaign", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", campaign::bench(rounds)?.printed(style));
        }
        ["threads", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", threads::bench(rounds).printed(style));
        }
        ["islands", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", islands::bench(rounds).printed(style));
        }
        ["first", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", first::bench(rounds).printed(style));
        }
        ["outlines", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", outlines::bench(rounds).printed(style));
        }
        ["fenders", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", fenders::bench(rounds).printed(style));
        }
        ["fleet", options @ ..] => {
            let (style, rounds) = options_of(options)?;
            println!("{}", fleet::bench(rounds).printed(style));
        }
        ["fleet-steps", ships, steps] => fleet::steps(count_of(ships)?, count_of(steps)?),
        ["fender-steps", count, steps] => fenders::run(count_of(count)?, count_of(steps)?),
        ["berth-steps", steps] => berth::steps(count_of(steps)?),
        ["runs", method, set_up, count] => many::runs(method, set_up, count_of(count)?)?,
        ["accuracy", options @ ..] => accuracy_table(options)?,
        ["instructions", scene, method, play, steps] => {
            let scene = scene_of(scene)?;
            let mut engines = Engine::OURS.iter().chain(Engine::PEERS);
            let engine = engines.find(|engine| engine.name() == *method);
            let engine = engine.ok_or_else(|| format!("no method `{method}`\n{USAGE}"))?;
            let play = Play::named(play).map_err(|why| format!("{why}\n{USAGE}"))?;
            let mut world = engine.world(&scene.plan(), play::STEP_S);
            play::steps(world.as_mut(), count_of(steps)?, play);
        }
        _ => return Err(USAGE.to_owned()),
    }
    Ok(())
}

fn accuracy_table(options: &[&str]) -> Result<(), String> {
    let (style, file) = match options {
        [] => (Style::Plain, None),
        ["--markdown"] => (Style::Markdown, None),
        ["--out", file] => (Style::Plain, Some(file)),
        ["--markdown", "--out", file] | ["--out", file, "--markdown"] => {
            (Style::Markdown, Some(file))
        }
        _ => return Err(USAGE.to_owned()),
    };
    let figures = accuracy::figures();
    println!("{}", accuracy::table(&figures).printed(style));
    match file {
        None => Ok(()),
        Some(file) => std::fs::write(file, accuracy::json(&figures))
            .map_err(|error| format!("could not write `{file}`: {error}")),
    }
}

fn scene_of(name: &str) -> Result<Scene, String> {
    Scene::named(name).ok_or_else(|| format!("no scene `{name}`\n{USAGE}"))
}

fn options_of(options: &[&str]) -> Result<(Style, usize), String> {
    let (mut style, mut rounds) = (Style::Plain, ROUNDS);
    let mut rest = options;
    loop {
        rest = match rest {
            [] => return Ok((style, rounds)),
            ["--markdown", rest @ ..] => {
                style = Style::Markdown;
                rest
            }
            ["--rounds", count, rest @ ..] => {
                rounds = count_of(count)?;
                rest
            }
            [other, ..] => return Err(format!("unknown option `{other}`\n{USAGE}")),
        }
    }
}

fn count_of(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(count) if count > 0 => Ok(count),
        _ => Err(format!("the count `{text}` is not a whole number of at least 1\n{USAGE}")),
    }
}
