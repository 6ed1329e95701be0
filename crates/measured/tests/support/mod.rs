//! Made-up logs of our own runs, with noise, rounding, gaps and outliers put on.

use core::fmt::Write as _;

use fenderline_contact::{BodyState, Rotation, Vec2, vec2};
use fenderline_measured::{
    Berth, BerthError, Berthings, Lie, Mapping, Motion, berthings, read_log,
};
use fenderline_nautical::{ChartOrigin, GeoPoint, Moment};
use fenderline_scenario::{Override, Scenario};
use fenderline_sim::{Load, Setup, Simulation};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

pub(crate) const BERTH: &str = include_str!("../../../../examples/measured/berth.toml");

/// Where the sensors stand.
pub(crate) const SENSORS: &str = "bow_sensor = { place = \"40 m\" }\nstern_sensor = { place = \"-40 m\" }\ntime_zone = \"UTC\"\n";

/// 1 June 2025, 10:00 UTC.
pub(crate) const START_S: f64 = 1_748_772_000.0;

/// Random numbers of a seed.
pub(crate) struct Random(ChaCha8Rng);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(ChaCha8Rng::seed_from_u64(seed))
    }

    /// Uniform from 0 to 1.
    pub(crate) fn share(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// Normal with deviation 1 (Box and Muller).
    pub(crate) fn normal(&mut self) -> f64 {
        let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.share()));
        radius * libm::cos(core::f64::consts::TAU * self.share())
    }
}

/// What the engine says about a run's first touch.
#[derive(Clone, Debug)]
pub(crate) struct Truth {
    pub(crate) t_s: f64,
    pub(crate) speed_mps: f64,
    pub(crate) angle_rad: f64,
    /// Place of the contact forward of the centre of gravity (m).
    pub(crate) forward_m: f64,
    pub(crate) fender: usize,
    pub(crate) energy_j: f64,
}

/// A run that is measured.
pub(crate) struct Approach {
    /// State of the ship every 0.1 s.
    pub(crate) states: Vec<BodyState>,
    pub(crate) truth: Truth,
}

pub(crate) fn setup() -> Setup {
    Scenario::parse(BERTH, "berth.toml").expect("the berth is good").setup
}

pub(crate) fn berth() -> Berth {
    Berth::new(setup(), &Mapping::default()).expect("a berth")
}

/// The berth with the scenario changed.
pub(crate) fn berth_for(changes: &[Override]) -> Result<Berth, BerthError> {
    let scenario =
        Scenario::parse_with(BERTH, "berth.toml", changes).map_err(BerthError::Scenario)?;
    Berth::new(scenario.setup, &Mapping::default()).map_err(BerthError::Lacks)
}

/// Deviation of a ship's place along the quay when she berths (m).
pub(crate) const PLACE_SD_M: f64 = 0.2;

/// A drawn approach: speed 6 to 20 cm/s at the start 10 m off, angle up to 3°, rate of turn up to 0.3°/min.
pub(crate) fn drawn(random: &mut Random) -> Approach {
    let berth = berth();
    let angle_rad = random.between(-3.0, 3.0).to_radians();
    let speed_mps = random.between(0.06, 0.20);
    let along_mps = 0.02 * random.normal();
    // She goes on along the quay until she touches.
    let along_m =
        berth.axes.start.along_m + PLACE_SD_M * random.normal() - along_mps * 10.0 / speed_mps;
    let lie = Lie { along_m, off_m: 15.0, angle_rad };
    let nearest = berth.axes.nearest(&lie).expect("abreast");
    let lie = Lie { off_m: lie.off_m + 10.0 - nearest.gap_m, ..lie };
    run(&Motion {
        lie,
        rates: [along_mps, -speed_mps, random.between(-0.3, 0.3).to_radians() / 60.0],
    })
}

/// Steps of a run in 0.1 s.
const FINER: usize = 5;

/// The run from a state, driven by nothing but the water.
pub(crate) fn run(motion: &Motion) -> Approach {
    run_with(motion, Vec::new())
}

/// The run from a state, driven by the water and by loads.
pub(crate) fn run_with(motion: &Motion, loads: Vec<Load>) -> Approach {
    let berth = berth();
    let mut setup = berth.setup.clone();
    setup.loads = loads;
    setup.duration_s = 400.0;
    // Finer than the run from the measured state: the engine says where she touches at the end of a step.
    setup.step_s = 0.1 / FINER as f64;
    let mut start = setup.start();
    start.bodies[berth.axes.ship] = berth.axes.start_of(motion);
    setup.set_start(&start);
    let mut simulation = Simulation::new(setup).expect("a simulation");
    let mut states = vec![simulation.states()[berth.axes.ship]];
    let mut touched: Option<(usize, BodyState, Vec2)> = None;
    let mut steps = 0_usize;
    while !simulation.is_done() {
        let before = simulation.states()[berth.axes.ship];
        let record = simulation.step().expect("a step");
        if touched.is_none()
            && let Some(contact) = record.contacts.iter().find(|contact| contact.fender.is_some())
        {
            let own = contact.body_1.0 as usize == berth.axes.ship;
            let arm_m = if own { contact.arm_1_m } else { contact.arm_2_m };
            touched = Some((steps, before, arm_m));
        }
        steps += 1;
        if steps.is_multiple_of(FINER) {
            states.push(record.states_after[berth.axes.ship]);
        }
        if touched.is_some_and(|(index, ..)| steps > index + 600 * FINER) {
            break;
        }
    }
    let (index, state, arm_m) = touched.expect("she touches");
    let first = simulation
        .fender_summaries()
        .min_by(|one, other| one.first_touch_s.total_cmp(&other.first_touch_s))
        .expect("a fender");
    let outcome = simulation.berthing().expect("a berthing").expect("in range");
    let lie = berth.axes.lie(state.position_m, state.heading_rad);
    let ahead = Rotation::from_angle(state.heading_rad).apply_inverse(arm_m);
    Approach {
        truth: Truth {
            t_s: index as f64 * 0.1 / FINER as f64,
            speed_mps: first.approach_speed_mps,
            angle_rad: lie.angle_rad,
            forward_m: ahead.x,
            fender: first.fender,
            energy_j: outcome.fender_energy_j,
        },
        states,
    }
}

/// How a docking system's log differs from the truth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Laser {
    /// Deviation of a distance (m).
    pub(crate) noise_m: f64,
    /// Share of rows without a reading of a sensor.
    pub(crate) lost: f64,
    /// Share of readings that are wrong by metres.
    pub(crate) outliers: f64,
    /// Length of a pause before the touch (s).
    pub(crate) pause_s: f64,
}

pub(crate) const USUAL: Laser = Laser { noise_m: 0.01, lost: 0.05, outliers: 0.01, pause_s: 6.0 };

pub(crate) fn time(t_s: f64) -> String {
    let at = Moment::from_unix(t_s);
    let whole = libm::round(at.seconds) as u64;
    format!(
        "{:04}-{:02}-{:02} {:02}:{:02}:{:02}",
        at.year,
        at.month,
        at.day,
        whole / 3600,
        whole / 60 % 60,
        whole % 60
    )
}

/// Distances of the hull at both sensors, and their speeds by differences.
pub(crate) fn distances(berth: &Berth, states: &[BodyState], index: usize) -> Option<[f64; 4]> {
    let at = |index: usize| {
        let state = &states[index.min(states.len() - 1)];
        let lie = berth.axes.lie(state.position_m, state.heading_rad);
        Some([berth.axes.hull_at(&lie, 40.0)?, berth.axes.hull_at(&lie, -40.0)?])
    };
    let (now, before, after) = (at(index)?, at(index.saturating_sub(5))?, at(index + 5)?);
    let span_s = 0.1 * ((index + 5).min(states.len() - 1) - index.saturating_sub(5)) as f64;
    let speed = |side: usize| (before[side] - after[side]) / span_s;
    Some([now[0], now[1], speed(0), speed(1)])
}

/// The log of a docking system: a row a second, distances and speeds in steps of 1 cm and 1 cm/s.
pub(crate) fn docking_log(approach: &Approach, laser: Laser, random: &mut Random) -> String {
    let berth = berth();
    let mut text = String::from(
        "Time,Bow distance (m),Stern distance (m),Bow speed (cm/s),Stern speed (cm/s)\n",
    );
    let touch_s = approach.truth.t_s;
    let pause_s = touch_s - random.between(8.0, 25.0);
    let phase = (random.share() * 10.0) as usize;
    for index in (phase..approach.states.len()).step_by(10) {
        let t_s = index as f64 * 0.1;
        if t_s > pause_s && t_s < pause_s + laser.pause_s {
            continue;
        }
        let Some([bow, stern, bow_speed, stern_speed]) = distances(&berth, &approach.states, index)
        else {
            continue;
        };
        let mut reading = |metres: f64| {
            if random.share() < laser.lost {
                return String::new();
            }
            let wrong =
                if random.share() < laser.outliers { random.between(-4.0, 4.0) } else { 0.0 };
            format!("{:.2}", metres + laser.noise_m * random.normal() + wrong)
        };
        let (bow, stern) = (reading(bow), reading(stern));
        let _ = writeln!(
            text,
            "{},{bow},{stern},{:.0},{:.0}",
            time_of(START_S, t_s),
            100.0 * bow_speed,
            100.0 * stern_speed
        );
    }
    text
}

/// A time with tenths of a second.
pub(crate) fn time_of(start_s: f64, t_s: f64) -> String {
    let tenths = libm::round(t_s * 10.0) as u64;
    format!("{}.{}", time(start_s + (tenths / 10) as f64), tenths % 10)
}

pub(crate) fn origin() -> ChartOrigin {
    ChartOrigin::new(GeoPoint { latitude_deg: 51.95, longitude_deg: 4.05 }).expect("a place")
}

/// Where the antenna of tracks is: forward and to starboard of the centre of gravity (m).
pub(crate) const ANTENNA_M: Vec2 = vec2(-70.0, 3.0);

/// The log of an antenna on board: five rows a second, positions to the millimetre with `noise_m`, headings with 0.02°.
pub(crate) fn track_log(approach: &Approach, noise_m: f64, random: &mut Random) -> String {
    let origin = origin();
    let mut text = String::from("time,lat,lon,heading\n");
    for (index, state) in approach.states.iter().enumerate().step_by(2) {
        let at = state.position_m + Rotation::from_angle(state.heading_rad).apply(ANTENNA_M);
        let place =
            origin.place(at.x + noise_m * random.normal(), at.y + noise_m * random.normal());
        let heading_deg = state.heading_rad.to_degrees() + 0.02 * random.normal();
        let _ = writeln!(
            text,
            "{}Z,{:.8},{:.8},{:.2}",
            time_of(START_S, index as f64 * 0.1),
            place.latitude_deg,
            place.longitude_deg,
            libm::fmod(heading_deg + 360.0, 360.0)
        );
    }
    text
}

/// The berthings of logs by a mapping.
pub(crate) fn found(logs: &[(&str, &str)], mapping: &str) -> Berthings {
    let mapping = Mapping::parse(mapping, "mapping.toml").expect("a mapping");
    let origin = origin();
    let read = logs.iter().map(|(name, text)| read_log(text, name, &mapping, Some(&origin)));
    berthings(read.collect(), &mapping, &berth_for).expect("the berth is good")
}
