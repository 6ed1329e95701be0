//! The columns of results that the table of every campaign has.

use super::numbers::{Numbers, Peak};
use crate::row::{Cell, Head};

/// A column of numbers: name, unit, and its value in a run.
struct Column {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&Numbers) -> Cell,
}

fn number(value: Option<f64>) -> Cell {
    value.filter(|value| value.is_finite()).map_or(Cell::Empty, Cell::Number)
}

/// The cell's value if a fender was touched, else 0.
fn or_none(of: &Numbers, value: Cell) -> Cell {
    if of.touched == 0 { Cell::Number(0.0) } else { value }
}

fn text(value: Option<&str>) -> Cell {
    value.map_or(Cell::Empty, |text| Cell::Text(text.to_owned()))
}

fn scaled(peak: Option<&Peak>, factor: f64) -> Cell {
    number(peak.map(|peak| peak.value * factor))
}

fn share(peak: Option<&Peak>) -> Cell {
    number(peak.and_then(|peak| peak.share).map(|share| 100.0 * share))
}

fn fender(peak: Option<&Peak>) -> Cell {
    text(peak.map(|peak| peak.fender.as_str()))
}

const fn column(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&Numbers) -> Cell,
) -> Column {
    Column { name, unit, meaning, value }
}

const COLUMNS: [Column; 28] = [
    column("verdict", "", "the worst finding of the run, as a word", |of| {
        Cell::Text(of.verdict.key().to_owned())
    }),
    column("gravity", "", "gravity of the worst finding", |of| {
        Cell::Text(of.verdict.gravity().key().to_owned())
    }),
    column("finding", "", "the worst finding of the run, in a sentence", |of| {
        Cell::Text(of.finding.clone())
    }),
    column("governing_fender", "", "the most used fender", |of| {
        text(of.governing.as_ref().map(|g| g.0.as_str()))
    }),
    column(
        "governing_quantity",
        "",
        "the quantity of the most used fender that is nearest to its rated value",
        |of| text(of.governing.as_ref().map(|g| g.1)),
    ),
    column("governing_share", "%", "largest share of a fender's rated value", |of| {
        or_none(of, number(of.governing.as_ref().map(|g| 100.0 * g.2)))
    }),
    column("energy", "kJ", "largest energy that one fender absorbed", |of| {
        or_none(of, scaled(of.energy.as_ref(), 1e-3))
    }),
    column(
        "energy_share",
        "%",
        "largest energy of a fender as a share of its rated energy",
        |of| or_none(of, share(of.energy.as_ref())),
    ),
    column("energy_fender", "", "that fender", |of| fender(of.energy.as_ref())),
    column("reaction", "kN", "largest reaction of one fender", |of| {
        or_none(of, scaled(of.reaction.as_ref(), 1e-3))
    }),
    column(
        "reaction_share",
        "%",
        "largest reaction of a fender as a share of its rated reaction",
        |of| or_none(of, share(of.reaction.as_ref())),
    ),
    column("reaction_fender", "", "that fender", |of| fender(of.reaction.as_ref())),
    column("deflection", "mm", "largest deflection of one fender", |of| {
        or_none(of, scaled(of.deflection.as_ref(), 1e3))
    }),
    column(
        "deflection_share",
        "%",
        "largest deflection of a fender as a share of its rated deflection",
        |of| or_none(of, share(of.deflection.as_ref())),
    ),
    column("hull_pressure", "kN/m²", "largest pressure of one fender on a hull", |of| {
        or_none(of, scaled(of.pressure.as_ref(), 1e-3))
    }),
    column(
        "hull_pressure_share",
        "%",
        "largest pressure on a hull as a share of the permissible pressure",
        |of| or_none(of, share(of.pressure.as_ref())),
    ),
    column("fenders_touched", "", "number of fenders that were touched", |of| {
        Cell::Number(of.touched as f64)
    }),
    column("first_hit_energy", "kJ", "energy of all fenders in the first hit", |of| {
        number(of.first_hit_j.map(|j| j * 1e-3))
    }),
    column("formula_energy", "kJ", "berthing energy by formula", |of| {
        number(of.formula_j.map(|j| j * 1e-3))
    }),
    column(
        "first_touch_speed",
        "m/s",
        "approach speed normal to the fender's face when the first fender was touched",
        |of| number(of.first_touch.map(|touch| touch.0)),
    ),
    column(
        "first_touch_angle",
        "deg",
        "angle between hull and fender face at the first touch",
        |of| number(of.first_touch.map(|t| t.1.to_degrees())),
    ),
    column("struck_force", "kN", "largest force on a structure that was struck", |of| {
        Cell::Number(of.struck_n.unwrap_or(0.0) * 1e-3)
    }),
    column("contact_force", "kN", "largest normal force between two bodies", |of| {
        number(of.contact.map(|(force_n, _)| force_n * 1e-3))
    }),
    column(
        "contact_depth",
        "m",
        "largest overlap of two bodies, or deflection of a fender between two bodies",
        |of| number(of.contact.map(|(_, depth_m)| depth_m)),
    ),
    column(
        "line_share",
        "%",
        "largest share of a line's working load, or of its break load where it has no working load",
        |of| number(of.line_share.map(|share| 100.0 * share)),
    ),
    column("under_keel", "m", "least under-keel clearance", |of| number(of.under_keel_m)),
    column("alongside", "s", "time in which a fender was touched", |of| {
        number(Some(of.alongside_s))
    }),
    column("lines_parted", "", "number of lines that parted", |of| {
        Cell::Number(of.lines_parted as f64)
    }),
];

/// Names of the columns that hold words.
const WORDS: [&str; 7] = [
    "verdict",
    "gravity",
    "finding",
    "governing_fender",
    "governing_quantity",
    "energy_fender",
    "reaction_fender",
];

/// The heads of the result columns of every run.
pub(super) fn heads() -> Vec<Head> {
    let head = |column: &Column| Head {
        is_text: WORDS.contains(&column.name),
        ..Head::new(column.name, column.unit, column.meaning)
    };
    COLUMNS.iter().map(head).collect()
}

/// The cells of the results of a run.
pub(super) fn cells(numbers: &Numbers) -> impl Iterator<Item = Cell> {
    COLUMNS.iter().map(|column| (column.value)(numbers))
}

/// The cells of the results of a run that was not made.
pub(super) fn cells_of_failure() -> impl Iterator<Item = Cell> {
    COLUMNS.iter().map(|column| match column.name {
        "verdict" => Cell::Text("error".to_owned()),
        _ => Cell::Empty,
    })
}
