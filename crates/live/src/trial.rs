//! Trial manoeuvres. In a trial, orders are given to a copy of the run, to see where they would take the ships. A trial
//! does not change the run itself.

use fenderline_sim::{Gravity, Simulation};

use crate::action::{Action, OtherAction};
use crate::carry_out::carry_out;
use crate::limits::MOST_TRIAL_ORDERS;
use crate::message::{Reply, ShipPath};
use crate::now::Now;
use crate::prediction::Prediction;
use crate::refusal::Refusal;
use crate::session::Session;

/// Number of positions of a ship's path in a trial, not counting the present position.
const POSITIONS: f64 = 60.0;

/// A copy of the run to which orders were given. The copy of a trial can run ahead, also on another thread.
#[derive(Clone, Debug)]
pub struct Trial {
    prediction: Prediction,
    horizon_s: f64,
    /// The findings of the verdict on the run before the trial.
    known: Vec<String>,
}

impl Session {
    /// Begins a trial in the present state of the session. A trial may also begin while the run is rewound. The orders
    /// are given at once to a copy of the run, by the rules of real orders. The trial looks
    /// `horizon_s` seconds of simulated time ahead.
    ///
    /// # Errors
    /// Fails for a horizon beyond the limits, or with the reason why one of the orders was refused.
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

    /// Checks that the orders can be given now one after the other, by giving them to a copy of the run. Returns the
    /// copy.
    ///
    /// # Errors
    /// Fails if there are no orders or too many, or if one of the commands is not an order. If an order was refused,
    /// the error is the reason, with the number of the order if there are several.
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

    /// Gives several orders in the session and records them. Either all of the orders are given or none of them.
    /// Returns their tick.
    ///
    /// # Errors
    /// Fails as [`Session::trial`] and [`Session::command`] do.
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
    /// Runs the copy of the trial up to the time that the trial looks ahead. The function `watch` gets the answer so
    /// far at each new position. If `watch` returns false, the trial stops early and its answer is not complete.
    #[must_use]
    pub fn run(mut self, id: i64, mut watch: impl FnMut(&[ShipPath]) -> bool) -> Reply {
        let tick = self.prediction.tick();
        let (horizon_s, every_s) = (self.horizon_s, self.horizon_s / POSITIONS);
        let (paths, complete) = self.prediction.advance(horizon_s, every_s, &mut watch);
        let all = findings(self.prediction.simulation());
        let findings = all.into_iter().filter(|text| !self.known.contains(text)).collect();
        Reply::Trial { id, tick, horizon_s, complete, paths, findings }
    }

    /// Leaves the paths of the vessels `vessels` out of the answer, such as vessels that fog hides.
    pub fn leave_out(&mut self, vessels: &[usize]) {
        self.prediction.leave_out(vessels);
    }

    /// The answer of a trial that still runs: its paths so far.
    #[must_use]
    pub fn so_far(id: i64, tick: u64, horizon_s: f64, paths: &[ShipPath]) -> Reply {
        let (paths, findings) = (paths.to_vec(), Vec::new());
        Reply::Trial { id, tick, horizon_s, complete: false, paths, findings }
    }

    /// The tick at which the trial begins.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.prediction.tick()
    }

    /// The time that the trial looks ahead (s).
    #[must_use]
    pub fn horizon_s(&self) -> f64 {
        self.horizon_s
    }
}

/// The findings about what went wrong in a run, in sentences.
fn findings(simulation: &Simulation) -> Vec<String> {
    let findings = simulation.findings();
    let grave = findings.iter().filter(|finding| {
        matches!(finding.verdict().gravity(), Gravity::Attention | Gravity::Failed)
    });
    grave.map(|finding| finding.sentence(simulation.setup())).collect()
}
