//! The speed along a track.

use super::error::TrackError;
use crate::range::within;

/// Speed along a track by time: straight lines between times, constant before the first and after the last time.
#[derive(Clone, Debug, PartialEq)]
pub struct Pace {
    /// Knots: times at which a speed is given, with these speeds, in the order of time.
    knots: Vec<Knot>,
    /// Distance from the first knot (time with a speed) to the first waypoint of the track (m).
    begins_m: f64,
    /// Time at which the ship is at the first waypoint (s).
    at_first_s: f64,
}

/// A knot: a time at which the speed is given.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    t_s: f64,
    speed_mps: f64,
    /// Distance that the ship has covered since the first knot (m).
    covered_m: f64,
}

impl Pace {
    /// A constant speed (m/s). The ship is at the first waypoint at the time `at_s` (s).
    ///
    /// # Errors
    /// Fails for a speed that is not between 0 and 50 m/s, or a time beyond ±10⁸ s.
    pub fn steady(speed_mps: f64, at_s: f64) -> Result<Pace, TrackError> {
        Pace::by_time(&[(0.0, speed_mps)], at_s)
    }

    /// Makes a speed that changes with time, from times (s) and speeds (m/s). The ship is at the first waypoint at the
    /// time `at_s` (s).
    ///
    /// # Errors
    /// Fails if there is no speed, a speed that is not between 0 and 50 m/s, or a time that is beyond ±10⁸ s or not
    /// later than the time before it.
    pub fn by_time(speeds: &[(f64, f64)], at_s: f64) -> Result<Pace, TrackError> {
        within("number of speeds of a track", speeds.len() as f64, 1.0, 1e6)?;
        within("time at the first waypoint [s]", at_s, -1e8, 1e8)?;
        let mut knots: Vec<Knot> = Vec::with_capacity(speeds.len());
        for (entry, &(t_s, speed_mps)) in speeds.iter().enumerate() {
            within("time of a speed [s]", t_s, -1e8, 1e8)?;
            within("speed along a track [m/s]", speed_mps, 0.0, 50.0)?;
            let covered_m = match knots.last() {
                Some(last) if t_s <= last.t_s => return Err(TrackError::NotLater { entry }),
                Some(last) => {
                    last.covered_m + 0.5 * (t_s - last.t_s) * (last.speed_mps + speed_mps)
                }
                None => 0.0,
            };
            knots.push(Knot { t_s, speed_mps, covered_m });
        }
        let mut pace = Pace { knots, begins_m: 0.0, at_first_s: at_s };
        pace.begins_m = pace.covered_m(at_s);
        Ok(pace)
    }

    /// Time at which the ship is at the first waypoint (s).
    #[must_use]
    pub fn at_first_s(&self) -> f64 {
        self.at_first_s
    }

    /// The given times (s) and speeds (m/s) along the track; a steady speed has one pair.
    pub fn speeds(&self) -> impl ExactSizeIterator<Item = (f64, f64)> {
        self.knots.iter().map(|knot| (knot.t_s, knot.speed_mps))
    }

    /// Speed along the track at a time (m/s).
    #[must_use]
    pub fn speed_mps(&self, t_s: f64) -> f64 {
        let (last, next) = self.around(t_s);
        match next {
            Some(next) if t_s > last.t_s => {
                let share = (t_s - last.t_s) / (next.t_s - last.t_s);
                last.speed_mps + share * (next.speed_mps - last.speed_mps)
            }
            _ => last.speed_mps,
        }
    }

    /// The highest speed along the track at any time (m/s).
    #[must_use]
    pub fn fastest_mps(&self) -> f64 {
        let speeds = self.knots.iter().map(|knot| knot.speed_mps);
        speeds.fold(0.0, fenderline_contact::number::greater)
    }

    /// Distance of the ship along the track from its first waypoint at a time (m), negative before the first waypoint.
    #[must_use]
    pub fn distance_m(&self, t_s: f64) -> f64 {
        self.covered_m(t_s) - self.begins_m
    }

    fn covered_m(&self, t_s: f64) -> f64 {
        let (last, _) = self.around(t_s);
        last.covered_m + 0.5 * (t_s - last.t_s) * (last.speed_mps + self.speed_mps(t_s))
    }

    /// Finds the knot (time with a speed) at or before a time, or the first knot; and the knot after it. Before the
    /// first knot, no second knot is returned.
    fn around(&self, t_s: f64) -> (Knot, Option<Knot>) {
        let later = self.knots.partition_point(|knot| knot.t_s <= t_s);
        if later == 0 {
            return (self.knots[0], None);
        }
        (self.knots[later - 1], self.knots.get(later).copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_is_the_integral_of_the_speed() {
        let pace = Pace::by_time(&[(10.0, 2.0), (20.0, 6.0), (40.0, 0.0)], 10.0).unwrap();
        for (t_s, distance_m) in
            [(0.0, -20.0), (10.0, 0.0), (15.0, 15.0), (20.0, 40.0), (40.0, 100.0), (60.0, 100.0)]
        {
            assert!((pace.distance_m(t_s) - distance_m).abs() < 1e-9, "{t_s}");
        }
        assert_eq!(pace.fastest_mps(), 6.0);
        let steady = Pace::steady(4.0, 100.0).unwrap();
        assert_eq!([steady.distance_m(0.0), steady.distance_m(125.0)], [-400.0, 100.0]);
    }

    #[test]
    fn speeds_that_are_none_are_refused() {
        assert!(Pace::by_time(&[], 0.0).is_err());
        assert!(Pace::steady(f64::NAN, 0.0).is_err());
        assert!(Pace::steady(-1.0, 0.0).is_err());
        let back = Pace::by_time(&[(0.0, 1.0), (0.0, 2.0)], 0.0);
        assert_eq!(back, Err(TrackError::NotLater { entry: 1 }));
    }
}
