//! Forces of the waves on a ship with hydrodynamic data: first-order excitation, mean drift, and slow drift by Newman's
//! approximation.
//!
//! Newman (1974) replaces the quadratic transfer function of two waves by the mean of their mean drifts. With the mean
//! drift of each wave a·cos θ as Ta², the drift by Newman's approximation is Σᵢ Σⱼ aᵢaⱼ ½(Tᵢ + Tⱼ) cos(θᵢ − θⱼ) = Re{(Σ
//! aⱼTⱼe^{iθⱼ}) (Σ aⱼe^{iθⱼ})*}. The product form of Newman's sum is exact, and its cost grows with the number of waves
//! and not with its square.

use fenderline_contact::Vec2;

use super::between::{Between, FineHeadings, FinePlace, MIRROR, MIRROR_DRIFT};
use super::data::Hydrodynamics;
use super::matrix::PLANE;
use super::matrix::Six;
use super::sub_steps::SubSteps;
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;
use fenderline_ship::environment::waves::{Complex, DriftHull, Sea};

/// Where the mean drift of a ship in waves comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriftSource<'d> {
    /// The hydrodynamic data.
    Data,
    /// The mean drift is the estimate of [`DriftHull`] about midship. The two numbers of the estimate are how far
    /// midship is forward of the centre of gravity (m), and the density of the water (kg/m³).
    Estimate(&'d DriftHull, f64, f64),
    /// The waves give no mean drift.
    Absent,
}

/// The forces of a sea on a ship with hydrodynamic data.
#[derive(Clone, Debug, PartialEq)]
pub struct WaveForces {
    waves: Vec<Wave>,
    /// Directions towards which the waves of the sea run (rad).
    directions_rad: Vec<f64>,
    headings: FineHeadings,
}

/// A wave of the sea, and the forces of this wave by heading.
#[derive(Clone, Debug, PartialEq)]
struct Wave {
    frequency_radps: f64,
    amplitude_m: f64,
    phase_rad: f64,
    number_radpm: Vec2,
    direction: usize,
    /// The square sin²(ωh/2).
    squared_sine: f64,
    /// Exciting force of the wave at the fine headings: the mean over a step, with the weights that the step gives to
    /// accelerations.
    excitation: Vec<[Complex; 6]>,
    /// Mean drift of the wave divided by its amplitude, at the fine headings (N/m, N/m, N).
    drift: Vec<[f64; 3]>,
}

/// Forces of the waves on a ship at a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WaveLoad {
    /// First-order exciting force of the waves about the centre of gravity.
    pub excitation: Six,
    /// Mean and slow drift about the centre of gravity: surge, sway, yaw.
    pub drift: [f64; 3],
}

impl WaveForces {
    /// Prepares the forces of a sea on a ship with the data, as means over a step (s).
    #[must_use]
    pub fn new(data: &Hydrodynamics, sea: &Sea, drift: DriftSource<'_>, step_s: f64) -> WaveForces {
        let between = Between::new(data);
        let estimate = match drift {
            DriftSource::Estimate(hull, ..) => Some(hull.at_directions(between.fine_headings())),
            DriftSource::Data | DriftSource::Absent => None,
        };
        let drift_of = |frequency_radps: f64, number_radpm: f64| match (drift, &estimate) {
            (DriftSource::Estimate(_, ahead_m, density), Some(estimate)) => {
                let scale = density * STANDARD_GRAVITY_MPS2;
                let about_gravity =
                    |[x, y, n]: [f64; 3]| [x, y, n + ahead_m * y].map(|of| scale * of);
                estimate(number_radpm).into_iter().map(about_gravity).collect()
            }
            // If the data have no drift, this is zero.
            _ => between.drift(frequency_radps),
        };
        let waves = sea.components().iter().map(|wave| {
            let theta = 0.5 * wave.frequency_radps * step_s;
            let sine = libm::sin(theta);
            let mean = if theta < 1e-6 { 1.0 } else { sine / theta };
            let scale = wave.amplitude_m * mean * mean;
            let mut excitation = between.excitation(wave.frequency_radps);
            for part in excitation.iter_mut().flatten() {
                *part = *part * scale;
            }
            let mut drift = drift_of(wave.frequency_radps, wave.number_radpm.length());
            for part in drift.iter_mut().flatten() {
                *part *= wave.amplitude_m;
            }
            Wave {
                frequency_radps: wave.frequency_radps,
                amplitude_m: wave.amplitude_m,
                phase_rad: wave.phase_rad,
                number_radpm: wave.number_radpm,
                direction: wave.direction,
                squared_sine: sine * sine,
                excitation,
                drift,
            }
        });
        WaveForces {
            waves: waves.collect(),
            directions_rad: sea.directions_rad().to_vec(),
            headings: between.headings,
        }
    }

    /// The forces of the waves on a ship whose centre of gravity has a place and which has a heading, in a step that
    /// begins at a time (s).
    pub fn at(&self, gravity_m: Vec2, heading_rad: f64, t_s: f64, sub_steps: SubSteps) -> WaveLoad {
        let t_s = t_s + sub_steps.ahead_s;
        let mut load = WaveLoad::default();
        let (mut with_drift, mut plain) = ([Complex::default(); 3], Complex::default());
        let mut known: Option<(usize, FinePlace)> = None;
        for wave in &self.waves {
            let place = match known {
                Some((direction, place)) if direction == wave.direction => place,
                _ => self.headings.place(self.directions_rad[wave.direction] - heading_rad),
            };
            known = Some((wave.direction, place));
            let angle =
                wave.frequency_radps * t_s - wave.number_radpm.dot(gravity_m) + wave.phase_rad;
            let (cos, sin) = (libm::cos(angle), libm::sin(angle));
            let gain = sub_steps.gain(wave.squared_sine);
            for (k, sum) in load.excitation.iter_mut().enumerate() {
                let re = place.of(&wave.excitation, MIRROR[k], |force| force[k].re);
                let im = place.of(&wave.excitation, MIRROR[k], |force| force[k].im);
                let gain = if PLANE.contains(&k) { gain } else { 1.0 };
                *sum += gain * (re * cos - im * sin);
            }
            for (k, sum) in with_drift.iter_mut().enumerate() {
                let force = place.of(&wave.drift, MIRROR_DRIFT[k], |drift| drift[k]);
                *sum = *sum + Complex::new(force * cos, force * sin);
            }
            plain = plain + Complex::new(wave.amplitude_m * cos, wave.amplitude_m * sin);
        }
        load.drift = with_drift.map(|sum| sum.re * plain.re + sum.im * plain.im);
        load
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reference is Newman's double sum over all pairs of waves, term by term.
    #[test]
    fn slow_drift_is_the_double_sum_over_pairs_of_waves() {
        let headings = FineHeadings { is_mirrored: true };
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
                    excitation: vec![[Complex::default(); 6]; 124],
                    drift: vec![drift.map(|of| of * amplitude_m); 124],
                }
            })
            .collect();
        let sea = WaveForces { waves, directions_rad: vec![0.3], headings };
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
}
