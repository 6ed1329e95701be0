//! Writes the state of a [`CoSimHost`] as bytes and reads it back: in little-endian order, with a
//! version number and a checksum.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `fndrhost` |
//! | 4 | version |
//! | 4, 4 | delay in steps; integration method: 0 forward Euler, 1 semi-implicit |
//! | 4, 8 | number of past steps; length of the last step (s) |
//! | 4 + that many | length of the contacts' [`Memory::snapshot`], and its bytes |
//! | 236 each | bodies by key: input state, observed load, mass check, teleport mark (0, 1), lead (0, 1, fields) |
//! | 60 each | past steps, body by body: Δt, wrench, 1 or 0: load reported, and the reported load |
//! | 8 | FNV-1a hash of all bytes before |
//!
//! The bodies in the snapshot are in the order of their keys.

use alloc::vec::Vec;

use crate::admit::{LONGEST_STEP_S, SHORTEST_STEP_S};
use crate::error::RestoreError;
use crate::host::cosim::CoSimHost;
use crate::host::direct::{DirectHost, DirectRecord};
use crate::host::lead::Lead;
use crate::host::mass_check::Answers;
use crate::host::past_step::PastStep;
use crate::host::record::BodyRecord;
use crate::host::settings::{HostIntegration, HostSettings};
use crate::host::velocity::{Offset, Velocity};
use crate::model::Model;
use crate::state::bytes::{Reader, Record, Writer, check_sum, records};
use crate::state::memory::Memory;

const MAGIC: &[u8; 8] = b"fndrhost";
const DIRECT_MAGIC: &[u8; 8] = b"fndrpres";

records! {
    Velocity { linear_mps, yaw_radps }
    Offset { linear_m, rotation_rad }
    Lead { velocity, half_kick, offset, exact, due_s }
    Answers { began, impulse_ns, time_s, reported }
    BodyRecord { input, observed, answers, placed, ahead }
    PastStep { step_s, wrench, reported_load }
    DirectRecord { input, after, sum, wrench, ahead }
}

impl CoSimHost {
    /// Returns this host as bytes, in the version [`crate::SNAPSHOT_VERSION`]. `model` must be the model for which the
    /// host was made.
    ///
    /// # Panics
    /// Panics if `model` has another number of bodies.
    #[must_use]
    pub fn snapshot(&self, model: &Model) -> Vec<u8> {
        assert_eq!(
            self.bodies.len(),
            model.bodies().len(),
            "the host was made for a model with another number of bodies"
        );
        let mut out = Writer::new(MAGIC);
        out.put(self.settings.delay_steps);
        out.put(self.settings.integration == HostIntegration::SemiImplicit);
        out.put(self.past_step_count() as u32);
        out.put(self.last_step_s);
        put_memory(&mut out, &self.memory);
        in_order(model, &self.bodies).for_each(|body| out.put(body));
        for step in self.past_steps.chunks(self.bodies.len().max(1)) {
            in_order(model, step).for_each(|given| out.put(given));
        }
        out.sealed()
    }

    /// Restores a host that [`CoSimHost::snapshot`] saved, settings included, for the same model.
    ///
    /// # Errors
    /// Returns a [`RestoreError`] if the bytes are not a whole, unchanged snapshot for this model; the host is then
    /// unchanged.
    pub fn restore(&mut self, model: &Model, bytes: &[u8]) -> Result<(), RestoreError> {
        let mut input = open(bytes, MAGIC)?;
        let delay_steps = input.get();
        let integration = match input.get() {
            true => HostIntegration::SemiImplicit,
            false => HostIntegration::ForwardEuler,
        };
        let mut host = CoSimHost::new(model, HostSettings { delay_steps, integration });
        let steps: u32 = input.get();
        host.last_step_s = input.get();
        host.memory = get_memory(&mut input, model)?;
        let count = model.ranked.len();
        let of_body = BodyRecord::byte_count() + u128::from(steps) * PastStep::byte_count();
        input.check_left(count as u128 * of_body)?;
        if u64::from(steps) > u64::from(delay_steps) + 1 || (count == 0 && steps > 0) {
            return Err(RestoreError::Content);
        }
        for id in &model.id_of {
            host.bodies[id.0 as usize] = input.get();
        }
        host.past_steps.resize(steps as usize * count, PastStep::default());
        for step in host.past_steps.chunks_mut(count.max(1)) {
            for id in &model.id_of {
                step[id.0 as usize] = input.get();
            }
        }
        input.outcome()?;
        let steps_s = host.past_steps.iter().map(|given| given.step_s).chain([host.last_step_s]);
        check_steps(steps_s)?;
        *self = host;
        Ok(())
    }
}

/// | bytes | content |
/// |---|---|
/// | 8 | `fndrpres` |
/// | 4, 8 | version; length of the last step (s) |
/// | 4 + that many | length and bytes of the contacts' [`Memory::snapshot`] |
/// | 232 each | bodies by key: input state, engine's state after the step, wrench + load, wrench, lead |
/// | 8 | FNV-1a of all before |
impl DirectHost {
    /// Returns this host as bytes, in the version [`crate::SNAPSHOT_VERSION`]. `model` must be the model for which the
    /// host was made.
    ///
    /// # Panics
    /// Panics if `model` has another number of bodies.
    #[must_use]
    pub fn snapshot(&self, model: &Model) -> Vec<u8> {
        assert_eq!(
            self.bodies.len(),
            model.bodies().len(),
            "the host was made for a model with another number of bodies"
        );
        let mut out = Writer::new(DIRECT_MAGIC);
        out.put(self.last_step_s);
        put_memory(&mut out, &self.memory);
        in_order(model, &self.bodies).for_each(|body| out.put(body));
        out.sealed()
    }

    /// Restores a host that [`DirectHost::snapshot`] saved, for the same model.
    ///
    /// # Errors
    /// Returns a [`RestoreError`] if the bytes are not a whole, unchanged snapshot for this model; the host is then
    /// unchanged.
    pub fn restore(&mut self, model: &Model, bytes: &[u8]) -> Result<(), RestoreError> {
        let mut input = open(bytes, DIRECT_MAGIC)?;
        let mut host = DirectHost::new(model);
        host.last_step_s = input.get();
        host.memory = get_memory(&mut input, model)?;
        input.check_left(model.ranked.len() as u128 * DirectRecord::byte_count())?;
        for id in &model.id_of {
            host.bodies[id.0 as usize] = input.get();
        }
        input.outcome()?;
        check_steps([host.last_step_s])?;
        *self = host;
        Ok(())
    }
}

/// The records of all bodies, in the order of the bodies' keys.
fn in_order<R: Copy>(model: &Model, by_id: &[R]) -> impl Iterator<Item = R> {
    model.id_of.iter().map(|id| by_id[id.0 as usize])
}

/// Checks magic number, version and checksum of a snapshot, and returns the bytes after magic and version.
fn open<'b>(bytes: &'b [u8], magic: &[u8; 8]) -> Result<Reader<'b>, RestoreError> {
    let input = Reader::open(bytes, magic)?;
    check_sum(bytes)?;
    Ok(input)
}

fn put_memory(out: &mut Writer, memory: &Memory) {
    let bytes = memory.snapshot();
    out.put(bytes.len() as u32);
    out.bytes(&bytes);
}

fn get_memory(input: &mut Reader<'_>, model: &Model) -> Result<Memory, RestoreError> {
    let length: u32 = input.get();
    input.outcome()?;
    let mut memory = Memory::new(model);
    memory.restore(model, input.bytes(length as usize)?)?;
    Ok(memory)
}

/// Checks that the lengths of past steps in a snapshot are possible. The length 0 stands for a pause, or for no step
/// yet.
fn check_steps(steps_s: impl IntoIterator<Item = f64>) -> Result<(), RestoreError> {
    let is_step = |s: f64| s == 0.0 || (SHORTEST_STEP_S..=LONGEST_STEP_S).contains(&s);
    if steps_s.into_iter().all(is_step) { Ok(()) } else { Err(RestoreError::Content) }
}
