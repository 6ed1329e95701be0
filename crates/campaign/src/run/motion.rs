//! Records how far bodies move from their positions at the start.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Rotation};

/// The largest excursions of a body, along the axes of the body at the start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Excursion {
    start: BodyState,
    axes: Rotation,
    /// Largest surge (m), without sign.
    pub(super) surge_m: f64,
    /// Largest sway (m), without sign.
    pub(super) sway_m: f64,
    /// Largest change of heading (rad), without sign.
    pub(super) yaw_rad: f64,
    /// State of the body at the end of the run.
    pub(super) last: BodyState,
}

impl Excursion {
    pub(super) fn new(start: &BodyState) -> Excursion {
        let axes = Rotation::from_angle(start.heading_rad);
        Excursion { start: *start, axes, surge_m: 0.0, sway_m: 0.0, yaw_rad: 0.0, last: *start }
    }

    pub(super) fn add(&mut self, now: &BodyState) {
        let way_m = self.axes.apply_inverse(now.position_m - self.start.position_m);
        self.surge_m = greater(self.surge_m, way_m.x.abs());
        self.sway_m = greater(self.sway_m, way_m.y.abs());
        self.yaw_rad = greater(self.yaw_rad, (now.heading_rad - self.start.heading_rad).abs());
        self.last = *now;
    }
}
