//! Sweeps of the hull's force: all drift angles, depths, speeds, yaw rates and forms.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::shallow::current_abeam_n;
use fenderline_sim::hydro::{Controls, Force, Known, Mmg, Particulars, Velocity, Water, estimated};

use crate::computed::ships::vessel;
use crate::sweeps::stage::{Stage, TANKER};
use crate::sweeps::sweep::{Axis, Curve, Line, Sweep};

const SUBJECT: &str = "Hull";
/// The ships of the sweeps: ships with data of their own, and estimated ones.
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
/// How much harder than abeam a current may push a ship at another angle: OCIMF's curve at h/T 1.1 has its greatest
/// value, 1 % above that abeam, at 80°. The rest of the limit leaves room for ships that are not alike fore and aft.
const MOST_OF_ABEAM: f64 = 1.25;
const PUSHES_BACK: &str = "the side force is against the ship's drift";
const NOT_ABOVE_ABEAM: &str = "a current pushes at no angle more than 1.25 times as hard as abeam";
const TAKES_ENERGY: &str = "the water takes energy from the ship's motion";

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

/// Velocity of the ship through the water for a current that comes from an angle off the bow, to starboard (°).
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

/// Makes a curve over the angle off the bow for a ship, at a speed; `part` takes the value from the force, and `sign`
/// is −1 for a value that turns its sign in the mirror.
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

/// Makes the curve of the side force by drift angle, with its laws.
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
        title: "Side force of hulls by drift angle in deep water".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["side force / ½ρLTV²", ""],
        curves: SHIPS.iter().map(curve).collect(),
        lines: vec![low_speed_of_esso_osaka()],
        note: "The ship is at rest in a current, or drifts, without yaw. A positive side force \
               pushes the ship away from where the current comes from.",
    }
}

/// Reference line for the side force at all drift angles: Yoshimura's form for low speed with Miyauchi's coefficients.
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
            "a current from ahead pushes the ship astern, a current from astern pushes her ahead",
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
        title: "Longitudinal force of hulls by drift angle in deep water".to_owned(),
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
        title: "Yaw moment of hulls by drift angle in deep water".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["yaw moment / ½ρL²TV²", ""],
        curves: SHIPS.iter().map(curve).collect(),
        lines: Vec::new(),
        note: "About midship. A positive moment turns the bow away from where the current comes \
               from.",
    }
}

fn sway_of_tanker() -> Sweep {
    let stage = Stage::of(TANKER);
    let curves =
        DEPTHS.map(|(name, ratio)| sway(name, stage.at_depth_ratio(ratio), TANKER_MPS, 1e3));
    Sweep {
        key: "hull_tanker_sway",
        subject: SUBJECT,
        title: "Hull of a loaded tanker of 250,000 dwt in a current of 2 kn: side force".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["side force", "kN"],
        curves: curves.into(),
        lines: vec![ufc(&stage, "h/T 1.1", 1.1), ufc(&stage, "h/T 3", 3.0)],
        note: "329.3 × 51.8 × 19.2 m, block 0.85, her hull estimated from these. Positive: pushed away from the current.",
    }
}

/// Reference line by UFC 4-159-03: the force abeam times the sine of the angle (kN).
fn ufc(stage: &Stage, curve: &str, ratio: f64) -> Line {
    let ship = stage.vessel().deep.particulars;
    Line::of("UFC 4-159-03", curve, move |degrees| {
        1e-3 * ufc_abeam_n(&ship, ratio) * libm::sin(degrees.to_radians())
    })
}

/// Force of a current abeam on the tanker by UFC 4-159-03 (N). The midship coefficient of a full tanker is assumed to
/// be 0.99 in this formula.
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
        title: "The same loaded tanker in a current of 2 kn: longitudinal force".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["longitudinal force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "Positive: pushed ahead. This is the force of the hull alone; that of a stopped \
               propeller is under Propeller.",
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
        title: "The same loaded tanker in a current of 2 kn: yaw moment".to_owned(),
        axis: Axis::off_the_bow("current off the bow"),
        value: ["yaw moment", "MN·m"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "About midship. A positive moment turns the bow away from where the current comes \
               from.",
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
            .falling("a current in less water never pushes less", 0.01)
    };
    Sweep {
        key: "hull_depth",
        subject: SUBJECT,
        title: "The same loaded tanker: side force by depth, from aground to deep".to_owned(),
        axis: Axis::new("depth over draught", "", 0.8, 10.0).geometric(),
        value: ["side force", "kN"],
        curves: [20.0, 45.0, 90.0].map(curve).into(),
        lines: vec![Line::of("UFC 4-159-03", "90° off the bow", move |ratio| {
            1e-3 * ufc_abeam_n(&ship, ratio)
        })],
        note: "Below 1.1 draughts of water the values for 1.1 draughts are used; a run has a message then.",
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
            .value_law("the resistance is against the motion", |knots, value| -value * knots)
            .growing_at_most(2.0)
    });
    Sweep {
        key: "hull_resistance",
        subject: SUBJECT,
        title: "The same loaded tanker: resistance by speed, from astern to ahead".to_owned(),
        axis: Axis::new("speed", "kn", -8.0, 16.0),
        value: ["longitudinal force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The resistance is without the ship's own waves: its coefficient does not change \
               with the speed.",
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
        title: "Hull of KVLCC2: yaw moment by rate of turn in deep water".to_owned(),
        axis: Axis::new("rate of turn", "°/s", -0.5, 0.5),
        value: ["yaw moment", "MN·m"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The yaw moment is about midship, with the Coriolis terms of the added mass.",
    }
}

/// Makes a ship of given proportions, all of whose data are estimated.
///
/// # Panics
/// Panics if the particulars are out of range, which would be a bug.
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

/// Curves of the side force divided by ½ρLTV² at angles off the bow; `ship` makes the ship for a place on the axis of
/// the sweep.
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
        title: "Side force of estimated ships by block coefficient in deep water".to_owned(),
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
        title: "Side force of estimated ships by length in deep water".to_owned(),
        axis: Axis::new("length", "m", 20.0, 400.0).geometric(),
        value: ["side force / ½ρLTV²", ""],
        curves: of_estimates(|length_m| estimate(length_m, 6.3, 0.8)),
        lines: Vec::new(),
        note: "All ships have one form, with L/B 6.3, B/T 2.7 and a block coefficient of 0.8: the \
               force coefficient depends on the form only.",
    }
}
