//! `fenderline fender fit` makes a fender file from curves of a test bench, a catalogue or a finite-element analysis.

use core::fmt::Write as _;

use fenderline_author::{CatalogueScale, FenderCurves, FitOptions, FittedFender, LoadingCurve};
use fenderline_contact::number::greater;
use fenderline_scenario::{FenderLibrary, LengthOrShare, Standing, read_text};
use maud::html;

use crate::cli::{FenderCommand, FitArgs, FitStanding};
use crate::failure::Failure;
use crate::output::write_whole;
use crate::terminal::{notice, say};
use fenderline_report::plot::{Axis, Chart, Point, Series, fixed, page};

/// Number of rows of the printed table.
const ROWS: u32 = 10;

/// Carries out a subcommand of `fenderline fender`.
///
/// # Errors
/// Fails if the input is bad or a file cannot be written.
pub(crate) fn fender(command: &FenderCommand) -> Result<(), Failure> {
    match command {
        FenderCommand::Fit(args) => fit(args),
    }
}

/// Fits the curves, writes the fender file, reads it back as a scenario would, and shows the fit.
fn fit(args: &FitArgs) -> Result<(), Failure> {
    let file = args.curves.display().to_string();
    let text = read_text(&args.curves)
        .map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
    let scale =
        CatalogueScale { height_m: Some(args.height), rated_reaction_n: args.rated_reaction };
    let curves = FenderCurves::parse(&text, &file, scale).map_err(Failure::input)?;
    let fitted = FittedFender::fit(&curves, &options(args))
        .map_err(|why| Failure::input(format_args!("error: {file}: {why}")))?;
    let toml = fitted.to_toml();
    let out = args.out.display().to_string();
    FenderLibrary::built_in().with_file(&toml, &out).map_err(Failure::input)?;
    write_whole(&args.out, toml.as_bytes())?;
    if let Some(path) = &args.plot {
        write_whole(path, plotted(&fitted, args).as_bytes())?;
    }
    if let Some(oddity) = fitted.oddity() {
        notice(oddity);
    }
    let mut text = printed(&fitted, &out);
    if args.rated_deflection.is_none() {
        text += "the rated deflection is the end of the curve: --rated-deflection changes this\n";
    }
    say(&text)
}

fn options(args: &FitArgs) -> FitOptions {
    let stem = args.out.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let name = || stem.clone().unwrap_or_else(|| "fitted".to_owned());
    let source = args.source.clone().unwrap_or_else(|| {
        format!("curves of {}", args.curves.file_name().unwrap_or_default().to_string_lossy())
    });
    FitOptions {
        family: args.family.clone().unwrap_or_else(name),
        designation: args.designation.clone().unwrap_or_else(name),
        height_m: args.height,
        length_m: args.length,
        rated_deflection_m: args.rated_deflection.map(|given| match given {
            LengthOrShare::Metres(metres) => metres,
            LengthOrShare::Share(of_height) => of_height * args.height,
        }),
        rated_reaction_n: args.rated_reaction,
        returned_energy: args.returned_energy,
        tolerance: args.tolerance,
        source,
        standing: match args.standing {
            FitStanding::Found => Standing::Found,
            FitStanding::Derived => Standing::Derived,
            FitStanding::Recalled => Standing::Recalled,
        },
    }
}

/// The measured reaction at a deflection, interpolated between the measured rows (N).
fn measured_n(branch: &[(f64, f64)], deflection_m: f64) -> Option<f64> {
    let after = branch.partition_point(|point| point.0 < deflection_m);
    let next = branch.get(after)?;
    let Some(before) = after.checked_sub(1).map(|index| branch[index]) else { return Some(next.1) };
    Some(before.1 + (next.1 - before.1) * (deflection_m - before.0) / (next.0 - before.0))
}

/// The energy up to a deflection by the measured rows (J).
fn measured_j(branch: &[(f64, f64)], deflection_m: f64) -> f64 {
    let mut points: Vec<(f64, f64)> =
        branch.iter().copied().filter(|point| point.0 < deflection_m).collect();
    points.extend(measured_n(branch, deflection_m).map(|reaction_n| (deflection_m, reaction_n)));
    points.windows(2).map(|two| 0.5 * (two[0].1 + two[1].1) * (two[1].0 - two[0].0)).sum()
}

/// Largest difference between the fit and the measured rows up to the end of the curve, as a share of the rated
/// reaction.
fn largest_difference(fitted: &FittedFender) -> f64 {
    let rows = fitted.reference().loading.iter();
    let off = rows.filter_map(|(d, r)| fitted.reaction_n(*d).map(|fit_n| (fit_n - r).abs()));
    off.fold(0.0, greater) / fitted.rated_reaction_n
}

fn printed(fitted: &FittedFender, out: &str) -> String {
    let LoadingCurve { loading, unloading, .. } = fitted.reference();
    let rated_m = fitted.rated_deflection_m;
    let mut text = String::new();
    let columns = ["deflection", "measured", "fitted", "measured", "fitted", "way out", "fitted"];
    let units = ["mm", "kN", "kN", "kJ", "kJ", "kN", "kN"];
    for line in [columns, units] {
        for cell in line {
            let _ = write!(text, "{cell:>11}");
        }
        text.push('\n');
    }
    let kilo = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| fixed(v / 1e3, 2));
    for row in 1..=ROWS {
        let deflection_m = rated_m * f64::from(row) / f64::from(ROWS);
        for cell in [
            fixed(deflection_m * 1e3, 1),
            kilo(measured_n(loading, deflection_m)),
            kilo(fitted.reaction_n(deflection_m)),
            kilo(Some(measured_j(loading, deflection_m))),
            kilo(Some(fitted.energy_j(deflection_m))),
            kilo(measured_n(unloading, deflection_m)),
            kilo(fitted.unloading_n(deflection_m)),
        ] {
            let _ = write!(text, "{cell:>11}");
        }
        text.push('\n');
    }
    let energy_j = measured_j(loading, rated_m);
    let _ = writeln!(
        text,
        "\nrated: {} mm, {} kN, {} kJ; {} points for {} rows; reaction within {} % of the rated one, energy {} %",
        fixed(rated_m * 1e3, 1),
        fixed(fitted.rated_reaction_n / 1e3, 2),
        fixed(fitted.energy_j(rated_m) / 1e3, 2),
        fitted.points.len(),
        loading.len(),
        fixed(100.0 * largest_difference(fitted), 2),
        fixed(100.0 * (fitted.energy_j(rated_m) / energy_j - 1.0), 2),
    );
    if let Some(share) = fitted.returned_energy() {
        let _ = writeln!(text, "returned energy: {} %", fixed(100.0 * share, 1));
    }
    for (what, unit, rows) in [
        ("speed", "s to rated deflection", &fitted.velocity),
        ("temperature", "°C", &fitted.temperature),
    ] {
        for (at, factor) in rows {
            let _ = writeln!(
                text,
                "factor of {what}: {} at {} {unit}",
                fixed(*factor, 3),
                fixed(*at, 2)
            );
        }
    }
    let _ = writeln!(text, "written to {out}; name this file in `fender_files` of a scenario");
    text
}

/// A page whose charts show the measured rows as marks and the fit as lines.
fn plotted(fitted: &FittedFender, args: &FitArgs) -> String {
    let LoadingCurve { loading, unloading, .. } = fitted.reference();
    let millimetres = |(d, r): &(f64, f64)| Point { x: d * 1e3, y: r / 1e3 };
    let line = |branch: &[(f64, f64)]| -> Vec<Point> {
        let si = |(d, r): &(f64, f64)| (d * args.height, r * fitted.rated_reaction_n);
        branch.iter().map(|point| millimetres(&si(point))).collect()
    };
    let mut series = vec![
        Series::line("fitted", line(&fitted.points)).styled(0),
        Series::marks("measured", loading.iter().map(millimetres).collect()).styled(0),
    ];
    if !unloading.is_empty() {
        series.push(Series::line("fitted, way out", line(&fitted.unloading)).styled(1));
        let rows = unloading.iter().map(millimetres).collect();
        series.push(Series::marks("measured, way out", rows).styled(1));
    }
    let chart = Chart {
        title: "Reaction over deflection".to_owned(),
        x: Axis::new("deflection", "mm").including(0.0),
        y: Axis::new("reaction", "kN").including(0.0),
        series,
        references: Vec::new(),
        linked: None,
        note: format!(
            "{} points for {} rows; the fit is within {} % of the rated reaction.",
            fitted.points.len(),
            loading.len(),
            fixed(100.0 * largest_difference(fitted), 2)
        ),
    };
    let title = format!("Fender fitted to {}", args.curves.display());
    page(&title, &html! { h1 { (title) } (chart.render()) })
}
