//! The chart of a berth: the background on which ships and quays are drawn, and where the depths of a bottom may come
//! from. A chart exerts no force.

use fenderline_contact::Vec2;

/// A chart in the scenario's coordinates; empty by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// The features of the chart, in the order of the chart's files. A feature of several parts in a file gives several
    /// features of this list.
    pub features: Vec<ChartFeature>,
    /// Latitude and longitude of the scenario's origin, if the chart was given in longitude and latitude.
    pub origin: Option<GeographicPlace>,
    /// For each class of features in the chart's files, how many were read and how many were left out; the classes are
    /// in alphabetical order.
    pub classes: Vec<ChartClass>,
    /// What of the chart is solid, as a part of the body [`SHORE`]: what was taken and what was left out, by class. Empty
    /// if nothing is solid.
    pub solid: Vec<ChartClass>,
}

/// Name of the body that the solid parts of a chart make.
pub const SHORE: &str = "shore";

impl Chart {
    /// The numbers of features that were read, class by class, in words; `None` if no feature was read.
    #[must_use]
    pub fn read_in_words(&self) -> Option<String> {
        let read = self.classes.iter().filter(|class| class.read > 0);
        listed(read.map(|class| format!("{} {}", class.read, class.class)))
    }

    /// The numbers of features that were left out, class by class, with the reasons, in words; `None` if no feature was
    /// left out.
    #[must_use]
    pub fn left_out_in_words(&self) -> Option<String> {
        left_out_of(&self.classes)
    }

    /// What of the chart is solid, and what of these classes is not, by class and number, in words; `None` if nothing is
    /// solid.
    #[must_use]
    pub fn solid_in_words(&self) -> Option<String> {
        let taken = self.solid.iter().filter(|class| class.read > 0);
        let taken = listed(taken.map(|class| format!("{} {}", class.read, class.class)))?;
        Some(match left_out_of(&self.solid) {
            Some(left_out) => format!("{taken}; not taken: {left_out}"),
            None => taken,
        })
    }
}

/// What was left out, by class and number, with the reasons; `None`: nothing was.
fn left_out_of(classes: &[ChartClass]) -> Option<String> {
    let mut reasons: Vec<&str> = Vec::new();
    let all = || classes.iter().flat_map(|class| &class.left_out);
    for (_, why) in all() {
        if !reasons.contains(&why.as_str()) {
            reasons.push(why);
        }
    }
    let of_reason = |why: &str| {
        let classes = classes.iter().filter_map(|class| {
            let (count, _) = class.left_out.iter().find(|(_, of)| of == why)?;
            Some(format!("{count} {}", class.class))
        });
        Some(format!("{} ({why})", listed(classes)?))
    };
    let texts: Vec<String> = reasons.into_iter().filter_map(of_reason).collect();
    (!texts.is_empty()).then(|| texts.join("; "))
}

/// Words with commas between them; `None` without words.
fn listed(words: impl Iterator<Item = String>) -> Option<String> {
    let words: Vec<String> = words.collect();
    (!words.is_empty()).then(|| words.join(", "))
}

/// How many features of one class were read from the chart's files, and how many were left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChartClass {
    /// Name of the class: an acronym of S-57 such as `DEPARE`, or the word for a kind of feature ([`ChartKind::word`]).
    pub class: String,
    /// Number of features that were read; a feature of several parts counts once.
    pub read: usize,
    /// For each reason to leave features of this class out, how many were left out, and the reason.
    pub left_out: Vec<(usize, String)>,
}

impl ChartClass {
    /// Number of features that were left out.
    #[must_use]
    pub fn left_out(&self) -> usize {
        self.left_out.iter().map(|(count, _)| count).sum()
    }
}

/// A place on the WGS 84 ellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeographicPlace {
    /// Latitude, north positive (rad).
    pub latitude_rad: f64,
    /// Longitude, east positive (rad).
    pub longitude_rad: f64,
}

/// One feature of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartFeature {
    /// Kind of the feature.
    pub kind: ChartKind,
    /// Class of the feature: an acronym of S-57 such as `SLCONS`, or the word of the kind.
    pub class: &'static str,
    /// The chart file of the feature, as an index in the scenario's list of files, and the number of the feature in the
    /// file, counted from 1.
    pub place: [usize; 2],
    /// Name of the feature; empty if the feature has no name.
    pub name: String,
    /// Shape and position of the feature.
    pub shape: ChartShape,
    /// Depth of the feature below chart datum; for an area, the least depth (m). `None` if the chart gives no depth for
    /// the feature.
    pub depth_m: Option<f64>,
    /// The greatest depth of an area below chart datum (m). `None` if the chart gives no greatest depth for the
    /// feature.
    pub deepest_m: Option<f64>,
    /// Colour and side of a buoy or beacon, and the colour of a mooring buoy; `None` for other features.
    pub mark: Option<ChartMark>,
    /// Colour, character, sector and range of a light; `None` for other kinds of features.
    pub light: Option<ChartLight>,
    /// Height of a bridge or overhead cable above the level from which the chart counts heights (m).
    pub clearance_m: Option<f64>,
}

/// What a light shows.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartLight {
    /// Colour of the light; if the light changes its colour, the first of its colours.
    pub colour: MarkColour,
    /// Character of the light as printed on charts, such as `Fl(2) R 6s`; empty if the chart gives no character.
    pub character: String,
    /// Period (s).
    pub period_s: Option<f64>,
    /// Directions from the light between which the light is seen, clockwise from the first direction to the second (rad
    /// from north). `None` if the light is seen all round.
    pub sector_rad: Option<[f64; 2]>,
    /// Nominal range (m).
    pub range_m: Option<f64>,
}

/// Kinds of features of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartKind {
    /// The area that the chart covers.
    Coverage,
    /// An area for which the chart gives the least depth of the water.
    DepthArea,
    /// An area that is dredged to a depth that the chart gives.
    DredgedArea,
    /// An area of unknown depth.
    UnsurveyedArea,
    /// A line of equal depth.
    DepthContour,
    /// A depth that was measured at a point.
    Sounding,
    /// An area of land, or the coastline.
    Coast,
    /// A quay, pier or jetty.
    Quay,
    /// A pontoon, floating dock or hulk.
    Pontoon,
    /// A building.
    Building,
    /// A berth.
    Berth,
    /// A fairway.
    Fairway,
    /// An anchorage.
    Anchorage,
    /// A leading line or a recommended track.
    LeadingLine,
    /// A bridge.
    Bridge,
    /// A cable over the water.
    Cable,
    /// A rock under water or awash.
    Rock,
    /// An obstruction.
    Obstruction,
    /// A wreck.
    Wreck,
    /// A dolphin, bollard or other mooring post.
    Mooring,
    /// A landmark.
    Landmark,
    /// A light.
    Light,
    /// A fixed mark.
    Beacon,
    /// A floating mark.
    Buoy,
    /// A name alone.
    Name,
}

impl ChartKind {
    /// All kinds of features, in the order in which pages draw them.
    pub const ALL: [ChartKind; 25] = [
        ChartKind::Coverage,
        ChartKind::DepthArea,
        ChartKind::DredgedArea,
        ChartKind::UnsurveyedArea,
        ChartKind::DepthContour,
        ChartKind::Sounding,
        ChartKind::Coast,
        ChartKind::Quay,
        ChartKind::Pontoon,
        ChartKind::Building,
        ChartKind::Berth,
        ChartKind::Fairway,
        ChartKind::Anchorage,
        ChartKind::LeadingLine,
        ChartKind::Bridge,
        ChartKind::Cable,
        ChartKind::Rock,
        ChartKind::Obstruction,
        ChartKind::Wreck,
        ChartKind::Mooring,
        ChartKind::Landmark,
        ChartKind::Light,
        ChartKind::Beacon,
        ChartKind::Buoy,
        ChartKind::Name,
    ];

    /// The word for this kind of feature in GeoJSON files and in messages to web pages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            ChartKind::Coverage => "coverage",
            ChartKind::DepthArea => "depth_area",
            ChartKind::DredgedArea => "dredged_area",
            ChartKind::UnsurveyedArea => "unsurveyed_area",
            ChartKind::DepthContour => "depth_contour",
            ChartKind::Sounding => "sounding",
            ChartKind::Coast => "coast",
            ChartKind::Quay => "quay",
            ChartKind::Pontoon => "pontoon",
            ChartKind::Building => "building",
            ChartKind::Berth => "berth",
            ChartKind::Fairway => "fairway",
            ChartKind::Anchorage => "anchorage",
            ChartKind::LeadingLine => "leading_line",
            ChartKind::Bridge => "bridge",
            ChartKind::Cable => "overhead_cable",
            ChartKind::Rock => "rock",
            ChartKind::Obstruction => "obstruction",
            ChartKind::Wreck => "wreck",
            ChartKind::Mooring => "mooring",
            ChartKind::Landmark => "landmark",
            ChartKind::Light => "light",
            ChartKind::Beacon => "beacon",
            ChartKind::Buoy => "buoy",
            ChartKind::Name => "name",
        }
    }

    /// True for the two kinds of areas for which the chart gives a depth: depth areas and dredged areas.
    #[must_use]
    pub fn is_area_of_depth(self) -> bool {
        matches!(self, ChartKind::DepthArea | ChartKind::DredgedArea)
    }
}

/// The shape of a chart's feature, in the scenario's coordinates: north and east (m).
#[derive(Clone, Debug, PartialEq)]
pub enum ChartShape {
    /// A point.
    Point(Vec2),
    /// A line through points.
    Line(Vec<Vec2>),
    /// An area, given by its outer ring and then the rings of its holes. No ring of an area repeats its first point at
    /// the end.
    Area(Vec<Vec<Vec2>>),
}

impl ChartShape {
    /// All points of the shape, north and east (m).
    pub fn points_m(&self) -> impl Iterator<Item = Vec2> {
        let (point, lines): (Option<Vec2>, &[Vec<Vec2>]) = match self {
            ChartShape::Point(at_m) => (Some(*at_m), &[]),
            ChartShape::Line(line) => (None, std::slice::from_ref(line)),
            ChartShape::Area(rings) => (None, rings),
        };
        point.into_iter().chain(lines.iter().flatten().copied())
    }
}

/// Colour and side of a buoy or beacon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChartMark {
    /// Colour of the mark.
    pub colour: MarkColour,
    /// The side of the fairway that the mark shows to an entering ship; `None` for a mark that is not a lateral mark.
    pub side: Option<MarkSide>,
    /// What the mark says, by IALA's system.
    pub meaning: MarkMeaning,
    /// Shape of the mark; `None` if the chart does not give the shape.
    pub shape: Option<MarkShape>,
}

/// What a mark says, by IALA's maritime buoyage system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkMeaning {
    /// A side of a fairway.
    Lateral,
    /// The safe water lies to the north of the mark.
    North,
    /// The safe water lies to the east of the mark.
    East,
    /// The safe water lies to the south of the mark.
    South,
    /// The safe water lies to the west of the mark.
    West,
    /// A danger under the mark, with safe water all round.
    IsolatedDanger,
    /// Safe water all round.
    SafeWater,
    /// An area or a thing of its own kind.
    Special,
    /// The chart does not say.
    Other,
}

impl MarkMeaning {
    /// All meanings.
    pub const ALL: [MarkMeaning; 9] = [
        MarkMeaning::Lateral,
        MarkMeaning::North,
        MarkMeaning::East,
        MarkMeaning::South,
        MarkMeaning::West,
        MarkMeaning::IsolatedDanger,
        MarkMeaning::SafeWater,
        MarkMeaning::Special,
        MarkMeaning::Other,
    ];

    /// The word for this meaning in GeoJSON files and in messages to web pages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            MarkMeaning::Lateral => "lateral",
            MarkMeaning::North => "north",
            MarkMeaning::East => "east",
            MarkMeaning::South => "south",
            MarkMeaning::West => "west",
            MarkMeaning::IsolatedDanger => "isolated_danger",
            MarkMeaning::SafeWater => "safe_water",
            MarkMeaning::Special => "special",
            MarkMeaning::Other => "other",
        }
    }
}

/// Shapes of buoys and beacons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkShape {
    /// A cone.
    Cone,
    /// A can.
    Can,
    /// A ball.
    Ball,
    /// A pillar: a narrow tower on a float.
    Pillar,
    /// A spar, stake or pole.
    Spar,
    /// A barrel.
    Barrel,
    /// A tower.
    Tower,
}

impl MarkShape {
    /// All shapes.
    pub const ALL: [MarkShape; 7] = [
        MarkShape::Cone,
        MarkShape::Can,
        MarkShape::Ball,
        MarkShape::Pillar,
        MarkShape::Spar,
        MarkShape::Barrel,
        MarkShape::Tower,
    ];

    /// The word for this shape in GeoJSON files and in messages to web pages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            MarkShape::Cone => "cone",
            MarkShape::Can => "can",
            MarkShape::Ball => "ball",
            MarkShape::Pillar => "pillar",
            MarkShape::Spar => "spar",
            MarkShape::Barrel => "barrel",
            MarkShape::Tower => "tower",
        }
    }
}

/// Colours of buoys and beacons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkColour {
    /// Red: a lateral mark, to port in IALA's region A, to starboard in region B.
    Red,
    /// Green: a lateral mark, to starboard in IALA's region A, to port in region B.
    Green,
    /// Yellow: a special mark.
    Yellow,
    /// Black with yellow or red: a cardinal mark, or the mark of an isolated danger.
    Black,
    /// White: a mark of safe water (with red stripes), or another mark.
    White,
}

impl MarkColour {
    /// All colours.
    pub const ALL: [MarkColour; 5] = [
        MarkColour::Red,
        MarkColour::Green,
        MarkColour::Yellow,
        MarkColour::Black,
        MarkColour::White,
    ];

    /// The word for this colour in GeoJSON files and in messages to web pages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            MarkColour::Red => "red",
            MarkColour::Green => "green",
            MarkColour::Yellow => "yellow",
            MarkColour::Black => "black",
            MarkColour::White => "white",
        }
    }
}

/// Sides of a fairway.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkSide {
    /// The mark lies to port of an entering ship. A mark to port has the shape of a can.
    Port,
    /// The mark lies to starboard of an entering ship. A mark to starboard has the shape of a cone.
    Starboard,
}

impl MarkSide {
    /// Both sides.
    pub const ALL: [MarkSide; 2] = [MarkSide::Port, MarkSide::Starboard];

    /// The word for this side in GeoJSON files and in messages to web pages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            MarkSide::Port => "port",
            MarkSide::Starboard => "starboard",
        }
    }
}
