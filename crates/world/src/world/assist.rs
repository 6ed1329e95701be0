//! Tugs that are vessels and assist a ship: their orders, and the task for their pilot in each step.

use core::fmt;

use fenderline_contact::number::{bounded, greater};
use fenderline_contact::{BodyState, Contact, Outline, Vec2, vec2};

use super::line::{LineEnd, Mooring, MooringSetup};
use crate::fender::FenderSetup;
use crate::setup::BodySetup;
use fenderline_ship::control::Task;

/// An order to a vessel to assist a ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assist {
    /// The job.
    pub job: Job,
    /// Her greatest speed relative to the ship (m/s).
    pub fastest_mps: f64,
}

/// The kinds of [`Assist`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Job {
    /// Keep a position relative to the ship.
    Follow {
        /// Index of the ship's body.
        ship: usize,
        /// Position of her centre of gravity in the ship's frame (m).
        at_m: Vec2,
        /// Her heading relative to the ship's (rad).
        heading_rad: f64,
    },
    /// Push with the bow.
    Push(PushJob),
    /// Pull on a line.
    Pull {
        /// Index of the line.
        line: usize,
        /// Direction of the pull from the ship's bow, positive to starboard (rad).
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
    /// Point of the ship's side in her frame (m).
    pub at_m: Vec2,
    /// Unit normal into the ship at that point, in her frame.
    pub inward: Vec2,
    /// Distance from the tug's centre of gravity to the tip of her bow with its fender (m).
    pub bow_m: f64,
    /// Force (N).
    pub force_n: f64,
}

/// Largest distance of an ordered point from the ship's outline (m).
const FARTHEST_OFF_M: f64 = 2.0;

/// The point of an order to push is not at the ship's side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotAtTheSide {
    /// Its distance from the outline (m).
    pub off_m: f64,
}

impl fmt::Display for NotAtTheSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let off_m = self.off_m;
        write!(
            f,
            "the point is {off_m:.1} m from the ship's outline, but must be within {FARTHEST_OFF_M} m"
        )
    }
}

impl std::error::Error for NotAtTheSide {}

impl PushJob {
    /// A push by a tug at the point of the ship's side nearest to `at_m`; both are indices of bodies.
    ///
    /// # Errors
    /// [`NotAtTheSide`] if that point is farther than 2 m.
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

/// The nearest point of an outline and the unit normal into the body there. The body is to the left of the direction from vertex
/// to vertex, as in all outlines of the engine.
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

/// Distance from a body's origin to its foremost point, with fenders that face ahead (m).
fn reach_ahead<'f>(outline: &Outline, fenders: impl Iterator<Item = &'f FenderSetup>) -> f64 {
    let (_, most) = outline.bounds();
    fenders
        .filter(|fender| libm::cos(fender.facing_rad) > 0.7)
        .map(|fender| fender.position_m.x + fender.projection_m)
        .fold(most.x, greater)
}

/// The state of a tug that assists: plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AssistPilot {
    /// The order.
    pub order: Assist,
    /// Normal contact force between her and the ship that she pushes, in the last step (N).
    pub contact_n: f64,
    /// Integral of the yaw control against the moment of the contact at her bow (N·m).
    pub steady_nm: f64,
}

impl AssistPilot {
    /// A pilot who carries out an order.
    pub fn new(order: Assist) -> AssistPilot {
        AssistPilot { order, contact_n: 0.0, steady_nm: 0.0 }
    }

    /// Stores the contact force between her and the ship after a step.
    pub fn store_contact(&mut self, own: usize, contacts: &[Contact]) {
        let Job::Push(push) = self.order.job else { return };
        let both = |contact: &&Contact| {
            let pair = [contact.body_1.0 as usize, contact.body_2.0 as usize];
            pair == [own, push.ship] || pair == [push.ship, own]
        };
        self.contact_n = contacts.iter().filter(both).map(|contact| contact.normal_force_n).sum();
    }

    /// Her task in a step.
    pub fn task(
        &self,
        own: usize,
        states: &[BodyState],
        lines: (&[MooringSetup], &[Mooring]),
    ) -> Task {
        let velocity_at = |body: usize, at_m: Vec2| {
            let state = &states[body];
            let arm_m = state.pose().rotation.apply(at_m);
            state.velocity_mps + arm_m.spun_by(state.yaw_rate_radps)
        };
        match self.order.job {
            Job::Follow { ship, at_m, heading_rad } => Task::Follow {
                place_m: states[ship].pose().apply(at_m),
                velocity_mps: velocity_at(ship, at_m),
                heading_rad: states[ship].heading_rad + heading_rad,
            },
            Job::Push(PushJob { ship, at_m, inward, bow_m, force_n }) => Task::Push {
                place_m: states[ship].pose().apply(at_m),
                velocity_mps: velocity_at(ship, at_m),
                inward: states[ship].pose().rotation.apply(inward),
                bow_m,
                force_n,
                contact_n: self.contact_n,
            },
            Job::Pull { line, direction_rad, force_n } => {
                let setup = &lines.0[line];
                let [(ship, at_m), (_, own_at_m)] = ends_for(setup, own);
                let direction = vec2(libm::cos(direction_rad), libm::sin(direction_rad));
                let place_m = states[ship].pose().apply(at_m);
                let span_m = (states[own].pose().apply(own_at_m) - place_m).length();
                let length_m = lines.1[line].line.as_ref().map_or(0.0, |(_, state)| state.length_m);
                Task::Pull {
                    place_m,
                    velocity_mps: velocity_at(ship, at_m),
                    outward: states[ship].pose().rotation.apply(direction),
                    over_bow: own_at_m.x >= 0.0,
                    slack_m: greater(length_m - span_m, 0.0),
                    force_n,
                    tension_n: lines.1[line].load.tension_n,
                }
            }
        }
    }
}

/// The two ends of a line, body and position in its frame: first the other body's, then a body's own.
fn ends_for(line: &MooringSetup, own: usize) -> [(usize, Vec2); 2] {
    let near = (line.ship, line.fairlead_m);
    match line.end {
        Some(LineEnd::OnBody { body, at_m, .. }) if body == own => [near, (body, at_m)],
        Some(LineEnd::OnBody { body, at_m, .. }) => [(body, at_m), near],
        Some(LineEnd::Fixed(_)) | None => unreachable!("a set-up with such an order is refused"),
    }
}
