//! The ends of a mooring line.

/// Positions of the two ends of a line: north, east, up (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineEnds {
    /// The ship's fairlead.
    pub ship_m: [f64; 3],
    /// Position of the line's other end at a bollard, an anchor or the fairlead of another ship.
    pub shore_m: [f64; 3],
}

impl LineEnds {
    /// The distance between the ends of the line (m).
    #[must_use]
    pub fn distance_m(&self) -> f64 {
        Span::of(self).distance_m
    }
}

/// Distance and direction from the ship's end of a line to the other end.
pub(super) struct Span {
    pub(super) distance_m: f64,
    pub(super) horizontal_m: f64,
    /// Height of the line's shore end above the ship's end (m).
    pub(super) up_m: f64,
    /// Unit vector from the line's ship end to its shore end; zero if the ends coincide.
    pub(super) towards_shore: [f64; 3],
    /// Horizontal unit vector from the line's ship end to its shore end; zero if one end is straight above the other.
    pub(super) horizontally: [f64; 2],
}

impl Span {
    pub(super) fn of(ends: &LineEnds) -> Span {
        let [n, e, u] = std::array::from_fn(|k| ends.shore_m[k] - ends.ship_m[k]);
        let horizontal_m = libm::hypot(n, e);
        let distance_m = libm::hypot(horizontal_m, u);
        let unit = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
        Span {
            distance_m,
            horizontal_m,
            up_m: u,
            towards_shore: [n, e, u].map(|part| unit(part, distance_m)),
            horizontally: [n, e].map(|part| unit(part, horizontal_m)),
        }
    }
}
