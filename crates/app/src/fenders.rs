//! `fenderline fenders`: the fender library, and every number of a family or of one of its sizes with its source.

use core::fmt::Write as _;
use std::path::PathBuf;

use fenderline_contact::Unloading;
use fenderline_report::plot::{counted, fixed, plain};
use fenderline_scenario::{
    CatalogueFender, FactorTable, Family, FamilyUnloading, FenderLibrary, HullPressureLimit,
    LookUpError, read_text,
};
use serde_json::{Value, json};

use crate::cli::FendersArgs;
use crate::failure::Failure;
use crate::terminal::{answer, say_json};

/// Lists the families with their sizes, or prints one family or one size.
///
/// # Errors
/// Fails if a fender file cannot be used, or if the family or the size is unknown.
pub(crate) fn fenders(args: &FendersArgs) -> Result<(), Failure> {
    let library = library(&args.file)?;
    let Some(name) = &args.family else {
        let (families, limits) = (library.families(), library.hull_pressure_limits());
        if args.json {
            let json = json!({
                "families": families.iter().map(|f| family_json(&library, f)).collect::<Result<Vec<_>, _>>()?,
                "hull_pressures": limits.iter().map(limit_json).collect::<Vec<_>>(),
            });
            return say_json(&format!("{json:#}\n"));
        }
        let mut text = String::new();
        for family in families {
            text += &listed(&library, family)?;
        }
        return answer(&(text + &limits_text(limits)));
    };
    let family = library.family(name).map_err(unknown)?;
    if let Some(size) = &args.size {
        let fender = library.fender(name, size).map_err(unknown)?;
        return match args.json {
            true => say_json(&format!("{:#}\n", size_json(&fender))),
            false => answer(&size_sheet(&fender)),
        };
    }
    if args.json {
        return say_json(&format!("{:#}\n", family_json(&library, family)?));
    }
    answer(&format!("{}{}", listed(&library, family)?, family_sheet(family)))
}

/// The built-in fenders together with the fenders of the given files.
fn library(files: &[PathBuf]) -> Result<FenderLibrary, Failure> {
    files.iter().try_fold(FenderLibrary::built_in(), |library, path| {
        let text = read_text(path)
            .map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
        library.with_file(&text, &path.display().to_string()).map_err(Failure::input)
    })
}

fn unknown(error: LookUpError) -> Failure {
    Failure::input(format_args!("error: {error}\n  = help: {}", error.help()))
}

/// The sizes of a family with their performance.
fn sizes(library: &FenderLibrary, family: &Family) -> Result<Vec<CatalogueFender>, Failure> {
    let size = |size: &fenderline_scenario::FenderSize| {
        library.fender(&family.name, &size.designation).map_err(unknown)
    };
    family.sizes.iter().map(size).collect()
}

/// A line for the fender family and a line for each of its sizes.
fn listed(library: &FenderLibrary, family: &Family) -> Result<String, Failure> {
    let sizes = sizes(library, family)?;
    let count = match sizes.len() {
        0 => "no sizes: a scenario gives `height` and `rated_reaction`".to_owned(),
        many => counted(many as u64, "size", "sizes"),
    };
    let mut text = format!(
        "{}: curve {}, rated at {} % of the height; {count}\n",
        family.name,
        family.standing.word(),
        plain(100.0 * family.rated_deflection, 3)
    );
    if sizes.is_empty() {
        return Ok(text);
    }
    let longest = sizes.iter().map(|size| size.designation.chars().count()).max();
    let width = longest.unwrap_or(0).max("size".len());
    for [name, height, deflection, reaction, energy, standing] in [
        ["size", "height", "deflection", "reaction", "energy", "standing"],
        ["", "m", "m", "kN", "kJ", "of source"],
    ] {
        let _ = writeln!(
            text,
            "  {name:<width$}  {height:>7}  {deflection:>10}  {reaction:>8}  {energy:>8}  {standing}"
        );
    }
    for size in &sizes {
        let _ = writeln!(
            text,
            "  {:<width$}  {:>7}  {:>10}  {:>8}  {:>8}  {}",
            size.designation,
            plain(size.height_m, 4),
            fixed(size.rated_deflection_m, 3),
            plain(size.rated_reaction_n / 1e3, 4),
            plain(size.rated_energy_j / 1e3, 4),
            size.standing.word()
        );
    }
    Ok(text)
}

fn limits_text(limits: &[HullPressureLimit]) -> String {
    let mut text = String::from("\nhull pressure that the side of a ship can bear (kN/m²):\n");
    let longest = limits.iter().map(|limit| limit.ship.chars().count()).max().unwrap_or(0);
    for limit in limits {
        let _ = writeln!(
            text,
            "  {:<longest$}  {:>5}  {}",
            limit.ship,
            plain(limit.limit_npm2 / 1e3, 4),
            limit.standing.word()
        );
    }
    text
}

/// Curve, unloading, factors and tolerance of a family, each with its source.
fn family_sheet(family: &Family) -> String {
    let mut text = String::from(
        "\ncurve: deflection in % of the height, reaction in % of the rated reaction\n",
    );
    for (deflection, reaction) in &family.curve {
        let _ = writeln!(
            text,
            "  {:>5}  {:>6}",
            fixed(100.0 * deflection, 1),
            fixed(100.0 * reaction, 1)
        );
    }
    let _ = writeln!(text, "  [{}] {}", family.standing.word(), family.source);
    if let Some(unloading) = &family.unloading {
        let law = match &unloading.law {
            Unloading::ReturnedEnergy(share) => {
                format!("{} % of the energy is returned", plain(100.0 * share, 3))
            }
            Unloading::Curve(points) => format!("a curve of {} points", points.len()),
        };
        let _ = writeln!(
            text,
            "\nunloading: {law}\n  [{}] {}",
            unloading.standing.word(),
            unloading.source
        );
    }
    let angle = |rad: f64| rad.to_degrees();
    for (what, table, shown) in [
        ("temperature (°C): factor on the reaction", &family.temperature, None),
        ("time to the rated deflection (s): factor on the reaction", &family.velocity, None),
        ("angle (°): factor on the energy", &family.angle_energy, Some(angle as fn(f64) -> f64)),
        ("angle (°): factor on the reaction", &family.angle_reaction, Some(angle)),
    ] {
        if let Some(table) = table {
            text += &factors(what, table, shown.unwrap_or(|value| value));
        }
    }
    if let Some(tolerance) = &family.tolerance {
        let _ = writeln!(
            text,
            "\ntolerance: ±{} %\n  [{}] {}",
            plain(100.0 * tolerance.value, 3),
            tolerance.standing.word(),
            tolerance.source
        );
    }
    text
}

fn factors(what: &str, table: &FactorTable, shown: fn(f64) -> f64) -> String {
    let mut text = format!("\n{what}\n");
    for (value, factor) in &table.points {
        let _ = writeln!(text, "  {:>6}  {}", plain(shown(*value), 4), fixed(*factor, 3));
    }
    if let Some(holds) = &table.holds {
        let _ = writeln!(text, "  holds for {holds}");
    }
    let _ = writeln!(text, "  [{}] {}", table.standing.word(), table.source);
    text
}

/// Text with the performance data of one fender size.
fn size_sheet(fender: &CatalogueFender) -> String {
    let mut text = format!("{} {}\n", fender.family, fender.designation);
    let number = |value: f64, unit: &str| format!("{} {unit}", plain(value, 4));
    let rows = [
        ("height", Some(number(fender.height_m, "m"))),
        ("length", fender.length_m.map(|length_m| number(length_m, "m"))),
        ("rated deflection", Some(number(fender.rated_deflection_m, "m"))),
        ("rated reaction", Some(number(fender.rated_reaction_n / 1e3, "kN"))),
        ("rated energy", Some(number(fender.rated_energy_j / 1e3, "kJ"))),
        (
            "published energy",
            fender.published_energy_j.map(|energy_j| number(energy_j / 1e3, "kJ")),
        ),
        ("hull pressure", fender.hull_pressure_npm2.map(|p| number(p / 1e3, "kN/m²"))),
        ("initial pressure", fender.initial_pressure_npm2.map(|p| number(p / 1e3, "kN/m²"))),
    ];
    for (what, value) in rows {
        if let Some(value) = value {
            let _ = writeln!(text, "  {what:<16}  {value}");
        }
    }
    text += "\ndeflection m, reaction kN\n";
    for (deflection_m, reaction_n) in &fender.curve {
        let _ =
            writeln!(text, "  {:>6}  {:>8}", fixed(*deflection_m, 3), fixed(reaction_n / 1e3, 1));
    }
    let _ = writeln!(text, "  [{}] {}", fender.standing.word(), fender.source);
    text
}

fn family_json(library: &FenderLibrary, family: &Family) -> Result<Value, Failure> {
    let sizes = sizes(library, family)?;
    let factors = |table: &Option<FactorTable>| {
        table.as_ref().map(|table| {
            json!({
                "points": table.points,
                "holds": table.holds,
                "standing": table.standing.word(),
                "source": table.source,
            })
        })
    };
    Ok(json!({
        "name": family.name,
        "rated_deflection": family.rated_deflection,
        "curve": family.curve,
        "standing": family.standing.word(),
        "source": family.source,
        "unloading": family.unloading.as_ref().map(unloading_json),
        "temperature_c": factors(&family.temperature),
        "time_to_rated_deflection_s": factors(&family.velocity),
        "angle_energy_rad": factors(&family.angle_energy),
        "angle_reaction_rad": factors(&family.angle_reaction),
        "tolerance": family.tolerance.as_ref().map(|tolerance| {
            json!({
                "value": tolerance.value,
                "standing": tolerance.standing.word(),
                "source": tolerance.source,
            })
        }),
        "sizes": sizes.iter().map(size_json).collect::<Vec<_>>(),
    }))
}

fn unloading_json(unloading: &FamilyUnloading) -> Value {
    let (law, value) = match &unloading.law {
        Unloading::ReturnedEnergy(share) => ("returned_energy", json!(share)),
        Unloading::Curve(points) => ("curve", json!(points)),
    };
    json!({ law: value, "standing": unloading.standing.word(), "source": unloading.source })
}

fn size_json(fender: &CatalogueFender) -> Value {
    json!({
        "family": fender.family,
        "size": fender.designation,
        "height_m": fender.height_m,
        "length_m": fender.length_m,
        "rated_deflection_m": fender.rated_deflection_m,
        "rated_reaction_n": fender.rated_reaction_n,
        "rated_energy_j": fender.rated_energy_j,
        "published_energy_j": fender.published_energy_j,
        "hull_pressure_npm2": fender.hull_pressure_npm2,
        "initial_pressure_npm2": fender.initial_pressure_npm2,
        "standing": fender.standing.word(),
        "source": fender.source,
    })
}

fn limit_json(limit: &HullPressureLimit) -> Value {
    json!({
        "ship": limit.ship,
        "limit_npm2": limit.limit_npm2,
        "standing": limit.standing.word(),
        "source": limit.source,
    })
}
