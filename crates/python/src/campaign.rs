//! Campaigns for Python: `fenderline.campaign` uses the class of this module.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use fenderline_campaign::store::{self, Opened, Shard, Store};
use fenderline_campaign::{CampaignError, Cell, Drawn, Row, RunNumbers, Runner, Runs, make};
use fenderline_scenario as scenario;
use numpy::{PyArray1, PyReadonlyArray2, PyUntypedArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::errors;
use crate::parallel;
use crate::whole;

/// A campaign whose file was read: the values of the variables that are drawn for each run, and the runs themselves. It
/// is immutable.
#[pyclass(frozen, module = "fenderline.campaign", name = "Campaign")]
pub(crate) struct Campaign {
    path: PathBuf,
    runs: Runs,
}

fn exception(py: Python<'_>, error: &CampaignError) -> PyErr {
    match error {
        CampaignError::File(error) => errors::of_load(py, error),
        other => errors::of_campaign(py, other.to_string()),
    }
}

fn cell<'py>(py: Python<'py>, cell: &Cell) -> PyResult<Bound<'py, PyAny>> {
    Ok(match cell {
        Cell::Number(value) => value.into_pyobject(py)?.into_any(),
        Cell::Text(text) => text.into_pyobject(py)?.into_any(),
        Cell::Empty => py.None().into_bound(py),
    })
}

#[pymethods]
impl Campaign {
    /// Reads the file of a campaign, the scenario of the campaign, and the files that both name.
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Campaign> {
        let read = fenderline_campaign::Campaign::load(&path).map_err(CampaignError::from);
        let runs = read.and_then(Runs::new).map_err(|error| exception(py, &error))?;
        Ok(Campaign { path, runs })
    }

    /// The number of runs.
    fn __len__(&self) -> usize {
        usize::try_from(self.runs.count()).unwrap_or(usize::MAX)
    }

    fn __repr__(&self) -> String {
        let campaign = self.runs.campaign();
        format!(
            "Campaign({:?}, {}, {} runs)",
            campaign.title,
            campaign.plan.word(),
            self.runs.count()
        )
    }

    /// A campaign is pickled as the path of its file, which the other process must be able to read.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (PathBuf,))> {
        let class = py.import("fenderline.campaign")?.getattr("Campaign")?;
        Ok((class, (self.path.clone(),)))
    }

    /// Path of the file.
    #[getter]
    fn path(&self) -> PathBuf {
        self.path.clone()
    }

    /// Title.
    #[getter]
    fn title(&self) -> String {
        self.runs.campaign().title.clone()
    }

    /// Names of the variables.
    #[getter]
    fn variables(&self) -> Vec<String> {
        self.runs.draws().heads().iter().map(|head| head.name.clone()).collect()
    }

    /// Columns of the campaign's table after the column `case`, each with name, unit and meaning.
    #[getter]
    fn columns(&self) -> Vec<(String, String, String)> {
        let named = |head: &fenderline_campaign::Head| {
            (head.name.clone(), head.unit.clone(), head.meaning.clone())
        };
        self.runs.heads().iter().map(named).collect()
    }

    /// Limits of outputs, each with name, column of the output, and value in the unit of the column.
    #[getter]
    fn limits(&self) -> Vec<(String, String, f64)> {
        let limits = self.runs.limits().iter();
        limits.map(|limit| (limit.name.clone(), limit.output.clone(), limit.value)).collect()
    }

    /// A number in hexadecimal that tells campaigns apart whose rows may differ.
    #[getter]
    fn fingerprint(&self) -> String {
        format!("{:016x}", self.runs.fingerprint())
    }

    /// The values of the variables of a run; the first run has the number 0.
    fn draw<'py>(&self, py: Python<'py>, run: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyDict>> {
        let run = self.number(run)?;
        self.values(py, &self.runs.draws().of_run(run))
    }

    /// The changes of the scenario in a run, as texts KEY=VALUE; the first run has the number 0.
    fn settings(&self, run: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
        let run = self.number(run)?;
        Ok(self.runs.settings(run))
    }

    /// Makes the runs from number `first` to `last - 1` on `threads` threads (by default all threads of the machine).
    /// Returns the rows of the runs as bytes, which `write` takes: bytes are small, and can pass between processes.
    #[pyo3(signature = (first, last, threads=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        first: &Bound<'py, PyAny>,
        last: &Bound<'py, PyAny>,
        #[pyo3(from_py_with = whole::some_threads)] threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let numbers = RunNumbers::from(whole::range(first, last, self.runs.count())?);
        let mut rows: Vec<Row> = Vec::new();
        self.make(py, &numbers, threads, &mut |row| {
            rows.push(row);
            Ok(())
        })?;
        rows.sort_by_key(|row| row.run);
        let bytes: Vec<u8> = rows.iter().flat_map(store::encode).collect();
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the tables of the campaign into a folder, from the rows of all its runs in any order, as `run` returned
    /// them.
    #[pyo3(signature = (folder, rows, replace=false))]
    fn write(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        rows: Vec<Bound<'_, PyBytes>>,
        replace: bool,
    ) -> PyResult<()> {
        let opened = if replace { Opened::Replaced } else { Opened::New };
        let refused = |error: CampaignError| exception(py, &error);
        let mut store =
            Store::open(&folder, &self.runs, Shard::WHOLE, opened, &mut |_| {}).map_err(refused)?;
        for message in &rows {
            for row in store::decode_all(message.as_bytes()).map_err(refused)? {
                if row.run >= self.runs.count() || row.cells.len() != self.runs.heads().len() {
                    let why = "the rows belong to another campaign".to_owned();
                    return Err(errors::of_campaign(py, why));
                }
                store.add(&row).map_err(refused)?;
            }
        }
        let missing = store.missing();
        if let Some(first) = missing.get(0) {
            let count = missing.count();
            let why =
                format!("{count} runs have no row; the first of these runs has the number {first}");
            return Err(errors::of_campaign(py, why));
        }
        store.finish(self.runs.count()).map_err(refused)
    }

    /// Makes a run for each row of `probabilities`, with the variables at these probabilities: a column for each
    /// variable, each number between 0 and 1. Returns an array for each column of the table that `outputs` names; a
    /// number is NaN if the run has no such number or was not made. Methods for rare events and sensitivity make their
    /// runs by this function.
    #[pyo3(signature = (probabilities, outputs, threads=None))]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        probabilities: PyReadonlyArray2<'py, f64>,
        outputs: Vec<String>,
        #[pyo3(from_py_with = whole::some_threads)] threads: Option<usize>,
    ) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
        let heads = self.runs.heads();
        let mut columns = Vec::new();
        for name in &outputs {
            let found = heads.iter().position(|head| head.name == *name && !head.is_text);
            columns.push(found.ok_or_else(|| {
                let near = scenario::nearest(name, heads.iter().map(|head| head.name.as_str()));
                let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
                errors::of_campaign(py, format!("there is no number `{name}`{near}"))
            })?);
        }
        let count = probabilities.shape()[0];
        let array = probabilities.as_array();
        let mut draws: Vec<Drawn> = Vec::with_capacity(count);
        for row in array.rows() {
            let row: Vec<f64> = row.iter().copied().collect();
            let drawn = self.runs.draws().at_probabilities(&row);
            draws.push(drawn.map_err(|why| errors::of_campaign(py, why))?);
        }
        let threads = parallel::threads(threads);
        let work = |runner: &mut Runner<'_>,
                    index: usize,
                    stop: &AtomicBool|
         -> Result<Vec<f64>, ()> {
            let cells =
                runner.of(draws[index].clone(), &|| stop.load(Ordering::Relaxed)).ok_or(())?;
            Ok(columns.iter().map(|column| cells[*column].number().unwrap_or(f64::NAN)).collect())
        };
        let mut raised = None;
        let mut watch = |_: usize| {
            raised = Python::attach(|py| py.check_signals()).err();
            raised.is_none()
        };
        let ended = py.detach(|| {
            parallel::each_watched(count, threads, || Runner::new(&self.runs), work, &mut watch)
        });
        let Ok(values) = ended else {
            return Err(raised.unwrap_or_else(|| errors::bad_argument("the runs were stopped")));
        };
        let column =
            |place: usize| PyArray1::from_vec(py, values.iter().map(|own| own[place]).collect());
        Ok((0..outputs.len()).map(column).collect())
    }

    /// The values of the variables at the given probabilities, each between 0 and 1.
    fn at<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole::probabilities)] probabilities: Vec<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let drawn = self.runs.draws().at_probabilities(&probabilities);
        self.values(py, &drawn.map_err(|why| errors::of_campaign(py, why))?)
    }
}

impl Campaign {
    fn number(&self, run: &Bound<'_, PyAny>) -> PyResult<u64> {
        whole::index(run, "run", self.runs.count())
    }

    fn values<'py>(&self, py: Python<'py>, drawn: &Drawn) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (head, value) in self.runs.draws().heads().iter().zip(&drawn.values) {
            dict.set_item(&head.name, cell(py, value)?)?;
        }
        Ok(dict)
    }

    /// Makes runs while other Python code may go on; an interrupt by the user ends the runs.
    fn make(
        &self,
        py: Python<'_>,
        numbers: &RunNumbers,
        threads: Option<usize>,
        use_row: &mut (dyn FnMut(Row) -> Result<(), CampaignError> + Send),
    ) -> PyResult<()> {
        let threads = parallel::threads(threads);
        let stop = AtomicBool::new(false);
        let mut raised = None;
        let made = py.detach(|| {
            make(&self.runs, numbers, threads, &|| stop.load(Ordering::Relaxed), &mut |row| {
                use_row(row)?;
                raised = Python::attach(|py| py.check_signals()).err();
                if raised.is_some() {
                    stop.store(true, Ordering::Relaxed);
                }
                Ok(raised.is_none())
            })
        });
        match raised {
            Some(raised) => Err(raised),
            None => made.map_err(|error| exception(py, &error)),
        }
    }
}
