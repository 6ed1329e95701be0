//! The figure of a campaign: a page of charts without outside resources. One variable is the horizontal axis, another
//! variable makes the lines, and there is a chart for each combination of the remaining variables.

use fenderline_campaign::Campaign;
use fenderline_campaign::Cell;
use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_report::plot::{Axis as ChartAxis, Chart, Point, Reference, Series, page, plain};
use maud::{Markup, html};

use super::axis::Axis;
use super::gathered::{CaseTable, Gathered};

/// Largest number of charts of a quantity, and of rows of the table, so that the page stays readable.
const MOST_CHARTS: usize = 60;
const MOST_ROWS: usize = 2000;
/// Largest number of lines in a chart, so that the lines can be told apart.
const MOST_LINES: usize = fenderline_report::plot::STYLES;

/// Values above this multiple of the limit are drawn at this multiple, so that a failed fender does not flatten the
/// chart of the other cases.
const DRAWN_LIMITS: f64 = 2.0;

/// Which variable is the horizontal axis, and which makes the lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) x: usize,
    pub(super) lines: Option<usize>,
}

impl Layout {
    /// The variables that `x` and `lines` name. If the user names no variable, the horizontal axis is the first
    /// variable with numbers, and the lines are made by the first of the remaining variables.
    ///
    /// # Errors
    /// Fails if no variable has the given name, if both options name the same variable, or if there are too many lines.
    pub(super) fn of(
        campaign: &Campaign,
        x: Option<&str>,
        lines: Option<&str>,
    ) -> Result<Layout, String> {
        let variables = &campaign.variables;
        let named = |option: &str, name: &str| {
            let found = variables.iter().position(|variable| variable.name == name);
            found.ok_or_else(|| {
                let names: Vec<&str> = variables.iter().map(|own| own.name.as_str()).collect();
                format!("{option} {name}: the variables are {}", names.join(", "))
            })
        };
        let lines = lines.map(|name| named("--lines", name)).transpose()?;
        let x = match x {
            Some(name) => named("--x", name)?,
            None => {
                let free = |index: &usize| Some(*index) != lines;
                let numeric = |index: &usize| Axis::of(&variables[*index]).is_some();
                let mut all = (0..variables.len()).filter(free);
                all.clone().find(numeric).or_else(|| all.next()).unwrap_or(0)
            }
        };
        if lines == Some(x) {
            return Err("--x and --lines name the same variable".to_owned());
        }
        let fits = |index: &usize| *index != x && variables[*index].choices().len() <= MOST_LINES;
        if let Some(index) = lines.filter(|index| !fits(index)) {
            let count = variables[index].choices().len();
            return Err(format!(
                "--lines: {count} lines cannot be distinguished; at most \
                {MOST_LINES} lines are drawn"
            ));
        }
        Ok(Layout { x, lines: lines.or_else(|| (0..variables.len()).find(fits)) })
    }
}

/// A quantity that the charts draw over the horizontal axis.
struct Drawn {
    title: &'static str,
    name: &'static str,
    unit: &'static str,
    limit: Option<(&'static str, f64)>,
    /// Column of the table that holds the quantity.
    column: &'static str,
}

/// Index of a case, and the value of the drawn quantity in that case.
struct Value {
    index: usize,
    value: f64,
}

impl Drawn {
    /// The highest value of the quantity that is drawn at its own height; higher values are drawn at this height.
    fn highest(&self) -> f64 {
        self.limit.map_or(f64::INFINITY, |(_, limit)| DRAWN_LIMITS * limit)
    }
}

const DRAWN: [Drawn; 3] = [
    Drawn {
        title: "Use of the governing fender",
        name: "share of its rating",
        unit: "%",
        limit: Some(("rated", 100.0)),
        column: "governing_share",
    },
    Drawn {
        title: "Largest energy of a fender",
        name: "energy",
        unit: "kJ",
        limit: None,
        column: "energy",
    },
    Drawn {
        title: "Largest reaction of a fender",
        name: "reaction",
        unit: "kN",
        limit: None,
        column: "reaction",
    },
];

/// The page.
pub(super) fn render(campaign: &Campaign, gathered: &Gathered, layout: Layout) -> String {
    let table = gathered.table();
    let body = html! {
        h1 { (campaign.title) }
        p { (gathered.count) " of " (campaign.cases()) " cases of "
            (campaign.scenario.file_name().unwrap_or_default().to_string_lossy()) "." }
        @for drawn in &DRAWN { (charts(campaign, &values(table, drawn), drawn, layout)) }
        h2 { "Cases" }
        (rows(table))
    };
    page(&campaign.title, &body)
}

/// The charts of a quantity: one for each combination of the variables that make neither the axis nor the lines.
fn charts(campaign: &Campaign, cases: &[Value], drawn: &Drawn, layout: Layout) -> Markup {
    let variables = &campaign.variables;
    let others: Vec<usize> = (0..variables.len())
        .filter(|index| *index != layout.x && Some(*index) != layout.lines)
        .collect();
    let combinations: usize =
        others.iter().map(|index| variables[*index].choices().len()).product();
    let x = Axis::or_numbered(&variables[layout.x]);
    let top = common_top(cases, drawn);
    let highest = drawn.highest();
    let is_beyond = cases.iter().any(|case| case.value > highest);
    let chart = |number: usize| {
        // The choice of each of the other variables, the last one fastest.
        let mut left = number;
        let mut wanted: Vec<(usize, usize)> = Vec::new();
        for &index in others.iter().rev() {
            let count = variables[index].choices().len();
            wanted.push((index, left % count));
            left /= count;
        }
        wanted.reverse();
        let words = wanted.iter().map(|(index, choice)| {
            format!("{} {}", variables[*index].name, variables[*index].choices()[*choice].label)
        });
        let title =
            [drawn.title.to_owned()].into_iter().chain(words).collect::<Vec<_>>().join(", ");
        let here = |chosen: &[usize]| wanted.iter().all(|(index, own)| chosen[*index] == *own);
        let series = match layout.lines {
            None => vec![line("", cases, campaign, drawn, (layout.x, &x), &here)],
            Some(of) => variables[of]
                .choices()
                .iter()
                .enumerate()
                .map(|(choice, own)| {
                    let name = format!("{} {}", variables[of].name, own.label);
                    let on_line = |chosen: &[usize]| here(chosen) && chosen[of] == choice;
                    line(&name, cases, campaign, drawn, (layout.x, &x), &on_line)
                })
                .collect(),
        };
        let limit = drawn.limit.map(|(label, value)| Reference { label: label.to_owned(), value });
        Chart {
            title,
            x: ChartAxis::new(&x.name, &x.unit),
            y: ChartAxis::new(drawn.name, drawn.unit).including(0.0).including(top),
            series,
            references: limit.into_iter().collect(),
            linked: None,
            note: if is_beyond {
                let shown = format!("{} {}", plain(highest, 4), drawn.unit);
                format!(
                    "Values beyond {shown} are drawn at {shown}; the table has the true values."
                )
            } else {
                String::new()
            },
        }
    };
    html! {
        h2 { (drawn.title) }
        @for number in 0..combinations.min(MOST_CHARTS) { (chart(number).render()) }
        @if combinations > MOST_CHARTS {
            p { "The first " (MOST_CHARTS) " of " (combinations) " charts." }
        }
    }
}

/// Upper end of the vertical axis in all charts of a quantity, so that the charts can be compared. A failed fender may
/// be far above its limit, but does not flatten the other charts.
fn common_top(cases: &[Value], drawn: &Drawn) -> f64 {
    let most = cases.iter().map(|case| case.value).fold(0.0, greater);
    match drawn.limit {
        Some((_, limit)) => bounded(most, 1.1 * limit, 1.5 * limit),
        None => most,
    }
}

/// The values of a quantity in the cases that ran.
fn values(table: &CaseTable, drawn: &Drawn) -> Vec<Value> {
    let place = table.heads.iter().position(|head| head.name == drawn.column);
    let place = place.expect("every campaign has it");
    let value = |row: &Vec<Cell>| {
        let index = row[0].number()? as usize - 1;
        Some(Value { index, value: row[place].number()? })
    };
    table.rows.iter().filter_map(value).collect()
}

/// One line of a chart: the cases for which `is_on` is true, in the order of the horizontal axis.
fn line(
    name: &str,
    cases: &[Value],
    campaign: &Campaign,
    drawn: &Drawn,
    (x, axis): (usize, &Axis),
    is_on: &dyn Fn(&[usize]) -> bool,
) -> Series {
    let mut points: Vec<Point> = Vec::new();
    for case in cases {
        let chosen = campaign.choices(case.index);
        if is_on(&chosen) {
            points
                .push(Point { x: axis.places[chosen[x]], y: lesser(case.value, drawn.highest()) });
        }
    }
    points.sort_by(|one, other| one.x.total_cmp(&other.x));
    Series::line(name, points).with_marks()
}

fn rows(table: &CaseTable) -> Markup {
    let shown = |cell: &Cell| match cell {
        Cell::Number(value) => plain(*value, 4),
        other => other.shown(),
    };
    html! {
        div class="wide" {
            table {
                thead { tr { @for head in &table.heads {
                    th { (head.name.replace('_', " ")) @if !head.unit.is_empty() { " [" (head.unit) "]" } }
                } } }
                tbody { @for row in table.rows.iter().take(MOST_ROWS) {
                    tr { @for cell in row { td { (shown(cell)) } } }
                } }
            }
        }
        @if table.rows.len() > MOST_ROWS {
            p { "The first " (MOST_ROWS) " of " (table.rows.len()) " rows are shown; cases.csv has all rows." }
        }
    }
}
