//! Bank effect: the force of a vertical bank on a ship under way, by Norrbin's formulas. Not validated. The other
//! method for bank effect, the ship's mirror image in a flow about slender ships, is in [`crate::passing`]. No whole set
//! of published formulas for banks of any shape was found: Lataire and Vantorre's coefficients are not in what we could
//! read. Banks of any shape are therefore brought to vertical walls, and the walls act by one of the two methods.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{Rotation, Vec2, vec2};

use super::error::EnvironmentError;
use crate::range::within;

/// A straight vertical bank from one point to another, north and east (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bank {
    from_m: Vec2,
    to_m: Vec2,
    method: BankMethod,
}

/// The method by which the force of a bank is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BankMethod {
    /// By Norrbin's formulas: [`Bank::force`].
    #[default]
    Norrbin,
    /// The force is computed by the mirror image of the ship behind the bank: [`crate::passing::force_of_wall`].
    Image,
}

/// Data of a ship beside a bank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShipAtBank {
    /// Length of the ship (m).
    pub length_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Draught (m).
    pub draught_m: f64,
    /// Position of the ship's midship point, north and east (m).
    pub position_m: Vec2,
    /// Heading (rad).
    pub heading_rad: f64,
    /// Speed of the ship ahead through the water (m/s).
    pub surge_mps: f64,
}

/// The water between a ship and a bank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BankWater {
    /// Density (kg/m³).
    pub density_kgpm3: f64,
    /// Depth of the water (m); `None` means deep water.
    pub depth_m: Option<f64>,
}

impl Bank {
    /// Makes a bank between two points (m).
    ///
    /// # Errors
    /// Fails if the points are not finite, or less than a metre apart.
    pub fn new(from_m: Vec2, to_m: Vec2, method: BankMethod) -> Result<Bank, EnvironmentError> {
        for value in [from_m.x, from_m.y, to_m.x, to_m.y] {
            within("position of a bank [m]", value, -1e8, 1e8)?;
        }
        within("length of a bank [m]", (to_m - from_m).length(), 1.0, 1e9)?;
        Ok(Bank { from_m, to_m, method })
    }

    /// The two ends of the bank (m).
    #[must_use]
    pub fn ends_m(&self) -> [Vec2; 2] {
        [self.from_m, self.to_m]
    }

    /// The method by which the force of this bank is computed.
    #[must_use]
    pub fn method(&self) -> BankMethod {
        self.method
    }

    /// Force and moment of a bank about midship by Norrbin's formulas, [X, Y, N] in (N, N, N·m). The forces of a bank
    /// are suction towards the bank and, for a ship going ahead, a moment that turns the bow away from the bank. NOT
    /// VALIDATED.
    ///
    /// Norrbin's formulas (1974), for a vertical bank to starboard, are Y = ½ρu²BT·(B/y)(0.0925 + 0.372(T/h)²) and N =
    /// −½ρu²BTL·(B/y)(0.0025 + 0.0755(T/h)²); we give them from memory, because the source could not be read. y is the
    /// distance of midship from the line of the bank, at least half a beam. Our additions to Norrbin's formulas: u is
    /// the component of the ship's speed along the bank, N changes its sign astern, and both Y and N are proportional
    /// to the share of her length that is abreast of the bank.
    #[must_use]
    pub fn force(&self, ship: &ShipAtBank, water: &BankWater) -> [f64; 3] {
        let length_m = (self.to_m - self.from_m).length();
        let along = (self.to_m - self.from_m) * (1.0 / length_m);
        let ahead = Rotation::from_angle(ship.heading_rad).apply(vec2(1.0, 0.0));
        let offset_m = ship.position_m - self.from_m;
        let cos = along.dot(ahead);
        let (at_m, half_m) = (along.dot(offset_m), 0.5 * ship.length_m * cos.abs());
        let abreast_m = lesser(at_m + half_m, length_m) - greater(at_m - half_m, 0.0);
        let share = greater(abreast_m / ship.length_m, 0.0);
        // Positive if the bank is to starboard. The vector from the ship to the line is minus the ship's offset from
        // the line.
        let across_m = -along.cross(offset_m);
        // The sign of the side changes continuously across the line of the bank.
        let half_beam_m = 0.5 * ship.beam_m;
        let side = bounded(across_m * cos.signum() / half_beam_m, -1.0, 1.0);
        let distance_m = greater(across_m.abs(), half_beam_m);
        let along_mps = ship.surge_mps * cos.abs();
        let [suction_n, turning_n] =
            norrbin(ship, water, ship.beam_m / distance_m, share, along_mps);
        [0.0, side * suction_n, -side * turning_n * ship.length_m]
    }
}

impl ShipAtBank {
    /// Force and moment of two vertical walls along the ship, [X, Y, N] in (N, N, N·m), by the formulas of
    /// [`Bank::force`]: a wall to port and a wall to starboard, each as long as the ship. `per_m` has one over the
    /// distance of each wall from her axis (1/m), 0 without a wall; a wall is at least half a beam off. NOT VALIDATED.
    #[must_use]
    pub fn between_walls(&self, per_m: [f64; 2], water: &BankWater) -> [f64; 3] {
        let of_wall = |per_m: f64| {
            let near = bounded(self.beam_m * per_m, 0.0, 2.0);
            norrbin(self, water, near, 1.0, self.surge_mps)
        };
        let [port, starboard] = per_m.map(of_wall);
        [0.0, starboard[0] - port[0], (port[1] - starboard[1]) * self.length_m]
    }
}

/// Suction (N), and the turning moment over the ship's length (N), of a vertical bank by Norrbin. `near` is the beam over
/// the distance of the bank from midship, `share` the share of her length that is abreast of the bank.
fn norrbin(
    ship: &ShipAtBank,
    water: &BankWater,
    near: f64,
    share: f64,
    along_mps: f64,
) -> [f64; 2] {
    let ratio = water.depth_m.map_or(0.0, |depth_m| bounded(ship.draught_m / depth_m, 0.0, 1.0));
    let section_m2 = ship.beam_m * ship.draught_m;
    let unit_n = 0.5 * water.density_kgpm3 * section_m2 * near * share;
    [
        unit_n * along_mps * along_mps * (0.0925 + 0.372 * ratio * ratio),
        unit_n * along_mps * along_mps.abs() * (0.0025 + 0.0755 * ratio * ratio),
    ]
}
