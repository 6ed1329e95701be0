//! Force of reflected waves that are short compared with the draught, from the shape of the waterline.

use fenderline_contact::number::bounded;

use super::hull::DriftHull;

/// Number of chords that stand for the curve of each end of the waterline. With 12 chords at each end, the force is
/// within 1 % of the force on the curved waterline.
const CHORDS: u32 = 12;

/// Shortest end of the waterline divided by its length: no ship has a blunter end, and a barge's end is square.
const SHORTEST_END: f64 = 0.05;

/// A waterline that is symmetric fore and aft: parabolas from stem and stern to the full beam, and straight sides
/// between them.
///
/// The length ℓ of the ends follows from the block coefficient: C_WP = (1 + 2 C_B)/3 (Schneekluth & Bertram, "Ship
/// Design for Efficiency and Economy", 2nd ed., equation for normal sections; from memory). Two parabolic ends of
/// length ℓ give the waterplane coefficient C_WP = 1 − ⅔ℓ/L. The length of each end of the waterline is therefore ℓ =
/// (1 − C_B)L. As an example, a public program of the SNNM method has a general cargo ship with C_B 0.79 and a length
/// of 194 m; the formula gives ends of ℓ = 40.7 m, and the true lengths of the ends are 38.5 m and 32.3 m.
pub(super) struct Waterline {
    half_length_m: f64,
    half_beam_m: f64,
    end_m: f64,
}

impl Waterline {
    pub(super) fn of(hull: &DriftHull) -> Waterline {
        let end = bounded(1.0 - hull.block_coefficient, SHORTEST_END, 0.5);
        Waterline {
            half_length_m: 0.5 * hull.length_m,
            half_beam_m: 0.5 * hull.beam_m,
            end_m: end * hull.length_m,
        }
    }

    /// Computes ½∫sin²θ n dl over the part of the waterline that is exposed to waves towards μ, with the normal n into
    /// the hull and θ the angle between wave and side: [X, Y, N] divided by ρga² (m, m, m²). No part of the waterline
    /// shelters another part, because the waterline is convex.
    pub(super) fn reflection(&self, direction_rad: f64) -> [f64; 3] {
        let towards = [libm::cos(direction_rad), libm::sin(direction_rad)];
        let mut sum = [0.0; 3];
        // The walk goes from the stern to the stem on both sides.
        let mut last = self.corner(0);
        for index in 1..=2 * CHORDS + 1 {
            let next = self.corner(index);
            for side in [1.0, -1.0] {
                let (along, out) = (next[0] - last[0], side * (next[1] - last[1]));
                // Outward normal times length: the chord, turned by a right angle away from the centre line.
                let normal = [-side * out, side * along];
                let facing = towards[0] * normal[0] + towards[1] * normal[1];
                if facing < 0.0 {
                    let length_squared = along * along + out * out;
                    let push = 0.5 * facing * facing / length_squared;
                    let force = [-push * normal[0], -push * normal[1]];
                    let middle = [0.5 * (last[0] + next[0]), 0.5 * side * (last[1] + next[1])];
                    sum[0] += force[0];
                    sum[1] += force[1];
                    sum[2] += middle[0] * force[1] - middle[1] * force[0];
                }
            }
            last = next;
        }
        sum
    }

    /// Corners of the waterline on the starboard side, from the stern forward: [forward of midship, half beam] (m).
    fn corner(&self, index: u32) -> [f64; 2] {
        let share = |number: u32| f64::from(number) / f64::from(CHORDS);
        let half_beam = |share: f64| self.half_beam_m * share * (2.0 - share);
        if index <= CHORDS {
            let share = share(index);
            return [share * self.end_m - self.half_length_m, half_beam(share)];
        }
        let share = share(2 * CHORDS + 1 - index);
        [self.half_length_m - share * self.end_m, half_beam(share)]
    }
}
