//! Fenders in a simulation: stored energy, reaction and failure.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::support;

use std::f64::consts::PI;

use fenderline_contact::{EventKind, Material, ReactionFactors, vec2};
use fenderline_sim::berthing::{
    AddedMass, AddedMassFormula, BerthingSetup, Configuration, OtherShip, Softness,
};
use fenderline_sim::{
    BodySetup, Energy, FenderSetup, Finding, Gravity, HullPressure, Integrator, Load, Method,
    NamedMaterial, PairSetup, Setup, Simulation, Verdict, fender_finding,
};
use proptest::prelude::*;
use support::scenes::{cone, cone_fender};
use support::{fixed, floating, rectangle, spring};

fn run(setup: Setup) -> Simulation {
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    simulation
}

/// A cone fender on the quay at `along_m`, with a hull pressure of at most 200 kN/m².
fn fender(name: &str, along_m: f64, height_m: f64, rated_reaction_n: f64) -> FenderSetup {
    FenderSetup {
        hull_pressure_limit_npm2: Some(200e3),
        ..cone_fender(name, along_m, height_m, rated_reaction_n)
    }
}

/// The paper's container ship beside a quay with fenders, `gap_m` off them, with her port side away from the quay.
fn berth(fenders: Vec<FenderSetup>, gap_m: f64, step_s: f64, duration_s: f64) -> Setup {
    let mut ship: BodySetup = floating("ship", rectangle(298.0, 46.0), 87.8e6, 74.5);
    ship.mass.as_mut().expect("she floats").added_sway_kg = 0.5 * 87.8e6;
    ship.mass.as_mut().expect("she floats").added_surge_kg = 0.03 * 87.8e6;
    let projection_m = fenders.first().map_or(0.0, |f| f.projection_m);
    ship.position_m = vec2(0.0, -23.0 - projection_m - gap_m);
    let quay = fixed(
        "quay",
        support::outline(&[
            vec2(-250.0, 0.0),
            vec2(250.0, 0.0),
            vec2(250.0, 20.0),
            vec2(-250.0, 20.0),
        ]),
    );
    let mut concrete = spring(50e6, 0.1);
    concrete.shear_stiffness_npm = 1e7;
    concrete.friction_static = 0.5;
    concrete.friction_dynamic = 0.5;
    let facing = Material {
        shear_stiffness_npm: 3e6,
        friction_static: 0.2,
        friction_dynamic: 0.2,
        ..spring(0.0, 0.1)
    };
    let named = |name: &str, material| NamedMaterial { name: name.into(), material };
    Setup {
        step_s,
        duration_s,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies: vec![quay, ship],
        materials: vec![named("concrete", concrete), named("facing", facing)],
        pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
        all_other_pairs: None,
        approaches: vec![],
        fenders,
        berthing: None,
        loads: vec![],
        world: fenderline_sim::WorldSetup::default(),
    }
}

fn row_of(count: usize, height_m: f64, rated_reaction_n: f64) -> Vec<FenderSetup> {
    (0..count)
        .map(|k| {
            let along_m = -105.0 + 210.0 * k as f64 / (count - 1).max(1) as f64;
            fender(&format!("fender {k:02}"), along_m, height_m, rated_reaction_n)
        })
        .collect()
}

/// Checks that the energy ledger closes to rounding.
fn assert_balanced(energy: &Energy, start_j: f64) {
    let parts_j = energy.stored_j
        + energy.shear_stored_j
        + energy.damping_j
        + energy.restitution_j
        + energy.friction_j
        + energy.contact_residual_j;
    let lost_j = -(energy.normal_work_j + energy.tangential_work_j);
    assert!((parts_j - lost_j).abs() < 1e-9 * start_j, "{energy:?}");
}

#[test]
fn an_87800_t_ship_does_not_sail_through_a_small_fender() {
    // The fender is 2 m wide and 1 m deep. It can absorb 0.4 MJ, and the ship has 4.1 MJ.
    for step_s in [0.1, 1.0] {
        let small = fender("small", 0.0, 1.0, 0.8e6);
        let capacity_j = small.rated.expect("a curve").energy_j;
        let mut setup = berth(vec![small], 0.2, step_s, 120.0);
        setup.bodies[1].velocity.sway_mps = 0.25;
        let mut simulation = Simulation::new(setup).unwrap();
        let mut told = vec![];
        let mut deepest_m = f64::MIN;
        while !simulation.is_done() {
            let record = simulation.step().unwrap();
            told.extend(record.events.iter().map(|event| event.kind));
            deepest_m = deepest_m.max(record.states_after[1].position_m.y + 23.0);
        }
        // The ship's side is at most a hand's breadth behind the quay's face.
        assert!(deepest_m < 0.1, "Δt {step_s}: {deepest_m} m behind the quay's face");
        let fender = told.iter().filter(|kind| matches!(kind, EventKind::FenderFailed(_)));
        assert_eq!(fender.count(), 1, "{told:?}");
        let summary = simulation.fender_summaries().next().expect("touched").clone();
        assert!(summary.failed);
        assert!(summary.peak_energy_j > 2.0 * capacity_j);
        assert!(summary.share_of_rated_energy.unwrap() > 2.0);
        // The ship rebounds no faster than γ allows.
        let back_mps = -simulation.states()[1].velocity_mps.y;
        assert!(back_mps > 0.0 && back_mps < 0.03, "Δt {step_s}: {back_mps} m/s");
    }
}

#[test]
fn a_berthing_puts_its_energy_into_the_fenders_and_the_ledger_balances() {
    for step_s in [0.02, 0.1, 0.5, 2.0] {
        let mut setup = berth(row_of(8, 1.2, 1.2e6), 0.3, step_s, 60.0);
        setup.bodies[1].velocity.sway_mps = 0.15;
        let mut simulation = Simulation::new(setup).unwrap();
        let start_j = simulation.energy().kinetic_j;
        let mut most_stored_j = 0.0_f64;
        while !simulation.is_done() {
            let record = simulation.step().unwrap();
            assert_balanced(&record.energy(), start_j);
            most_stored_j = most_stored_j.max(record.energy().stored_j);
        }
        let energy = simulation.energy();
        // At the greatest deflection all energy is in the fenders, within the error of a step.
        let peaks_j: f64 = simulation.fender_summaries().map(|f| f.peak_energy_j).sum();
        assert!((peaks_j / start_j - 1.0).abs() < 0.02, "Δt {step_s}: {peaks_j} of {start_j} J");
        assert!((energy.kinetic_j / start_j - 0.01).abs() < 0.001, "γ² goes back: {energy:?}");
        assert!(energy.contact_residual_j.abs() < 0.02 * start_j, "Δt {step_s}: {energy:?}");
        assert!(energy.restitution_j > 0.95 * start_j, "Δt {step_s}: {energy:?}");
    }
}

#[test]
fn factors_scale_the_reaction_and_are_those_of_the_first_touch() {
    let mut warm = fender("warm", 0.0, 1.2, 1.2e6);
    warm.factors = ReactionFactors {
        constant: 1.1,
        by_compression_time: vec![[1.0, 1.2], [5.0, 1.11], [10.0, 1.07], [20.0, 1.03]],
        by_angle: vec![[0.0, 1.0], [0.17, 1.0], [0.26, 0.95]],
    };
    let mut setup = berth(vec![warm], 0.2, 0.1, 30.0);
    setup.bodies[1].velocity.sway_mps = 0.05;
    let simulation = run(setup);
    let summary = simulation.fender_summaries().next().expect("touched");
    // t = 0.864/(0.74·0.05) = 23 s is beyond the table's end.
    assert!((summary.factor - 1.1 * 1.03).abs() < 1e-9, "{}", summary.factor);
    assert!((summary.approach_speed_mps - 0.05).abs() < 1e-9);
    let free = cone(1.2, 1.2e6).reaction_n(summary.peak_deflection_m);
    let peak = summary.peak_reaction_n / (free * summary.factor);
    assert!((peak - 1.0).abs() < 0.02, "{peak}");
}

/// A curve peaks at 101 % of its rated reaction. The shares refer to the rated value. The fender is not over-rated
/// while it stays within its curve.
#[test]
fn a_curve_may_peak_above_its_rated_reaction() {
    let mut buckles = fender("buckles", 0.0, 1.6, 3e6);
    buckles.hull_pressure_limit_npm2 = None;
    let rated = buckles.rated.expect("a curve");
    let given_n = rated.largest_reaction_n / 1.01;
    buckles.rated = Some(rated.with_reaction(given_n));
    assert!((buckles.rated.unwrap().curve_peak() - 1.01).abs() < 1e-12);
    let mut setup = berth(vec![buckles.clone()], 0.3, 0.05, 40.0);
    setup.bodies[1].velocity.sway_mps = 0.18;
    let simulation = run(setup);
    let summary = simulation.fender_summaries().next().expect("touched");
    let by_hand = summary.peak_reaction_n / given_n;
    assert!((summary.share_of_rated_reaction.unwrap() / by_hand - 1.0).abs() < 1e-12);
    assert!(by_hand > 1.0 && by_hand < 1.0101, "{by_hand}");
    assert!(summary.share_of_rated_energy.unwrap() < 1.0, "{summary:?}");
    assert_ne!(summary.governing().unwrap().0, "reaction");
    assert_eq!(fender_finding(summary, &buckles), None);
}

fn particulars() -> BerthingSetup {
    BerthingSetup {
        ship: 1,
        length_bp_m: 285.0,
        beam_m: 46.0,
        draught_m: 9.0,
        under_keel_clearance_m: 3.0,
        block_coefficient: 0.73,
        added_mass: AddedMass::By(AddedMassFormula::Pianc2002),
        softness: Softness::Soft,
        configuration: Configuration::SolidQuay,
        design_speed_mps: None,
        abnormal_factor: None,
    }
}

/// The ship comes parallel onto five fenders. The group takes all her energy, with Ce = 1, and not the share of the
/// fender at the end. If two fenders stand ahead of her centre of gravity, the nearer one counts. If she comes at an
/// angle, the fender that she meets counts.
#[test]
fn ce_of_a_parallel_touch_is_that_of_the_whole_group() {
    let study = |at_m: &[f64], heading_deg: f64| {
        let fenders = at_m.iter().enumerate();
        let fenders =
            fenders.map(|(k, along_m)| fender(&format!("f{k}"), *along_m, 1.6, 3e6)).collect();
        let mut setup = berth(fenders, 0.9, 0.05, 40.0);
        setup.bodies[1].velocity.sway_mps = 0.12 * heading_deg.to_radians().cos();
        setup.bodies[1].velocity.surge_mps = 0.12 * heading_deg.to_radians().sin();
        setup.bodies[1].heading_rad = heading_deg.to_radians();
        setup.berthing = Some(particulars());
        run(setup).berthing().expect("touched").expect("a ship").clone()
    };
    let five = study(&[-60.0, -30.0, 0.0, 30.0, 60.0], 0.0);
    assert_eq!((five.fenders.len(), five.along_m, five.eccentricity), (5, 0.0, 1.0));
    assert!((five.eccentricity_measured - 1.0).abs() < 0.01, "{}", five.eccentricity_measured);
    // By hand the energy is ½ M V² Cm Cc.
    let by_hand_j = 0.5 * 87.8e6 * 0.12 * 0.12 * (1.875 - 0.75 * 3.0 / 9.0) * 0.8;
    assert!((five.energy_j / by_hand_j - 1.0).abs() < 1e-9, "{}", five.energy_j);

    let ahead = study(&[30.0, 60.0], 0.0);
    assert_eq!((ahead.fenders.len(), (ahead.along_m - 30.0).abs() < 1e-6), (2, true));
    // At half a degree the hull is still 0.26 m from the nearer fender when it meets the other.
    let oblique = study(&[30.0, 60.0], 0.5);
    assert_eq!(oblique.fenders, [1]);
    assert!((oblique.along_m - 60.0).abs() < 0.5, "{}", oblique.along_m);
    assert!(oblique.eccentricity < ahead.eccentricity);
}

/// The ship meets a fender at a = 70 m ahead, turns, and meets a fender as far astern that stands back. These are two
/// hits without friction. With the radius of gyration K and the restitution e, the first hit takes ½ M v² K²/(K² + a²).
/// After it the point astern closes at v [1 − (1 + e)(K² − a²)/(K² + a²)]. The second hit takes the energy of the
/// first, times the square of this speed over v².
#[test]
fn the_second_hit_takes_what_the_first_left_in_her_turn() {
    let (v_mps, arm_m, restitution) = (0.12, 70.0, 0.5);
    let mut setup = berth(
        vec![fender("ahead", arm_m, 1.6, 12e6), fender("astern", -arm_m, 1.6, 12e6)],
        0.3,
        0.05,
        60.0,
    );
    setup.fenders[1].position_m.y += 0.6;
    let facing = &mut setup.materials[1].material;
    (facing.restitution, facing.shear_stiffness_npm) = (restitution, 0.0);
    (facing.friction_static, facing.friction_dynamic) = (0.0, 0.0);
    setup.bodies[1].velocity.sway_mps = v_mps;
    setup.berthing = Some(particulars());
    let simulation = run(setup);
    let outcome = simulation.berthing().expect("touched").expect("a ship");
    let (k2, a2) = (outcome.gyradius_simulated_m.powi(2), arm_m * arm_m);
    let first_j = outcome.kinetic_j * k2 / (k2 + a2);
    let closing = 1.0 - (1.0 + restitution) * (k2 - a2) / (k2 + a2);
    let second_j = first_j * closing * closing;
    // The arms change with the turn by half a degree, and a step is 0.05 s.
    assert!((outcome.fender_energy_j / first_j - 1.0).abs() < 0.01, "{outcome:?} {first_j}");
    let later = outcome.later.expect("she swings in");
    assert!((later.energy_j / second_j - 1.0).abs() < 0.02, "{later:?} {second_j}");
    assert_eq!(later.number, 2);
    // Each fender took one of the two hits.
    let fenders: Vec<_> = simulation.fender_summaries().collect();
    let hits = fenders.iter().map(|f| outcome.hit_at(f.peak_energy_at_s));
    assert_eq!(hits.collect::<Vec<_>>(), [Some(1), Some(2)]);
    // The stored energy is known at the ends of the steps. A fender's peak is known within the steps.
    assert!((fenders[1].peak_energy_j / later.energy_j - 1.0).abs() < 0.005, "{later:?}");
    assert_eq!(outcome.hit_at(outcome.first_hit_until_s.expect("over") + 1e-3), None);
}

/// The design speed is 0.15 m/s and the speed in the run 0.12 m/s. The formula has (0.15/0.12)² of the energy at the
/// touch. Her Cm in the run is 1 + 0.5, as the body has it.
#[test]
fn the_formula_takes_the_design_speed() {
    let mut setup = berth(vec![fender("one", 0.0, 1.6, 3e6)], 0.3, 0.1, 10.0);
    setup.bodies[1].velocity.sway_mps = 0.12;
    setup.berthing = Some(BerthingSetup { design_speed_mps: Some(0.15), ..particulars() });
    let simulation = run(setup);
    let outcome = simulation.berthing().expect("touched").expect("a ship");
    let by_hand_j = 0.5 * 87.8e6 * 0.15 * 0.15 * (1.875 - 0.75 * 3.0 / 9.0) * 0.8;
    assert!((outcome.energy_j / by_hand_j - 1.0).abs() < 1e-9, "{outcome:?}");
    let at_touch = outcome.energy_at_touch_j / outcome.energy_j;
    assert!((at_touch - 0.64).abs() < 1e-9, "{at_touch}");
    assert_eq!((outcome.formula_speed_mps(), outcome.energies_differ()), (0.15, true));
    assert!(outcome.why_speeds_differ().contains("slowed the ship"));
    // The energy that the fenders took is compared with the energy of the run.
    assert!((outcome.eccentricity_measured - 1.0).abs() < 0.01, "{outcome:?}");
    assert!((outcome.added_sway.deep - 0.5).abs() < 1e-12 && outcome.added_sway.shallow.is_none());
    let text = outcome.mass_of_run();
    assert_eq!(text, "Cm 1.50 of the run: 1 + 0.50, her added mass in sway over her displacement");
}

/// A speed that is 1 % off makes an energy that is 2 % off: the report then shows both energies. For half of this
/// difference it shows one.
#[test]
fn the_energies_of_two_speeds_are_both_shown_where_they_differ_by_a_percent() {
    for (at_touch_mps, differ, why) in
        [(0.1515, true, "faster"), (0.1485, true, "slowed"), (0.1506, false, "faster")]
    {
        let mut setup = berth(vec![fender("one", 0.0, 1.6, 3e6)], 0.3, 0.1, 10.0);
        setup.bodies[1].velocity.sway_mps = at_touch_mps;
        setup.berthing = Some(BerthingSetup { design_speed_mps: Some(0.15), ..particulars() });
        let simulation = run(setup);
        let outcome = simulation.berthing().expect("touched").expect("a ship");
        assert_eq!(outcome.energies_differ(), differ, "{at_touch_mps}");
        assert!(outcome.why_speeds_differ().contains(why), "{}", outcome.why_speeds_differ());
    }
}

/// Cold rubber is stiffer. The reaction is above the catalogue's value and within the rating of this run. The verdict
/// is then not "All well".
#[test]
fn a_reaction_above_the_catalogue_is_found_where_the_factors_of_the_run_allow_it() {
    let mut setup = berth(vec![fender("cold", 0.0, 1.6, 3e6)], 0.3, 0.05, 40.0);
    setup.bodies[1].velocity.sway_mps = 0.18;
    setup.fenders[0].hull_pressure_limit_npm2 = None;
    assert_eq!(run(setup.clone()).findings(), []);
    setup.fenders[0].factors.constant = 1.2;
    let simulation = run(setup);
    let summary = simulation.fender_summaries().next().expect("touched");
    let by_hand = summary.peak_reaction_n / 3e6;
    let findings = simulation.findings();
    let [
        Finding::AboveCatalogue { fender: 0, quantity: "reaction", share, share_of_run, others: 0 },
    ] = findings[..]
    else {
        panic!("{findings:?}")
    };
    assert!((share / by_hand - 1.0).abs() < 1e-9 && share > 1.15, "{share} {by_hand}");
    assert!((share_of_run * summary.factor / share - 1.0).abs() < 1e-12 && share_of_run < 1.005);
    assert_eq!(Verdict::of(&findings).gravity(), Gravity::Note);
}

/// Two equal ships close at 0.1 m/s. The reduced mass is half of one ship's mass, and the speed is that between the two
/// hulls.
#[test]
fn ship_to_ship_the_energy_is_that_of_the_reduced_mass() {
    let mut setup = berth(vec![fender("between", 0.0, 1.6, 3e6)], 0.3, 0.05, 40.0);
    let mut other = setup.bodies[1].clone();
    other.name = "other".into();
    other.position_m = vec2(0.0, 10.0);
    other.outline = support::outline(&[
        vec2(-149.0, -10.0),
        vec2(149.0, -10.0),
        vec2(149.0, 36.0),
        vec2(-149.0, 36.0),
    ]);
    other.velocity.sway_mps = -0.04;
    setup.bodies[0] = other;
    setup.fenders[0].position_m = vec2(0.0, -10.0);
    setup.bodies[1].velocity.sway_mps = 0.06;
    setup.berthing = Some(BerthingSetup {
        added_mass: AddedMass::Given(1.5),
        configuration: Configuration::OpenPiles,
        ..particulars()
    });
    let simulation = run(setup);
    let outcome = simulation.berthing().expect("touched").expect("a ship");
    assert_eq!(outcome.displacement_kg, 0.5 * 87.8e6);
    assert_eq!(outcome.other, Some(OtherShip { displacement_kg: 87.8e6, added_mass: 1.5 }));
    assert_eq!(
        outcome.mass_of_run(),
        "Cm 1.50 of the run: reduced mass of the two ships with added mass, divided by the reduced mass of their \
         displacements; Cm of the other ship alone 1.50; Cm of this ship alone 1.50, 1 + 0.50, her added mass in \
         sway over her displacement"
    );
    assert!((outcome.speed_mps - 0.1).abs() < 1e-9, "{}", outcome.speed_mps);
    let by_hand_j = 0.5 * 43.9e6 * 1.5 * 0.01;
    assert!((outcome.kinetic_j / by_hand_j - 1.0).abs() < 1e-9, "{}", outcome.kinetic_j);
    assert!((outcome.energy_j / by_hand_j - 1.0).abs() < 1e-3, "{}", outcome.energy_j);
    let measured = outcome.eccentricity_measured;
    assert!((measured - 1.0).abs() < 0.01, "{measured}");
}

/// The ship comes straight at a fender 60 m ahead of midships, with her side along the quay. By the formula Ce is (K² +
/// R² cos²γ)/(K² + R²) where the face holds her, and K²/(K² + a²) where she slides freely.
#[test]
fn the_study_of_a_berthing_agrees_with_the_eccentricity_factor() {
    for (friction, shear_npm) in [(0.0, 0.0), (100.0, 1e11)] {
        let mut setup = berth(vec![fender("ahead", 60.0, 1.6, 3e6)], 0.3, 0.1, 40.0);
        setup.materials[1].material.friction_static = friction;
        setup.materials[1].material.friction_dynamic = friction;
        setup.materials[1].material.shear_stiffness_npm = shear_npm;
        setup.bodies[1].velocity.sway_mps = 0.12;
        setup.berthing = Some(particulars());
        let simulation = run(setup);
        let outcome = simulation.berthing().expect("touched").expect("a ship");
        assert!((outcome.along_m - 60.0).abs() < 1e-6, "{}", outcome.along_m);
        assert!((outcome.speed_mps - 0.12).abs() < 1e-9);
        assert!((outcome.kinetic_j / (0.5 * 1.5 * 87.8e6 * 0.0144) - 1.0).abs() < 1e-9);
        let k = outcome.gyradius_simulated_m;
        let frictionless = k * k / (k * k + outcome.along_m * outcome.along_m);
        // The formula's mass is the same in all directions. Here she is lighter in surge. Where the face holds her,
        // this costs her a little more energy.
        let (by_formula, tolerance) = if friction == 0.0 {
            (frictionless, 0.01)
        } else {
            (outcome.eccentricity_of_run, 0.05)
        };
        let measured = outcome.eccentricity_measured;
        assert!((measured / by_formula - 1.0).abs() < tolerance, "{measured}, not {by_formula}");
        assert_eq!(outcome.configuration, 0.8);
    }
}

/// A ship with wind towards the quay and a current along it. Friction could hold more than the current's pull.
fn moored(step_s: f64, duration_s: f64) -> Setup {
    let mut setup = berth(row_of(8, 1.2, 1.2e6), 0.0, step_s, duration_s);
    // Eight fenders bear 0.2·8.64 MN. A fender with 0.2 MN is compressed by 0.025·1.2 m on the first line of the curve.
    let per_fender_n = 0.1 * 1.2e6;
    setup.bodies[1].position_m.y += 0.025 * 1.2;
    let load =
        |force_n, from_s| Load { body: 1, force_n, moment_nm: 0.0, from_s, until_s: f64::INFINITY };
    // Friction holds 0.2 of the pressing force. The pull is a tenth, and grows in ten parts over the first half minute.
    // A sudden pull would make her swing on her fenders' shear, which has no damping of its own.
    setup.loads = vec![load(vec2(0.0, 8.0 * per_fender_n), 0.0)];
    setup
        .loads
        .extend((0..10).map(|k| load(vec2(0.01 * 8.0 * per_fender_n, 0.0), 3.0 * f64::from(k))));
    setup
}

#[test]
fn a_day_alongside_in_steady_wind_drifts_less_than_a_millimetre_and_gains_nothing() {
    for step_s in [0.5, 2.0] {
        let mut simulation = Simulation::new(moored(step_s, 24.0 * 3600.0)).unwrap();
        let mut after_a_minute = None;
        // The largest kinetic energy in the first minute, and in each hour after it.
        let (mut first_j, mut hours_j) = (0.0_f64, vec![0.0_f64; 24]);
        while !simulation.is_done() {
            let energy = simulation.step().unwrap().energy();
            if simulation.time_s() < 60.0 {
                first_j = first_j.max(energy.kinetic_j);
                continue;
            }
            let state = simulation.states()[1];
            let start = *after_a_minute.get_or_insert(state);
            let drift_m = (state.position_m - start.position_m).length();
            assert!(drift_m < 1e-3, "Δt {step_s}: {drift_m} m at {} s", simulation.time_s());
            let hour = (simulation.time_s() / 3600.0) as usize;
            hours_j[hour.min(23)] = hours_j[hour.min(23)].max(energy.kinetic_j);
        }
        assert!(hours_j[0] <= first_j, "Δt {step_s}: {first_j} J, then {hours_j:?}");
        assert!(hours_j.is_sorted_by(|one, next| *next <= one + 1e-12), "{hours_j:?}");
        let depth_m = simulation.states()[1].position_m.y + 23.0 + 1.2;
        assert!((depth_m / 0.03 - 1.0).abs() < 0.005, "Δt {step_s}: {depth_m} m");
        // The work of the loads equals the stored energy.
        let energy = simulation.energy();
        assert!(energy.normal_work_j + energy.tangential_work_j <= 0.0, "{energy:?}");
    }
}

/// A random body with random speeds and spin hits a fender on a floating pontoon.
fn episode(seed: &Episode) -> Setup {
    let mut setup = berth(vec![fender("one", 0.0, 1.2, 1.2e6)], 0.0, seed.step_s, 20.0);
    let mass = fenderline_sim::MassProperties {
        mass_kg: seed.mass_kg,
        yaw_inertia_kgm2: seed.mass_kg * 100.0,
        added_sway_kg: seed.mass_kg * seed.added,
        ..Default::default()
    };
    setup.bodies[0].mass = Some(mass);
    setup.bodies[1] = floating("tug", rectangle(32.0, 11.0), 6e5, 8.0);
    let tug = &mut setup.bodies[1];
    tug.mass.as_mut().unwrap().added_sway_kg = 4e5;
    tug.heading_rad = seed.heading_rad;
    // The point of the hull nearest to the quay lies a little off the face.
    let (sin, cos) = (libm::sin(seed.heading_rad).abs(), libm::cos(seed.heading_rad).abs());
    tug.position_m = vec2(seed.along_m, -1.2 - (16.0 * sin + 5.5 * cos) - 0.05);
    let (sin, cos) = (libm::sin(seed.heading_rad), libm::cos(seed.heading_rad));
    // The velocity towards the quay (east) and along it (north).
    tug.velocity.surge_mps = seed.slide_mps * cos + seed.approach_mps * sin;
    tug.velocity.sway_mps = -seed.slide_mps * sin + seed.approach_mps * cos;
    tug.velocity.yaw_radps = seed.spin_radps;
    setup.materials[1].material.restitution = seed.restitution;
    setup.materials[1].material.friction_static = seed.friction;
    setup.materials[1].material.friction_dynamic = seed.friction * 0.8;
    setup.materials[0].material.restitution = seed.restitution;
    setup
}

#[derive(Clone, Debug)]
struct Episode {
    mass_kg: f64,
    added: f64,
    heading_rad: f64,
    along_m: f64,
    approach_mps: f64,
    slide_mps: f64,
    spin_radps: f64,
    restitution: f64,
    friction: f64,
    step_s: f64,
}

fn episodes() -> impl Strategy<Value = Episode> {
    let mass = (5.0..8.0_f64).prop_map(libm::exp10);
    (
        (mass, 0.0..0.6_f64, -PI..PI, -18.0..18.0_f64, 0.05..1.5_f64),
        (
            -0.5..0.5_f64,
            -0.05..0.05_f64,
            0.0..0.9_f64,
            0.0..0.6_f64,
            prop_oneof![Just(0.05), Just(0.1), Just(0.5), Just(1.0)],
        ),
    )
        .prop_map(|((mass_kg, added, heading_rad, along_m, approach_mps), rest)| {
            let (slide_mps, spin_radps, restitution, friction, step_s) = rest;
            Episode {
                mass_kg,
                added,
                heading_rad,
                along_m,
                approach_mps,
                slide_mps,
                spin_radps,
                restitution,
                friction,
                step_s,
            }
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// `cargo xtask passivity` runs 100,000 such episodes. The tolerance of 1e-9 is for rounding.
    #[test]
    fn nobody_leaves_a_fender_with_more_energy_than_it_came_with(seed in episodes()) {
        let simulation = Simulation::new(episode(&seed));
        let mut simulation = simulation.expect("a good set-up");
        let before_j = simulation.energy().kinetic_j;
        while !simulation.is_done() {
            simulation.step().unwrap();
        }
        let energy = simulation.energy();
        prop_assert!(
            energy.kinetic_j - energy.residual_j <= before_j * (1.0 + 1e-9),
            "{} of {before_j} J after: {energy:?}", energy.kinetic_j
        );
    }
}

/// By hand: at half of the rated deflection the pressure is half way between 50 and 146 kPa. Beyond the rated
/// deflection the same line continues.
#[test]
fn a_fender_without_a_panel_presses_with_its_inner_pressure() {
    let inner =
        HullPressure::Inner { initial_npm2: 50e3, rated_npm2: 146e3, rated_deflection_m: 2.0 };
    let mut setup = FenderSetup { hull_pressure: inner, ..fender("blown up", 0.0, 3.3, 3e6) };
    for (deflection_m, pressure_npm2) in [(0.0, 50e3), (1.0, 98e3), (2.0, 146e3), (2.5, 170e3)] {
        assert_eq!(setup.hull_pressure_npm2(deflection_m, 1e3), Some(pressure_npm2));
    }
    setup.hull_pressure = HullPressure::OverFace;
    assert_eq!(setup.hull_pressure_npm2(1.0, 6e5), Some(1e5), "2 m by 3 m");
    setup.hull_pressure = HullPressure::Unknown;
    assert_eq!(setup.hull_pressure_npm2(1.0, 6e5), None);
}
