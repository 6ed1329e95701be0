//! Scenarios.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fenderline_scenario::{
    self as scenario, LoadError, Override, ScenarioError, read_text, set_keys,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::errors;

/// A checked scenario. A scenario cannot be changed: `with_set` returns another scenario. Two scenarios are equal if
/// their texts, replaced keys and files are equal. A scenario can be pickled; the pickle holds the texts of the files
/// that the scenario names.
///
/// `Scenario(source)` takes a path, a text of TOML (recognised by its line break), a tree of dictionaries or a
/// scenario. `Scenario.load` takes a path, `Scenario.parse` takes a text and `Scenario.from_tree` takes a tree. `set`
/// replaces keys as the program's `--set` does: a dictionary from dotted paths to values, or texts `KEY=VALUE`.
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
    pub(crate) source: Arc<Source>,
    pub(crate) checked: Arc<scenario::Scenario>,
}

/// What a scenario was read from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Source {
    text: Arc<str>,
    name: String,
    /// Folder of the files that the scenario names.
    folder: Option<PathBuf>,
    replaced: Vec<Replacement>,
    /// Texts of the files that the scenario names, by those names, as they were when the scenario was read.
    files: Files,
}

type Files = BTreeMap<String, Arc<str>>;

/// A replaced key of a scenario, as the user gave it and as it was read.
#[derive(Clone, Debug)]
pub(crate) struct Replacement {
    /// How errors name it.
    option: String,
    key: String,
    value: String,
    pub(crate) read: Override,
}

impl PartialEq for Replacement {
    fn eq(&self, other: &Replacement) -> bool {
        self.key == other.key && self.value == other.value
    }
}

impl Replacement {
    fn new(option: String, key: String, value: String) -> Result<Replacement, ScenarioError> {
        let read = Override::new(&option, &key, &value)?;
        Ok(Replacement { option, key, value, read })
    }

    /// Of `KEY=VALUE`.
    fn parse(text: &str) -> Result<Replacement, ScenarioError> {
        let read = Override::parse(text)?;
        let (key, value) = text.split_once('=').unwrap_or((text, ""));
        Ok(Replacement {
            option: format!("--set {text}"),
            key: key.to_owned(),
            value: value.to_owned(),
            read,
        })
    }
}

impl Source {
    /// Reads the scenario with further keys replaced.
    pub(crate) fn check(&self, more: &[Override]) -> Result<scenario::Scenario, ScenarioError> {
        self.check_with_files(more).map(|(checked, _)| checked)
    }

    /// Reads the scenario as `check` does, and also returns the texts of the files that were read.
    fn check_with_files(
        &self,
        more: &[Override],
    ) -> Result<(scenario::Scenario, Files), ScenarioError> {
        let own = self.replaced.iter().map(|replaced| &replaced.read);
        let overrides: Vec<Override> = own.chain(more).cloned().collect();
        let mut files = Files::new();
        let mut read = |file: &str| {
            let text: Arc<str> = match (self.files.get(file), &self.folder) {
                (Some(text), _) => Arc::clone(text),
                (None, Some(folder)) => read_text(&folder.join(file))?.into(),
                (None, None) => {
                    return Err(format!(
                        "{file}: the scenario was given as a text without a folder, so that no other file can be read"
                    ));
                }
            };
            let owned = text.to_string();
            files.insert(file.to_owned(), text);
            Ok(owned)
        };
        let checked =
            scenario::Scenario::parse_among(&self.text, &self.name, &overrides, &mut read)?;
        Ok((checked, files))
    }
}

#[pymethods]
impl Scenario {
    #[new]
    #[pyo3(signature = (source, set=None))]
    fn new(
        py: Python<'_>,
        source: &Bound<'_, PyAny>,
        set: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Scenario> {
        if let Ok(own) = source.cast::<Scenario>() {
            let Scenario { source, checked } = own.get();
            return match set {
                Some(set) => own.get().with_set(py, set),
                None => Ok(Scenario { source: Arc::clone(source), checked: Arc::clone(checked) }),
            };
        }
        if let Ok(text) = source.extract::<String>()
            && text.contains('\n')
        {
            return Scenario::of(py, text, "scenario.toml".to_owned(), None, set);
        }
        if source.hasattr("keys")? {
            return Scenario::from_tree(py, source, "tree", None, set);
        }
        let path: PathBuf = source.extract().map_err(|_| {
            let kind = source.get_type();
            PyTypeError::new_err(format!(
                "a scenario is a path, a text of TOML, a tree of dictionaries or a Scenario, not {kind}"
            ))
        })?;
        Scenario::load(py, path, set)
    }

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

    /// Checks the text of a scenario; `folder` is the folder of the files that the scenario names.
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

    /// Checks a scenario that is a tree of dictionaries, as `tree` returns one.
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

    /// A scenario like this one with further keys replaced. The files that the scenario names are not read again.
    fn with_set(&self, py: Python<'_>, set: &Bound<'_, PyAny>) -> PyResult<Scenario> {
        let mut source = Source::clone(&self.source);
        source.replaced.extend(replacements(py, set)?);
        Scenario::checked(py, source)
    }

    /// The scenario as a tree of dictionaries, with replaced keys; you can edit the tree and make another scenario of
    /// it with `from_tree`.
    fn tree<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let Source { text, name, replaced, .. } = &*self.source;
        let overrides: Vec<Override> = replaced.iter().map(|one| one.read.clone()).collect();
        let set =
            set_keys(text, name, &overrides).map_err(|error| errors::of_scenario(py, &error))?;
        let module = py.import("fenderline._tree")?;
        module.getattr("tree")?.call1((&*self.source.text, set))
    }

    /// The text of the scenario's file, without replaced keys.
    #[getter]
    fn text(&self) -> &str {
        &self.source.text
    }

    /// The name of the scenario's file.
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

    /// Duration of the scenario's run (s).
    #[getter]
    fn duration_s(&self) -> f64 {
        self.checked.setup.duration_s
    }

    /// Names of the bodies, in the order of the rows of all arrays that have one row per body.
    #[getter]
    pub(crate) fn bodies(&self) -> Vec<String> {
        self.checked.setup.bodies.iter().map(|body| body.name.clone()).collect()
    }

    /// Names of the fenders, in the order of all arrays that have one entry per fender.
    #[getter]
    pub(crate) fn fenders(&self) -> Vec<String> {
        self.checked.setup.fenders.iter().map(|fender| fender.name.clone()).collect()
    }

    fn __repr__(&self) -> String {
        format!("<fenderline.Scenario \"{}\" of {}>", self.checked.title, self.source.name)
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("fenderline._html")?.getattr("scenario")?.call1((slf,))
    }

    fn __eq__(&self, other: &Scenario) -> bool {
        Arc::ptr_eq(&self.source, &other.source) || self.source == other.source
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.source.text.hash(&mut hasher);
        hasher.finish()
    }

    // It is immutable.
    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Parts)> {
        let Source { text, name, folder, replaced, files } = &*self.source;
        let folder = folder.as_ref().map(|folder| folder.display().to_string());
        let replaced = replaced
            .iter()
            .map(|one| (one.option.clone(), one.key.clone(), one.value.clone()))
            .collect();
        let files = files.iter().map(|(name, text)| (name.clone(), text.to_string())).collect();
        let parts = (text.to_string(), name.clone(), folder, replaced, files);
        Ok((py.import("fenderline._pickling")?.getattr("scenario")?, parts))
    }
}

/// The parts of which a scenario is pickled: text, name, folder, replaced keys (option, key, value), texts of files by
/// name.
type Parts =
    (String, String, Option<String>, Vec<(String, String, String)>, BTreeMap<String, String>);

/// Makes a scenario again from the parts in its pickle. `fenderline._pickling` calls this function.
#[pyfunction]
pub(crate) fn scenario_of_parts(
    py: Python<'_>,
    text: String,
    name: String,
    folder: Option<PathBuf>,
    replaced: Vec<(String, String, String)>,
    files: BTreeMap<String, String>,
) -> PyResult<Scenario> {
    let replaced = replaced
        .into_iter()
        .map(|(option, key, value)| Replacement::new(option, key, value))
        .collect::<Result<Vec<_>, _>>()
        .map_err(|error| errors::of_scenario(py, &error))?;
    let files = files.into_iter().map(|(name, text)| (name, text.into())).collect();
    Scenario::checked(py, Source { text: text.into(), name, folder, replaced, files })
}

impl Scenario {
    fn of(
        py: Python<'_>,
        text: String,
        name: String,
        folder: Option<PathBuf>,
        set: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Scenario> {
        let replaced = set.map(|set| replacements(py, set)).transpose()?.unwrap_or_default();
        let files = Files::new();
        Scenario::checked(py, Source { text: text.into(), name, folder, replaced, files })
    }

    fn checked(py: Python<'_>, mut source: Source) -> PyResult<Scenario> {
        let checked = source.check_with_files(&[]);
        let (checked, files) = checked.map_err(|error| errors::of_scenario(py, &error))?;
        source.files = files;
        Ok(Scenario { source: Arc::new(source), checked: Arc::new(checked) })
    }
}

/// Reads the keys that replace those of a scenario: a dictionary from dotted paths to values, or texts `KEY=VALUE`.
pub(crate) fn replacements(py: Python<'_>, set: &Bound<'_, PyAny>) -> PyResult<Vec<Replacement>> {
    let refused = |error: ScenarioError| errors::of_scenario(py, &error);
    let Ok(dict) = set.cast::<PyDict>() else {
        let texts = set.try_iter()?.map(|text| text?.extract::<String>());
        return texts.map(|text| Replacement::parse(&text?).map_err(refused)).collect();
    };
    dict.iter()
        .map(|(key, value)| {
            let key: String = key.extract()?;
            let value = value_text(&value)?;
            Replacement::new(option(&key, &value), key, value).map_err(refused)
        })
        .collect()
}

/// The name that errors give to a replaced key with its value.
pub(crate) fn option(key: &str, value: &str) -> String {
    format!("set {key} = {value}")
}

/// A number as text for the scenario reader.
pub(crate) fn number_text(number: f64) -> String {
    match number {
        _ if number.is_nan() => "nan".to_owned(),
        _ => format!("{number:?}"),
    }
}

/// A Python value as text for the scenario reader: texts unchanged, everything else as TOML.
pub(crate) fn value_text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.is_instance_of::<PyString>() {
        return value.extract();
    }
    if value.is_exact_instance_of::<pyo3::types::PyFloat>() {
        return value.extract().map(number_text);
    }
    let module = value.py().import("fenderline._tree")?;
    module.getattr("inline")?.call1((value,))?.extract()
}

/// Writes a tree of dictionaries as TOML.
pub(crate) fn toml_of(tree: &Bound<'_, PyAny>) -> PyResult<String> {
    tree.py().import("fenderline._tree")?.getattr("dumps")?.call1((tree,))?.extract()
}
