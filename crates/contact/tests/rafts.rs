//! Chains of tugs and rafts of barges: islands with many floating bodies.

#![allow(clippy::disallowed_methods, reason = "they give loads and expected values, not results")]

use fenderline_contact::*;

const STEP_S: f64 = 0.1;
/// Overlap of neighbours at the start (m).
const OVERLAP_M: f64 = 0.02;

struct Scene {
    model: Model,
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
}

#[derive(Default)]
struct Plan {
    bodies: Vec<Body>,
    states: Vec<BodyState>,
}

impl Plan {
    fn add(
        &mut self,
        corners: &[(f64, f64)],
        mobility: Mobility,
        position_m: Vec2,
        heading_rad: f64,
    ) {
        let corners: Vec<Vec2> = corners.iter().map(|&(x, y)| vec2(x, y)).collect();
        let key = self.bodies.len() as u64;
        let outline = Outline::new(&corners).expect("a good outline").0;
        self.bodies.push(Body { name: format!("body {key}"), key, outline, mobility });
        self.states.push(BodyState { position_m, heading_rad, ..BodyState::default() });
    }

    fn fixed(&mut self, length_m: f64, width_m: f64, position_m: Vec2) {
        let (x, y) = (0.5 * length_m, 0.5 * width_m);
        self.add(&[(-x, -y), (x, -y), (x, y), (-x, y)], Mobility::Fixed, position_m, 0.0);
    }

    fn scene(self, friction: f64) -> Scene {
        let Plan { bodies, states } = self;
        let mut builder = Model::builder();
        let material = builder.material(Material {
            stiffness_npm2: 500e3,
            damping_nspm2: 0.0,
            shear_stiffness_npm: 3e6,
            friction_static: friction,
            friction_dynamic: friction,
            restitution: 0.1,
        });
        for body in bodies {
            builder.body(body);
        }
        builder.all_other_pairs(material);
        let model = builder.build().expect("a good model");
        Scene { memory: Memory::new(&model), work: Workspace::new(&model), model, states }
    }
}

/// A barge with cut corners, given by half of her length and half of her beam.
fn barge(x: f64, y: f64) -> [(f64, f64); 8] {
    let cut = 1.0;
    [
        (-x + cut, -y),
        (x - cut, -y),
        (x, -y + cut),
        (x, y - cut),
        (x - cut, y),
        (-x + cut, y),
        (-x, y - cut),
        (-x, -y + cut),
    ]
}

/// Short barges in a row at a quay to the north. Longer barges would buckle sideways under the load.
fn chain(barges: usize) -> Scene {
    let mut plan = Plan::default();
    let floating = Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 };
    for place in 0..barges {
        plan.add(&barge(10.0, 5.5), floating, vec2(-(20.0 - OVERLAP_M) * place as f64, 0.0), 0.0);
    }
    plan.fixed(10.0, 200.0, vec2(10.0 + 5.0 - OVERLAP_M, 0.0));
    plan.scene(0.5)
}

/// Barges with cut corners in `side` rows and columns. They lie in the corner of two quays, to the north and to the
/// east.
fn raft(side: usize) -> Scene {
    let (x, y) = (20.0, 5.5);
    let floating = Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 1.4e8 };
    let mut plan = Plan::default();
    for row in 0..side {
        for column in 0..side {
            let ahead_m = (2.0 * x - OVERLAP_M) * row as f64;
            let abeam_m = (2.0 * y - OVERLAP_M) * column as f64;
            plan.add(&barge(x, y), floating, vec2(-ahead_m, -abeam_m), 0.0);
        }
    }
    let long_m = 120.0 * (side + 2) as f64;
    plan.fixed(10.0, long_m, vec2(x + 5.0 - OVERLAP_M, 0.0));
    plan.fixed(long_m, 10.0, vec2(0.0, y + 5.0 - OVERLAP_M));
    plan.scene(0.5)
}

impl Scene {
    /// Takes one step. Returns the number of islands that did not converge.
    fn step(&mut self, loads: &[Wrench]) -> usize {
        let Scene { model, memory, work, states } = self;
        advance_in_place(model, memory, work, states, loads, STEP_S).expect("a good step");
        let is_open = |event: &&Event| matches!(event.kind, EventKind::NotConverged);
        work.events().iter().filter(is_open).count()
    }
}

/// Each barge has a load of 30 kN. At rest the contact ahead of the barge that is k-th from the end bears exactly k ·
/// 30 kN: the solver's errors do not add up along the chain.
#[test]
fn a_chain_at_rest_bears_the_sum_of_its_loads() {
    const BARGES: usize = 30;
    let mut scene = chain(BARGES);
    let mut loads = vec![Wrench::default(); BARGES + 1];
    for step in 0..3000 {
        // The drag of the water brings the barges to rest.
        for (load, state) in loads.iter_mut().zip(&scene.states).take(BARGES) {
            load.force_n = vec2(30e3, 0.0) - state.velocity_mps * 2e5;
            load.moment_nm = -1e7 * state.yaw_rate_radps;
        }
        assert_eq!(scene.step(&loads), 0, "step {step}");
    }
    let fastest_mps = scene.states.iter().map(|s| s.velocity_mps.length()).fold(0.0, f64::max);
    assert!(fastest_mps < 1e-9, "{fastest_mps}");
    let mut forces_n = [0.0; BARGES];
    for contact in scene.work.contacts() {
        let behind = [contact.body_1, contact.body_2].map(|body| body.0 as usize);
        let place = if behind.contains(&BARGES) { 0 } else { behind[0].max(behind[1]) };
        forces_n[place] += contact.normal_force_n;
    }
    for (place, force_n) in forces_n.iter().enumerate() {
        let wanted_n = 30e3 * (BARGES - place) as f64;
        assert!((force_n / wanted_n - 1.0).abs() < 1e-9, "{place}: {force_n} for {wanted_n} N");
    }
}

/// A turning wind with gusts acts on a raft of barges.
fn rides_out_gusts(side: usize, steps: usize) {
    let mut scene = raft(side);
    let floating = side * side;
    let mut loads = vec![Wrench::default(); floating + 2];
    for step in 0..steps {
        let time_s = step as f64 * STEP_S;
        for (index, load) in loads.iter_mut().take(floating).enumerate() {
            let gust = 1.0 + 0.5 * (0.2 * time_s + 0.7 * index as f64).sin();
            load.force_n = vec2(10e3 * gust, 30e3 * gust);
            load.moment_nm = 1e5 * (0.1 * time_s + index as f64).sin();
        }
        assert_eq!(scene.step(&loads), 0, "step {step}");
    }
    // The barges lie where they were moored, except that their sides give a little.
    for (index, state) in scene.states.iter().take(floating).enumerate() {
        let wanted_m = vec2(-40.0 * (index / side) as f64, -11.0 * (index % side) as f64);
        let off_m = (state.position_m - wanted_m).length();
        assert!(off_m < 0.5 * side as f64, "barge {index}: {off_m} m off");
    }
}

#[test]
fn a_raft_of_25_barges_rides_out_gusts() {
    rides_out_gusts(5, 600);
}

/// The run lasts ten minutes of simulated time, and takes a minute or two.
#[test]
#[ignore = "long: cargo test --release -p fenderline-contact --test all rafts:: -- --ignored"]
fn a_raft_of_100_barges_rides_out_ten_minutes_of_gusts() {
    rides_out_gusts(10, 6000);
}
