//! Flexible dolphins: bodies on piles that bend under a ship, in series with their fenders.

use fenderline_contact::number::greater;
use fenderline_contact::{Model, Pile, PileMotion, Vec2};

use crate::setup::Setup;

/// What makes a body a flexible dolphin: its pile, and the mass on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DolphinSetup {
    /// Mass that moves with the head: the head itself, and the pile's share by its first mode (kg).
    pub mass_kg: f64,
    /// Horizontal stiffness at the fender's height, the same in all directions (N/m).
    pub stiffness_npm: f64,
    /// Damping over the critical damping.
    pub damping_ratio: f64,
    /// Load at the fender's height at which the pile yields (N).
    pub yield_load_n: Option<f64>,
}

impl DolphinSetup {
    /// ω without damping (rad/s).
    #[must_use]
    pub fn rate_radps(&self) -> f64 {
        libm::sqrt(self.stiffness_npm / self.mass_kg)
    }

    /// The period without damping and without a ship: 2π √(m/K) (s).
    #[must_use]
    pub fn period_s(&self) -> f64 {
        core::f64::consts::TAU / self.rate_radps()
    }

    /// The pile of a dolphin that stands here.
    pub fn pile(&self, place_m: Vec2) -> Pile {
        Pile {
            place_m,
            stiffness_npm: self.stiffness_npm,
            damping_nspm: 2.0 * self.damping_ratio * self.mass_kg * self.rate_radps(),
            yield_n: self.yield_load_n.unwrap_or(f64::INFINITY),
        }
    }
}

/// Tubular steel piles that stand upright and are fixed in the ground: beams of constant section, clamped at the point of
/// fixity. Several piles of one dolphin bend alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteelPiles {
    /// Number of piles.
    pub number: u32,
    /// Outer diameter (m).
    pub diameter_m: f64,
    /// Wall thickness (m).
    pub wall_m: f64,
    /// From the point of fixity to the height of the fender (m).
    pub length_m: f64,
    /// Young's modulus (N/m²).
    pub modulus_npm2: f64,
    /// Yield stress (N/m²).
    pub yield_stress_npm2: Option<f64>,
}

impl SteelPiles {
    /// Density of steel (kg/m³).
    const STEEL_KGPM3: f64 = 7850.0;

    /// Share of a clamped beam's mass μL that acts at its free end in the first mode. With ω₁ = β² √(EI/μ)/L², 1 + cos β cosh β
    /// = 0, and K = 3EI/L³ it is K/(μ L ω₁²) = 3/β⁴. With a heavy head it tends to 33/140 = 0.236, that of the static deflection.
    const FIRST_MODE: f64 = 0.242_672;

    /// K = 3EI/L³ of all piles (N/m).
    #[must_use]
    pub fn stiffness_npm(&self) -> f64 {
        let bending_nm2 = self.modulus_npm2 * self.inertia_m4();
        let cube_m3 = self.length_m * self.length_m * self.length_m;
        f64::from(self.number) * 3.0 * bending_nm2 / cube_m3
    }

    /// The part of the piles' steel that moves with the head (kg). Water in and around the piles is not in it.
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

/// The pile of a dolphin in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DolphinMotion {
    /// The dolphin: an index into [`Setup::bodies`].
    pub body: usize,
    /// What its pile did.
    pub pile: PileMotion,
}

/// What a dolphin's pile bore in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DolphinSummary {
    /// The dolphin: an index into [`Setup::bodies`].
    pub body: usize,
    /// Largest deflection of the head, permanent part included (m).
    pub peak_deflection_m: f64,
    /// Start of the step of it (s).
    pub peak_deflection_at_s: f64,
    /// Largest load on the pile (N).
    pub peak_load_n: f64,
    /// Start of the step of it (s).
    pub peak_load_at_s: f64,
    /// Largest energy in the pile's bending (J).
    pub peak_energy_j: f64,
    /// The largest load over the yield load, if that is known.
    pub share_of_yield_load: Option<f64>,
    /// Start of the first step in which it yielded (s).
    pub yielded_at_s: Option<f64>,
    /// Permanent deflection (m).
    pub offset_m: f64,
    /// Energy lost to yielding (J).
    pub yield_j: f64,
    /// Energy lost to damping (J).
    pub damping_j: f64,
}

/// The dolphins of a run: their last motions, and their summaries, in the order of the set-up.
#[derive(Clone, Debug, Default)]
pub struct Dolphins {
    /// For each dolphin, the number of its pile in the engine.
    piles: Vec<usize>,
    /// Their motions in the last step.
    pub motions: Vec<DolphinMotion>,
    /// What they did in the run.
    pub summaries: Vec<DolphinSummary>,
}

impl Dolphins {
    /// Before the first step. The engine has the piles in the order of its bodies' keys.
    pub fn new(setup: &Setup, model: &Model) -> Dolphins {
        let with_pile = |(body, of): (usize, &crate::setup::BodySetup)| of.dolphin.map(|_| body);
        let bodies: Vec<usize> = setup.bodies.iter().enumerate().filter_map(with_pile).collect();
        let key = |body: usize| model.bodies()[body].key;
        let piles = bodies
            .iter()
            .map(|&body| bodies.iter().filter(|&&other| key(other) < key(body)).count())
            .collect();
        let motion = |&body: &usize| DolphinMotion { body, pile: PileMotion::default() };
        Dolphins {
            piles,
            motions: bodies.iter().map(motion).collect(),
            summaries: bodies.iter().map(|&body| DolphinSummary::new(body)).collect(),
        }
    }

    /// Takes over a step of the engine.
    pub fn take(&mut self, piles: &[PileMotion]) {
        for (motion, &pile) in self.motions.iter_mut().zip(&self.piles) {
            motion.pile = piles[pile];
        }
    }

    /// Adds the last step to the summaries.
    pub fn summarise(&mut self, setup: &Setup, t_s: f64) {
        for (summary, motion) in self.summaries.iter_mut().zip(&self.motions) {
            let limit_n = setup.bodies[motion.body].dolphin.and_then(|of| of.yield_load_n);
            summary.add(&motion.pile, limit_n, t_s);
        }
    }
}

impl DolphinSummary {
    fn new(body: usize) -> DolphinSummary {
        DolphinSummary {
            body,
            peak_deflection_m: 0.0,
            peak_deflection_at_s: 0.0,
            peak_load_n: 0.0,
            peak_load_at_s: 0.0,
            peak_energy_j: 0.0,
            share_of_yield_load: None,
            yielded_at_s: None,
            offset_m: 0.0,
            yield_j: 0.0,
            damping_j: 0.0,
        }
    }

    fn add(&mut self, pile: &PileMotion, limit_n: Option<f64>, t_s: f64) {
        if pile.peak_deflection_m > self.peak_deflection_m {
            (self.peak_deflection_m, self.peak_deflection_at_s) = (pile.peak_deflection_m, t_s);
        }
        if pile.peak_load_n > self.peak_load_n {
            (self.peak_load_n, self.peak_load_at_s) = (pile.peak_load_n, t_s);
        }
        self.peak_energy_j = greater(self.peak_energy_j, pile.peak_stored_j);
        self.share_of_yield_load = limit_n.map(|limit_n| self.peak_load_n / limit_n);
        if pile.yield_j > 0.0 {
            self.yielded_at_s.get_or_insert(t_s);
        }
        self.offset_m = pile.offset_m.length();
        self.yield_j += pile.yield_j;
        self.damping_j += pile.damping_j;
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

    /// A monopile of 2.5 m by 40 mm, 25 m long, E = 210 GPa, 420 MPa. By hand: I = π/64 (2.5⁴ − 2.42⁴) = 0.233905 m⁴,
    /// K = 3EI/L³ = 9.4311 MN/m, A = 0.309133 m², ρ A L = 60.667 t, of which 0.24267, W = 0.187124 m³, f_y W/L = 3.1437 MN.
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
