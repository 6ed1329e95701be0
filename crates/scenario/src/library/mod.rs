//! The library of fenders: families with their curves and sizes, read from files of the form that `fenders/README.md`
//! shows.

mod curve;
mod family;
mod fender;
pub(crate) mod keys;
mod look_up;
mod read;

use std::collections::BTreeMap;
use std::sync::OnceLock;

use fenderline_sim::hydro::vessels::Standing;

pub use curve::{integral as curve_integral, value as curve_value};
pub use family::{FactorTable, Family, FamilyUnloading, FenderSize, HullPressureLimit, Tolerance};
pub use fender::CatalogueFender;
pub(crate) use keys::FENDER_FILE;
pub use look_up::LookUpError;
pub(crate) use read::unloading_curve;

use crate::data_files::FENDER_FILES;
use crate::library::keys::FenderFileKey;
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::Sources;
use fenderline_keys::{reader, syntax};

/// The library of fenders: families of fenders, and hull pressure limits.
///
/// ```
/// use fenderline_scenario::FenderLibrary;
///
/// let library = FenderLibrary::built_in();
/// let fender = library.fender("pneumatic", "3300x6500 50kPa")?;
/// assert_eq!(fender.rated_reaction_n, 3015e3);
/// // The integral of the reaction, not the published 1814 kJ.
/// assert!((fender.rated_energy_j - 1980e3).abs() < 1e3);
///
/// // No table of cone sizes was found. With your own rating the curve can be used.
/// let cone = library.rated("cone", 1.2, 900e3)?;
/// assert_eq!(cone.rated_deflection_m, 0.72 * 1.2);
///
/// let error = library.fender("pneumatc", "3300x6500 50kPa").unwrap_err();
/// assert_eq!(error.help(), "did you mean \"pneumatic\"?");
/// # Ok::<(), fenderline_scenario::LookUpError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FenderLibrary {
    families: Vec<Family>,
    hull_pressures: Vec<HullPressureLimit>,
    places: Places,
}

/// Index of each name in the lists of a library.
#[derive(Clone, Debug, Default, PartialEq)]
struct Places {
    families: BTreeMap<String, usize>,
    /// For each family, the index of each size by its designation.
    sizes: Vec<BTreeMap<String, usize>>,
    hull_pressures: BTreeMap<String, usize>,
}

impl FenderLibrary {
    /// The built-in fender files.
    #[must_use]
    pub fn built_in() -> FenderLibrary {
        FenderLibrary::of_program().clone()
    }

    /// The library of the built-in fender files, shared by the whole program.
    #[must_use]
    pub fn of_program() -> &'static FenderLibrary {
        // Read once: a batch checks thousands of scenarios.
        static READ: OnceLock<FenderLibrary> = OnceLock::new();
        let read = || {
            let empty = FenderLibrary::default();
            FENDER_FILES.iter().fold(empty, |library, (name, text)| {
                library.with_file(text, name).expect("the built-in fender files have no mistakes")
            })
        };
        READ.get_or_init(read)
    }

    /// Adds a user's file to the library: new families, sizes of known families, and hull pressure limits. `name` is
    /// the file's name for messages.
    ///
    /// # Errors
    /// Returns the first mistake found: first mistakes of TOML syntax, then unknown keys and bad values in the order of
    /// the file, then keys that contradict each other and names that exist already.
    pub fn with_file(mut self, text: &str, name: &str) -> Result<FenderLibrary, ScenarioError> {
        let sources = Sources::new(name, text, &[]);
        let document = syntax::parse(&sources)?;
        let end = text.trim_end().len();
        let file = reader::table(&sources, &FENDER_FILE, "", end..end, &document)?;
        let (families, limits) = (
            file.of::<FenderFileKey>().given(FenderFileKey::FAMILY).named(),
            file.of::<FenderFileKey>().given(FenderFileKey::HULL_PRESSURE).named(),
        );
        if families.is_empty() && limits.is_empty() {
            let error =
                sources.file_error("the file has neither families nor hull pressure limits");
            return Err(error.with_help("write [family.NAME] with the keys of the family below"));
        }
        read::families(&sources, families, &mut self)?;
        read::hull_pressures(&sources, limits, &mut self)?;
        Ok(self)
    }

    /// All families of the library, in the order in which they were added.
    #[must_use]
    pub fn families(&self) -> &[Family] {
        &self.families
    }

    /// All hull pressure limits of the library, in the order in which they were added.
    #[must_use]
    pub fn hull_pressure_limits(&self) -> &[HullPressureLimit] {
        &self.hull_pressures
    }

    /// The family of fenders with the name `name`.
    ///
    /// # Errors
    /// Fails if the library has no family of this name.
    pub fn family(&self, name: &str) -> Result<&Family, LookUpError> {
        Ok(&self.families[self.family_place(name)?])
    }

    fn family_place(&self, name: &str) -> Result<usize, LookUpError> {
        self.places.families.get(name).copied().ok_or_else(|| {
            let known = self.families.iter().map(|family| family.name.as_str());
            LookUpError::unknown("family of fenders".to_owned(), name, known)
        })
    }

    /// The fender of a family with the size `designation`.
    ///
    /// # Errors
    /// Fails if the library has no family of this name, or the family has no size of this name.
    pub fn fender(&self, family: &str, designation: &str) -> Result<CatalogueFender, LookUpError> {
        let place = self.family_place(family)?;
        let (family, sizes) = (&self.families[place], &self.places.sizes[place]);
        let size = sizes.get(designation).map(|place| &family.sizes[*place]);
        let size = size.ok_or_else(|| {
            let known = family.sizes.iter().map(|size| size.designation.as_str());
            LookUpError::unknown(format!("size of {} fenders", family.name), designation, known)
        })?;
        Ok(CatalogueFender::new(family, size))
    }

    /// A fender of a height that the catalogue does not have, scaled from the family's reference size. Lengths scale
    /// with the height, the reaction with the square of the height, and so the energy with the cube of the height. The
    /// standing of a scaled fender is `Derived` at best.
    ///
    /// # Errors
    /// Fails if there is no such family, if the family has no reference size, or if the height is out of range.
    pub fn scaled(&self, family: &str, height_m: f64) -> Result<CatalogueFender, LookUpError> {
        let family = self.family(family)?;
        let Some(reference) = family.reference else {
            return Err(LookUpError::NoReference { family: family.name.clone() });
        };
        let size = fender::scaled(&family.sizes[reference], checked_height_m(height_m)?);
        checked_reaction_n(size.rated_reaction_n)?;
        Ok(CatalogueFender::new(family, &size))
    }

    /// A fender with the curve of a family, and with the height and rated reaction that the user gives.
    ///
    /// # Errors
    /// Fails if there is no such family, or if the height (m) or the rated reaction (N) is out of range.
    pub fn rated(
        &self,
        family: &str,
        height_m: f64,
        rated_reaction_n: f64,
    ) -> Result<CatalogueFender, LookUpError> {
        let family = self.family(family)?;
        let size = FenderSize {
            designation: format!("{height_m} m, {} kN", rated_reaction_n / 1e3),
            height_m: checked_height_m(height_m)?,
            length_m: None,
            rated_reaction_n: checked_reaction_n(rated_reaction_n)?,
            published_energy_j: None,
            hull_pressure_npm2: None,
            initial_pressure_npm2: None,
            source: "the user".to_owned(),
            standing: Standing::Found,
        };
        Ok(CatalogueFender::new(family, &size))
    }

    /// The hull pressure that the side of a type of ship can bear.
    ///
    /// # Errors
    /// Fails if the library has no limit for this type of ship.
    pub fn hull_pressure_limit(&self, ship: &str) -> Result<&HullPressureLimit, LookUpError> {
        let place = self.places.hull_pressures.get(ship);
        place.map(|place| &self.hull_pressures[*place]).ok_or_else(|| {
            let known = self.hull_pressures.iter().map(|limit| limit.ship.as_str());
            LookUpError::unknown("type of ship".to_owned(), ship, known)
        })
    }
}

/// Checks a height within the same bounds as for a size in a file; NaN is out of bounds.
fn checked_height_m(value: f64) -> Result<f64, LookUpError> {
    let good = (1e-3..=100.0).contains(&value);
    good.then_some(value).ok_or(LookUpError::OutOfRange { quantity: "height [m]", value })
}

fn checked_reaction_n(value: f64) -> Result<f64, LookUpError> {
    let good = (1.0..=1e9).contains(&value);
    good.then_some(value).ok_or(LookUpError::OutOfRange { quantity: "rated reaction [N]", value })
}
