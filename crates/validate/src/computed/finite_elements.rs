//! Compares fenders that were fitted to finite-element curves: reaction and energy of the fitted curve, and of the one
//! stiffness that takes the same rated energy. The fender files are made by `validation/finite_elements/analyse.py`.

use fenderline_contact::number::lesser;
use fenderline_scenario::FenderLibrary;

use super::Values;

/// The names and the texts of the fender files; rows of the validation table use these names.
macro_rules! fenders {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!(env!("FENDERLINE_DATA"), "/validation/finite_elements/fenders/", $name, ".toml"
        )))),*]
    };
}

/// Table of the finite-element analysis: shape, fineness, elements, deflection, reaction and energy of every step on
/// every mesh.
const PRESSED: &str = include_str!(concat!(
    env!("FENDERLINE_DATA"),
    "/validation/finite_elements/results/pressed.csv"
));

/// Fender shapes that were analysed on more than one mesh.
const HALVED: [&str; 3] = ["cylinder", "solid_d", "hollow_d"];

const FENDERS: [(&str, &str); 4] = fenders!["cylinder", "solid_d", "hollow_d", "cone"];

pub(super) fn compute(values: &mut Values) {
    for shape in HALVED {
        let (reaction, energy) = last_but_finest(shape);
        values.put(format!("finite_elements/{shape}/mesh/reaction"), reaction, "");
        values.put(format!("finite_elements/{shape}/mesh/energy"), energy, "");
    }
    for (name, text) in FENDERS {
        let before = FenderLibrary::built_in().families().len();
        let library = FenderLibrary::built_in()
            .with_file(text, name)
            .unwrap_or_else(|e| panic!("the fender file of {name} is wrong: {e}"));
        let family = &library.families()[before];
        let fender = library
            .fender(&family.name, &family.sizes[0].designation)
            .expect("the fender family has the size with which it was read");
        let rated_m = fender.rated_deflection_m;
        let stiffness_npm = 2.0 * fender.rated_energy_j / (rated_m * rated_m);
        for share in ["0.5", "1.0"] {
            let deflection_m = share.parse::<f64>().expect("a number") * rated_m;
            let (reaction_n, energy_j) = on_curve(&fender.curve, deflection_m);
            let name =
                |law: &str, what: &str| format!("finite_elements/{name}/{law}/{what} at {share}");
            values.put(name("curve", "reaction"), reaction_n / 1e3, "kN");
            values.put(name("curve", "energy"), energy_j / 1e3, "kJ");
            values.put(name("linear", "reaction"), stiffness_npm * deflection_m / 1e3, "kN");
        }
    }
}

/// Reaction and energy of a fender at the largest deflection, on the mesh before the finest one.
fn last_but_finest(shape: &str) -> (f64, f64) {
    let of_shape = PRESSED.lines().filter_map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        (cells[0] == shape).then(|| {
            let number = |index: usize| -> f64 { cells[index].parse().expect("a number") };
            (number(1), number(4), number(5))
        })
    });
    // Steps stand in their order, meshes from coarse to fine: the last row of each mesh remains.
    let mut ends: Vec<(f64, f64, f64)> = Vec::new();
    for row in of_shape {
        match ends.last_mut() {
            Some(end) if end.0 == row.0 => *end = row,
            _ => ends.push(row),
        }
    }
    let (_, reaction, energy) = ends[ends.len() - 2];
    (reaction, energy)
}

/// Reaction (N) and energy (J) of a fender at a deflection (m) on a curve of straight pieces.
fn on_curve(curve: &[(f64, f64)], deflection_m: f64) -> (f64, f64) {
    let (mut reaction_n, mut energy_j) = (0.0, 0.0);
    for piece in curve.windows(2) {
        let ((from_m, from_n), (to_m, to_n)) = (piece[0], piece[1]);
        if deflection_m <= from_m {
            break;
        }
        let end_m = lesser(deflection_m, to_m);
        reaction_n = from_n + (to_n - from_n) * (end_m - from_m) / (to_m - from_m);
        energy_j += 0.5 * (from_n + reaction_n) * (end_m - from_m);
    }
    (reaction_n, energy_j)
}
