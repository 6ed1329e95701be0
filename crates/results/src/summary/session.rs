//! The recorded session in `summary.json`.

use serde_json::{Value, json};

use crate::branch::BranchOutcome;
use crate::recorded_session::{LogLine, RecordedSession};

pub(super) fn session_json(session: &RecordedSession) -> Value {
    let RecordedSession { file, branch, branches, missing_at_end, log, beside } = session;
    json!({
        "file": file,
        "branch": branch,
        "branches": branches,
        "is_complete": missing_at_end.is_none(),
        "log": log.iter().map(line_json).collect::<Vec<Value>>(),
        "beside": beside.iter().map(branch_json).collect::<Vec<Value>>(),
    })
}

/// A branch beside the others, without its way.
fn branch_json(branch: &BranchOutcome) -> Value {
    let BranchOutcome { id, parent, from_s, ends_s, verdict, findings, score, .. } = branch;
    let BranchOutcome { fender_share, line_share, approach_mps, commands, alarms, .. } = branch;
    let mut object = json!({
        "branch": id,
        "from_s": from_s,
        "ends_s": ends_s,
        "verdict": verdict.key(),
        "findings": findings.len(),
        "largest_share_of_break_load": line_share,
        "commands": commands,
        "alarms": alarms,
    });
    // What there is not is left out: the writer takes a null for a number that is not finite.
    for (key, value) in [
        ("parent", parent.map(|parent| json!(parent))),
        ("score", score.map(|(score, _)| json!(score))),
        ("passed", score.and_then(|(_, passed)| passed).map(|passed| json!(passed))),
        ("largest_share_of_rated_energy", fender_share.map(|share| json!(share))),
        ("fastest_approach_mps", approach_mps.map(|speed_mps| json!(speed_mps))),
    ] {
        if let Some(value) = value {
            object[key] = value;
        }
    }
    object
}

fn line_json(line: &LogLine) -> Value {
    let LogLine { t_s, until_s, kind, who, text, acknowledged, .. } = line;
    let mut object = json!({ "t_s": t_s, "kind": kind.word(), "text": text });
    if let Some(until_s) = until_s {
        object["until_s"] = json!(until_s);
    }
    if !who.is_empty() {
        object["who"] = json!(who);
    }
    if let Some((at_s, by)) = acknowledged {
        object["acknowledged_s"] = json!(at_s);
        object["acknowledged_by"] = json!(by);
    }
    object
}
