//! Vessels, tugs, lines, anchors and their events in `summary.json`.

use crate::events::world_event_key;
use fenderline_sim::Setup;
use fenderline_sim::external::ProviderEvent;
use fenderline_sim::passing::PassingSetup;

use crate::accuracy::{accuracy_json, source_json};
use crate::json::{Json, object};
use crate::outcome::Outcome;
use crate::provider_notices::provider_event_key;
use crate::world_totals::{AnchorTotals, LineTotals, PassingTotals, TugTotals, VesselTotals, Who};

/// Adds a section each for vessels, tugs and lines, if the set-up has any.
pub(super) fn put_world(whole: &mut Json, outcome: &Outcome<'_>) {
    let (setup, world) = (outcome.setup, outcome.world);
    if !world.vessels.is_empty() {
        let vessels = setup.world.vessels.iter().zip(&world.vessels);
        let vessels = vessels.map(|(vessel, totals)| {
            let mut object = vessel_json(&setup.bodies[vessel.body].name, totals);
            object.put("vessel", &vessel.origin.title);
            object.put("estimated", vessel.origin.estimates().map(source_json).collect::<Json>());
            object.put("estimate", accuracy_json(&vessel.origin, outcome.estimate_errors));
            object
        });
        whole.put("vessels", vessels.collect::<Json>());
    }
    if !world.tugs.is_empty() {
        let tugs = setup.world.tugs.iter().zip(&world.tugs);
        whole.put(
            "tugs",
            tugs.map(|(tug, totals)| {
                tug_json(&tug.tug.name, tug.tug.envelope.bollard_pull_n, totals)
            })
            .collect::<Json>(),
        );
    }
    if !world.lines.is_empty() {
        let lines = setup.world.lines.iter().zip(&world.lines);
        whole.put(
            "lines",
            lines.map(|(line, totals)| line_json(&line.line.name, totals)).collect::<Json>(),
        );
    }
    if !world.anchors.is_empty() {
        let anchors = setup.world.anchors.iter().zip(&world.anchors);
        whole.put(
            "anchors",
            anchors
                .map(|(anchor, totals)| anchor_json(&anchor.gear.name, totals))
                .collect::<Json>(),
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

/// Peaks of the flow of passing ships and of other vessels.
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

/// In deep water there is no key for the under-keel clearance.
fn vessel_json(name: &str, totals: &VesselTotals) -> Json {
    let mut object = object!({
        "name": name,
        "peak_speed_over_ground_mps": totals.over_ground_mps.value,
        "peak_speed_over_ground_at_s": totals.over_ground_mps.at_s,
        "peak_speed_through_water_mps": totals.through_water_mps.value,
        "peak_speed_through_water_at_s": totals.through_water_mps.at_s,
        "peak_rate_of_turn_radps": totals.rate_of_turn_radps.value,
        "peak_rate_of_turn_at_s": totals.rate_of_turn_radps.at_s,
        "peak_rudder_rad": totals.rudder_rad.value,
        "peak_roll_rad": totals.roll_rad.value,
        "peak_roll_at_s": totals.roll_rad.at_s,
        "peak_heel_rad": totals.heel_rad.value,
        "peak_heel_at_s": totals.heel_rad.at_s,
        "peak_pitch_rad": totals.pitch_rad.value,
        "peak_pitch_at_s": totals.pitch_rad.at_s,
        "peak_squat_m": totals.squat_m.value,
        "peak_squat_at_s": totals.squat_m.at_s,
        "aground_s": totals.aground.s(),
    });
    if let Some(least) = totals.under_keel_m {
        object.put("min_under_keel_clearance_m", least.value);
        object.put("min_under_keel_clearance_at_s", least.at_s);
    }
    object
}

fn tug_json(name: &str, bollard_pull_n: f64, totals: &TugTotals) -> Json {
    object!({
        "name": name,
        "bollard_pull_n": bollard_pull_n,
        "peak_force_n": totals.force_n.value,
        "peak_force_at_s": totals.force_n.at_s,
        "at_work_s": totals.at_work.s(),
        "limited_s": totals.limited.s(),
    })
}

/// Missing values (the break load before the line is fast, the time of parting) have no key.
fn line_json(name: &str, totals: &LineTotals) -> Json {
    let mut object = object!({
        "name": name,
        "verdict": totals.verdict().key(),
        "peak_tension_n": totals.tension_n.value,
        "peak_tension_at_s": totals.tension_n.at_s,
        "over_working_load_s": totals.over_working.s(),
        "rendered_m": totals.rendered_m,
        "parted": totals.parted_s.is_some(),
        "fast_at_end": totals.is_fast,
        "last_tension_n": totals.last_tension_n,
    });
    object.put_if_any("made_fast_s", totals.made_fast_s);
    object.put_if_any("break_load_n", totals.break_load_n);
    object.put_if_any("working_load_n", totals.working_load_n);
    object.put_if_any("share_of_break_load", totals.share_of_break_load());
    object.put_if_any("parted_at_s", totals.parted_s);
    object
}

/// Missing values (place of the anchor, time of its loss) have no key.
fn anchor_json(name: &str, totals: &AnchorTotals) -> Json {
    let mut object = object!({
        "name": name,
        "verdict": totals.verdict().key(),
        "break_load_n": totals.break_load_n,
        "peak_tension_n": totals.tension_n.value,
        "peak_tension_at_s": totals.tension_n.at_s,
        "most_chain_out_m": totals.chain_m.value,
        "on_bottom_s": totals.on_bottom.s(),
        "dragged_m": totals.dragged_m,
        "dragging_s": totals.dragging.s(),
        "dragged_j": totals.dragged_j,
        "rendered_m": totals.rendered_m,
        "state_at_end": totals.position.word(),
        "last_chain_out_m": totals.last_chain_m,
        "last_tension_n": totals.last_tension_n,
    });
    if let Some(at_m) = totals.place_m() {
        object.put("last_place_m", [at_m.x, at_m.y]);
    }
    if let Some((at_s, by)) = totals.lost {
        object.put("lost_at_s", at_s);
        object.put("lost_by", by.word());
    }
    object
}

/// Adds the counts to the counts of contact events, and the first events by name.
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
