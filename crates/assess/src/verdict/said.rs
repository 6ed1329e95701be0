//! Writes the sentences on the laws whose range a run has left.

use super::finding::{duration, length};
use super::law::{Departure, Law, Subject};
use crate::gain::EnergyGain;
use fenderline_world::named::called;
use fenderline_world::setup::Setup;

impl Subject {
    /// Names of the bodies, fenders or ships that the finding concerns.
    pub(super) fn names(self, setup: &Setup) -> Vec<&str> {
        let world = &setup.world;
        let vessel = |index: usize| setup.bodies[world.vessels[index].body].name.as_str();
        match self {
            Subject::Run => Vec::new(),
            Subject::Bodies(bodies) => bodies.map(|body| setup.bodies[body].name.as_str()).to_vec(),
            Subject::Fender(fender) => vec![setup.fenders[fender].name.as_str()],
            Subject::Vessel(index) | Subject::Ratio { vessel: index, .. } => vec![vessel(index)],
            Subject::Passing(ship) => vec![world.flow.passing[ship].name.as_str()],
            Subject::Provider(index) => {
                vec![setup.bodies[world.providers[index].body].name.as_str()]
            }
        }
    }
}

impl Departure {
    /// The finding as one sentence without a full stop at the end.
    pub(super) fn sentence(&self, setup: &Setup, names: &[&str]) -> String {
        format!("{}, {}", self.said(setup, names), self.when())
    }

    /// Says in words when the law was left, and for which share of the run.
    fn when(&self) -> String {
        let Departure { first_s, lasting_s, share_of_run, .. } = *self;
        if share_of_run >= 1.0 {
            return "in the whole run".to_owned();
        }
        let percent = 100.0 * share_of_run;
        let share = match percent {
            ..0.1 => "less than 0.1 %".to_owned(),
            ..10.0 => format!("{percent:.1} %"),
            _ => format!("{percent:.0} %"),
        };
        format!("from {first_s:.1} s for {} ({share} of the run)", duration(lasting_s))
    }

    fn said(&self, setup: &Setup, names: &[&str]) -> String {
        let [value, end] = self.extent;
        match self.law {
            Law::DeepOverlap => format!(
                "{} and {} overlapped by {:.0} % of the smaller one, {} deep: the force law is not meant for that, and forces and \
                 motions are not valid",
                names[0],
                names[1],
                100.0 * value,
                length(end)
            ),
            Law::PlacedInOverlap => format!(
                "{} or {} was placed inside the other and is pushed out slowly: forces of the first contact have no meaning",
                names[0], names[1]
            ),
            Law::NotConverged => {
                "The contact solve did not converge: contact forces are not valid".to_owned()
            }
            Law::EnergyGained => EnergyGain { gained_j: value, taken_j: end }.sentence(),
            Law::CurrentHeld => format!(
                "{} was off the grid or the times of the current: the current at the edge of the grid acted on her",
                names[0]
            ),
            Law::WindHeld => held("wind"),
            Law::TideHeld => held("tide"),
            Law::LongWavesHeld => held("long waves"),
            Law::FenderAngle => format!(
                "{} was met at {:.1} degrees, and its factors by angle end at {:.1}: the last factor was used",
                called("Fender", names[0]),
                value.to_degrees(),
                end.to_degrees()
            ),
            Law::FenderSpeed => format!(
                "{} was met with a compression time of {value:.2} s, and its factors by speed begin at {end:.2} s: \
                 the first factor was used",
                called("Fender", names[0])
            ),
            Law::WavesOfHydrodynamics => format!(
                "{:.0} % of the sea's energy is at frequencies outside the hydrodynamic data of {}, whose forces at the end of \
                 their range were used",
                100.0 * value,
                names[0]
            ),
            Law::WavesOfResponse => format!(
                "{:.0} % of the sea's energy is at frequencies outside the table of responses of {}, whose response at the end of \
                 its range was used",
                100.0 * value,
                names[0]
            ),
            Law::DepthOfHydrodynamics => format!(
                "The hydrodynamic data of {} are for {}, but the run has {}",
                names[0],
                water(value),
                water(end)
            ),
            Law::ShallowHeld => format!(
                "{} had {value:.2} draughts of water, and no shallow-water formula covers less than {end}: hull forces, added mass \
                 and squat kept their values at {end}",
                names[0]
            ),
            Law::ShallowExtrapolated => format!(
                "{} had {value:.2} draughts of water, and shallow-water corrections cover {end} and more: they were extrapolated",
                names[0]
            ),
            Law::SquatDepth => format!(
                "{} had {value:.2} draughts of water, and her formula of squat covers up to {end}",
                names[0]
            ),
            Law::SquatSpeed => format!(
                "{} reached {value:.2} of the speed of long waves, and the formula of squat covers up to {end}: squat kept its \
                 value at {end}",
                names[0]
            ),
            Law::EstimateOutside => match self.subject {
                Subject::Ratio { vessel, ratio } => {
                    format!("{}: {}", names[0], setup.world.vessels[vessel].origin.outside[ratio])
                }
                _ => unreachable!(
                    "an estimate is outside its range because of a ratio of the ship's dimensions"
                ),
            },
            Law::PassingSpeed => format!(
                "{} passes at {value:.2} of the speed of long waves: the computed flow has no waves, and the forces \
                 of the passing ship are too small",
                names[0]
            ),
            Law::PassingShape => format!(
                "{} is {value:.1} beams long: the flow about passing ships is that of slender ships",
                names[0]
            ),
            Law::FlowLeftOut => format!(
                "{} and {} came within {value:.2} of their mean beam, and below {end} the flow between them is left out in part or wholly",
                names[0], names[1]
            ),
            Law::ProviderSilent => format!(
                "The program that gives a force on {} did not reply: its last force was held for a time, and then no force acted",
                names[0]
            ),
        }
    }
}

/// The sentence for a run that lasted longer than a series of wind, tide or long waves.
fn held(what: &str) -> String {
    format!(
        "The run went on before the first or after the last row of the {what}, which kept the value of this row: \
         add a row at the end of the run if a constant value is meant"
    )
}

fn water(depth_m: f64) -> String {
    if depth_m.is_finite() { format!("{depth_m} m of water") } else { "deep water".to_owned() }
}
