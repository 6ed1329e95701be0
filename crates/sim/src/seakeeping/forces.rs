//! Forces of the waves on a ship with hydrodynamic data: first-order excitation, mean drift, and slow drift by Newman's
//! approximation.
//!
//! Newman (1974) replaces the quadratic transfer function of two waves by the mean of their mean drifts. With waves
//! a·cos θ, the drift is then Σᵢ Σⱼ aᵢaⱼ ½(Tᵢ + Tⱼ) cos(θᵢ − θⱼ) = Re{(Σ aⱼTⱼe^{iθⱼ}) (Σ aⱼe^{iθⱼ})*}: exactly, and with a cost that
//! grows with the number of waves and not with its square.

use core::f64::consts::{FRAC_PI_6, PI};

use fenderline_contact::number::lesser;
use fenderline_contact::{Rotation, Vec2};

use super::data::{Hydrodynamics, PLANE};
use super::matrix::Six;
use super::sub_steps::SubSteps;
use crate::constants::STANDARD_GRAVITY_MPS2;
use crate::environment::waves::{Complex, DriftHull, Sea};

/// Headings of the drift of an estimated hull: 0 to 180 degrees by 15.
const ESTIMATE_HEADINGS: usize = 13;
/// The motions that change their sign in a mirror.
const MIRROR: Six = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];

/// Where the mean drift comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum DriftSource<'d> {
    /// The database.
    Data,
    /// The estimate of [`DriftHull`] about midship, which is so far forward of the centre of gravity (m), in water of a
    /// density (kg/m³).
    Estimate(&'d DriftHull, f64, f64),
    /// None.
    Absent,
}

/// A sea as a ship with hydrodynamic data feels it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WaveForces {
    waves: Vec<Wave>,
    /// Directions of the sea towards which its waves run (rad).
    directions_rad: Vec<f64>,
    excitation: Headings,
    drift: Headings,
    origin_m: Vec2,
}

/// A wave of the sea and its forces by heading.
#[derive(Clone, Debug, PartialEq)]
struct Wave {
    frequency_radps: f64,
    amplitude_m: f64,
    phase_rad: f64,
    number_radpm: Vec2,
    direction: usize,
    /// sin²(ωh/2).
    squared_sine: f64,
    /// Exciting force by heading: its mean over a step, weighted as the step weights accelerations.
    excitation: Vec<[Complex; 6]>,
    /// Mean drift over the amplitude (N/m, N/m, N), by heading.
    drift: Vec<[f64; 3]>,
}

/// An axis of headings.
#[derive(Clone, Debug, PartialEq)]
struct Headings {
    rad: Vec<f64>,
    is_mirrored: bool,
}

/// A place on an axis of headings.
#[derive(Clone, Copy, Debug)]
struct Heading {
    low: usize,
    high: usize,
    share: f64,
    /// −1 where the mirror image is meant.
    side: f64,
}

impl Headings {
    fn place(&self, towards_rad: f64) -> Heading {
        let (sin, cos) = (libm::sin(towards_rad), libm::cos(towards_rad));
        let mut angle = libm::atan2(sin, cos);
        let mut side = 1.0;
        if self.is_mirrored {
            (angle, side) = (angle.abs(), if angle < 0.0 { -1.0 } else { 1.0 });
        } else {
            while angle < self.rad[0] {
                angle += 2.0 * PI;
            }
            while angle >= self.rad[0] + 2.0 * PI {
                angle -= 2.0 * PI;
            }
        }
        let last = self.rad.len() - 1;
        let above = self.rad.partition_point(|heading| *heading <= angle);
        if above == 0 {
            return Heading { low: 0, high: 0, share: 0.0, side };
        }
        if above > last {
            if self.is_mirrored {
                return Heading { low: last, high: last, share: 0.0, side };
            }
            let width = self.rad[0] + 2.0 * PI - self.rad[last];
            let share = if width > 1e-9 { (angle - self.rad[last]) / width } else { 0.0 };
            return Heading { low: last, high: 0, share: lesser(share, 1.0), side };
        }
        let share = (angle - self.rad[above - 1]) / (self.rad[above] - self.rad[above - 1]);
        Heading { low: above - 1, high: above, share, side }
    }
}

/// Forces of the waves at a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct WaveLoad {
    /// Excitation about the centre of gravity.
    pub(crate) excitation: Six,
    /// Mean and slow drift about the centre of gravity: surge, sway, yaw.
    pub(crate) drift: [f64; 3],
}

impl WaveForces {
    pub(crate) fn new(
        data: &Hydrodynamics,
        sea: &Sea,
        drift: DriftSource<'_>,
        step_s: f64,
    ) -> WaveForces {
        let excitation = Headings { rad: data.headings_rad.clone(), is_mirrored: data.is_mirrored };
        let drift_headings = match drift {
            DriftSource::Data => excitation.clone(),
            DriftSource::Estimate(..) | DriftSource::Absent => Headings {
                rad: (0..ESTIMATE_HEADINGS).map(|k| 0.5 * FRAC_PI_6 * k as f64).collect(),
                is_mirrored: true,
            },
        };
        let waves = sea
            .components()
            .iter()
            .map(|wave| {
                let theta = 0.5 * wave.frequency_radps * step_s;
                let sine = libm::sin(theta);
                let mean = if theta < 1e-6 { 1.0 } else { sine / theta };
                let scale = wave.amplitude_m * mean * mean;
                let count = excitation.rad.len();
                let forces = (0..count).map(|heading| {
                    data.excitation_at(wave.frequency_radps, heading).map(|force| force * scale)
                });
                let number = wave.number_radpm.length();
                let drifts = drift_headings.rad.iter().enumerate().map(|(heading, towards_rad)| {
                    match drift {
                        DriftSource::Data => data.drift_at(wave.frequency_radps, heading),
                        DriftSource::Estimate(hull, ahead_m, density) => {
                            let [x, y, n] = hull.coefficients(number, *towards_rad);
                            let scale = density * STANDARD_GRAVITY_MPS2;
                            [x, y, n + ahead_m * y].map(|of| scale * of)
                        }
                        DriftSource::Absent => [0.0; 3],
                    }
                    .map(|force| force * wave.amplitude_m)
                });
                Wave {
                    frequency_radps: wave.frequency_radps,
                    amplitude_m: wave.amplitude_m,
                    phase_rad: wave.phase_rad,
                    number_radpm: wave.number_radpm,
                    direction: wave.direction,
                    squared_sine: sine * sine,
                    excitation: forces.collect(),
                    drift: drifts.collect(),
                }
            })
            .collect();
        WaveForces {
            waves,
            directions_rad: sea.directions_rad().to_vec(),
            excitation,
            drift: drift_headings,
            origin_m: data.origin_m,
        }
    }

    /// The forces on a ship with a place of her centre of gravity and a heading, in a step that begins at a time (s).
    pub(crate) fn at(
        &self,
        gravity_m: Vec2,
        heading_rad: f64,
        t_s: f64,
        sub_steps: SubSteps,
    ) -> WaveLoad {
        let t_s = t_s + sub_steps.ahead_s;
        let place_m = gravity_m + Rotation::from_angle(heading_rad).apply(self.origin_m);
        let mut load = WaveLoad::default();
        let (mut with_drift, mut plain) = ([Complex::default(); 3], Complex::default());
        let (mut own, mut of_drift) = (None, None);
        for wave in &self.waves {
            let here = |known: &mut Option<(usize, Heading)>, axis: &Headings| match known {
                Some((direction, heading)) if *direction == wave.direction => *heading,
                _ => {
                    let heading = axis.place(self.directions_rad[wave.direction] - heading_rad);
                    *known = Some((wave.direction, heading));
                    heading
                }
            };
            let heading = here(&mut own, &self.excitation);
            let angle =
                wave.frequency_radps * t_s - wave.number_radpm.dot(place_m) + wave.phase_rad;
            let (cos, sin) = (libm::cos(angle), libm::sin(angle));
            let (low, high) = (&wave.excitation[heading.low], &wave.excitation[heading.high]);
            let gain = sub_steps.gain(wave.squared_sine);
            for (k, sum) in load.excitation.iter_mut().enumerate() {
                let re = low[k].re + heading.share * (high[k].re - low[k].re);
                let im = low[k].im + heading.share * (high[k].im - low[k].im);
                let side = if heading.side < 0.0 { MIRROR[k] } else { 1.0 };
                let gain = if PLANE.contains(&k) { gain } else { 1.0 };
                *sum += side * gain * (re * cos - im * sin);
            }
            let heading = here(&mut of_drift, &self.drift);
            let (low, high) = (&wave.drift[heading.low], &wave.drift[heading.high]);
            for (k, sum) in with_drift.iter_mut().enumerate() {
                let side = if heading.side < 0.0 { MIRROR[[0, 1, 5][k]] } else { 1.0 };
                let force = side * (low[k] + heading.share * (high[k] - low[k]));
                *sum = *sum + Complex::new(force * cos, force * sin);
            }
            plain = plain + Complex::new(wave.amplitude_m * cos, wave.amplitude_m * sin);
        }
        load.drift = with_drift.map(|sum| sum.re * plain.re + sum.im * plain.im);
        load
    }
}

impl Hydrodynamics {
    /// The exciting force in a wave of amplitude 1 m at one of the data's headings, linear between the frequencies and held beyond them.
    #[must_use]
    pub fn excitation_at(&self, frequency_radps: f64, heading: usize) -> [Complex; 6] {
        let (low, high, share) = self.wave_place(frequency_radps);
        let of = |row: usize| &self.excitation[row * self.headings_rad.len() + heading];
        let (low, high) = (of(low), of(high));
        std::array::from_fn(|k| low[k] * (1.0 - share) + high[k] * share)
    }

    /// The mean drift over the square of the amplitude, likewise; zero without such data.
    fn drift_at(&self, frequency_radps: f64, heading: usize) -> [f64; 3] {
        let Some(drift) = &self.drift else { return [0.0; 3] };
        let (low, high, share) = self.wave_place(frequency_radps);
        let of = |row: usize| &drift[row * self.headings_rad.len() + heading];
        let (low, high) = (of(low), of(high));
        std::array::from_fn(|k| low[k] + share * (high[k] - low[k]))
    }

    fn wave_place(&self, frequency_radps: f64) -> (usize, usize, f64) {
        let axis = &self.wave_frequencies_radps;
        let above = axis.partition_point(|w| *w <= frequency_radps);
        if above == 0 {
            return (0, 0, 0.0);
        }
        if above == axis.len() {
            return (above - 1, above - 1, 0.0);
        }
        (above - 1, above, (frequency_radps - axis[above - 1]) / (axis[above] - axis[above - 1]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Newman's double sum over all pairs of waves, term by term.
    #[test]
    fn slow_drift_is_the_double_sum_over_pairs_of_waves() {
        let headings = Headings { rad: vec![0.0, PI], is_mirrored: true };
        let waves: Vec<Wave> = (0..60)
            .map(|k| {
                let k = f64::from(k);
                let amplitude_m = 0.1 + 0.03 * libm::sin(k);
                let drift = [2e4 + 9e3 * libm::cos(2.0 * k), 3e4 * libm::sin(k), 1e6 - 4e4 * k];
                Wave {
                    frequency_radps: 0.4 + 0.017 * k,
                    amplitude_m,
                    phase_rad: 5.0 * libm::sin(7.0 * k),
                    number_radpm: Vec2 { x: 0.02 + 0.001 * k, y: 0.004 },
                    direction: 0,
                    squared_sine: 0.0,
                    excitation: vec![[Complex::default(); 6]; 2],
                    drift: vec![drift.map(|of| of * amplitude_m); 2],
                }
            })
            .collect();
        let sea = WaveForces {
            waves,
            directions_rad: vec![0.3],
            excitation: headings.clone(),
            drift: headings,
            origin_m: Vec2::ZERO,
        };
        let place_m = Vec2 { x: 12.0, y: -7.0 };
        for t_s in [0.0, 3.0, 417.0] {
            let found = sea.at(place_m, 0.0, t_s, SubSteps::default()).drift;
            for (k, found) in found.into_iter().enumerate() {
                let mut expected = 0.0;
                for one in &sea.waves {
                    for two in &sea.waves {
                        let angle = |wave: &Wave| {
                            wave.frequency_radps * t_s - wave.number_radpm.dot(place_m)
                                + wave.phase_rad
                        };
                        let mean = 0.5
                            * (one.drift[0][k] / one.amplitude_m
                                + two.drift[0][k] / two.amplitude_m);
                        let waves_m2 = one.amplitude_m * two.amplitude_m;
                        expected += waves_m2 * mean * libm::cos(angle(one) - angle(two));
                    }
                }
                assert!(
                    (found - expected).abs() < 1e-9 * expected.abs() + 1e-6,
                    "{found} {expected}"
                );
            }
        }
    }

    #[test]
    fn a_heading_from_starboard_is_the_mirror_of_one_from_port_and_all_round_wraps() {
        let mirrored = Headings { rad: vec![0.0, 0.5 * PI, PI], is_mirrored: true };
        let place = mirrored.place(-0.25 * PI);
        assert_eq!((place.low, place.high, place.side), (0, 1, -1.0));
        assert!((place.share - 0.5).abs() < 1e-12);
        let round = Headings { rad: vec![-0.5 * PI, 0.0, 0.5 * PI, PI], is_mirrored: false };
        let place = round.place(-0.75 * PI);
        assert_eq!((place.low, place.high, place.side), (3, 0, 1.0));
        assert!((place.share - 0.5).abs() < 1e-12);
    }
}
