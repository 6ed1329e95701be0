//! The project's own tasks, run as `cargo xtask NAME`; `USAGE` lists them.
//!
//! The task `test` runs everything that a change must pass, and is what continuous integration runs. The crate `xtask`
//! has no dependencies, so that it builds in seconds on a machine that has only Rust.

mod alone;
mod attack;
mod bench;
mod book;
mod browser;
mod built;
mod c_build;
mod c_interface;
mod circles;
mod citations;
mod command;
mod compare;
mod dist;
mod finite_elements;
mod fuzz;
mod gate;
mod guide;
mod hosts;
mod live_load;
mod nautical;
mod oldest_rust;
mod once_more;
mod pages;
mod passivity;
mod program;
mod protocol;
mod same_bits;
mod scenarios;
mod sentences;
mod slurm;
mod starts;
mod state_hashes;
mod step;
mod test;
#[cfg(test)]
mod test_files;
mod tools;
mod virtual_environment;
mod windows;
mod wine;
mod workflows;
mod wrappers;

use std::process::ExitCode;

const USAGE: &str = "\
usage: cargo xtask test                   what a change must pass and Rust alone can tell: format, tests, published cases
       cargo xtask test all               everything that a change must pass
       cargo xtask test STEP...           the named steps of it
       cargo xtask program [PROFILE]      the program for this machine as one file that needs nothing else
       cargo xtask alone [dev]            that program in an empty folder, with the sources, cargo and Node hidden
       cargo xtask slurm                  a campaign as an array of a Slurm of this machine, as root
       cargo xtask attack [together] [SECONDS] [SEED] [PART]...
                                          all hostile checks, or the named ones: one after the other in SECONDS
                                          (default: 600), or together, each for SECONDS
       cargo xtask fuzz [SECONDS]         each fuzz target for SECONDS (default: 20)
       cargo xtask bench [clip|step|islands|fenders|threads|border|accuracy|mmg|berth|many|campaign|callgrind]...
                                          times and results compared with peers, and
                                          instructions per step (default: all)
       cargo xtask book                   the book of docs/, into target/book
       cargo xtask c [SEQUENCES]          the C, C++ and C# examples and guides, and random calls (default: 100000
                                          sequences)
       cargo xtask circles                fails where files of a crate use each other in a circle
       cargo xtask finite-elements        fenders by finite elements: studies, comparison, tables, data files
       cargo xtask dist [cheap]           everything that a release hands out, into target/dist; cheap: what the tests run
       cargo xtask dist here              program, C library and wheel for this machine, where it is no Linux on x86-64
       cargo xtask dist try               what dist has made, unpacked and used as a user does
       cargo xtask dist sums              check sums of what is in target/dist
       cargo xtask dist tag TAG           whether all files have the version of a tag; the notes of the release
       cargo xtask dist c PREFIX          the C library for this machine, with headers, pkg-config and CMake files, into PREFIX
       cargo xtask hosts                  FMUs in FMPy, libcosim and ecos, which come from PyPI
       cargo xtask oldest-rust            what users build, with the oldest Rust that Cargo.toml names
       cargo xtask once-more              that, fuzz targets for a minute, documentation of private items: checks that
                                          compile everything once more, and so are no part of the tests
       cargo xtask passivity [EPISODES]   random impacts on fenders: none may gain energy (default: 100000)
       cargo xtask live-load [SECONDS]    the live server with 8 clients and 50 hostile ones (default: 20 s)
       cargo xtask pages                  the live server's pages: checked, built, driven in a browser
       cargo xtask protocol               the pages' types of the messages, written from the messages in Rust
       cargo xtask npm                    the npm package: built, made small, tested under Node, timed
       cargo xtask page                   that, and the page without a server, in target/page, driven in a browser
       cargo xtask nautical               sentences for chart programs, each read by two parsers
       cargo xtask same-bits-everywhere [PROFILE]
                                          hashes of the results of scenarios on Linux (glibc, musl), Windows, WebAssembly
                                          and 64-bit Arm, by emulators (default: release)
       cargo xtask sentences SEED [COUNT] [PATH]...
                                          sentences of comments, errors and documents drawn at random (default: 50),
                                          for a reader who has not seen the code
       cargo xtask starts                 the README's three ways to start, in a new clone with an empty home
       cargo xtask state-hashes [REVISION]
                                          a hash of all numbers that each scenario writes, compared with a revision
       cargo xtask workflows              the workflows of .github, by actionlint and zizmor
       cargo xtask windows [PROFILE]      program, FMU and C library for Windows under Wine, compared with Linux's";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    if let Err(e) = std::env::set_current_dir(command::workspace_root()) {
        eprintln!("the workspace's folder: {e}");
        return ExitCode::FAILURE;
    }
    match arguments.as_slice() {
        ["test", names @ ..] => test::test_command(names),
        ["step", name] => test::step_command(name),
        ["program"] => program::program_command("release"),
        ["program", profile] => program::program_command(profile),
        ["alone"] => alone::alone_command("release"),
        ["slurm"] => slurm::slurm_command(),
        ["alone", "dev"] => alone::alone_command("dev"),
        ["attack", arguments @ ..] => attack::attack_command(arguments),
        ["fuzz"] => fuzz::fuzz_command(fuzz::SECONDS),
        ["fuzz", seconds] => match seconds.parse() {
            Ok(seconds) => fuzz::fuzz_command(seconds),
            Err(_) => usage(),
        },
        ["oldest-rust"] => step::run_all(&[oldest_rust::STEP]),
        ["once-more"] => step::run_all(&once_more::STEPS),
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
        ["dist"] => dist::dist_command(),
        ["dist", "cheap"] => dist::cheap_command(),
        ["dist", "here"] => dist::here_command(),
        ["dist", "try"] => dist::try_command(),
        ["dist", "sums"] => dist::sums_command(),
        ["dist", "tag", name] => dist::tag_command(name),
        ["dist", "c", prefix] => dist::install_c_command(prefix),
        ["hosts"] => hosts::hosts_command(),
        ["pages"] => step::run_all(&pages::STEPS),
        ["npm"] => browser::npm_command(),
        ["protocol"] => protocol::protocol_command(),
        ["page"] => browser::page_command(),
        ["book"] => step::run_all(&[book::STEP]),
        ["circles"] => step::run_all(&[circles::STEP]),
        ["nautical"] => step::run_all(&[nautical::STEP]),
        ["live-load"] => live_load::live_load_command(live_load::SECONDS),
        ["live-load", seconds] => match seconds.parse() {
            Ok(seconds) => live_load::live_load_command(seconds),
            Err(_) => usage(),
        },
        ["same-bits-everywhere"] => same_bits::same_bits_command("release"),
        ["same-bits-everywhere", profile] => same_bits::same_bits_command(profile),
        ["sentences", seed, rest @ ..] => {
            let (count, paths) = match rest {
                [count, paths @ ..] => (count.parse(), paths),
                [] => (Ok(sentences::COUNT), rest),
            };
            match (seed.parse(), count) {
                (Ok(seed), Ok(count)) => sentences::sentences_command(seed, count, paths),
                _ => usage(),
            }
        }
        ["starts"] => starts::starts_command(),
        ["state-hashes"] => state_hashes::state_hashes_command(None),
        ["state-hashes", revision] => state_hashes::state_hashes_command(Some(revision)),
        ["workflows"] => workflows::workflows_command(),
        ["windows"] => windows::windows_command("release"),
        ["windows", profile] => windows::windows_command(profile),
        ["bench", benches @ ..] => bench::bench(benches),
        _ => usage(),
    }
}

fn usage() -> ExitCode {
    eprintln!("{USAGE}");
    ExitCode::from(2)
}
