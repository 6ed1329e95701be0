//! The conditions of which a goal consists.

use fenderline_contact::number::{greater, lesser};

use super::ExerciseSetup;
use super::anchored::{AnchorPlace, Holding};
use super::words::{force, metres, speed};
use crate::berth::Lie;
use crate::simulation::Simulation;
use fenderline_world::world::Mooring;

/// A condition of a goal.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// So many of these lines are fast with a tension between two bounds.
    LinesFast {
        /// Indices into [`crate::WorldSetup::lines`].
        lines: Vec<usize>,
        /// How many of them at least.
        at_least: usize,
        /// Least and greatest tension (N).
        tension_n: [f64; 2],
    },
    /// No line of the ship is ashore or under way.
    LinesAboard {
        /// The lines of the ship: indices into [`crate::WorldSetup::lines`].
        lines: Vec<usize>,
    },
    /// Both ends of the flat of her side are within a distance of the line of the fenders, abreast of it.
    Alongside {
        /// That distance (m).
        within_m: f64,
    },
    /// No end of the flat of her side moves faster than this, relative to the berth; without a berth, her origin over ground.
    AtRest {
        /// Greatest speed (m/s).
        at_most_mps: f64,
    },
    /// Both ends of the flat of her side are at least this far off the line of the fenders.
    Clear {
        /// That distance (m).
        by_m: f64,
    },
    /// So many of these anchors hold: on the bottom, the brake on, not dragging.
    AnchorsHold {
        /// Indices into [`crate::WorldSetup::anchors`].
        anchors: Vec<usize>,
        /// How many of them at least.
        at_least: usize,
        /// Least chain out of each (m).
        chain_m: f64,
        /// Where each must lie; `None`: anywhere.
        place: Option<AnchorPlace>,
    },
}

/// Whether a condition is fulfilled now.
#[derive(Clone, Debug, PartialEq)]
pub struct Fulfilled {
    /// True if it is.
    pub is_met: bool,
    /// How things are, in a few words.
    pub now: String,
}

impl Condition {
    /// Whether the condition is fulfilled. `lie` is that of the ship at her berth.
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
                let within = |line: &&usize| {
                    let tension = all[**line].load.tension_n;
                    is_fast(&all[**line]) && tension >= tension_n[0] && tension <= tension_n[1]
                };
                let good = lines.iter().filter(within).count();
                let now = format!("{fast} fast, {good} of {at_least} with this tension");
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

    /// The condition in words.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Condition::LinesFast { at_least, tension_n: [least, most], .. } => {
                let lines = if *at_least == 1 { "line" } else { "lines" };
                let tension = match (*least > 0.0, most.is_finite()) {
                    (true, true) => format!(", {} to {} each", force(*least), force(*most)),
                    (true, false) => format!(", at least {} each", force(*least)),
                    (false, true) => format!(", at most {} each", force(*most)),
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

    /// True if the condition needs a berth.
    #[must_use]
    pub fn needs_berth(&self) -> bool {
        matches!(self, Condition::Alongside { .. } | Condition::Clear { .. })
    }
}

/// The scenario's reader refuses such an exercise; one made by calls is never fulfilled.
fn no_berth() -> Fulfilled {
    Fulfilled { is_met: false, now: "there is no berth".to_owned() }
}

fn is_fast(line: &Mooring) -> bool {
    line.line.is_some() && !line.has_parted()
}
