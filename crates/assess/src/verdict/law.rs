//! The laws and data of a run, and the table of all conditions under which a run leaves them.
//!
//! Each force comes from a law or from data, and each law and each data set has a range. If a run leaves the range, the
//! engine goes on: it uses the law beyond its range, or the value at the end of the data. [`Law::TABLE`] lists all
//! these conditions once. Each condition is a [`super::Finding`]. Terminal, exit code, files, pages and campaigns show
//! it with its time and its share of the run.

use super::Verdict;

/// A law, or the range of some data, that a run can leave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Two bodies without a fender between them overlap by more than half of the smaller body.
    DeepOverlap,
    /// A body was placed so deep in another body that the contact would eject it. The contact pushes the body out
    /// slowly instead.
    PlacedInOverlap,
    /// The coupled solve of a contact did not settle within its iteration limit.
    NotConverged,
    /// Contacts returned more energy than they absorbed.
    EnergyGained,
    /// A vessel is off the grid of the current, or the run is before or after the times of the current.
    CurrentHeld,
    /// The run is before the first or after the last time of the wind.
    WindHeld,
    /// The run is before the first or after the last time of the tide.
    TideHeld,
    /// The run is before the first or after the last time of the long waves.
    LongWavesHeld,
    /// A hull met a fender at a larger angle than the fender's factors cover.
    FenderAngle,
    /// A hull met a fender faster than the fender's factors cover.
    FenderSpeed,
    /// A part of the sea's energy is at frequencies that a vessel's hydrodynamic data do not cover.
    WavesOfHydrodynamics,
    /// A part of the sea's energy is at frequencies that a vessel's table of responses does not cover.
    WavesOfResponse,
    /// A vessel's hydrodynamic data are for another depth.
    DepthOfHydrodynamics,
    /// The water is shallower than all shallow-water formulas cover: the values at 1.1 draughts are used.
    ShallowHeld,
    /// The water is shallower than in the published tests behind the shallow-water formulas. The formulas are
    /// extrapolated.
    ShallowExtrapolated,
    /// The water is deeper than the formula of squat covers.
    SquatDepth,
    /// A vessel is faster than the formula of squat covers in this depth.
    SquatSpeed,
    /// A vessel is estimated by formulas, and a ratio of the vessel's dimensions is outside the range of ships with
    /// which the formulas were compared.
    EstimateOutside,
    /// A passing ship is nearly as fast as long waves. The flow about her does not include waves.
    PassingSpeed,
    /// A passing ship is too short for the theory of slender ships.
    PassingShape,
    /// Two vessels are so near each other that the flow between them is left out.
    FlowLeftOut,
    /// A program that gives forces did not reply. The program's last force was held for a time, and then dropped.
    ProviderSilent,
}

/// A row of [`Law::TABLE`].
#[derive(Clone, Copy, Debug)]
pub struct LawRow {
    /// The law.
    pub law: Law,
    /// Key of the law in files.
    pub key: &'static str,
    /// The verdict on a run that leaves the law.
    pub verdict: Verdict,
    /// When the law is left, for documents.
    pub when: &'static str,
    /// The engine's action in this case, for documents.
    pub then: &'static str,
}

const fn row(
    law: Law,
    key: &'static str,
    verdict: Verdict,
    when: &'static str,
    then: &'static str,
) -> LawRow {
    LawRow { law, key, verdict, when, then }
}

impl Law {
    /// All conditions in which a result is outside its law or its data.
    pub const TABLE: [LawRow; 22] = [
        row(
            Law::DeepOverlap,
            "deep_overlap",
            Verdict::OutsideForceLaw,
            "two bodies overlap by more than half of the smaller one, without a fender between them",
            "the force follows the area of the overlap, which no longer describes a body's stiffness",
        ),
        row(
            Law::PlacedInOverlap,
            "placed_in_overlap",
            Verdict::StartInside,
            "a body is placed so deep in another that the contact would eject it",
            "the body is pushed out slowly",
        ),
        row(
            Law::NotConverged,
            "not_converged",
            Verdict::NotConverged,
            "the coupled solve of a contact does not settle within its iteration limit",
            "the forces of the last iteration",
        ),
        row(
            Law::EnergyGained,
            "energy_gained",
            Verdict::EnergyGained,
            "contacts return over 1 % more energy than they absorbed",
            "the energy stays in the motion",
        ),
        row(
            Law::CurrentHeld,
            "current_held",
            Verdict::OutsideData,
            "a vessel is off the grid of the current, or the run is outside the times of the current",
            "the current at the grid's edge",
        ),
        row(
            Law::WindHeld,
            "wind_held",
            Verdict::OutsideData,
            "the run is before the first or after the last row of the wind",
            "the wind of the first or last row",
        ),
        row(
            Law::TideHeld,
            "tide_held",
            Verdict::OutsideData,
            "the run is before the first or after the last row of the tide",
            "the level of the first or last row",
        ),
        row(
            Law::LongWavesHeld,
            "long_waves_held",
            Verdict::OutsideData,
            "the run is before the first or after the last row of the long waves",
            "level and velocity of the first or last row",
        ),
        row(
            Law::FenderAngle,
            "fender_angle",
            Verdict::OutsideData,
            "a hull meets a fender at a larger angle than its factors by angle cover",
            "the factor at the largest angle of the data",
        ),
        row(
            Law::FenderSpeed,
            "fender_speed",
            Verdict::OutsideData,
            "a hull compresses a fender faster than its factors by speed cover",
            "the factor at the shortest compression time of the data",
        ),
        row(
            Law::WavesOfHydrodynamics,
            "waves_outside_hydrodynamics",
            Verdict::OutsideData,
            "over 2 % of the sea's energy is at frequencies outside a vessel's hydrodynamic data",
            "the forces at the first or last frequency of the data",
        ),
        row(
            Law::WavesOfResponse,
            "waves_outside_response",
            Verdict::OutsideData,
            "over 2 % of the sea's energy is at frequencies outside a vessel's table of responses",
            "the response at the first or last frequency of the table",
        ),
        row(
            Law::DepthOfHydrodynamics,
            "depth_of_hydrodynamics",
            Verdict::OutsideData,
            "the depth at the start differs by over 10 % from the depth of a vessel's hydrodynamic data, and one of the two is not deep",
            "the hydrodynamic data without a correction",
        ),
        row(
            Law::ShallowHeld,
            "shallow_held",
            Verdict::OutsideData,
            "a vessel has less than 1.1 draughts of water",
            "hull forces, added mass and squat of 1.1 draughts",
        ),
        row(
            Law::ShallowExtrapolated,
            "shallow_extrapolated",
            Verdict::Extrapolated,
            "a vessel has 1.1 to 1.2 draughts of water, less than the published tests",
            "the factors of hull and added mass, continued along their tangents",
        ),
        row(
            Law::SquatDepth,
            "squat_depth",
            Verdict::Extrapolated,
            "a vessel squats by 1 cm or more in water deeper than the formula of squat covers",
            "the formula of squat outside its range",
        ),
        row(
            Law::SquatSpeed,
            "squat_speed",
            Verdict::OutsideData,
            "a vessel is faster than 0.9 times the speed of long waves in this depth",
            "the squat at 0.9 times the speed of long waves",
        ),
        row(
            Law::EstimateOutside,
            "estimate_outside",
            Verdict::Extrapolated,
            "a vessel is estimated from particulars, and a ratio is outside the range of the ships that the formulas were compared with",
            "the formulas nevertheless, or simpler formulas; the error is not known",
        ),
        row(
            Law::PassingSpeed,
            "passing_speed",
            Verdict::OutsideData,
            "a passing ship goes at more than 0.6 of the speed of long waves at the lowest level",
            "the flow without waves: the forces are too small",
        ),
        row(
            Law::PassingShape,
            "passing_shape",
            Verdict::Extrapolated,
            "a passing ship is shorter than four beams",
            "the flow of slender ships",
        ),
        row(
            Law::FlowLeftOut,
            "flow_left_out",
            Verdict::Extrapolated,
            "two vessels that act on each other are nearer than half the mean of their beams",
            "a part of the flow between the vessels; none below a quarter of the mean of their beams",
        ),
        row(
            Law::ProviderSilent,
            "provider_silent",
            Verdict::OutsideData,
            "a program that gives forces does not reply in time, or its force cannot be used",
            "the program's last force for a time, then no force",
        ),
    ];

    /// Row of the law in the table.
    #[must_use]
    pub fn row(self) -> &'static LawRow {
        let found = Law::TABLE.iter().find(|row| row.law == self);
        found.unwrap_or_else(|| unreachable!("the table has every law"))
    }
}

/// The part of a run that left a law, as indices into the [`fenderline_world::setup::Setup`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The run as a whole.
    Run,
    /// Two bodies.
    Bodies([usize; 2]),
    /// A fender.
    Fender(usize),
    /// A vessel.
    Vessel(usize),
    /// A ratio of a vessel's dimensions.
    Ratio {
        /// The vessel.
        vessel: usize,
        /// Index into [`fenderline_ship::hydro::vessels::Origin::outside`].
        ratio: usize,
    },
    /// A passing ship.
    Passing(usize),
    /// A program that gives forces, by its index in [`fenderline_world::world::WorldSetup::providers`].
    Provider(usize),
}

/// A law that a run left: the subject, when, and how far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The law.
    pub law: Law,
    /// The part of the run that left the law.
    pub subject: Subject,
    /// Start of the first step in which the law was left (s).
    pub first_s: f64,
    /// How long this lasted in all (s).
    pub lasting_s: f64,
    /// `lasting_s` over the time of the run so far; 1 for a departure that lasts from start to end.
    pub share_of_run: f64,
    /// Two numbers that say how far the law was left. The meaning of the numbers depends on the law:
    ///
    /// | law | first | second |
    /// |---|---|---|
    /// | deep overlap | most of the smaller body's area | greatest depth (m) |
    /// | energy gained | energy returned beyond the energy absorbed (J) | energy absorbed (J) |
    /// | fender angle | greatest angle (rad) | last angle of the data (rad) |
    /// | fender speed | shortest compression time (s) | first of the data (s) |
    /// | waves | share of the sea's energy | 0 |
    /// | depth of hydrodynamic data | of the data (m), infinite for deep water | of the run (m), likewise |
    /// | shallow water, depth of squat | least or greatest depth over draught | end of the range |
    /// | speed of squat, speed of a passing ship | speed over that of long waves | end of the range |
    /// | shape of a passing ship | length over beam | end of the range |
    /// | flow left out | least gap between the axes' sides over the mean of the beams | end of the range |
    /// | others | 0 | 0 |
    pub extent: [f64; 2],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_law_has_one_row_and_one_key() {
        for (index, row) in Law::TABLE.iter().enumerate() {
            assert_eq!(row.law as usize, index, "{}", row.key);
            assert_eq!(row.law.row().key, row.key);
            assert!(Law::TABLE.iter().filter(|other| other.key == row.key).count() == 1);
            assert!(row.verdict > Verdict::AllWell, "{}", row.key);
        }
    }
}
