//! Whether a ring of a chart crosses itself.

use fenderline_contact::{Vec2, vec2};

/// Two edges of a ring count as crossing only if each end of an edge lies farther than this from the other edge (m).
/// Coordinates of charts are rounded to a centimetre, so rings may touch themselves.
const CROSSING_M: f64 = 0.05;
/// Largest number of pairs of edges that are compared for one ring, which takes a few seconds.
const MOST_PAIRS: u64 = 2_000_000_000;

/// An error: the ring has more pairs of edges near each other than [`MOST_PAIRS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Tangled;

/// Finds a place (m) where two edges of a ring cross, each reaching more than 5 cm beyond the other; `None` if no edges
/// cross.
///
/// # Errors
/// [`Tangled`].
pub(super) fn crossing(ring: &[Vec2]) -> Result<Option<Vec2>, Tangled> {
    let next = |index: usize| ring[(index + 1) % ring.len()];
    let mut edges: Vec<Edge> = ring
        .iter()
        .enumerate()
        .map(|(index, &from_m)| Edge::new(index, from_m, next(index)))
        .collect();
    edges.sort_by(|a, b| a.low.x.total_cmp(&b.low.x).then(a.index.cmp(&b.index)));
    let mut pairs = 0_u64;
    for (rank, edge) in edges.iter().enumerate() {
        for other in &edges[rank + 1..] {
            if other.low.x > edge.high.x {
                break;
            }
            pairs += 1;
            if edge.low.y <= other.high.y && other.low.y <= edge.high.y && edge.crosses(other) {
                return Ok(Some((edge.low + edge.high) * 0.5));
            }
        }
        if pairs > MOST_PAIRS {
            return Err(Tangled);
        }
    }
    Ok(None)
}

/// An edge of a ring with its bounding box.
struct Edge {
    index: usize,
    from_m: Vec2,
    to_m: Vec2,
    low: Vec2,
    high: Vec2,
}

impl Edge {
    fn new(index: usize, from_m: Vec2, to_m: Vec2) -> Edge {
        let low = vec2(libm::fmin(from_m.x, to_m.x), libm::fmin(from_m.y, to_m.y));
        let high = vec2(libm::fmax(from_m.x, to_m.x), libm::fmax(from_m.y, to_m.y));
        Edge { index, from_m, to_m, low, high }
    }

    /// Whether two edges cross: the two ends of each edge lie on different sides of the other edge, and farther than
    /// [`CROSSING_M`] from it.
    fn crosses(&self, other: &Edge) -> bool {
        self.parts(other) && other.parts(self)
    }

    fn parts(&self, other: &Edge) -> bool {
        let along = self.to_m - self.from_m;
        let margin = CROSSING_M * along.length();
        let [a, b] = [other.from_m, other.to_m].map(|end| along.cross(end - self.from_m));
        (a > margin && b < -margin) || (a < -margin && b > margin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_may_touch_itself_but_not_cross_itself() {
        let touching = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (5.0, 0.0), (0.0, 10.0)];
        let crossing_ring = [(0.0, 0.0), (10.0, 10.0), (10.0, 0.0), (0.0, 10.0)];
        let ring = |corners: &[(f64, f64)]| {
            crossing(&corners.iter().map(|&(x, y)| vec2(x, y)).collect::<Vec<_>>())
        };
        assert_eq!(ring(&touching), Ok(None));
        assert!(matches!(ring(&crossing_ring), Ok(Some(_))));
    }
}
