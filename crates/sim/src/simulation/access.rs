//! Functions that read a run, and that change it between steps.

use fenderline_contact::{BodyState, Contact, Memory, Model, Wrench};

use super::Simulation;
use super::check::whole_steps;
use fenderline_assess::berthing::BerthingOutcome;
use fenderline_assess::gain::{EnergyGain, REPORTED_GAIN};
use fenderline_assess::statistics::Statistics;
use fenderline_assess::summary::PairSummary;
use fenderline_assess::verdict::{Finding, Verdict};
use fenderline_ship::anchor::{AnchorFaults, AnchorState};
use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::wind::Wind;
use fenderline_ship::step_time::StepTime;
use fenderline_world::berthing::BerthingError;
use fenderline_world::dolphin::DolphinSummary;
use fenderline_world::error::SetupError;
use fenderline_world::fender::FenderSummary;
use fenderline_world::ledger::Bodies;
use fenderline_world::order::{Action, LineAction, Order, OrderError, VesselAction, check_order};
use fenderline_world::record::Energy;
use fenderline_world::setup::{Integrator, Method, Setup};
use fenderline_world::world::Sending;
use fenderline_world::world::{AnchorAtWork, Assist, Faults, Job, Mooring, TugAtWork, VesselState};

impl Simulation {
    /// The set-up of the run.
    #[must_use]
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The contact model that was built from the set-up.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Number of steps in the run.
    #[must_use]
    pub fn steps_total(&self) -> u64 {
        self.steps_total
    }

    /// Number of steps taken.
    #[must_use]
    pub fn steps_taken(&self) -> u64 {
        self.index
    }

    /// Number of steps from the start of the run up to and including the step that contains the time `t_s` (s).
    #[must_use]
    pub fn steps_until(&self, t_s: f64) -> u64 {
        whole_steps(t_s / self.setup.step_s)
    }

    /// Returns true after the last step of the run.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.index >= self.steps_total
    }

    /// Current time of the run (s), computed as steps taken times Δt, so that rounding does not accumulate.
    #[must_use]
    pub fn time_s(&self) -> f64 {
        self.index as f64 * self.setup.step_s
    }

    /// The time to which the velocities in [`Simulation::states`] belong (s). In the coupled method with the
    /// semi-implicit integrator the motion is a leapfrog scheme: velocities belong to the middle of the last step, or
    /// to the middle of its last sub-step if contacts needed several sub-steps. Otherwise this is
    /// [`Simulation::time_s`].
    #[must_use]
    pub fn velocity_time_s(&self) -> f64 {
        let is_leapfrog = self.setup.integrator == Integrator::SemiImplicit
            && self.setup.method == Method::Coupled;
        if is_leapfrog && self.index > 0 {
            (self.index as f64 - 0.5) * self.setup.step_s
        } else {
            self.time_s()
        }
    }

    /// Current states of the bodies, in the order of the set-up. The velocities in these states belong to the time
    /// [`Simulation::velocity_time_s`].
    #[must_use]
    pub fn states(&self) -> &[BodyState] {
        &self.states
    }

    /// The current memory of the contact engine in this simulation.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// The current energy ledger.
    #[must_use]
    pub fn energy(&self) -> Energy {
        let (order, inertias) = (&self.world.order.bodies, &self.inertias);
        self.ledger.energy(Bodies { order, inertias, states: &self.states })
    }

    /// The energy that contacts created in the run, if it is large enough to be reported. The method of Moreno et al.
    /// (2023) creates energy, because its forces are explicit, and a stiff spring acts for too long in a long step.
    /// [`Method::Coupled`] bounds the energy that each contact returns, and this function checks the coupled method
    /// too.
    #[must_use]
    pub fn energy_gain(&self) -> Option<EnergyGain> {
        let Energy { contact_taken_j: taken_j, contact_gained_j: gained_j, .. } = self.energy();
        let is_reported = gained_j > REPORTED_GAIN * taken_j;
        is_reported.then_some(EnergyGain { gained_j, taken_j })
    }

    /// Summaries of the pairs of bodies that touched, in the order of first touch.
    #[must_use]
    pub fn pair_summaries(&self) -> &[PairSummary] {
        &self.summaries.pairs
    }

    /// Summaries of the fenders that were touched, in the order of the set-up.
    pub fn fender_summaries(&self) -> impl Iterator<Item = &FenderSummary> {
        self.fender_summaries.all.iter().flatten()
    }

    /// Summaries of the flexible dolphins, in the order of the set-up.
    #[must_use]
    pub fn dolphin_summaries(&self) -> &[DolphinSummary] {
        &self.dolphins.summaries
    }

    /// The findings in the run so far, the worst first. [`Verdict::of`] gives the verdict.
    #[must_use]
    pub fn findings(&self) -> Vec<Finding> {
        let until_now = (self.time_s(), self.energy_gain().is_some());
        let touched = (self.fender_summaries(), self.sides.missed());
        let piles = self.dolphins.summaries.as_slice();
        let mut all = self.watch.findings(&self.setup, touched, piles, until_now);
        let limits = &self.setup.world.statistics.limits;
        let exceeded = self.limit_values().into_iter().zip(limits).enumerate();
        let exceeded = exceeded.filter(|(_, (value, limit))| *value > limit.most);
        all.extend(exceeded.map(|(limit, (value, _))| Finding::LimitExceeded { limit, value }));
        all.sort_by_key(|finding| core::cmp::Reverse(finding.verdict()));
        all
    }

    /// Notes that an external program that gives forces has not replied for the coming step. The results of the run are
    /// then in doubt, and the verdict says so.
    ///
    /// # Panics
    /// Panics if the set-up has no such provider of forces.
    pub fn note_silent_provider(&mut self, provider: usize) {
        assert!(provider < self.setup.world.providers.len(), "the set-up has it");
        let t_s = self.time_s();
        self.watch.note_silent_provider(provider, t_s);
    }

    /// Statistics of motions and lines so far; `None` if the set-up asks for no statistics.
    #[must_use]
    pub fn statistics(&self) -> Option<&Statistics> {
        self.statistics.as_ref()
    }

    /// The values of the run that are compared with the limits of the set-up, in the order of the limits; empty without
    /// limits.
    #[must_use]
    pub fn limit_values(&self) -> Vec<f64> {
        let Some(statistics) =
            self.statistics.as_ref().filter(|_| !self.setup.world.statistics.limits.is_empty())
        else {
            return Vec::new();
        };
        let tensions = self.watch.peak_tensions_n();
        statistics.values(&self.setup, &tensions, self.fender_summaries())
    }

    /// Findings on bodies that start inside each other; empty in a sound scenario. The findings on the start of a run
    /// are known before the first step.
    #[must_use]
    pub fn start_findings(&self) -> &[Finding] {
        self.watch.starts()
    }

    /// The verdict on the run so far.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        Verdict::of(&self.findings())
    }

    /// The current state of the vessels, in the order of the set-up.
    #[must_use]
    pub fn vessels(&self) -> &[VesselState] {
        &self.world.vessels
    }

    /// The current state of the tugs, in the order of the set-up.
    #[must_use]
    pub fn tugs(&self) -> &[TugAtWork] {
        &self.world.tugs
    }

    /// The current state of the mooring lines, in the order of the set-up.
    #[must_use]
    pub fn lines(&self) -> &[Mooring] {
        &self.world.lines
    }

    /// The current state of the anchors, in the order of the set-up.
    #[must_use]
    pub fn anchors(&self) -> &[AnchorAtWork] {
        &self.world.anchors
    }

    /// Contact wrenches on the bodies in the last step; zero before the first step.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        self.work.wrenches()
    }

    /// The contacts of the last step.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        self.work.contacts()
    }

    /// The results of the simulated berthing, compared with the berthing formulas. Returns `None` if the set-up has no
    /// berthing, or if no fender was touched yet. Returns an error if the ship or the speed is outside the range of the
    /// formulas.
    #[must_use]
    pub fn berthing(&self) -> Option<Result<&BerthingOutcome, &BerthingError>> {
        self.study.as_ref()?.outcome.as_ref().map(Result::as_ref)
    }

    /// Sets an external wrench on each body, such as forces of another program, a controller or a model of the caller.
    /// The external wrenches act from the next step on, until they are set again.
    ///
    /// # Panics
    /// Panics if the number of wrenches is not the number of bodies, or if a wrench is not finite.
    pub fn set_external(&mut self, wrenches: &[Wrench]) {
        assert_eq!(wrenches.len(), self.states.len(), "one wrench per body");
        for wrench in wrenches {
            assert!(wrench.force_n.is_finite() && wrench.moment_nm.is_finite(), "a finite wrench");
        }
        self.buffers.external.copy_from_slice(wrenches);
    }

    /// Gives an order during the run, as a user in manual control does. The simulation carries the order out in the
    /// step that contains the order's time, or in the next step if this time has passed. Of several orders for the same
    /// time, the orders of the set-up come first, and then the other orders in the order in which they were given.
    ///
    /// # Errors
    /// Returns a [`SetupError`] if the order names something that does not exist, if a number is out of its limits, or
    /// if the ship does not have the gear that the order needs. After an error the pending orders are as before the
    /// call.
    pub fn order(&mut self, order: Order) -> Result<(), SetupError> {
        check_order(&order, &self.setup)?;
        self.world.order(order);
        Ok(())
    }

    /// Checks that an order can be carried out in the present state of the simulation. An order cannot be carried out
    /// if its line is on board or has parted, if the bollard is taken or out of reach, if the anchor is home, down or
    /// lost, or if a station pilot uses the tug. Orders to lines and anchors that wait for the next step count as
    /// carried out in this check. The check does not apply to orders for a later time.
    ///
    /// # Errors
    /// Returns the reason why the order cannot be carried out.
    pub fn check_now(&self, action: &Action) -> Result<(), OrderError> {
        let step = StepTime { t_s: self.time_s(), step_s: self.setup.step_s };
        let lines = self.world.lines_after_orders(&self.setup.world, step);
        let of_line = |line: usize, is_let_go: bool| {
            let Some(own) = lines.get(line) else { return Ok(()) };
            let line = self.setup.world.lines[line].line.name.clone();
            if own.aboard {
                return Err(OrderError::LineAboard { line });
            }
            if own.sent.is_some() && !is_let_go {
                return Err(OrderError::LineUnderWay { line });
            }
            if own.has_parted() && !is_let_go {
                return Err(OrderError::LineParted { line });
            }
            Ok(())
        };
        match action {
            Action::Anchor(anchor, action) if *anchor < self.world.anchors.len() => {
                let own = self.world.anchor_after_orders(&self.setup.world, *anchor, step);
                own.may(&self.setup.world.anchors[*anchor], *action)
            }
            Action::Line(line, LineAction::Winch(_)) => of_line(*line, false),
            Action::Line(line, LineAction::LetGo) => of_line(*line, true),
            Action::Line(line, LineAction::Send { bollard }) => self.world.may_send(
                &lines,
                &self.setup.world,
                &self.states,
                self.time_s(),
                Sending { line: *line, bollard: *bollard },
            ),
            Action::Vessel(_, VesselAction::Assist(Assist { job: Job::Pull { line, .. }, .. })) => {
                of_line(*line, false)
            }
            Action::Tug(tug, _) => {
                let Some(tug) = self.setup.world.tugs.get(*tug) else { return Ok(()) };
                if self.world.vessels[tug.vessel].pilots.station.is_none() {
                    return Ok(());
                }
                let ship = self.setup.world.vessels[tug.vessel].body;
                Err(OrderError::TugOfStation { ship: self.setup.bodies[ship].name.clone() })
            }
            Action::Vessel(..) | Action::Anchor(..) => Ok(()),
        }
    }

    /// Keeps only the pending orders, including those of the set-up, for which `keep` returns true. Call this function
    /// when a user takes manual control, so that planned orders do not interfere.
    pub fn retain_orders(&mut self, keep: impl FnMut(&Order) -> bool) {
        self.world.retain_orders(keep);
    }

    /// The pending orders in order of time, including the orders of the set-up.
    #[must_use]
    pub fn pending_orders(&self) -> &[Order] {
        self.world.pending_orders()
    }

    /// Sets the wind from the next step on; `None` for no wind. The wind jumps to the new value, and a planned change
    /// of the wind over a time ends.
    pub fn set_wind(&mut self, wind: Option<Wind>) {
        self.changes.ramps.wind = None;
        self.setup.world.environment.wind = wind;
        self.world.renew_gusts(&self.setup.world);
    }

    /// Sets the current from the next step on; `None` for no current. The current jumps to the new value, but the jump
    /// itself causes no force by the acceleration of the water: only drag takes ships along.
    pub fn set_current(&mut self, current: Option<Current>) {
        self.changes.ramps.current = None;
        self.setup.world.environment.current = current;
    }

    /// Sets the equipment faults of a vessel, from the next step on.
    ///
    /// # Errors
    /// Returns [`SetupError::BadBody`] if there is no such vessel.
    pub fn set_faults(&mut self, vessel: usize, faults: Faults) -> Result<(), SetupError> {
        let state = self.world.vessels.get_mut(vessel);
        let state = state.ok_or(SetupError::BadBody { owner: "fault", body: vessel })?;
        state.faults = faults;
        Ok(())
    }

    /// Lets a vector tug drop out, or come back, from the next step on. While the tug has dropped out, she carries out
    /// no orders. When the tug comes back, she stands by.
    ///
    /// # Errors
    /// Returns [`SetupError::BadBody`] if there is no such tug.
    pub fn set_tug_out(&mut self, tug: usize, out: bool) -> Result<(), SetupError> {
        let state = self.world.tugs.get_mut(tug);
        state.ok_or(SetupError::BadBody { owner: "fault", body: tug })?.out = out;
        Ok(())
    }

    /// Sets the faults of an anchor and its windlass, from the next step on.
    ///
    /// # Errors
    /// Returns [`SetupError::BadBody`] if there is no such anchor.
    pub fn set_anchor_faults(
        &mut self,
        anchor: usize,
        faults: AnchorFaults,
    ) -> Result<(), SetupError> {
        let own = self.world.anchors.get_mut(anchor);
        let own = own.ok_or(SetupError::BadBody { owner: "fault", body: anchor })?;
        own.state = AnchorState { faults, ..own.state };
        Ok(())
    }

    /// Parts a mooring line, as if it broke. Returns true if there is such a line and it was fast.
    pub fn part_line(&mut self, line: usize) -> bool {
        let line = self.world.lines.get_mut(line).and_then(|line| line.line.as_mut());
        let fast = line.filter(|(_, state)| !state.parted);
        fast.map(|(_, state)| state.parted = true).is_some()
    }
}
