//! Variants of a scenario that differ only in their start. A study may run thousands of variants, and reading a
//! scenario takes longer than many a run.

use fenderline_sim::{BodyStart, Start};
use toml::Spanned;
use toml::de::DeValue;

use crate::assemble::{read_current, read_velocity, read_wind};
use crate::scenario::Scenario;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::held::{Number, TableOf, Text};
use fenderline_keys::keys::body::{BodyKey, VelocityKey};
use fenderline_keys::keys::environment::{CurrentKey, EnvironmentKey, WindKey};
use fenderline_keys::keys::{BODY, SCENARIO, ScenarioKey};
use fenderline_keys::overrides::Override;
use fenderline_keys::overrides::pattern::is_pattern;
use fenderline_keys::reader::{read_value, respan};
use fenderline_keys::sources::{Sources, Span};
use fenderline_keys::spec::{Kind, TableSpec};
use fenderline_keys::typed_key::Key;

impl Scenario {
    /// Writes into `start` the start of this scenario with some keys replaced, if these keys change nothing but the
    /// start. The start is the position, heading and velocity of the floating bodies, and whole tables of wind and
    /// current. The set-up that [`Scenario::parse_with`] returns for the overrides is then the set-up of this scenario
    /// with the start `start` ([`fenderline_sim::Setup::set_start`]).
    ///
    /// Returns false, and leaves `start` unspecified, if the overrides may change more than the start, or if an
    /// override is refused. If this function returns false, `parse_with` gives the set-up or says what is wrong with
    /// the overrides.
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
            let has_wind = setup.world.environment.wind.is_some();
            let has_current = setup.world.environment.current.is_some();
            match path[..] {
                [outer, name, ref rest @ ..] if outer == ScenarioKey::BODY.name() => {
                    let mut all = setup.bodies.iter().zip(&mut start.bodies);
                    let (body, start) = all.find(|(body, _)| body.name == name)?;
                    // Of a fixed body fenders and dolphins may depend on the place.
                    (body.mass.is_some() && !is_pattern(name)).then_some(())?;
                    given.set_body(start, rest)
                }
                [outer, name] if outer == ScenarioKey::ENVIRONMENT.name() => match name {
                    _ if name == EnvironmentKey::WIND.name() && has_wind => {
                        let table = given.table(EnvironmentKey::WIND, WindKey::FILE)?;
                        start.wind = Some(read_wind(&sources, table.of())?);
                        Some(())
                    }
                    _ if name == EnvironmentKey::CURRENT.name() && has_current => {
                        let table = given.table(EnvironmentKey::CURRENT, CurrentKey::FILE)?;
                        start.current = Some(read_current(&sources, table.of())?);
                        Some(())
                    }
                    _ => None,
                },
                _ => None,
            }
        };
        overrides.iter().enumerate().all(|each| set(each).is_some())
    }
}

/// The value of an override, with its place.
struct Given<'g, 's> {
    sources: &'g Sources<'s>,
    span: Span,
    node: &'g Spanned<DeValue<'s>>,
}

impl Given<'_, '_> {
    /// Sets the position, heading or velocity of a body at its start.
    fn set_body(&self, start: &mut BodyStart, path: &[&str]) -> Option<()> {
        match *path {
            [name] if name == BodyKey::POSITION.name() => {
                let item = self.item(&BODY, BodyKey::POSITION)?;
                start.position_m = *item.entry(BodyKey::POSITION).vector();
            }
            [name] if name == BodyKey::HEADING.name() => {
                let item = self.item(&BODY, BodyKey::HEADING)?;
                start.heading_rad = *item.entry(BodyKey::HEADING).number();
            }
            [name] if name == BodyKey::VELOCITY.name() => {
                let item = self.item(&BODY, BodyKey::VELOCITY)?;
                start.velocity = read_velocity(item.entry(BodyKey::VELOCITY));
            }
            [outer, name] if outer == BodyKey::VELOCITY.name() => {
                let Kind::Table(spec) = BODY.key(outer)?.kind else { return None };
                let value = |key: Key<VelocityKey, Number>| {
                    Some(*self.item(spec, key)?.entry(key).number())
                };
                let velocity = &mut start.velocity;
                match name {
                    _ if name == VelocityKey::SURGE.name() => {
                        velocity.surge_mps = value(VelocityKey::SURGE)?;
                    }
                    _ if name == VelocityKey::SWAY.name() => {
                        velocity.sway_mps = value(VelocityKey::SWAY)?;
                    }
                    _ if name == VelocityKey::YAW.name() => {
                        velocity.yaw_radps = value(VelocityKey::YAW)?;
                    }
                    _ => return None,
                }
            }
            _ => return None,
        }
        Some(())
    }

    /// The value of the override, checked by the declaration of the key.
    fn item<T, V>(&self, spec: &'static TableSpec, key: Key<T, V>) -> Option<Item> {
        let key = spec.key(key.name())?;
        let value = read_value(self.sources, key, key.name, self.node).ok()?;
        let (key_span, span) = (self.span.clone(), self.span.clone());
        Some(Item { name: key.name, key_span, span, is_default: false, value })
    }

    /// The table of wind or current that the override gives, within a table `[environment]` that has only this key. The
    /// result is `None` if the table of wind or current names a file.
    fn table<R>(&self, key: Key<EnvironmentKey, TableOf<R>>, file: Key<R, Text>) -> Option<Table> {
        let outer = ScenarioKey::ENVIRONMENT.name();
        let Kind::Table(spec) = SCENARIO.key(outer)?.kind else { return None };
        let item = self.item(spec, key)?;
        item.entry(key).table().item(file).is_none().then_some(())?;
        Some(Table { spec, path: outer.to_owned(), span: self.span.clone(), items: vec![item] })
    }
}
