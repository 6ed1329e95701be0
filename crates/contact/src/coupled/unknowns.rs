//! The unknowns of the equations of an island: the velocities of its floating bodies. The module also lists the bodies
//! that each contact moves.

use alloc::vec::Vec;

use crate::coupled::block_cholesky::{Block, Pattern, Triple};
use crate::coupled::constraint::{Constraint, Jacobian, Side, Speeds};
use crate::maths::vec2::Vec2;
use crate::model::mass::InverseMatrix;

/// The floating bodies and the contacts of an island, with the matrix of the equations. Lists of bodies follow the
/// order of elimination.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unknowns {
    /// Mass matrix of each body.
    masses: Vec<Block>,
    /// One seat per contact.
    seats: Vec<Seat>,
    /// Index in `patterns` of the pattern of the present island's matrix: which blocks of the matrix are not zero.
    pattern: usize,
    /// `patterns` has one pattern for each island that was solved so far; `pattern_of` has, by rank, the pattern of the
    /// island whose first body has this rank.
    patterns: Vec<Pattern>,
    pattern_of: Vec<u32>,
    graph: Graph,
    matrix: Vec<Block>,
}

/// The graph of an island: its floating bodies as nodes, and the pairs of these bodies that touch as edges. The nodes
/// of the graph are numbered in the order of the contacts.
#[derive(Clone, Debug, Default)]
struct Graph {
    /// Rank of each node.
    ranks: Vec<u32>,
    edges: Vec<[u32; 2]>,
    /// Node of each body, by rank; [`NOWHERE`] for a body of another island.
    node_of: Vec<u32>,
}

/// Places of the two bodies of a contact among the unknowns ([`NOWHERE`] for a fixed body), and the block of the matrix
/// that couples these bodies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seat {
    a: u32,
    b: u32,
    between: u32,
}

const NOWHERE: u32 = u32::MAX;

/// A row of the Jacobian of a contact: derivatives of a speed of the contact by the surge, sway and yaw velocity of
/// bodies A and B, earth-fixed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    of_a: Triple,
    of_b: Triple,
}

impl Row {
    /// The row j of the Jacobian for the normal speed: V_n = j·v.
    #[inline(always)]
    pub(crate) fn normal(constraint: &Constraint) -> Row {
        Row::of(constraint, |of| (of.normal, of.levers.n_m))
    }

    /// The row j of the Jacobian for the tangential speed: V_t = j·v.
    #[inline(always)]
    pub(crate) fn tangential(constraint: &Constraint) -> Row {
        Row::of(constraint, |of| (of.normal.quarter_turn(), of.levers.t_m))
    }

    #[inline(always)]
    fn of(constraint: &Constraint, direction: impl Fn(&Jacobian) -> (Vec2, f64)) -> Row {
        let (Vec2 { x, y }, lever_m) = direction(&constraint.jacobian(Side::A));
        let (_, lever_b_m) = direction(&constraint.jacobian(Side::B));
        Row { of_a: [x, y, lever_m], of_b: [-x, -y, -lever_b_m] }
    }
}

impl Unknowns {
    /// Sets the unknowns to the island that has these contacts. Returns false if a mass matrix cannot be inverted
    /// within rounding.
    pub(crate) fn set(&mut self, inverses: &[InverseMatrix], constraints: &[Constraint]) -> bool {
        let Unknowns { masses, seats, pattern, patterns, pattern_of, graph, matrix } = self;
        if pattern_of.len() < inverses.len() {
            pattern_of.resize(inverses.len(), NOWHERE);
            graph.node_of.resize(inverses.len(), NOWHERE);
        }
        graph.set(constraints);
        let slot = &mut pattern_of[graph.ranks[0] as usize];
        if *slot == NOWHERE {
            *slot = patterns.len() as u32;
            patterns.push(Pattern::default());
        }
        *pattern = *slot as usize;
        let pattern = &mut patterns[*pattern];
        pattern.update(graph.ranks.len(), &graph.edges);
        masses.clear();
        masses.resize(graph.ranks.len(), Block::default());
        let mut all_invert = true;
        for (node, &rank) in (0..).zip(&graph.ranks) {
            let mass = inverses[rank as usize].matrix();
            all_invert &= mass.is_some();
            masses[pattern.place_of(node) as usize] = mass.unwrap_or_default();
        }
        seats.clear();
        seats.extend(constraints.iter().map(|constraint| graph.seat(pattern, constraint)));
        matrix.clear();
        matrix.resize(pattern.blocks(), Block::default());
        graph.leave();
        all_invert
    }

    /// Number of floating bodies.
    pub(crate) fn bodies(&self) -> usize {
        self.masses.len()
    }

    pub(crate) fn seats(&self) -> &[Seat] {
        &self.seats
    }

    /// Begins new equations, whose matrix is at first the mass matrix M.
    pub(crate) fn begin(&mut self) {
        let (diagonal, others) = self.matrix.split_at_mut(self.masses.len());
        diagonal.copy_from_slice(&self.masses);
        // Filled entry by entry, this is one call; filled block by block, it would be one call per block.
        others.as_flattened_mut().as_flattened_mut().fill(0.0);
    }

    /// Adds slope · j jᵀ to the matrix of the equations, and force · j to the right side.
    #[inline(always)]
    pub(crate) fn add(&mut self, seat: Seat, row: &Row, force: f64, slope: f64, b: &mut [Triple]) {
        for (place, j) in [(seat.a, &row.of_a), (seat.b, &row.of_b)] {
            if place == NOWHERE {
                continue;
            }
            for (b, j) in b[place as usize].iter_mut().zip(j) {
                *b += force * j;
            }
            if slope != 0.0 {
                add_product(&mut self.matrix[place as usize], slope, j, j);
            }
        }
        if slope != 0.0 && seat.between != NOWHERE {
            let (low, high) =
                if seat.a > seat.b { (&row.of_a, &row.of_b) } else { (&row.of_b, &row.of_a) };
            add_product(&mut self.matrix[seat.between as usize], slope, low, high);
        }
    }

    /// Solves the equations in place: the right side becomes the solution. Returns false if the matrix is not positive
    /// definite within rounding.
    pub(crate) fn solve(&mut self, b: &mut [Triple]) -> bool {
        let pattern = &self.patterns[self.pattern];
        let definite = pattern.factorise(&mut self.matrix);
        if definite {
            pattern.solve(&self.matrix, b);
        }
        definite
    }

    /// The product u·M v.
    pub(crate) fn mass_product(&self, u: &[Triple], v: &[Triple]) -> f64 {
        let of_each = self.masses.iter().zip(u).zip(v).map(|((mass, u), v)| {
            let [x, y, r] = mass.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
            u[0] * x + u[1] * y + u[2] * r
        });
        of_each.sum()
    }

    /// Subtracts the product M v from the right side b.
    pub(crate) fn subtract_momentum(&self, v: &[Triple], b: &mut [Triple]) {
        for ((mass, v), b) in self.masses.iter().zip(v).zip(b) {
            for (row, b) in mass.iter().zip(b) {
                *b -= row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
            }
        }
    }

    /// The change of the speeds of a contact for a change of the velocities of the bodies.
    #[inline(always)]
    pub(crate) fn speeds(seat: Seat, constraint: &Constraint, change: &[Triple]) -> Speeds {
        let dot = |row: Row| {
            let part = |place: u32, j: &Triple| match change.get(place as usize) {
                Some(v) => j[0] * v[0] + j[1] * v[1] + j[2] * v[2],
                None => 0.0,
            };
            part(seat.a, &row.of_a) + part(seat.b, &row.of_b)
        };
        Speeds {
            normal_mps: dot(Row::normal(constraint)),
            tangential_mps: dot(Row::tangential(constraint)),
        }
    }
}

impl Graph {
    fn set(&mut self, constraints: &[Constraint]) {
        self.ranks.clear();
        self.edges.clear();
        for constraint in constraints {
            let nodes = constraint.floating().map(|rank| rank.map(|rank| self.node(rank)));
            if let [Some(a), Some(b)] = nodes
                && self.edges.last() != Some(&[a, b])
            {
                self.edges.push([a, b]);
            }
        }
    }

    /// Returns the node of a body in the graph. A body without a node gets a new node.
    fn node(&mut self, rank: u32) -> u32 {
        let node = &mut self.node_of[rank as usize];
        if *node == NOWHERE {
            *node = self.ranks.len() as u32;
            self.ranks.push(rank);
        }
        *node
    }

    fn seat(&self, pattern: &Pattern, constraint: &Constraint) -> Seat {
        let [a, b] = constraint.floating().map(|rank| match rank {
            Some(rank) => pattern.place_of(self.node_of[rank as usize]),
            None => NOWHERE,
        });
        let both = a != NOWHERE && b != NOWHERE;
        Seat { a, b, between: if both { pattern.block(a.max(b), a.min(b)) } else { NOWHERE } }
    }

    /// Forgets the nodes of the bodies of this island.
    fn leave(&mut self) {
        for &rank in &self.ranks {
            self.node_of[rank as usize] = NOWHERE;
        }
    }
}

/// Adds the product s b cᵀ to the block a.
#[inline(always)]
fn add_product(a: &mut Block, scale: f64, b: &Triple, c: &Triple) {
    for (a, b) in a.iter_mut().zip(b) {
        let scaled = scale * b;
        for (a, c) in a.iter_mut().zip(c) {
            *a += scaled * c;
        }
    }
}
