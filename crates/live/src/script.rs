//! What the instructor has prepared: changes of wind and current over a time, and events at given times. Part of the state that
//! is kept, rewound and branched; it runs before each step.

use fenderline_contact::number::bounded;
use fenderline_contact::vec2;
use fenderline_sim::environment::current::Current;

use crate::action::{Action, OtherAction};
use crate::carry_out::carry_out;
use crate::cast::Cast;
use crate::limits::{LONGEST_PLAN_S, MOST_PLANNED};
use crate::message::PlannedNow;
use crate::refusal::Refusal;
use crate::session::Now;

/// Speed and direction of wind or current.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Flow {
    /// Speed (m/s).
    pub(crate) speed_mps: f64,
    /// Direction, clockwise from north (rad): from which the wind comes, to which the current sets.
    pub(crate) direction_rad: f64,
}

/// A change from one flow to another over a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ramp {
    from: Flow,
    to: Flow,
    begins_s: f64,
    over_s: f64,
}

impl Ramp {
    /// A ramp that begins at a time (s) and lasts `over_s`.
    pub(crate) fn new(from: Flow, to: Flow, begins_s: f64, over_s: f64) -> Ramp {
        Ramp { from, to, begins_s, over_s }
    }

    /// The flow at a time: the speed by a straight line, the direction by the shorter turn. From a calm it has the direction of the
    /// end throughout.
    pub(crate) fn at(&self, t_s: f64) -> Flow {
        let share = bounded((t_s - self.begins_s) / self.over_s, 0.0, 1.0);
        let turn_rad = libm::remainder(
            self.to.direction_rad - self.from.direction_rad,
            core::f64::consts::TAU,
        );
        let direction_rad = if self.from.speed_mps > 0.0 {
            self.from.direction_rad + share * turn_rad
        } else {
            self.to.direction_rad
        };
        let speed_mps = self.from.speed_mps + share * (self.to.speed_mps - self.from.speed_mps);
        if share < 1.0 { Flow { speed_mps, direction_rad } } else { self.to }
    }

    /// True at its end and later.
    pub(crate) fn is_over(&self, t_s: f64) -> bool {
        t_s >= self.begins_s + self.over_s
    }
}

/// What became of a planned event.
#[derive(Clone, Debug, PartialEq)]
enum Fate {
    Waits,
    Fired,
    Cancelled,
    /// It could not be carried out when its time came, for this reason.
    Refused(String),
}

/// An event at a time.
#[derive(Clone, Debug, PartialEq)]
struct Planned {
    id: u64,
    at_s: f64,
    event: OtherAction,
    fate: Fate,
}

/// The instructor's script.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Script {
    pub(crate) wind: Option<Ramp>,
    pub(crate) current: Option<Ramp>,
    planned: Vec<Planned>,
    /// Number of events that were planned so far.
    count: u64,
}

impl Script {
    /// The planned events for the instructor's page, by time.
    pub(crate) fn messages(&self) -> Vec<PlannedNow> {
        let mut all: Vec<PlannedNow> = self.planned.iter().map(Planned::message).collect();
        all.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
        all
    }

    /// Cancels an event that waits.
    ///
    /// # Errors
    /// There is none of this number that waits.
    pub(crate) fn cancel(&mut self, id: u64) -> Result<(), Refusal> {
        let waits = |planned: &&mut Planned| planned.id == id && planned.fate == Fate::Waits;
        let planned = self.planned.iter_mut().find(waits);
        planned.ok_or_else(|| Refusal::new("this event has happened, or was cancelled"))?.fate =
            Fate::Cancelled;
        Ok(())
    }
}

impl Planned {
    fn message(&self) -> PlannedNow {
        let (state, reason) = match &self.fate {
            Fate::Waits => ("waits", None),
            Fate::Fired => ("fired", None),
            Fate::Cancelled => ("cancelled", None),
            Fate::Refused(reason) => ("refused", Some(reason.clone())),
        };
        PlannedNow { id: self.id, at_s: self.at_s, event: self.event.clone(), state, reason }
    }
}

/// Plans an event. It must be one that could be carried out now.
///
/// # Errors
/// The reason why it cannot be planned.
pub(crate) fn plan(
    event: &OtherAction,
    at_s: f64,
    cast: &Cast,
    now: &mut Now,
) -> Result<(), Refusal> {
    if !event.can_be_planned() {
        return Err(Refusal::new("only changes of the weather and faults can be planned"));
    }
    let t_s = now.simulation.time_s();
    if !(at_s > t_s && at_s <= t_s + LONGEST_PLAN_S) {
        return Err(Refusal::new(format_args!(
            "an event is planned for a time from now to {} h from now",
            LONGEST_PLAN_S / 3600.0
        )));
    }
    let waiting = now.script.planned.iter().filter(|planned| planned.fate == Fate::Waits).count();
    if waiting >= MOST_PLANNED {
        return Err(Refusal::new(format_args!("at most {MOST_PLANNED} events can wait")));
    }
    carry_out(&Action::Other(event.clone()), cast, &mut now.clone())?;
    let Script { planned, count, .. } = &mut now.script;
    *count += 1;
    planned.push(Planned { id: *count, at_s, event: event.clone(), fate: Fate::Waits });
    // What is over is forgotten beyond some number, the oldest first.
    if planned.len() > 2 * MOST_PLANNED
        && let Some(over) = planned.iter().position(|planned| planned.fate != Fate::Waits)
    {
        planned.remove(over);
    }
    Ok(())
}

/// True if something is due in the next step.
pub(crate) fn is_due(now: &Now) -> bool {
    let Script { wind, current, planned, .. } = &now.script;
    let end_s = now.simulation.time_s() + now.simulation.setup().step_s;
    let is_due = |planned: &Planned| planned.fate == Fate::Waits && planned.at_s < end_s;
    wind.is_some() || current.is_some() || planned.iter().any(is_due)
}

/// Carries out what is due in the next step. Returns the events that fired.
pub(crate) fn run(cast: &Cast, now: &mut Now) -> Vec<OtherAction> {
    let t_s = now.simulation.time_s();
    let end_s = t_s + now.simulation.setup().step_s;
    let mut fired = Vec::new();
    for index in 0..now.script.planned.len() {
        let Planned { at_s, event, fate, .. } = &now.script.planned[index];
        // As an order, an event takes effect in the step that contains its time.
        if *fate != Fate::Waits || *at_s >= end_s {
            continue;
        }
        let event = event.clone();
        let fate = match carry_out(&Action::Other(event.clone()), cast, now) {
            Ok(_) => {
                fired.push(event);
                Fate::Fired
            }
            Err(why) => Fate::Refused(why.to_string()),
        };
        now.script.planned[index].fate = fate;
    }
    let environment = &now.simulation.setup().world.environment;
    if let Some(ramp) = now.script.wind {
        let Flow { speed_mps, direction_rad } = ramp.at(end_s);
        let changed =
            environment.wind.as_ref().map(|wind| wind.changed_to(speed_mps, direction_rad));
        // Between two winds that were accepted each wind is.
        if let Some(Ok(wind)) = changed {
            now.simulation.set_wind(Some(wind));
        }
        if ramp.is_over(end_s) {
            now.script.wind = None;
        }
    }
    if let Some(ramp) = now.script.current {
        let Flow { speed_mps, direction_rad } = ramp.at(end_s);
        let velocity = vec2(libm::cos(direction_rad), libm::sin(direction_rad)) * speed_mps;
        if let Ok(current) = Current::uniform(velocity) {
            now.simulation.set_current(Some(current));
        }
        if ramp.is_over(end_s) {
            now.script.current = None;
        }
    }
    fired
}
