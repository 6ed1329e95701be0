//! Builds a hull from a body's outlines at several heights.

use fenderline_contact::Outline;
use fenderline_sim::{BodySetup, FenderSetup, HullByHeight, HullError, Level, Setup};

use super::assembly::{Assembly, Checked};
use super::vessel;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::{Notice, ScenarioError};
use fenderline_keys::held::ListOf;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::keys::hull::OutlineAtHeightKey;
use fenderline_keys::sources::quoted;

/// Height above the water to which the sides of a vessel with one outline reach (m); it is higher than any fender.
const HIGH_M: f64 = 60.0;

impl Assembly<'_, '_> {
    /// Reads the outlines of a body at several heights; `None` for a body with one outline.
    pub(super) fn hull(
        &self,
        table: Of<'_, BodyKey>,
        kind: Option<&vessel::Kind>,
    ) -> Checked<Option<HullByHeight>> {
        let draught = table.item(BodyKey::DRAUGHT);
        let Some(item) = table.item(BodyKey::OUTLINES) else {
            return match draught {
                None => Ok(None),
                Some(draught) => {
                    let why = |path: &str| format!("`{path}` is for a body with `outlines`");
                    Err(self.draught_refused(table, draught, why))
                }
            };
        };
        if let Some(outline) = table.first_of(any_keys![BodyKey: OUTLINE, CHART_OUTLINE]) {
            let path = table.path_to(outline);
            let message = format!("`{path}` does not go together with `outlines`");
            let error = self.sources.error(&outline.key_span, &path, message);
            return Err(error.with_help("keep only one of the two keys"));
        }
        let fixed = *table.given(BodyKey::FIXED).flag();
        let draught_m = match (fixed, kind, draught) {
            (true, _, Some(draught)) => {
                let why = |path: &str| {
                    format!(
                        "`{path}` is for floating bodies: heights on a fixed body are above datum"
                    )
                };
                return Err(self.draught_refused(table, draught, why));
            }
            (true, _, None) => 0.0,
            (false, Some(_), Some(draught)) => {
                let why = |path: &str| {
                    format!(
                        "`{path}` does not go together with `vessel`, which has its own draught"
                    )
                };
                return Err(self.draught_refused(table, draught, why));
            }
            (false, Some(kind), None) => kind.draught_m(),
            (false, None, Some(draught)) => *draught.number(),
            (false, None, None) => {
                let help =
                    "write draught = \"9 m\", because the heights of `outlines` are above the keel";
                return Err(self.missing(table, BodyKey::DRAUGHT, help));
            }
        };
        let levels = item.list().iter().map(|level| Level {
            height_m: *level.given(OutlineAtHeightKey::HEIGHT).number(),
            vertices_m: level.given(OutlineAtHeightKey::OUTLINE).outline().to_vec(),
        });
        let hull = HullByHeight::new(levels.collect(), draught_m);
        hull.map(Some).map_err(|error| self.no_hull(table, item, fixed, &error))
    }

    /// Makes a hull with vertical sides from one outline, for a vessel whose heave, roll and pitch move her sides at
    /// the fenders. The upper end of these sides is not known, so the program takes the sides to be high.
    pub(super) fn vertical_sides<T>(
        &self,
        table: Of<'_, T>,
        kind: &vessel::Kind,
        outline: &Outline,
    ) -> Checked<HullByHeight> {
        let draught_m = kind.draught_m();
        let level = |height_m: f64| Level { height_m, vertices_m: outline.vertices().to_vec() };
        let levels = vec![level(0.0), level(draught_m + HIGH_M)];
        HullByHeight::new(levels, draught_m).map_err(|error| self.wrong(table, &error))
    }

    fn draught_refused<T, V>(
        &self,
        table: Of<'_, T>,
        draught: Entry<'_, V>,
        why: fn(&str) -> String,
    ) -> ScenarioError {
        let path = table.path_to(draught);
        self.sources.error(&draught.key_span, &path, why(&path))
    }

    /// The error for outlines that do not form a hull; it points to the outline that causes the error.
    fn no_hull<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, ListOf<OutlineAtHeightKey>>,
        fixed: bool,
        error: &HullError,
    ) -> ScenarioError {
        let (level, key) = match *error {
            HullError::TooFew { .. }
            | HullError::TooMany { .. }
            | HullError::WaterlineOutside { .. } => (None, OutlineAtHeightKey::OUTLINE.any()),
            HullError::NotAscending { level, .. } => {
                (Some(level), OutlineAtHeightKey::HEIGHT.any())
            }
            HullError::BadOutline { level, .. }
            | HullError::TooManyVertices { level, .. }
            | HullError::TurnsBack { level }
            | HullError::Crossing { level, .. } => (Some(level), OutlineAtHeightKey::OUTLINE.any()),
        };
        let (span, path) = match level.map(|level| item.list().at(level)) {
            Some(at) => (&at.given(key).item().span, at.path_of(key)),
            None => (&item.item().span, table.path_to(item)),
        };
        let complaint = self.sources.error(span, &path, format!("`{path}`: {error}"));
        complaint.with_help(match error {
            HullError::TooFew { .. } => {
                "give a second outline in `outlines`, or one `outline` for \
                a hull with vertical sides"
            }
            HullError::TooMany { .. } => "two or three outlines are enough for most hulls",
            HullError::TooManyVertices { .. } => {
                "leave out vertices where the side is nearly \
                straight"
            }
            HullError::NotAscending { .. } => {
                "write the lowest outline first, and the others with \
                rising heights"
            }
            HullError::BadOutline { .. } => "an outline is a polygon whose sides do not cross",
            HullError::TurnsBack { .. } => "give the same number of vertices in every outline",
            HullError::Crossing { .. } => {
                "vertex n of one outline must be at the same place of the hull as vertex n of the \
                 next"
            }
            HullError::WaterlineOutside { .. } if fixed => {
                "heights of `outlines` on a fixed body \
                are above datum; add an outline"
            }
            HullError::WaterlineOutside { .. } => {
                "heights of `outlines` are above the keel, so the waterline is at the height of \
                 the draught; add an outline above or below this height"
            }
        })
    }

    /// Warns of fenders that, at some level of the water, lie above or below all outlines of a hull.
    pub(super) fn note_outside_hulls(&mut self, fenders: Tables<'_, FenderKey>, setup: &Setup) {
        let levels_m = setup.world.environment.level_range_m();
        // First of all the few bodies with a hull by height: fenders times bodies times pairs may be very many.
        let bodies = setup.bodies.iter().enumerate();
        let hulls: Vec<_> = bodies.filter(|(_, body)| body.hull.is_some()).collect();
        for ((_, table), fender) in fenders.iter().zip(&setup.fenders) {
            let host = &setup.bodies[fender.body];
            for &(index, body) in &hulls {
                if index == fender.body || !setup.may_touch([index, fender.body]) {
                    continue;
                }
                let Some(message) = outside(fender, host, body, levels_m) else { continue };
                let above = table.item_if_any(FenderKey::ABOVE_WATER);
                let (span, key) = match above {
                    Some(item) => (&item.item().span, table.path_to(item)),
                    None => (&table.span, table.path.clone()),
                };
                self.notices.push(Notice { place: self.sources.place(span), key, message });
            }
        }
    }
}

/// A message about a fender that misses a hull at rest at some level of the water; `None` if the fender meets the
/// hull at every level.
fn outside(
    fender: &FenderSetup,
    host: &BodySetup,
    body: &BodySetup,
    levels_m: [f64; 2],
) -> Option<String> {
    let hull = body.hull.as_ref()?;
    let [low_m, high_m] = hull.range_m();
    let rides = fender.floating || !host.is_fixed();
    let half_m = 0.5 * fender.height_m;
    let heights_m = levels_m.map(|level_m| match (rides, body.is_fixed()) {
        (true, true) => fender.above_water_m + level_m,
        (true, false) => fender.above_water_m + hull.draught_m(),
        (false, true) => fender.above_water_m,
        (false, false) => fender.above_water_m - level_m + hull.draught_m(),
    });
    let from = if body.is_fixed() { "datum" } else { "the keel" };
    heights_m.into_iter().find_map(|height_m| {
        let off = |which: &str, end_m: f64| {
            format!(
                "the fender is {height_m:.2} m above {from}, and the {which} outline of {} is at \
                 {end_m} m: at rest there is no contact at this fender",
                quoted(&body.name)
            )
        };
        if height_m - half_m > high_m {
            return Some(off("highest", high_m));
        }
        (height_m + half_m < low_m).then(|| off("lowest", low_m))
    })
}
