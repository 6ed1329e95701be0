//! Finds the libraries of an FMU: those built into this program, files that the user names, or the library that cargo
//! puts beside the program.

use std::borrow::Cow;
use std::fs;
use std::path::{Path, PathBuf};

use fenderline_fmu::{
    LIBRARY_STAMP, Plan, Platform, is_of_this_version, library_file_name, try_library,
    try_library_bytes,
};
use fenderline_scenario::read_bytes;

use crate::carried::EMBEDDED;
use crate::cli::FmuArgs;
use crate::failure::Failure;

/// Largest library file that is read (bytes). The project's own library has about 3 MiB, with debug information about
/// 100 MiB.
const LARGEST_LIBRARY: u64 = 1 << 30;

/// An FMU library for one platform.
pub(super) struct Library {
    pub(super) platform: Platform,
    pub(super) bytes: Cow<'static, [u8]>,
    /// File of the library; `None` for a library that is built into the program.
    path: Option<PathBuf>,
}

impl Library {
    /// Checks the library's version. If this machine can load the library, checks also that the library makes an
    /// instance of the FMU.
    ///
    /// # Errors
    /// Fails if the library cannot go into an FMU of the plan.
    pub(super) fn check(&self, plan: &Plan) -> Result<(), Failure> {
        let place = match &self.path {
            Some(path) => path.display().to_string(),
            None => format!("the program's library for {}", self.platform),
        };
        // First, as the system may end the program when it loads a damaged file.
        if !is_of_this_version(&self.bytes) {
            return Err(Failure::case(format_args!(
                "error: {place}: this file is not the FMU's library of this version ({LIBRARY_STAMP:?} is not in it)"
            )));
        }
        if !self.platform.is_loadable() {
            return Ok(());
        }
        let tried = match &self.path {
            Some(path) => try_library(path, plan),
            None => try_library_bytes(&self.bytes, plan),
        };
        tried.map_err(|e| Failure::case(format_args!("error: {place}: {e}")))
    }
}

/// The FMU libraries that the arguments choose, one for each platform, in the order of [`Platform::ALL`].
///
/// # Errors
/// Fails if the program has no library for a platform, if a file is not a library, or if two files are for the same
/// platform.
pub(super) fn libraries(args: &FmuArgs) -> Result<Vec<Library>, Failure> {
    let mut libraries = if args.library.is_empty() {
        own(&args.platforms)?
    } else {
        args.library.iter().map(|path| of_file(path)).collect::<Result<_, _>>()?
    };
    libraries.sort_by_key(|library| library.platform);
    for pair in libraries.windows(2) {
        if pair[0].platform == pair[1].platform {
            return Err(Failure::input(format_args!(
                "error: --library: two libraries for {}",
                pair[0].platform
            )));
        }
    }
    Ok(libraries)
}

/// The libraries that are built into the program, or else the library that lies beside the program.
fn own(wanted: &[Platform]) -> Result<Vec<Library>, Failure> {
    let mut carried: Vec<Library> = EMBEDDED
        .iter()
        .map(|(name, bytes)| Library {
            platform: Platform::of_name(name).expect("build.rs names platforms"),
            bytes: Cow::Borrowed(bytes),
            path: None,
        })
        .collect();
    if carried.is_empty() {
        carried.push(of_file(&beside()?)?);
    }
    if wanted.is_empty() {
        return Ok(carried);
    }
    let has: Vec<&str> = carried.iter().map(|library| library.platform.name()).collect();
    if let Some(lacks) = wanted.iter().find(|platform| !has.contains(&platform.name())) {
        return Err(Failure::input(format_args!(
            "error: --platforms: this program has no library for {lacks}; it has {}\n\
             help: programs of a release have all; `--library PATH` adds a library",
            has.join(", ")
        )));
    }
    carried.retain(|library| wanted.contains(&library.platform));
    Ok(carried)
}

fn of_file(path: &Path) -> Result<Library, Failure> {
    let bytes = read_bytes(path, LARGEST_LIBRARY)
        .map_err(|e| Failure::case(format_args!("error: cannot read {e}")))?;
    let platform = Platform::of_library(&bytes).ok_or_else(|| {
        Failure::case(format_args!(
            "error: {}: not a shared library for Linux, Windows or macOS on x86-64 or 64-bit Arm",
            path.display()
        ))
    })?;
    Ok(Library { platform, bytes: Cow::Owned(bytes), path: Some(path.to_owned()) })
}

/// Path of the FMU library that cargo puts beside the program.
fn beside() -> Result<PathBuf, Failure> {
    let program = std::env::current_exe().map_err(|e| {
        Failure::case(format_args!("error: the folder of this program cannot be found: {e}"))
    })?;
    let folder = program.parent().unwrap_or(Path::new(""));
    let name = library_file_name();
    let places = [folder.join(&name), folder.join("deps").join(&name)];
    // If cargo has built it twice, the newer one belongs to this program.
    let built = |path: &PathBuf| fs::metadata(path).and_then(|meta| meta.modified()).ok();
    let newest = places.iter().filter_map(|path| Some((built(path)?, path))).max();
    newest.map(|(_, path)| path.clone()).ok_or_else(|| {
        Failure::case(format_args!(
            "error: this program was built without the library of FMUs, and `{name}` is not beside it ({})\n\
             help: `cargo xtask program` builds a program with the library; or name the library with `--library PATH`",
            folder.display()
        ))
    })
}
