//! `fenderline berthings`: measured berthings from logs of docking systems, tracks and AIS.

use std::path::Path;

use fenderline_campaign::store::{About, write_rows};
use fenderline_measured::{
    Berth, BerthError, Berthings, LogsRead, Mapping, Page, Weight, berthings as find, page,
    read_log, table,
};
use fenderline_nautical::{ChartOrigin, GeoPoint};
use fenderline_report::plot::{counted, fixed};
use fenderline_scenario::{Override, Scenario, read_text, read_text_of};

use crate::cli::BerthingsArgs;
use crate::failure::Failure;
use crate::load::Source;
use crate::output::{admit, write_whole};
use crate::terminal::{notice, say};

/// Largest log that is read (bytes).
pub(crate) const LARGEST_BYTES: u64 = 256 << 20;

/// Reads logs, finds the berthings in them, and writes table and report.
///
/// # Errors
/// Fails if the mapping, the scenario or a log cannot be read, if the scenario has no berth, if no log has a berthing,
/// or if a file cannot be written.
pub(crate) fn berthings(args: &BerthingsArgs) -> Result<(), Failure> {
    let mapping = mapping(args.mapping.as_deref())?;
    let source = Source::read(&args.berth).map_err(Failure::input)?;
    let scenario = source.scenario(&[]).map_err(Failure::input)?;
    let refused = |why: &dyn core::fmt::Display| {
        Failure::input(format_args!("error: {}: {why}", args.berth.display()))
    };
    // A scenario without a berth is refused before long logs are read.
    Berth::new(scenario.setup.clone(), &mapping).map_err(|why| refused(&why))?;
    for path in [&args.out, &args.report].into_iter().flatten() {
        admit(path)?;
    }
    let origin = origin(&mapping, &scenario).map_err(|why| refused(&why))?;
    let logs = logs(args, &mapping, origin.as_ref())?;
    let berth_for = |changes: &[Override]| {
        let scenario = match source.scenario(changes) {
            Ok(scenario) => scenario,
            Err(fenderline_scenario::LoadError::Refused(error)) => {
                return Err(BerthError::Scenario(error));
            }
            Err(other) => return Err(BerthError::Lacks(other.to_string())),
        };
        Berth::new(scenario.setup, &mapping).map_err(BerthError::Lacks)
    };
    let found = find(logs, &mapping, &berth_for).map_err(|error| match error {
        BerthError::Scenario(error) => Failure::input(error),
        BerthError::Lacks(why) => refused(&why),
    })?;
    for remark in &found.remarks {
        notice(remark);
    }
    if found.all.is_empty() {
        let worst = found.remarks.iter().find(|remark| remark.weight == Weight::Refused);
        let why = worst.map_or_else(|| "the logs are empty".to_owned(), ToString::to_string);
        return Err(Failure::input(format_args!("error: no berthing was found; {why}")));
    }
    write(args, &scenario, &found)?;
    say(&printed(args, &found))
}

/// The mapping of a file; the default without a file.
///
/// # Errors
/// Fails if the file cannot be read, or for the first mistake in the mapping.
pub(crate) fn mapping(path: Option<&Path>) -> Result<Mapping, Failure> {
    let Some(path) = path else { return Ok(Mapping::default()) };
    let text =
        read_text(path).map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
    Mapping::parse(&text, &path.display().to_string()).map_err(Failure::input)
}

/// The place of the scenario's origin on the earth: by the mapping, or else by the scenario's chart.
///
/// # Errors
/// The place is not on the earth.
pub(crate) fn origin(
    mapping: &Mapping,
    scenario: &Scenario,
) -> Result<Option<ChartOrigin>, String> {
    let of_chart = scenario.setup.world.chart.origin.map(|at| [at.latitude_rad, at.longitude_rad]);
    let Some([latitude_rad, longitude_rad]) = mapping.origin_rad.or(of_chart) else {
        return Ok(None);
    };
    let at = GeoPoint {
        latitude_deg: latitude_rad.to_degrees(),
        longitude_deg: longitude_rad.to_degrees(),
    };
    ChartOrigin::new(at).map(Some).map_err(|error| error.to_string())
}

fn logs(
    args: &BerthingsArgs,
    mapping: &Mapping,
    origin: Option<&ChartOrigin>,
) -> Result<Vec<LogsRead>, Failure> {
    let one = |path: &std::path::PathBuf| {
        let text = read_text_of(path, LARGEST_BYTES)
            .map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
        Ok(read_log(&text, &path.display().to_string(), mapping, origin))
    };
    args.logs.iter().map(one).collect()
}

fn write(args: &BerthingsArgs, scenario: &Scenario, found: &Berthings) -> Result<(), Failure> {
    let names: Vec<String> = args.logs.iter().map(|path| file_name(path)).collect();
    if let Some(path) = &args.out {
        let (heads, rows) = table(found);
        let facts = [("scenario", scenario.title.clone()), ("logs", names.join(", "))];
        let about = About { first: "berthing", facts: &facts };
        write_rows(path, &about, &heads, &rows).map_err(|error| match error.is_disk_full() {
            true => Failure::case(error),
            false => Failure::input(error),
        })?;
    }
    if let Some(path) = &args.report {
        let notices: Vec<String> =
            scenario.notices.iter().map(|notice| notice.message.clone()).collect();
        let of = Page { title: &scenario.title, logs: &names, notices: &notices };
        write_whole(path, page(&of, found).as_bytes())?;
    }
    Ok(())
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// A line a berthing.
fn printed(args: &BerthingsArgs, found: &Berthings) -> String {
    let mut text = String::new();
    for (index, own) in found.all.iter().enumerate() {
        let berth = &found.berths[own.berth];
        let touch = &own.touch;
        text += &format!(
            "{}. {} {}: {} ± {} cm/s, {} ± {}°, first at {}; {}\n",
            index + 1,
            fenderline_measured::time_text(own),
            own.ship,
            fixed(100.0 * touch.speed_mps.value, 1),
            fixed(200.0 * touch.speed_mps.sd, 1),
            fixed(touch.angle_rad.value.to_degrees(), 2),
            fixed(2.0 * touch.angle_rad.sd.to_degrees(), 2),
            berth.fender(touch.fender),
            match &own.run {
                Ok(run) => format!(
                    "formula {} kJ, run {} ± {} kJ{}",
                    fixed(run.formula_j.value / 1e3, 0),
                    fixed(run.energy_j.value / 1e3, 0),
                    match run.energy_j.sd {
                        sd if sd.is_finite() => fixed(2.0 * sd / 1e3, 0),
                        _ => "?".to_owned(),
                    },
                    if run.exceeded.is_empty() { "" } else { ", EXCEEDED" },
                ),
                Err(why) => format!("no run: {why}"),
            },
        );
    }
    let left_out = found.remarks.iter().filter(|remark| remark.weight == Weight::Refused).count();
    text += &counted(found.all.len() as u64, "berthing", "berthings");
    if left_out > 0 {
        text += &format!(", {left_out} left out");
    }
    text += " (± two standard deviations)\n";
    let files =
        [&args.out, &args.report].into_iter().flatten().map(|path| path.display().to_string());
    let files: Vec<String> = files.collect();
    if !files.is_empty() {
        text += &format!("written: {}\n", files.join(", "));
    }
    text
}
