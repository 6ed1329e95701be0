//! Fenders as `summary.json` has them.

use fenderline_sim::{
    ChainKind, ChainSetup, ChainSummary, ConeSummary, ConeUse, FenderSetup, FenderSource,
    FenderSummary, PanelSummary,
};
use serde_json::{Map, Value, json};

use crate::outcome::Outcome;
use crate::verdict::FenderVerdict;

/// One object per touched fender, in the order of the scenario. Missing data (rating, permissible hull pressure, source)
/// have no key.
pub(super) fn fenders_json(outcome: &Outcome<'_>) -> Vec<Value> {
    let setup = outcome.setup;
    let objects = outcome.fenders.iter().map(|summary| {
        let fender = &setup.fenders[summary.fender];
        fender_json(fender, &setup.bodies[fender.body].name, summary)
    });
    objects.collect()
}

fn fender_json(fender: &FenderSetup, body: &str, summary: &FenderSummary) -> Value {
    let mut object = json!({
        "name": fender.name,
        "body": body,
        "verdict": FenderVerdict::of(fender, summary).key(),
        "failed": summary.failed,
        "first_touch_s": summary.first_touch_s,
        "approach_speed_mps": summary.approach_speed_mps,
        "approach_angle_rad": summary.approach_angle_rad,
        "factor": summary.factor,
        "peak_deflection_m": summary.peak_deflection_m,
        "peak_deflection_at_s": summary.peak_deflection_at_s,
        "peak_reaction_n": summary.peak_reaction_n,
        "peak_reaction_at_s": summary.peak_reaction_at_s,
        "peak_energy_j": summary.peak_energy_j,
        "peak_energy_at_s": summary.peak_energy_at_s,
        "last_deflection_m": summary.last_deflection_m,
        "last_reaction_n": summary.last_reaction_n,
    });
    let known = object.as_object_mut().expect("an object");
    let rated = fender.rated.as_ref();
    put(known, "peak_hull_pressure_npm2", summary.peak_hull_pressure_npm2);
    put(known, "capacity_j", summary.capacity_j);
    put(known, "share_of_rated_energy", summary.share_of_rated_energy);
    put(known, "share_of_rated_reaction", summary.share_of_rated_reaction);
    put(known, "share_of_rated_deflection", summary.share_of_rated_deflection);
    put(known, "share_of_catalogue_energy", summary.share_of_catalogue_energy(fender));
    put(known, "share_of_catalogue_reaction", summary.share_of_catalogue_reaction());
    if let Some((quantity, share)) = summary.governing() {
        known.insert("governing".to_owned(), json!(quantity));
        known.insert("governing_share".to_owned(), json!(share));
    }
    put(known, "share_of_hull_pressure", summary.share_of_hull_pressure);
    put(known, "rated_deflection_m", rated.map(|r| r.deflection_m));
    put(known, "rated_reaction_n", rated.map(|r| r.reaction_n));
    put(known, "rated_energy_j", rated.map(|r| r.energy_j));
    put(known, "hull_pressure_limit_npm2", fender.hull_pressure_limit_npm2);
    put(known, "height_on_hull_m", summary.hull.map(|hull| hull.height_m));
    put(known, "vertical_angle_rad", summary.hull.map(|hull| hull.vertical_angle_rad));
    put(known, "peak_vertical_force_n", summary.hull.map(|hull| hull.peak_vertical_force_n));
    if let Some(panel) = &summary.panel {
        known.insert("panel".to_owned(), panel_json(fender, summary, panel));
    }
    if !summary.chains.is_empty() {
        let chains = fender.chains.iter().zip(&summary.chains);
        let chains: Vec<Value> = chains.map(|(setup, chain)| chain_json(setup, chain)).collect();
        known.insert("chains".to_owned(), json!(chains));
    }
    if let Some(FenderSource { designation, source, standing }) = &fender.source {
        known.insert("designation".to_owned(), json!(designation));
        known.insert("source".to_owned(), json!(source));
        known.insert("standing".to_owned(), json!(standing));
    }
    object
}

/// The turn, the moment and the cones of a panel.
fn panel_json(fender: &FenderSetup, summary: &FenderSummary, panel: &PanelSummary) -> Value {
    let cone = |cone: &ConeSummary| {
        let mut object = json!({
            "at_m": cone.at_m,
            "peak_deflection_m": cone.peak_deflection_m,
            "peak_stretch_m": cone.peak_stretch_m,
        });
        if let Some(of) = ConeUse::of(fender, summary, cone.peak_deflection_m) {
            let known = object.as_object_mut().expect("an object");
            put(known, "peak_reaction_n", Some(of.peak_reaction_n));
            put(known, "peak_energy_j", Some(of.peak_energy_j));
            put(known, "share_of_rated_deflection", of.share_of_rated_deflection);
            put(known, "share_of_rated_reaction", of.share_of_rated_reaction);
            put(known, "share_of_rated_energy", of.share_of_rated_energy);
        }
        object
    };
    json!({
        "peak_tilt_rad": panel.peak_tilt_rad,
        "peak_tilt_at_s": panel.peak_tilt_at_s,
        "peak_moment_nm": panel.peak_moment_nm,
        "peak_moment_at_s": panel.peak_moment_at_s,
        "cones": panel.cones.iter().map(cone).collect::<Vec<_>>(),
    })
}

/// The peak tension of a chain; the time at which it parted has no key if it has not.
fn chain_json(setup: &ChainSetup, chain: &ChainSummary) -> Value {
    let mut object = json!({
        "kind": chain.kind.word(),
        "break_load_n": setup.break_load_n,
        "peak_tension_n": chain.peak_tension_n,
        "peak_tension_at_s": chain.peak_tension_at_s,
        "share_of_break_load": chain.share_of_break_load,
    });
    let known = object.as_object_mut().expect("an object");
    let is_tension = chain.kind == ChainKind::Tension;
    put(known, "at_m", is_tension.then_some(setup.at_m));
    put(known, "parted_at_s", chain.parted_at_s);
    object
}

fn put(object: &mut Map<String, Value>, key: &str, value: Option<f64>) {
    if let Some(value) = value {
        object.insert(key.to_owned(), json!(value));
    }
}
