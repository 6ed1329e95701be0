//! The text of a new exercise.

use core::fmt::Write as _;

use super::{BerthingSide, NewBerth, NewExercise};
use crate::library::FenderSize;
use crate::vessels::VesselData;

/// Width of the quay (m).
const QUAY_M: f64 = 25.0;
/// From the ship's side to the middle of a tug that stands by (m).
const TUG_OFF_M: f64 = 45.0;
/// Half of a hull's outline, from stern to stem: shares of length and beam. For ships whose library has no outline.
const HULL: [(f64, f64); 6] =
    [(-0.5, 0.3), (-0.45, 0.45), (-0.37, 0.5), (0.31, 0.5), (0.4, 0.42), (0.465, 0.22)];
/// Lines on board: name, and the share of length and beam of its fairlead.
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

/// What the file's tables of materials say, for every exercise.
const MATERIALS: &str = r#"
[material.concrete]
stiffness = "50 MN/m^2"
shear_stiffness = "10 MN/m"
friction_static = 0.5
friction_dynamic = 0.4
restitution = 0.1

# Friction of fenders and of the tugs' bow fenders: assumptions, not from a source.
[material.facing]
stiffness = 0
shear_stiffness = "3000 kN/m"
friction_static = 0.2
friction_dynamic = 0.2

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

/// The file; `None` where fenders have neither a size nor height and reaction.
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
    bodies(&mut text, of, &hull, ship);
    text.push_str(MATERIALS);
    fenders(&mut text, &of.berth, size)?;
    tugs(&mut text, of, &hull, tug);
    for (name, along, across) in LINES {
        let _ = write!(
            text,
            "\n[line.{name}]\nfrom = \"ship\"\nfairlead = [{}, {}]\nfairlead_height = \"6 m\"\nrope = \"polyester\"\n\
             break_load = \"800 kN\"\nwinch = true\n",
            tenth(along * hull.length_m),
            tenth(hull.shore * across * hull.beam_m)
        );
    }
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

/// The ship's measures and place.
struct Hull {
    length_m: f64,
    beam_m: f64,
    /// Of her centre of gravity, north and east (m).
    at_m: [f64; 2],
    heading_deg: f64,
    /// The side of the quay: 1 starboard, −1 port.
    shore: f64,
}

impl Hull {
    fn of(of: &NewExercise, ship: &VesselData) -> Hull {
        let particulars = &ship.ship.particulars;
        let length_m = ship.length_overall_m.unwrap_or(particulars.length_m);
        let (shore, heading_deg) = match of.ship.side {
            BerthingSide::Starboard => (1.0, 0.0),
            BerthingSide::Port => (-1.0, 180.0),
        };
        let east_m = -(of.ship.off_m + 0.5 * particulars.beam_m);
        Hull {
            length_m,
            beam_m: particulars.beam_m,
            at_m: [-shore * of.ship.astern_m, east_m],
            heading_deg,
            shore,
        }
    }
}

fn environment(text: &mut String, of: &NewExercise) {
    let weather = &of.weather;
    let _ = write!(text, "\n[environment]\ndepth = {}\n", of.berth.depth_m);
    if weather.wind_mps > 0.0 {
        let _ = writeln!(
            text,
            "wind = {{ speed = {}, from = {}, gusts = {}, seed = 1 }}",
            weather.wind_mps, weather.wind_from_rad, weather.gusts
        );
    }
    if weather.current_mps > 0.0 {
        let _ = writeln!(
            text,
            "current = {{ speed = {}, towards = {} }}",
            weather.current_mps, weather.current_to_rad
        );
    }
    if let Some(visibility_m) = weather.visibility_m {
        let _ = writeln!(text, "visibility = {visibility_m}");
    }
}

fn bodies(text: &mut String, of: &NewExercise, hull: &Hull, ship: &VesselData) {
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
    let [north_m, east_m] = hull.at_m.map(tenth);
    let _ = write!(
        text,
        "position = [{north_m}, {east_m}]\nheading = \"{} deg\"\nvelocity = {{ surge = {} }}\n",
        hull.heading_deg, of.ship.speed_mps
    );
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

fn tugs(text: &mut String, of: &NewExercise, hull: &Hull, tug: &VesselData) {
    let half_m = 0.5 * tug.length_overall_m.unwrap_or(tug.ship.particulars.length_m);
    let (sea, off_m) = (-hull.shore, 0.5 * hull.beam_m + TUG_OFF_M);
    let names: Vec<String> = (1..=of.tugs.number).map(|number| format!("tug_{number}")).collect();
    for (name, along) in names.iter().zip(TUG_PLACES[of.tugs.number]) {
        let along_m = tenth(along * hull.length_m);
        // On the earth: ahead of the ship is north if her heading is zero.
        let north_m = tenth(hull.at_m[0] + hull.shore * along_m);
        let east_m = tenth(hull.at_m[1] - off_m);
        let _ = write!(
            text,
            "\n[body.{name}]\nvessel = {}\nposition = [{north_m}, {east_m}]\nheading = \"90 deg\"\n\
             \n[fender.bow_of_{name}]\non = \"{name}\"\nbelting = \"bow\"\nprojection = \"0.9 m\"\nmaterial = \"bow\"\n\
             \n[line.tow_of_{name}]\nfrom = \"{name}\"\nfairlead = [{}, 0]\nto = \"ship\"\nbollard = [{along_m}, {}]\n\
             rope = \"hmpe\"\nbreak_load = \"2400 kN\"\n\
             tail = {{ rope = \"nylon\", break_load = \"2600 kN\", length = \"20 m\" }}\nlength = \"60 m\"\nwinch = true\n\
             \n[[order]]\nvessel = \"{name}\"\n\
             follow_ship = {{ ship = \"ship\", at = [{along_m}, {}], heading = \"{} deg\", speed = \"4 kn\" }}\n",
            quoted(&tug.name),
            tenth(half_m - 1.5),
            tenth(sea * (0.5 * hull.beam_m - 2.0)),
            tenth(sea * off_m),
            hull.shore * 90.0
        );
    }
    for (index, name) in names.iter().enumerate() {
        let others = names[index + 1..].iter().map(String::as_str);
        for other in ["ship", "quay"].into_iter().chain(others) {
            let _ = write!(
                text,
                "\n[[pair]]\nbodies = [\"{name}\", \"{other}\"]\nmaterial = \"concrete\"\n"
            );
        }
    }
}

/// Rounded to a tenth, for a file that people read.
fn tenth(value_m: f64) -> f64 {
    // Adding 0 makes 0 of −0.
    libm::round(10.0 * value_m) / 10.0 + 0.0
}

/// A text in quotes: those of JSON are those of TOML.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
