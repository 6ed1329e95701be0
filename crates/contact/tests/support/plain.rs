//! The overlap of two convex polygons by plain Sutherland & Hodgman (1974) in f64, without memory. It is fast enough
//! for comparing the clip in millions of cases.

use fenderline_contact::Vec2;

/// The corners of the overlap.
pub fn plain_overlap(a: &[Vec2], b: &[Vec2]) -> Vec<Vec2> {
    let mut ring = a.to_vec();
    for (j, &from) in b.iter().enumerate() {
        let along = b[(j + 1) % b.len()] - from;
        let side = |p: Vec2| along.cross(p - from);
        let mut kept = Vec::with_capacity(ring.len() + 2);
        for (i, &p) in ring.iter().enumerate() {
            let q = ring[(i + 1) % ring.len()];
            let (p_side, q_side) = (side(p), side(q));
            if p_side >= 0.0 {
                kept.push(p);
            }
            if (p_side > 0.0 && q_side < 0.0) || (p_side < 0.0 && q_side > 0.0) {
                kept.push(p + (q - p) * (p_side / (p_side - q_side)));
            }
        }
        ring = kept;
    }
    ring
}

/// Area by the shoelace formula about the first vertex (m²).
pub fn plain_area_m2(ring: &[Vec2]) -> f64 {
    let Some(&origin) = ring.first() else { return 0.0 };
    ring[1..].windows(2).map(|w| (w[0] - origin).cross(w[1] - origin)).sum::<f64>() * 0.5
}

/// Largest extent along either axis (m).
pub fn perimeter_m(ring: &[Vec2]) -> f64 {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(p, q)| (*q - *p).length()).sum()
}
