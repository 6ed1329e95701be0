//! The line that a ship on a track follows: straight legs with round bends.

use core::f64::consts::PI;

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
        if waypoints_m.len() < 2 {
            return Err(TrackError::TooFew);
        }
        within("turning radius of a track [m]", radius_m, 1.0, 1e5)?;
        for value in waypoints_m.iter().flat_map(|point| [point.x, point.y]) {
            within("position of a waypoint [m]", value, -1e8, 1e8)?;
        }
        let legs: Vec<Vec2> = waypoints_m.windows(2).map(|ends| ends[1] - ends[0]).collect();
        if let Some(leg) = legs.iter().position(|leg| leg.length() < 1.0) {
            return Err(TrackError::Near { waypoint: leg + 1 });
        }
        let headings: Vec<f64> = legs.iter().map(|leg| libm::atan2(leg.y, leg.x)).collect();
        let turns: Vec<f64> =
            headings.windows(2).map(|pair| within_half_turn(pair[1] - pair[0])).collect();
        check_bends(&legs, &turns, radius_m)?;
        let mut pieces = Vec::with_capacity(legs.len() + turns.len());
        let (mut from_m, mut start_m) = (0.0, waypoints_m[0]);
        for (index, (leg, &heading_rad)) in legs.iter().zip(&headings).enumerate() {
            pieces.push(Piece { from_m, start_m, heading_rad, curvature_pm: 0.0 });
            let Some(&turn_rad) = turns.get(index) else { break };
            if turn_rad == 0.0 {
                from_m += (waypoints_m[index + 1] - start_m).length();
                start_m = waypoints_m[index + 1];
                continue;
            }
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
        Ok(Path { pieces })
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
fn within_half_turn(angle_rad: f64) -> f64 {
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
