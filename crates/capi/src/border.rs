//! Reads and writes the memory of the program that calls the C interface. Everything is copied; the library keeps no
//! reference to the caller's memory.
//!
//! The caller's promise (the header's preamble) covers what cannot be checked: a pointer that is neither NULL nor
//! misaligned points to as much memory as its type, count or length requires, and nobody writes it during the call.

use core::ffi::c_char;
use core::mem::size_of;

use crate::failure::{FlStatus, Outcome, failure};
use crate::types::FL_NUL;

/// Longest name of a body, a material or a fender (bytes).
pub(crate) const LONGEST_NAME: usize = 1 << 10;
/// Longest path, and longest list of overrides (bytes).
pub(crate) const LONGEST_PATH: usize = 1 << 16;
/// Longest scenario (bytes).
pub(crate) const LONGEST_SCENARIO: usize = 16 << 20;

/// Refuses NULL and misaligned pointers.
pub(crate) fn check<T>(pointer: *const T, name: &str) -> Outcome {
    if pointer.is_null() {
        return failure(FlStatus::BadPointer, format_args!("`{name}` is NULL"));
    }
    if !pointer.is_aligned() {
        return failure(FlStatus::BadPointer, format_args!("`{name}` is not aligned"));
    }
    Ok(())
}

/// Copies a value in.
///
/// # Safety
/// The caller's promise.
pub(crate) unsafe fn read<T: Copy>(pointer: *const T, name: &str) -> Outcome<T> {
    check(pointer, name)?;
    // SAFETY: not NULL and aligned by the check; the caller promises a T there, and all types that C passes
    // consist of numbers, for which any bytes are valid.
    Ok(unsafe { pointer.read() })
}

/// Copies a value out.
///
/// # Safety
/// The caller's promise.
pub(crate) unsafe fn write<T: Copy>(pointer: *mut T, value: T, name: &str) -> Outcome {
    check(pointer, name)?;
    // SAFETY: not NULL and aligned by the check; the caller promises room for a T.
    unsafe { pointer.write(value) };
    Ok(())
}

/// Copies a structure from the caller. The structure's first member is the structure's size.
///
/// # Safety
/// The caller promises (see the top of this file) that the whole structure is readable, or, if the member `size` is
/// wrong, that this member is readable.
pub(crate) unsafe fn read_sized<T: Copy>(pointer: *const T, name: &str) -> Outcome<T> {
    check_size(pointer, name)?;
    // SAFETY: as the caller promises; by its size the whole structure is there.
    unsafe { read(pointer, name) }
}

/// Refuses a structure whose member `size` is wrong.
pub(crate) fn check_size<T>(pointer: *const T, name: &str) -> Outcome {
    check(pointer, name)?;
    // SAFETY: not NULL and aligned by the check; such structures begin with a `size_t`, as the caller
    // promises.
    let size = unsafe { pointer.cast::<usize>().read() };
    if size != size_of::<T>() {
        let own = size_of::<T>();
        return failure(FlStatus::BadSize, format_args!("`{name}->size` is {size}, not {own}"));
    }
    Ok(())
}

/// Copies `count` values from the caller and converts each value. With a `count` of 0 the pointer may be NULL.
///
/// # Safety
/// The caller promises that `count` values are readable; `count` must have been checked against a limit before.
pub(crate) unsafe fn read_all<T: Copy, U>(
    pointer: *const T,
    count: usize,
    name: &str,
    convert: impl Fn(T) -> U,
    into: &mut Vec<U>,
) -> Outcome {
    into.clear();
    if count == 0 {
        return Ok(());
    }
    check(pointer, name)?;
    // SAFETY: not NULL and aligned; within the `count` values that the caller promises.
    into.extend((0..count).map(|index| convert(unsafe { pointer.add(index).read() })));
    Ok(())
}

/// Converts values and copies them to the caller.
///
/// # Safety
/// The caller promises that the pointer has room for all `values`.
pub(crate) unsafe fn write_all<T: Copy, U: Copy>(
    pointer: *mut T,
    values: &[U],
    name: &str,
    convert: impl Fn(U) -> T,
) -> Outcome {
    if values.is_empty() {
        return Ok(());
    }
    check(pointer, name)?;
    for (index, &value) in values.iter().enumerate() {
        // SAFETY: not NULL and aligned; within the room that the caller promises.
        unsafe { pointer.add(index).write(convert(value)) };
    }
    Ok(())
}

/// Reads the bytes of a text: the first `length` bytes, or all bytes up to the text's NUL.
///
/// # Safety
/// The caller promises that `length` bytes, or all bytes up to a NUL, are readable.
unsafe fn text_bytes(
    pointer: *const c_char,
    length: usize,
    longest: usize,
    name: &str,
) -> Outcome<Vec<u8>> {
    let too_long =
        || failure(FlStatus::BadText, format_args!("`{name}` is longer than {longest} bytes"));
    if length == 0 {
        return Ok(Vec::new());
    }
    check(pointer, name)?;
    let pointer = pointer.cast::<u8>();
    let mut bytes = Vec::new();
    if length != FL_NUL {
        if length > longest {
            return too_long();
        }
        // SAFETY: not NULL; the caller promises `length` bytes that nobody writes during the call.
        bytes.extend_from_slice(unsafe { core::slice::from_raw_parts(pointer, length) });
        return Ok(bytes);
    }
    for index in 0..=longest {
        // SAFETY: not NULL, and no NUL so far: the caller promises one further on.
        let byte = unsafe { pointer.add(index).read() };
        if byte == 0 {
            return Ok(bytes);
        }
        bytes.push(byte);
    }
    too_long()
}

/// Copies a text in.
///
/// # Safety
/// The caller promises that `length` bytes, or all bytes up to a NUL, are readable.
pub(crate) unsafe fn text(
    pointer: *const c_char,
    length: usize,
    longest: usize,
    name: &str,
) -> Outcome<String> {
    // SAFETY: as the caller promises.
    let bytes = unsafe { text_bytes(pointer, length, longest, name) }?;
    match String::from_utf8(bytes) {
        Ok(text) if text.contains('\0') => {
            failure(FlStatus::BadText, format_args!("`{name}` contains a NUL"))
        }
        Ok(text) => Ok(text),
        Err(error) => failure(FlStatus::BadText, format_args!("`{name}` is not UTF-8: {error}")),
    }
}

/// Copies bytes in.
///
/// # Safety
/// The caller promises that `length` bytes are readable.
pub(crate) unsafe fn bytes(pointer: *const u8, length: usize, name: &str) -> Outcome<Vec<u8>> {
    if length == 0 {
        return Ok(Vec::new());
    }
    check(pointer, name)?;
    if length > isize::MAX as usize {
        return failure(FlStatus::BadArgument, format_args!("`{name}` is too long"));
    }
    // SAFETY: not NULL; the caller promises `length` bytes that nobody writes during the call.
    Ok(unsafe { core::slice::from_raw_parts(pointer, length) }.to_vec())
}

/// Copies a text out, NUL-terminated: all of it, or as many whole characters as fit. `*length` gets the length of the
/// text without the NUL, unless `length` is NULL. A NULL buffer with a capacity of 0 only asks for the text's length.
///
/// # Safety
/// The caller promises room for `capacity` bytes.
pub(crate) unsafe fn put_text(
    text: &str,
    buffer: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> Outcome {
    let room = room(text.len() + 1, buffer.cast(), capacity, "buffer")?;
    if !length.is_null() {
        // SAFETY: the caller promises room for a `size_t` where the pointer is not NULL.
        unsafe { write(length, text.len(), "length") }?;
    }
    if capacity > 0 {
        let end = text.floor_char_boundary(capacity - 1);
        let buffer = buffer.cast::<u8>();
        // SAFETY: `end` bytes and a NUL are within the `capacity` bytes that the caller promises; the text is
        // the library's, so that the two do not overlap.
        unsafe {
            buffer.copy_from_nonoverlapping(text.as_ptr(), end);
            buffer.add(end).write(0);
        }
    }
    too_small(room, text.len() + 1, capacity)
}

/// Copies all bytes to the caller's buffer, or none if they do not fit; `length` gets the number of bytes. A NULL
/// buffer with a capacity of 0 only asks for the number of bytes.
///
/// # Safety
/// The caller promises room for `capacity` bytes.
pub(crate) unsafe fn put_bytes(
    bytes: &[u8],
    buffer: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> Outcome {
    let room = room(bytes.len(), buffer, capacity, "buffer")?;
    // SAFETY: the caller promises room for a `size_t`.
    unsafe { write(length, bytes.len(), "length") }?;
    if room == Room::Enough {
        // SAFETY: the bytes fit into the `capacity` that the caller promises; they are the library's, so that the
        // two do not overlap.
        unsafe { buffer.copy_from_nonoverlapping(bytes.as_ptr(), bytes.len()) };
    }
    too_small(room, bytes.len(), capacity)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Room {
    Enough,
    TooLittle,
    /// The caller gave no buffer and asks only for the length.
    Query,
}

fn room(needed: usize, buffer: *const u8, capacity: usize, name: &str) -> Outcome<Room> {
    if buffer.is_null() && capacity == 0 {
        return Ok(Room::Query);
    }
    check(buffer, name)?;
    Ok(if capacity >= needed { Room::Enough } else { Room::TooLittle })
}

fn too_small(room: Room, needed: usize, capacity: usize) -> Outcome {
    if room != Room::TooLittle {
        return Ok(());
    }
    let text = format_args!("the buffer has {capacity} bytes, but {needed} are needed");
    failure(FlStatus::BufferTooSmall, text)
}
