//! Reads the sea bottom, whose depth depends on the place, and checks whether ships begin aground.

use std::sync::Arc;

use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::chart::{Chart, GeographicPlace};
use fenderline_sim::{BodySetup, Bottom, Environment, Outside, Setup};

use super::assembly::{Assembly, Checked};
use super::rows::rounded;
use super::vessel::Kinds;
use fenderline_charts::bottom::{self, About, LAND_HEIGHT_M, Refusal, Request};
use fenderline_charts::chart::projection::Projected;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of, Tables, Value};
use fenderline_keys::held::TableOf;
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::bottom::BottomKey;
use fenderline_keys::keys::environment::EnvironmentKey;
use fenderline_keys::sources::quoted;

/// How far in front of a fender the bottom is looked at (m): under a ship that lies there.
const BEFORE_FENDER_M: f64 = 10.0;

/// A nautical chart. For a chart in longitude and latitude also the projection, the geographic position of the
/// scenario's origin, and whether the projection is UTM.
pub(super) struct Charted {
    pub(super) chart: Chart,
    pub(super) projected: Option<(Projected, GeographicPlace, bool)>,
}

impl Assembly<'_, '_> {
    /// The sea bottom, whose depth depends on the place; `None` if the scenario has no table `[environment.bottom]`.
    pub(super) fn bottom(
        &mut self,
        environment: Of<'_, EnvironmentKey>,
        charted: &Charted,
    ) -> Checked<Option<Bottom>> {
        let Some(item) = environment.item(EnvironmentKey::BOTTOM) else { return Ok(None) };
        if environment.item(EnvironmentKey::DEPTH).is_some() {
            let error = self.not_together(environment, item, "depth");
            return Err(error.with_help("keep one of the two: `depth` is the same everywhere"));
        }
        let of = item.table();
        let surveys = of.item(BottomKey::SURVEY);
        let names = surveys.map_or(&[][..], |item| item.texts());
        if let Some(item) = surveys
            && names.is_empty()
        {
            let path = of.path_of(BottomKey::SURVEY);
            let message = format!("`{path}` is empty: it must name a survey");
            return Err(self.sources.error(&item.span, &path, message));
        }
        let choice = of.item(BottomKey::CHART);
        if names.is_empty() && choice.is_none() {
            let path = environment.path_of(EnvironmentKey::BOTTOM);
            let message = format!("`{path}` has neither a `survey` nor a `chart`");
            let error = self.sources.error(&of.span, &path, message);
            return Err(
                error.with_help("write chart = \"interpolated\", or name the files of a survey")
            );
        }
        let of_surveys = any_keys![BottomKey: SURVEY_COORDINATES, SURVEY_VALUES];
        let mut given = of_surveys.iter().filter_map(|key| of.item(*key));
        if names.is_empty()
            && let Some(item) = given.find(|item| !item.is_default)
        {
            let path = of.path_to(item);
            let message = format!("`{path}` is for a `survey`, which is missing");
            return Err(self.sources.error(&item.key_span, &path, message));
        }
        let key = of.path_of(BottomKey::SURVEY);
        let request = Request {
            surveys: names.iter().map(|name| (name.as_str(), self.files.text(name))).collect(),
            key: &key,
            coordinates: of.given(BottomKey::SURVEY_COORDINATES).choice(),
            values: of.item(BottomKey::SURVEY_VALUES).map(|item| item.choice()),
            choice: choice.map(|item| item.choice()),
            chart: &charted.chart,
            projected: charted.projected.clone(),
            cell_m: of.item(BottomKey::CELL).map(|item| *item.number()),
        };
        let made = bottom::make(&request).map_err(|refusal| match refusal {
            Refusal::InFile(error) => *error,
            Refusal::Of(about, message, help) => {
                let (span, path) = place_of(environment, item, about);
                self.sources.error(&span, &path, format!("`{path}`: {message}")).with_help(help)
            }
        })?;
        let outside = self.outside(of)?;
        for (about, text) in made.told {
            let (span, path) = place_of(environment, item, about);
            self.note_at(&span, path, text);
        }
        let banks = of.given(BottomKey::BANKS).choice();
        let straight = environment.given(EnvironmentKey::BANK).list();
        if let (Some(_), Some(first)) = (banks, straight.iter().next()) {
            let banks = of.path_of(BottomKey::BANKS);
            let message = format!(
                "a straight bank acts beside the banks of the bottom: if the bottom has the same bank, its force is counted \
                 twice; {banks} = \"none\" leaves out those of the bottom"
            );
            self.note(first, &message);
        }
        Ok(Some(Bottom { field: Arc::new(made.field), outside, banks }))
    }

    fn outside(&self, of: Of<'_, BottomKey>) -> Checked<Outside> {
        let item = of.given(BottomKey::OUTSIDE);
        match &item.value {
            Value::Number(depth_m) => Ok(Outside::Depth(*depth_m)),
            Value::Text(word) if word == "error" => Ok(Outside::Error),
            _ => {
                let path = of.path_of(BottomKey::OUTSIDE);
                let message = format!("`{path}` is \"error\" or a depth");
                Err(self.sources.error(&item.span, &path, message))
            }
        }
    }

    /// Refuses ships that begin on land or where there is no data, and notes ships that begin aground.
    pub(super) fn check_starts(
        &mut self,
        tables: Tables<'_, BodyKey>,
        kinds: &Kinds,
        bodies: &[BodySetup],
        environment: &Environment,
    ) -> Checked<()> {
        let Some(bottom) = &environment.bottom else { return Ok(()) };
        let all = tables.iter().zip(kinds.of_bodies()).zip(bodies);
        for (((name, table), kind), body) in all {
            let Some(kind) = kind else { continue };
            let item = table.given(BodyKey::POSITION);
            let path = table.path_of(BodyKey::POSITION);
            let pose = Pose::new(body.position_m, body.heading_rad);
            let under = || {
                let corners = body.outline.vertices().iter().map(|corner| pose.apply(*corner));
                corners.chain([body.position_m])
            };
            let refuse = |at_m: Vec2, why: &str| {
                let message = format!(
                    "`{path}`: {} begins {why}, {} m north and {} m east of the origin",
                    quoted(name),
                    rounded(at_m.x),
                    rounded(at_m.y)
                );
                self.sources.error(&item.span, &path, message)
            };
            if let Some(at_m) = under().find(|at_m| bottom.depth_m(*at_m).is_none()) {
                let error = refuse(at_m, "where the bottom has no data");
                return Err(error.with_help(
                    "choose another place, or give `environment.bottom.outside` a depth: is the survey one of another place, or has the chart a hole there?",
                ));
            }
            let level_m = environment.level_m(0.0);
            let depth_m = |at_m: Vec2| bottom.depth_m(at_m).unwrap_or(f64::INFINITY);
            if depth_m(body.position_m) <= -0.5 * LAND_HEIGHT_M
                || depth_m(body.position_m) + level_m <= 0.0
            {
                return Err(refuse(body.position_m, "on land")
                    .with_help("choose a place in the water: positions are north, then east"));
            }
            let least_m = under().map(depth_m).fold(f64::INFINITY, libm::fmin) + level_m;
            let draught_m = kind.setup.deep.particulars.draught_m;
            if least_m < draught_m {
                let message = format!(
                    "{} begins aground: she draws {} m, and the least depth under her hull is {} m",
                    quoted(name),
                    rounded(draught_m),
                    rounded(least_m)
                );
                self.note_at(&item.span, path, message);
            }
        }
        Ok(())
    }

    /// Notes fenders without data in front of them.
    pub(super) fn note_holes_at_fenders(&mut self, file: Of<'_, ScenarioKey>, setup: &Setup) {
        let Some(bottom) = &setup.world.environment.bottom else { return };
        let no_data = setup.fenders.iter().filter(|fender| {
            let body = &setup.bodies[fender.body];
            let (sin, cos) = libm::sincos(fender.facing_rad);
            let out_m = fender.projection_m + BEFORE_FENDER_M;
            let front_m = fender.position_m + vec2(cos, sin) * out_m;
            let place_m = Pose::new(body.position_m, body.heading_rad).apply(front_m);
            body.is_fixed() && bottom.depth_m(place_m).is_none()
        });
        let names: Vec<&str> = no_data.map(|fender| fender.name.as_str()).collect();
        let Some(first) = names.first() else { return };
        let environment = file.given(ScenarioKey::ENVIRONMENT).table();
        let item = environment.given(EnvironmentKey::BOTTOM);
        let message = format!(
            "the bottom has no data {BEFORE_FENDER_M} m in front of {} of {} fenders, such as {}: a ship that comes there ends the run",
            names.len(),
            setup.fenders.len(),
            quoted(first)
        );
        self.note_at(&item.span, environment.path_of(EnvironmentKey::BOTTOM), message);
    }
}

/// The place in the file to which a warning or an error about the bottom points: the key, or the table if the file does
/// not give the key.
fn place_of(
    environment: Of<'_, EnvironmentKey>,
    item: Entry<'_, TableOf<BottomKey>>,
    about: About,
) -> (fenderline_keys::sources::Span, String) {
    let of = item.table();
    let key = match about {
        About::Survey => any_keys![BottomKey: SURVEY],
        About::Coordinates => any_keys![BottomKey: SURVEY_COORDINATES],
        About::Chart => any_keys![BottomKey: CHART],
        About::Cell => any_keys![BottomKey: CELL],
    };
    match of.first_of(key) {
        Some(entry) => (entry.span.clone(), of.path_to(entry)),
        None => (item.span.clone(), environment.path_of(EnvironmentKey::BOTTOM)),
    }
}

/// One depth below datum for waves, which have the same length everywhere (m): the median depth of the nodes that are
/// wet when the water stands `level_m` above datum. If no node is wet, the greatest depth.
pub(super) fn depth_for_waves_m(bottom: &Bottom, level_m: f64) -> f64 {
    let wet = |depth_m: &f32| f64::from(*depth_m) + level_m > 0.0;
    let mut water: Vec<f32> = bottom.field.depths_m().iter().copied().filter(wet).collect();
    water.sort_by(f32::total_cmp);
    match water.get(water.len() / 2) {
        Some(depth_m) => f64::from(*depth_m),
        None => bottom.range_m()[1],
    }
}
