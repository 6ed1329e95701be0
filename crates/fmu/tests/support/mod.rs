//! FMUs of a small scenario, called through the C functions as by a master.
#![allow(dead_code, reason = "each test file uses its own part")]
#![allow(unsafe_code, reason = "the test acts as a master")]

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::fs;
use std::path::PathBuf;
use std::sync::Mutex;

use fenderline_fmu::fmi2::{self, Callbacks, Logger2};
use fenderline_fmu::{Bundle, Kind, Plan};

pub(crate) const SCENARIO: &str = r#"
title = "A tug at a quay"
[time]
step = "0.1 s"
duration = "10 s"
[material.rubber]
stiffness = "500 kN/m^2"
shear_stiffness = "3000 kN/m"
friction_static = 0.5
friction_dynamic = 0.4
restitution = 0.1
[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 5], [-100, 5]]
position = [0, 20]
[body.tug]
outline = [[-16, -6.5], [8, -6.5], [16, -5], [16, 5], [8, 6.5], [-16, 6.5]]
mass = "930 t"
gyradius = "8 m"
added_mass = { surge = 0.08, sway = 0.8, yaw = 0.4 }
position = [3, 3.5]
heading = "90 deg"
velocity = { surge = "1 m/s" }
[[pair]]
bodies = ["quay", "tug"]
material = "rubber"
"#;

pub(crate) const OK: c_int = 0;
pub(crate) const DISCARD: c_int = 2;
pub(crate) const ERROR: c_int = 3;

/// An unpacked FMU.
pub(crate) struct Unpacked {
    folder: PathBuf,
    pub(crate) plan: Plan,
}

impl Unpacked {
    pub(crate) fn new(kind: Kind, name: &str) -> Unpacked {
        let folder =
            std::env::temp_dir().join(format!("fenderline-fmu-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder for the test");
        let file = folder.join("tug.toml");
        fs::write(&file, SCENARIO).expect("the scenario");
        let bundle = Bundle::load(kind, &file, Vec::new()).expect("a good scenario");
        fs::write(folder.join("scenario.json"), bundle.to_json()).expect("the resource");
        Unpacked { folder, plan: Plan::new(bundle).expect("a good scenario") }
    }

    pub(crate) fn uri(&self) -> CString {
        CString::new(format!("file://{}", self.folder.display())).expect("no NUL")
    }

    pub(crate) fn token(&self) -> CString {
        CString::new(self.plan.token.clone()).expect("no NUL")
    }

    pub(crate) fn reference(&self, name: &str) -> u32 {
        let place = self.plan.table.variables.iter().position(|v| v.name == name);
        place.unwrap_or_else(|| panic!("no `{name}`")) as u32
    }

    /// A new instance of FMI 2.0, whose messages go to `log`.
    pub(crate) fn two(&self, log: &Messages) -> Two {
        let callbacks = log.callbacks();
        let (uri, token) = (self.uri(), self.token());
        // SAFETY: texts and callbacks live during the call, the messages during the test.
        let component = unsafe {
            fmi2::fmi2Instantiate(
                c"tug".as_ptr(),
                1,
                token.as_ptr(),
                uri.as_ptr(),
                &callbacks,
                0,
                0,
            )
        };
        Two(component)
    }
}

impl Drop for Unpacked {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// The messages that an instance has logged.
#[derive(Default)]
pub(crate) struct Messages(Mutex<Vec<(c_int, String)>>);

impl Messages {
    pub(crate) fn callbacks(&self) -> Callbacks {
        // SAFETY: on the tested platforms the named arguments of a variadic function are passed like those of an
        // ordinary one, and the library passes no others.
        let logger = unsafe { std::mem::transmute::<*const (), Logger2>(log as *const ()) };
        Callbacks {
            logger: Some(logger),
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            environment: std::ptr::from_ref(self).cast_mut().cast(),
        }
    }

    /// Returns the last message and removes all.
    pub(crate) fn last(&self) -> String {
        let mut all = self.0.lock().expect("no panic");
        let last = all.pop().map(|(_, text)| text).unwrap_or_default();
        all.clear();
        last
    }
}

unsafe extern "C" fn log(
    environment: *mut c_void,
    _name: *const c_char,
    status: c_int,
    _category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: the environment is that of `callbacks`, the message a text.
    let (messages, text) =
        unsafe { (&*environment.cast::<Messages>(), CStr::from_ptr(message).to_string_lossy()) };
    messages.0.lock().expect("no panic").push((status, text.into_owned()));
}

/// An instance of FMI 2.0.
pub(crate) struct Two(pub(crate) *mut c_void);

// SAFETY of all below: arrays have the given length and live during the call.
impl Two {
    pub(crate) fn initialized(self) -> Two {
        assert_eq!(self.set_up(0.0, None), OK);
        assert_eq!(self.enter(), OK);
        assert_eq!(self.exit(), OK);
        self
    }

    pub(crate) fn set_up(&self, start_s: f64, stop_s: Option<f64>) -> c_int {
        let defined = c_int::from(stop_s.is_some());
        unsafe {
            fmi2::fmi2SetupExperiment(self.0, 0, 0.0, start_s, defined, stop_s.unwrap_or(0.0))
        }
    }

    pub(crate) fn enter(&self) -> c_int {
        unsafe { fmi2::fmi2EnterInitializationMode(self.0) }
    }

    pub(crate) fn exit(&self) -> c_int {
        unsafe { fmi2::fmi2ExitInitializationMode(self.0) }
    }

    pub(crate) fn terminate(&self) -> c_int {
        unsafe { fmi2::fmi2Terminate(self.0) }
    }

    pub(crate) fn reset(&self) -> c_int {
        unsafe { fmi2::fmi2Reset(self.0) }
    }

    pub(crate) fn step(&self, t_s: f64, step_s: f64) -> c_int {
        unsafe { fmi2::fmi2DoStep(self.0, t_s, step_s, 0) }
    }

    pub(crate) fn set(&self, references: &[u32], values: &[f64]) -> c_int {
        assert_eq!(references.len(), values.len());
        unsafe { fmi2::fmi2SetReal(self.0, references.as_ptr(), references.len(), values.as_ptr()) }
    }

    pub(crate) fn set_boolean(&self, reference: u32, value: c_int) -> c_int {
        unsafe { fmi2::fmi2SetBoolean(self.0, &reference, 1, &value) }
    }

    pub(crate) fn get(&self, references: &[u32]) -> Result<Vec<f64>, c_int> {
        let mut values = vec![0.0; references.len()];
        let (from, count) = (references.as_ptr(), references.len());
        match unsafe { fmi2::fmi2GetReal(self.0, from, count, values.as_mut_ptr()) } {
            OK => Ok(values),
            status => Err(status),
        }
    }

    pub(crate) fn save(&self) -> *mut c_void {
        let mut state = std::ptr::null_mut();
        assert_eq!(unsafe { fmi2::fmi2GetFMUstate(self.0, &mut state) }, OK);
        state
    }

    pub(crate) fn restore(&self, state: *mut c_void) -> c_int {
        unsafe { fmi2::fmi2SetFMUstate(self.0, state) }
    }

    pub(crate) fn bytes(&self, state: *mut c_void) -> Vec<u8> {
        self.try_bytes(state).expect("a state of this instance")
    }

    pub(crate) fn try_bytes(&self, state: *mut c_void) -> Option<Vec<u8>> {
        let mut size = 0;
        if unsafe { fmi2::fmi2SerializedFMUstateSize(self.0, state, &mut size) } != OK {
            return None;
        }
        let mut bytes = vec![0; size];
        let status =
            unsafe { fmi2::fmi2SerializeFMUstate(self.0, state, bytes.as_mut_ptr(), size) };
        assert_eq!(status, OK);
        Some(bytes)
    }

    pub(crate) fn of_bytes(&self, bytes: &[u8]) -> Result<*mut c_void, c_int> {
        let mut state = std::ptr::null_mut();
        let (from, size) = (bytes.as_ptr(), bytes.len());
        match unsafe { fmi2::fmi2DeSerializeFMUstate(self.0, from, size, &mut state) } {
            OK => Ok(state),
            status => Err(status),
        }
    }
}

impl Drop for Two {
    fn drop(&mut self) {
        unsafe { fmi2::fmi2FreeInstance(self.0) };
    }
}
