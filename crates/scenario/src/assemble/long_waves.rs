//! Reads long waves at a berth: a spectrum, a regular wave or a file.

use fenderline_contact::number::greater;
use fenderline_contact::vec2;
use fenderline_sim::Environment;
use fenderline_sim::environment::waves::{Realisation, RegularWave, Sea};
use fenderline_sim::environment::{LongWaveSite, LongWaveSpectrum, LongWaves};

use super::assembly::{Assembly, Checked};
use super::environment::TIMES_S;
use super::vessel::Kinds;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::{Number, TableOf, Text};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::environment::EnvironmentKey;
use fenderline_keys::keys::long_waves::LongWavesKey;
use fenderline_keys::printable::printable_number;
use fenderline_keys::typed_key::{AnyKey, Key};

/// Number of harmonics from which a spectrum of long waves is built.
const HARMONICS: usize = 40;
/// The keys of a spectrum that a regular wave does not have.
const OF_SPECTRUM: &[AnyKey<LongWavesKey>] =
    any_keys![LongWavesKey: SHORTEST_PERIOD, LONGEST_PERIOD, PEAKEDNESS, SEED];
/// The shortest period of a spectrum of long waves (s), if half of the peak period is less.
const SHORTEST_S: f64 = 25.0;
/// Bounds of the level (m) and the velocity (m/s) in a file of long waves.
const LEVELS_M: [f64; 2] = [-10.0, 10.0];
const VELOCITIES_MPS: [f64; 2] = [-15.0, 15.0];
/// A time step between two rows of a file counts as a gap if it is this many times as long as the usual step.
const GAP: f64 = 1.5;
/// A ship that is longer than this share of the wave length gets a warning. If a wave runs along a ship of this length,
/// the true force is 0.90 of the computed force, which is the mean of a cosine over a quarter of a wave length.
const LONG_SHIP: f64 = 0.25;

impl Assembly<'_, '_> {
    /// Reads the long waves of a table. `start_m` is the depth of the water at the start (m), `sea` the short waves,
    /// and `duration_s` the length of the run (s).
    pub(super) fn long_waves(
        &self,
        (table, item): (Of<'_, EnvironmentKey>, Entry<'_, TableOf<LongWavesKey>>),
        start_m: Option<f64>,
        sea: Option<&Sea>,
        duration_s: f64,
    ) -> Checked<LongWaves> {
        let of = item.table();
        if let Some(file) = of.item(LongWavesKey::FILE) {
            self.none_of(
                of,
                any_keys![LongWavesKey: HEIGHT, PERIOD, TOWARDS, WALL_DISTANCE],
                "file",
            )?;
            self.none_of(of, OF_SPECTRUM, "file")?;
            if *of.given(LongWavesKey::REGULAR).flag() {
                return Err(self.not_together(of, of.given(LongWavesKey::REGULAR), "file"));
            }
            return self.long_wave_file(of, file, duration_s);
        }
        let help = "long waves need a `height`, a `period` and a `towards`, or a `file`";
        self.all_of(of, any_keys![LongWavesKey: HEIGHT, PERIOD, TOWARDS], help)?;
        let Some(depth_m) = start_m else {
            let path = table.path_of(EnvironmentKey::LONG_WAVES);
            let message = format!(
                "`{path}` needs a `depth` in the same table, because the velocity of the water \
                 follows from the depth"
            );
            return Err(self.sources.error(&item.key_span, &path, message));
        };
        let number = |name: Key<_, Number>| of.item(name).map(|item| *item.number());
        let (height, period) = (of.given(LongWavesKey::HEIGHT), of.given(LongWavesKey::PERIOD));
        let (height_m, period_s) = (*height.number(), *period.number());
        let site = LongWaveSite {
            towards_rad: *of.given(LongWavesKey::TOWARDS).number(),
            depth_m,
            wall_m: number(LongWavesKey::WALL_DISTANCE),
        };
        site.check_height(height_m).map_err(|error| self.refused(of, height, &error))?;
        let is_regular = *of.given(LongWavesKey::REGULAR).flag();
        if is_regular {
            self.none_of(of, OF_SPECTRUM, "regular")?;
        }
        let shortest = of.item(LongWavesKey::SHORTEST_PERIOD).unwrap_or(period);
        let shortest_s = match (is_regular, of.item(LongWavesKey::SHORTEST_PERIOD)) {
            (true, _) => period_s,
            (false, Some(item)) => *item.number(),
            (false, None) => greater(0.5 * period_s, SHORTEST_S),
        };
        site.check_period(shortest_s).map_err(|error| {
            let help = format!(
                "a wave of {} s is {} m long in {} m of water; long waves have ten depths or more",
                printable_number(shortest_s),
                printable_number(site.length_m(shortest_s).round()),
                printable_number(depth_m)
            );
            self.refused(of, shortest, &error).with_help(help)
        })?;
        if let Some(of_sea_s) = sea.map(Sea::longest_period_s)
            && of_sea_s >= shortest_s
        {
            let path = of.path_to(shortest);
            let message = format!(
                "`{path}`: the shortest long wave, of {} s, is not longer than the longest wave of \
                 `environment.waves`, of {:.1} s: energy between the two periods would be counted \
                 twice",
                printable_number(shortest_s),
                of_sea_s
            );
            let error = self.sources.error(&shortest.span, &path, message);
            return Err(error.with_help("give a longer `shortest_period`"));
        }
        let refused = |error| self.refused(table, item, &error);
        if is_regular {
            let wave = RegularWave { height_m, period_s, phase_rad: 0.0 };
            return LongWaves::regular(wave, &site).map_err(refused);
        }
        let spectrum = LongWaveSpectrum {
            height_m,
            peak_period_s: period_s,
            periods_s: [shortest_s, number(LongWavesKey::LONGEST_PERIOD).unwrap_or(2.0 * period_s)],
            peak_enhancement: number(LongWavesKey::PEAKEDNESS).unwrap_or(3.3),
        };
        let seed = number(LongWavesKey::SEED).unwrap_or(1.0) as u64;
        let draw = Realisation { harmonics: HARMONICS, seed };
        LongWaves::of_spectrum(&spectrum, &site, draw).map_err(refused)
    }

    fn long_wave_file(
        &self,
        of: Of<'_, LongWavesKey>,
        file: Entry<'_, Text>,
        duration_s: f64,
    ) -> Checked<LongWaves> {
        let key = of.path_of(LongWavesKey::FILE);
        let columns = ["t_s", "level_m", "north_mps", "east_mps"];
        let (csv, [time, level, north, east]) = self.csv_of(file, &key, columns)?;
        let rows = (0..csv.row_count()).map(|row| {
            let velocity = vec2(
                csv.number(row, north, VELOCITIES_MPS)?,
                csv.number(row, east, VELOCITIES_MPS)?,
            );
            Ok((csv.number(row, time, TIMES_S)?, csv.number(row, level, LEVELS_M)?, velocity))
        });
        let rows = rows.collect::<Checked<Vec<_>>>()?;
        let mut steps_s: Vec<f64> = rows.windows(2).map(|two| two[1].0 - two[0].0).collect();
        if let Some(row) = steps_s.iter().position(|step_s| *step_s <= 0.0) {
            let message =
                "the time of this row is not later than the time of the row before".to_owned();
            return Err(csv.cell_error(row + 1, time, message));
        }
        let gaps_s = steps_s.clone();
        steps_s.sort_by(f64::total_cmp);
        let usual_s = steps_s.get(steps_s.len() / 2).copied().unwrap_or(0.0);
        if let Some(row) = gaps_s.iter().position(|step_s| *step_s > GAP * usual_s) {
            let message = format!(
                "there is a gap before this row: {} s, where {} s are usual",
                printable_number(gaps_s[row]),
                printable_number(usual_s)
            );
            let error = csv.cell_error(row + 1, time, message);
            return Err(
                error.with_help("interpolation over a gap would not be a wave: fill the gap")
            );
        }
        let (first_s, last_s) = (rows[0].0, rows[rows.len() - 1].0);
        if first_s > 0.0 || last_s < duration_s {
            let message = format!(
                "`{key}`: the file has the time from {} to {} s, the run covers 0 to {} s",
                printable_number(first_s),
                printable_number(last_s),
                printable_number(duration_s)
            );
            return Err(self.sources.error(&file.span, &key, message));
        }
        LongWaves::series(&rows).map_err(|error| self.refused(of, file, &error))
    }

    /// Warns of a ship that is too long for the long waves, or that touches the bottom in a trough.
    pub(super) fn note_long_waves(
        &mut self,
        file: Of<'_, ScenarioKey>,
        environment: &Environment,
        kinds: &Kinds,
    ) {
        let table = file.given(ScenarioKey::ENVIRONMENT).table();
        let (Some(item), Some(waves)) =
            (table.item(EnvironmentKey::LONG_WAVES), &environment.long_waves)
        else {
            return;
        };
        let of = item.table();
        let ships = kinds.all.iter().map(|(_, kind)| &kind.setup.ship.particulars);
        let [draught_m, longest_m] = ships.fold([0.0; 2], |[draught_m, longest_m], ship| {
            [greater(draught_m, ship.draught_m), greater(longest_m, ship.length_m)]
        });
        let [lowest_m, _] = environment.level_range_m();
        let [trough_m, _] = waves.range_m();
        if let Some(depth_m) = environment.depth_m
            && depth_m + lowest_m < draught_m
            && depth_m + lowest_m - trough_m >= draught_m
        {
            let message = format!(
                "in a trough of the long waves, {:.2} m below the level of the tide, the water is \
                 {:.2} m deep, but a vessel draws {:.2} m",
                -trough_m,
                depth_m + lowest_m,
                draught_m
            );
            self.note_at(&item.key_span, table.path_of(EnvironmentKey::LONG_WAVES), message);
        }
        let (Some(period), Some(depth_m)) = (of.item(LongWavesKey::PERIOD), environment.depth_m)
        else {
            return;
        };
        let depth_m = greater(depth_m + environment.tide.level_m(0.0), 0.0);
        let site = LongWaveSite { towards_rad: 0.0, depth_m, wall_m: None };
        let wave_m = site.length_m(*period.number());
        if longest_m > LONG_SHIP * wave_m {
            let message = format!(
                "a wave of {} s is {:.0} m long here, and a vessel is {:.0} m long, more than a \
                 quarter of the wave: the force along the vessel is computed from the water \
                 amidships, and is more than 10 % too large",
                printable_number(*period.number()),
                wave_m,
                longest_m
            );
            self.note_at(&period.span, of.path_of(LongWavesKey::PERIOD), message);
        }
    }
}
