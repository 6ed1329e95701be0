//! Distributes a horizontal force and a yaw moment over propellers, thrusters, azimuth units and tugs. Azimuth units
//! can push in any direction. A propeller pushes only ahead and astern; tunnel thrusters and tugs push only to the
//! sides.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{Vec2, vec2};

use super::station::Demand;

/// The forces that a device can give (N).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// The device pushes only ahead or astern: from the first force (negative: astern) to the second.
    Ahead([f64; 2]),
    /// The device pushes only to the sides: from the first force (negative: to port) to the second.
    Across([f64; 2]),
    /// The device pushes in any direction, up to the given force.
    Round(f64),
}

/// A device that gives a force at a position on the ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThrustDevice {
    /// Position of the device ahead and to starboard of the centre of gravity (m).
    pub at_m: Vec2,
    /// The forces that the device can give at present.
    pub reach: Reach,
}

/// Whether the demanded sway force must be met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sway {
    /// The demanded sway force is met.
    Held,
    /// The demanded sway force is ignored. Something other than the thrusters holds the vessel sideways, such as
    /// friction between a tug's bow fender and a ship's side.
    Free,
}

/// Surge force, sway force and yaw moment of a force (N, N, N); the moment is divided by the largest distance of a
/// device from the centre of gravity.
type Axes = [f64; 3];

/// The devices of a vessel, and the forces that they give to meet a demand together. The memory of the allocation is
/// reused: nothing is allocated anew unless there are more devices than before.
#[derive(Clone, Debug, Default)]
pub struct ThrustShares {
    /// The devices.
    pub devices: Vec<ThrustDevice>,
    /// The force of each device, ahead and to starboard (N), after a call of [`ThrustShares::meet`].
    pub forces_n: Vec<Vec2>,
    /// Forces of the devices that are set to their limits; `None` for the other devices.
    fixed: Vec<Option<Vec2>>,
    /// Forces of the devices that together give one of surge, sway and yaw alone.
    part_n: Vec<Vec2>,
}

impl ThrustShares {
    /// Computes the forces of all devices that together give the demand, with the least sum of squares of the forces.
    ///
    /// Least squares with conditions give f = Bᵀλ with BBᵀλ = demand, where f are the forces of the devices and B their
    /// effect in surge, sway and yaw. A device that pushes along one line only and is beyond its limit is set to the
    /// limit, and the rest of the demand is allocated again. If azimuth units are beyond their limits, the yaw moment
    /// has priority, then surge, then sway: each of the three is reduced to the largest part that all units can give.
    ///
    /// ```
    /// use fenderline_contact::vec2;
    /// use fenderline_ship::control::{Demand, Reach, Sway, ThrustDevice, ThrustShares};
    /// let unit = |across_m| ThrustDevice { at_m: vec2(-12.0, across_m), reach: Reach::Round(300e3) };
    /// let mut shares = ThrustShares::default();
    /// shares.devices.extend([unit(-2.5), unit(2.5)]);
    /// shares.meet(&Demand { surge_n: 400e3, ..Demand::default() }, Sway::Held);
    /// let one_n = shares.forces_n[0];
    /// assert!((one_n.x - 200e3).abs() < 1.0 && one_n.y.abs() < 1.0);
    /// ```
    pub fn meet(&mut self, demand: &Demand, sway: Sway) {
        let ThrustShares { devices, forces_n, fixed, part_n } = self;
        for forces_n in [&mut *forces_n, &mut *part_n] {
            forces_n.clear();
            forces_n.resize(devices.len(), Vec2::ZERO);
        }
        fixed.clear();
        fixed.resize(devices.len(), None);
        allocate(devices, demand, sway, (forces_n, fixed, part_n));
    }

    /// Makes azimuth units abreast of each other push against each other, as in dynamic positioning. The sum is
    /// unchanged. Units that push against each other turn by a small angle only when a small demand changes its sign;
    /// otherwise they would turn by half a turn, which takes ten seconds.
    pub fn bias_pairs(&mut self) {
        bias_pairs(&self.devices, &mut self.forces_n);
    }
}

/// Does the work of [`ThrustShares::meet`]; the slices have one entry for each device.
fn allocate(
    devices: &[ThrustDevice],
    demand: &Demand,
    sway: Sway,
    (forces_n, fixed, part_n): (&mut [Vec2], &mut [Option<Vec2>], &mut [Vec2]),
) {
    let scale_m = devices.iter().map(|device| device.at_m.length()).fold(1.0, greater);
    let wanted = [demand.surge_n, demand.sway_n, demand.yaw_nm / scale_m];
    let problem = Problem { devices, scale_m, sway };
    for _ in 0..=devices.len() {
        let rest = problem.less(wanted, fixed);
        problem.share(rest, fixed, forces_n);
        let Some((worst, given_n)) = problem.worst(fixed, forces_n) else { break };
        fixed[worst] = Some(given_n);
    }
    if problem.all_within(forces_n) {
        return;
    }
    // The axes are met one by one, by priority.
    let rest = problem.less(wanted, fixed);
    for (force_n, fixed_n) in forces_n.iter_mut().zip(&*fixed) {
        *force_n = fixed_n.unwrap_or(Vec2::ZERO);
    }
    for axis in [2, 0, 1] {
        let mut alone = [0.0; 3];
        alone[axis] = rest[axis];
        problem.share(alone, fixed, part_n);
        let still = |i: usize| if fixed[i].is_some() { Vec2::ZERO } else { part_n[i] };
        let share = (0..devices.len())
            .map(|i| largest_share(devices[i].reach, forces_n[i], still(i)))
            .fold(1.0, lesser);
        for (i, force_n) in forces_n.iter_mut().enumerate() {
            *force_n += still(i) * share;
        }
    }
}

/// Force with which the azimuth units of a pair push against each other, divided by the smaller of their two limits.
const BIAS: f64 = 0.15;

/// See [`ThrustShares::bias_pairs`].
fn bias_pairs(devices: &[ThrustDevice], forces_n: &mut [Vec2]) {
    for i in 0..devices.len() {
        for j in i + 1..devices.len() {
            let (Reach::Round(one_n), Reach::Round(other_n)) = (devices[i].reach, devices[j].reach)
            else {
                continue;
            };
            let apart = devices[j].at_m - devices[i].at_m;
            if apart.x.abs() > 0.1 * apart.y.abs() {
                continue;
            }
            // The forces act along the line between the units, so that the moment is unchanged too.
            let bias_n = apart * (BIAS * lesser(one_n, other_n) / apart.length());
            let share = lesser(
                largest_share(devices[i].reach, forces_n[i], -bias_n),
                largest_share(devices[j].reach, forces_n[j], bias_n),
            );
            forces_n[i] += bias_n * -share;
            forces_n[j] += bias_n * share;
        }
    }
}

struct Problem<'a> {
    devices: &'a [ThrustDevice],
    scale_m: f64,
    sway: Sway,
}

impl Problem<'_> {
    /// Surge force, sway force and yaw moment that a device's force gives; the sway force is 0 if sway is ignored.
    fn effect(&self, device: &ThrustDevice, force_n: Vec2) -> Axes {
        let sway_n = if self.sway == Sway::Held { force_n.y } else { 0.0 };
        [force_n.x, sway_n, device.at_m.cross(force_n) / self.scale_m]
    }

    /// The directions in which a device can push.
    fn directions(device: &ThrustDevice) -> [Vec2; 2] {
        match device.reach {
            Reach::Ahead(_) => [vec2(1.0, 0.0), Vec2::ZERO],
            Reach::Across(_) => [vec2(0.0, 1.0), Vec2::ZERO],
            Reach::Round(_) => [vec2(1.0, 0.0), vec2(0.0, 1.0)],
        }
    }

    fn less(&self, wanted: Axes, fixed: &[Option<Vec2>]) -> Axes {
        let mut rest = wanted;
        for (device, force_n) in self.devices.iter().zip(fixed) {
            let effect = force_n.map_or([0.0; 3], |force_n| self.effect(device, force_n));
            for axis in 0..3 {
                rest[axis] -= effect[axis];
            }
        }
        rest
    }

    /// Computes the forces f = Bᵀ(BBᵀ + ε)⁻¹ rest of the devices that are not fixed; `rest` is the demand that is still
    /// to be met. The small ε matters only if the devices cannot give surge, sway or yaw at all: then the result is the
    /// nearest that they can give.
    fn share(&self, rest: Axes, fixed: &[Option<Vec2>], forces_n: &mut [Vec2]) {
        let mut matrix = [[0.0; 3]; 3];
        for (device, _) in self.devices.iter().zip(fixed).filter(|(_, fixed)| fixed.is_none()) {
            for direction in Self::directions(device) {
                let column = self.effect(device, direction);
                for (row, &of_row) in matrix.iter_mut().zip(&column) {
                    for (entry, &of_column) in row.iter_mut().zip(&column) {
                        *entry += of_row * of_column;
                    }
                }
            }
        }
        let trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
        for (axis, row) in matrix.iter_mut().enumerate() {
            row[axis] += 1e-9 * trace + f64::MIN_POSITIVE;
        }
        let multiplier = solve(matrix, rest);
        for ((device, fixed_n), force_n) in self.devices.iter().zip(fixed).zip(forces_n) {
            *force_n = fixed_n.unwrap_or_else(|| {
                Self::directions(device).into_iter().fold(Vec2::ZERO, |sum, direction| {
                    let column = self.effect(device, direction);
                    let along: f64 = column.iter().zip(&multiplier).map(|(b, l)| b * l).sum();
                    sum + direction * along
                })
            });
        }
    }

    /// The device that pushes along one line and is farthest beyond its limits, and its force at the limit.
    fn worst(&self, fixed: &[Option<Vec2>], forces_n: &[Vec2]) -> Option<(usize, Vec2)> {
        let mut worst: Option<(usize, Vec2, f64)> = None;
        for (i, device) in self.devices.iter().enumerate().filter(|(i, _)| fixed[*i].is_none()) {
            let (direction, [low, high]) = match device.reach {
                Reach::Ahead(limits) => (vec2(1.0, 0.0), limits),
                Reach::Across(limits) => (vec2(0.0, 1.0), limits),
                Reach::Round(_) => continue,
            };
            let asked_n = forces_n[i].dot(direction);
            let given_n = bounded(asked_n, low, high);
            let over_n = (asked_n - given_n).abs();
            if over_n > worst.map_or(0.0, |(_, _, over_n)| over_n) {
                worst = Some((i, direction * given_n, over_n));
            }
        }
        worst.map(|(i, given_n, _)| (i, given_n))
    }

    fn all_within(&self, forces_n: &[Vec2]) -> bool {
        self.devices.iter().zip(forces_n).all(|(device, force_n)| match device.reach {
            Reach::Round(most_n) => force_n.length() <= most_n,
            Reach::Ahead(_) | Reach::Across(_) => true,
        })
    }
}

/// The largest share of `more` in [0, 1] that a device can give on top of `given`.
fn largest_share(reach: Reach, given: Vec2, more: Vec2) -> f64 {
    let within = |from: f64, by: f64, [low, high]: [f64; 2]| match by {
        by if by > 0.0 => bounded((high - from) / by, 0.0, 1.0),
        by if by < 0.0 => bounded((low - from) / by, 0.0, 1.0),
        _ => 1.0,
    };
    match reach {
        Reach::Ahead(limits) => within(given.x, more.x, limits),
        Reach::Across(limits) => within(given.y, more.y, limits),
        Reach::Round(most_n) => {
            // |given + σ more| = most, the larger root.
            let (a, b) = (more.dot(more), given.dot(more));
            let c = given.dot(given) - most_n * most_n;
            if a == 0.0 {
                return 1.0;
            }
            bounded((libm::sqrt(greater(b * b - a * c, 0.0)) - b) / a, 0.0, 1.0)
        }
    }
}

/// Solves a symmetric, positive definite system by Cholesky's method.
fn solve(matrix: [[f64; 3]; 3], right: Axes) -> Axes {
    let mut lower = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            let inner: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            lower[i][j] = if i == j {
                libm::sqrt(greater(matrix[i][i] - inner, f64::MIN_POSITIVE))
            } else {
                (matrix[i][j] - inner) / lower[j][j]
            };
        }
    }
    let mut answer = right;
    for i in 0..3 {
        let inner: f64 = (0..i).map(|k| lower[i][k] * answer[k]).sum();
        answer[i] = (answer[i] - inner) / lower[i][i];
    }
    for i in (0..3).rev() {
        let inner: f64 = (i + 1..3).map(|k| lower[k][i] * answer[k]).sum();
        answer[i] = (answer[i] - inner) / lower[i][i];
    }
    answer
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::{self, LateralDevice};

    fn round(x: f64, y: f64, most_n: f64) -> ThrustDevice {
        ThrustDevice { at_m: vec2(x, y), reach: Reach::Round(most_n) }
    }

    fn given(devices: &[ThrustDevice], demand: Demand, sway: Sway) -> (Demand, Vec<Vec2>) {
        let mut shares = ThrustShares { devices: devices.to_vec(), ..ThrustShares::default() };
        shares.meet(&demand, sway);
        let forces_n = shares.forces_n;
        let mut sum = Demand::default();
        for (device, force_n) in devices.iter().zip(&forces_n) {
            sum.surge_n += force_n.x;
            sum.sway_n += force_n.y;
            sum.yaw_nm += device.at_m.cross(*force_n);
        }
        (sum, forces_n)
    }

    fn demand(surge_n: f64, sway_n: f64, yaw_nm: f64) -> Demand {
        Demand { surge_n, sway_n, yaw_nm }
    }

    #[test]
    fn two_units_at_the_stern_give_the_demand() {
        let tug = [round(-12.0, -2.5, 3e5), round(-12.0, 2.5, 3e5)];
        let asked = demand(1e5, 2e4, -3e5);
        let (sum, _) = given(&tug, asked, Sway::Held);
        for (sum, asked) in
            [(sum.surge_n, asked.surge_n), (sum.sway_n, asked.sway_n), (sum.yaw_nm, asked.yaw_nm)]
        {
            assert!((sum - asked).abs() < 1e-4 * asked.abs(), "{sum}, asked {asked}");
        }
    }

    #[test]
    fn a_moment_takes_less_force_where_sway_is_free() {
        let tug = [round(-12.0, -2.5, 3e5), round(-12.0, 2.5, 3e5)];
        let hardest = |sway| {
            let (sum, forces_n) = given(&tug, demand(0.0, 0.0, 1e6), sway);
            assert!((sum.yaw_nm - 1e6).abs() < 100.0);
            forces_n.iter().map(|f| f.length()).fold(0.0, greater)
        };
        // The moment uses the arm of 12 m to the stern, not the 2.5 m between the units.
        assert!((hardest(Sway::Held) - 2e5).abs() < 100.0);
        assert!(hardest(Sway::Free) < 0.25 * hardest(Sway::Held));
    }

    #[test]
    fn beyond_the_limits_the_moment_has_priority_and_no_unit_exceeds_its_limit() {
        let tug = [round(-12.0, -2.5, 3e5), round(-12.0, 2.5, 3e5)];
        let (sum, forces_n) = given(&tug, demand(9e5, 4e5, 5e5), Sway::Held);
        assert!((sum.yaw_nm - 5e5).abs() < 500.0, "{sum:?}");
        assert!(sum.surge_n > 2e5 && sum.surge_n < 6e5, "{sum:?}");
        assert!(forces_n.iter().all(|f| f.length() <= 3e5 * (1.0 + 1e-12)), "{forces_n:?}");
    }

    #[test]
    fn one_unit_or_none_gives_the_nearest_possible_force() {
        let (sum, _) = given(&[round(-10.0, 0.0, 1e6)], demand(1e5, 0.0, 0.0), Sway::Held);
        assert!((sum.surge_n - 1e5).abs() < 1.0 && sum.yaw_nm.abs() < 1.0);
        assert_eq!(given(&[], demand(1.0, 1.0, 1.0), Sway::Held).0, Demand::default());
    }

    #[test]
    fn opposing_units_abreast_do_not_change_the_sum() {
        let tug = [round(-12.0, -2.5, 3e5), round(-12.0, 2.5, 3e5)];
        let asked = demand(1e4, -2e4, 3e5);
        let (before, mut forces_n) = given(&tug, asked, Sway::Held);
        bias_pairs(&tug, &mut forces_n);
        let sum = tug.iter().zip(&forces_n).fold(Demand::default(), |sum, (device, f)| Demand {
            surge_n: sum.surge_n + f.x,
            sway_n: sum.sway_n + f.y,
            yaw_nm: sum.yaw_nm + device.at_m.cross(*f),
        });
        assert!((sum.surge_n - before.surge_n).abs() < 1e-6, "{sum:?}");
        assert!((sum.sway_n - before.sway_n).abs() < 1e-6, "{sum:?}");
        assert!((sum.yaw_nm - before.yaw_nm).abs() < 1e-6, "{sum:?}");
        assert!(forces_n[0].y < -0.1 * 3e5 && forces_n[1].y > 0.1 * 3e5, "{forces_n:?}");
    }

    /// For lateral devices alone the result is that of [`control::allocate`].
    #[test]
    fn lateral_devices_get_the_forces_of_allocate() {
        let limits = [-1e5, 4e5];
        let places = [100.0, -60.0, 120.0];
        let across: Vec<_> = places
            .iter()
            .map(|&x| ThrustDevice { at_m: vec2(x, 0.0), reach: Reach::Across(limits) })
            .collect();
        let lateral: Vec<_> =
            places.iter().map(|&forward_m| LateralDevice { forward_m, limits_n: limits }).collect();
        for (sway_n, yaw_nm) in [(2e5, -3e6), (3e5, -3e7), (5e5, 1e7)] {
            let mut before_n = [0.0; 3];
            control::allocate(&lateral, sway_n, yaw_nm, &mut before_n);
            let (_, now) = given(&across, demand(0.0, sway_n, yaw_nm), Sway::Held);
            for (before_n, now) in before_n.iter().zip(&now) {
                assert!((before_n - now.y).abs() < 1e-3 * sway_n, "{before_n}, {now:?}");
            }
        }
    }
}
