//! Checks the sizes of exciting and drift forces, against the damping and the size of the ship.

use core::f64::consts::{PI, TAU};

use super::error::{Part, Reason, SeakeepingError, error};
use super::raw::RawHydrodynamics;
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;
use fenderline_ship::environment::waves::wave_number;

/// Allowed range of a ratio: the damping that follows from the exciting forces by Haskind's relation, divided by the
/// damping of the data. The ratio is that of the dampings in heave, at the frequency at which the data have the largest
/// damping in heave. The ratio should be 1, and 2 at a quay. With forces in newtons in place of kilonewtons the ratio
/// would be wrong by a factor of a million, with tonnes-force by a hundred, with feet by eleven.
const HASKIND: [f64; 2] = [0.1, 10.0];
/// Largest mean drift that is accepted, divided by ρgL/2, which is the drift of a wave that is wholly reflected over
/// the length L. The limit of the mean drift leaves room for resonance.
const DRIFT: f64 = 10.0;

/// Checks Haskind's relation in heave: the damping is k/(8πρg c) ∫|X|² dμ, where X is the exciting force in a wave of
/// amplitude 1 m, by heading, k the wave number and c the group velocity (Newman 1962 in deep water, from memory).
///
/// # Errors
/// [`Reason::ForcesOfOtherUnits`], [`Reason::Implausible`].
pub(super) fn check_forces(
    raw: &RawHydrodynamics,
    is_mirrored: bool,
) -> Result<(), SeakeepingError> {
    let axis = &raw.wave_frequencies_radps;
    let heave = |row: usize| raw.damping[row][2][2];
    let is_inside = |row: &usize| {
        let w = raw.frequencies_radps[*row];
        w >= axis[0] && w <= axis[axis.len() - 1]
    };
    let peak = (0..raw.damping.len())
        .filter(is_inside)
        .reduce(|best, row| if heave(row) > heave(best) { row } else { best });
    if let Some(row) = peak.filter(|&row| heave(row) > 0.0) {
        let nearest = |w: f64| {
            (0..axis.len()).fold(0, |best, k| {
                if (axis[k] - w).abs() < (axis[best] - w).abs() { k } else { best }
            })
        };
        let at = nearest(raw.frequencies_radps[row]);
        let ratio = by_forces(raw, at, is_mirrored) / heave(row);
        if !(HASKIND[0]..=HASKIND[1]).contains(&ratio) {
            let reason = Reason::ForcesOfOtherUnits { motion: 2, at_radps: axis[at], ratio };
            let row = at * raw.headings_rad.len();
            return Err(error(Part::Excitation, Some(row), reason));
        }
    }
    let length_m = 10.0 * libm::cbrt(raw.mass[0][0] / raw.water_kgpm3);
    let most = 0.5 * DRIFT * raw.water_kgpm3 * STANDARD_GRAVITY_MPS2 * length_m;
    for (row, drift) in raw.drift.iter().flatten().enumerate() {
        for (what, value) in
            [("mean drift in surge [N/m²]", drift[0]), ("mean drift in sway [N/m²]", drift[1])]
        {
            if value.abs() > most {
                let reason = Reason::Implausible { what, value, range: [-most, most] };
                return Err(error(Part::Drift, Some(row), reason));
            }
        }
    }
    Ok(())
}

/// The damping in heave that follows from the exciting forces at one of their frequencies (N·s/m).
fn by_forces(raw: &RawHydrodynamics, at: usize, is_mirrored: bool) -> f64 {
    let headings = &raw.headings_rad;
    let squared = |k: usize| {
        let force = raw.excitation[at * headings.len() + k % headings.len()][2];
        force.re * force.re + force.im * force.im
    };
    let trapezium = |k: usize, width_rad: f64| 0.5 * (squared(k) + squared(k + 1)) * width_rad;
    let last = headings.len() - 1;
    let inner: f64 = (0..last).map(|k| trapezium(k, headings[k + 1] - headings[k])).sum();
    let round = match is_mirrored {
        true => 2.0 * inner,
        false => inner + trapezium(last, headings[0] + TAU - headings[last]),
    };
    let w = raw.wave_frequencies_radps[at];
    let gravity = STANDARD_GRAVITY_MPS2;
    let (number_radpm, group_mps) = match raw.depth_m {
        None => (w * w / gravity, 0.5 * gravity / w),
        Some(depth_m) => {
            let number = wave_number(w, depth_m);
            let twice = 2.0 * number * depth_m;
            // In deep water 2kh/sinh 2kh is zero, and sinh would overflow.
            let shallow = if twice < 700.0 { twice / libm::sinh(twice) } else { 0.0 };
            (number, 0.5 * w / number * (1.0 + shallow))
        }
    };
    number_radpm * round / (8.0 * PI * raw.water_kgpm3 * gravity * group_mps)
}
