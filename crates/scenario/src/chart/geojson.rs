//! Reads the syntax of GeoJSON (RFC 7946) feature by feature, so that an error can name its feature and the program
//! needs little memory.

use core::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use serde_json::value::RawValue;

use super::placing::{LARGEST_FILE, MOST_FEATURES};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::{Sources, quoted};

/// A GeoJSON file whose features are not read yet.
pub(super) struct File<'a> {
    sources: Sources<'a>,
    text: &'a str,
    key: &'a str,
    features: Vec<&'a RawValue>,
}

/// The outermost object of a GeoJSON file.
#[derive(Deserialize)]
struct Document<'a> {
    #[serde(rename = "type")]
    kind: String,
    #[serde(borrow, default)]
    features: Option<Vec<&'a RawValue>>,
    crs: Option<System>,
}

/// The coordinate system that a GeoJSON file states; GeoJSON files had this object before the standard.
#[derive(Deserialize)]
struct System {
    properties: NameOfSystem,
}

/// The name of the coordinate system that a GeoJSON file states.
#[derive(Deserialize)]
struct NameOfSystem {
    name: String,
}

/// A feature of a GeoJSON file.
#[derive(Debug, Deserialize)]
pub(super) struct Raw {
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) geometry: Option<Geometry>,
    pub(super) properties: Option<Properties>,
}

/// The geometry of a feature; only a collection of geometries has no coordinates.
#[derive(Debug, Deserialize)]
pub(super) struct Geometry {
    #[serde(rename = "type")]
    pub(super) kind: String,
    #[serde(default)]
    pub(super) coordinates: Option<Coordinates>,
}

/// The properties of a feature that a chart uses; the program ignores all other properties.
#[derive(Debug, Default, Deserialize)]
pub(super) struct Properties {
    pub(super) kind: Option<String>,
    pub(super) name: Option<String>,
    pub(super) depth_m: Option<f64>,
    pub(super) colour: Option<String>,
    pub(super) side: Option<String>,
}

/// Coordinates as nested lists of numbers. A list of two or more numbers is a position; the program ignores its further
/// numbers, such as a height.
#[derive(Debug)]
pub(super) enum Coordinates {
    Number(f64),
    Position([f64; 2]),
    List(Vec<Coordinates>),
}

impl Raw {
    /// The feature's name; empty if the feature has no name.
    pub(super) fn name(&self) -> String {
        self.properties.as_ref().and_then(|given| given.name.clone()).unwrap_or_default()
    }
}

impl<'a> File<'a> {
    /// Finds the features of a GeoJSON file.
    ///
    /// # Errors
    /// Fails if the file is too large, is not JSON, is not a collection of features, or has too many features, or if it
    /// states another coordinate system than WGS 84 where degrees are expected.
    pub(super) fn open(
        name: &'a str,
        text: &'a str,
        key: &'a str,
        is_in_degrees: bool,
    ) -> Result<File<'a>, ScenarioError> {
        let sources = Sources::new(name, text, &[]);
        if text.len() > LARGEST_FILE {
            let most = LARGEST_FILE >> 20;
            let error = sources.file_error(format!("the chart is larger than {most} MiB"));
            return Err(error.with_help("simplify the lines: a chart has at most 20,000 points"));
        }
        // Some programs begin a file with a byte order mark, which JSON does not have.
        let json = text.strip_prefix('\u{feff}').unwrap_or(text);
        let document: Document<'a> = serde_json::from_str(json)
            .map_err(|error| syntax_error(&sources, key, text.len() - json.len(), json, &error))?;
        if document.kind != "FeatureCollection" {
            let message =
                format!("the file is a {}, not a FeatureCollection", quoted(&document.kind));
            return Err(sources.file_error(message));
        }
        let features = document
            .features
            .ok_or_else(|| sources.file_error("the FeatureCollection has no `features`"))?;
        if features.len() > MOST_FEATURES {
            let message = format!(
                "the chart has {} features, but may have at most {MOST_FEATURES}",
                features.len()
            );
            return Err(sources.file_error(message));
        }
        let system = document.crs.map(|crs| crs.properties.name).unwrap_or_default();
        let is_wgs_84 =
            system.is_empty() || ["CRS84", "4326"].iter().any(|of| system.ends_with(of));
        if is_in_degrees && !is_wgs_84 {
            let message = format!(
                "the file states the coordinate system {}, not longitude and latitude on WGS 84",
                quoted(&system)
            );
            let error = sources.file_error(message);
            return Err(error.with_help("convert the file to WGS 84 (EPSG:4326)"));
        }
        Ok(File { sources, text, key, features })
    }

    /// Number of features.
    pub(super) fn len(&self) -> usize {
        self.features.len()
    }

    /// Reads a feature.
    ///
    /// # Errors
    /// Fails if the feature has a value of the wrong type or something that is not a number, or if its lists are nested
    /// too deep.
    pub(super) fn feature(&self, index: usize) -> Result<Raw, ScenarioError> {
        let raw = self.features[index].get();
        serde_json::from_str(raw).map_err(|error| {
            let start = self.start(index);
            let Fault { at, why } = Fault::of(raw, &error);
            self.error(index, "", start + at..start + at + 1, &why)
        })
    }

    /// Makes an error about a feature of the file.
    pub(super) fn refused(&self, index: usize, name: &str, why: String) -> ScenarioError {
        let start = self.start(index);
        self.error(index, name, start..start + self.features[index].get().len(), &why)
    }

    fn error(
        &self,
        index: usize,
        name: &str,
        span: core::ops::Range<usize>,
        why: &str,
    ) -> ScenarioError {
        let named = if name.is_empty() { String::new() } else { format!(" ({})", quoted(name)) };
        let message = format!("feature {}{named}: {why}", index + 1);
        self.sources.error(&span, self.key, message)
    }

    /// Place at which a feature begins in the file (bytes).
    fn start(&self, index: usize) -> usize {
        self.features[index].get().as_ptr() as usize - self.text.as_ptr() as usize
    }
}

/// An error of the JSON parser.
struct Fault {
    /// Place of the error in the text (bytes).
    at: usize,
    why: String,
}

impl Fault {
    fn of(text: &str, error: &serde_json::Error) -> Fault {
        let whole = error.to_string();
        let why = whole.rfind(" at line ").map_or(&*whole, |end| &whole[..end]);
        let why = why
            .strip_prefix("recursion limit exceeded")
            .map_or_else(|| why.to_owned(), |_| "the lists are nested too deep".to_owned());
        // The reader counts lines from 1 and bytes of a line from 1.
        let line = text.split_inclusive('\n').take(error.line().saturating_sub(1));
        let at = line.map(str::len).sum::<usize>() + error.column().saturating_sub(1);
        Fault { at: at.min(text.len().saturating_sub(1)), why }
    }
}

fn syntax_error(
    sources: &Sources<'_>,
    key: &str,
    skipped: usize,
    json: &str,
    error: &serde_json::Error,
) -> ScenarioError {
    let Fault { at, why } = Fault::of(json, error);
    let at = skipped + at;
    sources.error(&(at..at + 1), key, format!("the file is not GeoJSON: {why}"))
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Coordinates, D::Error> {
        from.deserialize_any(OfCoordinates)
    }
}

struct OfCoordinates;

impl<'de> Visitor<'de> for OfCoordinates {
    type Value = Coordinates;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of coordinates")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Coordinates, E> {
        Ok(Coordinates::Number(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Coordinates, E> {
        Ok(Coordinates::Number(number as f64))
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Coordinates, E> {
        Ok(Coordinates::Number(number as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Coordinates, A::Error> {
        let not_a_position = || Error::custom("a position must be a list of two numbers");
        match list.next_element()? {
            None => Ok(Coordinates::List(Vec::new())),
            Some(Coordinates::Number(x)) => {
                let Some(Coordinates::Number(y)) = list.next_element()? else {
                    return Err(not_a_position());
                };
                while let Some(more) = list.next_element()? {
                    let Coordinates::Number(_) = more else { return Err(not_a_position()) };
                }
                Ok(Coordinates::Position([x, y]))
            }
            Some(first) => {
                let mut all = vec![first];
                while let Some(next) = list.next_element()? {
                    if matches!(next, Coordinates::Number(_)) {
                        return Err(not_a_position());
                    }
                    all.push(next);
                }
                Ok(Coordinates::List(all))
            }
        }
    }
}
