//! Makes a new exercise from a user's choices: a straight berth or that of another scenario, a ship, tugs and weather,
//! as the text of a scenario file. The editor in the browser makes exercises in this way; each is an ordinary file to
//! run, serve and change by hand.

mod at_berth;
pub(crate) mod text;

pub use at_berth::{BerthSource, berth_words, fixed_berth};

use core::fmt;

use serde::{Deserialize, Serialize};

use fenderline_scenario::FenderLibrary;
use fenderline_scenario::Scenario;
use fenderline_scenario::{VesselData, VesselLibrary};

/// Most tugs, fenders and bollards that an exercise is made with.
const MOST_TUGS: usize = 4;
/// The names that the tugs of an exercise have.
const TUG_NAMES: [&str; MOST_TUGS] = ["tug_1", "tug_2", "tug_3", "tug_4"];
const MOST_FENDERS: usize = 60;
const MOST_BOLLARDS: usize = 60;

/// The choices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct NewExercise {
    /// Title of the scenario.
    pub title: String,
    /// The straight berth, which is not used if `berth_of` names another scenario.
    pub berth: NewBerth,
    /// File name of the scenario whose berth is taken, for [`NewExercise::text_at`].
    #[serde(default)]
    pub berth_of: Option<String>,
    /// The ship.
    pub ship: NewShip,
    /// The tugs.
    pub tugs: NewTugs,
    /// The weather.
    pub weather: NewWeather,
}

/// A straight quay with a row of equal fenders. The quay's face runs north, with the water to the west.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct NewBerth {
    /// Length of the quay (m).
    pub length_m: f64,
    /// Depth of the water (m).
    pub depth_m: f64,
    /// Family of the fenders in the library.
    pub fender: String,
    /// Size of the fenders in the library; if `None`, height and reaction are given.
    pub size: Option<String>,
    /// Height of a fender (m), where no size is given.
    pub height_m: Option<f64>,
    /// Rated reaction of a fender (N), where no size is given.
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
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct NewShip {
    /// Name in the library.
    pub vessel: String,
    /// The side of the ship that is to lie at the berth.
    pub side: BerthingSide,
    /// Distance from the ship's side to the face of the quay at the start (m).
    pub off_m: f64,
    /// Distance of the ship at the start, astern of the middle of the berth (m).
    pub astern_m: f64,
    /// Speed ahead of the ship at the start (m/s).
    pub speed_mps: f64,
}

/// Sides of a ship.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum BerthingSide {
    /// Port side to the quay: the ship comes from the north.
    Port,
    /// Starboard side to the quay: the ship comes from the south.
    Starboard,
}

/// Equal tugs of the library, each on a line at the ship's side towards the water.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct NewTugs {
    /// Name in the library.
    pub vessel: String,
    /// How many.
    pub number: usize,
}

/// Wind, current and visibility.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct NewWeather {
    /// Speed of the wind (m/s).
    pub wind_mps: f64,
    /// Direction from which the wind comes (rad).
    pub wind_from_rad: f64,
    /// Whether the wind has gusts.
    pub gusts: bool,
    /// Speed of the current (m/s).
    pub current_mps: f64,
    /// Direction to which the current runs (rad).
    pub current_to_rad: f64,
    /// Visibility (m); `None`: clear.
    pub visibility_m: Option<f64>,
}

/// Says why the user's choices make no exercise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewExerciseError(String);

impl fmt::Display for NewExerciseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for NewExerciseError {}

/// Whether a vessel of the library can be the ship of a new exercise: a vessel of full size that is no tug.
#[must_use]
pub fn can_be_ship(vessel: &VesselData) -> bool {
    !vessel.is_model && !can_be_tug(vessel)
}

/// Whether a vessel of the library can be a tug of a new exercise: a vessel with azimuth units and a fender at her bow.
#[must_use]
pub fn can_be_tug(vessel: &VesselData) -> bool {
    !vessel.azimuths.is_empty() && vessel.beltings.iter().any(|belting| belting.name == "bow")
}

fn within(what: &str, value: f64, [low, high]: [f64; 2]) -> Result<(), NewExerciseError> {
    if value >= low && value <= high {
        return Ok(());
    }
    Err(NewExerciseError(format!("{what}: {value} is not between {low} and {high}")))
}

impl NewExercise {
    /// Looks up the ship and the tug of the exercise in the library of vessels.
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
            return Err(NewExerciseError(format!(
                "{number} tugs are more than the {MOST_TUGS} that an exercise \
                                                 can have"
            )));
        }
        Ok(())
    }

    /// Writes the text of the exercise's scenario file. The written text has been read again as a scenario, and is a
    /// good one.
    ///
    /// # Errors
    /// Fails for a vessel or fender that is not in the library, a number that makes no berth, or the first mistake of
    /// the scenario.
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
                return refused(format!(
                    "{number} {what} are more than the {most} that a berth can have"
                ));
            }
        }
        if fenders == 0 {
            return refused("a berth needs at least one fender".to_owned());
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
