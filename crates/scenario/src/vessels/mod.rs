//! The library of vessels: particulars, outline, coefficients, machinery and deck of each vessel, read from files of
//! the form that `vessels/README.md` shows.

mod data;
mod figures;
pub(crate) mod keys;
mod provenance;
mod read;
mod shape;

use std::collections::BTreeMap;
use std::sync::OnceLock;

pub use data::{Belting, DeckPoint, Shaft, Stability, VesselData};
pub(crate) use keys::VESSEL_FILE;
pub(crate) use read::{hydrostatics, own_vessel};

use crate::data_files::VESSEL_FILES;
use crate::library::LookUpError;
use crate::vessels::keys::VesselFileKey;
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::{Sources, quoted};
use fenderline_keys::{reader, syntax};

/// The library of vessels, by name.
///
/// ```
/// use fenderline_scenario::VesselLibrary;
///
/// let library = VesselLibrary::built_in();
/// let kcs = library.vessel("kcs")?;
/// assert_eq!(kcs.ship.particulars.length_m, 230.0);
/// // Her low-speed hull was never published: it is estimated, and listed as an estimate.
/// assert!(kcs.origin.estimates().any(|source| source.group == "hull at low speed"));
///
/// let error = library.vessel("kc").unwrap_err();
/// assert_eq!(error.help(), "did you mean \"kcs\"?");
/// # Ok::<(), fenderline_scenario::LookUpError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VesselLibrary {
    vessels: Vec<VesselData>,
    /// Index of each vessel by its name.
    places: BTreeMap<String, usize>,
}

impl VesselLibrary {
    /// Names and texts of the built-in vessel files.
    #[must_use]
    pub fn built_in_files() -> &'static [(&'static str, &'static str)] {
        &VESSEL_FILES
    }

    /// The vessels of the built-in vessel files.
    #[must_use]
    pub fn built_in() -> VesselLibrary {
        VesselLibrary::of_program().clone()
    }

    /// The library of the built-in vessel files, shared by the whole program.
    #[must_use]
    pub fn of_program() -> &'static VesselLibrary {
        // Read once: a batch checks thousands of scenarios.
        static READ: OnceLock<VesselLibrary> = OnceLock::new();
        let read = || {
            let empty = VesselLibrary::default();
            VESSEL_FILES.iter().fold(empty, |library, (name, text)| {
                let read = library.with_file(text, name);
                read.unwrap_or_else(|error| panic!("vessels/{name}: {error}"))
            })
        };
        READ.get_or_init(read)
    }

    /// Adds a user's file to the library of vessels. `name` is the file's name for messages.
    ///
    /// # Errors
    /// Returns the first mistake found: first text that is not TOML, then unknown keys and bad values in the order of
    /// the file, then impossible particulars, numbers without a source, and names that exist already.
    pub fn with_file(mut self, text: &str, name: &str) -> Result<VesselLibrary, ScenarioError> {
        let sources = Sources::new(name, text, &[]);
        let document = syntax::parse(&sources)?;
        let end = text.trim_end().len();
        let file = reader::table(&sources, &VESSEL_FILE, "", end..end, &document)?;
        for (name, table) in file.of::<VesselFileKey>().given(VesselFileKey::VESSEL).named() {
            if self.has(name) {
                let message = format!("there is a vessel named {} already", quoted(name));
                return Err(sources.error(&table.span, &table.path, message));
            }
            let vessel = read::file_vessel(&sources, name, table, &self)?;
            self.places.insert(name.clone(), self.vessels.len());
            self.vessels.push(vessel);
        }
        Ok(self)
    }

    /// Whether the library has a vessel of this name.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.places.contains_key(name)
    }

    /// All vessels of the library, in the order in which they were added.
    #[must_use]
    pub fn vessels(&self) -> &[VesselData] {
        &self.vessels
    }

    /// The vessel with the name `name`.
    ///
    /// # Errors
    /// Fails if the library has no vessel of this name.
    pub fn vessel(&self, name: &str) -> Result<&VesselData, LookUpError> {
        self.places.get(name).map(|place| &self.vessels[*place]).ok_or_else(|| {
            let known = self.vessels.iter().map(|vessel| vessel.name.as_str());
            LookUpError::unknown("vessel".to_owned(), name, known)
        })
    }
}
