//! Distributes a lateral force and a yaw moment over thrusters and tugs.

use fenderline_contact::number::{bounded, greater, lesser};

/// A device that gives a lateral force at a position along the hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LateralDevice {
    /// Position of the device ahead of the centre of gravity (m).
    pub forward_m: f64,
    /// Least and greatest force to starboard that the device can give at present (N).
    pub limits_n: [f64; 2],
}

/// Computes the forces of all devices, positive to starboard (N), that together give the wanted lateral force (N) and
/// yaw moment (N·m). The sum of the squares of the forces is the least possible, and each force is within the device's
/// limits.
///
/// Least squares with the two conditions of force and moment give f_i = λ + μ x_i, where f_i is the force of device i
/// at position x_i. A device beyond its limit is set to the limit, and what is still missing is allocated again to the
/// other devices, at most once for each device.
///
/// ```
/// use fenderline_ship::control::{LateralDevice, allocate};
/// let tug = |forward_m| LateralDevice { forward_m, limits_n: [0.0, 400e3] };
/// let mut forces_n = [0.0; 2];
/// allocate(&[tug(80.0), tug(-80.0)], 300e3, 0.0, &mut forces_n);
/// assert!((forces_n[0] - 150e3).abs() < 1e-6 && (forces_n[1] - 150e3).abs() < 1e-6);
/// ```
///
/// # Panics
/// Panics if `forces_n` has not one entry for each device.
pub fn allocate(devices: &[LateralDevice], force_n: f64, moment_nm: f64, forces_n: &mut [f64]) {
    assert_eq!(devices.len(), forces_n.len(), "one force a device");
    forces_n.fill(f64::NAN);
    for _ in 0..devices.len() {
        let free = || (0..devices.len()).filter(|&i| forces_n[i].is_nan());
        let (mut rest_n, mut rest_nm) = (force_n, moment_nm);
        for (device, given_n) in devices.iter().zip(&*forces_n).filter(|(_, n)| !n.is_nan()) {
            rest_n -= given_n;
            rest_nm -= given_n * device.forward_m;
        }
        let (mut count, mut first, mut second) = (0.0, 0.0, 0.0);
        for i in free() {
            let x = devices[i].forward_m;
            count += 1.0;
            first += x;
            second += x * x;
        }
        let determinant = count * second - first * first;
        // Devices at a single position cannot give a moment about it: the force has priority.
        let (level, slope) = if determinant > 1e-9 * (second + 1.0) * count {
            (
                (rest_n * second - rest_nm * first) / determinant,
                (rest_nm * count - rest_n * first) / determinant,
            )
        } else if count > 0.0 {
            (rest_n / count, 0.0)
        } else {
            return;
        };
        // The device farthest beyond its limit is set to it first, so that the order of devices does not matter.
        let excess = |i: usize| {
            let wanted_n = level + slope * devices[i].forward_m;
            let [low, high] = devices[i].limits_n;
            (wanted_n - bounded(wanted_n, lesser(low, high), greater(high, low))).abs()
        };
        let worst = free().fold(None, |worst: Option<usize>, i| match worst {
            Some(w) if excess(w) >= excess(i) => Some(w),
            _ => Some(i),
        });
        let Some(worst) = worst else { return };
        let over_n = excess(worst);
        if over_n > 0.0 {
            let wanted_n = level + slope * devices[worst].forward_m;
            let [low, high] = devices[worst].limits_n;
            forces_n[worst] = bounded(wanted_n, lesser(low, high), greater(high, low));
            continue;
        }
        for (given_n, device) in forces_n.iter_mut().zip(devices).filter(|(n, _)| n.is_nan()) {
            *given_n = level + slope * device.forward_m;
        }
        return;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn given(devices: &[LateralDevice], force_n: f64, moment_nm: f64) -> (f64, f64, Vec<f64>) {
        let mut forces_n = vec![0.0; devices.len()];
        allocate(devices, force_n, moment_nm, &mut forces_n);
        let moment = devices.iter().zip(&forces_n).map(|(d, f)| d.forward_m * f).sum();
        (forces_n.iter().sum(), moment, forces_n)
    }

    const fn device(forward_m: f64, low: f64, high: f64) -> LateralDevice {
        LateralDevice { forward_m, limits_n: [low, high] }
    }

    #[test]
    fn force_and_moment_are_met_within_the_limits() {
        let devices =
            [device(100.0, -1e6, 1e6), device(-60.0, -1e6, 1e6), device(120.0, -1e6, 1e6)];
        let (force, moment, _) = given(&devices, 2e5, -3e6);
        assert!((force - 2e5).abs() < 1e-6 && (moment + 3e6).abs() < 1e-3);
    }

    #[test]
    fn the_others_take_over_what_a_device_at_its_limit_cannot_give() {
        let devices = [device(100.0, 0.0, 1e5), device(-100.0, 0.0, 1e6), device(0.0, 0.0, 1e6)];
        let (force, _, forces) = given(&devices, 9e5, 0.0);
        assert_eq!(forces[0], 1e5);
        assert!((force - 9e5).abs() < 1e-6, "{forces:?}");
        // The demand is more than all devices can give: each is at its limit.
        let (force, _, _) = given(&devices, 9e7, 0.0);
        assert_eq!(force, 2.1e6);
        assert_eq!(given(&[], 1.0, 1.0).0, 0.0);
        assert_eq!(given(&[device(5.0, -1.0, 1.0); 2], 1.0, 99.0).0, 1.0);
    }
}
