//! Scenarios.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fenderline_scenario::{self as scenario, LoadError, Override, ScenarioError, read_text};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::errors;

/// A checked scenario. It is immutable: `with_set` returns another one.
///
/// Made with `Scenario.load(path)`, `Scenario.parse(text)` or `Scenario.from_tree(tree)`. `set` replaces keys as the
/// program's `--set` does: a dictionary from dotted paths to values, or texts `KEY=VALUE`.
///
/// >>> import fenderline
/// >>> scenario = fenderline.example("tug_4kn").with_set({"time.step": "0.05 s"})
/// >>> scenario.step_s, scenario.bodies
/// (0.05, ['ship', 'tug'])
/// >>> tree = scenario.tree()
/// >>> tree["body"]["tug"]["velocity"] = {"surge": "2 kn"}
/// >>> slower = fenderline.Scenario.from_tree(tree)
#[pyclass(frozen, module = "fenderline")]
pub(crate) struct Scenario {
    pub(crate) source: Source,
    pub(crate) checked: Arc<scenario::Scenario>,
}

/// The source of a scenario.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    text: Arc<str>,
    name: String,
    /// Folder of the files that it names.
    folder: Option<PathBuf>,
    overrides: Vec<Override>,
}

impl Source {
    /// Reads the scenario with more overrides.
    pub(crate) fn check(&self, more: &[Override]) -> Result<scenario::Scenario, ScenarioError> {
        let mut overrides = self.overrides.clone();
        overrides.extend_from_slice(more);
        scenario::Scenario::parse_among(&self.text, &self.name, &overrides, &mut |file| match &self
            .folder
        {
            Some(folder) => read_text(&folder.join(file)),
            None => Err(format!(
                "{file}: the scenario's text has no folder, so no other file can be read"
            )),
        })
    }
}

#[pymethods]
impl Scenario {
    /// Reads and checks a scenario file; `set` replaces keys.
    #[staticmethod]
    #[pyo3(signature = (path, set=None))]
    fn load(py: Python<'_>, path: PathBuf, set: Option<&Bound<'_, PyAny>>) -> PyResult<Scenario> {
        let text =
            read_text(&path).map_err(|why| errors::of_load(py, &LoadError::Unreadable(why)))?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let name = path.display().to_string();
        Scenario::of(py, text, name, Some(folder), set)
    }

    /// Checks the text of a scenario; `folder` has the files that it names.
    #[staticmethod]
    #[pyo3(signature = (text, name="scenario.toml", folder=None, set=None))]
    fn parse(
        py: Python<'_>,
        text: String,
        name: &str,
        folder: Option<PathBuf>,
        set: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Scenario> {
        Scenario::of(py, text, name.to_owned(), folder, set)
    }

    /// Checks a scenario given as a tree of dictionaries, as `tree` returns it.
    #[staticmethod]
    #[pyo3(signature = (tree, name="tree", folder=None, set=None))]
    fn from_tree(
        py: Python<'_>,
        tree: &Bound<'_, PyAny>,
        name: &str,
        folder: Option<PathBuf>,
        set: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Scenario> {
        let text = toml_of(tree)?;
        Scenario::of(py, text, name.to_owned(), folder, set)
    }

    /// This scenario with more keys replaced.
    fn with_set(&self, py: Python<'_>, set: &Bound<'_, PyAny>) -> PyResult<Scenario> {
        let mut source = self.source.clone();
        source.overrides.extend(overrides(py, set)?);
        Scenario::checked(py, source)
    }

    /// The scenario as a tree of dictionaries, with replaced keys; edit it, and make another scenario with `from_tree`.
    fn tree<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let set = self.source.overrides.iter().map(|set| (set.path().to_vec(), set.value_text()));
        let set: Vec<(Vec<String>, &str)> = set.collect();
        let module = py.import("fenderline._tree")?;
        module.getattr("tree")?.call1((&*self.source.text, set))
    }

    /// The text of the file, without replaced keys.
    #[getter]
    fn text(&self) -> &str {
        &self.source.text
    }

    /// The name of the file.
    #[getter]
    fn name(&self) -> &str {
        &self.source.name
    }

    /// The title of reports.
    #[getter]
    fn title(&self) -> &str {
        &self.checked.title
    }

    /// Notices of corrections and likely mistakes, one line each.
    #[getter]
    fn notices(&self) -> Vec<String> {
        self.checked.notices.iter().map(ToString::to_string).collect()
    }

    /// Δt (s).
    #[getter]
    fn step_s(&self) -> f64 {
        self.checked.setup.step_s
    }

    /// Duration of the run (s).
    #[getter]
    fn duration_s(&self) -> f64 {
        self.checked.setup.duration_s
    }

    /// Names of the bodies, in the order of all arrays with one row per body.
    #[getter]
    pub(crate) fn bodies(&self) -> Vec<String> {
        self.checked.setup.bodies.iter().map(|body| body.name.clone()).collect()
    }

    /// Names of the fenders, in the order of all arrays with one entry per fender.
    #[getter]
    pub(crate) fn fenders(&self) -> Vec<String> {
        self.checked.setup.fenders.iter().map(|fender| fender.name.clone()).collect()
    }

    fn __repr__(&self) -> String {
        format!("<fenderline.Scenario \"{}\" of {}>", self.checked.title, self.source.name)
    }
}

impl Scenario {
    fn of(
        py: Python<'_>,
        text: String,
        name: String,
        folder: Option<PathBuf>,
        set: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Scenario> {
        let overrides = set.map(|set| overrides(py, set)).transpose()?.unwrap_or_default();
        Scenario::checked(py, Source { text: text.into(), name, folder, overrides })
    }

    fn checked(py: Python<'_>, source: Source) -> PyResult<Scenario> {
        let checked = source.check(&[]).map_err(|error| errors::of_scenario(py, &error))?;
        Ok(Scenario { source, checked: Arc::new(checked) })
    }
}

/// Keys and values that replace those of a scenario: a dictionary from dotted paths, or texts `KEY=VALUE`.
pub(crate) fn overrides(py: Python<'_>, set: &Bound<'_, PyAny>) -> PyResult<Vec<Override>> {
    let refused = |error: ScenarioError| errors::of_scenario(py, &error);
    let Ok(dict) = set.cast::<PyDict>() else {
        let texts = set.try_iter()?.map(|text| text?.extract::<String>());
        return texts.map(|text| Override::parse(&text?).map_err(refused)).collect();
    };
    dict.iter()
        .map(|(key, value)| {
            let key: String = key.extract()?;
            let value = value_text(&value)?;
            Override::new(&format!("set {key} = {value}"), &key, &value).map_err(refused)
        })
        .collect()
}

/// A value for the scenario reader: texts unchanged, everything else as TOML.
fn value_text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.is_instance_of::<PyString>() {
        return value.extract();
    }
    if value.is_exact_instance_of::<pyo3::types::PyFloat>() {
        let number: f64 = value.extract()?;
        if number.is_finite() {
            return Ok(format!("{number:?}"));
        }
    }
    let module = value.py().import("fenderline._tree")?;
    module.getattr("inline")?.call1((value,))?.extract()
}

/// A tree of dictionaries as TOML.
pub(crate) fn toml_of(tree: &Bound<'_, PyAny>) -> PyResult<String> {
    tree.py().import("fenderline._tree")?.getattr("dumps")?.call1((tree,))?.extract()
}
