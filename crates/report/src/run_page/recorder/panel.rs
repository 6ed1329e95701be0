//! Records panels on several cones and chains for the report.

use fenderline_sim::{Setup, StepRecord};

use super::FOLLOWED;
use crate::plot::Decimator;

/// The turn of a panel over time.
pub(in crate::run_page) struct PanelTrace {
    /// Index of the fender among the set-up's fenders.
    pub(in crate::run_page) fender: usize,
    /// Turn of the panel at the start of each time step (rad); 0 while no hull presses the panel.
    pub(in crate::run_page) tilt_rad: Decimator,
}

/// The tension of a chain over time.
pub(in crate::run_page) struct ChainTrace {
    /// Index of the fender among the set-up's fenders.
    pub(in crate::run_page) fender: usize,
    /// Index of the chain among the fender's chains.
    pub(in crate::run_page) chain: usize,
    /// Largest tension of the chain within each time step (N).
    pub(in crate::run_page) tension_n: Decimator,
}

/// The panels and chains of a set-up that are recorded.
#[derive(Default)]
pub(in crate::run_page) struct Held {
    pub(in crate::run_page) panels: Vec<PanelTrace>,
    pub(in crate::run_page) chains: Vec<ChainTrace>,
}

impl Held {
    pub(super) fn new(setup: &Setup) -> Held {
        let fenders = || setup.fenders.iter().enumerate();
        let panels = fenders()
            .filter(|(_, of)| of.panel.is_some())
            .map(|(fender, _)| PanelTrace { fender, tilt_rad: Decimator::new() });
        let chains =
            fenders().flat_map(|(fender, of)| (0..of.chains.len()).map(move |c| (fender, c)));
        let chains =
            chains.map(|(fender, chain)| ChainTrace { fender, chain, tension_n: Decimator::new() });
        Held { panels: panels.take(FOLLOWED).collect(), chains: chains.take(FOLLOWED).collect() }
    }

    pub(super) fn push(&mut self, step: &StepRecord<'_>) {
        for trace in &mut self.panels {
            let own = step.panels.iter().filter(|motion| motion.fender.0 as usize == trace.fender);
            let most = own.max_by(|a, b| a.tilt_rad.abs().total_cmp(&b.tilt_rad.abs()));
            trace.tilt_rad.push(step.t_s, most.map_or(0.0, |motion| motion.tilt_rad));
        }
        for trace in &mut self.chains {
            let is_own = |of: &&fenderline_sim::ChainTension| {
                (of.fender, of.chain) == (trace.fender, trace.chain)
            };
            let now = step.chains.iter().find(is_own);
            trace.tension_n.push(step.t_s, now.map_or(0.0, |now| now.peak_tension_n));
        }
    }
}
