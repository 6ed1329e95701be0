//! The verdict on a run: everything that an engineer must know before a number of the run is used.
//!
//! A run collects [`Finding`]s: a hull on structure, a fender beyond its rating, a line that parted. The [`Verdict`] on
//! the run is the worst of its findings. Terminal, exit code, `summary.json`, report, Python and the live pages all
//! show the same verdict.
//!
//! | file | content |
//! |---|---|
//! | `verdict/finding.rs` | the findings that a run can have, and the sentence of each finding |
//! | `verdict/factored.rs` | findings that result from the user's partial factors |
//! | `verdict/fender.rs` | findings on a single fender |
//! | `verdict/watch.rs` | the totals that a run keeps, step by step, for its verdict |
//! | `verdict/law.rs` | the table of all physical laws and data whose range a run can leave |
//! | `verdict/departures.rs` | finds, step by step, where a run leaves the range of its laws and its data |
//! | `verdict/said.rs` | the sentences on the laws whose range a run has left |
//! | `verdict/start.rs` | bodies that start inside each other |

mod departures;
mod factored;
mod fender;
mod finding;
mod law;
mod said;
mod start;
mod watch;

pub use fender::fender_finding;
pub use finding::Finding;
pub use law::{Departure, Law, LawRow, Subject};
pub use start::starts_inside;
pub use watch::Watch;

/// All verdicts on a run, ordered from best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Nothing was found.
    AllWell,
    /// The scenario has fenders, but the run touched none of them.
    NoFenderTouched,
    /// Bodies touched, and no permissible load is given for their contact: a fender without rating, or hulls without a
    /// fender between them.
    NotRated,
    /// A formula was used a little outside its range, or in a range in which the error of the formula is not known.
    Extrapolated,
    /// A fender took more energy or reaction than its catalogue's rating, but stayed within its rating with the factors
    /// of the run.
    AboveCatalogue,
    /// The brake of a line's winch rendered: the drum slipped and let line out.
    LineRendered,
    /// An anchor dragged.
    AnchorDragged,
    /// The run left the range of its data. The run used the value at the end of the data.
    OutsideData,
    /// The pressure of a fender on the hull was above the permissible pressure.
    HullPressure,
    /// A line could not be made fast.
    LineNotMadeFast,
    /// A line was above its working load.
    LineOverWorking,
    /// A hull passed above or below a fender: the hull has no side at the height of the fender.
    NoSideAtFender,
    /// Deflection, reaction or energy of a fender was beyond its rating.
    FenderOverRated,
    /// A limit of the scenario on motions, lines or fenders was exceeded.
    LimitExceeded,
    /// A vessel was aground.
    Aground,
    /// Bodies started the run inside each other: forces and energies of the first contact have no meaning.
    StartInside,
    /// The coupled solve of a contact did not converge within its iteration limit.
    NotConverged,
    /// Contacts returned more energy than they absorbed.
    EnergyGained,
    /// A line parted.
    LineParted,
    /// An anchor was lost with its chain: the chain parted or ran out.
    AnchorLost,
    /// The pile of a flexible dolphin yielded.
    PileYielded,
    /// A fender was compressed to its stop, or to its whole projection.
    FenderFailed,
    /// A hull struck a structure that fenders should protect.
    StructureStruck,
    /// Bodies overlapped so deeply that the force law does not apply: the results are not valid.
    OutsideForceLaw,
}

/// How grave a verdict is, in four grades.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Gravity {
    /// Within all limits.
    Ok,
    /// The run has something that a user should know, but no limit was exceeded.
    Note,
    /// A limit was exceeded, or the result is in doubt.
    Attention,
    /// Something broke or was struck, or the results are not valid. `fenderline run` ends with exit code 1.
    Failed,
}

impl Verdict {
    /// All verdicts, from best to worst.
    pub const ALL: [Verdict; 24] = [
        Verdict::AllWell,
        Verdict::NoFenderTouched,
        Verdict::NotRated,
        Verdict::Extrapolated,
        Verdict::AboveCatalogue,
        Verdict::LineRendered,
        Verdict::AnchorDragged,
        Verdict::OutsideData,
        Verdict::HullPressure,
        Verdict::LineNotMadeFast,
        Verdict::LineOverWorking,
        Verdict::NoSideAtFender,
        Verdict::FenderOverRated,
        Verdict::LimitExceeded,
        Verdict::Aground,
        Verdict::StartInside,
        Verdict::NotConverged,
        Verdict::EnergyGained,
        Verdict::LineParted,
        Verdict::AnchorLost,
        Verdict::PileYielded,
        Verdict::FenderFailed,
        Verdict::StructureStruck,
        Verdict::OutsideForceLaw,
    ];

    /// The verdict on a list of findings: the worst of them.
    #[must_use]
    pub fn of(findings: &[Finding]) -> Verdict {
        findings.iter().map(Finding::verdict).max().unwrap_or(Verdict::AllWell)
    }

    /// The verdict in words that people read.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Verdict::AllWell => "All well",
            Verdict::NoFenderTouched => "No fender was touched",
            Verdict::NotRated => "No limit exceeded; some loads have no rating",
            Verdict::Extrapolated => "No limit exceeded; a formula was extrapolated",
            Verdict::AboveCatalogue => "Fender above its catalogue rating",
            Verdict::LineRendered => "A winch rendered",
            Verdict::AnchorDragged => "An anchor dragged",
            Verdict::NotConverged => "Not valid: the contact solve did not converge",
            Verdict::EnergyGained => "Not valid: contacts created energy",
            Verdict::OutsideData => "Outside the range of its data",
            Verdict::HullPressure => "Permissible hull pressure exceeded",
            Verdict::LineNotMadeFast => "Line could not be made fast",
            Verdict::LineOverWorking => "Line over its working load",
            Verdict::NoSideAtFender => "A fender met no side of a hull",
            Verdict::FenderOverRated => "Fender over its rating",
            Verdict::LimitExceeded => "A limit of the scenario exceeded",
            Verdict::Aground => "Aground",
            Verdict::StartInside => "Bodies start inside each other",
            Verdict::LineParted => "Line parted",
            Verdict::AnchorLost => "Anchor lost",
            Verdict::PileYielded => "Pile yielded",
            Verdict::FenderFailed => "Fender failed",
            Verdict::StructureStruck => "Structure struck",
            Verdict::OutsideForceLaw => "Not valid: bodies overlap too deeply",
        }
    }

    /// The key of the verdict in files and in messages of programs.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Verdict::AllWell => "all_well",
            Verdict::NoFenderTouched => "no_fender_touched",
            Verdict::NotRated => "not_rated",
            Verdict::Extrapolated => "extrapolated",
            Verdict::AboveCatalogue => "fender_above_catalogue",
            Verdict::LineRendered => "line_rendered",
            Verdict::AnchorDragged => "anchor_dragged",
            Verdict::NotConverged => "not_converged",
            Verdict::EnergyGained => "energy_gained",
            Verdict::OutsideData => "outside_data",
            Verdict::HullPressure => "hull_pressure_exceeded",
            Verdict::LineNotMadeFast => "line_not_made_fast",
            Verdict::LineOverWorking => "line_over_working_load",
            Verdict::NoSideAtFender => "no_side_at_fender",
            Verdict::FenderOverRated => "fender_over_rated",
            Verdict::LimitExceeded => "limit_exceeded",
            Verdict::Aground => "aground",
            Verdict::StartInside => "start_inside",
            Verdict::LineParted => "line_parted",
            Verdict::AnchorLost => "anchor_lost",
            Verdict::PileYielded => "pile_yielded",
            Verdict::FenderFailed => "fender_failed",
            Verdict::StructureStruck => "structure_struck",
            Verdict::OutsideForceLaw => "outside_force_law",
        }
    }

    /// Returns true if the run left a law or the range of its data, so that the results are not valid or in doubt.
    #[must_use]
    pub fn is_of_law(self) -> bool {
        Law::TABLE.iter().any(|row| row.verdict == self)
    }

    /// The gravity of this verdict.
    #[must_use]
    pub fn gravity(self) -> Gravity {
        match self {
            Verdict::AllWell => Gravity::Ok,
            Verdict::NoFenderTouched
            | Verdict::NotRated
            | Verdict::Extrapolated
            | Verdict::AboveCatalogue
            | Verdict::LineRendered
            | Verdict::AnchorDragged => Gravity::Note,
            Verdict::OutsideData
            | Verdict::HullPressure
            | Verdict::LineNotMadeFast
            | Verdict::LineOverWorking
            | Verdict::NoSideAtFender
            | Verdict::FenderOverRated
            | Verdict::LimitExceeded
            | Verdict::Aground
            | Verdict::StartInside => Gravity::Attention,
            Verdict::NotConverged
            | Verdict::EnergyGained
            | Verdict::LineParted
            | Verdict::AnchorLost
            | Verdict::PileYielded
            | Verdict::FenderFailed
            | Verdict::StructureStruck
            | Verdict::OutsideForceLaw => Gravity::Failed,
        }
    }
}

impl Gravity {
    /// The key of the gravity in files and in messages of programs.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Gravity::Ok => "ok",
            Gravity::Note => "note",
            Gravity::Attention => "attention",
            Gravity::Failed => "failed",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_of_verdicts_is_in_order_and_a_worse_verdict_is_at_least_as_grave() {
        assert!(Verdict::ALL.is_sorted());
        assert!(Verdict::ALL.map(Verdict::gravity).is_sorted());
    }
}
