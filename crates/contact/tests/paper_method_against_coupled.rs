//! The table of docs/contact_model.md, section 5: the results of the paper's method, and the right results. The wrong
//! results are tested too, so that the table stays true.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use crate::small_host;

use fenderline_contact::{
    BodyState, CoSimHost, HostIntegration, HostSettings, HostWorkspace, Material, vec2,
};
use small_host::{
    BodySetup, Host, Integrator, Load, Method, PairSetup, Scene, fixed, floating, rectangle,
    spring, two,
};

/// A scene with the paper's method: forward Euler, and a separate limit for each pair.
fn by_the_papers_method(mut scene: Scene) -> Scene {
    scene.method = Method::Paper;
    scene.integrator = Integrator::Euler;
    scene
}

/// A ship of 100,000 t, 200 m × 32 m, at `gap_m` from `count` fenders 4 m wide.
fn ship_beside_fenders(count: usize, gap_m: f64, material: Material, step_s: f64) -> Scene {
    let mut bodies: Vec<BodySetup> = vec![floating("ship", rectangle(200.0, 32.0), 1e8, 50.0)];
    for k in 0..count {
        let mut fender = fixed(&format!("fender {k:02}"), rectangle(4.0, 4.0));
        let along_m = if count == 1 { 0.0 } else { -80.0 + 160.0 * k as f64 / (count - 1) as f64 };
        fender.position_m = vec2(along_m, 18.0 + gap_m);
        bodies.push(fender);
    }
    Scene {
        step_s,
        duration_s: 900.0,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies,
        materials: vec![material],
        pairs: (1..=count).map(|k| PairSetup { bodies: [0, k], material: 0 }).collect(),
        fenders: vec![],
        loads: vec![],
    }
}

/// A tug of 1,000 t and 10 m width, with her bow at `gap_m` from a wall.
fn tug_at_a_wall(gap_m: f64, speed_mps: f64, material: Material, step_s: f64) -> Scene {
    let mut tug = floating("tug", rectangle(32.0, 10.0), 1e6, 8.0);
    tug.velocity.surge_mps = speed_mps;
    let mut wall = fixed("wall", rectangle(20.0, 100.0));
    wall.position_m = vec2(26.0 + gap_m, 0.0);
    let mut scene = two(tug, wall, material, Integrator::SemiImplicit, step_s, 120.0);
    scene.method = Method::Coupled;
    scene
}

fn pushed(mut scene: Scene, north_n: f64, east_n: f64) -> Scene {
    scene.loads.push(Load { body: 0, force_n: vec2(north_n, east_n) });
    scene
}

#[test]
fn leaning_on_one_fender_for_a_quarter_of_an_hour() {
    let scene = pushed(ship_beside_fenders(1, 0.0, spring(500e3, 0.1), 0.1), 0.0, 500e3);
    let depth_m = Host::run(scene.clone()).states[0].position_m.y;
    assert!((depth_m / 0.25 - 1.0).abs() < 0.005, "{depth_m} m, F/(k·width) is 0.25 m");
    // The limiter does not know the load. This program gives a depth of 0.94 m, and she still goes deeper.
    let paper = Host::run(by_the_papers_method(scene));
    let state = paper.states[0];
    assert!((state.position_m.y / 0.94 - 1.0).abs() < 0.1, "{state:?}");
    assert!(state.velocity_mps.y > 1e-5, "{state:?}");
}

/// The paper's equations with forward Euler and no limiter, for one body on a spring of k·width. `start` is its depth
/// and speed. Returns the depth after each step, and the final speed.
fn bare_spring(
    mass_kg: f64,
    stiffness_npm: f64,
    push_n: f64,
    start: (f64, f64),
    step_s: f64,
    duration_s: f64,
) -> (Vec<f64>, f64) {
    let (mut x_m, mut v_mps) = start;
    let mut path_m = vec![];
    for _ in 0..(duration_s / step_s).round() as u64 {
        let force_n = push_n - stiffness_npm * x_m.max(0.0);
        x_m += v_mps * step_s;
        v_mps += force_n / mass_kg * step_s;
        path_m.push(x_m);
    }
    (path_m, v_mps)
}

#[test]
fn leaning_without_a_limiter_swings_ever_wider() {
    let (path_m, _) = bare_spring(1e8, 2e6, 500e3, (0.0, 0.0), 0.1, 900.0);
    let [first_m, last_m] = [&path_m[..1500], &path_m[7500..]]
        .map(|part| part.iter().fold(0.0_f64, |deepest, &x| deepest.max(x)));
    // An undamped spring swings to 0.5 m. Each step multiplies the energy by 1 + (ωΔt)². If she never left the fender,
    // the swing about 0.25 m would grow by e^0.6 in ten minutes.
    assert!(first_m > 0.5 && last_m > 1.3 * first_m, "{first_m} m, then {last_m} m");
}

#[test]
fn eight_stiff_fenders() {
    let gaps_m = (0..30).map(|k| 0.5 + 0.001 * f64::from(k));
    let rebounds = |by: fn(Scene) -> Scene| -> Vec<f64> {
        let one = |gap_m| {
            let mut scene = ship_beside_fenders(8, gap_m, spring(50e6, 0.1), 0.1);
            scene.duration_s = 30.0;
            scene.bodies[0].velocity.sway_mps = 0.3;
            -Host::run(by(scene)).states[0].velocity_mps.y / 0.3
        };
        gaps_m.clone().map(one).collect()
    };
    for rebound in rebounds(|scene| scene) {
        assert!((rebound / 0.1 - 1.0).abs() < 0.03, "{rebound} v₀");
    }
    // Each pair allows γv₀ for itself, and these speeds add up. The later in a step the pairs turn her, the larger is
    // the sum.
    let worst = rebounds(by_the_papers_method).into_iter().fold(0.0, f64::max);
    assert!((worst / 0.47 - 1.0).abs() < 0.1, "0.47 v₀ as found with this program: {worst}");
}

#[test]
fn ten_stiff_fenders_with_steps_of_1_s() {
    let mut scene = ship_beside_fenders(10, 0.5, spring(50e6, 0.1), 1.0);
    scene.duration_s = 60.0;
    scene.bodies[0].velocity.sway_mps = 0.3;
    let rebound = -Host::run(scene.clone()).states[0].velocity_mps.y / 0.3;
    assert!((rebound / 0.1 - 1.0).abs() < 0.03, "{rebound} v₀");
    let rebound = -Host::run(by_the_papers_method(scene)).states[0].velocity_mps.y / 0.3;
    assert!(rebound > 1.0, "faster than the approach: {rebound} v₀");
}

#[test]
fn a_tug_pushing_on_a_wall_for_two_minutes() {
    let scene = pushed(tug_at_a_wall(0.0, 0.0, spring(400e3, 0.1), 0.1), 500e3, 0.0);
    let depth_m = Host::run(scene.clone()).states[0].position_m.x;
    assert!((depth_m / 0.125 - 1.0).abs() < 0.005, "{depth_m} m, F/(k·width) is 0.125 m");
    let depth_m = Host::run(by_the_papers_method(scene)).states[0].position_m.x;
    assert!(depth_m > 1.0, "metres of creep: {depth_m} m");
}

#[test]
fn forward_euler_without_a_limiter() {
    // A tug of 1,000 t hits k·width = 6.5 MN/m at 2.06 m/s, with Δt = 0.1 s. Each step multiplies the energy by 1 +
    // (ωΔt)² = 1.065. Half a period has 12.3 steps, so she leaves at 2.06 m/s · 1.065^(12.3/2) = 3.03 m/s.
    let (_, v_mps) = bare_spring(1e6, 6.5e6, 0.0, (-2.0, 2.06), 0.1, 10.0);
    // The tolerance is 4 %: half a step more or less of contact makes 1.6 % at either end.
    assert!((v_mps / -3.03 - 1.0).abs() < 0.04, "{v_mps} m/s");
    // With γ = 1, only a speed above the approach speed is limited.
    for step_s in [0.05, 0.1, 0.2] {
        let mut scene = tug_at_a_wall(2.0, 2.06, spring(650e3, 1.0), step_s);
        scene.integrator = Integrator::Euler;
        let left_mps = -Host::run(scene).states[0].velocity_mps.x;
        assert!(left_mps <= 2.06 + 1e-9, "Δt {step_s}: {left_mps} m/s");
        let left_mps = leaving_speed_as_cosim_host(step_s);
        assert!(left_mps <= 2.06 + 1e-9, "as a co-simulation host, Δt {step_s}: {left_mps} m/s");
    }
    // If a host applies the mean force in long steps of its own, its motion departs from the engine's. Such a host must
    // be a co-simulation host.
    let left_mps = leaving_speed_as_cosim_host(0.5);
    assert!(left_mps <= 2.06 + 1e-9, "as a co-simulation host, Δt 0.5: {left_mps} m/s");
}

#[test]
fn a_tug_with_steps_of_2_s() {
    // The depth v/ω of a half sine, with ω = √(5 MN/m / 1e6 kg).
    let scene = tug_at_a_wall(2.0, 2.06, spring(500e3, 0.1), 2.0);
    let depth_m = Host::run(scene.clone()).pairs[0].1.depth_m;
    assert!((depth_m / 0.9213 - 1.0).abs() < 0.005, "{depth_m} m");
    let depth_m = Host::run(by_the_papers_method(scene)).pairs[0].1.depth_m;
    // The tug first touches the wall after two steps. She is then four metres inside it.
    assert!(depth_m > 3.0, "metres: {depth_m} m");
}

/// The speed at which the tug leaves. A co-simulation host moves her with forward Euler and reports no loads.
fn leaving_speed_as_cosim_host(step_s: f64) -> f64 {
    let scene = tug_at_a_wall(2.0, 2.06, spring(650e3, 1.0), step_s);
    let model = scene.model();
    let settings = HostSettings { delay_steps: 0, integration: HostIntegration::ForwardEuler };
    let mut host = CoSimHost::new(&model, settings);
    let mut work = HostWorkspace::new(&model);
    let mut states: Vec<BodyState> = scene.initial_states();
    for _ in 0..Host::new(scene).steps_total() {
        let force_n = host.step(&model, &mut work, &states, None, step_s).unwrap()[0].force_n;
        let velocity_mps = states[0].velocity_mps;
        states[0].position_m += velocity_mps * step_s;
        states[0].velocity_mps += force_n * (step_s / 1e6);
    }
    -states[0].velocity_mps.x
}
