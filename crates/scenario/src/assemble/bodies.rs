//! Reads bodies: outline, mass, and position, heading and velocity at the start.

use fenderline_contact::Outline;
use fenderline_sim::chart::Chart;
use fenderline_sim::{BodySetup, BodyVelocity, HullByHeight, MassProperties};

use super::assembly::{Assembly, Checked};
use super::vessel;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::Notice;
use fenderline_keys::held::{NamedOf, Number, TableOf};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::body::{AddedMassKey, BodyKey, VelocityKey};
use fenderline_keys::sources::Span;
use fenderline_keys::typed_key::{AnyKey, Key};

impl Assembly<'_, '_> {
    pub(super) fn bodies(
        &mut self,
        item: Entry<'_, NamedOf<BodyKey>>,
        kinds: &vessel::Kinds,
        chart: &Chart,
    ) -> Checked<Vec<BodySetup>> {
        let bodies = item.named();
        if bodies.is_empty() {
            let error = self.sources.error(
                &item.span,
                ScenarioKey::BODY.name(),
                "the scenario has no bodies",
            );
            return Err(error.with_help("write [body.NAME] with the keys of the body below"));
        }
        let with_kinds = bodies.iter().zip(kinds.of_bodies());
        with_kinds.map(|((name, table), kind)| self.body(name, table, kind, chart)).collect()
    }

    pub(super) fn body(
        &mut self,
        name: &str,
        table: Of<'_, BodyKey>,
        kind: Option<&vessel::Kind>,
        chart: &Chart,
    ) -> Checked<BodySetup> {
        let hull = self.hull(table, kind)?;
        let outline = match &hull {
            Some(hull) => self.at_waterline(table, kind, hull)?,
            None => self.outline(table, kind, chart)?,
        };
        let hull = match (hull, kind) {
            (None, Some(kind)) if kind.setup.seakeeping.is_some() => {
                Some(self.vertical_sides(table, kind, &outline)?)
            }
            (hull, _) => hull,
        };
        let dolphin = self.dolphin(table)?;
        let mass = if dolphin.is_some() {
            self.refuse_keys_of_floating_bodies(table, "stands on piles", BodyKey::DOLPHIN.any())?;
            None
        } else if *table.given(BodyKey::FIXED).flag() {
            self.refuse_keys_of_floating_bodies(table, "is fixed", BodyKey::FIXED.any())?;
            None
        } else if let Some(kind) = kind {
            self.refuse_keys_of_plain_bodies(table)?;
            Some(kind.mass)
        } else {
            self.refuse_keys_of_vessels(table)?;
            Some(self.mass(table)?)
        };
        Ok(BodySetup {
            name: name.to_owned(),
            outline,
            hull,
            mass,
            position_m: *table.given(BodyKey::POSITION).vector(),
            heading_rad: *table.given(BodyKey::HEADING).number(),
            dolphin,
            velocity: table.item(BodyKey::VELOCITY).map_or(BodyVelocity::default(), velocity),
        })
    }

    /// The outline of a body, from the body's table or from its vessel.
    pub(super) fn outline(
        &mut self,
        table: Of<'_, BodyKey>,
        kind: Option<&vessel::Kind>,
        chart: &Chart,
    ) -> Checked<Outline> {
        let of_chart = table.item(BodyKey::CHART_OUTLINE);
        let path =
            of_chart.map_or_else(|| table.path_of(BodyKey::OUTLINE), |item| table.path_to(item));
        let own = table.item(BodyKey::OUTLINE);
        if let (Some(item), Some(_)) = (of_chart, own) {
            let message = format!("`{path}` and `outline` both give the body's shape");
            let error = self.sources.error(&item.key_span, &path, message);
            return Err(error.with_help("keep only one of the two keys"));
        }
        let of_kind = kind.and_then(vessel::Kind::outline_m);
        let (points, span) = match (own, of_chart, of_kind) {
            (_, Some(item), _) => (self.chart_outline(table, item, chart)?, &item.item().span),
            (Some(item), ..) => (item.outline().to_vec(), &item.item().span),
            (None, None, Some(points)) => (points, &table.given(BodyKey::VESSEL).item().span),
            (None, None, None) => {
                let error = self.sources.error(&table.span, &path, format!("`{path}` is missing"));
                return Err(error.with_help(match kind {
                    Some(_) => "the vessel has no outline: give the body an `outline`",
                    None => "give the corners (m), for example outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]",
                }));
            }
        };
        let (outline, outline_notices) = Outline::new(&points)
            .map_err(|error| self.sources.error(span, &path, format!("`{path}`: {error}")))?;
        self.notices.extend(outline_notices.iter().map(|notice| Notice {
            place: self.sources.place(span),
            key: path.clone(),
            message: notice.to_string(),
        }));
        if own.is_some() {
            self.note_size(kind, &outline, span, path);
        }
        Ok(outline)
    }

    /// The outline at the waterline, for a body with outlines at several heights.
    fn at_waterline(
        &mut self,
        table: Of<'_, BodyKey>,
        kind: Option<&vessel::Kind>,
        hull: &HullByHeight,
    ) -> Checked<Outline> {
        let (path, span) = (table.path_of(BodyKey::OUTLINES), &table.given(BodyKey::OUTLINES).span);
        let outline = hull.at_waterline().map_err(|error| {
            let message = format!("`{path}`: the outline at the waterline is not valid: {error}");
            self.sources.error(span, &path, message)
        })?;
        self.note_size(kind, &outline, span, path);
        Ok(outline)
    }

    /// Adds a warning if an outline does not have the size of the vessel.
    fn note_size(
        &mut self,
        kind: Option<&vessel::Kind>,
        outline: &Outline,
        span: &Span,
        path: String,
    ) {
        if let Some([length_m, beam_m]) = kind.map(vessel::Kind::size_m) {
            let (low, high) = outline.bounds();
            let size = high - low;
            // An outline may leave out a bulb or a flare. A larger difference suggests the outline of another ship.
            let fits = |of: f64, is: f64| (0.8..=1.25).contains(&(is / of));
            if !(fits(length_m, size.x) && fits(beam_m, size.y)) {
                let message = format!(
                    "the outline is {} m by {} m, but the vessel is {length_m} m by {beam_m} m",
                    size.x, size.y
                );
                let place = self.sources.place(span);
                self.notices.push(Notice { place, key: path, message });
            }
        }
    }

    fn refuse_keys_of_floating_bodies<T>(
        &self,
        table: Of<'_, T>,
        is: &str,
        by: AnyKey<BodyKey>,
    ) -> Checked<()> {
        const FLOATING: &[AnyKey<BodyKey>] = any_keys![
            BodyKey: VESSEL, RUNNING, AIR_DRAUGHT, MASS, GYRADIUS, YAW_INERTIA, ADDED_MASS, VELOCITY, APPROACH
        ];
        match table.entries().find(|item| FLOATING.iter().any(|key| item.is(*key))) {
            None => Ok(()),
            Some(item) => {
                let path = table.path_to(item);
                let message = format!("`{path}` is for floating bodies, but this body {is}");
                let error = self.sources.error(&item.key_span, &path, message);
                Err(error.with_help(format!("remove `{}` or `{by}`", item.name)))
            }
        }
    }

    fn refuse_keys_of_vessels(&self, table: Of<'_, BodyKey>) -> Checked<()> {
        let Some(item) = table.item(BodyKey::RUNNING) else { return Ok(()) };
        let path = table.path_to(item);
        let message = format!("`{path}` is for a body with a `vessel`");
        Err(self.sources.error(&item.key_span, &path, message))
    }

    fn refuse_keys_of_plain_bodies<T>(&self, table: Of<'_, T>) -> Checked<()> {
        const PLAIN: &[AnyKey<BodyKey>] =
            any_keys![BodyKey: MASS, GYRADIUS, YAW_INERTIA, ADDED_MASS];
        match table.entries().find(|item| PLAIN.iter().any(|key| item.is(*key))) {
            None => Ok(()),
            Some(item) => {
                let path = table.path_to(item);
                let message = format!(
                    "`{path}` does not go together with `vessel`: the model of the vessel gives \
                     this value"
                );
                let error = self.sources.error(&item.key_span, &path, message);
                Err(error.with_help(format!("remove `{}` or `vessel`", item.name)))
            }
        }
    }

    pub(super) fn mass(&self, table: Of<'_, BodyKey>) -> Checked<MassProperties> {
        let missing = |key: AnyKey<BodyKey>, help: &str| {
            let path = table.path_of(key);
            let message = format!("`{path}` is missing");
            self.sources.error(&table.span, &path, message).with_help(help)
        };
        let mass_kg = *table
            .item(BodyKey::MASS)
            .ok_or_else(|| {
                missing(BodyKey::MASS.any(), "write mass = \"87800 t\", or fixed = true for a quay")
            })?
            .number();
        let yaw_inertia_kgm2 =
            match (table.item(BodyKey::GYRADIUS), table.item(BodyKey::YAW_INERTIA)) {
                (Some(gyradius), None) => mass_kg * gyradius.number() * gyradius.number(),
                (None, Some(inertia)) => *inertia.number(),
                (Some(_), Some(inertia)) => {
                    let path = table.path_of(BodyKey::YAW_INERTIA);
                    let message = format!("`{path}` and `gyradius` both give the yaw inertia");
                    let error = self.sources.error(&inertia.key_span, &path, message);
                    return Err(error.with_help("keep only one of the two keys"));
                }
                (None, None) => {
                    return Err(missing(
                        BodyKey::GYRADIUS.any(),
                        "write gyradius = \"74.5 m\", or yaw_inertia",
                    ));
                }
            };
        let added = |key: Key<AddedMassKey, Number>| {
            let fractions = table.item(BodyKey::ADDED_MASS).map(Entry::table);
            fractions.map_or(0.0, |fractions| *fractions.given(key).number())
        };
        Ok(MassProperties {
            mass_kg,
            yaw_inertia_kgm2,
            added_surge_kg: added(AddedMassKey::SURGE) * mass_kg,
            added_sway_kg: added(AddedMassKey::SWAY) * mass_kg,
            added_yaw_kgm2: added(AddedMassKey::YAW) * yaw_inertia_kgm2,
        })
    }
}

/// The velocity of a body at its start.
pub(crate) fn velocity(item: Entry<'_, TableOf<VelocityKey>>) -> BodyVelocity {
    let table = item.table();
    BodyVelocity {
        surge_mps: *table.given(VelocityKey::SURGE).number(),
        sway_mps: *table.given(VelocityKey::SWAY).number(),
        yaw_radps: *table.given(VelocityKey::YAW).number(),
    }
}
