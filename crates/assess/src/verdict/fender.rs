//! Findings on a fender.

use super::finding::Finding;
use fenderline_world::fender::{FenderSetup, FenderSummary};

/// The least share of the catalogue's rating that counts as above the rating: it is printed as 101 % or more.
const ABOVE_CATALOGUE: f64 = 1.005;

/// The worst finding on this fender after a run; `None` if the fender stayed within its rating and within the
/// permissible hull pressure.
#[must_use]
pub fn fender_finding(summary: &FenderSummary, setup: &FenderSetup) -> Option<Finding> {
    let fender = summary.fender;
    Some(if summary.failed {
        let (at_s, deflection_m) = (summary.peak_deflection_at_s, summary.peak_deflection_m);
        Finding::FenderFailed { fender, at_s, deflection_m }
    } else if let Some((quantity, share)) = summary.governing().filter(|(_, share)| *share > 1.0) {
        Finding::FenderOverRated { fender, quantity, share }
    } else if let Some(share) = summary.share_of_hull_pressure.filter(|share| *share > 1.0) {
        Finding::HullPressure { fender, share }
    } else if setup.rated.is_none() {
        let (peak_reaction_n, at_s) = (summary.peak_reaction_n, summary.peak_reaction_at_s);
        Finding::FenderNotRated { fender, peak_reaction_n, at_s }
    } else {
        return None;
    })
}

/// The quantity (`energy` or `reaction`) that exceeds the catalogue's rating, its share of the catalogue's rating, and
/// its share of the rating with the factors of this run. `None` if the fender stayed within the catalogue's rating. The
/// result is also `None` for a fender that exceeds its rating with the factors of the run too.
///
/// The reaction curve of a fender that buckles can peak a little above the rated reaction. A small peak of the force
/// where a fender buckles does not count as above the catalogue's rating.
fn share_above_catalogue(
    summary: &FenderSummary,
    setup: &FenderSetup,
) -> Option<(&'static str, f64, f64)> {
    if summary.failed || summary.governing()?.1 > 1.0 {
        return None;
    }
    let energy = summary.share_of_catalogue_energy(setup)?;
    let reaction = summary.share_of_catalogue_reaction()?;
    let within_curve = summary.share_of_largest_reaction? * summary.factor <= ABOVE_CATALOGUE;
    let of_energy = ("energy", energy, summary.share_of_rated_energy?);
    let of_reaction = ("reaction", reaction, summary.share_of_rated_reaction?);
    let of_reaction = Some(of_reaction).filter(|_| !within_curve);
    let of_energy = Some(of_energy).filter(|_| energy > ABOVE_CATALOGUE);
    of_energy.into_iter().chain(of_reaction).max_by(|a, b| a.1.total_cmp(&b.1))
}

/// The chains that parted.
pub(super) fn chains_parted(summary: &FenderSummary) -> impl Iterator<Item = Finding> + '_ {
    let fender = summary.fender;
    summary.chains.iter().filter_map(move |chain| {
        let (kind, tension_n) = (chain.kind, chain.peak_tension_n);
        let at_s = chain.parted_at_s?;
        Some(Finding::ChainParted { fender, kind, at_s, tension_n })
    })
}

/// One finding on all fenders that took more than their catalogue's rating but stayed within their rating with the
/// factors of the run. The finding names the fender that is farthest above its catalogue's rating.
pub(super) fn above_catalogue<'a>(
    setups: &[FenderSetup],
    fenders: impl Iterator<Item = &'a FenderSummary>,
) -> Option<Finding> {
    let above =
        fenders.filter_map(|of| Some((of.fender, share_above_catalogue(of, &setups[of.fender])?)));
    let mut number = 0;
    let worst = above.inspect(|_| number += 1).max_by(|a, b| a.1.1.total_cmp(&b.1.1));
    let (fender, (quantity, share, share_of_run)) = worst?;
    Some(Finding::AboveCatalogue { fender, quantity, share, share_of_run, others: number - 1 })
}
