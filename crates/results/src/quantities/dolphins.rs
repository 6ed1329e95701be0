//! The quantities of a flexible dolphin.

use fenderline_sim::{BodySetup, DolphinSetup, DolphinSummary};

use super::Digits::{Fixed, Significant};
use super::scales::{
    KILOJOULES, KILONEWTONS, MEGANEWTONS_PER_M, MILLIMETRES, PERCENT, SECONDS, TONNES, TONNES_FORCE,
};
use super::{Catalogue, flag, given, known, number, shown};

/// Flexible dolphins.
pub static DOLPHINS: Catalogue<BodySetup, DolphinSummary> = Catalogue {
    subject: "dolphin",
    quantities: &[
        number("peak_deflection_m", "m", "largest deflection of the head", |_, d| {
            d.peak_deflection_m
        }),
        number(
            "peak_deflection_at_s",
            "s",
            "start of the step of the largest deflection",
            |_, d| d.peak_deflection_at_s,
        ),
        number("peak_load_n", "N", "largest load on the pile", |_, d| d.peak_load_n),
        number("peak_load_at_s", "s", "start of the step of the largest load", |_, d| {
            d.peak_load_at_s
        }),
        number("peak_energy_j", "J", "largest energy in the pile's bending", |_, d| {
            d.peak_energy_j
        }),
        number("damping_j", "J", "energy lost to damping of the pile", |_, d| d.damping_j),
        number("yield_j", "J", "energy lost to yielding", |_, d| d.yield_j),
        number("offset_m", "m", "permanent deflection", |_, d| d.offset_m),
        given("stiffness_npm", "N/m", "stiffness of the pile at its head", |s| {
            s.dolphin.as_ref().map(|dolphin| dolphin.stiffness_npm)
        }),
        given("mass_kg", "kg", "mass that moves with the head", |s| {
            s.dolphin.as_ref().map(|dolphin| dolphin.mass_kg)
        }),
        given("period_s", "s", "natural period without ship and fender", |s| {
            s.dolphin.as_ref().map(DolphinSetup::period_s)
        }),
        given("yield_load_n", "N", "load at which the pile yields", |s| {
            s.dolphin.as_ref()?.yield_load_n
        }),
        known("share_of_yield_load", "1", "largest load as a share of the yield load", |_, d| {
            d.share_of_yield_load
        }),
        known("yielded_at_s", "s", "start of the step in which the pile first yielded", |_, d| {
            d.yielded_at_s
        }),
        flag("yielded", "whether the pile yielded", |_, d: &DolphinSummary| {
            d.yielded_at_s.is_some()
        })
        .not_in_summary(),
    ],
    shown: &[
        shown("Stiffness", "stiffness_npm", MEGANEWTONS_PER_M).sheet(10.0),
        shown("Moving mass", "mass_kg", TONNES).sheet(10.0),
        shown("Period", "period_s", SECONDS).sheet(9.0),
        shown("Deflection", "peak_deflection_m", MILLIMETRES).sheet(11.0).printed(
            "deflection",
            10,
            1,
        ),
        shown("At", "peak_deflection_at_s", SECONDS).sheet(10.0),
        shown("Load", "peak_load_n", KILONEWTONS)
            .sheet(11.0)
            .printed("load", 10, 1)
            .reported(Significant(3), None),
        shown("Load", "peak_load_n", TONNES_FORCE).sheet(11.0),
        shown("At", "peak_load_at_s", SECONDS).sheet(10.0),
        shown("Energy", "peak_energy_j", KILOJOULES)
            .sheet(12.0)
            .printed("energy", 10, 1)
            .reported(Significant(3), None),
        shown("Stiffness", "stiffness_npm", MEGANEWTONS_PER_M).reported(Significant(3), None),
        shown("Period", "period_s", SECONDS).reported(Significant(3), None),
        shown("Of yield load", "share_of_yield_load", PERCENT).reported(Fixed(0), None),
        shown("Permanent", "offset_m", MILLIMETRES).reported(Fixed(0), None),
        shown("Yield load", "yield_load_n", KILONEWTONS).sheet(11.0),
        shown("of yield load", "share_of_yield_load", PERCENT).sheet(10.0).printed(
            "of yield load",
            13,
            0,
        ),
        shown("Yielded first", "yielded_at_s", SECONDS).sheet(10.0),
        shown("Permanent deflection", "offset_m", MILLIMETRES).sheet(12.0),
    ],
};
