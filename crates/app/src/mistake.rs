//! Mistakes and notices of files as JSON, and what `--strict` makes of them.

use fenderline_report::plot::counted;
use fenderline_scenario::{LoadError, Notice, Place, ScenarioError};
use serde_json::{Value, json};

use crate::failure::Failure;

/// Refuses notices, as `--strict` asks.
///
/// # Errors
/// Fails if there are any notices.
pub(crate) fn refuse_notices(count: usize) -> Result<(), Failure> {
    match count {
        0 => Ok(()),
        _ => {
            let notices = counted(count as u64, "notice", "notices");
            Err(Failure::input(format_args!("error: {notices}, which --strict does not permit")))
        }
    }
}

/// The mistake for which a file was refused, as `check --json` prints it.
pub(crate) fn refused_json(error: &LoadError) -> Value {
    let error = match error {
        LoadError::Unreadable(why) => json!({ "message": format!("cannot read {why}") }),
        LoadError::Refused(error) => error_json(error),
    };
    json!({ "good": false, "error": error })
}

/// A mistake as JSON.
pub(crate) fn error_json(error: &ScenarioError) -> Value {
    let mut json = json!({ "message": error.message(), "key": error.key(), "help": error.help() });
    add_place(&mut json, error.place());
    json
}

/// A notice as JSON.
pub(crate) fn notice_json(notice: &Notice) -> Value {
    let mut json = json!({ "message": notice.message, "key": notice.key });
    add_place(&mut json, &notice.place);
    json
}

/// Adds the place of a mistake to the JSON: file, line and column, or the option of the command line.
fn add_place(json: &mut Value, place: &Place) {
    match place {
        Place::File { name, line, column } => {
            json["file"] = json!(name);
            json["line"] = json!(line);
            json["column"] = json!(column);
        }
        Place::WholeFile { name } => json["file"] = json!(name),
        Place::Option { text } => json["option"] = json!(text),
    }
}
