//! `cargo xtask same-bits-everywhere [PROFILE]` runs the same scenarios on five targets and compares the hashes of
//! their results. Of the five targets, Linux with glibc and with musl run directly, Windows under Wine, WebAssembly
//! under Node, and 64-bit Arm under QEMU.

mod targets;

use std::process::{Command, ExitCode};

pub(crate) use self::targets::add_target;

use self::targets::Target;
use crate::command::run_quietly;

/// The scenarios that every target runs, with keys that shorten some of them, because QEMU is ten times slower.
const CASES: [&str; 13] = [
    // The paper's method.
    "scenarios/paper/experiment_2_4kn.toml",
    "scenarios/paper/experiment_1_step_2s.toml",
    // The coupled method.
    "scenarios/oblique_hit.toml",
    "scenarios/berth/eight_cones_at_5_deg.toml",
    "scenarios/berth/chains_hold_a_panel_that_turns.toml",
    // A hull by outlines at heights.
    "scenarios/berth/bow_flare_on_a_fender.toml",
    // Vessels, tugs, two ships, shallow water.
    "scenarios/berth/alongside_with_two_tugs.toml",
    "scenarios/berth/two_ships_on_pneumatic_fenders.toml",
    "scenarios/environment/squat_and_a_bank.toml",
    // A survey and a chart, their banks, and a current by place.
    "scenarios/harbours/bend.toml",
    // Waves.
    "scenarios/environment/rolling_in_a_beam_sea.toml",
    // Lines, a squall, gusts.
    "scenarios/live/moored_in_a_squall.toml;time.duration=200 s",
    "scenarios/berth/moored_three_hours_in_gusts.toml;time.duration=200 s",
];

/// Prints a table of results with a row for each scenario and a column for each target.
pub(crate) fn same_bits_command(profile: &str) -> ExitCode {
    match same_bits(profile) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => {
            eprintln!("the results differ");
            ExitCode::FAILURE
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn same_bits(profile: &str) -> Result<bool, String> {
    let mut columns = Vec::new();
    for target in targets::all()? {
        println!("{}: {}", target.name, target.triple);
        target.prepare()?;
        let program = target.build(profile)?;
        columns.push(hashes(&target, target.runs(&program)?)?);
    }
    let names: Vec<&str> = targets::NAMES.to_vec();
    print!("\n{:>9}", "numbers");
    names.iter().for_each(|name| print!("  {name:16}"));
    println!("  scenario");
    let mut same = true;
    for (row, case) in CASES.iter().enumerate() {
        let first = &columns[0][row];
        print!("{:>9}", first.numbers);
        for column in &columns {
            let differs = column[row] != *first;
            same &= !differs;
            print!("  {}", column[row].hash);
        }
        let verdict =
            if columns.iter().all(|column| column[row] == *first) { "" } else { "  DIFFERS" };
        println!("  {}{verdict}", case.replace("scenarios/", ""));
    }
    Ok(same)
}

/// What one target prints for one scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Hash {
    hash: String,
    numbers: String,
}

fn hashes(target: &Target, mut program: Command) -> Result<Vec<Hash>, String> {
    let printed = run_quietly(program.args(CASES))?;
    let hashes: Vec<Hash> = printed
        .lines()
        .filter_map(|line| {
            let mut words = line.split_whitespace().map(str::to_owned);
            Some(Hash { hash: words.next()?, numbers: words.next()? })
        })
        .collect();
    if hashes.len() == CASES.len() {
        Ok(hashes)
    } else {
        Err(format!("{}: {} scenarios of {}:\n{printed}", target.name, hashes.len(), CASES.len()))
    }
}
