//! Tracks as csv.

use std::path::Path;

use super::section::Track;
use crate::failure::Failure;
use crate::output::{make_folder, write_whole};

/// Writes each track to a file in `folder`, whole or not at all, and returns the names of the files.
///
/// # Errors
/// Fails if a file cannot be written, and names that file.
pub(super) fn write(folder: &Path, tracks: &[&Track]) -> Result<Vec<String>, Failure> {
    make_folder(folder)?;
    tracks.iter().map(|track| write_one(folder, track)).collect()
}

fn write_one(folder: &Path, track: &Track) -> Result<String, Failure> {
    let name = format!("{}.csv", track.name);
    write_whole(&folder.join(&name), &text(track))?;
    Ok(name)
}

fn text(track: &Track) -> Vec<u8> {
    let mut table = csv::Writer::from_writer(Vec::new());
    let mut put = |record: &[String]| {
        table.write_record(record).expect("a table in memory accepts every row");
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
    table.into_inner().expect("a table in memory can be finished")
}
