//! The frame: everything that the pages of the browser display after a tick.

mod alarms;
mod anchor;
mod board;
mod fog;
mod of_session;
mod passage;
mod sample;
pub(crate) mod seen;
mod traffic;
mod verdict;
mod vessel;

use self::board::BoardInput;
use fenderline_contact::Vec2;
use fenderline_contact::number::greater;
use fenderline_sim::berth::Berth;
use fenderline_sim::mooring::WinchOrder;
use fenderline_sim::order::{TugWord, Word};
use fenderline_sim::tug::TugOrder;
use fenderline_sim::{Mooring, MooringSetup, Simulation, TugAtWork, TugSetup};

use crate::alarm_book::Alarm;
use crate::cast::Cast;
use crate::exercise;
use crate::info::Info;
use crate::message::{CurrentNow, Frame, LineNow, RunState, TugNow, VesselNow, WavesNow, WindNow};
use crate::now::Now;
use crate::past::Sample;

pub(crate) use verdict::now as verdict;

/// The causes of alarms that are active in the present state of a session.
pub(crate) fn causes(now: &Now, cast: &Cast, info: &Info) -> Vec<Alarm> {
    after_tick(now, cast, info).0
}

/// The causes of alarms and the values for strip charts, which are found after every tick.
pub(crate) fn after_tick(now: &Now, cast: &Cast, info: &Info) -> (Vec<Alarm>, Sample) {
    let simulation = &now.simulation;
    let of = alarms::Input {
        simulation,
        info,
        vessels: &vessels(now, info),
        fenders: &now.seen.fenders(simulation),
        contacts: now.seen.contacts(),
        lines: &lines(simulation, info),
        approach: now.approach,
        tugs: &tugs(simulation),
        passages: now.seen.passages(),
        frozen: &now.frozen,
    };
    let mut causes = alarms::causes(&of);
    causes.extend(traffic::collisions(simulation, info));
    (causes, sample::sample(&of, cast, &now.frozen))
}

/// Updates the list of ships that pass, and the alarms. The server calls this function after every tick, not only for
/// every frame: a touch of one tick raises an alarm too. Returns the values for strip charts after the tick.
pub(crate) fn note_alarms(now: &mut Now, cast: &Cast, info: &Info) -> Sample {
    now.seen.note_passages(&now.simulation, info);
    now.seen.note_tugs(&now.simulation);
    let (causes, sample) = after_tick(now, cast, info);
    now.alarms.update(causes, now.simulation.time_s());
    sample
}

/// Makes the frame of the session's present state.
pub(crate) fn frame(now: &Now, cast: &Cast, info: &Info, at_ms: u64, run: RunState) -> Frame {
    let simulation = &now.simulation;
    let (states, t_s) = (simulation.states(), simulation.time_s());
    let (fenders, contacts) = (now.seen.fenders(simulation), now.seen.contacts());
    let own = cast.own;
    let mut vessels = vessels(now, info);
    if let Some(berth) = &info.berth {
        let (approach, book) = (now.approach, &now.alarms);
        let of = BoardInput { simulation, contacts, fenders: &fenders, book, approach };
        fill_in_signals(&of, berth, &mut vessels);
    }
    let bodies = states.iter().map(|state| {
        let [position, velocity] = [state.position_m, state.velocity_mps];
        let turn = state.yaw_rate_radps;
        Some([position.x, position.y, state.heading_rad, velocity.x, velocity.y, turn])
    });
    let place = own.map_or((Vec2::ZERO, 0.0), |own| {
        let vessel = &simulation.setup().world.vessels[own];
        (states[vessel.body].position_m, vessel.ship.particulars.draught_m)
    });
    Frame {
        tick: now.tick,
        t_s,
        at_ms,
        run,
        bodies: bodies.collect(),
        eyes: None,
        vessels,
        fenders,
        contacts: contacts.to_vec(),
        lines: lines(simulation, info),
        anchors: anchor::now(simulation),
        tugs: tugs(simulation),
        traffic: traffic::now(simulation).into_iter().map(Some).collect(),
        passages: now.seen.passages().messages(),
        wind: wind_now(simulation, t_s),
        current: current_now(simulation, t_s, place),
        waves: waves_now(simulation),
        water_level_m: simulation.setup().world.environment.level_m(t_s),
        visibility_m: simulation.setup().world.environment.visibility_m,
        approach_mps: now.approach.at_fenders_mps,
        alarms: now.alarms.messages(),
        verdict: verdict(simulation),
        exercise: now.exercise.as_ref().map(|exercise| exercise::now(exercise, simulation)),
    }
}

fn vessels(now: &Now, info: &Info) -> Vec<VesselNow> {
    let all = 0..now.simulation.vessels().len();
    all.map(|index| vessel::now(now, index, info.berth.as_ref())).collect()
}

fn lines(simulation: &Simulation, info: &Info) -> Vec<LineNow> {
    let setups = simulation.setup().world.lines.iter();
    let all = simulation.lines().iter().zip(setups);
    let all = all.zip(&info.lines);
    all.map(|((line, of), info)| line_now(line, of, info.working_n, simulation.time_s())).collect()
}

fn tugs(simulation: &Simulation) -> Vec<TugNow> {
    let setups = &simulation.setup().world.tugs;
    simulation.tugs().iter().zip(setups).map(|(tug, of)| tug_now(tug, of)).collect()
}

/// Fills in the docking board's signals for each vessel whose distance to the berth is known.
fn fill_in_signals(of: &BoardInput<'_>, berth: &Berth, vessels: &mut [VesselNow]) {
    for (index, vessel) in vessels.iter_mut().enumerate() {
        let ends = board::ends(of, berth, index, vessel);
        if let Some(lies) = &mut vessel.berth {
            [lies.bow, lies.stern] = ends;
            lies.bow_limit_mps = of.approach.at_mps(lies.bow_m);
            lies.stern_limit_mps = of.approach.at_mps(lies.stern_m);
            lies.bow_lamp = board::lamp(ends[0], of.approach.light(lies.bow_mps, lies.bow_m));
            lies.stern_lamp = board::lamp(ends[1], of.approach.light(lies.stern_mps, lies.stern_m));
        }
    }
}

fn line_now(line: &Mooring, setup: &MooringSetup, working_n: f64, t_s: f64) -> LineNow {
    let state = match &line.line {
        _ if line.aboard => "aboard",
        _ if line.sent.is_some() => "sent",
        // The first step makes fast the lines that are fast from the start.
        None if setup.from_s <= t_s => "fast",
        None => "ashore",
        Some((_, state)) if state.parted => "parted",
        Some(_) => "fast",
    };
    LineNow {
        state,
        tension_n: line.load.tension_n,
        over_working: state == "fast" && line.load.tension_n > working_n,
        bollard: line.bollard,
        length_m: line.line.as_ref().map(|(_, state)| state.length_m),
        fast_in_s: line.sent.and_then(|sent| sent.fast_at_s).map(|at_s| greater(at_s - t_s, 0.0)),
        winch: match line.order {
            WinchOrder::Hold => "hold",
            WinchOrder::Heave(_) => "heave",
            WinchOrder::PayOut(_) => "pay_out",
        },
    }
}

fn tug_now(tug: &TugAtWork, setup: &TugSetup) -> TugNow {
    // The latest order to the tug, even if she has not begun to carry it out.
    let order = tug.state.waiting.last().map_or(tug.state.order, |(_, order)| *order);
    let (order, order_n, order_direction_rad) = match order {
        TugOrder::StandBy => (TugWord::Stop, 0.0, tug.state.direction_rad),
        TugOrder::Push { force_n, direction_rad } => (TugWord::Push, force_n, direction_rad),
        TugOrder::Pull { force_n, direction_rad } => (TugWord::Pull, force_n, direction_rad),
    };
    TugNow {
        order: order.word(),
        power: order_n / setup.tug.envelope.bollard_pull_n,
        order_n,
        order_direction_rad,
        force_n: libm::hypot(tug.force.surge_n, tug.force.sway_n),
        direction_rad: tug.state.direction_rad,
        limited: tug.limited,
        out: tug.out,
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
