//! Makes a new exercise at the berth of another scenario: the scenario's fixed bodies with their fenders and bollards,
//! its water and its chart stay; ships, tugs, lines, orders and weather are new.

use fenderline_contact::Pose;
use fenderline_sim::Setup;
use fenderline_sim::berth::Berth;
use toml::de::{DeTable, DeValue};

use super::text::{self, Hull, quoted};
use super::{NewExercise, NewExerciseError};
use crate::rewrite::{Edit, rewritten};
use fenderline_keys::overrides::Override;
use fenderline_keys::sources::Sources;
use fenderline_keys::syntax;
use fenderline_scenario::Scenario;
use fenderline_scenario::VesselData;

/// Tables of the other scenario that belong to its ships or to its results, and are removed.
const REMOVED: [&str; 17] = [
    "anchor",
    "report",
    "output",
    "vessel",
    "tug",
    "line",
    "passing",
    "exercise",
    "order",
    "event",
    "provider",
    "load",
    "berthing",
    "statistics",
    "limit",
    "line_handling",
    "title",
];
/// Keys of the other scenario's weather, which are removed; the new exercise sets its own.
const WEATHER: [&str; 5] = ["wind", "current", "waves", "visibility", "interaction"];

/// A scenario whose berth the new exercise uses.
#[derive(Clone, Copy, Debug)]
pub struct BerthSource<'s> {
    /// Name of the scenario's file, for messages.
    pub file: &'s str,
    /// Its text.
    pub text: &'s str,
}

/// The berth of a scenario: the fixed body with most fenders; `None` if no fixed body has fenders.
#[must_use]
pub fn fixed_berth(setup: &Setup) -> Option<Berth> {
    let first = setup.bodies.iter().position(|body| !body.is_fixed()).unwrap_or(0);
    Berth::of(setup, first, |body| setup.bodies[body].is_fixed())
}

/// The berth of a scenario in words, from which a user chooses; `None` if the scenario has no berth.
#[must_use]
pub fn berth_words(setup: &Setup) -> Option<String> {
    let berth = fixed_berth(setup)?;
    let on = &setup.bodies[berth.body];
    let fenders = setup.fenders.iter().filter(|of| of.body == berth.body).count();
    Some(format!("{}: {fenders} fenders over {:.0} m", on.name, berth.length_m()))
}

impl NewExercise {
    /// Writes the scenario file of the exercise at the berth of another scenario, in place of the straight quay. `read`
    /// returns the text of a file that the other scenario names. The written text has been read again as a scenario,
    /// and is a good one.
    ///
    /// # Errors
    /// Fails as [`NewExercise::text`] does, and if the other scenario has no berth.
    pub fn text_at(
        &self,
        source: BerthSource<'_>,
        read: &mut dyn FnMut(&str) -> Result<String, String>,
    ) -> Result<String, NewExerciseError> {
        let failed = |why: String| NewExerciseError(format!("{}: {why}", source.file));
        let (ship, tug) = self.vessels()?;
        self.check_ship_and_tugs()?;
        let scenario = Scenario::parse_among(source.text, source.file, &[], read)
            .map_err(|error| failed(error.message().to_owned()))?;
        let setup = &scenario.setup;
        let berth = fixed_berth(setup).ok_or_else(|| {
            failed("no body ashore has fenders, so the scenario has no berth".to_owned())
        })?;
        let kept: Vec<&str> = setup
            .bodies
            .iter()
            .filter(|body| body.is_fixed())
            .map(|body| body.name.as_str())
            .collect();
        let taken = ["ship"].into_iter().chain(super::TUG_NAMES);
        if let Some(name) = taken.into_iter().find(|name| kept.contains(name)) {
            return Err(failed(format!(
                "a body ashore has the name `{name}`, which a ship or tug of the exercise \
                                       needs"
            )));
        }
        let overrides: [Override; 0] = [];
        let sources = Sources::new(source.file, source.text, &overrides);
        let document =
            syntax::parse(&sources).map_err(|error| failed(error.message().to_owned()))?;
        let edits = self.edits(&document, &kept);
        let base = rewritten(source.text, source.file, &overrides, &edits)
            .map_err(|error| failed(error.message().to_owned()))?;
        let title = quoted(&self.title);
        let mut text = format!(
            "# Made from choices: the berth of {}, with a ship of the library, tugs and weather. Change it as you like.\n\ntitle = \
             {title}\n{base}",
            source.file
        );
        self.add_ships(&mut text, (setup, &berth, &kept), (ship, tug));
        match Scenario::parse_among(&text, "exercise.toml", &[], read) {
            Ok(_) => Ok(text),
            Err(error) => Err(NewExerciseError(error.message().to_owned())),
        }
    }

    /// Edits that remove floating bodies and everything that belongs to them, and that set the weather.
    fn edits(&self, document: &DeTable<'_>, kept: &[&str]) -> Vec<Edit> {
        let mut edits: Vec<Edit> = REMOVED.iter().map(|key| Edit::remove(&[key])).collect();
        let is_kept = |value: Option<&DeValue<'_>>| matches!(value, Some(DeValue::String(name)) if kept.contains(&name.as_ref()));
        for (name, _) in tables(document, "body") {
            if !kept.contains(&name) {
                edits.push(Edit::remove(&["body", name]));
            }
        }
        for kind in ["fender", "fender_row", "bollard", "bollard_row"] {
            for (name, table) in tables(document, kind) {
                if !is_kept(table.get("on").map(toml::Spanned::get_ref)) {
                    edits.push(Edit::remove(&[kind, name]));
                }
            }
        }
        let pairs = document.get("pair").map(toml::Spanned::get_ref);
        let pairs: Vec<_> = match pairs {
            Some(DeValue::Array(pairs)) => pairs.iter().collect(),
            _ => Vec::new(),
        };
        let stays = |pair: &toml::Spanned<DeValue<'_>>| match pair.get_ref() {
            DeValue::Table(pair) => match pair.get("bodies").map(toml::Spanned::get_ref) {
                Some(DeValue::Array(bodies)) => {
                    bodies.iter().all(|body| is_kept(Some(body.get_ref())))
                }
                _ => false,
            },
            _ => false,
        };
        if pairs.iter().any(|pair| stays(pair)) {
            // From the last on, because the numbers behind a removed item change.
            for (index, _) in pairs.iter().enumerate().rev().filter(|(_, pair)| !stays(pair)) {
                edits.push(Edit::remove(&["pair", &index.to_string()]));
            }
        } else {
            edits.push(Edit::remove(&["pair"]));
        }
        edits.extend(WEATHER.iter().map(|key| Edit::remove(&["environment", key])));
        for (key, value) in text::weather(self) {
            edits.push(Edit::set(&["environment", key], value));
        }
        edits.push(Edit::set(&["time", "duration"], "\"4 h\""));
        edits
    }

    /// Adds the ship, the tugs, their lines and the pairs of bodies that may touch.
    fn add_ships(
        &self,
        text: &mut String,
        (setup, berth, kept): (&Setup, &Berth, &[&str]),
        (ship, tug): (&VesselData, &VesselData),
    ) {
        let carrier = &setup.bodies[berth.body];
        let pose = Pose::new(carrier.position_m, carrier.heading_rad);
        let middle_m = pose.apply((berth.from_m + berth.to_m) * 0.5);
        let to_sea = pose.rotation.apply(berth.facing);
        let hull = Hull::at(&self.ship, ship, middle_m, to_sea);
        text::ship_body(text, &self.ship, &hull, ship);
        for (name, table) in [("concrete", text::CONCRETE), ("bow", text::BOW)] {
            if !setup.materials.iter().any(|material| material.name == name) {
                text.push_str(table);
            }
        }
        for body in kept {
            text::pair(text, "ship", body);
        }
        text::tugs(text, self, &hull, tug, kept);
        text::lines(text, &hull);
    }
}

/// The tables below a key of the file, each with its name.
fn tables<'t>(
    document: &'t DeTable<'_>,
    key: &str,
) -> impl Iterator<Item = (&'t str, &'t DeTable<'t>)> {
    let all = match document.get(key).map(toml::Spanned::get_ref) {
        Some(DeValue::Table(all)) => Some(all),
        _ => None,
    };
    all.into_iter().flatten().filter_map(|(name, value)| match value.get_ref() {
        DeValue::Table(table) => Some((name.get_ref().as_ref(), table)),
        _ => None,
    })
}
