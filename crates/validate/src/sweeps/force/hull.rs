//! The hull: all drift angles, depths, speeds, yaw rates and forms.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::shallow::current_abeam_n;
use fenderline_sim::hydro::{Controls, Force, Known, Mmg, Particulars, Velocity, Water, estimated};

use crate::computed::ships::vessel;
use crate::sweeps::stage::{Stage, TANKER};
use crate::sweeps::sweep::{Axis, Curve, Line, Sweep};

const SUBJECT: &str = "Hull";
/// Ships with data of their own, and estimated ones.
const SHIPS: [(&str, &str); 6] = [
    ("KVLCC2", "kvlcc2"),
    ("KCS", "kcs"),
    ("Esso Osaka", "esso-osaka"),
    ("S175, estimated", "s175"),
    ("bulk carrier, estimated", "bulk-carrier"),
    ("tug, estimated", "asd-tug"),
];
/// Depth over draught.
const DEPTHS: [(&str, f64); 3] = [("h/T 1.1", 1.1), ("h/T 1.5", 1.5), ("h/T 3", 3.0)];
const TANKER_MPS: f64 = 2.0 * KNOT_MPS;
/// How much harder than abeam a current may push at another angle: OCIMF's curve at h/T 1.1 has its greatest value, 1 % above that abeam,
/// at 80°. The rest is room for ships who are not alike fore and aft.
const MOST_OF_ABEAM: f64 = 1.25;
const PUSHES_BACK: &str = "the side force is against the drift";
const NOT_ABOVE_ABEAM: &str = "no angle pushes more than 1.25 times as hard as abeam";
const TAKES_ENERGY: &str = "the water takes energy from the motion";

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![
        sway_of_ships(),
        surge_of_ships(),
        yaw_of_ships(),
        sway_of_tanker(),
        surge_of_tanker(),
        yaw_of_tanker(),
        by_depth(),
        resistance(),
        turning(),
        by_block(),
        by_size(),
    ]
}

/// Velocity through the water where the current comes from an angle off the bow, to starboard (°).
fn from_off_the_bow(speed_mps: f64, degrees: f64) -> Velocity {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    Velocity { surge_mps: speed_mps * cos, sway_mps: speed_mps * sin, yaw_radps: 0.0 }
}

/// The hull's force alone.
fn force(ship: &Mmg, velocity: &Velocity) -> Force {
    ship.parts(velocity, &Controls::default(), Water::SEA).hull
}

/// ½ρLTV² (N).
fn unit_n(ship: &Particulars, speed_mps: f64) -> f64 {
    0.5 * Water::SEA.density_kgpm3 * ship.length_m * ship.draught_m * speed_mps * speed_mps
}

fn power_w(ship: &Mmg, velocity: &Velocity) -> f64 {
    let force = force(ship, velocity);
    force.surge_n * velocity.surge_mps
        + force.sway_n * velocity.sway_mps
        + force.yaw_nm * velocity.yaw_radps
}

fn mirrored(velocity: &Velocity) -> Velocity {
    Velocity {
        surge_mps: velocity.surge_mps,
        sway_mps: -velocity.sway_mps,
        yaw_radps: -velocity.yaw_radps,
    }
}

/// A curve over the angle off the bow for a ship, at a speed; `part` takes the value, `sign` is −1 for a value that turns its sign in the
/// mirror.
fn by_angle(
    name: &str,
    ship: Mmg,
    speed_mps: f64,
    sign: f64,
    part: impl Fn(&Force) -> f64 + Clone + 'static,
) -> Curve {
    let other = part.clone();
    Curve::of(name, move |degrees| part(&force(&ship, &from_off_the_bow(speed_mps, degrees))))
        .mirrored(move |degrees| {
            let velocity = mirrored(&from_off_the_bow(speed_mps, degrees));
            sign * other(&force(&ship, &velocity))
        })
}

/// The side force that a drift angle gives, with its laws.
fn sway(name: &str, ship: Mmg, speed_mps: f64, unit_n: f64) -> Curve {
    let abeam = force(&ship, &from_off_the_bow(speed_mps, 90.0)).sway_n.abs() / unit_n;
    by_angle(name, ship, speed_mps, -1.0, move |force| -force.sway_n / unit_n)
        .never_negative(PUSHES_BACK)
        .at_most(NOT_ABOVE_ABEAM, move |_| MOST_OF_ABEAM * abeam)
        .law(TAKES_ENERGY, move |degrees| -power_w(&ship, &from_off_the_bow(speed_mps, degrees)))
}

fn sway_of_ships() -> Sweep {
    let curve = |&(title, name): &(&str, &str)| {
        let ship = vessel(name).ship;
        sway(title, ship, 1.0, unit_n(&ship.particulars, 1.0))
    };
    Sweep {
        key: "hull_sway",
        subject: SUBJECT,
        title: "Side force by drift angle, deep water".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["side force / ½ρLTV²", ""],
        curves: SHIPS.iter().map(curve).collect(),
        lines: vec![low_speed_of_esso_osaka()],
        note: "A ship at rest in a current, or drifting, without yaw. Positive: pushed away from the current.",
    }
}

/// Yoshimura's form for low speed with Miyauchi's coefficients, for the side force at all drift angles.
fn low_speed_of_esso_osaka() -> Line {
    let ship = vessel("esso-osaka").ship;
    let Particulars { length_m, draught_m, .. } = ship.particulars;
    let unit_n = unit_n(&ship.particulars, 1.0);
    Line::of("Miyauchi 2022, low speed", "Esso Osaka", move |degrees| {
        let velocity = from_off_the_bow(1.0, degrees);
        let force = ship.hull.low_speed.force(&velocity, length_m, draught_m, Water::SEA);
        -force.sway_n / unit_n
    })
}

fn surge_of_ships() -> Sweep {
    let curve = |&(title, name): &(&str, &str)| {
        let ship = vessel(name).ship;
        let unit_n = unit_n(&ship.particulars, 1.0);
        by_angle(title, ship, 1.0, 1.0, move |force| force.surge_n / unit_n).value_law(
            "from ahead it pushes astern, from astern ahead",
            |degrees, value| match degrees {
                _ if degrees == 0.0 => -value,
                _ if degrees == 180.0 => value,
                _ => 0.0,
            },
        )
    };
    Sweep {
        key: "hull_surge",
        subject: SUBJECT,
        title: "Longitudinal force by drift angle, deep water".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["longitudinal force / ½ρLTV²", ""],
        curves: SHIPS.iter().map(curve).collect(),
        lines: Vec::new(),
        note: "Positive: pushed ahead.",
    }
}

fn yaw_of_ships() -> Sweep {
    let curve = |&(title, name): &(&str, &str)| {
        let ship = vessel(name).ship;
        let unit_nm = unit_n(&ship.particulars, 1.0) * ship.particulars.length_m;
        by_angle(title, ship, 1.0, -1.0, move |force| -force.yaw_nm / unit_nm)
    };
    Sweep {
        key: "hull_yaw",
        subject: SUBJECT,
        title: "Yaw moment by drift angle, deep water".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["yaw moment / ½ρL²TV²", ""],
        curves: SHIPS.iter().map(curve).collect(),
        lines: Vec::new(),
        note: "About midship. Positive: the bow is turned away from the current.",
    }
}

fn sway_of_tanker() -> Sweep {
    let stage = Stage::of(TANKER);
    let curves =
        DEPTHS.map(|(name, ratio)| sway(name, stage.at_depth_ratio(ratio), TANKER_MPS, 1e3));
    Sweep {
        key: "hull_tanker_sway",
        subject: SUBJECT,
        title: "Loaded tanker of 250,000 dwt in a current of 2 kn: side force".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["side force", "kN"],
        curves: curves.into(),
        lines: vec![ufc(&stage, "h/T 1.1", 1.1), ufc(&stage, "h/T 3", 3.0)],
        note: "329.3 × 51.8 × 19.2 m, block 0.85, her hull estimated from these. Positive: pushed away from the current.",
    }
}

/// UFC 4-159-03: the force abeam times the sine of the angle (kN).
fn ufc(stage: &Stage, curve: &str, ratio: f64) -> Line {
    let ship = stage.vessel().deep.particulars;
    Line::of("UFC 4-159-03", curve, move |degrees| {
        1e-3 * ufc_abeam_n(&ship, ratio) * libm::sin(degrees.to_radians())
    })
}

/// Its force abeam (N). The midship coefficient of a full tanker is assumed to be 0.99.
fn ufc_abeam_n(ship: &Particulars, ratio: f64) -> f64 {
    let depth_m = ratio * ship.draught_m;
    current_abeam_n(ship, 0.99, depth_m, TANKER_MPS, Water::SEA).expect("afloat")
}

fn surge_of_tanker() -> Sweep {
    let stage = Stage::of(TANKER);
    let curves = DEPTHS.map(|(name, ratio)| {
        by_angle(name, stage.at_depth_ratio(ratio), TANKER_MPS, 1.0, |force| 1e-3 * force.surge_n)
    });
    Sweep {
        key: "hull_tanker_surge",
        subject: SUBJECT,
        title: "The same tanker: longitudinal force".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["longitudinal force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "Positive: pushed ahead. The hull alone: a stopped propeller is under Propeller.",
    }
}

fn yaw_of_tanker() -> Sweep {
    let stage = Stage::of(TANKER);
    let curves = DEPTHS.map(|(name, ratio)| {
        by_angle(name, stage.at_depth_ratio(ratio), TANKER_MPS, -1.0, |force| -1e-6 * force.yaw_nm)
    });
    Sweep {
        key: "hull_tanker_yaw",
        subject: SUBJECT,
        title: "The same tanker: yaw moment".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["yaw moment", "MN·m"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "About midship. Positive: the bow is turned away from the current.",
    }
}

fn by_depth() -> Sweep {
    let stage = Stage::of(TANKER);
    let ship = stage.vessel().deep.particulars;
    let curve = |degrees: f64| {
        let (stage, mirror) = (stage.clone(), stage.clone());
        let at = |stage: &Stage, ratio: f64, velocity: &Velocity| {
            1e-3 * force(&stage.at_depth_ratio(ratio), velocity).sway_n
        };
        let velocity = from_off_the_bow(TANKER_MPS, degrees);
        Curve::of(format!("{degrees}° off the bow"), move |ratio| -at(&stage, ratio, &velocity))
            .mirrored(move |ratio| at(&mirror, ratio, &mirrored(&velocity)))
            .falling("less water never pushes less", 0.01)
    };
    Sweep {
        key: "hull_depth",
        subject: SUBJECT,
        title: "The same tanker: side force by depth, from aground to deep".to_owned(),
        axis: Axis::new("depth over draught", "", 0.8, 10.0).geometric(),
        value: ["side force", "kN"],
        curves: [20.0, 45.0, 90.0].map(curve).into(),
        lines: vec![Line::of("UFC 4-159-03", "90° off the bow", move |ratio| {
            1e-3 * ufc_abeam_n(&ship, ratio)
        })],
        note: "Below 1.1 draughts of water the values of 1.1 are held; a run says so.",
    }
}

fn resistance() -> Sweep {
    let stage = Stage::of(TANKER);
    let depths = [("deep water", 100.0), ("h/T 1.5", 1.5), ("h/T 1.2", 1.2)];
    let curves = depths.map(|(name, ratio)| {
        let ship = stage.at_depth_ratio(ratio);
        let at = move |knots: f64| {
            let velocity = Velocity { surge_mps: knots * KNOT_MPS, ..Velocity::default() };
            1e-3 * force(&ship, &velocity).surge_n
        };
        Curve::of(name, at)
            .value_law("it is against the motion", |knots, value| -value * knots)
            .growing_at_most(2.0)
    });
    Sweep {
        key: "hull_resistance",
        subject: SUBJECT,
        title: "The same tanker: resistance, from astern to ahead".to_owned(),
        axis: Axis::new("speed", "kn", -8.0, 16.0),
        value: ["longitudinal force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "Without waves of her own: the coefficient does not change with the speed.",
    }
}

fn turning() -> Sweep {
    let ship = vessel("kvlcc2").ship;
    let states = [
        ("at rest", 0.0, 0.0),
        ("5 kn ahead", 5.0, 0.0),
        ("5 kn astern", -5.0, 0.0),
        ("2 kn to starboard", 0.0, 2.0),
    ];
    let curves = states.map(|(name, surge_kn, sway_kn)| {
        let at = move |degps: f64, side: f64| {
            let velocity = Velocity {
                surge_mps: surge_kn * KNOT_MPS,
                sway_mps: side * sway_kn * KNOT_MPS,
                yaw_radps: side * degps.to_radians(),
            };
            1e-6 * side * force(&ship, &velocity).yaw_nm
        };
        let still = at(0.0, 1.0);
        Curve::of(name, move |degps| at(degps, 1.0))
            .mirrored(move |degps| at(degps, -1.0))
            .value_law("turning is damped", move |degps, value| (still - value) * degps)
    });
    Sweep {
        key: "hull_turning",
        subject: SUBJECT,
        title: "KVLCC2: yaw moment by rate of turn, deep water".to_owned(),
        axis: Axis::new("rate of turn", "°/s", -0.5, 0.5),
        value: ["yaw moment", "MN·m"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "About midship, with the Coriolis terms of the added mass.",
    }
}

/// A ship of these proportions, all of her estimated.
///
/// # Panics
/// Particulars that are refused: a bug.
fn estimate(length_m: f64, length_to_beam: f64, block: f64) -> Mmg {
    let beam_m = length_m / length_to_beam;
    let particulars = Particulars::from_block(length_m, beam_m, beam_m / 2.7, block);
    let known = Known {
        particulars: particulars.expect("a ship"),
        added_mass: None,
        polynomial: None,
        low_speed: None,
        gear: None,
    };
    estimated(&known).expect("within the regressions").model
}

/// Side force over ½ρLTV² at angles off the bow, for a ship by the place on the axis.
fn of_estimates(ship: impl Fn(f64) -> Mmg + Clone + 'static) -> Vec<Curve> {
    let curve = |degrees: f64| {
        let ship = ship.clone();
        let at = move |x: f64| {
            let ship = ship(x);
            let velocity = from_off_the_bow(1.0, degrees);
            -force(&ship, &velocity).sway_n / unit_n(&ship.particulars, 1.0)
        };
        Curve::of(format!("{degrees}° off the bow"), at).never_negative(PUSHES_BACK)
    };
    [20.0, 45.0, 90.0, 135.0].map(curve).into()
}

fn by_block() -> Sweep {
    Sweep {
        key: "hull_block",
        subject: SUBJECT,
        title: "Estimated ships by block coefficient, deep water".to_owned(),
        axis: Axis::new("block coefficient", "", 0.5, 0.9),
        value: ["side force / ½ρLTV²", ""],
        curves: of_estimates(|block| estimate(200.0, 6.3, block)),
        lines: Vec::new(),
        note: "L/B 6.3, B/T 2.7.",
    }
}

fn by_size() -> Sweep {
    Sweep {
        key: "hull_size",
        subject: SUBJECT,
        title: "Estimated ships by length, deep water".to_owned(),
        axis: Axis::new("length", "m", 20.0, 400.0).geometric(),
        value: ["side force / ½ρLTV²", ""],
        curves: of_estimates(|length_m| estimate(length_m, 6.3, 0.8)),
        lines: Vec::new(),
        note: "One form, L/B 6.3, B/T 2.7, block 0.8: the coefficient is that of the form.",
    }
}
