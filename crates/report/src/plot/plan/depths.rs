//! Shades of the depths of a nautical chart, and the safety contour, as an electronic chart has them.

use std::collections::BTreeSet;

use fenderline_contact::Vec2;
use fenderline_contact::number::{greater, lesser};
use fenderline_sim::chart::{ChartFeature, ChartKind, ChartShape};

use super::map::Frame;

/// Water deeper than this many draughts is drawn as deep, as on the page of a live session.
const DEEP_DRAUGHTS: f64 = 2.0;
/// Distance from an edge at which the areas on both sides of the edge are looked for (m).
const BESIDE_M: f64 = 0.5;
/// Mean number of edges in a bin of an area.
const IN_BIN: usize = 8;

/// Depths at which the shades of a chart change, for one ship.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthLimits {
    /// Name of the ship.
    pub ship: String,
    /// Draught of the ship (m).
    pub draught_m: f64,
    /// Clearance under the keel that makes water safe (m).
    pub clearance_m: f64,
}

impl DepthLimits {
    /// The depth from which on water is safe for the ship (m).
    #[must_use]
    pub fn safety_m(&self) -> f64 {
        self.draught_m + self.clearance_m
    }

    /// The depth from which on water is drawn as deep (m).
    #[must_use]
    pub fn deep_m(&self) -> f64 {
        greater(DEEP_DRAUGHTS * self.draught_m, self.safety_m())
    }
}

/// Fill colour of a charted depth; shallower water is darker. Without a ship, the shades change at 5, 10 and 20 m.
pub(super) fn depth_fill(depth_m: f64, limits: Option<&DepthLimits>) -> &'static str {
    let [shallow_m, safety_m, deep_m] =
        limits.map_or([5.0, 10.0, 20.0], |of| [of.draught_m, of.safety_m(), of.deep_m()]);
    match depth_m {
        depth if depth < 0.0 => "#cfd8a8",
        depth if depth < shallow_m => "#8ebfe4",
        depth if depth < safety_m => "#b6d8ef",
        depth if depth < deep_m => "#dcecf7",
        _ => "#f4fafd",
    }
}

/// The depth and dredged areas of a chart in the order in which they are drawn: dredged areas over others, small areas
/// over large ones.
pub(super) fn areas(features: &[ChartFeature]) -> Vec<&ChartFeature> {
    let size = |feature: &ChartFeature| {
        Frame::around(feature.shape.points_m()).map_or(0.0, |of| of.size().x * of.size().y)
    };
    let is_area = |feature: &&ChartFeature| {
        feature.kind.is_area_of_depth() && matches!(feature.shape, ChartShape::Area(_))
    };
    let mut all: Vec<_> = features.iter().filter(is_area).map(|of| (size(of), of)).collect();
    let is_dredged = |of: &ChartFeature| of.kind == ChartKind::DredgedArea;
    all.sort_by(|(a_m2, a), (b_m2, b)| {
        is_dredged(a).cmp(&is_dredged(b)).then(b_m2.total_cmp(a_m2))
    });
    all.into_iter().map(|(_, feature)| feature).collect()
}

/// The safety contour in a frame: the edges between water that is at least as deep as `safety_m` and water that is not.
/// Towards land there is no contour.
pub(super) fn safety_contour(
    features: &[ChartFeature],
    frame: Frame,
    safety_m: f64,
) -> Vec<[Vec2; 2]> {
    let areas: Vec<Area> = areas(features).into_iter().filter_map(Area::of).collect();
    let depth_at = |at: Vec2| areas.iter().rev().find(|area| area.has(at)).map(|area| area.depth_m);
    let mut seen = BTreeSet::new();
    let mut contour = Vec::new();
    for [from, to] in areas.iter().flat_map(|area| &area.edges) {
        let [a, b] = [from, to].map(|end| [end.x.to_bits(), end.y.to_bits()]);
        let is_near = lesser(from.x, to.x) <= frame.high.x
            && greater(from.x, to.x) >= frame.low.x
            && lesser(from.y, to.y) <= frame.high.y
            && greater(from.y, to.y) >= frame.low.y;
        let (along, length_m) = (*to - *from, (*to - *from).length());
        // Areas of a chart share their edges.
        if !is_near || length_m == 0.0 || !seen.insert(if a < b { [a, b] } else { [b, a] }) {
            continue;
        }
        let (middle, off) = ((*from + *to) * 0.5, along.quarter_turn() * (BESIDE_M / length_m));
        if let [Some(one_m), Some(other_m)] = [depth_at(middle + off), depth_at(middle - off)]
            && (one_m < safety_m) != (other_m < safety_m)
        {
            contour.push([*from, *to]);
        }
    }
    contour
}

/// An area with its depth, and its edges sorted into bins by their place to the north.
struct Area {
    depth_m: f64,
    frame: Frame,
    edges: Vec<[Vec2; 2]>,
    bins: Vec<Vec<usize>>,
}

impl Area {
    fn of(feature: &ChartFeature) -> Option<Area> {
        let ChartShape::Area(rings) = &feature.shape else { return None };
        let frame = Frame::around(feature.shape.points_m())?;
        let ends = |ring: &Vec<Vec2>| {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(a, b)| [*a, *b]).take(ring.len()).collect::<Vec<_>>()
        };
        let edges: Vec<[Vec2; 2]> = rings.iter().flat_map(ends).collect();
        let bins = vec![Vec::new(); edges.len() / IN_BIN + 1];
        let mut area = Area { depth_m: feature.depth_m.unwrap_or(0.0), frame, edges, bins };
        for (index, [a, b]) in area.edges.iter().enumerate() {
            let (first, last) = (area.bin(lesser(a.x, b.x)), area.bin(greater(a.x, b.x)));
            area.bins[first..=last].iter_mut().for_each(|bin| bin.push(index));
        }
        Some(area)
    }

    /// The bin of a place to the north.
    fn bin(&self, north_m: f64) -> usize {
        let share = (north_m - self.frame.low.x) / greater(self.frame.size().x, 1e-9);
        // A number below 0 becomes 0.
        ((share * self.bins.len() as f64) as usize).min(self.bins.len() - 1)
    }

    /// Whether a place lies in the area (even-odd rule).
    fn has(&self, at: Vec2) -> bool {
        let (low, high) = (self.frame.low, self.frame.high);
        if at.x < low.x || at.x > high.x || at.y < low.y || at.y > high.y {
            return false;
        }
        let crosses = |index: &&usize| {
            let [a, b] = self.edges[**index];
            (a.x > at.x) != (b.x > at.x) && at.y < a.y + (b.y - a.y) * (at.x - a.x) / (b.x - a.x)
        };
        self.bins[self.bin(at.x)].iter().filter(crosses).count() % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    fn area(kind: ChartKind, depth_m: f64, [low, high]: [Vec2; 2]) -> ChartFeature {
        let ring = vec![low, vec2(high.x, low.y), high, vec2(low.x, high.y)];
        ChartFeature {
            kind,
            class: "",
            place: [0, 0],
            name: String::new(),
            shape: ChartShape::Area(vec![ring]),
            depth_m: Some(depth_m),
            deepest_m: None,
            mark: None,
            light: None,
            clearance_m: None,
        }
    }

    /// A dredged channel of 13 m goes north through shoal water, which meets deep water at its northern end.
    #[test]
    fn the_safety_contour_goes_round_the_water_that_is_safe_and_not_towards_land() {
        let chart = [
            area(ChartKind::DredgedArea, 13.0, [vec2(0.0, -50.0), vec2(1000.0, 50.0)]),
            area(ChartKind::DepthArea, 5.0, [vec2(0.0, -400.0), vec2(1000.0, 400.0)]),
            area(ChartKind::DepthArea, 20.0, [vec2(1000.0, -400.0), vec2(2000.0, 400.0)]),
        ];
        let frame = Frame { low: vec2(-100.0, -500.0), high: vec2(2100.0, 500.0) };
        let length_m = |safety_m: f64| -> f64 {
            let contour = safety_contour(&chart, frame, safety_m);
            contour.iter().map(|[from, to]| (*to - *from).length()).sum()
        };
        // Both sides of the channel. The edge of the deep water is one edge over the channel's end: its middle is safe on both
        // sides.
        assert_eq!(length_m(12.0), 2000.0);
        // The channel is not safe: the edge of the deep water, and over a part of this edge the end of the channel.
        assert_eq!(length_m(15.0), 900.0);
        assert_eq!(length_m(25.0), 0.0);
        assert_eq!(length_m(4.0), 0.0);
    }

    #[test]
    fn the_shades_follow_the_ship() {
        let limits = DepthLimits { ship: "ship".to_owned(), draught_m: 10.5, clearance_m: 1.5 };
        let shade = |depth_m: f64| depth_fill(depth_m, Some(&limits));
        assert_eq!((limits.safety_m(), limits.deep_m()), (12.0, 21.0));
        assert_eq!(shade(0.0), shade(10.4));
        assert_eq!(shade(10.5), shade(11.9));
        assert_eq!(shade(12.0), shade(20.9));
        let all = BTreeSet::from([-1.0, 0.0, 11.0, 13.0, 30.0].map(shade));
        assert_eq!(all.len(), 5);
    }
}
