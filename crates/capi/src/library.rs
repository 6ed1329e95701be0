//! Functions of the C interface about the library as a whole: its version, statuses and the last error.

use core::ffi::{CStr, c_char};

use crate::border::put_text;
use crate::failure::FlStatus;
use crate::last_error::{last, remember};
use crate::table::no_panic;

/// Version of this interface. The interface version changes when programs must be compiled anew.
pub const FL_ABI_VERSION: u32 = 1;

/// The interface version of the linked library; a program compares it with the header's FL_ABI_VERSION.
#[unsafe(no_mangle)]
pub extern "C" fn fl_abi_version() -> u32 {
    FL_ABI_VERSION
}

/// The library's version, such as "0.1.0". The text is static.
#[unsafe(no_mangle)]
pub extern "C" fn fl_version() -> *const c_char {
    const VERSION: &CStr =
        match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
            Ok(version) => version,
            Err(_) => c"",
        };
    VERSION.as_ptr()
}

/// Short description of a status of the interface; any number is accepted. The text is static.
#[unsafe(no_mangle)]
pub extern "C" fn fl_status_text(status: i32) -> *const c_char {
    let known = FlStatus::ALL.into_iter().find(|known| *known as i32 == status);
    known.map_or(c"no status", FlStatus::text).as_ptr()
}

/// Copies the message of the last failed call on this thread; empty if no call has failed. The message of a failed call
/// stays until another call fails; a call of fl_last_error() with too small a buffer does not count as a failed call.
/// `length` may be NULL. For the buffer see "Texts" in the preamble of this header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_last_error(
    buffer: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    // SAFETY: as the caller promises.
    keep_last(|text| unsafe { put_text(text, buffer, capacity, length) })
}

/// Runs a query for the message of the last error. If that query itself fails, the last error stays as it was.
pub(crate) fn keep_last(query: impl FnOnce(&str) -> crate::failure::Outcome) -> FlStatus {
    let text = last();
    let status = no_panic(|| query(&text));
    if status != FlStatus::Ok {
        remember(text);
    }
    status
}
