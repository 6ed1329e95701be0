//! Depth of the water by place: a grid of soundings.

use fenderline_contact::{Vec2, vec2};

use super::depth_blocks::Blocks;
use super::error::EnvironmentError;
use crate::range::within;

/// Largest number of nodes of a depth field. A field of this size takes 200 MB of memory.
pub const MOST_NODES: usize = 50_000_000;
/// A place nearer to a line of the grid than this share of a cell counts as on the line, so that the nodes beyond the
/// line do not count. Rounding errors of coordinates are smaller than this share.
const ON_LINE: f64 = 1e-9;

/// Depths below datum at the nodes of a square grid, bilinear between the nodes. The field has no data outside the
/// grid, and none in a cell of which a corner has no data.
///
/// The memory of a field does not change in a run: simulations share it by [`std::sync::Arc`].
///
/// ```
/// use fenderline_contact::vec2;
/// use fenderline_ship::environment::DepthField;
/// // Two columns to the north, three rows to the east: 10 m and 12 m deep.
/// let depths_m = vec![10.0, 12.0, 10.0, 12.0, 10.0, 12.0];
/// let field = DepthField::new(vec2(0.0, 0.0), 50.0, 2, 3, depths_m)?;
/// assert_eq!(field.depth_m(vec2(25.0, 60.0)), Some(11.0));
/// assert_eq!(field.gradient(vec2(25.0, 60.0)), Some(vec2(0.04, 0.0)));
/// assert_eq!(field.depth_m(vec2(-1.0, 60.0)), None);
/// # Ok::<(), fenderline_ship::environment::EnvironmentError>(())
/// ```
#[derive(Clone, Debug)]
pub struct DepthField {
    origin_m: Vec2,
    cell_m: f64,
    columns: usize,
    rows: usize,
    /// Depths at the nodes; NaN: no data. The index of the columns (north) varies fastest.
    depths_m: Vec<f32>,
    range_m: [f64; 2],
    blocks: Blocks,
}

impl PartialEq for DepthField {
    /// Fields are equal if all numbers have the same bits. Nodes without data are equal to each other.
    fn eq(&self, other: &DepthField) -> bool {
        let bits = |field: &DepthField| {
            let DepthField { origin_m, cell_m, .. } = field;
            [origin_m.x, origin_m.y, *cell_m].map(f64::to_bits)
        };
        let nodes = self.depths_m.iter().zip(&other.depths_m);
        bits(self) == bits(other)
            && [self.columns, self.rows] == [other.columns, other.rows]
            && nodes.into_iter().all(|(one, two)| one.to_bits() == two.to_bits())
    }
}

// An `Arc` compares addresses first if its content is `Eq`.
impl Eq for DepthField {}

/// A place on an axis of the grid.
#[derive(Clone, Copy)]
struct OnAxis {
    /// Index of the node at or below the place.
    low: usize,
    /// Index of the node above the place; the same as `low` on a line of the grid.
    high: usize,
    /// Weight of the upper node.
    share: f64,
}

impl OnAxis {
    fn of(nodes: usize, at: f64) -> Option<OnAxis> {
        let last = (nodes - 1) as f64;
        let inside = at >= -ON_LINE && at <= last + ON_LINE; // false for NaN
        if !inside {
            return None;
        }
        let nearest = (at + 0.5) as usize; // `at` is not below −ON_LINE
        if (at - nearest as f64).abs() <= ON_LINE {
            return Some(OnAxis { low: nearest, high: nearest, share: 0.0 });
        }
        let low = at as usize;
        Some(OnAxis { low, high: low + 1, share: at - low as f64 })
    }
}

fn mix(low: f64, high: f64, share: f64) -> f64 {
    low + share * (high - low)
}

impl DepthField {
    /// A field of square cells with sides of `cell_m`, along north and east. Node (0, 0) is at `origin_m`, `columns`
    /// nodes go north (x) and `rows` nodes go east (y). The index of the column varies fastest in `depths_m`: depths
    /// below datum (m), positive down, negative where the bottom falls dry, NaN where there is no data.
    ///
    /// # Errors
    /// Fails for fewer than two columns or rows, more than [`MOST_NODES`] nodes, another number of depths than nodes, a
    /// number out of range, or no data at all.
    pub fn new(
        origin_m: Vec2,
        cell_m: f64,
        columns: usize,
        rows: usize,
        mut depths_m: Vec<f32>,
    ) -> Result<DepthField, EnvironmentError> {
        for value in [origin_m.x, origin_m.y] {
            within("corner of the depth field [m]", value, -1e8, 1e8)?;
        }
        within("side of a cell of the depth field [m]", cell_m, 0.01, 1e5)?;
        for nodes in [columns, rows] {
            within("columns and rows of the depth field", nodes as f64, 2.0, MOST_NODES as f64)?;
        }
        let nodes = columns.saturating_mul(rows);
        within("number of nodes of the depth field", nodes as f64, 4.0, MOST_NODES as f64)?;
        let found = depths_m.len();
        if found != nodes {
            let table = "the depth field";
            return Err(EnvironmentError::Length { table, expected: nodes, found });
        }
        let mut range_m = [f64::INFINITY, f64::NEG_INFINITY];
        for node in &mut depths_m {
            if node.is_nan() {
                *node = f32::NAN; // one pattern of bits for all
                continue;
            }
            let depth_m = within("depth of the depth field [m]", f64::from(*node), -1e4, 12_000.0)?;
            *node += 0.0; // no negative zero
            range_m[0] = if depth_m < range_m[0] { depth_m } else { range_m[0] };
            range_m[1] = if depth_m > range_m[1] { depth_m } else { range_m[1] };
        }
        if range_m[0] > range_m[1] {
            return Err(EnvironmentError::NoData { table: "the depth field" });
        }
        let blocks = Blocks::new(columns, rows, &depths_m);
        Ok(DepthField { origin_m, cell_m, columns, rows, depths_m, range_m, blocks })
    }

    /// Depth below datum at a place (m), bilinear in the cell; `None` outside the data, or where a corner of the cell
    /// has no data. On a line of the grid only the nodes of the line count.
    #[must_use]
    pub fn depth_m(&self, place_m: Vec2) -> Option<f64> {
        let [x, y] = self.locate(place_m)?;
        let depth_m = self.between(x, y);
        (!depth_m.is_nan()).then_some(depth_m)
    }

    /// Gradient of the depth at a place (m/m), north and east: it points to deeper water. On a line of the grid the
    /// slope across the line is the mean of both sides, or that of the side with data. The result is `None`
    /// where [`DepthField::depth_m`] gives `None`, and where neither side has data.
    #[must_use]
    pub fn gradient(&self, place_m: Vec2) -> Option<Vec2> {
        self.sounding(place_m).map(|(_, gradient)| gradient)
    }

    /// Depth (m) and gradient at a place in one look-up: see [`DepthField::depth_m`] and [`DepthField::gradient`].
    #[must_use]
    pub fn sounding(&self, place_m: Vec2) -> Option<(f64, Vec2)> {
        let [x, y] = self.locate(place_m)?;
        let depth_m = self.between(x, y);
        let per_m = 1.0 / self.cell_m;
        let north = slope(x, self.columns, |column| self.between(column, y)) * per_m;
        let east = slope(y, self.rows, |row| self.between(x, row)) * per_m;
        let is_known = !(depth_m.is_nan() || north.is_nan() || east.is_nan());
        is_known.then(|| (depth_m, vec2(north, east)))
    }

    /// The least and the greatest depth below datum of the data (m).
    #[must_use]
    pub fn range_m(&self) -> [f64; 2] {
        self.range_m
    }

    /// A depth below datum (m) that no place within a distance of a place undercuts, from blocks of cells: often less
    /// than the least depth there, never more, apart from rounding. `None`: a place within the distance may have no
    /// data.
    #[must_use]
    pub fn at_least_m(&self, place_m: Vec2, reach_m: f64) -> Option<f64> {
        let ends = [-reach_m, reach_m].map(|by_m| {
            let from_m = place_m - self.origin_m + vec2(by_m, by_m);
            [from_m.x / self.cell_m, from_m.y / self.cell_m]
        });
        self.blocks.least_m(ends[0], ends[1])
    }

    /// Side of a cell (m).
    #[must_use]
    pub fn cell_m(&self) -> f64 {
        self.cell_m
    }

    /// The corners of the grid with the least and the greatest north and east (m).
    #[must_use]
    pub fn corners_m(&self) -> [Vec2; 2] {
        let size_m = vec2((self.columns - 1) as f64, (self.rows - 1) as f64) * self.cell_m;
        [self.origin_m, self.origin_m + size_m]
    }

    /// Numbers of nodes to the north and to the east.
    #[must_use]
    pub fn nodes(&self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// Depths below datum at the nodes (m), NaN without data. The index of the column (north) varies fastest.
    #[must_use]
    pub fn depths_m(&self) -> &[f32] {
        &self.depths_m
    }

    fn locate(&self, place_m: Vec2) -> Option<[OnAxis; 2]> {
        let from_m = place_m - self.origin_m;
        let x = OnAxis::of(self.columns, from_m.x / self.cell_m)?;
        let y = OnAxis::of(self.rows, from_m.y / self.cell_m)?;
        Some([x, y])
    }

    /// Depth between nodes (m); NaN if a node that counts has no data.
    fn between(&self, x: OnAxis, y: OnAxis) -> f64 {
        let node =
            |column: usize, row: usize| f64::from(self.depths_m[row * self.columns + column]);
        let in_row = |row: usize| mix(node(x.low, row), node(x.high, row), x.share);
        mix(in_row(y.low), in_row(y.high), y.share)
    }
}

/// Difference of depths from node to node along an axis, at a place; NaN without data. `at` gives the depth at a node
/// of the axis.
fn slope(place: OnAxis, nodes: usize, at: impl Fn(OnAxis) -> f64) -> f64 {
    let node = |index: usize| at(OnAxis { low: index, high: index, share: 0.0 });
    if place.high != place.low {
        return node(place.high) - node(place.low);
    }
    let here_m = node(place.low);
    let below = if place.low > 0 { here_m - node(place.low - 1) } else { f64::NAN };
    let above = if place.low + 1 < nodes { node(place.low + 1) - here_m } else { f64::NAN };
    match (below.is_nan(), above.is_nan()) {
        (false, false) => 0.5 * (below + above),
        (false, true) => below,
        _ => above,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fenderline_contact::number::lesser;

    /// A field from a function of north and east (m).
    fn field(
        origin_m: Vec2,
        cell_m: f64,
        [columns, rows]: [usize; 2],
        depth_m: impl Fn(f64, f64) -> f64,
    ) -> DepthField {
        let node = |index: usize| {
            let (column, row) = ((index % columns) as f64, (index / columns) as f64);
            depth_m(origin_m.x + column * cell_m, origin_m.y + row * cell_m) as f32
        };
        let depths_m = (0..columns * rows).map(node).collect();
        DepthField::new(origin_m, cell_m, columns, rows, depths_m).unwrap()
    }

    /// Places that are spread over a rectangle, without a pattern.
    fn places(count: u32, [low, high]: [Vec2; 2]) -> impl Iterator<Item = Vec2> {
        (1..=count).map(move |index| {
            let share = |by: f64| (f64::from(index) * by).fract();
            vec2(mix(low.x, high.x, share(0.754_877_666)), mix(low.y, high.y, share(0.569_840_291)))
        })
    }

    #[test]
    fn a_plane_has_its_depth_and_its_gradient_everywhere() {
        // Numbers of 24 bits, so that the nodes hold the plane exactly.
        let plane = |north: f64, east: f64| 12.0 + north / 64.0 - east / 32.0;
        let field = field(vec2(-160.0, 80.0), 8.0, [41, 31], plane);
        for place_m in places(2000, field.corners_m()) {
            let depth_m = field.depth_m(place_m).unwrap();
            assert!((depth_m - plane(place_m.x, place_m.y)).abs() < 1e-12, "{place_m:?}");
            let gradient = field.gradient(place_m).unwrap();
            assert!((gradient - vec2(1.0 / 64.0, -1.0 / 32.0)).length() < 1e-12, "{place_m:?}");
        }
        // Lines of the grid, nodes, edges and corners.
        for place_m in
            [vec2(-160.0, 80.0), vec2(160.0, 320.0), vec2(0.0, 100.0), vec2(-160.0, 81.0)]
        {
            let (depth_m, gradient) = field.sounding(place_m).unwrap();
            assert_eq!(depth_m, plane(place_m.x, place_m.y));
            assert_eq!(gradient, vec2(1.0 / 64.0, -1.0 / 32.0));
        }
        assert_eq!(field.range_m(), [plane(-160.0, 320.0), plane(160.0, 80.0)]);
    }

    /// A ship with this depth under her needs no sounding; a ship over a hole in the data does.
    #[test]
    fn no_place_of_an_area_is_shallower_than_the_least_depth_of_its_blocks() {
        let wavy = |north: f64, east: f64| {
            15.0 + 3.0 * libm::sin(north / 37.0) * libm::cos(east / 51.0) - east / 200.0
        };
        let whole = field(vec2(-900.0, 40.0), 2.5, [731, 410], wavy);
        let corners = whole.corners_m();
        let (mut known, mut near) = (0, 0);
        for (index, place_m) in places(300, corners).enumerate() {
            let reach_m = [1.0, 12.0, 90.0, 400.0][index % 4];
            let area = [place_m - vec2(reach_m, reach_m), place_m + vec2(reach_m, reach_m)];
            let within = places(400, area).map(|at_m| whole.depth_m(at_m));
            let Some(least_m) = whole.at_least_m(place_m, reach_m) else {
                assert!(
                    area[0].x < corners[0].x
                        || area[0].y < corners[0].y
                        || area[1].x > corners[1].x
                        || area[1].y > corners[1].y,
                    "{place_m:?}"
                );
                continue;
            };
            let sounded_m = within.map(Option::unwrap).fold(f64::INFINITY, lesser);
            assert!(least_m <= sounded_m + 1e-6, "{place_m:?}, {reach_m}: {least_m}, {sounded_m}");
            known += 1;
            near += usize::from(least_m > sounded_m - 2.0);
        }
        assert!(known > 150 && near > known / 2, "{known}, {near}");
        // A hole, and an area beside it.
        let mut depths_m = vec![9.0; 100 * 100];
        depths_m[50 * 100 + 50] = f32::NAN;
        let holed = DepthField::new(vec2(0.0, 0.0), 1.0, 100, 100, depths_m).unwrap();
        assert_eq!(holed.at_least_m(vec2(50.0, 50.0), 3.0), None);
        assert_eq!(holed.at_least_m(vec2(10.0, 10.0), 3.0), Some(9.0));
        assert_eq!(holed.at_least_m(vec2(f64::NAN, 10.0), 3.0), None);
    }

    #[test]
    fn beyond_an_edge_there_is_no_data() {
        let field = field(vec2(0.0, 0.0), 10.0, [3, 4], |_, _| 5.0);
        let inside = [vec2(0.0, 0.0), vec2(20.0, 30.0), vec2(20.0, 0.0), vec2(7.0, 30.0)];
        assert!(inside.iter().all(|&at_m| field.depth_m(at_m) == Some(5.0)));
        let outside = [
            vec2(-0.001, 5.0),
            vec2(20.001, 5.0),
            vec2(5.0, -0.001),
            vec2(5.0, 30.001),
            vec2(f64::NAN, 5.0),
            vec2(5.0, f64::INFINITY),
            vec2(-1e300, 5.0),
        ];
        for at_m in outside {
            assert_eq!(field.depth_m(at_m), None, "{at_m:?}");
            assert_eq!(field.gradient(at_m), None, "{at_m:?}");
        }
    }

    #[test]
    fn a_cell_with_a_corner_without_data_has_none_but_its_other_sides_do() {
        let nan = f32::NAN;
        #[rustfmt::skip]
        let depths_m = vec![
            1.0, 2.0, 4.0,
            3.0, 6.0, nan,
            5.0, 7.0, 9.0,
        ];
        let field = DepthField::new(vec2(0.0, 0.0), 1.0, 3, 3, depths_m).unwrap();
        assert_eq!(field.range_m(), [1.0, 9.0]);
        assert_eq!(field.depth_m(vec2(0.5, 0.5)), Some(3.0));
        assert_eq!(field.depth_m(vec2(1.5, 0.5)), None);
        assert_eq!(field.depth_m(vec2(1.5, 1.0)), None);
        assert_eq!(field.depth_m(vec2(1.5, 0.0)), Some(3.0));
        // At the middle node only the side to the south has data; across it both sides have.
        assert_eq!(field.sounding(vec2(1.0, 1.0)), Some((6.0, vec2(3.0, 2.5))));
        assert_eq!(field, field.clone());
        let empty = DepthField::new(vec2(0.0, 0.0), 1.0, 2, 2, vec![nan; 4]);
        assert_eq!(empty, Err(EnvironmentError::NoData { table: "the depth field" }));
    }

    #[test]
    fn a_mirrored_or_turned_field_has_mirrored_or_turned_depths() {
        let rough = |north: f64, east: f64| {
            10.0 + 3.0 * libm::sin(0.11 * north + 0.4) * libm::cos(0.07 * east) + 0.01 * north
        };
        let here = field(vec2(-30.0, -20.0), 2.5, [25, 17], rough);
        let mirrored = field(vec2(-30.0, -20.0), 2.5, [25, 17], |n, e| rough(n, -e));
        // Turned by 90 degrees to starboard: north becomes east, east becomes south.
        let turned = field(vec2(-20.0, -30.0), 2.5, [17, 25], |n, e| rough(e, -n));
        let mut all: Vec<Vec2> = places(500, here.corners_m()).collect();
        all.extend([vec2(-30.0, -20.0), vec2(0.0, 2.5), vec2(1.0, 5.0), vec2(30.0, 20.0)]);
        for at_m in all {
            let (depth_m, slope) = here.sounding(at_m).unwrap();
            let (mirrored_m, other) = mirrored.sounding(vec2(at_m.x, -at_m.y)).unwrap();
            assert!((depth_m - mirrored_m).abs() < 1e-9, "{at_m:?}");
            assert!((vec2(slope.x, -slope.y) - other).length() < 1e-9, "{at_m:?}");
            let (turned_m, other) = turned.sounding(vec2(-at_m.y, at_m.x)).unwrap();
            assert!((depth_m - turned_m).abs() < 1e-9, "{at_m:?}");
            assert!((vec2(-slope.y, slope.x) - other).length() < 1e-9, "{at_m:?}");
        }
    }

    #[test]
    fn the_field_is_continuous_from_cell_to_cell() {
        let field = field(vec2(0.0, 0.0), 5.0, [9, 9], |n, e| libm::sin(n * 1.3 + e * 0.9) * 4.0);
        for step in 0..20_000 {
            let at_m = vec2(2e-3 * f64::from(step), 1.7e-3 * f64::from(step));
            let next_m = at_m + vec2(1e-7, 1e-7);
            if let (Some(one), Some(two)) = (field.depth_m(at_m), field.depth_m(next_m)) {
                assert!((one - two).abs() < 1e-6, "{at_m:?}");
            }
        }
    }

    #[test]
    fn what_is_no_field_is_refused_by_name() {
        let make = |cell_m: f64, columns: usize, rows: usize, depths_m: Vec<f32>| {
            DepthField::new(vec2(0.0, 0.0), cell_m, columns, rows, depths_m)
                .unwrap_err()
                .to_string()
        };
        let four = vec![1.0_f32; 4];
        assert!(make(0.0, 2, 2, four.clone()).starts_with("side of a cell of the depth field"));
        assert!(make(f64::NAN, 2, 2, four.clone()).starts_with("side of a cell of the depth"));
        assert!(make(f64::INFINITY, 2, 2, four.clone()).starts_with("side of a cell of the depth"));
        assert!(make(1.0, 1, 4, four.clone()).starts_with("columns and rows"));
        assert!(make(1.0, 7072, 7072, Vec::new()).starts_with("number of nodes of the depth"));
        assert!(make(1.0, usize::MAX, 2, Vec::new()).starts_with("columns and rows"));
        assert_eq!(make(1.0, 2, 3, four), "the depth field needs 6 entries, but has 4");
        assert!(make(1.0, 2, 2, vec![f32::INFINITY; 4]).starts_with("depth of the depth field"));
        let far = DepthField::new(vec2(f64::NAN, 0.0), 1.0, 2, 2, vec![1.0; 4]);
        assert!(far.unwrap_err().to_string().starts_with("corner of the depth field"));
    }

    /// Prints the time of a query in a field of 16 million nodes:
    /// `cargo test -p fenderline-ship --lib depth_field -- --ignored --nocapture`.
    #[test]
    #[ignore = "prints a time"]
    fn a_query_takes_less_than_100_ns() {
        let side = 4000;
        let field = field(vec2(0.0, 0.0), 5.0, [side, side], |n, e| 12.0 + 1e-4 * n - 2e-4 * e);
        let [_, far] = field.corners_m();
        // A ship's stations, near each other, as in a run; then places all over the field.
        for (name, size) in [("under a ship", vec2(300.0, 40.0)), ("all over the field", far)] {
            let places_m: Vec<Vec2> = places(200_000, [vec2(0.0, 0.0), size]).collect();
            // The least of batches: other programs disturb a batch, and never make it faster.
            let [mut depth_ns, mut both_ns] = [f64::INFINITY; 2];
            let (mut sum, mut all) = (0.0, 0.0);
            for batch in places_m.chunks(2000) {
                let start = std::time::Instant::now();
                sum += batch.iter().filter_map(|&at_m| field.depth_m(at_m)).sum::<f64>();
                depth_ns = lesser(depth_ns, start.elapsed().as_nanos() as f64 / 2000.0);
                let start = std::time::Instant::now();
                let slopes = batch.iter().filter_map(|&at_m| field.sounding(at_m));
                all += slopes.map(|(depth_m, slope)| depth_m + slope.x).sum::<f64>();
                both_ns = lesser(both_ns, start.elapsed().as_nanos() as f64 / 2000.0);
            }
            println!(
                "{name}: depth {depth_ns:.1} ns, depth and gradient {both_ns:.1} ns ({sum:.3e}, {all:.3e})"
            );
        }
    }
}
