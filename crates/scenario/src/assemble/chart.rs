//! Reads the nautical chart of a scenario, and the outlines of bodies from the chart.

use fenderline_contact::{Pose, Vec2};
use fenderline_sim::chart::{Chart, ChartShape, GeographicPlace};

use super::assembly::{Assembly, Checked};
use super::bottom::Charted;
use fenderline_charts::chart::projection::Projected;
use fenderline_charts::chart::{Budget, Counts, Placing, read};
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::Text;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::chart::{ChartKey, ChartOriginKey, Coordinates, Projection};
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

impl Assembly<'_, '_> {
    /// Reads the nautical chart; the chart is empty if the scenario has no table `[chart]`.
    pub(super) fn chart(&mut self, table: Option<Of<'_, ChartKey>>) -> Checked<Charted> {
        let none = Charted { chart: Chart::default(), projected: None };
        let Some(table) = table else { return Ok(none) };
        let (placing, origin) = self.placing(table)?;
        let files = table.given(ChartKey::FILES);
        if files.texts().is_empty() {
            let path = table.path_of(ChartKey::FILES);
            let message = format!("`{path}` is empty: it must name a GeoJSON file");
            return Err(self.sources.error(&files.span, &path, message));
        }
        let key = table.path_of(ChartKey::FILES);
        let mut budget = Budget::OF_CHART;
        let (mut features, mut counts) = (Vec::new(), Counts::default());
        for (number, name) in files.texts().iter().enumerate() {
            let into = (&mut counts, &mut *self.notices);
            let file = (number, name.as_str(), self.files.text(name));
            features.extend(read(file, &key, &placing, &mut budget, into)?);
        }
        let projected = match (placing, origin) {
            (Placing::Degrees(projected), Some(origin)) => {
                let projection = table.item(ChartKey::PROJECTION).map(|item| item.choice());
                Some((projected, origin, projection == Some(Projection::Utm)))
            }
            _ => None,
        };
        let chart = Chart { features, origin, classes: counts.classes(), solid: Vec::new() };
        Ok(Charted { chart, projected })
    }

    /// How the coordinates in the files become coordinates of the scenario, and where the scenario's origin lies on the
    /// earth.
    fn placing(&self, table: Of<'_, ChartKey>) -> Checked<(Placing, Option<GeographicPlace>)> {
        let (projection, origin) = (table.item(ChartKey::PROJECTION), table.item(ChartKey::ORIGIN));
        let coordinates = table.given(ChartKey::COORDINATES);
        if coordinates.choice() == Coordinates::Metres {
            if let Some(item) = table.first_of(any_keys![ChartKey: PROJECTION, ORIGIN]) {
                let path = table.path_to(item);
                let message = format!("`{path}` is for a chart in longitude and latitude");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error
                    .with_help("remove this key, or write coordinates = \"longitude_latitude\""));
            }
            return Ok((Placing::Metres, None));
        }
        let (Some(projection), Some(origin)) = (projection, origin) else {
            let missing = match projection {
                None => ChartKey::PROJECTION.any(),
                Some(_) => ChartKey::ORIGIN.any(),
            };
            let path = table.path_of(missing);
            let message = format!(
                "`{path}` is missing: longitude and latitude become metres only by a projection \
                 about an origin"
            );
            let error = self.sources.error(&coordinates.span, &path, message);
            return Err(error.with_help(
                "write projection = \"transverse_mercator\" and \
                 origin = { latitude = \"53.52 deg\", longitude = \"9.94 deg\" }",
            ));
        };
        let angle = |key| *origin.table().given(key).number();
        let origin = GeographicPlace {
            latitude_rad: angle(ChartOriginKey::LATITUDE),
            longitude_rad: angle(ChartOriginKey::LONGITUDE),
        };
        Ok((Placing::Degrees(Projected::about(origin, projection.choice())), Some(origin)))
    }

    /// The corners of the area of the nautical chart that `chart_outline` names, in the body's axes.
    pub(super) fn chart_outline(
        &self,
        table: Of<'_, BodyKey>,
        item: Entry<'_, Text>,
        chart: &Chart,
    ) -> Checked<Vec<Vec2>> {
        let path = table.path_to(item);
        let wanted = item.text();
        let complain = |message: String| self.sources.error(&item.span, &path, message);
        if !*table.given(BodyKey::FIXED).flag() {
            let message = format!("`{path}` is for a fixed body");
            return Err(complain(message).with_help("write fixed = true"));
        }
        let named = || chart.features.iter().filter(|feature| !feature.name.is_empty());
        let areas: Vec<_> = named()
            .filter(|feature| feature.name == wanted)
            .filter_map(|feature| match &feature.shape {
                ChartShape::Area(rings) => Some(rings),
                _ => None,
            })
            .collect();
        match areas.as_slice() {
            [rings] => match rings.as_slice() {
                [ring] => {
                    let pose = Pose::new(
                        *table.given(BodyKey::POSITION).vector(),
                        *table.given(BodyKey::HEADING).number(),
                    );
                    Ok(ring.iter().map(|corner| pose.apply_inverse(*corner)).collect())
                }
                _ => Err(complain(format!(
                    "`{path}`: the area {} has a hole, which a body cannot have",
                    quoted(wanted)
                ))),
            },
            [] if named().any(|feature| feature.name == wanted) => Err(complain(format!(
                "`{path}`: {} is not an area of the chart, but a line or a point",
                quoted(wanted)
            ))),
            [] => {
                let error =
                    complain(format!("`{path}`: the chart has no area named {}", quoted(wanted)));
                let names = named().map(|feature| feature.name.as_str());
                Err(match nearest(wanted, names) {
                    Some(near) => error.with_help(format!("did you mean \"{near}\"?")),
                    None if chart.features.is_empty() => {
                        error.with_help("the scenario has no [chart] with files")
                    }
                    None => {
                        error.with_help("an area of the chart has its name in its property `name`")
                    }
                })
            }
            several => Err(complain(format!(
                "`{path}`: the chart has {} areas named {}: each needs another name",
                several.len(),
                quoted(wanted)
            ))),
        }
    }
}
