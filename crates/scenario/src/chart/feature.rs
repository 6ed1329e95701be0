//! Turns the features of a GeoJSON file into the features of a chart.

use fenderline_contact::{Outline, OutlineError, Vec2};
use fenderline_sim::chart::{ChartFeature, ChartKind, ChartMark, ChartShape, MarkColour, MarkSide};

use super::geojson::{Coordinates, Properties, Raw};
use super::placing::{Budget, MOST_FEATURES, MOST_POINTS, Placing};
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

/// Longest name of a chart's feature (bytes), the same as for a body.
const LONGEST_NAME: usize = 200;
/// Bounds of the depths in a chart (m); areas that fall dry have negative depths.
const DEPTHS_M: [f64; 2] = [-30.0, 12_000.0];

type Read<T> = Result<T, String>;

/// Reads features. Reads features of a file. An error is a text without the feature's name; the caller adds the name.
pub(super) struct Reading<'r> {
    pub(super) placing: &'r Placing,
    pub(super) budget: &'r mut Budget,
}

impl Reading<'_> {
    /// The features of the chart that follow from a feature of a file: one feature for each part of the geometry.
    ///
    /// # Errors
    /// Says why the feature of the file is not a feature of a chart.
    pub(super) fn features(&mut self, raw: &Raw) -> Read<Vec<ChartFeature>> {
        if raw.kind != "Feature" {
            return Err(format!("the feature's `type` is {}, not \"Feature\"", quoted(&raw.kind)));
        }
        let none = Properties::default();
        let given = raw.properties.as_ref().unwrap_or(&none);
        let kind = kind(given)?;
        let name = name(given)?;
        let (depth_m, mark) = (depth(given, kind)?, mark(given, kind)?);
        let shapes = self.shapes(raw)?;
        let feature = |shape| {
            check_shape(kind, &shape)?;
            Ok(ChartFeature { kind, name: name.clone(), shape, depth_m, mark })
        };
        let features: Vec<ChartFeature> = shapes.into_iter().map(feature).collect::<Read<_>>()?;
        if kind == ChartKind::Name && name.is_empty() {
            return Err("the feature is a name, but has no property `name`".to_owned());
        }
        Ok(features)
    }

    fn shapes(&mut self, raw: &Raw) -> Read<Vec<ChartShape>> {
        let Some(geometry) = &raw.geometry else {
            return Err("the feature has no `geometry`".to_owned());
        };
        let given = || {
            let missing = || format!("the feature's {} has no `coordinates`", geometry.kind);
            geometry.coordinates.as_ref().ok_or_else(missing)
        };
        let shapes = match geometry.kind.as_str() {
            "Point" => vec![ChartShape::Point(self.point(given()?)?)],
            "LineString" => vec![ChartShape::Line(self.line(given()?)?)],
            "Polygon" => vec![ChartShape::Area(self.rings(given()?)?)],
            "MultiPoint" => {
                self.each(given()?, |this, at| this.point(at).map(ChartShape::Point))?
            }
            "MultiLineString" => {
                self.each(given()?, |this, line| this.line(line).map(ChartShape::Line))?
            }
            "MultiPolygon" => {
                self.each(given()?, |this, rings| this.rings(rings).map(ChartShape::Area))?
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

    fn point(&mut self, at: &Coordinates) -> Read<Vec2> {
        let Coordinates::Position(position) = at else {
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
        let (Some(Coordinates::Position(first)), Some(Coordinates::Position(last))) =
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
        check_ring(&ring)?;
        Ok(ring)
    }
}

fn list(of: &Coordinates) -> Read<&[Coordinates]> {
    match of {
        Coordinates::List(list) => Ok(list),
        _ => Err("the feature's coordinates are not nested as its geometry needs".to_owned()),
    }
}

/// Checks that a ring is a simple polygon, with the check of the contact engine.
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
        return Err(format!("the feature has no property `kind`, which must be one of {}", all()));
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
    let has_depth = matches!(kind, ChartKind::DepthArea | ChartKind::DepthContour);
    match given.depth_m {
        None if has_depth => Err(format!("a {} needs `depth_m`", kind.word())),
        None => Ok(None),
        Some(_) if !has_depth => Err(format!("a {} has no `depth_m`", kind.word())),
        Some(depth_m) if (DEPTHS_M[0]..=DEPTHS_M[1]).contains(&depth_m) => Ok(Some(depth_m)),
        Some(depth_m) => Err(format!(
            "the feature's `depth_m` must be between {} and {}, but is {depth_m}",
            DEPTHS_M[0], DEPTHS_M[1]
        )),
    }
}

fn mark(given: &Properties, kind: ChartKind) -> Read<Option<ChartMark>> {
    if !matches!(kind, ChartKind::Buoy | ChartKind::Beacon) {
        let key = [(&given.colour, "colour"), (&given.side, "side")];
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
    Ok(Some(ChartMark { colour, side }))
}

fn word<T: Copy>(key: &str, given: &str, words: &[(&str, T)]) -> Read<T> {
    words.iter().find(|(word, _)| *word == given).map(|(_, value)| *value).ok_or_else(|| {
        let all: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        format!("the feature's `{key}` is {}, not one of {}", quoted(given), all.join(", "))
    })
}

/// Checks that a kind of feature may have a shape: a point, a line or an area.
fn check_shape(kind: ChartKind, shape: &ChartShape) -> Read<()> {
    let (is, fits) = match shape {
        ChartShape::Point(_) => {
            ("a point", matches!(kind, ChartKind::Buoy | ChartKind::Beacon | ChartKind::Name))
        }
        ChartShape::Line(_) => (
            "a line",
            matches!(
                kind,
                ChartKind::Coast
                    | ChartKind::DepthContour
                    | ChartKind::Quay
                    | ChartKind::LeadingLine
            ),
        ),
        ChartShape::Area(_) => {
            ("an area", matches!(kind, ChartKind::Coast | ChartKind::DepthArea | ChartKind::Quay))
        }
    };
    if fits { Ok(()) } else { Err(format!("a {} cannot be {is}", kind.word())) }
}
