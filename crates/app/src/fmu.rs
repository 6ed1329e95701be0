//! `fenderline fmu`: a scenario as a functional mock-up unit.

use std::fs;
use std::path::{Path, PathBuf};

use fenderline_fmu::{Bundle, BundleError, Fmi, Kind, Plan, PlanError, library_file_name, pack};
use fenderline_scenario::read_bytes;

use crate::cli::{FmiVersion, FmuArgs, FmuKind};
use crate::failure::Failure;
use crate::load::load;
use crate::output::write_whole;
use crate::terminal::{say, tell};

/// Largest library that is read (bytes). The project's has about 10 MiB, with debug information about 100.
const LARGEST_LIBRARY: u64 = 1 << 30;

/// Writes the FMU that `args` describe. Nothing is written before the scenario is accepted.
///
/// # Errors
/// Bad input; a missing library; a file that cannot be written.
pub(crate) fn fmu(args: &FmuArgs) -> Result<(), Failure> {
    let scenario = load(&args.scenario, &args.changes)?;
    for notice in &scenario.notices {
        tell(&format!("notice: {notice}"));
    }
    let kind = match args.kind {
        FmuKind::Engine => Kind::Engine,
        FmuKind::Simulation => Kind::Simulation,
    };
    let fmi = match args.fmi {
        FmiVersion::Two => Fmi::Two,
        FmiVersion::Three => Fmi::Three,
    };
    let changes = args.changes.keys_and_values().map_err(Failure::input)?;
    let bundle = Bundle::load(kind, &args.scenario, changes).map_err(Failure::input)?;
    let plan = Plan::new(bundle).map_err(|error| match error {
        PlanError::Bundle(BundleError::NotABundle(_)) => Failure::case(error),
        error => Failure::input(error),
    })?;
    let stem = args.out.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let library_path = library(args.library.as_deref())?;
    let library = read(&library_path)?;
    let packed = pack(&plan, fmi, &stem, &library).map_err(Failure::case)?;
    write_whole(&args.out, &packed.fmu)?;
    let osp_path = args.out.with_file_name(&packed.osp_name);
    write_whole(&osp_path, packed.osp.as_bytes())?;
    say(&format!(
        "{}: {} of \"{}\", FMI {}, {} variables, {} KiB\n{}: its groups of variables, for OSP\n",
        args.out.display(),
        kind.name(),
        plan.scenario.title,
        if fmi == Fmi::Two { "2.0" } else { "3.0" },
        plan.table.variables.len(),
        packed.fmu.len() / 1024,
        osp_path.display(),
    ))
}

/// The path of the library: as given, otherwise beside the program, where cargo puts it.
fn library(told: Option<&Path>) -> Result<PathBuf, Failure> {
    if let Some(path) = told {
        return Ok(path.to_owned());
    }
    let program = std::env::current_exe()
        .map_err(|e| Failure::case(format_args!("error: the folder of this program: {e}")))?;
    let folder = program.parent().unwrap_or(Path::new(""));
    let name = library_file_name();
    let places = [folder.join(&name), folder.join("deps").join(&name)];
    // If cargo has built it twice, the newer one belongs to this program.
    let built = |path: &PathBuf| fs::metadata(path).and_then(|meta| meta.modified()).ok();
    let newest = places.iter().filter_map(|path| Some((built(path)?, path))).max();
    newest.map(|(_, path)| path.clone()).ok_or_else(|| {
        let profile = if cfg!(debug_assertions) { "" } else { " --release" };
        Failure::case(format_args!(
            "error: the FMU's library `{name}` is not beside this program ({}) nor in `deps` there\n\
             help: `cargo build{profile} --package fenderline-fmu` builds it; or name it with \
             `--library PATH`",
            folder.display()
        ))
    })
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    read_bytes(path, LARGEST_LIBRARY)
        .map_err(|e| Failure::case(format_args!("error: cannot read {e}")))
}
