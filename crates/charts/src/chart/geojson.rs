//! Reads the syntax of GeoJSON (RFC 7946) feature by feature, so that an error can name its feature and the program
//! needs little memory.

use core::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use serde_json::Value;
use serde_json::value::RawValue;

use super::placing::{LARGEST_FILE, MOST_FEATURES};
use fenderline_keys::error::{Place, ScenarioError};
use fenderline_keys::sources::{Sources, quoted};

/// A GeoJSON file whose features are not read yet.
pub(super) struct File<'a> {
    sources: Sources<'a>,
    text: &'a str,
    key: &'a str,
    /// The file's `name`, to which the program GDAL writes the name of the chart's layer; empty if the file has no
    /// `name`.
    layer: String,
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
    name: Option<Value>,
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

/// The properties of a feature that the program uses; other properties are allowed and not read. Properties in capitals
/// are attributes of S-57: these are numbers, texts or lists, depending on the program that wrote the file.
#[derive(Debug, Default, Deserialize)]
pub(super) struct Properties {
    pub(super) kind: Option<String>,
    pub(super) name: Option<String>,
    pub(super) depth_m: Option<f64>,
    pub(super) deepest_m: Option<f64>,
    pub(super) clearance_m: Option<f64>,
    pub(super) colour: Option<String>,
    pub(super) side: Option<String>,
    pub(super) meaning: Option<String>,
    pub(super) shape: Option<String>,
    pub(super) character: Option<String>,
    pub(super) period_s: Option<f64>,
    pub(super) sector_deg: Option<[f64; 2]>,
    pub(super) range_m: Option<f64>,
    #[serde(rename = "OBJL")]
    pub(super) objl: Option<Value>,
    #[serde(rename = "OBJNAM")]
    pub(super) objnam: Option<Value>,
    #[serde(rename = "DRVAL1")]
    pub(super) drval1: Option<Value>,
    #[serde(rename = "DRVAL2")]
    pub(super) drval2: Option<Value>,
    #[serde(rename = "VALDCO")]
    pub(super) valdco: Option<Value>,
    #[serde(rename = "VALSOU")]
    pub(super) valsou: Option<Value>,
    /// Depth of a sounding, which GDAL may write in addition to the sounding's third coordinate.
    #[serde(rename = "DEPTH")]
    pub(super) depth: Option<Value>,
    #[serde(rename = "CATLAM")]
    pub(super) catlam: Option<Value>,
    #[serde(rename = "CATMOR")]
    pub(super) catmor: Option<Value>,
    #[serde(rename = "CATCAM")]
    pub(super) catcam: Option<Value>,
    #[serde(rename = "BOYSHP")]
    pub(super) boyshp: Option<Value>,
    #[serde(rename = "BCNSHP")]
    pub(super) bcnshp: Option<Value>,
    #[serde(rename = "CATCOV")]
    pub(super) catcov: Option<Value>,
    #[serde(rename = "COLOUR")]
    pub(super) colour_codes: Option<Value>,
    #[serde(rename = "LITCHR")]
    pub(super) litchr: Option<Value>,
    #[serde(rename = "SIGGRP")]
    pub(super) siggrp: Option<Value>,
    #[serde(rename = "SIGPER")]
    pub(super) sigper: Option<Value>,
    #[serde(rename = "SECTR1")]
    pub(super) sectr1: Option<Value>,
    #[serde(rename = "SECTR2")]
    pub(super) sectr2: Option<Value>,
    #[serde(rename = "VALNMR")]
    pub(super) valnmr: Option<Value>,
    #[serde(rename = "VERCLR")]
    pub(super) verclr: Option<Value>,
    #[serde(rename = "VERCCL")]
    pub(super) verccl: Option<Value>,
    #[serde(rename = "VERCSA")]
    pub(super) vercsa: Option<Value>,
}

/// The coordinates of a geometry: nested lists of numbers. A list of two or more numbers is a position. The third
/// number of a position is a height, or the depth of a sounding of S-57; further numbers are dropped.
#[derive(Debug)]
pub(super) enum Coordinates {
    Number(f64),
    Position([f64; 2], Option<f64>),
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
            return Err(error.with_help("cut the chart to the area of the exercise: `python -m fenderline.charts` has `--area`"));
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
        let layer = match document.name {
            Some(Value::String(name)) => name,
            _ => String::new(),
        };
        Ok(File { sources, text, key, layer, features })
    }

    /// The name of the chart's layer, if the program GDAL wrote the file; else empty.
    pub(super) fn layer(&self) -> &str {
        &self.layer
    }

    /// The place of a feature in the file (file, line and column).
    pub(super) fn place(&self, index: usize) -> Place {
        let start = self.start(index);
        self.sources.place(&(start..start + self.features[index].get().len()))
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

    /// Makes the error that a feature of the file is refused for the reason `why`.
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

    /// The byte of the file at which a feature begins.
    fn start(&self, index: usize) -> usize {
        self.features[index].get().as_ptr() as usize - self.text.as_ptr() as usize
    }
}

/// An error of the JSON parser.
struct Fault {
    /// The byte of the text at which the error is.
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
                let mut third = None;
                while let Some(more) = list.next_element()? {
                    let Coordinates::Number(more) = more else { return Err(not_a_position()) };
                    third = third.or(Some(more));
                }
                Ok(Coordinates::Position([x, y], third))
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
