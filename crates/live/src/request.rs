//! What a page asks for: a command to the simulation, a claim, or the conduct of the session.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::action::Action;
use crate::refusal::Refusal;

/// A helm: a vessel by her name, a vector tug by hers, or the session.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Control {
    /// A vessel's rudder, engine and thrusters.
    Vessel(String),
    /// A vector tug.
    Tug(String),
    /// Pause, rewind, weather and the like; always `true` in JSON.
    Session(bool),
}

/// What is done to the session rather than in it. Not recorded, but for its consequences.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
#[allow(missing_docs, reason = "the fields are those of protocol.ts")]
pub enum Conduct {
    /// Take a helm.
    Claim { control: Control },
    /// Give it back.
    Release { control: Control },
    /// Stop the time.
    Pause {},
    /// Let it go on; while rewound, what is recorded plays on.
    Resume {},
    /// One tick.
    SingleStep {},
    /// Simulated over wall time.
    Pace { pace: f64 },
    /// Go to a tick of this branch.
    Rewind { tick: u64 },
    /// Go on from where it is rewound to, as a new branch.
    Branch {},
    /// Go to the end of another branch.
    ShowBranch { id: usize },
    /// Another scenario, or a saved session; frames tell how far that is until it is there.
    Load { file: String },
    /// What is being opened shall not be.
    StopOpening {},
    /// An alarm was seen.
    Acknowledge { key: String },
    /// Keep a copy of the recording under a name.
    Save { name: String },
}

impl Conduct {
    /// The word of each; a test holds them against the variants.
    pub const WORDS: &[&str] = &[
        "claim",
        "release",
        "pause",
        "resume",
        "single_step",
        "pace",
        "rewind",
        "branch",
        "show_branch",
        "load",
        "stop_opening",
        "acknowledge",
        "save",
    ];
}

/// Anything that a page may ask for.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// To be recorded and carried out.
    Action(Action),
    /// To be done.
    Conduct(Conduct),
}

/// A message of a page before its action is looked at.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum Message {
    Command { id: i64, action: Value },
}

impl Request {
    /// Reads a message of a page: its number, where one could be read, and what it asks for.
    ///
    /// # Errors
    /// A reason to be told: no JSON, a number beyond all numbers, a field that is not there or not known.
    pub fn parse(text: &str) -> (Option<i64>, Result<Request, Refusal>) {
        let told = |e: serde_json::Error| Refusal::new(format_args!("not understood: {e}"));
        let message: Message = match serde_json::from_str(text) {
            Ok(message) => message,
            Err(e) => return (None, Err(told(e))),
        };
        let Message::Command { id, action } = message;
        let request = match action.get("do").and_then(Value::as_str) {
            Some(word) if Conduct::WORDS.contains(&word) => {
                serde_json::from_value(action).map(Request::Conduct)
            }
            _ => serde_json::from_value(action).map(Request::Action),
        };
        (Some(id), request.map_err(told))
    }
}

#[cfg(test)]
mod tests {
    use fenderline_sim::OrderName;

    use super::*;
    use crate::named_order::NamedOrder;

    #[test]
    fn a_message_is_read_and_what_is_none_is_told() {
        let good =
            r#"{"type":"command","id":7,"action":{"do":"rudder","vessel":"a","angle_rad":0.5}}"#;
        let action = Action::from(NamedOrder::new(OrderName::Rudder, "a").number("angle", 0.5));
        assert_eq!(Request::parse(good), (Some(7), Ok(Request::Action(action))));
        let pause = r#"{"type":"command","id":8,"action":{"do":"pause"}}"#;
        assert_eq!(Request::parse(pause), (Some(8), Ok(Request::Conduct(Conduct::Pause {}))));
        let claim = r#"{"type":"command","id":9,"action":{"do":"claim","control":{"tug":"fore"}}}"#;
        let control = Control::Tug("fore".into());
        assert_eq!(Request::parse(claim).1, Ok(Request::Conduct(Conduct::Claim { control })));
        for (bad, told) in [
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
            assert!(reason.contains(told), "{bad}: {reason}");
        }
    }

    #[test]
    fn a_tower_of_brackets_is_refused_and_overflows_no_stack() {
        let tower = "[".repeat(16_000);
        assert!(Request::parse(&tower).1.is_err());
    }
}
