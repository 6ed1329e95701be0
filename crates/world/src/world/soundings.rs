//! The depth of the water under a vessel, from stations along and across her hull.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_ship::hydro::Particulars;

use super::environment::{Environment, NoDepth};

/// Number of stations along the hull, from the stern to the bow.
const ALONG: usize = 13;
/// The rows of stations under the hull, to port, amidships and to starboard: place across the hull, and weight of the
/// row in the mean depth.
const ROWS: [(f64, f64); 3] = [(-1.0, 0.25), (0.0, 0.5), (1.0, 0.25)];
/// Stations under the hull.
pub(super) const STATIONS: usize = ALONG * ROWS.len();
/// Weight in the mean depth of a place half a beam off the ship's side, divided by the weight of the station at the
/// side: 1/e. Our assumption.
const BESIDE: f64 = 0.367_879_441_171_442_33;

/// The depths of the water under a vessel at a time (m); `None` for deep water.
///
/// If the depth differs by place, it is taken at 13 stations along the hull times three across. The hull's plan is a
/// rectangle of length and beam whose ends taper, so that its area is block coefficient times length times beam. The
/// mean depth for the forces of the water is our assumption, without a source: the depth under the keel has the weight
/// ½, under each side ¼, and half a beam off each side ¼ divided by e, evenly along the length. Depths off her sides
/// count only where they are known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Soundings {
    /// Mean depth under the vessel with the tide alone, without long waves (m); hull forces and added mass are computed
    /// with this depth.
    pub still_m: Option<f64>,
    /// Mean depth under the vessel with tide and long waves (m).
    pub mean_m: Option<f64>,
    /// Least depth of all stations under the vessel, with tide and long waves (m).
    pub least_m: Option<f64>,
    /// Least depth under the forward half of the vessel, midship included (m).
    pub fore_m: Option<f64>,
    /// Least depth under the after half of the vessel, midship included (m).
    pub aft_m: Option<f64>,
    /// Whether the bottom under the hull is level.
    pub is_level: bool,
}

/// Length of the part at each end over which a hull's plan tapers, divided by half of the hull's length.
fn taper(hull: &Particulars) -> f64 {
    lesser(2.0 * (1.0 - hull.block_coefficient()), 1.0)
}

/// The stations under a hull: place forward and to starboard of midship (m), and weight in the mean depth. The weights
/// add up to 1. For stations at a side, the third item is the place half a beam off this side.
pub(super) fn stations(hull: &Particulars) -> impl Iterator<Item = (Vec2, f64, Option<Vec2>)> {
    let (half_length_m, half_beam_m) = (0.5 * hull.length_m, 0.5 * hull.beam_m);
    let taper = taper(hull);
    (0..ALONG).flat_map(move |index| {
        let share = (2 * index) as f64 / (ALONG - 1) as f64 - 1.0;
        let is_end = index == 0 || index == ALONG - 1;
        let weight = (if is_end { 0.5 } else { 1.0 }) / (ALONG - 1) as f64;
        let to_end = 1.0 - share.abs();
        let breadth_m = half_beam_m * if to_end < taper { to_end / taper } else { 1.0 };
        ROWS.into_iter().map(move |(side, part)| {
            let x_m = share * half_length_m;
            let off_m = vec2(x_m, side * (breadth_m + half_beam_m));
            let beside = (side != 0.0).then_some(off_m);
            (vec2(x_m, side * breadth_m), weight * part, beside)
        })
    })
}

impl Soundings {
    /// Finds the depths under a hull in its present position.
    ///
    /// # Errors
    /// Fails if no depth is known under a station.
    pub fn under(
        hull: &Particulars,
        state: &BodyState,
        environment: &Environment,
        t_s: f64,
    ) -> Result<Soundings, NoDepth> {
        let Some(bottom) = &environment.bottom else {
            return Ok(Soundings::level(environment, t_s));
        };
        let (tide_m, level_m) = (environment.tide.level_m(t_s), environment.level_m(t_s));
        let pose = state.pose();
        let about_gravity = |at_m: Vec2| at_m - vec2(hull.centre_of_gravity_m, 0.0);
        // Sums of differences from the first station: a level bottom gives its depth to the last bit.
        let mut first = None;
        let [mut weights, mut still, mut mean] = [0.0; 3];
        let [mut fore_m, mut aft_m] = [f64::INFINITY; 2];
        let mut is_level = true;
        for (at_m, weight, beside_m) in stations(hull) {
            let place_m = pose.apply(about_gravity(at_m));
            let (depth_m, gradient) = bottom.sounding(place_m).ok_or(NoDepth { place_m })?;
            let under = [tide_m, level_m].map(|level_m| greater(depth_m + level_m, 0.0));
            let [still_m, now_m] = *first.get_or_insert(under);
            weights += weight;
            still += weight * (under[0] - still_m);
            mean += weight * (under[1] - now_m);
            is_level &= under[1] == now_m && gradient == Vec2::ZERO;
            if at_m.x >= 0.0 {
                fore_m = lesser(fore_m, under[1]);
            }
            if at_m.x <= 0.0 {
                aft_m = lesser(aft_m, under[1]);
            }
            let off_m = beside_m.map(|beside_m| pose.apply(about_gravity(beside_m)));
            let Some(beside_m) = off_m.and_then(|off_m| bottom.depth_m(off_m)) else { continue };
            let weight = BESIDE * weight;
            weights += weight;
            still += weight * (greater(beside_m + tide_m, 0.0) - still_m);
            mean += weight * (greater(beside_m + level_m, 0.0) - now_m);
        }
        let [still_m, now_m] = first.unwrap_or_default();
        Ok(Soundings {
            still_m: Some(still_m + still / weights),
            mean_m: Some(now_m + mean / weights),
            least_m: Some(lesser(fore_m, aft_m)),
            fore_m: Some(fore_m),
            aft_m: Some(aft_m),
            is_level,
        })
    }

    /// The soundings in water with one depth everywhere.
    fn level(environment: &Environment, t_s: f64) -> Soundings {
        let [still_m, depth_m] = [environment.tide.level_m(t_s), environment.level_m(t_s)]
            .map(|level_m| environment.depth_m.map(|depth_m| greater(depth_m + level_m, 0.0)));
        Soundings {
            still_m,
            mean_m: depth_m,
            least_m: depth_m,
            fore_m: depth_m,
            aft_m: depth_m,
            is_level: true,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::world::{Bottom, Outside};
    use fenderline_ship::environment::{DepthField, Tide};

    fn hull(block_coefficient: f64) -> Particulars {
        Particulars::from_block(192.0, 32.0, 8.0, block_coefficient).unwrap()
    }

    /// A bottom that falls by 1/64 to the north and rises by 1/32 to the east, 10 m deep at the origin.
    fn slope(outside: Outside) -> Environment {
        let node = |index: usize| {
            let (north, east) =
                ((index % 101) as f32 * 8.0 - 400.0, (index / 101) as f32 * 8.0 - 400.0);
            10.0 + north / 64.0 - east / 32.0
        };
        let depths_m = (0..101 * 101).map(node).collect();
        let field = DepthField::new(vec2(-400.0, -400.0), 8.0, 101, 101, depths_m).unwrap();
        Environment {
            bottom: Some(Bottom { field: Arc::new(field), outside, banks: None }),
            tide: Tide::Level(0.5),
            ..Environment::default()
        }
    }

    fn at(north_m: f64, east_m: f64, heading_rad: f64) -> BodyState {
        BodyState { position_m: vec2(north_m, east_m), heading_rad, ..BodyState::default() }
    }

    #[test]
    fn weights_add_up_to_one_and_the_plan_has_the_area_of_the_waterplane() {
        for block in [0.55, 0.8, 1.0] {
            let hull = hull(block);
            let sum: f64 = stations(&hull).map(|(_, weight, _)| weight).sum();
            assert!((sum - 1.0).abs() < 1e-12);
            let arm_m: f64 = stations(&hull).map(|(at_m, weight, _)| weight * at_m.x.abs()).sum();
            assert!((arm_m - 48.0).abs() < 1e-12, "a quarter of the length");
        }
        let bow_m = |block: f64| stations(&hull(block)).last().unwrap().0.y;
        assert_eq!([bow_m(1.0), bow_m(0.8)], [16.0, 0.0]);
    }

    /// Heading north on the slope: the stern is over the shallow end, starboard over the shallow side.
    #[test]
    fn a_slope_gives_depths_fore_and_aft_in_closed_form() {
        let sounded =
            Soundings::under(&hull(1.0), &at(20.0, -30.0, 0.0), &slope(Outside::Error), 0.0)
                .unwrap();
        let middle_m = 10.5 + 20.0 / 64.0 + 30.0 / 32.0;
        let side_m = 16.0 / 32.0;
        assert!((sounded.mean_m.unwrap() - middle_m).abs() < 1e-12);
        assert!((sounded.still_m.unwrap() - middle_m).abs() < 1e-12);
        assert!((sounded.fore_m.unwrap() - (middle_m - side_m)).abs() < 1e-12, "at midship");
        assert!((sounded.aft_m.unwrap() - (middle_m - side_m - 96.0 / 64.0)).abs() < 1e-12);
        assert_eq!(sounded.least_m, sounded.aft_m);
        assert!(!sounded.is_level);
        // Turned by half a turn, bow and stern change places.
        let turned = at(20.0, -30.0, core::f64::consts::PI);
        let turned = Soundings::under(&hull(1.0), &turned, &slope(Outside::Error), 0.0).unwrap();
        assert!((turned.fore_m.unwrap() - sounded.aft_m.unwrap()).abs() < 1e-9);
        assert!((turned.mean_m.unwrap() - middle_m).abs() < 1e-9);
    }

    #[test]
    fn without_data_under_her_there_is_an_error_and_never_deep_water() {
        let off = at(350.0, 0.0, 0.0);
        let error = Soundings::under(&hull(1.0), &off, &slope(Outside::Error), 0.0).unwrap_err();
        assert!(error.place_m.x > 400.0);
        let chosen = slope(Outside::Depth(3.0));
        let sounded = Soundings::under(&hull(1.0), &off, &chosen, 0.0).unwrap();
        assert_eq!(sounded.least_m, Some(3.5));
        // Beside her there may be none: a quay.
        let alongside = at(0.0, 384.0, 0.0);
        assert!(Soundings::under(&hull(1.0), &alongside, &slope(Outside::Error), 0.0).is_ok());
    }
}
