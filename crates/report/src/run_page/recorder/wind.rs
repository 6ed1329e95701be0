//! How the mean wind changed during a run: an instructor, a plan or a table changes it.

use fenderline_contact::number::{greater, lesser};
use fenderline_sim::Simulation;
use fenderline_sim::constants::KNOT_MPS;

use crate::plot::{fixed, plain};
use crate::run_page::session::clock;
use crate::run_page::vessels::compass;

/// Up to this number of changes of the wind, the report gives each change with its time; for more changes it gives the
/// range of the wind.
const TOLD: usize = 3;
/// A change of the wind that takes less than this time is reported as sudden (s).
const AT_ONCE_S: f64 = 1.5;
/// Two winds that differ by less than this count as the same wind (m/s, rad).
const SAME: f64 = 1e-9;

/// The mean wind: speed without gusts (m/s), and direction from which the wind comes, clockwise from north (rad).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Mean {
    speed_mps: f64,
    from_rad: f64,
}

/// A change from one steady wind to another.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Change {
    from_s: f64,
    until_s: f64,
    to: Mean,
}

/// The mean wind over a run.
#[derive(Clone, Debug, PartialEq)]
pub struct WindTrace {
    start: Mean,
    now: Mean,
    now_s: f64,
    least_mps: f64,
    most_mps: f64,
    /// The first changes of the wind. A change that goes on over several steps counts as one change.
    changes: Vec<Change>,
    /// Whether there were more changes than `changes` holds, or the wind is given by a table.
    is_varied: bool,
}

impl WindTrace {
    /// Starts the record with the wind at the present time of a simulation, before its first recorded step.
    #[must_use]
    pub fn of(simulation: &Simulation) -> WindTrace {
        let (now, is_varied) = now(simulation);
        WindTrace {
            start: now,
            now,
            now_s: simulation.time_s(),
            least_mps: now.speed_mps,
            most_mps: now.speed_mps,
            changes: Vec::new(),
            is_varied,
        }
    }

    /// Records the wind after a time step.
    pub fn note(&mut self, simulation: &Simulation) {
        let (wind, is_table) = now(simulation);
        self.add(wind, simulation.time_s(), is_table);
    }

    fn add(&mut self, wind: Mean, t_s: f64, is_table: bool) {
        let (before, before_s) = (self.now, self.now_s);
        (self.now, self.now_s) = (wind, t_s);
        self.is_varied |= is_table;
        if (wind.speed_mps - before.speed_mps).abs() < SAME
            && (wind.from_rad - before.from_rad).abs() < SAME
        {
            return;
        }
        self.least_mps = lesser(self.least_mps, wind.speed_mps);
        self.most_mps = greater(self.most_mps, wind.speed_mps);
        let told = self.changes.len();
        match self.changes.last_mut() {
            Some(change) if change.until_s == before_s => (change.until_s, change.to) = (t_s, wind),
            _ if told == TOLD => self.is_varied = true,
            _ => self.changes.push(Change { from_s: before_s, until_s: t_s, to: wind }),
        }
    }

    /// True if the wind was not the same all the time.
    pub(in crate::run_page) fn has_changed(&self) -> bool {
        !self.changes.is_empty()
    }

    /// The direction from which the wind first came (rad). A calm has no direction.
    pub(in crate::run_page) fn first_from_rad(&self) -> f64 {
        if self.start.speed_mps > 0.0 { self.start.from_rad } else { self.now.from_rad }
    }

    /// The range of speeds and, briefly, of directions of the wind, for a label.
    pub(in crate::run_page) fn range(&self) -> String {
        let [least, most] = [self.least_mps, self.most_mps];
        let speeds = if most - least < SAME {
            both(most)
        } else {
            let in_knots = [least, most].map(|mps| fixed(mps / KNOT_MPS, 1));
            format!(
                "{} to {} m/s ({} to {} kn)",
                plain(least, 3),
                plain(most, 3),
                in_knots[0],
                in_knots[1]
            )
        };
        let [first, last] = [self.first_from_rad(), self.now.from_rad].map(compass);
        if first == last {
            format!("wind {speeds} from {first}")
        } else {
            format!("wind {speeds}, first from {first}, at the end from {last}")
        }
    }

    /// Words for the wind at the start and each change with its time; if there were many changes, for the range of the
    /// wind.
    pub(in crate::run_page) fn by_time(&self) -> String {
        if self.is_varied {
            return self.range();
        }
        let mut text = if self.start.speed_mps > 0.0 {
            format!("wind {} at the start", in_words(self.start))
        } else {
            "no wind at the start".to_owned()
        };
        for change in &self.changes {
            let [from, until] = [change.from_s, change.until_s].map(clock);
            let to = in_words(change.to);
            text += &if change.until_s - change.from_s < AT_ONCE_S {
                format!("; from {from} on {to}")
            } else {
                format!("; changing from {from} until {until} to {to}")
            };
        }
        text
    }
}

fn now(simulation: &Simulation) -> (Mean, bool) {
    let wind = simulation.setup().world.environment.wind.as_ref();
    let (speed_mps, from_rad) = wind.map_or((0.0, 0.0), |wind| wind.mean_at(simulation.time_s()));
    (Mean { speed_mps, from_rad }, wind.is_some_and(|wind| wind.is_series()))
}

/// The text of a wind speed in m/s and knots.
pub(in crate::run_page) fn both(speed_mps: f64) -> String {
    format!("{} m/s ({} kn)", plain(speed_mps, 3), fixed(speed_mps / KNOT_MPS, 1))
}

fn in_words(wind: Mean) -> String {
    format!("{} from {}", both(wind.speed_mps), compass(wind.from_rad))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn trace(winds: &[(f64, f64)]) -> WindTrace {
        let mean =
            |&(speed_mps, degrees): &(f64, f64)| Mean { speed_mps, from_rad: degrees.to_radians() };
        let start = mean(&winds[0]);
        let mut trace = WindTrace {
            start,
            now: start,
            now_s: 0.0,
            least_mps: start.speed_mps,
            most_mps: start.speed_mps,
            changes: vec![],
            is_varied: false,
        };
        for (index, wind) in winds.iter().enumerate().skip(1) {
            trace.add(mean(wind), index as f64, false);
        }
        trace
    }

    #[test]
    fn a_ramp_of_the_wind_is_told_with_its_times() {
        let steady = trace(&[(4.0, 270.0); 3]);
        assert!(!steady.has_changed());
        let ramp = trace(&[(4.0, 270.0), (4.0, 270.0), (8.0, 260.0), (12.0, 250.0), (12.0, 250.0)]);
        assert_eq!(
            ramp.by_time(),
            "wind 4 m/s (7.8 kn) from 270° at the start; changing from 0:01.0 until 0:03.0 to 12 m/s (23.3 kn) from 250°"
        );
        assert_eq!(
            ramp.range(),
            "wind 4 to 12 m/s (7.8 to 23.3 kn), first from 270°, at the end from 250°"
        );
        let freshens = trace(&[(0.0, 0.0), (5.0, 200.0)]);
        assert_eq!(freshens.range(), "wind 0 to 5 m/s (0.0 to 9.7 kn) from 200°");
        assert_eq!(
            freshens.by_time(),
            "no wind at the start; from 0:00.0 on 5 m/s (9.7 kn) from 200°"
        );
        let often: Vec<(f64, f64)> = (0..20).map(|i| (f64::from(i / 2), 90.0)).collect();
        assert_eq!(trace(&often).by_time(), "wind 0 to 9 m/s (0.0 to 17.5 kn) from 090°");
    }
}
