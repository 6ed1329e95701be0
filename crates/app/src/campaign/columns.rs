//! The table of a campaign: a row a case.

use fenderline_scenario::Campaign;

use super::axis::Axis;
use super::case::{Case, Done, Numbers, Peak};

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    /// Words.
    Text(String),
    /// A number; never one that is not finite.
    Number(f64),
    /// Nothing: not known, or the case did not run.
    Empty,
}

/// A table with units.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CaseTable {
    /// Name and unit of each column.
    pub(crate) heads: Vec<(String, String)>,
    /// Rows.
    pub(crate) rows: Vec<Vec<Cell>>,
}

/// A column of numbers: name, unit, and its value in a run.
struct Column {
    name: &'static str,
    unit: &'static str,
    value: fn(&Numbers) -> Cell,
}

fn number(value: Option<f64>) -> Cell {
    value.filter(|value| value.is_finite()).map_or(Cell::Empty, Cell::Number)
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

const fn column(name: &'static str, unit: &'static str, value: fn(&Numbers) -> Cell) -> Column {
    Column { name, unit, value }
}

const COLUMNS: [Column; 24] = [
    column("verdict", "", |of| Cell::Text(of.verdict.key().to_owned())),
    column("gravity", "", |of| Cell::Text(of.verdict.gravity().key().to_owned())),
    column("finding", "", |of| Cell::Text(of.finding.clone())),
    column("governing_fender", "", |of| text(of.governing.as_ref().map(|g| g.0.as_str()))),
    column("governing_quantity", "", |of| text(of.governing.as_ref().map(|g| g.1))),
    column("governing_share", "%", |of| number(of.governing.as_ref().map(|g| 100.0 * g.2))),
    column("energy", "kJ", |of| scaled(of.energy.as_ref(), 1e-3)),
    column("energy_share", "%", |of| share(of.energy.as_ref())),
    column("energy_fender", "", |of| fender(of.energy.as_ref())),
    column("reaction", "kN", |of| scaled(of.reaction.as_ref(), 1e-3)),
    column("reaction_share", "%", |of| share(of.reaction.as_ref())),
    column("reaction_fender", "", |of| fender(of.reaction.as_ref())),
    column("deflection", "mm", |of| scaled(of.deflection.as_ref(), 1e3)),
    column("deflection_share", "%", |of| share(of.deflection.as_ref())),
    column("hull_pressure", "kN/m²", |of| scaled(of.pressure.as_ref(), 1e-3)),
    column("hull_pressure_share", "%", |of| share(of.pressure.as_ref())),
    column("fenders_touched", "", |of| Cell::Number(of.touched as f64)),
    column("first_hit_energy", "kJ", |of| number(of.first_hit_j.map(|j| j * 1e-3))),
    column("formula_energy", "kJ", |of| number(of.formula_j.map(|j| j * 1e-3))),
    column("first_touch_speed", "m/s", |of| number(of.first_touch.map(|touch| touch.0))),
    column("first_touch_angle", "deg", |of| number(of.first_touch.map(|t| t.1.to_degrees()))),
    column("struck_force", "kN", |of| number(of.struck_n.map(|force_n| force_n * 1e-3))),
    column("line_share", "%", |of| number(of.line_share.map(|share| 100.0 * share))),
    column("under_keel", "m", |of| number(of.under_keel_m)),
];

/// The table: number of the case, values of the variables, numbers of the run, notices, error.
pub(super) fn table(campaign: &Campaign, cases: &[Case]) -> CaseTable {
    let axes: Vec<Option<Axis>> = campaign.variables.iter().map(Axis::of).collect();
    let named = |name: &str, unit: &str| (name.to_owned(), unit.to_owned());
    let mut heads = vec![named("case", "")];
    heads.extend(campaign.variables.iter().zip(&axes).map(|(variable, axis)| {
        named(&variable.name, axis.as_ref().map_or("", |axis| axis.unit.as_str()))
    }));
    heads.extend(COLUMNS.iter().map(|column| named(column.name, column.unit)));
    heads.extend([named("notices", ""), named("error", "")]);
    let row = |case: &Case| {
        let mut cells = vec![Cell::Number((case.index + 1) as f64)];
        let choices = campaign.choices(case.index);
        let labels = campaign.labels(case.index);
        cells.extend(choices.iter().zip(labels).zip(&axes).map(|((choice, label), axis)| {
            let place = axis.as_ref().map(|axis| Cell::Number(axis.places[*choice]));
            place.unwrap_or_else(|| Cell::Text(label.to_owned()))
        }));
        match &case.done {
            Done::Run(numbers) => {
                cells.extend(COLUMNS.iter().map(|column| (column.value)(numbers)));
                cells.extend([Cell::Number(numbers.notices as f64), Cell::Empty]);
            }
            Done::Failed(why) => {
                cells.extend(COLUMNS.iter().map(|column| match column.name {
                    "verdict" => Cell::Text("error".to_owned()),
                    _ => Cell::Empty,
                }));
                cells.extend([Cell::Empty, Cell::Text(why.clone())]);
            }
        }
        cells
    };
    CaseTable { heads, rows: cases.iter().map(row).collect() }
}

impl CaseTable {
    /// As comma-separated text: the unit is part of the column's name, as in `energy [kJ]`.
    ///
    /// # Errors
    /// The text cannot be made.
    pub(super) fn csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(self.heads.iter().map(|(name, unit)| match unit.as_str() {
            "" => name.clone(),
            unit => format!("{name} [{unit}]"),
        }))?;
        for row in &self.rows {
            writer.write_record(row.iter().map(Cell::shown))?;
        }
        writer.into_inner().map_err(|error| error.into_error().into())
    }
}

impl Cell {
    /// Numbers in the shortest form that reads back to the same value.
    pub(super) fn shown(&self) -> String {
        match self {
            Cell::Text(text) => text.clone(),
            Cell::Number(value) => format!("{value}"),
            Cell::Empty => String::new(),
        }
    }
}
