//! Outputs of one fender, line, body or tug, as `fender.NAME.reaction`.

use fenderline_results::WorldTotals;
use fenderline_scenario::nearest;
use fenderline_sim::{FenderSummary, Setup, Simulation};

use super::motion::Excursion;
use crate::row::{Cell, Head};

/// An output of one part of the scenario.
#[derive(Clone, Copy, Debug)]
pub(super) enum Named {
    Fender(usize, &'static OfFender),
    Line(usize, &'static OfLine),
    Body(usize, &'static OfBody),
    Tug(usize, &'static OfTug),
    /// A limit of the scenario.
    Limit(usize),
}

/// A quantity: name, unit, meaning, value.
#[derive(Debug)]
pub(super) struct Quantity<T: ?Sized + 'static> {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&T) -> Option<f64>,
}

type OfFender = Quantity<FenderSummary>;
type OfLine = Quantity<fenderline_results::LineTotals>;
type OfBody = Quantity<Excursion>;
type OfTug = Quantity<fenderline_results::TugTotals>;

const fn quantity<T>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&T) -> Option<f64>,
) -> Quantity<T> {
    Quantity { name, unit, meaning, value }
}

static OF_FENDERS: [OfFender; 11] = [
    quantity("reaction", "kN", "largest reaction", |of| Some(of.peak_reaction_n * 1e-3)),
    quantity("reaction_share", "%", "over its rated reaction", |of| {
        of.share_of_rated_reaction.map(|x| 100.0 * x)
    }),
    quantity("deflection", "mm", "largest deflection", |of| Some(of.peak_deflection_m * 1e3)),
    quantity("deflection_share", "%", "over its rated deflection", |of| {
        of.share_of_rated_deflection.map(|x| 100.0 * x)
    }),
    quantity("energy", "kJ", "largest energy absorbed", |of| Some(of.peak_energy_j * 1e-3)),
    quantity("energy_share", "%", "over its rated energy", |of| {
        of.share_of_rated_energy.map(|x| 100.0 * x)
    }),
    quantity("hull_pressure", "kN/m²", "largest pressure on the hull", |of| {
        of.peak_hull_pressure_npm2.map(|x| x * 1e-3)
    }),
    quantity("hull_pressure_share", "%", "largest pressure over the permissible pressure", |of| {
        of.share_of_hull_pressure.map(|x| 100.0 * x)
    }),
    quantity("first_touch", "s", "start of the first step in which the fender was touched", |of| {
        Some(of.first_touch_s)
    }),
    quantity(
        "approach_speed",
        "m/s",
        "speed normal to the fender's face at the first touch",
        |of| Some(of.approach_speed_mps),
    ),
    quantity("approach_angle", "deg", "angle between hull and face at the first touch", |of| {
        Some(of.approach_angle_rad.to_degrees())
    }),
];

static OF_LINES: [OfLine; 3] = [
    quantity("tension", "kN", "largest tension", |of| Some(of.tension_n.value * 1e-3)),
    quantity("break_share", "%", "largest tension over the break load", |of| {
        of.share_of_break_load().map(|x| 100.0 * x)
    }),
    quantity("working_share", "%", "largest tension over the working load", |of| {
        of.working_load_n.map(|load_n| 100.0 * of.tension_n.value / load_n)
    }),
];

static OF_BODIES: [OfBody; 8] = [
    quantity(
        "largest_surge",
        "m",
        "largest distance from the start along the body's axis at the \
        start",
        |of| Some(of.surge_m),
    ),
    quantity(
        "largest_sway",
        "m",
        "largest distance from the start across the body's axis at the \
        start",
        |of| Some(of.sway_m),
    ),
    quantity("largest_yaw", "deg", "largest change of heading", |of| Some(of.yaw_rad.to_degrees())),
    quantity("end_north", "m", "north at the end", |of| Some(of.last.position_m.x)),
    quantity("end_east", "m", "east at the end", |of| Some(of.last.position_m.y)),
    quantity("end_heading", "deg", "heading at the end", |of| {
        Some(of.last.heading_rad.to_degrees())
    }),
    quantity("end_speed", "m/s", "speed over the ground at the end", |of| {
        Some(of.last.velocity_mps.length())
    }),
    quantity("end_turn", "deg/s", "rate of turn at the end", |of| {
        Some(of.last.yaw_rate_radps.to_degrees())
    }),
];

static OF_TUGS: [OfTug; 2] = [
    quantity("force", "kN", "largest force", |of| Some(of.force_n.value.abs() * 1e-3)),
    quantity("at_work", "s", "time at work", |of| Some(of.at_work.s())),
];

impl Named {
    /// The output of a text such as `fender.NAME.reaction`.
    ///
    /// # Errors
    /// A text of another form, a part that the scenario does not have, a quantity that it does not have.
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
                Ok(Named::Fender(index, of(kind, quantity, &OF_FENDERS)?))
            }
            "line" => {
                let index =
                    place(kind, name, world.lines.iter().map(|own| own.line.name.as_str()))?;
                Ok(Named::Line(index, of(kind, quantity, &OF_LINES)?))
            }
            "body" => {
                let index = place(kind, name, setup.bodies.iter().map(|own| own.name.as_str()))?;
                Ok(Named::Body(index, of(kind, quantity, &OF_BODIES)?))
            }
            "tug" => {
                let index = place(kind, name, world.tugs.iter().map(|own| own.tug.name.as_str()))?;
                Ok(Named::Tug(index, of(kind, quantity, &OF_TUGS)?))
            }
            _ => Err(form()),
        }
    }

    /// The body whose motion the output needs.
    pub(super) fn body(self) -> Option<usize> {
        match self {
            Named::Body(index, _) => Some(index),
            _ => None,
        }
    }

    pub(super) fn head(self, name: &str) -> Head {
        let (unit, meaning) = match self {
            Named::Fender(_, own) => (own.unit, own.meaning),
            Named::Line(_, own) => (own.unit, own.meaning),
            Named::Body(_, own) => (own.unit, own.meaning),
            Named::Tug(_, own) => (own.unit, own.meaning),
            Named::Limit(_) => ("%", "the limited value over the permissible value"),
        };
        Head::new(name, unit, meaning)
    }

    pub(super) fn cell(
        self,
        simulation: &Simulation,
        world: &WorldTotals,
        motions: &[(usize, Excursion)],
    ) -> Cell {
        let value = match self {
            Named::Fender(index, own) => {
                let mut all = simulation.fender_summaries();
                all.find(|summary| summary.fender == index).and_then(own.value)
            }
            Named::Line(index, own) => (own.value)(&world.lines[index]),
            Named::Body(index, own) => motions
                .iter()
                .find(|(body, _)| *body == index)
                .and_then(|(_, motion)| (own.value)(motion)),
            Named::Tug(index, own) => (own.value)(&world.tugs[index]),
            Named::Limit(index) => {
                let limit = &simulation.setup().world.statistics.limits[index];
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

fn of<T>(
    kind: &str,
    name: &str,
    all: &'static [Quantity<T>],
) -> Result<&'static Quantity<T>, String> {
    all.iter().find(|own| own.name == name).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|own| own.name).collect();
        format!("a {kind} has no `{name}`; it has {}", names.join(", "))
    })
}
