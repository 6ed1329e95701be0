//! `cargo xtask bench border`: the cost of the C interface. The benchmark times the same step of the engine in three
//! ways: by the engine itself, by `fenderline_embed`, and by `fl_engine_advance`, where the states and loads of all
//! bodies go in and the wrenches come out.

#![allow(unsafe_code, reason = "the example calls the library as a C program would")]

use std::hint::black_box;
use std::path::Path;
use std::ptr;
use std::time::Instant;

use fenderline::{
    FL_HOST_COSIMULATION, FlEngine, FlSettings, FlState, FlStatus, FlWrench, fl_engine_advance,
    fl_engine_destroy, fl_engine_from_file,
};
use fenderline_contact::{
    BodyState, CoSimHost, HostSettings, HostWorkspace, Memory, Model, Workspace, Wrench, advance,
};
use fenderline_embed::{Engine, Host, Settings};
use fenderline_scenario::Scenario;

/// Number of steps in a round of the benchmark: enough for a round of some milliseconds.
const STEPS: usize = 2_000;
/// Rounds. Each round times every way of calling the engine in turn, so that a busy machine slows all of them alike.
const ROUNDS: usize = 101;
const STEP_S: f64 = 0.1;
const BERTH: &str = "scenarios/berth/leaning_on_eight_fenders.toml";

/// A case of the benchmark: a ship at a berth.
struct Case {
    name: &'static str,
    co_simulation: bool,
    /// How much nearer to the quay the ship is than at the scenario's start (m).
    nearer_m: f64,
}

const CASES: [Case; 3] = [
    Case { name: "a ship off her berth", co_simulation: false, nearer_m: -20.0 },
    Case { name: "a ship on eight fenders", co_simulation: false, nearer_m: 0.1 },
    Case { name: "the same, co-simulation host", co_simulation: true, nearer_m: 0.1 },
];

fn main() {
    println!(
        "step, nine bodies with loads                 engine   embed  from C  C over the engine"
    );
    for case in CASES {
        let mut bare = Bare::new(&case);
        let mut embedded = embedded(&case);
        let mut from_c = FromC::new(&case);
        let (states, loads) = (bare.states.clone(), bare.loads.clone());
        let mut times = [const { Vec::new() }; 4];
        for _ in 0..ROUNDS {
            let engine_ns = nanoseconds_a_step(|| bare.round());
            let embed_ns = nanoseconds_a_step(|| {
                for _ in 0..STEPS {
                    let wrenches = embedded.advance(black_box(&states), Some(&loads), STEP_S);
                    black_box(wrenches.expect("good states"));
                }
            });
            let from_c_ns = nanoseconds_a_step(|| from_c.round());
            for (all, own) in
                times.iter_mut().zip([engine_ns, embed_ns, from_c_ns, from_c_ns - engine_ns])
            {
                all.push(own);
            }
        }
        let [engine_ns, embed_ns, from_c_ns, over_ns] = times.map(median);
        let name = case.name;
        println!(
            "{name:42} {engine_ns:6.0} ns {embed_ns:4.0} ns {from_c_ns:4.0} ns {over_ns:15.0} ns"
        );
    }
    println!(
        "\nMedians. embed takes each step on a copy of the memory and checks that the results are"
    );
    println!("finite, so that a failed call changes nothing.");
}

fn nanoseconds_a_step(round: impl FnOnce()) -> f64 {
    let start = Instant::now();
    round();
    start.elapsed().as_secs_f64() * 1e9 / STEPS as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn embedded(case: &Case) -> Engine {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(BERTH);
    let scenario = Scenario::load(&file, &[]).expect("the project's scenario loads");
    let host = match case.co_simulation {
        true => Host::CoSimulation(HostSettings::default()),
        false => Host::default(),
    };
    Engine::from_scenario(scenario, &Settings { host, ..Settings::default() }).expect("settings")
}

/// The engine itself.
struct Bare {
    model: Model,
    core: BareCore,
    states: Vec<BodyState>,
    loads: Vec<Wrench>,
}

enum BareCore {
    Direct(Box<(Memory, Workspace)>),
    CoSimulation(Box<(CoSimHost, HostWorkspace)>),
}

impl Bare {
    fn new(case: &Case) -> Bare {
        let engine = embedded(case);
        let model = engine.model().clone();
        let mut states = engine.initial_states().to_vec();
        let ship = engine.body_named("ship").expect("she is there");
        states[ship].position_m.y += case.nearer_m;
        let core = if case.co_simulation {
            let host = CoSimHost::new(&model, HostSettings::default());
            BareCore::CoSimulation(Box::new((host, HostWorkspace::new(&model))))
        } else {
            BareCore::Direct(Box::new((Memory::new(&model), Workspace::new(&model))))
        };
        let loads = vec![Wrench::default(); states.len()];
        Bare { model, core, states, loads }
    }

    fn round(&mut self) {
        let Bare { model, core, states, loads } = self;
        for _ in 0..STEPS {
            let states = black_box(&*states);
            match core {
                BareCore::Direct(own) => {
                    let (memory, work) = &mut **own;
                    advance(model, memory, work, states, loads, STEP_S).expect("good states");
                    black_box(work.wrenches());
                }
                BareCore::CoSimulation(own) => {
                    let (host, work) = &mut **own;
                    let step = host.step(model, work, states, Some(loads), STEP_S);
                    black_box(step.expect("good states"));
                }
            }
        }
    }
}

/// The engine as a C program calls it, through the C interface.
struct FromC {
    engine: *mut FlEngine,
    states: Vec<FlState>,
    loads: Vec<FlWrench>,
    wrenches: Vec<FlWrench>,
}

impl FromC {
    fn new(case: &Case) -> FromC {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(BERTH);
        let file = file.to_str().expect("UTF-8");
        let host = if case.co_simulation { FL_HOST_COSIMULATION } else { 0 };
        let settings = FlSettings { size: size_of::<FlSettings>(), host, ..FlSettings::default() };
        let mut engine = ptr::null_mut();
        let (text, length) = (file.as_ptr().cast(), file.len());
        // SAFETY: the text has the length given, and there is room for a handle.
        let status =
            unsafe { fl_engine_from_file(text, length, ptr::null(), 0, &settings, &mut engine) };
        assert_eq!(status, FlStatus::Ok);
        let states: Vec<FlState> = Bare::new(case).states.iter().map(as_c).collect();
        let none = vec![FlWrench::default(); states.len()];
        FromC { engine, states, loads: none.clone(), wrenches: none }
    }

    fn round(&mut self) {
        let FromC { engine, states, loads, wrenches } = self;
        let (states, count) = (black_box(&*states), states.len());
        for _ in 0..STEPS {
            let (loads, into) = (loads.as_ptr(), wrenches.as_mut_ptr());
            // SAFETY: the arrays have `count` elements.
            let status =
                unsafe { fl_engine_advance(*engine, states.as_ptr(), loads, count, STEP_S, into) };
            assert_eq!(status, FlStatus::Ok);
            black_box(&*wrenches);
        }
    }
}

impl Drop for FromC {
    fn drop(&mut self) {
        fl_engine_destroy(self.engine);
    }
}

fn as_c(state: &BodyState) -> FlState {
    FlState {
        north_m: state.position_m.x,
        east_m: state.position_m.y,
        heading_rad: state.heading_rad,
        north_mps: state.velocity_mps.x,
        east_mps: state.velocity_mps.y,
        yaw_rate_radps: state.yaw_rate_radps,
    }
}
