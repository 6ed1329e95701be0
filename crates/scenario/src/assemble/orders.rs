//! Orders: from the names in a file to the arguments of the table of orders in `fenderline_sim`, which checks limits
//! and gear.

use std::collections::BTreeMap;

use fenderline_sim::hydro::actuator::Telegraph;
use fenderline_sim::order::{ArgumentKind, Arguments, Named, OrderName, TargetKind, Value};
use fenderline_sim::{Order, OrderError, Setup};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::keys::order::{DIRECTION, Form, TELEGRAPH, form, words};

/// The names that orders refer to.
pub(super) struct OrderNames<'w> {
    setup: &'w Setup,
    names: &'w Names,
    vessels: BTreeMap<usize, usize>,
    tugs: BTreeMap<&'w str, usize>,
    lines: BTreeMap<&'w str, usize>,
    anchors: BTreeMap<&'w str, usize>,
}

impl<'w> OrderNames<'w> {
    pub(super) fn new(setup: &'w Setup, names: &'w Names) -> OrderNames<'w> {
        let world = &setup.world;
        OrderNames {
            setup,
            names,
            vessels: places(world.vessels.iter().map(|vessel| vessel.body)),
            tugs: places(world.tugs.iter().map(|tug| tug.tug.name.as_str())),
            lines: places(world.lines.iter().map(|line| line.line.name.as_str())),
            anchors: places(world.anchors.iter().map(|anchor| anchor.gear.name.as_str())),
        }
    }
}

/// The index of each key; of equal keys the first.
pub(super) fn places<K: Ord>(things: impl Iterator<Item = K>) -> BTreeMap<K, usize> {
    let mut places = BTreeMap::new();
    for (place, thing) in things.enumerate() {
        places.entry(thing).or_insert(place);
    }
    places
}

const TARGETS: [TargetKind; 4] =
    [TargetKind::Vessel, TargetKind::Tug, TargetKind::Line, TargetKind::Anchor];

impl Assembly<'_, '_> {
    pub(super) fn orders(&self, orders: &[Table], of: &OrderNames<'_>) -> Checked<Vec<Order>> {
        orders.iter().map(|table| self.order(table, of)).collect()
    }

    pub(super) fn order(&self, table: &Table, of: &OrderNames<'_>) -> Checked<Order> {
        let at_s = *table.given("at").number();
        let (kind, item) = self.target(table)?;
        let what = self.what(table, kind, item)?;
        let target = match kind {
            TargetKind::Vessel => self.vessel_named(table, item, &of.vessels, of.names)?,
            TargetKind::Tug => {
                let known = || of.setup.world.tugs.iter().map(|tug| tug.tug.name.as_str());
                let index = of.tugs.get(item.text()).copied();
                index.ok_or_else(|| self.unknown("tug", table, item, item.text(), known()))?
            }
            TargetKind::Line => self.line_named(table, item, of)?,
            TargetKind::Anchor => {
                let known = || of.setup.world.anchors.iter().map(|own| own.gear.name.as_str());
                let index = of.anchors.get(item.text()).copied();
                index.ok_or_else(|| self.unknown("anchor", table, item, item.text(), known()))?
            }
        };
        let (order, arguments) = self.arguments(table, what, target, of)?;
        let action = order
            .build(target, &arguments, of.setup)
            .map_err(|error| self.refused_order(table, what, &error))?;
        Ok(Order { at_s, action })
    }

    /// The one target that an order names.
    fn target<'t>(&self, table: &'t Table) -> Checked<(TargetKind, &'t Item)> {
        let named = TARGETS.map(|kind| table.item(kind.word()).map(|item| (kind, item)));
        let mut named = named.into_iter().flatten();
        match (named.next(), named.next()) {
            (Some(one), None) => Ok(one),
            _ => {
                let message = format!(
                    "`{}` must be for one of `vessel`, `tug`, `line` and `anchor`",
                    table.path
                );
                Err(self.sources.error(&table.span, &table.path, message))
            }
        }
    }

    /// The one key of the table that is an order.
    fn what<'t>(&self, table: &'t Table, kind: TargetKind, target: &Item) -> Checked<&'t Item> {
        let known = words(kind);
        let others = [target.name, "at", DIRECTION];
        let given: Vec<&Item> =
            table.items.iter().filter(|item| !others.contains(&item.name)).collect();
        let what = match given.as_slice() {
            [what] if known.contains(&what.name) => *what,
            [what, ..] if !known.contains(&what.name) => {
                let path = table.path_of(what.name);
                let article = if kind == TargetKind::Anchor { "an" } else { "a" };
                let message = format!("`{path}` is not an order to {article} {}", target.name);
                let error = self.sources.error(&what.key_span, &path, message);
                return Err(error.with_help(format!("there are {}", known.join(", "))));
            }
            [_, second, ..] => {
                let path = table.path_of(second.name);
                let message = format!("`{path}`: a second order in one table");
                let error = self.sources.error(&second.key_span, &path, message);
                return Err(error.with_help("write a second [[order]]"));
            }
            [] | [_] => {
                let message = format!("`{}` orders nothing", table.path);
                let error = self.sources.error(&table.span, &table.path, message);
                return Err(error.with_help(format!("there are {}", known.join(", "))));
            }
        };
        if let Some(direction) = table.item(DIRECTION).filter(|_| kind != TargetKind::Tug) {
            let path = table.path_of(DIRECTION);
            let message = format!("`{path}` is for tugs");
            return Err(self.sources.error(&direction.key_span, &path, message));
        }
        Ok(what)
    }

    /// The order and its arguments.
    fn arguments(
        &self,
        table: &Table,
        what: &Item,
        target: usize,
        of: &OrderNames<'_>,
    ) -> Checked<(OrderName, Arguments)> {
        let none = Arguments::new();
        let Some(order) = OrderName::of_word(what.name) else {
            debug_assert_eq!(what.name, TELEGRAPH, "all other words are in the table of orders");
            let share = what.choice::<Telegraph>().revolutions_ratio();
            return Ok((OrderName::Engine, none.number("share", share)));
        };
        let arguments = match form(order) {
            Form::Flag => {
                self.only_true(table, what)?;
                none
            }
            Form::Number => {
                let mut own = order.spec().arguments.iter();
                let first = own.next().map(|first| (first.name, *what.number()));
                let beside = own.filter_map(|argument| {
                    Some((argument.name, *table.item(argument.name)?.number()))
                });
                let all = first.into_iter().chain(beside);
                all.fold(none, |all, (name, value)| all.number(name, value))
            }
            Form::Table => {
                let given = what.table();
                let mut all = none;
                for argument in order.spec().arguments {
                    let Some(item) = given.item(argument.name) else { continue };
                    let value = match argument.kind {
                        ArgumentKind::Number { .. } => Value::Number(*item.number()),
                        ArgumentKind::Place { .. } => Value::Place(*item.vector()),
                        ArgumentKind::Name(named) => {
                            Value::Index(self.index_named(named, given, item, target, of)?)
                        }
                    };
                    all = all.with(argument.name, value);
                }
                all
            }
        };
        Ok((order, arguments))
    }

    /// The index of what an argument names.
    fn index_named(
        &self,
        named: Named,
        table: &Table,
        item: &Item,
        target: usize,
        of: &OrderNames<'_>,
    ) -> Checked<usize> {
        let vessel = of.setup.world.vessels.get(target);
        match named {
            Named::Thruster => {
                let all = vessel.map_or(&[][..], |vessel| &vessel.thrusters);
                let known = || all.iter().map(|thruster| thruster.name.as_str());
                let index = known().position(|known| known == item.text());
                index.ok_or_else(|| self.unknown("thruster", table, item, item.text(), known()))
            }
            Named::AzimuthUnit => {
                let all = vessel.map_or(&[][..], |vessel| &vessel.azimuths);
                let known = || all.iter().map(|unit| unit.name.as_str());
                let index = known().position(|known| known == item.text());
                index.ok_or_else(|| self.unknown("azimuth unit", table, item, item.text(), known()))
            }
            Named::Body => self.body_named(table, item, item.name(), of.names),
            Named::Line => self.line_named(table, item, of),
            Named::Bollard => {
                let known = || of.setup.world.bollards.iter().map(|bollard| bollard.name.as_str());
                let index = known().position(|known| known == item.text());
                index.ok_or_else(|| self.unknown("bollard", table, item, item.text(), known()))
            }
        }
    }

    fn line_named(&self, table: &Table, item: &Item, of: &OrderNames<'_>) -> Checked<usize> {
        let known = || of.setup.world.lines.iter().map(|line| line.line.name.as_str());
        let index = of.lines.get(item.text()).copied();
        index.ok_or_else(|| self.unknown("line", table, item, item.text(), known()))
    }

    /// The simulation's error about an order, at the key with the mistake.
    fn refused_order(&self, table: &Table, what: &Item, error: &OrderError) -> ScenarioError {
        let tables = match &what.value {
            fenderline_keys::checked::Value::Table(own) => [own, table],
            _ => [table, table],
        };
        let about = error.argument().and_then(|name| {
            tables.into_iter().find_map(|table| Some((table, table.item_if_any(name)?)))
        });
        let (path, span) = match about {
            Some((table, item)) => (table.path_of(item.name), &item.span),
            None => (table.path_of(what.name), &what.key_span),
        };
        self.sources.error(span, &path, format!("`{path}`: {error}"))
    }

    /// `let_go = false` would order nothing.
    fn only_true(&self, table: &Table, what: &Item) -> Checked<()> {
        if *what.flag() {
            return Ok(());
        }
        let path = table.path_of(what.name);
        Err(self.sources.error(&what.span, &path, format!("`{path}` can only be true")))
    }
}
