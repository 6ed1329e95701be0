//! `fenderline vessels` lists the known vessels, or prints every number of one vessel with its source.

use core::f64::consts::{FRAC_PI_4, PI, TAU};
use core::fmt::Write as _;
use std::path::PathBuf;

use fenderline_results::{ACCURACY, accuracy, accuracy_json, source_json};
use fenderline_scenario::{VesselData, VesselLibrary, read_text};
use fenderline_sim::constants::STANDARD_GRAVITY_MPS2;
use fenderline_sim::environment::waves::{DriftHull, wave_number};
use fenderline_sim::hydro::Water;
use fenderline_sim::hydro::vessels::{Origin, Source};
use serde_json::{Value, json};

use crate::cli::VesselsArgs;
use crate::failure::Failure;
use crate::terminal::{answer, say_json};
use fenderline_report::plot::{fixed, plain};
use fenderline_validate::errors_of;

/// Lists the vessels, or prints one vessel.
///
/// # Errors
/// Fails if a vessel file cannot be used, or if the vessel is unknown.
pub(crate) fn vessels(args: &VesselsArgs) -> Result<(), Failure> {
    let library = library(&args.file)?;
    let Some(name) = &args.vessel else {
        let all = library.vessels();
        if args.json {
            let all: Vec<Value> = all.iter().map(vessel_json).collect();
            return say_json(&format!("{:#}\n", json!(all)));
        }
        return answer(&all.iter().map(line).collect::<String>());
    };
    let vessel = found(&library, name)?;
    if !args.json {
        return answer(&sheet(vessel));
    }
    let mut json = vessel_json(vessel);
    json["wave_drift"] = drift_json(&drift(vessel));
    say_json(&format!("{json:#}\n"))
}

/// The built-in vessels together with the vessels of the given files.
///
/// # Errors
/// Fails if a file cannot be read or is not a valid vessel file.
pub(crate) fn library(files: &[PathBuf]) -> Result<VesselLibrary, Failure> {
    files.iter().try_fold(VesselLibrary::built_in(), |library, path| {
        let text = read_text(path)
            .map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
        library.with_file(&text, &path.display().to_string()).map_err(Failure::input)
    })
}

/// Finds the vessel of the given name.
///
/// # Errors
/// Fails if there is no vessel of this name.
pub(crate) fn found<'l>(library: &'l VesselLibrary, name: &str) -> Result<&'l VesselData, Failure> {
    library
        .vessel(name)
        .map_err(|error| Failure::input(format_args!("error: {error}\n  = help: {}", error.help())))
}

/// Lines that name the estimated data of a vessel.
pub(crate) fn estimates(name: &str, origin: &Origin) -> String {
    let mut text = String::new();
    for (index, source) in origin.estimates().enumerate() {
        if index == 0 {
            let _ = writeln!(
                text,
                "{name} ({}): estimated, not validated for this vessel:",
                origin.title
            );
        }
        text.push_str(&source_line(source));
    }
    text.push_str(&accuracy_text(origin));
    text
}

/// Text under a heading that says how accurate a vessel's estimated data are.
pub(crate) fn accuracy_text(origin: &Origin) -> String {
    let lines = accuracy(origin, errors_of(origin));
    if lines.is_empty() {
        return String::new();
    }
    let lines: String = lines.iter().map(|line| format!("  {line}\n")).collect();
    format!("{ACCURACY}:\n{lines}")
}

fn line(vessel: &VesselData) -> String {
    let estimated = vessel.origin.estimates().count();
    let note = match estimated {
        0 => String::new(),
        1 => "; 1 estimate".to_owned(),
        many => format!("; {many} estimates"),
    };
    format!("{:<16} {}; {}{note}\n", vessel.name, vessel.origin.title, size(vessel))
}

fn size(vessel: &VesselData) -> String {
    let hull = &vessel.ship.particulars;
    format!(
        "Lbp {} m, B {} m, T {} m, Cb {}",
        plain(hull.length_m, 4),
        plain(hull.beam_m, 4),
        plain(hull.draught_m, 4),
        fixed(hull.block_coefficient(), 3)
    )
}

/// Text with every number of a vessel, ordered by source, the estimates last.
fn sheet(vessel: &VesselData) -> String {
    let mut text = format!("{}: {}\n", vessel.origin.title, size(vessel));
    let lacks = [
        (vessel.shaft.is_none(), "propeller and rudder"),
        (vessel.windage.is_none(), "wind areas"),
        (vessel.stability.is_none(), "stability"),
        (vessel.outline_m.is_none(), "outline"),
    ];
    let lacks: Vec<_> = lacks.iter().filter(|(lacks, _)| *lacks).map(|(_, what)| *what).collect();
    if !lacks.is_empty() {
        let _ = writeln!(text, "not in the data: {}", lacks.join(", "));
    }
    for source in vessel.origin.sources.iter().filter(|source| !source.is_estimate) {
        let _ = writeln!(text, "\n[{}] {}", source.word(), source.source);
        let width = source.figures.iter().map(|figure| figure.name.chars().count()).max();
        for figure in &source.figures {
            let _ = writeln!(text, "  {:<1$}  {2}", figure.name, width.unwrap_or(0), figure.text);
        }
    }
    let mut estimates = vessel.origin.estimates().peekable();
    if estimates.peek().is_some() {
        text.push_str("\nEstimated by formulas, not validated for this vessel:\n");
    }
    estimates.for_each(|source| text.push_str(&source_line(source)));
    text.push_str(&accuracy_text(&vessel.origin));
    text.push_str(&drift_table(&drift(vessel)));
    text
}

/// Wave frequencies of the table of drift forces (rad/s).
const FREQUENCIES_RADPS: [f64; 12] = [0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2, 1.4, 1.7, 2.0];

/// Water depth so large that it does not affect the waves (m).
const DEEP_M: f64 = 10_000.0;

/// Mean drift forces in a regular wave of one frequency.
struct Drift {
    frequency_radps: f64,
    length_m: f64,
    /// For waves from ahead, the port bow, port, the port quarter and astern: the direction off the bow (rad), and the
    /// force forward, the force to starboard and the moment about midship, each divided by the square of the wave's
    /// amplitude [N/m², N/m², N·m/m²].
    by_heading: [(f64, [f64; 3]); 5],
}

/// Mean wave drift forces on a vessel at rest in deep sea water.
fn drift(vessel: &VesselData) -> Vec<Drift> {
    let hull = DriftHull::of(&vessel.ship.particulars);
    let specific_npm3 = Water::SEA.density_kgpm3 * STANDARD_GRAVITY_MPS2;
    let row = |&frequency_radps: &f64| {
        let number = wave_number(frequency_radps, DEEP_M);
        let at = |heading: u32| {
            let off_bow_rad = f64::from(heading) * FRAC_PI_4;
            let coefficients = hull.coefficients(number, PI - off_bow_rad);
            (off_bow_rad, coefficients.map(|coefficient| specific_npm3 * coefficient))
        };
        Drift {
            frequency_radps,
            length_m: TAU / number,
            by_heading: [at(0), at(1), at(2), at(3), at(4)],
        }
    };
    FREQUENCIES_RADPS.iter().map(row).collect()
}

fn drift_table(rows: &[Drift]) -> String {
    let mut text =
        "\nMean wave drift divided by the square of the wave's amplitude, at rest in deep \
                    water, by formula (reflection after Faltinsen et al. 1980 and Fujii & \
                    Takahashi 1975, motion by the SNNM method of ITTC 7.5-04-01-01.1), not \
                    validated for this vessel:\n"
            .to_owned();
    let _ = writeln!(
        text,
        "  {:>9}  {:>10}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>10}  {:>9}",
        "frequency",
        "length",
        "ahead X",
        "bow X",
        "bow Y",
        "abeam Y",
        "quarter Y",
        "quarter X",
        "astern X"
    );
    let _ = writeln!(
        text,
        "  {:>9}  {:>10}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>10}  {:>9}",
        "rad/s", "m", "kN/m²", "kN/m²", "kN/m²", "kN/m²", "kN/m²", "kN/m²", "kN/m²"
    );
    for row in rows {
        let at = |heading: usize, way: usize| {
            let force_kn = 1e-3 * row.by_heading[heading].1[way];
            // Rounding must not give −0.0.
            fixed(if force_kn.abs() < 0.05 { 0.0 } else { force_kn }, 1)
        };
        let _ = writeln!(
            text,
            "  {:>9}  {:>10}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>10}  {:>9}",
            fixed(row.frequency_radps, 1),
            fixed(row.length_m, 1),
            at(0, 0),
            at(1, 0),
            at(1, 1),
            at(2, 1),
            at(3, 1),
            at(3, 0),
            at(4, 0),
        );
    }
    text
}

fn drift_json(rows: &[Drift]) -> Value {
    let of_row = |row: &Drift| {
        row.by_heading
            .iter()
            .map(|(off_bow_rad, [surge, sway, yaw])| {
                json!({
                    "frequency_radps": row.frequency_radps,
                    "length_m": row.length_m,
                    "from_rad": -off_bow_rad,
                    "surge_npm2": surge,
                    "sway_npm2": sway,
                    "yaw_nmpm2": yaw,
                })
            })
            .collect::<Vec<_>>()
    };
    json!(rows.iter().flat_map(of_row).collect::<Vec<_>>())
}

fn source_line(source: &Source) -> String {
    let figures: Vec<String> =
        source.figures.iter().map(|figure| format!("{} = {}", figure.name, figure.text)).collect();
    let figures =
        if figures.is_empty() { String::new() } else { format!(", {}", figures.join(", ")) };
    format!("  [{}] {}{figures}: {}\n", source.word(), source.group, source.source)
}

fn vessel_json(vessel: &VesselData) -> Value {
    let hull = &vessel.ship.particulars;
    json!({
        "name": vessel.name,
        "title": vessel.origin.title,
        "length_bp_m": hull.length_m,
        "beam_m": hull.beam_m,
        "draught_m": hull.draught_m,
        "block_coefficient": hull.block_coefficient(),
        "sources": sources_json(&vessel.origin),
        "estimate": estimate_json(&vessel.origin),
    })
}

/// The sources of a vessel's data as JSON.
pub(crate) fn sources_json(origin: &Origin) -> Vec<Value> {
    let known = origin.sources.iter().map(|source| source_json(source).checked());
    known.map(|source| source.expect("a source holds texts")).collect()
}

/// How accurate the estimated data of a vessel are, as JSON; null if nothing is estimated.
pub(crate) fn estimate_json(origin: &Origin) -> Value {
    let known = accuracy_json(origin, errors_of(origin)).checked();
    known.expect("ratios of particulars and errors of published cases are finite")
}
