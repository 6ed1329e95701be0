//! The report's section of assumptions: method, ships, fenders, water, and the data that must be checked.

use fenderline_contact::BodyState;
use fenderline_contact::number::greater;
use fenderline_sim::hydro::shallow::PUBLISHED_RATIO;
use fenderline_sim::{BodySetup, Integrator, Method, Setup};
use maud::{Markup, html};

use super::method_notes::method_notes;
use super::recorder::Recorder;
use super::{fenders, scene, vessels};
use crate::plot::{fixed, plain};
use fenderline_results::Outcome;

/// Times of at least this length are given in hours too (s).
const HOUR_S: f64 = 3600.0;
/// Largest number of listed ships.
const SHIPS: usize = 8;

/// Writes the section of assumptions.
pub(super) fn section(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let setup = outcome.setup;
    html! {
        section class="assumptions" {
            h2 { "Assumptions" }
            dl {
                (computation(outcome))
                (ships(setup))
                (contact(setup))
                (formula(outcome))
                (water(setup, recorder))
            }
            (fenders::data(setup))
            (to_check(outcome))
            h3 { "Method and its limits" }
            (method_notes(outcome))
        }
    }
}

fn computation(outcome: &Outcome<'_>) -> Markup {
    let setup = outcome.setup;
    html! {
        dt { "Contact" }
        dd { @match setup.method {
            Method::Coupled => "coupled method: all contacts and loads of a step in one solve, with sub-steps",
            Method::Paper => "paper method: the limiter treats each pair of bodies by itself",
        } }
        dt { "Time" }
        dd {
            (outcome.duration_s()) " s "
            @if outcome.duration_s() >= HOUR_S { "(" (plain(outcome.duration_s() / HOUR_S, 3)) " h) " }
            "in steps of " (setup.step_s) " s; "
            @match setup.integrator {
                Integrator::Euler => "forward Euler",
                Integrator::SemiImplicit => "semi-implicit Euler",
                Integrator::Rk4 => "classical Runge–Kutta of fourth order",
            }
        }
    }
}

/// The list of floating bodies with their mass and added mass.
fn ships(setup: &Setup) -> Markup {
    let floating: Vec<(usize, &BodySetup)> =
        setup.bodies.iter().enumerate().filter(|(_, body)| body.mass.is_some()).collect();
    html! {
        @for &(index, body) in floating.iter().take(SHIPS) {
            @if let Some(mass) = body.mass {
                dt { (body.name) }
                dd {
                    (plain(mass.mass_kg / 1e3, 6)) " t; added mass "
                    (fixed(100.0 * mass.added_surge_kg / mass.mass_kg, 0)) " % in surge, "
                    (fixed(100.0 * mass.added_sway_kg / mass.mass_kg, 0))
                    " % in sway (virtual mass factor C" sub { "m" } " " (fixed(1.0 + mass.added_sway_kg / mass.mass_kg, 2))
                    @if let Some(ratio) = extrapolated(setup, index) {
                        ", by our extrapolation: the ship has " (fixed(ratio, 2)) " draughts of \
                            water, and published tests end at "
                        (PUBLISHED_RATIO)
                    }
                    "); radius of gyration " (plain(libm::sqrt(mass.yaw_inertia_kgm2 / mass.mass_kg), 3)) "\u{a0}m"
                }
            }
        }
        @if floating.len() > SHIPS {
            dt { "Other floating bodies" }
            dd { (floating.len() - SHIPS) ", under Set-up" }
        }
    }
}

/// Ratio of water depth to draught at the start, for a vessel whose added mass is our extrapolation in such shallow
/// water; else `None`.
fn extrapolated(setup: &Setup, body: usize) -> Option<f64> {
    let vessel = setup.world.vessels.iter().find(|vessel| vessel.body == body)?;
    let own = &setup.bodies[body];
    let (position_m, heading_rad) = (own.position_m, own.heading_rad);
    let state = BodyState { position_m, heading_rad, ..BodyState::default() };
    let soundings = vessel.soundings(&state, &setup.world.environment, 0.0).ok()?;
    let ratio = soundings.mean_m? / vessel.deep.particulars.draught_m;
    Some(ratio).filter(|ratio| *ratio < PUBLISHED_RATIO)
}

/// The lines about friction and factors of the fenders, each range of values once.
fn contact(setup: &Setup) -> Markup {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, 0.0), |(low, high), value: f64| {
            (if value < low { value } else { low }, greater(high, value))
        });
        if low == high { plain(low, 3) } else { format!("{} to {}", plain(low, 3), plain(high, 3)) }
    };
    let fenders = &setup.fenders;
    let material = |fender: &fenderline_sim::FenderSetup| setup.materials[fender.material].material;
    let by_speed = fenders.iter().any(|f| !f.factors.by_compression_time.is_empty());
    let by_angle = fenders.iter().any(|f| !f.factors.by_angle.is_empty());
    html! {
        @if !fenders.is_empty() {
            dt { "Fender factors" }
            dd {
                "temperature, tolerance and other constants "
                (range(&mut fenders.iter().map(|f| f.factors.constant)))
                "; by speed: " (if by_speed { "yes" } else { "none" })
                "; by angle: " (if by_angle { "yes" } else { "none" })
                ". The table of fenders has the factor of each fender."
            }
            dt { "Friction on fenders" }
            dd { "μ " (range(&mut fenders.iter().map(|f| material(f).friction_dynamic))) " when sliding" }
        }
    }
}

/// The lines about the assumptions of the berthing energy by formula.
fn formula(outcome: &Outcome<'_>) -> Markup {
    let Some(Ok(berthing)) = outcome.berthing else { return html! {} };
    html! { dt { "Energy by formula" } dd { (super::berthing::factors_in_words(berthing)) } }
}

fn water(setup: &Setup, recorder: &Recorder) -> Markup {
    let environment = &setup.world.environment;
    let weather = scene::weather_texts(environment, recorder);
    html! {
        dt { "Wind, current, waves" }
        dd { (if weather.is_empty() { "none".to_owned() } else { weather.join("; ") }) }
        dt { "Water" }
        dd { @match environment.depth_range_m() {
            None => "deep",
            Some([low_m, high_m]) if environment.bottom.is_some() => {
                "depth by place, from " (plain(low_m, 4)) " to " (plain(high_m, 4)) " m"
            }
            Some([low_m, high_m]) => {
                (plain(low_m, 4)) " m deep"
                @if high_m > low_m { " at low, " (plain(high_m, 4)) " m at high water" }
            }
        } }
    }
}

/// The list of data that were recalled, derived or estimated, and must be checked before the design is used.
fn to_check(outcome: &Outcome<'_>) -> Markup {
    let mut all = fenders::to_check(outcome.setup);
    all.extend(vessels::to_check(outcome));
    html! {
        @if !all.is_empty() {
            h3 { "To be checked against documents before use" }
            ul class="plain" { @for text in &all { li { (text) } } }
        }
    }
}
