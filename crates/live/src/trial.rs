//! Trial manoeuvres: orders are given to a copy of the run, to see where they would take the ships. The run does not change.

use fenderline_sim::{Gravity, Simulation};

use crate::action::{Action, OtherAction};
use crate::carry_out::carry_out;
use crate::limits::MOST_TRIAL_ORDERS;
use crate::message::{Reply, ShipPath};
use crate::now::Now;
use crate::prediction::Prediction;
use crate::refusal::Refusal;
use crate::session::Session;

/// Positions of a ship's path in a trial, besides the present one.
const POSITIONS: f64 = 60.0;

/// A copy of the run in which orders were given. It can be run ahead, also on another thread.
#[derive(Clone, Debug)]
pub struct Trial {
    prediction: Prediction,
    horizon_s: f64,
    /// What was found in the run before.
    known: Vec<String>,
}

impl Session {
    /// A trial from the present state, also while the run is rewound: these orders are given at once to a copy of the run, by the
    /// rules of real orders. It ends after `horizon_s`.
    ///
    /// # Errors
    /// A horizon beyond the limits; the reason why one of the orders was refused.
    pub fn trial(&self, orders: &[Action], horizon_s: f64) -> Result<Trial, Refusal> {
        let [least_s, most_s] = crate::COMMAND_LIMITS.trial_s;
        if !(least_s..=most_s).contains(&horizon_s) {
            return Err(Refusal::new(format_args!(
                "a trial looks from {least_s} to {most_s} s ahead"
            )));
        }
        let now = self.with_orders(orders)?;
        let known = findings(&now.simulation);
        let vessels = self.cast().predicted();
        Ok(Trial {
            prediction: Prediction::of(now.simulation, now.tick, vessels),
            horizon_s,
            known,
        })
    }

    /// Checks that these orders can be given now one after the other, on a copy. Returns the copy, in which they are given.
    ///
    /// # Errors
    /// No orders or too many; a command that is no order; the reason why an order was refused, with its number where there are
    /// several.
    pub(crate) fn with_orders(&self, orders: &[Action]) -> Result<Now, Refusal> {
        if orders.is_empty() || orders.len() > MOST_TRIAL_ORDERS {
            return Err(Refusal::new(format_args!(
                "a trial has 1 to {MOST_TRIAL_ORDERS} orders, not {}",
                orders.len()
            )));
        }
        let mut now = self.now().clone();
        for (index, action) in orders.iter().enumerate() {
            let number = |why: &dyn std::fmt::Display| match orders.len() {
                1 => Refusal::new(why),
                _ => Refusal::new(format_args!("order {}: {why}", index + 1)),
            };
            if !matches!(action, Action::Order(_) | Action::Other(OtherAction::Tug { .. })) {
                return Err(number(&"a trial takes orders to ships, tugs and lines only"));
            }
            carry_out(action, self.cast(), &mut now).map_err(|why| number(&why))?;
        }
        Ok(now)
    }

    /// Carries out and records these orders, all of them or none. Returns their tick.
    ///
    /// # Errors
    /// As [`Session::trial`] and [`Session::command`].
    pub fn command_all(
        &mut self,
        who: &str,
        at_ms: u64,
        orders: Vec<Action>,
    ) -> Result<u64, Refusal> {
        self.has_room_for(orders.len())?;
        self.with_orders(&orders)?;
        for order in orders {
            self.command(who, at_ms, order)?;
        }
        Ok(self.tick())
    }
}

impl Trial {
    /// Runs to its horizon. `watch` gets the answer so far at each new position, and ends the run if it returns false. The answer
    /// of a run that ended early is not complete.
    #[must_use]
    pub fn run(mut self, id: i64, mut watch: impl FnMut(&[ShipPath]) -> bool) -> Reply {
        let tick = self.prediction.tick();
        let (horizon_s, every_s) = (self.horizon_s, self.horizon_s / POSITIONS);
        let (paths, complete) = self.prediction.advance(horizon_s, every_s, &mut watch);
        let all = findings(self.prediction.simulation());
        let findings = all.into_iter().filter(|text| !self.known.contains(text)).collect();
        Reply::Trial { id, tick, horizon_s, complete, paths, findings }
    }

    /// Leaves out the paths of these vessels, as those that fog hides.
    pub fn leave_out(&mut self, vessels: &[usize]) {
        self.prediction.leave_out(vessels);
    }

    /// The answer of a run that goes on: paths so far.
    #[must_use]
    pub fn so_far(id: i64, tick: u64, horizon_s: f64, paths: &[ShipPath]) -> Reply {
        let (paths, findings) = (paths.to_vec(), Vec::new());
        Reply::Trial { id, tick, horizon_s, complete: false, paths, findings }
    }

    /// The tick from which it begins.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.prediction.tick()
    }

    /// How far ahead it looks (s).
    #[must_use]
    pub fn horizon_s(&self) -> f64 {
        self.horizon_s
    }
}

/// What went wrong in a run, in sentences.
fn findings(simulation: &Simulation) -> Vec<String> {
    let findings = simulation.findings();
    let grave = findings.iter().filter(|finding| {
        matches!(finding.verdict().gravity(), Gravity::Attention | Gravity::Failed)
    });
    grave.map(|finding| finding.sentence(simulation.setup())).collect()
}
