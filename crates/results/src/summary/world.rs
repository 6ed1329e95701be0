//! Vessels, tugs, mooring lines, anchors and their events in `summary.json`.

use crate::events::world_event_key;
use fenderline_sim::external::ProviderEvent;
use fenderline_sim::passing::PassingSetup;
use fenderline_sim::{AnchorSetup, MooringSetup, Setup, TugSetup, VesselSetup};

use crate::accuracy::{accuracy_json, source_json};
use crate::json::{Json, object};
use crate::outcome::Outcome;
use crate::provider_notices::provider_event_key;
use crate::quantities::{ANCHORS, LINES, TUGS, VESSELS};
use crate::world_totals::{AnchorTotals, LineTotals, PassingTotals, TugTotals, VesselTotals, Who};

/// Adds one section for vessels, one for tugs and one for mooring lines, if the set-up has any.
pub(super) fn put_world(whole: &mut Json, outcome: &Outcome<'_>) {
    let (setup, world) = (outcome.setup, outcome.world);
    if !world.vessels.is_empty() {
        let vessels = setup.world.vessels.iter().zip(&world.vessels);
        let vessels = vessels.map(|(vessel, totals)| {
            let mut object = vessel_json(&setup.bodies[vessel.body].name, vessel, totals);
            object.put("vessel", &vessel.origin.title);
            object.put("estimated", vessel.origin.estimates().map(source_json).collect::<Json>());
            object.put("estimate", accuracy_json(&vessel.origin, outcome.estimate_errors));
            object
        });
        whole.put("vessels", vessels.collect::<Json>());
    }
    if !world.tugs.is_empty() {
        let tugs = setup.world.tugs.iter().zip(&world.tugs);
        whole.put("tugs", tugs.map(|(tug, totals)| tug_json(tug, totals)).collect::<Json>());
    }
    if !world.lines.is_empty() {
        let lines = setup.world.lines.iter().zip(&world.lines);
        whole.put("lines", lines.map(|(line, totals)| line_json(line, totals)).collect::<Json>());
    }
    if !world.anchors.is_empty() {
        let anchors = setup.world.anchors.iter().zip(&world.anchors);
        whole.put(
            "anchors",
            anchors.map(|(anchor, totals)| anchor_json(anchor, totals)).collect::<Json>(),
        );
    }
    if !world.passing.is_empty() {
        let ships = setup.world.flow.passing.iter().zip(&world.passing);
        whole.put(
            "passing",
            ships.map(|(ship, totals)| passing_json(ship, totals, setup)).collect::<Json>(),
        );
    }
    if !setup.world.flow.hulls.is_empty() {
        for (object, totals) in whole["vessels"].items_mut().iter_mut().zip(&world.vessels) {
            put_peaks(object, totals);
        }
    }
    put_events(whole, outcome);
}

/// Adds the largest forces and the largest moment on a vessel by the flow around passing ships and other vessels.
fn put_peaks(vessel: &mut Json, totals: &VesselTotals) {
    for (name, unit, peak) in [
        ("surge", "n", totals.passing[0]),
        ("sway", "n", totals.passing[1]),
        ("yaw", "nm", totals.passing[2]),
    ] {
        vessel.put(&format!("peak_passing_{name}_{unit}"), peak.value);
        vessel.put(&format!("peak_passing_{name}_at_s"), peak.at_s);
    }
}

fn passing_json(ship: &PassingSetup, totals: &PassingTotals, setup: &Setup) -> Json {
    let mut object = object!({
        "name": ship.name,
        "length_m": ship.hull.length_m,
        "beam_m": ship.hull.beam_m,
        "draught_m": ship.hull.draught_m,
        "fastest_mps": ship.track.pace.fastest_mps(),
    });
    if let Some((vessel, nearest)) = totals.nearest {
        object.put("nearest_vessel", &setup.bodies[setup.world.vessels[vessel].body].name);
        object.put("least_gap_m", nearest.distance_m);
        object.put("least_gap_at_s", nearest.t_s);
        object.put("speed_there_mps", totals.speed_mps);
    }
    object
}

/// The results of a vessel, as JSON; in deep water there is no key for the under-keel clearance.
fn vessel_json(name: &str, setup: &VesselSetup, totals: &VesselTotals) -> Json {
    let mut object = object!({ "name": name });
    VESSELS.put(&mut object, setup, totals);
    object
}

fn tug_json(tug: &TugSetup, totals: &TugTotals) -> Json {
    let mut object = object!({ "name": tug.tug.name });
    TUGS.put(&mut object, tug, totals);
    object
}

/// The results of a mooring line, as JSON; missing values (the break load before the line is fast, the time of parting)
/// have no key.
fn line_json(line: &MooringSetup, totals: &LineTotals) -> Json {
    let mut object = object!({ "name": line.line.name });
    LINES.put(&mut object, line, totals);
    object
}

/// The results of an anchor, as JSON; missing values (place of the anchor, time of its loss) have no key.
fn anchor_json(anchor: &AnchorSetup, totals: &AnchorTotals) -> Json {
    let mut object = object!({ "name": anchor.gear.name });
    ANCHORS.put(&mut object, anchor, totals);
    if let Some(at_m) = totals.place_m() {
        object.put("last_place_m", [at_m.x, at_m.y]);
    }
    if let Some((at_s, by)) = totals.lost {
        object.put("lost_at_s", at_s);
        object.put("lost_by", by.word());
    }
    object
}

/// Adds the counts of the world's events to those of contact events, and the first events by name.
fn put_events(whole: &mut Json, outcome: &Outcome<'_>) {
    let (setup, world) = (outcome.setup, outcome.world);
    let of_world = world.events.counts().iter().map(|&(kind, n)| (world_event_key(kind), n));
    let of_providers = outcome.providers.counts().iter().copied();
    for (key, n) in of_world.chain(of_providers) {
        whole["events"]["counts"].put(key, n);
    }
    if !world.events.first().is_empty() {
        let first = world
            .events
            .first()
            .iter()
            .map(|(t_s, event)| {
                let who = Who::of(event, setup);
                object!({ "t_s": t_s, "kind": world_event_key(event.kind), (who.kind): who.name })
            })
            .collect::<Json>();
        whole["events"].put("world", first);
    }
    if !outcome.providers.first().is_empty() {
        let told = outcome.providers.first().iter();
        let told =
            told.map(|notice| provider_json(notice.t_s, notice.provider, &notice.event, setup));
        whole["events"].put("providers", told.collect::<Json>());
    }
}

fn provider_json(t_s: f64, provider: usize, event: &ProviderEvent, setup: &Setup) -> Json {
    let of = &setup.world.providers[provider];
    let mut told = object!({});
    told.put("t_s", t_s);
    told.put("kind", provider_event_key(event));
    told.put("body", &setup.bodies[of.body].name);
    if let ProviderEvent::Died(why) = event {
        told.put("why", why);
    }
    told
}
