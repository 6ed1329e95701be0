//! Estimates the damping where hydrodynamic data have none: below their first frequency, and beyond their last.
//!
//! Panel codes compute the added mass and the damping each by itself. By Ogilvie's relation (Kramers and Kronig's) the
//! damping at *all* frequencies gives the added mass at each frequency. The added mass of the data therefore shows the
//! damping that the data lack. The lacking damping is taken as a polygon over a few nodes of frequency. The values of
//! the lacking damping at the nodes are those with which added mass and damping agree best, by least squares. The
//! lacking part of the damping is large at a quay, where the resonances of the gap do not end with the data, and in
//! heave in shallow water, where the damping is large in the slowest waves of the data.

use fenderline_contact::number::{greater, lesser};

use super::data::Hydrodynamics;
use super::matrix::{Matrix6, ZERO};
use super::ogilvie::change;

/// Nodes of the polygon below the first frequency of the hydrodynamic data, divided by this frequency. At both ends of
/// these nodes the polygon of the lacking damping is zero.
const SLOW: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
/// Frequency at which the tail of the damping ends, divided by the last frequency of the hydrodynamic data.
pub(super) const TAIL: f64 = 1.5;
/// Nodes of the polygon beyond the last frequency of the hydrodynamic data, divided by this frequency. At both ends of
/// these nodes the polygon of the lacking damping is zero.
const FAST: [f64; 7] = [1.0, FIRST_NODE, 1.1, 1.2, 1.3, 1.4, TAIL];
/// Frequency, divided by the last frequency of the hydrodynamic data, at which a straight line from the damping at the
/// last frequency reaches zero. The polygon is added to this line.
pub(super) const FIRST_NODE: f64 = 1.05;
/// Number of nodes at which the polygon has a value.
const NODES: usize = SLOW.len() - 2 + FAST.len() - 2;
/// Weight of the size of the polygon's values in the least squares, beside the agreement of added mass and damping. The
/// weight of the values' size was found by trial: with half of it the moored ship's sway at a step of 0.5 s is 2.2 %
/// less than at 0.1 s (`moored_in_waves.rs` allows 2 %); with half as much again a row of the ship in 15 m of water is
/// 2.03 % off (`waves_between.rs`).
const RIDGE: f64 = 2e-2;
/// Rounds of the solution.
const ROUNDS: usize = 1000;

/// Values at the nodes.
type AtNodes = [f64; NODES];

/// Computes the unknown damping at the frequencies of a grid (rad/s), beside a damping that is known on this grid.
///
/// For a single motion, the damping must take energy, and the unknown part is no more than the largest damping of the
/// data. For two coupled motions, the unknown damping is limited by that of each motion, because the damping must take
/// energy in both together too.
pub(super) fn unknown_damping(
    data: &Hydrodynamics,
    grid_radps: &[f64],
    known: &[Matrix6],
) -> Vec<Matrix6> {
    let data_radps = &data.frequencies_radps;
    let ends_radps = [data_radps[0], data_radps[data_radps.len() - 1]];
    let shapes: [Vec<f64>; NODES] = std::array::from_fn(|node| {
        grid_radps.iter().map(|w| triangle(node, *w, ends_radps)).collect()
    });
    // What a damping of 1 at a node changes in the added mass, at each frequency of the data.
    let changes: [Vec<f64>; NODES] = std::array::from_fn(|node| {
        let of = |k: usize| shapes[node][k];
        without_mean(data_radps.iter().map(|w| change(grid_radps, of, *w)).collect())
    });
    let lacking = |i: usize, j: usize| {
        let added = data.added_mass.iter().zip(data_radps);
        let change_of_known = |w: f64| change(grid_radps, |k| known[k][i][j], w);
        without_mean(added.map(|(added, w)| added[i][j] - change_of_known(*w)).collect())
    };
    // What is known at each node. In waves slower than the data it is a cubic to zero.
    let known_at: [Matrix6; NODES] = std::array::from_fn(|node| {
        let peak = |&a: &usize, &b: &usize| shapes[node][a].total_cmp(&shapes[node][b]);
        let k = (0..grid_radps.len()).max_by(peak).expect("a grid");
        known[k]
    });
    let mut values = [[[0.0; NODES]; 6]; 6];
    for i in 0..6 {
        if data.is_coupled(i, i) {
            let most = data.damping.iter().map(|matrix| matrix[i][i]).fold(0.0, greater);
            let limits = std::array::from_fn(|node| [lesser(-known_at[node][i][i], 0.0), most]);
            values[i][i] = best(&changes, &lacking(i, i), &limits);
        }
    }
    for i in 0..6 {
        for j in i + 1..6 {
            if data.is_coupled(i, j) {
                let limits = std::array::from_fn(|node| {
                    let of = |k: usize| greater(known_at[node][k][k] + values[k][k][node], 0.0);
                    let (most, has) = ((of(i) * of(j)).sqrt(), known_at[node][i][j]);
                    [-most - has, most - has]
                });
                values[i][j] = best(&changes, &lacking(i, j), &limits);
                values[j][i] = values[i][j];
            }
        }
    }
    let at = |k: usize| -> Matrix6 {
        let mut sum = ZERO;
        for (row, of_row) in sum.iter_mut().zip(&values) {
            for (entry, of) in row.iter_mut().zip(of_row) {
                *entry = shapes.iter().zip(of).map(|(shape, value)| shape[k] * value).sum();
            }
        }
        sum
    };
    (0..grid_radps.len()).map(at).collect()
}

/// The part of the polygon that belongs to a node: it is 1 at the node and 0 at the nodes beside it.
fn triangle(node: usize, frequency_radps: f64, [first_radps, last_radps]: [f64; 2]) -> f64 {
    let slow = SLOW.len() - 2;
    let (nodes, x) = match node < slow {
        true => (&SLOW[node..node + 3], frequency_radps / first_radps),
        false => (&FAST[node - slow..node - slow + 3], frequency_radps / last_radps),
    };
    let (rises, falls) =
        ((x - nodes[0]) / (nodes[1] - nodes[0]), (nodes[2] - x) / (nodes[2] - nodes[1]));
    greater(lesser(rises, falls), 0.0)
}

/// Subtracts the mean from values: a constant counts as added mass at infinite frequency, which is free.
fn without_mean(mut values: Vec<f64>) -> Vec<f64> {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter_mut().for_each(|value| *value -= mean);
    values
}

/// Finds factors of columns, within limits, with which their sum is nearest to the wanted values: one factor after the
/// other, in rounds.
fn best(columns: &[Vec<f64>; NODES], wanted: &[f64], limits: &[[f64; 2]; NODES]) -> AtNodes {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut squares: [AtNodes; NODES] =
        std::array::from_fn(|i| std::array::from_fn(|j| dot(&columns[i], &columns[j])));
    let largest = (0..NODES).map(|k| squares[k][k]).fold(0.0, greater);
    for (k, row) in squares.iter_mut().enumerate() {
        row[k] += RIDGE * RIDGE * largest;
    }
    let right: AtNodes = std::array::from_fn(|k| dot(&columns[k], wanted));
    let mut factors = [0.0; NODES];
    for _ in 0..ROUNDS {
        for k in 0..NODES {
            let rest = dot(&squares[k], &factors) - squares[k][k] * factors[k];
            let free = (right[k] - rest) / squares[k][k];
            factors[k] = greater(lesser(free, limits[k][1]), limits[k][0]);
        }
    }
    factors
}
