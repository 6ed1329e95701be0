//! The one module that draws sweeps: our curves as lines, the references beside them.

use fenderline_report::plot::{Axis, Chart, Point, Series};

use super::Swept;
use super::check::Compared;

/// Width of a band, as a share, below which it is not drawn: a narrow band between marks far apart would look like a
/// stroke beside the curve.
const DRAWN_BAND: f64 = 0.05;

/// Every second one of the sampled places is drawn.
const EVERY: usize = 2;

/// Makes the chart of a sweep: a line for each curve; references as marks in the colour of their curve, or as a line,
/// within their band.
pub(super) fn chart(swept: &Swept) -> Chart {
    let Swept { sweep, judged } = swept;
    let mut series: Vec<Series> = Vec::new();
    for compared in judged.compared.iter().filter(|compared| compared.band >= DRAWN_BAND) {
        series.push(band(compared).styled(style_of(swept, &compared.curve)));
    }
    for (index, (curve, values)) in sweep.curves.iter().zip(&judged.values).enumerate() {
        let points = judged.places.iter().zip(values).map(|(&x, &y)| Point { x, y });
        let points = points.step_by(EVERY);
        series.push(Series::line(&curve.name, points.collect()).styled(index));
    }
    let mut next = sweep.curves.len();
    for (index, compared) in judged.compared.iter().enumerate() {
        let is_another = |before: &Compared| before.curve == compared.curve && !before.is_line;
        let has_another = judged.compared[..index].iter().any(is_another);
        let name = match sweep.curves.len() {
            1 => compared.short.clone(),
            _ => format!("{}: {}", compared.curve, compared.short),
        };
        let points = compared.points.iter().map(|&[x, y, _]| Point { x, y }).collect();
        // The first marks of a curve have its colour, others their own.
        let style = if compared.is_line || has_another {
            next += 1;
            next - 1
        } else {
            style_of(swept, &compared.curve)
        };
        let drawn = if compared.is_line { Series::line } else { Series::marks };
        series.push(drawn(&name, points).styled(style));
    }
    let [label, unit] = sweep.value;
    Chart {
        title: sweep.title.clone(),
        x: Axis::new(sweep.axis.name, sweep.axis.unit).tight(),
        y: Axis::new(label, unit).including(0.0),
        series,
        references: Vec::new(),
        linked: None,
        note: sweep.note.to_owned(),
    }
}

fn style_of(swept: &Swept, curve: &str) -> usize {
    swept.sweep.curves.iter().position(|own| own.name == curve).unwrap_or(0)
}

/// The band of values that a reference allows, without a name of its own in the legend.
fn band(compared: &Compared) -> Series {
    let edge = |sign: f64| {
        let points = compared.points.iter();
        points.map(|&[x, y, allowed]| Point { x, y: y + sign * allowed }).collect()
    };
    Series::band("", edge(-1.0), edge(1.0))
}
