//! The JSON Schemas of scenario, fender and vessel files, made from the same declarations of keys that the reader uses.

use fenderline_keys::keys::SCENARIO;
use fenderline_keys::schema::whole_file;
use serde_json::Value as Json;

use crate::library::FENDER_FILE;
use crate::vessels::VESSEL_FILE;

/// The JSON Schema (draft 2020-12) of scenario files, for editors that check and complete TOML.
///
/// The schema has every key of a scenario with its kind, bounds and default. The schema cannot check that units fit and
/// names exist; only the reader of scenario files checks this.
///
/// ```
/// let schema = fenderline_scenario::schema();
/// assert_eq!(schema["properties"]["time"]["required"], serde_json::json!(["step", "duration"]));
/// ```
#[must_use]
pub fn schema() -> Json {
    whole_file(&SCENARIO, "Fenderline scenario")
}

/// The JSON Schema (draft 2020-12) of fender files, which [`crate::FenderLibrary::with_file`] reads.
///
/// ```
/// let schema = fenderline_scenario::fender_schema();
/// assert_eq!(schema["title"], "Fenderline fender data");
/// ```
#[must_use]
pub fn fender_schema() -> Json {
    whole_file(&FENDER_FILE, "Fenderline fender data")
}

/// The JSON Schema (draft 2020-12) of vessel files, which [`crate::VesselLibrary::with_file`] reads.
///
/// ```
/// let schema = fenderline_scenario::vessel_schema();
/// assert_eq!(schema["title"], "Fenderline vessel data");
/// ```
#[must_use]
pub fn vessel_schema() -> Json {
    whole_file(&VESSEL_FILE, "Fenderline vessel data")
}
