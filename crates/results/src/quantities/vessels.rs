//! The quantities of a vessel.

use fenderline_sim::VesselSetup;

use super::scales::{DEGREES, DEGREES_PER_MINUTE, KNOTS, METRES, SECONDS};
use super::{Catalogue, known, number, shown};
use crate::world_totals::VesselTotals;

/// Vessels.
pub static VESSELS: Catalogue<VesselSetup, VesselTotals> = Catalogue {
    subject: "vessel",
    quantities: &[
        number("peak_speed_over_ground_mps", "m/s", "largest speed over the ground", |_, v| {
            v.over_ground_mps.value
        }),
        number("peak_speed_over_ground_at_s", "s", "time of this speed", |_, v| {
            v.over_ground_mps.at_s
        }),
        number("peak_speed_through_water_mps", "m/s", "largest speed through the water", |_, v| {
            v.through_water_mps.value
        }),
        number("peak_speed_through_water_at_s", "s", "time of this speed", |_, v| {
            v.through_water_mps.at_s
        }),
        number(
            "peak_rate_of_turn_radps",
            "rad/s",
            "largest rate of turn, positive to starboard",
            |_, v| v.rate_of_turn_radps.value,
        ),
        number("peak_rate_of_turn_at_s", "s", "time of the largest rate of turn", |_, v| {
            v.rate_of_turn_radps.at_s
        }),
        number(
            "peak_rudder_rad",
            "rad",
            "largest rudder angle, positive turns to starboard",
            |_, v| v.rudder_rad.value,
        ),
        number(
            "peak_rudder_at_s",
            "s",
            "time of the largest rudder angle",
            |_, v: &VesselTotals| v.rudder_rad.at_s,
        )
        .not_in_summary(),
        number(
            "peak_roll_rad",
            "rad",
            "largest roll with wave motion, positive to starboard",
            |_, v| v.roll_rad.value,
        ),
        number("peak_roll_at_s", "s", "time of this roll", |_, v| v.roll_rad.at_s),
        number(
            "peak_heel_rad",
            "rad",
            "largest roll without the motion in waves, positive to starboard",
            |_, v| v.heel_rad.value,
        ),
        number("peak_heel_at_s", "s", "time of this heel", |_, v| v.heel_rad.at_s),
        number(
            "peak_pitch_rad",
            "rad",
            "largest pitch with wave motion, positive bow up",
            |_, v| v.pitch_rad.value,
        ),
        number("peak_pitch_at_s", "s", "time of this pitch", |_, v| v.pitch_rad.at_s),
        number("peak_squat_m", "m", "largest squat", |_, v| v.squat_m.value),
        number("peak_squat_at_s", "s", "time of this squat", |_, v| v.squat_m.at_s),
        number("aground_s", "s", "time aground", |_, v| v.aground.s()),
        known(
            "min_under_keel_clearance_m",
            "m",
            "least clearance under the keel, squat included",
            |_, v| v.under_keel_m.map(|least| least.value),
        ),
        known("min_under_keel_clearance_at_s", "s", "time of this clearance", |_, v| {
            v.under_keel_m.map(|least| least.at_s)
        }),
        known(
            "peak_cross_track_m",
            "m",
            "largest cross-track distance from the passage plan, between its first and last waypoint, positive to starboard",
            |_, v| v.cross_track_m.map(|peak| peak.value),
        ),
        known("peak_cross_track_at_s", "s", "time of this cross-track distance", |_, v| {
            v.cross_track_m.map(|peak| peak.at_s)
        }),
        known(
            "min_air_clearance_m",
            "m",
            "least clearance under a bridge or cable, squat included; negative: the vessel is too high",
            |_, v| v.air_clearance_m.map(|(least, _)| least.value),
        ),
        known("min_air_clearance_at_s", "s", "time of this clearance", |_, v| {
            v.air_clearance_m.map(|(least, _)| least.at_s)
        }),
    ],
    shown: &[
        shown("Speed over ground", "peak_speed_over_ground_mps", KNOTS).sheet(11.0),
        shown("At", "peak_speed_over_ground_at_s", SECONDS).sheet(10.0),
        shown("Speed through water", "peak_speed_through_water_mps", KNOTS).sheet(11.0),
        shown("At", "peak_speed_through_water_at_s", SECONDS).sheet(10.0),
        shown("Rate of turn", "peak_rate_of_turn_radps", DEGREES_PER_MINUTE).sheet(10.0),
        shown("At", "peak_rate_of_turn_at_s", SECONDS).sheet(10.0),
        shown("Rudder", "peak_rudder_rad", DEGREES).sheet(10.0),
        shown("At", "peak_rudder_at_s", SECONDS).sheet(10.0),
        shown("Roll", "peak_roll_rad", DEGREES).sheet(10.0),
        shown("At", "peak_roll_at_s", SECONDS).sheet(10.0),
        shown("Pitch", "peak_pitch_rad", DEGREES).sheet(10.0),
        shown("At", "peak_pitch_at_s", SECONDS).sheet(10.0),
        shown("Squat", "peak_squat_m", METRES).sheet(10.0),
        shown("At", "peak_squat_at_s", SECONDS).sheet(10.0),
        shown("Least clearance under the keel", "min_under_keel_clearance_m", METRES).sheet(13.0),
        shown("At", "min_under_keel_clearance_at_s", SECONDS).sheet(10.0),
        shown("Cross-track distance", "peak_cross_track_m", METRES).sheet(13.0),
        shown("At", "peak_cross_track_at_s", SECONDS).sheet(10.0),
        shown("Least clearance under a bridge", "min_air_clearance_m", METRES).sheet(13.0),
        shown("At", "min_air_clearance_at_s", SECONDS).sheet(10.0),
        shown("Time aground", "aground_s", SECONDS).sheet(10.0),
    ],
};
