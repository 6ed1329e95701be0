//! The orders of a run, in time.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::mooring::WinchOrder;
use fenderline_sim::tug::TugOrder;
use fenderline_sim::{Action, Assist, Job, Order, Setup};
use maud::{Markup, html};

use crate::plot::{fixed, plain};
use crate::run_page::tables::{ROWS, more, number};
use crate::{Head, table_head};
use fenderline_results::Outcome;

/// One row an order, in the order of time.
pub(super) fn table(outcome: &Outcome<'_>) -> Markup {
    let setup = outcome.setup;
    let mut orders: Vec<&Order> = setup.world.orders.iter().collect();
    orders.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
    html! {
        div class="wide" {
            table class="narrow" {
                (table_head(&[
                    Head::Number("Time", "s"),
                    Head::Name("To"),
                    Head::Name("Order"),
                ]))
                tbody {
                    @for order in orders.iter().take(ROWS) {
                        tr {
                            (number(&plain(order.at_s, 6)))
                            td class="name" { (addressee(order, setup)) }
                            td class="name" { (text(order, setup)) }
                        }
                    }
                }
            }
        }
        (more(orders.len()))
    }
}

fn addressee(order: &Order, setup: &Setup) -> String {
    let world = &setup.world;
    match order.action {
        Action::Tug(tug, _) => format!("tug {}", world.tugs[tug].tug.name),
        Action::Winch(line, _) | Action::LetGo(line) => {
            format!("line {}", world.lines[line].line.name)
        }
        _ => setup.bodies[world.vessels[order.vessel].body].name.clone(),
    }
}

/// As a bridge would say it.
fn text(order: &Order, setup: &Setup) -> String {
    let world = &setup.world;
    match &order.action {
        Action::Rudder(angle_rad) if *angle_rad == 0.0 => "rudder midships".to_owned(),
        Action::Rudder(angle_rad) => format!("rudder {}", sided(angle_rad.to_degrees(), "°")),
        Action::Engine(share) if *share == 0.0 => "engine stop".to_owned(),
        Action::Engine(share) => {
            let way = if *share > 0.0 { "ahead" } else { "astern" };
            format!("engine {way}, {} % of full revolutions", fixed(100.0 * share.abs(), 0))
        }
        Action::Thruster(index, power) => {
            let name = &world.vessels[order.vessel].thrusters[*index].name;
            if *power == 0.0 {
                return format!("thruster {name} stop");
            }
            format!("thruster {name} {}", sided(100.0 * power, " %"))
        }
        Action::Azimuth { unit, power, direction_rad } => {
            let name = &world.vessels[order.vessel].azimuths[*unit].name;
            let power = power.map(|power| format!(" {} %", fixed(100.0 * power, 0)));
            let direction = direction_rad.map(|angle_rad| {
                let from_bow = libm::remainder(angle_rad.to_degrees(), 360.0);
                format!(" thrust {} of the bow", sided(from_bow, "°"))
            });
            let both = [power, direction].into_iter().flatten().collect::<Vec<_>>();
            format!("azimuth unit {name}{}", both.join(","))
        }
        Action::Assist(Assist { job, .. }) => assist(job, setup),
        Action::Course(heading_rad) => format!("steer {}", compass(*heading_rad)),
        Action::Speed(speed_mps) => {
            format!("make {} kn through the water", plain(speed_mps / KNOT_MPS, 3))
        }
        Action::Station(station) => format!(
            "go to north {} m, east {} m, heading {}, and stay; ahead up to {} m/s, sideways up to {} m/s",
            plain(station.position_m.x, 6),
            plain(station.position_m.y, 6),
            compass(station.heading_rad),
            plain(station.fastest_mps[0], 3),
            plain(station.fastest_mps[1], 3)
        ),
        Action::Hands => "pilots off; controls stay".to_owned(),
        Action::Tug(_, order) => match order {
            TugOrder::StandBy => "stand by".to_owned(),
            TugOrder::Push { force_n, direction_rad } => {
                format!("push {}", towards(*force_n, *direction_rad))
            }
            TugOrder::Pull { force_n, direction_rad } => {
                format!("pull {}", towards(*force_n, *direction_rad))
            }
        },
        Action::Winch(_, WinchOrder::Hold) => "hold".to_owned(),
        Action::Winch(_, WinchOrder::Heave(rate)) => format!("heave in {} m/s", plain(*rate, 3)),
        Action::Winch(_, WinchOrder::PayOut(rate)) => format!("pay out {} m/s", plain(*rate, 3)),
        Action::LetGo(_) => "let go".to_owned(),
    }
}

/// What a tug that is a vessel is told to do at a ship.
fn assist(job: &Job, setup: &Setup) -> String {
    let name = |body: usize| &setup.bodies[body].name;
    match job {
        Job::Follow { ship, at_m, .. } => format!(
            "keep {} m forward, {} m to starboard of {}",
            plain(at_m.x, 4),
            plain(at_m.y, 4),
            name(*ship)
        ),
        Job::Push(push) => format!(
            "push {} with {} kN at {} m forward of her origin",
            name(push.ship),
            plain(push.force_n / 1e3, 3),
            plain(push.at_m.x, 4)
        ),
        Job::Pull { line, direction_rad, force_n } => format!(
            "pull on line {} with {}",
            setup.world.lines[*line].line.name,
            towards(*force_n, *direction_rad)
        ),
    }
}

fn sided(value: f64, unit: &str) -> String {
    let side = if value > 0.0 { "to starboard" } else { "to port" };
    format!("{}{unit} {side}", plain(value.abs(), 3))
}

fn towards(force_n: f64, direction_rad: f64) -> String {
    let from_bow = libm::remainder(direction_rad.to_degrees(), 360.0);
    format!("{} kN, {} of the bow", plain(force_n / 1e3, 3), sided(from_bow, "°"))
}

/// Three digits, as a compass course is said.
pub(in crate::run_page) fn compass(angle_rad: f64) -> String {
    let degrees = libm::round(angle_rad.to_degrees()).rem_euclid(360.0);
    format!("{degrees:03}°")
}
