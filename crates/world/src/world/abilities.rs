//! What a ship can do: constants that the ship's pilots use.

use fenderline_contact::number::{greater, lesser};
use fenderline_ship::hydro::{Controls, Velocity, Water};

use super::azimuth::AzimuthSetup;
use super::vessel::{VesselSetup, mass_matrix};

/// Constants of a ship that the ship's pilots use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Abilities {
    /// Force at rest at full revolutions astern (negative) and ahead (N).
    pub(super) bollard_n: [f64; 2],
    /// Speed at full revolutions ahead (m/s).
    pub(super) full_speed_mps: f64,
    /// Mass in surge and sway and inertia in yaw, with added mass (kg, kg, kg·m²).
    pub(super) inertia: [f64; 3],
}

impl Abilities {
    pub(super) fn of(setup: &VesselSetup, water: Water) -> Abilities {
        let surge_n = |surge_mps: f64, shaft_rps: f64| {
            let velocity = Velocity { surge_mps, ..Velocity::default() };
            let controls = Controls { shaft_rps, rudder_rad: 0.0 };
            setup.ship.forces(&velocity, &controls, water).surge_n
        };
        let azimuths_n = |surge_mps: f64| -> f64 {
            let velocity = Velocity { surge_mps, ..Velocity::default() };
            let full = |a: &AzimuthSetup| {
                let full_rps = a.unit.revolutions_for(a.bollard_n, water);
                a.unit.force(full_rps, 0.0, &velocity, water).surge_n
            };
            setup.azimuths.iter().map(full).sum()
        };
        let full_rps = setup.shaft.stop;
        // The balance of thrust and resistance, by bisection.
        let (mut low, mut high) = (0.0, 30.0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if surge_n(middle, full_rps) + azimuths_n(middle) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let matrix = mass_matrix(&setup.ship, water.density_kgpm3);
        Abilities {
            bollard_n: [surge_n(0.0, -full_rps), surge_n(0.0, full_rps)],
            full_speed_mps: high,
            inertia: [matrix[0][0], matrix[1][1], matrix[2][2]],
        }
    }

    /// Revolutions divided by full revolutions, for a force at rest: thrust is proportional to the square of the
    /// revolutions.
    pub(super) fn revolutions(&self, surge_n: f64) -> f64 {
        let [astern_n, ahead_n] = self.bollard_n;
        if surge_n >= 0.0 {
            lesser(libm::sqrt(surge_n / greater(ahead_n, 1.0)), 1.0)
        } else {
            -lesser(libm::sqrt(surge_n / lesser(astern_n, -1.0)), 1.0)
        }
    }
}
