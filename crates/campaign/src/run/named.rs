//! Outputs of one fender, line, body or tug, as `fender.NAME.reaction`.

use fenderline_results::scales::{DEGREES, DEGREES_PER_SECOND, METRES, METRES_PER_SECOND};
use fenderline_results::{
    FENDERS, LINES, LineTotals, Quantity, TUGS, TugTotals, WorldTotals, number,
};
use fenderline_scenario::nearest;
use fenderline_sim::{FenderSetup, FenderSummary, MooringSetup, Setup, Simulation, TugSetup};

use super::motion::Excursion;
use crate::row::{Cell, Head};

/// An output of one part of the scenario, such as a fender or a line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Named {
    Fender(usize, &'static OfFender),
    Line(usize, &'static OfLine),
    Body(usize, &'static OfBody),
    Tug(usize, &'static OfTug),
    /// The value of a limit of the scenario, by the limit's index.
    Limit(usize),
}

type OfFender = Quantity<FenderSetup, FenderSummary>;
type OfLine = Quantity<MooringSetup, LineTotals>;
type OfBody = Quantity<(), Excursion>;
type OfTug = Quantity<TugSetup, TugTotals>;

/// Outputs of a body's motion, which only campaigns have.
static OF_BODIES: [OfBody; 8] = [
    number(
        "largest_surge_m",
        "m",
        "largest distance from the start, along the body's longitudinal axis at the start",
        |(), of: &Excursion| of.surge_m,
    )
    .output("largest_surge", METRES),
    number(
        "largest_sway_m",
        "m",
        "largest distance from the start, across the body's longitudinal axis at the start",
        |(), of: &Excursion| of.sway_m,
    )
    .output("largest_sway", METRES),
    number("largest_yaw_rad", "rad", "largest change of heading", |(), of: &Excursion| of.yaw_rad)
        .output("largest_yaw", DEGREES),
    number("end_north_m", "m", "north at the end", |(), of: &Excursion| of.last.position_m.x)
        .output("end_north", METRES),
    number("end_east_m", "m", "east at the end", |(), of: &Excursion| of.last.position_m.y)
        .output("end_east", METRES),
    number("end_heading_rad", "rad", "heading at the end", |(), of: &Excursion| {
        of.last.heading_rad
    })
    .output("end_heading", DEGREES),
    number("end_speed_mps", "m/s", "speed over the ground at the end", |(), of: &Excursion| {
        of.last.velocity_mps.length()
    })
    .output("end_speed", METRES_PER_SECOND),
    number("end_turn_radps", "rad/s", "rate of turn at the end", |(), of: &Excursion| {
        of.last.yaw_rate_radps
    })
    .output("end_turn", DEGREES_PER_SECOND),
];

impl Named {
    /// Reads the output that a text such as `fender.NAME.reaction` names.
    ///
    /// # Errors
    /// Fails if the text has another form, if the scenario does not have the part, or if the part does not have the
    /// quantity.
    pub(super) fn parse(text: &str, setup: &Setup) -> Result<Named, String> {
        if let Some(name) = text.strip_prefix("limit.") {
            let limits = setup.world.statistics.limits.iter();
            return Ok(Named::Limit(place("limit", name, limits.map(|own| own.name.as_str()))?));
        }
        let parts = text.split_once('.').and_then(|(kind, rest)| {
            let (name, quantity) = rest.rsplit_once('.')?;
            Some((kind, name, quantity))
        });
        let form = || {
            format!(
                "\"{text}\" is not of the form fender.NAME.reaction, line.NAME.tension, body.NAME.largest_sway, tug.NAME.force or limit.NAME"
            )
        };
        let (kind, name, quantity) = parts.ok_or_else(form)?;
        let world = &setup.world;
        match kind {
            "fender" => {
                let index = place(kind, name, setup.fenders.iter().map(|own| own.name.as_str()))?;
                Ok(Named::Fender(index, of(kind, quantity, FENDERS.quantities)?))
            }
            "line" => {
                let index =
                    place(kind, name, world.lines.iter().map(|own| own.line.name.as_str()))?;
                Ok(Named::Line(index, of(kind, quantity, LINES.quantities)?))
            }
            "body" => {
                let index = place(kind, name, setup.bodies.iter().map(|own| own.name.as_str()))?;
                Ok(Named::Body(index, of(kind, quantity, &OF_BODIES)?))
            }
            "tug" => {
                let index = place(kind, name, world.tugs.iter().map(|own| own.tug.name.as_str()))?;
                Ok(Named::Tug(index, of(kind, quantity, TUGS.quantities)?))
            }
            _ => Err(form()),
        }
    }

    /// The body whose motion the output needs, if it needs one.
    pub(super) fn body(self) -> Option<usize> {
        match self {
            Named::Body(index, _) => Some(index),
            _ => None,
        }
    }

    pub(super) fn head(self, name: &str) -> Head {
        let (unit, meaning) = match self {
            Named::Fender(_, own) => unit_and_meaning(own),
            Named::Line(_, own) => unit_and_meaning(own),
            Named::Body(_, own) => unit_and_meaning(own),
            Named::Tug(_, own) => unit_and_meaning(own),
            Named::Limit(_) => {
                ("%", "the limited quantity's largest value as a share of the permissible value")
            }
        };
        Head::new(name, unit, meaning)
    }

    pub(super) fn cell(
        self,
        simulation: &Simulation,
        world: &WorldTotals,
        motions: &[(usize, Excursion)],
    ) -> Cell {
        let setup = simulation.setup();
        let value = match self {
            Named::Fender(index, own) => {
                let mut all = simulation.fender_summaries();
                let touched = all.find(|summary| summary.fender == index);
                touched.and_then(|summary| value(own, &setup.fenders[index], summary))
            }
            Named::Line(index, own) => value(own, &setup.world.lines[index], &world.lines[index]),
            Named::Body(index, own) => motions
                .iter()
                .find(|(body, _)| *body == index)
                .and_then(|(_, motion)| value(own, &(), motion)),
            Named::Tug(index, own) => value(own, &setup.world.tugs[index], &world.tugs[index]),
            Named::Limit(index) => {
                let limit = &setup.world.statistics.limits[index];
                Some(100.0 * simulation.limit_values()[index] / limit.most)
            }
        };
        value.map_or(Cell::Empty, Cell::of_number)
    }
}

fn place<'n>(
    kind: &str,
    name: &str,
    mut names: impl Iterator<Item = &'n str> + Clone,
) -> Result<usize, String> {
    let all = names.clone();
    names.position(|own| own == name).ok_or_else(|| {
        let near =
            nearest(name, all).map_or(String::new(), |near| format!("; did you mean `{near}`?"));
        format!("the scenario has no {kind} `{name}`{near}")
    })
}

/// Finds the quantity that has the given output name.
fn of<S, T>(
    kind: &str,
    name: &str,
    all: &'static [Quantity<S, T>],
) -> Result<&'static Quantity<S, T>, String> {
    let mut outputs = all.iter().filter_map(|own| Some((own, own.output?.0)));
    outputs.find(|(_, output)| *output == name).map(|(own, _)| own).ok_or_else(|| {
        let names = all.iter().filter_map(|own| own.output);
        let names: Vec<&str> = names.map(|(output, _)| output).collect();
        format!("a {kind} has no `{name}`; it has {}", names.join(", "))
    })
}

fn unit_and_meaning<S, T>(of: &Quantity<S, T>) -> (&'static str, &'static str) {
    (of.output.map_or(of.unit, |(_, scale)| scale.unit), of.meaning)
}

/// The value of a quantity in a run, in the unit of the output.
fn value<S, T>(of: &Quantity<S, T>, setup: &S, summary: &T) -> Option<f64> {
    let value = of.amount(setup, Some(summary)).number()?;
    Some(of.output.map_or(value, |(_, scale)| scale.product(value)))
}
