//! Reads wind, waves, water and banks.

use std::f64::consts::PI;

use fenderline_contact::{Rotation, Vec2, vec2};
use fenderline_sim::Environment;
use fenderline_sim::environment::waves::{Jonswap, Realisation, RegularWave, Sea};
use fenderline_sim::environment::wind::{
    GustSpectrum, Gusts, MeanWind, Wind, WindProfile, WindSeries,
};
use fenderline_sim::environment::{Bank, BankMethod, EnvironmentError, Tide, TideConstituent};
use fenderline_sim::hydro::Squat;
use fenderline_sim::hydro::shallow::{PUBLISHED_RATIO, SHALLOWEST_RATIO};

use super::assembly::{Assembly, Checked};
use super::bottom::{Charted, depth_for_waves_m};
use super::vessel::Kinds;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::csv::Csv;
use fenderline_keys::error::{Notice, ScenarioError};
use fenderline_keys::held::{Number, TableOf, Text};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::environment::{
    BankKey, ConstituentKey, EnvironmentKey, TideKey, WavesKey, WindKey,
};
use fenderline_keys::typed_key::AnyKey;

/// Number of harmonics from which a sea or a gusty wind is built.
const HARMONICS: usize = 200;
/// A depth that counts as deep water for every wave (m).
const DEEP_M: f64 = 10_000.0;
/// Bounds of the times in a file of wind, current, tide or waves (s).
pub(super) const TIMES_S: [f64; 2] = [-1e9, 1e9];
/// Bounds of the directions in a file of wind or current (deg).
pub(super) const DIRECTIONS_DEG: [f64; 2] = [-720.0, 720.0];

impl Assembly<'_, '_> {
    pub(super) fn environment(
        &mut self,
        table: Of<'_, EnvironmentKey>,
        duration_s: f64,
        charted: &Charted,
    ) -> Checked<Environment> {
        let depth_m = table.item(EnvironmentKey::DEPTH).map(|item| *item.number());
        let bottom = self.bottom(table, charted)?;
        let tide = match table.item(EnvironmentKey::TIDE) {
            None => Tide::default(),
            Some(item) => self.tide(item)?,
        };
        let level_m = tide.level_m(0.0);
        let of_bottom_m = bottom.as_ref().map(|bottom| depth_for_waves_m(bottom, level_m));
        for &key in any_keys![EnvironmentKey: WAVES, LONG_WAVES] {
            if let (Some(item), Some(depth_m)) = (table.item(key), of_bottom_m) {
                let text = format!(
                    "waves do not follow the depth at each place: they have the length of waves in the median depth of the bottom, {depth_m:.1} m below \
                     datum"
                );
                self.note_at(&item.key_span, table.path_to(item), text);
            }
        }
        let start_m = depth_m.or(of_bottom_m).map(|depth_m: f64| depth_m + level_m);
        let wind = match table.item(EnvironmentKey::WIND) {
            None => None,
            Some(item) => Some(self.wind(table, item)?),
        };
        let current = match table.item(EnvironmentKey::CURRENT) {
            None => None,
            Some(item) => Some(self.current(table, item)?),
        };
        let sea = match table.item(EnvironmentKey::WAVES) {
            None => None,
            Some(item) => {
                let waves = item.table();
                if *waves.given(WavesKey::REGULAR).flag() {
                    self.none_of(waves, any_keys![WavesKey: SPREADING], "regular")?;
                }
                let sea = sea(waves, start_m.unwrap_or(DEEP_M));
                Some(sea.map_err(|error| self.refused(table, item, &error))?)
            }
        };
        let long_waves = match table.item(EnvironmentKey::LONG_WAVES) {
            None => None,
            Some(item) => {
                Some(self.long_waves((table, item), start_m, sea.as_ref(), duration_s)?)
            }
        };
        let environment = Environment {
            wind,
            current,
            sea,
            long_waves,
            depth_m,
            bottom,
            tide,
            squat: self.squat(table)?,
            banks: self.banks(table)?,
            visibility_m: table.item(EnvironmentKey::VISIBILITY).map(|item| *item.number()),
            daylight: self.daylight(table, charted)?,
            rain: table.item(EnvironmentKey::RAIN).map(|item| item.choice()),
            water_density_kgpm3: *table.given(EnvironmentKey::WATER_DENSITY).number(),
            air_density_kgpm3: *table.given(EnvironmentKey::AIR_DENSITY).number(),
        };
        if environment.depth_range_m().is_some_and(|[_, most_m]| most_m <= 0.0) {
            let message = "the bottom is above the water throughout the run";
            return Err(match table.item(EnvironmentKey::DEPTH) {
                Some(item) => self.refused(table, item, &message),
                None => self.refused(table, table.given(EnvironmentKey::BOTTOM), &message),
            });
        }
        Ok(environment)
    }

    pub(super) fn wind<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, TableOf<WindKey>>,
    ) -> Checked<Wind> {
        let of = item.table();
        let Some(file) = of.item(WindKey::FILE) else {
            self.all_of(
                of,
                any_keys![WindKey: SPEED, FROM],
                "a wind needs a `speed` and a `from`, or a `file`",
            )?;
            return wind(of).map_err(|error| self.refused(table, item, &error));
        };
        self.none_of(of, any_keys![WindKey: SPEED, FROM, GUSTS, GUST_ADMITTANCE, SEED], "file")?;
        let key = of.path_of(WindKey::FILE);
        let (csv, [time, speed, from]) =
            self.csv_of(file, &key, ["t_s", "speed_mps", "from_deg"])?;
        let points = csv.grid(&[time])?.rows.into_iter().map(|row| {
            Ok([
                csv.number(row, time, TIMES_S)?,
                csv.number(row, speed, [0.0, 120.0])?,
                csv.number(row, from, DIRECTIONS_DEG)?.to_radians(),
            ])
        });
        let series = WindSeries::new(points.collect::<Checked<_>>()?);
        Ok(Wind::series(series.map_err(|error| self.refused(of, file, &error))?))
    }

    fn tide(&self, item: Entry<'_, TableOf<TideKey>>) -> Checked<Tide> {
        let of = item.table();
        let constituents = of.given(TideKey::CONSTITUENT).list();
        let Some(file) = of.item(TideKey::FILE) else {
            self.all_of(of, any_keys![TideKey: LEVEL], "a tide needs a `level` or a `file`")?;
            let mean_m = *of.given(TideKey::LEVEL).number();
            let constituents: Vec<TideConstituent> = constituents
                .iter()
                .map(|of| TideConstituent {
                    amplitude_m: *of.given(ConstituentKey::AMPLITUDE).number(),
                    period_s: *of.given(ConstituentKey::PERIOD).number(),
                    lag_rad: *of.given(ConstituentKey::LAG).number(),
                })
                .collect();
            return Ok(match constituents.is_empty() {
                true => Tide::Level(mean_m),
                false => Tide::Harmonic { mean_m, constituents },
            });
        };
        self.none_of(of, any_keys![TideKey: LEVEL], "file")?;
        if !constituents.is_empty() {
            return Err(self.not_together(of, of.given(TideKey::CONSTITUENT), "file"));
        }
        let key = of.path_of(TideKey::FILE);
        let (csv, [time, level]) = self.csv_of(file, &key, ["t_s", "level_m"])?;
        let points = csv.grid(&[time])?.rows.into_iter().map(|row| {
            Ok([csv.number(row, time, TIMES_S)?, csv.number(row, level, [-30.0, 30.0])?])
        });
        let tide = Tide::Curve(points.collect::<Checked<_>>()?);
        tide.check().map_err(|error| self.refused(of, file, &error))?;
        Ok(tide)
    }

    /// Reads a file that must have all the columns `columns` and no others, and returns the index of each column.
    pub(super) fn csv_of<'c, const N: usize>(
        &'c self,
        file: Entry<'c, Text>,
        key: &'c str,
        columns: [&str; N],
    ) -> Checked<(Csv<'c>, [usize; N])> {
        let csv = Csv::parse(self.files.text(file.text()), file.text(), key, &columns)?;
        let mut indices = [0; N];
        for (index, name) in indices.iter_mut().zip(columns) {
            *index = csv.column(name)?;
        }
        Ok((csv, indices))
    }

    fn squat(&self, table: Of<'_, EnvironmentKey>) -> Checked<Option<Squat>> {
        let Some(item) = table.item(EnvironmentKey::SQUAT) else {
            return Ok(Some(Squat::default()));
        };
        if table.first_of(any_keys![EnvironmentKey: DEPTH, BOTTOM]).is_none() {
            let path = table.path_of(EnvironmentKey::SQUAT);
            let message = format!(
                "`{path}` needs a `depth` or a `bottom` in the same table: in deep water there is no squat"
            );
            return Err(self.sources.error(&item.key_span, &path, message));
        }
        Ok(item.choice())
    }

    fn banks(&self, table: Of<'_, EnvironmentKey>) -> Checked<Vec<Bank>> {
        let banks = table.given(EnvironmentKey::BANK).list().iter();
        let bank = |of: Of<'_, BankKey>| {
            let [from_m, to_m] = [BankKey::FROM, BankKey::TO].map(|end| *of.given(end).vector());
            let bank = Bank::new(from_m, to_m, of.given(BankKey::METHOD).choice());
            bank.map_err(|error| self.refused(of, of.given(BankKey::TO), &error))
        };
        banks.map(bank).collect()
    }

    /// Adds warnings if a part of the environment is unvalidated, or if a formula is used outside its range.
    pub(super) fn note_unvalidated(
        &mut self,
        file: Of<'_, ScenarioKey>,
        environment: &Environment,
        kinds: &Kinds,
    ) {
        let surroundings = file.given(ScenarioKey::ENVIRONMENT).table();
        let mut banks =
            surroundings.given(EnvironmentKey::BANK).list().iter().zip(&environment.banks);
        if let Some((first, _)) = banks.find(|(_, bank)| bank.method() == BankMethod::Norrbin) {
            self.note(
                first,
                "bank suction is UNVALIDATED: Norrbin's formulas are from memory, because we could \
                 not read a source",
            );
        }
        // Over a bottom by place the verdict names the depths that a vessel meets.
        if let Some(bottom) = &environment.bottom {
            if let (Some(BankMethod::Norrbin), Some(item), false) =
                (bottom.banks, surroundings.item(EnvironmentKey::BOTTOM), kinds.all.is_empty())
            {
                self.note(
                    item.table(),
                    "bank suction is UNVALIDATED: Norrbin's formulas are from memory, and the vertical walls that stand \
                     for the sections of the bottom are our assumption; `banks = \"none\"` leaves out the force of banks",
                );
            }
            return;
        }
        let Some([shallowest_m, deepest_m]) = environment.depth_range_m() else { return };
        for (name, kind) in &kinds.all {
            let draught_m = kind.setup.ship.particulars.draught_m;
            let [least, most] = [shallowest_m / draught_m, deepest_m / draught_m];
            let mut notify = |message: String| {
                let (span, key) = &kind.place;
                let place = self.sources.place(span);
                self.notices.push(Notice { place, key: key.clone(), message });
            };
            if least < SHALLOWEST_RATIO {
                notify(format!(
                    "{name} in water of {least:.2} draughts: no shallow-water formula covers less \
                     than {SHALLOWEST_RATIO} draughts; in shallower water added mass, hull forces \
                     and squat keep their values at {SHALLOWEST_RATIO} draughts, and only the drag \
                     of a flow across the ship grows further"
                ));
            } else if least < PUBLISHED_RATIO {
                notify(format!(
                    "{name} in water of {least:.2} draughts: shallow-water corrections are valid \
                     from {PUBLISHED_RATIO} draughts on; in shallower water the program \
                     extrapolates them linearly"
                ));
            }
            if let Some((squat, [_, high])) =
                environment.squat.and_then(|squat| Some((squat, squat.depth_ratios()?)))
                && most > high
            {
                notify(format!(
                    "squat of {name} by {}: the formula covers depths of up to {high} draughts, \
                     but the depth here is {most:.2}",
                    squat.name()
                ));
            }
            let [at_start, at_low] = [kind.setup.ship.added_mass, kind.low_water_mass];
            if at_low.sway_m3 > 1.05 * at_start.sway_m3 {
                notify(format!(
                    "the tide falls under {name}: the added mass keeps its value at the start; at \
                     low water the sway added mass would be {:.2} times as large",
                    at_low.sway_m3 / at_start.sway_m3
                ));
            }
        }
    }

    /// Refuses a table that lacks one of several keys that belong together.
    pub(super) fn all_of<T>(&self, of: Of<'_, T>, keys: &[AnyKey<T>], help: &str) -> Checked<()> {
        match keys.iter().find(|key| of.item(**key).is_none()) {
            None => Ok(()),
            Some(key) => {
                let path = of.path_of(*key);
                let error = self.sources.error(&of.span, &path, format!("`{path}` is missing"));
                Err(error.with_help(help))
            }
        }
    }

    /// Refuses keys that would have no effect because the table also has the key `beside`.
    pub(super) fn none_of<T>(
        &self,
        of: Of<'_, T>,
        keys: &[AnyKey<T>],
        beside: &str,
    ) -> Checked<()> {
        match keys.iter().find_map(|key| of.item(*key)) {
            None => Ok(()),
            Some(item) => Err(self.not_together(of, item, beside)),
        }
    }

    pub(super) fn not_together<T, V>(
        &self,
        of: Of<'_, T>,
        item: Entry<'_, V>,
        beside: &str,
    ) -> ScenarioError {
        let path = of.path_to(item);
        let message = format!("`{path}` does not go together with `{beside}`");
        self.sources.error(&item.key_span, &path, message)
    }
}

fn wind(table: Of<'_, WindKey>) -> Result<Wind, EnvironmentError> {
    let mean = MeanWind {
        speed_mps: *table.given(WindKey::SPEED).number(),
        from_rad: *table.given(WindKey::FROM).number(),
        profile: WindProfile::Uniform,
    };
    if !table.item(WindKey::GUSTS).is_some_and(|item| *item.flag()) {
        return Wind::steady(mean);
    }
    let gusts = Gusts::new(&mean, &GustSpectrum::Npd, realisation(table.item(WindKey::SEED)))?;
    let is_averaged = table.item(WindKey::GUST_ADMITTANCE).is_none_or(|item| *item.flag());
    Wind::with_gusts(mean, if is_averaged { gusts } else { gusts.uniform() })
}

fn sea(table: Of<'_, WavesKey>, depth_m: f64) -> Result<Sea, EnvironmentError> {
    let (height_m, period_s) =
        (*table.given(WavesKey::HEIGHT).number(), *table.given(WavesKey::PERIOD).number());
    let towards_rad = table.given(WavesKey::FROM).number() + PI;
    if *table.given(WavesKey::REGULAR).flag() {
        let wave = RegularWave { height_m, period_s, phase_rad: 0.0 };
        return Sea::regular(wave, towards_rad, depth_m);
    }
    let spectrum = Jonswap {
        height_m,
        peak_period_s: period_s,
        peak_enhancement: *table.given(WavesKey::PEAKEDNESS).number(),
    };
    let sea =
        Sea::jonswap(&spectrum, towards_rad, depth_m, realisation(table.item(WavesKey::SEED)))?;
    match table.item(WavesKey::SPREADING) {
        None => Ok(sea),
        Some(item) => sea.short_crested(*item.number()),
    }
}

fn realisation(seed: Option<Entry<'_, Number>>) -> Realisation {
    let seed = seed.map_or(1.0, |item| *item.number());
    Realisation { harmonics: HARMONICS, seed: seed as u64 }
}

/// The unit vector of a compass direction.
pub(super) fn along(direction_rad: f64) -> Vec2 {
    Rotation::from_angle(direction_rad).apply(vec2(1.0, 0.0))
}
