//! The quantities of two bodies that touched.

use fenderline_sim::PairSummary;

use super::scales::{KILONEWTON_SECONDS, KILONEWTONS, KNOTS, METRES, METRES_PER_SECOND, SECONDS};
use super::{Catalogue, flag, number, shown};

/// Pairs of bodies.
pub static PAIRS: Catalogue<(), PairSummary> = Catalogue {
    subject: "pair",
    quantities: &[
        number(
            "first_touch_s",
            "s",
            "start of the first step in which the two bodies touched",
            |(), p| p.first_touch_s,
        ),
        number(
            "last_touch_s",
            "s",
            "start of the last step in which the two bodies touched",
            |(), p| p.last_touch_s,
        ),
        number("peak_normal_force_n", "N", "largest normal force of all patches", |(), p| {
            p.peak_normal_force_n
        }),
        number("peak_normal_force_at_s", "s", "time of that force", |(), p| {
            p.peak_normal_force_at_s
        }),
        number("peak_depth_m", "m", "largest depth of a patch", |(), p| p.peak_depth_m),
        number("peak_depth_at_s", "s", "time of that depth", |(), p| p.peak_depth_at_s),
        number("impulse_ns", "N·s", "impulse of the normal force", |(), p| p.impulse_ns),
        number(
            "approach_speed_mps",
            "m/s",
            "closing speed along the normal at first touch",
            |(), p| p.approach_speed_mps,
        ),
        number(
            "final_speed_mps",
            "m/s",
            "separation speed along the normal after the last touch",
            |(), p| p.final_speed_mps,
        ),
        number("normal_work_j", "J", "work of normal forces on the two bodies", |(), p| {
            p.normal_work_j
        }),
        number("tangential_work_j", "J", "work of friction on the two bodies", |(), p| {
            p.tangential_work_j
        }),
        flag("touching_at_end", "whether the two bodies touch in the last step", |(), p| {
            p.touching_at_end
        }),
    ],
    shown: &[
        shown("First touch", "first_touch_s", SECONDS).sheet(10.0),
        shown("Peak normal force", "peak_normal_force_n", KILONEWTONS).sheet(12.0),
        shown("At", "peak_normal_force_at_s", SECONDS).sheet(10.0),
        shown("Peak penetration or deflection", "peak_depth_m", METRES).sheet(14.0),
        shown("Impulse", "impulse_ns", KILONEWTON_SECONDS).sheet(12.0),
        shown("Approach speed", "approach_speed_mps", METRES_PER_SECOND).sheet(12.0),
        shown("Approach speed", "approach_speed_mps", KNOTS).sheet(12.0),
        shown("Final speed", "final_speed_mps", METRES_PER_SECOND).sheet(12.0),
        shown("Final speed", "final_speed_mps", KNOTS).sheet(12.0),
    ],
};
