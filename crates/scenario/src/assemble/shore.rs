//! The shore: the solid parts of the chart as one fixed body.

use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::chart::{Chart, SHORE};
use fenderline_sim::distance::of_outlines_m;
use fenderline_sim::{BodySetup, BodyVelocity, PairSetup};

use super::assembly::{Assembly, Checked, Names, listed};
use super::pairs::Pairs;
use super::rows::rounded;
use fenderline_charts::chart::{refused, solid_words};
use fenderline_charts::shore::{self, Refusal, Request, Shore};
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::chart::ChartKey;
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

/// How many overlaps of features are named in a notice.
const OVERLAPS_SHOWN: usize = 3;

impl Assembly<'_, '_> {
    /// Adds the body of the shore, and what of the chart is solid. `None`: nothing is.
    pub(super) fn shore(
        &mut self,
        table: Option<Of<'_, ChartKey>>,
        file: Of<'_, ScenarioKey>,
        chart: &mut Chart,
        bodies: &mut Vec<BodySetup>,
    ) -> Checked<Option<Shore>> {
        let Some(table) = table else { return Ok(None) };
        let Some(solid) = table.item(ChartKey::SOLID) else {
            let of_solid = any_keys![ChartKey: SOLID_MATERIAL, SOLID_WIDTH];
            let mut given = of_solid.iter().filter_map(|key| table.item(*key));
            let Some(item) = given.find(|item| !item.is_default) else { return Ok(None) };
            let path = table.path_to(item);
            let message = format!("`{path}` is for a chart with `solid`, which is missing");
            let error = self.sources.error(&item.key_span, &path, message);
            return Err(error.with_help("write solid = [\"LNDARE\", \"SLCONS\"]"));
        };
        let path = table.path_of(ChartKey::SOLID);
        let complain = |message: String| self.sources.error(&solid.span, &path, message);
        if table.item(ChartKey::SOLID_MATERIAL).is_none() {
            return Err(self.missing(
                table,
                ChartKey::SOLID_MATERIAL,
                "name the material of the shore",
            ));
        }
        if solid.texts().is_empty() {
            let message = format!("`{path}` is empty: it must name a class of features");
            return Err(complain(message).with_help("write solid = [\"LNDARE\", \"SLCONS\"]"));
        }
        for (index, class) in solid.texts().iter().enumerate() {
            if !solid_words().any(|word| word == class) {
                let error = complain(format!(
                    "`{path}`: {} is not a class of features that can be solid",
                    quoted(class)
                ));
                let words: Vec<&str> = solid_words().collect();
                return Err(error.with_help(match nearest(class, words.iter().copied()) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("the classes are {}", words.join(", ")),
                }));
            }
            if solid.texts()[..index].contains(class) {
                return Err(complain(format!("`{path}` names {} twice", quoted(class))));
            }
        }
        if bodies.iter().any(|body| body.name == SHORE) {
            let message = format!(
                "`{path}`: the solid parts of the chart are the body \"{SHORE}\", but the scenario has a body of this name already"
            );
            return Err(complain(message).with_help("take another name for the body"));
        }
        let outlines = file.given(ScenarioKey::BODY).named().iter();
        let outlines = outlines.filter_map(|(_, body)| body.item(BodyKey::CHART_OUTLINE));
        let of_bodies: Vec<&str> = outlines.map(|item| item.text()).collect();
        let request = Request {
            chart,
            classes: solid.texts(),
            width_m: *table.given(ChartKey::SOLID_WIDTH).number(),
            bodies: &of_bodies,
        };
        let files = table.given(ChartKey::FILES).texts();
        let made = shore::make(&request).map_err(|refusal| match refusal {
            Refusal::NoFeature(class) => {
                let error = complain(format!("`{path}`: the chart has no feature of {class}"));
                let present = request.chart.classes.iter().filter(|of| of.read > 0);
                let present = present.map(|of| of.class.as_str());
                let present: Vec<&str> =
                    present.filter(|class| solid_words().any(|word| word == *class)).collect();
                error.with_help(match present.as_slice() {
                    [] => "the chart has no class of features that can be solid".to_owned(),
                    present => format!("the chart has {}", present.join(", ")),
                })
            }
            Refusal::Feature(index, why) => {
                let feature = &request.chart.features[index];
                let name = &files[feature.place[0]];
                refused((name, self.files.text(name)), &path, feature, why)
            }
            Refusal::Nothing => complain(format!(
                "`{path}`: no feature of {} can be solid: points have no width",
                listed(solid.texts().iter().map(String::as_str))
            )),
        })?;
        let told = self.told(table, chart, &made);
        for (key, message) in told {
            let span = table.item(key).map_or(table.span.clone(), |item| item.span.clone());
            self.note_at(&span, table.path_of(key), message);
        }
        chart.solid = made.classes.clone();
        bodies.push(BodySetup {
            name: SHORE.to_owned(),
            outline: made.outline.clone(),
            hull: None,
            mass: None,
            dolphin: None,
            position_m: vec2(0.0, 0.0),
            heading_rad: 0.0,
            velocity: BodyVelocity::default(),
        });
        Ok(Some(made))
    }

    /// What is noticed about the shore, with the key of each sentence.
    fn told(
        &self,
        table: Of<'_, ChartKey>,
        chart: &Chart,
        shore: &Shore,
    ) -> Vec<(fenderline_keys::typed_key::AnyKey<ChartKey>, String)> {
        let mut told = Vec::new();
        if !shore.overlaps.is_empty() {
            let named = |index: &usize| self.in_words(table, chart, *index);
            let count = shore.overlaps.len();
            let shown: Vec<String> = shore.overlaps[..count.min(OVERLAPS_SHOWN)]
                .iter()
                .map(|[one, other]| format!("{} and {}", named(one), named(other)))
                .collect();
            let more = if count > OVERLAPS_SHOWN { ", …" } else { "" };
            told.push((
                ChartKey::SOLID.any(),
                format!(
                    "{count} pairs of solid features overlap ({}{more}): a contact counts both, so that the shore is stiffer there",
                    shown.join("; ")
                ),
            ));
        }
        let width = table.given(ChartKey::SOLID_WIDTH);
        if !width.is_default && !shore.has_strips {
            let message = "no solid feature is a line of its own, so the width has no effect";
            told.push((ChartKey::SOLID_WIDTH.any(), message.to_owned()));
        }
        told
    }

    /// A feature of the chart in words: its class and name, its number and file.
    pub(super) fn in_words(&self, table: Of<'_, ChartKey>, chart: &Chart, index: usize) -> String {
        let feature = &chart.features[index];
        let file = &table.given(ChartKey::FILES).texts()[feature.place[0]];
        let name = if feature.name.is_empty() {
            String::new()
        } else {
            format!(" {}", quoted(&feature.name))
        };
        format!("{}{name}, feature {} of {file}", feature.class, feature.place[1])
    }

    /// Adds a pair of the shore with each floating body, unless the file names the pair.
    pub(super) fn pair_with_shore(
        &self,
        table: Of<'_, ChartKey>,
        bodies: &[BodySetup],
        names: &Names,
        pairs: &mut Pairs,
    ) -> Checked<()> {
        let material = self.material_named(table, table.given(ChartKey::SOLID_MATERIAL), names)?;
        let shore = names.bodies[SHORE];
        for (body, _) in bodies.iter().enumerate().filter(|(_, body)| !body.is_fixed()) {
            pairs.add_if_new(PairSetup { bodies: [body, shore], material });
        }
        Ok(())
    }

    /// Refuses floating bodies that begin on the shore.
    pub(super) fn check_starts_off_shore(
        &self,
        file: Of<'_, ScenarioKey>,
        bodies: &[BodySetup],
        (chart, shore): (&Chart, &Shore),
    ) -> Checked<()> {
        let tables: Tables<'_, BodyKey> = file.given(ScenarioKey::BODY).named();
        let Some(chart_table) = file.item(ScenarioKey::CHART).map(|item| item.table()) else {
            return Ok(());
        };
        for ((name, table), body) in tables.iter().zip(bodies) {
            if body.is_fixed() {
                continue;
            }
            let pose = Pose::new(body.position_m, body.heading_rad);
            let hull: Vec<Vec2> =
                body.outline.vertices().iter().map(|corner| pose.apply(*corner)).collect();
            let reach_m = body.outline.radius_m();
            let meets = |part: &fenderline_contact::Outline| {
                let (low, high) = part.bounds();
                let at = body.position_m;
                at.x >= low.x - reach_m
                    && at.x <= high.x + reach_m
                    && at.y >= low.y - reach_m
                    && at.y <= high.y + reach_m
                    && of_outlines_m(&hull, part.vertices()) <= 0.0
            };
            let met = shore.of_features.iter().find(|(_, parts)| parts.iter().any(meets));
            if let Some((feature, _)) = met {
                let item = table.given(BodyKey::POSITION);
                let path = table.path_of(BodyKey::POSITION);
                let message = format!(
                    "`{path}`: {} begins on the solid {}, {} m north and {} m east of the origin",
                    quoted(name),
                    self.in_words(chart_table, chart, *feature),
                    rounded(body.position_m.x),
                    rounded(body.position_m.y)
                );
                let error = self.sources.error(&item.span, &path, message);
                return Err(
                    error.with_help("choose a place in the water: positions are north, then east")
                );
            }
        }
        Ok(())
    }
}
