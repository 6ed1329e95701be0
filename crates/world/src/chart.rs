//! The chart of a berth: the background on which ships and quays are drawn. It exerts no force.

use fenderline_contact::Vec2;

/// A chart in the scenario's coordinates; empty by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// The features of the chart, in the order of its files. A geometry of several parts gives several features.
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
    /// Name of the feature; empty if it has none.
    pub name: String,
    /// Shape and position of the feature.
    pub shape: ChartShape,
    /// Depth below chart datum; for a depth area, the least depth (m). `None` for other kinds.
    pub depth_m: Option<f64>,
    /// Colour and side of a buoy or beacon; `None` for other kinds.
    pub mark: Option<ChartMark>,
}

/// Kinds of features of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartKind {
    /// Land, or the line where it begins.
    Coast,
    /// An area in which the water has at least some depth.
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
    /// A name alone.
    Name,
}

impl ChartKind {
    /// All kinds, in the order in which they are drawn.
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

    /// The word for the kind in GeoJSON files and in messages to pages.
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

/// A shape, in the scenario's coordinates: north and east (m).
#[derive(Clone, Debug, PartialEq)]
pub enum ChartShape {
    /// A point.
    Point(Vec2),
    /// A line through points.
    Line(Vec<Vec2>),
    /// An area: the outer ring, then the rings of the holes. No ring repeats its first point at the end.
    Area(Vec<Vec<Vec2>>),
}

impl ChartShape {
    /// All points of the shape (m).
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
    /// The side of the fairway that the mark shows to a ship that enters; `None`: not a lateral mark.
    pub side: Option<MarkSide>,
}

/// Colours of buoys and beacons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkColour {
    /// Red: lateral, port in IALA's region A, starboard in region B.
    Red,
    /// Green: lateral, starboard in IALA's region A, port in region B.
    Green,
    /// Yellow: special.
    Yellow,
    /// Black, with yellow or red: cardinal marks and isolated dangers.
    Black,
    /// White: safe water (with red stripes), and other marks.
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

    /// The word for the colour in GeoJSON files and in messages to pages.
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
    /// The mark is to port of a ship that enters. The mark has the shape of a can.
    Port,
    /// The mark is to starboard of a ship that enters. The mark has the shape of a cone.
    Starboard,
}

impl MarkSide {
    /// Both sides.
    pub const ALL: [MarkSide; 2] = [MarkSide::Port, MarkSide::Starboard];

    /// The word for the side in GeoJSON files and in messages to pages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            MarkSide::Port => "port",
            MarkSide::Starboard => "starboard",
        }
    }
}
