//! Azimuth units, orders to them, and the work of tugs that are vessels.

use std::collections::BTreeMap;

use fenderline_sim::hydro::{AzimuthThruster, Propeller, Series};
use fenderline_sim::{
    Action, Assist, AzimuthSetup, BodySetup, FenderSetup, Job, LineEnd, MooringSetup, PushJob,
    VesselSetup,
};

use super::{Assembly, Checked, Names, Pairs};
use crate::checked::{Item, Table};
use crate::sources::quoted;

/// What the work of a tug refers to.
pub(super) struct Afloat<'w> {
    pub(super) bodies: &'w [BodySetup],
    pub(super) fenders: &'w [FenderSetup],
    pub(super) pairs: &'w Pairs,
    pub(super) lines: &'w [MooringSetup],
    line_places: BTreeMap<&'w str, usize>,
}

impl<'w> Afloat<'w> {
    pub(super) fn new(
        bodies: &'w [BodySetup],
        fenders: &'w [FenderSetup],
        pairs: &'w Pairs,
        lines: &'w [MooringSetup],
    ) -> Afloat<'w> {
        let line_places = places(lines.iter().map(|line| line.line.name.as_str()));
        Afloat { bodies, fenders, pairs, lines, line_places }
    }

    /// The place of the line of a name.
    pub(super) fn line_place(&self, name: &str) -> Option<usize> {
        self.line_places.get(name).copied()
    }
}

/// Where each thing stands first.
pub(super) fn places<K: Ord>(things: impl Iterator<Item = K>) -> BTreeMap<K, usize> {
    let mut places = BTreeMap::new();
    for (place, thing) in things.enumerate() {
        places.entry(thing).or_insert(place);
    }
    places
}

/// The units of a kind of vessel.
pub(crate) fn azimuths(tables: &[(String, Table)]) -> Vec<AzimuthSetup> {
    let read = |(name, table): &(String, Table)| {
        let number = |name: &str| *table.given(name).number();
        AzimuthSetup {
            name: name.clone(),
            unit: AzimuthThruster {
                propeller: Propeller {
                    diameter_m: number("diameter"),
                    thrust_polynomial: None,
                    series: Series::B4Pitch10,
                },
                along_m: number("along"),
                across_m: number("across"),
                // A bollard pull is net, and the units stand clear of the hull.
                wake: 0.0,
                thrust_deduction: 0.0,
            },
            bollard_n: number("force"),
            lag_s: number("lag"),
            rate_radps: number("rate"),
            stop_rad: table.item("stop").map(|item| *item.number()),
        }
    };
    let mut units: Vec<_> = tables.iter().map(read).collect();
    // Sorted by name: forces are summed in this order, so that the order in the file has no effect.
    units.sort_by(|one, other| one.name.cmp(&other.name));
    units
}

impl Assembly<'_, '_> {
    /// An order to a unit.
    pub(super) fn to_azimuth(&self, of: &Table, vessel: &VesselSetup) -> Checked<Action> {
        let name = of.given("name");
        let known = || vessel.azimuths.iter().map(|azimuth| azimuth.name.as_str());
        let unit = known().position(|known| known == name.text());
        let unit =
            unit.ok_or_else(|| self.unknown("azimuth unit", of, name, name.text(), known()))?;
        let number = |name: &str| of.item(name).map(|item| *item.number());
        let (power, direction_rad) = (number("power"), number("direction"));
        if power.is_none() && direction_rad.is_none() {
            let message = format!("`{}` asks for nothing", of.path);
            let error = self.sources.error(&of.span, &of.path, message);
            return Err(error.with_help("give it a `power`, a `direction` or both"));
        }
        Ok(Action::Azimuth { unit, power, direction_rad })
    }

    /// What a tug is told to do at a ship.
    pub(super) fn to_tug_vessel(
        &self,
        what: &Item,
        tug: &VesselSetup,
        afloat: &Afloat<'_>,
        names: &Names,
    ) -> Checked<Action> {
        let of = what.table();
        if tug.azimuths.is_empty() {
            let name = quoted(&afloat.bodies[tug.body].name);
            let message = format!("`{}`: vessel {name} has no azimuth units", of.path);
            let error = self.sources.error(&what.key_span, &of.path, message);
            return Err(error.with_help("give her kind [vessel.NAME.azimuth.NAME]"));
        }
        let job = match what.name {
            "push_ship" => self.push(of, tug, afloat, names)?,
            "pull_ship" => self.pull(of, tug, afloat)?,
            "follow_ship" => Job::Follow {
                ship: self.other_body(of, tug, names)?,
                at_m: *of.given("at").vector(),
                heading_rad: *of.given("heading").number(),
            },
            other => unreachable!("{other} is no work of a tug"),
        };
        Ok(Action::Assist(Assist { job, fastest_mps: *of.given("speed").number() }))
    }

    fn push(
        &self,
        of: &Table,
        tug: &VesselSetup,
        afloat: &Afloat<'_>,
        names: &Names,
    ) -> Checked<Job> {
        let ship = self.other_body(of, tug, names)?;
        let force_n = self.force_within_bollard_pull(of, tug)?;
        let item = of.given("ship");
        if !afloat.pairs.may_touch([ship, tug.body]) {
            let path = of.path_of("ship");
            let message =
                format!("`{path}`: no [[pair]] lets her touch body {}", quoted(item.name()));
            return Err(self.sources.error(&item.span, &path, message));
        }
        let at = of.given("at");
        PushJob::new(afloat.bodies, afloat.fenders, tug.body, (ship, *at.vector()), force_n)
            .map(Job::Push)
            .map_err(|error| self.refused(of, at, &error))
    }

    fn pull(&self, of: &Table, tug: &VesselSetup, afloat: &Afloat<'_>) -> Checked<Job> {
        let item = of.given("line");
        let known = || afloat.lines.iter().map(|line| line.line.name.as_str());
        let line = afloat.line_place(item.text());
        let line = line.ok_or_else(|| self.unknown("line", of, item, item.text(), known()))?;
        let setup = &afloat.lines[line];
        let far = match setup.end {
            LineEnd::OnBody { body, .. } => Some(body),
            LineEnd::Fixed(_) => None,
        };
        if far.is_none() || (setup.ship != tug.body && far != Some(tug.body)) {
            let path = of.path_of("line");
            let message =
                format!("`{path}`: line {} is not between her and a ship", quoted(item.text()));
            return Err(self.sources.error(&item.span, &path, message));
        }
        let force_n = self.force_within_bollard_pull(of, tug)?;
        Ok(Job::Pull { line, direction_rad: *of.given("direction").number(), force_n })
    }

    fn other_body(&self, of: &Table, tug: &VesselSetup, names: &Names) -> Checked<usize> {
        let item = of.given("ship");
        let ship = self.body_named(of, item, item.name(), names)?;
        if ship != tug.body {
            return Ok(ship);
        }
        let path = of.path_of("ship");
        let message = format!("`{path}`: body {} is the tug herself", quoted(item.name()));
        Err(self.sources.error(&item.span, &path, message))
    }

    fn force_within_bollard_pull(&self, of: &Table, tug: &VesselSetup) -> Checked<f64> {
        let item = of.given("force");
        let pull_n: f64 = tug.azimuths.iter().map(|azimuth| azimuth.bollard_n).sum();
        let force_n = *item.number();
        if force_n <= pull_n {
            return Ok(force_n);
        }
        let path = of.path_of("force");
        let message = format!(
            "`{path}` must be at most her bollard pull of {} kN, but is {} kN",
            pull_n / 1e3,
            force_n / 1e3
        );
        Err(self.sources.error(&item.span, &path, message))
    }
}
