//! What fog hides: the frame of a person on board, who does not see beyond the visibility.

use fenderline_contact::{BodyState, Pose, Vec2};
use fenderline_sim::distance::to_edge_m;
use fenderline_sim::order::Word;
use fenderline_sim::{BodySetup, Fault, VesselSetup};

use crate::message::{Frame, Role};
use crate::session::Session;

impl Session {
    /// The frame as a person of this role sees it; `None` where fog hides nothing from her. Floating bodies that lie beyond
    /// the visibility are not in it, nor are their contacts and distances. The instructor sees everything, and everybody the
    /// chart, structures and the data of instruments and radio: own motion, the berth, orders to tugs, lines. Her pilot or master sees what
    /// frozen instruments of a ship show, and nobody but the instructor is told that they are frozen.
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

    /// What a person sees through fog; `None` where it hides nothing from her.
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

    /// Indices of the vessels whose paths a person of this role does not get: those that fog hides, and her own with frozen
    /// instruments.
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

    /// What a person of this role sees of the world; `None` if it is clear, or for the instructor.
    fn view(&self, role: &Role) -> Option<View> {
        let visibility_m = self.simulation().setup().world.environment.visibility_m?;
        let viewer = self.eye(role)?;
        let eye_m = self.simulation().states()[viewer].position_m;
        Some(View { viewer, eye_m, visibility_m })
    }

    /// For each body, whether fog hides it.
    fn hidden_bodies(&self, view: &View) -> Vec<bool> {
        let bodies = self.simulation().setup().bodies.iter().zip(self.simulation().states());
        let is_hidden = |(index, (body, state)): (usize, (&BodySetup, &BodyState))| {
            index != view.viewer
                && !body.is_fixed()
                && view.hides(body.outline.vertices(), state.pose())
        };
        bodies.enumerate().map(is_hidden).collect()
    }

    /// The same for each passing ship.
    fn hidden_traffic(&self, view: &View) -> Vec<bool> {
        let t_s = self.simulation().time_s();
        let passing = self.simulation().setup().world.flow.passing.iter();
        passing.map(|ship| view.hides(&ship.outline_m, ship.track.at(t_s).pose)).collect()
    }

    /// The body from which a person of this role looks; `None` for the instructor.
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
                // A tug that is a force works at the side of her ship.
                let tug = world.tugs.iter().find(|of| of.tug.name == *tug)?;
                Some(world.vessels[tug.vessel].body)
            }
        }
    }
}

/// True if the word is that of a fault of an instrument.
fn is_of_instrument(fault: &str) -> bool {
    Fault::of_word(fault).is_some_and(Fault::is_of_instrument)
}

/// From where, and how far, somebody sees.
struct View {
    /// The body on which she stands.
    viewer: usize,
    eye_m: Vec2,
    visibility_m: f64,
}

impl View {
    /// True if all of an outline is beyond the visibility.
    fn hides(&self, outline_m: &[Vec2], pose: Pose) -> bool {
        to_edge_m(pose.apply_inverse(self.eye_m), outline_m) > self.visibility_m
    }
}
