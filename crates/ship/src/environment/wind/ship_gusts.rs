//! Gusts averaged over one ship, for many times.
//!
//! The share of each harmonic in the mean over the ship's front ([`WindFront::share`]) depends on the width that she
//! turns to the wind. The shares of the harmonics are computed once for a series of widths, each wider than the last by
//! the same factor. For a width between two of the series, Lagrange's polynomial through the six nearest widths gives
//! the share: a step then takes a third of the time of the exact formula. The error of an interpolated share is below
//! 3e-11. The tables of shares are constant, so gusts depend only on width and time, not on earlier calls.

use std::sync::Arc;

use super::admittance::WindFront;
use super::gust::Gusts;
use super::lanes::{self, Lanes};
use super::windage::ShipWindage;

/// Number of widths in the tables for each factor of e (2.718) between them.
const WIDTHS: f64 = 24.0;
/// Number of widths through which an interpolating polynomial goes. `BELOW` of these widths are below the two nearest
/// widths.
const POINTS: usize = 6;
const BELOW: usize = POINTS / 2 - 1;

/// Gusts over one ship. Copies share their tables.
#[derive(Clone, Debug)]
pub struct ShipGusts(Arc<Tables>);

#[derive(Debug)]
struct Tables {
    gusts: Gusts,
    /// Natural logarithm of the least width (m) that the ship turns to the wind.
    least: f64,
    /// Amplitudes of the harmonics over fronts of each width, the narrowest first; none if gusts act on the whole ship
    /// at once.
    amplitudes: Vec<Vec<Lanes>>,
}

impl ShipGusts {
    /// Gusts over a ship.
    #[must_use]
    pub fn new(gusts: &Gusts, ship: &ShipWindage) -> ShipGusts {
        let [least_m, most_m] = ship.widths_m();
        let least = libm::log(least_m);
        let steps = WIDTHS * (libm::log(most_m) - least);
        let count = if gusts.is_uniform { 0 } else { libm::ceil(steps) as usize + POINTS };
        let amplitudes_of = |index: usize| {
            let width_m = libm::exp(least + (index as f64 - BELOW as f64) / WIDTHS);
            let scales_s = WindFront { width_m, ..ship.front(0.0) }.scales_s(gusts.mean_mps);
            gusts.groups.iter().map(|group| group.reduced(scales_s)).collect()
        };
        let amplitudes = (0..count).map(amplitudes_of).collect();
        ShipGusts(Arc::new(Tables { gusts: gusts.clone(), least, amplitudes }))
    }

    /// True if these gusts over a ship were made from the given gusts at a point.
    #[must_use]
    pub fn are_of(&self, gusts: &Gusts) -> bool {
        self.0.gusts == *gusts
    }

    /// Difference of the wind speed from its mean at a time, averaged over a front of the ship (m/s), as by
    /// [`Gusts::speed_over_mps`].
    #[must_use]
    pub fn speed_over_mps(&self, front: &WindFront, t_s: f64) -> f64 {
        let Tables { gusts, least, amplitudes } = &*self.0;
        if gusts.is_uniform {
            return gusts.speed_mps(t_s);
        }
        let place = WIDTHS * (libm::log(front.width_m) - least);
        let last = amplitudes.len() - POINTS;
        let first = (place as usize).min(last);
        let tables = core::array::from_fn(|k| amplitudes[first + k].as_slice());
        lanes::sum_between(&gusts.groups, tables, weights(place - first as f64), t_s)
    }
}

/// Weights of the points −2, −1, … 3 in Lagrange's polynomial at a place between the points 0 and 1. The place between
/// the two nearest widths is from 0 to 1, apart from rounding.
fn weights(place: f64) -> [f64; POINTS] {
    core::array::from_fn(|own| {
        let (mut product, mut scale) = (1.0, 1.0);
        for other in (0..POINTS).filter(|&other| other != own) {
            product *= place + BELOW as f64 - other as f64;
            scale *= own as f64 - other as f64;
        }
        product / scale
    })
}

#[cfg(test)]
mod tests {
    use super::super::{Blendermann, GustSpectrum, MeanWind, Realisation, WindMethod, WindProfile};
    use super::*;

    fn ship(length_m: f64, beam_m: f64) -> ShipWindage {
        ShipWindage {
            length_m,
            beam_m,
            frontal_m2: 20.0 * beam_m,
            lateral_m2: 17.0 * length_m,
            centroid_forward_m: 0.0,
            centroid_height_m: 8.0,
            method: WindMethod::Blendermann(Blendermann::of_type("tanker, loaded").unwrap()),
        }
    }

    fn gusts(harmonics: usize, speed_mps: f64) -> Gusts {
        let mean = MeanWind { speed_mps, from_rad: 0.3, profile: WindProfile::Uniform };
        Gusts::new(&mean, &GustSpectrum::Npd, Realisation { harmonics, seed: 5 }).unwrap()
    }

    /// The exact sum of `lanes::sum_over` is the reference. Each share is within 3e-11. The errors of neighbouring
    /// shares have the same sign and add up; 200 amplitudes add up to at most some ten times their deviation.
    #[test]
    fn gusts_over_a_ship_are_those_of_the_exact_shares_at_every_heading() {
        for (length_m, beam_m) in
            [(298.0, 46.0), (32.0, 11.0), (90.0, 90.0), (8.0, 20.0), (2000.0, 0.05)]
        {
            let ship = ship(length_m, beam_m);
            for (harmonics, speed_mps) in [(200, 12.0), (7, 30.0), (200, 0.5)] {
                let gusts = gusts(harmonics, speed_mps);
                let over = ShipGusts::new(&gusts, &ship);
                for step in 0..1000 {
                    let angle_rad = -3.5 + 0.007 * f64::from(step);
                    let (front, t_s) = (ship.front(angle_rad), 3.7 * f64::from(step));
                    let off = over.speed_over_mps(&front, t_s) - gusts.speed_over_mps(&front, t_s);
                    assert!(
                        off.abs() < 1e-10 * gusts.deviation_mps(),
                        "{angle_rad} rad: {off} m/s"
                    );
                }
            }
        }
    }

    #[test]
    fn uniform_gusts_and_a_calm_are_exact() {
        let ship = ship(200.0, 30.0);
        let uniform = gusts(50, 10.0).uniform();
        let front = ship.front(1.0);
        let over = ShipGusts::new(&uniform, &ship);
        assert_eq!(over.speed_over_mps(&front, 60.0), uniform.speed_mps(60.0));
        assert_eq!(ShipGusts::new(&gusts(50, 0.0), &ship).speed_over_mps(&front, 60.0), 0.0);
    }
}
