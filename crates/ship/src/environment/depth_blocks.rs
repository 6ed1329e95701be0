//! Least depths of a depth field by blocks of cells, to tell in a few look-ups that an area is deep enough.

/// Cells along the side of a block of the finest level, as a power of two.
const FINEST: u32 = 4;
/// Most blocks along a side of an area for one look-up; a larger area takes a coarser level.
const MOST_ACROSS: usize = 6;

/// Least depths by blocks. The sides of the blocks of a level are twice as long as those of the level before.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    /// Cells of the field to the north and to the east.
    cells: [usize; 2],
    levels: Vec<Level>,
}

#[derive(Clone, Debug)]
struct Level {
    /// Blocks to the north.
    columns: usize,
    /// Least depth of each block (m): infinite without data. The index of the columns varies fastest.
    least_m: Vec<f32>,
    /// Whether a node of the block has no data.
    has_gap: Vec<bool>,
}

impl Blocks {
    /// The blocks of a field with two columns and rows or more.
    pub(super) fn new(columns: usize, rows: usize, depths_m: &[f32]) -> Blocks {
        let side = 1 << FINEST;
        let cells = [columns - 1, rows - 1];
        let count = cells.map(|cells| cells.div_ceil(side));
        let mut finest = Level::empty(count);
        for (row, nodes) in depths_m.chunks_exact(columns).enumerate() {
            for (column, depth_m) in nodes.iter().enumerate() {
                // A node on the line between two blocks counts in both.
                for of_row in around(row, side, count[1]) {
                    for of_column in around(column, side, count[0]) {
                        finest.take(of_row * count[0] + of_column, *depth_m);
                    }
                }
            }
        }
        let mut levels = vec![finest];
        let mut count = count;
        while count[0] > MOST_ACROSS || count[1] > MOST_ACROSS {
            let next = count.map(|count| count.div_ceil(2));
            let mut coarser = Level::empty(next);
            let last = &levels[levels.len() - 1];
            for row in 0..count[1] {
                for column in 0..count[0] {
                    let (from, to) = (row * count[0] + column, row / 2 * next[0] + column / 2);
                    coarser.take(to, last.least_m[from]);
                    coarser.has_gap[to] |= last.has_gap[from];
                }
            }
            levels.push(coarser);
            count = next;
        }
        Blocks { cells, levels }
    }

    /// The least depth of an area (m), between the given places on both axes in units of cells: at most as deep as any
    /// place with data in the area. `None`: the area has a place without data.
    pub(super) fn least_m(&self, low: [f64; 2], high: [f64; 2]) -> Option<f64> {
        let [most_north, most_east] = self.cells.map(|cells| cells as f64);
        let is_within =
            low[0] >= 0.0 && low[1] >= 0.0 && high[0] <= most_north && high[1] <= most_east;
        if !is_within {
            return None;
        }
        // A place on a line of the grid may lie a rounding error beside the line: take one more cell.
        let first = [0, 1].map(|axis| (low[axis] as usize).saturating_sub(1));
        let last = [0, 1].map(|axis| (high[axis] as usize + 1).min(self.cells[axis] - 1));
        let across = |shift: u32| {
            [0, 1].map(|axis| (last[axis] >> shift) - (first[axis] >> shift)).into_iter().max()
        };
        let number = (0..self.levels.len() - 1)
            .find(|number| across(FINEST + *number as u32) < Some(MOST_ACROSS))
            .unwrap_or(self.levels.len() - 1);
        let (level, shift) = (&self.levels[number], FINEST + number as u32);
        let mut least_m = f32::INFINITY;
        for row in first[1] >> shift..=last[1] >> shift {
            let of_row = row * level.columns;
            for block in of_row + (first[0] >> shift)..=of_row + (last[0] >> shift) {
                if level.has_gap[block] {
                    return None;
                }
                least_m =
                    if level.least_m[block] < least_m { level.least_m[block] } else { least_m };
            }
        }
        Some(f64::from(least_m))
    }
}

impl Level {
    fn empty([columns, rows]: [usize; 2]) -> Level {
        let blocks = columns * rows;
        Level { columns, least_m: vec![f32::INFINITY; blocks], has_gap: vec![false; blocks] }
    }

    fn take(&mut self, block: usize, depth_m: f32) {
        if depth_m.is_nan() {
            self.has_gap[block] = true;
        } else if depth_m < self.least_m[block] {
            self.least_m[block] = depth_m;
        }
    }
}

/// The blocks of an axis in which a node counts: one, or two for a node on their line.
fn around(node: usize, side: usize, count: usize) -> impl Iterator<Item = usize> + Clone {
    let on_line = node.is_multiple_of(side) && node > 0;
    let before = on_line.then(|| node / side - 1);
    before.into_iter().chain(Some(node / side).filter(|block| *block < count))
}
