//! Identities of docs/contact_model.md, section 7, with the paper's method. They need no reference data.

use crate::small_host;

use fenderline_contact::{Vec2, vec2};
use proptest::prelude::*;
use small_host::{Host, Integrator, Scene, fixed, floating, rectangle, spring, two};

/// A block of 1000 t and 10 m width, just before a head-on impact on a wall 40 m wide.
fn head_on(speed_mps: f64, stiffness_npm2: f64, step_s: f64, duration_s: f64) -> Scene {
    let mut block = floating("block", rectangle(30.0, 10.0), 1e6, 8.0);
    block.velocity.surge_mps = speed_mps;
    let mut wall = fixed("wall", rectangle(20.0, 40.0));
    wall.position_m = vec2(25.0, 0.0);
    let elastic = spring(stiffness_npm2, 1.0);
    two(block, wall, elastic, Integrator::SemiImplicit, step_s, duration_s)
}

#[test]
fn a_flat_contact_is_a_half_sine_with_omega_root_kw_over_m() {
    let (speed, stiffness): (f64, f64) = (1.0, 500e3);
    let omega = (stiffness * 10.0 / 1e6_f64).sqrt();
    let step_s = 1e-4;
    let duration_s = 3.3 / omega;
    let host = Host::run(head_on(speed, stiffness, step_s, duration_s));
    let (_, pair) = host.pairs[0];
    // The error is of first order in Δt. Here ωΔt is 2e-4.
    let close =
        |ours: f64, exact: f64| assert!((ours / exact - 1.0).abs() < 5e-4, "{ours} {exact}");
    close(pair.depth_m, speed / omega);
    close(pair.force_n, stiffness * 10.0 * speed / omega);
    close(pair.depth_at_s, 0.5 * std::f64::consts::PI / omega);
    close(pair.last_touch_s - pair.first_touch_s, std::f64::consts::PI / omega);
    close(pair.impulse_ns, 2.0 * 1e6 * speed);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// With semi-implicit integration Δ(x×mv) = x×FΔt holds exactly, so both linear and angular momentum are conserved.
    /// Forward Euler conserves only linear momentum: it adds Δt² (v₁ − v₂)×F in each step.
    #[test]
    fn momentum_of_a_free_pair_is_constant_to_rounding(
        y in -18.0..18.0_f64,
        heading in -0.6..0.6_f64,
        speed in 0.2..4.0_f64,
        spin in -0.05..0.05_f64,
        friction in 0.0..0.8_f64,
        step_s in 0.02..1.0_f64,
    ) {
        let mut tug = floating("tug", rectangle(32.0, 13.0), 1.01e6, 8.0);
        tug.velocity.surge_mps = speed;
        tug.heading_rad = heading;
        tug.position_m = vec2(-40.0, y);
        let mut ship = floating("ship", rectangle(46.0, 120.0), 9e7, 30.0);
        ship.velocity.yaw_radps = spin * 0.1;
        let mut rubber = spring(500e3, 0.1);
        rubber.damping_nspm2 = 2e4;
        rubber.shear_stiffness_npm = 3e6;
        rubber.friction_static = friction;
        rubber.friction_dynamic = friction;
        let scene = two(tug, ship, rubber, Integrator::SemiImplicit, step_s, 60.0);
        let mut host = Host::new(scene);
        let (linear, angular) = host.momentum();
        let scale = linear.length() + 1e5;
        while !host.is_done() {
            host.step();
            let sum = host.work.wrenches()[0].force_n + host.work.wrenches()[1].force_n;
            prop_assert_eq!(sum, Vec2::ZERO, "F₁ = −F₂ bit for bit");
        }
        let (linear_after, angular_after) = host.momentum();
        prop_assert!((linear_after - linear).length() <= 1e-10 * scale);
        prop_assert!((angular_after - angular).abs() <= 1e-10 * scale * 200.0);
    }
}
