//! A sea as a sum of harmonics in one direction, or in several directions about a mean direction.

use core::f64::consts::{FRAC_PI_2, TAU};

use fenderline_contact::number::greater;
use fenderline_contact::{Vec2, vec2};

use super::dispersion::wave_number;
use super::jonswap::Jonswap;
use crate::environment::error::EnvironmentError;
use crate::environment::harmonics::{Realisation, integral};
use crate::range::within;

/// Frequency band of a JONSWAP sea, in multiples of the peak frequency ω_p. 0.3 % of the spectrum's energy lies outside
/// the band; the harmonics are scaled up to make up for it.
const BAND: [f64; 2] = [0.5, 4.0];

/// Number of directions of a short-crested sea.
pub const DIRECTIONS: usize = 15;
/// Step in the list of directions from one harmonic to the next. With this step, no two of fifteen consecutive
/// harmonics have the same direction.
const STRIDE: usize = 4;

/// One regular wave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegularWave {
    /// Height of the regular wave, from trough to crest (m).
    pub height_m: f64,
    /// Period (s).
    pub period_s: f64,
    /// Phase ε of the regular wave at the origin at t = 0 (rad); 0 is a crest.
    pub phase_rad: f64,
}

/// The height at which a regular wave breaks (m): 0.142 L tanh(kd) in water of depth d. The breaking height is a
/// seventh of the wave's length in deep water and nine tenths of the depth in shallow water (Miche 1944, from memory).
#[must_use]
pub fn breaking_height_m(period_s: f64, depth_m: f64) -> f64 {
    let number = wave_number(TAU / period_s, depth_m);
    0.142 * TAU / number * libm::tanh(number * depth_m)
}

/// A sea: a sum of harmonics in one direction, or in several directions about a mean direction. The elevation of the
/// sea is a pure function of position and time.
#[derive(Clone, Debug, PartialEq)]
pub struct Sea {
    towards_rad: f64,
    /// The directions towards which the harmonics travel.
    pub(super) directions_rad: Vec<f64>,
    pub(super) components: Vec<Component>,
}

/// One harmonic of a sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Component {
    /// Angular frequency ω (rad/s).
    pub frequency_radps: f64,
    /// Amplitude of the surface (m).
    pub amplitude_m: f64,
    /// Phase ε at the origin at time 0 (rad).
    pub phase_rad: f64,
    /// Wave number vector k of the harmonic, north and east (rad/m).
    pub number_radpm: Vec2,
    /// Index of the harmonic's direction in [`Sea::directions_rad`].
    pub direction: usize,
}

impl Component {
    /// The phase angle ωt − k·x + ε of the harmonic.
    pub(super) fn angle_rad(&self, position_m: Vec2, t_s: f64) -> f64 {
        self.frequency_radps * t_s - self.number_radpm.dot(position_m) + self.phase_rad
    }
}

impl Sea {
    /// Makes a regular wave towards a direction, clockwise from north, in water of a given depth (m).
    ///
    /// # Errors
    /// Fails for a number out of range, or a height at which waves of this length break ([`breaking_height_m`]).
    pub fn regular(
        wave: RegularWave,
        towards_rad: f64,
        depth_m: f64,
    ) -> Result<Sea, EnvironmentError> {
        within("wave period [s]", wave.period_s, 0.5, 40.0)?;
        within("phase of the wave [rad]", wave.phase_rad, -100.0, 100.0)?;
        check_place(towards_rad, depth_m)?;
        let frequency_radps = TAU / wave.period_s;
        let number = wave_number(frequency_radps, depth_m);
        let breaking_m = breaking_height_m(wave.period_s, depth_m);
        within(
            "wave height [m] (higher waves of this period break)",
            wave.height_m,
            0.0,
            breaking_m,
        )?;
        let component = Component {
            frequency_radps,
            amplitude_m: 0.5 * wave.height_m,
            phase_rad: wave.phase_rad,
            number_radpm: number_towards(number, towards_rad),
            direction: 0,
        };
        Ok(Sea { towards_rad, directions_rad: vec![towards_rad], components: vec![component] })
    }

    /// Makes a long-crested JONSWAP sea towards a direction, in water of a given depth (m). The depth changes the
    /// lengths of the waves, not the spectrum. The harmonics are scaled so that 4√m₀ equals the significant height Hs,
    /// where m₀ is the variance of the elevation. Without scaling of the harmonics, the variance m₀ would be 0.2 % too
    /// large at γ = 3.3, because the factor A of the spectrum is an approximation.
    ///
    /// # Errors
    /// Fails for a number out of range, or for a significant height at which a regular wave with the peak period would
    /// break ([`breaking_height_m`]), because no sea is so high.
    pub fn jonswap(
        spectrum: &Jonswap,
        towards_rad: f64,
        depth_m: f64,
        realisation: Realisation,
    ) -> Result<Sea, EnvironmentError> {
        spectrum.check()?;
        check_place(towards_rad, depth_m)?;
        realisation.check()?;
        let breaking_m = breaking_height_m(spectrum.peak_period_s, depth_m);
        let name = "significant wave height [m] (higher waves of this period break)";
        within(name, spectrum.height_m, 0.0, breaking_m)?;
        let [low, high] = BAND.map(|multiple| multiple * spectrum.peak_radps());
        let harmonics = realisation.harmonics_of(|w| spectrum.density(w), low, high);
        let energy_m2: f64 = harmonics.iter().map(|h| 0.5 * h.amplitude * h.amplitude).sum();
        let scale = if energy_m2 > 0.0 { 0.25 * spectrum.height_m / energy_m2.sqrt() } else { 0.0 };
        let component = |h: &crate::environment::harmonics::Harmonic| Component {
            frequency_radps: h.frequency,
            amplitude_m: scale * h.amplitude,
            phase_rad: h.phase_rad,
            number_radpm: number_towards(wave_number(h.frequency, depth_m), towards_rad),
            direction: 0,
        };
        let components = harmonics.iter().map(component).collect();
        Ok(Sea { towards_rad, directions_rad: vec![towards_rad], components })
    }

    /// Makes a long-crested sea short-crested. The energy of the sea is spread over directions as cosⁿ of the angle
    /// from the mean direction, up to 90° to each side. In a short-crested sea each harmonic has one of [`DIRECTIONS`]
    /// directions; all directions have equal shares of the energy. Harmonics that are neighbours in frequency have
    /// different directions.
    ///
    /// The exponent n = 2 is used by IMO (MEPC.1/Circ.796, 2.3: the circular was found, its formula is from memory) and
    /// commonly for wind seas. Swell has a narrower spread of directions, with a larger exponent n.
    ///
    /// # Errors
    /// Fails for an exponent outside 1 to 100.
    pub fn short_crested(mut self, exponent: f64) -> Result<Sea, EnvironmentError> {
        within("exponent of the spreading of waves", exponent, 1.0, 100.0)?;
        let off_rad = equal_shares(exponent);
        self.directions_rad = off_rad.iter().map(|off_rad| self.towards_rad + off_rad).collect();
        for (index, component) in self.components.iter_mut().enumerate() {
            component.direction = index * STRIDE % DIRECTIONS;
            let towards_rad = self.directions_rad[component.direction];
            component.number_radpm = number_towards(component.number_radpm.length(), towards_rad);
        }
        Ok(self)
    }

    /// Direction towards which the waves travel, clockwise from north (rad). For a short-crested sea this direction is
    /// the mean direction.
    #[must_use]
    pub fn towards_rad(&self) -> f64 {
        self.towards_rad
    }

    /// The harmonics.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// The directions towards which the harmonics travel (rad).
    #[must_use]
    pub fn directions_rad(&self) -> &[f64] {
        &self.directions_rad
    }

    /// True if the harmonics have more than one direction.
    #[must_use]
    pub fn is_short_crested(&self) -> bool {
        self.directions_rad.len() > 1
    }

    /// Elevation of the sea's surface at a position and a time (m).
    #[must_use]
    pub fn elevation_m(&self, position_m: Vec2, t_s: f64) -> f64 {
        let heights =
            self.components.iter().map(|c| c.amplitude_m * libm::cos(c.angle_rad(position_m, t_s)));
        heights.sum()
    }

    /// Variance of the sea's elevation, m₀ = Σ½a² (m²).
    #[must_use]
    pub fn variance_m2(&self) -> f64 {
        self.components.iter().map(|c| 0.5 * c.amplitude_m * c.amplitude_m).sum()
    }

    /// The share of the sea's energy at frequencies outside a range (rad/s); 0 without waves.
    #[must_use]
    pub fn share_outside(&self, [low_radps, high_radps]: [f64; 2]) -> f64 {
        let outside = |c: &&Component| !(low_radps..=high_radps).contains(&c.frequency_radps);
        let energy = |c: &Component| 0.5 * c.amplitude_m * c.amplitude_m;
        let outside_m2: f64 = self.components.iter().filter(outside).map(energy).sum();
        if outside_m2 > 0.0 { outside_m2 / self.variance_m2() } else { 0.0 }
    }

    /// Mean period of the sea, T₀₁ = 2π m₀/m₁ (s).
    #[must_use]
    pub fn mean_period_s(&self) -> f64 {
        let m1: f64 = self
            .components
            .iter()
            .map(|c| 0.5 * c.amplitude_m * c.amplitude_m * c.frequency_radps)
            .sum();
        core::f64::consts::TAU * self.variance_m2() / m1
    }

    /// The longest period among the sea's harmonics (s); 0 without waves.
    #[must_use]
    pub fn longest_period_s(&self) -> f64 {
        let there = self.components.iter().filter(|c| c.amplitude_m > 0.0);
        there.fold(0.0, |longest_s, c| greater(longest_s, TAU / c.frequency_radps))
    }

    /// Significant wave height of the sea, 4√m₀ (m).
    #[must_use]
    pub fn significant_height_m(&self) -> f64 {
        4.0 * self.variance_m2().sqrt()
    }
}

fn check_place(towards_rad: f64, depth_m: f64) -> Result<(), EnvironmentError> {
    within("direction of the waves [rad]", towards_rad, -100.0, 100.0)?;
    within("depth of the water [m]", depth_m, 0.1, 12_000.0)?;
    Ok(())
}

/// Angles of the harmonics' directions from the mean direction (rad): the medians of [`DIRECTIONS`] sectors with equal
/// energy under cosⁿ.
fn equal_shares(exponent: f64) -> Vec<f64> {
    let energy = |to_rad: f64| {
        integral(|angle_rad| libm::pow(libm::cos(angle_rad), exponent), 0.0, to_rad, SUB_INTERVALS)
    };
    let whole = 2.0 * energy(FRAC_PI_2);
    let quantile = |share: f64| {
        let (mut low, mut high) = (0.0, FRAC_PI_2);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if energy(middle) < share.abs() * whole {
                low = middle;
            } else {
                high = middle;
            }
        }
        (0.5 * (low + high)).copysign(share)
    };
    let middle = 0.5 * (DIRECTIONS - 1) as f64;
    (0..DIRECTIONS)
        .map(|index| {
            let share = (index as f64 - middle) / DIRECTIONS as f64;
            if share == 0.0 { 0.0 } else { quantile(share) }
        })
        .collect()
}

/// Number of sub-intervals with which Simpson's rule integrates cosⁿ. At the largest exponent, n = 100, the width of
/// the peak of cosⁿ is a fifteenth of the range of angles.
const SUB_INTERVALS: usize = 200;
/// Number of bisections that reduce an interval of a right angle to rounding error.
const BISECTIONS: usize = 52;

fn number_towards(number: f64, towards_rad: f64) -> Vec2 {
    vec2(libm::cos(towards_rad), libm::sin(towards_rad)) * number
}
