//! A ship on six lines for ten hours in a gusty wind off the quay: wind, current and lines together.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::*;
use fenderline_sim::mooring::*;

const STEP_S: f64 = 0.5;
const STEPS: u32 = 72_000;
/// Displacement and added mass in sway of the paper's container ship (kg).
const MASS_KG: f64 = 87.8e6 * 1.5;
/// A tenth of the critical damping for lines of about 2 MN/m (N·s/m).
const DAMPING_NSPM: f64 = 3.0e6;

fn wind() -> Wind {
    let profile = WindProfile::Uniform;
    let mean = MeanWind { speed_mps: 12.0, from_rad: 80.0_f64.to_radians(), profile };
    let realisation = Realisation { harmonics: 60, seed: 11 };
    Wind::with_gusts(mean, Gusts::new(&mean, &GustSpectrum::Npd, realisation).unwrap()).unwrap()
}

fn windage() -> ShipWindage {
    ShipWindage {
        length_m: 298.0,
        beam_m: 46.0,
        frontal_m2: 1700.0,
        lateral_m2: 9000.0,
        centroid_forward_m: 0.0,
        centroid_height_m: 15.0,
        method: WindMethod::Blendermann(Blendermann::of_type("container ship, loaded").unwrap()),
    }
}

/// Fairlead and bollard of six lines: ship heading north, quay to the east.
const LINES: [[[f64; 3]; 2]; 6] = [
    [[145.0, 5.0, 12.0], [180.0, 30.0, 3.0]],
    [[140.0, 12.0, 12.0], [150.0, 30.0, 3.0]],
    [[100.0, 23.0, 10.0], [50.0, 26.0, 3.0]],
    [[-100.0, 23.0, 10.0], [-50.0, 26.0, 3.0]],
    [[-140.0, 15.0, 12.0], [-150.0, 30.0, 3.0]],
    [[-145.0, 10.0, 12.0], [-180.0, 30.0, 3.0]],
];

fn ends(k: usize, moved_m: Vec2) -> LineEnds {
    let [[north, east, up], shore_m] = LINES[k];
    LineEnds { ship_m: [north + moved_m.x, east + moved_m.y, up], shore_m }
}

fn make_fast() -> (Vec<Line>, Vec<LineState>) {
    let line = |k: usize| {
        let setup = LineSetup {
            name: format!("line {}", k + 1),
            kind: LineKind::Light {
                main: Rope { break_load_n: 1.3e6, curve: RopeCurve::polyester() },
                tail: None,
                details: LineDetails::default(),
            },
            inboard_end: InboardEnd::Winch(Winch::of_design(1.3e6, 100.0)),
            initial_length: InitialLength::FromPretension(100e3),
        };
        Line::new(setup, &ends(k, Vec2::ZERO)).unwrap()
    };
    (0..LINES.len()).map(line).unzip()
}

struct Run {
    greatest_m: f64,
    mean_wind_n: Vec2,
    mean_lines_n: Vec2,
    mean_damping_n: Vec2,
    last: (Vec2, Vec2),
    states: Vec<LineState>,
}

fn run() -> Run {
    let (wind, windage) = (wind(), windage());
    let current = Current::uniform(vec2(0.2, 0.0)).unwrap();
    let (lines, mut states) = make_fast();
    let (mut moved_m, mut velocity_mps) = (Vec2::ZERO, Vec2::ZERO);
    let mut greatest_m = 0.0_f64;
    let mut sums = [Vec2::ZERO; 3];
    for step in 0..STEPS {
        let t_s = STEP_S * f64::from(step);
        let felt = RelativeWind::of(wind.velocity(10.0, t_s), velocity_mps, 0.0);
        let [x_n, y_n, _] = windage.force(&felt, 1.224);
        let lines_n = lines.iter().zip(&mut states).enumerate().fold(
            Vec2::ZERO,
            |sum, (k, (line, state))| {
                let load = line.step(state, &ends(k, moved_m), WinchOrder::Hold, STEP_S);
                sum + vec2(load.on_ship_n[0], load.on_ship_n[1])
            },
        );
        let through_mps = velocity_mps - current.velocity(moved_m, t_s, 9.0);
        let damping_n = through_mps * -DAMPING_NSPM;
        let forces = [vec2(x_n, y_n), lines_n, damping_n];
        for (sum, force) in sums.iter_mut().zip(forces) {
            *sum += force;
        }
        velocity_mps += (forces[0] + forces[1] + forces[2]) * (STEP_S / MASS_KG);
        moved_m += velocity_mps * STEP_S;
        greatest_m = greatest_m.max(moved_m.length());
    }
    let [mean_wind_n, mean_lines_n, mean_damping_n] =
        sums.map(|sum| sum * (1.0 / f64::from(STEPS)));
    let last = (moved_m, velocity_mps);
    Run { greatest_m, mean_wind_n, mean_lines_n, mean_damping_n, last, states }
}

/// Her lines hold her at most 3 m off, where the breast lines would almost render. No line parts. Over ten hours the
/// mean forces of lines, wind and water cancel, except for her final momentum.
#[test]
fn ten_hours_alongside_are_bounded_and_balanced() {
    let run = run();
    println!(
        "{:.2} m, wind {:?} N, lines {:?} N",
        run.greatest_m, run.mean_wind_n, run.mean_lines_n
    );
    assert!(run.greatest_m < 3.0, "{}", run.greatest_m);
    assert!(run.states.iter().all(|state| !state.parted));
    assert!(run.mean_wind_n.y < -500e3 && run.mean_lines_n.y > 500e3);
    let rest_n = run.mean_wind_n + run.mean_lines_n + run.mean_damping_n;
    let momentum_n = run.last.1 * (MASS_KG / (STEP_S * f64::from(STEPS)));
    assert!((rest_n - momentum_n).length() < 1e-6 * run.mean_wind_n.length(), "{rest_n:?}");
}

#[test]
fn ten_hours_replay_to_the_bit() {
    let (one, two) = (run(), run());
    let bits = |run: &Run| {
        let (at, v) = run.last;
        [at.x, at.y, v.x, v.y].map(f64::to_bits)
    };
    assert_eq!(bits(&one), bits(&two));
    assert_eq!(one.states, two.states);
}
