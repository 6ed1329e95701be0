//! Charts from GeoJSON files: `geojson` reads the text, `feature` interprets each feature, `s57` has the classes of
//! electronic charts, `bounds` has the limits for depths and names, `ring` checks the rings of areas, `placing`
//! converts coordinates, `projection` converts longitude and latitude to metres.

mod bounds;
mod feature;
mod geojson;
mod placing;
pub mod projection;
mod ring;
mod s57;

use std::collections::BTreeMap;

use fenderline_sim::chart::{ChartClass, ChartFeature, ChartKind};

use self::feature::{Reading, Refusal, Rings};
pub use self::placing::{Budget, Placing};
use self::s57::Found;
use fenderline_keys::error::{Notice, ScenarioError};

/// For each class of chart objects, by the name of the class: how many features were read, and how many were left out
/// for each reason.
#[derive(Debug, Default)]
pub struct Counts(BTreeMap<String, (usize, BTreeMap<String, usize>)>);

impl Counts {
    fn add_read(&mut self, class: &str) {
        self.0.entry(class.to_owned()).or_default().0 += 1;
    }

    fn add_left_out(&mut self, class: &str, why: &str) {
        *self.0.entry(class.to_owned()).or_default().1.entry(why.to_owned()).or_default() += 1;
    }

    /// The counts of all classes, in the alphabetical order of the classes' names.
    pub fn classes(self) -> Vec<ChartClass> {
        let class = |(class, (read, left_out)): (String, (usize, BTreeMap<String, usize>))| {
            let left_out = left_out.into_iter().map(|(why, count)| (count, why)).collect();
            ChartClass { class, read, left_out }
        };
        self.0.into_iter().map(class).collect()
    }
}

/// Reads the features of a GeoJSON file; `key` is the key of the scenario that names the file.
///
/// # Errors
/// Returns the first mistake in the file, with its line and the number and name of its feature.
pub fn read(
    (number, name, text): (usize, &str, &str),
    key: &str,
    placing: &Placing,
    budget: &mut Budget,
    (counts, notices): (&mut Counts, &mut Vec<Notice>),
) -> Result<Vec<ChartFeature>, ScenarioError> {
    let file = geojson::File::open(name, text, key, matches!(placing, Placing::Degrees(_)))?;
    let mut features = Vec::new();
    for index in 0..file.len() {
        let raw = file.feature(index)?;
        let found = raw.properties.as_ref().map_or_else(
            || s57::class_of(&geojson::Properties::default(), file.layer()),
            |given| s57::class_of(given, file.layer()),
        );
        let place = [number, index + 1];
        let refused = |why| file.refused(index, &raw.name(), why);
        match found {
            None => {
                let mut reading = Reading { place, placing, budget, rings: Rings::Outlines };
                let read = reading.features(&raw).map_err(refused)?;
                if let Some(first) = read.first() {
                    counts.add_read(first.kind.word());
                }
                features.extend(read);
            }
            Some(Found::NotRead(class)) => counts.add_left_out(&class, "the class is not read"),
            Some(Found::Read(class)) => {
                let mut reading = Reading { place, placing, budget, rings: Rings::Charted };
                match reading.of_s57(&raw, class) {
                    Ok(read) => {
                        counts.add_read(class.word);
                        features.extend(read);
                    }
                    Err(Refusal::LeftOut(why)) => counts.add_left_out(class.word, why),
                    Err(Refusal::Crossed(why)) => {
                        counts.add_left_out(class.word, "its ring crosses itself");
                        let message =
                            format!("feature {} ({}) is left out: {why}", index + 1, class.word);
                        notices.push(Notice {
                            place: file.place(index),
                            key: key.to_owned(),
                            message,
                        });
                    }
                    Err(Refusal::Refused(why)) => return Err(refused(why)),
                }
            }
        }
    }
    Ok(features)
}

/// An error about a feature of a chart file that was read.
pub fn refused(
    (name, text): (&str, &str),
    key: &str,
    feature: &ChartFeature,
    why: String,
) -> ScenarioError {
    match geojson::File::open(name, text, key, false) {
        Ok(file) => file.refused(feature.place[1] - 1, &feature.name, why),
        Err(error) => error,
    }
}

/// The words of the classes that may be solid: what stands out of the water and does not give way to a ship.
pub fn solid_words() -> impl Iterator<Item = &'static str> {
    let is_solid = |kind: ChartKind| {
        matches!(
            kind,
            ChartKind::Coast
                | ChartKind::Quay
                | ChartKind::Pontoon
                | ChartKind::Building
                | ChartKind::Mooring
        )
    };
    let kinds = ChartKind::ALL.into_iter().filter(move |kind| is_solid(*kind));
    s57::CLASSES
        .iter()
        .filter(move |class| is_solid(class.kind))
        .map(|class| class.word)
        .chain(kinds.map(ChartKind::word))
}
