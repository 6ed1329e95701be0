//! The exercise.

use fenderline_contact::number::lesser;
use fenderline_sim::Setup;
use fenderline_sim::berth::Berth;
use fenderline_sim::exercise::{Condition, ExerciseSetup, Limit, Measure};

use super::unused::listed;
use super::{Assembly, Checked, Names};
use crate::checked::{Item, Table};
use crate::keys::exercise::GoalWord;
use crate::sources::quoted;
use crate::suggest::nearest;

/// Farthest from the fenders of a ship that is alongside, unless the scenario says otherwise (m); our choice.
const ALONGSIDE_M: f64 = 0.5;
/// Nearest to the fenders of a ship that is clear of them, unless the scenario says otherwise (m); our choice.
const CLEAR_M: f64 = 30.0;

impl Assembly<'_, '_> {
    pub(super) fn exercise(
        &mut self,
        table: Option<&Table>,
        setup: &Setup,
        names: &Names,
    ) -> Checked<Option<ExerciseSetup>> {
        let Some(table) = table else { return Ok(None) };
        let vessel = self.vessel_of_exercise(table, setup, names)?;
        let berth = self.berth_of_exercise(table, setup, vessel, names)?;
        let goal = self.goal(table, setup, vessel)?;
        let limits = self.limits(table.given("limit").table(), setup, berth)?;
        let needs_berth = goal.iter().any(Condition::needs_berth)
            || limits.iter().any(|limit| limit.measure.needs_berth());
        if needs_berth && berth.is_none() {
            let path = table.path_of("berth");
            let message = format!("`{path}`: no body without a vessel has fenders");
            let error = self.sources.error(&table.span, &path, message);
            return Err(error.with_help("name the body whose fenders are the berth"));
        }
        Ok(Some(ExerciseSetup {
            task: table.item("task").map_or_else(String::new, |item| item.text().to_owned()),
            vessel,
            berth,
            goal,
            hold_s: *table.given("hold").number(),
            time_limit_s: table.item("time_limit").map_or(f64::INFINITY, |item| *item.number()),
            pass_mark: *table.given("pass_mark").number(),
            limits,
        }))
    }

    fn vessel_of_exercise(&self, table: &Table, setup: &Setup, names: &Names) -> Checked<usize> {
        let item = table.given("vessel");
        let body = self.body_named(table, item, item.name(), names)?;
        let found = setup.world.vessels.iter().position(|vessel| vessel.body == body);
        found.ok_or_else(|| {
            let path = table.path_of(item.name);
            let message = format!("`{path}`: body {} is no vessel", quoted(item.name()));
            self.sources.error(&item.span, &path, message)
        })
    }

    fn berth_of_exercise(
        &self,
        table: &Table,
        setup: &Setup,
        vessel: usize,
        names: &Names,
    ) -> Checked<Option<Berth>> {
        let vessels = &setup.world.vessels;
        let own = vessels[vessel].body;
        let Some(item) = table.item("berth") else {
            let is_vessel = |body: usize| vessels.iter().any(|other| other.body == body);
            return Ok(Berth::of(setup, own, |body| !is_vessel(body)));
        };
        let path = table.path_of(item.name);
        let body = self.body_named(table, item, item.name(), names)?;
        if body == own {
            let message = format!("`{path}`: a ship is not her own berth");
            return Err(self.sources.error(&item.span, &path, message));
        }
        let berth = Berth::of(setup, own, |other| other == body);
        berth.map(Some).ok_or_else(|| {
            let message = format!("`{path}`: body {} has no fenders", quoted(item.name()));
            self.sources.error(&item.span, &path, message)
        })
    }

    /// The conditions that the word of the goal stands for.
    fn goal(&self, table: &Table, setup: &Setup, vessel: usize) -> Checked<Vec<Condition>> {
        let word: GoalWord = table.given("goal").choice();
        self.check_keys_of_goal(table, word)?;
        let distance_m = |default_m: f64| table.item("distance").map_or(default_m, |d| *d.number());
        let at_rest = Condition::AtRest { at_most_mps: *table.given("rest_speed").number() };
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
        })
    }

    /// Refuses keys that the goal does not use.
    fn check_keys_of_goal(&self, table: &Table, word: GoalWord) -> Checked<()> {
        let unused: &[&'static str] = match word {
            GoalWord::AllFast => &[],
            GoalWord::Alongside => &["lines", "at_least", "least_tension", "most_tension"],
            GoalWord::Clear => {
                &["lines", "at_least", "least_tension", "most_tension", "rest_speed"]
            }
        };
        let given = unused.iter().filter_map(|name| table.item(name)).find(|item| !item.is_default);
        given.map_or(Ok(()), |item| {
            let path = table.path_of(item.name);
            let goal = table.given("goal").word();
            let message = format!("`{path}` does not go together with the goal \"{goal}\"");
            Err(self.sources.error(&item.key_span, &path, message))
        })
    }

    fn lines_fast(&self, table: &Table, setup: &Setup, vessel: usize) -> Checked<Condition> {
        let lines = match table.item("lines") {
            Some(item) => self.lines_named(table, item, setup)?,
            None => own_lines(setup, vessel).collect(),
        };
        let path = table.path_of("lines");
        if lines.is_empty() {
            let span = table.item("lines").map_or(&table.span, |item| &item.span);
            let message = format!("`{path}`: the ship has no lines");
            return Err(self.sources.error(span, &path, message));
        }
        let at_least = match table.item("at_least") {
            None => lines.len(),
            Some(item) => {
                let (number, path) = (*item.number(), table.path_of("at_least"));
                if number.fract() != 0.0 || number > lines.len() as f64 {
                    let message = format!(
                        "`{path}`: {number} is not a whole number of up to {} lines",
                        lines.len()
                    );
                    return Err(self.sources.error(&item.span, &path, message));
                }
                number as usize
            }
        };
        let number = |name: &str, without: f64| table.item(name).map_or(without, |i| *i.number());
        let tension_n = [number("least_tension", 0.0), number("most_tension", f64::INFINITY)];
        if tension_n[0] > tension_n[1] {
            let path = table.path_of("most_tension");
            let message = format!("`{path}` is less than `least_tension`");
            return Err(self.sources.error(&table.given("most_tension").span, &path, message));
        }
        Ok(Condition::LinesFast { lines, at_least, tension_n })
    }

    fn lines_named(&self, table: &Table, item: &Item, setup: &Setup) -> Checked<Vec<usize>> {
        let all = || setup.world.lines.iter().map(|line| line.line.name.as_str());
        let path = table.path_of(item.name);
        let mut lines = Vec::new();
        for name in item.texts() {
            let Some(line) = all().position(|other| other == name) else {
                let message = format!("`{path}`: there is no line {}", quoted(name));
                let error = self.sources.error(&item.span, &path, message);
                return Err(error.with_help(match nearest(name, all()) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("the scenario has the lines {}", listed(all())),
                }));
            };
            if lines.contains(&line) {
                let message = format!("`{path}`: {} is there twice", quoted(name));
                return Err(self.sources.error(&item.span, &path, message));
            }
            lines.push(line);
        }
        Ok(lines)
    }

    fn limits(
        &mut self,
        table: &Table,
        setup: &Setup,
        berth: Option<Berth>,
    ) -> Checked<Vec<Limit>> {
        let given = Measure::ALL
            .into_iter()
            .filter_map(|measure| table.item(measure.key()).map(|item| (measure, item.table())));
        given.map(|(measure, limit)| self.limit(measure, limit, setup, berth)).collect()
    }

    fn limit(
        &mut self,
        measure: Measure,
        table: &Table,
        setup: &Setup,
        berth: Option<Berth>,
    ) -> Checked<Limit> {
        let is_structure = |(index, body): (usize, &fenderline_sim::BodySetup)| {
            body.is_fixed() && berth.is_none_or(|berth| berth.body != index)
        };
        if measure == Measure::Clearance && !setup.bodies.iter().enumerate().any(is_structure) {
            self.note(table, "never exceeded: there is no fixed body but the berth");
        }
        if measure == Measure::UnderKeel && setup.world.environment.depth_m.is_none() {
            self.note(table, "never exceeded: `[environment]` has no `depth`");
        }
        let number = |name: &str| table.item_if_any(name).map(|item| *item.number());
        let (bound, worst) = match measure {
            Measure::Touch => (0.0, 1.0),
            _ if measure.is_least() => {
                (*table.given("least").number(), *table.given("worst").number())
            }
            _ => {
                let most = *table.given("most").number();
                (most, number("worst").unwrap_or(2.0 * most))
            }
        };
        let is_beyond = if measure.is_least() { worst <= bound } else { worst >= bound };
        if !is_beyond {
            let path = table.path_of("worst");
            let side = if measure.is_least() { "above `least`" } else { "below `most`" };
            let message =
                format!("`{path}` is {side}: it costs all points, so it is the worse value");
            return Err(self.sources.error(&table.given("worst").span, &path, message));
        }
        Ok(Limit {
            measure,
            bound,
            worst,
            points: *table.given("points").number(),
            fails: *table.given("fails").flag(),
            within_m: lesser(number("within").unwrap_or(f64::INFINITY), f64::INFINITY),
        })
    }
}

/// The lines of a ship: those whose fairlead is on her.
fn own_lines(setup: &Setup, vessel: usize) -> impl Iterator<Item = usize> {
    let body = setup.world.vessels[vessel].body;
    let lines = setup.world.lines.iter().enumerate();
    lines.filter(move |(_, line)| line.ship == body).map(|(index, _)| index)
}
