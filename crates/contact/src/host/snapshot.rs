//! Hosts as bytes: versioned, little-endian, with a checksum. A co-simulation host:
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `fndrhost` |
//! | 4 | version |
//! | 4, 4 | delay in steps; integration: 0 forward Euler, 1 semi-implicit |
//! | 4, 8 | number of past steps; length of the last step |
//! | 4 + that many | length and bytes of the contacts' [`Memory::snapshot`] |
//! | 236 each | bodies: input state, observed load, answers, 1 or 0: teleported, 1 or 0 and lead: velocity, half kick, offset, 1 or 0, time |
//! | 60 each | past steps, body by body: Δt, wrench, 1 or 0 and reported load |
//! | 8 | FNV-1a of all before |
//!
//! Bodies are in the order of their keys.

use alloc::vec::Vec;

use crate::admit::{LONGEST_STEP_S, SHORTEST_STEP_S};
use crate::error::RestoreError;
use crate::hash::Fnv1a;
use crate::host::cosim::CoSimHost;
use crate::host::direct::{DirectHost, DirectRecord};
use crate::host::lead::Lead;
use crate::host::mass_check::Answers;
use crate::host::past_step::PastStep;
use crate::host::record::BodyRecord;
use crate::host::settings::{HostIntegration, HostSettings};
use crate::host::velocity::{Offset, Velocity};
use crate::memory::Memory;
use crate::model::Model;
use crate::report::Wrench;
use crate::snapshot::{Reader, SNAPSHOT_VERSION, Writer};

const MAGIC: &[u8; 8] = b"fndrhost";
const PRESENT_MAGIC: &[u8; 8] = b"fndrpres";
/// Two states, two wrenches and a lead.
const RECORD_BYTES: usize = 2 * 48 + 2 * 24 + LEAD_BYTES;
const LEAD_BYTES: usize = 88;
const BODY_BYTES: usize = 236;
const PAST_STEP_BYTES: usize = 60;

impl CoSimHost {
    /// All of this host as bytes, of the version [`SNAPSHOT_VERSION`]. `model` is the one that it was
    /// built for.
    ///
    /// # Panics
    /// If `model` has another number of bodies.
    #[must_use]
    pub fn snapshot(&self, model: &Model) -> Vec<u8> {
        assert_eq!(self.bodies.len(), model.bodies().len(), "the model that the host was made for");
        let memory = self.memory.snapshot();
        let size =
            memory.len() + self.bodies.len() * BODY_BYTES + self.past_steps.len() * PAST_STEP_BYTES;
        let mut out = Writer(Vec::with_capacity(size + 40));
        out.0.extend_from_slice(MAGIC);
        out.word32(SNAPSHOT_VERSION);
        out.word32(self.settings.delay_steps);
        out.word32(match self.settings.integration {
            HostIntegration::ForwardEuler => 0,
            HostIntegration::SemiImplicit => 1,
        });
        out.word32(self.past_step_count() as u32);
        out.number(self.last_step_s);
        out.word32(memory.len() as u32);
        out.0.extend_from_slice(&memory);
        for id in &model.id_of {
            write_body(&mut out, &self.bodies[id.0 as usize]);
        }
        for step in self.past_steps.chunks(self.bodies.len().max(1)) {
            for id in &model.id_of {
                write_past_step(&mut out, &step[id.0 as usize]);
            }
        }
        let mut sum = Fnv1a::default();
        sum.bytes(&out.0);
        out.word64(sum.finish());
        out.0
    }

    /// Becomes what [`CoSimHost::snapshot`] saved, settings included, for the same model.
    ///
    /// # Errors
    /// [`RestoreError`] for bytes that are not a whole, unchanged snapshot of this model; the host is
    /// then unchanged.
    pub fn restore(&mut self, model: &Model, bytes: &[u8]) -> Result<(), RestoreError> {
        *self = read(model, bytes)?;
        Ok(())
    }
}

fn read(model: &Model, bytes: &[u8]) -> Result<CoSimHost, RestoreError> {
    let mut input = open(bytes, MAGIC)?;
    let delay_steps = input.word32()?;
    let integration = match input.word32()? {
        0 => HostIntegration::ForwardEuler,
        1 => HostIntegration::SemiImplicit,
        _ => return Err(RestoreError::Content),
    };
    let mut host = CoSimHost::new(model, HostSettings { delay_steps, integration });
    let steps = input.word32()?;
    host.last_step_s = read_step(&mut input)?;
    host.memory = read_memory(&mut input, model)?;
    let count = model.ranked.len();
    let rest =
        count as u128 * (BODY_BYTES as u128 + u128::from(steps) * PAST_STEP_BYTES as u128) + 8;
    if input.0.len() as u128 != rest {
        return Err(RestoreError::Length);
    }
    if u64::from(steps) > u64::from(delay_steps) + 1 || (count == 0 && steps > 0) {
        return Err(RestoreError::Content);
    }
    for id in &model.id_of {
        host.bodies[id.0 as usize] = read_body(&mut input)?;
    }
    for step in 0..steps as usize {
        // Any value: all of the step's are overwritten.
        let empty = PastStep { step_s: 0.0, wrench: Wrench::default(), reported_load: None };
        host.past_steps.resize((step + 1) * count, empty);
        for id in &model.id_of {
            host.past_steps[step * count + id.0 as usize] = read_past_step(&mut input)?;
        }
    }
    Ok(host)
}

/// | bytes | content |
/// |---|---|
/// | 8 | `fndrpres` |
/// | 4, 8 | version; length of the last step |
/// | 4 + that many | length and bytes of the contacts' [`Memory::snapshot`] |
/// | 232 each | bodies, in the order of their keys: input state, state after, wrench and load, wrench, lead |
/// | 8 | FNV-1a of all before |
impl DirectHost {
    /// All of this host as bytes, of the version [`SNAPSHOT_VERSION`]. `model` is the one that it was
    /// built for.
    ///
    /// # Panics
    /// If `model` has another number of bodies.
    #[must_use]
    pub fn snapshot(&self, model: &Model) -> Vec<u8> {
        assert_eq!(self.bodies.len(), model.bodies().len(), "the model that the host was made for");
        let memory = self.memory.snapshot();
        let mut out =
            Writer(Vec::with_capacity(memory.len() + self.bodies.len() * RECORD_BYTES + 32));
        out.0.extend_from_slice(PRESENT_MAGIC);
        out.word32(SNAPSHOT_VERSION);
        out.number(self.last_step_s);
        out.word32(memory.len() as u32);
        out.0.extend_from_slice(&memory);
        for id in &model.id_of {
            let body = &self.bodies[id.0 as usize];
            out.state(&body.input);
            out.state(&body.after);
            write_wrench(&mut out, &body.sum);
            write_wrench(&mut out, &body.wrench);
            write_lead(&mut out, body.ahead);
        }
        let mut sum = Fnv1a::default();
        sum.bytes(&out.0);
        out.word64(sum.finish());
        out.0
    }

    /// Becomes what [`DirectHost::snapshot`] saved, for the same model.
    ///
    /// # Errors
    /// [`RestoreError`] for bytes that are not a whole, unchanged snapshot of this model; the host is
    /// then unchanged.
    pub fn restore(&mut self, model: &Model, bytes: &[u8]) -> Result<(), RestoreError> {
        let mut input = open(bytes, PRESENT_MAGIC)?;
        let mut host = DirectHost::new(model);
        host.last_step_s = read_step(&mut input)?;
        host.memory = read_memory(&mut input, model)?;
        if input.0.len() as u128 != model.ranked.len() as u128 * RECORD_BYTES as u128 + 8 {
            return Err(RestoreError::Length);
        }
        for id in &model.id_of {
            host.bodies[id.0 as usize] = DirectRecord {
                input: input.state()?,
                after: input.state()?,
                sum: read_wrench(&mut input)?,
                wrench: read_wrench(&mut input)?,
                ahead: read_lead(&mut input)?,
            };
        }
        *self = host;
        Ok(())
    }
}

/// Checks magic, version and checksum; returns the bytes after them.
fn open<'b>(bytes: &'b [u8], magic: &[u8; 8]) -> Result<Reader<'b>, RestoreError> {
    let mut input = Reader(bytes);
    if input.take(8)? != magic {
        return Err(RestoreError::NotASnapshot);
    }
    let found = input.word32()?;
    if found != SNAPSHOT_VERSION {
        return Err(RestoreError::Version { found });
    }
    let (summed, sum) = bytes.split_at(bytes.len().checked_sub(8).ok_or(RestoreError::Length)?);
    let mut expected = Fnv1a::default();
    expected.bytes(summed);
    if sum != expected.finish().to_le_bytes() {
        return Err(RestoreError::Checksum);
    }
    Ok(input)
}

/// The length of the last step; 0 before the first.
fn read_step(input: &mut Reader<'_>) -> Result<f64, RestoreError> {
    let step_s = input.number()?;
    if step_s == 0.0 || is_step(step_s) { Ok(step_s) } else { Err(RestoreError::Content) }
}

fn read_memory(input: &mut Reader<'_>, model: &Model) -> Result<Memory, RestoreError> {
    let length = input.word32()? as usize;
    let mut memory = Memory::new(model);
    memory.restore(model, input.take(length)?)?;
    Ok(memory)
}

fn write_body(out: &mut Writer, body: &BodyRecord) {
    out.state(&body.input);
    write_wrench(out, &body.observed);
    write_answers(out, &body.answers);
    out.word32(u32::from(body.placed));
    write_lead(out, body.ahead);
}

fn write_answers(out: &mut Writer, answers: &Answers) {
    let (velocity, load_n) = answers.began.unwrap_or_default();
    out.word32(u32::from(answers.began.is_some()));
    write_velocity(out, velocity);
    out.vector(load_n);
    out.vector(answers.impulse_ns);
    out.number(answers.time_s);
    out.word32(u32::from(answers.reported));
}

fn read_answers(input: &mut Reader<'_>) -> Result<Answers, RestoreError> {
    let began = read_flag(input)?;
    let (velocity, load_n) = (read_velocity(input)?, input.vector()?);
    Ok(Answers {
        began: began.then_some((velocity, load_n)),
        impulse_ns: input.vector()?,
        time_s: input.number()?,
        reported: read_flag(input)?,
    })
}

fn write_lead(out: &mut Writer, ahead: Option<Lead>) {
    let lead = ahead.unwrap_or_default();
    out.word32(u32::from(ahead.is_some()));
    write_velocity(out, lead.velocity);
    write_velocity(out, lead.half_kick);
    out.vector(lead.offset.linear_m);
    out.number(lead.offset.rotation_rad);
    out.word32(u32::from(lead.exact));
    out.number(lead.due_s);
}

fn write_velocity(out: &mut Writer, velocity: Velocity) {
    out.vector(velocity.linear_mps);
    out.number(velocity.yaw_radps);
}

fn write_past_step(out: &mut Writer, step: &PastStep) {
    out.number(step.step_s);
    write_wrench(out, &step.wrench);
    out.word32(u32::from(step.reported_load.is_some()));
    write_wrench(out, &step.reported_load.unwrap_or_default());
}

fn write_wrench(out: &mut Writer, wrench: &Wrench) {
    out.vector(wrench.force_n);
    out.number(wrench.moment_nm);
}

fn read_body(input: &mut Reader<'_>) -> Result<BodyRecord, RestoreError> {
    let state = input.state()?;
    let observed = read_wrench(input)?;
    let answers = read_answers(input)?;
    let placed = read_flag(input)?;
    Ok(BodyRecord { input: state, observed, answers, placed, ahead: read_lead(input)? })
}

fn read_lead(input: &mut Reader<'_>) -> Result<Option<Lead>, RestoreError> {
    let is_ahead = read_flag(input)?;
    let lead = Lead {
        velocity: read_velocity(input)?,
        half_kick: read_velocity(input)?,
        offset: Offset { linear_m: input.vector()?, rotation_rad: input.number()? },
        exact: read_flag(input)?,
        due_s: input.number()?,
    };
    Ok(is_ahead.then_some(lead))
}

fn read_velocity(input: &mut Reader<'_>) -> Result<Velocity, RestoreError> {
    Ok(Velocity { linear_mps: input.vector()?, yaw_radps: input.number()? })
}

fn is_step(step_s: f64) -> bool {
    (SHORTEST_STEP_S..=LONGEST_STEP_S).contains(&step_s)
}

fn read_past_step(input: &mut Reader<'_>) -> Result<PastStep, RestoreError> {
    let step_s = input.number()?;
    if step_s != 0.0 && !is_step(step_s) {
        return Err(RestoreError::Content);
    }
    let wrench = read_wrench(input)?;
    let was_reported = read_flag(input)?;
    let load = read_wrench(input)?;
    Ok(PastStep { step_s, wrench, reported_load: was_reported.then_some(load) })
}

fn read_wrench(input: &mut Reader<'_>) -> Result<Wrench, RestoreError> {
    Ok(Wrench { force_n: input.vector()?, moment_nm: input.number()? })
}

fn read_flag(input: &mut Reader<'_>) -> Result<bool, RestoreError> {
    match input.word32()? {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(RestoreError::Content),
    }
}
