//! Tunnel thrusters and azimuth thrusters.

use crate::constants::KNOT_MPS;
use fenderline_contact::number::greater;

use super::propeller::Propeller;
use super::quantities::{Force, Velocity, Water, smooth_step};

/// Speed of the ship at which a tunnel thruster is least effective.
const WORST_MPS: f64 = 4.0 * KNOT_MPS;
/// Effectiveness of a tunnel thruster at the speed at which it is least effective.
const WORST: f64 = 0.5;
/// Speed of the ship from which on a tunnel thruster is fully effective again.
const AGAIN_MPS: f64 = 15.0 * KNOT_MPS;

/// A bow or stern thruster in a tunnel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunnelThruster {
    /// Thrust of the thruster at rest and full power, equal to both sides (N).
    pub bollard_n: f64,
    /// Position of the thruster forward of midship (m).
    pub along_m: f64,
}

impl TunnelThruster {
    /// Force of the tunnel thruster for an order from −1 (full to port) to 1 (full to starboard).
    pub fn force(&self, order: f64, velocity: &Velocity) -> Force {
        let sway_n = self.bollard_n * order * tunnel_effect(velocity.surge_mps);
        Force::at(0.0, sway_n, self.along_m, 0.0)
    }
}

/// Effectiveness of a tunnel thruster's turning moment at a speed (m/s): 1 at rest, 0.5 at 4 knots, 1 again at 15
/// knots, with smooth steps between (trials of a tanker of 60 000 t, 1967, from memory: the report was not read).
pub fn tunnel_effect(surge_mps: f64) -> f64 {
    let speed_mps = surge_mps.abs();
    let lost = 1.0 - WORST;
    if speed_mps <= WORST_MPS {
        return 1.0 - lost * smooth_step(speed_mps / WORST_MPS);
    }
    WORST + lost * smooth_step((speed_mps - WORST_MPS) / (AGAIN_MPS - WORST_MPS))
}

/// An azimuth thruster: a propeller that turns about a vertical axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AzimuthThruster {
    /// The propeller of the thruster, with its characteristics in open water.
    pub propeller: Propeller,
    /// Position of the thruster forward of midship (m).
    pub along_m: f64,
    /// Position of the thruster to starboard of the centre line (m).
    pub across_m: f64,
    /// Wake fraction at the thruster.
    pub wake: f64,
    /// Thrust deduction of the thruster, for thrust of either sign.
    pub thrust_deduction: f64,
}

impl AzimuthThruster {
    /// Force of the azimuth thruster for revolutions (1/s) and an azimuth (rad) of the thrust: 0 drives ahead, π/2 to
    /// starboard.
    ///
    /// The speed of advance is the velocity of the water at the azimuth thruster along its axis, the ship's yaw
    /// included. Drag of the azimuth thruster across its axis is neglected.
    pub fn force(
        &self,
        shaft_rps: f64,
        azimuth_rad: f64,
        velocity: &Velocity,
        water: Water,
    ) -> Force {
        let (sin, cos) = libm::sincos(azimuth_rad);
        let advance_mps = self.advance_mps(azimuth_rad, velocity);
        let thrust_n =
            (1.0 - self.thrust_deduction) * self.propeller.thrust_n(advance_mps, shaft_rps, water);
        Force::at(thrust_n * cos, thrust_n * sin, self.along_m, self.across_m)
    }

    fn advance_mps(&self, azimuth_rad: f64, velocity: &Velocity) -> f64 {
        let (sin, cos) = libm::sincos(azimuth_rad);
        let along_mps = velocity.surge_mps - velocity.yaw_radps * self.across_m;
        let across_mps = velocity.sway_mps + velocity.yaw_radps * self.along_m;
        (1.0 - self.wake) * (along_mps * cos + across_mps * sin)
    }

    /// Revolutions (1/s) of the thruster that give a thrust (N) in a direction, at a velocity of the ship. The
    /// revolutions are at most `max_rps`; they are zero if the inflow alone gives more thrust.
    pub fn revolutions_at(
        &self,
        thrust_n: f64,
        azimuth_rad: f64,
        velocity: &Velocity,
        water: Water,
        max_rps: f64,
    ) -> f64 {
        let advance_mps = self.advance_mps(azimuth_rad, velocity);
        let surplus_n = |shaft_rps: f64| {
            (1.0 - self.thrust_deduction) * self.propeller.thrust_n(advance_mps, shaft_rps, water)
                - thrust_n
        };
        least_with(surplus_n, max_rps)
    }

    /// Revolutions (1/s) of the thruster that give a thrust ahead at rest (N): thrust is proportional to the square of
    /// the revolutions.
    pub fn revolutions_for(&self, thrust_n: f64, water: Water) -> f64 {
        let of_one_n = (1.0 - self.thrust_deduction) * self.propeller.thrust_n(0.0, 1.0, water);
        libm::sqrt(greater(thrust_n, 0.0) / of_one_n)
    }
}

/// Number of halvings of the range of revolutions in the bisection.
const HALVINGS: u32 = 24;
/// Half the width of the bracket around the root, divided by the greatest revolutions. The half width of the bracket is
/// less than the interval that the last halving leaves.
const FINE: f64 = 1.0 / 134_217_728.0;

/// The revolutions (1/s) from 0 to `max_rps` from which on the thrust exceeds the wanted thrust, found by bisection.
/// The surplus of thrust over the wanted thrust increases with the revolutions.
///
/// Computing the series of the propeller takes most of the time of a tug's step. The root is therefore bracketed first,
/// by the rule of false position in the square of the revolutions, to which thrust is nearly proportional. The
/// bisection then computes the surplus of thrust only within the bracket. In total the surplus is computed less than
/// half as often as by a plain bisection. The revolutions found are those of a plain bisection, to the last bit.
fn least_with(surplus_n: impl Fn(f64) -> f64, max_rps: f64) -> f64 {
    let (below, above) = bracket(&surplus_n, max_rps);
    let (mut low, mut high) = (0.0, max_rps);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        let is_short = middle <= below || middle < above && surplus_n(middle) < 0.0;
        if is_short { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Revolutions (1/s) below which, and from which on, the sign of the thrust's surplus is known.
fn bracket(surplus_n: &impl Fn(f64) -> f64, max_rps: f64) -> (f64, f64) {
    let (mut low, mut at_low) = (0.0, surplus_n(0.0));
    // The inflow from astern alone gives more thrust: the thrust falls before it rises, and only a plain bisection
    // finds the same root.
    if at_low >= 0.0 {
        return (-1.0, f64::INFINITY);
    }
    let (mut high, mut at_high) = (max_rps, surplus_n(max_rps));
    if at_high < 0.0 {
        return (max_rps, max_rps);
    }
    let (fine, mut last) = (FINE * max_rps, max_rps);
    let mut was_short = None;
    for _ in 0..8 {
        let square = low * low + (high * high - low * low) * at_low / (at_low - at_high);
        let next = square.sqrt();
        // The loop also ends if both ends are the same number.
        let is_inside = low < next && next < high;
        if !is_inside {
            break;
        }
        let at_next = surplus_n(next);
        let is_short = at_next < 0.0;
        // An end that stays twice counts half (the Illinois rule). Otherwise the other end would come near in small
        // steps only.
        let stays = was_short == Some(is_short);
        if is_short {
            (low, at_low) = (next, at_next);
            at_high *= if stays { 0.5 } else { 1.0 };
        } else {
            (high, at_high) = (next, at_next);
            at_low *= if stays { 0.5 } else { 1.0 };
        }
        was_short = Some(is_short);
        let is_found = (next - last).abs() < fine;
        last = next;
        if is_found {
            break;
        }
    }
    for probe in [last - fine, last + fine] {
        if low < probe && probe < high {
            if surplus_n(probe) < 0.0 { low = probe } else { high = probe }
        }
    }
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::super::propeller::Series;
    use super::*;

    fn plain_bisection(surplus_n: impl Fn(f64) -> f64, max_rps: f64) -> f64 {
        let (mut low, mut high) = (0.0, max_rps);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if surplus_n(middle) < 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// The test covers every thrust, at speeds of advance from 6 kn astern to 12 kn ahead.
    #[test]
    fn revolutions_are_those_of_a_plain_bisection_to_the_bit() {
        let water = Water::SEA;
        let (mut evaluated, mut cases) = (0_u32, 0_u32);
        for (series, thrust_polynomial) in [
            (Series::B4Pitch08, None),
            (Series::B4Pitch10, None),
            (Series::B4Pitch10, Some([0.45, -0.25, -0.18])),
        ] {
            let propeller = Propeller { diameter_m: 2.6, thrust_polynomial, series };
            for advance in -12..=24 {
                let advance_mps = 0.5 * KNOT_MPS * f64::from(advance);
                for thrust in 0..=40 {
                    let wanted_n = 10e3 * f64::from(thrust);
                    let surplus_n = |rps| propeller.thrust_n(advance_mps, rps, water) - wanted_n;
                    let counted = core::cell::Cell::new(0);
                    let counting = |rps| {
                        counted.set(counted.get() + 1);
                        surplus_n(rps)
                    };
                    let found = least_with(counting, 4.0);
                    let plain = plain_bisection(surplus_n, 4.0);
                    assert_eq!(
                        found.to_bits(),
                        plain.to_bits(),
                        "{advance_mps} {wanted_n}: {found} {plain}"
                    );
                    evaluated += counted.get();
                    cases += 1;
                }
            }
        }
        let each = f64::from(evaluated) / f64::from(cases);
        assert!(each < f64::from(HALVINGS) / 2.0, "{each} evaluations");
    }
}
