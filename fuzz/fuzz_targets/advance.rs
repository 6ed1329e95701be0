//! Fuzzes the coupled method with random bodies, fenders, curves, loads and steps: no panic, finite states, normal
//! forces N ≥ 0, and opposite contact forces on two bodies.
#![no_main]

use fenderline_contact::{
    Body, BodyId, BodyState, Fender, FenderLaw, Material, MaterialId, Memory, Mobility, Model,
    Outline, Pair, ReactionFactors, Stop, Unloading, Vec2, Workspace, Wrench, advance, vec2,
};
use fenderline_fuzz::input::Input;
use libfuzzer_sys::fuzz_target;

const STEPS: usize = 12;

fuzz_target!(|bytes: &[u8]| {
    let mut input = Input::new(bytes);
    let Some((model, states, loads)) = scene(&mut input) else { return };
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut states = states;
    for _ in 0..STEPS {
        // 1 ms to 2 s.
        let step_s = [1e-3, 0.05, 0.1, 0.5, 1.0, 2.0][usize::from(input.byte()) % 6];
        let before = memory.clone();
        if advance(&model, &mut memory, &mut work, &states, &loads, step_s).is_err() {
            assert_eq!(
                memory, before,
                "the engine has changed its memory in a step that it refused"
            );
            return;
        }
        check(&model, &work);
        states.copy_from_slice(work.states_after());
    }
});

fn check(model: &Model, work: &Workspace) {
    for state in work.states_after() {
        let linear = [state.position_m, state.velocity_mps];
        assert!(linear.iter().all(|v| v.x.is_finite() && v.y.is_finite()), "{state:?}");
        assert!(state.heading_rad.is_finite() && state.yaw_rate_radps.is_finite(), "{state:?}");
    }
    let mut sums = vec![Wrench::default(); model.bodies().len()];
    for contact in work.contacts() {
        assert!(contact.normal_force_n >= 0.0, "{contact:?}");
        assert!(contact.peak_normal_force_n.is_finite() && contact.peak_depth_m.is_finite());
        let force_n = contact.force_on_body_1_n();
        assert!(force_n.x.is_finite() && force_n.y.is_finite(), "{contact:?}");
        let [one, two] = [contact.body_1, contact.body_2].map(|BodyId(id)| id as usize);
        assert_ne!(one, two);
        sums[one].force_n += force_n;
        sums[two].force_n -= force_n;
    }
    let wrenches = work.wrenches();
    for wrench in wrenches {
        assert!(wrench.force_n.x.is_finite() && wrench.force_n.y.is_finite(), "{wrench:?}");
        assert!(wrench.moment_nm.is_finite(), "{wrench:?}");
    }
    // Of two bodies, opposite bit for bit. Of more, opposite to rounding, as sums have another order.
    if let [one, two] = wrenches {
        assert_eq!(one.force_n, -two.force_n);
    }
    let largest_n = wrenches.iter().map(|w| w.force_n.length()).fold(0.0, f64::max);
    let total = wrenches.iter().fold(Vec2::ZERO, |sum, w| sum + w.force_n);
    assert!(total.length() <= 1e-9 * largest_n, "{total:?} of {largest_n} N");
}

/// A scene of two to four bodies near each other; `None` if an outline or a law is refused.
fn scene(input: &mut Input<'_>) -> Option<(Model, Vec<BodyState>, Vec<Wrench>)> {
    let mut builder = Model::builder();
    let count = 2 + input.byte() % 3;
    let (mut states, mut loads) = (vec![], vec![]);
    for key in 0..count {
        let outline = outline(input)?;
        let mobility = if key == 0 && input.byte() < 128 { Mobility::Fixed } else { mass(input) };
        let (name, key) = (format!("body {key}"), u64::from(key));
        builder.body(Body { name, key, outline, mobility });
        states.push(BodyState {
            position_m: vec2(input.coordinate_m(), input.coordinate_m()) * 0.25,
            heading_rad: input.heading_rad(),
            velocity_mps: vec2(input.coordinate_m(), input.coordinate_m()) * (1.0 / 32.0),
            yaw_rate_radps: input.coordinate_m() * 1e-3,
        });
        loads.push(Wrench {
            force_n: vec2(input.coordinate_m(), input.coordinate_m()) * 1e4,
            moment_nm: input.coordinate_m() * 1e5,
        });
    }
    let outlines = material(input);
    builder.material(outlines);
    let faces = material(input);
    builder.material(faces);
    builder.all_other_pairs(MaterialId(0));
    for key in 0..u32::from(input.byte() % 5) {
        builder.fender(fender(input, key, u32::from(count)));
    }
    builder.pair(Pair { bodies: [BodyId(0), BodyId(1)], material: MaterialId(0) });
    Some((builder.build().ok()?, states, loads))
}

/// An outline of three to eight corners, convex or not.
fn outline(input: &mut Input<'_>) -> Option<Outline> {
    let corners = 3 + input.byte() % 6;
    let corners: Vec<Vec2> =
        (0..corners).map(|_| vec2(input.coordinate_m(), input.coordinate_m()) * 0.25).collect();
    Outline::new(&corners).ok().map(|(outline, _)| outline)
}

/// A mass from 1 t to 1e8 t, equal in surge and sway or not.
fn mass(input: &mut Input<'_>) -> Mobility {
    let mass_kg = power_of_ten(input, 3.0, 11.0);
    let yaw_inertia_kgm2 = mass_kg * power_of_ten(input, 0.0, 4.0);
    if input.byte() < 128 {
        return Mobility::Free { mass_kg, yaw_inertia_kgm2 };
    }
    let sway_kg = mass_kg * (1.0 + f64::from(input.byte()) / 128.0);
    Mobility::FullMatrix {
        matrix: [[mass_kg, 0.0, 0.0], [0.0, sway_kg, 0.0], [0.0, 0.0, yaw_inertia_kgm2]],
    }
}

fn material(input: &mut Input<'_>) -> Material {
    let share = |input: &mut Input<'_>| f64::from(input.byte()) / 255.0;
    let friction_static = 2.0 * share(input);
    Material {
        stiffness_npm2: power_of_ten(input, 2.0, 10.0),
        damping_nspm2: if input.byte() < 128 { 0.0 } else { power_of_ten(input, 2.0, 7.0) },
        shear_stiffness_npm: if input.byte() < 64 { 0.0 } else { power_of_ten(input, 3.0, 12.0) },
        friction_static,
        friction_dynamic: friction_static * share(input),
        restitution: share(input),
    }
}

fn fender(input: &mut Input<'_>, key: u32, bodies: u32) -> Fender {
    let share = |input: &mut Input<'_>| f64::from(1 + u16::from(input.byte())) / 256.0;
    let projection_m = 4.0 * share(input);
    Fender {
        name: format!("fender {key}"),
        key: u64::from(key),
        body: BodyId(u32::from(input.byte()) % bodies),
        position_m: vec2(input.coordinate_m(), input.coordinate_m()) * 0.25,
        facing_rad: input.heading_rad(),
        width_m: 16.0 * share(input),
        projection_m,
        law: law(input, projection_m),
        unloading: (input.byte() < 128)
            .then(|| Unloading::ReturnedEnergy(share(input).max(Unloading::MIN_RETURNED_SHARE))),
        material: MaterialId(1),
        rated_deflection_m: projection_m * share(input),
        stop: (input.byte() < 128).then(|| Stop {
            from_m: projection_m * share(input),
            stiffness_npm: power_of_ten(input, 4.0, 10.0),
        }),
        factors: ReactionFactors {
            constant: 0.5 + share(input),
            by_compression_time: vec![[1.0, 1.0 + share(input)], [10.0, 1.0]],
            by_angle: vec![[0.0, 1.0], [0.3, share(input)]],
        },
        panel: None,
    }
}

/// The law of a fender: an area law, or a curve of up to six points, which may fall as that of a buckling fender does.
fn law(input: &mut Input<'_>, projection_m: f64) -> FenderLaw {
    let points = input.byte() % 7;
    if points == 0 {
        return FenderLaw::Area;
    }
    let scale_n = power_of_ten(input, 3.0, 8.0);
    let mut curve = vec![[0.0, 0.0]];
    for k in 1..=points {
        let deflection_m = projection_m * f64::from(k) / f64::from(points);
        curve.push([deflection_m, scale_n * f64::from(input.byte()) / 255.0]);
    }
    FenderLaw::Curve(curve)
}

/// A random number: 10 to a power from `low` to `high`.
fn power_of_ten(input: &mut Input<'_>, low: f64, high: f64) -> f64 {
    10.0_f64.powf(low + (high - low) * f64::from(input.byte()) / 255.0)
}
