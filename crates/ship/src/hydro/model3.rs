//! The equations of motion of a ship in three degrees of freedom, about midship, in water without current.
//!
//! The equations are (m + m_x)u̇ = X + m v r + x_G m r², (m + m_y)v̇ + x_G m ṙ = Y − m u r and (I_z + x_G² m + J_z)ṙ +
//! x_G m v̇ = N − x_G m u r, with X, Y, N from [`Mmg::forces`]. The Coriolis terms of the added mass are contained in
//! X, Y and N of the equations of motion.

use super::mmg::Mmg;
use super::quantities::{Controls, Force, Velocity, Water};

/// Position, heading and velocity of a ship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// North coordinate of the ship's midship point (m).
    pub north_m: f64,
    /// East coordinate of the ship's midship point (m).
    pub east_m: f64,
    /// Heading of the ship, clockwise from north, not wrapped (rad).
    pub heading_rad: f64,
    /// Velocity of the ship, in her own axes.
    pub velocity: Velocity,
}

/// Accelerations of the ship in surge, sway and yaw.
type Acceleration = [f64; 3];
/// Rates of change of the six numbers of a [`Motion`], in the order of its fields.
type Rates = [f64; 6];

/// A manoeuvring model [`Mmg`] with its mass matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model3 {
    ship: Mmg,
    water: Water,
    mass_kg: f64,
    offset_kgm: f64,
    inverse_surge: f64,
    /// Inverse of the block of the mass matrix for sway v and yaw r: [vv, vr, rr].
    inverse: [f64; 3],
}

impl Model3 {
    /// Computes the mass matrix. The particulars of the model must have been checked.
    pub fn new(ship: Mmg, water: Water) -> Model3 {
        let density = water.density_kgpm3;
        let (hull, added) = (&ship.particulars, &ship.added_mass);
        let mass_kg = density * hull.volume_m3;
        let offset_kgm = mass_kg * hull.centre_of_gravity_m;
        let sway_kg = mass_kg + density * added.sway_m3;
        let yaw_kgm2 = density * (hull.yaw_inertia_m5() + added.yaw_m5)
            + offset_kgm * hull.centre_of_gravity_m;
        let determinant = sway_kg * yaw_kgm2 - offset_kgm * offset_kgm;
        Model3 {
            ship,
            water,
            mass_kg,
            offset_kgm,
            inverse_surge: 1.0 / (mass_kg + density * added.surge_m3),
            inverse: [yaw_kgm2 / determinant, -offset_kgm / determinant, sway_kg / determinant],
        }
    }

    /// The manoeuvring model.
    pub fn ship(&self) -> &Mmg {
        &self.ship
    }

    /// The water.
    pub fn water(&self) -> Water {
        self.water
    }

    /// Takes one step of semi-implicit Euler: first the velocities, then the position with the new velocities.
    pub fn semi_implicit(
        &self,
        motion: &Motion,
        controls: &Controls,
        other: Force,
        step_s: f64,
    ) -> Motion {
        let [du, dv, dr] = self.acceleration(&motion.velocity, controls, other);
        let velocity = Velocity {
            surge_mps: motion.velocity.surge_mps + du * step_s,
            sway_mps: motion.velocity.sway_mps + dv * step_s,
            yaw_radps: motion.velocity.yaw_radps + dr * step_s,
        };
        let [north_mps, east_mps] = over_ground(motion.heading_rad, &velocity);
        Motion {
            north_m: motion.north_m + north_mps * step_s,
            east_m: motion.east_m + east_mps * step_s,
            heading_rad: motion.heading_rad + velocity.yaw_radps * step_s,
            velocity,
        }
    }

    /// Takes one step of classical Runge–Kutta, with controls and other forces constant over the step.
    pub fn runge_kutta(
        &self,
        motion: &Motion,
        controls: &Controls,
        other: Force,
        step_s: f64,
    ) -> Motion {
        let one = self.rates(motion, controls, other);
        let two = self.rates(&moved(motion, &one, 0.5 * step_s), controls, other);
        let three = self.rates(&moved(motion, &two, 0.5 * step_s), controls, other);
        let four = self.rates(&moved(motion, &three, step_s), controls, other);
        let mean =
            std::array::from_fn(|i| (one[i] + 2.0 * (two[i] + three[i]) + four[i]) * (1.0 / 6.0));
        moved(motion, &mean, step_s)
    }

    /// Accelerations (m/s², m/s², rad/s²) under the ship's own hydrodynamic forces and other forces at midship.
    pub fn acceleration(
        &self,
        velocity: &Velocity,
        controls: &Controls,
        other: Force,
    ) -> Acceleration {
        let force = self.ship.forces(velocity, controls, self.water) + other;
        let Velocity { surge_mps: u, sway_mps: v, yaw_radps: r } = *velocity;
        let surge_n = force.surge_n + (self.mass_kg * v + self.offset_kgm * r) * r;
        let sway_n = force.sway_n - self.mass_kg * u * r;
        let yaw_nm = force.yaw_nm - self.offset_kgm * u * r;
        let [vv, vr, rr] = self.inverse;
        [surge_n * self.inverse_surge, vv * sway_n + vr * yaw_nm, vr * sway_n + rr * yaw_nm]
    }

    /// Kinetic energy of the ship and her added mass (J).
    pub fn kinetic_j(&self, velocity: &Velocity) -> f64 {
        let Velocity { surge_mps: u, sway_mps: v, yaw_radps: r } = *velocity;
        let [vv, vr, rr] = self.inverse;
        let determinant = vv * rr - vr * vr;
        let (sway_kg, cross_kgm, yaw_kgm2) =
            (rr / determinant, -vr / determinant, vv / determinant);
        0.5 * (u * u / self.inverse_surge
            + sway_kg * v * v
            + 2.0 * cross_kgm * v * r
            + yaw_kgm2 * r * r)
    }

    fn rates(&self, motion: &Motion, controls: &Controls, other: Force) -> Rates {
        let [north, east] = over_ground(motion.heading_rad, &motion.velocity);
        let [du, dv, dr] = self.acceleration(&motion.velocity, controls, other);
        [north, east, motion.velocity.yaw_radps, du, dv, dr]
    }
}

/// Velocity of the ship's midship point towards north and east (m/s).
fn over_ground(heading_rad: f64, velocity: &Velocity) -> [f64; 2] {
    let (sin, cos) = libm::sincos(heading_rad);
    [
        velocity.surge_mps * cos - velocity.sway_mps * sin,
        velocity.surge_mps * sin + velocity.sway_mps * cos,
    ]
}

fn moved(motion: &Motion, rates: &Rates, step_s: f64) -> Motion {
    Motion {
        north_m: motion.north_m + rates[0] * step_s,
        east_m: motion.east_m + rates[1] * step_s,
        heading_rad: motion.heading_rad + rates[2] * step_s,
        velocity: Velocity {
            surge_mps: motion.velocity.surge_mps + rates[3] * step_s,
            sway_mps: motion.velocity.sway_mps + rates[4] * step_s,
            yaw_radps: motion.velocity.yaw_radps + rates[5] * step_s,
        },
    }
}
