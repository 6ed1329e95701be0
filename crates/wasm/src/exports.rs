//! What JavaScript calls. The functions that JavaScript calls: only the package's own TypeScript calls them, and wraps
//! all of them.
//!
//! An array is handed to JavaScript as its address in the module's memory and its length. An error is thrown as the
//! JSON of a [`Problem`].

use std::collections::BTreeMap;

use fenderline_results::KeptValues;
use fenderline_scenario::schema;
use wasm_bindgen::prelude::*;

use crate::engine::HostedEngine;
use crate::exercise;
use crate::numbers::{CONTACT_FIELDS, FENDER_FIELDS, STATE_FIELDS, WRENCH_FIELDS};
use crate::problem::Problem;
use crate::run::{Run, Source, Wanted};

/// Address and length of an array in the module's memory.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub struct Span {
    /// Address of the array: bytes from the start of the module's memory.
    pub address: usize,
    /// Number of its elements.
    pub length: usize,
}

impl Span {
    fn of<T>(array: &[T]) -> Span {
        Span { address: array.as_ptr() as usize, length: array.len() }
    }
}

/// A column of a table: the kind of its values (`f64`, `u32`, `i32` for codes of words, `u8` for truth values), and
/// where they are.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub struct ColumnSpan {
    kind: &'static str,
    /// Values of the column.
    pub span: Span,
}

#[wasm_bindgen]
impl ColumnSpan {
    /// The kind of the column's values.
    #[wasm_bindgen(getter)]
    pub fn kind(&self) -> String {
        self.kind.to_owned()
    }
}

fn thrown(problem: Problem) -> JsValue {
    JsValue::from_str(&problem.json())
}

/// The scenario that a call gives; `files` is a JSON object of texts, each under the name of its file.
fn source<'a>(
    text: &'a str,
    file: &'a str,
    set: &'a [String],
    files: &str,
) -> Result<Source<'a>, Problem> {
    let files: BTreeMap<String, String> = serde_json::from_str(files)
        .map_err(|e| Problem::new("call", format_args!("`files` must be a map of texts: {e}")))?;
    Ok(Source { text, file, set, files })
}

/// The version of fenderline.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// The JSON Schema of scenario files.
#[wasm_bindgen(js_name = scenarioSchema)]
pub fn scenario_schema() -> String {
    schema().to_string()
}

/// Names of the numbers in the rows of states, wrenches, fenders and contacts, as JSON.
#[wasm_bindgen]
pub fn fields() -> String {
    serde_json::json!({
        "state": STATE_FIELDS,
        "wrench": WRENCH_FIELDS,
        "fender": FENDER_FIELDS,
        "contact": CONTACT_FIELDS,
    })
    .to_string()
}

/// Checks a scenario and returns its title and notices as JSON.
///
/// # Errors
/// The first mistake.
#[wasm_bindgen]
pub fn check(text: &str, file: &str, set: Vec<String>, files: &str) -> Result<String, JsValue> {
    let source = source(text, file, &set, files).map_err(thrown)?;
    Run::new(&source, Wanted::default()).map(|run| run.description()).map_err(thrown)
}

/// See [`crate::exercise::library`].
#[wasm_bindgen]
pub fn library() -> String {
    exercise::library()
}

/// See [`crate::exercise::berth`].
///
/// # Errors
/// The first mistake.
#[wasm_bindgen]
pub fn berth(text: &str, file: &str, files: &str) -> Result<Option<String>, JsValue> {
    let source = source(text, file, &[], files).map_err(thrown)?;
    exercise::berth(&source).map_err(thrown)
}

/// Makes a new exercise at the straight berth of the choices: see [`crate::exercise::new_exercise`].
///
/// # Errors
/// Throws the reason why the choices make no exercise.
#[wasm_bindgen(js_name = newExercise)]
pub fn new_exercise(choices: &str) -> Result<String, JsValue> {
    exercise::new_exercise(choices, None).map_err(thrown)
}

/// Makes a new exercise at the berth of a scenario: see [`crate::exercise::new_exercise`].
///
/// # Errors
/// Throws the reason why the choices make no exercise.
#[wasm_bindgen(js_name = newExerciseAt)]
pub fn new_exercise_at(
    choices: &str,
    text: &str,
    file: &str,
    files: &str,
) -> Result<String, JsValue> {
    let source = source(text, file, &[], files).map_err(thrown)?;
    exercise::new_exercise(choices, Some(&source)).map_err(thrown)
}

/// A run of a scenario for JavaScript: [`Run`].
#[wasm_bindgen]
pub struct RawRun(Run);

#[wasm_bindgen]
impl RawRun {
    /// See [`Run::new`].
    #[wasm_bindgen(constructor)]
    pub fn new(
        text: &str,
        file: &str,
        set: Vec<String>,
        files: &str,
        frames: bool,
        tables: bool,
    ) -> Result<RawRun, JsValue> {
        let source = source(text, file, &set, files).map_err(thrown)?;
        Run::new(&source, Wanted { frames, tables }).map(RawRun).map_err(thrown)
    }

    /// See [`Run::advance`].
    pub fn advance(&mut self, steps: u32) -> Result<u32, JsValue> {
        self.0.advance(steps).map_err(thrown)
    }

    /// Steps taken.
    #[wasm_bindgen(getter)]
    pub fn step(&self) -> f64 {
        self.0.simulation().steps_taken() as f64
    }

    /// Time reached (s).
    #[wasm_bindgen(getter, js_name = timeS)]
    pub fn time_s(&self) -> f64 {
        self.0.simulation().time_s()
    }

    /// Whether the run is at its end.
    #[wasm_bindgen(getter, js_name = isDone)]
    pub fn is_done(&self) -> bool {
        self.0.simulation().is_done()
    }

    /// See [`Run::states`].
    pub fn states(&self) -> Span {
        Span::of(self.0.states())
    }

    /// See [`Run::fenders`].
    pub fn fenders(&self) -> Span {
        Span::of(self.0.fenders())
    }

    /// See [`Run::description`].
    pub fn description(&self) -> String {
        self.0.description()
    }

    /// See [`Run::hello`].
    pub fn hello(&self) -> String {
        self.0.hello()
    }

    /// See [`Run::frame`].
    pub fn frame(&mut self) -> Result<String, JsValue> {
        self.0.frame().map_err(thrown)
    }

    /// See [`Run::state_hash`].
    #[wasm_bindgen(js_name = stateHash)]
    pub fn state_hash(&self) -> String {
        self.0.state_hash()
    }

    /// See [`Run::summary`].
    pub fn summary(&self) -> Result<String, JsValue> {
        self.0.summary().map_err(thrown)
    }

    /// See [`Run::verdict`].
    pub fn verdict(&self) -> String {
        self.0.verdict()
    }

    /// See [`Run::report`].
    pub fn report(&self) -> String {
        self.0.report()
    }

    /// See [`Run::tables`].
    pub fn tables(&mut self) -> Result<String, JsValue> {
        self.0.tables().map_err(thrown)
    }

    /// See [`Run::column`].
    pub fn column(&self, table: usize, column: usize) -> Result<ColumnSpan, JsValue> {
        let missing = || thrown(Problem::new("call", "the tables have no column of this number"));
        let (kind, span) = match self.0.column(table, column).ok_or_else(missing)? {
            KeptValues::Floats(values) => ("f64", Span::of(values)),
            KeptValues::Counts(values) => ("u32", Span::of(values)),
            KeptValues::Texts { codes, .. } => ("i32", Span::of(codes)),
            KeptValues::Flags(values) => ("u8", Span::of(values)),
        };
        Ok(ColumnSpan { kind, span })
    }
}

/// The contact engine: [`HostedEngine`].
#[wasm_bindgen]
pub struct RawEngine(HostedEngine);

#[wasm_bindgen]
impl RawEngine {
    /// See [`HostedEngine::from_scenario`].
    #[wasm_bindgen(js_name = fromScenario)]
    pub fn from_scenario(
        text: &str,
        file: &str,
        set: Vec<String>,
        files: &str,
        settings: &str,
    ) -> Result<RawEngine, JsValue> {
        let source = source(text, file, &set, files).map_err(thrown)?;
        HostedEngine::from_scenario(&source, settings).map(RawEngine).map_err(thrown)
    }

    /// See [`HostedEngine::from_model`].
    #[wasm_bindgen(js_name = fromModel)]
    pub fn from_model(model: &str, settings: &str) -> Result<RawEngine, JsValue> {
        HostedEngine::from_model(model, settings).map(RawEngine).map_err(thrown)
    }

    /// See [`HostedEngine::advance`].
    pub fn advance(&mut self, step_s: f64, with_loads: bool) -> Result<(), JsValue> {
        self.0.advance(step_s, with_loads).map_err(thrown)
    }

    /// See [`HostedEngine::mark_teleported`].
    #[wasm_bindgen(js_name = markTeleported)]
    pub fn mark_teleported(&mut self, body: usize) -> Result<(), JsValue> {
        self.0.mark_teleported(body).map_err(thrown)
    }

    /// See [`HostedEngine::reset`].
    pub fn reset(&mut self) {
        self.0.reset();
    }

    /// See [`HostedEngine::save`].
    pub fn save(&self) -> Vec<u8> {
        self.0.save()
    }

    /// See [`HostedEngine::restore`].
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), JsValue> {
        self.0.restore(bytes).map_err(thrown)
    }

    /// See [`HostedEngine::description`].
    pub fn description(&self) -> String {
        self.0.description()
    }

    /// See [`HostedEngine::states`].
    pub fn states(&self) -> Span {
        Span::of(self.0.states())
    }

    /// See [`HostedEngine::loads`].
    pub fn loads(&self) -> Span {
        Span::of(self.0.loads())
    }

    /// See [`HostedEngine::wrenches`].
    pub fn wrenches(&self) -> Span {
        Span::of(self.0.wrenches())
    }

    /// See [`HostedEngine::peak_wrenches`].
    #[wasm_bindgen(js_name = peakWrenches)]
    pub fn peak_wrenches(&self) -> Span {
        Span::of(self.0.peak_wrenches())
    }

    /// See [`HostedEngine::states_after`].
    #[wasm_bindgen(js_name = statesAfter)]
    pub fn states_after(&self) -> Span {
        Span::of(self.0.states_after())
    }

    /// See [`HostedEngine::contacts`].
    pub fn contacts(&self) -> Span {
        Span::of(self.0.contacts())
    }
}
