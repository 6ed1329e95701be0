//! Completions and manual pages in the archives of the program, made by the program itself.

use std::path::Path;
use std::process::Command;

use crate::command::run_quietly;

/// Shells, and the names under which they look for completions of `fenderline`.
pub(super) const COMPLETIONS: [(&str, &str); 5] = [
    ("bash", "completions/fenderline.bash"),
    ("zsh", "completions/_fenderline"),
    ("fish", "completions/fenderline.fish"),
    ("powershell", "completions/_fenderline.ps1"),
    ("elvish", "completions/fenderline.elv"),
];

/// One of the manual pages, which are in a folder as `man` expects it.
pub(super) const PAGE: &str = "man/man1/fenderline-run.1";

/// Has `program`, which runs on this machine, write them into `folder`.
///
/// # Errors
/// A failure of the program; files that cannot be written.
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
