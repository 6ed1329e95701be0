//! The table of bodies.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Rotation, Vec2, Wrench};

use super::{Column, Layout, List, float, name};
use crate::row::Row;

/// A row of the table of bodies: the state of one body at the start of an interval, and the contact force on it during
/// the interval.
pub(crate) struct BodyRow {
    t_s: f64,
    body: usize,
    position_m: Vec2,
    heading_rad: f64,
    /// In the body's axes.
    velocity_mps: Vec2,
    yaw_rate_radps: f64,
    wrench: Wrench,
    peak_force_n: f64,
}

impl BodyRow {
    /// The row of body number `body` from its earth-fixed state and the contact forces on it.
    pub(crate) fn new(t_s: f64, body: usize, state: &BodyState, wrench: &Wrench) -> BodyRow {
        let attitude = Rotation::from_angle(state.heading_rad);
        BodyRow {
            t_s,
            body,
            position_m: state.position_m,
            heading_rad: state.heading_rad,
            velocity_mps: attitude.apply_inverse(state.velocity_mps),
            yaw_rate_radps: state.yaw_rate_radps,
            wrench: *wrench,
            peak_force_n: wrench.force_n.length(),
        }
    }
}

impl Row for BodyRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.body
    }

    fn join(&mut self, later: BodyRow) {
        self.wrench.force_n += later.wrench.force_n;
        self.wrench.moment_nm += later.wrench.moment_nm;
        self.peak_force_n = greater(self.peak_force_n, later.peak_force_n);
    }

    fn close(&mut self, _own: f64, all: f64) {
        self.wrench.force_n = self.wrench.force_n * (1.0 / all);
        self.wrench.moment_nm /= all;
    }
}

/// The table `bodies`.
pub(crate) fn bodies_table() -> Layout<BodyRow> {
    let columns: Vec<Column<BodyRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("body", "name of the body", List::Bodies, |r| Some(r.body)),
        float("x_m", "m", "position of the centre of gravity, north of the origin", |r| {
            r.position_m.x
        }),
        float("y_m", "m", "position of the centre of gravity, east of the origin", |r| {
            r.position_m.y
        }),
        float("heading_rad", "rad", "heading ψ, clockwise from north", |r| r.heading_rad),
        float(
            "u_mps",
            "m/s",
            "surge velocity u, body-fixed, positive forward; with the coupled method at half a (sub-)step before t",
            |r| r.velocity_mps.x,
        ),
        float(
            "v_mps",
            "m/s",
            "sway velocity v, body-fixed, positive to starboard; at the same time as surge velocity u",
            |r| r.velocity_mps.y,
        ),
        float(
            "r_radps",
            "rad/s",
            "yaw rate r, positive to starboard; at the same time as surge velocity u",
            |r| r.yaw_rate_radps,
        ),
        float(
            "force_x_n",
            "N",
            "mean sum of the contact forces on the body, positive north",
            |r| r.wrench.force_n.x,
        ),
        float("force_y_n", "N", "mean sum of the contact forces on the body, positive east", |r| {
            r.wrench.force_n.y
        }),
        float(
            "moment_z_nm",
            "N·m",
            "mean moment of the contact forces about the centre of gravity, positive to starboard",
            |r| r.wrench.moment_nm,
        ),
        float(
            "peak_force_n",
            "N",
            "largest sum of the contact forces on the body in a step of the interval",
            |r| r.peak_force_n,
        ),
    ];
    Layout { name: "bodies", rows: "one row per body and interval", columns }
}
