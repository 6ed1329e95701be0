//! The verdict of a run on a fender.

use fenderline_contact::number::greater;
use fenderline_sim::{FenderSetup, FenderSummary};

/// The verdict on a touched fender, from best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// No rating given.
    NotRated,
    /// Within its rating, and within the permissible hull pressure.
    Ok,
    /// Within its rating, but above the permissible hull pressure.
    HullPressure,
    /// Deflection, reaction or energy beyond its rating.
    OverRated,
    /// Compressed to its stop, or to its whole projection.
    Failed,
}

impl Verdict {
    /// The verdict on a fender after a run.
    pub fn of(setup: &FenderSetup, summary: &FenderSummary) -> Verdict {
        let is_over = |share: Option<f64>| share.is_some_and(|share| share > 1.0);
        if summary.failed {
            Verdict::Failed
        } else if shares(summary).into_iter().any(is_over) {
            Verdict::OverRated
        } else if is_over(summary.share_of_hull_pressure) {
            Verdict::HullPressure
        } else if setup.rated.is_none() {
            Verdict::NotRated
        } else {
            Verdict::Ok
        }
    }

    /// The verdict in words.
    pub fn text(self) -> &'static str {
        match self {
            Verdict::NotRated => "not rated",
            Verdict::Ok => "OK",
            Verdict::HullPressure => "hull pressure",
            Verdict::OverRated => "over rated",
            Verdict::Failed => "FAILED",
        }
    }

    /// The verdict in `summary.json`.
    pub fn key(self) -> &'static str {
        match self {
            Verdict::NotRated => "not_rated",
            Verdict::Ok => "ok",
            Verdict::HullPressure => "hull_pressure_exceeded",
            Verdict::OverRated => "over_rated",
            Verdict::Failed => "failed",
        }
    }

    /// Whether it needs attention.
    pub fn is_grave(self) -> bool {
        self >= Verdict::HullPressure
    }
}

/// The largest of the shares of rated deflection, reaction and energy that a fender reached; `None` without a rating.
pub fn utilisation(summary: &FenderSummary) -> Option<f64> {
    shares(summary).into_iter().flatten().reduce(greater)
}

/// The quantity that [`utilisation`] is a share of. A cone reaches its rated reaction at half of its rated deflection.
pub fn most_used(summary: &FenderSummary) -> &'static str {
    let most = utilisation(summary);
    let quantities = ["deflection", "reaction", "energy"];
    let found = quantities.into_iter().zip(shares(summary)).find(|(_, share)| *share == most);
    found.map_or("performance", |(quantity, _)| quantity)
}

/// Indices into `fenders` from the most used to the least: failed ones first, then by share of rating,
/// then by reaction.
pub fn worst_first(setups: &[FenderSetup], fenders: &[FenderSummary]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..fenders.len()).collect();
    order.sort_by(|&i, &j| {
        let [a, b] = [i, j].map(|k| &fenders[k]);
        let failed = [a, b].map(|f| Verdict::of(&setups[f.fender], f) == Verdict::Failed);
        let used = [a, b].map(|f| utilisation(f).unwrap_or(0.0));
        failed[1]
            .cmp(&failed[0])
            .then(used[1].total_cmp(&used[0]))
            .then(b.peak_reaction_n.total_cmp(&a.peak_reaction_n))
    });
    order
}

fn shares(summary: &FenderSummary) -> [Option<f64>; 3] {
    [
        summary.share_of_rated_deflection,
        summary.share_of_rated_reaction,
        summary.share_of_rated_energy,
    ]
}
