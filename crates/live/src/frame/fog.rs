//! Leaves out of a frame what fog hides from a person on board, who sees no farther than the visibility.

use fenderline_contact::{BodyState, Pose, Vec2};
use fenderline_sim::distance::to_edge_m;
use fenderline_sim::order::Word;
use fenderline_sim::{BodySetup, Fault, VesselSetup};

use crate::message::{Frame, Role};
use crate::session::Session;

impl Session {
    /// The frame as a person with the role `role` sees it. The frame is `None` if the fog hides nothing from the person
    /// and no instrument is frozen. The person's frame leaves out floating bodies beyond the visibility, with their
    /// contacts and distances. The instructor sees everything. Everybody sees the chart, the structures and the data of
    /// instruments and radio: the motion of the own ship, the berth, orders to tugs, lines. The pilot or master of a
    /// ship with frozen instruments gets what the instruments show, and her true motion for the view out of the window.
    /// Only the instructor is told that instruments are frozen.
    #[must_use]
    pub fn in_fog(&self, frame: &Frame, role: &Role) -> Option<Frame> {
        if *role == Role::Instructor {
            return None;
        }
        let mut seen = self.through_fog(frame, role);
        if let Some(vessel) = self.frozen_vessel(role) {
            self.freeze(vessel, seen.get_or_insert_with(|| frame.clone()));
        }
        let is_told = |faults: &[&str]| faults.iter().any(|fault| is_of_instrument(fault));
        if frame.vessels.iter().any(|vessel| is_told(&vessel.faults)) {
            let seen = seen.get_or_insert_with(|| frame.clone());
            for vessel in &mut seen.vessels {
                vessel.faults.retain(|fault| !is_of_instrument(fault));
            }
        }
        seen
    }

    /// The frame as a person with the role `role` sees it through fog. The frame is `None` if the fog hides nothing
    /// from the person.
    fn through_fog(&self, frame: &Frame, role: &Role) -> Option<Frame> {
        let view = self.view(role)?;
        let (hidden, traffic) = (self.hidden_bodies(&view), self.hidden_traffic(&view));
        if !hidden.contains(&true) && !traffic.contains(&true) {
            return None;
        }
        let setup = self.simulation().setup();
        let mut seen = frame.clone();
        let bodies = seen.bodies.iter_mut().zip(&hidden);
        for (ship, is_hidden) in bodies.chain(seen.traffic.iter_mut().zip(&traffic)) {
            if *is_hidden {
                *ship = None;
            }
        }
        seen.passages.retain(|passage| !traffic[passage.ship]);
        seen.contacts.retain(|contact| !contact.bodies.iter().any(|&body| hidden[body]));
        for (vessel, setup) in seen.vessels.iter_mut().zip(&setup.world.vessels) {
            if hidden[setup.body] {
                vessel.berth = None;
            }
        }
        Some(seen)
    }

    /// Indices of the vessels whose paths a person with the role `role` does not get: vessels that fog hides, and the
    /// person's own vessel if her instruments are frozen.
    #[must_use]
    pub fn hidden_vessels(&self, role: &Role) -> Vec<usize> {
        let frozen = self.frozen_vessel(role);
        let hidden = self.view(role).map(|view| self.hidden_bodies(&view));
        let vessels = self.simulation().setup().world.vessels.iter().enumerate();
        let is_hidden = |(index, vessel): &(usize, &VesselSetup)| {
            frozen == Some(*index) || hidden.as_ref().is_some_and(|hidden| hidden[vessel.body])
        };
        vessels.filter(is_hidden).map(|(index, _)| index).collect()
    }

    /// Where a person with the role `role` looks from, and how far. The view is `None` if the air is clear, and for the
    /// instructor.
    fn view(&self, role: &Role) -> Option<View> {
        let visibility_m = self.simulation().setup().world.environment.visibility_m?;
        let viewer = self.eye(role)?;
        let eye_m = self.simulation().states()[viewer].position_m;
        Some(View { viewer, eye_m, visibility_m })
    }

    /// For each body, whether fog hides the body.
    fn hidden_bodies(&self, view: &View) -> Vec<bool> {
        let bodies = self.simulation().setup().bodies.iter().zip(self.simulation().states());
        let is_hidden = |(index, (body, state)): (usize, (&BodySetup, &BodyState))| {
            index != view.viewer
                && !body.is_fixed()
                && view.hides(body.outline.vertices(), state.pose())
        };
        bodies.enumerate().map(is_hidden).collect()
    }

    /// For each passing ship, whether fog hides the ship.
    fn hidden_traffic(&self, view: &View) -> Vec<bool> {
        let t_s = self.simulation().time_s();
        let passing = self.simulation().setup().world.flow.passing.iter();
        passing.map(|ship| view.hides(&ship.outline_m, ship.track.at(t_s).pose)).collect()
    }

    /// The body on which a person with the role `role` stands. `None` for the instructor.
    fn eye(&self, role: &Role) -> Option<usize> {
        let (cast, world) = (self.cast(), &self.simulation().setup().world);
        let own = || cast.own.map(|own| world.vessels[own].body);
        let body_of = |name: &str| {
            let vessel = cast.vessels.iter().position(|of| of == name)?;
            Some(world.vessels[vessel].body)
        };
        match role {
            Role::Instructor => None,
            Role::Observer | Role::Pilot { vessel: None } => own(),
            Role::Pilot { vessel: Some(name) } => body_of(name),
            Role::Tugmaster { tug } => {
                if let Some(body) = body_of(tug) {
                    return Some(body);
                }
                // A vector tug is a force and not a body: its master looks from the ship that it serves.
                let tug = world.tugs.iter().find(|of| of.tug.name == *tug)?;
                Some(world.vessels[tug.vessel].body)
            }
        }
    }
}

/// True if the word names a fault of an instrument.
fn is_of_instrument(fault: &str) -> bool {
    Fault::of_word(fault).is_some_and(Fault::is_of_instrument)
}

/// Position from which a person looks, and how far the person sees.
struct View {
    /// The body on which the person stands.
    viewer: usize,
    eye_m: Vec2,
    visibility_m: f64,
}

impl View {
    /// True if the whole outline of a body lies beyond the visibility.
    fn hides(&self, outline_m: &[Vec2], pose: Pose) -> bool {
        to_edge_m(pose.apply_inverse(self.eye_m), outline_m) > self.visibility_m
    }
}
