//! The exercise in `summary.json`.

use fenderline_sim::Setup;
use fenderline_sim::exercise::{Assessment, Deduction, Limit, Mark};
use serde_json::{Value, json};

pub(super) fn exercise_json(exercise: &Assessment, setup: &Setup) -> Value {
    let of = exercise.setup();
    let goal: Vec<Value> = of
        .goal
        .iter()
        .zip(exercise.conditions())
        .map(|(condition, now)| {
            json!({ "text": condition.words(), "met": now.is_met, "now": now.now })
        })
        .collect();
    let deductions: Vec<Deduction<'_>> = exercise.deductions().collect();
    let limits: Vec<Value> = of
        .limits
        .iter()
        .zip(exercise.marks())
        .map(|(limit, mark)| {
            let deduction = deductions.iter().find(|deduction| deduction.limit == limit);
            limit_json(limit, mark, deduction, setup)
        })
        .collect();
    let mut object = json!({
        "task": of.task,
        "goal": goal,
        "state": exercise.state().word(),
        "score": exercise.score(),
        "pass_mark": of.pass_mark,
        "limits": limits,
    });
    if let Some(ended_s) = exercise.state().ended_s() {
        object["ended_s"] = json!(ended_s);
    }
    if let Some(passed) = exercise.is_passed() {
        object["passed"] = json!(passed);
    }
    object
}

fn limit_json(
    limit: &Limit,
    mark: &Mark,
    deduction: Option<&Deduction<'_>>,
    setup: &Setup,
) -> Value {
    let bound = if limit.measure.is_least() { "least" } else { "most" };
    let mut object = json!({
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
        object["within_m"] = json!(limit.within_m);
    }
    if let Some((value, subject, at_s)) = mark.worst {
        object["value"] = json!(value);
        object["at_s"] = json!(at_s);
        object["by"] = json!(subject.name(setup));
    }
    if let (Some(first_s), Some(deduction)) = (mark.first_s, deduction) {
        object["first_exceeded_s"] = json!(first_s);
        object["exceeded_for_s"] = json!(mark.lasting_s);
        object["text"] = json!(deduction.sentence(setup));
    }
    object
}
