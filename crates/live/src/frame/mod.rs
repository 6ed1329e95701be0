//! What there is to see after a tick.

mod alarms;
mod seen;
mod vessel;

use fenderline_contact::Vec2;
use fenderline_sim::mooring::WinchOrder;
use fenderline_sim::tug::TugOrder;
use fenderline_sim::{Mooring, MooringSetup, Simulation, TugAtWork};

use crate::info::Info;
use crate::message::{BranchNow, CurrentNow, Frame, LineNow, RunState, TugNow, WavesNow, WindNow};
use crate::session::{Branch, Session};

pub(crate) use seen::Seen;

impl Session {
    /// The frame of this tick. Of `run` the owner of the session says what it knows: whether it is paused, its pace,
    /// its clients; branches are filled in here.
    #[must_use]
    pub fn frame(&self, info: &Info, at_ms: u64, run: RunState) -> Frame {
        let now = self.now();
        let simulation = &now.simulation;
        let (states, t_s) = (simulation.states(), simulation.time_s());
        let fenders = now.seen.fenders(simulation);
        let lines: Vec<LineNow> = {
            let setups = simulation.setup().world.lines.iter();
            simulation
                .lines()
                .iter()
                .zip(setups)
                .map(|(line, of)| line_now(line, of, t_s))
                .collect()
        };
        let tugs: Vec<TugNow> = simulation.tugs().iter().map(tug_now).collect();
        let own = self.cast().own;
        let vessels: Vec<_> = (0..simulation.vessels().len())
            .map(|index| vessel::now(simulation, index, info.berth.as_ref()))
            .collect();
        let alarms = alarms::alarms(&alarms::Shown {
            simulation,
            info,
            vessels: &vessels,
            fenders: &fenders,
            contacts: now.seen.contacts(),
            lines: &lines,
            tugs: &tugs,
        });
        let bodies = states.iter().map(|state| {
            let [position, velocity] = [state.position_m, state.velocity_mps];
            let turn = state.yaw_rate_radps;
            [position.x, position.y, state.heading_rad, velocity.x, velocity.y, turn]
        });
        let place = own.map_or((Vec2::ZERO, 0.0), |own| {
            let vessel = &simulation.setup().world.vessels[own];
            (states[vessel.body].position_m, vessel.ship.particulars.draught_m)
        });
        Frame {
            tick: now.tick,
            t_s,
            at_ms,
            run: RunState {
                branch: self.shown(),
                branches: self.branches().iter().enumerate().map(branch_now).collect(),
                last_tick: self.branches()[self.shown()].ends_tick,
                ..run
            },
            bodies: bodies.collect(),
            vessels,
            fenders,
            contacts: now.seen.contacts().to_vec(),
            lines,
            tugs,
            wind: wind_now(simulation, t_s),
            current: current_now(simulation, t_s, place),
            waves: waves_now(simulation),
            alarms,
        }
    }
}

fn branch_now((id, branch): (usize, &Branch)) -> BranchNow {
    let Branch { parent, from_tick, ends_tick, .. } = *branch;
    BranchNow { id, from_tick, ends_tick, parent }
}

fn line_now(line: &Mooring, setup: &MooringSetup, t_s: f64) -> LineNow {
    let state = match &line.line {
        _ if line.gone => "gone",
        // Before the first step nothing is fast yet, though it will have been from the start.
        None if setup.from_s <= t_s => "fast",
        None => "ashore",
        Some((_, state)) if state.parted => "parted",
        Some(_) => "fast",
    };
    LineNow {
        state,
        tension_n: line.load.tension_n,
        winch: match line.order {
            WinchOrder::Hold => "hold",
            WinchOrder::Heave(_) => "heave",
            WinchOrder::PayOut(_) => "pay_out",
        },
    }
}

fn tug_now(tug: &TugAtWork) -> TugNow {
    // The latest order, be it not begun yet: what the hand on it has just said.
    let order = tug.state.waiting.last().map_or(tug.state.order, |(_, order)| *order);
    let (order, order_n, order_direction_rad) = match order {
        TugOrder::StandBy => ("stand_by", 0.0, tug.state.direction_rad),
        TugOrder::Push { force_n, direction_rad } => ("push", force_n, direction_rad),
        TugOrder::Pull { force_n, direction_rad } => ("pull", force_n, direction_rad),
    };
    TugNow {
        order,
        order_n,
        order_direction_rad,
        force_n: libm::hypot(tug.force.surge_n, tug.force.sway_n),
        direction_rad: tug.state.direction_rad,
        limited: tug.limited,
    }
}

/// The direction of a vector, clockwise from north, in [0, 2π).
fn bearing_rad(of: Vec2) -> f64 {
    let angle = libm::atan2(of.y, of.x);
    if angle < 0.0 { angle + core::f64::consts::TAU } else { angle }
}

fn wind_now(simulation: &Simulation, t_s: f64) -> WindNow {
    let Some(wind) = &simulation.setup().world.environment.wind else { return WindNow::default() };
    let air = wind.velocity(10.0, t_s);
    let speed_mps = air.length();
    if speed_mps > 0.0 {
        return WindNow { speed_mps, from_rad: bearing_rad(air * -1.0) };
    }
    WindNow { speed_mps, from_rad: wind.mean_at(t_s).1 }
}

fn current_now(
    simulation: &Simulation,
    t_s: f64,
    (position_m, draught_m): (Vec2, f64),
) -> CurrentNow {
    let Some(current) = &simulation.setup().world.environment.current else {
        return CurrentNow::default();
    };
    let water = current.velocity(position_m, t_s, draught_m);
    CurrentNow { speed_mps: water.length(), to_rad: bearing_rad(water) }
}

fn waves_now(simulation: &Simulation) -> Option<WavesNow> {
    let sea = simulation.setup().world.environment.sea.as_ref()?;
    let height_m = sea.significant_height_m();
    if height_m <= 0.0 {
        return None;
    }
    let from_rad = libm::fmod(sea.towards_rad() + core::f64::consts::PI, core::f64::consts::TAU);
    Some(WavesNow { height_m, period_s: sea.mean_period_s(), from_rad })
}
