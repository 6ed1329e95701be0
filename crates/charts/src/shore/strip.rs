//! Strips along the lines of a chart: a line has no width, so that nothing could press on it.

use fenderline_contact::Vec2;

/// Shortest segment of a line that gets a strip (m).
const SHORTEST_M: f64 = 0.05;
/// Strips of two segments meet in common corners if the cosine of the turn between them is greater than this; at
/// sharper turns the two strips end straight.
const JOINED_COSINE: f64 = 0.5;

/// The strips along a line: a quadrilateral for each segment, half of the width on either side.
pub(super) fn strips(line: &[Vec2], width_m: f64) -> Vec<[Vec2; 4]> {
    let mut points = line.to_vec();
    points.dedup_by(|one, other| (*one - *other).length() < SHORTEST_M);
    let half_m = 0.5 * width_m;
    let normal = |segment: &[Vec2]| {
        let along = segment[1] - segment[0];
        along.quarter_turn() * (1.0 / along.length())
    };
    let normals: Vec<Vec2> = points.windows(2).map(normal).collect();
    let is_long = |index: usize| (points[index + 1] - points[index]).length() > 2.0 * width_m;
    // Half of the width across the line at a joint of two segments, if their strips meet there.
    let joint = |before: usize, after: usize| {
        let cosine = normals[before].dot(normals[after]);
        (cosine > JOINED_COSINE && is_long(before) && is_long(after))
            .then(|| (normals[before] + normals[after]) * (half_m / (1.0 + cosine)))
    };
    let strip = |index: usize| {
        let straight = normals[index] * half_m;
        let begin = index.checked_sub(1).and_then(|before| joint(before, index));
        let end = (index + 1 < normals.len()).then(|| joint(index, index + 1)).flatten();
        let (begin, end) = (begin.unwrap_or(straight), end.unwrap_or(straight));
        let (from, to) = (points[index], points[index + 1]);
        [from - begin, to - end, to + end, from + begin]
    };
    (0..normals.len()).map(strip).collect()
}

#[cfg(test)]
mod tests {
    use super::strips;
    use fenderline_contact::{Outline, vec2};

    #[test]
    fn strips_of_a_bend_share_their_corners() {
        let line = [vec2(0.0, 0.0), vec2(20.0, 0.0), vec2(34.0, 14.0), vec2(34.0, 15.0)];
        let all = strips(&line, 2.0);
        assert_eq!(all.len(), 3);
        assert_eq!([all[0][1], all[0][2]], [all[1][0], all[1][3]]);
        let area_m2: f64 = all.iter().map(|strip| Outline::new(strip).unwrap().0.area_m2()).sum();
        assert!((area_m2 - 2.0 * (20.0 + 14.0 * 2f64.sqrt() + 1.0)).abs() < 1e-9, "{area_m2}");
    }
}
