//! The states of a weather: hours that are much alike, put together.
//!
//! All hours are one state at first. Then, again and again, the state that spreads most in one quantity is split in two at its mean,
//! until there are as many as wanted. Spread is measured by what it does to a ship: that of waves by height, that of wind and current by the
//! square of the speed; a change of direction (rad), or of the period over its mean, counts as that share of the strength. The spread of
//! each agent is over that of its whole weather, so that waves, wind, current and level count alike.

use core::f64::consts::{PI, TAU};

use super::quantity::{Agent, Role};
use super::weather::Weather;

/// A state.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    /// Its rows of the weather, rising.
    pub(super) rows: Vec<usize>,
    /// The mean of each quantity; of height and speeds the root mean square; of directions that of the sum of vectors.
    pub(super) means: Vec<f64>,
    /// Hours.
    pub(super) hours: f64,
}

/// The states of a series, at most so many, from the mildest on. Of a scatter diagram each row is one.
pub(super) fn states(weather: &Weather, most: usize) -> Vec<State> {
    let mut all: Vec<Part> = match weather.is_series() {
        true => split(weather, most),
        false => (0..weather.len()).map(|row| Part::of(weather, vec![row], &[])).collect(),
    };
    all.sort_by(|one, other| {
        one.means[0].total_cmp(&other.means[0]).then(one.rows[0].cmp(&other.rows[0]))
    });
    let state = |part: Part| State {
        hours: part.rows.iter().map(|row| weather.hours[*row]).sum(),
        rows: part.rows,
        means: part.means,
    };
    all.into_iter().map(state).collect()
}

fn split(weather: &Weather, most: usize) -> Vec<Part> {
    let whole: Vec<usize> = (0..weather.len()).collect();
    let scales = scales(weather);
    let mut parts = vec![Part::of(weather, whole, &scales)];
    while parts.len() < most {
        let mut widest = 0;
        for (index, part) in parts.iter().enumerate() {
            if part.spread > parts[widest].spread {
                widest = index;
            }
        }
        // Equal hours are left.
        if parts[widest].spread <= 0.0 {
            break;
        }
        let part = &parts[widest];
        let (upper, lower): (Vec<usize>, Vec<usize>) =
            part.rows.iter().partition(|row| part.is_above(weather, **row));
        // A spread that is rounding alone.
        if upper.is_empty() || lower.is_empty() {
            parts[widest].spread = 0.0;
            continue;
        }
        parts[widest] = Part::of(weather, lower, &scales);
        parts.push(Part::of(weather, upper, &scales));
    }
    parts
}

/// A state in the making.
struct Part {
    rows: Vec<usize>,
    means: Vec<f64>,
    /// The quantity in which it spreads most, and how much.
    widest: usize,
    spread: f64,
}

impl Part {
    /// `scales` are the spreads of each quantity's agent over the whole weather; without them the spread is not asked for.
    fn of(weather: &Weather, rows: Vec<usize>, scales: &[f64]) -> Part {
        let means = means(weather, &rows);
        let mut part = Part { rows, means, widest: 0, spread: 0.0 };
        for (index, scale) in scales.iter().enumerate() {
            if *scale > 0.0 {
                let spread = part.squares(weather, index) / scale;
                if spread > part.spread {
                    (part.widest, part.spread) = (index, spread);
                }
            }
        }
        part
    }

    /// Sum of the squares of what a quantity's distance from its mean does, over hours.
    fn squares(&self, weather: &Weather, index: usize) -> f64 {
        let quantity = weather.quantities[index];
        let mean = self.means[index];
        let strength = weather.index(quantity.agent, Role::Strength);
        let of_row = |row: &usize| {
            let values = &weather.rows[*row];
            let load = strength.map_or(1.0, |own| quantity.agent.load(values[own]));
            let distance = match quantity.role {
                Role::Strength => load - quantity.agent.load(mean),
                Role::Level => values[index] - mean,
                Role::Period => load * (values[index] - mean) / mean,
                Role::Direction => load * turn_rad(values[index] - mean),
            };
            weather.hours[*row] * distance * distance
        };
        self.rows.iter().map(of_row).sum()
    }

    /// Whether a row lies above the mean of the widest quantity, or clockwise of it.
    fn is_above(&self, weather: &Weather, row: usize) -> bool {
        let way = weather.rows[row][self.widest] - self.means[self.widest];
        match weather.quantities[self.widest].role {
            Role::Direction => turn_rad(way) >= 0.0,
            _ => way >= 0.0,
        }
    }
}

/// A turn (deg) as the shorter way round (rad), from −π on.
fn turn_rad(turn_deg: f64) -> f64 {
    let turn = turn_deg.to_radians() / TAU;
    let way = (turn - libm::floor(turn)) * TAU;
    if way >= PI { way - TAU } else { way }
}

/// For each quantity the sum of squares of its agent's strength over the whole weather: the scale of its spread.
fn scales(weather: &Weather) -> Vec<f64> {
    let all: Vec<usize> = (0..weather.len()).collect();
    let hours: f64 = weather.hours.iter().sum();
    let of_agent = |agent: Agent| {
        let role = if agent == Agent::Level { Role::Level } else { Role::Strength };
        let Some(index) = weather.index(agent, role) else { return 0.0 };
        let load = |row: &usize| agent.load(weather.rows[*row][index]);
        let mean = all.iter().map(|row| weather.hours[*row] * load(row)).sum::<f64>() / hours;
        let square = |row: &usize| weather.hours[*row] * (load(row) - mean) * (load(row) - mean);
        let sum: f64 = all.iter().map(square).sum();
        // Waves or wind of one strength all year may still turn.
        if sum > 0.0 { sum } else { hours * mean * mean }
    };
    weather.quantities.iter().map(|own| of_agent(own.agent)).collect()
}

/// The mean of each quantity of some rows.
fn means(weather: &Weather, rows: &[usize]) -> Vec<f64> {
    if let [row] = rows {
        return weather.rows[*row].clone();
    }
    let hours: f64 = rows.iter().map(|row| weather.hours[*row]).sum();
    let mean = |value: &dyn Fn(&[f64]) -> f64| {
        let sum: f64 = rows.iter().map(|row| weather.hours[*row] * value(&weather.rows[*row])).sum();
        sum / hours
    };
    let of_quantity = |(index, quantity): (usize, &&super::Quantity)| match quantity.role {
        Role::Strength => libm::sqrt(mean(&|values| values[index] * values[index])),
        Role::Period | Role::Level => mean(&|values| values[index]),
        Role::Direction => {
            let strength = weather.index(quantity.agent, Role::Strength);
            let load = |values: &[f64]| strength.map_or(1.0, |own| quantity.agent.load(values[own]));
            let north = mean(&|values| load(values) * libm::cos(values[index].to_radians()));
            let east = mean(&|values| load(values) * libm::sin(values[index].to_radians()));
            let direction_deg = libm::atan2(east, north).to_degrees();
            if direction_deg < 0.0 { direction_deg + 360.0 } else { direction_deg }
        }
    };
    weather.quantities.iter().enumerate().map(of_quantity).collect()
}
