//! Makes a scenario at a berth of a chart: the tables of the chart, a solid shore, fenders and bollards along a quay line,
//! and a ship off the berth.

use core::fmt::{self, Write as _};

use fenderline_charts::chart::projection::Projected;
use fenderline_contact::{Vec2, vec2};
use fenderline_keys::keys::chart::Projection;
use fenderline_scenario::{Scenario, ScenarioError, VesselData, VesselLibrary};
use fenderline_sim::chart::{ChartClass, GeographicPlace};
use toml_edit::{DocumentMut, Item, Value};

use crate::new_exercise::text::{self, Hull, quoted};
use crate::new_exercise::{BerthingSide, NewShip, can_be_ship};

/// Distances off the berth at which the ship begins (m): the first at which she floats clear of the shore.
const OFF_M: [f64; 8] = [120.0, 80.0, 50.0, 30.0, 15.0, 250.0, 500.0, 1000.0];
/// A ship that floats only farther off than this gets a note in the file: the chart has too little water at the berth (m).
const NEAR_M: f64 = 120.0;
/// The ship is at most this share of the berth's length; our choice.
const MOST_OF_BERTH: f64 = 0.9;
/// The ship of short berths.
const SMALL_SHIP: &str = "asd-tug";
/// Classes that become solid, if the chart has them.
const SOLID: [&str; 4] = ["LNDARE", "SLCONS", "coast", "quay"];

/// What a scenario at a berth of a chart is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct NewHarbour {
    /// Name of the chart's folder, for messages and for the title.
    pub chart: String,
    /// Text of the file `chart.toml`, which `python -m fenderline.charts` writes.
    pub tables: String,
    /// Path from the new file to the chart's files, with a slash at the end; empty if they lie in the same folder.
    pub prefix: String,
    /// The berth: the name of a quay line, or latitude and longitude of the two ends of the berth in degrees, with
    /// commas; for a chart in metres north and east of both ends.
    pub berth: String,
    /// The side of the water, seen along the berth: `left` or `right`. `None`: as the chart has it.
    pub water: Option<String>,
    /// The ship, by her name in the library. `None`: the longest that fits the berth.
    pub vessel: Option<String>,
}

/// Says why there is no scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewHarbourError(String);

impl fmt::Display for NewHarbourError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for NewHarbourError {}

type Made<T> = Result<T, NewHarbourError>;

fn failed<T>(why: String) -> Made<T> {
    Err(NewHarbourError(why))
}

/// A reader of the files that the new scenario names.
type Reader<'r> = dyn FnMut(&str) -> Result<String, String> + 'r;

impl NewHarbour {
    /// The text of the scenario, which has been read again as a scenario and is a good one. `read` returns the text of
    /// a file that the scenario names.
    ///
    /// # Errors
    /// Fails if the tables have no chart, if the chart has no line for the berth or nothing solid, and if no ship floats
    /// off the berth.
    pub fn text(&self, read: &mut Reader<'_>) -> Made<String> {
        let mut tables = self.tables()?;
        let quay_line = self.quay_line(&tables)?;
        let bare = self.parsed(&format!("{HEAD}{PROBE}{tables}"), read)?;
        let classes = &bare.setup.world.chart.classes;
        let solid: Vec<&str> =
            SOLID.into_iter().filter(|word| classes.iter().any(|of| has(of, word))).collect();
        if solid.is_empty() {
            return failed(format!(
                "the chart in {} has neither land nor quays: a berth needs LNDARE or SLCONS",
                self.chart
            ));
        }
        let mut list = toml_edit::Array::new();
        list.extend(solid);
        tables["chart"]["solid"] = Item::Value(Value::Array(list));
        tables["chart"]["solid_material"] = toml_edit::value("concrete");
        let title = quoted(&format!("A berth of the chart in {}", self.chart));
        let base = format!(
            "# The berth is on a quay line of the chart. Sizes and distances of its fenders and bollards are fenderline's\n\
             # choice, not those of the real berth. The chart is not for navigation.\n\ntitle = {title}\n{HEAD}\n{}\n\n{}{}",
            tables.to_string().trim(),
            text::CONCRETE.trim_start_matches('\n'),
            berth(&quay_line)
        );
        let at_berth = self.parsed(&format!("{base}{PROBE}"), read)?;
        let fenders = &at_berth.setup.fenders;
        let (Some(first), Some(last)) = (fenders.first(), fenders.last()) else {
            return failed("the berth has no fenders".to_owned());
        };
        let (middle_m, length_m) = (
            (first.position_m + last.position_m) * 0.5,
            (last.position_m - first.position_m).length() + SPACING_M,
        );
        let to_sea = fenders.iter().fold(Vec2::ZERO, |sum, fender| {
            sum + vec2(libm::cos(fender.facing_rad), libm::sin(fender.facing_rad))
        });
        if to_sea.length() < 0.5 {
            return failed(
                "the fenders of the berth face in all directions: choose a straighter part"
                    .to_owned(),
            );
        }
        let to_sea = to_sea * (1.0 / to_sea.length());
        let mut why = String::new();
        for ship in self.ships(length_m)? {
            for off_m in OFF_M {
                let start = NewShip {
                    vessel: ship.name.clone(),
                    side: BerthingSide::Port,
                    off_m,
                    astern_m: 0.0,
                    speed_mps: 0.0,
                };
                let hull = Hull::at(&start, ship, middle_m, to_sea);
                let mut text = base.clone();
                text::ship_body(&mut text, &start, &hull, ship);
                text::lines(&mut text, &hull);
                match Scenario::parse_among(&text, NAME, &[], read) {
                    Err(error) => why = error.message().to_owned(),
                    Ok(scenario) => {
                        let aground = scenario
                            .notices
                            .iter()
                            .find(|notice| notice.message.contains("aground"));
                        match aground {
                            None => return Ok(noted(text, off_m)),
                            Some(notice) => why.clone_from(&notice.message),
                        }
                    }
                }
            }
        }
        failed(format!(
            "no ship floats off the berth, from {} to {} m from its fenders: {why}\n  = help: a survey or a chart of larger scale may have \
             more water; without [environment.bottom] in chart.toml the water is deep",
            OFF_M[4],
            OFF_M[OFF_M.len() - 1]
        ))
    }

    /// The tables of the chart, with the paths of the files as the new scenario needs them.
    fn tables(&self) -> Made<DocumentMut> {
        let mut tables: DocumentMut = match self.tables.parse() {
            Ok(tables) => tables,
            Err(error) => return failed(format!("{}/chart.toml: {error}", self.chart)),
        };
        let files = tables.get_mut("chart").and_then(|chart| chart.get_mut("files"));
        let Some(files) = files.and_then(Item::as_array_mut) else {
            return failed(format!("{}/chart.toml has no table [chart] with files", self.chart));
        };
        for file in files.iter_mut() {
            let Some(name) = file.as_str() else {
                return failed(format!(
                    "{}/chart.toml: `chart.files` is no list of names",
                    self.chart
                ));
            };
            *file = Value::from(format!("{}{name}", self.prefix));
        }
        let bottom = tables.get_mut("environment").and_then(|of| of.get_mut("bottom"));
        if let Some(surveys) =
            bottom.and_then(|of| of.get_mut("survey")).and_then(Item::as_array_mut)
        {
            for file in surveys.iter_mut() {
                if let Some(name) = file.as_str() {
                    *file = Value::from(format!("{}{name}", self.prefix));
                }
            }
        }
        Ok(tables)
    }

    /// The table `quay_line` of the berth.
    fn quay_line(&self, tables: &DocumentMut) -> Made<String> {
        let water = self.water.as_ref();
        let water = water.map_or(String::new(), |side| format!(", water = {}", quoted(side)));
        let parts: Vec<&str> = self.berth.split(',').map(str::trim).collect();
        let numbers: Vec<f64> = parts.iter().filter_map(|part| part.parse().ok()).collect();
        if numbers.len() != parts.len() {
            return Ok(format!("{{ name = {}{water} }}", quoted(&self.berth)));
        }
        let [a, b, c, d] = numbers[..] else {
            return failed(format!(
                "the berth has {} numbers: latitude and longitude of both ends are four numbers with commas",
                numbers.len()
            ));
        };
        let ends = match tables["chart"].get("origin") {
            None => [vec2(a, b), vec2(c, d)],
            Some(origin) => {
                for (latitude, longitude) in [(a, b), (c, d)] {
                    if latitude.abs() > 84.0 || longitude.abs() > 180.0 {
                        return failed(format!(
                            "{latitude}, {longitude} is no place on the chart: latitude comes first, in degrees"
                        ));
                    }
                }
                let angle = |key: &str| origin.get(key).and_then(in_rad);
                let (Some(latitude_rad), Some(longitude_rad)) =
                    (angle("latitude"), angle("longitude"))
                else {
                    return failed(format!(
                        "{}/chart.toml: `chart.origin` cannot be read",
                        self.chart
                    ));
                };
                let is_utm =
                    tables["chart"].get("projection").and_then(Item::as_str) == Some("utm");
                let projection = if is_utm { Projection::Utm } else { Projection::ThroughOrigin };
                let origin = GeographicPlace { latitude_rad, longitude_rad };
                let projected = Projected::about(origin, projection);
                [(a, b), (c, d)].map(|(latitude, longitude)| {
                    projected.to_m(GeographicPlace {
                        latitude_rad: latitude.to_radians(),
                        longitude_rad: longitude.to_radians(),
                    })
                })
            }
        };
        let [from, to] = ends.map(|at| format!("[{:.1}, {:.1}]", at.x + 0.0, at.y + 0.0));
        Ok(format!("{{ from = {from}, to = {to}{water} }}"))
    }

    fn parsed(&self, text: &str, read: &mut Reader<'_>) -> Made<Scenario> {
        Scenario::parse_among(text, NAME, &[], read).map_err(|error| self.told(&error))
    }

    /// The error of a scenario in words for a user who has not seen the scenario.
    fn told(&self, error: &ScenarioError) -> NewHarbourError {
        let message = error
            .message()
            .replace("`fender_row.f.quay_line`", "the berth")
            .replace("`fender_row.f.quay_line.name`", "the berth")
            .replace("`fender_row.f.quay_line.from`", "the first end of the berth")
            .replace("`fender_row.f.quay_line.to`", "the second end of the berth");
        let help = match error.help() {
            Some(help) if help.contains("give `water`") => {
                "\n  = help: say on which side of the berth the water lies, seen from the first end: --water left or --water right"
                    .to_owned()
            }
            Some(help) if help.contains("positions are north") => {
                "\n  = help: latitude comes first, in degrees; in a chart in metres north comes first".to_owned()
            }
            Some(help) if help.contains("`from` and `to`") || help.contains("`check`") => {
                "\n  = help: give the ends of the berth: --berth \"LAT,LON,LAT,LON\"".to_owned()
            }
            Some(help) => format!("\n  = help: {help}"),
            None => String::new(),
        };
        NewHarbourError(format!("{}: {message}{help}", self.chart))
    }

    /// The ships that are tried, from the longest.
    fn ships(&self, length_m: f64) -> Made<Vec<&'static VesselData>> {
        let library = VesselLibrary::of_program();
        let look_up = |name: &str| match library.vessel(name) {
            Ok(vessel) => Ok(vessel),
            Err(error) => failed(error.to_string()),
        };
        if let Some(name) = &self.vessel {
            return Ok(vec![look_up(name)?]);
        }
        let long_m = |ship: &VesselData| ship.ship.particulars.length_m;
        let mut ships: Vec<&VesselData> = library
            .vessels()
            .iter()
            .filter(|ship| can_be_ship(ship) && long_m(ship) <= MOST_OF_BERTH * length_m)
            .collect();
        ships.sort_by(|one, other| long_m(other).total_cmp(&long_m(one)));
        ships.push(look_up(SMALL_SHIP)?);
        Ok(ships)
    }
}

/// Name of the new scenario in errors.
const NAME: &str = "harbour.toml";
/// Distance between fenders (m).
const SPACING_M: f64 = 12.0;
/// Time step and length of the run.
const HEAD: &str = "\n[time]\nstep = \"0.1 s\"\nduration = \"2 h\"\n";
/// A body far away, as a scenario needs a body.
const PROBE: &str = "\n[body.probe]\noutline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]\nmass = 1000\n\
                     gyradius = 1\nposition = [900000, 900000]\n\n";

/// The text of a scenario, with a note if the ship begins far off the berth.
fn noted(text: String, off_m: f64) -> String {
    if off_m <= NEAR_M {
        return text;
    }
    format!(
        "# The ship begins {off_m} m off: nearer to the berth the chart has too little water for the ships that were tried.\n{text}"
    )
}

fn has(class: &ChartClass, word: &str) -> bool {
    class.class == word && class.read > 0
}

/// An angle of the chart's table in radians: a number, or a text in degrees.
fn in_rad(item: &Item) -> Option<f64> {
    if let Some(text) = item.as_str() {
        let degrees: f64 = text.strip_suffix("deg")?.trim().parse().ok()?;
        return Some(degrees.to_radians());
    }
    item.as_float().or_else(|| item.as_integer().map(|whole| whole as f64))
}

/// The tables of fenders and bollards.
fn berth(quay_line: &str) -> String {
    let mut text = text::FACING.to_owned();
    let _ = write!(
        text,
        "\n[fender_row.f]\non = \"shore\"\nquay_line = {quay_line}\nspacing = \"{SPACING_M} m\"\nwidth = \"1.5 m\"\n\
         projection = \"1.2 m\"\ntype = \"cone\"\nheight = \"1 m\"\nrated_reaction = \"500 kN\"\nmaterial = \"facing\"\n\
         \n# The height of the bollards is above chart datum.\n[bollard_row.b]\non = \"shore\"\nquay_line = {quay_line}\n\
         spacing = \"15 m\"\nheight = \"3 m\"\n"
    );
    text
}
