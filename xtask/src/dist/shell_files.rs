//! Puts shell completions and manual pages into the archives of the program; the program itself makes them.

use std::path::Path;
use std::process::Command;

use crate::command::run_quietly;

/// Shells, and the file names under which the shells look for completions of `fenderline`.
pub(super) const COMPLETIONS: [(&str, &str); 5] = [
    ("bash", "completions/fenderline.bash"),
    ("zsh", "completions/_fenderline"),
    ("fish", "completions/fenderline.fish"),
    ("powershell", "completions/_fenderline.ps1"),
    ("elvish", "completions/fenderline.elv"),
];

/// Path of one of the manual pages, which lie in a folder as `man` expects it.
pub(super) const PAGE: &str = "man/man1/fenderline-run.1";

/// Lets `program`, which runs on this machine, write completions and manual pages into `folder`.
///
/// # Errors
/// Fails if the program fails, or if files cannot be written.
pub(super) fn write(program: &Path, folder: &Path) -> Result<(), String> {
    for (shell, name) in COMPLETIONS {
        let file = folder.join(name);
        let within = file.parent().unwrap_or(folder);
        std::fs::create_dir_all(within).map_err(|e| format!("{}: {e}", within.display()))?;
        let script = run_quietly(Command::new(program).args(["completions", shell]))?;
        std::fs::write(&file, script).map_err(|e| format!("{}: {e}", file.display()))?;
    }
    let pages = folder.join(PAGE);
    let within = pages.parent().unwrap_or(folder);
    run_quietly(Command::new(program).args(["man", "--out"]).arg(within))?;
    Ok(())
}
