//! Wind, current and water of a run.

use std::fmt;
use std::sync::Arc;

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{DisplayNumber, Vec2, vec2};
use fenderline_ship::constants::{AIR_KGPM3, SEA_WATER_KGPM3};

use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::waves::Sea;
use fenderline_ship::environment::wind::Wind;
use fenderline_ship::environment::{
    Bank, BankMethod, DepthField, EnvironmentError, LongWaves, Tide,
};
use fenderline_ship::hydro::{self, Squat};
use fenderline_ship::range::within;
use fenderline_ship::step_time::StepTime;

use crate::looks::{Daylight, Rain};

/// A place at which no depth is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoDepth {
    /// The place, north and east (m).
    pub place_m: Vec2,
}

impl fmt::Display for NoDepth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [north, east] = [self.place_m.x, self.place_m.y].map(DisplayNumber);
        write!(f, "no depth is known at {north} m north, {east} m east")
    }
}

impl std::error::Error for NoDepth {}

/// Number of strips into which each half of a cross-section of the water is divided, from the middle to a side.
const STRIPS: u32 = 64;

/// The depth of the sea bottom at each place.
#[derive(Clone, Debug, PartialEq)]
pub struct Bottom {
    /// Depths below datum. Clones of a set-up share the field.
    pub field: Arc<DepthField>,
    /// The depth that is used where the field has no data, or an error there.
    pub outside: Outside,
    /// Method for the force of the banks that the field has: [`Walls`](super::Walls); `None`: no force.
    pub banks: Option<BankMethod>,
}

/// What the program does where a [`DepthField`] has no data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outside {
    /// It takes the bottom to be level, at this depth below datum (m).
    Depth(f64),
    /// It ends the run with an error if a ship comes to such a place.
    Error,
}

impl Bottom {
    /// Depth below datum (m) and gradient of the depth at a place; `None` if no depth is known at the place.
    #[must_use]
    pub fn sounding(&self, place_m: Vec2) -> Option<(f64, Vec2)> {
        self.field.sounding(place_m).or(match self.outside {
            Outside::Depth(depth_m) => Some((depth_m, Vec2::ZERO)),
            Outside::Error => None,
        })
    }

    /// Depth below datum at a place (m); `None` if no depth is known at the place.
    #[must_use]
    pub fn depth_m(&self, place_m: Vec2) -> Option<f64> {
        self.field.depth_m(place_m).or(match self.outside {
            Outside::Depth(depth_m) => Some(depth_m),
            Outside::Error => None,
        })
    }

    /// Describes the depths in words: numbers of nodes, size of a cell, least and greatest depth, and what the program
    /// does where there are no data.
    #[must_use]
    pub fn in_words(&self) -> String {
        let field = &self.field;
        let ([north, east], [least_m, most_m]) = (field.nodes(), field.range_m());
        let holes = field.depths_m().iter().filter(|depth_m| depth_m.is_nan()).count();
        let share = 100.0 * holes as f64 / field.depths_m().len() as f64;
        let outside = match self.outside {
            Outside::Depth(depth_m) => format!("{depth_m} m where there is no data"),
            Outside::Error => "an error where there is no data".to_owned(),
        };
        let banks = match self.banks {
            None => "no force of banks",
            Some(BankMethod::Norrbin) => "banks by Norrbin's formulas (unvalidated)",
            Some(BankMethod::Image) => "banks by the image of a vessel",
        };
        format!(
            "bottom: {north} by {east} nodes to the north and east, cells of {} m; {least_m:.1} to {most_m:.1} m below datum; \
             {share:.1} % of the nodes without data; {outside}; {banks}",
            field.cell_m()
        )
    }

    /// Cross-section of the water at a level above datum (m²). It extends from a place to both sides, at right angles
    /// to a heading (a unit vector). Each side ends at `half_width_m`, or before that where the bottom is dry or has no
    /// data.
    #[must_use]
    pub fn section_m2(&self, place_m: Vec2, ahead: Vec2, level_m: f64, half_width_m: f64) -> f64 {
        let wet_m = |at_m: Vec2| self.depth_m(at_m).map_or(0.0, |depth_m| depth_m + level_m);
        let middle_m = wet_m(place_m);
        let strip_m = half_width_m / f64::from(STRIPS);
        [1.0, -1.0].into_iter().fold(0.0, |sum_m2, side| {
            let out = vec2(-ahead.y, ahead.x) * (side * strip_m);
            let (mut sum_m2, mut last_m) = (sum_m2, middle_m);
            for strip in 1..=STRIPS {
                let next_m = wet_m(place_m + out * f64::from(strip));
                if last_m <= 0.0 {
                    break;
                }
                // Within a strip that falls dry, the wet part is a triangle.
                sum_m2 += match next_m > 0.0 {
                    true => 0.5 * strip_m * (last_m + next_m),
                    false => 0.5 * strip_m * last_m * last_m / (last_m - next_m),
                };
                last_m = next_m;
            }
            sum_m2
        })
    }

    /// The least and the greatest depth below datum (m), the depth that is used where there are no data included.
    #[must_use]
    pub fn range_m(&self) -> [f64; 2] {
        let [least_m, most_m] = self.field.range_m();
        match self.outside {
            Outside::Depth(depth_m) => [lesser(least_m, depth_m), greater(most_m, depth_m)],
            Outside::Error => [least_m, most_m],
        }
    }
}

/// Wind, current and water of a [`crate::world::WorldSetup`].
#[derive(Clone, Debug, PartialEq)]
pub struct Environment {
    /// Wind.
    pub wind: Option<Wind>,
    /// Current.
    pub current: Option<Current>,
    /// Waves.
    pub sea: Option<Sea>,
    /// Long waves: their level adds to the level of the tide, and their velocity adds to the current.
    pub long_waves: Option<LongWaves>,
    /// Density of the water (kg/m³).
    pub water_density_kgpm3: f64,
    /// Density of the air (kg/m³).
    pub air_density_kgpm3: f64,
    /// Depth of the water below datum (m), negative if the bottom falls dry; `None` for deep water.
    pub depth_m: Option<f64>,
    /// Depth of the water that differs by place; `depth_m` is then `None`.
    pub bottom: Option<Bottom>,
    /// Level of the water above datum.
    pub tide: Tide,
    /// Formula for the squat of ships in water of finite depth; `None` for no squat.
    pub squat: Option<Squat>,
    /// Banks, which attract ships. The model of banks is not validated.
    pub banks: Vec<Bank>,
    /// Visibility (m), for the pages of live sessions; `None` for clear weather. The visibility has no effect on
    /// forces.
    pub visibility_m: Option<f64>,
    /// Where and when the run begins, for the sun in the pages' view; `None`: the view takes the sun from the page's
    /// palette. No force depends on the daylight.
    pub daylight: Option<Daylight>,
    /// Rain in the pages' view; `None`: no rain. No force depends on the rain.
    pub rain: Option<Rain>,
}

impl Default for Environment {
    /// Deep sea water, with no wind, current or banks. If a depth is then set, [`Squat::default`] gives the squat.
    fn default() -> Environment {
        Environment {
            wind: None,
            current: None,
            sea: None,
            long_waves: None,
            water_density_kgpm3: SEA_WATER_KGPM3,
            air_density_kgpm3: AIR_KGPM3,
            depth_m: None,
            bottom: None,
            tide: Tide::default(),
            squat: Some(Squat::default()),
            banks: Vec::new(),
            visibility_m: None,
            daylight: None,
            rain: None,
        }
    }
}

impl Environment {
    /// Level of the water above datum at a time (m), with tide and long waves.
    #[must_use]
    pub fn level_m(&self, t_s: f64) -> f64 {
        let tide_m = self.tide.level_m(t_s);
        self.long_waves.as_ref().map_or(tide_m, |waves| tide_m + waves.level_m(t_s))
    }

    /// Bounds of the level of the water from the start of the run (m): the bounds of the tide ([`Tide::range_m`]) plus
    /// the bounds of the long waves ([`LongWaves::range_m`]).
    #[must_use]
    pub fn level_range_m(&self) -> [f64; 2] {
        let [low_m, high_m] = self.tide.range_m();
        let waves_m = self.long_waves.as_ref().map_or([0.0; 2], LongWaves::range_m);
        [low_m + waves_m[0], high_m + waves_m[1]]
    }

    /// Depth of the water at a place and a time (m) with tide and long waves, 0 if the bottom is dry; `None` for deep
    /// water.
    ///
    /// # Errors
    /// Fails if no depth is known at the place.
    pub fn depth_at_m(&self, place_m: Vec2, t_s: f64) -> Result<Option<f64>, NoDepth> {
        let below_datum_m = match &self.bottom {
            Some(bottom) => Some(bottom.depth_m(place_m).ok_or(NoDepth { place_m })?),
            None => self.depth_m,
        };
        Ok(below_datum_m.map(|depth_m| greater(depth_m + self.level_m(t_s), 0.0)))
    }

    /// The least and the greatest depth of the water in a run (m), over all places; `None` for deep water.
    #[must_use]
    pub fn depth_range_m(&self) -> Option<[f64; 2]> {
        let one = self.depth_m.map(|depth_m| [depth_m; 2]);
        let [least_m, most_m] = self.bottom.as_ref().map(Bottom::range_m).or(one)?;
        let [low_m, high_m] = self.level_range_m();
        Some([least_m + low_m, most_m + high_m].map(|depth_m| greater(depth_m, 0.0)))
    }

    /// Whether the water is deep everywhere: neither one depth for all places nor a depth by place is given.
    #[must_use]
    pub fn is_deep(&self) -> bool {
        self.depth_m.is_none() && self.bottom.is_none()
    }

    /// Checks depth, bottom and tide; wind, current, sea and long waves are checked when they are made.
    ///
    /// # Errors
    /// Fails for a number out of range, which the error names, or if both one depth for all places and a depth by place
    /// are given.
    pub fn check(&self) -> Result<(), EnvironmentError> {
        if let Some(depth_m) = self.depth_m {
            within("depth of the water [m]", depth_m, -100.0, 12_000.0)?;
        }
        if let Some(bottom) = &self.bottom {
            if let Outside::Depth(depth_m) = bottom.outside {
                within(
                    "depth of the water outside the depth field [m]",
                    depth_m,
                    -100.0,
                    12_000.0,
                )?;
            }
            if self.depth_m.is_some() {
                return Err(EnvironmentError::TwoDepths);
            }
        }
        self.tide.check()
    }

    /// The water.
    pub fn density(&self) -> hydro::Water {
        hydro::Water { density_kgpm3: self.water_density_kgpm3 }
    }

    /// Mean velocity of the water over a ship's draught (m/s), with current and long waves.
    pub fn current(&self, position_m: Vec2, t_s: f64, draught_m: f64) -> Vec2 {
        let current = self.current.as_ref();
        let stream =
            current.map_or(Vec2::ZERO, |current| current.velocity(position_m, t_s, draught_m));
        self.long_waves.as_ref().map_or(stream, |waves| stream + waves.velocity(t_s))
    }

    /// Mean acceleration DU/Dt of the water around a hull during a step, for an observer who moves with the water
    /// (m/s²).
    pub fn water_acceleration(
        &self,
        position_m: Vec2,
        StepTime { t_s, step_s }: StepTime,
        draught_m: f64,
    ) -> Vec2 {
        let now = self.current(position_m, t_s, draught_m);
        let then = self.current(position_m + now * step_s, t_s + step_s, draught_m);
        (then - now) * (1.0 / step_s)
    }
}
