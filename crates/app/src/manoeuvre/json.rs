//! The measures as JSON.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::vessels::Vessel;
use serde_json::{Map, Value, json};

use super::conditions::{Conditions, Sea};
use super::section::{Row, Section};
use crate::vessels::{estimate_json, sources_json};

/// The results of all manoeuvres as a JSON document, with a final line feed.
pub(super) fn text(
    name: &str,
    vessel: &Vessel,
    sea: &Sea,
    conditions: &Conditions,
    sections: &[Section],
) -> String {
    let particulars = &vessel.ship.particulars;
    let document = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "vessel": name,
        "title": vessel.origin.title,
        "length_m": particulars.length_m,
        "beam_m": particulars.beam_m,
        "draught_m": particulars.draught_m,
        "block_coefficient": particulars.block_coefficient(),
        "water_kgpm3": sea.water.density_kgpm3,
        "approach_kn": conditions.speed_mps / KNOT_MPS,
        "depth_m": conditions.shallow.map(|shallow| shallow.depth_m),
        "notices": conditions.shallow.map_or_else(Vec::new, |shallow| shallow.notices(vessel, conditions.speed_mps)),
        "manoeuvres": sections.iter().map(section).collect::<Vec<_>>(),
        "sources": sources_json(&vessel.origin),
        "estimate": estimate_json(&vessel.origin),
    });
    format!("{document:#}\n")
}

fn section(section: &Section) -> Value {
    let measures: Map<String, Value> = section
        .rows
        .iter()
        .map(|row| (row.key.to_owned(), measure(row, &section.columns)))
        .collect();
    json!({
        "manoeuvre": section.manoeuvre,
        "title": section.title,
        "measures": measures,
        "notes": section.notes,
    })
}

fn measure(row: &Row, columns: &[String]) -> Value {
    let values: Map<String, Value> =
        columns.iter().zip(&row.values).map(|(side, value)| (side.clone(), json!(value))).collect();
    json!({
        "unit": row.unit.text(),
        "values": values,
        "imo_limit": row.imo_limit,
        "within_imo_limit": row.is_within(),
    })
}
