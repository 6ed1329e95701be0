//! The borders of the areas that are solid, to find areas and lines that lie on them.

use std::collections::BTreeMap;

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::distance::{contains, to_segment_m};

/// How near two borders count as the same border (m). Coordinates of charts are rounded to a centimetre.
const SAME_BORDER_M: f64 = 0.1;
/// Side of a cell of the index of edges (m).
const CELL_M: f64 = 50.0;

/// How an area lies to the areas that are taken.
pub(super) enum Meets {
    /// All of it is solid already.
    LiesWithin,
    /// It overlaps these features, by index in the chart; often none.
    Overlaps(Vec<usize>),
}

/// The borders of the areas that are taken.
#[derive(Default)]
pub(super) struct Borders {
    areas: Vec<Area>,
    /// The edges of all taken areas, by the cells of the index through which the edges run.
    cells: BTreeMap<[i32; 2], Vec<[Vec2; 2]>>,
}

struct Area {
    /// Index of its feature in the chart.
    feature: usize,
    rings: Vec<Vec<Vec2>>,
    low_m: Vec2,
    high_m: Vec2,
}

impl Area {
    fn new(feature: usize, rings: Vec<Vec<Vec2>>) -> Area {
        let (mut low_m, mut high_m) = (rings[0][0], rings[0][0]);
        for corner in rings.iter().flatten() {
            low_m = vec2(libm::fmin(low_m.x, corner.x), libm::fmin(low_m.y, corner.y));
            high_m = vec2(libm::fmax(high_m.x, corner.x), libm::fmax(high_m.y, corner.y));
        }
        Area { feature, rings, low_m, high_m }
    }

    fn may_hold(&self, point: Vec2) -> bool {
        let within = |at: f64, low: f64, high: f64| {
            (low - SAME_BORDER_M..=high + SAME_BORDER_M).contains(&at)
        };
        within(point.x, self.low_m.x, self.high_m.x) && within(point.y, self.low_m.y, self.high_m.y)
    }

    /// Whether a point lies in the area, not in a hole of it.
    fn contains(&self, point: Vec2) -> bool {
        let rings_around = || self.rings.iter().filter(|ring| contains(ring, point)).count();
        self.may_hold(point) && rings_around() % 2 == 1
    }

    fn is_near_border(&self, point: Vec2) -> bool {
        let edges = self.rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        edges.into_iter().any(|(from, to)| to_segment_m(point, [*from, *to]) <= SAME_BORDER_M)
    }
}

fn cell(at: f64) -> i32 {
    libm::floor(at / CELL_M) as i32
}

impl Borders {
    pub(super) fn add(&mut self, feature: usize, rings: Vec<Vec<Vec2>>) {
        for ring in &rings {
            for (from, to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                self.add_edge([*from, *to]);
            }
        }
        self.areas.push(Area::new(feature, rings));
    }

    /// Adds an edge to the cells along it. A long edge is taken step by step.
    fn add_edge(&mut self, edge: [Vec2; 2]) {
        let along = edge[1] - edge[0];
        let steps = libm::ceil(along.length() / CELL_M) + 1.0;
        let mut last = None;
        for step in 0..=steps as usize {
            let at = edge[0] + along * (step as f64 / steps);
            let of = [cell(at.x), cell(at.y)];
            if last != Some(of) {
                last = Some(of);
                self.cells.entry(of).or_default().push(edge);
            }
        }
    }

    /// Whether a point lies in a taken area, or not farther than `near_m` from its border.
    pub(super) fn holds(&self, point: Vec2, near_m: f64) -> bool {
        let (row, column) = (cell(point.x), cell(point.y));
        let around = (-1..=1).flat_map(|by| (-1..=1).map(move |across| [by, across]));
        let near = around
            .filter_map(|[by, across]| self.cells.get(&[row + by, column + across]))
            .flatten()
            .any(|edge| to_segment_m(point, *edge) <= near_m + SAME_BORDER_M);
        near || self.areas.iter().any(|area| area.contains(point))
    }

    /// How an area with these rings, which has a point `inner_m` inside, lies to the areas that are taken.
    pub(super) fn meets(&self, rings: &[Vec<Vec2>], inner_m: Vec2) -> Meets {
        let own = Area::new(0, rings.to_vec());
        let mut overlaps = Vec::new();
        for area in &self.areas {
            let is_off = own.low_m.x > area.high_m.x
                || own.low_m.y > area.high_m.y
                || own.high_m.x < area.low_m.x
                || own.high_m.y < area.low_m.y;
            if is_off {
                continue;
            }
            let has_inner = area.contains(inner_m);
            let is_in = |corner: &Vec2| area.contains(*corner) || area.is_near_border(*corner);
            if has_inner && own.rings.iter().flatten().all(is_in) {
                return Meets::LiesWithin;
            }
            let is_deep =
                |of: &Area, corner: &Vec2| of.contains(*corner) && !of.is_near_border(*corner);
            if has_inner
                || own.rings.iter().flatten().any(|corner| is_deep(area, corner))
                || area.rings.iter().flatten().any(|corner| is_deep(&own, corner))
            {
                overlaps.push(area.feature);
            }
        }
        Meets::Overlaps(overlaps)
    }
}
