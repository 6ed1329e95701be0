//! Reads a file of measured curves of a fender, reactions over deflections: loading, unloading, several speeds or
//! temperatures.

use core::fmt::Write as _;
use std::collections::{BTreeMap, BTreeSet};

use fenderline_keys::csv::Csv;
use fenderline_keys::error::ScenarioError;
use fenderline_keys::printable::printable_number;

type Read<T> = Result<T, ScenarioError>;

/// A curve's points of deflection (m) and reaction (N), with rising deflections.
pub type Branch = Vec<(f64, f64)>;

/// The loading curve of a fender at one speed and temperature, with its unloading curve.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadingCurve {
    /// Speed of compression (m/s), if the file has speeds.
    pub speed_mps: Option<f64>,
    /// Temperature (°C), if the file has temperatures.
    pub temperature_c: Option<f64>,
    /// From (0, 0).
    pub loading: Branch,
    /// Unloading curve from (0, 0) to the deflection where unloading began, nowhere above `loading`; empty if the file
    /// has no unloading rows.
    pub unloading: Branch,
}

/// All curves of a file of a fender's measured curves, in the order of their first rows.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderCurves {
    pub(super) curves: Vec<LoadingCurve>,
}

/// The numbers that 100 % means in a catalogue's curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CatalogueScale {
    /// Height of the fender (m), to which `deflection_percent` refers.
    pub height_m: Option<f64>,
    /// Rated reaction (N), to which `reaction_percent` refers.
    pub rated_reaction_n: Option<f64>,
}

/// Columns of a file of a fender's curves, which has one column of deflection, one of reaction, and any of the other
/// columns.
const COLUMNS: [&str; 9] = [
    "deflection_m",
    "deflection_mm",
    "deflection_percent",
    "reaction_n",
    "reaction_kn",
    "reaction_percent",
    "unloading",
    "speed_mps",
    "temperature_c",
];

/// The key that error messages name for a file of curves.
const KEY: &str = "curves";
/// Least number of rows of a curve, not counting zero deflection.
const FEWEST: usize = 3;
const LARGEST_DEFLECTION_M: f64 = 100.0;
const LARGEST_REACTION_N: f64 = 1e9;

/// Rows of a file that have the same speed, temperature and branch (loading or unloading).
struct Group {
    speed_mps: Option<f64>,
    temperature_c: Option<f64>,
    is_unloading: bool,
    /// Deflection (m), reaction (N) and index of each row in the file.
    rows: Vec<(f64, f64, usize)>,
}

impl LoadingCurve {
    /// Name of the curve in messages, with its speed and temperature.
    pub(super) fn name(&self) -> String {
        let mut name = "the loading curve".to_owned();
        if let Some(speed_mps) = self.speed_mps {
            let _ = write!(name, " at {speed_mps} m/s");
        }
        if let Some(temperature_c) = self.temperature_c {
            let _ = write!(name, " at {temperature_c} °C");
        }
        name
    }
}

impl FenderCurves {
    /// Reads the curves from the text of a file; messages call the file `name`.
    ///
    /// The first line names the columns: `deflection_m`, `deflection_mm` or `deflection_percent` (of the height);
    /// `reaction_n`, `reaction_kn` or `reaction_percent` (of the rated reaction); and optionally `unloading` (0 for
    /// loading, 1 for unloading), `speed_mps`, `temperature_c`. `scale` is used for columns of percentages only.
    ///
    /// # Errors
    /// Refuses unknown or missing columns, percentages whose scale is not given, a cell that is not a number, a
    /// negative deflection or reaction, two rows at one deflection, loading rows whose deflection does not rise, and a
    /// reaction at zero deflection. Refuses a loading curve of fewer than three rows, and an unloading curve that has
    /// no loading curve, goes beyond or above its loading curve, or returns no energy.
    pub fn parse(text: &str, name: &str, scale: CatalogueScale) -> Read<FenderCurves> {
        let csv = Csv::parse(text, name, KEY, &COLUMNS)?;
        let groups = groups(&csv, scale)?;
        let (unloading, loading): (Vec<Group>, Vec<Group>) =
            groups.into_iter().partition(|group| group.is_unloading);
        if loading.is_empty() {
            return Err(
                csv.header_error("the file has no loading curve: `unloading` is 1 everywhere")
            );
        }
        let mut curves = loading
            .into_iter()
            .map(|group| loading_curve(&csv, group))
            .collect::<Read<Vec<LoadingCurve>>>()?;
        for group in unloading {
            add_unloading(&csv, group, &mut curves)?;
        }
        Ok(FenderCurves { curves })
    }

    /// The loading curves of the fender, in the order of the file.
    #[must_use]
    pub fn curves(&self) -> &[LoadingCurve] {
        &self.curves
    }
}

/// Name of a column for one quantity, and the column's factor to SI; `None` if that factor is not given.
type ColumnUnit = (&'static str, Option<f64>);

/// Index of the one column among alternatives such as metres or millimetres that the file has, and the column's factor
/// to SI.
fn one_of(csv: &Csv<'_>, units: [ColumnUnit; 3], to_scale: &str) -> Read<(usize, f64)> {
    let mut given = units.iter().filter(|(name, _)| csv.has(name));
    let (first, second) = (given.next(), given.next());
    match (first, second) {
        (Some((name, _)), Some((other, _))) => {
            let message = format!("the columns `{name}` and `{other}` give the same quantity");
            Err(csv.header_error(message).with_help("give one of them"))
        }
        (Some((name, Some(factor))), None) => Ok((csv.column(name)?, *factor)),
        (Some((name, None)), None) => {
            let message = format!(
                "the column `{name}` is in per cent, but the number for 100 % is not given"
            );
            Err(csv.header_error(message).with_help(to_scale))
        }
        (None, _) => {
            let names = units.map(|(name, _)| format!("`{name}`"));
            let message = format!("the column {} is missing", names.join(" or "));
            Err(csv.header_error(message))
        }
    }
}

/// Sorts the rows of the file into groups by branch (loading or unloading), speed and temperature.
fn groups(csv: &Csv<'_>, scale: CatalogueScale) -> Read<Vec<Group>> {
    let hundredth = |whole: Option<f64>| whole.map(|whole| whole / 100.0);
    let deflections = [
        ("deflection_m", Some(1.0)),
        ("deflection_mm", Some(1e-3)),
        ("deflection_percent", hundredth(scale.height_m)),
    ];
    let reactions = [
        ("reaction_n", Some(1.0)),
        ("reaction_kn", Some(1e3)),
        ("reaction_percent", hundredth(scale.rated_reaction_n)),
    ];
    let (deflection, to_m) =
        one_of(csv, deflections, "give the fender's height, as in --height \"1.2 m\"")?;
    let (reaction, to_n) = one_of(
        csv,
        reactions,
        "give the fender's rated reaction, as in --rated-reaction \"585 kN\"",
    )?;
    let optional = |name: &str| csv.has(name).then(|| csv.column(name)).transpose();
    let (unloading, speed, temperature) =
        (optional("unloading")?, optional("speed_mps")?, optional("temperature_c")?);
    let mut groups: Vec<Group> = Vec::new();
    // Index of each group by branch, speed and temperature, and the deflections that each group has. Numbers are
    // compared by their bits: no cell is -0.
    let mut places: BTreeMap<(bool, Option<u64>, Option<u64>), usize> = BTreeMap::new();
    let mut seen: BTreeSet<(usize, u64)> = BTreeSet::new();
    for row in 0..csv.row_count() {
        let deflection_m =
            to_m * csv.number(row, deflection, [0.0, LARGEST_DEFLECTION_M / to_m])?;
        let reaction_n = to_n * csv.number(row, reaction, [0.0, LARGEST_REACTION_N / to_n])?;
        if deflection_m == 0.0 && reaction_n != 0.0 {
            let message = format!(
                "a reaction of {} kN at zero deflection",
                printable_number(reaction_n / 1e3)
            );
            return Err(csv.cell_error(row, reaction, message));
        }
        let is_unloading =
            match unloading.map(|column| (column, csv.number(row, column, [0.0, 1.0]))) {
                None => false,
                Some((_, Err(error))) => return Err(error),
                Some((_, Ok(0.0))) => false,
                Some((_, Ok(1.0))) => true,
                Some((column, Ok(other))) => {
                    let message = format!("`unloading` is 0 or 1, not {}", printable_number(other));
                    return Err(csv.cell_error(row, column, message));
                }
            };
        let speed_mps = speed.map(|column| csv.number(row, column, [1e-6, 100.0])).transpose()?;
        let temperature_c =
            temperature.map(|column| csv.number(row, column, [-100.0, 200.0])).transpose()?;
        let bits = |number: Option<f64>| number.map(f64::to_bits);
        let key = (is_unloading, bits(speed_mps), bits(temperature_c));
        let place = *places.entry(key).or_insert(groups.len());
        if place == groups.len() {
            groups.push(Group { speed_mps, temperature_c, is_unloading, rows: Vec::new() });
        }
        let rows = &mut groups[place].rows;
        if !seen.insert((place, deflection_m.to_bits())) {
            let branch = if is_unloading { "unloading" } else { "loading" };
            let message =
                format!("the file has two {branch} reactions at a deflection of {deflection_m} m");
            return Err(csv.cell_error(row, deflection, message));
        }
        if let Some((before_m, _, _)) = rows.last().filter(|_| !is_unloading)
            && *before_m > deflection_m
        {
            let message = format!(
                "the deflection falls from {before_m} m to {deflection_m} m in rows of loading"
            );
            let error = csv.cell_error(row, deflection, message);
            return Err(
                error.with_help("mark the rows of unloading with 1 in a column `unloading`")
            );
        }
        rows.push((deflection_m, reaction_n, row));
    }
    Ok(groups)
}

/// A curve sorted by deflection, with (0, 0) added if the file does not have this point.
fn from_origin(rows: &[(f64, f64, usize)]) -> Branch {
    let mut branch: Branch = rows.iter().map(|(d, r, _)| (*d, *r)).collect();
    branch.sort_by(|one, other| one.0.total_cmp(&other.0));
    if branch.first().is_none_or(|first| first.0 > 0.0) {
        branch.insert(0, (0.0, 0.0));
    }
    branch
}

fn loading_curve(csv: &Csv<'_>, group: Group) -> Read<LoadingCurve> {
    let loading = from_origin(&group.rows);
    if loading.len() <= FEWEST {
        let (_, _, row) = group.rows[group.rows.len() - 1];
        let message = format!(
            "the loading curve has {} rows beyond zero deflection, but needs at least {FEWEST}",
            loading.len() - 1
        );
        return Err(csv.cell_error(row, 0, message));
    }
    Ok(LoadingCurve {
        speed_mps: group.speed_mps,
        temperature_c: group.temperature_c,
        loading,
        unloading: Vec::new(),
    })
}

fn add_unloading(csv: &Csv<'_>, group: Group, curves: &mut [LoadingCurve]) -> Read<()> {
    let first_row = group.rows[0].2;
    let loading = curves.iter_mut().find(|curve| {
        curve.speed_mps == group.speed_mps && curve.temperature_c == group.temperature_c
    });
    let Some(curve) = loading else {
        let message =
            "there is no loading curve at the speed and temperature of this unloading curve";
        return Err(csv.cell_error(first_row, 0, message.to_owned()));
    };
    for (deflection_m, reaction_n, row) in &group.rows {
        let Some(bound_n) = value(&curve.loading, *deflection_m) else {
            let end_m = curve.loading.last().map_or(0.0, |last| last.0);
            let message = format!(
                "the unloading curve begins at {deflection_m} m, but the loading curve ends at {end_m} m"
            );
            return Err(csv.cell_error(*row, 0, message));
        };
        if *reaction_n > bound_n * (1.0 + 1e-9) {
            let message = format!(
                "the unloading reaction of {} kN is above the loading reaction of {} kN at {deflection_m} m",
                reaction_n / 1e3,
                bound_n / 1e3
            );
            return Err(csv.cell_error(*row, 0, message));
        }
    }
    let unloading = from_origin(&group.rows);
    if unloading.len() <= FEWEST {
        let message =
            format!("the unloading curve has fewer than {FEWEST} rows beyond zero deflection");
        return Err(csv.cell_error(first_row, 0, message));
    }
    let end_m = unloading[unloading.len() - 1].0;
    let share = integral(&unloading, end_m) / integral(&curve.loading, end_m);
    if !(share > 0.0 && share <= 1.0) {
        let message =
            format!("the unloading curve returns {share} times the energy of the loading curve");
        return Err(csv
            .cell_error(first_row, 0, message)
            .with_help("the returned share of the energy must be above 0 and at most 1"));
    }
    curve.unloading = unloading;
    Ok(())
}

/// The deflection at which a branch ends; 0 for an empty branch.
pub(super) fn end(branch: &Branch) -> f64 {
    branch.last().map_or(0.0, |last| last.0)
}

/// The value at `x` of a piecewise linear curve; `None` where the curve does not reach `x`.
pub(super) fn value(points: &[(f64, f64)], x: f64) -> Option<f64> {
    fenderline_scenario::curve_value(points, x)
}

/// The integral of a curve from its start to `x`, which lies within the curve.
pub(super) fn integral(points: &[(f64, f64)], x: f64) -> f64 {
    fenderline_scenario::curve_integral(points, x)
}

#[cfg(test)]
mod tests {
    use super::{CatalogueScale, FenderCurves};

    fn refused(text: &str) -> String {
        FenderCurves::parse(text, "bench.csv", CatalogueScale::default())
            .expect_err(text)
            .to_string()
    }

    const HEAD: &str = "deflection_mm,reaction_kn,unloading\n";

    #[test]
    fn millimetres_and_kilonewtons_become_si_and_the_origin_is_added() {
        let text = format!("{HEAD}100,10,0\n200,30,0\n300,60,0\n300,60,1\n200,20,1\n100,5,1\n");
        let curves = FenderCurves::parse(&text, "bench.csv", CatalogueScale::default()).unwrap();
        let [curve] = curves.curves() else { panic!("{curves:?}") };
        let near = |(d, r): (f64, f64), (e, s): (f64, f64)| (d - e).abs() < 1e-12 && r == s;
        let loading = [(0.0, 0.0), (0.1, 10e3), (0.2, 30e3), (0.3, 60e3)];
        let unloading = [(0.0, 0.0), (0.1, 5e3), (0.2, 20e3), (0.3, 60e3)];
        assert!(curve.loading.iter().zip(loading).all(|(a, b)| near(*a, b)), "{curve:?}");
        assert!(curve.unloading.iter().zip(unloading).all(|(a, b)| near(*a, b)), "{curve:?}");
    }

    #[test]
    fn percentages_are_of_height_and_rated_reaction() {
        let text = "deflection_percent,reaction_percent\n5,20\n35,100\n72,100\n";
        let scale = CatalogueScale { height_m: Some(1.2), rated_reaction_n: Some(500e3) };
        let curves = FenderCurves::parse(text, "page.csv", scale).unwrap();
        let loading = &curves.curves()[0].loading;
        let expected = [(0.0, 0.0), (0.06, 100e3), (0.42, 500e3), (0.864, 500e3)];
        let near = |(a, b): (&(f64, f64), (f64, f64))| {
            (a.0 - b.0).abs() < 1e-12 && (a.1 - b.1).abs() < 1e-6
        };
        assert!(loading.len() == 4 && loading.iter().zip(expected).all(near), "{loading:?}");
        for (scale, fragment) in [
            (CatalogueScale { height_m: None, ..scale }, "--height"),
            (CatalogueScale { rated_reaction_n: None, ..scale }, "--rated-reaction"),
        ] {
            let error = FenderCurves::parse(text, "page.csv", scale).unwrap_err().to_string();
            assert!(error.contains("the number for 100 % is not given"), "{error}");
            assert!(error.contains(fragment) && error.contains("page.csv:1"), "{error}");
        }
    }

    #[test]
    fn each_mistake_is_reported_at_its_line() {
        let good = "100,10,0\n200,30,0\n300,60,0\n";
        for (text, fragments) in [
            (
                "deflection_m,reaction\n1,2\n".to_owned(),
                ["\"reaction\" is not a column", "bench.csv:1:14", "reaction_n"],
            ),
            (
                "deflection_m\n1\n".to_owned(),
                [
                    "`reaction_n` or `reaction_kn` or `reaction_percent` is missing",
                    "bench.csv:1",
                    "",
                ],
            ),
            (
                "deflection_m,deflection_mm,reaction_n\n1,1,1\n".to_owned(),
                ["give the same quantity", "bench.csv:1", "one of them"],
            ),
            (
                format!("{HEAD}100,10,0\n200,-3,0\n"),
                ["`reaction_kn` must be between 0", "bench.csv:3:5", "-3"],
            ),
            (
                format!("{HEAD}-100,10,0\n"),
                ["`deflection_mm` must be between 0", "bench.csv:2:1", "-100"],
            ),
            (
                format!("{HEAD}100,10,0\n100,12,0\n"),
                [
                    "the file has two loading reactions at a deflection of 0.1 m",
                    "bench.csv:3:1",
                    "",
                ],
            ),
            (
                format!("{HEAD}100,10,0\n90,12,0\n"),
                ["falls from 0.1 m to 0.09 m", "bench.csv:3:1", "column `unloading`"],
            ),
            (format!("{HEAD}0,10,0\n"), ["at zero deflection", "bench.csv:2:3", ""]),
            (
                format!("{HEAD}100,10,0\n200,30,0\n"),
                ["2 rows beyond zero deflection", "bench.csv:3:1", "at least 3"],
            ),
            (
                format!("{HEAD}{good}200,31,1\n"),
                ["31 kN is above the loading reaction of 30 kN", "bench.csv:5:1", ""],
            ),
            (format!("{HEAD}{good}400,31,1\n"), ["ends at 0.3 m", "bench.csv:5:1", ""]),
            (
                format!("{HEAD}{good}300,0,1\n200,0,1\n100,0,1\n"),
                ["returns 0 times the energy", "bench.csv:5:1", "above 0"],
            ),
            (
                format!("{HEAD}{good}100,5,2\n"),
                ["`unloading` must be between 0 and 1", "bench.csv:5:7", "2"],
            ),
            (format!("{HEAD}{good}100,5,0.5\n"), ["`unloading` is 0 or 1", "bench.csv:5:7", ""]),
            (format!("{HEAD}100,5,1\n"), ["no loading curve", "bench.csv:1", ""]),
            (
                "deflection_m,reaction_n,speed_mps\n0.1,5,0\n".to_owned(),
                ["`speed_mps` must be between", "bench.csv:2:7", ""],
            ),
        ] {
            let message = refused(&text);
            assert!(
                fragments.iter().all(|fragment| message.contains(fragment)),
                "{message}\nfor {text}"
            );
        }
    }
}
