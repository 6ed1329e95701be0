//! The recorded session in `summary.json`.

use serde_json::{Value, json};

use crate::recorded_session::{LogLine, RecordedSession};

pub(super) fn session_json(session: &RecordedSession) -> Value {
    let RecordedSession { file, branch, branches, missing_at_end, log } = session;
    json!({
        "file": file,
        "branch": branch,
        "branches": branches,
        "is_complete": missing_at_end.is_none(),
        "log": log.iter().map(line_json).collect::<Vec<Value>>(),
    })
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
