//! Changes of wind, current and visibility that take some time.

use fenderline_contact::number::{bounded, lesser};

/// Speed and direction of the wind or of the current.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow {
    /// Speed (m/s).
    pub speed_mps: f64,
    /// Direction, clockwise from north (rad): the direction from which the wind comes, or to which the current sets.
    pub direction_rad: f64,
}

/// A quantity that can change over a time.
pub trait Between: Copy {
    /// The value of the quantity after a share `share` of the change, from 0 to 1.
    fn between(from: Self, to: Self, share: f64) -> Self;
}

impl Between for Flow {
    /// The speed of wind or current changes linearly, the direction by the shorter turn. If there is no flow at the
    /// start of the change, the direction is the direction at the end throughout the change.
    fn between(from: Flow, to: Flow, share: f64) -> Flow {
        let turn_rad =
            libm::remainder(to.direction_rad - from.direction_rad, core::f64::consts::TAU);
        let direction_rad = if from.speed_mps > 0.0 {
            from.direction_rad + share * turn_rad
        } else {
            to.direction_rad
        };
        let speed_mps = from.speed_mps + share * (to.speed_mps - from.speed_mps);
        Flow { speed_mps, direction_rad }
    }
}

/// A visibility (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight(pub f64);

impl Between for Sight {
    /// The visibility changes by equal ratios in equal times: half-way from 2000 m to 200 m it is 632 m.
    fn between(from: Sight, to: Sight, share: f64) -> Sight {
        Sight(from.0 * libm::pow(to.0 / from.0, share))
    }
}

/// Visibility that counts as clear in a change over a time (m), because the ships of an exercise are not so far away.
const CLEAR_M: f64 = 20_000.0;

/// Turns a visibility, which may be clear, into a distance (m). The function is used for a change over a time that
/// begins or ends with this visibility.
pub fn fog_m(visibility_m: Option<f64>) -> Sight {
    Sight(visibility_m.unwrap_or(CLEAR_M))
}

/// A gradual change of a quantity from one value to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp<T> {
    from: T,
    to: T,
    begins_s: f64,
    over_s: f64,
}

impl<T: Between> Ramp<T> {
    /// Makes a ramp that begins at the time `begins_s` (s) and lasts `over_s` (s).
    pub fn new(from: T, to: T, begins_s: f64, over_s: f64) -> Ramp<T> {
        Ramp { from, to, begins_s, over_s }
    }

    /// The value of the ramp at the time `t_s` (s); after the end of the ramp, its last value.
    pub fn at(&self, t_s: f64) -> T {
        let share = bounded((t_s - self.begins_s) / self.over_s, 0.0, 1.0);
        if share < 1.0 { T::between(self.from, self.to, lesser(share, 1.0)) } else { self.to }
    }

    /// True if the ramp has ended at the time `t_s` (s).
    pub fn is_over(&self, t_s: f64) -> bool {
        t_s >= self.begins_s + self.over_s
    }

    /// The last value of the ramp, and the time that remains at the time `t_s` (s).
    pub fn rest(&self, t_s: f64) -> (T, f64) {
        (self.to, self.begins_s + self.over_s - t_s)
    }
}

/// The gradual changes that are under way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ramps {
    /// The ramp of the wind; `None` if the wind does not change.
    pub wind: Option<Ramp<Flow>>,
    /// The ramp of the current; `None` if the current does not change.
    pub current: Option<Ramp<Flow>>,
    /// The ramp of the visibility, and the visibility at the end of the ramp (m), where an inner `None` means clear
    /// visibility.
    pub visibility: Option<(Ramp<Sight>, Option<f64>)>,
}

impl Ramps {
    /// True while wind, current or visibility changes gradually.
    pub fn any(&self) -> bool {
        self.wind.is_some() || self.current.is_some() || self.visibility.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wind_backs_by_the_shorter_turn_and_fog_comes_by_equal_ratios() {
        let flow = |speed_mps, deg: f64| Flow { speed_mps, direction_rad: deg.to_radians() };
        let backs = Ramp::new(flow(10.0, 10.0), flow(20.0, 350.0), 100.0, 60.0);
        let half = backs.at(130.0);
        assert!((half.speed_mps - 15.0).abs() < 1e-12);
        assert!(half.direction_rad.abs() < 1e-12);
        assert!(!backs.is_over(159.9) && backs.is_over(160.0));
        assert_eq!(backs.at(400.0), flow(20.0, 350.0));
        assert_eq!(backs.rest(120.0), (flow(20.0, 350.0), 40.0));
        let fog = Ramp::new(Sight(2000.0), Sight(200.0), 0.0, 10.0);
        assert!((fog.at(5.0).0 - 632.455_532).abs() < 1e-6);
    }
}
