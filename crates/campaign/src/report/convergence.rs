//! The section of a report that shows how the estimates settled as the number of runs grew.

use fenderline_report::plot::{Axis, Chart, Point, Series, plain};
use maud::{Markup, html};

use super::{Output, column};
use crate::statistics::convergence::{Step, steps};
use crate::statistics::design::Asked;

/// Largest number of points of the chart: the estimate is shown for at most this many different numbers of runs.
const STEPS: usize = 40;

/// Probability with which a run exceeds the quantile that the chart shows.
const P: f64 = 0.01;

/// Smallest number of runs for which the section is shown.
const FEWEST: usize = 50;

/// A chart for each output.
pub(super) fn section(outputs: &[Output<'_>], asked: &Asked) -> Markup {
    let charts: Vec<Chart> = outputs.iter().filter_map(|output| chart(output, asked)).collect();
    html! {
        @if !charts.is_empty() {
            h2 { "Convergence" }
            p { "Each point of a line is the estimate from the first runs, up to this number of runs. \
                If the line still moves at the end, or its band is wider than you need, make more \
                runs." }
            @for chart in charts { (chart.render()) }
        }
    }
}

/// The chart of an output's mean, and of the value that one run of a hundred exceeds, with their bands.
fn chart(output: &Output<'_>, asked: &Asked) -> Option<Chart> {
    if output.findings.as_ref().ok()?.sample.is_weighted() {
        return None;
    }
    let values: Vec<f64> =
        output.values.iter().copied().filter(|value| value.is_finite()).collect();
    if values.len() < FEWEST {
        return None;
    }
    let steps = steps(&values, P, STEPS, asked.confidence);
    let half = asked.confidence.normal_quantile();
    let line = |of: &dyn Fn(&Step) -> Option<f64>| -> Vec<Point> {
        let point = |step: &Step| Some(Point { x: step.runs as f64, y: of(step)? });
        steps.iter().filter_map(point).collect()
    };
    // A band needs both ends.
    let known = |step: &Step| step.quantile.low.zip(step.quantile.high);
    let name = column::words_of(output.head);
    let per_cent = plain(100.0 * asked.confidence.level(), 4);
    Some(Chart {
        title: format!("{} of the first runs", super::capital(&name)),
        x: Axis::new("number of runs", "").logarithmic(),
        y: Axis::new(&name, &output.head.unit),
        series: vec![
            Series::band(
                &format!("{per_cent} % bands"),
                line(&|step| known(step).map(|(low, _)| low)),
                line(&|step| known(step).map(|(_, high)| high)),
            )
            .styled(1),
            Series::line("exceeded by 1 of 100", line(&|step| step.quantile.value)).styled(1),
            Series::band(
                "",
                line(&|step| Some(step.mean.value - half * step.mean.error)),
                line(&|step| Some(step.mean.value + half * step.mean.error)),
            )
            .styled(0),
            Series::line("mean", line(&|step| Some(step.mean.value))).styled(0),
        ],
        references: Vec::new(),
        linked: None,
        note: String::new(),
    })
}
