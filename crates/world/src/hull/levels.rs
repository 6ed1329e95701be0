//! Hulls that are given by outlines at several heights, and the checks of these outlines.

use std::fmt;

use fenderline_contact::number::greater;
use fenderline_contact::{Outline, OutlineError, Vec2, vec2};

use super::level::Level;
use super::resample::{self, TurnsBack};

/// Between two given outlines, interpolated outlines are checked at this many heights.
const CHECKED_BETWEEN: usize = 15;

/// Greatest number of outlines of a hull; `MOST_VERTICES` is the greatest number of vertices of each outline. Lines
/// plans have fewer outlines and vertices, and the check of so many is still fast.
const MOST_LEVELS: usize = 50;
const MOST_VERTICES: usize = 1000;

/// The hull of a body, given by outlines at two heights or more, with straight lines between the outlines.
#[derive(Clone, Debug, PartialEq)]
pub struct HullByHeight {
    levels: Vec<Level>,
    draught_m: f64,
}

/// Errors in the outlines of a hull at several heights.
#[derive(Clone, Debug, PartialEq)]
pub enum HullError {
    /// The hull has fewer than two outlines.
    TooFew {
        /// Number of outlines.
        count: usize,
    },
    /// The hull has more outlines than a hull may have.
    TooMany {
        /// Number of outlines.
        count: usize,
    },
    /// An outline has more vertices than is allowed if there are several outlines.
    TooManyVertices {
        /// Number of the outline, from 0.
        level: usize,
        /// Number of the outline's vertices.
        count: usize,
    },
    /// The height of an outline is not greater than the height of the previous outline.
    NotAscending {
        /// Number of the outline, from 0.
        level: usize,
        /// Height of the outline (m).
        height_m: f64,
        /// Height of the previous outline (m).
        before_m: f64,
    },
    /// A given outline is not valid.
    BadOutline {
        /// Number of the outline, from 0.
        level: usize,
        /// The fault of the outline.
        error: OutlineError,
    },
    /// The outlines have different numbers of vertices, and a side of one outline turns back between stern and bow.
    TurnsBack {
        /// Number of the outline, from 0.
        level: usize,
    },
    /// No hull can be interpolated between two of the outlines.
    Crossing {
        /// Number of the lower outline, from 0.
        level: usize,
        /// A height at which the interpolated outline is not valid (m).
        height_m: f64,
        /// The fault of the interpolated outline.
        error: OutlineError,
    },
    /// The waterline lies outside the heights of the outlines.
    WaterlineOutside {
        /// Height of the waterline (m).
        waterline_m: f64,
        /// Heights of the lowest and the highest outline (m).
        range_m: [f64; 2],
    },
}

impl fmt::Display for HullError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            HullError::TooFew { count } => {
                write!(f, "a hull needs outlines at two heights or more, but this hull has {count}")
            }
            HullError::TooMany { count } => {
                write!(
                    f,
                    "a hull may have at most {MOST_LEVELS} outlines, but this hull has {count}"
                )
            }
            HullError::TooManyVertices { level, count } => write!(
                f,
                "outline {level} has {count} vertices, but an outline of a hull with several \
                 outlines may have at most {MOST_VERTICES}"
            ),
            HullError::NotAscending { level, height_m, before_m } => write!(
                f,
                "the heights of the outlines must rise, but outline {level} at {height_m} m \
                 follows an outline at {before_m} m"
            ),
            HullError::BadOutline { level, error } => write!(f, "outline {level}: {error}"),
            HullError::TurnsBack { level } => write!(
                f,
                "the outlines have different numbers of vertices, and a side of outline {level} does not run forward \
                 from stern to bow"
            ),
            HullError::Crossing { level, height_m, error } => write!(
                f,
                "the outline between outlines {level} and {} is not valid at {height_m} m: {error}",
                level + 1
            ),
            HullError::WaterlineOutside { waterline_m, range_m: [low_m, high_m] } => write!(
                f,
                "the heights of the outlines go from {low_m} m to {high_m} m, so the waterline at \
                 {waterline_m} m is outside"
            ),
        }
    }
}

impl std::error::Error for HullError {}

impl HullByHeight {
    /// Makes a hull from outlines in ascending order of height. Vertex `i` of one outline is joined to vertex `i` of
    /// the next outline. Outlines with different numbers of vertices are resampled at common stations. `draught_m` is
    /// the height of the waterline: the draught of a floating body, 0 (datum) for a fixed body.
    ///
    /// # Errors
    /// Returns a [`HullError`], with the number of the faulty outline.
    pub fn new(levels: Vec<Level>, draught_m: f64) -> Result<HullByHeight, HullError> {
        if levels.len() < 2 {
            return Err(HullError::TooFew { count: levels.len() });
        }
        if levels.len() > MOST_LEVELS {
            return Err(HullError::TooMany { count: levels.len() });
        }
        let mut counts = levels.iter().map(|level| level.vertices_m.len()).enumerate();
        if let Some((level, count)) = counts.find(|&(_, count)| count > MOST_VERTICES) {
            return Err(HullError::TooManyVertices { level, count });
        }
        for (level, two) in (1..).zip(levels.windows(2)) {
            let (height_m, before_m) = (two[1].height_m, two[0].height_m);
            if height_m.is_nan() || before_m.is_nan() || height_m <= before_m {
                return Err(HullError::NotAscending { level, height_m, before_m });
            }
        }
        for (level, of) in levels.iter().enumerate() {
            Outline::new(&of.vertices_m).map_err(|error| HullError::BadOutline { level, error })?;
        }
        let range_m = [levels[0].height_m, levels[levels.len() - 1].height_m];
        if !(range_m[0]..=range_m[1]).contains(&draught_m) {
            return Err(HullError::WaterlineOutside { waterline_m: draught_m, range_m });
        }
        let mut levels: Vec<Level> = levels;
        levels.iter_mut().for_each(|level| make_positive(&mut level.vertices_m));
        if levels.windows(2).any(|two| two[0].vertices_m.len() != two[1].vertices_m.len()) {
            resample::at_common_stations(&mut levels)
                .map_err(|TurnsBack { level }| HullError::TurnsBack { level })?;
        }
        let hull = HullByHeight { levels, draught_m };
        hull.check_between()?;
        Ok(hull)
    }

    /// Checks interpolated outlines.
    fn check_between(&self) -> Result<(), HullError> {
        for (level, two) in self.levels.windows(2).enumerate() {
            let (low_m, high_m) = (two[0].height_m, two[1].height_m);
            for part in 1..=CHECKED_BETWEEN {
                let share = part as f64 / (CHECKED_BETWEEN + 1) as f64;
                let height_m = low_m + (high_m - low_m) * share;
                Outline::new(&self.vertices_at_m(height_m))
                    .map_err(|error| HullError::Crossing { level, height_m, error })?;
            }
        }
        Ok(())
    }

    /// The outline of the hull at the waterline. Outlines of other bodies meet the outline at the waterline; fenders do
    /// not.
    ///
    /// # Errors
    /// Fails if the interpolated outline is not valid. An interpolated outline can be invalid between the heights that
    /// were checked.
    pub fn at_waterline(&self) -> Result<Outline, OutlineError> {
        Outline::new(&self.vertices_at_m(self.draught_m)).map(|(outline, _)| outline)
    }

    /// The outlines of the hull, resampled if they had different numbers of vertices.
    #[must_use]
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Height of the waterline (m), which is the draught of a floating body, and 0 for a fixed body, whose heights are
    /// above datum.
    #[must_use]
    pub fn draught_m(&self) -> f64 {
        self.draught_m
    }

    /// Heights of the lowest and the highest outline (m).
    #[must_use]
    pub fn range_m(&self) -> [f64; 2] {
        [self.levels[0].height_m, self.levels[self.levels.len() - 1].height_m]
    }

    /// Largest distance of a vertex from the centre of gravity (m).
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        let all = self.levels.iter().flat_map(|level| &level.vertices_m);
        all.map(|v| v.length()).fold(0.0, greater)
    }

    /// Largest distances of a vertex from the centre of gravity, forward or aft and to a side (m).
    pub(super) fn half_size_m(&self) -> Vec2 {
        let all = self.levels.iter().flat_map(|level| &level.vertices_m);
        all.fold(Vec2::ZERO, |half, v| vec2(greater(half.x, v.x.abs()), greater(half.y, v.y.abs())))
    }

    /// The vertices of the hull's outline at a height (m). Above the highest or below the lowest outline, the vertices
    /// of that outline are returned.
    fn vertices_at_m(&self, height_m: f64) -> Vec<Vec2> {
        (0..self.levels[0].vertices_m.len()).map(|vertex| self.vertex(vertex, height_m).0).collect()
    }

    /// A vertex of the hull at a height (m), and the rate at which the vertex moves with height (m/m). Above the
    /// highest or below the lowest outline, the vertex is that of this outline, with rate 0.
    pub(super) fn vertex(&self, vertex: usize, height_m: f64) -> (Vec2, Vec2) {
        let at = |level: &Level| level.vertices_m[vertex];
        let levels = &self.levels;
        let above = levels.partition_point(|level| level.height_m <= height_m);
        if above == 0 {
            return (at(&levels[0]), Vec2::ZERO);
        }
        let low = &levels[above - 1];
        let Some(high) = levels.get(above) else {
            // At the highest outline the slope below it is used.
            let slope = if height_m == low.height_m {
                self.slope_below(above - 1, vertex)
            } else {
                Vec2::ZERO
            };
            return (at(low), slope);
        };
        let rate = (at(high) - at(low)) * (1.0 / (high.height_m - low.height_m));
        (at(low) + rate * (height_m - low.height_m), rate)
    }

    fn slope_below(&self, level: usize, vertex: usize) -> Vec2 {
        let (low, high) = (&self.levels[level - 1], &self.levels[level]);
        (high.vertices_m[vertex] - low.vertices_m[vertex]) * (1.0 / (high.height_m - low.height_m))
    }
}

/// Puts the vertices of an outline in the positive sense; the first vertex stays first.
fn make_positive(vertices_m: &mut [Vec2]) {
    let first = vertices_m[0];
    let doubled_m2: f64 =
        vertices_m[1..].windows(2).map(|two| (two[0] - first).cross(two[1] - first)).sum();
    if doubled_m2 < 0.0 {
        vertices_m[1..].reverse();
    }
}
