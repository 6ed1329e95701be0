//! `fenderline man` and `fenderline completions`: manual pages and shell completions, which the library clap makes from
//! the command line.

use std::path::Path;

use clap::{Command, CommandFactory as _};
use clap_mangen::Man;
use fenderline_report::plot::counted;

use crate::cli::{Cli, CompletionsArgs, ManArgs};
use crate::failure::Failure;
use crate::output::{make_folder, write_whole};
use crate::terminal::{answer, say};

/// Prints the manual page of the program or of one of its commands, or writes all manual pages into a folder.
///
/// # Errors
/// Fails if the command does not exist or a file cannot be written.
pub(crate) fn man(args: &ManArgs) -> Result<(), Failure> {
    // Pages are those of a version: the same from every build of it.
    let mut program = Cli::command().long_version(None::<&str>);
    // Gives the subcommands their full names and the options that they inherit.
    program.build();
    if let Some(folder) = &args.out {
        make_folder(folder)?;
        let written = write_all(&program, folder)?;
        return say(&format!("{} in {}\n", counted(written, "page", "pages"), folder.display()));
    }
    let mut chosen = &program;
    for name in &args.command {
        chosen = chosen.find_subcommand(name).ok_or_else(|| {
            let known: Vec<&str> = chosen.get_subcommands().map(Command::get_name).collect();
            let known = match known.is_empty() {
                true => "it has none".to_owned(),
                false => format!("there are {}", known.join(", ")),
            };
            let of = chosen.get_name();
            Failure::input(format_args!("error: `{of}` has no command `{name}`\n  = help: {known}"))
        })?;
    }
    answer(&page(chosen)?)
}

/// Prints the completions for a shell.
///
/// # Errors
/// Fails if standard output cannot be written.
pub(crate) fn completions(args: &CompletionsArgs) -> Result<(), Failure> {
    let mut script = Vec::new();
    let mut program = Cli::command();
    let name = program.get_name().to_owned();
    clap_complete::generate(args.shell, &mut program, name, &mut script);
    answer(&String::from_utf8_lossy(&script))
}

/// Writes the manual page of a command, such as `fenderline-fender-fit.1`, and the pages of its subcommands; returns
/// the number of pages.
fn write_all(command: &Command, folder: &Path) -> Result<u64, Failure> {
    let name = Man::new(command.clone()).get_filename();
    write_whole(&folder.join(name), page(command)?.as_bytes())?;
    let mut written = 1;
    for below in command.get_subcommands().filter(|below| below.get_name() != "help") {
        written += write_all(below, folder)?;
    }
    Ok(written)
}

fn page(command: &Command) -> Result<String, Failure> {
    let mut page = Vec::new();
    Man::new(command.clone())
        .render(&mut page)
        .map_err(|e| Failure::case(format_args!("error: no manual page: {e}")))?;
    Ok(String::from_utf8_lossy(&page).into_owned())
}
