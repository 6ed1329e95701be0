//! Long waves at a berth: infragravity waves and seiches. The input for long waves is the level and the velocity of the
//! water at the berth.
//!
//! Long waves are much longer than the depth and the ship. Because long waves are so long, the water level is taken to
//! be the same all over the berth. The velocity of long waves is taken to be the same all over the berth and over the
//! depth. The level of the long waves lifts a ship as the tide does. The velocity of the long waves acts on the ship as
//! a current, and its acceleration pushes her (Froude–Krylov force and added mass).
//!
//! By linear theory, a wave of amplitude a and phase speed c = ω/k moves water of depth h to and fro. The mean velocity
//! of a long wave over the depth is a c/h, with k by the dispersion relation (derived: a level that rises needs this
//! flow). In front of a wall that reflects a wave wholly, the wave is a standing wave. With the amplitude A at the
//! wall, the level of the standing wave is A cos(kx) cos(ωt) at a distance x from the wall, and the velocity towards
//! the wall is −A (c/h) sin(kx) sin(ωt).
//!
//! The spectrum of long waves has the shape of JONSWAP around its peak, within a band of periods. The JONSWAP shape of
//! the spectrum is our assumption: we know no standard shape for long waves.

use core::f64::consts::TAU;

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Vec2, vec2};

use super::current::check_velocity;
use super::error::EnvironmentError;
use super::harmonics::Realisation;
use super::table::{check_axis, is_off, place};
use super::waves::{Jonswap, RegularWave, wave_number};
use crate::range::within;

/// Height of a long wave divided by the depth at which the wave breaks: the value for a solitary wave (McCowan 1894;
/// from memory).
const BREAKING: f64 = 0.78;
/// The least length of a long wave, in multiples of the depth. At the least length of a long wave, the velocity at the
/// surface is 1.2 times the velocity at the bottom.
const LENGTH_IN_DEPTHS: f64 = 10.0;
/// Shortest and longest period of a long wave that is accepted (s). A period of 25 s separates long waves from swell.
const PERIODS_S: [f64; 2] = [25.0, 86_400.0];

/// The berth at which there are long waves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LongWaveSite {
    /// Direction to which the long waves run, clockwise from north (rad).
    pub towards_rad: f64,
    /// Depth of the water at the berth (m).
    pub depth_m: f64,
    /// Distance from the berth to a wall in the direction of the waves, which reflects them wholly (m); `None` if there
    /// is no wall.
    pub wall_m: Option<f64>,
}

/// A spectrum of long waves. If there is a wall, the significant height is that at the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LongWaveSpectrum {
    /// Significant height (m).
    pub height_m: f64,
    /// Peak period (s).
    pub peak_period_s: f64,
    /// Shortest and longest period of the spectrum (s), with the peak between them.
    pub periods_s: [f64; 2],
    /// Peak enhancement γ of the spectrum, as in JONSWAP.
    pub peak_enhancement: f64,
}

/// Level and velocity of the water at a berth in long waves: a pure function of time.
#[derive(Clone, Debug, PartialEq)]
pub struct LongWaves {
    kind: Kind,
    /// Lowest and highest level of the long waves (m). For a spectrum the lowest and the highest level are taken as
    /// minus and plus the significant height, which the level seldom passes.
    range_m: [f64; 2],
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Harmonics { along: Vec2, parts: Vec<Part> },
    Series { times_s: Vec<f64>, levels_m: Vec<f64>, velocities_mps: Vec<Vec2> },
}

/// One harmonic of the long waves: level · cos(ωt + ε), and the velocity along the direction of the waves.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    frequency_radps: f64,
    phase_rad: f64,
    level_m: f64,
    /// Amplitudes of the harmonic's velocity, in phase with the cosine and with the sine (m/s).
    velocity_mps: [f64; 2],
}

impl LongWaveSite {
    fn check(&self) -> Result<(), EnvironmentError> {
        within("direction of the long waves [rad]", self.towards_rad, -100.0, 100.0)?;
        within("depth under long waves [m]", self.depth_m, 0.5, 1000.0)?;
        within("distance to the wall [m]", self.wall_m.unwrap_or(0.0), 0.0, 1e5)?;
        Ok(())
    }

    /// Checks the height of long waves (m): waves break at 0.78 of the depth.
    ///
    /// # Errors
    /// Fails for a height below 0, or for one at which the waves would break.
    pub fn check_height(&self, height_m: f64) -> Result<(), EnvironmentError> {
        let most_m = BREAKING * self.depth_m;
        within("height of the long waves [m], which break at 0.78 depths", height_m, 0.0, most_m)?;
        Ok(())
    }

    /// Checks the period of long waves (s): waves count as long if their length is ten depths or more.
    ///
    /// # Errors
    /// Fails for a period that is not between 25 s and a day, or that is too short for the depth.
    pub fn check_period(&self, period_s: f64) -> Result<(), EnvironmentError> {
        within("period of a long wave [s]", period_s, PERIODS_S[0], PERIODS_S[1])?;
        let depths = self.length_m(period_s) / self.depth_m;
        let what = "length of the shortest long wave, in depths";
        within(what, depths, LENGTH_IN_DEPTHS, 1e6)?;
        Ok(())
    }

    /// Length of a long wave from its period (m).
    #[must_use]
    pub fn length_m(&self, period_s: f64) -> f64 {
        TAU / wave_number(TAU / period_s, self.depth_m)
    }

    /// Makes one harmonic of the long waves from its amplitude. If there is a wall, the given amplitude is the
    /// amplitude at the wall.
    fn part(&self, frequency_radps: f64, amplitude_m: f64, phase_rad: f64) -> Part {
        let number = wave_number(frequency_radps, self.depth_m);
        let velocity_mps = amplitude_m * frequency_radps / (number * self.depth_m);
        let (level_m, velocity_mps) = match self.wall_m {
            None => (amplitude_m, [velocity_mps, 0.0]),
            Some(wall_m) => {
                let (sine, cosine) = libm::sincos(number * wall_m);
                (amplitude_m * cosine, [0.0, -velocity_mps * sine])
            }
        };
        Part { frequency_radps, phase_rad, level_m, velocity_mps }
    }

    fn along(&self) -> Vec2 {
        let (sine, cosine) = libm::sincos(self.towards_rad);
        vec2(cosine, sine)
    }
}

impl LongWaves {
    /// Makes one regular long wave; with a wall the wave is a seiche, and the height is the height at the wall.
    ///
    /// # Errors
    /// Fails for a number out of range, a wave that would break, or a wave that is too short for the depth.
    pub fn regular(wave: RegularWave, site: &LongWaveSite) -> Result<LongWaves, EnvironmentError> {
        site.check()?;
        site.check_height(wave.height_m)?;
        site.check_period(wave.period_s)?;
        within("phase of the long wave [rad]", wave.phase_rad, -100.0, 100.0)?;
        let part = site.part(TAU / wave.period_s, 0.5 * wave.height_m, wave.phase_rad);
        let reach_m = part.level_m.abs();
        let kind = Kind::Harmonics { along: site.along(), parts: vec![part] };
        Ok(LongWaves { kind, range_m: [-reach_m, reach_m] })
    }

    /// Makes long waves with random phases, from a spectrum. The same seed gives the same long waves, bit for bit. The
    /// significant height of the made waves is exactly that of the spectrum.
    ///
    /// # Errors
    /// Fails for a number out of range, a height at which the waves would break, a peak outside the band, or periods
    /// too short for the depth.
    pub fn of_spectrum(
        spectrum: &LongWaveSpectrum,
        site: &LongWaveSite,
        realisation: Realisation,
    ) -> Result<LongWaves, EnvironmentError> {
        site.check()?;
        site.check_height(spectrum.height_m)?;
        let [shortest_s, longest_s] = spectrum.periods_s;
        site.check_period(shortest_s)?;
        within("longest period of the long waves [s]", longest_s, shortest_s, PERIODS_S[1])?;
        within("peak period of the long waves [s]", spectrum.peak_period_s, shortest_s, longest_s)?;
        within("peak enhancement of JONSWAP", spectrum.peak_enhancement, 1.0, 10.0)?;
        realisation.check()?;
        let shape = Jonswap {
            height_m: spectrum.height_m,
            peak_period_s: spectrum.peak_period_s,
            peak_enhancement: spectrum.peak_enhancement,
        };
        let [low, high] = [TAU / longest_s, TAU / shortest_s];
        let harmonics = realisation.harmonics_of(|w| shape.density(w), low, high);
        let energy_m2: f64 = harmonics.iter().map(|h| 0.5 * h.amplitude * h.amplitude).sum();
        let scale = if energy_m2 > 0.0 { 0.25 * spectrum.height_m / energy_m2.sqrt() } else { 0.0 };
        let parts: Vec<Part> = harmonics
            .iter()
            .map(|h| site.part(h.frequency, scale * h.amplitude, h.phase_rad))
            .collect();
        let mut waves =
            LongWaves { kind: Kind::Harmonics { along: site.along(), parts }, range_m: [0.0; 2] };
        let reach_m = waves.significant_height_m();
        waves.range_m = [-reach_m, reach_m];
        Ok(waves)
    }

    /// Makes long waves from rows of time (s), level (m) and velocity, north and east (m/s), with straight lines
    /// between the rows.
    ///
    /// # Errors
    /// Fails for fewer than two rows, times that do not increase, or a number out of range.
    pub fn series(rows: &[(f64, f64, Vec2)]) -> Result<LongWaves, EnvironmentError> {
        check_axis("times of the long waves [s]", rows.iter().map(|row| row.0), 2)?;
        for &(_, level_m, velocity_mps) in rows {
            within("level of the long waves [m]", level_m, -10.0, 10.0)?;
            check_velocity(velocity_mps)?;
        }
        let levels_m: Vec<f64> = rows.iter().map(|row| row.1).collect();
        let range_m = levels_m.iter().fold([f64::MAX, f64::MIN], |[low, high], &level_m| {
            [lesser(low, level_m), greater(high, level_m)]
        });
        let kind = Kind::Series {
            times_s: rows.iter().map(|row| row.0).collect(),
            levels_m,
            velocities_mps: rows.iter().map(|row| row.2).collect(),
        };
        Ok(LongWaves { kind, range_m })
    }

    /// Whether a time (s) is before the first or after the last row of a series; the level and velocity of that row are
    /// then used.
    #[must_use]
    pub fn is_held(&self, t_s: f64) -> bool {
        match &self.kind {
            Kind::Harmonics { .. } => false,
            Kind::Series { times_s, .. } => is_off(times_s.len(), |i| times_s[i], t_s),
        }
    }

    /// Level of the long waves above that of the tide (m).
    #[must_use]
    pub fn level_m(&self, t_s: f64) -> f64 {
        match &self.kind {
            Kind::Harmonics { parts, .. } => parts
                .iter()
                .map(|part| part.level_m * libm::cos(part.frequency_radps * t_s + part.phase_rad))
                .sum(),
            Kind::Series { times_s, levels_m, .. } => {
                let at = place(times_s.len(), |i| times_s[i], t_s);
                levels_m[at.low] + at.share * (levels_m[at.high] - levels_m[at.low])
            }
        }
    }

    /// Velocity of the water in the long waves (m/s).
    #[must_use]
    pub fn velocity(&self, t_s: f64) -> Vec2 {
        match &self.kind {
            Kind::Harmonics { along, parts } => {
                let speeds_mps = parts.iter().map(|part| {
                    let (sine, cosine) = libm::sincos(part.frequency_radps * t_s + part.phase_rad);
                    part.velocity_mps[0] * cosine + part.velocity_mps[1] * sine
                });
                *along * speeds_mps.sum::<f64>()
            }
            Kind::Series { times_s, velocities_mps, .. } => {
                let at = place(times_s.len(), |i| times_s[i], t_s);
                let (low, high) = (velocities_mps[at.low], velocities_mps[at.high]);
                low + (high - low) * at.share
            }
        }
    }

    /// Lowest and highest level of the long waves (m). For a spectrum the lowest and the highest level are minus and
    /// plus the significant height, which the level seldom passes.
    #[must_use]
    pub fn range_m(&self) -> [f64; 2] {
        self.range_m
    }

    /// Significant height: four times the standard deviation of the level (m); for a series it is computed from the
    /// rows.
    #[must_use]
    pub fn significant_height_m(&self) -> f64 {
        4.0 * match &self.kind {
            Kind::Harmonics { parts, .. } => {
                parts.iter().map(|part| 0.5 * part.level_m * part.level_m).sum::<f64>().sqrt()
            }
            Kind::Series { levels_m, .. } => deviation(levels_m.iter().copied()),
        }
    }

    /// The standard deviation of the long waves' velocity, north and east (m/s); for a series it is computed from the
    /// rows.
    #[must_use]
    pub fn velocity_deviation(&self) -> Vec2 {
        match &self.kind {
            Kind::Harmonics { along, parts } => {
                let squares = parts.iter().map(|part| {
                    let [cosine, sine] = part.velocity_mps;
                    0.5 * (cosine * cosine + sine * sine)
                });
                let deviation_mps = squares.sum::<f64>().sqrt();
                vec2(along.x.abs() * deviation_mps, along.y.abs() * deviation_mps)
            }
            Kind::Series { velocities_mps, .. } => vec2(
                deviation(velocities_mps.iter().map(|velocity| velocity.x)),
                deviation(velocities_mps.iter().map(|velocity| velocity.y)),
            ),
        }
    }
}

/// The standard deviation of numbers about their mean.
fn deviation(numbers: impl ExactSizeIterator<Item = f64> + Clone) -> f64 {
    let count = numbers.len() as f64;
    let mean = numbers.clone().sum::<f64>() / count;
    (numbers.map(|number| (number - mean) * (number - mean)).sum::<f64>() / count).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SITE: LongWaveSite = LongWaveSite { towards_rad: 0.5, depth_m: 20.0, wall_m: None };
    const SPECTRUM: LongWaveSpectrum = LongWaveSpectrum {
        height_m: 0.2,
        peak_period_s: 100.0,
        periods_s: [50.0, 200.0],
        peak_enhancement: 3.3,
    };
    const DRAW: Realisation = Realisation { harmonics: 40, seed: 4 };

    fn close(one: f64, other: f64, tolerance: f64) {
        assert!((one - other).abs() <= tolerance, "{one} {other}");
    }

    /// A run of 12,000 s would be 120 peak periods. Near the peak the harmonics are 0.0014 rad/s apart, so the mean
    /// over such a run still has beats. The run is therefore 400,000 s, over which the variance is known to 1 %.
    #[test]
    fn the_level_has_the_significant_height_and_the_velocity_follows_it() {
        let waves = LongWaves::of_spectrum(&SPECTRUM, &SITE, DRAW).expect("good numbers");
        assert_eq!(waves, LongWaves::of_spectrum(&SPECTRUM, &SITE, DRAW).expect("good numbers"));
        let other = Realisation { seed: 5, ..DRAW };
        assert_ne!(waves, LongWaves::of_spectrum(&SPECTRUM, &SITE, other).expect("good numbers"));
        close(waves.significant_height_m(), 0.2, 1e-12);
        let levels_m: Vec<f64> = (0..100_000).map(|k| waves.level_m(4.0 * f64::from(k))).collect();
        close(4.0 * deviation(levels_m.iter().copied()), 0.2, 0.002);
        // Waves of 50 to 200 s run at 13.63 to 13.98 m/s here: the velocity is the level times this speed over the
        // depth.
        for (k, level_m) in levels_m.iter().enumerate().take(500) {
            let velocity = waves.velocity(4.0 * k as f64);
            close(velocity.dot(SITE.along()), level_m * 13.9 / 20.0, 0.002);
            close(velocity.dot(vec2(-SITE.along().y, SITE.along().x)), 0.0, 1e-15);
        }
    }

    /// Continuity: between two places of a standing wave the level rises by the flow that enters and does not leave
    /// again.
    #[test]
    fn a_seiche_keeps_its_water() {
        let wave = RegularWave { height_m: 0.4, period_s: 300.0, phase_rad: 0.3 };
        let at = |wall_m: f64| {
            let site = LongWaveSite { wall_m: Some(wall_m), towards_rad: 0.0, ..SITE };
            LongWaves::regular(wave, &site).expect("good numbers")
        };
        let (t_s, by_s, by_m) = (77.0, 0.01, 0.01);
        let [near, here, far] = [at(700.0 - by_m), at(700.0), at(700.0 + by_m)];
        let rises_mps = (here.level_m(t_s + by_s) - here.level_m(t_s - by_s)) / (2.0 * by_s);
        // Towards the wall: the flow that enters at the far place, less the flow that leaves at the near place.
        let stays_ps = (far.velocity(t_s).x - near.velocity(t_s).x) / (2.0 * by_m);
        close(rises_mps, 20.0 * stays_ps, 1e-7);
        let quarter_m = 0.25 * SITE.length_m(300.0);
        close(at(0.0).range_m()[1], 0.2, 1e-15);
        close(at(0.0).velocity(t_s).length(), 0.0, 1e-15);
        close(at(quarter_m).range_m()[1], 0.0, 1e-15);
        // At the node the velocity is the amplitude times the phase speed over the depth. The phase speed here is √(gh)
        // within a permille.
        let node_mps = at(quarter_m).velocity_deviation().x * core::f64::consts::SQRT_2;
        close(node_mps, 0.2 * (9.80665_f64 / 20.0).sqrt(), 1e-3 * 0.14);
    }

    #[test]
    fn a_series_is_linear_between_its_rows() {
        let rows = [(0.0, 0.1, vec2(0.2, 0.0)), (10.0, -0.1, vec2(0.0, 0.4))];
        let waves = LongWaves::series(&rows).expect("good rows");
        close(waves.level_m(2.5), 0.05, 1e-15);
        assert_eq!(waves.velocity(5.0), vec2(0.1, 0.2));
        assert_eq!(waves.range_m(), [-0.1, 0.1]);
        close(waves.significant_height_m(), 0.4, 1e-15);
        let back = [rows[1], rows[0]];
        assert!(LongWaves::series(&back).is_err() && LongWaves::series(&rows[..1]).is_err());
    }

    #[test]
    fn numbers_out_of_range_are_refused() {
        let of = |spectrum: LongWaveSpectrum, site: LongWaveSite| {
            LongWaves::of_spectrum(&spectrum, &site, DRAW).expect_err("a mistake").to_string()
        };
        for (bad, what) in [
            (LongWaveSpectrum { height_m: -1.0, ..SPECTRUM }, "height of the long waves"),
            (LongWaveSpectrum { height_m: 15.7, ..SPECTRUM }, "break at 0.78 depths"),
            (LongWaveSpectrum { periods_s: [12.0, 200.0], ..SPECTRUM }, "period of a long wave"),
            (LongWaveSpectrum { periods_s: [120.0, 200.0], ..SPECTRUM }, "peak period"),
            (LongWaveSpectrum { periods_s: [50.0, 40.0], ..SPECTRUM }, "longest period"),
        ] {
            let message = of(bad, SITE);
            assert!(message.contains(what), "{message}");
        }
        // A wave of 50 s is 1,500 m long in 100 m of water. In 230 m of water it is 10 depths long.
        let message = of(SPECTRUM, LongWaveSite { depth_m: 250.0, ..SITE });
        assert!(message.contains("in depths"), "{message}");
        assert!(of(SPECTRUM, LongWaveSite { depth_m: f64::NAN, ..SITE }).contains("depth"));
    }
}
