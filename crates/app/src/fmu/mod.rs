//! `fenderline fmu`: a scenario as a functional mock-up unit.

mod libraries;

use fenderline_fmu::{Bundle, BundleError, Fmi, Kind, Plan, PlanError, Platform, pack};

use self::libraries::{Library, libraries};
use crate::cli::{FmiVersion, FmuArgs, FmuKind};
use crate::failure::Failure;
use crate::load::Source;
use crate::output::write_whole;
use crate::terminal::{notice, say};

/// Writes the FMU that `args` describe. No file is written before the scenario is accepted.
///
/// # Errors
/// Fails if the input is bad, if a library is missing or does not make an instance of the FMU, or if a file cannot be
/// written.
pub(crate) fn fmu(args: &FmuArgs) -> Result<(), Failure> {
    let source = Source::read(&args.scenario).map_err(Failure::input)?;
    let overrides = args.changes.overrides().map_err(Failure::input)?;
    let scenario = source.scenario(&overrides).map_err(Failure::input)?;
    scenario.notices.iter().for_each(notice);
    let kind = match args.kind {
        FmuKind::Engine => Kind::Engine,
        FmuKind::Simulation => Kind::Simulation,
    };
    let fmi = match args.fmi {
        FmiVersion::Two => Fmi::Two,
        FmiVersion::Three => Fmi::Three,
    };
    let changes = args.changes.keys_and_values().map_err(Failure::input)?;
    let bundle = Bundle::of_text(kind, source.text, &source.shown, &source.folder, changes)
        .map_err(Failure::input)?;
    let plan = Plan::new(bundle).map_err(|error| match error {
        PlanError::Bundle(BundleError::NotABundle(_)) => Failure::case(error),
        error => Failure::input(error),
    })?;
    let stem = args.out.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let libraries = libraries(args)?;
    libraries.iter().try_for_each(|library| library.check(&plan))?;
    let files: Vec<(Platform, &[u8])> =
        libraries.iter().map(|library| (library.platform, &*library.bytes)).collect();
    let packed = pack(&plan, fmi, &stem, &files).map_err(Failure::case)?;
    write_whole(&args.out, &packed.fmu)?;
    let osp_path = args.out.with_file_name(&packed.osp_name);
    write_whole(&osp_path, packed.osp.as_bytes())?;
    say(&format!(
        "{}: {} of \"{}\", FMI {}, {} variables, {} KiB\n{}{}: its groups of variables, for OSP\n",
        args.out.display(),
        kind.name(),
        plan.scenario.title,
        if fmi == Fmi::Two { "2.0" } else { "3.0" },
        plan.table.variables.len(),
        packed.fmu.len() / 1024,
        platforms(&libraries),
        osp_path.display(),
    ))
}

/// A line that names the platforms of the FMU, and says which libraries could not be tried on this machine.
fn platforms(libraries: &[Library]) -> String {
    let name = |library: &Library| {
        let tried = if library.platform.is_loadable() { "" } else { " (not tried here)" };
        format!("{}{tried}", library.platform)
    };
    let names: Vec<String> = libraries.iter().map(name).collect();
    format!("platforms: {}\n", names.join(", "))
}
