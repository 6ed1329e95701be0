//! The exercise of a session, as pages of the browser get it.

use fenderline_sim::exercise::{AnchorPlace, Assessment, Condition, Deduction, State};
use fenderline_sim::{Setup, Simulation};

use crate::message::{
    ConditionNow, ExerciseInfo, ExerciseMarks, ExerciseNow, LimitInfo, LimitNow, PlaceInfo,
    TensionInfo,
};

/// The text of how an exercise ended, without its score. The text is `None` while the exercise goes on.
pub(crate) fn ending(exercise: &Assessment) -> Option<&'static str> {
    match exercise.state() {
        State::Running => None,
        State::Reached(_) => Some("The exercise has ended: its goal is reached"),
        State::TimeOver(_) => Some("The exercise has ended: its time is over"),
    }
}

/// The data of an exercise that do not change.
pub(crate) fn info(exercise: &Assessment, setup: &Setup) -> ExerciseInfo {
    let of = exercise.setup();
    let ship = setup.world.vessels[of.vessel].body;
    let limits = of.limits.iter().map(|limit| LimitInfo {
        key: limit.measure.key(),
        text: limit.measure.text(),
        rule: limit.words(),
        bound: limit.bound,
        points: limit.points,
        fails: limit.fails,
    });
    ExerciseInfo {
        task: of.task.clone(),
        ship: setup.bodies[ship].name.clone(),
        goal: of.goal.iter().map(|condition| condition.words()).collect(),
        tension: of.goal.iter().find_map(Condition::tensions).map(|(lines, [least_n, most_n])| {
            let most_n = most_n.is_finite().then_some(most_n);
            TensionInfo { lines: lines.to_vec(), least_n, most_n }
        }),
        hold_s: of.hold_s,
        time_limit_s: of.time_limit_s.is_finite().then_some(of.time_limit_s),
        pass_mark: of.pass_mark,
        limits: limits.collect(),
        place: of.goal.iter().find_map(|condition| match condition {
            Condition::AnchorsHold { place, .. } => place.map(|AnchorPlace { at_m, within_m }| {
                PlaceInfo { at_m: [at_m.x, at_m.y], within_m }
            }),
            _ => None,
        }),
        mark: of.mark.as_ref().map(|mark| match mark.name.as_str() {
            "" => "mark".to_owned(),
            name => name.to_owned(),
        }),
        view_marks: of.view_marks,
    }
}

/// The present state of an exercise that everybody sees.
pub(crate) fn now(exercise: &Assessment, simulation: &Simulation) -> ExerciseNow {
    let t_s = simulation.time_s();
    let conditions = exercise.conditions().iter();
    ExerciseNow {
        state: exercise.state().word(),
        ended_s: exercise.state().ended_s(),
        held_s: exercise.held_s(exercise.state().ended_s().unwrap_or(t_s)),
        conditions: conditions
            .map(|of| ConditionNow { met: of.is_met, now: of.now.clone() })
            .collect(),
        to_go_m: exercise.to_go_m(simulation),
    }
}

/// Score and limits of an exercise, which only the instructor gets.
pub(crate) fn marks(exercise: &Assessment, setup: &Setup) -> ExerciseMarks {
    let deductions: Vec<Deduction<'_>> = exercise.deductions().collect();
    let limits = exercise.setup().limits.iter().zip(exercise.marks()).map(|(limit, mark)| {
        let deduction = deductions.iter().find(|of| of.limit == limit);
        LimitNow {
            worst: mark.worst.map(|(value, ..)| limit.measure.value_text(value)),
            exceeded: deduction.is_some(),
            points: deduction.map_or(0.0, |of| of.points),
            why: deduction.map(|of| of.sentence(setup)),
        }
    });
    ExerciseMarks {
        score: exercise.score(),
        passed: exercise.is_passed(),
        limits: limits.collect(),
    }
}
