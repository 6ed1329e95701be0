//! Motions and summaries of the flexible dolphins in a run.

use fenderline_contact::number::greater;
use fenderline_contact::{Model, PileMotion};

use crate::setup::{BodySetup, Setup};

/// The motion of a dolphin's pile in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DolphinMotion {
    /// Index of the dolphin in [`Setup::bodies`].
    pub body: usize,
    /// Motion of the dolphin's pile.
    pub pile: PileMotion,
}

/// Summary of the deflections, loads and losses of a dolphin's pile in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DolphinSummary {
    /// Index of the dolphin in [`Setup::bodies`].
    pub body: usize,
    /// Largest deflection of the dolphin's head, permanent part included (m).
    pub peak_deflection_m: f64,
    /// Start of the step with the largest deflection (s).
    pub peak_deflection_at_s: f64,
    /// Largest load on the pile (N).
    pub peak_load_n: f64,
    /// Start of the step with the largest load (s).
    pub peak_load_at_s: f64,
    /// Largest energy stored in the bending of the pile (J).
    pub peak_energy_j: f64,
    /// The largest load divided by the yield load, if the yield load is known.
    pub share_of_yield_load: Option<f64>,
    /// Start of the first step in which the pile yielded (s); `None` if the pile did not yield.
    pub yielded_at_s: Option<f64>,
    /// Permanent deflection of the dolphin's head (m).
    pub offset_m: f64,
    /// Energy lost to yielding of the pile (J).
    pub yield_j: f64,
    /// Energy lost to damping of the pile (J).
    pub damping_j: f64,
}

/// The flexible dolphins of a run in the order of the set-up, with their last motions and their summaries.
#[derive(Clone, Debug, Default)]
pub struct Dolphins {
    /// For each dolphin, the number of its pile in the contact engine.
    piles: Vec<usize>,
    /// Motions of the dolphins in the last step.
    pub motions: Vec<DolphinMotion>,
    /// Summaries of the dolphins in the run.
    pub summaries: Vec<DolphinSummary>,
}

impl Dolphins {
    /// Makes the dolphins as they are before the first step. The contact engine lists the piles in the order of the
    /// keys that its model has for the bodies.
    pub fn new(setup: &Setup, model: &Model) -> Dolphins {
        let with_pile = |(body, of): (usize, &BodySetup)| of.dolphin.map(|_| body);
        let bodies: Vec<usize> = setup.bodies.iter().enumerate().filter_map(with_pile).collect();
        let key = |body: usize| model.bodies()[body].key;
        let piles = bodies
            .iter()
            .map(|&body| bodies.iter().filter(|&&other| key(other) < key(body)).count())
            .collect();
        let motion = |&body: &usize| DolphinMotion { body, pile: PileMotion::default() };
        Dolphins {
            piles,
            motions: bodies.iter().map(motion).collect(),
            summaries: bodies.iter().map(|&body| DolphinSummary::new(body)).collect(),
        }
    }

    /// Takes over the motions of the piles in a step of the contact engine.
    pub fn take(&mut self, piles: &[PileMotion]) {
        for (motion, &pile) in self.motions.iter_mut().zip(&self.piles) {
            motion.pile = piles[pile];
        }
    }

    /// Adds the last step to the summaries of the dolphins.
    pub fn summarise(&mut self, setup: &Setup, t_s: f64) {
        for (summary, motion) in self.summaries.iter_mut().zip(&self.motions) {
            let limit_n = setup.bodies[motion.body].dolphin.and_then(|of| of.yield_load_n);
            summary.add(&motion.pile, limit_n, t_s);
        }
    }
}

impl DolphinSummary {
    fn new(body: usize) -> DolphinSummary {
        DolphinSummary {
            body,
            peak_deflection_m: 0.0,
            peak_deflection_at_s: 0.0,
            peak_load_n: 0.0,
            peak_load_at_s: 0.0,
            peak_energy_j: 0.0,
            share_of_yield_load: None,
            yielded_at_s: None,
            offset_m: 0.0,
            yield_j: 0.0,
            damping_j: 0.0,
        }
    }

    fn add(&mut self, pile: &PileMotion, limit_n: Option<f64>, t_s: f64) {
        if pile.peak_deflection_m > self.peak_deflection_m {
            (self.peak_deflection_m, self.peak_deflection_at_s) = (pile.peak_deflection_m, t_s);
        }
        if pile.peak_load_n > self.peak_load_n {
            (self.peak_load_n, self.peak_load_at_s) = (pile.peak_load_n, t_s);
        }
        self.peak_energy_j = greater(self.peak_energy_j, pile.peak_stored_j);
        self.share_of_yield_load = limit_n.map(|limit_n| self.peak_load_n / limit_n);
        if pile.yield_j > 0.0 {
            self.yielded_at_s.get_or_insert(t_s);
        }
        self.offset_m = pile.offset_m.length();
        self.yield_j += pile.yield_j;
        self.damping_j += pile.damping_j;
    }
}
