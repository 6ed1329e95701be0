//! The physical laws and the data that a run uses, and the table of all conditions under which a run leaves their
//! range.
//!
//! Each force comes from a law or from data, and each law and each data set has a range. If a run leaves the range of a
//! law or of data, the engine goes on: it uses the law beyond its range, or the value at the end of the data.
//! [`Law::TABLE`] has one row for each condition under which a run leaves a law or its data. Each condition in this
//! table becomes a [`super::Finding`] when it occurs in a run. Terminal, exit code, files, pages and campaigns show
//! each such finding with its time and its share of the run.

use super::Verdict;

/// A physical law, or the range of some data, that a run can leave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Two bodies without a fender between them overlap by more than half of the smaller body.
    DeepOverlap,
    /// A body was placed so deep in another body that the contact would eject it. The contact pushes the placed body
    /// out slowly instead.
    PlacedInOverlap,
    /// The coupled solve of a contact did not settle within its iteration limit.
    NotConverged,
    /// Contacts returned more energy than they absorbed.
    EnergyGained,
    /// A vessel is off the grid of the current, or the run is before the first or after the last time of the current.
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
    /// A vessel's hydrodynamic data are for another depth of water.
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
    /// The coefficients of a vessel are estimated by formulas, and a ratio of her dimensions is outside the
    /// range of the ships with which the formulas were compared.
    EstimateOutside,
    /// A passing ship is nearly as fast as long waves in this depth. The computed flow about the passing ship does not
    /// include waves.
    PassingSpeed,
    /// A passing ship is too short for the theory of slender ships.
    PassingShape,
    /// Two vessels are so near each other that the flow between them is left out.
    FlowLeftOut,
    /// A program that gives forces did not reply. The last force of the program was held for a time and then dropped.
    ProviderSilent,
}

/// A row of [`Law::TABLE`].
#[derive(Clone, Copy, Debug)]
pub struct LawRow {
    /// The law.
    pub law: Law,
    /// Key of the law in result files.
    pub key: &'static str,
    /// The verdict on a run that leaves the law.
    pub verdict: Verdict,
    /// The condition under which a run leaves the law, as text for documents.
    pub when: &'static str,
    /// What the engine does when a run leaves the law, as text for documents.
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
    /// One row for each condition under which a result is outside its law or its data.
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
            "the engine uses the forces of the last iteration",
        ),
        row(
            Law::EnergyGained,
            "energy_gained",
            Verdict::EnergyGained,
            "contacts return over 1 % more energy than they absorbed",
            "the energy gained stays in the motion of the bodies",
        ),
        row(
            Law::CurrentHeld,
            "current_held",
            Verdict::OutsideData,
            "a vessel is off the grid of the current, or the run is outside the times of the current",
            "the engine uses the current at the edge of the grid",
        ),
        row(
            Law::WindHeld,
            "wind_held",
            Verdict::OutsideData,
            "the run is before the first or after the last row of the wind",
            "the engine uses the wind of the first or last row",
        ),
        row(
            Law::TideHeld,
            "tide_held",
            Verdict::OutsideData,
            "the run is before the first or after the last row of the tide",
            "the engine uses the level of the first or last row",
        ),
        row(
            Law::LongWavesHeld,
            "long_waves_held",
            Verdict::OutsideData,
            "the run is before the first or after the last row of the long waves",
            "the engine uses level and velocity of the first or last row",
        ),
        row(
            Law::FenderAngle,
            "fender_angle",
            Verdict::OutsideData,
            "a hull meets a fender at a larger angle than its factors by angle cover",
            "the engine uses the factor at the largest angle of the data",
        ),
        row(
            Law::FenderSpeed,
            "fender_speed",
            Verdict::OutsideData,
            "a hull compresses a fender faster than its factors by speed cover",
            "the engine uses the factor at the shortest compression time of the data",
        ),
        row(
            Law::WavesOfHydrodynamics,
            "waves_outside_hydrodynamics",
            Verdict::OutsideData,
            "over 2 % of the sea's energy is at frequencies outside a vessel's hydrodynamic data",
            "the engine uses the forces at the first or last frequency of the data",
        ),
        row(
            Law::WavesOfResponse,
            "waves_outside_response",
            Verdict::OutsideData,
            "over 2 % of the sea's energy is at frequencies outside a vessel's table of responses",
            "the engine uses the response at the first or last frequency of the table",
        ),
        row(
            Law::DepthOfHydrodynamics,
            "depth_of_hydrodynamics",
            Verdict::OutsideData,
            "the depth at the start differs by over 10 % from the depth of a vessel's hydrodynamic data, and one of the two is not deep",
            "the engine uses the hydrodynamic data without a correction",
        ),
        row(
            Law::ShallowHeld,
            "shallow_held",
            Verdict::OutsideData,
            "a vessel has less than 1.1 draughts of water",
            "the engine uses hull forces, added mass and squat of 1.1 draughts",
        ),
        row(
            Law::ShallowExtrapolated,
            "shallow_extrapolated",
            Verdict::Extrapolated,
            "a vessel has 1.1 to 1.2 draughts of water, less than the published tests",
            "the engine continues the factors of hull forces and added mass along their tangents",
        ),
        row(
            Law::SquatDepth,
            "squat_depth",
            Verdict::Extrapolated,
            "a vessel squats by 1 cm or more in water deeper than the formula of squat covers",
            "the engine uses the formula of squat outside its range",
        ),
        row(
            Law::SquatSpeed,
            "squat_speed",
            Verdict::OutsideData,
            "a vessel is faster than 0.9 times the speed of long waves in this depth",
            "the engine uses the squat at 0.9 times the speed of long waves",
        ),
        row(
            Law::EstimateOutside,
            "estimate_outside",
            Verdict::Extrapolated,
            "a vessel is estimated from particulars, and a ratio is outside the range of the ships that the formulas were compared with",
            "the engine uses the formulas nevertheless, or simpler formulas; their error is not known",
        ),
        row(
            Law::PassingSpeed,
            "passing_speed",
            Verdict::OutsideData,
            "a passing ship goes at more than 0.6 of the speed of long waves at the lowest level",
            "the engine computes the flow without waves: the forces of the passing ship are too small",
        ),
        row(
            Law::PassingShape,
            "passing_shape",
            Verdict::Extrapolated,
            "a passing ship is shorter than four beams",
            "the engine uses the flow of slender ships",
        ),
        row(
            Law::FlowLeftOut,
            "flow_left_out",
            Verdict::Extrapolated,
            "two vessels that act on each other are nearer than half the mean of their beams",
            "the engine reduces the flow between the vessels, and leaves it out for gaps below a quarter of the mean of their beams",
        ),
        row(
            Law::ProviderSilent,
            "provider_silent",
            Verdict::OutsideData,
            "a program that gives forces does not reply in time, or its force cannot be used",
            "the engine holds the program's last force for a time and then uses no force",
        ),
    ];

    /// The row of this law in [`Law::TABLE`].
    #[must_use]
    pub fn row(self) -> &'static LawRow {
        let found = Law::TABLE.iter().find(|row| row.law == self);
        found.unwrap_or_else(|| unreachable!("the table has a row for every law"))
    }
}

/// The part of a run that left the range of a law; the indices point into the [`fenderline_world::setup::Setup`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The run as a whole, without a particular body, fender or vessel.
    Run,
    /// Two bodies.
    Bodies([usize; 2]),
    /// A fender.
    Fender(usize),
    /// A vessel.
    Vessel(usize),
    /// A ratio of a vessel's dimensions, such as length over beam.
    Ratio {
        /// The vessel.
        vessel: usize,
        /// Index into [`fenderline_ship::hydro::vessels::Origin::outside`].
        ratio: usize,
    },
    /// A passing ship.
    Passing(usize),
    /// An external program that gives forces, by its index in [`fenderline_world::world::WorldSetup::providers`].
    Provider(usize),
}

/// A law whose range a run left, with the part of the run concerned, the time, and how far the run was outside the
/// range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The law.
    pub law: Law,
    /// The part of the run that left the range of the law, such as a vessel or a fender.
    pub subject: Subject,
    /// Start of the first step in which the run was outside the range of the law (s).
    pub first_s: f64,
    /// How long the run was outside the range of the law in all (s).
    pub lasting_s: f64,
    /// `lasting_s` divided by the time of the run so far; 1 if the law was left from start to end.
    pub share_of_run: f64,
    /// Two numbers that say how far the run was outside the range of the law. The meaning of the two numbers in
    /// `extent` depends on the law:
    ///
    /// | law | first | second |
    /// |---|---|---|
    /// | deep overlap | largest share of the smaller body's area that overlapped | greatest depth (m) |
    /// | energy gained | energy that contacts returned beyond the energy absorbed (J) | energy absorbed (J) |
    /// | fender angle | greatest angle (rad) | last angle that the fender's data cover (rad) |
    /// | fender speed | shortest compression time (s) | first compression time of the fender's data (s) |
    /// | waves | share of the sea's energy outside the data | 0 |
    /// | depth of hydrodynamic data | depth of the data (m; infinite: deep) | depth of the run (m; infinite: deep) |
    /// | shallow water, depth for squat | least or greatest depth of water over draught | end of the range |
    /// | squat speed, speed of a passing ship | speed divided by that of long waves | end of the range |
    /// | shape of a passing ship | length over beam | end of the range |
    /// | flow left out | least gap between the vessels' sides, over the mean of their beams | end of the range |
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
