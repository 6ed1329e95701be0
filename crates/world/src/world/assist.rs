//! Tugs that are vessels and assist a ship: their orders, and the task of their pilot in each step.

use core::fmt;

use fenderline_contact::number::{bounded, greater};
use fenderline_contact::{Contact, Outline, Vec2};

use crate::fender::FenderSetup;
use crate::setup::body::BodySetup;

/// An order to a tug that is a vessel to assist a ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assist {
    /// The job.
    pub job: Job,
    /// The greatest speed of the tug relative to the ship (m/s).
    pub fastest_mps: f64,
}

/// The kinds of [`Assist`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Job {
    /// The tug keeps a position relative to the ship.
    Follow {
        /// Index of the ship's body.
        ship: usize,
        /// Position of the tug's centre of gravity in the ship's frame (m).
        at_m: Vec2,
        /// The tug's heading relative to the ship's heading (rad).
        heading_rad: f64,
    },
    /// Push with the bow.
    Push(PushJob),
    /// Pull on a line.
    Pull {
        /// Index of the line.
        line: usize,
        /// Direction of the pull, measured from the ship's bow, positive to starboard (rad).
        direction_rad: f64,
        /// Force (N).
        force_n: f64,
    },
}

/// Position and force of a push.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PushJob {
    /// Index of the ship's body.
    pub ship: usize,
    /// Point of the ship's side, in the ship's frame (m).
    pub at_m: Vec2,
    /// Unit normal at the point of the push, in the ship's frame; the normal points into the ship.
    pub inward: Vec2,
    /// Distance from the tug's centre of gravity to the tip of the tug's bow, bow fender included (m).
    pub bow_m: f64,
    /// Force (N).
    pub force_n: f64,
}

/// Largest distance from the ship's outline of the point that an order to push gives (m).
const FARTHEST_OFF_M: f64 = 2.0;

/// The point of an order to push is not at the ship's side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotAtTheSide {
    /// Distance of the point from the outline (m).
    pub off_m: f64,
}

impl fmt::Display for NotAtTheSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let off_m = self.off_m;
        write!(
            f,
            "the point to push at is {off_m:.1} m from the ship's outline, but must be within \
             {FARTHEST_OFF_M} m"
        )
    }
}

impl std::error::Error for NotAtTheSide {}

impl PushJob {
    /// A push by a tug at the point of the ship's side that is nearest to `at_m`. `tug` and `ship` are indices of
    /// bodies.
    ///
    /// # Errors
    /// Fails with [`NotAtTheSide`] if the nearest point of the side is more than 2 m from `at_m`.
    pub fn new(
        bodies: &[BodySetup],
        fenders: &[FenderSetup],
        tug: usize,
        (ship, at_m): (usize, Vec2),
        force_n: f64,
    ) -> Result<PushJob, NotAtTheSide> {
        let (place_m, inward) = nearest_side(&bodies[ship].outline, at_m);
        let off_m = (place_m - at_m).length();
        if off_m > FARTHEST_OFF_M {
            return Err(NotAtTheSide { off_m });
        }
        let bow_m = reach_ahead(&bodies[tug].outline, fenders.iter().filter(|f| f.body == tug));
        Ok(PushJob { ship, at_m: place_m, inward, bow_m, force_n })
    }
}

/// The point of an outline that is nearest to `at_m`, and the unit normal at this point, which points into the body.
/// The body is to the left of the direction from vertex to vertex, as in all outlines of the engine.
fn nearest_side(outline: &Outline, at_m: Vec2) -> (Vec2, Vec2) {
    let vertices = outline.vertices();
    let edges = vertices.iter().zip(vertices.iter().cycle().skip(1));
    let mut best = (f64::INFINITY, Vec2::ZERO, Vec2::ZERO);
    for (&from, &to) in edges {
        let along = to - from;
        let share = bounded((at_m - from).dot(along) / along.dot(along), 0.0, 1.0);
        let place = from + along * share;
        let off = (place - at_m).length();
        if off < best.0 {
            best = (off, place, along.quarter_turn() * (1.0 / along.length()));
        }
    }
    (best.1, best.2)
}

/// Distance from a body's origin to the body's foremost point, fenders that face ahead included (m).
fn reach_ahead<'f>(outline: &Outline, fenders: impl Iterator<Item = &'f FenderSetup>) -> f64 {
    let (_, most) = outline.bounds();
    fenders
        .filter(|fender| libm::cos(fender.facing_rad) > 0.7)
        .map(|fender| fender.position_m.x + fender.projection_m)
        .fold(most.x, greater)
}

/// The state of a tug that assists a ship, as plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AssistPilot {
    /// The order.
    pub order: Assist,
    /// Normal contact force between the tug and the ship that the tug pushes, in the last step (N).
    pub contact_n: f64,
    /// Integral part of the yaw control, which balances the moment of the contact at the tug's bow (N·m).
    pub steady_nm: f64,
}

impl AssistPilot {
    /// A pilot that carries out an order.
    pub fn new(order: Assist) -> AssistPilot {
        AssistPilot { order, contact_n: 0.0, steady_nm: 0.0 }
    }

    /// Stores the contact force between tug and ship after a step.
    pub fn store_contact(&mut self, own: usize, contacts: &[Contact]) {
        let Job::Push(push) = self.order.job else { return };
        let both = |contact: &&Contact| {
            let pair = [contact.body_1.0 as usize, contact.body_2.0 as usize];
            pair == [own, push.ship] || pair == [push.ship, own]
        };
        self.contact_n = contacts.iter().filter(both).map(|contact| contact.normal_force_n).sum();
    }
}
