//! The present state of the anchors, for a frame.

use fenderline_sim::anchor::{AnchorPosition, LostBy, SHACKLE_M, WindlassOrder};
use fenderline_sim::{AnchorAtWork, Simulation};

use crate::action::AnchorFault;
use crate::message::AnchorNow;
use crate::pair::pair;

/// The present state of all anchors.
pub(super) fn now(simulation: &Simulation) -> Vec<AnchorNow> {
    let world = &simulation.setup().world;
    let all = world.anchors.iter().zip(simulation.anchors());
    all.map(|(setup, now)| {
        let body = world.vessels[setup.vessel].body;
        anchor_now(now, simulation.states()[body].heading_rad)
    })
    .collect()
}

fn anchor_now(now: &AnchorAtWork, heading_rad: f64) -> AnchorNow {
    let AnchorAtWork { state, load, .. } = now;
    let (windlass, to_m) = match state.order {
        WindlassOrder::Hold => ("hold", None),
        WindlassOrder::LetGo(to_m) => ("let_go", Some(to_m)),
        WindlassOrder::Veer(to_m) => ("veer", Some(to_m)),
        WindlassOrder::Heave(to_m) => ("heave", Some(to_m)),
    };
    AnchorNow {
        state: state.position.word(),
        place_m: match state.position {
            AnchorPosition::OnBottom(at_m) => Some(pair(at_m)),
            _ => None,
        },
        chain_m: state.chain_m,
        tension_n: load.tension_n,
        holding_n: load.holding_n,
        on_bottom_m: load.on_bottom_m,
        lead_rad: load.lead_rad(heading_rad),
        dragging: state.dragging,
        dragged_m: state.dragged_m,
        windlass,
        to_m,
        stalled: load.stalled,
        report: report(now, heading_rad),
        faults: AnchorFault::active(&state.faults),
    }
}

/// The report from the forecastle: length of chain out, direction of the chain as an hour of the clock from the bow,
/// and how tight the chain is.
fn report(now: &AnchorAtWork, heading_rad: f64) -> String {
    let AnchorAtWork { state, load, .. } = now;
    match state.position {
        AnchorPosition::Housed => return "home".to_owned(),
        AnchorPosition::Lost(by) => {
            let how = match by {
                LostBy::Slipped => "slipped",
                LostBy::Parted => "the chain parted",
                LostBy::RanOut => "the chain ran out",
            };
            return format!("gone: {how}");
        }
        AnchorPosition::Hanging | AnchorPosition::OnBottom(_) => {}
    }
    let shackles = format!("{:.1}", state.chain_m / SHACKLE_M);
    let shackles = shackles.strip_suffix(".0").unwrap_or(&shackles);
    let plural = if shackles == "1" { "" } else { "s" };
    let mut parts = vec![format!("{shackles} shackle{plural} out")];
    if state.position == AnchorPosition::Hanging {
        parts.push("off the bottom".to_owned());
        return parts.join(", ");
    }
    if let Some(lead_rad) = load.lead_rad(heading_rad) {
        parts.push(format!("leads {} o'clock", clock(lead_rad)));
    }
    parts.extend(load.stay().map(|stay| stay.words().to_owned()));
    if state.dragging {
        parts.push("dragging".to_owned());
    }
    parts.join(", ")
}

/// The direction as an hour of the clock: 12 is ahead, 3 is on the starboard beam.
fn clock(lead_rad: f64) -> u32 {
    let hours = libm::round(lead_rad * 6.0 / core::f64::consts::PI).rem_euclid(12.0);
    match hours as u32 {
        0 => 12,
        hour => hour,
    }
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;
    use fenderline_sim::anchor::{AnchorLoad, AnchorState};

    use super::*;

    #[test]
    fn the_forecastle_reports_chain_lead_and_stay() {
        let state = AnchorState::on_bottom(vec2(0.0, 0.0), 2.0 * SHACKLE_M);
        let (sine, cosine) = (libm::sin(-0.52), libm::cos(-0.52));
        let on_ship_n = [1e5 * cosine, 1e5 * sine, -1e5];
        let load = AnchorLoad { tension_n: 1.414e5, on_ship_n, ..AnchorLoad::default() };
        let now = AnchorAtWork::with(state, load);
        assert_eq!(report(&now, 0.0), "2 shackles out, leads 11 o'clock, medium stay");
        assert_eq!(report(&now, -0.52), "2 shackles out, leads 12 o'clock, medium stay");
        let down = AnchorLoad { tension_n: 1e5, on_ship_n: [0.0, 0.0, -1e5], ..load };
        let now = AnchorAtWork::with(state, down);
        assert_eq!(report(&now, 0.0), "2 shackles out, up and down");
        let home = AnchorAtWork::with(AnchorState::housed(), AnchorLoad::default());
        assert_eq!(report(&home, 0.0), "home");
        assert_eq!([-3.1, -1.6, 0.0, 1.6, 3.1].map(clock), [6, 9, 12, 3, 6]);
    }
}
