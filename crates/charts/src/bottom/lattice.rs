//! The nodes of a grid of depths, and a search for the nodes that lie in an area or near a line.

use fenderline_contact::{Vec2, vec2};

/// The nodes of a grid of square cells along north and east. In a list of all nodes, the column (the index to the
/// north) varies fastest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lattice {
    pub(super) origin_m: Vec2,
    pub(super) cell_m: f64,
    pub(super) columns: usize,
    pub(super) rows: usize,
}

/// A rectangle with sides along north and east, which is extended to contain given points (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) low: Vec2,
    pub(super) high: Vec2,
}

impl Extent {
    pub(super) const NONE: Extent = Extent {
        low: vec2(f64::INFINITY, f64::INFINITY),
        high: vec2(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    pub(super) fn with(self, at_m: Vec2) -> Extent {
        Extent {
            low: vec2(libm::fmin(self.low.x, at_m.x), libm::fmin(self.low.y, at_m.y)),
            high: vec2(libm::fmax(self.high.x, at_m.x), libm::fmax(self.high.y, at_m.y)),
        }
    }

    pub(super) fn around(points: impl Iterator<Item = Vec2>) -> Extent {
        points.fold(Extent::NONE, Extent::with)
    }

    pub(super) fn joined(self, other: Extent) -> Extent {
        self.with(other.low).with(other.high)
    }

    pub(super) fn is_empty(self) -> bool {
        self.low.x > self.high.x || self.low.y > self.high.y
    }

    pub(super) fn meets(self, other: Extent) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }
}

impl Lattice {
    /// Makes the grid that contains a rectangle. The coordinates of its nodes are whole multiples of the side of a
    /// cell.
    pub(super) fn around(extent: Extent, cell_m: f64) -> Lattice {
        let [x0, y0] = [extent.low.x, extent.low.y].map(|low| libm::floor(low / cell_m));
        let [x1, y1] = [extent.high.x, extent.high.y].map(|high| libm::ceil(high / cell_m));
        let count = |low: f64, high: f64| libm::fmax(high - low, 1.0) as usize + 1;
        Lattice {
            origin_m: vec2(x0, y0) * cell_m,
            cell_m,
            columns: count(x0, x1),
            rows: count(y0, y1),
        }
    }

    pub(super) fn nodes(&self) -> usize {
        self.columns.saturating_mul(self.rows)
    }

    pub(super) fn place_m(&self, column: usize, row: usize) -> Vec2 {
        self.origin_m + vec2(column as f64, row as f64) * self.cell_m
    }

    pub(super) fn index(&self, column: usize, row: usize) -> usize {
        row * self.columns + column
    }

    /// The indices of the nodes whose coordinate on one axis is from `low` to `high` (m), both included; the range may
    /// be empty.
    fn span(&self, low: f64, high: f64, origin: f64, count: usize) -> core::ops::Range<usize> {
        let first = libm::fmax(libm::ceil((low - origin) / self.cell_m), 0.0);
        let last = libm::fmin(libm::floor((high - origin) / self.cell_m), count as f64 - 1.0);
        // The comparison is false for NaN.
        if first <= last { first as usize..last as usize + 1 } else { 0..0 }
    }

    pub(super) fn columns_within(&self, low: f64, high: f64) -> core::ops::Range<usize> {
        self.span(low, high, self.origin_m.x, self.columns)
    }

    pub(super) fn rows_within(&self, low: f64, high: f64) -> core::ops::Range<usize> {
        self.span(low, high, self.origin_m.y, self.rows)
    }

    /// Calls `fill` with the index of each node in an area, which is given by its rings (even-odd rule). If two areas
    /// have a common edge, a node on this edge lies in only one of them.
    pub(super) fn fill(&self, rings: &[Vec<Vec2>], mut fill: impl FnMut(usize)) {
        let extent = Extent::around(rings.iter().flatten().copied());
        if extent.is_empty() {
            return;
        }
        let rows = self.rows_within(extent.low.y, extent.high.y);
        let mut crossings: Vec<Vec<f64>> = vec![Vec::new(); rows.len()];
        for ring in rings {
            let ends = ring.iter().zip(ring.iter().cycle().skip(1)).take(ring.len());
            for (&a, &b) in ends {
                // The lower end first, so that an edge crosses a row at the same place for both of its areas.
                let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
                for row in self.rows_within(low.y, high.y) {
                    let y = self.place_m(0, row).y;
                    // A corner belongs to the edge above it.
                    if low.y <= y && y < high.y {
                        let x = low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
                        crossings[row - rows.start].push(x);
                    }
                }
            }
        }
        for (row, crossings) in rows.zip(&mut crossings) {
            crossings.sort_by(f64::total_cmp);
            for pair in crossings.chunks_exact(2) {
                for column in self.columns_within(pair[0], pair[1]) {
                    // A node on the far edge belongs to the next area.
                    if self.place_m(column, row).x < pair[1] {
                        fill(self.index(column, row));
                    }
                }
            }
        }
    }

    /// Calls `mark` with the index of each node that is within `reach_m` of a line.
    pub(super) fn near(&self, line: &[Vec2], reach_m: f64, mut mark: impl FnMut(usize)) {
        for pair in line.windows(2) {
            let extent = Extent::around(pair.iter().copied());
            for row in self.rows_within(extent.low.y - reach_m, extent.high.y + reach_m) {
                for column in self.columns_within(extent.low.x - reach_m, extent.high.x + reach_m) {
                    if distance_m(self.place_m(column, row), pair[0], pair[1]) <= reach_m {
                        mark(self.index(column, row));
                    }
                }
            }
        }
    }
}

/// Distance from a point to a straight line segment (m).
fn distance_m(at_m: Vec2, from_m: Vec2, to_m: Vec2) -> f64 {
    let (along, off) = (to_m - from_m, at_m - from_m);
    let length_squared = along.length_squared();
    if length_squared == 0.0 {
        return off.length();
    }
    let share = libm::fmin(libm::fmax(off.dot(along) / length_squared, 0.0), 1.0);
    (off - along * share).length()
}

/// Rounds a length (m) up to a number of the series 1, 2, 5, 10, 20, …
pub(super) fn round_up_m(length_m: f64) -> f64 {
    let mut decade = 1.0;
    // Cells of 1 m to 100 km: a bounded number of steps.
    for _ in 0..6 {
        for factor in [1.0, 2.0, 5.0] {
            if decade * factor >= length_m {
                return decade * factor;
            }
        }
        decade *= 10.0;
    }
    decade
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_areas_with_a_common_edge_share_no_node_and_leave_none_out() {
        let lattice = Lattice { origin_m: Vec2::ZERO, cell_m: 1.0, columns: 11, rows: 11 };
        let corner = |x: f64, y: f64| vec2(x, y);
        let one =
            vec![vec![corner(0.0, 0.0), corner(10.5, 0.0), corner(3.0, 10.5), corner(0.0, 10.5)]];
        let two = vec![vec![corner(10.5, 0.0), corner(10.5, 10.5), corner(3.0, 10.5)]];
        let mut hits = vec![0; lattice.nodes()];
        lattice.fill(&one, |node| hits[node] += 1);
        lattice.fill(&two, |node| hits[node] += 1);
        assert!(hits.iter().all(|hit| *hit == 1), "{hits:?}");
    }

    #[test]
    fn a_hole_is_not_filled() {
        let lattice = Lattice { origin_m: Vec2::ZERO, cell_m: 1.0, columns: 5, rows: 5 };
        let square = |low: f64, high: f64| {
            vec![vec2(low, low), vec2(high, low), vec2(high, high), vec2(low, high)]
        };
        let mut count = 0;
        lattice.fill(&[square(-0.5, 4.5), square(0.5, 3.5)], |_| count += 1);
        assert_eq!(count, 25 - 9);
    }

    #[test]
    fn lengths_are_rounded_up_to_1_2_and_5() {
        for (length_m, rounded_m) in
            [(0.3, 1.0), (1.0, 1.0), (4.7, 5.0), (5.1, 10.0), (81.0, 100.0)]
        {
            assert_eq!(round_up_m(length_m), rounded_m);
        }
    }
}
