//! Curves with fewer points.

use fenderline_contact::number::lesser;

use super::curves::{Branch, value};

/// Adds a point that lies on a curve to the curve's points, unless they have a point at this deflection.
pub(super) fn insert(branch: &mut Branch, point: (f64, f64)) {
    let after = branch.partition_point(|known| known.0 < point.0);
    if branch.get(after).is_none_or(|known| known.0 > point.0) {
        branch.insert(after, point);
    }
}

/// Keeps few points of a curve, such that all dropped points are within the tolerance of the straight lines between the
/// kept points (Ramer, 1972; Douglas and Peucker, 1973, with the distance in reaction). The point of the curve at the
/// abscissa `kept` always stays.
pub(super) fn thinned(points: &Branch, tolerance: f64, kept: f64) -> Branch {
    let Some(last) = points.len().checked_sub(1) else { return Branch::new() };
    let mut stays = vec![false; points.len()];
    let fixed = points.iter().position(|point| (point.0 - kept).abs() <= 1e-12);
    let mut pieces = vec![(0, fixed.unwrap_or(last)), (fixed.unwrap_or(last), last)];
    for (from, to) in &pieces {
        stays[*from] = true;
        stays[*to] = true;
    }
    while let Some((from, to)) = pieces.pop() {
        let ends = [points[from], points[to]];
        let off = |index: usize| {
            let straight = value(&ends, points[index].0).unwrap_or(ends[0].1);
            (points[index].1 - straight).abs()
        };
        let farthest = (from + 1..to).max_by(|one, other| off(*one).total_cmp(&off(*other)));
        if let Some(index) = farthest.filter(|index| off(*index) > tolerance) {
            stays[index] = true;
            pieces.push((from, index));
            pieces.push((index, to));
        }
    }
    let kept = points.iter().zip(stays).filter(|(_, stays)| *stays);
    kept.map(|(point, _)| *point).collect()
}

/// Lowers the unloading curve to the loading curve where thinning has put the loading curve below the unloading
/// curve.
pub(super) fn below(unloading: Branch, loading: &Branch) -> Branch {
    let mut all = unloading.clone();
    if let Some(end) = unloading.last().map(|last| last.0) {
        // A corner of the loading curve can lie below a straight piece of the unloading curve.
        for corner in loading.iter().filter(|corner| corner.0 < end) {
            if value(&unloading, corner.0).is_some_and(|reaction| reaction > corner.1) {
                insert(&mut all, *corner);
            }
        }
    }
    // The file holds six digits. Away from the corners of the loading curve, stay a little below it, so that rounding
    // puts no point above it.
    let is_corner = |d: f64| loading.iter().any(|corner| corner.0 == d);
    let margin = |d: f64| if is_corner(d) { 1.0 } else { 1.0 - 2e-5 };
    let lowered =
        |(d, r): (f64, f64)| (d, value(loading, d).map_or(r, |bound| lesser(r, margin(d) * bound)));
    all.into_iter().map(lowered).collect()
}
