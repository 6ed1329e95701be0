//! Gives Python the contacts and events of a step.

use std::borrow::Cow;

use fenderline_contact::{Contact, Event, EventKind, Friction};
use fenderline_results::{event_key, world_event_key};
use fenderline_sim::{WorldEvent, WorldEventKind};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;

/// The fields of a contact in NumPy, each of eight bytes: `i` a whole number, `f` a float.
const FIELDS: [(&str, char); 33] = [
    ("body_1", 'i'),
    ("body_2", 'i'),
    ("fender", 'i'),
    ("patch", 'i'),
    ("slip", 'i'),
    ("limited", 'i'),
    ("area_m2", 'f'),
    ("depth_m", 'f'),
    ("point_north_m", 'f'),
    ("point_east_m", 'f'),
    ("normal_north", 'f'),
    ("normal_east", 'f'),
    ("v_normal_mps", 'f'),
    ("v_tangential_mps", 'f'),
    ("shear_m", 'f'),
    ("normal_force_n", 'f'),
    ("tangential_force_n", 'f'),
    ("peak_normal_force_n", 'f'),
    ("peak_depth_m", 'f'),
    ("spring_n", 'f'),
    ("stop_n", 'f'),
    ("damper_n", 'f'),
    ("limiter_n", 'f'),
    ("work_normal_j", 'f'),
    ("work_tangential_j", 'f'),
    ("factor", 'f'),
    ("tilt_rad", 'f'),
    ("stored_j", 'f'),
    ("peak_absorbed_j", 'f'),
    ("hysteresis_j", 'f'),
    ("shear_stored_j", 'f'),
    ("arm_1_north_m", 'f'),
    ("arm_1_east_m", 'f'),
];

fn words(c: &Contact) -> [u64; FIELDS.len()] {
    let whole = |number: i64| number as u64;
    let f = f64::to_bits;
    [
        u64::from(c.body_1.0),
        u64::from(c.body_2.0),
        whole(c.fender.map_or(-1, |fender| i64::from(fender.0))),
        u64::from(c.patch),
        u64::from(c.friction == Friction::Slip),
        u64::from(c.limited),
        f(c.area_m2),
        f(c.depth_m),
        f(c.point_m.x),
        f(c.point_m.y),
        f(c.normal.x),
        f(c.normal.y),
        f(c.v_normal_mps),
        f(c.v_tangential_mps),
        f(c.shear_m),
        f(c.normal_force_n),
        f(c.tangential_force_n),
        f(c.peak_normal_force_n),
        f(c.peak_depth_m),
        f(c.parts.spring_n),
        f(c.parts.stop_n),
        f(c.parts.damper_n),
        f(c.parts.limiter_n),
        f(c.work.normal_j),
        f(c.work.tangential_j),
        f(c.factor),
        f(c.tilt_rad),
        f(c.energy.stored_j),
        f(c.energy.peak_absorbed_j),
        f(c.energy.hysteresis_j),
        f(c.energy.shear_stored_j),
        f(c.arm_1_m.x),
        f(c.arm_1_m.y),
    ]
}

/// NumPy's type of one contact.
pub(crate) fn contact_type(py: Python<'_>) -> PyResult<&Bound<'_, PyAny>> {
    static TYPE: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let made = TYPE.get_or_try_init(py, || {
        let fields: Vec<(&str, String)> =
            FIELDS.iter().map(|&(name, kind)| (name, format!("{kind}8"))).collect();
        Ok::<_, PyErr>(py.import("numpy")?.getattr("dtype")?.call1((fields,))?.unbind())
    })?;
    Ok(made.bind(py))
}

/// A new structured array of the given contacts.
pub(crate) fn contacts_array<'py>(
    py: Python<'py>,
    contacts: &[Contact],
) -> PyResult<Bound<'py, PyAny>> {
    let words: Vec<u64> = contacts.iter().flat_map(words).collect();
    PyArray1::from_vec(py, words).call_method1("view", (contact_type(py)?,))
}

/// An event in a step.
#[pyclass(frozen, get_all, module = "fenderline")]
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct StepEvent {
    /// The kind of event, as in `summary.json`: `contact_began`, `fender_rating_exceeded`, ...
    kind: Cow<'static, str>,
    /// Names of the bodies in the event, or of the vessel, tug or line.
    subjects: Vec<String>,
    /// Name of the fender in the event.
    fender: Option<String>,
}

#[pymethods]
impl StepEvent {
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Parts)> {
        let made = py.import("fenderline._native")?.getattr("step_event")?;
        Ok((made, (self.kind.to_string(), self.subjects.clone(), self.fender.clone())))
    }

    fn __eq__(&self, other: &StepEvent) -> bool {
        self == other
    }

    fn __repr__(&self) -> String {
        let fender = self.fender.as_ref().map_or(String::new(), |name| format!(", fender {name}"));
        format!("<fenderline.StepEvent {} of {}{fender}>", self.kind, self.subjects.join(" and "))
    }
}

/// Kind, subjects and fender of an event.
type Parts = (String, Vec<String>, Option<String>);

/// Makes an event from its parts; unpickling calls this function.
#[pyfunction]
#[pyo3(signature = (kind, subjects, fender))]
pub(crate) fn step_event(kind: String, subjects: Vec<String>, fender: Option<String>) -> StepEvent {
    StepEvent { kind: kind.into(), subjects, fender }
}

/// Makes the event of a contact, with the names of bodies and fender.
pub(crate) fn contact_event(event: &Event, bodies: &[String], fenders: &[String]) -> StepEvent {
    let fender = match event.kind {
        EventKind::FenderRatingExceeded(id) | EventKind::FenderFailed(id) => Some(id),
        _ => None,
    };
    StepEvent {
        kind: event_key(event.kind).into(),
        subjects: event.bodies.iter().map(|body| bodies[body.0 as usize].clone()).collect(),
        fender: fender.map(|id| fenders[id.0 as usize].clone()),
    }
}

/// Makes the event of a vessel, tug, line or anchor, with its name.
pub(crate) fn world_event(
    event: &WorldEvent,
    [vessels, tugs, lines, anchors]: [&[String]; 4],
) -> StepEvent {
    let names = match event.kind {
        WorldEventKind::OrderClamped | WorldEventKind::Aground | WorldEventKind::ShallowHeld => {
            vessels
        }
        WorldEventKind::TugLimited | WorldEventKind::TugOrderRefused => tugs,
        WorldEventKind::LineNotMadeFast
        | WorldEventKind::LineMadeFast
        | WorldEventKind::LineParted
        | WorldEventKind::LineNotParted
        | WorldEventKind::LineRenders => lines,
        WorldEventKind::Anchor(_) => anchors,
    };
    let kind = world_event_key(event.kind);
    StepEvent { kind: kind.into(), subjects: vec![names[event.who].clone()], fender: None }
}
