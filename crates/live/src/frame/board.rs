//! The docking board's signals for each end of a ship, from the contacts and the position of the berth. The distance
//! from the berth alone does not tell the signal. A hull behind the line of the fenders may lie at a fender, between
//! fenders, or on the quay.

use fenderline_contact::number::greater;
use fenderline_contact::{Rotation, Vec2, vec2};
use fenderline_sim::berth::{Berth, Lie};
use fenderline_sim::{FenderSetup, Simulation};

use crate::alarm_book::AlarmBook;
use crate::approach::{ApproachLimit, Light};
use crate::message::{BerthEnd, ContactNow, FenderNow, Lamp, Pair, VesselNow};

/// The data from which the docking board's signals are found.
pub(super) struct BoardInput<'a> {
    pub(super) simulation: &'a Simulation,
    pub(super) contacts: &'a [ContactNow],
    pub(super) fenders: &'a [FenderNow],
    pub(super) book: &'a AlarmBook,
    pub(super) approach: ApproachLimit,
}

/// An end of a ship is at the fenders if its distance is less than this (m) and a fender carries load. A docking laser
/// can resolve distances of this size.
const AT_FENDERS_M: f64 = 0.02;

/// The board's signal for an end of a ship: the worse of the signals for speed and for position. If both signals are
/// equal, the signal for position is shown.
pub(super) fn lamp(end: BerthEnd, speed: Light) -> Lamp {
    let by_speed = Lamp {
        light: speed,
        text: match speed {
            Light::Ok => "OK",
            Light::Caution => "CAUTION",
            Light::Alarm => "TOO FAST",
        },
        by_speed: true,
    };
    let (light, text) = match end {
        BerthEnd::Off => return by_speed,
        BerthEnd::AtFenders => (Light::Ok, "AT FENDERS"),
        BerthEnd::NoFender => (Light::Caution, "NO FENDER"),
        BerthEnd::PastEnd => (Light::Caution, "BEYOND FENDERS"),
        BerthEnd::Touched => (Light::Caution, "TOUCHED"),
        BerthEnd::WasOverRated => (Light::Caution, "FENDER WAS OVER"),
        BerthEnd::OverRated => (Light::Alarm, "FENDER LIMIT"),
        BerthEnd::Structure => (Light::Alarm, "STRUCTURE"),
    };
    if speed > light { by_speed } else { Lamp { light, text, by_speed: false } }
}

/// The positions of a vessel's bow and stern relative to the berth.
pub(super) fn ends(
    of: &BoardInput<'_>,
    berth: &Berth,
    vessel: usize,
    now: &VesselNow,
) -> [BerthEnd; 2] {
    let Some(lies) = &now.berth else { return [BerthEnd::Off; 2] };
    let setup = of.simulation.setup();
    let body = setup.world.vessels[vessel].body;
    let states = of.simulation.states();
    let outline = &setup.bodies[body].outline;
    let ends = berth.lie(&states[berth.body], outline, &states[body]);
    let ours: Vec<_> = of.contacts.iter().filter(|c| c.bodies.contains(&body)).collect();
    let at_berth = |contact: &ContactNow| contact.bodies.contains(&berth.body);
    let is_carried = ours.iter().any(|contact| contact.fender.is_some() && at_berth(contact));
    let is_structure = |other: usize| other == berth.body || setup.bodies[other].is_fixed();
    let on_structure = |name: &str| {
        setup.bodies.iter().enumerate().any(|(other, of)| of.name == name && is_structure(other))
    };
    let was_touched = of.book.has_open_touch(&setup.bodies[body].name, on_structure);
    let quay = Rotation::from_angle(states[berth.body].heading_rad);
    let at_berth_fenders = || {
        let all = setup.fenders.iter().zip(of.fenders);
        all.filter(|(fender, _)| fender.body == berth.body)
    };
    let place =
        |fender: &FenderSetup| states[berth.body].position_m + quay.apply(fender.position_m);
    let failed: Vec<Vec2> =
        at_berth_fenders().filter(|(_, now)| now.failed).map(|(fender, _)| place(fender)).collect();
    // Fenders that were loaded beyond their rating, where nobody has acknowledged the alarm.
    let were_over: Vec<Vec2> = at_berth_fenders()
        .filter(|(fender, _)| of.book.has_open_fender(&fender.name))
        .map(|(fender, _)| place(fender))
        .collect();
    let by_place = [lies.bow_m, lies.stern_m];
    std::array::from_fn(|end| {
        let mut worst = BerthEnd::Off;
        if by_place[end] < AT_FENDERS_M && is_carried {
            worst = BerthEnd::AtFenders;
        } else if by_place[end] < -AT_FENDERS_M {
            worst = BerthEnd::NoFender;
        }
        if berth.is_past_the_end(&ends, end) {
            worst = worst.max(BerthEnd::PastEnd);
        }
        if was_touched {
            worst = worst.max(BerthEnd::Touched);
        }
        if were_over.iter().any(|&at_m| is_at(&ends, end, at_m)) {
            worst = worst.max(BerthEnd::WasOverRated);
        }
        // A failed fender raises an alarm, whether the ship touches it or not.
        if failed.iter().any(|&at_m| is_at(&ends, end, at_m)) {
            worst = worst.max(BerthEnd::OverRated);
        }
        for contact in ours.iter().filter(|contact| is_at(&ends, end, of_pair(contact.at_m))) {
            let here = match contact.fender {
                // The ship touches the quay or a rock. Contact with a tug at her side does not count.
                None if contact.bodies.iter().any(|&other| is_structure(other)) => {
                    BerthEnd::Structure
                }
                Some(fender) if is_over_rated(&of.fenders[fender]) => BerthEnd::OverRated,
                _ => BerthEnd::Off,
            };
            worst = worst.max(here);
        }
        worst
    })
}

fn is_over_rated(fender: &FenderNow) -> bool {
    fender.failed || greater(fender.of_energy, fender.of_reaction) >= 1.0
}

/// True if a contact point belongs to an end of the ship. For this question the side of the ship is divided into three
/// thirds. A contact point in the middle third belongs to both ends, as the middle of a patch along the whole side
/// does. Outside the middle third, a contact point belongs to the nearer end of the ship.
fn is_at(ends: &Lie, end: usize, at_m: Vec2) -> bool {
    let [this, other] = [ends.at_m[end], ends.at_m[1 - end]];
    let side = this - other;
    (at_m - other).dot(side) > side.dot(side) / 3.0
}

fn of_pair(at: Pair) -> Vec2 {
    vec2(at[0], at[1])
}
