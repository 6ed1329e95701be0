//! The report's chart of the components of the largest contact force.

use maud::{Markup, html};

use super::charts::{Charts, scaled};
use super::recorder::PartsTrace;
use super::recorder::Recorder;
use crate::plot::{Axis, Series};

/// The chart of spring, stop, damper and limiter force over time; empty if there was no contact.
pub(super) fn chart(charts: &Charts<'_>, recorder: &Recorder) -> Markup {
    let Some((name, parts)) = hardest(charts, recorder) else { return html! {} };
    let lines = [
        ("normal force N", parts.total_n.points(), 1.0),
        ("spring", parts.spring_n.points(), 1.0),
        ("stop", parts.stop_n.points(), 1.0),
        ("damper", parts.damper_n.points(), 1.0),
        ("removed by the limiter", parts.limiter_n.points(), -1.0),
    ];
    let lines = lines
        .into_iter()
        .enumerate()
        .map(|(style, (name, points, sign))| Series::line(name, points).scaled(sign).styled(style));
    let series: Vec<Series> = lines.filter(|line| line.largest() > 0.0).collect();
    if series.is_empty() {
        return html! {};
    }
    let (unit, series) = scaled(series, "N");
    let axis = Axis::new("force", &unit).including(0.0);
    let title = format!("Components of the contact force, {name}");
    let mut chart = charts.chart(&title, axis, series);
    chart.note = "N is the sum of the other lines. The impulse-momentum limiter removes spring \
        force that would make the hull rebound faster than the coefficient of restitution allows."
        .to_owned();
    chart.render()
}

/// Name and record of the fender, or of the pair of outlines, with the largest force.
fn hardest<'a>(charts: &Charts<'_>, recorder: &'a Recorder) -> Option<(String, &'a PartsTrace)> {
    let setup = charts.outcome.setup;
    let fenders = recorder
        .fenders
        .iter()
        .map(|trace| (setup.fenders[trace.fender].name.clone(), &trace.parts));
    let pairs = recorder.pairs.iter().map(|trace| {
        let [a, b] = trace.bodies.map(|i| setup.bodies[i].name.as_str());
        (format!("{a} – {b}"), &trace.parts)
    });
    let largest = |parts: &PartsTrace| Series::line("", parts.total_n.points()).largest();
    // The largest N counts, not what the limiter removed.
    let all = fenders.chain(pairs).map(|(name, parts)| (largest(parts), name, parts));
    let hardest = all.reduce(|best, next| if next.0 > best.0 { next } else { best })?;
    Some((hardest.1, hardest.2))
}
