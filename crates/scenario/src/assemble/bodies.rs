//! Bodies: outline, mass and initial state.

use fenderline_contact::Outline;
use fenderline_sim::chart::Chart;
use fenderline_sim::{BodySetup, BodyVelocity, HullByHeight, MassProperties};

use super::assembly::{Assembly, Checked};
use super::vessel;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::Notice;
use fenderline_keys::sources::Span;

impl Assembly<'_, '_> {
    pub(super) fn bodies(
        &mut self,
        item: &Item,
        kinds: &vessel::Kinds,
        chart: &Chart,
    ) -> Checked<Vec<BodySetup>> {
        let bodies = item.named();
        if bodies.is_empty() {
            let error = self.sources.error(&item.span, "body", "the scenario has no bodies");
            return Err(error.with_help("write [body.NAME] with its keys below"));
        }
        let with_kinds = bodies.iter().zip(kinds.of_bodies());
        with_kinds.map(|((name, table), kind)| self.body(name, table, kind, chart)).collect()
    }

    pub(super) fn body(
        &mut self,
        name: &str,
        table: &Table,
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
            self.refuse_keys_of_floating_bodies(table, "stands on piles", "dolphin")?;
            None
        } else if *table.given("fixed").flag() {
            self.refuse_keys_of_floating_bodies(table, "is fixed", "fixed")?;
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
            position_m: *table.given("position").vector(),
            heading_rad: *table.given("heading").number(),
            dolphin,
            velocity: table.item("velocity").map_or(BodyVelocity::default(), velocity),
        })
    }

    /// The body's outline: from the body's table, or from the vessel.
    pub(super) fn outline(
        &mut self,
        table: &Table,
        kind: Option<&vessel::Kind>,
        chart: &Chart,
    ) -> Checked<Outline> {
        let of_chart = table.item("chart_outline");
        let path = table.path_of(of_chart.map_or("outline", |item| item.name));
        let own = table.item("outline");
        if let (Some(item), Some(_)) = (of_chart, own) {
            let message = format!("`{path}` and `outline` both give the body's shape");
            let error = self.sources.error(&item.key_span, &path, message);
            return Err(error.with_help("keep one of the two"));
        }
        let (points, span) = match (own.or(of_chart), kind.and_then(vessel::Kind::outline_m)) {
            (Some(item), _) if of_chart.is_some() => {
                (self.chart_outline(table, item, chart)?, &item.span)
            }
            (Some(item), _) => (item.outline().to_vec(), &item.span),
            (None, Some(points)) => (points, &table.given("vessel").span),
            (None, None) => {
                let error = self.sources.error(&table.span, &path, format!("`{path}` is missing"));
                return Err(error.with_help(match kind {
                    Some(_) => "the vessel has no outline: give one here",
                    None => "write outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]",
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

    /// The outline at the waterline of a body with outlines by height.
    fn at_waterline(
        &mut self,
        table: &Table,
        kind: Option<&vessel::Kind>,
        hull: &HullByHeight,
    ) -> Checked<Outline> {
        let (path, span) = (table.path_of("outlines"), &table.given("outlines").span);
        let outline = hull.at_waterline().map_err(|error| {
            let message = format!("`{path}`: the outline at the waterline is not valid: {error}");
            self.sources.error(span, &path, message)
        })?;
        self.note_size(kind, &outline, span, path);
        Ok(outline)
    }

    /// A notice if an outline does not have the size of the vessel.
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

    fn refuse_keys_of_floating_bodies(&self, table: &Table, is: &str, by: &str) -> Checked<()> {
        const FLOATING: [&str; 8] = [
            "vessel",
            "running",
            "mass",
            "gyradius",
            "yaw_inertia",
            "added_mass",
            "velocity",
            "approach",
        ];
        match table.items.iter().find(|item| FLOATING.contains(&item.name)) {
            None => Ok(()),
            Some(item) => {
                let path = table.path_of(item.name);
                let message = format!("`{path}` is for floating bodies, but this body {is}");
                let error = self.sources.error(&item.key_span, &path, message);
                Err(error.with_help(format!("remove `{}` or `{by}`", item.name)))
            }
        }
    }

    fn refuse_keys_of_vessels(&self, table: &Table) -> Checked<()> {
        let Some(item) = table.item("running") else { return Ok(()) };
        let path = table.path_of(item.name);
        let message = format!("`{path}` is for a body with a `vessel`");
        Err(self.sources.error(&item.key_span, &path, message))
    }

    fn refuse_keys_of_plain_bodies(&self, table: &Table) -> Checked<()> {
        const PLAIN: [&str; 4] = ["mass", "gyradius", "yaw_inertia", "added_mass"];
        match table.items.iter().find(|item| PLAIN.contains(&item.name)) {
            None => Ok(()),
            Some(item) => {
                let path = table.path_of(item.name);
                let message = format!(
                    "`{path}` does not go together with `vessel`, whose model gives this \
                        value"
                );
                let error = self.sources.error(&item.key_span, &path, message);
                Err(error.with_help(format!("remove `{}` or `vessel`", item.name)))
            }
        }
    }

    pub(super) fn mass(&self, table: &Table) -> Checked<MassProperties> {
        let missing = |name: &str, help: &str| {
            let path = table.path_of(name);
            let message = format!("`{path}` is missing");
            self.sources.error(&table.span, &path, message).with_help(help)
        };
        let mass_kg = *table
            .item("mass")
            .ok_or_else(|| missing("mass", "write mass = \"87800 t\", or fixed = true for a quay"))?
            .number();
        let yaw_inertia_kgm2 = match (table.item("gyradius"), table.item("yaw_inertia")) {
            (Some(gyradius), None) => mass_kg * gyradius.number() * gyradius.number(),
            (None, Some(inertia)) => *inertia.number(),
            (Some(_), Some(inertia)) => {
                let path = table.path_of("yaw_inertia");
                let message = format!("`{path}` and `gyradius` both give the yaw inertia");
                let error = self.sources.error(&inertia.key_span, &path, message);
                return Err(error.with_help("keep one of the two"));
            }
            (None, None) => {
                return Err(missing("gyradius", "write gyradius = \"74.5 m\", or yaw_inertia"));
            }
        };
        let added = |name: &str| {
            let fractions = table.item("added_mass").map(Item::table);
            fractions.map_or(0.0, |fractions| *fractions.given(name).number())
        };
        Ok(MassProperties {
            mass_kg,
            yaw_inertia_kgm2,
            added_surge_kg: added("surge") * mass_kg,
            added_sway_kg: added("sway") * mass_kg,
            added_yaw_kgm2: added("yaw") * yaw_inertia_kgm2,
        })
    }
}

/// The velocity of a body at its start.
pub(crate) fn velocity(item: &Item) -> BodyVelocity {
    let table = item.table();
    BodyVelocity {
        surge_mps: *table.given("surge").number(),
        sway_mps: *table.given("sway").number(),
        yaw_radps: *table.given("yaw").number(),
    }
}
