//! Bridges and cables over the water, and the clearance between a vessel's highest point and them.
//!
//! The chart gives the height of a bridge or cable above a high-water level. With the height of this level above chart
//! datum, the clearance of a vessel under the structure is
//! `height + level of high water − water level now − air draught + squat`. Squat lowers the vessel. Heave, roll, pitch and
//! trim are left out, as in the under-keel clearance.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{BodyState, Outline, Pose, Vec2, vec2};
use fenderline_ship::distance::{contains, of_segments_m};

use crate::chart::ChartShape;

/// A vessel slower than this is not moved ahead (m/s); our choice.
const SLOW_MPS: f64 = 0.1;
/// A vessel that is moved ahead goes this share of her breadth in a step, so that she skips no cable when she drifts
/// sideways; our choice.
const STRIDE: f64 = 0.5;

/// The bridges and cables of a scenario, and the air draughts of its vessels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OverheadSetup {
    /// Bridges and cables with a known height. Empty if no vessel has an air draught.
    pub structures: Vec<Structure>,
    /// For each vessel, her air draught and outline; `None` if her air draught is not known. Empty if there are no
    /// structures.
    pub vessels: Vec<Option<TallVessel>>,
    /// Height above chart datum of the level of high water from which the chart gives clearances (m); `None` if the
    /// scenario does not give the level, or has no structures.
    pub clearance_datum_m: Option<f64>,
}

/// A vessel with a known air draught.
#[derive(Clone, Debug, PartialEq)]
pub struct TallVessel {
    /// Height of the vessel's highest point above her waterline at rest (m).
    pub air_draught_m: f64,
    /// Outline of the vessel.
    pub outline: Outline,
}

/// A bridge or cable.
#[derive(Clone, Debug, PartialEq)]
pub struct Structure {
    /// Class and name in the chart, such as `BRIDGE "High Bridge"`.
    pub name: String,
    /// The structure in plan, north and east (m).
    shape: ChartShape,
    /// Height of the underside above chart datum (m).
    pub above_datum_m: f64,
    low_m: Vec2,
    high_m: Vec2,
}

/// A vessel under a structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AirClearance {
    /// Index of the structure in [`OverheadSetup::structures`].
    pub structure: usize,
    /// Clearance above the vessel's highest point (m); negative if the structure is too low.
    pub clearance_m: f64,
    /// Where the vessel's origin is, north and east (m).
    pub at_m: Vec2,
}

impl Structure {
    /// A structure of the chart; `None` for a point, which no vessel passes under.
    #[must_use]
    pub fn new(name: String, shape: ChartShape, above_datum_m: f64) -> Option<Structure> {
        let first_m = match &shape {
            ChartShape::Point(_) => return None,
            _ => shape.points_m().next()?,
        };
        let (mut low_m, mut high_m) = (first_m, first_m);
        for point in shape.points_m() {
            low_m = vec2(lesser(low_m.x, point.x), lesser(low_m.y, point.y));
            high_m = vec2(greater(high_m.x, point.x), greater(high_m.y, point.y));
        }
        Some(Structure { name, shape, above_datum_m, low_m, high_m })
    }

    /// Whether any part of a hull is under the structure.
    fn is_over(&self, hull: &[Vec2]) -> bool {
        let edges = || (0..hull.len()).map(|from| [hull[from], hull[(from + 1) % hull.len()]]);
        let meets = |line: [Vec2; 2]| {
            contains(hull, line[0]) || edges().any(|edge| of_segments_m(edge, line) <= 0.0)
        };
        match &self.shape {
            ChartShape::Point(_) => false,
            ChartShape::Line(line) => line.windows(2).any(|pair| meets([pair[0], pair[1]])),
            ChartShape::Area(rings) => {
                let around = rings.iter().filter(|ring| contains(ring, hull[0])).count();
                around % 2 == 1
                    || rings.iter().any(|ring| {
                        (0..ring.len())
                            .any(|from| meets([ring[from], ring[(from + 1) % ring.len()]]))
                    })
            }
        }
    }
}

impl OverheadSetup {
    /// The structure with the least clearance under which a vessel is, with the level of the water above datum and her
    /// squat (m); `None` if she is under no structure, or if her air draught is not known.
    #[must_use]
    pub fn over(
        &self,
        vessel: usize,
        state: &BodyState,
        level_m: f64,
        squat_m: f64,
    ) -> Option<AirClearance> {
        let TallVessel { air_draught_m, outline } = self.vessels.get(vessel)?.as_ref()?;
        self.least(outline, state.pose(), level_m + air_draught_m - squat_m)
    }

    /// The structure with the least clearance that a vessel comes under within `within_s` (s) if she keeps her velocity,
    /// heading and squat, and the time until then (s).
    #[must_use]
    pub fn ahead(
        &self,
        vessel: usize,
        state: &BodyState,
        level_m: f64,
        squat_m: f64,
        within_s: f64,
    ) -> Option<(f64, AirClearance)> {
        let TallVessel { air_draught_m, outline } = self.vessels.get(vessel)?.as_ref()?;
        let top_m = level_m + air_draught_m - squat_m;
        let speed_mps = state.velocity_mps.length();
        if speed_mps < SLOW_MPS {
            return None;
        }
        let (low_m, high_m) = outline.bounds();
        let breadth_m = lesser(high_m.x - low_m.x, high_m.y - low_m.y);
        let stride_s = STRIDE * breadth_m / speed_mps;
        let steps = libm::ceil(within_s / stride_s);
        let mut found: Option<(f64, AirClearance)> = None;
        for step in 1..=steps as usize {
            let after_s = stride_s * step as f64;
            let at_m = state.position_m + state.velocity_mps * after_s;
            let Some(now) = self.least(outline, Pose::new(at_m, state.heading_rad), top_m) else {
                continue;
            };
            if found.is_none_or(|(_, least)| now.clearance_m < least.clearance_m) {
                found = Some((after_s, now));
            }
        }
        found
    }

    fn least(&self, outline: &Outline, pose: Pose, top_m: f64) -> Option<AirClearance> {
        let (at_m, reach_m) = (pose.position_m, outline.radius_m());
        let is_near = |of: &Structure| {
            at_m.x + reach_m >= of.low_m.x
                && at_m.x - reach_m <= of.high_m.x
                && at_m.y + reach_m >= of.low_m.y
                && at_m.y - reach_m <= of.high_m.y
        };
        let mut hull: Vec<Vec2> = Vec::new();
        let mut least: Option<AirClearance> = None;
        for (structure, of) in self.structures.iter().enumerate().filter(|(_, of)| is_near(of)) {
            if hull.is_empty() {
                hull = outline.vertices().iter().map(|corner| pose.apply(*corner)).collect();
            }
            let clearance_m = of.above_datum_m - top_m;
            if least.is_none_or(|least| clearance_m < least.clearance_m) && of.is_over(&hull) {
                least = Some(AirClearance { structure, clearance_m, at_m });
            }
        }
        least
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cable along her heading, onto which she drifts sideways, and a cable across her heading.
    #[test]
    fn a_vessel_that_drifts_in_any_direction_finds_the_cable_ahead_of_her() {
        let corners = [(-50.0, -8.0), (50.0, -8.0), (50.0, 8.0), (-50.0, 8.0)];
        let (outline, _) = Outline::new(&corners.map(|(x, y)| vec2(x, y))).unwrap();
        for (line, off_m) in [
            (vec![vec2(-200.0, 100.0), vec2(200.0, 100.0)], [0.0, 92.0]),
            (vec![vec2(142.0, -200.0), vec2(142.0, 200.0)], [92.0, 0.0]),
        ] {
            let cable = Structure::new("cable".to_owned(), ChartShape::Line(line), 20.0).unwrap();
            let tall = TallVessel { air_draught_m: 21.0, outline: outline.clone() };
            let overhead = OverheadSetup {
                structures: vec![cable],
                vessels: vec![Some(tall)],
                clearance_datum_m: None,
            };
            for speed_mps in [0.2, 0.7, 1.9, 5.0, 12.0] {
                let way = vec2(off_m[0], off_m[1]) * (speed_mps / 92.0);
                let state = BodyState { velocity_mps: way, ..BodyState::default() };
                let (after_s, found) = overhead.ahead(0, &state, 0.0, 0.0, 600.0).unwrap();
                assert_eq!(found.clearance_m, -1.0);
                // At most a stride after her side or stem has come under the cable.
                let first_s = 92.0 / speed_mps;
                let stride_s = STRIDE * 16.0 / speed_mps;
                assert!(after_s >= first_s - 1e-9 && after_s <= first_s + stride_s, "{speed_mps}");
            }
        }
    }
}
