//! Reads files of hydrodynamic data, which are several tables of numbers in one text, each below a line `= name`.
//!
//! docs/guides/hydrodynamics.md describes the form of these files. Each table of such a file is read as a separate
//! comma-separated file in which all other lines are empty, so that every error names the right line.

use core::f64::consts::PI;

use fenderline_sim::environment::waves::Complex;
use fenderline_sim::seakeeping::matrix::{Matrix6, ZERO};
use fenderline_sim::seakeeping::{Hydrodynamics, Part, RawHydrodynamics, SeakeepingError};

use fenderline_keys::csv::Csv;
use fenderline_keys::error::{Notice, ScenarioError};
use fenderline_keys::sources::{Sources, quoted};
use fenderline_keys::suggest::nearest;

type Read<T> = Result<T, ScenarioError>;

/// The first line of a file of hydrodynamic data.
const FIRST: &str = "= fenderline hydrodynamic data 1";
/// The tables of a file, in the order in which the code below reads them.
const TABLES: [&str; 5] = ["ship", "radiation", "infinite", "excitation", "drift"];
/// Wide bounds for numbers of the file that [`Hydrodynamics::new`] checks later.
const ANY: [f64; 2] = [-1e18, 1e18];
/// The columns that the table `ship` must have.
const SHIP: [&str; 7] = [
    "mass_kg",
    "gravity_above_water_m",
    "roll_gyradius_m",
    "pitch_gyradius_m",
    "yaw_gyradius_m",
    "water_kgpm3",
    "c33",
];
/// Further columns that the table `ship` may have; their numbers are zero if the columns are missing.
const SHIP_ALSO: [&str; 9] = [
    "reference_forward_m",
    "reference_starboard_m",
    "reference_up_m",
    "depth_m",
    "c34",
    "c35",
    "c44",
    "c45",
    "c55",
];

/// The contents of a file of hydrodynamic data.
#[derive(Clone, Debug)]
pub(crate) struct HydrodynamicFile {
    pub(crate) data: Hydrodynamics,
    pub(crate) gravity_above_water_m: f64,
    /// Warnings about the data, each with its line in the file.
    pub(crate) notices: Vec<Notice>,
}

/// Reads a file of hydrodynamic data. `key` is the key of the scenario that names the file.
///
/// # Errors
/// Returns the first mistake in the file, with its line.
pub(crate) fn read(text: &str, name: &str, key: &str) -> Read<HydrodynamicFile> {
    let sources = Sources::new(name, text, &[]);
    let parts = split(&sources, key)?;
    let table = |index: usize, known: &[String]| {
        let Some(text) = &parts[index] else {
            return Err(sources.file_error(format!("the table `= {}` is missing", TABLES[index])));
        };
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        Csv::parse(text, name, key, &known)
    };
    let pairs: Vec<[usize; 2]> = (0..6).flat_map(|i| (i..6).map(move |j| [i, j])).collect();
    let of_pair = |letter: &str, [i, j]: [usize; 2]| format!("{letter}{}{}", i + 1, j + 1);
    let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();

    let ship = table(0, &owned(&[SHIP.as_slice(), &SHIP_ALSO].concat()))?;
    let mut known = owned(&["omega_radps"]);
    known.extend(pairs.iter().flat_map(|pair| [of_pair("a", *pair), of_pair("b", *pair)]));
    let radiation = table(1, &known)?;
    let known: Vec<String> = pairs.iter().map(|pair| of_pair("a", *pair)).collect();
    let infinite = table(2, &known)?;
    let forces: Vec<String> = (1..=6).flat_map(|k| [format!("re{k}"), format!("im{k}")]).collect();
    let mut known = owned(&["omega_radps", "heading_deg"]);
    known.extend(forces.iter().cloned());
    let excitation = table(3, &known)?;
    let drift = match parts[4] {
        Some(_) => Some(table(4, &owned(&["omega_radps", "heading_deg", "surge", "sway", "yaw"]))?),
        None => None,
    };

    for (csv, name) in [(&ship, "ship"), (&infinite, "infinite")] {
        if csv.row_count() != 1 {
            return Err(csv.header_error(format!("the table `= {name}` must have one row")));
        }
    }
    let needed = |name: &str| ship.number(0, ship.column(name)?, ANY);
    let also = |name: &str| match ship.has(name) {
        true => needed(name),
        false => Ok(0.0),
    };
    let mass_kg = ship.number(0, ship.column("mass_kg")?, [1.0, 1e12])?;
    let water_kgpm3 = ship.number(0, ship.column("water_kgpm3")?, [900.0, 1300.0])?;
    let mut mass = ZERO;
    for (k, row) in mass.iter_mut().take(3).enumerate() {
        row[k] = mass_kg;
    }
    for (k, name) in [(3, "roll_gyradius_m"), (4, "pitch_gyradius_m"), (5, "yaw_gyradius_m")] {
        let gyradius_m = ship.number(0, ship.column(name)?, [0.01, 1000.0])?;
        mass[k][k] = mass_kg * gyradius_m * gyradius_m;
    }
    let restoring = {
        let [c33, c34, c35] = [needed("c33")?, also("c34")?, also("c35")?];
        let [c44, c45, c55] = [needed("c44")?, also("c45")?, needed("c55")?];
        [[c33, c34, c35], [c34, c44, c45], [c35, c45, c55]]
    };

    let symmetric = |csv: &Csv<'_>, row: usize, letter: &str| -> Read<Matrix6> {
        let mut matrix = ZERO;
        for &[i, j] in &pairs {
            let name = of_pair(letter, [i, j]);
            if i == j || csv.has(&name) {
                let value = csv.number(row, csv.column(&name)?, ANY)?;
                (matrix[i][j], matrix[j][i]) = (value, value);
            }
        }
        Ok(matrix)
    };
    let omega = radiation.column("omega_radps")?;
    let grid = radiation.grid(&[omega])?;
    let matrices = |letter: &str| -> Read<Vec<Matrix6>> {
        grid.rows.iter().map(|row| symmetric(&radiation, *row, letter)).collect()
    };

    let waves =
        excitation.grid(&[excitation.column("omega_radps")?, excitation.column("heading_deg")?])?;
    let mut exciting = Vec::with_capacity(waves.rows.len());
    for &row in &waves.rows {
        let mut six = [Complex::default(); 6];
        for (force, names) in six.iter_mut().zip(forces.chunks(2)) {
            let part = |name: &str| excitation.number(row, excitation.column(name)?, ANY);
            *force = Complex::new(part(&names[0])?, part(&names[1])?);
        }
        exciting.push(six);
    }
    let drift_rows = match &drift {
        Some(csv) => {
            let grid = csv.grid(&[csv.column("omega_radps")?, csv.column("heading_deg")?])?;
            if grid.axes != waves.axes {
                return Err(csv.header_error(
                    "the frequencies and headings must be the same as in the table `= excitation`",
                ));
            }
            let columns = [csv.column("surge")?, csv.column("sway")?, csv.column("yaw")?];
            let row_of = |row: &usize| -> Read<[f64; 3]> {
                let [x, y, n] = columns.map(|column| csv.number(*row, column, ANY));
                Ok([x?, y?, n?])
            };
            Some((grid.rows.iter().map(row_of).collect::<Read<Vec<_>>>()?, grid.rows))
        }
        None => None,
    };
    let (drift_forces, drift_order) = drift_rows.unzip();
    let raw = RawHydrodynamics {
        reference_m: [
            also("reference_forward_m")?,
            also("reference_starboard_m")?,
            also("reference_up_m")?,
        ],
        mass,
        restoring,
        frequencies_radps: grid.axes[0].clone(),
        added_mass: matrices("a")?,
        damping: matrices("b")?,
        infinite: symmetric(&infinite, 0, "a")?,
        wave_frequencies_radps: waves.axes[0].clone(),
        headings_rad: waves.axes[1].iter().map(|degrees| degrees / 180.0 * PI).collect(),
        excitation: exciting,
        drift: drift_forces,
        depth_m: match ship.has("depth_m") {
            true => Some(ship.number(0, ship.column("depth_m")?, [0.1, 12_000.0])?),
            false => None,
        },
        water_kgpm3,
    };
    let gravity_above_water_m =
        ship.number(0, ship.column("gravity_above_water_m")?, [-200.0, 200.0])?;
    // Table and row in the file of a message about the data.
    let place = |SeakeepingError { part, row, .. }: &SeakeepingError| {
        let (csv, rows): (&Csv<'_>, &[usize]) = match (part, &drift) {
            (Part::Radiation, _) => (&radiation, &grid.rows),
            (Part::Infinite, _) => (&infinite, &[0]),
            (Part::Drift, Some(csv)) => (csv, drift_order.as_deref().unwrap_or(&[])),
            (Part::Excitation | Part::Drift, _) => (&excitation, &waves.rows),
            (Part::Head, _) => (&ship, &[0]),
        };
        (csv, row.and_then(|row| rows.get(row)).copied())
    };
    let data = Hydrodynamics::new(raw).map_err(|error| match place(&error) {
        (csv, Some(row)) => csv.cell_error(row, 0, error.to_string()),
        (csv, None) => csv.header_error(error.to_string()),
    })?;
    let doubt = |doubt: &SeakeepingError| {
        let (csv, row) = place(doubt);
        let place = csv.place_of(row.map(|row| (row, 0)));
        Notice { place, key: key.to_owned(), message: doubt.to_string() }
    };
    let notices = data.doubts().iter().map(doubt).collect();
    Ok(HydrodynamicFile { data, gravity_above_water_m, notices })
}

/// Splits a file into the texts of its tables; each text has empty lines in place of all other lines of the file.
fn split(sources: &Sources<'_>, key: &str) -> Read<[Option<String>; 5]> {
    let text = sources.text;
    if text.trim_start_matches('\u{feff}').lines().next().map(str::trim_end) != Some(FIRST) {
        let message = format!("the first line of the file must be `{FIRST}`");
        return Err(sources.error(&(0..0), key, message));
    }
    let mut parts: [Option<String>; 5] = Default::default();
    let mut now = None;
    let mut start = 0;
    for (number, line) in text.split_inclusive('\n').enumerate() {
        let span = start..start + line.trim_end().len();
        start += line.len();
        if let Some(name) = line.strip_prefix('=').map(str::trim).filter(|_| number > 0) {
            let Some(index) = TABLES.iter().position(|table| *table == name) else {
                let error =
                    sources.error(&span, key, format!("there is no table {}", quoted(name)));
                return Err(match nearest(name, TABLES.iter().copied()) {
                    Some(near) => error.with_help(format!("did you mean `= {near}`?")),
                    None => error.with_help(format!("there are {}", TABLES.join(", "))),
                });
            };
            if parts[index].is_some() {
                return Err(sources.error(&span, key, format!("a second table `= {name}`")));
            }
            parts[index] = Some("\n".repeat(number));
            now = Some(index);
        }
        let is_own = !line.starts_with('=');
        if let Some(part) = now.and_then(|index| parts[index].as_mut()) {
            part.push_str(if is_own { line } else { "\n" });
        }
    }
    Ok(parts)
}
