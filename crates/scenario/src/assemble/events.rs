//! Reads events: planned changes of the weather, and faults.

use std::collections::BTreeMap;

use fenderline_sim::{Change, PlannedChange, Setup, VesselSetup};

use super::assembly::{Assembly, Checked, Names};
use super::orders::places;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, List, Of};
use fenderline_keys::held::Text;
use fenderline_keys::keys::event::{
    CAN_END, CurrentChangeKey, EventKey, OF_VESSEL, VisibilityChangeKey, WHAT, WindChangeKey,
};
use fenderline_keys::typed_key::Anything;

impl Assembly<'_, '_> {
    pub(super) fn events(
        &self,
        events: List<'_, EventKey>,
        setup: &Setup,
        names: &Names,
    ) -> Checked<Vec<PlannedChange>> {
        let vessels = places(setup.world.vessels.iter().map(|vessel| vessel.body));
        events.iter().map(|table| self.event(table, setup, (names, &vessels))).collect()
    }

    fn event(
        &self,
        table: Of<'_, EventKey>,
        setup: &Setup,
        (names, vessels): (&Names, &BTreeMap<usize, usize>),
    ) -> Checked<PlannedChange> {
        let what = self.what_happens(table)?;
        self.check_beside(table, what)?;
        let on = !*table.given(EventKey::ENDS).flag();
        let world = &setup.world;
        let vessel = || match table.item(EventKey::VESSEL) {
            Some(item) => self.vessel_named(table, item, vessels, names),
            None => {
                let path = table.path_of(EventKey::VESSEL);
                let error = self.sources.error(&table.span, &path, format!("`{path}` is missing"));
                Err(error.with_help("name the body of the vessel in `vessel`"))
            }
        };
        let change = if let Some(fault) = table.item(EventKey::FAULT) {
            Change::Fault { vessel: vessel()?, fault: fault.choice(), on }
        } else if let Some(unit) = table.item(EventKey::THRUSTER_OUT) {
            let vessel = vessel()?;
            let unit = self.thruster(table, unit, &world.vessels[vessel])?;
            Change::Thruster { vessel, unit, on }
        } else if let Some(line) = table.item(EventKey::LINE_PARTS) {
            let known = || world.lines.iter().map(|line| line.line.name.as_str());
            Change::PartLine(self.numbered("line", table, line, known())?)
        } else if let Some(tug) = table.item(EventKey::TUG_OUT) {
            let known = || world.tugs.iter().map(|tug| tug.tug.name.as_str());
            Change::TugOut { tug: self.numbered("tug", table, tug, known())?, on }
        } else {
            of_weather(table)
        };
        change.check(setup).map_err(|error| self.refused(table, what, &error))?;
        Ok(PlannedChange { at_s: *table.given(EventKey::AT).number(), change })
    }

    /// The one key of an event that says what happens.
    fn what_happens<'t>(&self, table: Of<'t, EventKey>) -> Checked<Entry<'t, Anything>> {
        let mut given = WHAT.iter().filter_map(|key| table.item(*key));
        match (given.next(), given.next()) {
            (Some(what), None) => Ok(what),
            (Some(_), Some(second)) => {
                let path = table.path_to(second);
                let message = format!("`{path}` is a second event in one table");
                let error = self.sources.error(&second.key_span, &path, message);
                Err(error.with_help("write a second [[event]]"))
            }
            (None, _) => {
                let message = format!("in `{}` nothing happens", table.path);
                let error = self.sources.error(&table.span, &table.path, message);
                let words: Vec<&str> = WHAT.iter().map(|key| key.name()).collect();
                Err(error.with_help(format!("there are {}", words.join(", "))))
            }
        }
    }

    /// Refuses keys that do not apply to this kind of event.
    fn check_beside<V>(&self, table: Of<'_, EventKey>, what: Entry<'_, V>) -> Checked<()> {
        if !OF_VESSEL.iter().any(|key| what.is(*key)) {
            self.none_of(table, any_keys![EventKey: VESSEL], what.name)?;
        }
        let ends = table.given(EventKey::ENDS);
        if *ends.flag() && !CAN_END.iter().any(|key| what.is(*key)) {
            let path = table.path_of(EventKey::ENDS);
            let message = format!("`{path}` does not go together with `{}`", what.name);
            return Err(self.sources.error(&ends.key_span, &path, message));
        }
        Ok(())
    }

    /// The index of the thruster or azimuth unit that an event names.
    fn thruster<T>(
        &self,
        table: Of<'_, T>,
        what: Entry<'_, Text>,
        of: &VesselSetup,
    ) -> Checked<usize> {
        self.numbered("thruster", table, what, of.unit_names())
    }

    fn numbered<'n, T>(
        &self,
        kind: &str,
        table: Of<'_, T>,
        what: Entry<'_, Text>,
        mut known: impl Iterator<Item = &'n str> + Clone,
    ) -> Checked<usize> {
        let all = known.clone();
        let number = known.position(|name| name == what.text());
        number.ok_or_else(|| self.unknown(kind, table, what, what.text(), all))
    }
}

/// Reads a change of wind, current or visibility.
fn of_weather(event: Of<'_, EventKey>) -> Change {
    if let Some(wind) = event.item(EventKey::WIND).map(Entry::table) {
        return Change::Wind {
            speed_mps: *wind.given(WindChangeKey::SPEED).number(),
            from_rad: *wind.given(WindChangeKey::FROM).number(),
            over_s: *wind.given(WindChangeKey::OVER).number(),
        };
    }
    if let Some(current) = event.item(EventKey::CURRENT).map(Entry::table) {
        return Change::Current {
            speed_mps: *current.given(CurrentChangeKey::SPEED).number(),
            to_rad: *current.given(CurrentChangeKey::TOWARDS).number(),
            over_s: *current.given(CurrentChangeKey::OVER).number(),
            at: None,
        };
    }
    let visibility = event.item(EventKey::VISIBILITY).map(Entry::table);
    let visibility =
        visibility.unwrap_or_else(|| unreachable!("all other kinds of events were handled above"));
    Change::Visibility {
        distance_m: visibility.item(VisibilityChangeKey::DISTANCE).map(|of| *of.number()),
        over_s: *visibility.given(VisibilityChangeKey::OVER).number(),
    }
}
