//! The states of a weather: groups of similar hours.
//!
//! All hours are one state at first. Then the state with the largest spread of one quantity is split in two at the
//! quantity's mean, again and again, until there are as many states as wanted. Spread is measured by the effect on a
//! ship: for waves in height, for wind and current in the square of the speed. A change of direction (rad), or of the
//! period relative to its mean, counts as the same relative change of the strength. The spread of each agent is divided
//! by its spread over the whole weather, so that waves, wind, current and water level count alike.

use core::f64::consts::{PI, TAU};

use super::quantity::{Agent, Quantity, Role};
use super::weather::Weather;

/// A state: a group of similar hours, which one run stands for.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    /// The weather rows of the state, in rising order.
    pub(super) rows: Vec<usize>,
    /// The mean of each quantity over the hours of the state; for heights and speeds the root mean square; for
    /// directions the direction of the vector sum.
    pub(super) means: Vec<f64>,
    /// Number of hours of the state.
    pub(super) hours: f64,
}

/// Groups the hours of a series into at most `most` states, from the mildest to the strongest. Each row of a scatter
/// diagram becomes a state.
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
        // The spread is rounding alone.
        if upper.is_empty() || lower.is_empty() {
            parts[widest].spread = 0.0;
            continue;
        }
        parts[widest] = Part::of(weather, lower, &scales);
        parts.push(Part::of(weather, upper, &scales));
    }
    parts
}

/// A state while the hours are being grouped.
struct Part {
    rows: Vec<usize>,
    means: Vec<f64>,
    /// Index of the quantity, such as wind speed, that spreads most within this state. `spread` is this quantity's sum
    /// of squares, divided by the sum of squares of the whole weather.
    widest: usize,
    spread: f64,
}

impl Part {
    /// `scales` are the spreads of each quantity's agent over the whole weather; without `scales` no spread is
    /// computed.
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

    /// Sum over the hours of a state: the squared effect of a quantity's distance from its mean.
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

    /// Whether a weather row lies above the mean of the state's widest quantity, or clockwise of the mean for a
    /// direction.
    fn is_above(&self, weather: &Weather, row: usize) -> bool {
        let way = weather.rows[row][self.widest] - self.means[self.widest];
        match weather.quantities[self.widest].role {
            Role::Direction => turn_rad(way) >= 0.0,
            _ => way >= 0.0,
        }
    }
}

/// A turn (deg) as the shorter way round (rad), from −π to π.
fn turn_rad(turn_deg: f64) -> f64 {
    let turn = turn_deg.to_radians() / TAU;
    let way = (turn - libm::floor(turn)) * TAU;
    if way >= PI { way - TAU } else { way }
}

/// The number by which the spread of each quantity is divided: the sum, over all hours of the weather, of the squared
/// strength of the wind, current or waves that the quantity describes.
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

/// The mean of each quantity over the given weather rows.
fn means(weather: &Weather, rows: &[usize]) -> Vec<f64> {
    if let [row] = rows {
        return weather.rows[*row].clone();
    }
    let hours: f64 = rows.iter().map(|row| weather.hours[*row]).sum();
    let mean = |value: &dyn Fn(&[f64]) -> f64| {
        let sum: f64 =
            rows.iter().map(|row| weather.hours[*row] * value(&weather.rows[*row])).sum();
        sum / hours
    };
    let of_quantity = |(index, quantity): (usize, &&Quantity)| match quantity.role {
        Role::Strength => libm::sqrt(mean(&|values| values[index] * values[index])),
        Role::Period | Role::Level => mean(&|values| values[index]),
        Role::Direction => {
            let strength = weather.index(quantity.agent, Role::Strength);
            let load =
                |values: &[f64]| strength.map_or(1.0, |own| quantity.agent.load(values[own]));
            let north = mean(&|values| load(values) * libm::cos(values[index].to_radians()));
            let east = mean(&|values| load(values) * libm::sin(values[index].to_radians()));
            let direction_deg = libm::atan2(east, north).to_degrees();
            if direction_deg < 0.0 { direction_deg + 360.0 } else { direction_deg }
        }
    };
    weather.quantities.iter().enumerate().map(of_quantity).collect()
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use super::*;

    /// A made-up weather of so many hours.
    fn weather(name: &str, hours: usize) -> Weather {
        let mut text =
            String::from("t_s,hs_m,tp_s,wave_from_deg,wind_speed_mps,wind_from_deg,level_m\n");
        for hour in 0..hours {
            let of = |step: usize| (hour * step % 1009) as f64 / 1009.0;
            let (height, period) = (3.0 * of(17) * of(17), 6.0 + 8.0 * of(29));
            let (wave, wind) = (330.0 + 60.0 * of(113), 360.0 * of(7));
            let _ = writeln!(
                text,
                "{},{height},{period},{},{},{wind},{}",
                3600 * hour,
                wave % 360.0,
                20.0 * of(41),
                of(3)
            );
        }
        let path =
            std::env::temp_dir().join(format!("fenderline_{name}_{}.csv", std::process::id()));
        std::fs::write(&path, text).expect("written");
        let weather = Weather::read(&path).expect("a weather");
        std::fs::remove_file(&path).expect("removed");
        weather
    }

    #[test]
    fn each_hour_is_in_one_state_and_states_have_the_means_of_their_hours() {
        let weather = weather("states", 800);
        let states = states(&weather, 60);
        assert_eq!(states.len(), 60);
        let mut rows: Vec<usize> = states.iter().flat_map(|state| state.rows.clone()).collect();
        rows.sort_unstable();
        assert_eq!(rows, (0..800).collect::<Vec<_>>());
        let energy = |values: &[f64]| values[0] * values[0];
        let of_states: f64 = states.iter().map(|state| state.hours * energy(&state.means)).sum();
        let of_hours: f64 = weather.rows.iter().map(|values| energy(values)).sum();
        assert!((of_states / of_hours - 1.0).abs() < 1e-12, "{of_states} for {of_hours}");
        // Directions about north are not put together to south.
        for state in &states {
            let wave = state.means[2];
            assert!(!(30.0..330.0).contains(&wave), "{wave}");
        }
        assert!(states.is_sorted_by(|one, other| one.means[0] <= other.means[0]));
    }

    /// The more states, the less of the spread of the heights is left.
    #[test]
    fn more_states_leave_less_out() {
        let weather = weather("spread", 800);
        let left = |most: usize| -> f64 {
            let of_state = |state: &State| -> f64 {
                let way = |row: &usize| weather.rows[*row][0] - state.means[0];
                state.rows.iter().map(|row| way(row) * way(row)).sum()
            };
            states(&weather, most).iter().map(of_state).sum()
        };
        let all = left(1);
        assert!(left(20) < 0.5 * all && left(100) < 0.5 * left(20), "{all}");
        assert!(left(800) < 1e-20, "each hour by itself");
    }

    #[test]
    fn turns_go_the_shorter_way() {
        assert!((turn_rad(350.0) + 10_f64.to_radians()).abs() < 1e-12);
        assert!((turn_rad(-350.0) - 10_f64.to_radians()).abs() < 1e-12);
        assert!((turn_rad(180.0) + PI).abs() < 1e-12);
    }
}
