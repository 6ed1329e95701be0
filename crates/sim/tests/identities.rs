//! Identities of docs/contact_model.md, section 7, that need the integrators, the berthing formulas and the energy
//! ledger. Other identities are in crates/contact/tests/identities.rs.

use crate::support;

use fenderline_contact::{BodyState, vec2};
use fenderline_sim::berthing::{ContactPoint, frictionless_factor};
use fenderline_sim::{BodySetup, BodyVelocity, Integrator, Method, Setup, Simulation};
use proptest::prelude::*;
use support::{fixed, floating, outline, rectangle, spring, two};

fn run(setup: Setup) -> Simulation {
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    simulation
}

/// A block of 1000 t and 10 m width, which is about to touch a wall 40 m wide head-on.
fn head_on(
    speed_mps: f64,
    stiffness_npm2: f64,
    restitution: f64,
    integrator: Integrator,
    step_s: f64,
    duration_s: f64,
) -> Setup {
    let mut block = floating("block", rectangle(30.0, 10.0), 1e6, 8.0);
    block.velocity.surge_mps = speed_mps;
    let mut wall = fixed("wall", rectangle(20.0, 40.0));
    wall.position_m = vec2(25.0, 0.0);
    two(block, wall, spring(stiffness_npm2, restitution), integrator, step_s, duration_s)
}

/// The attack on FMI states found this case: such a start has an infinite kinetic energy.
#[test]
fn the_residual_of_a_start_faster_than_any_step_takes_is_zero_and_not_a_nan() {
    let setup = head_on(1e215, 500e3, 0.1, Integrator::SemiImplicit, 0.1, 1.0);
    let mut simulation =
        Simulation::new(setup).expect("a set-up that is checked by its first step");
    assert_eq!(simulation.energy().residual_j, 0.0);
    simulation.step().expect_err("it is too fast");
    assert_eq!(simulation.energy().residual_j, 0.0);
}

#[allow(clippy::disallowed_methods, reason = "a test's closed form need not be bit for bit")]
/// Error of position and velocity before a quarter of the contact's period, while nothing limits the force (m). (In
/// position alone, semi-implicit Euler that begins at the touch is of second order.)
fn error_at_quarter_period(integrator: Integrator, steps: u32) -> f64 {
    let (speed, stiffness): (f64, f64) = (1.0, 500e3);
    let omega = (stiffness * 10.0 / 1e6_f64).sqrt();
    let quarter_s = 0.4 * std::f64::consts::PI / omega;
    let step_s = quarter_s / f64::from(steps);
    let simulation = run(head_on(speed, stiffness, 1.0, integrator, step_s, quarter_s));
    let state = simulation.states()[0];
    let exact_m = speed / omega * (omega * quarter_s).sin();
    let exact_mps = speed * (omega * quarter_s).cos();
    (state.position_m.x - exact_m).abs() + (state.velocity_mps.x - exact_mps).abs() / omega
}

#[test]
#[allow(clippy::disallowed_methods, reason = "a test's closed form need not be bit for bit")]
fn the_error_falls_with_the_time_step_at_the_order_of_the_integrator() {
    for (integrator, order) in
        [(Integrator::Euler, 1.0), (Integrator::SemiImplicit, 1.0), (Integrator::Rk4, 4.0)]
    {
        let coarse = error_at_quarter_period(integrator, 40);
        let fine = error_at_quarter_period(integrator, 80);
        let seen = (coarse / fine).log2();
        assert!((seen - order).abs() < 0.1, "{integrator:?}: order {seen}, not {order}");
    }
}

fn kinetic_j(setup: &Setup, states: &[BodyState]) -> f64 {
    let of = |(body, state): (&BodySetup, &BodyState)| {
        let Some(mass) = body.mass else { return 0.0 };
        0.5 * (mass.mass_kg * state.velocity_mps.length_squared()
            + mass.yaw_inertia_kgm2 * state.yaw_rate_radps * state.yaw_rate_radps)
    };
    setup.bodies.iter().zip(states).map(of).sum()
}

/// The same scene with the paper's method and forward Euler, and with the coupled method in its usual form.
fn by_both_methods(paper: Setup) -> [Setup; 2] {
    let mut coupled = paper.clone();
    coupled.method = Method::Coupled;
    coupled.integrator = Integrator::SemiImplicit;
    [paper, coupled]
}

/// A ship whose side moves onto a small fixed fender `along_m` forward of midships.
fn onto_a_point(along_m: f64, velocity: BodyVelocity, half_width_m: f64) -> [BodySetup; 2] {
    let mut ship = floating("ship", rectangle(100.0, 20.0), 1e7, 25.0);
    ship.velocity = velocity;
    let w = half_width_m;
    let mut fender =
        fixed("fender", outline(&[vec2(-w, 0.0), vec2(w, 0.0), vec2(w, 1.0), vec2(-w, 1.0)]));
    fender.position_m = vec2(along_m, 10.0);
    [ship, fender]
}

/// Points at which the ship of [`onto_a_point`] is touched, in metres forward of midships, from end to end.
const CONTACT_POINTS_M: [f64; 7] = [-48.0, -33.0, -16.0, 0.0, 9.0, 25.0, 47.0];

#[test]
#[allow(clippy::disallowed_methods, reason = "a test's closed form need not be bit for bit")]
fn pianc_frictionless_contact_loses_the_fraction_k2_over_k2_plus_a2() {
    for along_m in CONTACT_POINTS_M {
        for angle_deg in [-60.0, -20.0, 0.0, 5.0, 10.0, 45.0] {
            // Without friction, the speed along the side does not change.
            let surge_mps = 0.2 * f64::to_radians(angle_deg).tan();
            let velocity = BodyVelocity { sway_mps: 0.2, surge_mps, ..Default::default() };
            let [ship, fender] = onto_a_point(along_m, velocity, 0.05);
            let setup = two(ship, fender, spring(1e14, 0.0), Integrator::Euler, 1e-4, 0.01);
            let factor = frictionless_factor(25.0, along_m).unwrap();
            for setup in by_both_methods(setup) {
                let simulation = run(setup.clone());
                let before_j = 0.5 * 1e7 * 0.2 * 0.2; // the energy along the normal
                let all_j = before_j + 0.5 * 1e7 * surge_mps * surge_mps;
                let lost = (all_j - kinetic_j(&setup, simulation.states())) / before_j;
                let method = setup.method;
                assert!(
                    (lost / factor - 1.0).abs() < 1e-3,
                    "{method:?} at {along_m} m, {angle_deg}°: {lost}, {factor}"
                );
            }
        }
    }
}

#[test]
#[allow(clippy::disallowed_methods, reason = "a test's closed form need not be bit for bit")]
fn pianc_sticking_contact_loses_the_eccentricity_factor() {
    for along_m in CONTACT_POINTS_M {
        for angle_deg in [-30.0, -20.0, -5.0, 0.0, 5.0, 10.0, 15.0, 30.0] {
            let angle = f64::to_radians(angle_deg);
            let (v_n, v_t) = (0.2 * angle.cos(), 0.2 * angle.sin());
            let velocity = BodyVelocity { sway_mps: v_n, surge_mps: v_t, ..Default::default() };
            let [ship, fender] = onto_a_point(along_m, velocity, 0.25);
            let mut rubber = spring(2e9, 0.0);
            // The shear spring is so stiff that the tangential motion dies within a step. Otherwise its elastic energy
            // would come back as a rebound along the side, and the contact would not have stuck.
            rubber.shear_stiffness_npm = 1e17;
            rubber.friction_static = 1e6;
            rubber.friction_dynamic = 1e6;
            let setup = two(ship, fender, rubber, Integrator::Euler, 1e-5, 0.5);
            // In the ship's axes, a berthing at α square to the berth has this velocity.
            let contact = ContactPoint { along_m, beam_m: 20.0 };
            let ce = contact.eccentricity(25.0, angle).unwrap();
            for setup in by_both_methods(setup) {
                let simulation = run(setup.clone());
                let before_j = 0.5 * 1e7 * 0.2 * 0.2;
                let lost = 1.0 - kinetic_j(&setup, simulation.states()) / before_j;
                let method = setup.method;
                assert!(
                    (lost / ce - 1.0).abs() < 1e-3,
                    "{method:?} at {along_m} m, {angle_deg}°: {lost}, Ce {ce}"
                );
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// In a head-on hit without friction, no body leaves with more energy than it came with. This holds at any time
    /// step and stiffness, and for any restitution up to 1.
    #[test]
    fn a_head_on_frictionless_hit_makes_no_energy(
        speed in 0.05..4.0_f64,
        log_stiffness in 4.0..8.0_f64,
        restitution in 0.0..=1.0_f64,
        step_s in 0.01..2.0_f64,
    ) {
        let stiffness = libm::exp10(log_stiffness);
        let setup = head_on(speed, stiffness, restitution, Integrator::Euler, step_s, 60.0);
        let simulation = run(setup.clone());
        let before_j = 0.5 * 1e6 * speed * speed;
        prop_assert!(kinetic_j(&setup, simulation.states()) <= before_j * (1.0 + 1e-12));
        prop_assert!(simulation.energy().residual_j.abs() <= 1e-9 * before_j);
    }

    /// In an oblique hit with friction and a load, the ledger accounts for every joule with every integrator.
    #[test]
    fn the_energy_ledger_closes_to_rounding(
        y in -18.0..18.0_f64,
        heading in -0.6..0.6_f64,
        speed in 0.2..3.0_f64,
        integrator in prop_oneof![
            Just(Integrator::Euler), Just(Integrator::SemiImplicit), Just(Integrator::Rk4)
        ],
    ) {
        let mut tug = floating("tug", rectangle(32.0, 13.0), 1.01e6, 8.0);
        tug.velocity.surge_mps = speed;
        tug.heading_rad = heading;
        tug.position_m = vec2(-42.0, y);
        let ship = floating("ship", rectangle(46.0, 120.0), 9e7, 30.0);
        let mut rubber = spring(500e3, 0.1);
        rubber.shear_stiffness_npm = 3e6;
        rubber.friction_static = 0.5;
        rubber.friction_dynamic = 0.4;
        let mut setup = two(tug, ship, rubber, integrator, 0.1, 30.0);
        setup.loads.push(fenderline_sim::Load {
            body: 0,
            force_n: vec2(2e5, 1e4),
            moment_nm: 1e5,
            from_s: 1.03,
            until_s: 12.34,
        });
        let energy = run(setup).energy();
        let moved = energy.kinetic_j.abs() + energy.load_work_j.abs()
            + energy.normal_work_j.abs() + energy.tangential_work_j.abs();
        prop_assert!(energy.residual_j.abs() <= 1e-10 * moved, "{:?}", energy);
    }
}
