//! The exercise.

use fenderline_contact::number::lesser;
use fenderline_sim::Setup;
use fenderline_sim::berth::Berth;
use fenderline_sim::exercise::{AnchorPlace, BerthMark, Condition, ExerciseSetup, Limit, Measure};

use super::assembly::listed;
use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::{Number, Texts};
use fenderline_keys::keys::exercise::{
    ExerciseKey, ExerciseLimitKey, GoalWord, MarkKey, ScoreKey, limit_key,
};
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;
use fenderline_keys::typed_key::Key;

/// Largest distance from the fenders at which a ship counts as alongside, unless the scenario gives another
/// distance (m); our choice.
const ALONGSIDE_M: f64 = 0.5;
/// Least distance from the fenders at which a ship counts as clear, unless the scenario gives another
/// distance (m); our choice.
const CLEAR_M: f64 = 30.0;

/// Largest distance of an anchor from its required place, unless the scenario gives another distance (m);
/// our choice.
const AT_PLACE_M: f64 = 50.0;

impl Assembly<'_, '_> {
    pub(super) fn exercise(
        &mut self,
        table: Option<Of<'_, ExerciseKey>>,
        setup: &Setup,
        names: &Names,
    ) -> Checked<Option<ExerciseSetup>> {
        let Some(table) = table else { return Ok(None) };
        let vessel = self.vessel_of_exercise(table, setup, names)?;
        let berth = self.berth_of_exercise(table, setup, vessel, names)?;
        let goal = self.goal(table, setup, vessel)?;
        let limits = self.limits(table.given(ExerciseKey::LIMIT).table(), setup, vessel, berth)?;
        let needs_berth = goal.iter().any(Condition::needs_berth)
            || limits.iter().any(|limit| limit.measure.needs_berth())
            || table.item(ExerciseKey::MARK).is_some();
        if needs_berth && berth.is_none() {
            let path = table.path_of(ExerciseKey::BERTH);
            let message = format!("`{path}`: no body without a vessel has fenders");
            let error = self.sources.error(&table.span, &path, message);
            return Err(error.with_help("name the body whose fenders are the berth"));
        }
        Ok(Some(ExerciseSetup {
            task: table
                .item(ExerciseKey::TASK)
                .map_or_else(String::new, |item| item.text().to_owned()),
            vessel,
            berth,
            mark: table.item(ExerciseKey::MARK).map(|item| mark(item.table(), setup, vessel)),
            goal,
            hold_s: *table.given(ExerciseKey::HOLD).number(),
            time_limit_s: table
                .item(ExerciseKey::TIME_LIMIT)
                .map_or(f64::INFINITY, |item| *item.number()),
            view_marks: *table.given(ExerciseKey::VIEW_MARKS).flag(),
            pass_mark: *table.given(ExerciseKey::PASS_MARK).number(),
            limits,
        }))
    }

    fn vessel_of_exercise(
        &self,
        table: Of<'_, ExerciseKey>,
        setup: &Setup,
        names: &Names,
    ) -> Checked<usize> {
        let item = table.given(ExerciseKey::VESSEL);
        let body = self.body_named(table, item, item.name(), names)?;
        let found = setup.world.vessels.iter().position(|vessel| vessel.body == body);
        found.ok_or_else(|| {
            let path = table.path_to(item);
            let message = format!("`{path}`: body {} is no vessel", quoted(item.name()));
            self.sources.error(&item.span, &path, message)
        })
    }

    fn berth_of_exercise(
        &self,
        table: Of<'_, ExerciseKey>,
        setup: &Setup,
        vessel: usize,
        names: &Names,
    ) -> Checked<Option<Berth>> {
        let vessels = &setup.world.vessels;
        let own = vessels[vessel].body;
        let Some(item) = table.item(ExerciseKey::BERTH) else {
            let is_vessel = |body: usize| vessels.iter().any(|other| other.body == body);
            return Ok(Berth::of(setup, own, |body| !is_vessel(body)));
        };
        let path = table.path_to(item);
        let body = self.body_named(table, item, item.name(), names)?;
        if body == own {
            let message = format!("`{path}`: a ship cannot be her own berth");
            return Err(self.sources.error(&item.span, &path, message));
        }
        let berth = Berth::of(setup, own, |other| other == body);
        berth.map(Some).ok_or_else(|| {
            let message = format!("`{path}`: body {} has no fenders", quoted(item.name()));
            self.sources.error(&item.span, &path, message)
        })
    }

    /// The conditions for which the word of the goal stands.
    fn goal(
        &self,
        table: Of<'_, ExerciseKey>,
        setup: &Setup,
        vessel: usize,
    ) -> Checked<Vec<Condition>> {
        let word: GoalWord = table.given(ExerciseKey::GOAL).choice();
        self.check_keys_of_goal(table, word)?;
        let distance_m =
            |default_m: f64| table.item(ExerciseKey::DISTANCE).map_or(default_m, |d| *d.number());
        let at_rest =
            Condition::AtRest { at_most_mps: *table.given(ExerciseKey::REST_SPEED).number() };
        let alongside = || Condition::Alongside { within_m: distance_m(ALONGSIDE_M) };
        Ok(match word {
            GoalWord::AllFast => vec![alongside(), at_rest, self.lines_fast(table, setup, vessel)?],
            GoalWord::Alongside => vec![alongside(), at_rest],
            GoalWord::Clear => {
                let lines = own_lines(setup, vessel).collect();
                vec![
                    Condition::Clear { by_m: distance_m(CLEAR_M) },
                    Condition::LinesAboard { lines },
                ]
            }
            GoalWord::Anchored => vec![self.anchors_hold(table, setup, vessel)?, at_rest],
        })
    }

    /// Refuses keys that do not apply to the goal of the exercise.
    fn check_keys_of_goal(&self, table: Of<'_, ExerciseKey>, word: GoalWord) -> Checked<()> {
        let unused = word.unused().iter();
        let given = unused.filter_map(|key| table.item(*key)).find(|item| !item.is_default);
        given.map_or(Ok(()), |item| {
            let path = table.path_to(item);
            let goal = table.given(ExerciseKey::GOAL).word();
            let message = format!("`{path}` does not go together with the goal \"{goal}\"");
            Err(self.sources.error(&item.key_span, &path, message))
        })
    }

    fn lines_fast(
        &self,
        table: Of<'_, ExerciseKey>,
        setup: &Setup,
        vessel: usize,
    ) -> Checked<Condition> {
        let all: Vec<usize> = own_lines(setup, vessel).collect();
        let lines = match table.item(ExerciseKey::LINES) {
            Some(item) => {
                let names = setup.world.lines.iter().map(|line| line.line.name.as_str());
                self.named(table, item, "line", &names.collect::<Vec<_>>())?
            }
            None => all,
        };
        let path = table.path_of(ExerciseKey::LINES);
        if lines.is_empty() {
            let span = table.item(ExerciseKey::LINES).map_or(&table.span, |item| &item.item().span);
            let message = format!("`{path}`: the ship has no lines");
            return Err(self.sources.error(span, &path, message));
        }
        let at_least = self.at_least(table, lines.len(), "lines")?.unwrap_or(lines.len());
        let number =
            |name: Key<_, Number>, without: f64| table.item(name).map_or(without, |i| *i.number());
        let tension_n = [
            number(ExerciseKey::LEAST_TENSION, 0.0),
            number(ExerciseKey::MOST_TENSION, f64::INFINITY),
        ];
        if tension_n[0] > tension_n[1] {
            let path = table.path_of(ExerciseKey::MOST_TENSION);
            let message = format!("`{path}` is less than `least_tension`");
            return Err(self.sources.error(
                &table.given(ExerciseKey::MOST_TENSION).span,
                &path,
                message,
            ));
        }
        Ok(Condition::LinesFast { lines, at_least, tension_n })
    }

    /// The number of mooring lines or anchors that the goal of the exercise needs; `None` if the scenario gives no
    /// number.
    fn at_least(
        &self,
        table: Of<'_, ExerciseKey>,
        of: usize,
        what: &str,
    ) -> Checked<Option<usize>> {
        let Some(item) = table.item(ExerciseKey::AT_LEAST) else { return Ok(None) };
        let (number, path) = (*item.number(), table.path_of(ExerciseKey::AT_LEAST));
        if number.fract() != 0.0 || number > of as f64 {
            let message =
                format!("`{path}` must be a whole number of at most {of} {what}, but is {number}");
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(Some(number as usize))
    }

    fn anchors_hold(
        &self,
        table: Of<'_, ExerciseKey>,
        setup: &Setup,
        vessel: usize,
    ) -> Checked<Condition> {
        let all = || setup.world.anchors.iter().enumerate();
        let own = || all().filter(|(_, anchor)| anchor.vessel == vessel);
        let anchors: Vec<usize> = match table.item(ExerciseKey::ANCHORS) {
            Some(item) => {
                let names: Vec<&str> = all().map(|(_, of)| of.gear.name.as_str()).collect();
                let given = self.named(table, item, "anchor", &names)?;
                if let Some(other) =
                    given.iter().find(|&&of| setup.world.anchors[of].vessel != vessel)
                {
                    let path = table.path_of(ExerciseKey::ANCHORS);
                    let message = format!("`{path}`: {} is on another ship", quoted(names[*other]));
                    return Err(self.sources.error(&item.span, &path, message));
                }
                given
            }
            None => own().map(|(index, _)| index).collect(),
        };
        if anchors.is_empty() {
            let path = table.path_of(ExerciseKey::ANCHORS);
            let span =
                table.item(ExerciseKey::ANCHORS).map_or(&table.span, |item| &item.item().span);
            let message = format!("`{path}`: the ship has no anchors");
            return Err(self.sources.error(span, &path, message));
        }
        let at_least = self.at_least(table, anchors.len(), "anchors")?.unwrap_or(1);
        let chain_m = table.item(ExerciseKey::CHAIN_OUT).map_or(0.0, |item| *item.number());
        if let Some(item) = table.item(ExerciseKey::CHAIN_OUT) {
            let lengths = anchors.iter().map(|&of| setup.world.anchors[of].gear.chain_length_m);
            let enough = lengths.filter(|&length_m| length_m >= chain_m).count();
            if enough < at_least {
                let path = table.path_of(ExerciseKey::CHAIN_OUT);
                let message = format!(
                    "`{path}`: {enough} of the anchors have a chain of {chain_m} m, but the goal \
                     needs {at_least} such anchors"
                );
                return Err(self.sources.error(&item.span, &path, message));
            }
        }
        Ok(Condition::AnchorsHold { anchors, at_least, chain_m, place: self.anchor_place(table)? })
    }

    /// Reads where anchors must lie; the key `distance` needs the key `position`.
    fn anchor_place(&self, table: Of<'_, ExerciseKey>) -> Checked<Option<AnchorPlace>> {
        let within_m = table.item(ExerciseKey::DISTANCE).map(|item| *item.number());
        match (table.item(ExerciseKey::POSITION), table.item(ExerciseKey::DISTANCE)) {
            (Some(at), _) => {
                let within_m = within_m.unwrap_or(AT_PLACE_M);
                Ok(Some(AnchorPlace { at_m: *at.vector(), within_m }))
            }
            (None, None) => Ok(None),
            (None, Some(distance)) => {
                let path = table.path_of(ExerciseKey::DISTANCE);
                let message = format!("`{path}` needs `position` with the goal \"anchored\"");
                Err(self.sources.error(&distance.key_span, &path, message))
            }
        }
    }

    /// Finds things of the scenario, such as mooring lines, by a list of names that has each name once. `what` is the
    /// kind of thing, `all` the names of all things of this kind.
    fn named<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Texts>,
        what: &str,
        all: &[&str],
    ) -> Checked<Vec<usize>> {
        let path = table.path_to(item);
        let names = || all.iter().copied();
        let mut found = Vec::new();
        for name in item.texts() {
            let Some(place) = names().position(|other| other == name) else {
                let message = format!("`{path}`: there is no {what} {}", quoted(name));
                let error = self.sources.error(&item.span, &path, message);
                return Err(error.with_help(match nearest(name, names()) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("the scenario has the {what}s {}", listed(names())),
                }));
            };
            if found.contains(&place) {
                let message = format!("`{path}`: {} is there twice", quoted(name));
                return Err(self.sources.error(&item.span, &path, message));
            }
            found.push(place);
        }
        Ok(found)
    }

    fn limits(
        &mut self,
        table: Of<'_, ExerciseLimitKey>,
        setup: &Setup,
        vessel: usize,
        berth: Option<Berth>,
    ) -> Checked<Vec<Limit>> {
        let given = Measure::ALL.into_iter().filter_map(|measure| {
            table.item(limit_key(measure)).map(|item| (measure, item.table()))
        });
        given.map(|(measure, limit)| self.limit(measure, limit, setup, vessel, berth)).collect()
    }

    fn limit(
        &mut self,
        measure: Measure,
        table: Of<'_, ScoreKey>,
        setup: &Setup,
        vessel: usize,
        berth: Option<Berth>,
    ) -> Checked<Limit> {
        let is_structure = |(index, body): (usize, &fenderline_sim::BodySetup)| {
            body.is_fixed() && berth.is_none_or(|berth| berth.body != index)
        };
        if measure == Measure::Clearance && !setup.bodies.iter().enumerate().any(is_structure) {
            self.note(
                table,
                "no effect: the limit is never exceeded, because there is no fixed body but the \
                 berth",
            );
        }
        if measure == Measure::UnderKeel && setup.world.environment.is_deep() {
            self.note(
                table,
                "no effect: the limit is never exceeded, because `[environment]` has no `depth`",
            );
        }
        if measure == Measure::CrossTrack && setup.world.vessels[vessel].plan.is_none() {
            self.note(
                table,
                "no effect: the limit is never exceeded, because the ship has no passage plan",
            );
        }
        let number = |name: Key<_, Number>| table.item_if_any(name).map(|item| *item.number());
        let (bound, worst) = match measure {
            Measure::Touch => (0.0, 1.0),
            _ if measure.is_least() => {
                (*table.given(ScoreKey::LEAST).number(), *table.given(ScoreKey::WORST).number())
            }
            _ => {
                let most = *table.given(ScoreKey::MOST).number();
                (most, number(ScoreKey::WORST).unwrap_or(2.0 * most))
            }
        };
        let is_beyond = if measure.is_least() { worst <= bound } else { worst >= bound };
        if !is_beyond {
            let path = table.path_of(ScoreKey::WORST);
            let side = if measure.is_least() { "above `least`" } else { "below `most`" };
            let message = format!(
                "`{path}` is {side}, but the value that costs all points must be the worse value"
            );
            return Err(self.sources.error(&table.given(ScoreKey::WORST).span, &path, message));
        }
        Ok(Limit {
            measure,
            bound,
            worst,
            points: *table.given(ScoreKey::POINTS).number(),
            fails: *table.given(ScoreKey::FAILS).flag(),
            within_m: lesser(number(ScoreKey::WITHIN).unwrap_or(f64::INFINITY), f64::INFINITY),
        })
    }
}

/// The mark of the berth for the docking board.
fn mark(table: Of<'_, MarkKey>, setup: &Setup, vessel: usize) -> BerthMark {
    let outline = &setup.bodies[setup.world.vessels[vessel].body].outline;
    BerthMark {
        name: table.item(MarkKey::NAME).map_or_else(String::new, |item| item.text().to_owned()),
        at_m: *table.given(MarkKey::AT).vector(),
        of_ship_m: table
            .item(MarkKey::OF_SHIP)
            .map_or_else(|| outline.bounds().1.x, |item| *item.number()),
    }
}

/// The indices of a ship's mooring lines, which are the lines whose fairlead is on the ship.
fn own_lines(setup: &Setup, vessel: usize) -> impl Iterator<Item = usize> {
    let body = setup.world.vessels[vessel].body;
    let lines = setup.world.lines.iter().enumerate();
    lines.filter(move |(_, line)| line.ship == body).map(|(index, _)| index)
}
