//! Variants of a scenario: they have the same bodies, fenders and controls, but other numbers in some keys.

use std::borrow::Cow;
use std::sync::Arc;

use fenderline_scenario::{self as scenario, Override, ScenarioError};
use fenderline_sim::{Setup, Start};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::controls::{Control, controls};
use crate::errors;
use crate::run::{CannotRun, Run};
use crate::scenario::{Scenario, Source, number_text, option, replacements, value_text};
use crate::simulation::cannot_run;

/// A scenario, and the controls that its variants share.
pub(crate) struct Common {
    source: Arc<Source>,
    pub(crate) base: Arc<scenario::Scenario>,
    pub(crate) controls: Arc<Vec<Control>>,
}

/// Why a variant of the scenario cannot be run.
pub(crate) enum NoRun {
    Scenario(ScenarioError),
    Cannot(CannotRun),
    /// The bodies, fenders or controls of the variant differ from the scenario's; the text says which.
    Other(&'static str),
}

impl Common {
    pub(crate) fn of(scenario: &Scenario) -> Common {
        let base = Arc::clone(&scenario.checked);
        let controls = Arc::new(controls(&base.setup));
        Common { source: Arc::clone(&scenario.source), base, controls }
    }

    /// What a run of the variant with the overrides `set` begins with. If only the variant's start differs from the
    /// scenario's, no simulation is made.
    pub(crate) fn variant(&self, set: &[Override]) -> Result<Variant, NoRun> {
        let setup = &self.base.setup;
        if setup.world.providers.is_empty() && setup.restarts_in_place() {
            let mut start = setup.start();
            if self.base.start_with(set, &mut start) {
                return Ok(Variant::Start(Box::new(start)));
            }
        }
        self.run(set).map(|run| Variant::Run(Box::new(run)))
    }

    /// Makes a run of the variant with the overrides `set` anew.
    pub(crate) fn run(&self, set: &[Override]) -> Result<Run, NoRun> {
        let varied;
        let scenario = match set {
            [] => &*self.base,
            _ => {
                varied = self.source.check(set).map_err(NoRun::Scenario)?;
                &varied
            }
        };
        let (own, other) = (&self.base.setup, &scenario.setup);
        let bodies =
            |setup: &Setup| setup.bodies.iter().map(|b| b.name.clone()).collect::<Vec<_>>();
        let fenders =
            |setup: &Setup| setup.fenders.iter().map(|f| f.name.clone()).collect::<Vec<_>>();
        if bodies(own) != bodies(other) {
            return Err(NoRun::Other("bodies"));
        }
        if fenders(own) != fenders(other) {
            return Err(NoRun::Other("fenders"));
        }
        if *self.controls != controls(other) {
            return Err(NoRun::Other("controls"));
        }
        let mut run = Run::new(scenario, Arc::clone(&self.controls)).map_err(NoRun::Cannot)?;
        run.is_of_scenario = set.is_empty();
        Ok(run)
    }
}

/// What a run of a variant begins with.
pub(crate) enum Variant {
    /// The start of the variant, which differs from the scenario in nothing else.
    Start(Box<Start>),
    /// A run that was made for the variant alone.
    Run(Box<Run>),
}

impl Variant {
    /// Begins a new run.
    pub(crate) fn begin(self, common: &Common) -> Result<Run, NoRun> {
        match self {
            Variant::Run(own) => Ok(*own),
            Variant::Start(start) => {
                let mut run = common.run(&[])?;
                run.restart(&start);
                Ok(run)
            }
        }
    }

    /// Begins the variant in the memory of another run of the scenario's variants. The results are the same as those of
    /// a new run.
    pub(crate) fn begin_in(self, common: &Common, run: &mut Run) -> Result<(), NoRun> {
        match self {
            Variant::Start(start) if run.is_of_scenario => run.restart(&start),
            other => *run = other.begin(common)?,
        }
        Ok(())
    }
}

/// Reads the overrides of each variant.
pub(crate) fn read(variants: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<Override>>> {
    let read = |set| -> PyResult<Vec<Override>> {
        let replaced = replacements(variants.py(), &set)?;
        Ok(replaced.into_iter().map(|one| one.read).collect())
    };
    let each = variants.try_iter()?.enumerate();
    each.map(|(number, set)| read(set?).map_err(|error| numbered(variants.py(), number, error)))
        .collect()
}

/// The overrides of many variants. Overrides that are given as columns are made where they are needed: by the threads
/// that run the variants.
pub(crate) enum Sets {
    Each(Vec<Vec<Override>>),
    Columns { keys: Vec<(String, Column)>, rows: usize },
}

/// The values of an overridden key, one value for each variant.
pub(crate) enum Column {
    Numbers(Vec<f64>),
    /// Values of any kind, as texts for the scenario reader.
    Texts(Vec<String>),
}

impl Sets {
    /// Reads a sequence of dictionaries, or a dictionary of columns of the same length.
    pub(crate) fn read(variants: &Bound<'_, PyAny>) -> PyResult<Sets> {
        let Ok(columns) = variants.cast::<PyDict>() else { return read(variants).map(Sets::Each) };
        let keys = columns.iter().map(|(key, values)| Ok((key.extract()?, Column::read(&values)?)));
        let keys: Vec<(String, Column)> = keys.collect::<PyResult<_>>()?;
        let rows = keys.first().map_or(0, |(_, column)| column.len());
        if keys.iter().any(|(_, column)| column.len() != rows) {
            return Err(errors::bad_argument("each key needs one value per run"));
        }
        Ok(Sets::Columns { keys, rows })
    }

    pub(crate) fn len(&self) -> usize {
        match self {
            Sets::Each(sets) => sets.len(),
            Sets::Columns { rows, .. } => *rows,
        }
    }

    /// The overrides of a variant.
    pub(crate) fn get(&self, index: usize) -> Result<Cow<'_, [Override]>, ScenarioError> {
        match self {
            Sets::Each(sets) => Ok(Cow::Borrowed(&sets[index])),
            Sets::Columns { keys, .. } => {
                let set = |(key, column): &(String, Column)| {
                    let value = column.text(index);
                    Override::new(&option(key, &value), key, &value)
                };
                keys.iter().map(set).collect::<Result<_, _>>().map(Cow::Owned)
            }
        }
    }
}

impl Column {
    fn read(values: &Bound<'_, PyAny>) -> PyResult<Column> {
        if let Ok(numbers) = values.cast::<PyArray1<f64>>() {
            return Ok(Column::Numbers(numbers.try_readonly()?.as_array().to_vec()));
        }
        // As NumPy's numbers are slow to read one by one.
        let list = values.call_method0("tolist");
        let each = list.as_ref().unwrap_or(values).try_iter()?.enumerate();
        let text = |(number, value): (usize, PyResult<Bound<'_, PyAny>>)| {
            value_text(&value?).map_err(|error| numbered(values.py(), number, error))
        };
        each.map(text).collect::<PyResult<_>>().map(Column::Texts)
    }

    fn len(&self) -> usize {
        match self {
            Column::Numbers(numbers) => numbers.len(),
            Column::Texts(texts) => texts.len(),
        }
    }

    /// A value of the column, as text for the scenario reader.
    fn text(&self, index: usize) -> Cow<'_, str> {
        match self {
            Column::Numbers(numbers) => Cow::Owned(number_text(numbers[index])),
            Column::Texts(texts) => Cow::Borrowed(&texts[index]),
        }
    }
}

/// The exception for a variant that cannot run, with the variant's number.
pub(crate) fn exception(py: Python<'_>, number: usize, error: &NoRun) -> PyErr {
    let exception = match error {
        NoRun::Scenario(error) => errors::of_scenario(py, error),
        NoRun::Cannot(error) => cannot_run(py, error),
        NoRun::Other(what) => {
            errors::refused(py, format!("the variant has other {what} than its scenario"))
        }
    };
    numbered(py, number, exception)
}

/// Puts the number of a run before the message of its exception, and into the exception's attribute `run`.
pub(crate) fn numbered(py: Python<'_>, number: usize, error: PyErr) -> PyErr {
    let value = error.value(py);
    let set = (|| {
        let message = value.str()?;
        value.setattr("args", (format!("run {number}: {message}"),))?;
        value.setattr("run", number)
    })();
    set.map_or_else(|error| error, |()| error)
}
