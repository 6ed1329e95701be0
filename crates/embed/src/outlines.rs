//! Makes outlines of bodies from the points of a mesh: convex hull, mirrored half, fewer vertices.

use fenderline_contact::Vec2;
use fenderline_contact::number::bounded;

use crate::error::EngineError;

/// The convex hull of points (m), by Andrew's monotone chain: the corners in the positive sense, without points on a
/// straight edge.
///
/// # Errors
/// Fails if a point is not finite, or if all points lie on one line.
pub fn hull_of_points(points_m: &[Vec2]) -> Result<Vec<Vec2>, EngineError> {
    check(points_m)?;
    let mut sorted = points_m.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    sorted.dedup();
    let mut hull = chain(sorted.iter().copied());
    // Each chain ends with the point at which the other begins.
    hull.pop();
    let mut back = chain(sorted.into_iter().rev());
    back.pop();
    hull.append(&mut back);
    if hull.len() < 3 {
        return Err(EngineError::Points("the points lie on one line: they enclose no area"));
    }
    Ok(hull)
}

/// Finds one side of the convex hull of sorted points.
fn chain(sorted: impl Iterator<Item = Vec2>) -> Vec<Vec2> {
    let mut side: Vec<Vec2> = Vec::new();
    for point in sorted {
        while let [.., a, b] = side[..]
            && (b - a).cross(point - b) <= 0.0
        {
            side.pop();
        }
        side.push(point);
    }
    side
}

/// Makes the outline of a ship from the points of her starboard side (m), from the bow to the stern or from the stern
/// to the bow: these points and their mirror images about the centreline. Points on the centreline are not repeated;
/// points to port by less than `tolerance_m` count as points on the centreline.
///
/// # Errors
/// Fails if a point is not finite or lies too far to port, or if no point lies to starboard of the centreline.
pub fn mirrored_outline(side_m: &[Vec2], tolerance_m: f64) -> Result<Vec<Vec2>, EngineError> {
    check(side_m)?;
    if !(tolerance_m.is_finite() && tolerance_m >= 0.0) {
        return Err(EngineError::Points("the tolerance must be 0 or more"));
    }
    if side_m.iter().any(|point| point.y < -tolerance_m) {
        return Err(EngineError::Points("a point of the starboard side lies to port (y < 0)"));
    }
    let mut whole: Vec<Vec2> = side_m.to_vec();
    for point in &mut whole {
        if point.y <= tolerance_m {
            point.y = 0.0;
        }
    }
    let port = whole.iter().rev().filter(|point| point.y > 0.0);
    let mut port: Vec<Vec2> = port.map(|point| Vec2 { x: point.x, y: -point.y }).collect();
    if port.is_empty() {
        return Err(EngineError::Points("no point lies to starboard of the centreline"));
    }
    whole.append(&mut port);
    Ok(whole)
}

/// Thins an outline to fewer vertices, by the method of Ramer and of Douglas and Peucker. No vertex of the given
/// outline is farther than `tolerance_m` from the new outline. When an outline is thinned, the two vertices that are
/// farthest apart along one axis stay.
///
/// # Errors
/// Fails if a point or the tolerance is not finite, or if there are fewer than three vertices.
pub fn simplified_outline(outline_m: &[Vec2], tolerance_m: f64) -> Result<Vec<Vec2>, EngineError> {
    check(outline_m)?;
    if !(tolerance_m.is_finite() && tolerance_m >= 0.0) {
        return Err(EngineError::Points("the tolerance must be 0 or more"));
    }
    let count = outline_m.len();
    if count < 3 {
        return Err(EngineError::Points("an outline has at least three vertices"));
    }
    // The closed line is cut at two vertices that certainly belong to the new outline.
    let first = extreme(outline_m, |point| point.x);
    let ring: Vec<Vec2> = (0..=count).map(|step| outline_m[(first + step) % count]).collect();
    let far = extreme(&ring[..count], |point| (point - ring[0]).length_squared());
    let mut keep = vec![false; count + 1];
    (keep[0], keep[far]) = (true, true);
    let mut parts = vec![(0, far), (far, count)];
    while let Some((from, to)) = parts.pop() {
        let distance_m = |index: usize| distance_m(ring[index], ring[from], ring[to]);
        let farthest = (from + 1..to).max_by(|&a, &b| distance_m(a).total_cmp(&distance_m(b)));
        if let Some(at) = farthest.filter(|&at| distance_m(at) > tolerance_m) {
            keep[at] = true;
            parts.push((from, at));
            parts.push((at, to));
        }
    }
    let kept = (0..count).filter(|&index| keep[index]).map(|index| ring[index]);
    let kept: Vec<Vec2> = kept.collect();
    if kept.len() < 3 {
        return Err(EngineError::Points("nothing is left of the outline: use a smaller tolerance"));
    }
    Ok(kept)
}

/// Index of the first of the points with the largest value.
fn extreme(points: &[Vec2], of: impl Fn(Vec2) -> f64) -> usize {
    (1..points.len()).fold(0, |best, i| if of(points[i]) > of(points[best]) { i } else { best })
}

/// Distance of a point from the straight piece between two other points (m).
fn distance_m(point: Vec2, from: Vec2, to: Vec2) -> f64 {
    let (along, offset) = (to - from, point - from);
    let squared = along.length_squared();
    let share = if squared > 0.0 { bounded(along.dot(offset) / squared, 0.0, 1.0) } else { 0.0 };
    (offset - along * share).length()
}

fn check(points_m: &[Vec2]) -> Result<(), EngineError> {
    if points_m.iter().all(|point| point.is_finite()) {
        return Ok(());
    }
    Err(EngineError::Points("a point is not finite"))
}

#[cfg(test)]
mod tests {
    use fenderline_contact::number::lesser;
    use fenderline_contact::{Outline, Vec2, vec2};

    use super::{distance_m, hull_of_points, mirrored_outline, simplified_outline};

    /// A ship's waterline of 2 × 60 points: parallel sides, an elliptic bow, a straight stern.
    fn side() -> Vec<Vec2> {
        let bow = (0..40).map(|i| {
            let angle_rad = f64::from(i) / 40.0 * core::f64::consts::FRAC_PI_2;
            vec2(40.0 + 30.0 * libm::cos(angle_rad), 12.0 * libm::sin(angle_rad))
        });
        bow.chain((0..20).map(|i| vec2(40.0 - 5.0 * f64::from(i), 12.0))).collect()
    }

    #[test]
    fn the_hull_of_points_is_that_of_the_outermost() {
        let corners = [vec2(-10.0, -3.0), vec2(10.0, -3.0), vec2(10.0, 3.0), vec2(-10.0, 3.0)];
        let mut points: Vec<Vec2> = (0..400)
            .map(|i| vec2(f64::from(i % 20) - 9.5, 0.25 * f64::from(i / 20) - 2.4))
            .collect();
        points.extend(corners);
        points.push(vec2(0.0, 3.0));
        assert_eq!(hull_of_points(&points).expect("an area"), corners);
        let line = [vec2(0.0, 0.0), vec2(1.0, 1.0), vec2(2.0, 2.0)];
        assert!(hull_of_points(&line).is_err());
        assert!(hull_of_points(&[vec2(f64::NAN, 0.0)]).is_err());
    }

    #[test]
    fn a_mirrored_side_is_a_whole_ship_of_twice_its_area() {
        let whole = mirrored_outline(&side(), 0.01).expect("a starboard side");
        assert_eq!(whole.len(), 119, "the bow is on the centreline, the stern is straight");
        let (outline, _) = Outline::new(&whole).expect("a valid outline");
        // Parallel part of 95 m × 24 m and half an ellipse of half-axes 30 m and 12 m; the polygon in it lacks less than 0.1 %.
        let closed_form_m2 = 95.0 * 24.0 + 0.5 * core::f64::consts::PI * 30.0 * 12.0;
        assert!((outline.area_m2() / closed_form_m2 - 1.0).abs() < 1e-3);
        assert!(outline.centroid_m().y.abs() < 1e-9);
        assert!(mirrored_outline(&[vec2(0.0, -1.0), vec2(1.0, 2.0)], 0.1).is_err());
        assert!(mirrored_outline(&[vec2(0.0, 0.0), vec2(1.0, 0.0)], 0.1).is_err());
    }

    #[test]
    fn a_simplified_outline_stays_within_the_tolerance() {
        let whole = mirrored_outline(&side(), 0.0).expect("a starboard side");
        for tolerance_m in [0.0, 0.05, 0.5, 2.0] {
            let fewer = simplified_outline(&whole, tolerance_m).expect("an outline");
            Outline::new(&fewer).expect("a valid outline");
            let edges = || (0..fewer.len()).map(|i| (fewer[i], fewer[(i + 1) % fewer.len()]));
            for point in &whole {
                let least_m = edges().map(|(a, b)| distance_m(*point, a, b)).fold(f64::MAX, lesser);
                assert!(least_m <= tolerance_m + 1e-12, "{point:?} is {least_m} m away");
            }
        }
        assert!(simplified_outline(&whole, 0.05).expect("an outline").len() < whole.len() / 2);
        assert!(simplified_outline(&whole, -1.0).is_err());
        assert!(simplified_outline(&whole[..2], 0.1).is_err());
    }
}
