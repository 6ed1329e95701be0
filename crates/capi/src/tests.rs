//! Tests that need access to internals.

use core::ptr;

use fenderline_embed::EngineBuilder;

use crate::failure::FlStatus;
use crate::table::{BUILDERS, FlBuilder};
use crate::*;

fn last_error() -> String {
    let mut buffer = [0_u8; 200];
    let mut length = 0;
    // SAFETY: the buffer has this many bytes.
    let status = unsafe { fl_last_error(buffer.as_mut_ptr().cast(), buffer.len(), &mut length) };
    assert_eq!(status, FlStatus::Ok);
    String::from_utf8(buffer[..length].to_vec()).expect("UTF-8")
}

#[test]
fn after_a_panic_a_handle_can_only_be_destroyed() {
    let builder: *mut FlBuilder = BUILDERS.insert(EngineBuilder::new()).expect("a handle");
    let other: *mut FlBuilder = BUILDERS.insert(EngineBuilder::new()).expect("a handle");
    let status = BUILDERS.call(builder, |_| panic!("for the test"));
    assert_eq!(status, FlStatus::Panicked);
    assert!(last_error().contains("for the test"), "{}", last_error());
    assert_eq!(fl_builder_add_pair(builder, 0, 1, 0), FlStatus::Panicked);
    assert_eq!(fl_builder_add_pair(other, 0, 1, 0), FlStatus::NoSuch);
    assert_eq!(fl_builder_destroy(builder), FlStatus::Ok);
    assert_eq!(fl_builder_destroy(builder), FlStatus::BadHandle);
    assert_eq!(fl_builder_destroy(other), FlStatus::Ok);
}

#[test]
fn invalid_handles_are_refused() {
    let mut builder = ptr::null_mut();
    // SAFETY: room for a handle.
    assert_eq!(unsafe { fl_builder_new(&mut builder) }, FlStatus::Ok);
    let mut something = 0_u64;
    let engine: *mut FlEngine = builder.cast();
    for handle in [engine, (&raw mut something).cast(), ptr::without_provenance_mut(0x15)] {
        assert_eq!(fl_engine_step(handle, 0.1), FlStatus::BadHandle);
        assert_eq!(fl_engine_destroy(handle), FlStatus::BadHandle);
    }
    assert_eq!(fl_engine_step(ptr::null_mut(), 0.1), FlStatus::BadPointer);
    assert_eq!(fl_engine_destroy(ptr::null_mut()), FlStatus::Ok);
    assert_eq!(fl_builder_destroy(builder), FlStatus::Ok);
}

#[test]
fn a_text_that_does_not_fit_is_truncated_between_characters_and_its_length_reported() {
    let mut buffer = [0xff_u8; 6];
    let mut length = 0;
    let mut put = |capacity| {
        // SAFETY: the buffer has six bytes.
        let put =
            unsafe { border::put_text("grün", buffer.as_mut_ptr().cast(), capacity, &mut length) };
        (put.map_err(|failure| failure.status), buffer, length)
    };
    assert_eq!(put(4), (Err(FlStatus::BufferTooSmall), [b'g', b'r', 0, 0xff, 0xff, 0xff], 5));
    assert_eq!(put(6), (Ok(()), *b"gr\xc3\xbcn\0", 5));
    // SAFETY: only the length is written.
    let query = unsafe { border::put_text("grün", ptr::null_mut(), 0, &mut length) };
    assert_eq!((query.is_ok(), length), (true, 5));
}

#[test]
fn statuses_are_listed_in_their_order() {
    for status in FlStatus::ALL {
        assert_eq!(FlStatus::ALL[status as usize], status);
    }
}
