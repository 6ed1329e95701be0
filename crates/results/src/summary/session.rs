//! The recorded session in `summary.json`.

use crate::branch::BranchOutcome;
use crate::json::{Json, object};
use crate::recorded_session::{LogLine, RecordedSession};

pub(super) fn session_json(session: &RecordedSession) -> Json {
    let RecordedSession { file, branch, branches, missing_at_end, log, beside } = session;
    object!({
        "file": file,
        "branch": branch,
        "branches": branches,
        "is_complete": missing_at_end.is_none(),
        "log": log.iter().map(line_json).collect::<Json>(),
        "beside": beside.iter().map(branch_json).collect::<Json>(),
    })
}

/// The outcome of a branch as JSON, for comparison with other branches, without the ship's track.
fn branch_json(branch: &BranchOutcome) -> Json {
    let BranchOutcome { id, parent, from_s, ends_s, verdict, findings, score, .. } = branch;
    let BranchOutcome { fender_share, line_share, approach_mps, commands, alarms, .. } = branch;
    let mut object = object!({
        "branch": id,
        "from_s": from_s,
        "ends_s": ends_s,
        "verdict": verdict.key(),
        "findings": findings.len(),
        "largest_share_of_break_load": line_share,
        "commands": commands,
        "alarms": alarms,
    });
    object.put_if_any("parent", *parent);
    object.put_if_any("score", score.map(|(score, _)| score));
    object.put_if_any("passed", score.and_then(|(_, passed)| passed));
    object.put_if_any("largest_share_of_rated_energy", *fender_share);
    object.put_if_any("fastest_approach_mps", *approach_mps);
    object
}

fn line_json(line: &LogLine) -> Json {
    let LogLine { t_s, until_s, kind, who, text, acknowledged, .. } = line;
    let mut object = object!({ "t_s": t_s, "kind": kind.word(), "text": text });
    if let Some(until_s) = until_s {
        object.put("until_s", until_s);
    }
    if !who.is_empty() {
        object.put("who", who);
    }
    if let Some((at_s, by)) = acknowledged {
        object.put("acknowledged_s", at_s);
        object.put("acknowledged_by", by);
    }
    object
}
