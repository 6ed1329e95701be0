//! The JSON Schema of campaign files, made from the same key table as the reader of these files.

use fenderline_keys::schema::whole_file;
use serde_json::Value as Json;

use super::keys::CAMPAIGN_FILE;

/// The JSON Schema (draft 2020-12) of campaign files, which [`crate::Campaign::parse`] reads.
///
/// ```
/// let schema = fenderline_campaign::campaign_schema();
/// assert_eq!(schema["title"], "Fenderline campaign");
/// ```
#[must_use]
pub fn campaign_schema() -> Json {
    whole_file(&CAMPAIGN_FILE, "Fenderline campaign")
}
