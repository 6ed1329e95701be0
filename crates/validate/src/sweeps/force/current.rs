//! Sweeps of the current: its mean over the draught, its velocity between the nodes of a grid, and the rule that only
//! the speed through the water counts.

use fenderline_contact::vec2;
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::environment::current::{Current, CurrentGrid, CurrentProfile};
use fenderline_sim::hydro::Force;
use fenderline_sim::{BodyVelocity, VesselForces};

use crate::sweeps::stage::{Stage, TANKER};
use crate::sweeps::sweep::{Axis, Curve, Line, Sweep};

const SUBJECT: &str = "Current";
const STREAM_MPS: f64 = 2.0 * KNOT_MPS;
const DEPTH_M: f64 = 30.0;

/// Name of a part of a force, and how it is taken from the force.
type Part = fn(&Force) -> f64;

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![over_draught(), over_grid(), at_rest_and_adrift()]
}

/// A profile of the current by the power law with the exponent 1/7 at 31 depths, 1 m/s at the surface.
fn over_draught() -> Sweep {
    const POINTS: u32 = 30;
    let at = |depth_m: f64| libm::pow(1.0 - depth_m / DEPTH_M, 1.0 / 7.0);
    let points = (0..=POINTS).map(|k| {
        let depth_m = DEPTH_M * f64::from(k) / f64::from(POINTS);
        (depth_m, vec2(at(depth_m), 0.0))
    });
    let profile = CurrentProfile::new(points.collect()).expect("a good profile");
    let mean = Curve::of("mean over the draught", move |draught_m| profile.mean_over(draught_m).x)
        .falling("a deeper hull feels less of the stream at the surface", 0.05);
    let closed = Line::of("power law, integrated", "mean over the draught", |draught_m| {
        let below = 1.0 - draught_m / DEPTH_M;
        7.0 / 8.0 * (1.0 - libm::pow(below, 8.0 / 7.0)) / (draught_m / DEPTH_M)
    });
    Sweep {
        key: "current_profile",
        subject: SUBJECT,
        title: "A stream in 30 m of water by the power law with the exponent 1/7: its mean over \
                the draught"
            .to_owned(),
        axis: Axis::new("draught", "m", 0.0, 25.0),
        value: ["velocity", "m/s"],
        curves: vec![mean],
        lines: vec![closed],
        note: "The profile has 31 depths, 1 m/s at the surface, and straight lines between the \
               depths.",
    }
}

/// A stream on a grid that turns and shears over three nodes each way.
fn over_grid() -> Sweep {
    let axis = vec![-100.0, 0.0, 150.0];
    let nodes = axis.iter().flat_map(|&north_m: &f64| {
        axis.iter().map(move |&east_m: &f64| {
            vec2(0.5 + 0.002 * north_m, 0.3 - 0.001 * east_m * north_m / 100.0)
        })
    });
    let grid = CurrentGrid::new(vec![0.0], axis.clone(), axis.clone(), nodes.collect());
    let current = Current::Grid(grid.expect("a good grid"));
    let curve = |name: &str, part: fn(fenderline_contact::Vec2) -> f64| {
        let current = current.clone();
        Curve::of(name, move |m| part(current.velocity(vec2(m, 0.6 * m), 0.0, 10.0)))
    };
    Sweep {
        key: "current_grid",
        subject: SUBJECT,
        title: "Velocity of a stream on a grid, along a line across its cells and beyond its edges"
            .to_owned(),
        axis: Axis::new("place to the north", "m", -200.0, 250.0),
        value: ["velocity", "m/s"],
        curves: vec![curve("to the north", |v| v.x), curve("to the east", |v| v.y)],
        lines: Vec::new(),
        note: "The stream is linear between nodes in both directions; beyond the edge of the grid \
               it has the value at the edge.",
    }
}

/// Checks that the force on the tanker at rest in a stream from an angle is the same as on the tanker adrift in still
/// water.
fn at_rest_and_adrift() -> Sweep {
    let stage = Stage::of(&format!("[environment]\ndepth = \"28.8 m\"\n{TANKER}"));
    let parts: [(&str, Part); 3] = [
        ("longitudinal force", |f| 1e-3 * f.surge_n),
        ("side force", |f| 1e-3 * f.sway_n),
        ("yaw moment / 100 m", |f| 1e-5 * f.yaw_nm),
    ];
    let curves = parts.map(|(name, part)| {
        let (moored, adrift) = (stage.clone(), stage.clone());
        Curve::of(name, move |degrees| part(&in_stream(&moored, degrees).hull))
            .same_as("adrift in still water", move |degrees| part(&drifting(&adrift, degrees).hull))
    });
    Sweep {
        key: "current_moored",
        subject: SUBJECT,
        title: "Force on a tanker of 250,000 dwt at rest in a stream of 2 kn, h/T 1.5, in a run"
            .to_owned(),
        axis: Axis::new("stream from", "° off the bow", -180.0, 180.0),
        value: ["force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The force is compared with that on the same ship adrift in still water, because \
               only the speed through the water counts.",
    }
}

fn in_stream(stage: &Stage, degrees: f64) -> VesselForces {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    stage.forces(|setup| {
        let stream = Current::uniform(vec2(-STREAM_MPS * cos, -STREAM_MPS * sin));
        setup.world.environment.current = Some(stream.expect("a slow stream"));
    })
}

fn drifting(stage: &Stage, degrees: f64) -> VesselForces {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    stage.forces(|setup| {
        setup.bodies[0].velocity = BodyVelocity {
            surge_mps: STREAM_MPS * cos,
            sway_mps: STREAM_MPS * sin,
            ..BodyVelocity::default()
        };
    })
}
