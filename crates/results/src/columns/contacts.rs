//! The table of contacts.

use std::collections::BTreeMap;

use fenderline_contact::{Contact, Friction};
use fenderline_sim::ContactEnergy;

use super::{Column, Layout, List, Value, flag, float, name};
use crate::row::Row;

/// A row of the table of contacts: one contact patch, in the step of an interval in which its normal force is largest.
pub(crate) struct ContactRow {
    pub(crate) t_s: f64,
    pub(crate) contact: Contact,
    /// Work of the normal and the tangential force on the two bodies in the interval (J).
    pub(crate) work_j: [f64; 2],
}

/// The work of the contacts of a step, each written to one row only.
///
/// The energy ledger adds up the work by pair and by fender. If several patches touch, the first row has the work of
/// all patches, so that the sum over rows equals the ledger. There is one exception: with the contact method `paper`
/// and the Runge–Kutta integrator, the later stages may see a contact one step before its first row.
pub(crate) struct ContactWorks {
    left: BTreeMap<([usize; 2], Option<usize>), [f64; 2]>,
}

impl ContactWorks {
    /// Collects the work of the contacts of a step.
    pub(crate) fn of(books: &[ContactEnergy]) -> ContactWorks {
        let left = books.iter().map(|b| ((b.bodies, b.fender), [b.normal_j, b.tangential_j]));
        ContactWorks { left: left.collect() }
    }

    /// The work for the row of this contact; 0 if an earlier row has the work.
    pub(crate) fn take(&mut self, contact: &Contact) -> [f64; 2] {
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        let fender = contact.fender.map(|id| id.0 as usize);
        self.left.remove(&(bodies, fender)).unwrap_or_default()
    }
}

impl Row for ContactRow {
    /// Bodies, fender, patch.
    type Key = ([u32; 2], Option<u32>, u32);

    fn key(&self) -> Self::Key {
        let Contact { body_1, body_2, fender, patch, .. } = &self.contact;
        ([body_1.0, body_2.0], fender.map(|id| id.0), *patch)
    }

    fn join(&mut self, later: ContactRow) {
        if later.contact.normal_force_n > self.contact.normal_force_n {
            self.contact = later.contact;
        }
        self.work_j = [self.work_j[0] + later.work_j[0], self.work_j[1] + later.work_j[1]];
    }

    fn close(&mut self, _own: f64, _all: f64) {}
}

/// The table `contacts`.
pub(crate) fn contacts_table() -> Layout<ContactRow> {
    let columns: Vec<Column<ContactRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("body_1", "name of the body that comes first in the scenario", List::Bodies, |r| {
            Some(r.contact.body_1.0 as usize)
        }),
        name("body_2", "name of the second body of the pair", List::Bodies, |r| {
            Some(r.contact.body_2.0 as usize)
        }),
        float("area_m2", "m²", "overlap area S", |r| r.contact.area_m2),
        float("depth_m", "m", "penetration δ, extent of the overlap along the normal", |r| {
            r.contact.depth_m
        }),
        float("point_x_m", "m", "centroid C of the overlap, north", |r| r.contact.point_m.x),
        float("point_y_m", "m", "centroid C of the overlap, east", |r| r.contact.point_m.y),
        float("normal_x", "1", "outward normal n of the first body, north component", |r| {
            r.contact.normal.x
        }),
        float("normal_y", "1", "outward normal n of the first body, east component", |r| {
            r.contact.normal.y
        }),
        float(
            "v_normal_mps",
            "m/s",
            "relative velocity along the normal n, positive approaching",
            |r| r.contact.v_normal_mps,
        ),
        float(
            "v_tangential_mps",
            "m/s",
            "velocity of the first body relative to the second along the tangent, which is the normal n turned by +90°",
            |r| r.contact.v_tangential_mps,
        ),
        float("shear_m", "m", "shear Δs of the contact", |r| r.contact.shear_m),
        float("normal_force_n", "N", "normal force N, positive in compression", |r| {
            r.contact.normal_force_n
        }),
        float(
            "tangential_force_n",
            "N",
            "tangential force T on the first body, along the tangent",
            |r| r.contact.tangential_force_n,
        ),
        Column {
            name: "friction_state",
            unit: "-",
            meaning: "stick or slip",
            value: Value::Word(|r| match r.contact.friction {
                Friction::Stick => "stick",
                Friction::Slip => "slip",
            }),
        },
        flag("limited", "whether the impulse-momentum limiter reduced a force", |r| {
            r.contact.limited
        }),
        Column {
            name: "patch",
            unit: "1",
            meaning: "number of the patch of contact within the pair, from 0",
            value: Value::Count(|r| r.contact.patch),
        },
        name("fender", "name of the fender; empty if two outlines touch", List::Fenders, |r| {
            r.contact.fender.map(|id| id.0 as usize)
        }),
        float(
            "spring_n",
            "N",
            "part of the normal force N: area spring or reaction curve, with its factors",
            |r| r.contact.parts.spring_n,
        ),
        float("stop_n", "N", "part of the normal force N: stop beyond a fender's travel", |r| {
            r.contact.parts.stop_n
        }),
        float(
            "damper_n",
            "N",
            "part of the normal force N: damper c Ṡ, negative while the overlap shrinks",
            |r| r.contact.parts.damper_n,
        ),
        float(
            "limiter_n",
            "N",
            "reduction of N by the impulse-momentum limiter: N = spring + stop + damper − limiter",
            |r| r.contact.parts.limiter_n,
        ),
        float("stored_j", "J", "energy stored in a fender's spring and stop", |r| {
            r.contact.energy.stored_j
        }),
        float("tilt_rad", "rad", "angle between a fender's face and the hull", |r| {
            r.contact.tilt_rad
        }),
        float(
            "normal_work_j",
            "J",
            "work of the normal force on the bodies in the interval; the first row of a pair or \
             fender has the work of all its patches, the other rows 0",
            |r| r.work_j[0],
        ),
        float(
            "tangential_work_j",
            "J",
            "work of the tangential force on the bodies in the interval, in the same rows as the \
             work of the normal force",
            |r| r.work_j[1],
        ),
    ];
    Layout {
        name: "contacts",
        rows: "one row per contact patch and interval, in the step in which its normal force is largest",
        columns,
    }
}
