//! Tables of the report: results, bodies, materials, loads, and settings of the run.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::{BodySetup, Load, NamedMaterial, PairSummary, Setup};
use maud::{Markup, html};

use crate::plot::{decimals_for, fixed, plain, significant};
use crate::{Head, table_head};
use fenderline_results::Outcome;

/// Number of rows that are shown of a long table.
pub(super) const ROWS: usize = 30;

/// Newtons in a tonne-force, the unit in which lines, chains and tugs are rated too.
pub(super) const TONNE_N: f64 = 9806.65;

pub(super) fn number(text: &str) -> Markup {
    html! { td class="number" { (text) } }
}

pub(super) fn more(total: usize) -> Markup {
    html! {
        @if total > ROWS {
            p class="note" { (format!("and {} more rows are not shown.", total - ROWS)) }
        }
    }
}

/// The table of key results, with one row for each pair of bodies, the largest force first.
pub(super) fn results(outcome: &Outcome<'_>) -> Markup {
    let mut pairs: Vec<&PairSummary> = outcome.pairs.iter().collect();
    pairs.sort_by(|a, b| b.peak_normal_force_n.total_cmp(&a.peak_normal_force_n));
    if pairs.is_empty() {
        return html! { p { "No bodies touched in this run." } };
    }
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Contact"),
                    Head::Number("First touch", "s"),
                    Head::Number("Peak normal force", "kN"),
                    Head::Number("at", "s"),
                    Head::Number(depth_head(&pairs), "m"),
                    Head::Number("Impulse", "kN·s"),
                    Head::Number("Approach speed", "m/s (kn)"),
                    Head::Number("Final speed", "m/s (kn)"),
                ]))
                tbody {
                    @for (index, pair) in pairs.iter().take(ROWS).enumerate() {
                        tr class=[(index == 0 && pairs.len() > 1).then_some("strong")] {
                            (result_cells(pair, outcome.setup))
                        }
                    }
                }
            }
        }
        (more(pairs.len()))
        p class="note" {
            "Speeds are relative and along the contact normal: the approach speed at the first touch, positive \
            when closing; the final speed at the end of the last step with contact, positive when separating."
            @if pairs.iter().any(|p| p.touching_at_end) {
                " † Still touching at the end of the run."
            }
        }
    }
}

fn result_cells(pair: &PairSummary, setup: &Setup) -> Markup {
    let [name_1, name_2] = pair.bodies.map(|i| setup.bodies[i].name.as_str());
    let decimals = decimals_for(setup.step_s);
    html! {
        td class="name" { (name_1) " – " (name_2) @if pair.touching_at_end { "\u{a0}†" } }
        (number(&fixed(pair.first_touch_s, decimals)))
        (number(&significant(pair.peak_normal_force_n / 1e3, 4)))
        (number(&fixed(pair.peak_normal_force_at_s, decimals)))
        td class="number" {
            (fixed(pair.peak_depth_m, 3))
            @if let Some(fender) = pair.peak_depth_fender { small { (setup.fenders[fender].name) } }
        }
        (number(&significant(pair.impulse_ns / 1e3, 4)))
        (number(&speed(pair.approach_speed_mps)))
        (number(&speed(pair.final_speed_mps)))
    }
}

/// The head of the column of depths: a contact through a fender has a deflection of the fender instead of a
/// penetration.
fn depth_head(pairs: &[&PairSummary]) -> &'static str {
    let by_fender = pairs.iter().filter(|pair| pair.peak_depth_fender.is_some()).count();
    match by_fender {
        0 => "Peak penetration",
        all if all == pairs.len() => "Peak deflection",
        _ => "Peak penetration or deflection",
    }
}

/// Rounds a length (m) to the millimetre; less than half a millimetre becomes 0.
fn to_millimetres(length_m: f64) -> f64 {
    // No −0.
    libm::round(1e3 * length_m) / 1e3 + 0.0
}

/// The text of a speed in m/s, with knots beside it.
fn speed(speed_mps: f64) -> String {
    format!("{} ({})", fixed(speed_mps, 3), fixed(speed_mps / KNOT_MPS, 2))
}

/// The tables of everything that the scenario set.
pub(super) fn setup(outcome: &Outcome<'_>) -> Markup {
    let setup = outcome.setup;
    html! {
        h3 { "Bodies" }
        (bodies(&setup.bodies))
        h3 { "Materials" }
        (materials(&setup.materials))
        @if !setup.loads.is_empty() {
            h3 { "External loads" }
            (loads(setup))
        }
        dl {
            dt { "Pairs that may touch" }
            dd {
                (setup.pairs.len()) " named"
                @if let Some(material) = setup.all_other_pairs {
                    "; every other pair with the material " (setup.materials[material].name)
                }
            }
        }
    }
}

fn bodies(bodies: &[BodySetup]) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Body"),
                    Head::Number("Length ×\u{a0}breadth", "m"),
                    Head::Number("Displacement", "t"),
                    Head::Number("Added mass", "surge / sway, t"),
                    Head::Number("Gyradius", "m"),
                    Head::Number("Position", "north, east, m"),
                    Head::Number("Heading", "deg"),
                    Head::Number("Speed", "m/s (kn)"),
                    Head::Number("Rate of turn", "deg/s"),
                ]))
                tbody { @for body in bodies.iter().take(ROWS) { (body_row(body)) } }
            }
        }
        (more(bodies.len()))
        p class="note" {
            "Length and breadth are measured on the outline. Gyradius and displacement are without \
             added mass. Speed is the speed over ground at the start."
        }
    }
}

fn body_row(body: &BodySetup) -> Markup {
    let (low, high) = body.outline.bounds();
    let size = high - low;
    let velocity = body.velocity;
    let speed_mps = fenderline_contact::vec2(velocity.surge_mps, velocity.sway_mps).length();
    let heading_deg = body.heading_rad.to_degrees().rem_euclid(360.0);
    // A heading a hair below 360° reads 0.
    let heading_deg = if heading_deg > 359.995 { 0.0 } else { heading_deg };
    html! {
        tr {
            td class="name" { (body.name) }
            (number(&format!("{} × {}", plain(size.x, 4), plain(size.y, 4))))
            @if let Some(mass) = body.mass {
                (number(&plain(mass.mass_kg / 1e3, 6)))
                (number(&format!("{} / {}",
                    plain(mass.added_surge_kg / 1e3, 4),
                    plain(mass.added_sway_kg / 1e3, 4))))
                (number(&plain(libm::sqrt(mass.yaw_inertia_kgm2 / mass.mass_kg), 4)))
            } @else {
                td class="number" { "fixed" }
                td class="number" { "–" }
                td class="number" { "–" }
            }
            (number(&format!("{}, {}",
                plain(to_millimetres(body.position_m.x), 6), plain(to_millimetres(body.position_m.y), 6))))
            (number(&plain(heading_deg, 4)))
            @if body.mass.is_some() {
                (number(&speed(speed_mps)))
                (number(&plain(velocity.yaw_radps.to_degrees(), 3)))
            } @else {
                td class="number" { "–" }
                td class="number" { "–" }
            }
        }
    }
}

fn materials(materials: &[NamedMaterial]) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Material"),
                    Head::Number("Stiffness k", "kN/m²"),
                    Head::Number("Damping c", "kN·s/m²"),
                    Head::Number("Shear stiffness k_s", "kN/m"),
                    Head::Number("Static friction μ_s", "–"),
                    Head::Number("Dynamic friction μ_k", "–"),
                    Head::Number("Restitution γ", "–"),
                ]))
                tbody {
                    @for NamedMaterial { name, material } in materials.iter().take(ROWS) {
                        tr {
                            td class="name" { (name) }
                            (number(&plain(material.stiffness_npm2 / 1e3, 4)))
                            (number(&plain(material.damping_nspm2 / 1e3, 4)))
                            (number(&plain(material.shear_stiffness_npm / 1e3, 4)))
                            (number(&material.friction_static.to_string()))
                            (number(&material.friction_dynamic.to_string()))
                            (number(&material.restitution.to_string()))
                        }
                    }
                }
            }
        }
        (more(materials.len()))
    }
}

fn loads(setup: &Setup) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Body"),
                    Head::Number("Force north", "kN"),
                    Head::Number("Force east", "kN"),
                    Head::Number("Moment", "kN·m"),
                    Head::Number("From", "s"),
                    Head::Number("Until", "s"),
                ]))
                tbody {
                    @for load in setup.loads.iter().take(ROWS) { (load_row(load, setup)) }
                }
            }
        }
        (more(setup.loads.len()))
    }
}

fn load_row(load: &Load, setup: &Setup) -> Markup {
    html! {
        tr {
            td class="name" { (setup.bodies[load.body].name) }
            (number(&plain(load.force_n.x / 1e3, 4)))
            (number(&plain(load.force_n.y / 1e3, 4)))
            (number(&plain(load.moment_nm / 1e3, 4)))
            (number(&load.from_s.to_string()))
            @if load.until_s.is_finite() {
                (number(&load.until_s.to_string()))
            } @else {
                td class="number" { "end of run" }
            }
        }
    }
}
