//! Sweeps of the force of a passing ship: all places along the berth, distances, speeds and depths.

use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::passing::{Berth, PassingShip, Sections, factors, force};
use fenderline_sim::track::{Pace, Path};

use crate::sweeps::stage::Stage;
use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Passing ships";
/// The two equal ships of another program's workbook, in the units ft, ft², slug/ft³ and ft/s.
const LENGTH_FT: f64 = 941.109;
const AREA_FT2: f64 = 8103.879;
const ACROSS_FT: f64 = 364.042;
const SLUGS: f64 = 1.9905;
const SPEED_FTPS: f64 = 6.0;
const KN_PER_LBF: f64 = 4.448_221_615e-3;
const M_PER_FT: f64 = 0.3048;
const PARTS: [(&str, usize); 3] = [("surge", 0), ("sway", 1), ("yaw moment / 100 m", 2)];

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![by_place(), by_distance(), by_speed(), by_depth(), in_a_run()]
}

/// Force (lbf, lbf, lbf·ft) on a ship at rest of a ship that passes parallel to her, on either side, in either
/// direction.
fn passed(along_ft: f64, across_ft: f64, speed_ftps: f64, [side, way]: [f64; 2]) -> [f64; 3] {
    let sections = Sections::parabola(LENGTH_FT, AREA_FT2).expect("a good ship");
    let heading_rad = if way < 0.0 { std::f64::consts::PI } else { 0.0 };
    let passing = PassingShip {
        sections: &sections,
        pose: Pose::new(vec2(way * along_ft, side * across_ft), heading_rad),
        velocity_mps: vec2(way * speed_ftps, 0.0),
    };
    force(&sections, Pose::new(Vec2::ZERO, 0.0), &passing, SLUGS, 1.0)
}

/// Converts a force to kN, and its moment to kN·m divided by 100 m.
fn in_kn(force: [f64; 3]) -> [f64; 3] {
    [force[0] * KN_PER_LBF, force[1] * KN_PER_LBF, force[2] * KN_PER_LBF * M_PER_FT / 100.0]
}

/// Signs that turn a force back from its mirror image on the other side: surge stays, sway and yaw change.
const SIDE_SIGNS: [f64; 3] = [1.0, -1.0, -1.0];

fn by_place() -> Sweep {
    let curves = PARTS.map(|(name, part)| {
        let at = move |lengths: f64, side: f64| {
            in_kn(passed(lengths * LENGTH_FT, side * ACROSS_FT, SPEED_FTPS, [1.0, 1.0]))[part]
        };
        let curve = Curve::of(name, move |lengths| at(lengths, 1.0))
            .mirrored(move |lengths| SIDE_SIGNS[part] * at(lengths, -1.0));
        match part {
            // Two ships alike fore and aft: surge is odd along the berth, sway even.
            0 => curve.same_as("fore and aft", move |x| -at(-x, 1.0)),
            1 => curve.same_as("fore and aft", move |x| at(-x, 1.0)),
            _ => curve,
        }
    });
    Sweep {
        key: "passing_place",
        subject: SUBJECT,
        title: "Force between two equal ships of 287 m, 111 m apart, one passing at 3.6 kn in \
                deep water"
            .to_owned(),
        axis: Axis::new("midship of the passing ship ahead, over the length", "", -3.0, 3.0),
        value: ["force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "Parabolic sections. Positive values are ahead, towards the passing ship, and bow \
               towards her.",
    }
}

fn by_distance() -> Sweep {
    let curves = [("abreast: sway", 0.0, 1), ("half a length ahead: surge", 0.5, 0)].map(
        |(name, lengths, part)| {
            let at = move |share: f64, side: f64| {
                let across_ft = side * share * LENGTH_FT;
                in_kn(passed(lengths * LENGTH_FT, across_ft, SPEED_FTPS, [1.0, 1.0]))[part].abs()
            };
            Curve::of(name, move |share| at(share, 1.0))
                .mirrored(move |share| at(share, -1.0))
                .falling("a passing ship that is farther off pushes less", 0.01)
        },
    );
    Sweep {
        key: "passing_distance",
        subject: SUBJECT,
        title: "The same two ships of 287 m: size of the passing force by distance".to_owned(),
        axis: Axis::new("distance of the axes over the length", "", 0.1, 2.0),
        value: ["force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

fn by_speed() -> Sweep {
    let curves = [("abreast: sway", 0.0, 1), ("half a length ahead: surge", 0.5, 0)].map(
        |(name, lengths, part)| {
            let at = move |knots: f64, way: f64| {
                let speed_ftps = knots * 1.687_81;
                in_kn(passed(lengths * LENGTH_FT, ACROSS_FT, speed_ftps, [1.0, way]))[part]
            };
            // A ship that goes the other way from the mirrored place gives the mirrored force.
            let sign = if part == 0 { -1.0 } else { 1.0 };
            Curve::of(name, move |knots| at(knots, 1.0))
                .mirrored(move |knots| sign * at(knots, -1.0))
                .growing_at_most(2.0)
        },
    );
    Sweep {
        key: "passing_speed",
        subject: SUBJECT,
        title:
            "The same two ships of 287 m: force by speed of the passing ship, from astern to ahead"
                .to_owned(),
        axis: Axis::new("speed", "kn", -10.0, 15.0),
        value: ["force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

fn by_depth() -> Sweep {
    let curves = [("surge", 0), ("sway", 1), ("yaw", 2)].map(|(name, part)| {
        let at = move |ratio: f64| {
            let ratio = if ratio > 1.0 { ratio } else { 1.0 };
            factors(1.0 / ratio, 3.0, Berth::Open).expect("afloat")[part]
        };
        Curve::of(name, at)
            .value_law("shallow water never lessens the force of a passing ship", |_, value| {
                value - 1.0
            })
            .falling("a passing ship in less water never pushes less", 0.01)
            .value_law("ten draughts of water are deep", |ratio, value| {
                if ratio < 10.0 { 0.0 } else { 1.1 - value }
            })
    });
    Sweep {
        key: "passing_depth",
        subject: SUBJECT,
        title: "Factor of the depth on the force of a passing ship by Kriebel, with a clear gap \
                of three beams"
            .to_owned(),
        axis: Axis::new("depth over draught of the moored ship", "", 0.9, 10.0).geometric(),
        value: ["factor", ""],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The factors do not go to 1 in deep water: their form has 1 + a·e^(−…) there.",
    }
}

/// Sweep of the force on a moored ship in a run, by the place of the passing ship. The places reach as far as the
/// distance at which the force has faded out.
fn in_a_run() -> Sweep {
    let stage = Stage::of(
        r#"
[environment]
depth = "20 m"

[vessel.tanker]
length_bp = 243.5
beam = 39
draught = 15.3
block_coefficient = 0.8

[body.ship]
vessel = "tanker"
outline = [[-121.75, -19.5], [121.75, -19.5], [121.75, 19.5], [-121.75, 19.5]]

[passing.coaster]
length = 185.4
beam = 25.8
draught = 6.8
position = [0, -110]
heading = 0
speed = "10 kn"
time = "0 s"
depth_factors = "kriebel"
"#,
    );
    let at = |stage: &Stage, x_m: f64, side: f64| {
        let forces = stage.forces(|setup| {
            let track = &mut setup.world.flow.passing[0].track;
            track.path = Path::straight(vec2(x_m, side * 110.0), 0.0).expect("a place");
            track.pace =
                Pace::steady(10.0 * fenderline_sim::constants::KNOT_MPS, 0.0).expect("a speed");
        });
        let force = forces.passing;
        [1e-3 * force.surge_n, 1e-3 * force.sway_n, 1e-5 * force.yaw_nm]
    };
    let curves = PARTS.map(|(name, part)| {
        let (own, mirror) = (stage.clone(), stage.clone());
        Curve::of(name, move |x_m| at(&own, x_m, 1.0)[part])
            .mirrored(move |x_m| SIDE_SIGNS[part] * at(&mirror, x_m, -1.0)[part])
    });
    Sweep {
        key: "passing_run",
        subject: SUBJECT,
        title: "Passing force on a tanker of 243.5 m in 20 m of water, passed at 10 kn 110 m off, \
                in a run"
            .to_owned(),
        axis: Axis::new("midship of the passing ship ahead", "m", -2500.0, 2500.0),
        value: ["force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The force is shown as far as it is computed: it fades out between 8 and 10 mean \
               lengths.",
    }
}
