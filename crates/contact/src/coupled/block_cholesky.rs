//! Sparse Cholesky factors of symmetric positive definite matrices of 3 × 3 blocks. Each row of blocks belongs to one
//! floating body.
//!
//! The matrix of an island of a hundred barges has 300 rows. A row of the matrix has entries only for its own body and
//! for the bodies that this body touches. The blocks are eliminated in the order of minimum degree (Tinney and Walker
//! 1967; George and Liu 1989): next is the body with the fewest neighbours left, and among equal bodies the first in
//! the island. The graph of the contacts alone determines the order of elimination and the places of the factor's
//! blocks ([`Pattern`]), so both are kept while the graph stays the same. The same graph gives the same order of
//! elimination, whether the order was kept or found again, so the bits of the result do not depend on keeping it.

use alloc::vec::Vec;

/// A 3 × 3 block of the matrix: its rows are surge, sway and yaw of one body, its columns those of another body.
pub(crate) type Block = [[f64; 3]; 3];

/// Three numbers for surge, sway and yaw of one body.
pub(crate) type Triple = [f64; 3];

/// The places of the blocks in the Cholesky factor of the matrix that belongs to a graph of contacts. The nodes of the
/// graph are numbered by their place in the order of elimination.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pattern {
    /// The graph of contacts: number of nodes, and edges between nodes, as the caller gave them.
    nodes: usize,
    edges: Vec<[u32; 2]>,
    /// Place of each node in the order of elimination.
    place_of: Vec<u32>,
    /// The place in `rows` where each column's blocks below the diagonal begin; the list has one more entry than
    /// columns.
    first: Vec<u32>,
    /// Row of each block below the diagonal, in ascending order within a column.
    rows: Vec<u32>,
    /// For each column, and for each pair of its rows i ≥ k: the index of the block (i, k) that the elimination of this
    /// column changes.
    targets: Vec<u32>,
    search: Search,
}

/// Buffers for the search for the order of elimination.
#[derive(Clone, Debug, Default)]
struct Search {
    /// Neighbours of each node that are not yet eliminated, in ascending order.
    neighbours: Vec<Vec<u32>>,
    /// The nodes that are not yet eliminated, in ascending order.
    left: Vec<u32>,
    /// The eliminated nodes, in the order of elimination.
    order: Vec<u32>,
    merged: Vec<u32>,
}

const NOT_YET: u32 = u32::MAX;

impl Pattern {
    /// Updates the pattern of the factor for a graph of contacts. If the graph is the same as in the last call, the
    /// update costs only a comparison.
    pub(crate) fn update(&mut self, nodes: usize, edges: &[[u32; 2]]) {
        if self.nodes == nodes && self.edges == edges {
            return;
        }
        self.nodes = nodes;
        self.edges.clear();
        self.edges.extend_from_slice(edges);
        self.search.begin(nodes, edges);
        self.search.eliminate();
        self.write();
    }

    /// Writes the order of elimination and the columns that the search has found.
    fn write(&mut self) {
        let Search { neighbours, order, .. } = &self.search;
        self.place_of.clear();
        self.place_of.resize(self.nodes, NOT_YET);
        for (place, &node) in (0..).zip(order) {
            self.place_of[node as usize] = place;
        }
        self.first.clear();
        self.rows.clear();
        for &node in order {
            let from = self.rows.len();
            self.first.push(from as u32);
            let places = neighbours[node as usize].iter().map(|&n| self.place_of[n as usize]);
            self.rows.extend(places);
            self.rows[from..].sort_unstable();
        }
        self.first.push(self.rows.len() as u32);
        self.targets.clear();
        for column in 0..self.nodes {
            let own = self.column(column);
            for k in own.clone() {
                for i in k..own.end {
                    let target = self.block(self.rows[i], self.rows[k]);
                    self.targets.push(target);
                }
            }
        }
    }

    /// The blocks of a column below the diagonal, as a range of `rows`.
    fn column(&self, column: usize) -> core::ops::Range<usize> {
        self.first[column] as usize..self.first[column + 1] as usize
    }

    /// Place of a node in the order of elimination.
    #[inline]
    pub(crate) fn place_of(&self, node: u32) -> u32 {
        self.place_of[node as usize]
    }

    /// Number of blocks of the factor on and below the diagonal.
    pub(crate) fn blocks(&self) -> usize {
        self.nodes + self.rows.len()
    }

    /// The index of the block that couples the nodes at two places. `row` must not be smaller than `column`. The blocks
    /// on the diagonal come first in the list of blocks.
    pub(crate) fn block(&self, row: u32, column: u32) -> u32 {
        if row == column {
            return row;
        }
        let own = self.column(column as usize);
        let index = self.rows[own.clone()].binary_search(&row).expect("coupled by an edge");
        (self.nodes + own.start + index) as u32
    }

    /// Replaces a matrix, given by its blocks, by its Cholesky factor. Returns false if the matrix is not positive
    /// definite within rounding.
    #[inline(never)]
    pub(crate) fn factorise(&self, blocks: &mut [Block]) -> bool {
        let mut targets = self.targets.iter();
        for column in 0..self.nodes {
            let Some(pivot) = cholesky(&blocks[column]) else { return false };
            blocks[column] = pivot;
            let own = self.column(column);
            let own = self.nodes + own.start..self.nodes + own.end;
            for block in &mut blocks[own.clone()] {
                block.iter_mut().for_each(|row| *row = forward(&pivot, *row));
            }
            for k in own.clone() {
                let right = blocks[k];
                for i in k..own.end {
                    let left = blocks[i];
                    let target = targets.next().expect("one target for each pair of rows");
                    subtract_product(&mut blocks[*target as usize], &left, &right);
                }
            }
        }
        true
    }

    /// Solves L Lᵀ x = b in place, where L is the Cholesky factor; the unknowns are ordered by place.
    #[inline(never)]
    pub(crate) fn solve(&self, factor: &[Block], b: &mut [Triple]) {
        for column in 0..self.nodes {
            let solved = forward(&factor[column], b[column]);
            b[column] = solved;
            for index in self.column(column) {
                let of = &mut b[self.rows[index] as usize];
                for (of, row) in of.iter_mut().zip(&factor[self.nodes + index]) {
                    *of -= dot(row, &solved);
                }
            }
        }
        for column in (0..self.nodes).rev() {
            let mut left = b[column];
            for index in self.column(column) {
                let known = b[self.rows[index] as usize];
                for (row, known) in factor[self.nodes + index].iter().zip(known) {
                    for (left, entry) in left.iter_mut().zip(row) {
                        *left -= entry * known;
                    }
                }
            }
            b[column] = backward(&factor[column], left);
        }
    }
}

impl Search {
    fn begin(&mut self, nodes: usize, edges: &[[u32; 2]]) {
        self.neighbours.iter_mut().for_each(Vec::clear);
        if self.neighbours.len() < nodes {
            self.neighbours.resize_with(nodes, Vec::new);
        }
        for &[a, b] in edges {
            for (node, other) in [(a, b), (b, a)] {
                let list = &mut self.neighbours[node as usize];
                if let Err(at) = list.binary_search(&other) {
                    list.insert(at, other);
                }
            }
        }
        self.left.clear();
        self.left.extend(0..nodes as u32);
        self.order.clear();
    }

    /// Finds the order. Afterwards `neighbours` holds the neighbours that each node had when it was eliminated.
    fn eliminate(&mut self) {
        let Search { neighbours, left, order, merged } = self;
        while !left.is_empty() {
            let least = |&(_, &node): &(usize, &u32)| neighbours[node as usize].len();
            let (at, _) = left.iter().enumerate().min_by_key(least).expect("not empty");
            let node = left.remove(at);
            order.push(node);
            let own = core::mem::take(&mut neighbours[node as usize]);
            for &other in &own {
                merged.clear();
                merge(&own, &neighbours[other as usize], [node, other], merged);
                let list = &mut neighbours[other as usize];
                list.clear();
                list.extend_from_slice(merged);
            }
            neighbours[node as usize] = own;
        }
    }
}

/// Merges two ascending lists into one list that has each number once and none of the numbers in `omitted`.
fn merge(one: &[u32], two: &[u32], omitted: [u32; 2], merged: &mut Vec<u32>) {
    let (mut one, mut two) = (one.iter().peekable(), two.iter().peekable());
    loop {
        let next = match (one.peek(), two.peek()) {
            (Some(&&p), Some(&&q)) => p.min(q),
            (Some(&&p), None) => p,
            (None, Some(&&q)) => q,
            (None, None) => return,
        };
        one.next_if(|&&p| p == next);
        two.next_if(|&&q| q == next);
        if !omitted.contains(&next) {
            merged.push(next);
        }
    }
}

#[inline(always)]
fn dot(p: &Triple, q: &Triple) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

/// Computes the lower Cholesky factor of a block from the lower part of the block. The diagonal of the block's factor
/// is stored inverted, because the solves multiply by it.
#[inline(always)]
fn cholesky(a: &Block) -> Option<Block> {
    let inverse_root = |square: f64| (square > 0.0).then(|| 1.0 / libm::sqrt(square));
    let l00 = inverse_root(a[0][0])?;
    let (l10, l20) = (a[1][0] * l00, a[2][0] * l00);
    let l11 = inverse_root(a[1][1] - l10 * l10)?;
    let l21 = (a[2][1] - l20 * l10) * l11;
    let l22 = inverse_root(a[2][2] - l20 * l20 - l21 * l21)?;
    Some([[l00, 0.0, 0.0], [l10, l11, 0.0], [l20, l21, l22]])
}

/// Solves L x = b for x, where L is the lower Cholesky factor of a block.
#[inline(always)]
fn forward(l: &Block, b: Triple) -> Triple {
    let x = b[0] * l[0][0];
    let y = (b[1] - l[1][0] * x) * l[1][1];
    let z = (b[2] - l[2][0] * x - l[2][1] * y) * l[2][2];
    [x, y, z]
}

/// Solves Lᵀ x = b for x, where L is the lower Cholesky factor of a block.
#[inline(always)]
fn backward(l: &Block, b: Triple) -> Triple {
    let z = b[2] * l[2][2];
    let y = (b[1] - l[2][1] * z) * l[1][1];
    let x = (b[0] - l[1][0] * y - l[2][0] * z) * l[0][0];
    [x, y, z]
}

/// Subtracts the product b cᵀ of two blocks from the block a.
#[inline(always)]
fn subtract_product(a: &mut Block, b: &Block, c: &Block) {
    for (a, b) in a.iter_mut().zip(b) {
        for (a, c) in a.iter_mut().zip(c) {
            *a -= dot(b, c);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    /// Edges of a grid with diagonals, like the contacts of barges that lie in rows, slightly askew.
    fn grid(side: u32) -> Vec<[u32; 2]> {
        let mut edges = Vec::new();
        for row in 0..side {
            for column in 0..side {
                let node = row * side + column;
                if column + 1 < side {
                    edges.push([node, node + 1]);
                }
                if row + 1 < side {
                    edges.push([node, node + side]);
                }
                if row + 1 < side && column + 1 < side {
                    edges.push([node, node + side + 1]);
                }
            }
        }
        edges
    }

    /// Random entries between −1 and 1.
    fn noise(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        f64::from((*state >> 40) as u32) / f64::from(1_u32 << 23) - 1.0
    }

    /// The residual of the sparse solve, computed with the full matrix, relative to the right side.
    #[test]
    fn a_grid_s_equations_are_solved_to_rounding() {
        let side = 7;
        let (nodes, edges) = ((side * side) as usize, grid(side));
        let mut pattern = Pattern::default();
        pattern.update(nodes, &edges);
        let mut seed = 7;
        let mut blocks = vec![[[0.0; 3]; 3]; pattern.blocks()];
        let mut full = vec![vec![0.0; 3 * nodes]; 3 * nodes];
        let mut add = |p: u32, q: u32, value: Block| {
            let (row, column) = (p.max(q), p.min(q));
            let transposed = p < q;
            let block = &mut blocks[pattern.block(row, column) as usize];
            for i in 0..3 {
                for k in 0..3 {
                    let entry = if transposed { value[k][i] } else { value[i][k] };
                    block[i][k] += entry;
                    full[3 * row as usize + i][3 * column as usize + k] += entry;
                    if row != column {
                        full[3 * column as usize + k][3 * row as usize + i] += entry;
                    }
                }
            }
        };
        for node in 0..nodes as u32 {
            let place = pattern.place_of(node);
            add(place, place, [[20.0, 0.0, 0.0], [0.0, 20.0, 0.0], [0.0, 0.0, 20.0]]);
        }
        for &[a, b] in &edges {
            let value: Block = core::array::from_fn(|_| core::array::from_fn(|_| noise(&mut seed)));
            add(pattern.place_of(a), pattern.place_of(b), value);
        }
        let b: Vec<Triple> =
            (0..nodes).map(|_| core::array::from_fn(|_| noise(&mut seed))).collect();
        let mut x = b.clone();
        assert!(pattern.factorise(&mut blocks));
        pattern.solve(&blocks, &mut x);
        for (row, entries) in full.iter().enumerate() {
            let sum: f64 = entries.iter().enumerate().map(|(k, e)| e * x[k / 3][k % 3]).sum();
            assert!((sum - b[row / 3][row % 3]).abs() < 1e-13, "row {row}: {sum}");
        }
    }

    /// A chain is eliminated from its ends: no block is filled in.
    #[test]
    fn a_chain_has_no_fill() {
        let edges: Vec<[u32; 2]> = (0..99).map(|n| [n, n + 1]).collect();
        let mut pattern = Pattern::default();
        pattern.update(100, &edges);
        assert_eq!(pattern.blocks(), 199);
    }

    /// The order is the same, whether the pattern was kept or found anew after another graph.
    #[test]
    fn the_pattern_does_not_depend_on_the_graph_before() {
        let mut kept = Pattern::default();
        kept.update(9, &grid(3));
        kept.update(49, &grid(7));
        kept.update(25, &grid(5));
        let mut fresh = Pattern::default();
        fresh.update(25, &grid(5));
        assert_eq!(kept.place_of, fresh.place_of);
        assert_eq!((kept.first, kept.rows, kept.targets), (fresh.first, fresh.rows, fresh.targets));
    }

    #[test]
    fn a_matrix_that_is_not_positive_definite_is_refused() {
        let mut pattern = Pattern::default();
        pattern.update(1, &[]);
        assert!(!pattern.factorise(&mut [[[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]]));
        assert!(!pattern.factorise(&mut [[[f64::NAN; 3]; 3]]));
    }
}
