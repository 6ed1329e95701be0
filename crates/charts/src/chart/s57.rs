//! Features of S-57, the format of electronic navigational charts, as GDAL writes them to GeoJSON: the object classes
//! that the program reads, and the attributes of these objects.
//!
//! Numbers of classes and codes of attributes are those of S-57 Appendix A, edition 3.1, as the tables of GDAL have them
//! (`s57objectclasses.csv`, `s57expectedinput.csv`).

use fenderline_sim::chart::{
    ChartKind, ChartLight, ChartMark, MarkColour, MarkMeaning, MarkShape, MarkSide,
};
use serde_json::Value;

use super::bounds::{DEPTHS_M, LONGEST_NAME};
use super::geojson::Properties;

/// A nautical mile (m).
const NAUTICAL_MILE_M: f64 = 1852.0;

/// An object class of S-57 that the program reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Class {
    /// Acronym of the class, such as `DEPARE`, which GDAL uses as the name of a layer.
    pub(super) word: &'static str,
    /// Number of the class in S-57 (`OBJL`).
    number: u32,
    /// The kind of chart feature that objects of this class become.
    pub(super) kind: ChartKind,
}

/// Shorthand for the table.
const fn class(word: &'static str, number: u32, kind: ChartKind) -> Class {
    Class { word, number, kind }
}

/// The object classes of S-57 that the program reads.
pub(super) const CLASSES: [Class; 37] = [
    class("ACHARE", 4, ChartKind::Anchorage),
    class("BCNCAR", 5, ChartKind::Beacon),
    class("BCNISD", 6, ChartKind::Beacon),
    class("BCNLAT", 7, ChartKind::Beacon),
    class("BCNSAW", 8, ChartKind::Beacon),
    class("BCNSPP", 9, ChartKind::Beacon),
    class("BERTHS", 10, ChartKind::Berth),
    class("BOYCAR", 14, ChartKind::Buoy),
    class("BOYINB", 15, ChartKind::Buoy),
    class("BOYISD", 16, ChartKind::Buoy),
    class("BOYLAT", 17, ChartKind::Buoy),
    class("BOYSAW", 18, ChartKind::Buoy),
    class("BOYSPP", 19, ChartKind::Buoy),
    class("BRIDGE", 11, ChartKind::Bridge),
    class("BUISGL", 12, ChartKind::Building),
    class("CBLOHD", 21, ChartKind::Cable),
    class("COALNE", 30, ChartKind::Coast),
    class("DEPARE", 42, ChartKind::DepthArea),
    class("DEPCNT", 43, ChartKind::DepthContour),
    class("DRGARE", 46, ChartKind::DredgedArea),
    class("FAIRWY", 51, ChartKind::Fairway),
    class("FLODOC", 57, ChartKind::Pontoon),
    class("HULKES", 65, ChartKind::Pontoon),
    class("LIGHTS", 75, ChartKind::Light),
    class("LNDARE", 71, ChartKind::Coast),
    class("LNDMRK", 74, ChartKind::Landmark),
    class("MORFAC", 84, ChartKind::Mooring),
    class("M_COVR", 302, ChartKind::Coverage),
    class("NAVLNE", 85, ChartKind::LeadingLine),
    class("OBSTRN", 86, ChartKind::Obstruction),
    class("PONTON", 95, ChartKind::Pontoon),
    class("RECTRC", 109, ChartKind::LeadingLine),
    class("SLCONS", 122, ChartKind::Quay),
    class("SOUNDG", 129, ChartKind::Sounding),
    class("UNSARE", 154, ChartKind::UnsurveyedArea),
    class("UWTROC", 153, ChartKind::Rock),
    class("WRECKS", 159, ChartKind::Wreck),
];

/// The S-57 class of a feature, and whether the program reads this class.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Found {
    /// The program reads this class.
    Read(Class),
    /// The program does not read this class, which is given by its name.
    NotRead(String),
}

/// Finds the S-57 class of a feature by its class number (`OBJL`) or by the name of the file's layer; `None` if the
/// feature is not from S-57.
pub(super) fn class_of(given: &Properties, layer: &str) -> Option<Found> {
    if given.kind.is_some() {
        return None;
    }
    // A layer of S-57 has a name of six letters in capitals, such as `M_COVR`.
    let is_layer = layer.len() == 6 && layer.bytes().all(|b| b.is_ascii_uppercase() || b == b'_');
    let named = CLASSES.into_iter().find(|class| class.word == layer);
    if let Some(number) = given.objl.as_ref().and_then(number) {
        let known = CLASSES.into_iter().find(|class| f64::from(class.number) == number);
        return Some(match known {
            Some(class) => Found::Read(class),
            None if is_layer && named.is_none() => Found::NotRead(layer.to_owned()),
            None => Found::NotRead(format!("OBJL {number}")),
        });
    }
    if !is_layer {
        return None;
    }
    Some(match named {
        Some(class) => Found::Read(class),
        None => Found::NotRead(layer.to_owned()),
    })
}

/// The properties of a chart feature apart from its shape and kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Attributes {
    pub(super) name: String,
    pub(super) depth_m: Option<f64>,
    pub(super) deepest_m: Option<f64>,
    pub(super) mark: Option<ChartMark>,
    pub(super) light: Option<ChartLight>,
    pub(super) clearance_m: Option<f64>,
}

impl Attributes {
    /// Reads the attributes of a feature of the class `class`.
    ///
    /// # Errors
    /// Says why the feature is left out of the chart.
    pub(super) fn of(class: Class, given: &Properties) -> Result<Attributes, &'static str> {
        let value = |of: &Option<Value>| of.as_ref().and_then(number);
        let depth = |of: &Option<Value>| {
            value(of).filter(|depth_m| (DEPTHS_M[0]..=DEPTHS_M[1]).contains(depth_m))
        };
        let mut read = Attributes {
            name: given.objnam.as_ref().map(tidy_name).unwrap_or_default(),
            ..Attributes::default()
        };
        match class.kind {
            ChartKind::DepthArea | ChartKind::DredgedArea => {
                read.depth_m = Some(depth(&given.drval1).ok_or("no DRVAL1")?);
                read.deepest_m = depth(&given.drval2);
                if read.deepest_m < read.depth_m && read.deepest_m.is_some() {
                    return Err("DRVAL2 is less than DRVAL1");
                }
            }
            ChartKind::DepthContour => {
                read.depth_m = Some(depth(&given.valdco).ok_or("no VALDCO")?);
            }
            // The third coordinate is the depth; without a third coordinate, GDAL's property `DEPTH` is the depth.
            ChartKind::Sounding => read.depth_m = depth(&given.depth),
            ChartKind::Rock | ChartKind::Obstruction | ChartKind::Wreck => {
                read.depth_m = depth(&given.valsou);
            }
            ChartKind::Bridge | ChartKind::Cable => {
                let heights = [&given.vercsa, &given.verccl, &given.verclr];
                let least = heights.into_iter().find_map(value);
                read.clearance_m = least.filter(|height_m| (0.0..=1e3).contains(height_m));
            }
            ChartKind::Buoy | ChartKind::Beacon => read.mark = Some(mark(class, given)),
            // A mooring buoy: it floats, so the pages' view must tell it from a dolphin.
            ChartKind::Mooring if value(&given.catmor) == Some(7.0) => {
                read.mark = Some(mark(class, given));
            }
            ChartKind::Light => read.light = Some(light(given)),
            ChartKind::Coverage if value(&given.catcov) == Some(2.0) => {
                return Err("CATCOV 2: no coverage");
            }
            _ => {}
        }
        Ok(read)
    }
}

/// Reads a number that may be written as a number, as a text, or as the first item of a list.
fn number(of: &Value) -> Option<f64> {
    match of {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => text.trim().parse().ok().filter(|number: &f64| number.is_finite()),
        Value::Array(list) => list.first().and_then(number),
        _ => None,
    }
}

/// Reads a list of code numbers, which may also be one text with commas between the numbers.
fn codes(of: Option<&Value>) -> Vec<u32> {
    match of {
        Some(Value::String(text)) => {
            text.split(',').filter_map(|code| code.trim().parse().ok()).collect()
        }
        Some(Value::Array(list)) => {
            list.iter().filter_map(number).map(|code| code as u32).collect()
        }
        Some(one) => number(one).map(|code| code as u32).into_iter().collect(),
        None => Vec::new(),
    }
}

/// Reads a name, without its control characters, and cuts it to the longest name that a chart feature may have.
fn tidy_name(of: &Value) -> String {
    let Value::String(text) = of else { return String::new() };
    let text: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let text = text.trim();
    let mut end = text.len().min(LONGEST_NAME);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    text[..end].trim_end().to_owned()
}

fn colour(code: u32) -> Option<MarkColour> {
    match code {
        1 => Some(MarkColour::White),
        2 => Some(MarkColour::Black),
        3 => Some(MarkColour::Red),
        4 => Some(MarkColour::Green),
        // Yellow and amber.
        6 | 9 => Some(MarkColour::Yellow),
        _ => None,
    }
}

/// Colour of a buoy, mooring buoy or beacon, and the side of the channel that it marks. Cardinal marks and isolated dangers are black
/// with another colour, safe-water marks are white with red; a mark of a colour that the program does not know is drawn
/// white.
fn mark(class: Class, given: &Properties) -> ChartMark {
    let first = codes(given.colour_codes.as_ref()).first().copied().and_then(colour);
    let side = match given.catlam.as_ref().and_then(number) {
        // Port-hand, and port-hand where the preferred channel is to starboard.
        Some(1.0 | 3.0) => Some(MarkSide::Port),
        Some(2.0 | 4.0) => Some(MarkSide::Starboard),
        _ => None,
    };
    let colour = match &class.word[3..] {
        "CAR" | "ISD" => MarkColour::Black,
        "SAW" => MarkColour::White,
        "SPP" => first.unwrap_or(MarkColour::Yellow),
        _ => first.unwrap_or(MarkColour::White),
    };
    let is_lateral = class.word.ends_with("LAT");
    ChartMark {
        colour,
        side: side.filter(|_| is_lateral),
        meaning: meaning(class, given),
        shape: shape(given),
    }
}

fn meaning(class: Class, given: &Properties) -> MarkMeaning {
    match &class.word[3..] {
        "LAT" => MarkMeaning::Lateral,
        "CAR" => match given.catcam.as_ref().and_then(number) {
            Some(1.0) => MarkMeaning::North,
            Some(2.0) => MarkMeaning::East,
            Some(3.0) => MarkMeaning::South,
            Some(4.0) => MarkMeaning::West,
            _ => MarkMeaning::Other,
        },
        "ISD" => MarkMeaning::IsolatedDanger,
        "SAW" => MarkMeaning::SafeWater,
        "SPP" => MarkMeaning::Special,
        _ => MarkMeaning::Other,
    }
}

/// The shape of a buoy (`BOYSHP`) or of a beacon (`BCNSHP`). A super-buoy, an ice buoy and a cairn have no shape of ours.
fn shape(given: &Properties) -> Option<MarkShape> {
    let code = |of: &Option<Value>| of.as_ref().and_then(number).map(|code| code as u32);
    match (code(&given.boyshp), code(&given.bcnshp)) {
        (Some(1), _) => Some(MarkShape::Cone),
        (Some(2), _) => Some(MarkShape::Can),
        (Some(3), _) => Some(MarkShape::Ball),
        (Some(4), _) => Some(MarkShape::Pillar),
        (Some(5), _) | (None, Some(1 | 2)) => Some(MarkShape::Spar),
        (Some(6), _) => Some(MarkShape::Barrel),
        // A beacon tower, a lattice beacon, a pile beacon, a buoyant beacon.
        (None, Some(3 | 4 | 5 | 7)) => Some(MarkShape::Tower),
        _ => None,
    }
}

fn light(given: &Properties) -> ChartLight {
    let value = |of: &Option<Value>| of.as_ref().and_then(number);
    let colours = codes(given.colour_codes.as_ref());
    let period_s = value(&given.sigper).filter(|period_s| (0.0..=1e3).contains(period_s));
    let sector_rad = match (value(&given.sectr1), value(&given.sectr2)) {
        // The attributes are bearings of the light as a ship sees it; the light shines the other way.
        (Some(from_deg), Some(to_deg)) => {
            Some([from_deg, to_deg].map(|bearing_deg| direction_rad(bearing_deg + 180.0)))
        }
        _ => None,
    };
    ChartLight {
        colour: colours.first().copied().and_then(colour).unwrap_or(MarkColour::White),
        character: character(given, &colours, period_s),
        period_s,
        sector_rad,
        range_m: value(&given.valnmr)
            .filter(|miles| (0.0..=100.0).contains(miles))
            .map(|miles| miles * NAUTICAL_MILE_M),
    }
}

/// Converts a direction in degrees into a direction from 0 to 2π (rad).
pub(super) fn direction_rad(degrees: f64) -> f64 {
    (degrees - 360.0 * libm::floor(degrees / 360.0)).to_radians()
}

/// The character of a light as charts write it, such as `Fl(2) R 6s`.
fn character(given: &Properties, colours: &[u32], period_s: Option<f64>) -> String {
    let code = given.litchr.as_ref().and_then(number).unwrap_or(0.0) as u32;
    let word = match code {
        1 => "F",
        2 => "Fl",
        3 => "LFl",
        4 => "Q",
        5 => "VQ",
        6 => "UQ",
        7 => "Iso",
        8 => "Oc",
        9 => "IQ",
        10 => "IVQ",
        11 => "IUQ",
        12 => "Mo",
        13 => "FFl",
        14 => "Fl+LFl",
        25 => "Q+LFl",
        26 => "VQ+LFl",
        27 => "UQ+LFl",
        28 => "Al",
        _ => return String::new(),
    };
    let group = match given.siggrp.as_ref() {
        Some(Value::String(group)) if !["", "()", "(1)", "()()"].contains(&group.as_str()) => group
            .chars()
            .filter(|c| c.is_ascii_alphanumeric() || "()+".contains(*c))
            .take(20)
            .collect(),
        _ => String::new(),
    };
    let letters: String = colours
        .iter()
        .filter_map(|code| match code {
            1 => Some("W"),
            3 => Some("R"),
            4 => Some("G"),
            5 => Some("Bu"),
            6 | 9 => Some("Y"),
            10 => Some("Vi"),
            11 => Some("Or"),
            _ => None,
        })
        .collect();
    let mut text = format!("{word}{group}");
    if !letters.is_empty() {
        text += &format!(" {letters}");
    }
    if let Some(period_s) = period_s {
        text += &format!(" {period_s}s");
    }
    text
}
