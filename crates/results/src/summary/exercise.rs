//! The exercise in `summary.json`.

use fenderline_sim::Setup;
use fenderline_sim::exercise::{Assessment, Deduction, Limit, Mark};

use crate::json::{Json, object};

pub(super) fn exercise_json(exercise: &Assessment, setup: &Setup) -> Json {
    let of = exercise.setup();
    let goal: Vec<Json> = of
        .goal
        .iter()
        .zip(exercise.conditions())
        .map(|(condition, now)| {
            object!({ "text": condition.words(), "met": now.is_met, "now": now.now })
        })
        .collect();
    let deductions: Vec<Deduction<'_>> = exercise.deductions().collect();
    let limits: Vec<Json> = of
        .limits
        .iter()
        .zip(exercise.marks())
        .map(|(limit, mark)| {
            let deduction = deductions.iter().find(|deduction| deduction.limit == limit);
            limit_json(limit, mark, deduction, setup)
        })
        .collect();
    let mut object = object!({
        "task": of.task,
        "goal": goal,
        "state": exercise.state().word(),
        "score": exercise.score(),
        "pass_mark": of.pass_mark,
        "limits": limits,
    });
    if let Some(ended_s) = exercise.state().ended_s() {
        object.put("ended_s", ended_s);
    }
    if let Some(passed) = exercise.is_passed() {
        object.put("passed", passed);
    }
    object
}

fn limit_json(
    limit: &Limit,
    mark: &Mark,
    deduction: Option<&Deduction<'_>>,
    setup: &Setup,
) -> Json {
    let bound = if limit.measure.is_least() { "least" } else { "most" };
    let mut object = object!({
        "of": limit.measure.key(),
        "unit": limit.measure.unit(),
        bound: limit.bound,
        "worst": limit.worst,
        "points": limit.points,
        "fails": limit.fails,
        "exceeded": deduction.is_some(),
        "deducted": deduction.map_or(0.0, |of| of.points),
    });
    if limit.within_m.is_finite() {
        object.put("within_m", limit.within_m);
    }
    if let Some((value, subject, at_s)) = mark.worst {
        object.put("value", value);
        object.put("at_s", at_s);
        object.put("by", subject.name(setup));
    }
    if let (Some(first_s), Some(deduction)) = (mark.first_s, deduction) {
        object.put("first_exceeded_s", first_s);
        object.put("exceeded_for_s", mark.lasting_s);
        object.put("text", deduction.sentence(setup));
    }
    object
}
