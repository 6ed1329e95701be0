//! Tries a shared library before it goes into an FMU: loads it and makes an instance, as a master does.

use core::fmt;
use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use libloading::Library;

use crate::pack::BUNDLE_FILE;
use crate::plan::Plan;

/// Says why a library cannot go into an FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TrialError {
    /// The files for the trial cannot be written.
    Folder(String),
    /// The operating system does not load the library; its reason is the text.
    NotLoaded(String),
    /// The library lacks a function of the FMI standard.
    Lacks(&'static str),
    /// The library makes no instance; its message is the text.
    Refused(String),
}

impl fmt::Display for TrialError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TrialError::Folder(why) => write!(f, "the FMU's library cannot be tried: {why}"),
            TrialError::NotLoaded(why) => write!(f, "the FMU's library cannot be loaded: {why}"),
            TrialError::Lacks(name) => write!(f, "the FMU's library has no function `{name}`"),
            TrialError::Refused(why) => {
                write!(f, "the FMU's library makes no instance of this scenario: {why}")
            }
        }
    }
}

impl std::error::Error for TrialError {}

/// Loads the library `file` and makes an instance of the plan's FMU, in a temporary folder that is removed afterwards.
///
/// # Errors
/// [`TrialError`].
pub fn try_library(file: &Path, plan: &Plan) -> Result<(), TrialError> {
    // A path with a folder: the system must not look elsewhere for a bare file name.
    let file = std::path::absolute(file).map_err(|e| TrialError::Folder(e.to_string()))?;
    let folder = Folder::new()?;
    folder.write(BUNDLE_FILE, plan.bundle.to_json().as_bytes())?;
    make_instance(&file, &folder.0, &plan.token)
}

/// Tries a library as [`try_library`] does, for a library whose bytes are in memory.
///
/// # Errors
/// [`TrialError`].
pub fn try_library_bytes(library: &[u8], plan: &Plan) -> Result<(), TrialError> {
    let folder = Folder::new()?;
    let file = folder.write(&crate::library_file_name(), library)?;
    folder.write(BUNDLE_FILE, plan.bundle.to_json().as_bytes())?;
    make_instance(&file, &folder.0, &plan.token)
}

/// `fmi3InstantiateCoSimulation`.
type Instantiate = unsafe extern "C" fn(
    *const c_char,
    *const c_char,
    *const c_char,
    bool,
    bool,
    bool,
    bool,
    *const u32,
    usize,
    *mut c_void,
    Option<unsafe extern "C" fn(*mut c_void, c_int, *const c_char, *const c_char)>,
    Option<unsafe extern "C" fn()>,
) -> *mut c_void;
/// `fmi3FreeInstance`.
type Free = unsafe extern "C" fn(*mut c_void);

/// Makes an instance by the functions of FMI 3.0 and frees it again. An instance by FMI 3.0 is enough for the trial,
/// because the library has the functions of both versions of FMI, and one token.
fn make_instance(file: &Path, resources: &Path, token: &str) -> Result<(), TrialError> {
    // SAFETY: loading runs the library's initialisers. The user names a library to be run by masters; ours has none but
    // the standard library's.
    let library =
        unsafe { Library::new(file) }.map_err(|e| TrialError::NotLoaded(e.to_string()))?;
    // SAFETY: the type is not used, only the presence of the function.
    unsafe { library.get::<*const c_void>(b"fmi2Instantiate\0") }
        .map_err(|_| TrialError::Lacks("fmi2Instantiate"))?;
    // SAFETY: the standard's signatures.
    let instantiate = unsafe { library.get::<Instantiate>(b"fmi3InstantiateCoSimulation\0") }
        .map_err(|_| TrialError::Lacks("fmi3InstantiateCoSimulation"))?;
    // SAFETY: as above.
    let free = unsafe { library.get::<Free>(b"fmi3FreeInstance\0") }
        .map_err(|_| TrialError::Lacks("fmi3FreeInstance"))?;
    let text = |text: &str| CString::new(text).map_err(|e| TrialError::Folder(e.to_string()));
    let path = resources.to_str().ok_or_else(|| {
        TrialError::Folder(format!("{}: the path is not Unicode", resources.display()))
    })?;
    let (token, path) = (text(token)?, text(path)?);
    let messages = Mutex::new(String::new());
    // SAFETY: the texts and `messages` outlive the call and the instance.
    let instance = unsafe {
        instantiate(
            c"trial".as_ptr(),
            token.as_ptr(),
            path.as_ptr(),
            false,
            false,
            false,
            false,
            std::ptr::null(),
            0,
            std::ptr::from_ref(&messages).cast_mut().cast(),
            Some(note),
            None,
        )
    };
    if instance.is_null() {
        let why = messages.into_inner().unwrap_or_else(PoisonError::into_inner);
        return Err(TrialError::Refused(why));
    }
    // SAFETY: the instance that was just made, freed once.
    unsafe { free(instance) };
    Ok(())
}

/// Keeps the last message.
unsafe extern "C" fn note(
    environment: *mut c_void,
    _status: c_int,
    _category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: the mutex that `make_instance` gave; it lives until the instance is freed.
    let messages = unsafe { &*environment.cast::<Mutex<String>>() };
    // SAFETY: the standard promises a text with a NUL.
    let message = unsafe { CStr::from_ptr(message) }.to_string_lossy().into_owned();
    *messages.lock().unwrap_or_else(PoisonError::into_inner) = message;
}

/// A temporary folder, which is removed when this value is dropped.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Result<Folder, TrialError> {
        let within = std::env::temp_dir();
        let mut number = 0_u32;
        loop {
            let path = within.join(format!("fenderline-trial-{}-{number}", std::process::id()));
            // Never a folder that someone else has made.
            match fs::create_dir(&path) {
                Ok(()) => return Ok(Folder(path)),
                Err(e) if e.kind() == std::io::ErrorKind::AlreadyExists && number < 1000 => {
                    number += 1;
                }
                Err(e) => return Err(TrialError::Folder(format!("{}: {e}", path.display()))),
            }
        }
    }

    fn write(&self, name: &str, content: &[u8]) -> Result<PathBuf, TrialError> {
        let path = self.0.join(name);
        fs::write(&path, content)
            .map_err(|e| TrialError::Folder(format!("{}: {e}", path.display())))?;
        Ok(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
