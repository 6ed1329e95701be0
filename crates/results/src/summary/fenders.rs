//! Writes fenders into `summary.json`.

use fenderline_sim::{
    ChainSetup, ChainSummary, ConeSummary, ConeUse, FenderSetup, FenderSource, FenderSummary,
    PanelSummary,
};

use crate::json::{Json, object};
use crate::outcome::Outcome;
use crate::quantities::{CHAINS, FENDERS};

/// One object per touched fender, in the order of the scenario. Missing data of a fender (rating, permissible hull
/// pressure, source) have no key.
pub(super) fn fenders_json(outcome: &Outcome<'_>) -> Vec<Json> {
    let setup = outcome.setup;
    let objects = outcome.fenders.iter().map(|summary| {
        let fender = &setup.fenders[summary.fender];
        fender_json(fender, &setup.bodies[fender.body].name, summary)
    });
    objects.collect()
}

fn fender_json(fender: &FenderSetup, body: &str, summary: &FenderSummary) -> Json {
    let mut object = object!({ "name": fender.name, "body": body });
    FENDERS.put(&mut object, fender, summary);
    if let Some(panel) = &summary.panel {
        object.put("panel", panel_json(fender, summary, panel));
    }
    if !summary.chains.is_empty() {
        let chains = fender.chains.iter().zip(&summary.chains);
        let chains: Json = chains.map(|(setup, chain)| chain_json(setup, chain)).collect();
        object.put("chains", chains);
    }
    if let Some(FenderSource { designation, source, standing, .. }) = &fender.source {
        object.put("designation", designation);
        object.put("source", source);
        object.put("standing", standing);
    }
    object
}

/// The turn, the moment and the cones of a panel, as JSON.
fn panel_json(fender: &FenderSetup, summary: &FenderSummary, panel: &PanelSummary) -> Json {
    let cone = |cone: &ConeSummary| {
        let mut object = object!({
            "at_m": cone.at_m,
            "peak_deflection_m": cone.peak_deflection_m,
            "peak_stretch_m": cone.peak_stretch_m,
        });
        if let Some(of) = ConeUse::of(fender, summary, cone.peak_deflection_m) {
            object.put("peak_reaction_n", of.peak_reaction_n);
            object.put("peak_energy_j", of.peak_energy_j);
            object.put_if_any("share_of_rated_deflection", of.share_of_rated_deflection);
            object.put_if_any("share_of_rated_reaction", of.share_of_rated_reaction);
            object.put_if_any("share_of_rated_energy", of.share_of_rated_energy);
        }
        object
    };
    object!({
        "peak_tilt_rad": panel.peak_tilt_rad,
        "peak_tilt_at_s": panel.peak_tilt_at_s,
        "peak_moment_nm": panel.peak_moment_nm,
        "peak_moment_at_s": panel.peak_moment_at_s,
        "cones": panel.cones.iter().map(cone).collect::<Vec<_>>(),
    })
}

/// The results of a fender chain, as JSON; the time of parting has no key if the chain has not parted.
fn chain_json(setup: &ChainSetup, chain: &ChainSummary) -> Json {
    let mut object = object!({});
    CHAINS.put(&mut object, setup, chain);
    object
}
