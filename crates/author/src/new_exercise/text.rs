//! Writes the scenario file of a new exercise.

use core::fmt::Write as _;

use fenderline_contact::{Vec2, vec2};

use super::{BerthingSide, NewBerth, NewExercise, NewShip, NewWeather};
use fenderline_scenario::FenderSize;
use fenderline_scenario::VesselData;

/// Width of the quay (m).
const QUAY_M: f64 = 25.0;
/// Distance from the ship's side to the middle of a tug that stands by (m).
const TUG_OFF_M: f64 = 45.0;
/// Half of a hull's outline from stern to stem, in shares of length and beam. The outline in shares is used for ships
/// that have no outline in the library.
const HULL: [(f64, f64); 6] =
    [(-0.5, 0.3), (-0.45, 0.45), (-0.37, 0.5), (0.31, 0.5), (0.4, 0.42), (0.465, 0.22)];
/// Mooring lines of the ship: name of each, and place of its fairlead in shares of length and beam.
const LINES: [(&str, f64, f64); 6] = [
    ("head", 0.46, 0.15),
    ("fore_breast", 0.41, 0.32),
    ("fore_spring", 0.3, 0.47),
    ("aft_spring", -0.35, 0.47),
    ("aft_breast", -0.42, 0.42),
    ("stern", -0.48, 0.28),
];
/// Places of tugs along the ship, as shares of her length.
const TUG_PLACES: [&[f64]; 5] =
    [&[], &[0.0], &[0.31, -0.34], &[0.36, 0.0, -0.38], &[0.38, 0.14, -0.14, -0.38]];

/// The tables of materials.
pub(crate) const CONCRETE: &str = r#"
[material.concrete]
stiffness = "50 MN/m^2"
shear_stiffness = "10 MN/m"
friction_static = 0.5
friction_dynamic = 0.4
restitution = 0.1
"#;
pub(crate) const FACING: &str = r#"
# Friction of fenders: an assumption, not from a source.
[material.facing]
stiffness = 0
shear_stiffness = "3000 kN/m"
friction_static = 0.2
friction_dynamic = 0.2
"#;
pub(super) const BOW: &str = r#"
# Friction of the tugs' bow fenders: an assumption, not from a source.
[material.bow]
stiffness = "500 kN/m^2"
shear_stiffness = "3000 kN/m"
friction_static = 0.5
friction_dynamic = 0.4
"#;

/// Number of bollards on a quay.
pub(super) fn bollards(berth: &NewBerth) -> usize {
    // Checked to be of the order of a quay.
    let places = libm::floor((berth.length_m - 10.0) / berth.bollard_spacing_m);
    if places < 1e4 { places as usize + 1 } else { usize::MAX }
}

/// The text of the scenario file; `None` if the fenders have neither a size nor height and reaction.
pub(super) fn compose(
    of: &NewExercise,
    ship: &VesselData,
    tug: &VesselData,
    size: Option<&FenderSize>,
) -> Option<String> {
    let mut text = format!(
        "# Made from choices: a straight berth with its face to the west, a ship of the library, tugs and weather. Change it as\n\
         # you like.\n\ntitle = {}\n\n[time]\nstep = \"0.1 s\"\nduration = \"4 h\"\n",
        quoted(&of.title)
    );
    environment(&mut text, of);
    let hull = Hull::of(of, ship);
    ship_body(&mut text, &of.ship, &hull, ship);
    quay(&mut text, of);
    for material in [CONCRETE, FACING, BOW] {
        text.push_str(material);
    }
    fenders(&mut text, &of.berth, size)?;
    tugs(&mut text, of, &hull, tug, &["quay"]);
    lines(&mut text, &hull);
    let (count, spacing_m) = (bollards(&of.berth), of.berth.bollard_spacing_m);
    for index in 0..count {
        let at_m = (index as f64 - 0.5 * (count - 1) as f64) * spacing_m;
        let number = index + 1;
        let _ = write!(
            text,
            "\n[bollard.b{number}]\non = \"quay\"\nat = [{}, 1.5]\nheight = \"4 m\"\n",
            tenth(at_m)
        );
    }
    Some(text)
}

/// The ship's length and beam, and where she starts.
pub(crate) struct Hull {
    length_m: f64,
    beam_m: f64,
    /// Place of the ship's centre of gravity at the start, north and east (m).
    at_m: Vec2,
    /// Direction in which the ship's bow points, and direction from the berth to the water.
    ahead: Vec2,
    to_sea: Vec2,
    /// Side of the ship at which the quay lies: 1 starboard, −1 port.
    shore: f64,
}

impl Hull {
    /// The ship at the straight quay, whose middle is the origin, with the water to the west.
    fn of(of: &NewExercise, ship: &VesselData) -> Hull {
        Hull::at(&of.ship, ship, Vec2::ZERO, vec2(0.0, -1.0))
    }

    /// The ship at a berth whose middle is `middle_m` and from which the water lies in the direction `to_sea`.
    pub(crate) fn at(of: &NewShip, ship: &VesselData, middle_m: Vec2, to_sea: Vec2) -> Hull {
        let particulars = &ship.ship.particulars;
        let length_m = ship.length_overall_m.unwrap_or(particulars.length_m);
        let shore = match of.side {
            BerthingSide::Starboard => 1.0,
            BerthingSide::Port => -1.0,
        };
        // With the berth to starboard, the bow is a quarter turn to port of the direction to the berth.
        let ahead = vec2(-to_sea.y, to_sea.x) * shore;
        let off_m = of.off_m + 0.5 * particulars.beam_m;
        let at_m = middle_m + to_sea * off_m - ahead * of.astern_m;
        Hull { length_m, beam_m: particulars.beam_m, at_m, ahead, to_sea, shore }
    }
}

/// A direction as degrees from north, 0 to 360.
fn bearing_deg(of: Vec2) -> f64 {
    let deg = tenth(libm::atan2(of.y, of.x).to_degrees());
    if deg < 0.0 { deg + 360.0 } else { deg }
}

/// Writes the ship's lines, which are still on board.
pub(crate) fn lines(text: &mut String, hull: &Hull) {
    for (name, along, across) in LINES {
        let _ = write!(
            text,
            "\n[line.{name}]\nfrom = \"ship\"\nfairlead = [{}, {}]\nfairlead_height = \"6 m\"\nrope = \"polyester\"\n\
             break_load = \"800 kN\"\nwinch = true\n",
            tenth(along * hull.length_m),
            tenth(hull.shore * across * hull.beam_m)
        );
    }
}

fn environment(text: &mut String, of: &NewExercise) {
    let _ = write!(text, "\n[environment]\ndepth = {}\n", of.berth.depth_m);
    for (key, value) in weather(of) {
        let _ = writeln!(text, "{key} = {value}");
    }
}

/// The keys of wind, current and visibility, with the values that the user chose.
pub(super) fn weather(of: &NewExercise) -> Vec<(&'static str, String)> {
    let NewWeather { wind_mps, wind_from_rad, gusts, current_mps, current_to_rad, visibility_m } =
        of.weather;
    let wind = (wind_mps > 0.0).then(|| {
        let value =
            format!("{{ speed = {wind_mps}, from = {wind_from_rad}, gusts = {gusts}, seed = 1 }}");
        ("wind", value)
    });
    let current = (current_mps > 0.0)
        .then(|| ("current", format!("{{ speed = {current_mps}, towards = {current_to_rad} }}")));
    let visibility = visibility_m.map(|visibility_m| ("visibility", visibility_m.to_string()));
    [wind, current, visibility].into_iter().flatten().collect()
}

pub(crate) fn ship_body(text: &mut String, of: &NewShip, hull: &Hull, ship: &VesselData) {
    let _ = write!(text, "\n[body.ship]\nvessel = {}\n", quoted(&ship.name));
    if ship.outline_m.is_none() {
        // The outline is about the centre of gravity.
        let ahead_m = ship.ship.particulars.centre_of_gravity_m;
        let corner = |(along, across): (f64, f64)| {
            format!("[{}, {}]", tenth(along * hull.length_m - ahead_m), tenth(across * hull.beam_m))
        };
        let port = HULL.iter().map(|(along, across)| corner((*along, -across)));
        let starboard = HULL.iter().rev().map(|at| corner(*at));
        let all: Vec<String> = port.chain([corner((0.5, 0.0))]).chain(starboard).collect();
        let _ = writeln!(text, "outline = [{}]", all.join(", "));
    }
    let _ = write!(
        text,
        "position = [{}, {}]\nheading = \"{} deg\"\nvelocity = {{ surge = {} }}\n",
        tenth(hull.at_m.x),
        tenth(hull.at_m.y),
        bearing_deg(hull.ahead),
        of.speed_mps
    );
}

fn quay(text: &mut String, of: &NewExercise) {
    let half_m = 0.5 * of.berth.length_m;
    let _ = write!(
        text,
        "\n[body.quay]\nfixed = true\noutline = [[-{half_m}, 0], [{half_m}, 0], [{half_m}, {QUAY_M}], [-{half_m}, {QUAY_M}]]\n\
         \n[[pair]]\nbodies = [\"ship\", \"quay\"]\nmaterial = \"concrete\"\n"
    );
}

fn fenders(text: &mut String, berth: &NewBerth, size: Option<&FenderSize>) -> Option<()> {
    let height_m = match size {
        Some(size) => size.height_m,
        None => berth.height_m?,
    };
    // A pneumatic fender is as thick as it projects. Others carry a panel, of about a fifth of their height.
    let is_pneumatic = berth.fender == "pneumatic";
    let projection_m = if is_pneumatic { height_m } else { 1.2 * height_m };
    let width_m = size.and_then(|size| size.length_m).unwrap_or(1.5 * height_m);
    let first_m = -0.5 * berth.fender_spacing_m * (berth.fenders - 1) as f64;
    let _ = write!(
        text,
        "\n[fender_row.row]\non = \"quay\"\nfirst = [{}, 0]\nspacing = {}\nnumber = {}\nwidth = {}\nprojection = {}\n\
         type = {}\nmaterial = \"facing\"\n",
        first_m,
        berth.fender_spacing_m,
        berth.fenders,
        width_m,
        projection_m,
        quoted(&berth.fender)
    );
    match size {
        Some(size) => {
            let _ = writeln!(text, "size = {}", quoted(&size.designation));
        }
        None => {
            let reaction_n = berth.rated_reaction_n?;
            let _ = writeln!(text, "height = {height_m}\nrated_reaction = {reaction_n}");
        }
    }
    Some(())
}

/// Writes the tugs, each on her line. The tugs may touch the ship, each other, and the fixed bodies that `ashore`
/// names.
pub(super) fn tugs(
    text: &mut String,
    of: &NewExercise,
    hull: &Hull,
    tug: &VesselData,
    ashore: &[&str],
) {
    let half_m = 0.5 * tug.length_overall_m.unwrap_or(tug.ship.particulars.length_m);
    let (sea, off_m) = (-hull.shore, 0.5 * hull.beam_m + TUG_OFF_M);
    let names: Vec<String> = (1..=of.tugs.number).map(|number| format!("tug_{number}")).collect();
    for (name, along) in names.iter().zip(TUG_PLACES[of.tugs.number]) {
        let along_m = tenth(along * hull.length_m);
        let at_m = hull.at_m + hull.ahead * along_m + hull.to_sea * off_m;
        let (north_m, east_m) = (tenth(at_m.x), tenth(at_m.y));
        let _ = write!(
            text,
            "\n[body.{name}]\nvessel = {}\nposition = [{north_m}, {east_m}]\nheading = \"{} deg\"\n\
             \n[fender.bow_of_{name}]\non = \"{name}\"\nbelting = \"bow\"\nprojection = \"0.9 m\"\nmaterial = \"bow\"\n\
             \n[line.tow_of_{name}]\nfrom = \"{name}\"\nfairlead = [{}, 0]\nto = \"ship\"\nbollard = [{along_m}, {}]\n\
             rope = \"hmpe\"\nbreak_load = \"2400 kN\"\n\
             tail = {{ rope = \"nylon\", break_load = \"2600 kN\", length = \"20 m\" }}\nlength = \"60 m\"\nwinch = true\n\
             \n[[order]]\nvessel = \"{name}\"\n\
             follow_ship = {{ ship = \"ship\", at = [{along_m}, {}], heading = \"{} deg\", speed = \"4 kn\" }}\n",
            quoted(&tug.name),
            bearing_deg(hull.to_sea * -1.0),
            tenth(half_m - 1.5),
            tenth(sea * (0.5 * hull.beam_m - 2.0)),
            tenth(sea * off_m),
            hull.shore * 90.0
        );
    }
    for (index, name) in names.iter().enumerate() {
        let others = names[index + 1..].iter().map(String::as_str);
        for other in ["ship"].into_iter().chain(ashore.iter().copied()).chain(others) {
            pair(text, name, other);
        }
    }
}

/// Writes a pair of two bodies that may touch.
pub(super) fn pair(text: &mut String, one: &str, other: &str) {
    let (one, other) = (quoted(one), quoted(other));
    let _ = write!(text, "\n[[pair]]\nbodies = [{one}, {other}]\nmaterial = \"concrete\"\n");
}

/// A number rounded to a tenth, for a file that people read.
fn tenth(value_m: f64) -> f64 {
    // Adding 0 makes 0 of −0.
    libm::round(10.0 * value_m) / 10.0 + 0.0
}

/// A text in quotation marks, in JSON's form, which is valid in TOML too.
pub(crate) fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
