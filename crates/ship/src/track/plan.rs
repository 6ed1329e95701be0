//! A passage plan: the waypoints of a ship, the turns and the corridor between them, and how far the ship is from the
//! planned track.
//!
//! Each turn of a plan is an arc of a circle that touches both legs. The wheel goes over before the arc begins, because
//! a ship first goes on straight ahead: by the *reach*, usually about a length of the ship. So the wheel-over point lies
//! R tan(Δ/2) + F before the waypoint, with the turning radius R, the change of course Δ and the reach F. This is the
//! turn of constant radius of bridge practice (read: "Wheel over point", seachest.in, 2015, which takes about the ship's
//! length for F).

use fenderline_contact::number::greater;
use fenderline_contact::{Vec2, vec2};

use super::error::TrackError;
use super::path::{Path, within_half_turn};
use crate::range::within;

/// Least change of course with a wheel-over point (rad): half a degree; our choice.
const LEAST_TURN_RAD: f64 = 0.5 * core::f64::consts::PI / 180.0;

/// A waypoint of a passage plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Waypoint {
    /// Name; empty if the waypoint has no name.
    pub name: String,
    /// Place, north and east (m).
    pub at_m: Vec2,
    /// Radius of the turn at the waypoint (m). No effect at the first and the last waypoint.
    pub turning_radius_m: f64,
    /// Planned speed over the ground on the leg that leads to the waypoint (m/s).
    pub speed_mps: Option<f64>,
    /// Half of the width of the corridor on the leg that leads to the waypoint (m): the greatest cross-track distance.
    pub half_width_m: Option<f64>,
}

/// A passage plan of a ship.
#[derive(Clone, Debug, PartialEq)]
pub struct PassagePlan {
    /// Name of the plan.
    pub name: String,
    waypoints: Vec<Waypoint>,
    path: Path,
    /// Distance that the ship goes on straight ahead after the wheel is put over (m).
    reach_m: f64,
    /// For each waypoint: distances along the path at which its turn begins and ends (m). Both are the distance of the
    /// waypoint where there is no turn.
    turns_m: Vec<[f64; 2]>,
}

/// A leg of a passage plan, from waypoint to waypoint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Course, clockwise from north, from −π to π (rad).
    pub course_rad: f64,
    /// Distance between the waypoints (m).
    pub length_m: f64,
}

/// A place at which the wheel goes over for a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelOver {
    /// Index of the waypoint at which the ship turns.
    pub waypoint: usize,
    /// Distance along the planned track from the first waypoint (m).
    pub along_m: f64,
    /// Place, north and east (m).
    pub at_m: Vec2,
    /// Course of the planned track at this place, from −π to π (rad).
    pub course_rad: f64,
    /// Change of course, positive to starboard (rad).
    pub turn_rad: f64,
}

/// Where a ship is on her passage plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnPlan {
    /// Index of the leg. A leg ends abeam of the middle of the turn at its waypoint.
    pub leg: usize,
    /// Distance along the planned track from the first waypoint (m); negative before the first waypoint.
    pub along_m: f64,
    /// Cross-track distance: distance from the planned track, positive to starboard of the track (m).
    pub cross_track_m: f64,
    /// Distance along the planned track to the waypoint at the end of the leg (m); negative after the last waypoint.
    /// Where the ship turns at the waypoint, distance to the middle of the turn.
    pub to_waypoint_m: f64,
    /// Course of the leg, clockwise from north, from −π to π (rad).
    pub course_rad: f64,
    /// Planned speed on the leg (m/s).
    pub speed_mps: Option<f64>,
    /// Half of the width of the corridor on the leg (m). There is no corridor before the first waypoint and after the
    /// last one.
    pub half_width_m: Option<f64>,
    /// Distance along the planned track to the next wheel-over point (m); `None` if no turn is left.
    pub to_wheel_over_m: Option<f64>,
}

impl OnPlan {
    /// True between the first and the last waypoint; false before the first and after the last one.
    #[must_use]
    pub fn is_on_leg(&self) -> bool {
        self.along_m >= 0.0 && self.to_waypoint_m >= 0.0
    }

    /// Distance of the ship outside the corridor (m); `None` inside, or where the plan has no corridor.
    #[must_use]
    pub fn outside_m(&self) -> Option<f64> {
        let beyond_m = self.cross_track_m.abs() - self.half_width_m?;
        (beyond_m > 0.0).then_some(beyond_m)
    }
}

impl PassagePlan {
    /// Makes a plan from its waypoints and the reach of the ship (m).
    ///
    /// # Errors
    /// As [`Path::with_radii`]; and for a speed that is not between 0 and 50 m/s, a half width or a reach that is not
    /// between 0 and 100 km.
    pub fn new(
        name: String,
        waypoints: Vec<Waypoint>,
        reach_m: f64,
    ) -> Result<PassagePlan, TrackError> {
        within("reach of a plan [m]", reach_m, 0.0, 1e5)?;
        for waypoint in &waypoints {
            within("speed of a plan [m/s]", waypoint.speed_mps.unwrap_or(0.0), 0.0, 50.0)?;
            within("half width of a plan [m]", waypoint.half_width_m.unwrap_or(0.0), 0.0, 1e5)?;
        }
        let places: Vec<Vec2> = waypoints.iter().map(|waypoint| waypoint.at_m).collect();
        let radii: Vec<f64> = waypoints.iter().map(|waypoint| waypoint.turning_radius_m).collect();
        let path = Path::with_radii(&places, &radii)?;
        let legs: Vec<Leg> = places.windows(2).map(|ends| leg(ends[0], ends[1])).collect();
        let mut turns_m = vec![[0.0, 0.0]];
        let mut along_m = 0.0;
        let mut cut_m = 0.0;
        for (index, leg) in legs.iter().enumerate() {
            let turn_rad = legs
                .get(index + 1)
                .map_or(0.0, |next| within_half_turn(next.course_rad - leg.course_rad).abs());
            let radius_m = radii[index + 1];
            let own_m = if turn_rad == 0.0 { 0.0 } else { radius_m * libm::tan(0.5 * turn_rad) };
            let begins_m = along_m + leg.length_m - cut_m - own_m;
            along_m = if turn_rad == 0.0 { begins_m } else { begins_m + radius_m * turn_rad };
            turns_m.push([begins_m, along_m]);
            cut_m = own_m;
        }
        Ok(PassagePlan { name, waypoints, path, reach_m, turns_m })
    }

    /// The waypoints.
    #[must_use]
    pub fn waypoints(&self) -> &[Waypoint] {
        &self.waypoints
    }

    /// The planned track: legs, and arcs between them.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Distance that the ship goes on straight ahead after the wheel is put over (m).
    #[must_use]
    pub fn reach_m(&self) -> f64 {
        self.reach_m
    }

    /// Length of the planned track from the first to the last waypoint (m).
    #[must_use]
    pub fn length_m(&self) -> f64 {
        self.passed_m(self.waypoints.len() - 1)
    }

    /// Distance along the planned track at which a waypoint is passed: the middle of its turn (m).
    #[must_use]
    pub fn passed_m(&self, waypoint: usize) -> f64 {
        let [begins_m, ends_m] = self.turns_m[waypoint];
        0.5 * (begins_m + ends_m)
    }

    /// The legs from waypoint to waypoint.
    pub fn legs(&self) -> impl ExactSizeIterator<Item = Leg> {
        self.waypoints.windows(2).map(|ends| leg(ends[0].at_m, ends[1].at_m))
    }

    /// The wheel-over points, in the order of the waypoints. A change of course of less than half a degree has no
    /// wheel-over point. If a leg is shorter than the reach, the point lies on the turn before.
    pub fn wheel_overs(&self) -> impl Iterator<Item = WheelOver> {
        (1..self.waypoints.len() - 1).filter_map(|waypoint| {
            let [begins_m, ends_m] = self.turns_m[waypoint];
            let along_m = begins_m - self.reach_m;
            let place = self.path.at(along_m);
            let turned_rad = self.path.at(ends_m).heading_rad - self.path.at(begins_m).heading_rad;
            let turn_rad = within_half_turn(turned_rad);
            (turn_rad.abs() >= LEAST_TURN_RAD).then_some(WheelOver {
                waypoint,
                along_m,
                at_m: place.position_m,
                course_rad: place.heading_rad,
                turn_rad,
            })
        })
    }

    /// Where a ship at a place, north and east (m), is on the plan.
    #[must_use]
    pub fn at(&self, place_m: Vec2) -> OnPlan {
        let beside = self.path.nearest(place_m);
        let last = self.waypoints.len() - 1;
        let leg = (1..last).filter(|&way| self.passed_m(way) <= beside.along_m).count();
        let (from, to) = (&self.waypoints[leg], &self.waypoints[leg + 1]);
        let is_between = beside.along_m >= 0.0 && beside.along_m <= self.length_m();
        let next = self.wheel_overs().map(|wheel| wheel.along_m - beside.along_m);
        OnPlan {
            leg,
            along_m: beside.along_m,
            cross_track_m: beside.off_m,
            to_waypoint_m: self.passed_m(leg + 1) - beside.along_m,
            course_rad: self::leg(from.at_m, to.at_m).course_rad,
            speed_mps: to.speed_mps,
            half_width_m: to.half_width_m.filter(|_| is_between),
            to_wheel_over_m: next.into_iter().find(|distance_m| *distance_m >= 0.0),
        }
    }

    /// Both edges of the corridor as lines, north and east (m): for each leg with a corridor the edge to port and the
    /// edge to starboard, from the middle of one turn to the middle of the next.
    #[must_use]
    pub fn corridor_m(&self) -> Vec<[Vec<Vec2>; 2]> {
        /// Greatest distance between two points of an edge (m).
        const STEP_M: f64 = 50.0;
        let edge = |leg: usize, off_m: f64| {
            let (from_m, to_m) = (self.passed_m(leg), self.passed_m(leg + 1));
            let parts = greater(libm::ceil((to_m - from_m) / STEP_M), 1.0) as u32;
            let point = |part: u32| {
                let along_m = from_m + (to_m - from_m) * f64::from(part) / f64::from(parts);
                let place = self.path.at(along_m);
                place.position_m + vec2(-place.ahead.y, place.ahead.x) * off_m
            };
            (0..=parts).map(point).collect()
        };
        let legs = (0..self.waypoints.len() - 1).filter_map(|leg| {
            let half_m = self.waypoints[leg + 1].half_width_m?;
            Some([edge(leg, -half_m), edge(leg, half_m)])
        });
        legs.collect()
    }
}

fn leg(from_m: Vec2, to_m: Vec2) -> Leg {
    let way = to_m - from_m;
    Leg { course_rad: libm::atan2(way.y, way.x), length_m: way.length() }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::*;

    fn way(north: f64, east: f64, turning_radius_m: f64) -> Waypoint {
        let (speed_mps, half_width_m) = (Some(4.0), Some(50.0));
        Waypoint {
            name: String::new(),
            at_m: vec2(north, east),
            turning_radius_m,
            speed_mps,
            half_width_m,
        }
    }

    fn plan() -> PassagePlan {
        let waypoints = vec![way(0.0, 0.0, 0.0), way(1000.0, 0.0, 200.0), way(1000.0, 900.0, 0.0)];
        PassagePlan::new("in".to_owned(), waypoints, 180.0).unwrap()
    }

    #[test]
    fn the_wheel_goes_over_before_the_arc_by_the_reach() {
        let plan = plan();
        let all: Vec<WheelOver> = plan.wheel_overs().collect();
        assert_eq!(all.len(), 1);
        // R tan(Δ/2) + F = 200 + 180 m before the waypoint.
        assert!((all[0].at_m - vec2(620.0, 0.0)).length() < 1e-9, "{all:?}");
        assert!((all[0].turn_rad - FRAC_PI_2).abs() < 1e-12);
        assert!((plan.length_m() - (800.0 + 100.0 * PI + 700.0)).abs() < 1e-9);
        let legs: Vec<Leg> = plan.legs().collect();
        assert_eq!(legs[1], Leg { course_rad: FRAC_PI_2, length_m: 900.0 });
    }

    #[test]
    fn a_ship_knows_her_leg_her_side_and_what_comes_next() {
        let plan = plan();
        let now = plan.at(vec2(300.0, -12.0));
        assert_eq!((now.leg, now.cross_track_m), (0, -12.0));
        assert!((now.to_waypoint_m - (500.0 + 50.0 * PI)).abs() < 1e-9);
        assert!((now.to_wheel_over_m.unwrap() - 320.0).abs() < 1e-9);
        assert_eq!((now.outside_m(), now.speed_mps), (None, Some(4.0)));
        // On the second leg, to starboard of it and outside the corridor.
        let now = plan.at(vec2(940.0, 500.0));
        assert_eq!((now.leg, now.to_wheel_over_m), (1, None));
        assert!((now.cross_track_m - 60.0).abs() < 1e-9 && now.course_rad == FRAC_PI_2);
        assert!((now.outside_m().unwrap() - 10.0).abs() < 1e-9);
        assert!((now.to_waypoint_m - 400.0).abs() < 1e-9);
        // Beyond both ends.
        let [before, after] = [plan.at(vec2(-70.0, 5.0)), plan.at(vec2(1003.0, 950.0))];
        assert!((before.along_m + 70.0).abs() < 1e-9 && (before.cross_track_m - 5.0).abs() < 1e-9);
        assert!((after.to_waypoint_m + 50.0).abs() < 1e-9, "{after:?}");
        assert!((after.cross_track_m + 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_straight_way_over_a_waypoint_has_no_wheel_over_and_two_legs() {
        let waypoints = vec![way(0.0, 0.0, 0.0), way(400.0, 0.0, 300.0), way(900.0, 0.0, 0.0)];
        let plan = PassagePlan::new("on".to_owned(), waypoints, 100.0).unwrap();
        assert_eq!(plan.wheel_overs().count(), 0);
        assert_eq!([plan.passed_m(1), plan.length_m()], [400.0, 900.0]);
        assert_eq!([plan.at(vec2(399.0, 0.0)).leg, plan.at(vec2(401.0, 0.0)).leg], [0, 1]);
    }

    #[test]
    fn the_corridor_lies_its_half_width_beside_the_track() {
        let plan = plan();
        let corridor = plan.corridor_m();
        assert_eq!(corridor.len(), 2);
        for (edges, side) in
            corridor.iter().flat_map(|[port, starboard]| [(port, -1.0), (starboard, 1.0)])
        {
            for point in edges {
                assert!((plan.at(*point).cross_track_m - 50.0 * side).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn plans_that_no_ship_can_follow_are_refused() {
        let of = |waypoints| PassagePlan::new(String::new(), waypoints, 100.0);
        assert_eq!(of(vec![way(0.0, 0.0, 0.0)]), Err(TrackError::TooFew));
        let tight = of(vec![way(0.0, 0.0, 0.0), way(100.0, 0.0, 200.0), way(100.0, 900.0, 0.0)]);
        assert!(matches!(tight, Err(TrackError::Bend { waypoint: 1, .. })), "{tight:?}");
        let waypoints = vec![way(0.0, 0.0, 0.0), way(100.0, 0.0, 0.0)];
        assert!(PassagePlan::new(String::new(), waypoints, f64::NAN).is_err());
    }
}
