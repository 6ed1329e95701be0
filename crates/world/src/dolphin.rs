//! Flexible dolphins: bodies on piles that bend under a ship, in series with their fenders.

mod run;

use fenderline_contact::{Pile, Vec2};

pub use self::run::{DolphinMotion, DolphinSummary, Dolphins};

/// A flexible dolphin: a pile, and the mass on the pile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DolphinSetup {
    /// Mass that moves with the dolphin's head (kg): the head, and the share of the pile that moves in the first mode.
    pub mass_kg: f64,
    /// Horizontal stiffness of the dolphin at the fender's height, equal in all directions (N/m).
    pub stiffness_npm: f64,
    /// Damping of the dolphin divided by its critical damping.
    pub damping_ratio: f64,
    /// Load at the fender's height at which the pile yields (N), if known.
    pub yield_load_n: Option<f64>,
}

impl DolphinSetup {
    /// Natural angular frequency of the dolphin without damping and without a ship (rad/s).
    #[must_use]
    pub fn rate_radps(&self) -> f64 {
        libm::sqrt(self.stiffness_npm / self.mass_kg)
    }

    /// Natural period of the dolphin without damping and without a ship: 2π √(m/K) (s).
    #[must_use]
    pub fn period_s(&self) -> f64 {
        core::f64::consts::TAU / self.rate_radps()
    }

    /// The pile of this dolphin at the place `place_m`, for the contact engine.
    pub fn pile(&self, place_m: Vec2) -> Pile {
        Pile {
            place_m,
            stiffness_npm: self.stiffness_npm,
            damping_nspm: 2.0 * self.damping_ratio * self.mass_kg * self.rate_radps(),
            yield_n: self.yield_load_n.unwrap_or(f64::INFINITY),
        }
    }
}

/// Tubular steel piles that stand upright and are fixed in the ground: beams of constant section, clamped at the point
/// of fixity. All piles of a dolphin bend equally.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteelPiles {
    /// Number of piles.
    pub number: u32,
    /// Outer diameter (m).
    pub diameter_m: f64,
    /// Wall thickness (m).
    pub wall_m: f64,
    /// Length of the piles from the point of fixity to the height of the fender (m).
    pub length_m: f64,
    /// Young's modulus (N/m²).
    pub modulus_npm2: f64,
    /// Yield stress (N/m²).
    pub yield_stress_npm2: Option<f64>,
}

impl SteelPiles {
    /// Density of steel (kg/m³).
    const STEEL_KGPM3: f64 = 7850.0;

    /// Share of a clamped beam's mass μL that acts at its free end in the first mode. With ω₁ = β² √(EI/μ)/L², 1 + cos
    /// β cosh β = 0, and K = 3EI/L³, this share is K/(μ L ω₁²) = 3/β⁴. With a heavy head the share of the beam's mass
    /// tends to 33/140 = 0.236, the value for the static deflection.
    const FIRST_MODE: f64 = 0.242_672;

    /// Stiffness K = 3EI/L³ of all piles together (N/m).
    #[must_use]
    pub fn stiffness_npm(&self) -> f64 {
        let bending_nm2 = self.modulus_npm2 * self.inertia_m4();
        let cube_m3 = self.length_m * self.length_m * self.length_m;
        f64::from(self.number) * 3.0 * bending_nm2 / cube_m3
    }

    /// Mass of the part of the piles' steel that moves with the head (kg). The mass of the water in and around the
    /// piles is not included.
    #[must_use]
    pub fn moving_mass_kg(&self) -> f64 {
        let [outer_m, inner_m] = self.diameters_m();
        let area_m2 = 0.25 * core::f64::consts::PI * (outer_m * outer_m - inner_m * inner_m);
        let steel_kg = SteelPiles::STEEL_KGPM3 * area_m2 * self.length_m;
        f64::from(self.number) * SteelPiles::FIRST_MODE * steel_kg
    }

    /// The load at which the outermost fibre at the point of fixity yields: F L = f_y I/(D/2) (N).
    #[must_use]
    pub fn yield_load_n(&self) -> Option<f64> {
        let section_m3 = self.inertia_m4() / (0.5 * self.diameter_m);
        let of_stress = |stress_npm2: f64| stress_npm2 * section_m3 / self.length_m;
        Some(f64::from(self.number) * of_stress(self.yield_stress_npm2?))
    }

    fn diameters_m(&self) -> [f64; 2] {
        [self.diameter_m, self.diameter_m - 2.0 * self.wall_m]
    }

    /// Second moment of area of one pile (m⁴).
    fn inertia_m4(&self) -> f64 {
        let [outer, inner] = self.diameters_m().map(|diameter_m| {
            let square_m2 = diameter_m * diameter_m;
            square_m2 * square_m2
        });
        core::f64::consts::PI / 64.0 * (outer - inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first root of 1 + cos β cosh β = 0, by bisection.
    #[test]
    fn the_first_mode_is_that_of_a_clamped_beam() {
        let (mut low, mut high) = (1.0, 3.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let is_before = 1.0 + libm::cos(middle) * libm::cosh(middle) > 0.0;
            if is_before { low = middle } else { high = middle }
        }
        let square: f64 = low * low;
        let share = 3.0 / (square * square);
        assert!((SteelPiles::FIRST_MODE / share - 1.0).abs() < 1e-5, "{share}");
    }

    /// A monopile of 2.5 m diameter and 40 mm wall, 25 m long, E = 210 GPa, yield stress 420 MPa. By hand: I = π/64
    /// (2.5⁴ − 2.42⁴) = 0.233905 m⁴, K = 3EI/L³ = 9.4311 MN/m, A = 0.309133 m², ρ A L = 60.667 t, of which 0.24267, W =
    /// 0.187124 m³, f_y W/L = 3.1437 MN.
    #[test]
    fn a_monopile_is_a_cantilever() {
        let pile = SteelPiles {
            number: 1,
            diameter_m: 2.5,
            wall_m: 0.04,
            length_m: 25.0,
            modulus_npm2: 210e9,
            yield_stress_npm2: Some(420e6),
        };
        let close =
            |got: f64, wanted: f64| assert!((got / wanted - 1.0).abs() < 1e-5, "{got} {wanted}");
        close(pile.stiffness_npm(), 9.43106e6);
        close(pile.moving_mass_kg(), 0.242_672 * 60_667.3);
        close(pile.yield_load_n().unwrap(), 3.14369e6);
        let four = SteelPiles { number: 4, ..pile };
        close(four.stiffness_npm(), 4.0 * pile.stiffness_npm());
        close(four.yield_load_n().unwrap(), 4.0 * 3.14369e6);
    }
}
