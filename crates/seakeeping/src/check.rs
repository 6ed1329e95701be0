//! Checks of hydrodynamic data before they are used.

use core::f64::consts::{PI, TAU};

use fenderline_contact::number::greater;

use super::error::{Part, Reason, SeakeepingError, error};
use super::matrix::{Matrix6, Six, UPRIGHT, smallest_eigenvalue};
use super::passive::{negative_together, scaled_to_one};
use super::raw::RawHydrodynamics;
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;
use fenderline_ship::environment::waves::Complex;

/// Largest change of the damping between two neighbouring frequencies, divided by the largest damping.
const COARSEST: f64 = 0.6;
/// Largest damping that is allowed at the first and at the last frequency, divided by the largest damping of all.
const AT_THE_ENDS: [f64; 2] = [0.6, 0.5];
/// Share of the restoring force below which a damping force has no noticeable effect.
const UNFELT: f64 = 0.3;
/// The widest step between neighbouring headings that is allowed (rad).
const WIDEST_STEP: f64 = 45.5 * PI / 180.0;
/// Numerical noise of panel codes that is accepted in hydrodynamic data. The first value is how far below zero a
/// damping may be, divided by the largest damping. The second value is how far a matrix may be from symmetric, divided
/// by the root of the product of the two diagonal entries.
const NOISE: [f64; 2] = [0.01, 0.05];

/// Checks that the tables of the data have the right numbers of rows, and that all numbers are finite.
pub(super) fn check_shape(raw: &RawHydrodynamics) -> Result<(), SeakeepingError> {
    let count = raw.frequencies_radps.len();
    let grid = raw.wave_frequencies_radps.len() * raw.headings_rad.len();
    let lists = [
        (Part::Radiation, "matrices of added mass", count, raw.added_mass.len()),
        (Part::Radiation, "matrices of damping", count, raw.damping.len()),
        (Part::Excitation, "exciting forces", grid, raw.excitation.len()),
        (Part::Drift, "drift forces", grid, raw.drift.as_ref().map_or(grid, Vec::len)),
    ];
    for (part, what, expected, found) in lists {
        if expected != found {
            return Err(error(part, None, Reason::Length { what, expected, found }));
        }
    }
    for (part, what, found, least) in [
        (Part::Radiation, "frequencies or more", count, 8),
        (Part::Excitation, "frequencies or more", raw.wave_frequencies_radps.len(), 2),
    ] {
        if found < least {
            return Err(error(part, None, Reason::Length { what, expected: least, found }));
        }
    }
    let bad = |value: f64| value.is_nan() || value.abs() >= 1e18;
    let in_matrix = |matrix: &Matrix6| matrix.iter().flatten().any(|value| bad(*value));
    for (what, matrices) in [("added mass", &raw.added_mass), ("damping", &raw.damping)] {
        if let Some(row) = matrices.iter().position(in_matrix) {
            return Err(error(Part::Radiation, Some(row), Reason::NotANumber(what)));
        }
    }
    if in_matrix(&raw.infinite) {
        return Err(error(Part::Infinite, Some(0), Reason::NotANumber("added mass")));
    }
    let bad_force = |at: &[Complex; 6]| at.iter().any(|part| bad(part.re) || bad(part.im));
    if let Some(row) = raw.excitation.iter().position(bad_force) {
        return Err(error(Part::Excitation, Some(row), Reason::NotANumber("an exciting force")));
    }
    let bad_drift = |at: &[f64; 3]| at.iter().any(|part| bad(*part));
    if let Some(row) = raw.drift.as_ref().and_then(|all| all.iter().position(bad_drift)) {
        return Err(error(Part::Drift, Some(row), Reason::NotANumber("a drift force")));
    }
    Ok(())
}

/// Checks mass and restoring.
pub(super) fn check_head(raw: &RawHydrodynamics) -> Result<(), SeakeepingError> {
    let head = |reason| Err(error(Part::Head, None, reason));
    let mass_kg = raw.mass[0][0];
    let numbers = raw.mass.iter().flatten().chain(raw.restoring.iter().flatten());
    if numbers.chain(&raw.reference_m).any(|value| value.is_nan() || value.abs() >= 1e18) {
        return head(Reason::NotANumber("mass or restoring"));
    }
    if !(mass_kg > 0.0 && smallest_eigenvalue(&raw.mass).0 > 0.0) {
        return head(Reason::NoMass { motion: 0 });
    }
    for (index, motion) in UPRIGHT.into_iter().enumerate() {
        if raw.restoring[index][index] <= 0.0 {
            return head(Reason::Unstable { motion });
        }
    }
    let mut restoring = scaled_to_one();
    for (i, row) in raw.restoring.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            restoring[UPRIGHT[i]][UPRIGHT[j]] =
                entry / (raw.restoring[i][i] * raw.restoring[j][j]).sqrt();
        }
    }
    if let Some(motions) = negative_together(&restoring) {
        return head(Reason::CouplesTooMuch { what: "restoring", motions });
    }
    // Heave restoring is ρg times the waterplane area. The range of areas is the displaced volume over a draught of 2 %
    // to three times the cube root of the volume.
    let volume_m3 = mass_kg / raw.water_kgpm3;
    let specific_npm3 = raw.water_kgpm3 * STANDARD_GRAVITY_MPS2;
    let cube_m = libm::cbrt(volume_m3);
    let range = [3.0, 0.02].map(|share| specific_npm3 * volume_m3 / (share * cube_m));
    let value = raw.restoring[0][0];
    if !(range[0]..=range[1]).contains(&value) {
        return head(Reason::Implausible { what: "restoring in heave [N/m]", value, range });
    }
    Ok(())
}

/// Checks symmetry, signs and sizes of the added mass and the damping.
pub(super) fn check_matrices(raw: &RawHydrodynamics) -> Result<(), SeakeepingError> {
    let mass_kg = raw.mass[0][0];
    let length_m = 10.0 * libm::cbrt(mass_kg / raw.water_kgpm3);
    let at_infinity = |motion: usize| raw.infinite[motion][motion];
    for (motion, most) in [(0, 5.0), (1, 20.0), (2, 50.0)] {
        let range = [0.0, most * mass_kg];
        let value = at_infinity(motion);
        if !(range[0]..=range[1]).contains(&value) {
            let what =
                ["added mass in surge [kg]", "added mass in sway [kg]", "added mass in heave [kg]"]
                    [motion];
            return Err(error(Part::Infinite, Some(0), Reason::Implausible { what, value, range }));
        }
    }
    // In sway and heave a ship carries water with at least a part of her own mass.
    let heave = at_infinity(2);
    let range = [0.02 * mass_kg, 50.0 * mass_kg];
    if heave < range[0] {
        let what = "added mass in heave [kg]";
        return Err(error(
            Part::Infinite,
            Some(0),
            Reason::Implausible { what, value: heave, range },
        ));
    }
    let yaw = at_infinity(5);
    let range = [0.0, 20.0 * mass_kg * length_m * length_m];
    if !(range[0]..=range[1]).contains(&yaw) {
        let what = "added inertia in yaw [kg m²]";
        return Err(error(
            Part::Infinite,
            Some(0),
            Reason::Implausible { what, value: yaw, range },
        ));
    }
    let largest = |matrices: &[Matrix6], motion: usize| {
        matrices.iter().map(|matrix| matrix[motion][motion].abs()).fold(0.0, greater)
    };
    let added: Six =
        std::array::from_fn(|k| greater(largest(&raw.added_mass, k), raw.infinite[k][k].abs()));
    let damped: Six = std::array::from_fn(|k| largest(&raw.damping, k));
    for (row, damping) in raw.damping.iter().enumerate() {
        for (motion, most) in damped.iter().enumerate() {
            let damping = damping[motion][motion];
            if damping < -NOISE[0] * most {
                let reason = Reason::NegativeDamping { motion, damping };
                return Err(error(Part::Radiation, Some(row), reason));
            }
        }
    }
    let check = |part, row, name, matrix: &Matrix6, scale: &Six| {
        for i in 0..6 {
            for j in 0..i {
                let values = [matrix[j][i], matrix[i][j]];
                let noise = NOISE[1] * (scale[i] * scale[j]).sqrt();
                if (values[0] - values[1]).abs() > noise {
                    let reason = Reason::NotSymmetric { matrix: name, entry: [j, i], values };
                    return Err(error(part, Some(row), reason));
                }
            }
        }
        Ok(())
    };
    for (row, matrix) in raw.added_mass.iter().enumerate() {
        check(Part::Radiation, row, "added mass", matrix, &added)?;
    }
    for (row, matrix) in raw.damping.iter().enumerate() {
        check(Part::Radiation, row, "damping", matrix, &damped)?;
    }
    check(Part::Infinite, 0, "added mass", &raw.infinite, &added)
}

/// Checks the frequencies of the data: they must rise, be close enough to each other, and reach from long waves to
/// where the damping has faded.
pub(super) fn check_axes(raw: &RawHydrodynamics) -> Result<(), SeakeepingError> {
    for (part, axis) in
        [(Part::Radiation, &raw.frequencies_radps), (Part::Excitation, &raw.wave_frequencies_radps)]
    {
        let first_is_good = axis[0] > 0.0 && axis[axis.len() - 1] < 1e3;
        let falls = axis.windows(2).position(|two| !rises(two));
        if falls.is_some() || !first_is_good {
            let row = falls.map_or(Some(0), |row| Some(row + 1));
            return Err(error(part, row, Reason::NotRising("frequencies")));
        }
    }
    let axis = &raw.frequencies_radps;
    let last = axis.len() - 1;
    for motion in 0..6 {
        let of = |row: usize| raw.damping[row][motion][motion];
        let most = (0..=last).map(of).fold(0.0, greater);
        // Damping without a noticeable effect on the motion may end at any frequency.
        let total = raw.mass[motion][motion] + raw.infinite[motion][motion].abs();
        if most < 0.06 * total {
            continue;
        }
        for row in 1..=last {
            if (of(row) - of(row - 1)).abs() > COARSEST * most {
                let reason =
                    Reason::TooCoarse { motion, between_radps: [axis[row - 1], axis[row]] };
                return Err(error(Part::Radiation, Some(row), reason));
            }
        }
        if of(last) > AT_THE_ENDS[1] * most {
            let reason =
                Reason::TooShort { motion, share: of(last) / most, last_radps: axis[last] };
            return Err(error(Part::Radiation, Some(last), reason));
        }
        // In shallow water heave radiates long waves. Their damping is small beside the restoring force.
        let restoring =
            UPRIGHT.iter().position(|k| *k == motion).map_or(0.0, |k| raw.restoring[k][k]);
        let is_felt = axis[0] * of(0) > UNFELT * restoring;
        if is_felt && of(0) > AT_THE_ENDS[0] * most {
            let reason = Reason::StartsLate { motion, share: of(0) / most, first_radps: axis[0] };
            return Err(error(Part::Radiation, Some(0), reason));
        }
    }
    Ok(())
}

/// True if the headings of the hydrodynamic data go from 0 to π; otherwise the headings must go all round.
pub(super) fn check_headings(headings_rad: &[f64]) -> Result<bool, SeakeepingError> {
    let part = Part::Excitation;
    if headings_rad.len() < 2 || headings_rad.windows(2).any(|two| !rises(two)) {
        return Err(error(part, None, Reason::NotRising("headings")));
    }
    let [first, last] = [headings_rad[0], headings_rad[headings_rad.len() - 1]];
    let gap = |from: f64, to: f64| {
        let between_deg = [from.to_degrees(), to.to_degrees()];
        Err(error(part, None, Reason::HeadingGap { between_deg }))
    };
    if let Some(two) = headings_rad.windows(2).find(|two| two[1] - two[0] > WIDEST_STEP) {
        return gap(two[0], two[1]);
    }
    let is_mirrored = first.abs() < 1e-3 && (last - PI).abs() < 1e-3;
    if is_mirrored {
        return Ok(true);
    }
    if last - first > TAU + 1e-3 || first + TAU - last > WIDEST_STEP {
        return gap(last, first + TAU);
    }
    Ok(false)
}

fn rises(two: &[f64]) -> bool {
    two[0] < two[1]
}
