//! A hit of a ship on her fenders, and the energy that they absorb.

use fenderline_contact::number::{greater, lesser};

/// Energies of one step, summed over all fenders that the ship touches.
#[derive(Clone, Copy, Debug)]
pub(super) struct HitStep {
    /// Recoverable energy stored in the fenders at the end of the step (J).
    pub(super) stored_j: f64,
    /// Hysteresis loss in the fenders in the step (J).
    pub(super) hysteresis_j: f64,
    /// Energy to load each fender to its peak deflection in the step, summed over the fenders (J).
    pub(super) peak_absorbed_j: f64,
}

/// Follows one hit: from the rise of the stored energy until this energy is less than half of its maximum.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hit {
    /// Hysteresis loss in the fenders since the hit began (J).
    heat_j: f64,
    /// Largest energy stored in the fenders (J).
    most_stored_j: f64,
    /// Largest energy absorbed (J).
    pub(super) taken_j: f64,
}

impl Hit {
    /// Adds one step. Returns true if the fenders had absorbed more by this step than by any step before.
    pub(super) fn add(&mut self, step: HitStep) -> bool {
        self.heat_j += step.hysteresis_j;
        self.most_stored_j = greater(self.most_stored_j, step.stored_j);
        // The peaks of several fenders within a step need not coincide, so their sum is only an upper bound.
        let taken_j = lesser(step.stored_j + self.heat_j, step.peak_absorbed_j);
        let is_more = taken_j > self.taken_j;
        self.taken_j = greater(self.taken_j, taken_j);
        is_more
    }

    /// Returns true if the fenders have given back more than half of the stored energy.
    pub(super) fn is_over(&self, step: HitStep) -> bool {
        step.stored_j < 0.5 * self.most_stored_j
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A fender is compressed to 100 kJ on the loading curve, of which 60 kJ are recoverable, and released. By hand, 60
    /// + 40 = 100 kJ are absorbed, and the hit is over when less than 30 kJ are stored.
    #[test]
    fn a_hit_takes_what_is_stored_and_lost() {
        let mut hit = Hit::default();
        let step = |stored_j, hysteresis_j, peak_absorbed_j| HitStep {
            stored_j,
            hysteresis_j,
            peak_absorbed_j,
        };
        assert!(hit.add(step(30e3, 0.0, 30e3)));
        assert!(hit.add(step(100e3, 0.0, 100e3)));
        assert!(!hit.add(step(60e3, 40e3, 100e3)), "it turns back: what was stored is lost");
        assert!(!hit.is_over(step(60e3, 40e3, 100e3)));
        assert!(!hit.add(step(49e3, 5e3, 80e3)));
        assert!(hit.is_over(step(49e3, 5e3, 80e3)));
        assert_eq!(hit.taken_j, 100e3);
    }

    /// The heat of many small cycles is not energy of one hit: a hit absorbs no more than it takes to load the fender
    /// to its deflection.
    #[test]
    fn heat_of_many_cycles_does_not_add_up() {
        let mut hit = Hit::default();
        for _ in 0..1000 {
            hit.add(HitStep { stored_j: 60e3, hysteresis_j: 1e3, peak_absorbed_j: 70e3 });
        }
        assert_eq!(hit.taken_j, 70e3);
    }
}
