//! A family with one size of measured curves: normalised, with as few points as the tolerance allows.

use fenderline_contact::number::lesser;

use core::fmt;
use core::fmt::Write as _;

use super::curves::{Branch, FenderCurves, LoadingCurve, integral, value};
use crate::Standing;
use crate::printable::printable_number;

/// Temperature for which catalogues rate fenders (°C): the factor is 1 at the one nearest to it.
const RATED_TEMPERATURE_C: f64 = 23.0;

/// What the file of curves does not say.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// Name of the family.
    pub family: String,
    /// Designation of the size.
    pub designation: String,
    /// Extent in the direction of compression, uncompressed (m).
    pub height_m: f64,
    /// Length along the berth (m).
    pub length_m: Option<f64>,
    /// Rated deflection (m); `None`: where the reference loading curve ends.
    pub rated_deflection_m: Option<f64>,
    /// Share of the energy that comes back, where the file has no unloading curve.
    pub returned_energy: Option<f64>,
    /// Largest difference of the straight pieces from the rows, as a share of the rated reaction.
    pub tolerance: f64,
    /// Where the curves come from.
    pub source: String,
    /// How well that is known.
    pub standing: Standing,
}

/// Why no fender can be made of good curves.
#[derive(Clone, Debug, PartialEq)]
pub enum FitError {
    /// A number outside its range.
    OutOfRange {
        /// Which.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Smallest good value.
        low: f64,
        /// Largest good value.
        high: f64,
    },
    /// A curve is deflected by more than the height, or its end lies before the rated deflection.
    Ends {
        /// Which curve.
        curve: String,
        /// Where it ends (m).
        end_m: f64,
        /// Where it would have to (m).
        wanted: String,
    },
    /// The reaction at the rated deflection is none.
    NoReaction {
        /// The rated deflection (m).
        rated_deflection_m: f64,
    },
    /// The file has an unloading curve and the returned energy is given as well.
    ReturnedTwice,
    /// Several loading curves of the same speed: temperature and speed must be varied one at a time.
    NotOneAtATime {
        /// Which curve.
        curve: String,
    },
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FitError::OutOfRange { quantity, value, low, high } => {
                let [value, low, high] = [*value, *low, *high].map(printable_number);
                write!(f, "{quantity} is {value}, but must be between {low} and {high}")
            }
            FitError::Ends { curve, end_m, wanted } => {
                write!(f, "{curve} ends at {end_m} m; {wanted}")
            }
            FitError::NoReaction { rated_deflection_m } => {
                write!(f, "at the rated deflection of {rated_deflection_m} m there is no reaction")
            }
            FitError::ReturnedTwice => {
                write!(f, "the file has an unloading curve; the returned energy is that curve's")
            }
            FitError::NotOneAtATime { curve } => write!(
                f,
                "{curve} differs from the reference curve in speed and in temperature: vary one at a time"
            ),
        }
    }
}

impl core::error::Error for FitError {}

/// A fender made of curves.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedFender {
    options: FitOptions,
    /// The curve that the family has: speed and temperature nearest to those of a rating.
    reference: LoadingCurve,
    /// Rated deflection (m).
    pub rated_deflection_m: f64,
    /// Reaction at the rated deflection (N).
    pub rated_reaction_n: f64,
    /// Deflection over height against reaction over rated reaction.
    pub points: Branch,
    /// The same of the unloading curve; empty where there is none.
    pub unloading: Branch,
    /// Time to rated deflection (s) against factor on the reaction; empty where the file has no speeds.
    pub velocity: Branch,
    /// Temperature (°C) against factor on the reaction; empty where the file has no temperatures.
    pub temperature: Branch,
}

impl FittedFender {
    /// Fits a fender to the curves. The reference is the slowest curve at the temperature nearest to 23 °C; factors of
    /// speed and temperature are the ratios of the energies to the rated deflection.
    ///
    /// # Errors
    /// An option out of its range, a curve that ends too soon or goes beyond the height, no reaction at the rated
    /// deflection, an unloading curve beside a returned energy, speed and temperature varied together.
    pub fn fit(curves: &FenderCurves, options: &FitOptions) -> Result<FittedFender, FitError> {
        check(options)?;
        let reference = reference(curves);
        let end_m = end(&reference.loading);
        if end_m > options.height_m {
            return Err(FitError::Ends {
                curve: name(reference),
                end_m,
                wanted: format!("the fender is {} m high", printable_number(options.height_m)),
            });
        }
        let rated_m = options.rated_deflection_m.unwrap_or(end_m);
        let rated_n = value(&reference.loading, rated_m).ok_or_else(|| FitError::Ends {
            curve: name(reference),
            end_m,
            wanted: format!("the rated deflection is {} m", printable_number(rated_m)),
        })?;
        if rated_n <= 0.0 {
            return Err(FitError::NoReaction { rated_deflection_m: rated_m });
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

    /// The measured curve that the fit follows.
    #[must_use]
    pub fn reference(&self) -> &LoadingCurve {
        &self.reference
    }

    /// Reaction of the fit at a deflection (m) on its curve (N).
    #[must_use]
    pub fn reaction_n(&self, deflection_m: f64) -> Option<f64> {
        value(&self.points, deflection_m / self.options.height_m).map(|r| r * self.rated_reaction_n)
    }

    /// Energy of the fit to a deflection (m) on its curve (J).
    #[must_use]
    pub fn energy_j(&self, deflection_m: f64) -> f64 {
        let share = integral(&self.points, deflection_m / self.options.height_m);
        share * self.rated_reaction_n * self.options.height_m
    }

    /// Reaction of the fitted unloading curve at a deflection (m) on it (N).
    #[must_use]
    pub fn unloading_n(&self, deflection_m: f64) -> Option<f64> {
        value(&self.unloading, deflection_m / self.options.height_m)
            .map(|r| r * self.rated_reaction_n)
    }

    /// Share of the energy that the fitted unloading curve returns; the given one where there is no curve.
    #[must_use]
    pub fn returned_energy(&self) -> Option<f64> {
        if self.unloading.is_empty() {
            return self.options.returned_energy;
        }
        let end = end(&self.unloading);
        Some(integral(&self.unloading, end) / integral(&self.points, end))
    }

    /// The fender as a file of the library.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let FitOptions { family, designation, height_m, length_m, source, standing, .. } =
            &self.options;
        let family = quoted(family);
        let origin = format!("source = {}\nstanding = \"{}\"\n", quoted(source), standing.word());
        let mut text = format!(
            "# Fitted by `fenderline fender fit`.\n\n[family.{family}]\nrated_deflection = {}\nreference = {}\n",
            number(self.rated_deflection_m / height_m),
            quoted(designation),
        );
        let mut table = |title: &str, comment: &str, points: &Branch| {
            if !points.is_empty() {
                let _ = write!(text, "\n[family.{family}.{title}]\n# {comment}\npoints = [\n");
                text.push_str(&rows(points));
                let _ = write!(text, "]\n{origin}");
            }
        };
        table("curve", "[deflection over height, reaction over rated reaction]", &self.points);
        table(
            "unloading",
            "[deflection over height, reaction over rated reaction]",
            &self.unloading,
        );
        table("temperature", "[degrees Celsius, factor on the reaction]", &self.temperature);
        table(
            "velocity",
            "[time to rated deflection in s, factor on the reaction]",
            &self.velocity,
        );
        if let Some(share) = self.options.returned_energy {
            let _ = write!(
                text,
                "\n[family.{family}.unloading]\nreturned_energy = {}\n{origin}",
                number(share)
            );
        }
        let _ = write!(
            text,
            "\n[[family.{family}.size]]\ndesignation = {}\nheight = \"{} m\"\n",
            quoted(designation),
            number(*height_m)
        );
        if let Some(length_m) = length_m {
            let _ = writeln!(text, "length = \"{} m\"", number(*length_m));
        }
        let _ = write!(text, "reaction = \"{} N\"\n{origin}", number(self.rated_reaction_n));
        text
    }
}

fn check(options: &FitOptions) -> Result<(), FitError> {
    let within = |quantity, value: f64, low, high| {
        let good = (low..=high).contains(&value);
        good.then_some(()).ok_or(FitError::OutOfRange { quantity, value, low, high })
    };
    within("the height [m]", options.height_m, 1e-3, 100.0)?;
    within("the length [m]", options.length_m.unwrap_or(1.0), 1e-3, 100.0)?;
    within("the rated deflection [m]", options.rated_deflection_m.unwrap_or(1e-6), 1e-6, 100.0)?;
    within("the returned energy", options.returned_energy.unwrap_or(1.0), 0.05, 1.0)?;
    within("the tolerance", options.tolerance, 0.0, 0.2)
}

/// The slowest curve at the temperature nearest to that of ratings; the first of equal ones.
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

/// What a message calls a curve.
fn name(curve: &LoadingCurve) -> String {
    let mut name = "the loading curve".to_owned();
    if let Some(speed_mps) = curve.speed_mps {
        let _ = write!(name, " at {speed_mps} m/s");
    }
    if let Some(temperature_c) = curve.temperature_c {
        let _ = write!(name, " at {temperature_c} °C");
    }
    name
}

fn end(branch: &Branch) -> f64 {
    branch.last().map_or(0.0, |last| last.0)
}

/// Energy of a curve to the rated deflection over that of the reference.
fn factor(curve: &LoadingCurve, reference: &LoadingCurve, rated_m: f64) -> Result<f64, FitError> {
    let end_m = end(&curve.loading);
    if end_m < rated_m {
        let wanted = format!("the rated deflection is {} m", printable_number(rated_m));
        return Err(FitError::Ends { curve: name(curve), end_m, wanted });
    }
    Ok(integral(&curve.loading, rated_m) / integral(&reference.loading, rated_m))
}

fn velocity(
    curves: &FenderCurves,
    reference: &LoadingCurve,
    rated_m: f64,
) -> Result<Branch, FitError> {
    let mut rows = Branch::new();
    for curve in &curves.curves {
        let Some(speed_mps) = curve.speed_mps else { continue };
        if curve.temperature_c == reference.temperature_c {
            rows.push((rated_m / speed_mps, factor(curve, reference, rated_m)?));
        } else if curve.speed_mps != reference.speed_mps {
            return Err(FitError::NotOneAtATime { curve: name(curve) });
        }
    }
    rows.sort_by(|one, other| one.0.total_cmp(&other.0));
    // One speed is no dependence on it.
    Ok(if rows.len() > 1 { rows } else { Branch::new() })
}

fn temperature(
    curves: &FenderCurves,
    reference: &LoadingCurve,
    rated_m: f64,
) -> Result<Branch, FitError> {
    let mut rows = Branch::new();
    for curve in curves.curves.iter().filter(|curve| curve.speed_mps == reference.speed_mps) {
        if let Some(temperature_c) = curve.temperature_c {
            rows.push((temperature_c, factor(curve, reference, rated_m)?));
        }
    }
    rows.sort_by(|one, other| one.0.total_cmp(&other.0));
    Ok(if rows.len() > 1 { rows } else { Branch::new() })
}

/// Adds a point to a curve on which it lies, unless one is there.
fn insert(branch: &mut Branch, point: (f64, f64)) {
    let after = branch.partition_point(|known| known.0 < point.0);
    if branch.get(after).is_none_or(|known| known.0 > point.0) {
        branch.insert(after, point);
    }
}

/// As few of the points as keep all others within the tolerance of the straight pieces (Ramer, 1972; Douglas and
/// Peucker, 1973, with the distance in reaction). The one at `kept` stays.
fn thinned(points: &Branch, tolerance: f64, kept: f64) -> Branch {
    let Some(last) = points.len().checked_sub(1) else { return Branch::new() };
    let mut stays = vec![false; points.len()];
    let fixed = points.iter().position(|point| (point.0 - kept).abs() <= 1e-12);
    let mut pieces = vec![(0, fixed.unwrap_or(last)), (fixed.unwrap_or(last), last)];
    for (from, to) in &pieces {
        stays[*from] = true;
        stays[*to] = true;
    }
    while let Some((from, to)) = pieces.pop() {
        let ends = [points[from], points[to]];
        let off = |index: usize| {
            let straight = value(&ends, points[index].0).unwrap_or(ends[0].1);
            (points[index].1 - straight).abs()
        };
        let farthest = (from + 1..to).max_by(|one, other| off(*one).total_cmp(&off(*other)));
        if let Some(index) = farthest.filter(|index| off(*index) > tolerance) {
            stays[index] = true;
            pieces.push((from, index));
            pieces.push((index, to));
        }
    }
    let kept = points.iter().zip(stays).filter(|(_, stays)| *stays);
    kept.map(|(point, _)| *point).collect()
}

/// The unloading curve held down to the loading one, which thinning may have put below it.
fn below(unloading: Branch, loading: &Branch) -> Branch {
    let mut all = unloading.clone();
    if let Some(end) = unloading.last().map(|last| last.0) {
        // Where the loading curve has a corner below a straight piece of the unloading one.
        for corner in loading.iter().filter(|corner| corner.0 < end) {
            if value(&unloading, corner.0).is_some_and(|reaction| reaction > corner.1) {
                insert(&mut all, *corner);
            }
        }
    }
    // The file has six figures: off the corners of the loading curve a hair below it, so that rounding puts none above.
    let is_corner = |d: f64| loading.iter().any(|corner| corner.0 == d);
    let hair = |d: f64| if is_corner(d) { 1.0 } else { 1.0 - 2e-5 };
    let held =
        |(d, r): (f64, f64)| (d, value(loading, d).map_or(r, |bound| lesser(r, hair(d) * bound)));
    all.into_iter().map(held).collect()
}

/// Six figures: finer than any test bench.
fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    format!("{rounded}")
}

fn rows(points: &Branch) -> String {
    points.iter().map(|(d, r)| format!("    [{}, {}],\n", number(*d), number(*r))).collect()
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' => {
                quoted.push('\\');
                quoted.push(letter);
            }
            control if control.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(control));
            }
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FenderLibrary;

    fn options() -> FitOptions {
        FitOptions {
            family: "bench \"A\"".to_owned(),
            designation: "500".to_owned(),
            height_m: 0.5,
            length_m: Some(1.0),
            rated_deflection_m: None,
            returned_energy: None,
            tolerance: 0.005,
            source: "a test bench".to_owned(),
            standing: Standing::Found,
        }
    }

    fn curves(rows: &str) -> FenderCurves {
        FenderCurves::parse(rows, "bench.csv").unwrap()
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
    fn what_cannot_be_made_a_fender_is_refused() {
        let good = curves(&parabola(COLUMNS, "", 1.0));
        let refused = |change: fn(&mut FitOptions)| {
            let mut options = options();
            change(&mut options);
            FittedFender::fit(&good, &options).unwrap_err().to_string()
        };
        for (said, fragment) in [
            (refused(|o| o.height_m = 0.2), "the fender is 0.2 m high"),
            (refused(|o| o.height_m = f64::NAN), "the height"),
            (
                refused(|o| o.rated_deflection_m = Some(0.3)),
                "ends at 0.25 m; the rated deflection is 0.3 m",
            ),
            (refused(|o| o.rated_deflection_m = Some(-0.3)), "the rated deflection [m] is -0.3"),
            (refused(|o| o.returned_energy = Some(1.2)), "the returned energy is 1.2"),
            (refused(|o| o.returned_energy = Some(-0.1)), "the returned energy is -0.1"),
            (refused(|o| o.tolerance = 0.5), "the tolerance is 0.5"),
        ] {
            assert!(said.contains(fragment), "{said}");
        }
        let nothing = curves("deflection_m,reaction_n\n0.1,0\n0.2,0\n0.3,0\n");
        let said = FittedFender::fit(&nothing, &options()).unwrap_err().to_string();
        assert!(said.contains("no reaction"), "{said}");
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

    #[test]
    fn a_returned_energy_of_the_user_goes_into_the_file() {
        let options = FitOptions { returned_energy: Some(0.6), ..options() };
        let fitted = FittedFender::fit(&curves(&parabola(COLUMNS, "", 1.0)), &options).unwrap();
        let library = FenderLibrary::built_in().with_file(&fitted.to_toml(), "fit.toml").unwrap();
        let unloading = library.family("bench \"A\"").unwrap().unloading.clone().unwrap();
        assert_eq!(unloading.law, fenderline_contact::Unloading::ReturnedEnergy(0.6));
    }
}
