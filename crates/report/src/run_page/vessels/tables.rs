//! The report's tables of vessels, tugs and mooring lines.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::environment::BankMethod;
use fenderline_sim::environment::waves::MotionResponse;
use fenderline_sim::hydro::vessels::{Origin, Source, Standing};
use fenderline_sim::overhead::OverheadSetup;
use fenderline_sim::{Environment, VesselSetup};
use maud::{Markup, html};

use super::headline::class;
use crate::plot::{fixed, plain, significant};
use crate::run_page::tables::{ROWS, TONNE_N, more, number};
use crate::words::with_code;
use crate::{Head, table_head};
use fenderline_results::Outcome;
use fenderline_results::{ACCURACY, accuracy};
use fenderline_results::{LineTotals, TugTotals, VesselTotals};

/// The tables of the vessels' particulars, and of their largest motions.
pub(super) fn vessels(outcome: &Outcome<'_>) -> Markup {
    let (setup, world) = (outcome.setup, outcome.world);
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Vessel"),
                    Head::Number("Length bp × beam × draught", "m"),
                    Head::Number("Block coefficient", "–"),
                    Head::Number("Full revolutions", "rpm"),
                    Head::Number("Rudder", "stop deg, deg/s"),
                    Head::Number("Thrusters and azimuth units", "kN each"),
                    Head::Number("Largest speed", "over ground, kn"),
                    Head::Number("Largest rate of turn", "deg/min"),
                    Head::Number("Largest roll", "deg"),
                ]))
                tbody {
                    @for (vessel, totals) in setup.world.vessels.iter().zip(&world.vessels).take(ROWS) {
                        tr { (vessel_cells(&setup.bodies[vessel.body].name, vessel, totals)) }
                    }
                }
            }
        }
        (more(world.vessels.len()))
        @for vessel in setup.world.vessels.iter().take(ROWS) {
            (source(outcome, vessel))
        }
        @for (vessel, totals) in setup.world.vessels.iter().zip(&world.vessels).take(ROWS) {
            (under_keel(&setup.bodies[vessel.body].name, totals, &setup.world.environment))
            (under_bridges(&setup.bodies[vessel.body].name, totals, &setup.world.overhead))
        }
        (banks(&setup.world.environment))
    }
}

fn vessel_cells(name: &str, vessel: &VesselSetup, totals: &VesselTotals) -> Markup {
    let ship = &vessel.ship.particulars;
    let named = |name: &str, bollard_n: f64| format!("{name} {}", plain(bollard_n / 1e3, 3));
    let tunnels = vessel.thrusters.iter().map(|t| named(&t.name, t.tunnel.bollard_n));
    let azimuths = vessel.azimuths.iter().map(|a| named(&a.name, a.bollard_n));
    let thrusters: Vec<String> = tunnels.chain(azimuths).collect();
    let has_gear = vessel.ship.propulsion.is_some();
    let gear = |text: String| if has_gear { text } else { "none".to_owned() };
    let rudder = &vessel.rudder;
    html! {
        td class="name" { (name) }
        (number(&format!(
            "{} × {} × {}",
            plain(ship.length_m, 4), plain(ship.beam_m, 4), plain(ship.draught_m, 4)
        )))
        (number(&fixed(ship.block_coefficient(), 3)))
        (number(&gear(plain(60.0 * vessel.shaft.stop, 4))))
        (number(&gear(format!(
            "{}, {}",
            plain(rudder.stop.to_degrees(), 3), plain(rudder.rate_per_s.to_degrees(), 3)
        ))))
        td class="number list" {
            (if thrusters.is_empty() { "none".to_owned() } else { thrusters.join(", ") })
        }
        (number(&fixed(totals.over_ground_mps.value / KNOT_MPS, 2)))
        (number(&fixed(60.0 * totals.rate_of_turn_radps.value.to_degrees(), 2)))
        (number(&fixed(totals.roll_rad.value.to_degrees(), 2)))
    }
}

/// The list of sources of a vessel's data. Estimates are marked.
fn source(outcome: &Outcome<'_>, vessel: &VesselSetup) -> Markup {
    let name = outcome.setup.bodies[vessel.body].name.as_str();
    let environment = &outcome.setup.world.environment;
    let origin = &vessel.origin;
    let has_estimates = origin.estimates().next().is_some();
    html! {
        p { (name) ": " strong { (origin.title) } ". Sources of her data:" }
        ul class="plain" {
            @for source in origin.sources.iter().filter(|source| !source.is_estimate) {
                li { (source.group.replace('_', " ")) ": " (source.source) " – " (standing(source)) }
            }
        }
        @if has_estimates {
            p {
                span class="verdict over_rated" { "ESTIMATED" }
                (format!(
                    " Missing data of {name} are estimated by formulas that are not validated for \
                     this ship. Do not use the estimates as manoeuvring data of this ship."
                ))
            }
            (estimates(origin))
            @let accuracy = accuracy(origin, outcome.estimate_errors);
            @if !accuracy.is_empty() {
                p { (with_code(ACCURACY)) ":" }
                ul class="plain" { @for line in &accuracy { li { (line) } } }
            }
        }
        @if let (Some(windage), true) = (&vessel.windage, environment.wind.is_some()) {
            @let (method, standing) = windage.method.standing();
            p class="note" { (name) ": wind coefficients by " (method) ": " (standing) "." }
        }
        @if let Some(table) = &vessel.current_table {
            @let [alone_mps, gone_mps] = table.speeds_mps();
            p class="note" {
                (format!(
                    "{name}: hull force in a current by the scenario's table: {}. The table acts \
                     alone up to {} kn through the water, and hands over to the manoeuvring model \
                     until {} kn. The effect of the rate of turn comes from the model.",
                    table.source(),
                    fixed(alone_mps / KNOT_MPS, 1),
                    fixed(gone_mps / KNOT_MPS, 1),
                ))
            }
        }
        @if environment.sea.is_some() {
            @match &vessel.response {
                Some(MotionResponse::Estimate(_)) => p class="note" {
                    (name) ": motion in waves is an " strong { "estimate" } " of a box-shaped hull."
                }
                Some(MotionResponse::Table(_)) => p class="note" {
                    (format!(
                        "{name}: motion in waves is by the scenario's table of response amplitude \
                         operators."
                    ))
                }
                None => {}
            }
        }
    }
}

/// The table of squat and under-keel clearance, if the scenario gives a water depth.
fn under_keel(name: &str, totals: &VesselTotals, environment: &Environment) -> Markup {
    html! {
        @if let Some(least) = totals.under_keel_m {
            p class="note" {
                (name) ": minimum under-keel clearance " (fixed(least.value, 2)) " m at "
                (plain(least.at_s, 6)) " s"
                @let [low_m, high_m] = environment.level_range_m();
                @if low_m != 0.0 || high_m != 0.0 {
                    @if low_m < high_m {
                        ", the water between " (plain(low_m, 4)) " and " (plain(high_m, 4)) " m above datum"
                    } @else {
                        ", the water " (plain(low_m, 4)) " m above datum"
                    }
                }
                @if let Some(squat) = environment.squat {
                    "; largest squat " (fixed(totals.squat_m.value, 2)) " m at "
                    (plain(totals.squat_m.at_s, 6)) " s, by " (squat.name())
                    ", a formula of open water that is " strong { "not validated" }
                }
                "."
            }
        }
    }
}

/// The least clearance under a bridge or cable, if the vessel passed under one.
fn under_bridges(name: &str, totals: &VesselTotals, overhead: &OverheadSetup) -> Markup {
    html! {
        @if let Some((least, structure)) = totals.air_clearance_m {
            p class="note" {
                (name) ": minimum clearance under a bridge or cable " (fixed(least.value, 2)) " m at "
                (plain(least.at_s, 6)) " s, under the " (overhead.structures[structure].name)
                @if least.value < 0.0 { ": " strong { "she is too high" } }
                "."
            }
        }
    }
}

/// The note on how well the methods for bank suction are known.
fn banks(environment: &Environment) -> Markup {
    let has = |method| environment.banks.iter().any(|bank| bank.method() == method);
    html! {
        @if has(BankMethod::Norrbin) {
            p {
                span class="verdict over_rated" { "UNVALIDATED" } " \
                The suction of banks on vessels is by Norrbin's formulas for a vertical wall, which \
                are recalled: we could read no source of these formulas, and found no data to \
                validate them."
            }
        }
        @if has(BankMethod::Image) {
            p {
                span class="verdict over_rated" { "UNVALIDATED" } " The suction of banks on \
                    vessels is computed from the vessel's image behind the bank, for slender ships \
                    in potential flow without waves and lift. This method was compared with panels \
                    in the same flow, which give up to 2.7 times as much, and not with \
                    measurements. The moment that turns the bow away is left out."
            }
        }
    }
}

/// The table of every estimated quantity, with its formula and how certain that formula is.
fn estimates(origin: &Origin) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Estimated"),
                    Head::Name("Value"),
                    Head::Name("By"),
                    Head::Name("Standing of the formula"),
                ]))
                tbody {
                    @for source in origin.estimates() {
                        tr {
                            td class="name" { (source.group) }
                            td class="name" {
                                @for (index, figure) in source.figures.iter().enumerate() {
                                    @if index > 0 { ", " }
                                    (symbols(&figure.name)) " = " (figure.text.replace('-', "\u{2212}"))
                                }
                            }
                            td class="name" { (symbols(&source.source)) }
                            td class="name" { (standing(source)) }
                        }
                    }
                }
            }
        }
    }
}

/// Marks up a text: `m_x` becomes a symbol with a subscript, longer names with a `_` stay as they are.
fn symbols(text: &str) -> Markup {
    let is_symbol = |before: &str| {
        // A prime stands for a number without dimension.
        let mut last = before.trim_end_matches('\'').chars().rev();
        last.next().is_some_and(char::is_alphabetic)
            && !last.next().is_some_and(char::is_alphanumeric)
    };
    let mut done = "";
    let parts = text.split_inclusive('_').map(|part| {
        let is_below = is_symbol(done);
        done = part.strip_suffix('_').unwrap_or("");
        let end = part.find(|c: char| !c.is_alphanumeric()).unwrap_or(part.len());
        let (low, rest) = if is_below { part.split_at(end) } else { ("", part) };
        let rest = if is_symbol(done) { rest.trim_end_matches('_') } else { rest };
        html! { @if !low.is_empty() { sub { (low) } } (rest) }
    });
    let parts: Vec<Markup> = parts.collect();
    html! { @for part in &parts { (part) } }
}

fn standing(source: &Source) -> Markup {
    html! {
        @match source.standing {
            Standing::Recalled => strong { "recalled: to be checked" },
            known => (known.word()),
        }
    }
}

/// The table of the tugs: orders and forces.
pub(super) fn tugs(outcome: &Outcome<'_>) -> Markup {
    let (setup, world) = (outcome.setup, outcome.world);
    let body = |vessel: usize| setup.bodies[setup.world.vessels[vessel].body].name.as_str();
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Tug"),
                    Head::Name("Serves"),
                    Head::Number("Bollard pull", "tf (kN)"),
                    Head::Number("Peak force", "tf (kN)"),
                    Head::Number("at", "s"),
                    Head::Number("At work", "min"),
                    Head::Number("Force limited", "s"),
                ]))
                tbody {
                    @for (tug, totals) in setup.world.tugs.iter().zip(&world.tugs).take(ROWS) {
                        tr {
                            td class="name" { (tug.tug.name) }
                            td class="name" { (body(tug.vessel)) }
                            (tug_cells(tug.tug.envelope.bollard_pull_n, totals))
                        }
                    }
                }
            }
        }
        (more(world.tugs.len()))
        p class="note" {
            "Tugs are forces at the ship's side, not hulls. " strong { "Derived" } ": the force of \
                a tug at speed is derived from bollard pull and drag; we found no published \
                envelope. Force limited: time in which speed and angle allowed less than the ordered force."
        }
    }
}

fn tug_cells(bollard_pull_n: f64, totals: &TugTotals) -> Markup {
    let tonnes = |n: f64| format!("{} ({})", plain(n / TONNE_N, 3), significant(n / 1e3, 3));
    html! {
        (number(&tonnes(bollard_pull_n)))
        (number(&tonnes(totals.force_n.value)))
        (number(&fixed(totals.force_n.at_s, 1)))
        (number(&fixed(totals.at_work.s() / 60.0, 1)))
        (number(&fixed(totals.limited.s(), 1)))
    }
}

/// What the lines bore.
pub(super) fn lines(outcome: &Outcome<'_>) -> Markup {
    let (setup, world) = (outcome.setup, outcome.world);
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Line"),
                    Head::Number("Made fast", "s"),
                    Head::Number("Break load", "kN (t)"),
                    Head::Number("Working load", "kN (t)"),
                    Head::Number("Peak tension", "kN (t)"),
                    Head::Number("of break load", "%"),
                    Head::Number("at", "s"),
                    Head::Number("Rendered", "m"),
                    Head::Number("At the end", "kN"),
                    Head::Text("Verdict", ""),
                ]))
                tbody {
                    @for (line, totals) in setup.world.lines.iter().zip(&world.lines).take(ROWS) {
                        tr {
                            td class="name" { (line.line.name) }
                            (line_cells(totals))
                        }
                    }
                }
            }
        }
        (more(world.lines.len()))
        p class="note" {
            "The tension is that at the ship's end; the break load is the lesser of those of rope \
             and tail. Working load: 55 % of the rope's break load for wire, 50 % for others \
             (MEG4, from public summaries), unless the scenario gives it."
        }
    }
}

fn line_cells(totals: &LineTotals) -> Markup {
    let verdict = totals.verdict();
    let kilo = |value: Option<f64>| value.map_or_else(|| "–".into(), |n| significant(n / 1e3, 3));
    let load = |value: Option<f64>| {
        let text = |n: f64| format!("{} ({})", significant(n / 1e3, 3), plain(n / TONNE_N, 3));
        value.map_or_else(|| "–".into(), text)
    };
    html! {
        (number(&totals.made_fast_s.map_or_else(|| "–".to_owned(), |t| fixed(t, 1))))
        (number(&load(totals.break_load_n)))
        (number(&load(totals.working_load_n)))
        (number(&load(totals.made_fast_s.map(|_| totals.tension_n.value))))
        (number(&totals.share_of_break_load().map_or_else(|| "–".to_owned(), |s| fixed(100.0 * s, 0))))
        (number(&totals.made_fast_s.map_or_else(|| "–".to_owned(), |_| fixed(totals.tension_n.at_s, 1))))
        (number(&fixed(totals.rendered_m, 2)))
        (number(&kilo(totals.made_fast_s.map(|_| totals.last_tension_n))))
        td { span class={ "verdict " (class(verdict)) } { (verdict.text()) } }
    }
}

#[cfg(test)]
mod tests {
    use super::symbols;

    #[test]
    fn a_symbol_has_its_subscript() {
        for (text, shown) in [
            ("m_x/m", "m<sub>x</sub>/m"),
            ("J_z/I_z", "J<sub>z</sub>/I<sub>z</sub>"),
            ("C_T = 0.004", "C<sub>T</sub> = 0.004"),
            ("x'_H = -0.4", "x'<sub>H</sub> = -0.4"),
            ("own_file and m_y", "own_file and m<sub>y</sub>"),
            ("plain", "plain"),
        ] {
            assert_eq!(symbols(text).into_string(), shown);
        }
    }
}
