//! The project's own tasks, run as `cargo xtask NAME`; `USAGE` lists them.
//!
//! `test` is what a change must pass, and what continuous integration runs. The crate has no dependencies, so that it
//! builds in seconds on a machine that has only Rust.

mod attack;
mod bench;
mod book;
mod c_interface;
mod circles;
mod citations;
mod command;
mod compare;
mod finite_elements;
mod fuzz;
mod guide;
mod hosts;
mod live_load;
mod nautical;
mod pages;
mod passivity;
mod scenarios;
mod state_hashes;
mod step;
mod test;
mod tools;
mod virtual_environment;

use std::process::ExitCode;

const USAGE: &str = "\
usage: cargo xtask test                   everything that a change must pass
       cargo xtask attack [together] [SECONDS] [SEED] [PART]...
                                          all hostile checks, or the named ones: one after the other in SECONDS
                                          (default: 600), or together, each for SECONDS
       cargo xtask fuzz [SECONDS]         each fuzz target for SECONDS (default: 20)
       cargo xtask bench [clip|step|border|accuracy|mmg|berth|callgrind]...
                                          times and results compared with peers, and
                                          instructions per step (default: all seven)
       cargo xtask book                   the book of docs/, into target/book
       cargo xtask c [SEQUENCES]          the C examples and guide, and random calls (default: 100000 sequences)
       cargo xtask circles                fails where files of a crate use each other in a circle
       cargo xtask finite-elements        fenders by finite elements: studies, comparison, tables, data files
       cargo xtask hosts                  FMUs in FMPy, libcosim and ecos, which come from PyPI
       cargo xtask passivity [EPISODES]   random impacts on fenders: none may gain energy (default: 100000)
       cargo xtask live-load [SECONDS]    the live server with 8 clients and 50 hostile ones (default: 20 s)
       cargo xtask pages                  the live server's pages: checked, built, driven in a browser
       cargo xtask nautical               sentences for chart programs, each read by two parsers
       cargo xtask state-hashes [REVISION]
                                          a hash of all numbers that each scenario writes, compared with a revision";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    if let Err(e) = std::env::set_current_dir(command::workspace_root()) {
        eprintln!("the workspace's folder: {e}");
        return ExitCode::FAILURE;
    }
    match arguments.as_slice() {
        ["test"] => test::test(),
        ["attack", arguments @ ..] => attack::attack_command(arguments),
        ["fuzz"] => fuzz::fuzz_command(fuzz::SECONDS),
        ["fuzz", seconds] => match seconds.parse() {
            Ok(seconds) => fuzz::fuzz_command(seconds),
            Err(_) => usage(),
        },
        ["passivity"] => passivity::passivity_command(passivity::EPISODES),
        ["passivity", episodes] => match episodes.parse() {
            Ok(episodes) => passivity::passivity_command(episodes),
            Err(_) => usage(),
        },
        ["c"] => c_interface::c_command(c_interface::SEQUENCES),
        ["c", sequences] => match sequences.parse() {
            Ok(sequences) => c_interface::c_command(sequences),
            Err(_) => usage(),
        },
        ["finite-elements"] => finite_elements::finite_elements_command(),
        ["hosts"] => hosts::hosts_command(),
        ["pages"] => step::run_all(&pages::STEPS),
        ["book"] => step::run_all(&[book::STEP]),
        ["circles"] => step::run_all(&[circles::STEP]),
        ["nautical"] => step::run_all(&[nautical::STEP]),
        ["live-load"] => live_load::live_load_command(live_load::SECONDS),
        ["live-load", seconds] => match seconds.parse() {
            Ok(seconds) => live_load::live_load_command(seconds),
            Err(_) => usage(),
        },
        ["state-hashes"] => state_hashes::state_hashes_command(None),
        ["state-hashes", revision] => state_hashes::state_hashes_command(Some(revision)),
        ["bench", benches @ ..] => bench::bench(benches),
        _ => usage(),
    }
}

fn usage() -> ExitCode {
    eprintln!("{USAGE}");
    ExitCode::from(2)
}
