//! fenderline: contact of ships, fenders, quays and tugs from a scenario file.
//!
//! `cli` is the command line; `run`, `report`, `limit`, `campaign`, `statistics`, `berthings`, `check`, `validate`, `manoeuvre`, `vessels`, `fenders`, `fender`, `init` and `fmu` are the
//! commands; `man` makes completions and manual pages; `version` says what this program was built of; `load` reads a scenario; `interrupt` handles Ctrl-C;
//! `output` writes the result files, `documents` PDF and workbook; `provider` exchanges data with other programs that apply forces to bodies.

mod berthings;
mod branches;
mod campaign;
mod carried;
mod check;
mod cli;
mod columns;
mod debrief;
mod documents;
mod engine_dump;
mod failure;
mod fender;
mod fenders;
mod fmu;
mod ghost;
mod init;
mod interrupt;
mod limit;
mod load;
mod man;
mod manoeuvre;
mod mistake;
mod output;
mod played;
mod progress;
mod provider;
mod report;
mod run;
mod serve;
mod session;
mod statistics;
mod terminal;
mod validate;
mod version;
mod vessels;

use std::borrow::Cow;
use std::process::ExitCode;

use clap::Parser as _;
use fenderline_scenario::printable_text;

use cli::{Cli, Command};

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            // Help and version come this way too, with exit code 0; wrong usage has 2.
            let plain = e.render().to_string();
            match printable_text(&plain) {
                // In colour, if the terminal has it.
                Cow::Borrowed(_) => {
                    let _ = e.print();
                }
                Cow::Owned(fit_to_print) => terminal::tell(&fit_to_print),
            }
            return ExitCode::from(u8::try_from(e.exit_code()).unwrap_or(2));
        }
    };
    if cli.quiet {
        terminal::be_quiet();
    }
    if cli.has_json() {
        terminal::answer_only();
    }
    let done = match &cli.command {
        Command::Run(args) => run::run(args),
        Command::Init(args) => init::init(args),
        Command::Report(args) => report::report(args),
        Command::Check(args) => check::check(args),
        Command::Limit(args) => limit::limit(args),
        Command::Campaign(args) => campaign::campaign(args),
        Command::Statistics(args) => statistics::statistics(args),
        Command::Berthings(args) => berthings::berthings(args),
        Command::Validate(args) => validate::validate(args),
        Command::Manoeuvre(args) => manoeuvre::manoeuvre(args),
        Command::Vessels(args) => vessels::vessels(args),
        Command::Fenders(args) => fenders::fenders(args),
        Command::Fender(command) => fender::fender(command),
        Command::Fmu(args) => fmu::fmu(args),
        Command::Serve(args) => serve::serve(args),
        Command::Replay(args) => serve::replay(args),
        Command::Columns(args) => columns::columns(args),
        Command::Completions(args) => man::completions(args),
        Command::Man(args) => man::man(args),
        Command::Schema(args) => check::schema(args.of),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if let Some(message) = failure.message() {
                terminal::tell(message);
            }
            ExitCode::from(failure.exit_code())
        }
    }
}
