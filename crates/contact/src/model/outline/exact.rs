//! Computes signs and sums without rounding error, so that checks and cuts of an outline are always right. The methods
//! are those of Shewchuk, Discrete & Computational Geometry 18 (1997) 305–363.

use crate::maths::vec2::Vec2;

/// Computes the cross product (b − a) × (c − a) with the exact sign: positive if a, b, c turn in the positive sense,
/// and zero only if they lie exactly on one line.
///
/// The sign is exact for coordinates that are 0 or between 1e-100 and 1e100 in size.
pub(super) fn turn(a: Vec2, b: Vec2, c: Vec2) -> f64 {
    let left = (a.x - c.x) * (b.y - c.y);
    let right = (a.y - c.y) * (b.x - c.x);
    let difference = left - right;
    // (3 + 16 u) u with u = 2⁻⁵³: the largest relative rounding error of `difference`.
    const BOUND: f64 = 3.330_669_073_875_471_6e-16;
    if difference.abs() > BOUND * (left.abs() + right.abs()) {
        return difference;
    }
    turn_by_expansion(a, b, c)
}

/// Computes [`turn`] by a sum without any rounding.
fn turn_by_expansion(a: Vec2, b: Vec2, c: Vec2) -> f64 {
    let products = [(a.x, b.y), (-a.y, b.x), (b.x, c.y), (-b.y, c.x), (c.x, a.y), (-c.y, a.x)];
    // The parts of the sum do not overlap and come smallest first: the last non-zero part has the sign of the sum.
    let mut parts = [0.0; 12];
    let mut count = 0;
    for (p, q) in products {
        let (high, low) = two_product(p, q);
        for term in [low, high] {
            let mut carry = term;
            for part in &mut parts[..count] {
                (carry, *part) = two_sum(carry, *part);
            }
            parts[count] = carry;
            count += 1;
        }
    }
    parts.into_iter().rev().find(|part| *part != 0.0).unwrap_or(0.0)
}

/// Computes twice the signed area of a closed polygon. The area is right to the last bit or two even if the polygon is
/// far from the origin or its area almost cancels.
pub(super) fn doubled_area(vertices: &[Vec2]) -> f64 {
    let (mut high, mut low) = (0.0, 0.0);
    let Some(&last) = vertices.last() else { return 0.0 };
    let mut a = last;
    for &b in vertices {
        for (p, q) in [(a.x, b.y), (-a.y, b.x)] {
            let (product, product_rest) = two_product(p, q);
            let (sum, sum_rest) = two_sum(high, product);
            high = sum;
            low += sum_rest + product_rest;
        }
        a = b;
    }
    high + low
}

/// Returns a + b as the rounded sum and its rounding error (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_kept = sum - a;
    let a_kept = sum - b_kept;
    (sum, (a - a_kept) + (b - b_kept))
}

/// Returns a · b as the rounded product and its rounding error (Dekker).
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let rest = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
    (product, rest)
}

/// Splits the number a into a sum of two numbers of 26 bits.
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let c = SPLITTER * a;
    let high = c - (c - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use proptest::prelude::*;

    use super::{doubled_area, turn};
    use crate::maths::vec2::{Vec2, vec2};

    fn exact(value: f64) -> BigRational {
        BigRational::from_float(value).expect("finite")
    }

    fn exact_turn(a: Vec2, b: Vec2, c: Vec2) -> BigRational {
        let [ax, ay, bx, by, cx, cy] = [a.x, a.y, b.x, b.y, c.x, c.y].map(exact);
        (bx - &ax) * (cy - &ay) - (by - ay) * (cx - ax)
    }

    fn sign(value: f64) -> i32 {
        i32::from(value > 0.0) - i32::from(value < 0.0)
    }

    fn exact_sign(value: &BigRational) -> i32 {
        let zero = exact(0.0);
        i32::from(*value > zero) - i32::from(*value < zero)
    }

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![-1.0e8..1.0e8, -1.0..1.0f64, Just(0.0), -1.0e-90..1.0e-90f64]
    }

    fn point() -> impl Strategy<Value = Vec2> {
        (coordinate(), coordinate()).prop_map(|(x, y)| vec2(x, y))
    }

    proptest! {
        #[test]
        fn turn_has_the_exact_sign(a in point(), b in point(), c in point()) {
            prop_assert_eq!(sign(turn(a, b, c)), exact_sign(&exact_turn(a, b, c)));
        }

        #[test]
        fn turn_has_the_exact_sign_on_points_of_one_line(
            a in point(), b in point(), t in -2.0..3.0f64,
        ) {
            let c = a + (b - a) * t;
            prop_assert_eq!(sign(turn(a, b, c)), exact_sign(&exact_turn(a, b, c)));
            prop_assert_eq!(turn(a, b, a + (b - a) * 0.0), 0.0);
        }

        #[test]
        fn doubled_area_is_right_far_from_the_origin(
            far in -1.0e8..1.0e8f64, a in -1.0..1.0f64, b in -1.0..1.0f64, c in 0.1..1.0f64,
        ) {
            let corners = [vec2(far, a), vec2(far + c, b), vec2(far - 1.0, far + c)];
            let expected = exact_turn(corners[0], corners[1], corners[2]);
            let error = exact(doubled_area(&corners)) - &expected;
            let allowed = expected * exact(3.0e-16);
            prop_assert!(error.clone() * error <= allowed.clone() * allowed);
        }
    }
}
