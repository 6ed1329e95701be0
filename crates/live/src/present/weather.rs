//! Writes the weather into the scenario file: the present mean wind with its gusts, the present current, visibility and
//! water level.

use fenderline_author::Edit;
use fenderline_contact::Vec2;
use fenderline_sim::environment::Tide;
use fenderline_sim::environment::current::Current;
use fenderline_sim::{Setup, Simulation};

use super::written::{degrees, rounded};

/// Writes the present weather. Weather that changes in time by a data file or by tidal constituents keeps its present
/// value, with a note.
pub(super) fn edit(
    simulation: &Simulation,
    began: &Setup,
    edits: &mut Vec<Edit>,
    notes: &mut Vec<String>,
) {
    let (now, before) = (&simulation.setup().world.environment, &began.world.environment);
    let t_s = simulation.time_s();
    let of = |key| ["environment", key];
    if let Some(wind) = &now.wind {
        let (speed_mps, from_rad) = wind.mean_at(t_s);
        let [speed, from] = [rounded(speed_mps, 6).to_string(), degrees(from_rad)];
        if before.wind.as_ref().is_some_and(|wind| !wind.is_series()) {
            edits.push(Edit::set(&["environment", "wind", "speed"], speed));
            edits.push(Edit::set(&["environment", "wind", "from"], from));
        } else {
            if wind.is_series() {
                notes.push(
                    "The wind came from a file of data, and stays as it was when this file was \
                            saved."
                        .to_owned(),
                );
            }
            edits.push(Edit::set(&of("wind"), format!("{{ speed = {speed}, from = {from} }}")));
        }
    }
    let is_same = now.current == before.current;
    match &now.current {
        Some(Current::Uniform(velocity)) if !is_same => edits.push(uniform(*velocity)),
        Some(current) if varies_in_time(current) => {
            notes.push(
                "The current came from a file of data, and stays everywhere as it was when this file was \
                 saved.".to_owned(),
            );
            edits.push(uniform(current.velocity(Vec2::ZERO, t_s, 0.0)));
        }
        Some(_) | None => {}
    }
    match now.visibility_m {
        Some(distance_m) => {
            edits.push(Edit::set(&of("visibility"), rounded(distance_m, 2).to_string()));
        }
        None => edits.push(Edit::remove(&of("visibility"))),
    }
    if !matches!(now.tide, Tide::Level(_)) {
        notes.push("The water level stays as it was when this file was saved.".to_owned());
        let level_m = rounded(now.tide.level_m(t_s), 4);
        edits.push(Edit::set(&of("tide"), format!("{{ level = {level_m} }}")));
    }
}

fn varies_in_time(current: &Current) -> bool {
    !matches!(current, Current::Uniform(_))
}

fn uniform(velocity_mps: Vec2) -> Edit {
    let towards = degrees(libm::atan2(velocity_mps.y, velocity_mps.x));
    let speed_mps = rounded(velocity_mps.length(), 6);
    Edit::set(
        &["environment", "current"],
        format!("{{ speed = {speed_mps}, towards = {towards} }}"),
    )
}
