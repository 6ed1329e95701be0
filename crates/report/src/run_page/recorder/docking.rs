//! Records how far a vessel's ends are from a row of fenders, and how fast they approach it.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Outline, Rotation, Vec2, vec2};
use fenderline_sim::Setup;

use crate::plot::Decimator;

/// Cosine of the largest angle between the directions of fenders that count as one row: 1 degree.
const ONE_ROW: f64 = 0.9998;

/// A straight row of fenders on one body: the line through its foremost faces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Berth {
    /// Index of the body that carries the row of fenders.
    pub(super) body: usize,
    /// Direction outwards from the fenders, in the body's frame.
    outward: Vec2,
    /// Distance of the foremost fender face along the outward direction (m).
    out_m: f64,
}

impl Berth {
    /// Finds the row of fenders of a set-up whose fenders are all on one body and face the same way.
    pub(super) fn of(setup: &Setup) -> Option<Berth> {
        let first = setup.fenders.first()?;
        let outward_of = |facing_rad| Rotation::from_angle(facing_rad).apply(vec2(1.0, 0.0));
        let outward = outward_of(first.facing_rad);
        let is_one_row = setup.fenders.iter().all(|fender| {
            fender.body == first.body && outward.dot(outward_of(fender.facing_rad)) > ONE_ROW
        });
        let out_m = setup
            .fenders
            .iter()
            .map(|fender| fender.position_m.dot(outward) + fender.projection_m)
            .fold(f64::NEG_INFINITY, greater);
        is_one_row.then_some(Berth { body: first.body, outward, out_m })
    }
}

/// Distance and closing speed of the fore and the after third of a hull, over time.
pub(in crate::run_page) struct DockingTrace {
    berth: Berth,
    /// Vertices of the fore third and of the after third of the hull, in its frame (m).
    ends_m: [Vec<Vec2>; 2],
    /// Distance from the line of the fender faces to the nearest point of each third of the hull, positive outside (m).
    pub(in crate::run_page) distance_m: [Decimator; 2],
    /// Speed of each third's nearest point towards the berth (m/s).
    pub(in crate::run_page) closing_mps: [Decimator; 2],
}

impl DockingTrace {
    pub(super) fn new(berth: Berth, hull: &Outline) -> DockingTrace {
        let (low, high) = hull.bounds();
        let third_m = (high.x - low.x) / 3.0;
        let vertices = hull.vertices();
        let within = |from_m: f64, to_m: f64| {
            vertices.iter().copied().filter(|v| v.x >= from_m && v.x <= to_m).collect::<Vec<_>>()
        };
        DockingTrace {
            berth,
            ends_m: [within(high.x - third_m, high.x), within(low.x, low.x + third_m)],
            distance_m: Default::default(),
            closing_mps: Default::default(),
        }
    }

    pub(super) fn push(&mut self, t_s: f64, states: &[BodyState], ship: &BodyState) {
        let carrier = states[self.berth.body].pose();
        let outward = carrier.rotation.apply(self.berth.outward);
        let line_m = (carrier.apply(self.berth.outward * self.berth.out_m)).dot(outward);
        let pose = ship.pose();
        for (k, vertices) in self.ends_m.iter().enumerate() {
            let places = vertices.iter().map(|vertex| pose.apply(*vertex));
            let nearest = places.min_by(|a, b| a.dot(outward).total_cmp(&b.dot(outward)));
            let Some(place) = nearest else { continue };
            self.distance_m[k].push(t_s, place.dot(outward) - line_m);
            self.closing_mps[k].push(t_s, -ship.velocity_at(place).dot(outward));
        }
    }
}
