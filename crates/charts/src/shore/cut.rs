//! Cuts areas of a chart into simple polygons with few corners and without holes.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::distance::contains;

/// Corners nearer to each other than this are one corner (m). Coordinates of charts are rounded to a centimetre.
const SAME_M: f64 = 1e-6;
/// Least area of a ring (m²): smaller ones are left over from rounding at a cut.
const LEAST_M2: f64 = 1e-3;
/// Most corners of a part that is not cut further.
const MOST_CORNERS: usize = 96;
/// Most cuts of cuts. A part that is cut this often is as small as rounding allows.
const DEEPEST: usize = 60;

/// An area with its holes: the outer ring has the positive sense, from north to east, the holes the negative one.
#[derive(Clone, Debug)]
pub(super) struct Region {
    pub(super) outer: Vec<Vec2>,
    holes: Vec<Vec<Vec2>>,
}

/// The regions of an area of a chart. A ring that touches itself in a corner falls into several rings.
pub(super) fn regions(rings: &[Vec<Vec2>]) -> Vec<Region> {
    let mut all = Vec::new();
    for (index, ring) in rings.iter().enumerate() {
        let mut ring = ring.clone();
        // The first ring is the outer one, the others are holes.
        if (doubled_area_m2(&ring) < 0.0) == (index == 0) {
            ring.reverse();
        }
        untouched(ring, &mut all);
    }
    grouped(all)
}

/// The rings of a region's border.
pub(super) fn borders(region: &Region) -> impl Iterator<Item = &Vec<Vec2>> {
    core::iter::once(&region.outer).chain(&region.holes)
}

/// Simple polygons without holes that together are the region.
pub(super) fn parts(region: Region) -> Vec<Vec<Vec2>> {
    let mut done = Vec::new();
    let mut to_cut = vec![(region, 0)];
    while let Some((region, depth)) = to_cut.pop() {
        let place = match region.holes.first() {
            Some(hole) => Some(through(hole, &region)),
            None if region.outer.len() > MOST_CORNERS => Some(through(&region.outer, &region)),
            None => None,
        };
        match place.flatten().filter(|_| depth < DEEPEST) {
            Some(place) => {
                let sides = cut(&region, place);
                to_cut.extend(sides.into_iter().rev().flatten().map(|part| (part, depth + 1)));
            }
            None => done.push(region.outer),
        }
    }
    done
}

/// A straight cut: across the axis north (0) or east (1), at a coordinate (m).
#[derive(Clone, Copy, Debug)]
struct Cut {
    axis: usize,
    at_m: f64,
}

impl Cut {
    /// Coordinates of a point across and along the cut.
    fn of(self, point: Vec2) -> [f64; 2] {
        if self.axis == 0 { [point.x, point.y] } else { [point.y, point.x] }
    }

    fn is_below(self, point: Vec2) -> bool {
        self.of(point)[0] < self.at_m
    }

    /// Where an edge crosses the cut. Both directions of the edge give the same point, bit for bit.
    fn crossing(self, from: Vec2, to: Vec2) -> Vec2 {
        let (from, to) = if self.is_below(from) { (from, to) } else { (to, from) };
        let ([a, a_along], [b, b_along]) = (self.of(from), self.of(to));
        let along_m = a_along + (b_along - a_along) * ((self.at_m - a) / (b - a));
        if self.axis == 0 { vec2(self.at_m, along_m) } else { vec2(along_m, self.at_m) }
    }
}

/// A cut through the middle of a ring of a region, which passes no corner of the region. `None`: all corners are as good as
/// in line.
fn through(ring: &[Vec2], region: &Region) -> Option<Cut> {
    let size = |axis: usize| {
        let of = Cut { axis, at_m: 0.0 };
        let ends = ring.iter().map(|corner| of.of(*corner)[0]);
        let low = ends.clone().fold(f64::INFINITY, libm::fmin);
        (low, ends.fold(f64::NEG_INFINITY, libm::fmax))
    };
    let [north, east] = [size(0), size(1)];
    let axes = if north.1 - north.0 >= east.1 - east.0 { [0, 1] } else { [1, 0] };
    axes.into_iter().find_map(|axis| {
        let (low, high) = if axis == 0 { north } else { east };
        let of = Cut { axis, at_m: 0.0 };
        let all = borders(region).flatten().map(|corner| of.of(*corner)[0]);
        let mut within: Vec<f64> = all.filter(|at| (low..=high).contains(at)).collect();
        within.sort_by(f64::total_cmp);
        let middle = within.len() / 2;
        // The gap nearest to the median.
        let gaps = (0..within.len().saturating_sub(1))
            .filter(|&place| within[place + 1] - within[place] > 2.0 * SAME_M);
        let place = gaps.min_by_key(|place| place.abs_diff(middle))?;
        Some(Cut { axis, at_m: 0.5 * (within[place] + within[place + 1]) })
    })
}

/// A piece of a ring between two crossings of the cut.
struct Chain {
    /// Numbers of the crossings at which the chain begins and ends.
    ends: [usize; 2],
    corners: Vec<Vec2>,
    is_below: bool,
}

/// Cuts a region in two: the regions below the cut, and those above.
fn cut(region: &Region, place: Cut) -> [Vec<Region>; 2] {
    let (mut chains, mut crossings) = (Vec::new(), Vec::new());
    let mut rings = [Vec::new(), Vec::new()];
    for ring in borders(region) {
        let next = |index: usize| ring[(index + 1) % ring.len()];
        let crossed: Vec<usize> = (0..ring.len())
            .filter(|&index| place.is_below(ring[index]) != place.is_below(next(index)))
            .collect();
        if crossed.is_empty() {
            rings[usize::from(!place.is_below(ring[0]))].push(ring.clone());
            continue;
        }
        let first = crossings.len();
        crossings.extend(crossed.iter().map(|&index| place.crossing(ring[index], next(index))));
        for (number, &edge) in crossed.iter().enumerate() {
            let following = (number + 1) % crossed.len();
            let (from, to) = (edge + 1, crossed[following]);
            let to = if to < from { to + ring.len() } else { to };
            chains.push(Chain {
                ends: [first + number, first + following],
                corners: (from..=to).map(|index| ring[index % ring.len()]).collect(),
                is_below: place.is_below(next(edge)),
            });
        }
    }
    let partners = partners(&crossings, place);
    let mut begins: Vec<[Option<usize>; 2]> = vec![[None; 2]; crossings.len()];
    for (index, chain) in chains.iter().enumerate() {
        begins[chain.ends[0]][usize::from(!chain.is_below)] = Some(index);
    }
    let mut used = vec![false; chains.len()];
    for start in 0..chains.len() {
        let side = usize::from(!chains[start].is_below);
        let mut ring = Vec::new();
        let mut at = Some(start);
        while let Some(index) = at.filter(|index| !used[*index]) {
            used[index] = true;
            let Chain { ends: [from, to], corners, .. } = &chains[index];
            ring.push(crossings[*from]);
            ring.extend(corners);
            ring.push(crossings[*to]);
            at = begins[partners[*to]][side];
        }
        untouched(ring, &mut rings[side]);
    }
    rings.map(grouped)
}

/// For each crossing, the crossing at the other end of the land along the cut: land and water take turns.
fn partners(crossings: &[Vec2], place: Cut) -> Vec<usize> {
    let mut order: Vec<usize> = (0..crossings.len()).collect();
    let along = |index: &usize| place.of(crossings[*index])[1];
    order.sort_by(|a, b| along(a).total_cmp(&along(b)).then(a.cmp(b)));
    let mut partners = vec![0; crossings.len()];
    for two in order.chunks_exact(2) {
        partners[two[0]] = two[1];
        partners[two[1]] = two[0];
    }
    partners
}

/// Adds the ring, without repeated corners, and as several rings where it touches itself in a corner.
fn untouched(ring: Vec<Vec2>, into: &mut Vec<Vec<Vec2>>) {
    let mut to_split = vec![ring];
    while let Some(mut ring) = to_split.pop() {
        ring.dedup_by(|one, other| (*one - *other).length() <= SAME_M);
        while ring.len() > 1 && (ring[0] - ring[ring.len() - 1]).length() <= SAME_M {
            ring.pop();
        }
        if ring.len() < 3 {
            continue;
        }
        match repeated(&ring) {
            Some([from, to]) => {
                let between = ring.drain(from..to).collect();
                to_split.extend([ring, between]);
            }
            None if doubled_area_m2(&ring).abs() > 2.0 * LEAST_M2 => into.push(ring),
            None => {}
        }
    }
}

/// The places of two corners of a ring that are the same corner.
fn repeated(ring: &[Vec2]) -> Option<[usize; 2]> {
    let mut order: Vec<usize> = (0..ring.len()).collect();
    let by_place = |a: &usize, b: &usize| {
        let (p, q) = (ring[*a], ring[*b]);
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(a.cmp(b))
    };
    order.sort_by(by_place);
    for (rank, &one) in order.iter().enumerate() {
        let near = order[rank + 1..]
            .iter()
            .take_while(|other| ring[**other].x - ring[one].x <= SAME_M)
            .find(|other| (ring[**other] - ring[one]).length() <= SAME_M);
        if let Some(&other) = near {
            return Some([one.min(other), one.max(other)]);
        }
    }
    None
}

/// Groups rings into regions: each hole belongs to the smallest outer ring around it.
fn grouped(rings: Vec<Vec<Vec2>>) -> Vec<Region> {
    let (outers, holes): (Vec<_>, Vec<_>) =
        rings.into_iter().partition(|ring| doubled_area_m2(ring) > 0.0);
    let mut regions: Vec<Region> =
        outers.into_iter().map(|outer| Region { outer, holes: Vec::new() }).collect();
    for hole in holes {
        // Midway along an edge, as a corner may lie on the outer ring.
        let inside = (hole[0] + hole[1]) * 0.5;
        let around = regions.iter_mut().filter(|region| contains(&region.outer, inside));
        let least = around.min_by(|one, other| {
            doubled_area_m2(&one.outer).total_cmp(&doubled_area_m2(&other.outer))
        });
        if let Some(region) = least {
            region.holes.push(hole);
        }
    }
    regions
}

/// Twice the area of a ring, positive for the sense from north to east (m²).
pub(super) fn doubled_area_m2(ring: &[Vec2]) -> f64 {
    let base = ring[0];
    let ends = ring.iter().zip(ring.iter().cycle().skip(1));
    ends.map(|(from, to)| (*from - base).cross(*to - base)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[(f64, f64)]) -> Vec<Vec2> {
        corners.iter().map(|&(x, y)| vec2(x, y)).collect()
    }

    fn area_m2(rings: &[Vec<Vec2>]) -> f64 {
        rings.iter().map(|ring| 0.5 * doubled_area_m2(ring)).sum()
    }

    #[test]
    fn an_area_with_holes_is_cut_into_parts_of_the_same_area() {
        let outer = ring(&[(0.0, 0.0), (100.0, 0.0), (100.0, 60.0), (50.0, 30.0), (0.0, 60.0)]);
        let hole = ring(&[(10.0, 10.0), (20.0, 10.0), (20.0, 30.0), (10.0, 30.0)]);
        let other = ring(&[(60.0, 5.0), (75.0, 5.0), (75.0, 20.0)]);
        let regions = regions(&[outer.clone(), hole.clone(), other.clone()]);
        let [region] = regions.as_slice() else { panic!("{regions:?}") };
        assert_eq!(borders(region).count(), 3);
        let parts = parts(region.clone());
        let whole = [&outer, &hole, &other].map(|ring| 0.5 * doubled_area_m2(ring).abs());
        assert!((area_m2(&parts) - (whole[0] - whole[1] - whole[2])).abs() < 1e-9);
        let around = |point: Vec2| parts.iter().filter(|part| contains(part, point)).count();
        assert_eq!(around(vec2(15.0, 20.3)), 0, "in the hole");
        assert_eq!(around(vec2(71.3, 11.2)), 0, "in the other hole");
        assert_eq!(around(vec2(30.3, 20.3)), 1);
        assert!(parts.iter().all(|part| fenderline_contact::Outline::new(part).is_ok()));
    }

    #[test]
    fn a_coast_of_many_corners_becomes_parts_of_few_corners() {
        let count = 5000;
        let wavy = |index: usize| {
            let (sin, cos) = libm::sincos(core::f64::consts::TAU * index as f64 / count as f64);
            let radius_m = 3000.0 + if index.is_multiple_of(2) { 0.0 } else { 15.0 };
            vec2(cos, sin) * radius_m
        };
        let coast: Vec<Vec2> = (0..count).map(wavy).collect();
        let whole_m2 = 0.5 * doubled_area_m2(&coast);
        let all: Vec<_> = regions(&[coast]).into_iter().flat_map(parts).collect();
        assert!(all.iter().all(|part| part.len() <= MOST_CORNERS + 4));
        assert!((area_m2(&all) / whole_m2 - 1.0).abs() < 1e-12, "{}", area_m2(&all));
        assert!(all.iter().all(|part| fenderline_contact::Outline::new(part).is_ok()));
    }

    #[test]
    fn a_ring_that_touches_itself_falls_into_rings() {
        // Two squares that share a corner, and a ring that comes back to its border around a hole.
        let pinched = ring(&[
            (0.0, 0.0),
            (5.0, 0.0),
            (5.0, 5.0),
            (10.0, 5.0),
            (10.0, 10.0),
            (5.0, 10.0),
            (5.0, 5.0),
            (0.0, 5.0),
        ]);
        assert_eq!(regions(&[pinched]).len(), 2);
        let holed = ring(&[
            (0.0, 0.0),
            (10.0, 0.0),
            (10.0, 10.0),
            (0.0, 10.0),
            (0.0, 0.0),
            (2.0, 6.0),
            (6.0, 6.0),
            (6.0, 2.0),
        ]);
        let regions = regions(&[holed]);
        let [region] = regions.as_slice() else { panic!("{regions:?}") };
        assert_eq!(region.holes.len(), 1);
        assert!((area_m2(&parts(region.clone())) - 76.0).abs() < 1e-9);
    }
}
