//! Fuzzes the replay of an engine's dump with any bytes: either an error, or steps that are replayed to an end without
//! a panic. An engine that a dump gives can be saved and restored.
#![no_main]

use std::sync::LazyLock;

use fenderline_contact::hash::Fnv1a;
use fenderline_contact::{HostIntegration, HostSettings, Material, vec2};
use fenderline_embed::{BodyDef, Dump, Engine, EngineBuilder, EngineError, Host, Settings};
use fenderline_fuzz::input::Input;
use fenderline_sim::{MassProperties, Method};
use libfuzzer_sys::fuzz_target;

/// Real dumps, one for each kind of method and host.
static DUMPS: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| {
    let co_simulation = HostSettings { delay_steps: 1, integration: HostIntegration::SemiImplicit };
    let settings = [
        Settings::default(),
        Settings { method: Some(Method::Paper), ..Settings::default() },
        Settings { host: Host::CoSimulation(co_simulation), ..Settings::default() },
    ];
    settings.iter().map(|settings| dump(settings).expect("a good scene")).collect()
});

fuzz_target!(|bytes: &[u8]| {
    let mut input = Input::new(bytes);
    let (mode, which) = (input.byte() % 4, usize::from(input.byte()) % DUMPS.len());
    let real = &DUMPS[which];
    let claimed = match mode {
        0 => input.rest().to_vec(),
        1 => mutated(real, input),
        2 => with_check_sum(mutated(real, input)),
        _ => with_check_sum([&real[..16], input.rest(), &[0; 8]].concat()),
    };
    let Ok(mut dump) = Dump::read(&claimed) else { return };
    let mut steps = 0;
    while dump.next_step().is_some() {
        steps += 1;
    }
    assert_eq!(steps, dump.steps());
    let mut engine = dump.into_engine();
    let saved = engine.save();
    engine.restore(&saved).expect("its own bytes");
    assert_eq!(engine.save(), saved, "a restored engine saves the same bytes as before");
});

/// Overwrites bytes. Each overwritten byte takes three bytes of the input: two for its place and one for its value.
fn mutated(real: &[u8], mut input: Input<'_>) -> Vec<u8> {
    let mut bytes = real.to_vec();
    while !input.is_empty() {
        let place = usize::from(input.word()) % bytes.len();
        bytes[place] = input.byte();
    }
    bytes
}

/// Overwrites the last eight bytes with a valid check sum (FNV-1a, 64 bit).
fn with_check_sum(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 8;
    let sum = Fnv1a::of(&bytes[..end]);
    bytes[end..].copy_from_slice(&sum.to_le_bytes());
    bytes
}

/// The dump of a ship against a quay with a panel on two cones, held by a chain: the scene has everything that a model
/// can have.
fn dump(settings: &Settings) -> Result<Vec<u8>, EngineError> {
    let mut builder = EngineBuilder::new();
    let rubber = Material {
        stiffness_npm2: 5e6,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.2,
        friction_dynamic: 0.2,
        restitution: 0.1,
    };
    let rubber = builder.material("rubber", rubber)?;
    let wall = [vec2(-60.0, -5.0), vec2(60.0, -5.0), vec2(60.0, 0.0), vec2(-60.0, 0.0)];
    let (position_m, heading_rad) = (vec2(0.0, 0.0), 0.0);
    let quay = BodyDef { name: "quay", outline_m: &wall, mass: None, position_m, heading_rad };
    builder.body(&quay)?;
    let hull = [vec2(-60.0, -10.0), vec2(60.0, -10.0), vec2(60.0, 10.0), vec2(-60.0, 10.0)];
    let mass = MassProperties { mass_kg: 2e7, yaw_inertia_kgm2: 2e10, ..Default::default() };
    let (mass, position_m) = (Some(mass), vec2(0.0, 11.2));
    builder.body(&BodyDef { name: "ship", outline_m: &hull, mass, position_m, heading_rad })?;
    builder.all_other_pairs(rubber)?;
    let mut keys = String::from(
        "on=quay\nmaterial=rubber\ntype=cone\nsize=1050 F1.1\nposition=[0, 0]\nwidth=2 m",
    );
    if settings.method != Some(Method::Paper) {
        keys += "\ncones=[{ at = -0.8 }, { at = 0.8 }]\nchains=[{ kind = \"tension\", at = \"0.7 m\", \
                 slack = \"20 mm\", stiffness = \"20 MN/m\", break_load = \"500 kN\" }]";
    }
    builder.fender_by_keys("cones", &keys)?;
    let mut engine: Engine = builder.build(settings)?;
    engine.record(100)?;
    let mut states = engine.initial_states().to_vec();
    states[1].velocity_mps = vec2(0.0, -0.15);
    for step in 0..8 {
        if step == 4 {
            engine.mark_teleported(1)?;
        }
        engine.advance(&states, None, 0.1)?;
        let velocity_mps = states[1].velocity_mps;
        states[1].position_m += velocity_mps * 0.1;
    }
    engine.dump()
}
