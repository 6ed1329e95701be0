//! A new exercise from choices: a straight berth or that of another scenario, a ship, tugs and weather, as
//! the text of a scenario file. The page's editor makes such an exercise: an ordinary file, to run, serve and
//! change by hand.

mod at_berth;
mod text;

pub use at_berth::{BerthSource, berth_words, fixed_berth};

use core::fmt;

use serde::{Deserialize, Serialize};

use fenderline_scenario::FenderLibrary;
use fenderline_scenario::Scenario;
use fenderline_scenario::{VesselData, VesselLibrary};

/// Most tugs, fenders and bollards that an exercise is made with.
const MOST_TUGS: usize = 4;
/// The names of the tugs.
const TUG_NAMES: [&str; MOST_TUGS] = ["tug_1", "tug_2", "tug_3", "tug_4"];
const MOST_FENDERS: usize = 60;
const MOST_BOLLARDS: usize = 60;

/// The choices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NewExercise {
    /// Title of the scenario.
    pub title: String,
    /// The straight berth, which is not used if `berth_of` is given.
    pub berth: NewBerth,
    /// The scenario whose berth is taken, by its file's name: for [`NewExercise::text_at`].
    #[serde(default)]
    pub berth_of: Option<String>,
    /// The ship.
    pub ship: NewShip,
    /// The tugs.
    pub tugs: NewTugs,
    /// The weather.
    pub weather: NewWeather,
}

/// A straight quay with a row of equal fenders. Its face runs north, with the water to the west.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NewBerth {
    /// Length of the quay (m).
    pub length_m: f64,
    /// Depth of the water (m).
    pub depth_m: f64,
    /// Family of the fenders in the library.
    pub fender: String,
    /// Size in the library; `None`: by height and reaction.
    pub size: Option<String>,
    /// Height of a fender (m), without a size.
    pub height_m: Option<f64>,
    /// Rated reaction of a fender (N), without a size.
    pub rated_reaction_n: Option<f64>,
    /// Number of fenders.
    pub fenders: usize,
    /// Distance between fenders (m).
    pub fender_spacing_m: f64,
    /// Distance between bollards (m).
    pub bollard_spacing_m: f64,
}

/// A ship of the library on her way to the berth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NewShip {
    /// Name in the library.
    pub vessel: String,
    /// The side of the ship towards the berth.
    pub side: BerthingSide,
    /// Distance from the ship's side to the face of the quay (m).
    pub off_m: f64,
    /// Distance of the start astern of the middle of the berth (m).
    pub astern_m: f64,
    /// Speed ahead of the ship (m/s).
    pub speed_mps: f64,
}

/// Sides of a ship.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BerthingSide {
    /// Port side to the quay: she comes from the north.
    Port,
    /// Starboard side to the quay: she comes from the south.
    Starboard,
}

/// Equal tugs of the library, each on a line at the side of the water.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NewTugs {
    /// Name in the library.
    pub vessel: String,
    /// How many.
    pub number: usize,
}

/// Wind, current and visibility.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NewWeather {
    /// Speed of the wind (m/s).
    pub wind_mps: f64,
    /// Where the wind comes from (rad).
    pub wind_from_rad: f64,
    /// Whether the wind has gusts.
    pub gusts: bool,
    /// Speed of the current (m/s).
    pub current_mps: f64,
    /// Where the current runs to (rad).
    pub current_to_rad: f64,
    /// Visibility (m); `None`: clear.
    pub visibility_m: Option<f64>,
}

/// Why choices make no exercise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewExerciseError(String);

impl fmt::Display for NewExerciseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for NewExerciseError {}

/// Whether a vessel of the library can be the ship of a new exercise: one of full size that people can steer.
#[must_use]
pub fn can_be_ship(vessel: &VesselData) -> bool {
    !vessel.is_model && !can_be_tug(vessel)
}

/// Whether a vessel of the library can be a tug of a new exercise: azimuth units, and a fender at her bow.
#[must_use]
pub fn can_be_tug(vessel: &VesselData) -> bool {
    !vessel.azimuths.is_empty() && vessel.beltings.iter().any(|belting| belting.name == "bow")
}

fn within(what: &str, value: f64, [low, high]: [f64; 2]) -> Result<(), NewExerciseError> {
    if value >= low && value <= high {
        return Ok(());
    }
    Err(NewExerciseError(format!("{what}: {value} is not within {low} and {high}")))
}

impl NewExercise {
    /// Ship and tug of the library.
    fn vessels(&self) -> Result<(&'static VesselData, &'static VesselData), NewExerciseError> {
        let vessels = VesselLibrary::of_program();
        let look_up =
            |name: &str| vessels.vessel(name).map_err(|error| NewExerciseError(error.to_string()));
        let (ship, tug) = (look_up(&self.ship.vessel)?, look_up(&self.tugs.vessel)?);
        if !can_be_ship(ship) {
            return Err(NewExerciseError(format!("{} is a model or a tug, not a ship", ship.name)));
        }
        if self.tugs.number > 0 && !can_be_tug(tug) {
            let why = format!("{} is no tug with azimuth units and a bow fender", tug.name);
            return Err(NewExerciseError(why));
        }
        Ok((ship, tug))
    }

    fn check_ship_and_tugs(&self) -> Result<(), NewExerciseError> {
        within("distance to the quay [m]", self.ship.off_m, [5.0, 2000.0])?;
        within("distance astern of the berth [m]", self.ship.astern_m, [0.0, 10_000.0])?;
        within("speed of the ship [m/s]", self.ship.speed_mps, [0.0, 10.0])?;
        if self.tugs.number > MOST_TUGS {
            let number = self.tugs.number;
            return Err(NewExerciseError(format!("{number} tugs are more than {MOST_TUGS}")));
        }
        Ok(())
    }

    /// The text of the scenario file. It was read and is good.
    ///
    /// # Errors
    /// A vessel or fender that is not in the library, a number that makes no berth, or the first mistake of the scenario.
    pub fn text(&self) -> Result<String, NewExerciseError> {
        let refused = |why: String| Err(NewExerciseError(why));
        let (ship, tug) = self.vessels()?;
        self.check_ship_and_tugs()?;
        let NewBerth { length_m, fender_spacing_m, bollard_spacing_m, fenders, .. } = self.berth;
        for (what, value, [low, high]) in [
            ("length of the quay [m]", length_m, [20.0, 2000.0]),
            ("distance of fenders [m]", fender_spacing_m, [1.0, 500.0]),
            ("distance of bollards [m]", bollard_spacing_m, [5.0, 500.0]),
        ] {
            within(what, value, [low, high])?;
        }
        for (what, number, most) in [
            ("fenders", fenders, MOST_FENDERS),
            ("bollards", text::bollards(&self.berth), MOST_BOLLARDS),
        ] {
            if number > most {
                return refused(format!("{number} {what} are more than {most}"));
            }
        }
        if fenders == 0 {
            return refused("a berth has at least one fender".to_owned());
        }
        let row_m = fender_spacing_m * (fenders - 1) as f64;
        if row_m > length_m {
            return refused(format!(
                "the row of fenders is {row_m} m long, longer than the quay of {length_m} m"
            ));
        }
        let family = FenderLibrary::of_program().family(&self.berth.fender);
        let family = family.map_err(|error| NewExerciseError(error.to_string()))?;
        let size = match &self.berth.size {
            None => None,
            Some(wanted) => {
                let size = family.sizes.iter().find(|size| size.designation == *wanted);
                Some(size.ok_or_else(|| {
                    NewExerciseError(format!("{} has no size {wanted:?}", family.name))
                })?)
            }
        };
        let text = text::compose(self, ship, tug, size).ok_or_else(|| {
            NewExerciseError("fenders without a size need height and rated reaction".to_owned())
        })?;
        match Scenario::parse(&text, "exercise.toml") {
            Ok(_) => Ok(text),
            Err(error) => refused(error.message().to_owned()),
        }
    }
}
