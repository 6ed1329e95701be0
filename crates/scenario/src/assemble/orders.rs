//! Reads orders: turns the names in a file into arguments for the table of orders in `fenderline_sim`, which checks
//! limits and gear.

use std::collections::BTreeMap;

use fenderline_sim::order::{ArgumentKind, Arguments, Named, OrderName, TargetKind, Value};
use fenderline_sim::{Order, OrderError, Setup};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::{Entry, List, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{Flag, Name, Number, Text, Vector};
use fenderline_keys::keys::order::{
    ArgumentKey, OrderKey, OrderKind, argument_key, order_key, target_key, words,
};
use fenderline_keys::typed_key::{Anything, Key};

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

/// The index of each item in a list; of equal items the index of the first.
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
    pub(super) fn orders(
        &self,
        orders: List<'_, OrderKey>,
        of: &OrderNames<'_>,
    ) -> Checked<Vec<Order>> {
        orders.iter().map(|table| self.order(table, of)).collect()
    }

    pub(super) fn order(&self, table: Of<'_, OrderKey>, of: &OrderNames<'_>) -> Checked<Order> {
        let at_s = *table.given(OrderKey::AT).number();
        let kind = self.target(table)?;
        let what = self.what(table, kind)?;
        let target = match kind {
            TargetKind::Vessel => {
                let item = table.given(OrderKey::VESSEL);
                self.vessel_named(table, item, &of.vessels, of.names)?
            }
            TargetKind::Tug => {
                let item = table.given(OrderKey::TUG);
                let known = || of.setup.world.tugs.iter().map(|tug| tug.tug.name.as_str());
                let index = of.tugs.get(item.text()).copied();
                index.ok_or_else(|| self.unknown("tug", table, item, item.text(), known()))?
            }
            TargetKind::Line => self.line_named(table, table.given(OrderKey::LINE), of)?,
            TargetKind::Anchor => {
                let item = table.given(OrderKey::ANCHOR);
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

    /// The kind of target that an order names; an order must have one target.
    fn target(&self, table: Of<'_, OrderKey>) -> Checked<TargetKind> {
        let mut named = TARGETS.into_iter().filter(|kind| table.item(target_key(*kind)).is_some());
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

    /// The key of an `[[order]]` table that says what is ordered; there must be one such key.
    fn what<'t>(&self, table: Of<'t, OrderKey>, kind: TargetKind) -> Checked<Entry<'t, Anything>> {
        let known = words(kind);
        let target = target_key(kind);
        let others = [target, OrderKey::AT.any(), OrderKey::DIRECTION.any()];
        let is_other = |item: &Entry<'_, Anything>| others.iter().any(|key| item.is(*key));
        let given: Vec<Entry<'_, Anything>> =
            table.entries().filter(|item| !is_other(item)).collect();
        let what = match given.as_slice() {
            [what] if known.contains(&what.name) => *what,
            [what, ..] if !known.contains(&what.name) => {
                let path = table.path_to(*what);
                let article = if kind == TargetKind::Anchor { "an" } else { "a" };
                let message = format!("`{path}` is not an order to {article} {target}");
                let error = self.sources.error(&what.key_span, &path, message);
                return Err(error.with_help(format!("there are {}", known.join(", "))));
            }
            [_, second, ..] => {
                let path = table.path_to(*second);
                let message = format!("`{path}` is a second order in one table");
                let error = self.sources.error(&second.key_span, &path, message);
                return Err(error.with_help("write a second [[order]]"));
            }
            [] | [_] => {
                let message = format!("`{}` orders nothing", table.path);
                let error = self.sources.error(&table.span, &table.path, message);
                return Err(error.with_help(format!("there are {}", known.join(", "))));
            }
        };
        if let Some(direction) = table.item(OrderKey::DIRECTION).filter(|_| kind != TargetKind::Tug)
        {
            let path = table.path_of(OrderKey::DIRECTION);
            let message = format!("`{path}` is for tugs");
            return Err(self.sources.error(&direction.key_span, &path, message));
        }
        Ok(what)
    }

    /// Reads an order and the order's arguments.
    fn arguments(
        &self,
        table: Of<'_, OrderKey>,
        what: Entry<'_, Anything>,
        target: usize,
        of: &OrderNames<'_>,
    ) -> Checked<(OrderName, Arguments)> {
        let none = Arguments::new();
        let Some(order) = OrderName::of_word(what.name) else {
            // All other words are in the table of orders.
            let word = table.given(OrderKey::TELEGRAPH).choice();
            return Ok((OrderName::Engine, none.number("share", word.revolutions_ratio())));
        };
        let all = order.spec().arguments;
        let arguments = match order_key(order) {
            OrderKind::Flag(key) => {
                self.only_true(table, key)?;
                none
            }
            OrderKind::Number(key) => {
                let mut own = all.iter();
                let first = own.next().map(|first| (first.name, *table.given(key).number()));
                let beside = own.filter_map(|argument| {
                    let key = argument_key::<OrderKey, Number>(argument);
                    Some((argument.name, *table.item(key)?.number()))
                });
                let all = first.into_iter().chain(beside);
                all.fold(none, |all, (name, value)| all.number(name, value))
            }
            OrderKind::Table(key) => {
                let given = table.given(key).table();
                let mut found = none;
                for argument in all {
                    let value = match argument.kind {
                        ArgumentKind::Number { .. } => {
                            let item = given.item(argument_key::<_, Number>(argument));
                            item.map(|item| Value::Number(*item.number()))
                        }
                        ArgumentKind::Place { .. } => {
                            let item = given.item(argument_key::<_, Vector>(argument));
                            item.map(|item| Value::Place(*item.vector()))
                        }
                        ArgumentKind::Name(Named::Body) => {
                            match given.item(argument_key::<_, Name>(argument)) {
                                None => None,
                                Some(item) => Some(Value::Index(self.body_named(
                                    given,
                                    item,
                                    item.name(),
                                    of.names,
                                )?)),
                            }
                        }
                        ArgumentKind::Name(named) => {
                            match given.item(argument_key::<_, Text>(argument)) {
                                None => None,
                                Some(item) => Some(Value::Index(
                                    self.index_named(named, given, item, target, of)?,
                                )),
                            }
                        }
                    };
                    if let Some(value) = value {
                        found = found.with(argument.name, value);
                    }
                }
                found
            }
        };
        Ok((order, arguments))
    }

    /// The index of the thing, other than a body, that an argument of an order names.
    fn index_named(
        &self,
        named: Named,
        table: Of<'_, ArgumentKey>,
        item: Entry<'_, Text>,
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
            Named::Line => self.line_named(table, item, of),
            Named::Bollard => {
                let known = || of.setup.world.bollards.iter().map(|bollard| bollard.name.as_str());
                let index = known().position(|known| known == item.text());
                index.ok_or_else(|| self.unknown("bollard", table, item, item.text(), known()))
            }
            Named::Body => unreachable!("the name of a body is not read as a text"),
        }
    }

    fn line_named<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Text>,
        of: &OrderNames<'_>,
    ) -> Checked<usize> {
        let known = || of.setup.world.lines.iter().map(|line| line.line.name.as_str());
        let index = of.lines.get(item.text()).copied();
        index.ok_or_else(|| self.unknown("line", table, item, item.text(), known()))
    }

    /// Turns the simulation's error about an order into an error that points to the key with the mistake.
    fn refused_order(
        &self,
        table: Of<'_, OrderKey>,
        what: Entry<'_, Anything>,
        error: &OrderError,
    ) -> ScenarioError {
        let table = table.table();
        let tables = match &what.item().value {
            fenderline_keys::checked::Value::Table(own) => [own, table],
            _ => [table, table],
        };
        let about = error.argument().and_then(|name| {
            tables.into_iter().find_map(|table| {
                let item = table.items.iter().find(|item| item.name == name)?;
                Some((table, item))
            })
        });
        let (path, span) = match about {
            Some((table, item)) => (table.path_to(item), &item.span),
            None => (table.path_to(what.item()), &what.item().key_span),
        };
        self.sources.error(span, &path, format!("`{path}`: {error}"))
    }

    /// Checks that the key of an order without arguments is true, because `let_go = false` would order nothing.
    fn only_true(&self, table: Of<'_, OrderKey>, key: Key<OrderKey, Flag>) -> Checked<()> {
        let what = table.given(key);
        if *what.flag() {
            return Ok(());
        }
        let path = table.path_of(key);
        Err(self.sources.error(&what.span, &path, format!("`{path}` must be true")))
    }
}
