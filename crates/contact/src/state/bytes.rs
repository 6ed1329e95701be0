//! Writes and reads snapshots as bytes, little-endian: a magic number, the version, the records, and the FNV-1a hash of
//! all bytes before.
//!
//! A [`Record`] lists its fields only once, both for writing and for reading.

use alloc::vec::Vec;

use crate::error::RestoreError;
use crate::maths::hash::Fnv1a;
use crate::maths::vec2::{Rotation, Vec2};
use crate::state::body_state::BodyState;
use crate::state::report::Wrench;

/// The version of the snapshots that this library writes and reads.
pub const SNAPSHOT_VERSION: u32 = 8;

/// Passes the numbers of a snapshot one after the other. A [`Writer`] appends the numbers to the bytes; a [`Reader`]
/// replaces the numbers by those from the bytes.
pub(crate) trait Codec {
    fn word(&mut self, word: &mut u32);
    fn number(&mut self, number: &mut f64);
    /// Notes that the record just read has an impossible value.
    fn refuse(&mut self);
}

/// A part of a snapshot, such as a number or the state of a body.
pub(crate) trait Record: Copy + Default {
    /// Passes all numbers of the record to the codec, in the order of the snapshot.
    fn code(&mut self, codec: &mut impl Codec);

    /// Number of bytes that the record takes in a snapshot.
    fn byte_count() -> u128 {
        let mut out = Writer(Vec::new());
        out.put(Self::default());
        out.0.len() as u128
    }
}

/// Makes records of structs. The fields of each struct are listed in the order of their bytes.
macro_rules! records {
    ($($record:ty { $($field:ident),* })*) => {
        $(impl $crate::state::bytes::Record for $record {
            fn code(&mut self, codec: &mut impl $crate::state::bytes::Codec) {
                $(self.$field.code(codec);)*
            }
        })*
    };
}
pub(crate) use records;

records! {
    Vec2 { x, y }
    Rotation { cos, sin }
    BodyState { position_m, heading_rad, velocity_mps, yaw_rate_radps }
    Wrench { force_n, moment_nm }
}

impl Record for u32 {
    fn code(&mut self, codec: &mut impl Codec) {
        codec.word(self);
    }
}

impl Record for f64 {
    fn code(&mut self, codec: &mut impl Codec) {
        codec.number(self);
    }
}

/// A `bool` is stored as a 32-bit word: 0 or 1.
impl Record for bool {
    fn code(&mut self, codec: &mut impl Codec) {
        let mut word = u32::from(*self);
        codec.word(&mut word);
        *self = word == 1;
        if word > 1 {
            codec.refuse();
        }
    }
}

/// An `Option` is stored as a `bool`, which says whether there is a record, and then the record. If the `Option` is
/// `None`, the bytes of the record may have any value.
impl<R: Record> Record for Option<R> {
    fn code(&mut self, codec: &mut impl Codec) {
        let (mut is_some, mut record) = (self.is_some(), self.unwrap_or_default());
        is_some.code(codec);
        record.code(codec);
        *self = is_some.then_some(record);
    }
}

impl<R: Record, S: Record> Record for (R, S) {
    fn code(&mut self, codec: &mut impl Codec) {
        self.0.code(codec);
        self.1.code(codec);
    }
}

impl Record for [f64; 3] {
    fn code(&mut self, codec: &mut impl Codec) {
        self.iter_mut().for_each(|number| codec.number(number));
    }
}

/// Writes a snapshot.
pub(crate) struct Writer(Vec<u8>);

impl Codec for Writer {
    fn word(&mut self, word: &mut u32) {
        self.bytes(&word.to_le_bytes());
    }

    fn number(&mut self, number: &mut f64) {
        self.bytes(&number.to_le_bytes());
    }

    fn refuse(&mut self) {}
}

impl Writer {
    /// Begins a snapshot.
    pub(crate) fn new(magic: &[u8; 8]) -> Writer {
        let mut out = Writer(magic.to_vec());
        out.put(SNAPSHOT_VERSION);
        out
    }

    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        self.0.extend_from_slice(bytes);
    }

    pub(crate) fn put(&mut self, mut record: impl Record) {
        record.code(self);
    }

    /// Returns the bytes of the snapshot with their checksum at the end.
    pub(crate) fn sealed(mut self) -> Vec<u8> {
        let sum = Fnv1a::of(&self.0);
        self.bytes(&sum.to_le_bytes());
        self.0
    }
}

/// Reads a snapshot. The reader keeps the first fault in the snapshot, and reads zeros after the fault.
pub(crate) struct Reader<'b> {
    rest: &'b [u8],
    outcome: Result<(), RestoreError>,
}

impl Codec for Reader<'_> {
    fn word(&mut self, word: &mut u32) {
        *word = u32::from_le_bytes(self.array());
    }

    /// Reads a number. A number in a snapshot must be finite, and small enough that the next step cannot overflow.
    fn number(&mut self, number: &mut f64) {
        *number = f64::from_le_bytes(self.array());
        let is_usable = number.abs() <= 1e30;
        if !is_usable {
            self.refuse();
            *number = 0.0;
        }
    }

    fn refuse(&mut self) {
        self.outcome = self.outcome.and(Err(RestoreError::Content));
    }
}

impl<'b> Reader<'b> {
    /// Checks magic and version. [`check_sum`] checks the checksum.
    pub(crate) fn open(bytes: &'b [u8], magic: &[u8; 8]) -> Result<Reader<'b>, RestoreError> {
        let mut input = Reader { rest: bytes, outcome: Ok(()) };
        let (found_magic, found) = (input.array::<8>(), input.get());
        input.outcome?;
        match found {
            _ if found_magic != *magic => Err(RestoreError::NotASnapshot),
            SNAPSHOT_VERSION => Ok(input),
            _ => Err(RestoreError::Version { found }),
        }
    }

    pub(crate) fn get<R: Record>(&mut self) -> R {
        let mut record = R::default();
        record.code(self);
        record
    }

    pub(crate) fn array<const N: usize>(&mut self) -> [u8; N] {
        let mut array = [0; N];
        array.copy_from_slice(self.bytes(N).unwrap_or(&[0; N]));
        array
    }

    /// Returns the next `count` bytes of the snapshot unchanged.
    pub(crate) fn bytes(&mut self, count: usize) -> Result<&'b [u8], RestoreError> {
        let Some((bytes, rest)) = self.rest.split_at_checked(count) else {
            self.outcome = self.outcome.and(Err(RestoreError::Length));
            return Err(RestoreError::Length);
        };
        self.rest = rest;
        Ok(bytes)
    }

    /// Returns the first fault that the reader found so far.
    pub(crate) fn outcome(&self) -> Result<(), RestoreError> {
        self.outcome
    }

    /// Checks that exactly `bytes` bytes and the checksum are left to read.
    pub(crate) fn check_left(&self, bytes: u128) -> Result<(), RestoreError> {
        if self.rest.len() as u128 == bytes + 8 { Ok(()) } else { Err(RestoreError::Length) }
    }
}

/// Checks the checksum at the end of a whole snapshot.
pub(crate) fn check_sum(snapshot: &[u8]) -> Result<(), RestoreError> {
    let (summed, sum) = snapshot.split_last_chunk().ok_or(RestoreError::Length)?;
    if *sum == Fnv1a::of(summed).to_le_bytes() { Ok(()) } else { Err(RestoreError::Checksum) }
}
