//! `fenderline vessels`: the vessels of the data, and every number of one of them with its source.

use core::fmt::Write as _;
use std::path::PathBuf;

use fenderline_scenario::{VesselData, VesselLibrary, read_text};
use fenderline_sim::hydro::Route;
use fenderline_sim::hydro::vessels::{Origin, Source};
use serde_json::{Map, Value, json};

use crate::cli::VesselsArgs;
use crate::failure::Failure;
use crate::plot::{fixed, plain};
use crate::terminal::say;
use crate::validate::{EstimateError, estimate_errors};

/// Lists the vessels, or tells one of them.
///
/// # Errors
/// A file that cannot be used, a vessel that is not known.
pub(crate) fn vessels(args: &VesselsArgs) -> Result<(), Failure> {
    let library = library(&args.file)?;
    let Some(name) = &args.vessel else {
        let all = library.vessels();
        if args.json {
            let all: Vec<Value> = all.iter().map(vessel_json).collect();
            return say(&format!("{:#}\n", json!(all)));
        }
        return say(&all.iter().map(line).collect::<String>());
    };
    let vessel = found(&library, name)?;
    say(&if args.json { format!("{:#}\n", vessel_json(vessel)) } else { sheet(vessel) })
}

/// The vessels that the program carries in itself, with those of files.
///
/// # Errors
/// A file that cannot be read or is no good vessel file.
pub(crate) fn library(files: &[PathBuf]) -> Result<VesselLibrary, Failure> {
    files.iter().try_fold(VesselLibrary::built_in(), |library, path| {
        let text = read_text(path)
            .map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
        library.with_file(&text, &path.display().to_string()).map_err(Failure::input)
    })
}

/// The vessel of a name.
///
/// # Errors
/// There is none.
pub(crate) fn found<'l>(library: &'l VesselLibrary, name: &str) -> Result<&'l VesselData, Failure> {
    library
        .vessel(name)
        .map_err(|error| Failure::input(format_args!("error: {error}\n  = help: {}", error.help())))
}

/// What of a vessel is estimated, one line each; nothing where nothing is.
pub(crate) fn estimates(name: &str, origin: &Origin) -> String {
    let mut text = String::new();
    for (index, source) in origin.estimates().enumerate() {
        if index == 0 {
            let _ = writeln!(text, "{name} ({}): estimated, not validated for her:", origin.title);
        }
        text.push_str(&source_line(source));
    }
    text.push_str(&accuracy_text(origin));
    text
}

/// How far the estimate of a vessel is to be relied on: where she is outside the range of the formulas, and what error
/// they have on ships with references. Nothing of a vessel whose hull, propeller and rudder are her own.
pub(crate) fn accuracy(origin: &Origin) -> Vec<String> {
    let Some(route) = origin.route else { return Vec::new() };
    let mut lines: Vec<String> = origin.outside.iter().map(ToString::to_string).collect();
    match route {
        Route::Clarke => lines.push(
            "no vessel like her was found to hold the formulas against: their error is not known"
                .to_owned(),
        ),
        Route::YoshimuraMasumoto => lines.extend(estimate_errors(route).iter().map(|error| {
            let percent = |share: f64| signed_percent(share);
            let [(low_ship, low), (high_ship, high)] = &error.ends;
            format!(
                "{}: off by {} in the mean of {} ships with references, from {} ({low_ship}) to {} ({high_ship}); bias {}",
                error.name,
                percent(error.size).trim_start_matches('+'),
                error.ships,
                percent(*low),
                percent(*high),
                percent(error.bias)
            )
        })),
    }
    lines
}

/// The same as lines of text under a heading.
pub(crate) fn accuracy_text(origin: &Origin) -> String {
    let lines = accuracy(origin);
    if lines.is_empty() {
        return String::new();
    }
    let lines: String = lines.iter().map(|line| format!("  {line}\n")).collect();
    format!("{ACCURACY}:\n{lines}")
}

/// The heading of [`accuracy`].
pub(crate) const ACCURACY: &str =
    "How far these estimates are to be relied on (`fenderline validate`)";

fn signed_percent(share: f64) -> String {
    let text = format!("{:+.0} %", 100.0 * share).replace('-', "−");
    if matches!(text.as_str(), "+0 %" | "−0 %") { "0 %".to_owned() } else { text }
}

/// The same as JSON; null where nothing of hull, propeller and rudder is estimated.
pub(crate) fn accuracy_json(origin: &Origin) -> Value {
    let Some(route) = origin.route else { return Value::Null };
    let outside: Vec<Value> = origin
        .outside
        .iter()
        .map(|outside| {
            json!({
                "ratio": outside.ratio.name(),
                "value": outside.value,
                "low": outside.range[0],
                "high": outside.range[1],
            })
        })
        .collect();
    let (formulas, errors) = match route {
        Route::Clarke => ("Clarke, Gedling & Hine (1983)", Vec::new()),
        Route::YoshimuraMasumoto => ("Yoshimura & Masumoto (2012)", {
            let object = |error: &EstimateError| {
                json!({
                    "measure": error.measure,
                    "mean_size": error.size,
                    "bias": error.bias,
                    "lowest": error.ends[0].1,
                    "highest": error.ends[1].1,
                    "ships": error.ships,
                })
            };
            estimate_errors(route).iter().map(object).collect()
        }),
    };
    json!({ "formulas": formulas, "outside": outside, "errors": errors })
}

/// A source as JSON.
pub(crate) fn source(source: &Source) -> Value {
    let figures: Map<String, Value> =
        source.figures.iter().map(|figure| (figure.name.clone(), json!(figure.text))).collect();
    json!({
        "group": source.group,
        "figures": figures,
        "source": source.source,
        "standing": source.standing.word(),
        "estimated": source.is_estimate,
    })
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

/// Every number by source, the estimates last.
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
        let _ = writeln!(text, "not known of her: {}", lacks.join(", "));
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
        text.push_str("\nEstimated by formulas, not validated for her:\n");
    }
    estimates.for_each(|source| text.push_str(&source_line(source)));
    text.push_str(&accuracy_text(&vessel.origin));
    text
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
        "sources": vessel.origin.sources.iter().map(source).collect::<Vec<_>>(),
        "estimate": accuracy_json(&vessel.origin),
    })
}
