//! IMO's limits: resolution MSC.137(76), Standards for ship manoeuvrability, annex, section 5.3 (read on a page
//! that reproduces it, imorules.com, not in IMO's own print).
//!
//! IMO's limits are for ships of 100 m and more, and for chemical tankers and gas carriers of any length, at full load
//! on an even keel, at the test speed, in sheltered water deeper than four draughts (MSC/Circ.1053, 2.1, likewise); the
//! kinds of ships are recalled.

use fenderline_contact::number::bounded;

/// IMO's limit of the advance at 90° with the rudder hard over (ship lengths).
pub(super) const ADVANCE: f64 = 4.5;
/// IMO's limit of the tactical diameter with the rudder hard over (ship lengths).
pub(super) const TACTICAL_DIAMETER: f64 = 5.0;
/// IMO's limit of the distance until the heading has changed by 10° with 10° of rudder (ship lengths).
pub(super) const INITIAL_TURNING: f64 = 2.5;
/// IMO's limit of the first overshoot of the 20°/20° zig-zag (°).
pub(super) const FIRST_OVERSHOOT_20_DEG: f64 = 25.0;
/// IMO's limit of the track reach when stopping with full astern (ship lengths); an administration may allow a large
/// ship up to 20.
pub(super) const TRACK_REACH: f64 = 15.0;

/// IMO's limit of the first overshoot of the 10°/10° zig-zag (°), which depends on length over speed L/V (s).
pub(super) fn first_overshoot_10_deg(length_over_speed_s: f64) -> f64 {
    5.0 + 0.5 * bounded(length_over_speed_s, 10.0, 30.0)
}

/// IMO's limit of the second overshoot of the 10°/10° zig-zag (°), which depends on length over speed L/V (s).
pub(super) fn second_overshoot_10_deg(length_over_speed_s: f64) -> f64 {
    17.5 + 0.75 * bounded(length_over_speed_s, 10.0, 30.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The resolution's own corners: 10° and 25° below L/V 10 s, 20° and 40° from 30 s on.
    #[test]
    fn limits_of_the_overshoots_agree_with_the_resolution_at_its_corners() {
        for (seconds, first, second) in [
            (5.0, 10.0, 25.0),
            (10.0, 10.0, 25.0),
            (20.0, 15.0, 32.5),
            (30.0, 20.0, 40.0),
            (50.0, 20.0, 40.0),
        ] {
            assert_eq!(first_overshoot_10_deg(seconds), first);
            assert_eq!(second_overshoot_10_deg(seconds), second);
        }
    }
}
