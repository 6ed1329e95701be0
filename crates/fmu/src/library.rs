//! File names of the shared library, as built and within an FMU.

use std::env::consts::{ARCH, DLL_PREFIX, DLL_SUFFIX, OS};

use crate::Fmi;

/// File name of the library that cargo builds from this crate.
#[must_use]
pub fn file_name() -> String {
    format!("{DLL_PREFIX}fenderline_fmu{DLL_SUFFIX}")
}

/// Path within an FMU of a library for this machine.
pub(crate) fn place(fmi: Fmi, identifier: &str) -> String {
    let platform = match fmi {
        // FMI 2.0 names the system and the width of a pointer only.
        Fmi::Two => {
            let os = match OS {
                "windows" => "win",
                "macos" => "darwin",
                os => os,
            };
            format!("{os}{}", usize::BITS)
        }
        Fmi::Three => format!("{ARCH}-{}", if OS == "macos" { "darwin" } else { OS }),
    };
    format!("binaries/{platform}/{identifier}{DLL_SUFFIX}")
}
