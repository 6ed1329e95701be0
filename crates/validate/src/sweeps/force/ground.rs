//! Sweeps of the force of the ground on a ship aground: depth, speed and direction.

use fenderline_sim::BodyVelocity;
use fenderline_sim::constants::{KNOT_MPS, SEA_WATER_KGPM3, STANDARD_GRAVITY_MPS2};
use fenderline_sim::hydro::Force;

use crate::sweeps::stage::Stage;
use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Ground";
const DRAUGHT_M: f64 = 10.0;
const SHIP: &str = r#"
[environment]
depth = "10 m"
squat = "none"

[vessel.bulker]
length_bp = "200 m"
beam = "30 m"
draught = "10 m"
block_coefficient = 0.8

[body.ship]
vessel = "bulker"
outline = [[-100, -10], [-80, -15], [60, -15], [100, 0], [60, 15], [-80, 15], [-100, 10]]
"#;
const AGAINST: &str = "the drag of the bottom is against the ship's motion";
const COULOMB: &str = "the drag is never more than 0.4 of the weight that the bottom carries";

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![by_depth(), by_speed(), by_direction(), by_turning()]
}

fn force(stage: &Stage, depth_m: f64, velocity: BodyVelocity) -> Force {
    let forces = stage.forces(|setup| {
        setup.bodies[0].velocity = velocity;
        setup.world.environment.depth_m = Some(depth_m);
    });
    forces.bottom
}

fn along(surge_mps: f64) -> BodyVelocity {
    BodyVelocity { surge_mps, ..BodyVelocity::default() }
}

/// Weight of the ship that the bottom carries (kN): her waterplane is taken as block coefficient × length × beam.
fn carried_kn(depth_m: f64) -> f64 {
    let sunk_m = if depth_m < DRAUGHT_M { DRAUGHT_M - depth_m } else { 0.0 };
    1e-3 * SEA_WATER_KGPM3 * STANDARD_GRAVITY_MPS2 * 0.8 * 200.0 * 30.0 * sunk_m
}

fn by_depth() -> Sweep {
    let stage = Stage::of(SHIP);
    let curves = [0.02, 0.2, 2.0].map(|mps| {
        let (own, mirror) = (stage.clone(), stage.clone());
        Curve::of(format!("{mps} m/s"), move |ratio| {
            -1e-3 * force(&own, ratio * DRAUGHT_M, along(mps)).surge_n
        })
        .same_as("going astern", move |ratio| {
            1e-3 * force(&mirror, ratio * DRAUGHT_M, along(-mps)).surge_n
        })
        .never_negative(AGAINST)
        .at_most(COULOMB, |ratio| 0.4 * carried_kn(ratio * DRAUGHT_M) + 1e-9)
        .falling("in deeper water the bottom never carries less of the ship's weight", 1e-4)
    });
    Sweep {
        key: "ground_depth",
        subject: SUBJECT,
        title: "Bulk carrier of 200 m: drag of the bottom by depth, from aground to afloat"
            .to_owned(),
        axis: Axis::new("depth over draught", "", 0.95, 1.02),
        value: ["drag", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The ship of 200 × 30 × 10 m goes ahead. The bottom is hard and level; the drag \
               fades out below 0.01 m/s.",
    }
}

fn by_speed() -> Sweep {
    let stage = Stage::of(SHIP);
    let curves = [0.99, 0.97].map(|ratio| {
        let stage = stage.clone();
        Curve::of(format!("depth {ratio} of the draught"), move |mps| {
            1e-3 * force(&stage, ratio * DRAUGHT_M, along(mps)).surge_n
        })
        .odd()
        .value_law(AGAINST, |mps, value| -value * mps)
        .at_most(COULOMB, move |_| 0.4 * carried_kn(ratio * DRAUGHT_M))
        .growing_at_most(1.0)
    });
    Sweep {
        key: "ground_speed",
        subject: SUBJECT,
        title: "The same bulk carrier aground by speed, from astern to ahead".to_owned(),
        axis: Axis::new("speed", "m/s", -0.3, 0.3),
        value: ["longitudinal force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

fn by_direction() -> Sweep {
    let stage = Stage::of(SHIP);
    let at = |stage: &Stage, degrees: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let speed_mps = 0.2 * KNOT_MPS;
        let velocity = BodyVelocity {
            surge_mps: speed_mps * cos,
            sway_mps: speed_mps * sin,
            ..BodyVelocity::default()
        };
        force(stage, 0.98 * DRAUGHT_M, velocity)
    };
    let (ahead, across) = (stage.clone(), stage);
    Sweep {
        key: "ground_direction",
        subject: SUBJECT,
        title: "The same bulk carrier aground, with 0.2 m too little water, by the direction in \
                which she moves at 0.2 kn"
            .to_owned(),
        axis: Axis::new("direction of motion, from the bow to starboard", "°", -180.0, 180.0),
        value: ["force", "kN"],
        curves: vec![
            Curve::of("longitudinal", move |degrees| 1e-3 * at(&ahead, degrees).surge_n)
                .even()
                .value_law(AGAINST, |degrees, value| -value * libm::cos(degrees.to_radians())),
            Curve::of("side", move |degrees| 1e-3 * at(&across, degrees).sway_n)
                .odd()
                .value_law(AGAINST, |degrees, value| -value * libm::sin(degrees.to_radians())),
        ],
        lines: Vec::new(),
        note: "",
    }
}

fn by_turning() -> Sweep {
    let stage = Stage::of(SHIP);
    let curve = Curve::of("0.2 m under", move |degps: f64| {
        let velocity = BodyVelocity { yaw_radps: degps.to_radians(), ..BodyVelocity::default() };
        1e-6 * force(&stage, 0.98 * DRAUGHT_M, velocity).yaw_nm
    });
    Sweep {
        key: "ground_turning",
        subject: SUBJECT,
        title: "The same bulk carrier aground: moment of the bottom by rate of turn".to_owned(),
        axis: Axis::new("rate of turn", "°/s", -0.2, 0.2),
        value: ["yaw moment", "MN·m"],
        curves: vec![
            curve
                .odd()
                .value_law(AGAINST, |degps, value| -value * degps)
                .at_most(
                    "the moment is never more than 0.4 of the weight that the bottom carries, at \
                     a quarter of her length",
                    |_| 0.4 * 1e-3 * carried_kn(0.98 * DRAUGHT_M) * 50.0,
                )
                .growing_at_most(1.0),
        ],
        lines: Vec::new(),
        note: "",
    }
}
