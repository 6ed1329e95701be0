//! What fog hides: the frame of a person on board, who does not see beyond the visibility.

use fenderline_contact::Vec2;
use fenderline_contact::number::{bounded, lesser};

use crate::message::{Frame, Role};
use crate::session::Session;

impl Session {
    /// The frame as a person of this role sees it; `None` where fog hides nothing from her. Floating bodies that lie beyond
    /// the visibility are not in it, nor are their contacts and distances. The instructor sees everything, and everybody the
    /// chart, structures and the data of instruments and radio: own motion, the berth, orders to tugs, lines.
    #[must_use]
    pub fn in_fog(&self, frame: &Frame, role: &Role) -> Option<Frame> {
        let hidden = self.hidden_bodies(role)?;
        let setup = self.simulation().setup();
        let mut seen = frame.clone();
        for (body, is_hidden) in seen.bodies.iter_mut().zip(&hidden) {
            if *is_hidden {
                *body = None;
            }
        }
        seen.contacts.retain(|contact| !contact.bodies.iter().any(|&body| hidden[body]));
        for (vessel, setup) in seen.vessels.iter_mut().zip(&setup.world.vessels) {
            if hidden[setup.body] {
                vessel.berth = None;
            }
        }
        Some(seen)
    }

    /// Indices of the vessels that fog hides from a person of this role.
    #[must_use]
    pub fn hidden_vessels(&self, role: &Role) -> Vec<usize> {
        let Some(hidden) = self.hidden_bodies(role) else { return Vec::new() };
        let vessels = self.simulation().setup().world.vessels.iter().enumerate();
        vessels.filter(|(_, vessel)| hidden[vessel.body]).map(|(index, _)| index).collect()
    }

    /// For each body, whether fog hides it from a person of this role; `None` if nothing is hidden.
    fn hidden_bodies(&self, role: &Role) -> Option<Vec<bool>> {
        let visibility_m = self.now().visibility_m?;
        let viewer = self.eye(role)?;
        let setup = self.simulation().setup();
        let states = self.simulation().states();
        let eye_m = states[viewer].position_m;
        let is_hidden = |body: usize| {
            let of = &setup.bodies[body];
            body != viewer
                && !of.is_fixed()
                && distance_m(eye_m, of.outline.vertices(), |at| states[body].pose().apply(at))
                    > visibility_m
        };
        let hidden: Vec<bool> = (0..setup.bodies.len()).map(is_hidden).collect();
        hidden.contains(&true).then_some(hidden)
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

/// From a point to the nearest point of a ring (m).
fn distance_m(from_m: Vec2, ring: &[Vec2], on_earth: impl Fn(Vec2) -> Vec2) -> f64 {
    let corners: Vec<Vec2> = ring.iter().map(|corner| on_earth(*corner)).collect();
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let distances = edges.map(|(a, b)| {
        let (edge, to) = (*b - *a, from_m - *a);
        let share = bounded(edge.dot(to) / edge.length_squared(), 0.0, 1.0);
        (to - edge * share).length()
    });
    distances.fold(f64::INFINITY, lesser)
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    #[test]
    fn the_distance_is_that_to_the_nearest_edge() {
        let square = [vec2(0.0, 0.0), vec2(10.0, 0.0), vec2(10.0, 10.0), vec2(0.0, 10.0)];
        let to = |at| distance_m(at, &square, |corner| corner + vec2(100.0, 0.0));
        assert_eq!(to(vec2(105.0, -7.0)), 7.0);
        assert_eq!(to(vec2(113.0, 14.0)), 5.0);
    }
}
