//! How near a passing ship comes to a body that does not move.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Pose, Vec2};

use super::setup::PassingSetup;
use crate::distance::of_outlines_m;

/// Largest number of places of the passing ship that the search tests.
const MOST_PLACES: f64 = 1e6;

/// Distance and time at which a passing ship is nearest to a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Clear distance between the outlines of ship and body (m); 0 if they meet.
    pub distance_m: f64,
    /// Time at which the ship is nearest to the body (s).
    pub t_s: f64,
}

impl PassingSetup {
    /// Finds how near the passing ship comes to an outline in a pose, from time 0 to `duration_s`. The search tests a
    /// place each time the passing ship, at her highest speed, has moved by a tenth of her beam. If the ship is farther
    /// away than three of her lengths, the search tests only the distance of the middles.
    #[must_use]
    pub fn nearest(&self, outline_m: &[Vec2], pose: Pose, duration_s: f64) -> Nearest {
        let fastest_mps = self.track.pace.fastest_mps();
        let parts = duration_s * fastest_mps / (0.1 * self.hull.beam_m);
        let parts = libm::ceil(lesser(greater(parts, 1.0), MOST_PLACES));
        let mut nearest = Nearest { distance_m: f64::INFINITY, t_s: 0.0 };
        for part in 0..=(parts as u32) {
            let t_s = duration_s * f64::from(part) / parts;
            if let Some(distance_m) = self.nearer_than_m(nearest.distance_m, t_s, outline_m, pose) {
                nearest = Nearest { distance_m, t_s };
            }
        }
        nearest
    }

    /// Whether the passing ship's outline overlaps another outline in a pose at a time.
    #[must_use]
    pub fn meets(&self, outline_m: &[Vec2], pose: Pose, t_s: f64) -> bool {
        self.nearer_than_m(f64::MIN_POSITIVE, t_s, outline_m, pose).is_some()
    }

    /// The clear distance of the passing ship from an outline in a pose at a time, if it is less than `most_m`; else
    /// `None`.
    #[must_use]
    pub fn nearer_than_m(
        &self,
        most_m: f64,
        t_s: f64,
        outline_m: &[Vec2],
        pose: Pose,
    ) -> Option<f64> {
        let radius =
            |points: &[Vec2]| points.iter().fold(0.0, |most, point| greater(most, point.length()));
        let at = self.track.at(t_s).pose;
        let between_m = (at.position_m - pose.position_m).length()
            - radius(&self.outline_m)
            - radius(outline_m);
        if between_m >= most_m {
            return None;
        }
        let found_m = if between_m > 3.0 * self.hull.length_m {
            between_m
        } else {
            // The search is in the frame of the outline.
            let relative = pose.to(at);
            let hull: Vec<Vec2> =
                self.outline_m.iter().map(|point| relative.apply(*point)).collect();
            of_outlines_m(&hull, outline_m)
        };
        (found_m < most_m).then_some(found_m)
    }
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::super::{Berth, DepthFactors, FlowHull};
    use super::*;
    use crate::track::{Pace, Path, Track};

    fn ship(across_m: f64) -> PassingSetup {
        let outline_m =
            vec![vec2(-80.0, -12.0), vec2(80.0, -12.0), vec2(80.0, 12.0), vec2(-80.0, 12.0)];
        PassingSetup {
            name: "coaster".into(),
            hull: FlowHull::new([160.0, 24.0, 7.0], 0.98, None).unwrap(),
            outline_m,
            track: Track {
                path: Path::straight(vec2(0.0, across_m), 0.0).unwrap(),
                pace: Pace::steady(4.0, 300.0).unwrap(),
            },
            depth: DepthFactors::DeepWater,
            berth: Berth::Open,
        }
    }

    #[test]
    fn she_is_nearest_where_she_is_abreast_and_meets_what_is_in_her_way() {
        let quay = [vec2(-150.0, 20.0), vec2(150.0, 20.0), vec2(150.0, 60.0), vec2(-150.0, 60.0)];
        let at = Pose::new(Vec2::ZERO, 0.0);
        let clear = ship(-50.0).nearest(&quay, at, 600.0);
        assert!((clear.distance_m - 58.0).abs() < 1e-9, "{clear:?}");
        let struck = ship(10.0).nearest(&quay, at, 600.0);
        assert_eq!(struck.distance_m, 0.0);
        // Bow and corner meet 230 m before the middles are abreast.
        assert!((struck.t_s - (300.0 - 230.0 / 4.0)).abs() < 1.0, "{struck:?}");
        // The run ends before the ship arrives.
        assert!(ship(10.0).nearest(&quay, at, 100.0).distance_m > 0.0);
    }
}
