//! Arrays of numbers that JavaScript sees without a copy.

use fenderline_contact::{BodyState, Contact, Friction, Vec2, Wrench};
use fenderline_live::message::FenderNow;

/// Names of the numbers of a body's state.
pub const STATE_FIELDS: [&str; 6] =
    ["north_m", "east_m", "heading_rad", "north_mps", "east_mps", "yaw_rate_radps"];
/// Names of the numbers of a wrench.
pub const WRENCH_FIELDS: [&str; 3] = ["north_n", "east_n", "moment_nm"];
/// Names of the numbers of a fender.
pub const FENDER_FIELDS: [&str; 9] = [
    "deflection_m",
    "reaction_n",
    "energy_j",
    "share_of_rated_energy",
    "share_of_rated_reaction",
    "peak_share_of_rated_energy",
    "peak_share_of_rated_reaction",
    "touched",
    "failed",
];
/// Names of the numbers of a contact.
pub const CONTACT_FIELDS: [&str; 12] = [
    "body_1",
    "body_2",
    "fender",
    "north_m",
    "east_m",
    "normal_north",
    "normal_east",
    "depth_m",
    "area_m2",
    "normal_force_n",
    "tangential_force_n",
    "slips",
];

/// Rows of numbers that lie one after the other in memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows(Vec<f64>);

impl Rows {
    /// Replaces the rows. The memory of the rows is kept if it is large enough.
    pub fn set<const N: usize>(&mut self, rows: impl Iterator<Item = [f64; N]>) {
        self.0.clear();
        rows.for_each(|row| self.0.extend_from_slice(&row));
    }

    /// Replaces the rows by zeros.
    pub fn set_zero(&mut self, length: usize) {
        self.0.clear();
        self.0.resize(length, 0.0);
    }

    /// The numbers.
    #[must_use]
    pub fn numbers(&self) -> &[f64] {
        &self.0
    }
}

/// Turns a body's state into numbers.
#[must_use]
pub fn of_state(state: &BodyState) -> [f64; 6] {
    let BodyState { position_m, heading_rad, velocity_mps, yaw_rate_radps } = *state;
    [position_m.x, position_m.y, heading_rad, velocity_mps.x, velocity_mps.y, yaw_rate_radps]
}

/// Makes a body's state from six numbers.
#[must_use]
pub fn state_of(row: &[f64]) -> BodyState {
    BodyState {
        position_m: Vec2 { x: row[0], y: row[1] },
        heading_rad: row[2],
        velocity_mps: Vec2 { x: row[3], y: row[4] },
        yaw_rate_radps: row[5],
    }
}

/// A wrench as numbers.
#[must_use]
pub fn of_wrench(wrench: &Wrench) -> [f64; 3] {
    [wrench.force_n.x, wrench.force_n.y, wrench.moment_nm]
}

/// Makes a wrench from three numbers.
#[must_use]
pub fn wrench_of(row: &[f64]) -> Wrench {
    Wrench { force_n: Vec2 { x: row[0], y: row[1] }, moment_nm: row[2] }
}

/// A fender as numbers.
#[must_use]
pub fn of_fender(now: &FenderNow) -> [f64; 9] {
    [
        now.deflection_m,
        now.reaction_n,
        now.energy_j,
        now.of_energy,
        now.of_reaction,
        now.peak_of_energy,
        now.peak_of_reaction,
        f64::from(u8::from(now.touched)),
        f64::from(u8::from(now.failed)),
    ]
}

/// Turns a contact into numbers; `fender` is -1 where hull meets hull.
#[must_use]
pub fn of_contact(contact: &Contact) -> [f64; 12] {
    [
        f64::from(contact.body_1.0),
        f64::from(contact.body_2.0),
        contact.fender.map_or(-1.0, |fender| f64::from(fender.0)),
        contact.point_m.x,
        contact.point_m.y,
        contact.normal.x,
        contact.normal.y,
        contact.depth_m,
        contact.area_m2,
        contact.normal_force_n,
        contact.tangential_force_n,
        f64::from(u8::from(contact.friction == Friction::Slip)),
    ]
}
