//! Ships over a bottom whose depth depends on the place, compared with one depth everywhere and with closed forms.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use crate::ships;
use crate::support;

use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_sim::environment::current::{Current, CurrentGrid};
use fenderline_sim::environment::{DepthField, Tide};
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::vessels::Origin;
use fenderline_sim::hydro::{AddedMass, CrossFlow, Hull, LowSpeedHull, Mmg, Particulars, Squat};
use fenderline_sim::{
    Action, Bottom, Environment, Integrator, Load, Looks, MassProperties, Method, Order, Outside,
    Setup, SetupError, Simulation, StepFault, VesselAction, VesselSetup, WorldSetup,
};
use support::{fixed, rectangle};

const STEPS_S: [f64; 4] = [0.05, 0.2, 0.5, 1.0];
const GRAVITY_MPS2: f64 = 9.80665;
const FRICTION: f64 = 0.4;

/// A field from a function of north and east (m), with cells of 8 m, around the origin.
fn field(half_m: f64, depth_m: impl Fn(f64, f64) -> f64) -> Bottom {
    let side = (half_m / 4.0) as usize + 1;
    let at = |index: usize| index as f64 * 8.0 - half_m;
    let node = |index: usize| depth_m(at(index % side), at(index / side)) as f32;
    let depths_m = (0..side * side).map(node).collect();
    let field = DepthField::new(vec2(-half_m, -half_m), 8.0, side, side, depths_m);
    Bottom { field: Arc::new(field.expect("a field")), outside: Outside::Error, banks: None }
}

/// A box of 192 × 32 × 8 m on which water exerts no force.
pub(crate) fn ship() -> Mmg {
    let none = LowSpeedHull {
        ahead: 0.0,
        astern: 0.0,
        surge_vr: 0.0,
        sway_v: 0.0,
        sway_r: 0.0,
        yaw_v: 0.0,
        yaw_r: 0.0,
        cross_flow: CrossFlow { drag_coefficient: 0.0, yaw_gain_force: 1.0, yaw_gain_moment: 1.0 },
    };
    Mmg {
        particulars: Particulars::from_block(192.0, 32.0, 8.0, 1.0).expect("a box"),
        added_mass: AddedMass { surge_m3: 0.0, sway_m3: 0.0, yaw_m5: 0.0 },
        hull: Hull::deep(None, none),
        propulsion: None,
    }
}

pub(crate) fn with(ship: Mmg, environment: Environment, step_s: f64, duration_s: f64) -> Setup {
    let hull = ship.particulars;
    let mut body = fixed("barge", rectangle(hull.length_m, hull.beam_m));
    body.mass = Some(MassProperties { mass_kg: 1.0, yaw_inertia_kgm2: 1.0, ..Default::default() });
    Setup {
        step_s,
        duration_s,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies: vec![body],
        materials: vec![],
        pairs: vec![],
        all_other_pairs: None,
        approaches: vec![],
        fenders: vec![],
        berthing: None,
        loads: vec![],
        world: WorldSetup {
            environment,
            vessels: vec![VesselSetup {
                body: 0,
                origin: Origin::default(),
                ship,
                deep: ship,
                rudder: RateLimited { value: 0.0, rate_per_s: 0.1, stop: 0.6 },
                shaft: RateLimited { value: 0.0, rate_per_s: 0.1, stop: 1.0 },
                thrusters: vec![],
                azimuths: vec![],
                current_table: None,
                windage: None,
                float: None,
                response: None,
                drift: None,
                seakeeping: None,
                plan: None,
                looks: Looks::default(),
            }],
            ..WorldSetup::default()
        },
    }
}

fn over(bottom: Bottom) -> Environment {
    Environment { bottom: Some(bottom), ..Environment::default() }
}

/// Depth 8 m along the line east = 0, and less by `slope` to the east.
fn beach(slope: f64) -> Bottom {
    field(400.0, move |_, east| 8.0 - slope * east)
}

/// How a box ran up a slope.
struct RunUp {
    /// From the first touch to the farthest place (m).
    ran_m: f64,
    /// The most speed away from the shore (m/s).
    back_mps: f64,
    /// Work of the bottom and of the water on her hull, and the largest residual of the ledger, over her energy at the
    /// start.
    bottom: f64,
    hull: f64,
    residual: f64,
}

/// The box goes east, without squat, from 3.3 m before her front, `front_m` ahead of her middle, touches.
fn runs_up(heading_rad: f64, front_m: f64, slope: f64, speed_mps: f64, step_s: f64) -> RunUp {
    let water = Environment { squat: None, ..over(beach(slope)) };
    let mut setup = with(ship(), water, step_s, 40.0);
    let body = &mut setup.bodies[0];
    body.heading_rad = heading_rad;
    body.position_m = vec2(0.0, -front_m - 3.3);
    body.velocity.surge_mps = speed_mps * heading_rad.sin();
    body.velocity.sway_mps = speed_mps * heading_rad.cos();
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    let start_j = simulation.energy().kinetic_j;
    let [mut farthest_m, mut back_mps, mut residual] = [f64::NEG_INFINITY, 0.0, 0.0_f64];
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let state = record.states_after[0];
        farthest_m = state.position_m.y.max(farthest_m);
        back_mps = (-state.velocity_mps.y).max(back_mps);
        let energy = record.energy();
        residual = residual.max(energy.residual_j.abs() / start_j);
        assert!(energy.kinetic_j <= start_j * (1.0 + 1e-9), "no step adds energy");
    }
    let works = simulation.energy().loads;
    let [bottom, hull] = [works.bottom_j, works.hull_j].map(|work_j| work_j / start_j);
    RunUp { ran_m: farthest_m + front_m, back_mps, bottom, hull, residual }
}

/// ½ M V² = ½ K s(s + μ) d²: the kinetic energy is used up by lift and friction. At the bow K is a quarter of the
/// stiffness ρ g L B of the waterplane, as the box trims. No force of the water acts on a box that goes ahead.
#[test]
fn a_box_runs_up_a_slope_until_lift_and_friction_have_used_up_her_energy() {
    for (slope, speed_mps) in [(1.0 / 32.0, 1.0), (1.0 / 16.0, 2.0)] {
        let stiff = 0.25 * GRAVITY_MPS2 / 8.0 * slope * (slope + FRICTION);
        let closed_m = speed_mps / stiff.sqrt();
        for step_s in STEPS_S {
            let run = runs_up(FRAC_PI_2, 96.0, slope, speed_mps, step_s);
            let off = run.ran_m / closed_m - 1.0;
            println!(
                "slope {slope}, {speed_mps} m/s, step {step_s} s: {:.3} m, closed form {closed_m:.3} m, {:+.2} %; back \
                 {:.4} m/s, residual of the ledger {:.1e}",
                run.ran_m,
                100.0 * off,
                run.back_mps,
                run.residual
            );
            assert!(off.abs() < 0.02, "{slope} {step_s}: {} {closed_m}", run.ran_m);
            assert!(run.back_mps < 0.01, "she does not bounce: {}", run.back_mps);
            assert!((run.bottom + 1.0).abs() < 1e-3 && run.residual < 1e-3, "{}", run.bottom);
        }
    }
}

/// She drifts onto the slope with her side. The water takes a part of her energy; the rest carries her as far as lift and
/// friction allow: the bottom takes ½ K s(s + μ) d².
#[test]
fn a_box_that_drifts_onto_a_slope_goes_as_far_as_the_energy_left_by_the_water() {
    for (slope, speed_mps) in [(1.0 / 16.0, 4.0), (1.0 / 8.0, 4.0)] {
        for step_s in STEPS_S {
            let run = runs_up(0.0, 16.0, slope, speed_mps, step_s);
            let stiff = GRAVITY_MPS2 / 8.0 * slope * (slope + FRICTION);
            let closed_m = speed_mps * ((1.0 + run.hull) / stiff).sqrt();
            let off = run.ran_m / closed_m - 1.0;
            println!(
                "slope {slope}, {speed_mps} m/s, step {step_s} s: the water takes {:.3} of her energy; {:.3} m, closed \
                 form {closed_m:.3} m, {:+.2} %; back {:.4} m/s",
                -run.hull,
                run.ran_m,
                100.0 * off,
                run.back_mps
            );
            assert!(off.abs() < 0.02, "{slope} {step_s}: {} {closed_m}", run.ran_m);
            assert!(run.back_mps < 0.01, "she does not bounce: {}", run.back_mps);
            assert!((run.bottom + run.hull + 1.0).abs() < 1e-3 && run.residual < 1e-3);
        }
    }
}

/// At a bank of 1:1 the way of one step is longer than the slope's whole rise: she gains no energy at any step.
#[test]
fn a_steep_bank_never_adds_energy() {
    for step_s in STEPS_S {
        let bank = field(400.0, |_, east| (8.0 - east).clamp(-20.0, 12.0));
        let mut setup = with(ship(), over(bank), step_s, 60.0);
        setup.bodies[0].position_m = vec2(0.0, -30.0);
        setup.bodies[0].velocity.sway_mps = 3.0;
        setup.bodies[0].velocity.yaw_radps = 0.002;
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        let start_j = simulation.energy().kinetic_j;
        let mut most = 0.0_f64;
        while !simulation.is_done() {
            let record = simulation.step().expect("a good step");
            most = most.max(record.energy().kinetic_j / start_j);
        }
        println!("step {step_s} s: at most {most:.6} of her energy");
        assert!(most < 1.0 + 1e-3, "{step_s}: {most}");
    }
}

/// Her bow sits on the bank; a force at the stern turns her about the bow.
#[test]
fn a_ship_with_her_bow_on_a_bank_swings_about_her_bow() {
    let mut setup = with(ship(), over(beach(1.0 / 32.0)), 0.2, 120.0);
    setup.bodies[0].heading_rad = FRAC_PI_2;
    setup.bodies[0].position_m = vec2(0.0, -96.0 + 8.0);
    setup.loads.push(Load {
        body: 0,
        force_n: vec2(4e5, 0.0),
        moment_nm: 4e5 * 80.0,
        from_s: 0.0,
        until_s: f64::INFINITY,
    });
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    let ends = |state: &BodyState| [96.0, -96.0].map(|x_m| state.pose().apply(vec2(x_m, 0.0)));
    let before = ends(&simulation.states()[0]);
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    assert!(simulation.vessels()[0].aground);
    let after = ends(&simulation.states()[0]);
    let [bow_m, stern_m] = [0, 1].map(|end| (after[end] - before[end]).length());
    println!("the bow moves {bow_m:.2} m, the stern {stern_m:.2} m");
    assert!(stern_m > 20.0 && bow_m < 0.1 * stern_m, "{bow_m} {stern_m}");
}

/// KVLCC2 turns with the tide. Every state has the bits of the run with one depth.
#[test]
fn a_flat_field_is_one_depth() {
    let vessel = ships::kvlcc2();
    let run = |bottom: Option<Bottom>, depth_m: Option<f64>| {
        let tide = Tide::Curve(vec![[0.0, 0.0], [200.0, -1.0]]);
        let environment = Environment { bottom, depth_m, tide, ..Environment::default() };
        let mut setup = with(vessel.ship.at_depth(25.5), environment, 0.5, 200.0);
        let own = &mut setup.world.vessels[0];
        own.deep = vessel.ship;
        own.rudder = vessel.steering;
        own.shaft = RateLimited { value: 1.5, rate_per_s: 0.1, stop: 1.5 };
        let rudder = Action::Vessel(0, VesselAction::Rudder(0.4));
        setup.world.orders = vec![Order { at_s: 0.0, action: rudder }];
        setup.bodies[0].velocity.surge_mps = 6.0;
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        let mut all = Vec::new();
        while !simulation.is_done() {
            let record = simulation.step().expect("a good step");
            let now = &record.vessels[0];
            all.push((record.states_after[0], now.squat_m, now.under_keel_m));
        }
        all
    };
    let flat = field(2000.0, |_, _| 25.5);
    assert_eq!(run(Some(flat), None), run(None, Some(25.5)));
}

/// The same aground: a ship that touches as the tide falls, and one on a bottom above the water.
#[test]
fn a_flat_field_is_one_depth_aground_too() {
    for depth_m in [8.0, -0.5] {
        let run = |bottom: Option<Bottom>, depth_m: Option<f64>| {
            let tide = Tide::Curve(vec![[0.0, 0.25], [60.0, -0.25]]);
            let environment = Environment { bottom, depth_m, tide, ..Environment::default() };
            let mut setup = with(ship(), environment, 0.5, 60.0);
            let velocity = &mut setup.bodies[0].velocity;
            (velocity.surge_mps, velocity.sway_mps, velocity.yaw_radps) = (0.6, -0.3, 0.004);
            let mut simulation = Simulation::new(setup).expect("a good set-up");
            let mut all = Vec::new();
            while !simulation.is_done() {
                let record = simulation.step().expect("a good step");
                all.push((record.states_after[0], record.vessels[0].clone()));
            }
            assert!(simulation.vessels()[0].aground);
            all
        };
        let flat = field(400.0, |_, _| depth_m);
        assert_eq!(run(Some(flat), None), run(None, Some(depth_m)));
    }
}

/// A rough bottom and a ship, and both mirrored at the north axis; then both turned by a quarter.
#[test]
fn a_mirrored_or_turned_bottom_mirrors_or_turns_the_run() {
    let rough = |north: f64, east: f64| {
        8.05 + 0.6 * (north / 60.0).sin() * (east / 45.0 + 0.3).cos() - 0.01 * (north + 0.5 * east)
    };
    let run = |bottom: Bottom, place_m: Vec2, heading_rad: f64, sign: f64| {
        let mut setup = with(ship(), over(bottom), 0.5, 60.0);
        let body = &mut setup.bodies[0];
        (body.position_m, body.heading_rad) = (place_m, heading_rad);
        body.velocity.surge_mps = 1.0;
        body.velocity.sway_mps = sign * 0.4;
        body.velocity.yaw_radps = sign * 0.002;
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        while !simulation.is_done() {
            simulation.step().expect("a good step");
        }
        assert!(simulation.energy().loads.bottom_j.abs() > 1e6, "she was aground");
        simulation.states()[0]
    };
    let here = run(field(400.0, rough), vec2(-60.0, 20.0), 0.3, 1.0);
    let mirrored = run(field(400.0, |n, e| rough(n, -e)), vec2(-60.0, -20.0), -0.3, -1.0);
    let mirror = |at: Vec2| vec2(at.x, -at.y);
    assert!((mirror(here.position_m) - mirrored.position_m).length() < 1e-6, "{mirrored:?}");
    assert!((here.heading_rad + mirrored.heading_rad).abs() < 1e-8);
    let quarter = |at: Vec2| vec2(-at.y, at.x);
    let turned =
        run(field(400.0, |n, e| rough(e, -n)), quarter(vec2(-60.0, 20.0)), 0.3 + FRAC_PI_2, 1.0);
    assert!((quarter(here.position_m) - turned.position_m).length() < 1e-6, "{turned:?}");
    assert!((here.heading_rad + FRAC_PI_2 - turned.heading_rad).abs() < 1e-8);
}

/// Clearances forward and aft on a slope of 1:64, in closed form, in the record of a step.
#[test]
fn clearances_fore_and_aft_are_those_of_the_slope() {
    let slope = field(400.0, |north, _| 12.0 - north / 64.0);
    let mut simulation = Simulation::new(with(ship(), over(slope), 0.5, 10.0)).expect("a set-up");
    let vessel = simulation.setup().world.vessels[0].clone();
    let record = simulation.step().expect("a good step");
    let [fore_m, aft_m] = vessel.clearances_m(0.0, &record.soundings[0]);
    assert!((fore_m.unwrap() - (4.0 - 96.0 / 64.0)).abs() < 1e-9);
    assert!((aft_m.unwrap() - 4.0).abs() < 1e-9, "midship");
    assert_eq!(record.vessels[0].under_keel_m, fore_m);
}

/// A dredged trench 112 m wide at the bottom and 14 m deep with slopes of 1:4, in water of 6 m, by hand. The width of
/// influence is 7.7 B = 246.4 m for a box.
#[test]
fn a_trench_has_its_section_and_squat_follows_its_blockage() {
    let section = |_: f64, east: f64| {
        let off_m = east.abs() - 56.0;
        14.0 - (off_m / 4.0).clamp(0.0, 8.0)
    };
    let bottom = field(400.0, section);
    // 112 × 14, two slopes of 32 m with a mean of 10 m, and 2 × 35.2 m at 6 m.
    let by_hand_m2 = 112.0 * 14.0 + 2.0 * 32.0 * 10.0 + 2.0 * (123.2 - 88.0) * 6.0;
    let found_m2 = bottom.section_m2(vec2(0.0, 0.0), vec2(1.0, 0.0), 0.0, 123.2);
    assert!((found_m2 / by_hand_m2 - 1.0).abs() < 1e-3, "{found_m2} {by_hand_m2}");
    let squat_by = |formula: Squat, bottom: Option<Bottom>, depth_m: Option<f64>| {
        let squat = Some(formula);
        let water = Environment { bottom, depth_m, squat, ..Environment::default() };
        let mut setup = with(ship(), water, 0.5, 10.0);
        setup.bodies[0].velocity.surge_mps = 4.0;
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        simulation.step().expect("a good step").vessels[0].squat_m
    };
    let squat_m = |bottom: Option<Bottom>, depth_m: Option<f64>| {
        squat_by(Squat::BarrassChannel, bottom, depth_m)
    };
    // ICORELS with blockage looks 15.2 beams (486.7 m) to either side, here as far as the data go.
    let whole_m2 = 112.0 * 14.0 + 2.0 * 32.0 * 10.0 + 2.0 * (400.0 - 88.0) * 6.0;
    let factor = 7.45 * 0.98 * 32.0 * 8.0 / whole_m2 + 0.76;
    let canal_m = squat_by(Squat::IcorelsChannel, Some(bottom.clone()), None);
    let wide_m = squat_by(Squat::Icorels, Some(bottom.clone()), None);
    println!(
        "ICORELS {canal_m:.3} m in the trench, {wide_m:.3} m without blockage, {factor:.4} by hand"
    );
    assert!(
        (canal_m / wide_m / factor - 1.0).abs() < 2e-3 && factor > 1.05,
        "{canal_m} {wide_m} {factor}"
    );
    let own_m2 = 32.0 * 8.0;
    let returns = own_m2 / (by_hand_m2 - own_m2);
    let knots = 4.0 * 3600.0 / 1852.0_f64;
    let wanted_m = returns.powf(2.0 / 3.0) * knots.powf(2.08) / 30.0;
    let (trench_m, open_m) = (squat_m(Some(bottom), None), squat_m(None, Some(14.0)));
    println!(
        "squat {trench_m:.3} m in the trench, {wanted_m:.3} m by hand; {open_m:.3} m in open water"
    );
    assert!((trench_m / wanted_m - 1.0).abs() < 1e-3 && trench_m > 1.1 * open_m);
    // A flat field is open water: she has no banks.
    let flat_m = squat_m(Some(field(400.0, |_, _| 14.0)), None);
    assert!((flat_m / open_m - 1.0).abs() < 1e-9, "{flat_m} {open_m}");
}

#[test]
fn off_the_data_a_step_names_ship_place_and_time_and_changes_nothing() {
    let mut setup = with(ship(), over(field(400.0, |_, _| 20.0)), 0.5, 600.0);
    setup.bodies[0].velocity.surge_mps = 2.0;
    let mut simulation = Simulation::new(setup.clone()).expect("a good set-up");
    let error = loop {
        match simulation.step() {
            Ok(_) => {}
            Err(error) => break error,
        }
    };
    assert!((error.t_s - 152.5).abs() <= 0.5, "{error}");
    assert!(matches!(&error.cause, StepFault::NoDepth(at) if at.body == "barge"), "{error}");
    let text = error.to_string();
    assert!(text.contains("`barge` is off the data of the bottom"), "{text}");
    assert!(text.starts_with("at t = 152.5 s") && text.contains("m north"), "{text}");
    let before = simulation.states().to_vec();
    assert_eq!(simulation.step().unwrap_err(), error);
    assert_eq!(simulation.states(), before);
    // A chosen depth outside lets her go on, and there she is aground.
    let mut chosen = setup.clone();
    chosen.world.environment.bottom.as_mut().unwrap().outside = Outside::Depth(7.0);
    let mut simulation = Simulation::new(chosen).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    assert!(simulation.vessels()[0].aground);
    // At the start she must be over the data.
    setup.bodies[0].position_m = vec2(0.0, 500.0);
    let refused = Simulation::new(setup.clone()).unwrap_err();
    assert!(matches!(refused, SetupError::NoDepth(_)), "{refused}");
    setup.world.environment.depth_m = Some(10.0);
    let text = Simulation::new(setup).unwrap_err().to_string();
    assert!(text.contains("give only one of the two"), "{text}");
}

#[test]
fn a_run_shares_the_field() {
    let bottom = field(400.0, |_, _| 20.0);
    let shared = Arc::clone(&bottom.field);
    let setup = with(ship(), over(bottom), 0.5, 10.0);
    let mut runs: Vec<Simulation> =
        (0..4).map(|_| Simulation::new(setup.clone()).expect("a good set-up")).collect();
    for run in &mut runs {
        run.step().expect("a good step");
    }
    assert_eq!(Arc::strong_count(&shared), 6);
}

/// A stream to the east that grows by 1 kn over the length of a ship that lies north: −½ kn at the stern, ½ kn at the bow.
/// By hand the cross-flow drag turns her to starboard with ½ ρ T C ω² L⁴/32, ω = 1 kn/L, and does not push her.
#[test]
fn a_shear_of_the_current_along_a_ship_turns_her() {
    let knot_mps = 1852.0 / 3600.0;
    let grid = CurrentGrid::new(
        vec![0.0],
        vec![-192.0, 192.0],
        vec![0.0],
        vec![vec2(0.0, -knot_mps), vec2(0.0, knot_mps)],
    );
    let current = Some(Current::Grid(grid.expect("a grid")));
    let mut box_ship = ship();
    let drag = 0.6;
    box_ship.hull.low_speed.cross_flow.drag_coefficient = drag;
    box_ship.hull = Hull::deep(None, box_ship.hull.low_speed);
    let water = Environment { current, ..Environment::default() };
    let mut simulation = Simulation::new(with(box_ship, water, 0.5, 10.0)).expect("a set-up");
    let force = simulation.step().expect("a good step").vessel_forces[0].hull;
    let turning_radps = knot_mps / 192.0;
    let by_hand_nm =
        0.5 * 1025.0 * 8.0 * drag * turning_radps * turning_radps * 192.0_f64.powi(4) / 32.0;
    println!("yaw moment {:.4e} N m, by hand {by_hand_nm:.4e} N m", force.yaw_nm);
    assert!((force.yaw_nm / by_hand_nm - 1.0).abs() < 1e-9, "{force:?} {by_hand_nm}");
    assert!(force.sway_n.abs() < 1e-6 && force.surge_n.abs() < 1e-6, "{force:?}");
}

/// Prints the time of a step afloat in one depth, over a field, and aground on a slope:
/// `cargo test -p fenderline-sim --test all a_step_over_a_field -- --ignored --nocapture`.
#[test]
#[ignore = "prints times"]
fn a_step_over_a_field_costs_little() {
    let vessel = ships::kvlcc2();
    let deep_enough = |north: f64, east: f64| 30.0 + 0.01 * north - 0.004 * east;
    let on_slope = |_: f64, east: f64| 20.8 - east / 64.0;
    for (name, bottom, depth_m) in [
        ("one depth", None, Some(30.0)),
        ("a field", Some(field(2000.0, deep_enough)), None),
        ("aground", Some(field(2000.0, on_slope)), None),
    ] {
        let tide = Tide::Curve(vec![[0.0, 0.0], [3600.0, 0.1]]);
        let environment = Environment { bottom, depth_m, tide, ..Environment::default() };
        let mut setup = with(vessel.ship, environment, 0.5, 1e6);
        setup.bodies[0].velocity.surge_mps = if name == "aground" { 0.0 } else { 0.5 };
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        let mut least_us = f64::INFINITY;
        for _ in 0..20 {
            let start = std::time::Instant::now();
            for _ in 0..50 {
                simulation.step().expect("a good step");
            }
            least_us = least_us.min(start.elapsed().as_secs_f64() * 1e6 / 50.0);
        }
        println!("{name}: {least_us:.1} µs a step, aground: {}", simulation.vessels()[0].aground);
    }
}
