//! Banks from the depth by place: symmetries, straight banks of a trench, and what is not a bank.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use crate::depth_by_place::{ship, with};
use crate::ships;

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::environment::{Bank, BankMethod, DepthField};
use fenderline_sim::hydro::{Force, Mmg};
use fenderline_sim::passing::FlowHull;
use fenderline_sim::{Bottom, Environment, Outside, Setup, Simulation, Walls};

const METHODS: [BankMethod; 2] = [BankMethod::Norrbin, BankMethod::Image];
const SPEED_MPS: f64 = 3.0;
/// Height of the land above datum (m), as a chart has it.
const LAND_M: f64 = 20.0;

/// Where a ship is: midship north and east (m), and heading (rad).
type At = (f64, f64, f64);

/// A field of square cells about the origin, from a function of north and east (m).
fn field(
    half_m: f64,
    cell_m: f64,
    banks: Option<BankMethod>,
    depth_m: impl Fn(f64, f64) -> f64,
) -> Bottom {
    let side = (2.0 * half_m / cell_m) as usize + 1;
    let at = |index: usize| index as f64 * cell_m - half_m;
    let depths_m =
        (0..side * side).map(|node| depth_m(at(node % side), at(node / side)) as f32).collect();
    let field = DepthField::new(vec2(-half_m, -half_m), cell_m, side, side, depths_m);
    Bottom { field: Arc::new(field.expect("a field")), outside: Outside::Error, banks }
}

fn setup_of(
    ship: Mmg,
    bottom: Bottom,
    banks: Vec<Bank>,
    (north_m, east_m, heading_rad): At,
) -> Setup {
    let environment = Environment { bottom: Some(bottom), banks, ..Environment::default() };
    let hull = ship.particulars;
    let mut setup = with(ship, environment, 0.5, 1e6);
    let size_m = [hull.length_m, hull.beam_m, hull.draught_m];
    setup.world.flow.hulls = vec![FlowHull::new(size_m, 1.0, None).expect("a hull")];
    let body = &mut setup.bodies[0];
    body.position_m = vec2(north_m, east_m);
    body.heading_rad = heading_rad;
    body.velocity.surge_mps = SPEED_MPS;
    setup
}

/// The force of banks in the first step.
fn force(bottom: Bottom, banks: Vec<Bank>, at: At) -> Force {
    let mut simulation =
        Simulation::new(setup_of(ship(), bottom, banks, at)).expect("a good set-up");
    simulation.step().expect("a good step").vessel_forces[0].banks
}

fn near(one: Force, other: Force, scale_n: f64) -> bool {
    let [surge, sway, yaw] = [
        one.surge_n - other.surge_n,
        one.sway_n - other.sway_n,
        (one.yaw_nm - other.yaw_nm) / 192.0,
    ];
    surge.abs() + sway.abs() + yaw.abs() <= 1e-9 * scale_n
}

/// A channel 12 m deep whose flanks rise by 1 in 5 from 60 m off its axis to land.
fn channel(_: f64, east_m: f64) -> f64 {
    12.0 - ((east_m.abs() - 60.0) / 5.0).clamp(0.0, 12.0 + LAND_M)
}

/// Land from a distance to starboard on, and a flank of 1 in 5 before it.
fn one_bank(toe_m: f64) -> impl Fn(f64, f64) -> f64 {
    move |_, east_m| 12.0 - ((east_m - toe_m) / 5.0).clamp(0.0, 12.0 + LAND_M)
}

#[test]
fn a_symmetric_channel_draws_her_to_neither_side() {
    for method in METHODS {
        let one_side =
            force(field(400.0, 4.0, Some(method), one_bank(60.0)), vec![], (0.0, 0.0, 0.0));
        assert!(one_side.sway_n > 1e3, "{method:?} {one_side:?}");
        for north_m in [0.0, 3.7] {
            let bottom = field(400.0, 4.0, Some(method), channel);
            let found = force(bottom, vec![], (north_m, 0.0, 0.0));
            assert!(near(found, Force::default(), one_side.sway_n), "{method:?} {found:?}");
        }
    }
}

/// A bank draws her to itself; by Norrbin it turns her bow away, ahead as astern; by her image, she is alike fore and aft,
/// and it does not turn her.
#[test]
fn a_bank_draws_her_to_itself_and_turns_her_bow_away() {
    for method in METHODS {
        let beside = |speed_mps: f64| {
            let bottom = field(400.0, 4.0, Some(method), one_bank(40.0));
            let mut setup = setup_of(ship(), bottom, vec![], (0.0, 0.0, 0.0));
            setup.bodies[0].velocity.surge_mps = speed_mps;
            let mut simulation = Simulation::new(setup).expect("a good set-up");
            simulation.step().expect("a good step").vessel_forces[0].banks
        };
        let [ahead, astern, at_rest] = [SPEED_MPS, -SPEED_MPS, 0.0].map(beside);
        assert!(ahead.sway_n > 0.0 && (astern.sway_n / ahead.sway_n - 1.0).abs() < 1e-9);
        assert_eq!(at_rest, Force::default());
        match method {
            BankMethod::Norrbin => assert!(ahead.yaw_nm < 0.0 && astern.yaw_nm > 0.0),
            BankMethod::Image => assert!(ahead.yaw_nm.abs() < 1e-9 * 192.0 * ahead.sway_n),
        }
    }
}

#[test]
fn a_mirrored_or_turned_harbour_has_mirrored_or_the_same_forces() {
    let rough = |north_m: f64, east_m: f64| {
        9.0 + 4.0 * (0.021 * north_m + 0.4).sin() * (0.017 * east_m).cos() + 0.02 * east_m
    };
    let at: At = (17.3, -31.7, 0.35);
    for method in METHODS {
        let here = force(field(400.0, 4.0, Some(method), rough), vec![], at);
        assert!(here.sway_n.abs() > 100.0, "{here:?}");
        let bottom = field(400.0, 4.0, Some(method), |north_m, east_m| rough(north_m, -east_m));
        let mirrored = force(bottom, vec![], (at.0, -at.1, -at.2));
        let back = Force { sway_n: -mirrored.sway_n, yaw_nm: -mirrored.yaw_nm, ..mirrored };
        assert!(near(here, back, here.sway_n.abs()), "{method:?} {here:?} {mirrored:?}");
        // Turned by 90 degrees: north becomes east.
        let bottom = field(400.0, 4.0, Some(method), |north_m, east_m| rough(east_m, -north_m));
        let turned = force(bottom, vec![], (-at.1, at.0, at.2 + FRAC_PI_2));
        assert!(near(here, turned, here.sway_n.abs()), "{method:?} {here:?} {turned:?}");
    }
}

#[test]
fn a_flat_field_has_no_banks_to_the_last_bit() {
    let run = |banks: Option<BankMethod>| {
        let bottom = field(400.0, 8.0, banks, |_, _| 11.3);
        let mut simulation =
            Simulation::new(setup_of(ship(), bottom, vec![], (3.0, 5.0, 0.3))).expect("a set-up");
        for _ in 0..20 {
            let record = simulation.step().expect("a good step");
            assert_eq!(record.vessel_forces[0].banks, Force::default());
        }
        simulation.states().to_vec()
    };
    for method in METHODS {
        assert_eq!(run(Some(method)), run(None));
    }
}

/// A trench with vertical sides, 12 m deep, and straight banks of the same method over the same field. Its sides rise from
/// the bottom to land within a cell of 2 m, and to the water's surface within 0.75 m: the bank is taken half way. A step of a section
/// is cut in half until a bank is placed to 0.1 % of its distance, and the cell's slope counts as much: 0.2 % of the force
/// of one bank by 1/y, and twice that by 1/y². The image's pull falls faster than 1/y² far off, which a vertical bank does not
/// see.
#[test]
fn a_trench_with_vertical_sides_has_the_forces_of_straight_banks() {
    let mut worst = [0.0_f64; 2];
    for (index, method) in METHODS.into_iter().enumerate() {
        for toe_m in [40.0, 64.0, 100.0, 150.0, 198.0] {
            let trench = move |_: f64, east_m: f64| {
                if (-200.0..=toe_m).contains(&east_m) { 12.0 } else { -LAND_M }
            };
            let at = (0.0, 0.0, 0.0);
            let found = force(field(400.0, 2.0, Some(method), trench), vec![], at);
            let bank = |east_m: f64| {
                Bank::new(vec2(-4000.0, east_m), vec2(4000.0, east_m), method).expect("a bank")
            };
            let [near, far] = [toe_m + 0.375, -200.375]
                .map(|east_m| force(field(400.0, 2.0, None, trench), vec![bank(east_m)], at));
            let [wanted_n, wanted_nm] = [near.sway_n + far.sway_n, near.yaw_nm + far.yaw_nm];
            let error = (found.sway_n - wanted_n).abs() / near.sway_n;
            println!(
                "straight, {method:?}: bank {toe_m} m off: {:.0} N, wanted {wanted_n:.0} N",
                found.sway_n
            );
            assert!(error < [2e-3, 4e-3][index], "{method:?} {toe_m}: {error}");
            if method == BankMethod::Norrbin {
                assert!((found.yaw_nm - wanted_nm).abs() < 2e-3 * near.yaw_nm.abs());
            }
            worst[index] = worst[index].max(error);
        }
    }
    println!("straight, largest error: Norrbin {:.5}, image {:.5}", worst[0], worst[1]);
}

/// The walls of a flank of 1 in 5 from 60 to 120 m off, and of a vertical bank 60 m off to half of the depth, in closed form: the means of
/// 1/y over the layers are ln(120/60)/60 m and 0.5/60 m, the means of 1/y² 1/(60 · 120) m² and 0.5/60² m².
#[test]
fn walls_of_a_flank_and_of_a_submerged_bank_are_those_in_closed_form() {
    let state = Simulation::new(setup_of(
        ship(),
        field(400.0, 2.0, None, |_, _| 12.0),
        vec![],
        (0.0, 0.0, 0.0),
    ));
    let state = state.expect("a good set-up").states()[0];
    let hull = ship().particulars;
    let walls = |bottom: &Bottom| Walls::beside(&hull, &state, bottom, 0.0, 12.0);
    let flank = walls(&field(400.0, 2.0, None, one_bank(60.0)));
    assert!((flank.per_m[1] * 60.0 / 2.0_f64.ln() - 1.0).abs() < 1e-3, "{flank:?}");
    assert!((flank.per_m2[1] * 7200.0 - 1.0).abs() < 1e-3, "{flank:?}");
    assert_eq!((flank.per_m[0], flank.per_m2[0]), (0.0, 0.0));
    let to_half =
        walls(&field(400.0, 0.5, None, |_, east_m| if east_m > 60.0 { 6.0 } else { 12.0 }));
    assert!((to_half.per_m[1] * 120.5 - 1.0).abs() < 2e-3, "{to_half:?}");
    assert!((to_half.per_m2[1] * 2.0 * 60.25 * 60.25 - 1.0).abs() < 4e-3, "{to_half:?}");
}

/// Submerged and sloping banks act less than vertical ones at their toe, and more than none.
#[test]
fn a_submerged_or_sloping_bank_acts_less_than_a_wall() {
    let at = (0.0, 0.0, 0.0);
    for method in METHODS {
        let to = |depth_m: fn(f64) -> f64| {
            force(field(400.0, 2.0, Some(method), |_, east_m| depth_m(east_m)), vec![], at).sway_n
        };
        let wall = to(|east_m| if east_m > 60.0 { -LAND_M } else { 12.0 });
        let half = to(|east_m| if east_m > 60.0 { 6.0 } else { 12.0 });
        let quarter = to(|east_m| if east_m > 60.0 { 9.0 } else { 12.0 });
        let slope = to(|east_m| 12.0 - ((east_m - 60.0) / 5.0).clamp(0.0, 32.0));
        let deeper = to(|east_m| if east_m > 60.0 { 30.0 } else { 12.0 });
        // A lagoon behind a breakwater is not open water.
        let breakwater = to(|east_m| if east_m > 60.0 && east_m < 70.0 { -5.0 } else { 12.0 });
        println!(
            "{method:?}: wall {wall:.0}, half {half:.0}, quarter {quarter:.0}, slope {slope:.0} N"
        );
        assert!(wall > half && half > quarter && quarter > 0.0 && wall > slope && slope > quarter);
        assert_eq!(deeper, 0.0);
        assert!((breakwater / wall - 1.0).abs() < 0.05, "{breakwater} {wall}");
    }
    // By Norrbin the layers add up: half of the depth has half of the force.
    let to = |depth_m: f64| {
        let step = move |_: f64, east_m: f64| if east_m > 60.0 { depth_m } else { 12.0 };
        force(field(400.0, 2.0, Some(BankMethod::Norrbin), step), vec![], at).sway_n
    };
    assert!((to(6.0) / to(0.0) - 0.5).abs() < 0.02, "{} {}", to(6.0), to(0.0));
}

/// She moves across a channel and along a ragged bank by centimetres: the force never jumps. Far from the bank it fades
/// out.
#[test]
fn the_force_is_continuous_and_fades_out() {
    let ragged = |north_m: f64, east_m: f64| {
        12.0 - ((east_m - 60.0 - 15.0 * (0.05 * north_m).sin()) / 3.0).clamp(0.0, 12.0 + LAND_M)
    };
    for method in METHODS {
        let bottom = field(500.0, 4.0, Some(method), ragged);
        let at = |north_m: f64, east_m: f64| {
            force(bottom.clone(), vec![], (north_m, east_m, 0.02)).sway_n
        };
        let most = at(0.0, 20.0);
        let mut last = at(0.0, 0.0);
        for step in 1..=400 {
            let way_m = 0.02 * f64::from(step);
            let now = at(0.5 * way_m, way_m);
            assert!((now - last).abs() < 2e-3 * most, "{method:?} {way_m}: {last} {now}");
            last = now;
        }
        let out: Vec<f64> = (0..18).map(|step| at(0.0, -20.0 * f64::from(step))).collect();
        assert!(out.windows(2).all(|pair| pair[1] <= pair[0] + 1e-3 * most), "{out:?}");
        assert_eq!(out[17], 0.0, "340 m west, 10.6 beams from the nearest toe");
        assert!(out[10] > 0.0 && out[10] < 0.35 * out[0], "{out:?}");
    }
}

#[test]
fn aground_and_on_land_she_has_a_finite_force() {
    for method in METHODS {
        for east_m in [0.0, 40.0, 80.0, 120.0, 160.0, 300.0] {
            let bottom = field(500.0, 4.0, Some(method), one_bank(60.0));
            let found = force(bottom, vec![], (0.0, east_m, 0.4));
            let parts = [found.surge_n, found.sway_n, found.yaw_nm];
            assert!(parts.iter().all(|part| part.is_finite()), "{method:?} {east_m} {found:?}");
        }
    }
}

/// The end of the data is no bank: the bottom goes on as at the last place with data.
#[test]
fn the_end_of_the_data_is_no_bank() {
    let nan_beyond = |_: f64, east_m: f64| if east_m > 60.0 { f64::NAN } else { 12.0 };
    for method in METHODS {
        let found = force(field(400.0, 4.0, Some(method), nan_beyond), vec![], (0.0, 0.0, 0.0));
        assert_eq!(found, Force::default());
    }
}

/// Prints the time of a step with and without the force of banks:
/// `cargo test -p fenderline-sim --test all banks_by_place::what_banks_cost -- --ignored --nocapture`.
#[test]
#[ignore = "prints times"]
fn what_banks_cost() {
    let shoals = |north_m: f64, east_m: f64| {
        30.0 + 0.001 * north_m - ((east_m.abs() - 300.0) / 10.0).clamp(0.0, 40.0)
    };
    for banks in [None, Some(BankMethod::Norrbin), Some(BankMethod::Image)] {
        let bottom = field(2000.0, 5.0, banks, shoals);
        let vessel = ships::kvlcc2().ship;
        let setup = setup_of(vessel, bottom, vec![], (0.0, Vec2::ZERO.y, 0.0));
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        let mut least_us = f64::INFINITY;
        for _ in 0..10 {
            let start = std::time::Instant::now();
            for _ in 0..20 {
                simulation.step().expect("a good step");
            }
            least_us = least_us.min(start.elapsed().as_secs_f64() * 1e6 / 20.0);
        }
        println!("cost {banks:?}: {least_us:.1} µs a step");
    }
}
