//! The verdict of a run on a fender.

use fenderline_sim::{FenderSetup, FenderSummary, Finding, fender_finding};

/// The verdict on a touched fender, from best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FenderVerdict {
    /// No rating given.
    NotRated,
    /// The fender stayed within its rating and within the permissible hull pressure.
    Ok,
    /// The fender stayed within its rating, but exceeded the permissible hull pressure.
    HullPressure,
    /// Deflection, reaction or energy of the fender was beyond the rating.
    OverRated,
    /// The fender was compressed to its stop, or by its whole projection.
    Failed,
}

impl FenderVerdict {
    /// The verdict on a fender after a run.
    pub fn of(setup: &FenderSetup, summary: &FenderSummary) -> FenderVerdict {
        match fender_finding(summary, setup) {
            Some(Finding::FenderFailed { .. }) => FenderVerdict::Failed,
            Some(Finding::FenderOverRated { .. }) => FenderVerdict::OverRated,
            Some(Finding::HullPressure { .. }) => FenderVerdict::HullPressure,
            Some(_) => FenderVerdict::NotRated,
            None => FenderVerdict::Ok,
        }
    }

    /// The verdict in words.
    pub fn text(self) -> &'static str {
        match self {
            FenderVerdict::NotRated => "not rated",
            FenderVerdict::Ok => "OK",
            FenderVerdict::HullPressure => "hull pressure",
            FenderVerdict::OverRated => "over rated",
            FenderVerdict::Failed => "FAILED",
        }
    }

    /// The verdict in `summary.json`.
    pub fn key(self) -> &'static str {
        match self {
            FenderVerdict::NotRated => "not_rated",
            FenderVerdict::Ok => "ok",
            FenderVerdict::HullPressure => "hull_pressure_exceeded",
            FenderVerdict::OverRated => "over_rated",
            FenderVerdict::Failed => "failed",
        }
    }

    /// Whether the verdict needs attention.
    pub fn is_grave(self) -> bool {
        self >= FenderVerdict::HullPressure
    }
}

/// Indices into `fenders` from the most used to the least used: failed fenders first, then by share of rating, then by
/// reaction.
pub fn worst_first(setups: &[FenderSetup], fenders: &[FenderSummary]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..fenders.len()).collect();
    order.sort_by(|&i, &j| {
        let [a, b] = [i, j].map(|k| &fenders[k]);
        let failed =
            [a, b].map(|f| FenderVerdict::of(&setups[f.fender], f) == FenderVerdict::Failed);
        let used = [a, b].map(|f| f.governing().map_or(0.0, |(_, share)| share));
        failed[1]
            .cmp(&failed[0])
            .then(used[1].total_cmp(&used[0]))
            .then(b.peak_reaction_n.total_cmp(&a.peak_reaction_n))
    });
    order
}
