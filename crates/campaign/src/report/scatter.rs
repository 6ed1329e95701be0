//! The chart that compares the energy of each run with the energy by the berthing formula for the same inputs.

use fenderline_contact::number::greater;
use fenderline_report::plot::{Axis, Chart, Point, Series, fixed, significant};
use maud::{Markup, html};

use crate::table::{Table, TableError};

/// The two columns: largest energy of a fender, and PIANC's berthing energy of the same approach.
const ENERGY: &str = "energy";
const FORMULA: &str = "formula_energy";

/// Number of runs with the highest energies, which are all drawn; of the other runs only every n-th is drawn.
const HIGHEST: usize = 400;
const OTHERS: usize = 2000;

/// The section with the chart; empty if the table lacks one of the two columns.
pub(super) fn section(table: &Table) -> Result<Markup, TableError> {
    if !(table.has(ENERGY) && table.has(FORMULA)) {
        return Ok(html! {});
    }
    let unit = table.head(ENERGY)?.unit.clone();
    let (energy, formula) = (table.numbers(ENERGY)?.values, table.numbers(FORMULA)?.values);
    let pairs = formula.iter().zip(&energy).map(|(x, y)| Point { x: *x, y: *y });
    let pairs: Vec<Point> = pairs.filter(|p| p.x.is_finite() && p.y.is_finite()).collect();
    if pairs.is_empty() {
        return Ok(html! {});
    }
    let above = pairs.iter().filter(|p| p.y > p.x).count();
    let mut ratios: Vec<f64> = pairs.iter().filter(|p| p.x > 0.0).map(|p| p.y / p.x).collect();
    ratios.sort_unstable_by(f64::total_cmp);
    let end = pairs.iter().map(|p| greater(p.x, p.y)).fold(0.0, greater);
    let count = pairs.len();
    let drawn = thinned(pairs);
    let note = if drawn.len() < count {
        format!(
            "{} of {count} runs are drawn, including the {HIGHEST} with the largest energy.",
            drawn.len()
        )
    } else {
        String::new()
    };
    let chart = Chart {
        title: "Largest energy of one fender, over the formula's energy of the whole berthing"
            .to_owned(),
        x: Axis::new("energy by formula", &unit).including(0.0).including(end),
        y: Axis::new("largest energy of a fender", &unit).including(0.0).including(end),
        series: vec![
            Series::dots("a run", drawn).styled(0),
            Series::line("equal", [0.0, end].map(|x| Point { x, y: x }).to_vec()).styled(6),
        ],
        references: Vec::new(),
        linked: None,
        note,
    };
    Ok(html! {
        h2 { "Beside the formula" }
        p {
            (format!(
                "In {} % of the runs one fender took more energy than the formula gives for the \
                 whole berthing with the same inputs.",
                fixed(100.0 * above as f64 / count as f64, 1),
            ))
            @if let Some(median) = ratios.get(ratios.len() / 2) {
                (format!(
                    " Half of the runs had less than {} times the formula's energy; the largest \
                     ratio is {}.",
                    significant(*median, 3),
                    significant(ratios[ratios.len() - 1], 3),
                ))
            }
        }
        (chart.render_tall())
    })
}

/// Thins out the points of the chart: keeps the points of the highest energies, and every n-th of the other points.
fn thinned(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| b.y.total_cmp(&a.y));
    let every = points.len().saturating_sub(HIGHEST).div_ceil(OTHERS).max(1);
    let kept = |(index, point): (usize, Point)| {
        (index < HIGHEST || (index - HIGHEST).is_multiple_of(every)).then_some(point)
    };
    points.into_iter().enumerate().filter_map(kept).collect()
}
