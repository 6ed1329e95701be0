//! `fenderline check` of a campaign: shows all that can be known before the first run of the campaign is made.

use core::fmt::Write as _;
use std::collections::BTreeMap;
use std::path::Path;

use fenderline_campaign::Campaign;
use fenderline_campaign::{CampaignError, Cell, Runs};
use fenderline_contact::number::{greater, lesser};
use fenderline_report::plot::{counted, plain};
use fenderline_scenario::{LoadError, printable_number};
use serde_json::{Value, json};

use super::report;
use crate::cli::CheckArgs;
use crate::failure::Failure;
use crate::mistake::{error_json, notice_json, refuse_notices, refused_json};
use crate::terminal::{notice, say, say_json};

/// Largest number of cases that the check sets up, which takes a second or two.
const SET_UP: u64 = 1000;

/// Sets up the cases of a campaign (the first 1000 if there are more) without a time step, and says what would run.
///
/// # Errors
/// Fails with the mistakes that end `fenderline campaign` before its first run. With `--strict` the check also fails if
/// there is a notice or a case that cannot start.
pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let refused = |failure: Failure, found: Value| {
        if args.json {
            say_json(&format!("{found:#}\n"))?;
        }
        Err(failure)
    };
    let other = |why: &str| json!({ "good": false, "error": { "message": why } });
    if !args.changes.overrides().map_err(Failure::input)?.is_empty() {
        let why = "changes of a scenario are given on the command line; a campaign has `set = [\"KEY=VALUE\"]` in its file";
        return refused(Failure::input(format_args!("error: {why}")), other(why));
    }
    let runs = match loaded(&args.scenario) {
        Ok(runs) => runs,
        Err(CampaignError::File(error)) => {
            let found = refused_json(&error);
            return refused(Failure::input(error), found);
        }
        Err(error) => {
            let found = other(&error.to_string());
            return refused(Failure::input(error), found);
        }
    };
    if let Err(why) = report::check_success(&runs) {
        return refused(Failure::input(format_args!("error: {why}")), other(&why));
    }
    let found = Found::of(&runs);
    if args.json {
        say_json(&format!("{:#}\n", found.json(&runs, args.strict)))?;
    } else {
        found.sentences().iter().for_each(notice);
    }
    if args.strict {
        refuse_notices(found.sentences().len())?;
    }
    say(&found.text(&runs, &args.scenario))
}

fn loaded(path: &Path) -> Result<Runs, CampaignError> {
    Runs::new(Campaign::load(path)?)
}

/// What the check found while it set up the cases.
struct Found {
    /// Number of cases that the check set up.
    tried: u64,
    /// Reasons why a case cannot start, with the cases that each reason concerns.
    refused: BTreeMap<String, Cases>,
    /// Notices of the scenario, and notices of ships that start inside another body.
    notices: BTreeMap<String, Cases>,
    /// Smallest and largest number of time steps of a case.
    steps: Option<(u64, u64)>,
    /// Smallest and largest value of each variable; `None` for a variable without numbers.
    ranges: Vec<Option<(f64, f64)>>,
}

impl Found {
    fn of(runs: &Runs) -> Found {
        let mut found = Found {
            tried: runs.count().min(SET_UP),
            refused: BTreeMap::new(),
            notices: BTreeMap::new(),
            steps: None,
            ranges: vec![None; runs.draws().heads().len()],
        };
        for run in 0..found.tried {
            found.add_values(&runs.draws().of_run(run).values);
            match runs.begun(run) {
                Ok((simulation, notices)) => {
                    for notice in notices {
                        let json = notice_json(&notice);
                        add(&mut found.notices, notice.message, run, json);
                    }
                    for finding in simulation.start_findings() {
                        let sentence = finding.sentence(simulation.setup());
                        let json = json!({ "message": sentence });
                        add(&mut found.notices, sentence, run, json);
                    }
                    let steps = simulation.steps_total();
                    let (least, most) = found.steps.unwrap_or((steps, steps));
                    found.steps = Some((least.min(steps), most.max(steps)));
                }
                Err(error) => {
                    let json = match &error {
                        CampaignError::File(error) => match &**error {
                            LoadError::Refused(error) => error_json(error),
                            LoadError::Unreadable(why) => json!({ "message": why.to_string() }),
                        },
                        error => json!({ "message": error.to_string() }),
                    };
                    add(&mut found.refused, error.to_string(), run, json);
                }
            }
        }
        found
    }

    fn add_values(&mut self, values: &[Cell]) {
        for (range, value) in self.ranges.iter_mut().zip(values.iter().map(Cell::number)) {
            let Some(value) = value else { continue };
            let (least, greatest) = range.unwrap_or((value, value));
            *range = Some((lesser(least, value), greater(greatest, value)));
        }
    }

    /// What looks like a mistake of the user, one sentence each, with the first case that shows it.
    fn sentences(&self) -> Vec<String> {
        let refused = self.refused.values().map(|cases| {
            let why = cases.what.strip_prefix("error: ").unwrap_or(&cases.what);
            format!("a case cannot start: {why}\n{}", cases.counted(self.tried))
        });
        let noticed = |cases: &Cases| format!("{}\n{}", cases.what, cases.counted(self.tried));
        refused.chain(self.notices.values().map(noticed)).collect()
    }

    fn json(&self, runs: &Runs, is_strict: bool) -> Value {
        let variables = self.variables(runs).into_iter().map(|variable| {
            let (least, greatest) = variable.range.unzip();
            json!({ "name": variable.name, "unit": variable.unit, "law": variable.law, "least": least, "greatest": greatest })
        });
        let columns =
            runs.heads().iter().map(|head| json!({ "name": head.name, "unit": head.unit }));
        let campaign = runs.campaign();
        json!({
            "good": !is_strict || self.sentences().is_empty(),
            "title": campaign.title,
            "plan": campaign.plan.word(),
            "seed": campaign.seed,
            "cases": runs.count(),
            "cases_set_up": self.tried,
            "refused": self.refused.values().map(Cases::json).collect::<Vec<_>>(),
            "notices": self.notices.values().map(Cases::json).collect::<Vec<_>>(),
            "variables": variables.collect::<Vec<_>>(),
            "columns": columns.collect::<Vec<_>>(),
            "steps": self.steps.map(|(least, most)| [least, most]),
            "step_s": runs.base().setup.step_s,
        })
    }

    fn text(&self, runs: &Runs, path: &Path) -> String {
        let campaign = runs.campaign();
        let mut text = format!(
            "{}: good; {}, {}",
            path.display(),
            report::plan(campaign),
            counted(runs.count(), "case", "cases")
        );
        if let Some((least, most)) = self.steps {
            let steps = if least == most { most.to_string() } else { format!("{least} to {most}") };
            let step = printable_number(runs.base().setup.step_s);
            let _ = write!(text, " of {steps} time steps of {step} s");
        }
        text.push('\n');
        if self.tried < runs.count() {
            let _ = writeln!(text, "the first {} cases were set up", self.tried);
        }
        for variable in self.variables(runs) {
            let _ = write!(text, "  {}", variable.name);
            if let Some((least, greatest)) = variable.range {
                let (least, greatest) = (plain(least, 4), plain(greatest, 4));
                let unit = if variable.unit.is_empty() { "" } else { " " };
                let _ = write!(text, ": {least} to {greatest}{unit}{}", variable.unit);
            }
            let _ = writeln!(text, "; {}", variable.law);
        }
        let _ = writeln!(
            text,
            "the table gets {}; `--json` names them",
            counted(runs.heads().len() as u64 + 1, "column", "columns")
        );
        text
    }

    /// The campaign's variables, each with its law and the range of the values that were drawn.
    fn variables(&self, runs: &Runs) -> Vec<Variable> {
        let each = runs.draws().heads().iter().zip(&self.ranges);
        let law = |name: &str| {
            let own = runs.campaign().variables.iter().find(|variable| variable.name == name);
            own.map_or(String::new(), |own| report::input(own).distribution)
        };
        let one = |(head, range): (&fenderline_campaign::Head, &Option<(f64, f64)>)| Variable {
            name: head.name.clone(),
            unit: head.unit.clone(),
            law: law(&head.name),
            range: *range,
        };
        each.map(one).collect()
    }
}

struct Variable {
    name: String,
    unit: String,
    law: String,
    range: Option<(f64, f64)>,
}

/// Cases in which the check found the same message; messages that differ only in their numbers count as the same.
struct Cases {
    /// Index of the first case with this message, counted from 0.
    first: u64,
    count: u64,
    /// The message of the first case, as text and as JSON.
    what: String,
    json: Value,
}

impl Cases {
    fn json(&self) -> Value {
        let mut json = self.json.clone();
        json["first_case"] = json!(self.first + 1);
        json["cases"] = json!(self.count);
        json
    }

    fn counted(&self, tried: u64) -> String {
        let cases = counted(self.count, "case", "cases");
        format!("in {cases} of {tried}, first in case {}", self.first + 1)
    }
}

/// Counts a case under the message that the check found in it.
fn add(found: &mut BTreeMap<String, Cases>, what: String, run: u64, json: Value) {
    let is_of_a_number = |c: &char| c.is_ascii_digit() || ['.', '-'].contains(c);
    let kind = what.chars().filter(|c| !is_of_a_number(c)).collect();
    found.entry(kind).or_insert(Cases { first: run, count: 0, what, json }).count += 1;
}
