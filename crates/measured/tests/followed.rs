//! The run along the measured path gives back a force that pushed the ship in the run that was measured.

use fenderline_measured::{Followed, Lie, Motion};
use fenderline_sim::Load;

use crate::support::{
    ANTENNA_M, Approach, Random, SENSORS, USUAL, berth, docking_log, found, run_with, track_log,
};

/// Force ahead and towards the quay (N), and moment with the bow towards the quay (N·m), of a tug in the run that is measured.
const PUSH: [f64; 3] = [15e3, 90e3, -0.5e6];

/// A ship that a tug pushes to the berth from 25 m off, by the force ahead `ahead_n`.
fn approach(ahead_n: f64) -> Approach {
    let lie = Lie { along_m: -3.0, off_m: 41.0, angle_rad: 0.015 };
    let axes = berth().axes;
    let nearest = axes.nearest(&lie).expect("abreast");
    let lie = Lie { off_m: lie.off_m + 25.0 - nearest.gap_m, ..lie };
    let push = axes.from_axes([ahead_n, -PUSH[1]]) - axes.from_axes([0.0, 0.0]);
    let load = Load {
        body: axes.ship,
        force_n: push,
        moment_nm: axes.rate_of_turn(PUSH[2]),
        from_s: 0.0,
        until_s: f64::INFINITY,
    };
    run_with(&Motion { lie, rates: [0.0, -0.06, 0.0] }, vec![load])
}

fn followed(log: &str, mapping: &str) -> Followed {
    let mapping = format!("{mapping}follow_from = \"18 m\"\n");
    let found = found(&[("log.csv", log)], &mapping);
    assert_eq!(found.all.len(), 1, "{:?}", found.remarks);
    let run = found.all[0].followed.clone().expect("the mapping asks for the run");
    run.unwrap_or_else(|why| panic!("{why}"))
}

/// Errors of the three means as shares of the force and moment of the tug, and in the stated deviations.
fn errors(run: &Followed) -> [[f64; 2]; 3] {
    let mean = run.mean();
    core::array::from_fn(|of| {
        let error = mean[of].value - PUSH[of];
        [(error / PUSH[of]).abs(), (error / mean[of].sd).abs()]
    })
}

/// The force follows from the change of the momentum: with lasers of 1 cm and a row a second, the speeds at both ends of the
/// way have deviations of 1 to 2 mm/s, and the ship's mass with the added one is some 85,000 t in sway. That is the stated
/// deviation of some 220 kN·s, in 130 s 1.7 kN of 90 kN; 6 % are three deviations.
#[test]
fn a_docking_log_gives_the_push_of_a_tug_back() {
    // The way along the quay is not measured: some 2 cm/s, one deviation of the mapping, at the touch.
    let approach = approach(0.4 * PUSH[0]);
    for seed in 0..4 {
        let log = docking_log(&approach, USUAL, &mut Random::new(seed));
        let mapping = format!("{SENSORS}ship_place_deviation = \"0.2 m\"\n");
        let run = followed(&log, &mapping);
        let [_, across, turn] = errors(&run);
        println!("docking {seed}: {run:?} {:?}", errors(&run));
        assert!(across[0] < 0.06, "{run:?}");
        assert!(across[1] < 4.0 && turn[1] < 4.0, "{run:?}");
        assert!(run.off_m < 0.5, "{run:?}");
    }
}

/// Positions of 2 cm five times a second: the stated deviations are 1.3 % across, 2.4 % along the quay and 5 % of the moment. The
/// bounds are some three deviations, for the force along the quay twice that.
#[test]
fn a_track_gives_the_push_of_a_tug_back() {
    let approach = approach(PUSH[0]);
    for seed in 0..2 {
        let log = track_log(&approach, 0.02, &mut Random::new(seed));
        let mapping = format!(
            "antenna = [{:?}, {:?}]\nposition_deviation = \"2 cm\"\n",
            ANTENNA_M.x, ANTENNA_M.y
        );
        let run = followed(&log, &mapping);
        println!("track {seed}: {run:?} {:?}", errors(&run));
        let [along, across, turn] = errors(&run);
        assert!(across[0] < 0.03 && along[0] < 0.15 && turn[0] < 0.15, "{run:?}");
        assert!(run.off_m < 0.5, "{run:?}");
    }
}

/// A ship that nothing but the water drives is pushed by nothing.
#[test]
fn a_free_ship_is_pushed_by_nothing() {
    let lie = Lie { along_m: 0.0, off_m: 41.0, angle_rad: 0.01 };
    let approach = run_with(&Motion { lie, rates: [0.0, -0.15, 0.0] }, Vec::new());
    let log = docking_log(&approach, USUAL, &mut Random::new(9));
    let run = followed(&log, &format!("{SENSORS}ship_place_deviation = \"0.2 m\"\n"));
    let across = run.mean()[1];
    println!("{run:?}");
    assert!(across.value.abs() < 4.0 * across.sd && across.sd < 10e3, "{run:?}");
}
