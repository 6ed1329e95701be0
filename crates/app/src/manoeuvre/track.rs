//! Tracks as csv.

use std::fs;
use std::path::Path;

use super::section::Track;
use crate::failure::Failure;

/// Writes each track into `folder`, whole or not at all; returns the files' names.
///
/// # Errors
/// The file that cannot be written.
pub(super) fn write(folder: &Path, tracks: &[&Track]) -> Result<Vec<String>, Failure> {
    fs::create_dir_all(folder).map_err(|e| cannot(folder, &e))?;
    tracks.iter().map(|track| write_one(folder, track)).collect()
}

fn write_one(folder: &Path, track: &Track) -> Result<String, Failure> {
    let name = format!("{}.csv", track.name);
    let (part, whole) = (folder.join(format!("{name}.part")), folder.join(&name));
    let written = fs::write(&part, text(track)).and_then(|()| fs::rename(&part, &whole));
    written.map_err(|e| {
        // Nothing better can be done with a second error.
        let _ = fs::remove_file(&part);
        cannot(&whole, &e)
    })?;
    Ok(name)
}

fn cannot(path: &Path, error: &dyn core::fmt::Display) -> Failure {
    Failure::case(format_args!("error: cannot write {}: {error}", path.display()))
}

fn text(track: &Track) -> Vec<u8> {
    let mut table = csv::Writer::from_writer(Vec::new());
    let mut put = |record: &[String]| {
        table.write_record(record).expect("a table in memory takes every row");
    };
    let head = [
        "t_s",
        "north_m",
        "east_m",
        "heading_rad",
        "surge_mps",
        "sway_mps",
        "yaw_rate_radps",
        "rudder_rad",
        "shaft_rps",
    ];
    put(&head.map(str::to_owned));
    for moment in &track.moments {
        let (motion, controls) = (&moment.motion, &moment.controls);
        let values = [
            moment.time_s,
            motion.north_m,
            motion.east_m,
            motion.heading_rad,
            motion.velocity.surge_mps,
            motion.velocity.sway_mps,
            motion.velocity.yaw_radps,
            controls.rudder_rad,
            controls.shaft_rps,
        ];
        put(&values.map(|value| format!("{value:?}")));
    }
    table.into_inner().expect("a table in memory ends")
}
