//! Variants of a scenario that differ only in their start: a study runs thousands of them, and reading a scenario takes
//! longer than many a run.

use fenderline_sim::{BodyStart, Start};
use toml::Spanned;
use toml::de::DeValue;

use crate::assemble::{read_current, read_velocity, read_wind};
use crate::scenario::Scenario;
use fenderline_keys::checked::{Item, Table, Value};
use fenderline_keys::keys::SCENARIO;
use fenderline_keys::overrides::Override;
use fenderline_keys::overrides::pattern::is_pattern;
use fenderline_keys::reader::{read_value, respan};
use fenderline_keys::sources::{Sources, Span};
use fenderline_keys::spec::{KeySpec, Kind, TableSpec};

impl Scenario {
    /// Writes the start of this scenario with some keys replaced into `start`, if they change nothing else of its set-up: the
    /// position, heading and velocity of a floating body, and whole tables of wind and current. The set-up that
    /// [`Scenario::parse_with`] returns for these overrides is then this one with that start ([`fenderline_sim::Setup::set_start`]).
    ///
    /// Returns false, and leaves `start` unspecified, where the overrides may change more than the start, and where one is
    /// refused. `parse_with` then gives the set-up or says what is wrong.
    ///
    /// ```
    /// # use fenderline_scenario::{Override, Scenario};
    /// # let text = include_str!("../../../scenarios/paper/experiment_2_4kn.toml");
    /// let scenario = Scenario::parse(text, "tug.toml")?;
    /// let mut start = scenario.setup.start();
    /// let slow = [Override::parse("body.tug.velocity.surge = 1 kn")?];
    /// assert!(scenario.start_with(&slow, &mut start));
    /// assert_eq!(start.bodies[1].velocity.surge_mps, 1852.0 / 3600.0);
    /// let soft = [Override::parse("material.paper.stiffness = 1 MN/m^2")?];
    /// assert!(!scenario.start_with(&soft, &mut start));
    /// # Ok::<(), fenderline_scenario::ScenarioError>(())
    /// ```
    #[must_use]
    pub fn start_with(&self, overrides: &[Override], start: &mut Start) -> bool {
        let setup = &self.setup;
        // An approach gives the start of its ship, and lines must fit between their ends.
        if !setup.approaches.is_empty() || !setup.world.lines.is_empty() {
            return false;
        }
        setup.start_into(start);
        let sources = Sources::new("", "", overrides);
        let mut set = |(index, change): (usize, &Override)| {
            let span = sources.override_span(index);
            let node = respan(&change.value().ok()?, &span);
            let given = Given { sources: &sources, span, node: &node };
            let path: Vec<&str> = change.path().iter().map(String::as_str).collect();
            match path[..] {
                ["body", name, ref rest @ ..] => {
                    let mut all = setup.bodies.iter().zip(&mut start.bodies);
                    let (body, start) = all.find(|(body, _)| body.name == name)?;
                    // Of a fixed body fenders and dolphins may depend on the place.
                    (body.mass.is_some() && !is_pattern(name)).then_some(())?;
                    given.set_body(start, rest)
                }
                ["environment", "wind"] if setup.world.environment.wind.is_some() => {
                    let table = given.table("environment", "wind")?;
                    start.wind = Some(read_wind(&sources, &table)?);
                    Some(())
                }
                ["environment", "current"] if setup.world.environment.current.is_some() => {
                    let table = given.table("environment", "current")?;
                    start.current = Some(read_current(&sources, &table)?);
                    Some(())
                }
                _ => None,
            }
        };
        overrides.iter().enumerate().all(|each| set(each).is_some())
    }
}

/// The value of an override.
struct Given<'g, 's> {
    sources: &'g Sources<'s>,
    span: Span,
    node: &'g Spanned<DeValue<'s>>,
}

impl Given<'_, '_> {
    /// Sets a key of a body's start.
    fn set_body(&self, start: &mut BodyStart, path: &[&str]) -> Option<()> {
        let Kind::Named(body) = SCENARIO.key("body")?.kind else { return None };
        match *path {
            ["position"] => start.position_m = *self.item(body.key("position")?)?.vector(),
            ["heading"] => start.heading_rad = *self.item(body.key("heading")?)?.number(),
            ["velocity"] => start.velocity = read_velocity(&self.item(body.key("velocity")?)?),
            ["velocity", name] => {
                let Kind::Table(velocity) = body.key("velocity")?.kind else { return None };
                let value = *self.item(velocity.key(name)?)?.number();
                match name {
                    "surge" => start.velocity.surge_mps = value,
                    "sway" => start.velocity.sway_mps = value,
                    "yaw" => start.velocity.yaw_radps = value,
                    _ => return None,
                }
            }
            _ => return None,
        }
        Some(())
    }

    /// The value, checked by the key table.
    fn item(&self, key: &'static KeySpec) -> Option<Item> {
        let value = read_value(self.sources, key, key.name, self.node).ok()?;
        let (key_span, span) = (self.span.clone(), self.span.clone());
        Some(Item { name: key.name, key_span, span, is_default: false, value })
    }

    /// The value of a key that holds a table, as the outer table with only this key. `None` if the table names a file.
    fn table(&self, outer: &str, name: &str) -> Option<Table> {
        let Kind::Table(spec): Kind = SCENARIO.key(outer)?.kind else { return None };
        let spec: &'static TableSpec = spec;
        let item = self.item(spec.key(name)?)?;
        let Value::Table(table) = &item.value else { return None };
        table.item("file").is_none().then_some(())?;
        Some(Table { spec, path: outer.to_owned(), span: self.span.clone(), items: vec![item] })
    }
}
