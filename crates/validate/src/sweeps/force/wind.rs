//! Sweeps of the wind's force: each method, each type of ship, all angles and speeds.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::environment::wind::{
    BLENDERMANN_TYPES, Blendermann, Fujiwara, Isherwood, RelativeWind, ShipWindage,
    WindCoefficients, WindMethod,
};

use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Wind";
const AIR_KGPM3: f64 = 1.28;
const PUSHES_ACROSS: &str = "the side force of the wind is to lee";
const PUSHES_DOWNWIND: &str = "the force along the wind's direction is to lee";

/// A part of the wind coefficients: longitudinal force, side force or yaw moment.
#[derive(Clone, Copy)]
enum Part {
    Surge,
    Sway,
    Yaw,
}

impl Part {
    const ALL: [Part; 3] = [Part::Surge, Part::Sway, Part::Yaw];

    fn of(self, coefficients: &WindCoefficients) -> f64 {
        match self {
            Part::Surge => coefficients.surge,
            Part::Sway => coefficients.sway,
            Part::Yaw => coefficients.yaw,
        }
    }

    /// Key, title and value.
    fn words(self) -> [&'static str; 3] {
        match self {
            Part::Surge => ["surge", "longitudinal force", "C_X, on the frontal area"],
            Part::Sway => ["sway", "side force", "C_Y, on the lateral area"],
            Part::Yaw => ["yaw", "yaw moment", "C_N, on lateral area × length"],
        }
    }
}

/// A group of ship types on one chart: title of the group, keys of its three sweeps, names of the types.
type Group = (&'static str, [&'static str; 3], &'static [&'static str]);

const GROUPS: [Group; 3] = [
    (
        "Cargo ships by Blendermann",
        ["wind_cargo_surge", "wind_cargo_sway", "wind_cargo_yaw"],
        &[
            "tanker, loaded",
            "tanker, in ballast",
            "gas tanker",
            "cargo vessel, loaded",
            "cargo vessel, container on deck",
            "container ship, loaded",
        ],
    ),
    (
        "Wind coefficients of ships with high sides by Blendermann",
        ["wind_high_surge", "wind_high_sway", "wind_high_yaw"],
        &[
            "car carrier",
            "ferry",
            "passenger liner",
            "destroyer",
            "drilling vessel",
            "research vessel",
        ],
    ),
    (
        "Small ships by Blendermann",
        ["wind_small_surge", "wind_small_sway", "wind_small_yaw"],
        &[
            "diving support vessel",
            "offshore supply vessel",
            "fishing vessel",
            "speed boat",
            "tender",
        ],
    ),
];

pub(super) fn sweeps() -> Vec<Sweep> {
    let tanker = Part::ALL.map(of_tanker);
    let methods = Part::ALL.map(by_methods);
    let types = GROUPS.iter().flat_map(|group| Part::ALL.map(|part| of_types(group, part)));
    tanker.into_iter().chain(methods).chain(types).chain([by_speed()]).collect()
}

/// Makes the curve of a wind coefficient by the angle off the bow to port, with the laws for all methods.
fn curve(name: &str, ship: ShipWindage, part: Part) -> Curve {
    let coefficients = ship.clone();
    let at = move |degrees: f64| part.of(&coefficients.coefficients(degrees.to_radians()));
    let curve = Curve::of(name, at);
    match part {
        Part::Surge => curve.even().law(PUSHES_DOWNWIND, move |degrees| downwind_n(&ship, degrees)),
        Part::Sway => curve.odd().never_negative(PUSHES_ACROSS),
        Part::Yaw => curve.odd(),
    }
}

/// The component of the wind's force along a wind of 1 m/s (N).
fn downwind_n(ship: &ShipWindage, degrees: f64) -> f64 {
    let wind = RelativeWind { speed_mps: 1.0, angle_rad: degrees.to_radians() };
    let [surge_n, sway_n, _] = ship.force(&wind, AIR_KGPM3);
    let (sin, cos) = libm::sincos(wind.angle_rad);
    sway_n * sin - surge_n * cos
}

/// The tanker of the worked example in OCIMF's guidelines: 329.3 × 51.8 m, loaded, areas 818 and 3,225 m², centroid
/// amidships.
fn tanker() -> ShipWindage {
    let method =
        Blendermann::of_type("tanker, loaded").expect("the type of ship is in Blendermann's table");
    ShipWindage {
        length_m: 329.3,
        beam_m: 51.8,
        frontal_m2: 818.0,
        lateral_m2: 3225.0,
        centroid_forward_m: 0.0,
        centroid_height_m: 7.0,
        method: WindMethod::Blendermann(method),
    }
}

fn of_tanker(part: Part) -> Sweep {
    let [_, title, value] = part.words();
    let key = match part {
        Part::Surge => "wind_tanker_surge",
        Part::Sway => "wind_tanker_sway",
        Part::Yaw => "wind_tanker_yaw",
    };
    Sweep {
        key,
        subject: SUBJECT,
        title: format!("Loaded tanker of 250,000 dwt: {title}"),
        axis: Axis::off_the_bow("wind off the bow"),
        value: [value, ""],
        curves: vec![curve("Blendermann", tanker(), part)],
        lines: Vec::new(),
        note: "Wind from port. Positive values are ahead, to starboard, and bow to starboard. \
               Blendermann's tanker has her bridge where it was in his tests; the centroid of her \
               side is assumed amidships.",
    }
}

/// The container ship of 298 × 46 m, with areas that are assumed.
fn container_ship(method: WindMethod) -> ShipWindage {
    ShipWindage {
        length_m: 298.0,
        beam_m: 46.0,
        frontal_m2: 1700.0,
        lateral_m2: 9000.0,
        centroid_forward_m: 0.0,
        centroid_height_m: 15.0,
        method,
    }
}

fn by_methods(part: Part) -> Sweep {
    let [_, title, value] = part.words();
    let key = match part {
        Part::Surge => "wind_methods_surge",
        Part::Sway => "wind_methods_sway",
        Part::Yaw => "wind_methods_yaw",
    };
    let blendermann = Blendermann::of_type("container ship, loaded")
        .expect("the type of ship is in Blendermann's table");
    let isherwood = Isherwood { perimeter_m: 700.0, superstructure_m2: 1500.0, mast_groups: 1.0 };
    let fujiwara = Fujiwara { on_deck_m2: 5000.0, on_deck_forward_m: 0.0, top_height_m: 45.0 };
    let curves = vec![
        curve("Blendermann", container_ship(WindMethod::Blendermann(blendermann)), part),
        curve("Isherwood", container_ship(WindMethod::Isherwood(isherwood)), part),
        curve("Fujiwara", container_ship(WindMethod::Fujiwara(fujiwara)), part),
    ];
    Sweep {
        key,
        subject: SUBJECT,
        title: format!("Container ship of 298 m, wind coefficients by each method: {title}"),
        axis: Axis::off_the_bow("wind off the bow"),
        value: [value, ""],
        curves,
        lines: Vec::new(),
        note: "A_L 9,000 m², A_F 1,700 m², 5,000 m² of it on deck: assumed. What the methods differ by is how well such a force is known.",
    }
}

fn of_types((title, keys, types): &Group, part: Part) -> Sweep {
    let [_, what, value] = part.words();
    let of_type = |name: &&str| {
        let kind = BLENDERMANN_TYPES.iter().find(|kind| kind.name == *name);
        let kind = *kind.unwrap_or_else(|| panic!("no type {name}"));
        curve(name, container_ship(WindMethod::Blendermann(Blendermann { kind })), part)
    };
    Sweep {
        key: keys[part as usize],
        subject: SUBJECT,
        title: format!("{title}: {what}"),
        axis: Axis::off_the_bow("wind off the bow"),
        value: [value, ""],
        curves: types.iter().map(of_type).collect(),
        lines: Vec::new(),
        note: "All curves are with the areas of the container ship, so that only the types differ.",
    }
}

fn by_speed() -> Sweep {
    let curves = [0.0, 45.0, 90.0, 180.0].map(|degrees: f64| {
        let ship = tanker();
        let at = move |knots: f64| {
            let wind =
                RelativeWind { speed_mps: knots * KNOT_MPS, angle_rad: degrees.to_radians() };
            let [surge_n, sway_n, _] = ship.force(&wind, AIR_KGPM3);
            1e-3 * libm::hypot(surge_n, sway_n)
        };
        Curve::of(format!("{degrees}° off the bow"), at)
            .never_negative("it is a size")
            .growing_at_most(2.0)
    });
    Sweep {
        key: "wind_speed",
        subject: SUBJECT,
        title: "Loaded tanker of 250,000 dwt: size of the wind's force by wind speed".to_owned(),
        axis: Axis::new("wind", "kn", 0.0, 80.0),
        value: ["force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_is_in_a_group() {
        let grouped: usize = GROUPS.iter().map(|(_, _, types)| types.len()).sum();
        assert_eq!(grouped, BLENDERMANN_TYPES.len());
    }
}
