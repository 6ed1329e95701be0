//! Shared libraries of an FMU: their file names as cargo builds them, the platform of a library's file, and the places
//! of libraries within an FMU.

use core::fmt;
use std::env::consts::{ARCH, DLL_PREFIX, DLL_SUFFIX, OS};

use crate::Fmi;

/// File name of the library that cargo builds from this crate.
#[must_use]
pub fn file_name() -> String {
    format!("{DLL_PREFIX}fenderline_fmu{DLL_SUFFIX}")
}

/// A system and processor for which an FMU can have a library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Platform {
    /// Linux on x86-64.
    X86_64Linux,
    /// Linux on 64-bit Arm.
    Aarch64Linux,
    /// Windows on x86-64.
    X86_64Windows,
    /// macOS on x86-64.
    X86_64Darwin,
    /// macOS on 64-bit Arm.
    Aarch64Darwin,
}

impl Platform {
    /// All platforms, in the order in which FMUs list them.
    pub const ALL: [Platform; 5] = [
        Platform::X86_64Linux,
        Platform::Aarch64Linux,
        Platform::X86_64Windows,
        Platform::X86_64Darwin,
        Platform::Aarch64Darwin,
    ];

    /// The platform on which this program runs, if an FMU can have a library for this platform.
    #[must_use]
    pub fn own() -> Option<Platform> {
        let os = if OS == "macos" { "darwin" } else { OS };
        Platform::of_name(&format!("{ARCH}-{os}"))
    }

    /// Whether this program can load libraries of the platform: the platform is the program's platform, and the
    /// program is not a static program of Linux, which cannot load libraries.
    #[must_use]
    pub fn is_loadable(self) -> bool {
        let is_static = cfg!(target_os = "linux") && cfg!(target_feature = "crt-static");
        Platform::own() == Some(self) && !is_static
    }

    /// The platform's name as FMI 3.0 writes it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Platform::X86_64Linux => "x86_64-linux",
            Platform::Aarch64Linux => "aarch64-linux",
            Platform::X86_64Windows => "x86_64-windows",
            Platform::X86_64Darwin => "x86_64-darwin",
            Platform::Aarch64Darwin => "aarch64-darwin",
        }
    }

    /// The platform that has the name `name`.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Platform> {
        Platform::ALL.into_iter().find(|platform| platform.name() == name)
    }

    /// The platform of a shared library, from the header of its file: ELF, PE or Mach-O.
    #[must_use]
    pub fn of_library(file: &[u8]) -> Option<Platform> {
        let half = |at: usize| Some(u16::from_le_bytes([*file.get(at)?, *file.get(at + 1)?]));
        let word = |at: usize| {
            let bytes = file.get(at..at + 4)?;
            Some(u32::from_le_bytes(bytes.try_into().ok()?))
        };
        // ELF of 64 bits, little-endian; `e_machine` at 18.
        if file.starts_with(b"\x7fELF\x02\x01") {
            return match half(18)? {
                0x3e => Some(Platform::X86_64Linux),
                0xb7 => Some(Platform::Aarch64Linux),
                _ => None,
            };
        }
        // PE: the offset of the header is at 0x3c; `Machine` follows its signature.
        if file.starts_with(b"MZ") {
            let header = word(0x3c)? as usize;
            let is_pe = file.get(header..header.checked_add(4)?) == Some(b"PE\0\0");
            return (is_pe && half(header + 4)? == 0x8664).then_some(Platform::X86_64Windows);
        }
        // Mach-O of 64 bits: `cputype` follows the magic number.
        if word(0)? == 0xfeed_facf {
            return match word(4)? {
                0x0100_0007 => Some(Platform::X86_64Darwin),
                0x0100_000c => Some(Platform::Aarch64Darwin),
                _ => None,
            };
        }
        None
    }

    fn suffix(self) -> &'static str {
        match self {
            Platform::X86_64Linux | Platform::Aarch64Linux => ".so",
            Platform::X86_64Windows => ".dll",
            Platform::X86_64Darwin | Platform::Aarch64Darwin => ".dylib",
        }
    }
}

impl fmt::Display for Platform {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Path of a library within an FMU that has libraries for the platforms `all`.
///
/// FMI 2.0 names only the system and the width of a pointer, and masters on 64-bit Arm look for their library under
/// that name. If a library for x86-64 takes the place that FMI 2.0 names, the library for Arm gets the place that FMI
/// 3.0 names.
pub(crate) fn place(fmi: Fmi, platform: Platform, all: &[Platform], identifier: &str) -> String {
    let shared = |x86_64: Platform, name| {
        if all.contains(&x86_64) { platform.name() } else { name }
    };
    let folder = match (fmi, platform) {
        (Fmi::Three, _) => platform.name(),
        (Fmi::Two, Platform::X86_64Linux) => "linux64",
        (Fmi::Two, Platform::Aarch64Linux) => shared(Platform::X86_64Linux, "linux64"),
        (Fmi::Two, Platform::X86_64Windows) => "win64",
        (Fmi::Two, Platform::X86_64Darwin) => "darwin64",
        (Fmi::Two, Platform::Aarch64Darwin) => shared(Platform::X86_64Darwin, "darwin64"),
    };
    format!("binaries/{folder}/{identifier}{}", platform.suffix())
}

/// A text that is in the data of every library as a part of a message for masters. By this text in a library's file,
/// the program recognises a library for another machine, which cannot be loaded here. A library without this text
/// belongs to another version of the program.
pub const STAMP: &str = concat!("fenderline-fmu ", env!("CARGO_PKG_VERSION"), ", token form 2");

/// Whether a library's file carries [`STAMP`].
#[must_use]
pub fn is_of_this_version(file: &[u8]) -> bool {
    file.windows(STAMP.len()).any(|window| window == STAMP.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn platforms_are_read_from_the_headers_of_libraries() {
        let elf = |machine: u8| {
            let mut file = b"\x7fELF\x02\x01\x01".to_vec();
            file.resize(18, 0);
            file.extend([machine, 0]);
            file
        };
        assert_eq!(Platform::of_library(&elf(0x3e)), Some(Platform::X86_64Linux));
        assert_eq!(Platform::of_library(&elf(0xb7)), Some(Platform::Aarch64Linux));
        assert_eq!(Platform::of_library(&elf(0x28)), None, "32-bit Arm");
        let mut pe = b"MZ".to_vec();
        pe.resize(0x3c, 0);
        pe.extend([0x40, 0, 0, 0]);
        pe.extend(b"PE\0\0\x64\x86");
        assert_eq!(Platform::of_library(&pe), Some(Platform::X86_64Windows));
        pe[0x3c..0x40].fill(0xff);
        assert_eq!(Platform::of_library(&pe), None, "the header is beyond the file");
        assert_eq!(
            Platform::of_library(b"\xcf\xfa\xed\xfe\x0c\0\0\x01"),
            Some(Platform::Aarch64Darwin)
        );
        for junk in [&b""[..], b"MZ", b"\x7fELF\x02\x01", b"some library"] {
            assert_eq!(Platform::of_library(junk), None);
        }
    }

    #[test]
    fn two_linux_libraries_of_fmi_2_have_different_places() {
        let both = [Platform::X86_64Linux, Platform::Aarch64Linux];
        let two = |platform, all: &[Platform]| place(Fmi::Two, platform, all, "x");
        assert_eq!(two(Platform::X86_64Linux, &both), "binaries/linux64/x.so");
        assert_eq!(two(Platform::Aarch64Linux, &both), "binaries/aarch64-linux/x.so");
        assert_eq!(two(Platform::Aarch64Linux, &both[1..]), "binaries/linux64/x.so");
        assert_eq!(two(Platform::X86_64Windows, &both), "binaries/win64/x.dll");
        assert_eq!(
            place(Fmi::Three, Platform::X86_64Windows, &both, "x"),
            "binaries/x86_64-windows/x.dll"
        );
    }
}
