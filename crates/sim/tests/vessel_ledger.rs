//! The energy ledger of vessels under way balances at every time step, in any current and with every integrator.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::ships;
use crate::support;

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::environment::current::{Current, CurrentGrid};
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::vessels::{Origin, Vessel};
use fenderline_sim::hydro::{Model3, Water, manoeuvres};
use fenderline_sim::{
    Action, Energy, Environment, Integrator, Load, Looks, MassProperties, Method, Order, Setup,
    Simulation, VesselAction, VesselSetup, WorldSetup,
};
use support::{fixed, rectangle};

const STEPS_S: [f64; 4] = [0.05, 0.1, 0.5, 1.0];
const INTEGRATORS: [Integrator; 3] = [Integrator::SemiImplicit, Integrator::Euler, Integrator::Rk4];

/// A manoeuvre.
#[derive(Clone, Copy, Debug)]
enum Manoeuvre {
    /// Rudder hard over at full speed.
    Turning,
    /// Full astern at full speed.
    Stopping,
    /// Tugs push the ship sideways and turn her, from rest.
    Crabbing,
}

const MANOEUVRES: [Manoeuvre; 3] = [Manoeuvre::Turning, Manoeuvre::Stopping, Manoeuvre::Crabbing];

/// Still water, a uniform current, and a current that varies with position and time.
fn currents() -> [Option<Current>; 3] {
    let grid = CurrentGrid::new(
        vec![0.0, 150.0, 300.0],
        vec![-1000.0, 500.0, 3000.0],
        vec![-2000.0, 2000.0],
        (0..18).map(|k| vec2(0.1 * f64::from(k % 5), 0.8 - 0.07 * f64::from(k))).collect(),
    );
    [
        None,
        Some(Current::uniform(vec2(0.7, -1.1)).expect("a current")),
        Some(Current::Grid(grid.expect("a grid"))),
    ]
}

fn run(
    (vessel, manoeuvre): (&Vessel, Manoeuvre),
    (step_s, integrator): (f64, Integrator),
    current: Option<Current>,
    depth_m: Option<f64>,
) -> Energy {
    let deep = vessel.ship;
    let model = Model3::new(deep, Water::SEA);
    let speed_mps = vessel.approach_mps.expect("a speed of approach");
    let approach =
        manoeuvres::Approach::at(&model, speed_mps, vessel.steering, 0.5).expect("she goes");
    let mut body = fixed("ship", rectangle(deep.particulars.length_m, deep.particulars.beam_m));
    body.mass = Some(MassProperties { mass_kg: 1.0, yaw_inertia_kgm2: 1.0, ..Default::default() });
    let (shaft_rps, orders) = match manoeuvre {
        Manoeuvre::Turning => (approach.shaft_rps, vec![(0.0, VesselAction::Rudder(0.61))]),
        Manoeuvre::Stopping => (
            approach.shaft_rps,
            vec![(0.0, VesselAction::Engine(-1.0)), (0.0, VesselAction::Rudder(-0.3))],
        ),
        Manoeuvre::Crabbing => (approach.shaft_rps, vec![(0.0, VesselAction::Engine(0.0))]),
    };
    let adrift_mps = current.as_ref().map_or(Vec2::ZERO, |current| {
        current.velocity(Vec2::ZERO, 0.0, deep.particulars.draught_m)
    });
    body.velocity.surge_mps = adrift_mps.x;
    body.velocity.sway_mps = adrift_mps.y;
    let mut loads = vec![];
    if let Manoeuvre::Crabbing = manoeuvre {
        let mass_kg = 1025.0 * deep.particulars.volume_m3;
        loads.push(Load {
            body: 0,
            force_n: vec2(0.0, 3e-3 * mass_kg),
            moment_nm: 0.15 * deep.particulars.length_m * 2e-3 * mass_kg,
            from_s: 0.0,
            until_s: f64::INFINITY,
        });
    } else {
        body.velocity.surge_mps += speed_mps;
    }
    let setup = Setup {
        step_s,
        duration_s: 300.0,
        integrator,
        method: Method::Coupled,
        bodies: vec![body],
        materials: vec![],
        pairs: vec![],
        all_other_pairs: None,
        approaches: vec![],
        fenders: vec![],
        berthing: None,
        loads,
        world: WorldSetup {
            environment: Environment { current, depth_m, ..Environment::default() },
            vessels: vec![VesselSetup {
                body: 0,
                origin: Origin::default(),
                ship: depth_m.map_or(deep, |depth_m| deep.at_depth(depth_m)),
                deep,
                rudder: vessel.steering,
                shaft: RateLimited { value: shaft_rps, rate_per_s: 0.1, stop: shaft_rps },
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
            orders: orders
                .into_iter()
                .map(|(at_s, action)| Order { at_s, action: Action::Vessel(0, action) })
                .collect(),
            ..WorldSetup::default()
        },
    };
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    simulation.energy()
}

fn balances(vessel: &Vessel, integrator: Integrator, most: f64) {
    let mut worst = 0.0_f64;
    for manoeuvre in MANOEUVRES {
        for current in currents() {
            for depth in [None, Some(1.3)] {
                let depth_m = depth.map(|ratio| ratio * vessel.ship.particulars.draught_m);
                for step_s in STEPS_S {
                    let energy =
                        run((vessel, manoeuvre), (step_s, integrator), current.clone(), depth_m);
                    let share = energy.residual_j / energy.exchanged_j();
                    worst = worst.max(share.abs());
                    println!(
                        "{manoeuvre:?} {integrator:?} {step_s} s, current {}, h/T {depth:?}: \
                         {share:.1e}; kinetic {:.3e}, {:?}",
                        current.is_some(),
                        energy.kinetic_j,
                        energy.loads
                    );
                }
            }
        }
    }
    println!("worst {worst:.1e}");
    assert!(worst <= most, "{worst}");
}

#[test]
fn the_ledger_of_a_tanker_balances_as_the_engine_moves_her() {
    balances(&ships::kvlcc2(), Integrator::SemiImplicit, 1e-3);
}

#[test]
fn the_ledger_of_a_tanker_balances_by_the_other_integrators() {
    for integrator in &INTEGRATORS[1..] {
        balances(&ships::kvlcc2(), *integrator, 1e-3);
    }
}

/// The 7 m model of KVLCC2 turns ten degrees a second.
#[test]
fn the_ledger_of_a_fast_turning_model_balances() {
    for integrator in INTEGRATORS {
        balances(&ships::kvlcc2_model(), integrator, 1e-3);
    }
}

/// In still water the current does no work, and the energy of the propeller goes into drag and motion.
#[test]
fn in_still_water_the_propeller_supplies_all_energy() {
    let energy =
        run((&ships::kvlcc2(), Manoeuvre::Turning), (0.5, Integrator::SemiImplicit), None, None);
    assert_eq!(energy.loads.current_j, 0.0);
    assert!(energy.loads.propeller_j > 0.0, "{energy:?}");
    assert!(energy.loads.hull_j < 0.0, "{energy:?}");
}
