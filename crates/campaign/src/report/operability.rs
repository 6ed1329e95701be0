//! The report's section on operability: success by wind speed and direction, and the wind up to which runs succeed.

use fenderline_report::plot::{
    Axis, Chart, Point, Reference, Ring, Rose, Series, counted, fixed, plain,
};
use maud::{Markup, html};

use super::verdicts::Verdicts;
use super::{Campaign, words};
use crate::statistics::operability::{Bin, Edges, Limit, by_one, limit, sector};
use crate::statistics::{Confidence, binomial};
use crate::table::TableError;

/// Columns of the two inputs that are shown as a wind rose.
const SPEED: &str = "wind_speed";
const DIRECTION: &str = "wind_direction";

const SECTORS: usize = 16;
const RINGS: usize = 6;
const BINS: usize = 12;

/// Probabilities of success for which the report gives the limiting wind speed.
const REQUIRED: [f64; 2] = [0.95, 0.99];

/// The section on operability; empty if wind speed and direction are no inputs, or if the table has no verdicts.
pub(super) fn section(campaign: &Campaign<'_>, verdicts: &Verdicts) -> Result<Markup, TableError> {
    let is_input = |name: &str| campaign.inputs.iter().any(|input| input.column == name);
    let successes = match campaign.success {
        None => verdicts.successes(),
        Some(name) => {
            let values = campaign.table.numbers(name)?.values;
            Some(values.iter().map(|value| value.is_finite().then_some(*value > 0.5)).collect())
        }
    };
    let Some(successes) = successes.filter(|_| is_input(SPEED) && is_input(DIRECTION)) else {
        return Ok(html! {});
    };
    let unit = campaign.table.head(SPEED)?.unit.clone();
    let speeds = campaign.table.numbers(SPEED)?.values;
    let directions = campaign.table.numbers(DIRECTION)?.values;
    // Runs that could not be made do not count.
    let runs = speeds.iter().zip(&directions).zip(&successes);
    let runs =
        runs.filter_map(|((speed, direction), success)| Some((*speed, *direction, (*success)?)));
    let runs: Vec<(f64, f64, bool)> =
        runs.filter(|run| run.0.is_finite() && run.1.is_finite()).collect();
    let speeds: Vec<f64> = runs.iter().map(|run| run.0).collect();
    let is_success: Vec<bool> = runs.iter().map(|run| run.2).collect();
    let confidence = campaign.asked.confidence;
    let (Some(rings), Some(bins)) = (Edges::over(&speeds, RINGS), Edges::over(&speeds, BINS))
    else {
        return Ok(html! {});
    };
    let by_speed = by_one(&speeds, &is_success, &bins, confidence);
    let limits = REQUIRED.map(|required| (required, limit(&by_speed, &bins, required)));
    Ok(html! {
        h2 { "Operability" }
        @match campaign.success {
            None => p { "A run succeeds if its verdict is “all well” or a note: no limit was \
                exceeded and nothing is in doubt." },
            Some(name) => p { "A run succeeds if the output “" (name.replace('_', " ")) "” of the campaign's file is 1." },
        }
        ul class="plain" { @for (required, limit) in limits { li { (sentence(required, limit, &unit)) } } }
        (rose(&runs, &rings, &unit).render())
        (curve(&by_speed, &bins, &unit, confidence).render())
    })
}

fn sentence(required: f64, limit: Limit, unit: &str) -> String {
    let share = format!("At least {} % of the runs succeed", plain(100.0 * required, 3));
    match limit {
        Limit::At(speed) => {
            format!(
                "{share}: this holds up to a wind of {} {unit}, over all directions.",
                words::number(speed)
            )
        }
        Limit::Beyond(speed) => format!(
            "{share}: this holds up to {} {unit}, the strongest wind of the campaign; the limit lies beyond.",
            words::number(speed)
        ),
        Limit::Below(speed) => format!(
            "Not even {} % succeed in the lightest wind of the campaign, {} {unit}.",
            plain(100.0 * required, 3),
            words::number(speed)
        ),
        Limit::Unknown => "No run has a wind speed.".to_owned(),
    }
}

fn rose(runs: &[(f64, f64, bool)], edges: &Edges, unit: &str) -> Rose {
    let mut counts = vec![vec![(0_usize, 0_usize); SECTORS]; edges.count()];
    for (speed, direction, success) in runs {
        if let Some(ring) = edges.of(*speed) {
            let cell = &mut counts[ring][sector(*direction, SECTORS)];
            cell.0 += 1;
            cell.1 += usize::from(*success);
        }
    }
    let share =
        |(runs, successes): &(usize, usize)| (*runs > 0).then(|| *successes as f64 / *runs as f64);
    let ring = |(index, row): (usize, &Vec<(usize, usize)>)| Ring {
        label: format!("{} {unit}", words::number(edges.edges()[index + 1])),
        shares: row.iter().map(share).collect(),
    };
    let filled: Vec<usize> =
        counts.iter().flatten().map(|cell| cell.0).filter(|runs| *runs > 0).collect();
    let fewest = filled.iter().copied().min().unwrap_or(0);
    // With so few runs, a share cannot be distinguished from 95 %.
    let note = match fewest {
        0..=20 => {
            let interval = binomial(fewest, fewest.max(1), Confidence::USUAL).interval;
            format!(
                "Some sectors have only {}: even if all of these succeed, the true probability may \
                 be {} %.",
                counted(fewest as u64, "run", "runs"),
                fixed(100.0 * interval.low, 0)
            )
        }
        _ => format!("Each sector has {fewest} runs or more."),
    };
    Rose {
        title: "Success by the direction from which the wind comes, and by its speed".to_owned(),
        rings: counts.iter().enumerate().map(ring).collect(),
        quantity: "share of runs that succeed".to_owned(),
        note,
    }
}

/// The chart of the probability of success over wind speed, with its band.
fn curve(bins: &[Bin], edges: &Edges, unit: &str, confidence: Confidence) -> Chart {
    let known =
        bins.iter().enumerate().filter_map(|(bin, of)| Some((edges.middle(bin), of.success?)));
    let known: Vec<_> = known.collect();
    let line = |of: &dyn Fn(&crate::statistics::Estimate) -> f64| -> Vec<Point> {
        known.iter().map(|(x, estimate)| Point { x: *x, y: 100.0 * of(estimate) }).collect()
    };
    let per_cent = plain(100.0 * confidence.level(), 4);
    Chart {
        title: "Success by wind speed, over all directions".to_owned(),
        x: Axis::new("wind speed", unit),
        y: Axis::new("runs that succeed", "%").including(100.0),
        series: vec![
            Series::band(
                &format!("{per_cent} % band"),
                line(&|e| e.interval.low),
                line(&|e| e.interval.high),
            )
            .styled(0),
            Series::line("share of runs", line(&|e| e.value)).with_marks().styled(0),
        ],
        references: vec![Reference { label: "95 %".to_owned(), value: 95.0 }],
        linked: None,
        note: String::new(),
    }
}
