//! Computes depths at the nodes of a grid from the depth areas, depth contours and soundings of a chart.

use std::collections::BTreeMap;

use fenderline_contact::Vec2;
use fenderline_keys::keys::bottom::ChartDepths;
use fenderline_sim::chart::{Chart, ChartFeature, ChartKind, ChartShape};

use super::lattice::{Extent, Lattice};
use super::triangles::{Sounded, Triangles, spaced};

/// Height above chart datum that the grid of depths has on land (m): more than any tide. A chart does not give the
/// height of land.
pub const LAND_HEIGHT_M: f64 = 20.0;
/// Number of grid cells behind the front of a quay in which the bottom is as deep as before the front.
const UNDER_QUAY_CELLS: usize = 2;
/// Largest number of points of a triangulation. If there would be more points, fewer points are set between the corners
/// of the contours.
const MOST_POINTS: usize = 400_000;

/// What lies at a node of the grid: land, water or nothing that is known.
#[derive(Clone, Copy, Debug, PartialEq)]
enum At {
    Unknown,
    Land,
    Water { least_m: f64, most_m: Option<f64>, is_dredged: bool },
}

/// Depths that a chart gives at the nodes of a grid.
pub(super) struct Charted {
    /// Depth at each node (m); NaN where the depth is not known.
    pub(super) depths_m: Vec<f64>,
    /// Number of nodes in water, and number of nodes that lie in two depth areas of different depth.
    pub(super) water: usize,
    pub(super) overlapping: usize,
}

/// The depth areas and dredged areas of a chart, each with its rings.
pub(super) fn areas(chart: &Chart) -> impl Iterator<Item = (&ChartFeature, &[Vec<Vec2>])> {
    chart.features.iter().filter_map(|feature| match &feature.shape {
        ChartShape::Area(rings) if feature.kind.is_area_of_depth() => {
            Some((feature, rings.as_slice()))
        }
        _ => None,
    })
}

/// The rectangle around all depth areas, dredged areas and land areas of a chart.
pub(super) fn extent(chart: &Chart) -> Extent {
    let is_land = |feature: &&ChartFeature| {
        feature.kind == ChartKind::Coast && matches!(feature.shape, ChartShape::Area(_))
    };
    let land = chart.features.iter().filter(is_land);
    let all = areas(chart).map(|(feature, _)| feature).chain(land);
    Extent::around(all.flat_map(|feature| feature.shape.points_m()))
}

/// Computes the depths that a chart gives at the nodes of the grid `lattice`.
pub(super) fn depths(chart: &Chart, lattice: &Lattice, choice: ChartDepths) -> Charted {
    let mut at = vec![At::Unknown; lattice.nodes()];
    let overlapping = lay_water(chart, lattice, &mut at);
    lay_unsurveyed_and_land(chart, lattice, &mut at);
    let near_quays = near_quays(chart, lattice);
    let between_m = match choice {
        ChartDepths::Least => None,
        ChartDepths::Interpolated => {
            let points = points(chart, lattice, &near_quays);
            Some(Triangles::of(points).depths_m(lattice, f64::INFINITY))
        }
    };
    let depth_m = |(node, at): (usize, &At)| match *at {
        At::Unknown => f64::NAN,
        At::Land => -LAND_HEIGHT_M,
        At::Water { least_m, most_m, is_dredged } => {
            // A dredged area is level. Where no triangle lies, the least depth counts.
            let known_m = between_m.as_ref().filter(|_| !is_dredged).map(|all| all[node]);
            match known_m.filter(|depth_m| !depth_m.is_nan()) {
                None => least_m,
                Some(depth_m) => {
                    libm::fmin(libm::fmax(depth_m, least_m), most_m.unwrap_or(f64::INFINITY))
                }
            }
        }
    };
    let mut depths_m: Vec<f64> = at.iter().enumerate().map(depth_m).collect();
    let mut is_water: Vec<bool> = at.iter().map(|at| matches!(at, At::Water { .. })).collect();
    let water = is_water.iter().filter(|is| **is).count();
    for _ in 0..UNDER_QUAY_CELLS {
        grow_under_quays(lattice, &near_quays, &mut depths_m, &mut is_water);
    }
    Charted { depths_m, water, overlapping }
}

/// Sets the nodes that lie in depth areas to water. A dredged area replaces a depth area; of two areas of the same kind
/// at a node, the area with less depth counts. Returns the number of nodes that lie in two such areas of different
/// depth.
fn lay_water(chart: &Chart, lattice: &Lattice, at: &mut [At]) -> usize {
    let mut overlapping = 0;
    for dredged in [false, true] {
        for (feature, rings) in areas(chart) {
            let is_dredged = feature.kind == ChartKind::DredgedArea;
            let Some(least_m) = feature.depth_m.filter(|_| is_dredged == dredged) else { continue };
            let water = At::Water { least_m, most_m: feature.deepest_m, is_dredged };
            lattice.fill(rings, |node| {
                at[node] = match at[node] {
                    At::Water { least_m: other_m, is_dredged: other, .. }
                        if other == is_dredged =>
                    {
                        overlapping += usize::from(other_m != least_m);
                        if other_m < least_m { at[node] } else { water }
                    }
                    _ => water,
                };
            });
        }
    }
    overlapping
}

fn lay_unsurveyed_and_land(chart: &Chart, lattice: &Lattice, at: &mut [At]) {
    for (kind, what) in [(ChartKind::UnsurveyedArea, At::Unknown), (ChartKind::Coast, At::Land)] {
        for feature in chart.features.iter().filter(|feature| feature.kind == kind) {
            if let ChartShape::Area(rings) = &feature.shape {
                lattice.fill(rings, |node| at[node] = what);
            }
        }
    }
}

/// For each node of the grid, whether the node is near a quay.
fn near_quays(chart: &Chart, lattice: &Lattice) -> Vec<bool> {
    let reach_m = (UNDER_QUAY_CELLS as f64 + 0.5) * lattice.cell_m;
    let mut near = vec![false; lattice.nodes()];
    for feature in chart.features.iter().filter(|feature| feature.kind == ChartKind::Quay) {
        for line in lines(&feature.shape) {
            lattice.near(&line, reach_m, |node| near[node] = true);
        }
    }
    near
}

/// The lines of a chart feature: a line itself, or the closed rings of an area.
fn lines(shape: &ChartShape) -> Vec<Vec<Vec2>> {
    match shape {
        ChartShape::Point(_) => Vec::new(),
        ChartShape::Line(line) => vec![line.clone()],
        ChartShape::Area(rings) => {
            let closed = |ring: &Vec<Vec2>| ring.iter().chain(ring.first()).copied().collect();
            rings.iter().map(closed).collect()
        }
    }
}

/// Continues the bottom under the front of a quay: a land node near a quay gets the least depth of the water nodes
/// beside it. Otherwise the bottom would rise within the last cell before the quay, under the ship that lies there.
fn grow_under_quays(
    lattice: &Lattice,
    near_quays: &[bool],
    depths_m: &mut [f64],
    is_water: &mut [bool],
) {
    let mut grown = Vec::new();
    for row in 0..lattice.rows {
        for column in 0..lattice.columns {
            let node = lattice.index(column, row);
            if is_water[node] || !near_quays[node] {
                continue;
            }
            let rows = row.saturating_sub(1)..(row + 2).min(lattice.rows);
            let columns = column.saturating_sub(1)..(column + 2).min(lattice.columns);
            let beside = rows.flat_map(|row| columns.clone().map(move |column| (column, row)));
            let least_m = beside
                .map(|(column, row)| lattice.index(column, row))
                .filter(|beside| is_water[*beside])
                .map(|beside| depths_m[beside])
                .fold(f64::INFINITY, libm::fmin);
            if least_m.is_finite() {
                grown.push((node, least_m));
            }
        }
    }
    for (node, depth_m) in grown {
        depths_m[node] = depth_m;
        is_water[node] = true;
    }
}

/// The points of a chart with known depth: on contours, at soundings, on edges between two depth areas, and on the
/// coast.
fn points(chart: &Chart, lattice: &Lattice, near_quays: &[bool]) -> Vec<Sounded> {
    let mut spacing_m = 2.0 * lattice.cell_m;
    // A chart has at most 500,000 points, so the spacing must be doubled a few times at most.
    loop {
        let points = points_spaced(chart, lattice, near_quays, spacing_m);
        if points.len() <= MOST_POINTS || spacing_m > 1e5 {
            return points;
        }
        spacing_m *= 2.0;
    }
}

fn points_spaced(
    chart: &Chart,
    lattice: &Lattice,
    near_quays: &[bool],
    spacing_m: f64,
) -> Vec<Sounded> {
    let mut points = edges_between_areas(chart);
    // The coastline gets the height of the highest ground that falls dry; later, each area's own depths limit the
    // depths at its nodes.
    let least_m = areas(chart).filter_map(|(feature, _)| feature.depth_m).fold(0.0, libm::fmin);
    for feature in &chart.features {
        match (feature.kind, &feature.shape, feature.depth_m) {
            (ChartKind::DepthContour, ChartShape::Line(line), Some(depth_m)) => {
                points.extend(spaced(line, spacing_m).map(|at_m| Sounded { at_m, depth_m }));
            }
            (ChartKind::Sounding, ChartShape::Point(at_m), Some(depth_m)) => {
                points.push(Sounded { at_m: *at_m, depth_m });
            }
            (ChartKind::Coast, shape, _) => {
                for line in lines(shape) {
                    let on_coast = spaced(&line, spacing_m)
                        .filter(|at_m| !is_near(lattice, near_quays, *at_m))
                        .map(|at_m| Sounded { at_m, depth_m: least_m });
                    points.extend(on_coast);
                }
            }
            _ => {}
        }
    }
    points
}

/// Whether the grid node nearest to the place `at_m` is near a quay.
fn is_near(lattice: &Lattice, near_quays: &[bool], at_m: Vec2) -> bool {
    let off = (at_m - lattice.origin_m) * (1.0 / lattice.cell_m);
    let (column, row) = (libm::round(off.x), libm::round(off.y));
    let is_inside = (0.0..lattice.columns as f64).contains(&column)
        && (0.0..lattice.rows as f64).contains(&row);
    is_inside && near_quays[lattice.index(column as usize, row as usize)]
}

/// The corners that two depth areas share. There the water has the least depth of the deeper area.
fn edges_between_areas(chart: &Chart) -> Vec<Sounded> {
    let mut depths_of: BTreeMap<[u64; 2], (Vec2, [f64; 2])> = BTreeMap::new();
    for (feature, _) in areas(chart).filter(|(feature, _)| feature.kind == ChartKind::DepthArea) {
        let Some(least_m) = feature.depth_m else { continue };
        for at_m in feature.shape.points_m() {
            let key = [at_m.x.to_bits(), at_m.y.to_bits()];
            let entry = depths_of.entry(key).or_insert((at_m, [least_m; 2]));
            entry.1 = [libm::fmin(entry.1[0], least_m), libm::fmax(entry.1[1], least_m)];
        }
    }
    let shared = depths_of.into_values().filter(|(_, [low_m, high_m])| low_m < high_m);
    shared.map(|(at_m, [_, depth_m])| Sounded { at_m, depth_m }).collect()
}
