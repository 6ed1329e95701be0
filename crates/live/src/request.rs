//! The requests of a page: commands to the simulation, and commands to the session itself.

use fenderline_author::NewExercise;
use serde::{Deserialize, Serialize};
use serde_json::Value;
#[cfg(test)]
use ts_rs::TS;

use crate::action::Action;
use crate::refusal::Refusal;

/// A helm that a page can hold: that of a vessel or a vector tug, by her name, or that of the session.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(test, derive(TS))]
#[serde(rename_all = "snake_case")]
pub enum Control {
    /// The helm of a vessel: rudder, engine and thrusters.
    Vessel(String),
    /// The helm of a vector tug: her force and its direction.
    Tug(String),
    /// The helm of the session itself: pause, rewind, weather and the like. The bool is always `true` in JSON.
    Session(#[cfg_attr(test, ts(type = "true"))] bool),
}

/// Defines [`Conduct`] and [`Conduct::WORDS`] from one list, so that both agree.
macro_rules! conducts {
    ($($(#[$doc:meta])* $name:ident = $word:literal { $($(#[$of:meta])* $field:ident: $type:ty),* },)*) => {
        /// A command to the session itself: about helms, time, branches or files. The recording keeps only what a
        /// command to the session causes.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[cfg_attr(test, derive(TS))]
        #[serde(tag = "do", deny_unknown_fields)]
        #[allow(missing_docs, reason = "the commands are explained")]
        pub enum Conduct {
            $($(#[$doc])* #[serde(rename = $word)] $name { $($(#[$of])* $field: $type),* },)*
        }

        impl Conduct {
            /// For each variant of [`Conduct`], the word in the field `do`.
            pub const WORDS: &[&str] = &[$($word),*];
        }
    };
}

/// An exercise that is to be made from the user's choices, and its name in the gallery.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(TS))]
#[serde(deny_unknown_fields)]
pub struct Creation {
    /// Name of the exercise's file, without the ending.
    pub name: String,
    /// The choices.
    pub exercise: NewExercise,
    /// True if the exercise may replace an exercise of the same name.
    pub replace: bool,
}

conducts! {
    /// Takes a helm.
    Claim = "claim" { control: Control },
    /// Gives a helm back.
    Release = "release" { control: Control },
    /// Stops the simulated time.
    Pause = "pause" {},
    /// Lets the simulated time go on. While the run is rewound, the recorded ticks are played again.
    Resume = "resume" {},
    /// Takes one step.
    SingleStep = "single_step" {},
    /// Sets the pace of the run: simulated time over wall time.
    Pace = "pace" { pace: f64 },
    /// Goes to a tick of the branch that is shown.
    Rewind = "rewind" { tick: u64 },
    /// Begins a new branch at the tick to which the run is rewound.
    Branch = "branch" {},
    /// Shows the end of another branch of the session.
    ShowBranch = "show_branch" { id: usize },
    /// Opens another scenario or a saved session. Frames report the progress.
    Load = "load" { file: String },
    /// Stops opening a file.
    StopOpening = "stop_opening" {},
    /// Gives the name of the person at this page, for labels and the recording.
    Name = "name" { name: String },
    /// Identifies a page by a secret that the page keeps when it is reloaded. The page gets back the helms that it held
    /// before it was reloaded.
    Seat = "seat" { key: String },
    /// Shows where orders would take the ships, by means of a copy of the run. The answers to the page carry the number
    /// of the command that began the trial.
    Trial = "trial" { #[cfg_attr(test, ts(type = "TrialOrder[]"))] orders: Vec<Action>, horizon_s: f64 },
    /// Gives several orders at once. Either all of the orders are given or none of them.
    Give = "give" { #[cfg_attr(test, ts(type = "TrialOrder[]"))] orders: Vec<Action> },
    /// Asks for the last half hour of the session: the values that strip charts show, and the events that the log
    /// shows. The values are those of the own ship, or of the ship that `vessel` names.
    History = "history" { #[cfg_attr(test, ts(optional))] vessel: Option<String> },
    /// Makes the report of the session up to now. The page can fetch the report when this command is acknowledged.
    Report = "report" {},
    /// Saves a copy of the recording under a name.
    Save = "save" { name: String },
    /// Saves the present state of the session as an exercise of the gallery. If `replace` is true, the new exercise may
    /// replace an exercise of the same name.
    SaveExercise = "save_exercise" { name: String, title: String, replace: bool },
    /// Gives a recording or a saved exercise of the gallery another name. `name` has no ending.
    Rename = "rename" { file: String, name: String },
    /// Moves a recording or a saved exercise of the gallery to the folder of deleted files.
    Delete = "delete" { file: String },
    /// Moves a deleted file back to the gallery.
    PutBack = "put_back" { file: String },
    /// Makes a new exercise from the user's choices and adds it to the gallery.
    Create = "create" { of: Box<Creation> },
}

/// A request of a page.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// A command to the simulation. The session records it.
    Action(Action),
    /// A command to the session.
    Conduct(Conduct),
}

/// A message of a page whose field `action` is not yet read.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum Message {
    Command { id: i64, action: Value },
}

impl Request {
    /// Reads a message of a page and returns its request, and its number if the number can be read.
    ///
    /// # Errors
    /// Refuses text that is not JSON, a number that is not finite, and a missing or unknown field; the reason is for
    /// the page.
    pub fn parse(text: &str) -> (Option<i64>, Result<Request, Refusal>) {
        let refused = |e: serde_json::Error| Refusal::new(format_args!("not understood: {e}"));
        let message: Message = match serde_json::from_str(text) {
            Ok(message) => message,
            Err(e) => return (None, Err(refused(e))),
        };
        let Message::Command { id, action } = message;
        let request = match action.get("do").and_then(Value::as_str) {
            Some(word) if Conduct::WORDS.contains(&word) => {
                serde_json::from_value(action).map(Request::Conduct)
            }
            _ => serde_json::from_value(action).map(Request::Action),
        };
        (Some(id), request.map_err(refused))
    }
}

#[cfg(test)]
mod tests {
    use fenderline_sim::OrderName;

    use super::*;
    use crate::named_order::NamedOrder;

    #[test]
    fn a_valid_message_is_read_and_an_invalid_one_is_refused_with_the_reason() {
        let good =
            r#"{"type":"command","id":7,"action":{"do":"rudder","vessel":"a","angle_rad":0.5}}"#;
        let action = Action::from(NamedOrder::new(OrderName::Rudder, "a").number("angle", 0.5));
        assert_eq!(Request::parse(good), (Some(7), Ok(Request::Action(action))));
        let pause = r#"{"type":"command","id":8,"action":{"do":"pause"}}"#;
        assert_eq!(Request::parse(pause), (Some(8), Ok(Request::Conduct(Conduct::Pause {}))));
        let claim = r#"{"type":"command","id":9,"action":{"do":"claim","control":{"tug":"fore"}}}"#;
        let control = Control::Tug("fore".into());
        assert_eq!(Request::parse(claim).1, Ok(Request::Conduct(Conduct::Claim { control })));
        for (bad, expected) in [
            ("", "EOF"),
            ("{", "EOF"),
            (r#"{"type":"command","id":1,"action":{"do":"fly"}}"#, "unknown variant `fly`"),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"a","share":1e999}}"#,
                "number out of range",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"a","share":NaN}}"#,
                "expected value",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"a","share":null}}"#,
                "`share` is a number",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"a"}}"#,
                "missing field `share`",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"hands","vessel":"a","x":1}}"#,
                "unknown field `x`",
            ),
            (r#"{"type":"command","id":1,"action":7}"#, "invalid type"),
        ] {
            let reason = Request::parse(bad).1.expect_err(bad).to_string();
            assert!(reason.contains(expected), "{bad}: {reason}");
        }
    }

    #[test]
    fn deeply_nested_brackets_are_refused_without_a_stack_overflow() {
        let nested = "[".repeat(16_000);
        assert!(Request::parse(&nested).1.is_err());
    }
}
