//! Quay lines of the chart, along which fenders and bollards stand: which line, which part of the line, and on which
//! side of the line the chart has water.

use fenderline_contact::Vec2;
use fenderline_sim::chart::{Chart, ChartFeature, ChartKind, ChartShape};
use fenderline_sim::distance::contains;

use crate::chart::solid_words;

/// Distances of two features that differ by less count as equal (m).
const SAME_M: f64 = 0.1;

/// Which line of the chart is asked for.
#[derive(Debug)]
pub struct Request<'r> {
    /// The chart.
    pub chart: &'r Chart,
    /// Class of the line's feature. `None`: any class that can be solid.
    pub class: Option<&'r str>,
    /// Name of the line's feature. `None`: any name.
    pub name: Option<&'r str>,
    /// The two places between which the line runs, north and east (m). `None`: the whole line.
    pub ends_m: Option<[Vec2; 2]>,
    /// Farthest distance of the places from the line (m).
    pub near_m: f64,
}

/// A part of a line of the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct QuayLine {
    /// Index of the line's feature in the chart.
    pub feature: usize,
    /// Two or more points, north and east (m), each apart from the next.
    pub points_m: Vec<Vec2>,
}

/// Why there is no line.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The chart has no feature of this class and name.
    NoFeature,
    /// Without places, the name must be that of one line; the chart has this number of lines with the name.
    Lines(usize),
    /// A place is too far from every line: number of the place (0 or 1), and the nearest feature with its distance (m).
    Far(usize, usize, f64),
    /// Each place is near a line, but no line is near both: the features that are nearest to the places.
    Apart([usize; 2]),
    /// The two places are nearest to the same point of the line of this feature.
    Same(usize),
}

impl QuayLine {
    /// Finds the line.
    ///
    /// # Errors
    /// [`Refusal`].
    pub fn find(request: &Request<'_>) -> Result<QuayLine, Refusal> {
        let is_asked = |feature: &ChartFeature| {
            let is_of_class = match request.class {
                Some(class) => feature.class == class,
                None => solid_words().any(|word| word == feature.class),
            };
            is_of_class && request.name.is_none_or(|name| feature.name == name)
        };
        let asked = || request.chart.features.iter().enumerate().filter(|(_, of)| is_asked(of));
        let Some(ends_m) = request.ends_m else {
            let lines: Vec<QuayLine> = asked()
                .filter_map(|(feature, of)| match &of.shape {
                    ChartShape::Line(line) => Some(QuayLine { feature, points_m: tidy(line) }),
                    _ => None,
                })
                .collect();
            return match (asked().next(), <[QuayLine; 1]>::try_from(lines)) {
                (None, _) => Err(Refusal::NoFeature),
                (_, Ok([line])) if line.points_m.len() < 2 => Err(Refusal::Same(line.feature)),
                (_, Ok([line])) => Ok(line),
                (_, Err(several)) => Err(Refusal::Lines(several.len())),
            };
        };
        // Lines before areas: at equal distances the line counts, not the border of the land behind the line.
        let lines = asked().filter(|(_, of)| matches!(of.shape, ChartShape::Line(_)));
        let areas = asked().filter(|(_, of)| matches!(of.shape, ChartShape::Area(_)));
        let mut best: Option<(f64, usize, &[Vec2], bool)> = None;
        let mut nearest: [Option<(f64, usize)>; 2] = [None, None];
        for (feature, of) in lines.chain(areas) {
            let (rings, is_closed): (&[Vec<Vec2>], bool) = match &of.shape {
                ChartShape::Line(line) => (std::slice::from_ref(line), false),
                ChartShape::Area(rings) => (rings, true),
                ChartShape::Point(_) => continue,
            };
            for ring in rings {
                let distances = ends_m.map(|end_m| foot(ring, is_closed, end_m).0);
                for (nearest, distance_m) in nearest.iter_mut().zip(distances) {
                    if nearest.is_none_or(|(least_m, _)| distance_m < least_m - SAME_M) {
                        *nearest = Some((distance_m, feature));
                    }
                }
                let sum_m = distances[0] + distances[1];
                let is_near = distances.iter().all(|distance_m| *distance_m <= request.near_m);
                if is_near && best.is_none_or(|(least_m, ..)| sum_m < least_m - SAME_M) {
                    best = Some((sum_m, feature, ring, is_closed));
                }
            }
        }
        let (Some(from), Some(to)) = (nearest[0], nearest[1]) else {
            return Err(Refusal::NoFeature);
        };
        let Some((_, feature, ring, is_closed)) = best else {
            let far = [from, to].into_iter().enumerate().find(|(_, (m, _))| *m > request.near_m);
            return Err(match far {
                Some((end, (distance_m, feature))) => Refusal::Far(end, feature, distance_m),
                None => Refusal::Apart([from.1, to.1]),
            });
        };
        let points_m = tidy(&between(ring, is_closed, ends_m));
        if points_m.len() < 2 {
            return Err(Refusal::Same(feature));
        }
        Ok(QuayLine { feature, points_m })
    }

    /// Length of the line (m).
    #[must_use]
    pub fn length_m(&self) -> f64 {
        self.points_m.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum()
    }

    /// The point at a distance along the line (m), and the unit vector along the line there; at a corner midway between
    /// the directions before and behind the corner.
    #[must_use]
    pub fn at(&self, reach_m: f64) -> (Vec2, Vec2) {
        const AT_CORNER_M: f64 = 0.01;
        let mut start_m = 0.0;
        let last = self.points_m.len() - 2;
        for (index, pair) in self.points_m.windows(2).enumerate() {
            let whole = pair[1] - pair[0];
            let length_m = whole.length();
            let along = whole * (1.0 / length_m);
            let rest_m = reach_m - start_m;
            if rest_m <= length_m + AT_CORNER_M || index == last {
                let is_corner = (rest_m - length_m).abs() <= AT_CORNER_M && index < last;
                let along = match is_corner {
                    false => along,
                    true => {
                        let next = self.points_m[index + 2] - pair[1];
                        let sum = along + next * (1.0 / next.length());
                        if sum.length() > 1e-6 { sum * (1.0 / sum.length()) } else { along }
                    }
                };
                return (pair[0] + (pair[1] - pair[0]) * (rest_m / length_m), along);
            }
            start_m += length_m;
        }
        unreachable!("a line has two points")
    }

    /// The corners of the line, each with its distance along the line (m) and the angle by which the line turns there
    /// (rad, not negative).
    pub fn turns(&self) -> impl Iterator<Item = (f64, f64)> {
        let mut reach_m = 0.0;
        self.points_m.windows(3).map(move |three| {
            let (before, after) = (three[1] - three[0], three[2] - three[1]);
            reach_m += before.length();
            (reach_m, libm::atan2(before.cross(after).abs(), before.dot(after)))
        })
    }
}

/// Whether the chart has water at a place: a depth area, a dredged or an unsurveyed area.
#[must_use]
pub fn has_water(chart: &Chart, at_m: Vec2) -> bool {
    chart.features.iter().any(|feature| {
        let is_water = matches!(
            feature.kind,
            ChartKind::DepthArea | ChartKind::DredgedArea | ChartKind::UnsurveyedArea
        );
        match &feature.shape {
            ChartShape::Area(rings) if is_water => {
                rings.iter().filter(|ring| contains(ring, at_m)).count() % 2 == 1
            }
            _ => false,
        }
    })
}

/// Whether a place lies in one of these polygons, without holes.
pub fn is_in<'p>(mut polygons: impl Iterator<Item = &'p [Vec2]>, at_m: Vec2) -> bool {
    polygons.any(|polygon| contains(polygon, at_m))
}

/// Edges of a line, or of a ring.
fn edges(line: &[Vec2], is_closed: bool) -> impl Iterator<Item = [Vec2; 2]> {
    let last = is_closed.then(|| [line[line.len() - 1], line[0]]);
    line.windows(2).map(|pair| [pair[0], pair[1]]).chain(last)
}

/// The distance of a place from a line (m), with the edge and the share of the edge at which the line is nearest.
fn foot(line: &[Vec2], is_closed: bool, at_m: Vec2) -> (f64, usize, f64) {
    let mut best = (f64::INFINITY, 0, 0.0);
    for (index, [a, b]) in edges(line, is_closed).enumerate() {
        let along = b - a;
        let squared = along.dot(along);
        let share = if squared > 0.0 { (at_m - a).dot(along) / squared } else { 0.0 };
        let share = fenderline_contact::number::bounded(share, 0.0, 1.0);
        let distance_m = (at_m - (a + along * share)).length();
        if distance_m < best.0 {
            best = (distance_m, index, share);
        }
    }
    best
}

/// The part of a line between the points that are nearest to two places; of a ring, the shorter part.
fn between(line: &[Vec2], is_closed: bool, ends_m: [Vec2; 2]) -> Vec<Vec2> {
    let [from, to] = ends_m.map(|end_m| {
        let (_, edge, share) = foot(line, is_closed, end_m);
        (edge, share)
    });
    let next = |index: usize| line[(index + 1) % line.len()];
    let point = |(edge, share): (usize, f64)| line[edge] + (next(edge) - line[edge]) * share;
    let forward = |from: (usize, f64), to: (usize, f64)| {
        let mut part = vec![point(from)];
        let mut edge = from.0;
        let is_before = |edge: usize| edge != to.0;
        if from.0 == to.0 && from.1 > to.1 {
            // Once round the ring.
            part.push(next(edge));
            edge = (edge + 1) % line.len();
        }
        while is_before(edge) {
            part.push(next(edge));
            edge = (edge + 1) % line.len();
        }
        part.push(point(to));
        part
    };
    let back = |from, to| {
        let mut part = forward(to, from);
        part.reverse();
        part
    };
    if !is_closed {
        let is_forward = from.0 < to.0 || (from.0 == to.0 && from.1 <= to.1);
        return if is_forward { forward(from, to) } else { back(from, to) };
    }
    let (one, other) = (forward(from, to), back(from, to));
    let length_m =
        |part: &[Vec2]| -> f64 { part.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum() };
    if length_m(&one) <= length_m(&other) { one } else { other }
}

/// The points of a line without repeated points.
fn tidy(line: &[Vec2]) -> Vec<Vec2> {
    const REPEATED_M: f64 = 1e-3;
    let mut tidy: Vec<Vec2> = Vec::with_capacity(line.len());
    for point in line {
        if tidy.last().is_none_or(|last| (*point - *last).length() > REPEATED_M) {
            tidy.push(*point);
        }
    }
    tidy
}

/// Where a straight line from the water towards the land meets the border of a body: the distance towards the water (m)
/// of the crossing nearest to the place `at_m`, within `reach_m`, at which the body begins. `None`: there is none.
pub fn face_m<'p>(
    at_m: Vec2,
    to_water: Vec2,
    reach_m: f64,
    edges: impl Iterator<Item = [Vec2; 2]>,
    polygons: impl Iterator<Item = &'p [Vec2]> + Clone,
) -> Option<f64> {
    const BESIDE_M: f64 = 0.02;
    let mut best: Option<f64> = None;
    let is_solid = |off_m: f64| is_in(polygons.clone(), at_m + to_water * off_m);
    for [a, b] in edges {
        let along = b - a;
        let slope = to_water.cross(along);
        if slope.abs() < 1e-12 * along.length() {
            continue;
        }
        let off_m = (a - at_m).cross(along) / slope;
        let share = (a - at_m).cross(to_water) / slope;
        let is_on = share * along.length() >= -1e-3 && (share - 1.0) * along.length() <= 1e-3;
        let is_nearer = best.is_none_or(|best: f64| off_m.abs() < best.abs());
        if is_on
            && off_m.abs() <= reach_m
            && is_nearer
            && !is_solid(off_m + BESIDE_M)
            && is_solid(off_m - BESIDE_M)
        {
            best = Some(off_m);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use fenderline_contact::vec2;

    fn points(of: &[(f64, f64)]) -> Vec<Vec2> {
        of.iter().map(|&(x, y)| vec2(x, y)).collect()
    }

    #[test]
    fn the_part_between_two_places_keeps_the_corners_and_the_order() {
        let line = points(&[(0.0, 0.0), (100.0, 0.0), (100.0, 50.0)]);
        let part = between(&line, false, [vec2(20.0, 3.0), vec2(97.0, 30.0)]);
        assert_eq!(part, points(&[(20.0, 0.0), (100.0, 0.0), (100.0, 30.0)]));
        let back = between(&line, false, [vec2(97.0, 30.0), vec2(20.0, 3.0)]);
        assert_eq!(back, points(&[(100.0, 30.0), (100.0, 0.0), (20.0, 0.0)]));
    }

    #[test]
    fn a_ring_is_followed_the_shorter_way() {
        let ring = points(&[(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)]);
        let part = between(&ring, true, [vec2(0.0, 20.0), vec2(10.0, 0.0)]);
        assert_eq!(part, points(&[(0.0, 20.0), (0.0, 0.0), (10.0, 0.0)]));
        let across = between(&ring, true, [vec2(10.0, 0.0), vec2(0.0, 20.0)]);
        assert_eq!(across, points(&[(10.0, 0.0), (0.0, 0.0), (0.0, 20.0)]));
        let on_one_edge = between(&ring, true, [vec2(60.0, 0.0), vec2(10.0, 0.0)]);
        assert_eq!(on_one_edge, points(&[(60.0, 0.0), (10.0, 0.0)]));
    }

    #[test]
    fn places_along_a_line_and_the_direction_at_a_corner() {
        let line =
            QuayLine { feature: 0, points_m: points(&[(0.0, 0.0), (100.0, 0.0), (100.0, 50.0)]) };
        assert_eq!(line.length_m(), 150.0);
        assert_eq!(line.at(40.0), (vec2(40.0, 0.0), vec2(1.0, 0.0)));
        assert_eq!(line.at(120.0), (vec2(100.0, 20.0), vec2(0.0, 1.0)));
        let (at, along) = line.at(100.0);
        assert_eq!(at, vec2(100.0, 0.0));
        assert!((along.x - along.y).abs() < 1e-15 && (along.length() - 1.0).abs() < 1e-15);
        let turns: Vec<_> = line.turns().collect();
        assert_eq!(turns, [(100.0, core::f64::consts::FRAC_PI_2)]);
    }
}
