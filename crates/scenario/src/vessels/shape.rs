//! Reads outline, chocks, bitts and belting, and checks that chocks, bitts and belting are on the vessel.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Outline, Vec2, vec2};
use fenderline_sim::hydro::Particulars;

use super::data::{Belting, DeckPoint};
use crate::vessels::keys::FileVesselKey;
use crate::vessels::keys::deck::{FileBeltingKey, FileDeckPointKey, FileOutlineKey, OutlineOrigin};
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{Number, Vector};
use fenderline_keys::sources::Sources;

type Read<T> = Result<T, ScenarioError>;

/// Relative tolerance of an outline's breadth, and of the outline's length if the length overall is known.
const FITS: f64 = 0.02;
/// Bounds of an outline's length divided by the length between perpendiculars, if the length overall is not known.
const OVERALL: [f64; 2] = [0.95, 1.2];
/// How far outside the vessel's outline a chock may be (m).
const OUTREACH_M: f64 = 1.0;

/// Reads the outline of a vessel, with vertices relative to midship.
pub(super) fn outline(
    sources: &Sources<'_>,
    table: Of<'_, FileVesselKey>,
    ship: &Particulars,
    length_overall: Option<Entry<'_, Number>>,
) -> Read<Option<Vec<Vec2>>> {
    let Some(inner) = table.item(FileVesselKey::OUTLINE).map(Entry::table) else { return Ok(None) };
    let item = inner.given(FileOutlineKey::POINTS);
    let path = inner.path_of(FileOutlineKey::POINTS);
    let complain =
        |message: String| sources.error(&item.span, &path, format!("`{path}`: {message}"));
    let forward_m = match inner.given(FileOutlineKey::ORIGIN).choice() {
        OutlineOrigin::Midship => 0.0,
        OutlineOrigin::AfterPerpendicular => -0.5 * ship.length_m,
        OutlineOrigin::CentreOfGravity => ship.centre_of_gravity_m,
    };
    let points: Vec<Vec2> =
        item.outline().iter().map(|point| *point + vec2(forward_m, 0.0)).collect();
    Outline::new(&points).map_err(|error| complain(error.to_string()))?;
    let extent = extent(&points);
    let (length_m, breadth_m) = (extent[1].x - extent[0].x, extent[1].y - extent[0].y);
    if (breadth_m / ship.beam_m - 1.0).abs() > FITS {
        let message = format!(
            "the outline is {breadth_m} m broad, but the vessel's beam is {} m",
            ship.beam_m
        );
        return Err(complain(message));
    }
    match length_overall {
        Some(overall) if (length_m / overall.number() - 1.0).abs() > FITS => {
            let overall_m = overall.number();
            Err(complain(format!(
                "the outline is {length_m} m long, but the vessel's length overall is {overall_m} m"
            )))
        }
        None if !(OVERALL[0]..=OVERALL[1]).contains(&(length_m / ship.length_m)) => {
            let message = format!(
                "the outline is {length_m} m long, but the vessel's length between perpendiculars \
                 is {} m",
                ship.length_m
            );
            Err(complain(message)
                .with_help("give `length_overall` if the outline's length is right"))
        }
        _ => Ok(Some(points)),
    }
}

/// The after port and forward starboard corners of the bounding rectangle of points.
fn extent(points: &[Vec2]) -> [Vec2; 2] {
    let start = [vec2(f64::INFINITY, f64::INFINITY), vec2(-f64::INFINITY, -f64::INFINITY)];
    points.iter().fold(start, |[low, high], point| {
        [
            vec2(lesser(low.x, point.x), lesser(low.y, point.y)),
            vec2(greater(high.x, point.x), greater(high.y, point.y)),
        ]
    })
}

/// Reads chocks or bitts.
pub(super) fn deck_points(
    sources: &Sources<'_>,
    tables: Tables<'_, FileDeckPointKey>,
    hull: &Hull<'_>,
) -> Read<Vec<DeckPoint>> {
    let read = |(name, table): (&String, Of<'_, _>)| {
        let item = table.given(FileDeckPointKey::AT);
        hull.check(sources, table, item)?;
        Ok(DeckPoint {
            name: name.clone(),
            at_m: *item.vector(),
            above_water_m: *table.given(FileDeckPointKey::HEIGHT).number(),
        })
    };
    tables.iter().map(read).collect()
}

/// Reads strips of belting.
pub(super) fn beltings(
    sources: &Sources<'_>,
    tables: Tables<'_, FileBeltingKey>,
    hull: &Hull<'_>,
) -> Read<Vec<Belting>> {
    let read = |(name, table): (&String, Of<'_, _>)| {
        let ends = [table.given(FileBeltingKey::FROM), table.given(FileBeltingKey::TO)];
        for end in ends {
            hull.check(sources, table, end)?;
        }
        let [from_m, to_m] = ends.map(|end| *end.vector());
        let along_m = to_m - from_m;
        let middle_m = (from_m + to_m) * 0.5;
        let across = vec2(-along_m.y, along_m.x);
        let outward = if across.dot(middle_m) < 0.0 { across * -1.0 } else { across };
        // If its line passes through midship, neither side is outward.
        if across.dot(middle_m).abs() < 1e-6 * along_m.length() || along_m.length() < 1e-3 {
            let path = &table.path;
            let message =
                format!("`{path}` must be a strip whose line does not pass through midship");
            return Err(sources.error(&ends[0].span, path, message));
        }
        Ok(Belting {
            name: name.clone(),
            middle_m,
            facing_rad: libm::atan2(outward.y, outward.x),
            width_m: along_m.length(),
            above_water_m: *table.given(FileBeltingKey::HEIGHT).number(),
            extent_m: *table.given(FileBeltingKey::EXTENT).number(),
        })
    };
    tables.iter().map(read).collect()
}

/// The hull of a vessel, on which points of the deck must lie.
pub(super) struct Hull<'h> {
    /// Vertices of the vessel's outline relative to midship, if known.
    pub(super) outline_m: Option<&'h [Vec2]>,
    /// Length and beam.
    pub(super) ship: &'h Particulars,
}

impl Hull<'_> {
    fn check<T>(
        &self,
        sources: &Sources<'_>,
        table: Of<'_, T>,
        item: Entry<'_, Vector>,
    ) -> Read<()> {
        let [low, high] = match self.outline_m {
            Some(points) => extent(points),
            None => {
                let corner = vec2(0.5 * OVERALL[1] * self.ship.length_m, 0.5 * self.ship.beam_m);
                [corner * -1.0, corner]
            }
        };
        let at = item.vector();
        let inside = |value: f64, low: f64, high: f64| {
            (low - OUTREACH_M..=high + OUTREACH_M).contains(&value)
        };
        if inside(at.x, low.x, high.x) && inside(at.y, low.y, high.y) {
            return Ok(());
        }
        let path = table.path_to(item);
        let message = format!("`{path}`: the point [{}, {}] m is not on the vessel", at.x, at.y);
        Err(sources.error(&item.span, &path, message))
    }
}
