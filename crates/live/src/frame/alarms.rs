//! Finds the causes of alarms that are active in a tick. The alarm book decides how long each alarm is displayed.

use fenderline_contact::number::greater;
use fenderline_sim::anchor::{AnchorPosition, LostBy};
use fenderline_sim::order::Word;
use fenderline_sim::overhead::AirClearance;
use fenderline_sim::track::OnPlan;
use fenderline_sim::{Fault, Simulation};

use crate::alarm_book::{Alarm, FENDER, Level, TOUCH};
use crate::approach::{ApproachLimit, Light};
use crate::frozen::{Frozen, place};
use crate::info::Info;
use crate::message::{ContactNow, FenderNow, LineNow, TugNow, VesselNow};

use super::passage::Passages;

/// A load of this share of a fender's rating raises a caution. A load on a fender of its whole rating raises an alarm.
const FENDER_CAUTION: f64 = 0.8;
/// A tension of this share of a line's working load raises a caution. A tension of a line's whole working load raises
/// an alarm.
const LINE_CAUTION: f64 = 0.8;
/// A ship that closes in too fast raises an alarm within this distance of the berth (m).
const NEAR_M: f64 = 100.0;

/// A clearance under a bridge or cable below this raises a caution (m); our choice. A vessel that is too high raises an
/// alarm.
const OVERHEAD_M: f64 = 1.0;
/// How far ahead a bridge or cable is looked for, while the vessel keeps her velocity and heading (s); our choice.
const AHEAD_S: f64 = 180.0;

/// The data from which the causes of alarms are found.
pub(super) struct Input<'a> {
    pub(super) simulation: &'a Simulation,
    pub(super) approach: ApproachLimit,
    pub(super) info: &'a Info,
    pub(super) vessels: &'a [VesselNow],
    pub(super) fenders: &'a [FenderNow],
    pub(super) contacts: &'a [ContactNow],
    pub(super) lines: &'a [LineNow],
    pub(super) tugs: &'a [TugNow],
    pub(super) passages: &'a Passages,
    pub(super) frozen: &'a [Frozen],
}

/// All causes of alarms that are active in the present tick.
pub(super) fn causes(of: &Input<'_>) -> Vec<Alarm> {
    let mut all = Vec::new();
    vessels(of, &mut all);
    fenders(of, &mut all);
    contacts(of, &mut all);
    lines(of, &mut all);
    for (vessel, ship, text) in of.passages.cautions(of.simulation) {
        all.push(caution("passing", &[vessel, ship], text));
    }
    anchors(of, &mut all);
    for (tug, now) in of.info.tugs.iter().zip(of.tugs) {
        if now.out {
            all.push(alarm("tug out", &[&tug.name], format!("Tug {} has dropped out", tug.name)));
        } else if now.limited {
            let text = format!("Tug {} cannot give the ordered force", tug.name);
            all.push(caution("tug", &[&tug.name], text));
        }
    }
    all
}

/// Makes an alarm whose key joins the kind and the subjects of the alarm.
fn of_level(level: Level, kind: &str, about: &[&str], text: String) -> Alarm {
    let key = format!("{kind} {}", about.join(" "));
    Alarm { level, key, text, about: about.iter().map(|&name| name.to_owned()).collect() }
}

fn alarm(kind: &str, about: &[&str], text: String) -> Alarm {
    of_level(Level::Alarm, kind, about, text)
}

fn caution(kind: &str, about: &[&str], text: String) -> Alarm {
    of_level(Level::Caution, kind, about, text)
}

fn alarm_if(is_alarm: bool) -> Level {
    if is_alarm { Level::Alarm } else { Level::Caution }
}

/// Where a ship's position receiver shows her on her passage plan: a frozen receiver keeps its position.
pub(super) fn on_plan(of: &Input<'_>, vessel: usize, frozen: &Frozen) -> Option<OnPlan> {
    let plan = of.simulation.setup().world.vessels[vessel].plan.as_ref()?;
    let shown = frozen.place.unwrap_or_else(|| place(of.simulation, vessel));
    Some(plan.at(shown.midship_m))
}

/// The alarm of a ship that is outside the corridor of her passage plan, as her position receiver shows her.
fn off_track(of: &Input<'_>, vessel: usize) -> Option<Alarm> {
    let on = on_plan(of, vessel, &of.frozen[vessel])?;
    let half_m = on.half_width_m.filter(|_| on.outside_m().is_some())?;
    let side = if on.cross_track_m < 0.0 { "port" } else { "starboard" };
    let name = &*of.info.vessels[vessel].name;
    let off_m = on.cross_track_m.abs();
    let text = format!("{name}: {off_m:.0} m to {side} of her track (planned {half_m:.0} m)");
    Some(alarm("off track", &[name], text))
}

/// The alarm of a vessel that is under a bridge or cable with too little clearance, or will be if she keeps her velocity
/// and heading.
fn overhead(of: &Input<'_>, index: usize) -> Option<Alarm> {
    let world = &of.simulation.setup().world;
    let overhead = &world.overhead;
    let (vessel, squat_m) = (&of.info.vessels[index], of.vessels[index].squat_m);
    let state = &of.simulation.states()[vessel.body];
    let level_m = world.environment.level_m(of.simulation.time_s());
    let name = &*vessel.name;
    let structure = |of: AirClearance| &*overhead.structures[of.structure].name;
    let level = |clearance_m: f64| alarm_if(clearance_m < 0.0);
    if let Some(here) = overhead.over(index, state, level_m, squat_m)
        && here.clearance_m < OVERHEAD_M
    {
        let (clearance_m, over) = (here.clearance_m, structure(here));
        let text = match clearance_m < 0.0 {
            true => format!("{name}: {:.1} m too high for the {over}", -clearance_m),
            false => format!("{name}: {clearance_m:.1} m under the {over}"),
        };
        return Some(of_level(level(clearance_m), "overhead", &[name], text));
    }
    let (after_s, ahead) = overhead.ahead(index, state, level_m, squat_m, AHEAD_S)?;
    let (clearance_m, over) = (ahead.clearance_m, structure(ahead));
    if clearance_m >= OVERHEAD_M {
        return None;
    }
    let text = match clearance_m < 0.0 {
        true => {
            format!("{name}: the {over} ahead in {after_s:.0} s is {:.1} m too low", -clearance_m)
        }
        false => format!("{name}: {clearance_m:.1} m under the {over} ahead in {after_s:.0} s"),
    };
    Some(of_level(level(clearance_m), "overhead", &[name], text))
}

fn vessels(of: &Input<'_>, all: &mut Vec<Alarm>) {
    for (index, (vessel, now)) in of.info.vessels.iter().zip(of.vessels).enumerate() {
        let name = &vessel.name;
        all.extend(off_track(of, index));
        all.extend(overhead(of, index));
        if now.aground {
            all.push(alarm("aground", &[name], format!("{name} is aground")));
        } else if let Some(clear_m) = now.under_keel_m
            && clear_m < vessel.under_keel_limit_m
        {
            let text = format!("{name}: {clear_m:.1} m under the keel");
            all.push(caution("under keel", &[name], text));
        }
        for fault in now.faults.iter().filter_map(|word| Fault::of_word(word)) {
            let what = match fault {
                Fault::RudderStuck => "rudder stuck",
                Fault::FollowUpLost => "rudder does not follow",
                Fault::EngineLost => "engine lost",
                Fault::ThrustersLost => "thrusters lost",
                Fault::Blackout => "blackout",
                // Nobody on board is told that an instrument is frozen.
                Fault::HeadingFrozen | Fault::SpeedFrozen | Fault::PositionFrozen => continue,
            };
            all.push(alarm(what, &[name], format!("{name}: {what}")));
        }
        for unit in &now.tripped {
            let text = format!("{name}: thruster {unit} tripped");
            all.push(alarm("thruster tripped", &[name, unit], text));
        }
        let (Some(berth), Some(near), false) = (&of.info.berth, &now.berth, vessel.is_tug) else {
            continue;
        };
        let setup = of.simulation.setup();
        let states = of.simulation.states();
        let outline = &setup.bodies[vessel.body].outline;
        if !berth.is_near(&states[berth.body], outline, &states[vessel.body], NEAR_M) {
            continue;
        }
        let ends = [("bow", near.bow_m, near.bow_mps), ("stern", near.stern_m, near.stern_mps)];
        for (end, off_m, closing_mps) in ends {
            let light = of.approach.light(closing_mps, off_m);
            // A ship at the fenders still moves against them. The load of the fenders has its own alarm.
            if off_m > 0.0 && light != Light::Ok {
                let limit_mps = of.approach.at_mps(off_m);
                let text = format!(
                    "{name}: {end} closes at {closing_mps:.2} m/s, {off_m:.0} m off (limit {limit_mps:.2})"
                );
                let level = alarm_if(light == Light::Alarm);
                all.push(of_level(level, &format!("approach {end}"), &[name], text));
            }
        }
    }
}

fn fenders(of: &Input<'_>, all: &mut Vec<Alarm>) {
    for (fender, now) in of.info.fenders.iter().zip(of.fenders) {
        let (name, share) = (&*fender.name, greater(now.of_energy, now.of_reaction));
        if now.failed {
            all.push(alarm(FENDER, &[name], format!("Fender {name} has failed")));
        } else if share >= FENDER_CAUTION {
            let text = format!("Fender {name}: {:.0} % of its rating", 100.0 * share);
            all.push(of_level(alarm_if(share >= 1.0), FENDER, &[name], text));
        }
    }
}

/// Alarms for hulls that touch a structure or another hull without a fender in between.
fn contacts(of: &Input<'_>, all: &mut Vec<Alarm>) {
    for contact in of.contacts.iter().filter(|contact| contact.fender.is_none()) {
        let [one, two] = contact.bodies.map(|body| &*of.info.bodies[body].name);
        let text = format!("{one} touches {two} without a fender");
        let touch = alarm(TOUCH, &[one, two], text);
        if all.iter().all(|other| other.key != touch.key) {
            all.push(touch);
        }
    }
}

/// An anchor that has dragged farther than this raises an alarm (m). A few metres are usual while a ship brings up. The
/// greatest distance without an alarm is our choice.
const DRAGGED_M: f64 = 5.0;

fn anchors(of: &Input<'_>, all: &mut Vec<Alarm>) {
    let setups = &of.simulation.setup().world.anchors;
    for (setup, now) in setups.iter().zip(of.simulation.anchors()) {
        let name = &*setup.gear.name;
        let called = fenderline_sim::called("Anchor", name);
        match now.state.position {
            AnchorPosition::Lost(LostBy::Parted) => {
                all.push(alarm("anchor", &[name], format!("{called}: the chain has parted")));
            }
            AnchorPosition::Lost(LostBy::RanOut) => {
                all.push(alarm("anchor", &[name], format!("{called}: the chain has run out")));
            }
            _ if now.state.dragging && now.state.dragged_m > DRAGGED_M => {
                all.push(alarm("anchor", &[name], format!("{called} drags")));
            }
            _ => {}
        }
        if now.state.faults.windlass_failed {
            let text = format!("{called}: the windlass has no power");
            all.push(alarm("windlass", &[name], text));
        }
    }
}

fn lines(of: &Input<'_>, all: &mut Vec<Alarm>) {
    for (index, (line, now)) in of.info.lines.iter().zip(of.lines).enumerate() {
        let (name, share) = (&*line.name, now.tension_n / line.working_n);
        if now.state == "parted" {
            let text = format!("Line {name} has parted{}", of.passages.why_parted(index));
            all.push(alarm("line", &[name], text));
        } else if now.state == "fast" && share >= LINE_CAUTION {
            let why = of.passages.pushing(of.simulation, line.ship);
            let text = format!("Line {name}: {:.0} % of its working load{why}", 100.0 * share);
            all.push(of_level(alarm_if(share >= 1.0), "line", &[name], text));
        }
    }
}
