//! Piecewise linear curves.

use fenderline_contact::number::lesser;

/// The value of a curve at `x`; `None` if `x` is outside the curve.
pub fn value(points: &[(f64, f64)], x: f64) -> Option<f64> {
    let (first, last) = (points.first()?, points.last()?);
    if x < first.0 || x > last.0 {
        return None;
    }
    let after = points.partition_point(|point| point.0 < x);
    let Some(before) = after.checked_sub(1) else { return Some(first.1) };
    let ((x0, y0), (x1, y1)) = (points[before], points[after]);
    Some(y0 + (y1 - y0) * ((x - x0) / (x1 - x0)))
}

/// The integral of a curve from its start to `x`, which must lie on the curve.
pub fn integral(points: &[(f64, f64)], x: f64) -> f64 {
    let mut sum = 0.0;
    for piece in points.windows(2) {
        let ((x0, y0), (x1, y1)) = (piece[0], piece[1]);
        if x <= x0 {
            break;
        }
        let end = lesser(x, x1);
        let y_end = y0 + (y1 - y0) * ((end - x0) / (x1 - x0));
        sum += 0.5 * (y0 + y_end) * (end - x0);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::{integral, value};

    const TENT: [(f64, f64); 3] = [(0.0, 0.0), (1.0, 2.0), (3.0, 0.0)];

    #[test]
    fn a_tent_has_its_closed_form() {
        assert_eq!(value(&TENT, 0.0), Some(0.0));
        assert_eq!(value(&TENT, 0.25), Some(0.5));
        assert_eq!(value(&TENT, 1.0), Some(2.0));
        assert_eq!(value(&TENT, 2.0), Some(1.0));
        assert_eq!(value(&TENT, 3.0), Some(0.0));
        assert_eq!((value(&TENT, -0.1), value(&TENT, 3.1)), (None, None));
        assert_eq!(integral(&TENT, 0.0), 0.0);
        assert_eq!(integral(&TENT, 0.5), 0.25);
        assert_eq!(integral(&TENT, 2.0), 2.5);
        assert_eq!(integral(&TENT, 3.0), 3.0);
    }
}
