//! Mean drift force of waves on a ship at rest, by frequency and heading.
//!
//! In a regular wave of amplitude a the drift force is ρga² times a length, and the moment ρga² times an area; this
//! length and this area are the [`DriftHull::coefficients`]. The coefficients have two parts.
//!
//! - The part *reflection*: reflected waves exert a radiation pressure on the ship's side. In waves that are short
//!   compared with the draught the force of reflection is ½ρga²∫sin²θ n dl along the exposed part of the waterline
//!   ([`waterline`]; Faltinsen, Minsaas, Liapis & Skjørdal, "Prediction of resistance and propulsion of a ship in a
//!   seaway", 13th Symposium on Naval Hydrodynamics, 1980). Of waves that are longer than the draught, only the part
//!   within the draught is reflected ([`depth`]).
//! - The part *motion*: heave and pitch radiate waves, most for waves about as long as the ship ([`motion`]).
//!
//! The drift force is smaller on a ship that moves with the waves, and larger on a ship that moves against them
//! ([`encountered`]).
//!
//! The file `validation/wave_drift.toml` compares the coefficients of this module with mean drift forces by a panel
//! code, for two ships.

mod depth;
mod hull;
mod motion;
mod waterline;

use fenderline_contact::Vec2;
use fenderline_contact::number::bounded;

use super::sea::Sea;
use crate::constants::STANDARD_GRAVITY_MPS2;
pub use hull::DriftHull;
use waterline::Waterline;

impl DriftHull {
    /// Mean drift force forward and to starboard, and moment about midship, each divided by ρga², in a regular wave of
    /// amplitude a, wave number k > 0 (rad/m) and direction μ relative to the bow (rad): [X, Y, N] in (m, m, m²).
    #[must_use]
    pub fn coefficients(&self, number_radpm: f64, direction_rad: f64) -> [f64; 3] {
        let reflected = Waterline::of(self).reflection(direction_rad);
        self.sum(&reflected, number_radpm, direction_rad)
    }

    /// Prepares [`DriftHull::coefficients`] at several directions, for any wave number. Those parts of the coefficients
    /// that do not depend on the wave number are computed once.
    pub fn at_directions(
        &self,
        directions_rad: impl Iterator<Item = f64>,
    ) -> impl Fn(f64) -> Vec<[f64; 3]> {
        let hull = *self;
        let waterline = Waterline::of(self);
        let reflected: Vec<(f64, [f64; 3])> = directions_rad
            .map(|direction_rad| (direction_rad, waterline.reflection(direction_rad)))
            .collect();
        move |number_radpm| {
            let of = |(direction_rad, reflected): &(f64, [f64; 3])| {
                hull.sum(reflected, number_radpm, *direction_rad)
            };
            reflected.iter().map(of).collect()
        }
    }

    /// The sum of the drift by reflection (with its draught factor) and the drift by motion. Reflection in surge and
    /// reflection in sway have different draught factors: see [`depth`].
    fn sum(&self, reflected: &[f64; 3], number_radpm: f64, direction_rad: f64) -> [f64; 3] {
        let along = depth::along(self, number_radpm);
        let across = depth::across(self.draught_m, number_radpm);
        let [surge_m, sway_m, yaw_m2] = *reflected;
        let motion_m = motion::surge_m(self, number_radpm, direction_rad);
        [along * surge_m + motion_m, across * sway_m, across * yaw_m2]
    }
}

/// The mean drift force of a sea on a hull, [X, Y, N] about midship in (N, N, N·m), for the ship's heading and her
/// velocity through the water, north and east (m/s). The drift force is ρg Σ a²·C(k, μ) over the sea's harmonics, where
/// C are the coefficients; this equals the integral of 2ρg S(ω)·C over the spectrum S.
#[must_use]
pub fn mean_drift(
    sea: &Sea,
    hull: &DriftHull,
    (heading_rad, velocity_mps): (f64, Vec2),
    water_density_kgpm3: f64,
) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (index, towards_rad) in sea.directions_rad.iter().enumerate() {
        let direction_rad = towards_rad - heading_rad;
        let reflected = Waterline::of(hull).reflection(direction_rad);
        for wave in sea.components.iter().filter(|wave| wave.direction == index) {
            let squared_m2 = wave.amplitude_m * wave.amplitude_m;
            let with_waves = wave.number_radpm.dot(velocity_mps) / wave.frequency_radps;
            let (number_radpm, share) = encountered(wave.number_radpm.length(), -with_waves);
            let coefficients = hull.sum(&reflected, number_radpm, direction_rad);
            for (sum, coefficient) in sum.iter_mut().zip(coefficients) {
                *sum += squared_m2 * share * coefficient;
            }
        }
    }
    sum.map(|sum| water_density_kgpm3 * STANDARD_GRAVITY_MPS2 * sum)
}

/// Correction of the drift force for a ship that moves against the wave with a share τ of its phase speed. The
/// correction for the ship's speed gives the wave number at the frequency of encounter ω(1 + τ), and the factor 1 + 4τ
/// on the force (Aranha, "A formula for 'wave damping' in the drift of a floating body", Journal of Fluid Mechanics
/// 275, 1994; from memory, and without Aranha's change of direction). Aranha's correction is of first order in τ, so τ
/// is limited to ±0.25; at −0.25 the force is zero.
fn encountered(number_radpm: f64, against: f64) -> (f64, f64) {
    let against = bounded(against, -0.25, 0.25);
    let ratio = 1.0 + against;
    (number_radpm * ratio * ratio, 1.0 + 4.0 * against)
}
