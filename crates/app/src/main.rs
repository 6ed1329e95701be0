//! fenderline: contact of ships, fenders, quays and tugs from a scenario file.
//!
//! `cli` is the command line; `run`, `check`, `validate`, `manoeuvre`, `vessels`, `fender` and `fmu` are the commands;
//! `load` reads a scenario; `interrupt` handles Ctrl-C;
//! `output` writes the result files; `provider` exchanges data with other programs that apply forces to bodies.

mod check;
mod cli;
mod columns;
mod failure;
mod fender;
mod fmu;
mod interrupt;
mod load;
mod manoeuvre;
mod output;
mod progress;
mod provider;
mod run;
mod serve;
mod terminal;
mod validate;
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
    let done = match &cli.command {
        Command::Run(args) => run::run(args),
        Command::Check(args) => check::check(args),
        Command::Validate(args) => validate::validate(args),
        Command::Manoeuvre(args) => manoeuvre::manoeuvre(args),
        Command::Vessels(args) => vessels::vessels(args),
        Command::Fender(command) => fender::fender(command),
        Command::Fmu(args) => fmu::fmu(args),
        Command::Serve(args) => serve::serve(args),
        Command::Replay(args) => serve::replay(args),
        Command::Columns(args) => columns::columns(args),
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
