//! `check` tells the keys that have no effect in a scenario: those, and no others. `docs/design/files.md` has the criterion.

use std::path::{Path, PathBuf};

use fenderline_scenario::Scenario;

/// A plain ship at a quay with one fender.
const BERTH: &str = r#"
[time]
step = "0.1 s"
duration = "10 s"
[material.concrete]
stiffness = "50 MN/m^2"
[material.facing]
stiffness = 0
shear_stiffness = "3000 kN/m"
friction_static = 0.2
[body.ship]
outline = [[-60, -10], [60, -10], [60, 10], [-60, 10]]
mass = "9000 t"
gyradius = "30 m"
[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 9], [-100, 9]]
position = [0, 12]
[fender.one]
on = "quay"
position = [0, 0]
width = "2 m"
projection = "1 m"
stiffness = "900 kN/m"
material = "facing"
[[pair]]
bodies = ["ship", "quay"]
material = "concrete"
"#;

/// A vessel alone.
const VESSEL: &str = r#"
[time]
step = "0.1 s"
duration = "10 s"
[body.ship]
vessel = "container-ship"
"#;

/// The keys that notices tell as without effect, in the order of the notices.
fn idle(text: &str) -> Vec<String> {
    let scenario =
        Scenario::parse(text, "x.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let told = scenario.notices.into_iter().filter(|notice| notice.is_without_effect());
    told.map(|notice| notice.key).collect()
}

#[test]
fn a_scenario_without_idle_keys_has_no_such_notice() {
    assert_eq!(idle(BERTH), [""; 0]);
    assert_eq!(idle(VESSEL), [""; 0]);
}

/// A vessel of the scenario's own, for keys of vessels and weather.
const OWN_VESSEL: &str = r#"
[time]
step = "0.1 s"
duration = "10 s"
[vessel.coaster]
length_bp = "130 m"
beam = "20 m"
draught = "7.5 m"
block_coefficient = 0.74
[body.ship]
vessel = "coaster"
outline = [[-68, -10], [68, -10], [68, 10], [-68, 10]]
"#;

/// A moored vessel, for lines and limits.
const MOORED: &str = r#"
[time]
step = "0.1 s"
duration = "10 s"
[body.ship]
vessel = "container-ship"
[body.quay]
fixed = true
outline = [[-200, 0], [200, 0], [200, 9], [-200, 9]]
position = [0, 40]
[material.concrete]
stiffness = "50 MN/m^2"
[[pair]]
bodies = ["ship", "quay"]
material = "concrete"
"#;

const LINE: &str = r#"
[line.head]
from = "ship"
chock = "head-starboard"
to = "quay"
bollard = [150, 6]
rope = "hmpe"
break_load = "1200 kN"
pretension = "100 kN"
"#;

/// Made-up scenarios with keys that have no effect: the scenario, what is replaced in it, what is added, the keys that are told.
type Trap = (
    &'static str,
    &'static str,
    (&'static str, &'static str),
    &'static str,
    &'static [&'static str],
);

const AS_IT_IS: (&str, &str) = ("", "");

const TRAPS: &[Trap] = &[
    (
        "stiffness of a facing whose fenders have laws",
        BERTH,
        ("stiffness = 0\n", "stiffness = \"500 kN/m^2\"\n"),
        "",
        &["material.facing.stiffness"],
    ),
    (
        "shear stiffness without friction",
        BERTH,
        ("friction_static = 0.2\n", ""),
        "",
        &["material.facing.shear_stiffness"],
    ),
    (
        "friction of a material of rollers",
        BERTH,
        ("material = \"facing\"\n", "material = \"facing\"\nrolling_resistance = 0.05\n"),
        "",
        &["material.facing.friction_static"],
    ),
    (
        "restitution of a facing whose fenders unload by their law",
        BERTH,
        ("friction_static = 0.2\n", "friction_static = 0.2\nrestitution = 0.1\n"),
        "",
        &["material.facing.restitution"],
    ),
    (
        "a material that nothing uses",
        BERTH,
        AS_IT_IS,
        "[material.steel]\nstiffness = \"5 MN/m^2\"\n",
        &["material.steel"],
    ),
    (
        "mass of a panel that no chain carries",
        BERTH,
        ("width =", "panel_mass = \"2 t\"\nwidth ="),
        "",
        &["fender.one.panel_mass"],
    ),
    (
        "a fender that floats on a ship",
        BERTH,
        AS_IT_IS,
        "[fender.two]\non = \"ship\"\nposition = [0, -10]\nwidth = \"1 m\"\nprojection = \"1 m\"\nstiffness = \"900 kN/m\"\nmaterial = \"facing\"\nfloating = true\n",
        &["fender.two.floating"],
    ),
    (
        "wind on a plain body",
        BERTH,
        AS_IT_IS,
        "[environment]\nwind = { speed = \"9 m/s\", from = 0 }\n",
        &["environment.wind"],
    ),
    (
        "current on a plain body",
        BERTH,
        AS_IT_IS,
        "[environment]\ncurrent = { speed = \"1 kn\", towards = 0 }\n",
        &["environment.current"],
    ),
    (
        "waves on a plain body",
        BERTH,
        AS_IT_IS,
        "[environment]\nwaves = { height = \"1 m\", period = \"8 s\", from = 0 }\n",
        &["environment.waves"],
    ),
    (
        "squat of a plain body",
        BERTH,
        AS_IT_IS,
        "[environment]\ndepth = \"20 m\"\nsquat = \"barrass\"\n",
        &["environment.squat"],
    ),
    (
        "wind on a vessel without wind areas",
        OWN_VESSEL,
        AS_IT_IS,
        "[environment]\nwind = { speed = \"9 m/s\", from = 0 }\n",
        &["environment.wind"],
    ),
    (
        "seed and admittance of a wind without gusts",
        VESSEL,
        AS_IT_IS,
        "[environment]\nwind = { speed = \"9 m/s\", from = 0, seed = 3, gust_admittance = false }\n",
        &["environment.wind.gust_admittance", "environment.wind.seed"],
    ),
    (
        "peak and seed of a regular wave",
        VESSEL,
        AS_IT_IS,
        "[environment]\nwaves = { height = \"1 m\", period = \"8 s\", from = 0, regular = true, peakedness = 2, seed = 3 }\n",
        &["environment.waves.peakedness", "environment.waves.seed"],
    ),
    (
        "sections without a flow",
        VESSEL,
        AS_IT_IS,
        "[environment]\ninteraction = { midship_coefficient = 0.9, sections = \"outline\" }\n",
        &["environment.interaction.midship_coefficient", "environment.interaction.sections"],
    ),
    (
        "radius of a track without a bend",
        VESSEL,
        AS_IT_IS,
        "[passing.one]\nvessel = \"kcs\"\nwaypoints = [[-2000, 900], [0, 900]]\nturning_radius = \"600 m\"\nspeed = \"8 kn\"\ndepth_factors = \"none\"\n",
        &["passing.one.turning_radius"],
    ),
    (
        "a vessel that no body is",
        OWN_VESSEL,
        AS_IT_IS,
        "[vessel.other]\nfrom = \"kvlcc2\"\n",
        &["vessel.other"],
    ),
    (
        "an order after the end",
        OWN_VESSEL,
        AS_IT_IS,
        "[vessel.t]\nfrom = \"container-ship\"\n[body.t]\nvessel = \"t\"\nposition = [0, 900]\n[[pair]]\nbodies = [\"ship\", \"t\"]\nmaterial = \"m\"\n[material.m]\nstiffness = 1\n[[order]]\nat = \"20 s\"\nvessel = \"t\"\nrudder = \"9 deg\"\n",
        &["order.0"],
    ),
    (
        "an event after the end",
        VESSEL,
        AS_IT_IS,
        "[[event]]\nat = \"10 s\"\nwind = { speed = \"9 m/s\", from = 0 }\n",
        &["event.0"],
    ),
    (
        "a load after the end",
        BERTH,
        AS_IT_IS,
        "[[load]]\nbody = \"ship\"\nforce = [0, \"9 kN\"]\nfrom = \"1 min\"\n",
        &["load.0"],
    ),
    (
        "a limit of lines without lines",
        VESSEL,
        AS_IT_IS,
        "[limit.a]\nof = \"lines\"\nshare = 0.5\n",
        &["limit.a"],
    ),
    (
        "a limit of fenders without fenders",
        VESSEL,
        AS_IT_IS,
        "[limit.a]\nof = \"fenders\"\nshare = 0.5\n",
        &["limit.a"],
    ),
    (
        "an exercise with limits that cannot be exceeded",
        VESSEL,
        AS_IT_IS,
        "[exercise]\nvessel = \"ship\"\ngoal = \"clear\"\n[exercise.limit]\nunder_keel = { least = 1, points = 9 }\nclearance = { least = 1, points = 9 }\n[body.quay]\nfixed = true\noutline = [[-9, 0], [9, 0], [9, 9], [-9, 9]]\nposition = [0, 90]\n[material.facing]\nstiffness = 0\n[fender.one]\non = \"quay\"\nposition = [0, 0]\nwidth = 1\nprojection = 1\nstiffness = 1e6\nmaterial = \"facing\"\n[[pair]]\nbodies = [\"ship\", \"quay\"]\nmaterial = \"m\"\n[material.m]\nstiffness = 1\n",
        &["exercise.limit.clearance", "exercise.limit.under_keel"],
    ),
    (
        "a bank beside a plain body",
        BERTH,
        AS_IT_IS,
        "[environment]\nbank = [{ from = [-500, 40], to = [500, 40] }]\n",
        &["environment.bank"],
    ),
    (
        "a floating fender in water that stays at datum",
        MOORED,
        AS_IT_IS,
        "[fender.one]\non = \"quay\"\nposition = [0, 0]\nwidth = 1\nprojection = 1\nstiffness = 1e6\nmaterial = \"concrete\"\nfloating = true\n",
        &["fender.one.floating"],
    ),
    (
        "factors of a type that has none",
        BERTH,
        (
            "projection = \"1 m\"\nstiffness = \"900 kN/m\"",
            "type = \"pneumatic\"\nsize = \"2500x4000 50kPa\"\nangle_factor = false\nvelocity_factor = true",
        ),
        "",
        &["fender.one.angle_factor", "fender.one.velocity_factor"],
    ),
    (
        "the flow between vessels where there is one",
        VESSEL,
        AS_IT_IS,
        "[environment]\ninteraction = { between_vessels = true }\n",
        &["environment.interaction.between_vessels"],
    ),
    (
        "a berthing study without fenders",
        VESSEL,
        AS_IT_IS,
        "[environment]\ndepth = \"20 m\"\n[berthing]\nship = \"ship\"\n",
        &["berthing"],
    ),
    (
        "type and side of an anchor whose holding factor and hawse pipe are given",
        VESSEL,
        AS_IT_IS,
        "[environment]\ndepth = \"20 m\"\n[anchor.one]\non = \"ship\"\nside = \"starboard\"\nhawse = [130, -8]\nhawse_height = 10\nmass = \"8 t\"\nchain_diameter = \"76 mm\"\nchain_length = \"11 shackles\"\ntype = \"high_holding_power\"\nholding_factor = 5\n",
        &["anchor.one.type", "anchor.one.side"],
    ),
    (
        "the end of a load after that of the run",
        BERTH,
        AS_IT_IS,
        "[[load]]\nbody = \"ship\"\nforce = [0, \"9 kN\"]\nuntil = \"1 min\"\n",
        &["load.0.until"],
    ),
    (
        "a line that is made fast after the end",
        MOORED,
        AS_IT_IS,
        "LINEmade_fast = \"1 min\"\n",
        &["line.head"],
    ),
];

#[test]
fn each_key_without_effect_is_told() {
    for (name, base, (find, replace), more, expected) in TRAPS {
        assert!(base.contains(find), "{name}");
        let text = base.replacen(find, replace, 1) + &more.replace("LINE", LINE);
        assert_eq!(idle(&text), *expected, "{name}\n{text}");
    }
}

/// The scenarios of the repository are without such keys.
#[test]
fn no_scenario_of_the_repository_has_a_key_without_effect() {
    let files = toml_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios"));
    assert!(files.len() > 40);
    let mut told = Vec::new();
    for file in files {
        let scenario = Scenario::load(&file, &[]).unwrap_or_else(|error| panic!("{error}"));
        let idle = scenario.notices.iter().filter(|notice| notice.is_without_effect());
        told.extend(idle.map(ToString::to_string));
    }
    assert_eq!(told, [""; 0]);
}

fn toml_files(folder: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            all.extend(toml_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "toml") {
            all.push(path);
        }
    }
    all.sort();
    all
}
