//! The present state of a vessel, for a frame.

use fenderline_contact::number::greater;
use fenderline_contact::{Vec2, vec2};
use fenderline_sim::berth::Berth;
use fenderline_sim::order::{SidePlace, TugWord, Word};
use fenderline_sim::{Job, LineEnd, Pilots, Simulation};

use crate::berth;
use crate::message::{AssistNow, AssistState, AzimuthNow, RudderNow, ShareNow, VesselNow};
use crate::now::Now;
use crate::plan;
use crate::speeds::speeds;

/// The present state of a vessel. Speeds over ground and through the water are those of midship. Lateral speeds are
/// those of the foremost and aftmost points of the vessel's outline.
pub(super) fn now(all: &Now, index: usize, at: Option<&Berth>) -> VesselNow {
    let simulation = &all.simulation;
    let setup = simulation.setup();
    let (of, vessel) = (&setup.world.vessels[index], &simulation.vessels()[index]);
    let (body, state) = (&setup.bodies[of.body], &simulation.states()[of.body]);
    let speeds = speeds(simulation, index);
    let azimuths =
        vessel.azimuths.iter().zip(&vessel.orders.azimuths).map(|(now, order)| AzimuthNow {
            power_order: order.power,
            power: now.power.value,
            direction_order_rad: order.direction_rad,
            direction_rad: now.direction.angle_rad,
        });
    let thrusters = vessel.thrusters.iter().zip(&vessel.orders.thrusters);
    let shaft = if of.shaft.stop > 0.0 { vessel.shaft.value / of.shaft.stop } else { 0.0 };
    let [_, _, heave, roll, pitch, _] = vessel.wave_motion.motion;
    VesselNow {
        rudder: RudderNow { order_rad: vessel.orders.rudder_rad, now_rad: vessel.rudder.value },
        shaft: ShareNow { order: vessel.orders.shaft, now: shaft },
        thrusters: thrusters.map(|(lag, &order)| ShareNow { order, now: lag.value }).collect(),
        azimuths: azimuths.collect(),
        pilot: pilot_text(&vessel.pilots),
        course_rad: vessel.pilots.course.map(|course| course.heading_rad),
        speed_order_mps: vessel.pilots.speed.map(|speed| speed.speed_mps),
        ground_mps: speeds.ground_mps,
        water_mps: speeds.water_mps,
        bow_mps: speeds.bow_mps,
        stern_mps: speeds.stern_mps,
        heel_rad: vessel.attitude.roll.value + roll,
        trim_rad: vessel.attitude.pitch.value + pitch,
        heave_m: vessel.attitude.heave.value + heave,
        squat_m: vessel.squat_m,
        under_keel_m: vessel.under_keel_m,
        aground: vessel.aground,
        // A berth has no distance to the body that carries it.
        berth: at
            .filter(|at| at.body != of.body)
            .map(|at| berth::seen_from(at, &simulation.states()[at.body], &body.outline, state)),
        plan: of.on_plan(state).as_ref().map(plan::now),
        assist: vessel.pilots.assist.as_ref().map(|pilot| assist_now(all, index, &pilot.order.job)),
        faults: vessel.faults.active().map(Word::word).collect(),
        tripped: of
            .unit_names()
            .enumerate()
            .filter(|(unit, _)| vessel.faults.tripped.has(*unit))
            .map(|(_, name)| name.to_owned())
            .collect(),
    }
}

/// A line with less tension than this is displayed as slack (N).
const SLACK_N: f64 = 1e3;

/// The order in words to a tug that is a vessel, and how much of the order the tug has carried out.
fn assist_now(now: &Now, tug: usize, job: &Job) -> AssistNow {
    let setup = now.simulation.setup();
    let own = setup.world.vessels[tug].body;
    let place = |ship: usize, at_m| {
        let ship = setup.world.vessels.iter().find(|vessel| vessel.body == ship)?;
        let outline = &setup.bodies[ship.body].outline;
        let place = SidePlace::nearest(at_m, outline, ship.ship.particulars.length_m)?;
        let off_m = (place.on(outline, ship.ship.particulars.length_m)? - at_m).x.abs();
        (off_m < SAME_PLACE_M).then(|| place.word())
    };
    let states = now.simulation.states();
    let world = |body: usize, at_m| states[body].pose().apply(at_m);
    let (mut away_m, mut slack_m) = (None, None);
    let (word, force_n, place, state, felt_n) = match *job {
        Job::Follow { ship, at_m, .. } => {
            away_m = Some((world(own, Vec2::ZERO) - world(ship, at_m)).length());
            (TugWord::StandOff, 0.0, place(ship, at_m), AssistState::StandsOff, 0.0)
        }
        Job::Push(push) => {
            let word = if push.force_n > 0.0 { TugWord::Push } else { TugWord::Stop };
            let pairs = [[own, push.ship], [push.ship, own]];
            let between = || now.seen.contacts().iter().filter(|c| pairs.contains(&c.bodies));
            let felt_n = between().map(|c| libm::hypot(c.force_n[0], c.force_n[1])).sum();
            let bow = world(own, vec2(push.bow_m, 0.0));
            let off_m = (bow - world(push.ship, push.at_m)).length();
            away_m = Some(off_m);
            // A tug that lies at the side loses the contact and has it again, as ship and tug move.
            let stays = off_m < AT_THE_SIDE_M && now.seen.has_touched(pairs[0]);
            let is_there = stays || between().next().is_some();
            let state = match (is_there, word) {
                (false, _) => AssistState::ComesAlongside,
                (true, TugWord::Stop) => AssistState::Alongside,
                (true, _) => AssistState::Pushes,
            };
            (word, push.force_n, place(push.ship, push.at_m), state, felt_n)
        }
        Job::Pull { line, force_n, .. } => {
            let tension_n = now.simulation.lines()[line].load.tension_n;
            let is_taut = tension_n > SLACK_N;
            slack_m = slack(&now.simulation, line).filter(|_| !is_taut);
            let state = if is_taut { AssistState::Pulls } else { AssistState::TakesUpSlack };
            (TugWord::Pull, force_n, None, state, tension_n)
        }
    };
    let power = force_n / setup.world.vessels[tug].bollard_pull_n();
    AssistNow { order: word.word(), power, place, state, away_m, slack_m, force_n: felt_n }
}

/// How much longer a line between two bodies is than the straight way between its ends (m); 0 if the line is straight.
fn slack(simulation: &Simulation, line: usize) -> Option<f64> {
    let of = &simulation.setup().world.lines[line];
    let LineEnd::OnBody { body, at_m, above_water_m } = of.end? else { return None };
    let (_, state) = simulation.lines()[line].line.as_ref()?;
    let states = simulation.states();
    let place = |body: usize, at_m| states[body].pose().apply(at_m);
    let level = place(of.ship, of.fairlead_m) - place(body, at_m);
    let way_m = libm::hypot(level.length(), of.fairlead_above_water_m - above_water_m);
    Some(greater(state.length_m - way_m, 0.0))
}

/// A tug that has touched the ship and whose bow is nearer to the place of her order is alongside (m).
const AT_THE_SIDE_M: f64 = 1.5;

/// A point within this distance along the ship of a named position at her side belongs to that position (m).
const SAME_PLACE_M: f64 = 1.0;

fn pilot_text(pilots: &Pilots) -> &'static str {
    match pilots {
        Pilots { assist: Some(_), .. } => "assist",
        Pilots { station: Some(_), .. } => "station",
        Pilots { course: Some(_), speed: Some(_), .. } => "course+speed",
        Pilots { course: Some(_), .. } => "course",
        Pilots { speed: Some(_), .. } => "speed",
        _ => "hands",
    }
}
