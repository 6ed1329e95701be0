//! Charts from GeoJSON files: `geojson` reads the text, `feature` interprets each feature, `projection` converts
//! longitude and latitude to metres.

mod feature;
mod geojson;
mod placing;
pub(crate) mod projection;

use fenderline_sim::chart::ChartFeature;

use self::feature::Reading;
pub(crate) use self::placing::{Budget, Placing};
use fenderline_keys::error::ScenarioError;

/// Reads a GeoJSON file; `key` is the key of the scenario that names the file.
///
/// # Errors
/// Returns the first mistake in the file, with its line and the number and name of its feature.
pub(crate) fn read(
    (name, text): (&str, &str),
    key: &str,
    placing: &Placing,
    budget: &mut Budget,
) -> Result<Vec<ChartFeature>, ScenarioError> {
    let file = geojson::File::open(name, text, key, matches!(placing, Placing::Degrees(_)))?;
    let mut features = Vec::new();
    for index in 0..file.len() {
        let raw = file.feature(index)?;
        let mut reading = Reading { placing, budget };
        let read = reading.features(&raw).map_err(|why| file.refused(index, &raw.name(), why))?;
        features.extend(read);
    }
    Ok(features)
}
