//! A fender family with one size, fitted to measured curves: deflections and reactions are shares of height and rated
//! reaction, and the fit has as few points as the tolerance allows.

use super::curves::{Branch, FenderCurves, LoadingCurve, end, integral, value};
use super::factors::{temperature, velocity};
use super::options::{FitError, FitOptions};
use super::thinning::{below, insert, thinned};
use fenderline_keys::printable::printable_number;
use fenderline_keys::rating::odd_reaction;

/// Temperature for which catalogues rate fenders (°C). The reference curve is the curve nearest to this temperature.
const RATED_TEMPERATURE_C: f64 = 23.0;

/// A fender fitted to measured curves.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedFender {
    pub(super) options: FitOptions,
    /// The measured curve that the fit follows.
    reference: LoadingCurve,
    /// Rated deflection (m).
    pub rated_deflection_m: f64,
    /// Reaction of the fender at the rated deflection (N).
    pub rated_reaction_n: f64,
    /// Points of the loading curve: deflection over height, reaction over rated reaction.
    pub points: Branch,
    /// Points of the unloading curve, as shares of height and rated reaction; empty if no unloading curve was measured.
    pub unloading: Branch,
    /// Points of time to rated deflection (s) and factor on the reaction; empty if the file has no speeds.
    pub velocity: Branch,
    /// Points of temperature (°C) and factor on the reaction; empty if the file has no temperatures.
    pub temperature: Branch,
}

impl FittedFender {
    /// Fits a fender to the measured curves. The reference is the slowest curve at the temperature nearest to 23 °C;
    /// the factor of a speed or temperature is the ratio of its curve's energy to the reference curve's energy, both up
    /// to the rated deflection.
    ///
    /// # Errors
    /// Fails for an option out of range, for a reaction of zero at the rated deflection, for an unloading curve
    /// together with a returned energy, and for curves that differ in both speed and temperature. Fails too for a curve
    /// that does not have the given rated reaction at the rated deflection, ends before the rated deflection, or goes
    /// beyond the height.
    pub fn fit(curves: &FenderCurves, options: &FitOptions) -> Result<FittedFender, FitError> {
        options.check()?;
        let reference = reference(curves);
        let end_m = end(&reference.loading);
        if end_m > options.height_m {
            return Err(FitError::Ends {
                curve: reference.name(),
                end_m,
                conflict: format!("the fender is {} m high", printable_number(options.height_m)),
            });
        }
        let rated_m = options.rated_deflection_m.unwrap_or(end_m);
        let rated_n = value(&reference.loading, rated_m).ok_or_else(|| FitError::Ends {
            curve: reference.name(),
            end_m,
            conflict: format!("the rated deflection is {} m", printable_number(rated_m)),
        })?;
        if rated_n <= 0.0 {
            return Err(FitError::NoReaction { rated_deflection_m: rated_m });
        }
        if let Some(catalogue_n) = options.rated_reaction_n {
            check_rated(&reference.loading, (rated_m, rated_n), catalogue_n, options)?;
        }
        if options.returned_energy.is_some() && !reference.unloading.is_empty() {
            return Err(FitError::ReturnedTwice);
        }
        let normal = |branch: &Branch| -> Branch {
            branch.iter().map(|(d, r)| (d / options.height_m, r / rated_n)).collect()
        };
        let mut loading = normal(&reference.loading);
        insert(&mut loading, (rated_m / options.height_m, 1.0));
        let points = thinned(&loading, options.tolerance, rated_m / options.height_m);
        let unloading = thinned(&normal(&reference.unloading), options.tolerance, f64::NAN);
        Ok(FittedFender {
            options: options.clone(),
            reference: reference.clone(),
            rated_deflection_m: rated_m,
            rated_reaction_n: rated_n,
            unloading: below(unloading, &points),
            points,
            velocity: velocity(curves, reference, rated_m)?,
            temperature: temperature(curves, reference, rated_m)?,
        })
    }

    /// Says what is odd about the rated reaction for a fender of this height, such as newtons in place of kilonewtons.
    #[must_use]
    pub fn oddity(&self) -> Option<String> {
        odd_reaction(self.rated_reaction_n, self.options.height_m, "a height")
    }

    /// The measured curve that the fitted fender follows.
    #[must_use]
    pub fn reference(&self) -> &LoadingCurve {
        &self.reference
    }

    /// Reaction (N) of the fitted loading curve at a deflection (m); `None` beyond the curve's end.
    #[must_use]
    pub fn reaction_n(&self, deflection_m: f64) -> Option<f64> {
        value(&self.points, deflection_m / self.options.height_m).map(|r| r * self.rated_reaction_n)
    }

    /// Energy (J) of the fitted loading curve up to a deflection (m).
    #[must_use]
    pub fn energy_j(&self, deflection_m: f64) -> f64 {
        let share = integral(&self.points, deflection_m / self.options.height_m);
        share * self.rated_reaction_n * self.options.height_m
    }

    /// Reaction (N) of the fitted unloading curve at a deflection (m); `None` beyond the curve's end.
    #[must_use]
    pub fn unloading_n(&self, deflection_m: f64) -> Option<f64> {
        value(&self.unloading, deflection_m / self.options.height_m)
            .map(|r| r * self.rated_reaction_n)
    }

    /// Fraction of the energy that the fender returns in unloading: by the fitted unloading curve, or as given if there
    /// is no unloading curve.
    #[must_use]
    pub fn returned_energy(&self) -> Option<f64> {
        if self.unloading.is_empty() {
            return self.options.returned_energy;
        }
        let end = end(&self.unloading);
        Some(integral(&self.unloading, end) / integral(&self.points, end))
    }
}

/// Largest relative difference between the curve's reaction at the rated deflection and the rated reaction: catalogues
/// round both to a per cent.
const RATED_FITS: f64 = 0.02;

/// Refuses a curve that does not have the catalogue's rated reaction at the rated deflection.
fn check_rated(
    loading: &Branch,
    (rated_m, curve_n): (f64, f64),
    catalogue_n: f64,
    options: &FitOptions,
) -> Result<(), FitError> {
    let share = curve_n / catalogue_n;
    if (share - 1.0).abs() <= RATED_FITS {
        return Ok(());
    }
    let crossing = loading.windows(2).rev().find_map(|two| {
        let [(d0, r0), (d1, r1)] = [two[0], two[1]];
        let is_between = (r0 - catalogue_n) * (r1 - catalogue_n) <= 0.0 && r0 != r1;
        is_between.then(|| d0 + (d1 - d0) * (catalogue_n - r0) / (r1 - r0))
    });
    Err(FitError::NotRated {
        deflection_m: rated_m,
        share,
        is_given: options.rated_deflection_m.is_some(),
        at: crossing.map(|at_m| (at_m, at_m / options.height_m)),
    })
}

/// The slowest of the curves at the temperature nearest to the rated temperature; the first of equal curves.
fn reference(curves: &FenderCurves) -> &LoadingCurve {
    let away =
        |curve: &LoadingCurve| curve.temperature_c.map_or(0.0, |c| (c - RATED_TEMPERATURE_C).abs());
    let speed = |curve: &LoadingCurve| curve.speed_mps.unwrap_or(0.0);
    let nearer = |one: &LoadingCurve, other: &LoadingCurve| {
        away(one).total_cmp(&away(other)).then(speed(one).total_cmp(&speed(other)))
    };
    curves
        .curves
        .iter()
        .min_by(|one, other| nearer(one, other))
        .expect("a file without a loading curve is refused")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::CatalogueScale;
    use fenderline_scenario::{FenderLibrary, Standing};

    fn options() -> FitOptions {
        FitOptions {
            family: "bench \"A\"".to_owned(),
            designation: "500".to_owned(),
            height_m: 0.5,
            length_m: Some(1.0),
            rated_deflection_m: None,
            rated_reaction_n: None,
            returned_energy: None,
            tolerance: 0.005,
            source: "a test bench".to_owned(),
            standing: Standing::Found,
        }
    }

    fn curves(rows: &str) -> FenderCurves {
        FenderCurves::parse(rows, "bench.csv", CatalogueScale::default()).unwrap()
    }

    /// R = 400 kN/m² δ² to 0.25 m in steps of 1 mm.
    fn parabola(columns: &str, rest: &str, factor: f64) -> String {
        let row = |mm: u32| {
            let m = f64::from(mm) * 1e-3;
            format!("{m},{}{rest}\n", factor * 400e3 * m * m)
        };
        format!("{columns}{}", (1..=250).map(row).collect::<String>())
    }

    const COLUMNS: &str = "deflection_m,reaction_n\n";

    #[test]
    fn a_parabola_is_followed_with_few_points_and_read_back() {
        let fitted = FittedFender::fit(&curves(&parabola(COLUMNS, "", 1.0)), &options()).unwrap();
        assert!(fitted.points.len() < 12, "{} points", fitted.points.len());
        assert!((fitted.rated_reaction_n - 25e3).abs() < 1e-6);
        for mm in 1..=250 {
            let m = f64::from(mm) * 1e-3;
            let off_n = fitted.reaction_n(m).unwrap() - 400e3 * m * m;
            assert!(off_n.abs() <= 0.005 * 25e3 + 1e-6, "{off_n} N at {m} m");
        }
        let library = FenderLibrary::built_in().with_file(&fitted.to_toml(), "fit.toml").unwrap();
        let fender = library.fender("bench \"A\"", "500").unwrap();
        assert!((fender.rated_reaction_n - 25e3).abs() < 1.0);
        assert!((fender.rated_deflection_m - 0.25).abs() < 1e-9);
        assert!((fender.rated_energy_j / fitted.energy_j(0.25) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn speeds_and_temperatures_become_factors_by_energy() {
        let speeds = "deflection_m,reaction_n,speed_mps\n".to_owned()
            + &parabola("", ",0.1", 1.2)
            + &parabola("", ",0.001", 1.0);
        let fitted = FittedFender::fit(&curves(&speeds), &options()).unwrap();
        let [(fast_s, fast), (slow_s, slow)] = fitted.velocity[..] else { panic!("{fitted:?}") };
        assert!((fast_s - 2.5).abs() < 1e-12 && (fast - 1.2).abs() < 1e-12);
        assert!((slow_s - 250.0).abs() < 1e-9 && (slow - 1.0).abs() < 1e-12);
        let temperatures = "deflection_m,reaction_n,temperature_c\n".to_owned()
            + &parabola("", ",-10", 1.1)
            + &parabola("", ",20", 1.0)
            + &parabola("", ",40", 0.9);
        let fitted = FittedFender::fit(&curves(&temperatures), &options()).unwrap();
        let expected = [(-10.0, 1.1), (20.0, 1.0), (40.0, 0.9)];
        assert!(
            fitted
                .temperature
                .iter()
                .zip(expected)
                .all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 1e-12),
            "{fitted:?}"
        );
        FenderLibrary::built_in().with_file(&fitted.to_toml(), "fit.toml").unwrap();
    }

    #[test]
    fn curves_and_options_that_make_no_fender_are_refused() {
        let good = curves(&parabola(COLUMNS, "", 1.0));
        let refused = |change: fn(&mut FitOptions)| {
            let mut options = options();
            change(&mut options);
            FittedFender::fit(&good, &options).unwrap_err().to_string()
        };
        for (message, fragment) in [
            (refused(|o| o.height_m = 0.2), "the fender is 0.2 m high"),
            (refused(|o| o.height_m = f64::NAN), "the height"),
            (
                refused(|o| o.rated_deflection_m = Some(0.3)),
                "ends at a deflection of 0.25 m; the rated deflection is 0.3 m",
            ),
            (refused(|o| o.rated_deflection_m = Some(-0.3)), "the rated deflection [m] is -0.3"),
            (refused(|o| o.returned_energy = Some(1.2)), "the returned energy is 1.2"),
            (refused(|o| o.returned_energy = Some(-0.1)), "the returned energy is -0.1"),
            (refused(|o| o.tolerance = 0.5), "the tolerance is 0.5"),
        ] {
            assert!(message.contains(fragment), "{message}");
        }
        let nothing = curves("deflection_m,reaction_n\n0.1,0\n0.2,0\n0.3,0\n");
        let message = FittedFender::fit(&nothing, &options()).unwrap_err().to_string();
        assert!(message.contains("is zero"), "{message}");
    }

    #[test]
    fn the_unloading_curve_stays_below_the_loading_one_after_thinning() {
        let rows: String = (1..=100)
            .map(|i| {
                let d = f64::from(i) * 0.0025;
                let loading = 1e5 * libm::sqrt(d);
                format!("{d},{loading},0\n{d},{},1\n", loading * (0.9 + 0.1 * d / 0.25))
            })
            .collect();
        let text = format!("deflection_m,reaction_n,unloading\n{rows}");
        let options = FitOptions { tolerance: 0.05, ..options() };
        let fitted = FittedFender::fit(&curves(&text), &options).unwrap();
        for i in 0..=1000 {
            let d = f64::from(i) * 0.00025;
            let (up, down) = (fitted.reaction_n(d).unwrap(), fitted.unloading_n(d).unwrap());
            assert!(down <= up * (1.0 + 1e-12), "{down} N above {up} N at {d} m");
        }
        let share = fitted.returned_energy().unwrap();
        assert!((0.9..1.0).contains(&share), "{share}");
        let library = FenderLibrary::built_in().with_file(&fitted.to_toml(), "fit.toml").unwrap();
        let family = library.family("bench \"A\"").unwrap();
        assert!(family.unloading.is_some());
    }

    /// R = 25 kN at 0.25 m; a catalogue's 16 kN are at 0.2 m.
    #[test]
    fn a_curve_must_have_the_rated_reaction_at_the_rated_deflection() {
        let good = curves(&parabola(COLUMNS, "", 1.0));
        let fit = |rated_n: f64, rated_m: Option<f64>| {
            let options = FitOptions {
                rated_reaction_n: Some(rated_n),
                rated_deflection_m: rated_m,
                ..options()
            };
            FittedFender::fit(&good, &options).map_err(|error| error.to_string())
        };
        assert!(fit(25e3, None).is_ok());
        assert!(fit(16e3, Some(0.2)).is_ok());
        let message = fit(16e3, None).unwrap_err();
        let expected = "at the end of the curve, 250 mm, the reaction is 156.3 % of the rated \
            reaction; it must be 100 % at the rated deflection: the curve is at 100 % for the \
            last time at 200 mm, 40 % of the height";
        assert!(message.contains(expected), "{message}");
        assert!(message.contains("give --rated-deflection \"200 mm\""), "{message}");
        let message = fit(40e3, Some(0.2)).unwrap_err();
        assert!(
            message.contains("at the rated deflection, 200 mm, the reaction is 40 %"),
            "{message}"
        );
        assert!(message.contains("never reaches the rated reaction"), "{message}");
    }

    #[test]
    fn a_given_returned_energy_goes_into_the_file() {
        let options = FitOptions { returned_energy: Some(0.6), ..options() };
        let fitted = FittedFender::fit(&curves(&parabola(COLUMNS, "", 1.0)), &options).unwrap();
        let library = FenderLibrary::built_in().with_file(&fitted.to_toml(), "fit.toml").unwrap();
        let unloading = library.family("bench \"A\"").unwrap().unloading.clone().unwrap();
        assert_eq!(unloading.law, fenderline_contact::Unloading::ReturnedEnergy(0.6));
    }
}
