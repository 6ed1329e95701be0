//! Events: planned changes of the weather and faults.

use std::collections::BTreeMap;

use fenderline_sim::{Change, Fault, PlannedChange, Setup, VesselSetup};

use super::assembly::{Assembly, Checked, Names};
use super::orders::places;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::keys::event::{CAN_END, OF_VESSEL, WHAT};

impl Assembly<'_, '_> {
    pub(super) fn events(
        &self,
        events: &[Table],
        setup: &Setup,
        names: &Names,
    ) -> Checked<Vec<PlannedChange>> {
        let vessels = places(setup.world.vessels.iter().map(|vessel| vessel.body));
        events.iter().map(|table| self.event(table, setup, (names, &vessels))).collect()
    }

    fn event(
        &self,
        table: &Table,
        setup: &Setup,
        (names, vessels): (&Names, &BTreeMap<usize, usize>),
    ) -> Checked<PlannedChange> {
        let what = self.what_happens(table)?;
        self.check_beside(table, what)?;
        let on = !*table.given("ends").flag();
        let world = &setup.world;
        let vessel = || match table.item("vessel") {
            Some(item) => self.vessel_named(table, item, vessels, names),
            None => {
                let path = table.path_of("vessel");
                let error = self.sources.error(&table.span, &path, format!("`{path}` is missing"));
                Err(error.with_help("name the body of the vessel"))
            }
        };
        let change = match what.name {
            "wind" | "current" | "visibility" => of_weather(what),
            "fault" => Change::Fault { vessel: vessel()?, fault: what.choice::<Fault>(), on },
            "thruster_out" => {
                let vessel = vessel()?;
                let unit = self.thruster(table, what, &world.vessels[vessel])?;
                Change::Thruster { vessel, unit, on }
            }
            "line_parts" => {
                let known = || world.lines.iter().map(|line| line.line.name.as_str());
                Change::PartLine(self.numbered("line", table, what, known())?)
            }
            _ => {
                debug_assert_eq!(what.name, "tug_out", "all other words are above");
                let known = || world.tugs.iter().map(|tug| tug.tug.name.as_str());
                Change::TugOut { tug: self.numbered("tug", table, what, known())?, on }
            }
        };
        change.check(setup).map_err(|error| self.refused(table, what, &error))?;
        Ok(PlannedChange { at_s: *table.given("at").number(), change })
    }

    /// The one key that says what happens.
    fn what_happens<'t>(&self, table: &'t Table) -> Checked<&'t Item> {
        let mut given = WHAT.iter().filter_map(|key| table.item(key));
        match (given.next(), given.next()) {
            (Some(what), None) => Ok(what),
            (Some(_), Some(second)) => {
                let path = table.path_of(second.name);
                let message = format!("`{path}`: a second event in one table");
                let error = self.sources.error(&second.key_span, &path, message);
                Err(error.with_help("write a second [[event]]"))
            }
            (None, _) => {
                let message = format!("in `{}` nothing happens", table.path);
                let error = self.sources.error(&table.span, &table.path, message);
                Err(error.with_help(format!("there are {}", WHAT.join(", "))))
            }
        }
    }

    /// Refuses keys that the event does not use.
    fn check_beside(&self, table: &Table, what: &Item) -> Checked<()> {
        if !OF_VESSEL.contains(&what.name) {
            self.none_of(table, &["vessel"], what.name)?;
        }
        let ends = table.given("ends");
        if *ends.flag() && !CAN_END.contains(&what.name) {
            let path = table.path_of("ends");
            let message = format!("`{path}` does not go together with `{}`", what.name);
            return Err(self.sources.error(&ends.key_span, &path, message));
        }
        Ok(())
    }

    /// The number of a thruster or an azimuth unit.
    fn thruster(&self, table: &Table, what: &Item, of: &VesselSetup) -> Checked<usize> {
        self.numbered("thruster", table, what, of.unit_names())
    }

    fn numbered<'n>(
        &self,
        kind: &str,
        table: &Table,
        what: &Item,
        mut known: impl Iterator<Item = &'n str> + Clone,
    ) -> Checked<usize> {
        let all = known.clone();
        let number = known.position(|name| name == what.text());
        number.ok_or_else(|| self.unknown(kind, table, what, what.text(), all))
    }
}

/// A change of wind, current or visibility.
fn of_weather(what: &Item) -> Change {
    let of = what.table();
    let number = |key: &str| *of.given(key).number();
    let over_s = number("over");
    match what.name {
        "wind" => Change::Wind { speed_mps: number("speed"), from_rad: number("from"), over_s },
        "current" => Change::Current {
            speed_mps: number("speed"),
            to_rad: number("towards"),
            over_s,
            at: None,
        },
        _ => Change::Visibility { distance_m: of.item("distance").map(|of| *of.number()), over_s },
    }
}
