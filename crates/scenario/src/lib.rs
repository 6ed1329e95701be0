//! Reads scenario files: turns TOML with units into the checked set-up of a simulation.
//!
//! This crate is the only crate that knows what a scenario file looks like. In a scenario file a plain number is in SI
//! units (angles in radians); a number with another unit is a string, as `"4 kn"`. Every mistake is one
//! [`ScenarioError`] that points at file, line and key; corrections and unusual values are reported as [`Notice`]s.
//!
//! A scenario takes this path through the code: `syntax` parses the text into a TOML tree, `overrides` applies the keys
//! of the command line, `reader` checks every key against the declarations in `keys`, and `assemble` builds the set-up
//! and checks the rules between keys. `schema` makes a JSON Schema from the same declarations of the keys.
//!
//! `library` reads fender files in the same way and looks up catalogue fenders; `vessels` reads vessel files and looks
//! up vessels.
//!
//! ```
//! use fenderline_scenario::{Override, Scenario};
//!
//! let text = r#"
//!     title = "Tug against a quay"
//!
//!     [time]
//!     step = "0.1 s"
//!     duration = "20 s"
//!
//!     [material.rubber]
//!     stiffness = "500 kN/m^2"
//!     restitution = 0.1
//!
//!     [body.tug]
//!     outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]
//!     mass = "930 t"
//!     gyradius = "8 m"
//!     velocity = { surge = "4 kn" }
//!
//!     [body.quay]
//!     fixed = true
//!     outline = [[0, -50], [5, -50], [5, 50], [0, 50]]
//!     position = [20, 0]
//!
//!     [[pair]]
//!     bodies = ["tug", "quay"]
//!     material = "rubber"
//! "#;
//! let scenario = Scenario::parse(text, "tug.toml")?;
//! assert_eq!(scenario.setup.bodies[0].velocity.surge_mps, 4.0 * 1852.0 / 3600.0);
//!
//! let longer_step = [Override::parse("time.step=0.5 s")?];
//! let scenario = Scenario::parse_with(text, "tug.toml", &longer_step)?;
//! assert_eq!(scenario.setup.step_s, 0.5);
//!
//! let error = Scenario::parse(&text.replace("500 kN/m^2", "4 kn"), "tug.toml").unwrap_err();
//! assert_eq!(error.line(), Some(9));
//! assert_eq!(error.key(), Some("material.rubber.stiffness"));
//! # Ok::<(), fenderline_scenario::ScenarioError>(())
//! ```

mod assemble;
mod data_files;
mod files;
mod hydrodynamics;
mod library;
mod load;
mod model;
mod order;
mod scenario;
mod schema;
mod variant;
mod vessels;

pub use fenderline_keys::bounded_file::{
    FileError, FileFault, irregular, open_regular, read_bytes, read_text_of, without_following,
};
pub use fenderline_keys::error::{Notice, Place, ScenarioError};
pub use fenderline_keys::option_value::{
    LengthOrShare, force_n, in_unit, length_m, length_or_share, percent,
};
pub use fenderline_keys::origin::Origin;
pub use fenderline_keys::overrides::{Override, set_keys};
pub use fenderline_keys::printable::{
    escaped_json, printable_line, printable_number, printable_text,
};
pub use fenderline_keys::suggest::nearest;
pub use fenderline_sim::hydro::vessels::Standing;
pub use library::{
    CatalogueFender, FactorTable, Family, FamilyUnloading, FenderLibrary, FenderSize,
    HullPressureLimit, LookUpError, Tolerance, curve_integral, curve_value,
};
pub use load::{LoadError, read_stream, read_text};
pub use order::order;
pub use scenario::Scenario;
pub use schema::{fender_schema, schema, vessel_schema};
pub use vessels::{Belting, DeckPoint, Shaft, Stability, VesselData, VesselLibrary};
