//! Finds the waves of a sea that hydrodynamic data do not resolve: the headings or the frequencies of the data are too
//! far apart, or the frequencies end too early.
//!
//! The force of a wave has phases of ±½kL at bow and stern (k wave number, L length of the ship). From one heading to
//! the next the phases at bow and stern turn by up to ½kLΔμ, from one frequency to the next by ½LΔk. The interpolation
//! in `super::between` can follow the phases up to kLΔμ = 4 and LΔk = 2.5. Data with headings all round may be for a
//! ship at a wall, whose image makes the hull wider; their phases are followed up to kLΔμ = 3. In tests with headings
//! thinned to every 12 degrees, free motions began to differ by more than 2 % from panel runs at the exact heading at a
//! kLΔμ of 4.1 for the ship in 20 m of water, and of 3.1 for the barge at a quay.

use fenderline_contact::number::greater;

use super::between::widest_step;
use super::data::Hydrodynamics;
use fenderline_ship::environment::waves::Sea;

/// The largest step of phases kLΔμ between headings that is resolved, for headings from 0 to 180 degrees, and for
/// headings all round.
const HEADINGS: [f64; 2] = [4.0, 3.0];
/// The largest step of phases LΔk between frequencies that is resolved.
const FREQUENCIES: f64 = 2.5;

/// Shares of a sea's energy, from 0 to 1, in waves that data do not resolve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Unresolved {
    /// Share of the energy in waves within the frequencies of the hydrodynamic data, for which the headings of the data
    /// are too far apart.
    pub by_headings: f64,
    /// Share of the energy in waves for which the headings of the data are fine enough, but the frequencies too far
    /// apart.
    pub by_frequencies: f64,
    /// Share of the energy in waves with frequencies below the first or above the last frequency of the data.
    pub beyond: f64,
}

impl Unresolved {
    /// The whole share of a sea's energy that the hydrodynamic data do not resolve: the sum of the three shares.
    #[must_use]
    pub fn sum(&self) -> f64 {
        self.by_headings + self.by_frequencies + self.beyond
    }
}

impl Hydrodynamics {
    /// The shares of a sea's energy that the data do not resolve, for a ship of the given length (m).
    #[must_use]
    pub fn unresolved(&self, sea: &Sea, length_m: f64) -> Unresolved {
        let most_radpm = self.resolved_number_radpm(length_m);
        let axis = &self.wave_frequencies_radps;
        let last = axis.len() - 1;
        let mut of = Unresolved::default();
        let mut all = 0.0;
        for wave in sea.components() {
            let w = wave.frequency_radps;
            let energy = wave.amplitude_m * wave.amplitude_m;
            all += energy;
            if w < axis[0] || w > axis[last] {
                of.beyond += energy;
                continue;
            }
            let above = axis.partition_point(|at| *at <= w).clamp(1, last);
            let number_step = self.wave_number(axis[above]) - self.wave_number(axis[above - 1]);
            if self.wave_number(w) > most_radpm {
                of.by_headings += energy;
            } else if axis[above - 1] != w && number_step * length_m > FREQUENCIES {
                of.by_frequencies += energy;
            }
        }
        let scale = if all > 0.0 { 1.0 / all } else { 0.0 };
        Unresolved {
            by_headings: of.by_headings * scale,
            by_frequencies: of.by_frequencies * scale,
            beyond: of.beyond * scale,
        }
    }

    /// The widest step between the headings of the data (rad).
    #[must_use]
    pub fn widest_heading_step_rad(&self) -> f64 {
        widest_step(&self.headings_rad, self.is_mirrored)
    }

    /// The largest wave number k for which the headings are fine enough (rad/m).
    fn resolved_number_radpm(&self, length_m: f64) -> f64 {
        let most = if self.is_mirrored { HEADINGS[0] } else { HEADINGS[1] };
        most / (length_m * self.widest_heading_step_rad())
    }

    /// The frequency of the shortest wave for which the headings are fine enough (rad/s), for a ship of the given
    /// length (m). The returned frequency is at most the last frequency of the data.
    #[must_use]
    pub fn resolved_to_radps(&self, length_m: f64) -> f64 {
        let most = self.resolved_number_radpm(length_m);
        let (mut low, mut high) =
            (0.0, self.wave_frequencies_radps.iter().copied().fold(0.0, greater));
        if self.wave_number(high) <= most {
            return high;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.wave_number(middle) <= most {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }
}
