//! A dump: a model, a saved engine and the steps that followed, in one file that can be replayed to the same bits.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `fndrdump` |
//! | 4, 4 | version of the dump's format, then version of the format of the engine's snapshot in the dump |
//! | 4 + length | version of the library |
//! | … | the model (bodies, materials, fenders, pairs, initial states), then the settings |
//! | 4 + length | the saved engine before the first step |
//! | … | the entries: teleports, and steps with their states, loads, outcome and the hash of their results |
//! | 8 | FNV-1a hash of all bytes before it |

use std::collections::VecDeque;
use std::sync::Arc;

use fenderline_contact::hash::Fnv1a;
use fenderline_contact::{
    Body, BodyId, BodyState, Fender, FenderLaw, HostIntegration, HostSettings, Material,
    MaterialId, Mobility, Model, Outline, Pair, Panel, ReactionFactors, RestoreError,
    SNAPSHOT_VERSION, Stop, TensionChain, Unloading, Wrench,
};
use fenderline_sim::Method;

use crate::bytes::{Reader, Writer};
use crate::engine::{Engine, Plan};
use crate::error::EngineError;
use crate::recorded::digest;
use crate::recording::{DONE, MARK, REFUSED, STEP, UNFINISHED};
use crate::settings::{Host, MAX_DELAY_STEPS};
use crate::snapshot::settings_words;

const MAGIC: &[u8; 8] = b"fndrdump";
const VERSION: u32 = 1;
const NONE: u32 = u32::MAX;
const LIBRARY: &str = env!("CARGO_PKG_VERSION");

type Read<T> = Result<T, RestoreError>;

/// Whether the given bytes begin as a dump does.
#[must_use]
pub fn is_dump(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

impl Engine {
    /// Returns a dump: the recorded steps with all that is needed to replay them (see [`Engine::record`] and [`Dump`]).
    ///
    /// # Errors
    /// [`EngineError::NotRecorded`].
    pub fn dump(&self) -> Result<Vec<u8>, EngineError> {
        let (start, entries) = self.recording.as_ref().ok_or(EngineError::NotRecorded)?.parts();
        let mut out = Writer::default();
        out.0.extend_from_slice(MAGIC);
        out.word32(VERSION);
        out.word32(SNAPSHOT_VERSION);
        out.text(LIBRARY);
        write_plan(&mut out, &self.plan);
        out.word32(start.len() as u32);
        out.0.extend_from_slice(start);
        entries.into_iter().for_each(|bytes| out.0.extend_from_slice(bytes));
        let sum = Fnv1a::of(&out.0);
        out.word64(sum);
        Ok(out.0)
    }
}

/// A dump that was read, together with the engine that replays it.
#[derive(Clone, Debug)]
pub struct Dump {
    library: String,
    engine: Engine,
    entries: VecDeque<Entry>,
    steps: usize,
}

/// How a recorded step ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DumpedOutcome {
    /// The step was taken; holds the hash of the step's results.
    Done(u64),
    /// The step was refused with an error.
    Refused,
    /// The step did not end: the library panicked, or the process ended.
    Unfinished,
}

/// A recorded step that was replayed.
#[derive(Clone, Debug, PartialEq)]
pub struct DumpedStep {
    /// Length of the replayed step (s).
    pub step_s: f64,
    /// How the step had ended when it was recorded.
    pub outcome: DumpedOutcome,
    /// Error with which the replayed step ended, if it was refused.
    pub error: Option<EngineError>,
    /// Whether the replayed step ended like the recorded step, with the same bits in all results.
    pub is_same: bool,
}

#[derive(Clone, Debug)]
enum Entry {
    Mark(usize),
    Step {
        step_s: f64,
        states: Vec<(BodyState, bool)>,
        loads: Option<Vec<Wrench>>,
        outcome: DumpedOutcome,
    },
}

impl Dump {
    /// Reads a dump. Any bytes may be given: bytes that are not a dump are refused.
    ///
    /// # Errors
    /// Fails for bytes that are not a complete, unchanged dump of a version that this library reads.
    pub fn read(bytes: &[u8]) -> Result<Dump, EngineError> {
        let mut input = Reader { rest: bytes, bodies: 0, fenders: 0 };
        let dump = EngineError::Dump;
        if !is_dump(bytes) {
            return Err(dump(RestoreError::NotASnapshot));
        }
        let end = bytes.len().checked_sub(8).ok_or(dump(RestoreError::Length))?;
        let (summed, sum) = bytes.split_at(end);
        if sum != Fnv1a::of(summed).to_le_bytes() {
            return Err(dump(RestoreError::Checksum));
        }
        input.rest = &summed[8..];
        let found = input.word32().map_err(dump)?;
        if found != VERSION {
            return Err(dump(RestoreError::Version { found }));
        }
        let snapshot = input.word32().map_err(dump)?;
        let library = input.text().map_err(dump)?;
        if snapshot != SNAPSHOT_VERSION {
            return Err(EngineError::DumpVersion { library });
        }
        let plan = read_plan(&mut input).map_err(dump)?;
        (input.bodies, input.fenders) = (plan.model.bodies().len(), plan.model.fenders().len());
        let mut engine = Engine::new(Arc::new(plan));
        let length = input.word32().map_err(dump)? as usize;
        let start = input.take(length).map_err(dump)?;
        engine.restore(start).map_err(|error| match error {
            EngineError::Restore(error) => dump(error),
            other => other,
        })?;
        let mut entries = VecDeque::new();
        while !input.rest.is_empty() {
            entries.push_back(read_entry(&mut input).map_err(dump)?);
        }
        let steps = entries.iter().filter(|entry| matches!(entry, Entry::Step { .. })).count();
        Ok(Dump { library, engine, entries, steps })
    }

    /// The version of the library that wrote the dump.
    #[must_use]
    pub fn library_version(&self) -> &str {
        &self.library
    }

    /// The engine of the dump: before the first step, or after the last step that [`Dump::next_step`] took.
    #[must_use]
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Takes the engine out of the dump, to continue after the replayed steps.
    #[must_use]
    pub fn into_engine(self) -> Engine {
        self.engine
    }

    /// Number of steps in the whole dump.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Whether the next step of the dump did not end when it was recorded. The replay of a step that did not end may
    /// panic.
    #[must_use]
    pub fn next_is_unfinished(&self) -> bool {
        let step = self.entries.iter().find_map(|entry| match entry {
            Entry::Step { outcome, .. } => Some(*outcome),
            Entry::Mark(_) => None,
        });
        step == Some(DumpedOutcome::Unfinished)
    }

    /// Takes the next step of the dump; `None` at the end of the dump.
    pub fn next_step(&mut self) -> Option<DumpedStep> {
        loop {
            match self.entries.pop_front()? {
                Entry::Mark(body) => {
                    // The index was checked when the dump was read.
                    let _ = self.engine.mark_teleported(body);
                }
                Entry::Step { step_s, states, loads, outcome } => {
                    let error = self.engine.replay_step(&states, loads, step_s).err();
                    let again = match (&error, self.engine.results()) {
                        (None, Ok(results)) => DumpedOutcome::Done(digest(&results)),
                        _ => DumpedOutcome::Refused,
                    };
                    let is_same = again == outcome;
                    return Some(DumpedStep { step_s, outcome, error, is_same });
                }
            }
        }
    }
}

impl Engine {
    /// Takes a step of the engine with its recorded input.
    fn replay_step(
        &mut self,
        states: &[(BodyState, bool)],
        loads: Option<Vec<Wrench>>,
        step_s: f64,
    ) -> Result<(), EngineError> {
        for (body, (state, is_set)) in states.iter().enumerate() {
            self.set_state(body, state)?;
            self.is_set[body] = *is_set;
        }
        self.set_loads(loads.as_deref())?;
        self.step(step_s)
    }
}

fn read_entry(input: &mut Reader<'_>) -> Read<Entry> {
    match input.word32()? {
        MARK => Ok(Entry::Mark(input.body()?.0 as usize)),
        STEP => {
            let step_s = f64::from_bits(input.word64()?);
            let bodies = input.bodies;
            let states: Read<Vec<_>> =
                (0..bodies).map(|_| Ok((input.state()?, input.flag()?))).collect();
            let states = states?;
            let loads = if input.flag()? {
                Some((0..bodies).map(|_| input.wrench()).collect::<Read<Vec<_>>>()?)
            } else {
                None
            };
            let outcome = match (input.word32()?, input.word64()?) {
                (DONE, digest) => DumpedOutcome::Done(digest),
                (REFUSED, 0) => DumpedOutcome::Refused,
                (UNFINISHED, 0) => DumpedOutcome::Unfinished,
                _ => return Err(RestoreError::Content),
            };
            Ok(Entry::Step { step_s, states, loads, outcome })
        }
        _ => Err(RestoreError::Content),
    }
}

fn write_plan(out: &mut Writer, plan: &Plan) {
    let model = &plan.model;
    out.text(&plan.title);
    out.list(model.bodies(), write_body);
    out.list(model.materials(), |out, m| {
        out.numbers(&[m.stiffness_npm2, m.damping_nspm2, m.shear_stiffness_npm]);
        out.numbers(&[m.friction_static, m.friction_dynamic, m.restitution]);
    });
    out.list(model.fenders(), write_fender);
    out.list(&plan.pairs, |out, pair| {
        pair.bodies.iter().for_each(|body| out.word32(body.0));
        out.word32(pair.material.0);
    });
    out.word32(plan.all_other_pairs.map_or(NONE, |material| material.0));
    out.list(&plan.initial, Writer::state);
    settings_words(plan).into_iter().for_each(|word| out.word32(word));
}

fn read_plan(input: &mut Reader<'_>) -> Read<Plan> {
    let title = input.text()?;
    let mut builder = Model::builder();
    for body in input.list(read_body)? {
        builder.body(body);
    }
    for material in input.list(read_material)? {
        builder.material(material);
    }
    for fender in input.list(read_fender)? {
        builder.fender(fender);
    }
    let pairs = input.list(|input| {
        let bodies = [BodyId(input.word32()?), BodyId(input.word32()?)];
        Ok(Pair { bodies, material: MaterialId(input.word32()?) })
    })?;
    pairs.iter().for_each(|pair| {
        builder.pair(*pair);
    });
    let all_other_pairs = match input.word32()? {
        NONE => None,
        index => Some(MaterialId(index)),
    };
    if let Some(material) = all_other_pairs {
        builder.all_other_pairs(material);
    }
    let model = builder.build().map_err(|_| RestoreError::Content)?;
    let initial = input.list(Reader::state)?;
    if initial.len() != model.bodies().len() {
        return Err(RestoreError::Content);
    }
    for (body, state) in initial.iter().enumerate() {
        model.check_state(body, state).map_err(|_| RestoreError::Content)?;
    }
    let method = match input.word32()? {
        0 => Method::Coupled,
        1 => Method::Paper,
        _ => return Err(RestoreError::Content),
    };
    let host = read_host(input, method)?;
    let notices = Vec::new();
    Ok(Plan { title, model, initial, method, host, notices, pairs, all_other_pairs })
}

fn read_host(input: &mut Reader<'_>, method: Method) -> Read<Host> {
    let (kind, delay_steps) = (input.word32()?, input.word32()?);
    let integration = match input.word32()? {
        0 => HostIntegration::ForwardEuler,
        1 => HostIntegration::SemiImplicit,
        _ => return Err(RestoreError::Content),
    };
    match kind {
        // The Coriolis terms are in the masses.
        0 => Ok(Host::Direct { coriolis: None }),
        1 if method == Method::Coupled && delay_steps <= MAX_DELAY_STEPS => {
            Ok(Host::CoSimulation(HostSettings { delay_steps, integration }))
        }
        _ => Err(RestoreError::Content),
    }
}

fn write_body(out: &mut Writer, body: &Body) {
    out.text(&body.name);
    out.word64(body.key);
    out.list(body.outline.vertices(), |out, vertex| out.vector(*vertex));
    match body.mobility {
        Mobility::Fixed => out.word32(0),
        Mobility::Free { mass_kg, yaw_inertia_kgm2 } => {
            out.word32(1);
            out.numbers(&[mass_kg, yaw_inertia_kgm2]);
        }
        Mobility::SurgeSway { surge_kg, sway_kg, yaw_inertia_kgm2 } => {
            out.word32(2);
            out.numbers(&[surge_kg, sway_kg, yaw_inertia_kgm2]);
        }
        Mobility::FullMatrix { matrix } => {
            out.word32(3);
            out.numbers(matrix.as_flattened());
        }
        Mobility::OnPile { .. } => unreachable!("an engine for hosts has no bodies on piles"),
    }
}

fn read_body(input: &mut Reader<'_>) -> Read<Body> {
    let (name, key) = (input.text()?, input.word64()?);
    let vertices = input.list(Reader::vector)?;
    let (outline, _) = Outline::new(&vertices).map_err(|_| RestoreError::Content)?;
    let mobility = match input.word32()? {
        0 => Mobility::Fixed,
        1 => {
            let [mass_kg, yaw_inertia_kgm2] = input.numbers()?;
            Mobility::Free { mass_kg, yaw_inertia_kgm2 }
        }
        2 => {
            let [surge_kg, sway_kg, yaw_inertia_kgm2] = input.numbers()?;
            Mobility::SurgeSway { surge_kg, sway_kg, yaw_inertia_kgm2 }
        }
        3 => {
            let matrix = [input.numbers()?, input.numbers()?, input.numbers()?];
            Mobility::FullMatrix { matrix }
        }
        _ => return Err(RestoreError::Content),
    };
    Ok(Body { name, key, outline, mobility })
}

fn read_material(input: &mut Reader<'_>) -> Read<Material> {
    let [stiffness_npm2, damping_nspm2, shear_stiffness_npm] = input.numbers()?;
    let [friction_static, friction_dynamic, restitution] = input.numbers()?;
    Ok(Material {
        stiffness_npm2,
        damping_nspm2,
        shear_stiffness_npm,
        friction_static,
        friction_dynamic,
        restitution,
    })
}

fn write_points(out: &mut Writer, points: &[[f64; 2]]) {
    out.list(points, |out, point| out.numbers(point));
}

fn read_points(input: &mut Reader<'_>) -> Read<Vec<[f64; 2]>> {
    input.list(Reader::numbers)
}

fn write_fender(out: &mut Writer, fender: &Fender) {
    out.text(&fender.name);
    out.word64(fender.key);
    out.word32(fender.body.0);
    out.vector(fender.position_m);
    out.numbers(&[fender.facing_rad, fender.width_m, fender.projection_m]);
    match &fender.law {
        FenderLaw::Area => out.word32(0),
        FenderLaw::Curve(points) => {
            out.word32(1);
            write_points(out, points);
        }
    }
    match &fender.unloading {
        None => out.word32(0),
        Some(Unloading::ReturnedEnergy(share)) => {
            out.word32(1);
            out.numbers(&[*share]);
        }
        Some(Unloading::Curve(points)) => {
            out.word32(2);
            write_points(out, points);
        }
    }
    out.word32(fender.material.0);
    out.numbers(&[fender.rated_deflection_m]);
    out.word32(u32::from(fender.stop.is_some()));
    fender.stop.iter().for_each(|stop| out.numbers(&[stop.from_m, stop.stiffness_npm]));
    out.numbers(&[fender.factors.constant]);
    write_points(out, &fender.factors.by_compression_time);
    write_points(out, &fender.factors.by_angle);
    out.word32(u32::from(fender.panel.is_some()));
    if let Some(panel) = &fender.panel {
        out.list(&panel.cones_m, |out, cone_m| out.numbers(&[*cone_m]));
        out.list(&panel.tension_chains, |out, chain| {
            out.numbers(&[chain.at_m, chain.slack_m, chain.stiffness_npm, chain.break_load_n]);
        });
    }
}

fn read_fender(input: &mut Reader<'_>) -> Read<Fender> {
    let (name, key) = (input.text()?, input.word64()?);
    let (body, position_m) = (BodyId(input.word32()?), input.vector()?);
    let [facing_rad, width_m, projection_m] = input.numbers()?;
    let law = match input.word32()? {
        0 => FenderLaw::Area,
        1 => FenderLaw::Curve(read_points(input)?),
        _ => return Err(RestoreError::Content),
    };
    let unloading = match input.word32()? {
        0 => None,
        1 => Some(Unloading::ReturnedEnergy(input.number()?)),
        2 => Some(Unloading::Curve(read_points(input)?)),
        _ => return Err(RestoreError::Content),
    };
    let (material, rated_deflection_m) = (MaterialId(input.word32()?), input.number()?);
    let stop = if input.flag()? {
        let [from_m, stiffness_npm] = input.numbers()?;
        Some(Stop { from_m, stiffness_npm })
    } else {
        None
    };
    let factors = ReactionFactors {
        constant: input.number()?,
        by_compression_time: read_points(input)?,
        by_angle: read_points(input)?,
    };
    let panel = if input.flag()? {
        let cones_m = input.list(Reader::number)?;
        let tension_chains = input.list(|input| {
            let [at_m, slack_m, stiffness_npm] = input.numbers()?;
            // Infinite for a chain that does not part.
            let break_load_n = f64::from_bits(input.word64()?);
            Ok(TensionChain { at_m, slack_m, stiffness_npm, break_load_n })
        })?;
        Some(Panel { cones_m, tension_chains })
    } else {
        None
    };
    Ok(Fender {
        name,
        key,
        body,
        position_m,
        facing_rad,
        width_m,
        projection_m,
        law,
        unloading,
        material,
        rated_deflection_m,
        stop,
        factors,
        panel,
    })
}
