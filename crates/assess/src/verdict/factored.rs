//! Findings that result from the user's partial factors.

use super::finding::{Finding, Subject};
use fenderline_world::factors::{Factored, PartialFactors};
use fenderline_world::fender::FenderSummary;
use fenderline_world::setup::Setup;

/// Findings on loads that exceed the capacity only with the user's partial factors. If the load exceeds the capacity
/// also without the partial factor, another finding reports this.
pub(super) fn factored<'a>(
    setup: &'a Setup,
    fenders: &'a [&'a FenderSummary],
    peaks_n: impl Iterator<Item = f64> + 'a,
) -> impl Iterator<Item = Finding> + 'a {
    let factors = &setup.world.factors;
    let of_fenders = fenders.iter().flat_map(move |fender| of_fender(factors, fender));
    let lines = setup.world.lines.iter().zip(peaks_n).enumerate();
    let of_lines = lines.filter_map(move |(line, (setup, peak_n))| {
        let of = factors.line_load_of(&setup.line.kind, peak_n)?;
        let quantity = factors.line_capacity.words();
        above(of, true).map(|share| found(Subject::Line(line), quantity, of, share))
    });
    of_fenders.chain(of_lines)
}

fn of_fender(factors: &PartialFactors, fender: &FenderSummary) -> Vec<Finding> {
    let subject = Subject::Fender(fender.fender);
    let energy = factors
        .energy_of(fender)
        .and_then(|of| above(of, true).map(|share| found(subject, "rated energy", of, share)));
    let reaction = factors.reaction_of(fender).and_then(|of| {
        above(of, false).map(|share| found(subject, "limit of the reaction", of, share))
    });
    energy.into_iter().chain(reaction).collect()
}

/// The load divided by the capacity, if this share is above 1. With `by_factor` the share is returned only if it is not
/// above 1 without the partial factor.
fn above(of: Factored, by_factor: bool) -> Option<f64> {
    let share = of.share()?;
    (share > 1.0 && !(by_factor && share / of.factor > 1.0)).then_some(share)
}

fn found(subject: Subject, capacity: &'static str, of: Factored, share: f64) -> Finding {
    Finding::AboveWithFactor { subject, capacity, factor: of.factor, share }
}
