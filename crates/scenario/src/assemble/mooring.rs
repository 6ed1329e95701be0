//! Reads mooring lines, bollards and line handlers.

use fenderline_contact::Vec2;
use fenderline_sim::constants::STANDARD_GRAVITY_MPS2;
use fenderline_sim::mooring::{
    ConstantTension, InboardEnd, InitialLength, LineDetails, LineKind, LineSetup, OnDeck, Tail,
    Winch,
};
use fenderline_sim::{BodySetup, BollardSetup, LineEnd, LineHandling, MooringSetup};

use super::assembly::{Assembly, Checked, Names};
use super::vessel::Decks;
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{Name, Number, Text, Vector};
use fenderline_keys::keys::mooring::{
    AT_THE_FAR_END, BollardKey, ConstantTensionKey, LineHandlingKey, LineKey, OnDeckKey, TailKey,
};
use fenderline_keys::sources::quoted;
use fenderline_keys::typed_key::{AnyKey, Anything, Key};

/// The far end of a mooring line that is made fast before the start, and the length of the line.
struct FarEnd {
    end: LineEnd,
    initial_length: InitialLength,
}

impl Assembly<'_, '_> {
    pub(super) fn lines(
        &mut self,
        lines: Tables<'_, LineKey>,
        start: (&[BodySetup], f64),
        decks: &Decks<'_>,
        names: &Names,
    ) -> Checked<Vec<MooringSetup>> {
        lines.iter().map(|(name, table)| self.line(name, table, start, decks, names)).collect()
    }

    fn line(
        &mut self,
        name: &str,
        table: Of<'_, LineKey>,
        (bodies, level_m): (&[BodySetup], f64),
        decks: &Decks<'_>,
        names: &Names,
    ) -> Checked<MooringSetup> {
        let number = |name: Key<_, Number>| *table.given(name).number();
        let from = table.given(LineKey::FROM);
        let ship = self.body_named(table, from, from.name(), names)?;
        let (fairlead_m, fairlead_above_water_m) = match self.one_of(
            table,
            LineKey::FAIRLEAD,
            LineKey::FAIRLEAD_HEIGHT,
            LineKey::CHOCK,
        )? {
            LinePoint::At(at_m, above_water_m) => (at_m, above_water_m),
            LinePoint::Named(item) => self.chock(table, item, decks[ship])?,
        };
        let far = match table.item(LineKey::TO) {
            Some(to) => Some(self.far_end(table, to, (ship, decks), names)?),
            None => {
                self.check_on_board(table)?;
                None
            }
        };
        let break_load_n = number(LineKey::BREAK_LOAD);
        let main = self.rope(table.read_as())?;
        let tail = match table.item(LineKey::TAIL).map(Entry::table) {
            Some(tail) => Some(Tail {
                rope: self.rope(tail.read_as())?,
                length_m: *tail.given(TailKey::LENGTH).number(),
            }),
            None => None,
        };
        let details = LineDetails {
            on_deck: self.on_deck(table)?,
            weight_npm: table
                .item(LineKey::MASS)
                .map_or(0.0, |item| STANDARD_GRAVITY_MPS2 * item.number()),
            working_load_n: table.item(LineKey::WORKING_LOAD).map(|item| *item.number()),
        };
        let winch = Winch {
            constant_tension: self.constant_tension(table)?,
            ..Winch::of_design(break_load_n, 100.0)
        };
        let setup = MooringSetup {
            line: LineSetup {
                name: name.to_owned(),
                kind: LineKind::Light { main, tail, details },
                inboard_end: match table.given(LineKey::WINCH).flag() {
                    true => InboardEnd::Winch(winch),
                    false => InboardEnd::Bitts,
                },
                // A line on board gets its length when it is made fast.
                initial_length: far
                    .as_ref()
                    .map_or(InitialLength::Outboard(0.0), |far| far.initial_length),
            },
            ship,
            fairlead_m,
            fairlead_above_water_m,
            end: far.map(|far| far.end),
            from_s: number(LineKey::MADE_FAST),
            rope_m: number(LineKey::ROPE_LENGTH),
        };
        if setup.from_s <= 0.0 {
            setup.check_at_start(bodies, level_m).map_err(|error| self.wrong(table, &error))?;
        }
        Ok(setup)
    }

    fn on_deck(&self, table: Of<'_, LineKey>) -> Checked<Option<OnDeck>> {
        let Some(of) = table.item(LineKey::ON_DECK).map(Entry::table) else { return Ok(None) };
        let (friction, wrap) = (of.given(OnDeckKey::FRICTION), of.given(OnDeckKey::WRAP));
        if friction.is_default && !wrap.is_default {
            let path = of.path_of(OnDeckKey::WRAP);
            let message =
                format!("`{path}` needs `friction`: without friction this key does nothing");
            return Err(self.sources.error(&wrap.key_span, &path, message));
        }
        let length_m = *of.given(OnDeckKey::LENGTH).number();
        Ok(Some(OnDeck::behind_chock(length_m, *friction.number(), *wrap.number())))
    }

    fn constant_tension(&self, table: Of<'_, LineKey>) -> Checked<Option<ConstantTension>> {
        let Some(item) = table.item(LineKey::CONSTANT_TENSION) else { return Ok(None) };
        if !table.given(LineKey::WINCH).flag() {
            let path = table.path_of(LineKey::CONSTANT_TENSION);
            let error =
                self.sources.error(&item.key_span, &path, format!("`{path}` needs `winch = true`"));
            return Err(error.with_help("a line on bitts is held until the line parts"));
        }
        let number = |name: Key<_, Number>| *item.table().given(name).number();
        Ok(Some(ConstantTension {
            tension_n: number(ConstantTensionKey::TENSION),
            band: number(ConstantTensionKey::BAND),
            heave_mps: number(ConstantTensionKey::HEAVING_SPEED),
            pay_out_mps: number(ConstantTensionKey::PAYING_OUT_SPEED),
        }))
    }

    /// Reads the far end of a mooring line that is made fast before the start.
    fn far_end(
        &self,
        table: Of<'_, LineKey>,
        to: Entry<'_, Name>,
        (ship, decks): (usize, &Decks<'_>),
        names: &Names,
    ) -> Checked<FarEnd> {
        let body = self.body_named(table, to, to.name(), names)?;
        if ship == body {
            let path = table.path_of(LineKey::TO);
            let message = format!("`{path}`: both ends are on body {}", quoted(to.name()));
            return Err(self.sources.error(&to.span, &path, message));
        }
        let (at_m, above_water_m) =
            match self.one_of(table, LineKey::BOLLARD, LineKey::BOLLARD_HEIGHT, LineKey::BITTS)? {
                LinePoint::At(at_m, above_water_m) => (at_m, above_water_m),
                LinePoint::Named(item) => self.bitts(table, item, decks[body])?,
            };
        let initial_length = match (table.item(LineKey::LENGTH), table.item(LineKey::PRETENSION)) {
            (Some(length), None) => InitialLength::Outboard(*length.number()),
            (None, Some(tension)) => InitialLength::FromPretension(*tension.number()),
            (given, _) => {
                let path = table.path_of(LineKey::PRETENSION);
                let both = given.is_some();
                let message = if both {
                    format!("`{path}` does not go together with `length`")
                } else {
                    format!("`{path}` is missing")
                };
                let error = self.sources.error(&table.span, &path, message);
                return Err(error.with_help("give the line a `length` or a `pretension`"));
            }
        };
        Ok(FarEnd { end: LineEnd::OnBody { body, at_m, above_water_m }, initial_length })
    }

    /// Refuses keys that say where or how a mooring line is made fast, for a line that is still on board.
    fn check_on_board(&self, table: Of<'_, LineKey>) -> Checked<()> {
        let given =
            AT_THE_FAR_END.iter().find_map(|key| table.item(*key).filter(|item| !item.is_default));
        let Some(item) = given else { return Ok(()) };
        let path = table.path_to(item);
        let message = format!("`{path}` needs `to`: a line without `to` is on board");
        let error = self.sources.error(&item.key_span, &path, message);
        Err(error.with_help("name the body at the far end of the line in `to`, or remove this key"))
    }

    pub(super) fn bollards(
        &self,
        bollards: Tables<'_, BollardKey>,
        names: &Names,
    ) -> Checked<Vec<BollardSetup>> {
        let bollard = |(name, table): (&String, Of<'_, _>)| {
            let on = table.given(BollardKey::ON);
            Ok(BollardSetup {
                name: name.clone(),
                body: self.body_named(table, on, on.name(), names)?,
                at_m: *table.given(BollardKey::AT).vector(),
                above_water_m: *table.given(BollardKey::HEIGHT).number(),
                most_lines: self.count(table, BollardKey::LINES)?,
            })
        };
        bollards.iter().map(bollard).collect()
    }

    pub(super) fn line_handling(&self, table: Of<'_, LineHandlingKey>) -> Checked<LineHandling> {
        let number = |name: Key<_, Number>| *table.given(name).number();
        let (boat, speed) =
            (table.given(LineHandlingKey::BOAT).flag(), table.given(LineHandlingKey::BOAT_SPEED));
        if !boat && !speed.is_default {
            let path = table.path_of(LineHandlingKey::BOAT_SPEED);
            let message = format!("`{path}` does not go together with `boat = false`");
            return Err(self.sources.error(&speed.key_span, &path, message));
        }
        Ok(LineHandling {
            gangs: self.count(table, LineHandlingKey::GANGS)?,
            heaving_line_m: number(LineHandlingKey::HEAVING_LINE),
            heaving_line_s: number(LineHandlingKey::TIME),
            boat_mps: boat.then(|| *speed.number()),
        })
    }

    /// Reads a whole number.
    pub(super) fn count<T>(&self, table: Of<'_, T>, key: Key<T, Number>) -> Checked<usize> {
        let item = table.given(key);
        let value = *item.number();
        if value.fract() != 0.0 {
            let path = table.path_of(key);
            let message = format!("`{path}` must be a whole number, but is {value}");
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(value as usize)
    }

    /// Reads where the end of a mooring line is fastened, by coordinates or by the name of a point of the vessel.
    fn one_of<'t>(
        &self,
        table: Of<'t, LineKey>,
        place: Key<LineKey, Vector>,
        height: Key<LineKey, Number>,
        name: Key<LineKey, Text>,
    ) -> Checked<LinePoint<'t>> {
        let height = table.given(height);
        match (table.item(place), table.item(name)) {
            (Some(at), None) => Ok(LinePoint::At(*at.vector(), *height.number())),
            (None, Some(item)) if height.is_default => Ok(LinePoint::Named(item)),
            (None, Some(_)) => Err(self.beside(table, height.any(), name.any())),
            (Some(_), Some(item)) => Err(self.beside(table, item.any(), place.any())),
            (None, None) => {
                let path = table.path_of(place);
                let error = self.sources.error(&table.span, &path, format!("`{path}` is missing"));
                Err(error.with_help(format!("give `{place}`, or the name of a point in `{name}`")))
            }
        }
    }

    fn beside(
        &self,
        table: Of<'_, LineKey>,
        item: Entry<'_, Anything>,
        other: AnyKey<LineKey>,
    ) -> ScenarioError {
        let path = table.path_to(item);
        let message = format!("`{path}` does not go together with `{other}`");
        let error = self.sources.error(&item.key_span, &path, message);
        error.with_help("keep only one of the two keys")
    }
}

/// Where the end of a mooring line is fastened.
enum LinePoint<'t> {
    /// A place relative to the body's origin, and a height above the water (m).
    At(Vec2, f64),
    /// A chock or bitts.
    Named(Entry<'t, Text>),
}
