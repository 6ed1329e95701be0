//! The columns of the result tables: name, unit, meaning and value of each, stated once. The csv
//! header, the parquet schema and its metadata all come from here.

use fenderline_contact::{BodyState, Contact, Friction, Rotation, Vec2, Wrench};

/// One column of a table with rows of type `R`.
pub(super) struct Column<R> {
    /// Name; it ends with the unit where there is one.
    pub(super) name: &'static str,
    /// Unit as a reader writes it; `1` for a pure number, `-` for a text or a truth value.
    pub(super) unit: &'static str,
    /// What it means.
    pub(super) meaning: &'static str,
    /// Takes the value from a row.
    pub(super) value: Value<R>,
}

/// How a column's value is taken from a row, which sets the column's type.
pub(super) enum Value<R> {
    /// A number.
    Float(fn(&R) -> f64),
    /// The index of a body, written as its name.
    Body(fn(&R) -> usize),
    /// One of a few words.
    Word(fn(&R) -> &'static str),
    /// A truth value.
    Flag(fn(&R) -> bool),
    /// A whole number.
    Count(fn(&R) -> u32),
}

/// One body at the start of one step.
pub(super) struct BodyRow {
    t_s: f64,
    body: usize,
    position_m: Vec2,
    heading_rad: f64,
    /// In the body's axes.
    velocity_mps: Vec2,
    yaw_rate_radps: f64,
    wrench: Wrench,
}

impl BodyRow {
    /// The row of body number `body` from its earth-fixed state and the contact forces on it.
    pub(super) fn new(t_s: f64, body: usize, state: &BodyState, wrench: &Wrench) -> BodyRow {
        let attitude = Rotation::from_angle(state.heading_rad);
        BodyRow {
            t_s,
            body,
            position_m: state.position_m,
            heading_rad: state.heading_rad,
            velocity_mps: attitude.apply_inverse(state.velocity_mps),
            yaw_rate_radps: state.yaw_rate_radps,
            wrench: *wrench,
        }
    }
}

/// One patch of contact in one step.
pub(super) struct ContactRow {
    pub(super) t_s: f64,
    pub(super) contact: Contact,
}

const fn float<R>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&R) -> f64,
) -> Column<R> {
    Column { name, unit, meaning, value: Value::Float(value) }
}

const fn body<R>(name: &'static str, meaning: &'static str, value: fn(&R) -> usize) -> Column<R> {
    Column { name, unit: "-", meaning, value: Value::Body(value) }
}

/// The columns of `bodies`, in their order.
pub(super) fn bodies_columns() -> Vec<Column<BodyRow>> {
    vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        body("body", "name of the body", |r| r.body),
        float("x_m", "m", "position of the centre of gravity, north", |r| r.position_m.x),
        float("y_m", "m", "position of the centre of gravity, east", |r| r.position_m.y),
        float("heading_rad", "rad", "heading ψ, clockwise from north", |r| r.heading_rad),
        float("u_mps", "m/s", "surge velocity u, body-fixed, forward", |r| r.velocity_mps.x),
        float("v_mps", "m/s", "sway velocity v, body-fixed, to starboard", |r| r.velocity_mps.y),
        float("r_radps", "rad/s", "rate of turn r, positive to starboard", |r| r.yaw_rate_radps),
        float("force_x_n", "N", "sum of the contact forces on the body, north", |r| {
            r.wrench.force_n.x
        }),
        float("force_y_n", "N", "sum of the contact forces on the body, east", |r| {
            r.wrench.force_n.y
        }),
        float(
            "moment_z_nm",
            "N·m",
            "moment of the contact forces about the centre of gravity, positive to starboard",
            |r| r.wrench.moment_nm,
        ),
    ]
}

/// The columns of `contacts`, in their order.
pub(super) fn contacts_columns() -> Vec<Column<ContactRow>> {
    vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        body("body_1", "name of the body that is first in the scenario", |r| {
            r.contact.body_1.0 as usize
        }),
        body("body_2", "name of the other body", |r| r.contact.body_2.0 as usize),
        float("area_m2", "m²", "overlap area S", |r| r.contact.area_m2),
        float("depth_m", "m", "penetration δ, extent of the overlap along the normal", |r| {
            r.contact.depth_m
        }),
        float("point_x_m", "m", "centroid C of the overlap, north", |r| r.contact.point_m.x),
        float("point_y_m", "m", "centroid C of the overlap, east", |r| r.contact.point_m.y),
        float("normal_x", "1", "outward normal n of body 1, north component", |r| {
            r.contact.normal.x
        }),
        float("normal_y", "1", "outward normal n of body 1, east component", |r| {
            r.contact.normal.y
        }),
        float("v_normal_mps", "m/s", "relative velocity along n, positive approaching", |r| {
            r.contact.v_normal_mps
        }),
        float(
            "v_tangential_mps",
            "m/s",
            "velocity of body 1 relative to body 2 along the tangent, n turned by +90°",
            |r| r.contact.v_tangential_mps,
        ),
        float("shear_m", "m", "shear Δs of the contact", |r| r.contact.shear_m),
        float("normal_force_n", "N", "normal force N, pressing", |r| r.contact.normal_force_n),
        float("tangential_force_n", "N", "tangential force T on body 1, along the tangent", |r| {
            r.contact.tangential_force_n
        }),
        Column {
            name: "state",
            unit: "-",
            meaning: "stick or slip",
            value: Value::Word(|r| match r.contact.friction {
                Friction::Stick => "stick",
                Friction::Slip => "slip",
            }),
        },
        Column {
            name: "limited",
            unit: "-",
            meaning: "whether the impulse-momentum limiter cut a force",
            value: Value::Flag(|r| r.contact.limited),
        },
        Column {
            name: "patch",
            unit: "1",
            meaning: "number of the patch of contact within the pair, from 0",
            value: Value::Count(|r| r.contact.patch),
        },
    ]
}
