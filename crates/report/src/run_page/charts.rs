//! Time series of the report.

use fenderline_contact::number::greater;

use maud::{Markup, html};

use super::recorder::Recorder;
use super::recorder::{BodyTrace, PairTrace};
use crate::plot::{Axis, Chart, Decimator, Point, Reference, Scaled, Series};
use fenderline_results::Outcome;

/// Name of the group of charts that share the read-out under the pointer.
const LINK: &str = "time";
/// Largest number of bodies in a chart.
const DRAWN_BODIES: usize = 6;

/// All charts of a run; those of contacts show the pairs of bodies in `drawn`.
pub(super) fn all(outcome: &Outcome<'_>, recorder: &Recorder, drawn: &[&PairTrace]) -> Markup {
    let page = Charts::new(outcome);
    html! {
        @match drawn {
            [] => {}
            [pair] => { (page.forces_of_one(pair)) }
            pairs => {
                (page.forces("Normal force", pairs, |p| &p.normal_n))
                (page.forces("Tangential force", pairs, |p| &p.tangential_n))
            }
        }
        @if !drawn.is_empty() {
            (page.depth(drawn))
            (page.relative_speed(drawn))
        }
        (page.body_speeds(recorder))
    }
}

/// The data that all charts over time have in common.
pub(super) struct Charts<'a> {
    pub(super) outcome: &'a Outcome<'a>,
    end_s: f64,
    /// Unit of the time axis, and the length of this unit in seconds.
    unit: (&'static str, f64),
}

impl<'a> Charts<'a> {
    pub(super) fn new(outcome: &'a Outcome<'a>) -> Charts<'a> {
        let end_s = outcome.steps as f64 * outcome.setup.step_s;
        let unit = match end_s {
            end_s if end_s > 2.0 * 3600.0 => ("h", 3600.0),
            end_s if end_s > 1000.0 => ("min", 60.0),
            _ => ("s", 1.0),
        };
        Charts { outcome, end_s, unit }
    }

    /// Unit of the time axis, and the length of this unit in seconds.
    pub(super) fn unit(&self) -> (&'static str, f64) {
        self.unit
    }

    /// The end of the run (s).
    pub(super) fn end_s(&self) -> f64 {
        self.end_s
    }

    /// The time axis, which covers the whole run.
    pub(super) fn time_axis(&self) -> Axis {
        let (unit, unit_s) = self.unit;
        Axis::new("time", unit).including(0.0).including(self.end_s / unit_s).tight()
    }

    /// Makes a chart over the whole time of the run, from series whose times are in seconds.
    pub(super) fn chart(&self, title: &str, y: Axis, series: Vec<Series>) -> Chart {
        let (_, unit_s) = self.unit;
        let in_unit = |p: &Point| Point { x: p.x / unit_s, y: p.y };
        Chart {
            title: title.to_owned(),
            x: self.time_axis(),
            y,
            series: series.into_iter().map(|line| line.mapped(in_unit)).collect(),
            references: Vec::new(),
            linked: Some(LINK),
            note: String::new(),
        }
    }

    fn pair_name(&self, pair: &PairTrace) -> String {
        let [a, b] = pair.bodies.map(|i| self.outcome.setup.bodies[i].name.as_str());
        format!("{a} – {b}")
    }

    fn pair_series(&self, pairs: &[&PairTrace], of: fn(&PairTrace) -> &Decimator) -> Vec<Series> {
        pairs.iter().map(|pair| Series::line(&self.pair_name(pair), of(pair).points())).collect()
    }

    /// The chart of normal and tangential force if only one pair touched, with the peak marked.
    fn forces_of_one(&self, pair: &PairTrace) -> Markup {
        let peak = Point { x: pair.peak.t_s, y: pair.peak.normal_n };
        let series = vec![
            Series::line("normal force N", pair.normal_n.points()),
            Series::line("tangential force T", pair.tangential_n.points()),
            Series::marks("peak", vec![peak]).styled(0),
        ];
        let (unit, series) = scaled(series, "N");
        let title = format!("Contact force, {}", self.pair_name(pair));
        self.chart(&title, Axis::new("force", &unit).including(0.0), series).render()
    }

    fn forces(
        &self,
        title: &str,
        pairs: &[&PairTrace],
        of: fn(&PairTrace) -> &Decimator,
    ) -> Markup {
        let (unit, series) = scaled(self.pair_series(pairs, of), "N");
        self.chart(title, Axis::new("force", &unit).including(0.0), series).render()
    }

    fn depth(&self, pairs: &[&PairTrace]) -> Markup {
        let series = self.pair_series(pairs, |p| &p.depth_m);
        let summaries = self.outcome.pairs.iter();
        let of_fender = summaries.filter(|of| of.peak_depth_fender.is_some()).count();
        let (title, axis) = match of_fender {
            0 => ("Penetration", "depth"),
            all if all == self.outcome.pairs.len() => {
                ("Largest deflection of a fender", "deflection")
            }
            _ => ("Penetration, or largest deflection of a fender", "depth or deflection"),
        };
        self.chart(title, Axis::new(axis, "m").including(0.0), series).render()
    }

    fn relative_speed(&self, pairs: &[&PairTrace]) -> Markup {
        let series = self.pair_series(pairs, |p| &p.v_normal_mps);
        let axis = Axis::new("speed", "m/s").including(0.0);
        let mut chart = self.chart("Relative normal speed (positive closing)", axis, series);
        chart.references.extend(match pairs {
            [pair] => self.rebound(pair),
            _ => None,
        });
        chart.note = "After the contact, the speed is measured along the last normal, at the last \
            point of contact."
            .to_owned();
        chart.render()
    }

    /// The line of the rebound speed −γV⁰ after the first touch, at which the impulse-momentum limiter aims.
    fn rebound(&self, pair: &PairTrace) -> Option<Reference> {
        let summary = self.outcome.pairs.iter().find(|p| p.bodies == pair.bodies)?;
        let restitution = self.restitution_of(pair.bodies)?;
        let value = -restitution * greater(summary.approach_speed_mps, 0.0);
        Some(Reference { label: "−γV⁰".to_owned(), value })
    }

    /// The coefficient of restitution γ of two outlines; `None` if the bodies touched through fenders, which have
    /// separate materials.
    fn restitution_of(&self, bodies: [usize; 2]) -> Option<f64> {
        let setup = self.outcome.setup;
        if self.outcome.fenders.iter().any(|f| bodies.contains(&setup.fenders[f.fender].body)) {
            return None;
        }
        let [a, b] = bodies;
        let named = setup.pairs.iter().find(|p| p.bodies == [a, b] || p.bodies == [b, a]);
        let material = named.map(|p| p.material).or(setup.all_other_pairs)?;
        Some(setup.materials[material].material.restitution)
    }

    fn body_speeds(&self, recorder: &Recorder) -> Markup {
        let mut traces: Vec<(f64, &BodyTrace, Series)> = recorder
            .bodies
            .iter()
            .map(|trace| {
                let name = &self.outcome.setup.bodies[trace.body].name;
                let series = Series::line(name, trace.speed_mps.points());
                (series.largest(), trace, series)
            })
            .collect();
        // The fastest, in the order of the scenario.
        traces.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.body.cmp(&b.1.body)));
        traces.truncate(DRAWN_BODIES);
        traces.sort_by_key(|(_, trace, _)| trace.body);
        if traces.is_empty() {
            return html! {};
        }
        let floating = self.outcome.setup.bodies.iter().filter(|b| b.mass.is_some()).count();
        let drawn = traces.len();
        let series = traces.into_iter().map(|(_, _, series)| series).collect();
        let axis = Axis::new("speed", "m/s").including(0.0);
        let mut chart = self.chart("Speed of the bodies over ground", axis, series);
        if floating > drawn {
            let followed = recorder.bodies.len();
            chart.note = if floating > followed {
                format!(
                    "The chart shows the {drawn} fastest of the first {followed} floating bodies in the \
                     scenario, which has {floating}."
                )
            } else {
                format!("The chart shows the {drawn} fastest of {floating} floating bodies.")
            };
        }
        chart.render()
    }
}

/// Converts the series to the unit whose prefix suits their largest value, and returns that unit and the series.
pub(super) fn scaled(series: Vec<Series>, base: &str) -> (String, Vec<Series>) {
    let scaled = Scaled::for_largest(series.iter().map(Series::largest).fold(0.0, greater));
    let series = series.into_iter().map(|s| s.scaled(scaled.factor)).collect();
    (scaled.unit(base), series)
}
