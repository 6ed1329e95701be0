//! `fenderline limit`: the largest value of a key with which a run stays within all limits, by bisection.

use fenderline_scenario::{Override, printable_line};
use fenderline_sim::{Gravity, Simulation, Verdict};
use serde_json::json;

use crate::cli::LimitArgs;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::load::Source;
use crate::terminal::{answer, say_json};

/// Largest number of runs of a search: after fifty halvings nothing of the range is left.
const MOST_RUNS: usize = 52;

/// A run of the search, with one value of the key.
struct Trial {
    value: f64,
    verdict: Verdict,
    /// The worst finding of the run, in a sentence.
    reason: String,
}

impl Trial {
    fn is_within(&self) -> bool {
        self.verdict.gravity() < Gravity::Attention
    }
}

/// A number with its unit, as the user gives it.
struct Amount {
    number: f64,
    unit: String,
}

impl Amount {
    /// # Errors
    /// Fails if the text does not begin with a number.
    fn parse(option: &str, text: &str) -> Result<Amount, Failure> {
        let is_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E');
        let text = text.trim();
        let end = text.find(|c| !is_number(c)).unwrap_or(text.len());
        let number = text[..end].parse::<f64>().ok().filter(|number| number.is_finite());
        let number = number.ok_or_else(|| {
            let shown = printable_line(text);
            Failure::input(format_args!(
                "error: {option} {shown}: not a number with a unit, such as \"8 kn\""
            ))
        })?;
        Ok(Amount { number, unit: text[end..].trim().to_owned() })
    }
}

/// Runs the scenario with values of a key between `--from` and `--to`. Prints all runs, and the largest value whose run
/// stays within all limits.
///
/// A run is within its limits if no finding is graver than a note: no `[limit.NAME]` is exceeded, no fender is over its
/// rating, no line is over its working load. The search supposes that larger values are worse.
///
/// # Errors
/// Fails if the input is bad, if a run diverges, or if no value of the range keeps the run within the limits.
pub(crate) fn limit(args: &LimitArgs) -> Result<(), Failure> {
    let (low, high) = (Amount::parse("--from", &args.from)?, Amount::parse("--to", &args.to)?);
    if low.unit != high.unit {
        return Err(Failure::input("error: --from and --to need the same unit"));
    }
    if low.number >= high.number {
        return Err(Failure::input("error: --from is not below --to"));
    }
    let within = args.within.unwrap_or((high.number - low.number) / 100.0);
    if within.is_nan() || within <= 0.0 {
        return Err(Failure::input("error: --within needs a number above 0"));
    }
    let source = Source::read(&args.scenario).map_err(Failure::input)?;
    let interrupt = Interrupt::listen();
    let mut trials: Vec<Trial> = Vec::new();
    let is_within = |number: f64, trials: &mut Vec<Trial>| -> Result<bool, Failure> {
        let trial = run(args, &source, &interrupt, (number, &low.unit))?;
        let is_within = trial.is_within();
        trials.push(trial);
        Ok(is_within)
    };
    let found = if !is_within(low.number, &mut trials)? {
        None
    } else if is_within(high.number, &mut trials)? {
        Some(high.number)
    } else {
        let (mut good, mut bad) = (low.number, high.number);
        while bad - good > within && trials.len() < MOST_RUNS {
            let middle = 0.5 * (good + bad);
            if is_within(middle, &mut trials)? { good = middle } else { bad = middle }
        }
        Some(good)
    };
    let is_at_end = found == Some(high.number);
    if args.json {
        say_json(&format!(
            "{:#}\n",
            as_json(args, &trials, (found, is_at_end), &low.unit, within)
        ))?;
    } else {
        answer(&printed(args, &trials, (found, is_at_end), &low.unit))?;
    }
    match found {
        Some(_) => Ok(()),
        None => Err(Failure::case(format_args!(
            "error: {} {} is beyond the limits already",
            args.key, args.from
        ))),
    }
}

fn run(
    args: &LimitArgs,
    source: &Source,
    interrupt: &Interrupt,
    (number, unit): (f64, &str),
) -> Result<Trial, Failure> {
    let value = if unit.is_empty() { format!("{number}") } else { format!("{number} {unit}") };
    let mut overrides = args.changes.overrides().map_err(Failure::input)?;
    let option = format!("--key {} at {value}", args.key);
    overrides.push(Override::new(&option, &args.key, &value).map_err(Failure::input)?);
    let scenario = source.scenario(&overrides).map_err(Failure::input)?;
    let mut simulation = Simulation::new(scenario.setup)
        .map_err(|error| Failure::input(format_args!("error: {error}")))?;
    while !simulation.is_done() {
        if interrupt.is_asked() {
            return Err(Failure::Interrupted);
        }
        simulation
            .step()
            .map_err(|error| Failure::case(format_args!("error: {option}: {error}")))?;
    }
    let findings = simulation.findings();
    let reason = findings.first().map(|finding| finding.sentence(simulation.setup()));
    Ok(Trial {
        value: number,
        verdict: Verdict::of(&findings),
        reason: reason.unwrap_or_else(|| "nothing found".to_owned()),
    })
}

fn printed(
    args: &LimitArgs,
    trials: &[Trial],
    (found, is_at_end): (Option<f64>, bool),
    unit: &str,
) -> String {
    let mut sorted: Vec<&Trial> = trials.iter().collect();
    sorted.sort_by(|one, other| one.value.total_cmp(&other.value));
    let mut text = format!("{:>12}  {:<6}  finding\n", args.key, "within");
    for trial in sorted {
        let value = format!("{} {unit}", trimmed(trial.value));
        let word = if trial.is_within() { "yes" } else { "NO" };
        text += &format!(
            "{:>width$}  {word:<6}  {}\n",
            value.trim(),
            trial.reason,
            width = args.key.len().max(12)
        );
    }
    match found {
        Some(value) if is_at_end => {
            text += &format!(
                "\nWithin all limits up to {} {unit}, the end of the range.\n",
                trimmed(value)
            );
        }
        Some(value) => {
            text +=
                &format!("\nLargest {} within all limits: {} {unit}\n", args.key, trimmed(value));
        }
        None => {}
    }
    text
}

/// At most four decimals.
fn trimmed(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn as_json(
    args: &LimitArgs,
    trials: &[Trial],
    (found, is_at_end): (Option<f64>, bool),
    unit: &str,
    within: f64,
) -> serde_json::Value {
    let trials = trials.iter().map(|trial| {
        json!({
            "value": trial.value,
            "within": trial.is_within(),
            "verdict": trial.verdict.key(),
            "reason": trial.reason,
        })
    });
    json!({
        "key": args.key,
        "unit": unit,
        "limit": found,
        "is_end_of_range": is_at_end,
        "accuracy": within,
        "runs": trials.collect::<Vec<_>>(),
    })
}
