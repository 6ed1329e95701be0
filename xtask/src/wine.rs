//! Runs Windows programs under Wine, whose files are in a prefix of their own below the target folder.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::run_quietly;
use crate::virtual_environment::target_folder;

/// Rust's standard library takes random numbers from a DLL of Windows 10, which Wine before 8.13 lacks. The DLL that is
/// built from this text hands on the random numbers of `RtlGenRandom`.
const RANDOM: &str = "\
#include <windows.h>
BOOLEAN NTAPI SystemFunction036(PVOID buffer, ULONG length);
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE buffer, SIZE_T length)
{
    while (length > 0) {
        ULONG part = length > 0x10000 ? 0x10000 : (ULONG)length;
        if (!SystemFunction036(buffer, part))
            return FALSE;
        buffer += part;
        length -= part;
    }
    return TRUE;
}
";

/// Finds a Wine that runs programs of 64 bits. Debian keeps `wine64` out of the path if the package `wine` itself is
/// not installed.
///
/// # Errors
/// It is not installed.
pub(crate) fn find() -> Result<PathBuf, String> {
    ["wine64", "/usr/lib/wine/wine64", "wine"]
        .into_iter()
        .find(|wine| run_quietly(Command::new(wine).arg("--version")).is_ok())
        .map(PathBuf::from)
        .ok_or_else(|| "Wine is missing; install: wine64 of Debian".into())
}

/// The command that runs a Windows program under Wine. The DLL that old versions of Wine lack is put beside the
/// program.
///
/// # Errors
/// Fails if Wine or the C compiler for Windows is missing.
pub(crate) fn command(program: &Path) -> Result<Command, String> {
    let wine = find()?;
    let source = target_folder().join("bcryptprimitives.c");
    std::fs::write(&source, RANDOM).map_err(|e| format!("{}: {e}", source.display()))?;
    let dll = program.with_file_name("bcryptprimitives.dll");
    if !dll.exists() {
        let mut compile = Command::new("x86_64-w64-mingw32-gcc");
        compile.args(["-O2", "-shared", "-o"]).arg(&dll).arg(&source).arg("-ladvapi32");
        run_quietly(&mut compile)?;
    }
    let mut command = Command::new(wine);
    command.arg(program);
    command.env("WINEPREFIX", target_folder().join("wine")).env("WINEDEBUG", "-all");
    // No window asks whether to install what the programs do not use, and ours comes before Wine's own.
    command.env("WINEDLLOVERRIDES", "mscoree,mshtml=;bcryptprimitives=n,b");
    Ok(command)
}
