//! The line that a ship on a track follows: straight legs with round bends.

use core::f64::consts::PI;

use fenderline_contact::number::greater;
use fenderline_contact::{Rotation, Vec2, vec2};

use super::error::TrackError;
use crate::range::within;

/// A path of straight legs between waypoints, joined by arcs of one radius.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    pieces: Vec<Piece>,
}

/// A piece of a path: a straight leg or an arc.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    /// Distance along the path at which the piece begins (m).
    from_m: f64,
    /// Place at which the piece of path begins, north and east (m).
    start_m: Vec2,
    /// Heading at the start of the piece of path (rad).
    heading_rad: f64,
    /// Curvature of the piece: 1 divided by the radius (1/m), positive for a turn to starboard; 0 for a leg.
    curvature_pm: f64,
}

/// Where a point lies beside a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// Distance along the path from its first waypoint to the place that is nearest to the point (m); negative before
    /// the first waypoint.
    pub along_m: f64,
    /// Distance of the point from the path (m), positive to starboard of the path.
    pub off_m: f64,
}

/// A point may lie so far beyond the end of a piece and still count as beside the piece (m).
const SEAM_M: f64 = 1e-6;

impl Piece {
    /// Distance along the piece to the place beside a point, and the distance of the point from the piece, positive to
    /// starboard (m). On an arc the distance along is at most half a circle.
    fn beside(&self, to_m: Vec2) -> (f64, f64) {
        let seen = Rotation::from_angle(-self.heading_rad).apply(to_m - self.start_m);
        if self.curvature_pm == 0.0 {
            return (seen.x, seen.y);
        }
        // Seen from the start of the arc the centre lies square to starboard or to port.
        let radius_m = 1.0 / self.curvature_pm.abs();
        let side = self.curvature_pm.signum();
        let from_centre = vec2(seen.x, radius_m - side * seen.y);
        let turned_rad = libm::atan2(from_centre.x, from_centre.y);
        (radius_m * turned_rad, side * (radius_m - from_centre.length()))
    }
}

/// A place on the path of a ship on a track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) position_m: Vec2,
    pub(super) heading_rad: f64,
    /// Unit vector along the path at this place.
    pub(super) ahead: Vec2,
    pub(super) curvature_pm: f64,
}

impl Path {
    /// Makes a straight path through a point, north and east (m), with a heading (rad).
    ///
    /// # Errors
    /// Fails for a number that is not finite or beyond 10⁸.
    pub fn straight(through_m: Vec2, heading_rad: f64) -> Result<Path, TrackError> {
        for value in [through_m.x, through_m.y] {
            within("position of a track [m]", value, -1e8, 1e8)?;
        }
        within("heading of a track [rad]", heading_rad, -1e3, 1e3)?;
        let heading_rad = within_half_turn(heading_rad);
        Ok(Path {
            pieces: vec![Piece { from_m: 0.0, start_m: through_m, heading_rad, curvature_pm: 0.0 }],
        })
    }

    /// Makes a path of legs between waypoints, north and east (m), with bends of a radius (m) that touch both legs.
    ///
    /// # Errors
    /// Fails for fewer than two waypoints; a waypoint less than a metre from the waypoint before it; or a radius that
    /// is not between 1 m and 100 km, or that does not fit between the waypoints.
    pub fn through(waypoints_m: &[Vec2], radius_m: f64) -> Result<Path, TrackError> {
        let (legs, turns) = legs_and_turns(waypoints_m)?;
        within("turning radius of a track [m]", radius_m, 1.0, 1e5)?;
        check_bends(&legs, &turns, radius_m)?;
        Ok(Path::of(waypoints_m, &legs, &turns, |_| radius_m))
    }

    /// As [`Path::through`], with a radius for the bend at each waypoint (m). The radii of the first and the last
    /// waypoint have no effect.
    ///
    /// # Errors
    /// As [`Path::through`].
    ///
    /// # Panics
    /// Panics if there are not as many radii as waypoints.
    pub fn with_radii(waypoints_m: &[Vec2], radii_m: &[f64]) -> Result<Path, TrackError> {
        assert_eq!(waypoints_m.len(), radii_m.len(), "a radius for each waypoint");
        let (legs, turns) = legs_and_turns(waypoints_m)?;
        for &radius_m in &radii_m[1..radii_m.len() - 1] {
            within("turning radius at a waypoint [m]", radius_m, 1.0, 1e5)?;
        }
        let cut = |waypoint: usize| match turns.get(waypoint.wrapping_sub(1)) {
            Some(turn_rad) => radii_m[waypoint] * libm::tan(0.5 * turn_rad.abs()),
            None => 0.0,
        };
        for (index, leg) in legs.iter().enumerate() {
            let cuts_m = [cut(index), cut(index + 1)];
            if cuts_m[0] + cuts_m[1] > leg.length() {
                // The bend that takes more of the leg is the one to change.
                let (waypoint, [own_m, other_m]) = match cuts_m[0] > cuts_m[1] {
                    true => (index, cuts_m),
                    false => (index + 1, [cuts_m[1], cuts_m[0]]),
                };
                let most_m = greater(leg.length() - other_m, 0.0) * radii_m[waypoint] / own_m;
                return Err(TrackError::Bend { waypoint, most_m });
            }
        }
        Ok(Path::of(waypoints_m, &legs, &turns, |waypoint| radii_m[waypoint]))
    }

    /// The pieces of a path whose bends fit; `radius_m` gives the radius at a waypoint.
    fn of(
        waypoints_m: &[Vec2],
        legs: &[Vec2],
        turns_rad: &[f64],
        radius_m: impl Fn(usize) -> f64,
    ) -> Path {
        let mut pieces = Vec::with_capacity(legs.len() + turns_rad.len());
        let (mut from_m, mut start_m) = (0.0, waypoints_m[0]);
        for (index, leg) in legs.iter().enumerate() {
            let heading_rad = libm::atan2(leg.y, leg.x);
            pieces.push(Piece { from_m, start_m, heading_rad, curvature_pm: 0.0 });
            let Some(&turn_rad) = turns_rad.get(index) else { break };
            if turn_rad == 0.0 {
                from_m += (waypoints_m[index + 1] - start_m).length();
                start_m = waypoints_m[index + 1];
                continue;
            }
            let radius_m = radius_m(index + 1);
            let cut_m = radius_m * libm::tan(0.5 * turn_rad.abs());
            let ahead = *leg * (1.0 / leg.length());
            let bend_m = waypoints_m[index + 1] - ahead * cut_m;
            from_m += (bend_m - start_m).dot(ahead);
            let curvature_pm = turn_rad.signum() / radius_m;
            pieces.push(Piece { from_m, start_m: bend_m, heading_rad, curvature_pm });
            from_m += radius_m * turn_rad.abs();
            let next = legs[index + 1];
            start_m = waypoints_m[index + 1] + next * (cut_m / next.length());
        }
        Path { pieces }
    }

    /// The place of the path that is nearest to a point, north and east (m). The first leg goes on before the first
    /// waypoint, and the last leg after the last waypoint. Of places that are equally near, the first along the path.
    #[must_use]
    pub fn nearest(&self, to_m: Vec2) -> Beside {
        let mut nearest: Option<Beside> = None;
        for (index, piece) in self.pieces.iter().enumerate() {
            let next = self.pieces.get(index + 1);
            let length_m = next.map_or(f64::INFINITY, |next| next.from_m - piece.from_m);
            let least_m = if index == 0 { f64::NEG_INFINITY } else { 0.0 };
            let (along_m, off_m) = piece.beside(to_m);
            // A point beside the end of a piece is beside the begin of the next piece: neither may be lost to rounding.
            if along_m < least_m - SEAM_M || along_m > length_m + SEAM_M {
                continue;
            }
            if nearest.is_none_or(|found| off_m.abs() < found.off_m.abs()) {
                nearest = Some(Beside { along_m: piece.from_m + along_m, off_m });
            }
        }
        // A smooth path without ends has a place nearest to every point, and the point lies square to the path there.
        nearest.unwrap_or(Beside { along_m: 0.0, off_m: 0.0 })
    }

    /// The place at a distance along the path from its first waypoint (m).
    pub(super) fn at(&self, distance_m: f64) -> Place {
        let piece = self.pieces.partition_point(|piece| piece.from_m <= distance_m);
        let piece = self.pieces[piece.max(1) - 1];
        let along_m = distance_m - piece.from_m;
        let turned_rad = along_m * piece.curvature_pm;
        let start = Rotation::from_angle(piece.heading_rad);
        // On an arc the chord turns by half the turn of the heading.
        let moved_m = match piece.curvature_pm == 0.0 {
            true => vec2(along_m, 0.0),
            false => {
                let chord_m = 2.0 * libm::sin(0.5 * turned_rad) / piece.curvature_pm;
                vec2(chord_m * libm::cos(0.5 * turned_rad), chord_m * libm::sin(0.5 * turned_rad))
            }
        };
        let heading_rad = within_half_turn(piece.heading_rad + turned_rad);
        Place {
            position_m: piece.start_m + start.apply(moved_m),
            heading_rad,
            ahead: Rotation::from_angle(heading_rad).apply(vec2(1.0, 0.0)),
            curvature_pm: piece.curvature_pm,
        }
    }

    /// Points for drawing the path, from `from_m` to `to_m` along it (m), given north and east (m). The points for
    /// drawing are the ends of legs, and points on bends at most a twelfth of a turn apart.
    #[must_use]
    pub fn points_m(&self, from_m: f64, to_m: f64) -> Vec<Vec2> {
        let mut points = vec![self.at(from_m).position_m];
        for (index, piece) in self.pieces.iter().enumerate() {
            let end_m = self.pieces.get(index + 1).map_or(to_m, |next| next.from_m);
            let turned_rad = ((end_m - piece.from_m) * piece.curvature_pm).abs();
            let parts = (turned_rad * 12.0 / (2.0 * PI)) as u32 + 1;
            let within = (1..=parts).map(|part| {
                piece.from_m + (end_m - piece.from_m) * f64::from(part) / f64::from(parts)
            });
            let within = within.filter(|at_m| *at_m > from_m && *at_m < to_m);
            points.extend(within.map(|at_m| self.at(at_m).position_m));
        }
        points.push(self.at(to_m).position_m);
        points
    }
}

/// Legs between waypoints, and the turns between the legs (rad, positive to starboard).
fn legs_and_turns(waypoints_m: &[Vec2]) -> Result<(Vec<Vec2>, Vec<f64>), TrackError> {
    if waypoints_m.len() < 2 {
        return Err(TrackError::TooFew);
    }
    for value in waypoints_m.iter().flat_map(|point| [point.x, point.y]) {
        within("position of a waypoint [m]", value, -1e8, 1e8)?;
    }
    let legs: Vec<Vec2> = waypoints_m.windows(2).map(|ends| ends[1] - ends[0]).collect();
    if let Some(leg) = legs.iter().position(|leg| leg.length() < 1.0) {
        return Err(TrackError::Near { waypoint: leg + 1 });
    }
    let headings: Vec<f64> = legs.iter().map(|leg| libm::atan2(leg.y, leg.x)).collect();
    let turns = headings.windows(2).map(|pair| within_half_turn(pair[1] - pair[0])).collect();
    Ok((legs, turns))
}

/// Checks that each leg of the path has room for the bends at both of its ends.
fn check_bends(legs: &[Vec2], turns_rad: &[f64], radius_m: f64) -> Result<(), TrackError> {
    // Length of a leg that a bend of radius 1 takes.
    let cut = |index: usize| libm::tan(0.5 * turns_rad[index].abs());
    let all = |index: Option<usize>| index.filter(|&at| at < turns_rad.len()).map_or(0.0, cut);
    for (index, leg) in legs.iter().enumerate() {
        let cuts = all(index.checked_sub(1)) + all(Some(index));
        let most_m = leg.length() / cuts;
        if radius_m > most_m {
            return Err(TrackError::Bend { waypoint: index.max(1), most_m });
        }
    }
    Ok(())
}

/// Returns an angle in the range from −π to π (rad).
pub(super) fn within_half_turn(angle_rad: f64) -> f64 {
    angle_rad - 2.0 * PI * libm::round(angle_rad / (2.0 * PI))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_touches_its_legs_and_its_length_is_that_of_legs_and_arcs() {
        let path = Path::through(&[vec2(0.0, 0.0), vec2(300.0, 0.0), vec2(300.0, 400.0)], 100.0);
        let path = path.unwrap();
        let bend_m = 0.5 * PI * 100.0;
        for (distance_m, place) in [
            (-50.0, vec2(-50.0, 0.0)),
            (200.0, vec2(200.0, 0.0)),
            (200.0 + bend_m, vec2(300.0, 100.0)),
            (500.0 + bend_m, vec2(300.0, 400.0)),
            (600.0 + bend_m, vec2(300.0, 500.0)),
        ] {
            let off = path.at(distance_m).position_m - place;
            assert!(off.length() < 1e-9, "{distance_m}: {off:?}");
        }
        let points = path.points_m(-50.0, 700.0);
        assert!(points.len() >= 5 && points.iter().all(|point| point.is_finite()));
    }

    /// A straight leg, a quarter circle to port, and a straight leg: distances in closed form, before the first waypoint
    /// and after the last one too.
    #[test]
    fn the_place_beside_a_point_is_that_of_leg_arc_and_both_ends() {
        let path = Path::through(&[vec2(0.0, 0.0), vec2(300.0, 0.0), vec2(300.0, -400.0)], 100.0);
        let path = path.unwrap();
        let bend_m = 0.5 * PI * 100.0;
        let half = 0.5_f64.sqrt();
        for (point, along_m, off_m) in [
            (vec2(50.0, 20.0), 50.0, 20.0),
            (vec2(50.0, -20.0), 50.0, -20.0),
            (vec2(-80.0, 7.0), -80.0, 7.0),
            // On the line from the centre of the arc, at 200 m north and 100 m west, to the north-east.
            (vec2(200.0 + 130.0 * half, -100.0 + 130.0 * half), 200.0 + 0.5 * bend_m, 30.0),
            (vec2(200.0 + 60.0 * half, -100.0 + 60.0 * half), 200.0 + 0.5 * bend_m, -40.0),
            (vec2(310.0, -250.0), 350.0 + bend_m, 10.0),
            (vec2(295.0, -900.0), 1000.0 + bend_m, -5.0),
        ] {
            let found = path.nearest(point);
            assert!((found.along_m - along_m).abs() < 1e-9, "{point:?}: {found:?}");
            assert!((found.off_m - off_m).abs() < 1e-9, "{point:?}: {found:?}");
        }
    }

    /// At places all around a path with bends to both sides, the found place lies square to the point, and no place of
    /// the path is nearer.
    #[test]
    fn no_place_of_the_path_is_nearer_than_the_nearest() {
        let waypoints = [vec2(0.0, 0.0), vec2(500.0, 0.0), vec2(900.0, 400.0), vec2(1500.0, 300.0)];
        let path = Path::with_radii(&waypoints, &[0.0, 350.0, 600.0, 0.0]).unwrap();
        for step in 0..400 {
            let point =
                vec2(f64::from(step) * 5.0 - 250.0, f64::from(step * 37 % 400) * 2.0 - 300.0);
            let found = path.nearest(point);
            let place = path.at(found.along_m);
            let starboard = vec2(-place.ahead.y, place.ahead.x);
            let off = place.position_m + starboard * found.off_m - point;
            assert!(off.length() < 1e-6, "{point:?}: {off:?}");
            for other in 0..300 {
                let at = path.at(f64::from(other) * 8.0 - 300.0).position_m;
                assert!((at - point).length() >= found.off_m.abs() - 1e-6, "{point:?}");
            }
        }
    }

    #[test]
    fn a_radius_that_does_not_fit_beside_the_next_bend_is_refused_with_the_most() {
        let waypoints = [vec2(0.0, 0.0), vec2(500.0, 0.0), vec2(500.0, 300.0), vec2(900.0, 300.0)];
        let refused = Path::with_radii(&waypoints, &[0.0, 100.0, 250.0, 0.0]).unwrap_err();
        let TrackError::Bend { waypoint: 2, most_m } = refused else { panic!("{refused:?}") };
        assert!((most_m - 200.0).abs() < 1e-9, "{most_m}");
        assert!(Path::with_radii(&waypoints, &[0.0, 100.0, 200.0, 0.0]).is_ok());
    }

    #[test]
    fn paths_without_room_are_refused() {
        let at = |points: &[(f64, f64)], radius_m| {
            let points: Vec<Vec2> = points.iter().map(|&(x, y)| vec2(x, y)).collect();
            Path::through(&points, radius_m)
        };
        assert_eq!(at(&[(0.0, 0.0)], 100.0), Err(TrackError::TooFew));
        let near = at(&[(0.0, 0.0), (0.5, 0.0)], 100.0);
        assert_eq!(near, Err(TrackError::Near { waypoint: 1 }));
        let short = at(&[(0.0, 0.0), (90.0, 0.0), (90.0, 400.0)], 100.0).unwrap_err();
        assert!(short.to_string().contains("radius of 9") || short.to_string().contains("of 89"));
        let back = at(&[(0.0, 0.0), (500.0, 0.0), (0.0, 0.0)], 100.0).unwrap_err();
        assert!(back.to_string().contains("turns back"), "{back}");
        assert!(Path::straight(vec2(f64::NAN, 0.0), 0.0).is_err());
    }
}
