//! Bridges and cables of the chart over the water, and the air draughts of vessels.

use fenderline_sim::chart::{Chart, ChartFeature, ChartKind};
use fenderline_sim::overhead::{OverheadSetup, Structure, TallVessel};
use fenderline_sim::{Setup, VesselSetup};

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::chart::ChartKey;
use fenderline_keys::sources::quoted;

/// Class and name of a feature.
fn named(feature: &ChartFeature) -> String {
    let kind = match feature.kind {
        ChartKind::Cable => "cable",
        _ => "bridge",
    };
    if feature.name.is_empty() {
        format!("{kind} without a name")
    } else {
        format!("{kind} {}", quoted(&feature.name))
    }
}

fn structures(chart: &Chart) -> impl Iterator<Item = &ChartFeature> {
    let is_over =
        |feature: &&ChartFeature| matches!(feature.kind, ChartKind::Bridge | ChartKind::Cable);
    chart.features.iter().filter(is_over)
}

impl Assembly<'_, '_> {
    /// The bridges and cables that vessels with an air draught may pass under.
    pub(super) fn overhead(
        &mut self,
        file: Of<'_, ScenarioKey>,
        setup: &Setup,
    ) -> Checked<OverheadSetup> {
        let chart = &setup.world.chart;
        let tables: Tables<'_, BodyKey> = file.given(ScenarioKey::BODY).named();
        let vessels = setup.world.vessels.iter();
        let air_draughts: Vec<_> = vessels
            .map(|vessel| {
                let name = &setup.bodies[vessel.body].name;
                let (_, table) = tables.iter().find(|(body, _)| *body == name)?;
                Some((table, table.item(BodyKey::AIR_DRAUGHT)))
            })
            .collect();
        let given =
            || air_draughts.iter().flatten().filter_map(|(table, item)| Some((*table, (*item)?)));
        let chart_table = file.item(ScenarioKey::CHART).map(|item| item.table());
        let level = chart_table.and_then(|table| table.item(ChartKey::CLEARANCE_DATUM));
        let known = structures(chart).filter(|feature| feature.clearance_m.is_some()).count();
        let unknown = structures(chart).count() - known;
        if known == 0 {
            let why = "the chart has no bridge or cable with a clearance";
            let told: Vec<_> = given().map(|(table, _)| table).collect();
            for table in told {
                self.note_idle(table, BodyKey::AIR_DRAUGHT, why);
            }
            if let Some(table) = chart_table {
                self.note_idle(table, ChartKey::CLEARANCE_DATUM, why);
            }
        }
        if known + unknown > 0 && !setup.world.vessels.is_empty() {
            self.note_unchecked(chart_table, setup, &air_draughts, [known, unknown]);
        }
        let Some((table, item)) = given().next().filter(|_| known > 0) else {
            // Nobody is compared, but the view draws bridges and cables from this level up.
            let clearance_datum_m = level.map(|level| *level.number());
            return Ok(OverheadSetup { clearance_datum_m, ..OverheadSetup::default() });
        };
        let Some(level) = level else {
            let path = table.path_of(BodyKey::AIR_DRAUGHT);
            let message = format!(
                "`{path}`: the chart gives clearances of bridges and cables above a level of high water, whose height above \
                 chart datum is not given"
            );
            let error = self.sources.error(&item.span, &path, message);
            return Err(error.with_help(
                "write chart.clearance_datum, such as \"3.2 m\": the height of that level (mean high water springs, highest \
                 astronomical tide) above chart datum at the place",
            ));
        };
        let structure = |feature: &ChartFeature| {
            let above_datum_m = level.number() + feature.clearance_m?;
            Structure::new(named(feature), feature.shape.clone(), above_datum_m)
        };
        let tall = |(vessel, given): (&VesselSetup, &Option<(Of<'_, BodyKey>, Option<_>)>)| {
            let (table, _) = given.as_ref()?;
            let air_draught_m = *table.item(BodyKey::AIR_DRAUGHT)?.number();
            let outline = setup.bodies[vessel.body].outline.clone();
            Some(TallVessel { air_draught_m, outline })
        };
        let vessels = setup.world.vessels.iter().zip(&air_draughts);
        Ok(OverheadSetup {
            structures: structures(chart).filter_map(structure).collect(),
            vessels: vessels.map(tall).collect(),
            clearance_datum_m: Some(*level.number()),
        })
    }

    /// Tells which clearances are not checked: those of structures without a height, and those of vessels without an air
    /// draught.
    fn note_unchecked<I>(
        &mut self,
        chart_table: Option<Of<'_, ChartKey>>,
        setup: &Setup,
        air_draughts: &[Option<(Of<'_, BodyKey>, Option<I>)>],
        [known, unknown]: [usize; 2],
    ) {
        let without: Vec<String> = air_draughts
            .iter()
            .zip(&setup.world.vessels)
            .filter(|(of, _)| !matches!(of, Some((_, Some(_)))))
            .map(|(_, vessel)| setup.bodies[vessel.body].name.clone())
            .collect();
        let Some(table) = chart_table else { return };
        let span = &table.given(ChartKey::FILES).span;
        let key = table.path_of(ChartKey::FILES);
        if known > 0 && !without.is_empty() {
            let message = format!(
                "the chart has {known} bridges and cables with a clearance, which is not checked for {}: no `air_draught`",
                without.join(", ")
            );
            self.note_at(span, key.clone(), message);
        }
        if unknown > 0 && without.len() < air_draughts.len() {
            let message = format!(
                "{unknown} bridges and cables of the chart have no clearance, so they are not checked"
            );
            self.note_at(span, key, message);
        }
    }
}
