//! The conditions of which a goal consists.

use fenderline_contact::number::{greater, lesser};

use super::ExerciseSetup;
use super::anchored::{AnchorPlace, Holding};
use super::words::{metres, speed, tension};
use crate::berth::Lie;
use crate::simulation::Simulation;
use fenderline_ship::mooring::WinchOrder;
use fenderline_world::world::Mooring;

/// A condition that belongs to the goal of an exercise.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// At least a given number of these lines are fast, with a tension between two bounds.
    LinesFast {
        /// Indices into [`crate::WorldSetup::lines`].
        lines: Vec<usize>,
        /// The least number of lines that must be fast with a tension between the two bounds.
        at_least: usize,
        /// Least and greatest tension of a line that counts as fast (N).
        tension_n: [f64; 2],
    },
    /// No line of the ship is fast to a bollard or on its way between ship and bollard.
    LinesAboard {
        /// The lines of the ship: indices into [`crate::WorldSetup::lines`].
        lines: Vec<usize>,
    },
    /// Both ends of the flat of the ship's side are abreast of the berth, and within a given distance of the line of
    /// the fenders.
    Alongside {
        /// The greatest distance of the two ends of the ship's flat side from the line of the fenders (m).
        within_m: f64,
    },
    /// No end of the flat of the ship's side moves faster than this speed relative to the berth. Without a berth, the
    /// condition is that the ship's origin moves no faster than this speed over the ground.
    AtRest {
        /// Greatest speed (m/s).
        at_most_mps: f64,
    },
    /// Both ends of the flat of the ship's side are at least a given distance off the line of the fenders.
    Clear {
        /// The least distance of the two ends of the ship's flat side from the line of the fenders (m).
        by_m: f64,
    },
    /// At least a given number of these anchors hold: they are on the bottom with the brake on, and do not drag.
    AnchorsHold {
        /// Indices into [`crate::WorldSetup::anchors`].
        anchors: Vec<usize>,
        /// The least number of anchors that must hold.
        at_least: usize,
        /// Least length of chain out of each anchor (m).
        chain_m: f64,
        /// The place where each anchor must lie; `None` if the anchor may lie anywhere.
        place: Option<AnchorPlace>,
    },
}

/// A condition of the goal, and whether it is fulfilled in the present state.
#[derive(Clone, Debug, PartialEq)]
pub struct Fulfilled {
    /// True if the condition of the goal is fulfilled.
    pub is_met: bool,
    /// The present state of what the condition is about, in a few words.
    pub now: String,
}

impl Condition {
    /// Evaluates whether the condition is fulfilled. `lie` is the position of the ship relative to her berth.
    pub(super) fn look(
        &self,
        exercise: &ExerciseSetup,
        simulation: &Simulation,
        lie: Option<&Lie>,
    ) -> Fulfilled {
        match self {
            Condition::LinesFast { lines, at_least, tension_n } => {
                let all = simulation.lines();
                let fast = lines.iter().filter(|&&line| is_fast(&all[line])).count();
                let asks_tension = self.tensions().is_some();
                let within = |line: &&usize| {
                    let line = &all[**line];
                    let tension = line.load.tension_n;
                    // The tension of a line whose winch works does not last.
                    let holds = !asks_tension || line.order == WinchOrder::Hold;
                    is_fast(line) && holds && tension >= tension_n[0] && tension <= tension_n[1]
                };
                let good = lines.iter().filter(within).count();
                let what =
                    if asks_tension { " with the required tension, winch on hold" } else { "" };
                let now = format!("{fast} lines fast, {good} of {at_least}{what}");
                Fulfilled { is_met: good >= *at_least, now }
            }
            Condition::LinesAboard { lines } => {
                let all = simulation.lines();
                let out = lines.iter().filter(|&&line| !all[line].aboard).count();
                Fulfilled { is_met: out == 0, now: format!("{out} not on board") }
            }
            Condition::Alongside { within_m } => {
                let (Some(berth), Some(lie)) = (&exercise.berth, lie) else { return no_berth() };
                let off_m = greater(lie.off_m[0], lie.off_m[1]);
                let is_past = (0..2).any(|end| berth.is_past_the_end(lie, end));
                let now = match is_past {
                    true => format!("past the end of the fenders, {} off", metres(off_m)),
                    false if off_m <= 0.0 => "at the fenders".to_owned(),
                    false => format!("{} off", metres(off_m)),
                };
                Fulfilled { is_met: off_m <= *within_m && !is_past, now }
            }
            Condition::AtRest { at_most_mps } => {
                let now_mps = match lie {
                    Some(lie) => greater(lie.speed_mps[0], lie.speed_mps[1]),
                    None => {
                        let body = simulation.setup().world.vessels[exercise.vessel].body;
                        simulation.states()[body].velocity_mps.length()
                    }
                };
                Fulfilled { is_met: now_mps <= *at_most_mps, now: speed(now_mps) }
            }
            Condition::Clear { by_m } => {
                let Some(lie) = lie else { return no_berth() };
                let off_m = lesser(lie.off_m[0], lie.off_m[1]);
                Fulfilled { is_met: off_m >= *by_m, now: format!("{} off", metres(off_m)) }
            }
            Condition::AnchorsHold { anchors, at_least, chain_m, place } => {
                let (holding, all) = (Holding { chain_m: *chain_m, place }, simulation.anchors());
                let good = anchors.iter().filter(|&&anchor| holding.is_met_by(&all[anchor]));
                Fulfilled {
                    is_met: good.count() >= *at_least,
                    now: holding.now(anchors, all, simulation.setup()),
                }
            }
        }
    }

    /// The lines of which the condition asks a tension, and the least and the largest tension (N). `None` if the
    /// condition asks for no tension.
    #[must_use]
    pub fn tensions(&self) -> Option<(&[usize], [f64; 2])> {
        match self {
            Condition::LinesFast { lines, tension_n, .. }
                if tension_n[0] > 0.0 || tension_n[1].is_finite() =>
            {
                Some((lines, *tension_n))
            }
            _ => None,
        }
    }

    /// The condition in words.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Condition::LinesFast { at_least, tension_n: [least, most], .. } => {
                let lines = if *at_least == 1 { "line" } else { "lines" };
                let tension = match (*least > 0.0, most.is_finite()) {
                    (true, true) => {
                        format!(", {} to {} each, winch on hold", tension(*least), tension(*most))
                    }
                    (true, false) => format!(", at least {} each, winch on hold", tension(*least)),
                    (false, true) => format!(", at most {} each, winch on hold", tension(*most)),
                    (false, false) => String::new(),
                };
                format!("{at_least} {lines} fast{tension}")
            }
            Condition::LinesAboard { .. } => "all lines on board".to_owned(),
            Condition::Alongside { within_m } => {
                format!("bow and stern within {} of the fenders", metres(*within_m))
            }
            Condition::AtRest { at_most_mps } => {
                format!("at rest: no end faster than {}", speed(*at_most_mps))
            }
            Condition::Clear { by_m } => {
                format!("bow and stern at least {} off the fenders", metres(*by_m))
            }
            Condition::AnchorsHold { at_least, chain_m, place, .. } => {
                let hold = if *at_least == 1 { "anchor holds" } else { "anchors hold" };
                let holding = Holding { chain_m: *chain_m, place };
                format!("{at_least} {hold}{}", holding.words())
            }
        }
    }

    /// Returns true if the condition can only be evaluated at a berth.
    #[must_use]
    pub fn needs_berth(&self) -> bool {
        matches!(self, Condition::Alongside { .. } | Condition::Clear { .. })
    }
}

/// The reader of scenarios refuses an exercise whose condition needs a berth that the scenario does not have. A
/// condition that needs a missing berth is never fulfilled in an exercise made by calls of this crate.
fn no_berth() -> Fulfilled {
    Fulfilled { is_met: false, now: "there is no berth".to_owned() }
}

fn is_fast(line: &Mooring) -> bool {
    line.line.is_some() && !line.has_parted()
}
