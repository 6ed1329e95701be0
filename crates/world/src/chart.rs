//! The chart of a berth: the background on which ships and quays are drawn. The chart exerts no force.

use fenderline_contact::Vec2;

/// A chart in the scenario's coordinates; empty by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// The features of the chart, in the order of the chart's files. A geometry of several parts gives several features
    /// of the chart.
    pub features: Vec<ChartFeature>,
    /// The place of the scenario's origin, if the chart was given in longitude and latitude.
    pub origin: Option<GeographicPlace>,
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
    /// Name of the feature; empty if the feature has no name.
    pub name: String,
    /// Shape and position of the feature.
    pub shape: ChartShape,
    /// Depth of a depth contour, or least depth of a depth area, below chart datum (m). `None` for other kinds of
    /// features.
    pub depth_m: Option<f64>,
    /// Colour and side of a buoy or beacon; `None` for other kinds of features.
    pub mark: Option<ChartMark>,
}

/// Kinds of features of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartKind {
    /// Land, or the line where land begins.
    Coast,
    /// An area in which the water has at least a given depth.
    DepthArea,
    /// A line of equal depth.
    DepthContour,
    /// A quay, pier or jetty.
    Quay,
    /// A floating mark.
    Buoy,
    /// A fixed mark.
    Beacon,
    /// The line on which two marks are in transit.
    LeadingLine,
    /// A name at a place, without a shape.
    Name,
}

impl ChartKind {
    /// All kinds of features, in the order in which the features are drawn.
    pub const ALL: [ChartKind; 8] = [
        ChartKind::DepthArea,
        ChartKind::DepthContour,
        ChartKind::Coast,
        ChartKind::Quay,
        ChartKind::LeadingLine,
        ChartKind::Beacon,
        ChartKind::Buoy,
        ChartKind::Name,
    ];

    /// The word for this kind of feature in GeoJSON files and in messages to web pages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            ChartKind::Coast => "coast",
            ChartKind::DepthArea => "depth_area",
            ChartKind::DepthContour => "depth_contour",
            ChartKind::Quay => "quay",
            ChartKind::Buoy => "buoy",
            ChartKind::Beacon => "beacon",
            ChartKind::LeadingLine => "leading_line",
            ChartKind::Name => "name",
        }
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
