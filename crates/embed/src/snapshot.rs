//! A saved engine as bytes: versioned, little-endian, with a checksum.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `fndrmbed` |
//! | 4, 4 | version of the format of these bytes, then [`SNAPSHOT_VERSION`] of the contact engine's snapshot in them |
//! | 8 | FNV-1a hash of the names of bodies and fenders in their order, because the bytes that follow refer to them by index |
//! | 4, 4, 4, 4 | method; kind of host; age of the host's states in steps; the host's integration |
//! | 4 + length | length and bytes of the contact engine's own snapshot, which has the model's fingerprint |
//! | 52 each | for each body: its state; then 1 if the host has set the state, else 0 |
//! | 4 + 24 each | 1 if loads were set, else 0; then the loads |
//! | 4 + … | 1 if there are results, else 0; then the results |
//! | 8 | FNV-1a hash of all bytes before it |
//!
//! Results are saved too, so that a restored engine reports the results of the saved engine.

use fenderline_contact::hash::Fnv1a;
use fenderline_contact::{
    CoSimHost, HostIntegration, HostSettings, Memory, RestoreError, SNAPSHOT_VERSION,
};
use fenderline_sim::Method;

use crate::bytes::{Reader, Writer};
use crate::engine::{Core, Engine, Latest, Plan};
use crate::error::EngineError;
use crate::results::{Results, Saved};
use crate::settings::Host;

const MAGIC: &[u8; 8] = b"fndrmbed";
const VERSION: u32 = 4;

impl Engine {
    /// Saves as bytes all parts of this engine that steps change.
    #[must_use]
    pub fn save(&self) -> Vec<u8> {
        let plan = &*self.plan;
        let own = match &self.core {
            Core::Paper { memory, .. } => memory.snapshot(),
            Core::Direct { host, .. } => host.snapshot(&plan.model),
            Core::CoSimulation { host, .. } => host.snapshot(&plan.model),
        };
        let mut out = Writer::default();
        out.0.extend_from_slice(MAGIC);
        out.word32(VERSION);
        out.word32(SNAPSHOT_VERSION);
        out.word64(hash_of_names(plan));
        settings_words(plan).into_iter().for_each(|word| out.word32(word));
        out.word32(own.len() as u32);
        out.0.extend_from_slice(&own);
        for (state, &is_set) in self.states.iter().zip(&self.is_set) {
            out.state(state);
            out.word32(u32::from(is_set));
        }
        out.word32(u32::from(self.loads.is_some()));
        self.loads.iter().flatten().for_each(|load| out.wrench(load));
        match self.results() {
            Ok(results) => write_results(&mut out, &results),
            Err(_) => out.word32(0),
        }
        let sum = Fnv1a::of(&out.0);
        out.word64(sum);
        out.0
    }

    /// Restores an engine that [`Engine::save`] saved: an engine of the same model, with bodies and fenders in the same
    /// order, and with the same settings. Any bytes may be given to restore: bytes that are not a saved engine are
    /// refused.
    ///
    /// # Errors
    /// Fails for bytes that are not a complete, unchanged saved engine, or that were saved from another engine. After
    /// an error this engine is unchanged.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), EngineError> {
        let mut restored = self.clone();
        read(&mut restored, bytes)?;
        *self = restored;
        self.restart_recording();
        Ok(())
    }
}

fn read(engine: &mut Engine, bytes: &[u8]) -> Result<(), EngineError> {
    let plan = engine.plan.clone();
    let model = &plan.model;
    let mut input =
        Reader { rest: bytes, bodies: model.bodies().len(), fenders: model.fenders().len() };
    if input.take(8)? != MAGIC {
        return Err(RestoreError::NotASnapshot.into());
    }
    for known in [VERSION, SNAPSHOT_VERSION] {
        let found = input.word32()?;
        if found != known {
            return Err(RestoreError::Version { found }.into());
        }
    }
    let end = bytes.len().checked_sub(8).ok_or(RestoreError::Length)?;
    let (summed, sum) = bytes.split_at(end);
    if sum != Fnv1a::of(summed).to_le_bytes() {
        return Err(RestoreError::Checksum.into());
    }
    if input.word64()? != hash_of_names(&plan) {
        return Err(RestoreError::OtherModel.into());
    }
    for own in settings_words(&plan) {
        if input.word32()? != own {
            return Err(EngineError::OtherSettings);
        }
    }
    let length = input.word32()? as usize;
    let own = input.take(length)?;
    match &mut engine.core {
        Core::Paper { memory, .. } => *memory = restored_memory(&plan, own)?,
        Core::Direct { host, .. } => host.restore(model, own)?,
        Core::CoSimulation { host, .. } => *host = restored_host(&plan, host.settings(), own)?,
    }
    for body in 0..input.bodies {
        let state = input.state()?;
        model.check_state(body, &state).map_err(|_| RestoreError::Content)?;
        engine.states[body] = state;
        engine.is_set[body] = input.flag()?;
    }
    engine.loads = None;
    if input.flag()? {
        if plan.method == Method::Paper {
            return Err(RestoreError::Content.into());
        }
        let loads: Result<Vec<_>, _> = (0..input.bodies).map(|_| input.wrench()).collect();
        let loads = loads?;
        for (body, load) in loads.iter().enumerate() {
            model.check_load(body, load).map_err(|_| RestoreError::Content)?;
        }
        engine.loads = Some(loads);
    }
    engine.latest = if input.flag()? {
        Latest::Saved(Box::new(read_results(&mut input, &plan)?))
    } else {
        Latest::Nowhere
    };
    if input.rest.len() != 8 {
        return Err(RestoreError::Length.into());
    }
    Ok(())
}

fn restored_memory(plan: &Plan, bytes: &[u8]) -> Result<Memory, RestoreError> {
    let mut memory = Memory::new(&plan.model);
    memory.restore(&plan.model, bytes)?;
    Ok(memory)
}

fn restored_host(
    plan: &Plan,
    settings: HostSettings,
    bytes: &[u8],
) -> Result<CoSimHost, RestoreError> {
    let mut host = CoSimHost::new(&plan.model, settings);
    host.restore(&plan.model, bytes)?;
    // The bytes hold the settings twice: within the host's snapshot and outside.
    if host.settings() == settings { Ok(host) } else { Err(RestoreError::Content) }
}

/// A hash of the names of a model's bodies and fenders in their order, on which the model's fingerprint does not
/// depend.
fn hash_of_names(plan: &Plan) -> u64 {
    let mut out = Writer::default();
    let bodies = plan.model.bodies().iter().map(|body| &body.name);
    let fenders = plan.model.fenders().iter().map(|fender| &fender.name);
    out.word32(plan.model.bodies().len() as u32);
    for name in bodies.chain(fenders) {
        out.word32(name.len() as u32);
        out.0.extend_from_slice(name.as_bytes());
    }
    Fnv1a::of(&out.0)
}

/// The engine's settings as words, without the setting of the Coriolis terms, which the model's fingerprint includes.
pub(crate) fn settings_words(plan: &Plan) -> [u32; 4] {
    let method = match plan.method {
        Method::Coupled => 0,
        Method::Paper => 1,
    };
    let (kind, host) = match plan.host {
        Host::Direct { .. } => (0, HostSettings::default()),
        Host::CoSimulation(settings) => (1, settings),
    };
    let integration = match host.integration {
        HostIntegration::ForwardEuler => 0,
        HostIntegration::SemiImplicit => 1,
    };
    [method, kind, host.delay_steps, integration]
}

pub(crate) fn write_results(out: &mut Writer, results: &Results<'_>) {
    out.word32(1);
    results.wrenches.iter().chain(results.peak_wrenches).for_each(|wrench| out.wrench(wrench));
    out.word32(results.contacts.len() as u32);
    results.contacts.iter().for_each(|contact| out.contact(contact));
    out.list(results.panels, Writer::panel);
    out.word32(results.events.len() as u32);
    results.events.iter().for_each(|event| out.event(event));
    results.states_after.iter().for_each(|state| out.state(state));
    if let Some(host_estimate) = results.host_estimate {
        host_estimate.states.iter().for_each(|state| out.state(state));
        host_estimate.loads.iter().for_each(|load| out.wrench(load));
    }
}

/// Reads saved results; the engine's settings decide which results exist.
fn read_results(input: &mut Reader<'_>, plan: &Plan) -> Result<Saved, RestoreError> {
    let bodies = input.bodies;
    let mut saved = Saved {
        wrenches: (0..bodies).map(|_| input.wrench()).collect::<Result<_, _>>()?,
        peak_wrenches: (0..bodies).map(|_| input.wrench()).collect::<Result<_, _>>()?,
        contacts: input.list(Reader::contact)?,
        panels: input.list(Reader::panel)?,
        events: input.list(Reader::event)?,
        ..Saved::default()
    };
    match plan.host {
        Host::Direct { .. } if plan.method == Method::Coupled => {
            saved.states_after = (0..bodies).map(|_| input.state()).collect::<Result<_, _>>()?;
        }
        Host::Direct { .. } => {}
        Host::CoSimulation(_) => {
            let states = (0..bodies).map(|_| input.state()).collect::<Result<_, _>>()?;
            let loads = (0..bodies).map(|_| input.wrench()).collect::<Result<_, _>>()?;
            saved.host_estimate = Some((states, loads));
        }
    }
    Ok(saved)
}
