//! Reads and writes memory of the master, the program that calls the FMU. Null and misaligned pointers are rejected;
//! everything else is the master's promise: that a pointer is valid for its type and count during the call.

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::{Path, PathBuf};

use fenderline_scenario::read_text_of;

use crate::bundle::Bundle;
use crate::instance::{Instance, Outcome};
use crate::library::STAMP;
use crate::logger::{Logger2, Logger3};
use crate::plan::Plan;
use crate::status::Status;

/// Most values that a call may read or write; a longer array is an error.
const MOST_VALUES: usize = 1 << 20;
/// Limit of a serialised state (bytes).
const MOST_BYTES: usize = 1 << 30;
/// Category of all messages to the master, as the model description names it.
pub(crate) const CATEGORY: &CStr = c"logStatusError";

/// Where messages go.
pub(crate) enum Log {
    Nowhere,
    Two { logger: Logger2, environment: Address, name: CString },
    Three { logger: Logger3, environment: Address },
}

/// A pointer of the master, which is handed back to the master and never dereferenced.
pub(crate) struct Address(pub(crate) *mut c_void);

// SAFETY: the address is only passed back. The standard lets a master call an instance from any
// thread, with the environment that the master gave.
unsafe impl Send for Address {}
// SAFETY: as above.
unsafe impl Sync for Address {}

impl Log {
    pub(crate) fn write(&self, status: Status, text: &str) {
        let clean = text.replace('\0', " ");
        match self {
            Log::Nowhere => {}
            Log::Two { logger, environment, name } => {
                // The message is a printf format, in which `#` starts a reference to a variable.
                let message = clean.replace('%', "%%").replace('#', "##");
                let Ok(message) = CString::new(message) else { return };
                // SAFETY: the master's own function and pointer; the texts live during the call.
                unsafe {
                    logger(
                        environment.0,
                        name.as_ptr(),
                        status as c_int,
                        CATEGORY.as_ptr(),
                        message.as_ptr(),
                    );
                }
            }
            Log::Three { logger, environment } => {
                let Ok(message) = CString::new(clean) else { return };
                // SAFETY: as above.
                unsafe {
                    logger(environment.0, status as c_int, CATEGORY.as_ptr(), message.as_ptr());
                }
            }
        }
    }
}

fn check<T>(pointer: *const T, name: &str) -> Outcome {
    if pointer.is_null() {
        return Err(format!("{name} is NULL"));
    }
    if !pointer.is_aligned() {
        return Err(format!("{name} is not aligned"));
    }
    Ok(())
}

/// Copies values in.
///
/// # Safety
/// The pointer must be valid for `count` values during the call, as the master promises.
pub(crate) unsafe fn read<T: Copy>(pointer: *const T, count: usize, name: &str) -> Outcome<Vec<T>> {
    if count == 0 {
        return Ok(Vec::new());
    }
    check(pointer, name)?;
    if count > MOST_VALUES {
        return Err(format!("{count} of {name} are more than a call may pass"));
    }
    // SAFETY: not NULL, aligned, and within the count that the master promises; any bytes are a valid number.
    Ok((0..count).map(|index| unsafe { pointer.add(index).read() }).collect())
}

/// Copies bytes in.
///
/// # Safety
/// The pointer must be valid for `count` bytes during the call, as the master promises.
pub(crate) unsafe fn read_bytes(pointer: *const u8, count: usize) -> Outcome<Vec<u8>> {
    check(pointer, "the serialised state")?;
    if count > MOST_BYTES {
        return Err(format!("a state of {count} bytes is too long"));
    }
    // SAFETY: not NULL; the master promises `count` bytes, which nobody writes during the call.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) }.to_vec())
}

/// Copies values out.
///
/// # Safety
/// The pointer must have room for all of the values during the call, as the master promises.
pub(crate) unsafe fn write<T: Copy>(pointer: *mut T, values: &[T], name: &str) -> Outcome {
    if values.is_empty() {
        return Ok(());
    }
    check(pointer, name)?;
    for (index, &value) in values.iter().enumerate() {
        // SAFETY: not NULL, aligned, and within the room that the master promises.
        unsafe { pointer.add(index).write(value) };
    }
    Ok(())
}

/// Rejects a NULL or misaligned pointer where the master should give room for values.
pub(crate) fn check_room<T>(pointer: *const T, count: usize, name: &str) -> Outcome {
    if count == 0 { Ok(()) } else { check(pointer, name) }
}

/// Copies a text in.
///
/// # Safety
/// The text must end with a NUL, as the master promises.
pub(crate) unsafe fn text(pointer: *const c_char, name: &str) -> Outcome<String> {
    check(pointer, name)?;
    // SAFETY: not NULL; the master promises a NUL.
    let text = unsafe { CStr::from_ptr(pointer) };
    text.to_str().map(str::to_owned).map_err(|_| format!("{name} is not UTF-8"))
}

/// Limit of a bundle's size (bytes).
const LARGEST_BUNDLE: u64 = 1 << 30;

/// Creates an instance of the FMU whose resources are in the folder `resources`.
pub(crate) fn instance(token: &str, resources: &Path) -> Outcome<Instance> {
    let path = resources.join(crate::pack::BUNDLE_FILE);
    let json = read_text_of(&path, LARGEST_BUNDLE).map_err(|error| error.to_string())?;
    let bundle = Bundle::from_json(&json).map_err(|error| error.to_string())?;
    let plan = Plan::new(bundle).map_err(|error| error.to_string())?;
    if plan.token != token {
        return Err(format!(
            "the FMU's token is `{}` and not `{token}`: its description, resources and library do not belong \
             together (library: {STAMP})",
            plan.token
        ));
    }
    Ok(Instance::new(plan))
}

/// The folder that a URI of the form `file:…` names.
pub(crate) fn folder_of_uri(uri: &str) -> Outcome<PathBuf> {
    let no = || format!("the resource location `{uri}` is not a file URI");
    let rest = uri.strip_prefix("file:").ok_or_else(no)?;
    let path = match rest.strip_prefix("//") {
        Some(rest) => rest.strip_prefix("localhost").unwrap_or(rest),
        None => rest,
    };
    let mut bytes = Vec::with_capacity(path.len());
    let mut left = path.bytes();
    while let Some(byte) = left.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let digit = |byte: Option<u8>| byte.and_then(|byte| (byte as char).to_digit(16));
        let (Some(high), Some(low)) = (digit(left.next()), digit(left.next())) else {
            return Err(no());
        };
        bytes.push((16 * high + low) as u8);
    }
    let path = String::from_utf8(bytes).map_err(|_| no())?;
    // "/C:/…" on Windows.
    let drive = path.as_bytes().get(2) == Some(&b':') && path.starts_with('/');
    Ok(PathBuf::from(if drive { &path[1..] } else { &path }))
}

/// Refuses the use of a feature that the FMU lacks: returns an error unless `count` is 0.
pub(crate) fn none(count: usize, what: &str) -> Outcome {
    if count == 0 { Ok(()) } else { Err(format!("the FMU has no {what}")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_uris_become_paths() {
        let folder = |uri: &str| folder_of_uri(uri).map(|path| path.display().to_string());
        for uri in ["file:///a%20b/c", "file:/a%20b/c", "file://localhost/a b/c"] {
            assert_eq!(folder(uri).as_deref(), Ok("/a b/c"));
        }
        assert_eq!(folder("file:///C:/x").as_deref(), Ok("C:/x"));
        for uri in ["http://a", "/a", "file:///%zz", "file:///a%2", "file:///%ff"] {
            assert!(folder(uri).is_err(), "{uri}");
        }
    }
}
