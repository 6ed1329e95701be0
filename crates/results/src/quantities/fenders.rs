//! The quantities of a fender that was touched.

use fenderline_sim::{FenderSetup, FenderSummary};

use super::Digits::{Fixed, OfStep, Significant};
use super::scales::{
    DEGREES, FACTOR, KILOJOULES, KILONEWTONS, KILONEWTONS_PER_M2, KNOTS, METRES, METRES_PER_SECOND,
    MILLIMETRES, PERCENT, SECONDS, WORD,
};
use super::{Catalogue, flag, given, known, number, shown, word};
use crate::verdict::FenderVerdict;

/// Fenders.
pub static FENDERS: Catalogue<FenderSetup, FenderSummary> = Catalogue {
    subject: "fender",
    quantities: &[
        word("verdict", "the verdict on the fender", |s, f| Some(FenderVerdict::of(s, f).key())),
        flag("failed", "whether the fender was deflected beyond its travel", |_, f| f.failed),
        number(
            "first_touch_s",
            "s",
            "start of the first step in which the fender was touched",
            |_, f: &FenderSummary| f.first_touch_s,
        )
        .output("first_touch", SECONDS),
        number(
            "approach_speed_mps",
            "m/s",
            "speed normal to the fender's face at the first touch",
            |_, f: &FenderSummary| f.approach_speed_mps,
        )
        .output("approach_speed", METRES_PER_SECOND),
        number(
            "approach_angle_rad",
            "rad",
            "angle between hull and face at the first touch",
            |_, f: &FenderSummary| f.approach_angle_rad,
        )
        .output("approach_angle", DEGREES),
        number(
            "factor",
            "1",
            "factor on the reaction: temperature, tolerance, speed and angle",
            |_, f| f.factor,
        ),
        number("peak_deflection_m", "m", "largest deflection", |_, f: &FenderSummary| {
            f.peak_deflection_m
        })
        .output("deflection", MILLIMETRES),
        number(
            "peak_deflection_at_s",
            "s",
            "start of the step of the largest deflection",
            |_, f| f.peak_deflection_at_s,
        ),
        number(
            "peak_reaction_n",
            "N",
            "largest reaction along the fender's axis",
            |_, f: &FenderSummary| f.peak_reaction_n,
        )
        .output("reaction", KILONEWTONS),
        number("peak_reaction_at_s", "s", "start of the step of the largest reaction", |_, f| {
            f.peak_reaction_at_s
        }),
        number("peak_energy_j", "J", "largest energy absorbed", |_, f: &FenderSummary| {
            f.peak_energy_j
        })
        .output("energy", KILOJOULES)
        .in_fmu(),
        number("peak_energy_at_s", "s", "start of the step of the largest energy", |_, f| {
            f.peak_energy_at_s
        }),
        number("last_deflection_m", "m", "deflection in the last step", |_, f| f.last_deflection_m),
        number("last_reaction_n", "N", "reaction in the last step", |_, f| f.last_reaction_n),
        known(
            "peak_hull_pressure_npm2",
            "N/m²",
            "largest pressure on the hull",
            |_, f: &FenderSummary| f.peak_hull_pressure_npm2,
        )
        .output("hull_pressure", KILONEWTONS_PER_M2),
        known("capacity_j", "J", "rated energy times the run's factors", |_, f| f.capacity_j),
        known(
            "share_of_rated_energy",
            "1",
            "largest energy as a share of the rated energy with the run's factors",
            |_, f: &FenderSummary| f.share_of_rated_energy,
        )
        .output("energy_share", PERCENT)
        .in_fmu(),
        known(
            "share_of_rated_reaction",
            "1",
            "largest reaction as a share of the rated reaction with the run's factors",
            |_, f: &FenderSummary| f.share_of_rated_reaction,
        )
        .output("reaction_share", PERCENT),
        known(
            "share_of_rated_deflection",
            "1",
            "largest deflection as a share of the rated deflection",
            |_, f: &FenderSummary| f.share_of_rated_deflection,
        )
        .output("deflection_share", PERCENT),
        known(
            "share_of_catalogue_energy",
            "1",
            "largest energy as a share of the rated energy without the run's factors",
            |s, f| f.share_of_catalogue_energy(s),
        ),
        known(
            "share_of_catalogue_reaction",
            "1",
            "largest reaction as a share of the rated reaction without the run's factors",
            |_, f| f.share_of_catalogue_reaction(),
        ),
        known(
            "share_of_largest_reaction",
            "1",
            "largest reaction as a share of the largest reaction of the curve up to the rated \
             deflection, with the run's factors",
            |_, f: &FenderSummary| f.share_of_largest_reaction,
        )
        .not_in_summary(),
        word("governing", "the quantity that is nearest to its rated value", |_, f| {
            f.governing().map(|(quantity, _)| quantity)
        }),
        known(
            "governing_share",
            "1",
            "largest share of a rated value, that of the quantity `governing`",
            |_, f| f.governing().map(|(_, share)| share),
        ),
        known(
            "share_of_hull_pressure",
            "1",
            "largest pressure on the hull as a share of the permissible pressure",
            |_, f: &FenderSummary| f.share_of_hull_pressure,
        )
        .output("hull_pressure_share", PERCENT),
        given("rated_deflection_m", "m", "rated deflection", |s| s.rated.map(|r| r.deflection_m)),
        given("rated_reaction_n", "N", "rated reaction", |s| s.rated.map(|r| r.reaction_n)),
        given("rated_energy_j", "J", "rated energy", |s| s.rated.map(|r| r.energy_j)),
        given(
            "above_water_m",
            "m",
            "height of the face's middle above datum or water",
            |s: &FenderSetup| Some(s.above_water_m),
        )
        .not_in_summary(),
        given("hull_pressure_limit_npm2", "N/m²", "permissible pressure on the hull", |s| {
            s.hull_pressure_limit_npm2
        }),
        known("height_on_hull_m", "m", "height of the first touch on the hull", |_, f| {
            f.hull.map(|hull| hull.height_m)
        }),
        known(
            "vertical_angle_rad",
            "rad",
            "angle by which the hull's side leans out over the fender at the first touch",
            |_, f| f.hull.map(|hull| hull.vertical_angle_rad),
        ),
        known(
            "peak_vertical_force_n",
            "N",
            "vertical force on the hull with the largest magnitude, positive up",
            |_, f| f.hull.map(|hull| hull.peak_vertical_force_n),
        ),
    ],
    shown: &[
        shown("Governed by", "governing", WORD).sheet(11.0),
        shown("Deflection", "peak_deflection_m", MILLIMETRES)
            .sheet(11.0)
            .printed("deflection", 10, 1)
            .reported(Fixed(0), Some("share_of_rated_deflection")),
        shown("of rated", "share_of_rated_deflection", PERCENT).sheet(9.0),
        shown("Reaction", "peak_reaction_n", KILONEWTONS)
            .sheet(11.0)
            .printed("reaction", 10, 1)
            .reported(Significant(3), Some("share_of_rated_reaction"))
            .with_catalogue("share_of_catalogue_reaction", "share_of_largest_reaction"),
        shown("of rated", "share_of_rated_reaction", PERCENT).sheet(9.0),
        shown("of catalogue", "share_of_catalogue_reaction", PERCENT).sheet(11.0),
        shown("Energy", "peak_energy_j", KILOJOULES)
            .sheet(12.0)
            .printed("energy", 10, 1)
            .reported(Significant(3), Some("share_of_rated_energy"))
            .with_catalogue("share_of_catalogue_energy", "share_of_rated_energy"),
        shown("of rated", "share_of_rated_energy", PERCENT).sheet(9.0),
        shown("of catalogue", "share_of_catalogue_energy", PERCENT).sheet(11.0),
        shown("Hull pressure", "peak_hull_pressure_npm2", KILONEWTONS_PER_M2)
            .sheet(11.0)
            .printed("on hull", 7, 0)
            .reported(Fixed(0), Some("share_of_hull_pressure")),
        shown("of permissible", "share_of_hull_pressure", PERCENT).sheet(12.0),
        shown("First touch", "first_touch_s", SECONDS).sheet(10.0).reported(OfStep, None),
        shown("Approach speed", "approach_speed_mps", METRES_PER_SECOND).sheet(10.0),
        shown("Approach speed", "approach_speed_mps", KNOTS).sheet(10.0),
        shown("Angle", "approach_angle_rad", DEGREES).sheet(9.0),
        shown("Factor on reaction", "factor", FACTOR).sheet(10.0),
        shown("Rated energy with factors", "capacity_j", KILOJOULES).sheet(13.0),
        shown("Rated deflection", "rated_deflection_m", MILLIMETRES).sheet(11.0),
        shown("Rated reaction", "rated_reaction_n", KILONEWTONS).sheet(11.0),
        shown("Rated energy", "rated_energy_j", KILOJOULES).sheet(12.0),
        shown("Middle of the face above datum or water", "above_water_m", METRES).sheet(14.0),
        shown("Met at height on the hull", "height_on_hull_m", METRES).sheet(12.0),
        shown("Flare there", "vertical_angle_rad", DEGREES).sheet(9.0),
        shown("Peak vertical force on the hull", "peak_vertical_force_n", KILONEWTONS).sheet(13.0),
    ],
};
