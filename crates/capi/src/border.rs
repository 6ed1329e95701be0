//! Reading and writing what C points to. Everything is copied: no reference to the caller's memory lives
//! longer than a line here.
//!
//! What no check can tell, the caller promises (the header's preamble): a pointer that is neither NULL nor
//! misaligned points to as much memory as its type, count or length says, which nobody else writes meanwhile.

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

/// Refuses NULL and what is not aligned.
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
    // SAFETY: not NULL and aligned by the check; the caller promises a T behind it, and all types that C
    // gives here are numbers, of which any bytes are one.
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

/// Copies a structure in whose first member is its size.
///
/// # Safety
/// The caller's promise, for the size alone if that is wrong.
pub(crate) unsafe fn read_sized<T: Copy>(pointer: *const T, name: &str) -> Outcome<T> {
    check_size(pointer, name)?;
    // SAFETY: as the caller promises; the size says that the whole structure is there.
    unsafe { read(pointer, name) }
}

/// Refuses a structure whose first member is not its size.
pub(crate) fn check_size<T>(pointer: *const T, name: &str) -> Outcome {
    check(pointer, name)?;
    // SAFETY: not NULL and aligned by the check; such structures begin with a `size_t`, that the caller
    // promises to be there.
    let size = unsafe { pointer.cast::<usize>().read() };
    if size != size_of::<T>() {
        let own = size_of::<T>();
        return failure(FlStatus::BadSize, format_args!("`{name}->size` is {size}, not {own}"));
    }
    Ok(())
}

/// Copies `count` values in, each turned by `turn`. None may be at NULL.
///
/// # Safety
/// The caller's promise for `count` values, which must have been held against a bound.
pub(crate) unsafe fn read_all<T: Copy, U>(
    pointer: *const T,
    count: usize,
    name: &str,
    turn: impl Fn(T) -> U,
    into: &mut Vec<U>,
) -> Outcome {
    into.clear();
    if count == 0 {
        return Ok(());
    }
    check(pointer, name)?;
    // SAFETY: not NULL and aligned; within the `count` values that the caller promises.
    into.extend((0..count).map(|index| turn(unsafe { pointer.add(index).read() })));
    Ok(())
}

/// Copies values out, each turned by `turn`, to room for as many.
///
/// # Safety
/// The caller's promise for as many values as `values` has.
pub(crate) unsafe fn write_all<T: Copy, U: Copy>(
    pointer: *mut T,
    values: &[U],
    name: &str,
    turn: impl Fn(U) -> T,
) -> Outcome {
    if values.is_empty() {
        return Ok(());
    }
    check(pointer, name)?;
    for (index, &value) in values.iter().enumerate() {
        // SAFETY: not NULL and aligned; within the room that the caller promises.
        unsafe { pointer.add(index).write(turn(value)) };
    }
    Ok(())
}

/// The bytes of a text: as many as `length` says, or to its NUL.
///
/// # Safety
/// The caller's promise for `length` bytes, or up to a NUL.
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
        // SAFETY: not NULL; the caller promises `length` bytes, which are not written meanwhile.
        bytes.extend_from_slice(unsafe { core::slice::from_raw_parts(pointer, length) });
        return Ok(bytes);
    }
    for index in 0..=longest {
        // SAFETY: not NULL, and no NUL yet: the caller promises one further on.
        let byte = unsafe { pointer.add(index).read() };
        if byte == 0 {
            return Ok(bytes);
        }
        bytes.push(byte);
    }
    too_long()
}

/// A text.
///
/// # Safety
/// The caller's promise for `length` bytes, or up to a NUL.
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
            failure(FlStatus::BadText, format_args!("`{name}` holds a NUL"))
        }
        Ok(text) => Ok(text),
        Err(error) => failure(FlStatus::BadText, format_args!("`{name}` is not UTF-8: {error}")),
    }
}

/// Any bytes.
///
/// # Safety
/// The caller's promise for `length` bytes.
pub(crate) unsafe fn bytes(pointer: *const u8, length: usize, name: &str) -> Outcome<Vec<u8>> {
    if length == 0 {
        return Ok(Vec::new());
    }
    check(pointer, name)?;
    if length > isize::MAX as usize {
        return failure(FlStatus::BadArgument, format_args!("`{name}` cannot be that long"));
    }
    // SAFETY: not NULL; the caller promises `length` bytes, which are not written meanwhile.
    Ok(unsafe { core::slice::from_raw_parts(pointer, length) }.to_vec())
}

/// Copies a text out with a NUL behind it: all of it, or as many whole characters as there is room for. NULL
/// and a capacity of 0 ask for the length alone, which goes to `length` where that is not NULL, without the
/// NUL.
///
/// # Safety
/// The caller's promise for `capacity` bytes.
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
        // SAFETY: `end` bytes and a NUL are within the `capacity` bytes that the caller promises; the text
        // is ours, so that the two do not overlap.
        unsafe {
            buffer.copy_from_nonoverlapping(text.as_ptr(), end);
            buffer.add(end).write(0);
        }
    }
    too_small(room, text.len() + 1, capacity)
}

/// Copies bytes out, all of them or none; `length` gets their number. NULL and a capacity of 0 ask for that
/// alone.
///
/// # Safety
/// The caller's promise for `capacity` bytes.
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
        // SAFETY: the bytes are no more than the `capacity` that the caller promises; they are ours, so that
        // the two do not overlap.
        unsafe { buffer.copy_from_nonoverlapping(bytes.as_ptr(), bytes.len()) };
    }
    too_small(room, bytes.len(), capacity)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Room {
    Enough,
    TooLittle,
    /// The length alone is asked for.
    NotAsked,
}

fn room(needed: usize, buffer: *const u8, capacity: usize, name: &str) -> Outcome<Room> {
    if buffer.is_null() && capacity == 0 {
        return Ok(Room::NotAsked);
    }
    check(buffer, name)?;
    Ok(if capacity >= needed { Room::Enough } else { Room::TooLittle })
}

fn too_small(room: Room, needed: usize, capacity: usize) -> Outcome {
    if room != Room::TooLittle {
        return Ok(());
    }
    let text = format_args!("the buffer has {capacity} bytes, {needed} are needed");
    failure(FlStatus::BufferTooSmall, text)
}
