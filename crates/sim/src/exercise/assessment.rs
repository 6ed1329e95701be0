//! The state of an exercise from step to step, and the score of the exercise.

use std::sync::Arc;

use fenderline_contact::number::greater;

use super::condition::Fulfilled;
use super::limit::{Limit, Measure};
use super::measure::{Subject, worst_now};
use super::words::seconds;
use super::{ExerciseSetup, FULL_SCORE};
use crate::berth::Lie;
use crate::simulation::Simulation;
use fenderline_ship::step_time::StepTime;
use fenderline_world::setup::Setup;

/// Whether an exercise goes on, has reached its goal or has ended by its time limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum State {
    /// The exercise goes on.
    Running,
    /// The goal of the exercise was reached at this time (s). After the goal is reached, nothing more counts in the
    /// exercise.
    Reached(f64),
    /// The time limit of the exercise was reached at this time (s), without the goal.
    TimeOver(f64),
}

impl State {
    /// The word for the state of the exercise in results and messages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            State::Running => "running",
            State::Reached(_) => "reached",
            State::TimeOver(_) => "time_over",
        }
    }

    /// Time at which the exercise ended (s); `None` while the exercise goes on.
    #[must_use]
    pub fn ended_s(self) -> Option<f64> {
        match self {
            State::Running => None,
            State::Reached(at_s) | State::TimeOver(at_s) => Some(at_s),
        }
    }
}

/// What an exercise records for one of its limits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mark {
    /// The worst value of the limit's measure so far, the subject that had this value, and the time of the value (s).
    /// `None` until the limit counts for the first time.
    pub worst: Option<(f64, Subject, f64)>,
    /// Time at which the limit was first exceeded (s).
    pub first_s: Option<f64>,
    /// For how long the limit was exceeded in total (s); 0 for limits on peak values.
    pub lasting_s: f64,
}

/// A deduction from the score of an exercise because a limit was exceeded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deduction<'a> {
    /// The limit of the exercise that was exceeded.
    pub limit: &'a Limit,
    /// The record of the exercise for this limit.
    pub mark: &'a Mark,
    /// The worst value.
    pub value: f64,
    /// The subject that had the worst value, such as the bow or a fender.
    pub subject: Subject,
    /// Time at which the worst value occurred (s).
    pub at_s: f64,
    /// The points deducted.
    pub points: f64,
}

/// An exercise that goes on or has ended. An exercise is plain data, and is copied together with the state of a
/// session.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    setup: Arc<ExerciseSetup>,
    state: State,
    /// Time since which all conditions of the goal hold (s).
    held_since_s: Option<f64>,
    conditions: Vec<Fulfilled>,
    marks: Vec<Mark>,
}

impl Assessment {
    /// Starts an assessment of an exercise, before the first step.
    #[must_use]
    pub fn new(setup: ExerciseSetup, simulation: &Simulation) -> Assessment {
        let marks = vec![Mark::default(); setup.limits.len()];
        let setup = Arc::new(setup);
        let mut assessment = Assessment {
            setup,
            state: State::Running,
            held_since_s: None,
            conditions: Vec::new(),
            marks,
        };
        assessment.conditions = assessment.look(simulation, assessment.lie(simulation).as_ref());
        assessment
    }

    /// Evaluates the state of the simulation after a step. After the end of the exercise the function does nothing.
    pub fn update(&mut self, simulation: &Simulation) {
        if self.state != State::Running {
            return;
        }
        let t_s = simulation.time_s();
        let lie = self.lie(simulation);
        self.conditions = self.look(simulation, lie.as_ref());
        let step_s = simulation.setup().step_s;
        for (limit, mark) in self.setup.limits.iter().zip(&mut self.marks) {
            if let Some((value, subject)) = worst_now(limit, &self.setup, simulation, lie.as_ref())
            {
                mark.add(limit, value, subject, StepTime { t_s, step_s });
            }
        }
        let is_met = self.conditions.iter().all(|condition| condition.is_met);
        self.held_since_s = is_met.then(|| self.held_since_s.unwrap_or(t_s));
        // Half a step is the tolerance: times are sums of steps, with rounding.
        let holds = self
            .held_since_s
            .is_some_and(|since_s| t_s - since_s >= self.setup.hold_s - 0.5 * step_s);
        if holds {
            self.state = State::Reached(t_s);
        } else if t_s >= self.setup.time_limit_s - 0.5 * step_s {
            self.state = State::TimeOver(t_s);
        }
    }

    /// Position and speed of the ship relative to the berth of the exercise.
    fn lie(&self, simulation: &Simulation) -> Option<Lie> {
        let berth = self.setup.berth.as_ref()?;
        let setup = simulation.setup();
        let body = setup.world.vessels[self.setup.vessel].body;
        let states = simulation.states();
        Some(berth.lie(&states[berth.body], &setup.bodies[body].outline, &states[body]))
    }

    fn look(&self, simulation: &Simulation, lie: Option<&Lie>) -> Vec<Fulfilled> {
        let goal = self.setup.goal.iter();
        goal.map(|condition| condition.look(&self.setup, simulation, lie)).collect()
    }

    /// Distance along the berth that the ship has to go ahead until her place is abeam of the mark of the berth (m); negative
    /// astern. `None` if the exercise has no mark.
    #[must_use]
    pub fn to_go_m(&self, simulation: &Simulation) -> Option<f64> {
        let (berth, mark) = (self.setup.berth?, self.setup.mark.as_ref()?);
        let states = simulation.states();
        let ship = simulation.setup().world.vessels[self.setup.vessel].body;
        Some(berth.to_go_m(&states[berth.body], &states[ship], mark.at_m, mark.of_ship_m))
    }

    /// The exercise.
    #[must_use]
    pub fn setup(&self) -> &ExerciseSetup {
        &self.setup
    }

    /// Whether the exercise goes on, has reached its goal or has ended by its time limit.
    #[must_use]
    pub fn state(&self) -> State {
        self.state
    }

    /// The conditions of the goal, each as it is in the present state, or as it was at the end of the exercise.
    #[must_use]
    pub fn conditions(&self) -> &[Fulfilled] {
        &self.conditions
    }

    /// For how long all conditions of the goal have held by the time `t_s` (s).
    #[must_use]
    pub fn held_s(&self, t_s: f64) -> f64 {
        self.held_since_s.map_or(0.0, |since_s| greater(t_s - since_s, 0.0))
    }

    /// The record of the exercise for each limit, in the order of the limits.
    #[must_use]
    pub fn marks(&self) -> &[Mark] {
        &self.marks
    }

    /// The deductions from the score so far, in the order of the limits.
    pub fn deductions(&self) -> impl Iterator<Item = Deduction<'_>> {
        self.setup.limits.iter().zip(&self.marks).filter_map(|(limit, mark)| {
            let (value, subject, at_s) = mark.worst?;
            mark.first_s?;
            let points = limit.points_at(value);
            Some(Deduction { limit, mark, value, subject, at_s, points })
        })
    }

    /// The score of the exercise: 100 less all deductions, at least 0.
    #[must_use]
    pub fn score(&self) -> f64 {
        let points: f64 = self.deductions().map(|deduction| deduction.points).sum();
        greater(FULL_SCORE - points, 0.0)
    }

    /// Returns whether the exercise is passed; `None` while this is not decided. The exercise is failed if the goal is
    /// not reached, or if the score is below the pass mark. If a limit with `fails` is exceeded, the exercise is failed
    /// at once.
    #[must_use]
    pub fn is_passed(&self) -> Option<bool> {
        if self.deductions().any(|deduction| deduction.limit.fails) {
            return Some(false);
        }
        match self.state {
            State::Running => None,
            State::Reached(_) => Some(self.score() >= self.setup.pass_mark),
            State::TimeOver(_) => Some(false),
        }
    }

    /// The result of the exercise in one sentence.
    #[must_use]
    pub fn sentence(&self) -> String {
        let score = format!("score {:.0} of {FULL_SCORE:.0}", self.score());
        let passed = match self.is_passed() {
            Some(true) => ", passed",
            Some(false) => ", not passed",
            None => "",
        };
        match self.state {
            State::Running => format!("Goal not reached yet; {score}{passed}"),
            State::Reached(at_s) => format!("Goal reached at {}; {score}{passed}", seconds(at_s)),
            State::TimeOver(at_s) => {
                format!("Time over at {}, goal not reached; {score}{passed}", seconds(at_s))
            }
        }
    }
}

impl Mark {
    fn add(&mut self, limit: &Limit, value: f64, subject: Subject, step: StepTime) {
        let StepTime { t_s, step_s } = step;
        let is_worse = self.worst.is_none_or(|(worst, ..)| {
            if limit.measure.is_least() { value < worst } else { value > worst }
        });
        if is_worse {
            self.worst = Some((value, subject, t_s));
        }
        if limit.is_exceeded_by(value) {
            self.first_s.get_or_insert(t_s);
            if limit.measure.is_momentary() {
                self.lasting_s += step_s;
            }
        }
    }
}

impl Deduction<'_> {
    /// Says in one sentence what exceeded the limit, by how much and when.
    #[must_use]
    pub fn sentence(&self, setup: &Setup) -> String {
        let measure = self.limit.measure;
        let at = seconds(self.at_s);
        let whose = match self.subject {
            Subject::Ship => String::new(),
            subject => format!(" ({})", subject.name(setup)),
        };
        let text = measure.text();
        let value = measure.value_text(self.value);
        let lasting = if self.mark.lasting_s > 0.0 {
            format!(", exceeded for {}", seconds(self.mark.lasting_s))
        } else {
            String::new()
        };
        match measure {
            Measure::Touch => format!("{text}{whose} at {at}{lasting}"),
            Measure::Time => format!("{text}: {value}, {}", self.limit.words()),
            _ => format!("{text}{whose}: {value} at {at}, {}{lasting}", self.limit.words()),
        }
    }
}
