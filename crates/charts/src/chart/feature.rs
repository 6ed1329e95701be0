//! Turns the features of a GeoJSON file into the features of a chart.

use fenderline_contact::{Outline, OutlineError, Vec2};
use fenderline_sim::chart::{
    ChartFeature, ChartKind, ChartLight, ChartMark, ChartShape, MarkColour, MarkMeaning, MarkShape,
    MarkSide,
};

use super::bounds::{DEPTHS_M, LONGEST_NAME};
use super::geojson::{Coordinates, Properties, Raw};
use super::placing::{Budget, MOST_FEATURES, MOST_POINTS, Placing};
use super::ring;
use super::s57::{self, Attributes, Class};
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

type Read<T> = Result<T, String>;

/// Reads the features of a GeoJSON file. Error texts do not contain the name of the feature; the caller adds the name.
pub(super) struct Reading<'r> {
    /// File and number of the feature that is read: see [`ChartFeature::place`].
    pub(super) place: [usize; 2],
    pub(super) placing: &'r Placing,
    pub(super) budget: &'r mut Budget,
    /// How the rings of areas are checked.
    pub(super) rings: Rings,
}

/// How the rings of areas are checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rings {
    /// As strictly as the outlines of bodies: a ring must not touch itself.
    Outlines,
    /// As electronic charts need it: a ring may touch itself, but must not cross itself.
    Charted,
}

/// The reason why a feature of an electronic chart (S-57) is not taken into the chart.
pub(super) enum Refusal {
    /// The feature is left out, and counted among the features left out for this reason.
    LeftOut(&'static str),
    /// The feature is left out because a ring crosses itself, and the user gets a notice.
    Crossed(String),
    /// The whole file is refused because of this feature.
    Refused(String),
}

impl Reading<'_> {
    /// Makes the chart's features from one feature of the file: one for each part of the feature's geometry.
    ///
    /// # Errors
    /// Says why the feature of the file cannot be a feature of the chart.
    pub(super) fn features(&mut self, raw: &Raw) -> Read<Vec<ChartFeature>> {
        if raw.kind != "Feature" {
            return Err(format!("the feature's `type` is {}, not \"Feature\"", quoted(&raw.kind)));
        }
        let none = Properties::default();
        let given = raw.properties.as_ref().unwrap_or(&none);
        let kind = kind(given)?;
        let of_kind = own_attributes(given, kind)?;
        let shapes = self.shapes(raw)?;
        let class = (kind, kind.word(), self.place);
        let feature = |(shape, _)| {
            check_shape(kind, &shape)?;
            Ok(charted(class, shape, &of_kind))
        };
        let features: Vec<ChartFeature> = shapes.into_iter().map(feature).collect::<Read<_>>()?;
        if kind == ChartKind::Name && of_kind.name.is_empty() {
            return Err("the feature is a name, but has no property `name`".to_owned());
        }
        Ok(features)
    }

    /// Does the same as [`Reading::features`] for a feature of an electronic chart (S-57).
    ///
    /// # Errors
    /// [`Refusal`].
    pub(super) fn of_s57(&mut self, raw: &Raw, class: Class) -> Result<Vec<ChartFeature>, Refusal> {
        let none = Properties::default();
        let given = raw.properties.as_ref().unwrap_or(&none);
        let attributes = Attributes::of(class, given).map_err(Refusal::LeftOut)?;
        if raw.geometry.is_none() {
            return Err(Refusal::LeftOut("no geometry"));
        }
        let shapes = self.shapes(raw).map_err(|why| match why.strip_prefix(CROSSES) {
            Some(_) => Refusal::Crossed(why),
            None => Refusal::Refused(why),
        })?;
        let fits = |shape: &ChartShape| match class.kind {
            ChartKind::DepthArea
            | ChartKind::DredgedArea
            | ChartKind::UnsurveyedArea
            | ChartKind::Coverage => matches!(shape, ChartShape::Area(_)),
            ChartKind::DepthContour => matches!(shape, ChartShape::Line(_)),
            ChartKind::Buoy | ChartKind::Beacon | ChartKind::Light | ChartKind::Sounding => {
                matches!(shape, ChartShape::Point(_))
            }
            _ => true,
        };
        if !shapes.iter().all(|(shape, _)| fits(shape)) {
            return Err(Refusal::LeftOut("its class does not allow its geometry"));
        }
        let of_class = (class.kind, class.word, self.place);
        if class.kind == ChartKind::Sounding {
            let in_range = |depth_m: &f64| (DEPTHS_M[0]..=DEPTHS_M[1]).contains(depth_m);
            let depth_of = |third: Option<f64>| third.filter(in_range).or(attributes.depth_m);
            if shapes.iter().any(|(_, third)| depth_of(*third).is_none()) {
                return Err(Refusal::LeftOut("no depth"));
            }
            let sounding = |(shape, third)| {
                let feature = charted(of_class, shape, &attributes);
                ChartFeature { depth_m: depth_of(third), ..feature }
            };
            return Ok(shapes.into_iter().map(sounding).collect());
        }
        let charted = |(shape, _)| charted(of_class, shape, &attributes);
        Ok(shapes.into_iter().map(charted).collect())
    }

    /// The parts of a feature's geometry; a point comes with its third coordinate, if it has one.
    fn shapes(&mut self, raw: &Raw) -> Read<Vec<(ChartShape, Option<f64>)>> {
        let Some(geometry) = &raw.geometry else {
            return Err("the feature has no `geometry`".to_owned());
        };
        let given = || {
            let missing = || format!("the feature's {} has no `coordinates`", geometry.kind);
            geometry.coordinates.as_ref().ok_or_else(missing)
        };
        let shapes = match geometry.kind.as_str() {
            "Point" => vec![self.sounded(given()?)?],
            "LineString" => vec![(ChartShape::Line(self.line(given()?)?), None)],
            "Polygon" => vec![(ChartShape::Area(self.rings(given()?)?), None)],
            "MultiPoint" => self.each(given()?, Reading::sounded)?,
            "MultiLineString" => {
                self.each(given()?, |this, line| Ok((ChartShape::Line(this.line(line)?), None)))?
            }
            "MultiPolygon" => {
                self.each(given()?, |this, rings| Ok((ChartShape::Area(this.rings(rings)?), None)))?
            }
            "GeometryCollection" => {
                return Err(
                    "a GeometryCollection cannot be read: make each of its parts a separate \
                            feature"
                        .to_owned(),
                );
            }
            other => {
                return Err(format!(
                    "the feature's geometry is {}, which is not a geometry of GeoJSON",
                    quoted(other)
                ));
            }
        };
        // Each of these takes a place in messages and pictures.
        self.budget.features = self.budget.features.checked_sub(shapes.len()).ok_or_else(|| {
            format!("with this feature the chart has more than {MOST_FEATURES} parts")
        })?;
        Ok(shapes)
    }

    fn each<T>(
        &mut self,
        all: &Coordinates,
        mut one: impl FnMut(&mut Self, &Coordinates) -> Read<T>,
    ) -> Read<Vec<T>> {
        list(all)?.iter().map(|part| one(self, part)).collect()
    }

    fn sounded(&mut self, at: &Coordinates) -> Read<(ChartShape, Option<f64>)> {
        let point = ChartShape::Point(self.point(at)?);
        let Coordinates::Position(_, third) = at else { return Ok((point, None)) };
        Ok((point, *third))
    }

    fn point(&mut self, at: &Coordinates) -> Read<Vec2> {
        let Coordinates::Position(position, _) = at else {
            return Err("a position must be a list of two numbers".to_owned());
        };
        self.budget.points = self.budget.points.checked_sub(1).ok_or_else(|| {
            format!("with this feature the chart has more than {MOST_POINTS} points")
        })?;
        self.placing.place(*position)
    }

    fn line(&mut self, line: &Coordinates) -> Read<Vec<Vec2>> {
        let line = self.each(line, |this, at| this.point(at))?;
        if line.len() < 2 {
            return Err(format!(
                "a line must have two points or more, but this line has {}",
                line.len()
            ));
        }
        Ok(line)
    }

    /// The rings of a polygon, each without its last point, which repeats the first point.
    fn rings(&mut self, rings: &Coordinates) -> Read<Vec<Vec<Vec2>>> {
        let rings = self.each(rings, Reading::ring)?;
        if rings.is_empty() {
            return Err("the feature's polygon has no ring".to_owned());
        }
        Ok(rings)
    }

    fn ring(&mut self, ring: &Coordinates) -> Read<Vec<Vec2>> {
        // The points are compared as written, which makes an error easier to understand; projected
        // points would compare equally well.
        let (Some(Coordinates::Position(first, _)), Some(Coordinates::Position(last, _))) =
            (list(ring)?.first(), list(ring)?.last())
        else {
            return Err("a ring of a polygon must be a list of positions".to_owned());
        };
        if first != last {
            return Err(format!(
                "the feature's ring is not closed: the ring begins at {first:?} and ends at \
                 {last:?}"
            ));
        }
        let mut ring = self.each(ring, |this, at| this.point(at))?;
        ring.pop();
        if ring.len() < 3 {
            let count = ring.len();
            return Err(format!(
                "a ring must have three corners or more, but this ring has {count}"
            ));
        }
        match self.rings {
            Rings::Outlines => check_ring(&ring)?,
            Rings::Charted => check_charted(&ring)?,
        }
        Ok(ring)
    }
}

fn list(of: &Coordinates) -> Read<&[Coordinates]> {
    match of {
        Coordinates::List(list) => Ok(list),
        _ => Err("the feature's coordinates are not nested as its geometry needs".to_owned()),
    }
}

/// The error text for a ring that crosses itself begins with these words.
const CROSSES: &str = "its ring crosses itself";

/// Checks that a ring of an electronic chart does not cross itself.
fn check_charted(ring: &[Vec2]) -> Read<()> {
    match ring::crossing(ring) {
        Ok(None) => Ok(()),
        Ok(Some(at_m)) => {
            Err(format!("{CROSSES} {:.1} m north and {:.1} m east of the origin", at_m.x, at_m.y))
        }
        Err(ring::Tangled) => Err("its ring is too tangled to check".to_owned()),
    }
}

/// Makes the chart's feature for one part of a geometry.
fn charted(
    (kind, class, place): (ChartKind, &'static str, [usize; 2]),
    shape: ChartShape,
    of: &Attributes,
) -> ChartFeature {
    ChartFeature {
        kind,
        class,
        place,
        name: of.name.clone(),
        shape,
        depth_m: of.depth_m,
        deepest_m: of.deepest_m,
        mark: of.mark,
        light: of.light.clone(),
        clearance_m: of.clearance_m,
    }
}

/// Reads the properties of a feature that names its `kind` itself, unlike features of S-57.
fn own_attributes(given: &Properties, kind: ChartKind) -> Read<Attributes> {
    let name = name(given)?;
    let depth_m = depth(given, kind)?;
    let deepest_m = allowed(given.deepest_m, "deepest_m", kind, kind.is_area_of_depth(), DEPTHS_M)?;
    if let (Some(least_m), Some(most_m)) = (depth_m, deepest_m)
        && most_m < least_m
    {
        return Err(format!("its `deepest_m` of {most_m} is less than its `depth_m` of {least_m}"));
    }
    let has_clearance = matches!(kind, ChartKind::Bridge | ChartKind::Cable);
    let clearance_m =
        allowed(given.clearance_m, "clearance_m", kind, has_clearance, [0.0, 1_000.0])?;
    let (mark, light) = (mark(given, kind)?, own_light(given, kind)?);
    Ok(Attributes { name, depth_m, deepest_m, mark, light, clearance_m })
}

/// Checks a property that only some kinds of features may have, and its range; `has` says whether this kind may have
/// it.
fn allowed(
    given: Option<f64>,
    key: &str,
    kind: ChartKind,
    has: bool,
    [low, high]: [f64; 2],
) -> Read<Option<f64>> {
    match given {
        None => Ok(None),
        Some(_) if !has => Err(format!("a {} has no `{key}`", kind.word())),
        Some(value) if (low..=high).contains(&value) => Ok(Some(value)),
        Some(value) => Err(format!("its `{key}` must be between {low} and {high}, but is {value}")),
    }
}

fn own_light(given: &Properties, kind: ChartKind) -> Read<Option<ChartLight>> {
    let has = kind == ChartKind::Light;
    let period_s = allowed(given.period_s, "period_s", kind, has, [0.0, 1_000.0])?;
    let range_m = allowed(given.range_m, "range_m", kind, has, [0.0, 200_000.0])?;
    let of_light =
        [("character", given.character.is_some()), ("sector_deg", given.sector_deg.is_some())];
    if !has {
        return match of_light.iter().find(|(_, is_given)| *is_given) {
            Some((key, _)) => Err(format!("a {} has no `{key}`", kind.word())),
            None => Ok(None),
        };
    }
    let Some(colour) = &given.colour else {
        return Err(format!("a {} needs `colour`", kind.word()));
    };
    let colour = word("colour", colour, &MarkColour::ALL.map(|colour| (colour.word(), colour)))?;
    let character = given.character.clone().unwrap_or_default();
    if character.len() > LONGEST_NAME || character.contains(char::is_control) {
        return Err(format!(
            "its `character` is longer than {LONGEST_NAME} bytes or no line of text"
        ));
    }
    let sector_rad = given.sector_deg.map(|sector_deg| sector_deg.map(s57::direction_rad));
    Ok(Some(ChartLight { colour, character, period_s, sector_rad, range_m }))
}

/// Checks that a ring is a simple polygon, by the engine's check for outlines.
fn check_ring(ring: &[Vec2]) -> Read<()> {
    match Outline::new(ring) {
        Ok(_) => Ok(()),
        Err(error @ OutlineError::SelfIntersection { .. }) => {
            Err(format!("the feature's ring crosses or touches itself: {error}"))
        }
        Err(error) => Err(format!("the feature's ring is not an area: {error}")),
    }
}

fn kind(given: &Properties) -> Read<ChartKind> {
    let words = || ChartKind::ALL.iter().map(|kind| kind.word());
    let all = || words().collect::<Vec<_>>().join(", ");
    let Some(word) = &given.kind else {
        return Err(format!(
            "the feature has no property `kind`, which must be one of {}; a feature of S-57 has `OBJL`, or its file the `name` of the layer",
            all()
        ));
    };
    ChartKind::ALL.iter().copied().find(|kind| kind.word() == word).ok_or_else(|| {
        match nearest(word, words()) {
            Some(near) => {
                format!("the feature's `kind` is {}; did you mean \"{near}\"?", quoted(word))
            }
            None => format!("the feature's `kind` is {}, not one of {}", quoted(word), all()),
        }
    })
}

fn name(given: &Properties) -> Read<String> {
    let name = given.name.as_deref().unwrap_or_default();
    if name.len() > LONGEST_NAME {
        return Err(format!("the feature's name is longer than {LONGEST_NAME} bytes"));
    }
    if name.contains(char::is_control) {
        return Err(
            "the feature's name has a line break or another control character in it".to_owned()
        );
    }
    Ok(name.trim().to_owned())
}

fn depth(given: &Properties, kind: ChartKind) -> Read<Option<f64>> {
    let needs =
        kind.is_area_of_depth() || matches!(kind, ChartKind::DepthContour | ChartKind::Sounding);
    if needs && given.depth_m.is_none() {
        return Err(format!("a {} needs `depth_m`", kind.word()));
    }
    let may = matches!(kind, ChartKind::Rock | ChartKind::Obstruction | ChartKind::Wreck);
    allowed(given.depth_m, "depth_m", kind, needs || may, DEPTHS_M)
}

fn mark(given: &Properties, kind: ChartKind) -> Read<Option<ChartMark>> {
    if !matches!(kind, ChartKind::Buoy | ChartKind::Beacon) {
        let has_colour = kind == ChartKind::Light;
        let key = [
            (given.colour.as_ref().filter(|_| !has_colour), "colour"),
            (given.side.as_ref(), "side"),
            (given.meaning.as_ref(), "meaning"),
            (given.shape.as_ref(), "shape"),
        ];
        return match key.iter().find(|(value, _)| value.is_some()) {
            Some((_, key)) => Err(format!("a {} has no `{key}`", kind.word())),
            None => Ok(None),
        };
    }
    let Some(colour) = &given.colour else {
        return Err(format!("a {} needs `colour`", kind.word()));
    };
    let colours = MarkColour::ALL.map(|colour| (colour.word(), colour));
    let sides = MarkSide::ALL.map(|side| (side.word(), side));
    let colour = word("colour", colour, &colours)?;
    let side = given.side.as_deref().map(|side| word("side", side, &sides)).transpose()?;
    let meanings = MarkMeaning::ALL.map(|meaning| (meaning.word(), meaning));
    let said = given.meaning.as_deref().map(|said| word("meaning", said, &meanings)).transpose()?;
    let meaning = said.unwrap_or(match (side, colour) {
        (Some(_), _) => MarkMeaning::Lateral,
        (None, MarkColour::Yellow) => MarkMeaning::Special,
        (None, _) => MarkMeaning::Other,
    });
    if side.is_some() && meaning != MarkMeaning::Lateral {
        return Err("only a mark with the `meaning` \"lateral\" has a `side`".to_owned());
    }
    let shapes = MarkShape::ALL.map(|shape| (shape.word(), shape));
    let shape = given.shape.as_deref().map(|shape| word("shape", shape, &shapes)).transpose()?;
    Ok(Some(ChartMark { colour, side, meaning, shape }))
}

fn word<T: Copy>(key: &str, given: &str, words: &[(&str, T)]) -> Read<T> {
    words.iter().find(|(word, _)| *word == given).map(|(_, value)| *value).ok_or_else(|| {
        let all: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        format!("the feature's `{key}` is {}, not one of {}", quoted(given), all.join(", "))
    })
}

/// Checks that a feature of this kind may be a point, a line or an area, as its shape is.
fn check_shape(kind: ChartKind, shape: &ChartShape) -> Read<()> {
    use ChartKind as K;
    let (is, fits) = match shape {
        ChartShape::Point(_) => (
            "a point",
            matches!(
                kind,
                K::Buoy
                    | K::Beacon
                    | K::Name
                    | K::Light
                    | K::Sounding
                    | K::Rock
                    | K::Obstruction
                    | K::Wreck
                    | K::Mooring
                    | K::Landmark
            ),
        ),
        ChartShape::Line(_) => (
            "a line",
            matches!(
                kind,
                K::Coast
                    | K::DepthContour
                    | K::Quay
                    | K::LeadingLine
                    | K::Pontoon
                    | K::Berth
                    | K::Bridge
                    | K::Cable
            ),
        ),
        ChartShape::Area(_) => (
            "an area",
            !matches!(
                kind,
                K::Buoy
                    | K::Beacon
                    | K::Name
                    | K::Light
                    | K::Sounding
                    | K::DepthContour
                    | K::LeadingLine
                    | K::Cable
            ),
        ),
    };
    if fits { Ok(()) } else { Err(format!("a {} cannot be {is}", kind.word())) }
}
