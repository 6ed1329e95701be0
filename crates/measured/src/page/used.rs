//! How far the fenders are used.

use fenderline_report::plot::{Bars, Group};
use maud::{Markup, html};

use crate::berthing::Berthings;

/// The section with the largest use of each fender, and how often it was the first and the most used.
pub(super) fn section(berthings: &Berthings) -> Markup {
    let Some(berth) = berthings.berths.first() else { return html! {} };
    let runs: Vec<_> =
        berthings.all.iter().filter_map(|own| Some((own, own.run.as_ref().ok()?))).collect();
    let groups = berth.setup.fenders.iter().enumerate().map(|(index, fender)| {
        let rated = fender.rated;
        let most = |of: &dyn Fn(&crate::run::FenderUse) -> f64, whole: Option<f64>| {
            let uses = runs.iter().flat_map(|(_, run)| run.fenders.iter());
            let values = uses.filter(|own| own.fender == index).map(of);
            let largest = values.max_by(f64::total_cmp);
            largest.zip(whole).map(|(value, whole)| 100.0 * value / whole)
        };
        Group {
            name: fender.name.clone(),
            values: vec![
                most(&|own| own.energy_j, rated.map(|rated| rated.energy_j)),
                most(&|own| own.reaction_n, rated.map(|rated| rated.reaction_n)),
                most(&|own| own.deflection_m, rated.map(|rated| rated.deflection_m)),
            ],
        }
    });
    let bars = Bars {
        title: "Largest use of each fender in all runs, as a share of its catalogue rating".to_owned(),
        kinds: vec!["energy", "reaction", "deflection"],
        groups: groups.collect(),
        axis: "share of the rating [%]",
        note: "The most compressed cone decides for a panel on several cones. Corrections for temperature and speed are \
               in the column `most_used_share` of the table, not in these bars."
            .to_owned(),
    };
    let firsts = berth.setup.fenders.iter().enumerate().filter_map(|(index, fender)| {
        let count = berthings.all.iter().filter(|own| own.touch.fender == index).count();
        (count > 0).then(|| format!("{} ({count})", fender.name))
    });
    let firsts: Vec<String> = firsts.collect();
    html! {
        @if !runs.is_empty() {
            h2 { "Use of the fenders" }
            p { "First touched, with the number of berthings: " (firsts.join(", ")) "." }
            (bars.render())
        }
    }
}
