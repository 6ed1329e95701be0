//! Wind, current and water of a run.

use fenderline_contact::Vec2;
use fenderline_contact::number::greater;
use fenderline_ship::constants::{AIR_KGPM3, SEA_WATER_KGPM3};

use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::waves::Sea;
use fenderline_ship::environment::wind::Wind;
use fenderline_ship::environment::{Bank, EnvironmentError, LongWaves, Tide};
use fenderline_ship::hydro::{self, Squat};
use fenderline_ship::range::within;

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
    /// Level of the water above datum.
    pub tide: Tide,
    /// Method of squat in water of finite depth; `None` for no squat.
    pub squat: Option<Squat>,
    /// Banks, which attract ships. The model of banks is not validated.
    pub banks: Vec<Bank>,
    /// Visibility (m), for the pages of live sessions; `None` for clear weather. The visibility has no effect on
    /// forces.
    pub visibility_m: Option<f64>,
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
            tide: Tide::default(),
            squat: Some(Squat::default()),
            banks: Vec::new(),
            visibility_m: None,
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

    /// Depth of the water at a time (m) with tide and long waves, 0 if the bottom is dry; `None` for deep water.
    #[must_use]
    pub fn depth_at_m(&self, t_s: f64) -> Option<f64> {
        self.depth_m.map(|depth_m| greater(depth_m + self.level_m(t_s), 0.0))
    }

    /// Depth of the water at a time (m) with the tide alone, for hull forces and added mass; `None` for deep water.
    #[must_use]
    pub fn still_depth_at_m(&self, t_s: f64) -> Option<f64> {
        self.depth_m.map(|depth_m| greater(depth_m + self.tide.level_m(t_s), 0.0))
    }

    /// The least and the greatest depth of a run (m); `None` for deep water.
    #[must_use]
    pub fn depth_range_m(&self) -> Option<[f64; 2]> {
        self.depth_m
            .map(|depth_m| self.level_range_m().map(|level_m| greater(depth_m + level_m, 0.0)))
    }

    /// Checks depth and tide. The constructors of wind, current, sea and long waves check the other numbers.
    ///
    /// # Errors
    /// Returns a number that is out of range, with the name of the number.
    pub fn check(&self) -> Result<(), EnvironmentError> {
        if let Some(depth_m) = self.depth_m {
            within("depth of the water [m]", depth_m, -100.0, 12_000.0)?;
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
        (t_s, step_s): (f64, f64),
        draught_m: f64,
    ) -> Vec2 {
        let now = self.current(position_m, t_s, draught_m);
        let then = self.current(position_m + now * step_s, t_s + step_s, draught_m);
        (then - now) * (1.0 / step_s)
    }
}
