//! Takes a scenario from its text to summary and report.

use std::collections::BTreeMap;

use fenderline_live::Watched;
use fenderline_report::run_page::{self, Recorder, WindTrace};
use fenderline_results::{
    EstimateError, Events, InMemory, Interrupted, KeptTable, KeptValues, Outcome, ProviderNotices,
    Tables, WorldTotals, summary,
};
use fenderline_scenario::{Notice, Override, Place, Scenario};
use fenderline_sim::{FenderSummary, OutputPlan, Setup, Simulation};
use fenderline_validate::errors_of;
use serde_json::{Value, json};

use crate::numbers::{Rows, of_fender, of_state};
use crate::problem::{Problem, check_size};

/// A scenario as JavaScript gives it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Source<'a> {
    /// The scenario.
    pub text: &'a str,
    /// Name of the scenario's file, for messages and the default title.
    pub file: &'a str,
    /// Keys of the scenario that are replaced, as `KEY=VALUE`.
    pub set: &'a [String],
    /// Texts of the files that the scenario names, by those names.
    pub files: BTreeMap<String, String>,
}

impl Source<'_> {
    /// The text of a file that the scenario names.
    ///
    /// # Errors
    /// It was not given.
    pub fn read(&self, name: &str) -> Result<String, String> {
        let text = self.files.get(name).cloned();
        text.ok_or_else(|| format!("{name}: the text of this file was not given with the scenario"))
    }
}

/// What a run is to give beside its summary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Whether the run gives frames for pages, with alarms and events.
    pub frames: bool,
    /// Result tables.
    pub tables: bool,
}

/// A run.
pub struct Run {
    title: String,
    file: String,
    report: Vec<(&'static str, String)>,
    notices: Vec<String>,
    places: Vec<Value>,
    wanted: Wanted,
    watched: Watched,
    recorder: Recorder,
    events: Events,
    world: WorldTotals,
    tables: Option<Tables<InMemory>>,
    kept: Vec<KeptTable>,
    states: Rows,
    fenders: Rows,
}

/// Reads and checks a scenario.
///
/// # Errors
/// Fails with the first mistake of the scenario, or for a text that is too large.
pub fn parse(source: &Source<'_>) -> Result<Scenario, Problem> {
    check_size(source.file, source.text)?;
    let set: Result<Vec<Override>, _> =
        source.set.iter().map(|text| Override::parse(text)).collect();
    let mut read = |name: &str| source.read(name);
    Ok(Scenario::parse_among(source.text, source.file, &set?, &mut read)?)
}

impl Run {
    /// Makes a run before its first step.
    ///
    /// # Errors
    /// Fails for a mistake in the scenario, for a scenario that needs another program to compute forces, and for a
    /// set-up that cannot be simulated.
    pub fn new(source: &Source<'_>, wanted: Wanted) -> Result<Run, Problem> {
        let Scenario { title, report, setup, exercise, output, notices, .. } = parse(source)?;
        if !setup.world.providers.is_empty() {
            return Err(Problem::new(
                "setup",
                "the scenario has a [[provider]], a program that computes forces, which only the program \
                 `fenderline` can start",
            ));
        }
        let simulation = Simulation::new(setup).map_err(|e| Problem::new("setup", e))?;
        let file = file_name(source.file);
        let mut recorder = Recorder::new(simulation.setup(), simulation.energy());
        recorder.wind = Some(WindTrace::of(&simulation));
        let tables = wanted.tables.then(|| tables(&simulation, &output)).transpose()?;
        let mut run = Run {
            report,
            notices: notices.iter().map(recorded).collect(),
            places: notices.iter().map(notice_json).collect(),
            wanted,
            recorder,
            events: Events::default(),
            world: WorldTotals::new(simulation.setup()),
            tables,
            kept: vec![],
            watched: Watched::new(simulation, exercise, title.clone(), file.clone()),
            title,
            file,
            states: Rows::default(),
            fenders: Rows::default(),
        };
        run.show();
        Ok(run)
    }

    /// Takes up to `steps` steps of the run, and fewer at its end. Returns how many.
    ///
    /// # Errors
    /// Fails for a step that the simulation cannot make; the run then stays at the step before. Fails too for a number
    /// that is not finite.
    pub fn advance(&mut self, steps: u32) -> Result<u32, Problem> {
        let mut taken = 0;
        let mut result = Ok(());
        while taken < steps && !self.simulation().is_done() {
            result = self.step();
            if result.is_err() {
                break;
            }
            taken += 1;
        }
        self.show();
        result.map(|()| taken)
    }

    fn step(&mut self) -> Result<(), Problem> {
        let Run { watched, recorder, events, world, tables, .. } = self;
        let mut written = Ok(());
        let stepped = watched.step(|record| {
            recorder.record(record);
            events.count(record);
            world.add(record);
            if let Some(tables) = tables {
                written = tables.write(record);
            }
        });
        stepped.map_err(|e| Problem::new("step", e))?;
        written.map_err(|e| Problem::new("step", e))?;
        if let Some(wind) = &mut self.recorder.wind {
            wind.note(self.watched.simulation());
        }
        if self.wanted.frames {
            self.watched.note();
        }
        Ok(())
    }

    /// Fills the arrays of states and fenders anew.
    fn show(&mut self) {
        let simulation = self.watched.simulation();
        self.states.set(simulation.states().iter().map(of_state));
        self.fenders.set(self.watched.fenders().iter().map(of_fender));
    }

    /// The simulation of the run in its present state.
    #[must_use]
    pub fn simulation(&self) -> &Simulation {
        self.watched.simulation()
    }

    /// The states of the bodies as numbers: [`crate::numbers::STATE_FIELDS`] of each body.
    #[must_use]
    pub fn states(&self) -> &[f64] {
        self.states.numbers()
    }

    /// The fenders as numbers: [`crate::numbers::FENDER_FIELDS`] of each fender.
    #[must_use]
    pub fn fenders(&self) -> &[f64] {
        self.fenders.numbers()
    }

    /// Title, names, times and notices of the run, as JSON.
    #[must_use]
    pub fn description(&self) -> String {
        let setup = self.simulation().setup();
        let bodies: Vec<&str> = setup.bodies.iter().map(|body| &*body.name).collect();
        let fenders: Vec<&str> = setup.fenders.iter().map(|fender| &*fender.name).collect();
        let starts = self.simulation().start_findings().iter();
        let start: Vec<String> = starts.map(|finding| finding.sentence(setup)).collect();
        json!({
            "title": self.title,
            "step_s": setup.step_s,
            "duration_s": setup.duration_s,
            "steps": self.simulation().steps_total(),
            "bodies": bodies,
            "fenders": fenders,
            "notices": self.places,
            "start": start,
        })
        .to_string()
    }

    /// The message `hello`, from which a live page is built.
    #[must_use]
    pub fn hello(&self) -> String {
        self.watched.hello()
    }

    /// The present state as the JSON of a frame for live pages, with the events since the last frame.
    ///
    /// # Errors
    /// Fails if the run was made without frames.
    pub fn frame(&mut self) -> Result<String, Problem> {
        if !self.wanted.frames {
            return Err(Problem::new("call", "frames need a run with the option `frames`"));
        }
        Ok(self.watched.frame())
    }

    /// Fingerprint of the run's state, in hexadecimal.
    #[must_use]
    pub fn state_hash(&self) -> String {
        self.watched.bits()
    }

    /// The text of `summary.json` for the run, with no list of files.
    ///
    /// # Errors
    /// Fails for a number that is not finite.
    pub fn summary(&self) -> Result<String, Problem> {
        self.at_end(|outcome, _| summary(outcome, &[])).map_err(|e| Problem::new("step", e))
    }

    /// The text of `report.html`.
    #[must_use]
    pub fn report(&self) -> String {
        self.at_end(run_page::render)
    }

    /// The verdict on the run with its findings, the worst first, as JSON.
    #[must_use]
    pub fn verdict(&self) -> String {
        self.watched.verdict()
    }

    /// Ends the result tables and returns the names of tables and columns, as JSON. Steps that are taken later are not
    /// in the tables.
    ///
    /// # Errors
    /// Fails if the run was made without tables, or if a number is not finite.
    pub fn tables(&mut self) -> Result<String, Problem> {
        if !self.wanted.tables {
            return Err(Problem::new("call", "tables need a run with the option `tables`"));
        }
        if let Some(tables) = self.tables.take() {
            self.kept = tables.finish().map_err(|e| Problem::new("step", e))?;
        }
        let tables = self.kept.iter().map(table_json).collect();
        Ok(Value::Array(tables).to_string())
    }

    /// A column of a result table: numbers, or codes of words.
    #[must_use]
    pub fn column(&self, table: usize, column: usize) -> Option<&KeptValues> {
        Some(&self.kept.get(table)?.columns.get(column)?.values)
    }

    /// Calls `make` with the run's outcome up to now.
    fn at_end<T>(&self, make: impl FnOnce(&Outcome<'_>, &Recorder) -> T) -> T {
        let simulation = self.simulation();
        let setup = simulation.setup();
        let findings = simulation.findings();
        let fenders: Vec<FenderSummary> = simulation.fender_summaries().cloned().collect();
        let mut notices = self.notices.clone();
        notices.extend(simulation.energy_gain().map(|gain| gain.to_string()));
        let outcome = Outcome {
            title: &self.title,
            report: &self.report,
            scenario_file: &self.file,
            session: None,
            exercise: self.watched.exercise(),
            setup,
            notices: &notices,
            interrupted: (!simulation.is_done()).then(|| Interrupted::of(simulation)),
            steps: simulation.steps_taken(),
            states: simulation.states(),
            pairs: simulation.pair_summaries(),
            energy: simulation.energy(),
            events: &self.events,
            findings: &findings,
            fenders: &fenders,
            dolphins: simulation.dolphin_summaries(),
            berthing: simulation.berthing(),
            statistics: simulation.statistics(),
            limit_values: &simulation.limit_values(),
            world: &self.world,
            providers: &ProviderNotices::default(),
            estimate_errors: estimate_errors(setup),
        };
        make(&outcome, &self.recorder)
    }
}

fn tables(simulation: &Simulation, plan: &OutputPlan) -> Result<Tables<InMemory>, Problem> {
    Tables::start(&InMemory, simulation.setup(), simulation.energy(), plan)
        .map_err(|e| Problem::new("step", e))
}

/// The errors of the formulas by which vessels were estimated; empty if no vessel is estimated.
fn estimate_errors(setup: &Setup) -> &'static [EstimateError] {
    let mut all = setup.world.vessels.iter().map(|vessel| errors_of(&vessel.origin));
    all.find(|errors| !errors.is_empty()).unwrap_or(&[])
}

/// The name of a file without its folders.
fn file_name(path: &str) -> String {
    path.rsplit(['/', '\\']).next().unwrap_or(path).to_owned()
}

/// A notice about the scenario for the results: without the file's path, as the program writes it.
fn recorded(notice: &Notice) -> String {
    let Notice { place, key, message } = notice;
    match place {
        Place::File { line, .. } => format!("line {line}, {key}: {message}"),
        Place::WholeFile { .. } => format!("{key}: {message}"),
        Place::Option { text } => format!("{text}, {key}: {message}"),
    }
}

/// A notice about the scenario with its place, as JSON.
#[must_use]
pub fn notice_json(notice: &Notice) -> Value {
    let Notice { place, key, message } = notice;
    let (line, column) = match place {
        Place::File { line, column, .. } => (Some(line), Some(column)),
        Place::WholeFile { .. } | Place::Option { .. } => (None, None),
    };
    json!({ "key": key, "message": message, "line": line, "column": column, "text": notice.to_string() })
}

fn table_json(table: &KeptTable) -> Value {
    let columns: Vec<Value> = table
        .columns
        .iter()
        .map(|column| {
            let words = match &column.values {
                KeptValues::Texts { words, .. } => Some(words),
                _ => None,
            };
            json!({ "name": column.name, "unit": column.unit, "meaning": column.meaning, "words": words })
        })
        .collect();
    json!({ "name": table.name, "rows": table.rows(), "columns": columns })
}

#[cfg(test)]
mod tests {
    use fenderline_scenario::VesselLibrary;

    use super::*;

    /// What the page without a server shows of a run: the frame, the verdict, summary and report.
    #[test]
    fn each_vessel_of_the_library_runs_by_herself_on_the_page() {
        for vessel in VesselLibrary::built_in().vessels() {
            let name = &vessel.name;
            let outline = match vessel.outline_m {
                Some(_) => "",
                None => "outline = [[-50, -8], [50, -8], [50, 8], [-50, 8]]",
            };
            let text = format!(
                "[time]\nstep = \"0.5 s\"\nduration = \"2 s\"\n[body.ship]\nvessel = \"{name}\"\nposition = [0, 0]\n{outline}\n"
            );
            let source = Source { text: &text, file: "bare.toml", ..Source::default() };
            let mut run = Run::new(&source, Wanted { frames: true, tables: true }).expect(name);
            assert_eq!(run.advance(4), Ok(4), "{name}");
            let summary = run.summary().expect(name);
            assert!(summary.contains("\"verdict\""), "{name}");
            assert!(run.frame().expect(name).contains("\"verdict\""), "{name}");
            assert!(run.report().contains("</html>") && run.tables().is_ok(), "{name}");
        }
    }
}
