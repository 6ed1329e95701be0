//! Makes a new exercise from a user's choices, for pages: what can be chosen, and the text of the scenario that is
//! made.

use fenderline_author::{BerthSource, NewExercise, berth_words};
use fenderline_live::library_info;

use crate::problem::Problem;
use crate::run::{Source, parse};

/// The ships, tugs and fenders that a user can choose, as the JSON of `LibraryInfo` in `web/src/protocol.ts`.
#[must_use]
pub fn library() -> String {
    serde_json::to_string(library_info()).unwrap_or_else(|e| unreachable!("texts and numbers: {e}"))
}

/// The berth of a scenario that a new exercise can take, in words; `None` if the scenario has no berth.
///
/// # Errors
/// Fails for a mistake in the scenario.
pub fn berth(source: &Source<'_>) -> Result<Option<String>, Problem> {
    parse(source).map(|scenario| berth_words(&scenario.setup))
}

/// Makes the text of a scenario from a user's choices, which are the JSON of `NewExercise` in `web/src/protocol.ts`.
/// `berth` is the scenario whose berth the exercise takes, if it takes one. The overrides of keys in `berth` have no
/// effect.
///
/// # Errors
/// Fails for choices that do not have the form of `NewExercise`, or that make no exercise.
pub fn new_exercise(choices: &str, berth: Option<&Source<'_>>) -> Result<String, Problem> {
    let exercise: NewExercise = serde_json::from_str(choices)
        .map_err(|e| Problem::new("call", format_args!("`choices`: {e}")))?;
    let text = match berth {
        None => exercise.text(),
        Some(source) => {
            let mut read = |name: &str| source.read(name);
            exercise.text_at(BerthSource { file: source.file, text: source.text }, &mut read)
        }
    };
    text.map_err(|error| Problem::new("exercise", error))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BERTHING: &str = include_str!("../../../scenarios/live/berthing.toml");

    fn berthing() -> Source<'static> {
        Source { text: BERTHING, file: "berthing.toml", ..Source::default() }
    }

    fn choices(fenders: usize, berth_of: Option<&str>) -> String {
        serde_json::json!({
            "title": "A first try",
            "berth": {
                "length_m": 300, "depth_m": 20, "fender": "pneumatic", "size": "3300x6500 50kPa", "height_m": null,
                "rated_reaction_n": null, "fenders": fenders, "fender_spacing_m": 40, "bollard_spacing_m": 25
            },
            "berth_of": berth_of,
            "ship": { "vessel": "container-ship", "side": "port", "off_m": 60, "astern_m": 250, "speed_mps": 1 },
            "tugs": { "vessel": "asd-tug", "number": 2 },
            "weather": {
                "wind_mps": 6, "wind_from_rad": 4.7, "gusts": true, "current_mps": 0, "current_to_rad": 0, "visibility_m": null
            }
        })
        .to_string()
    }

    #[test]
    fn choices_make_a_scenario_that_runs() {
        let text = new_exercise(&choices(6, None), None).expect("good choices");
        assert!(text.contains("title = \"A first try\""));
        let source = Source { text: &text, file: "first.toml", ..Source::default() };
        let mut run = crate::run::Run::new(&source, crate::run::Wanted::default()).expect("a run");
        assert_eq!(run.advance(5), Ok(5));
    }

    #[test]
    fn the_berth_of_another_scenario_is_offered_and_taken() {
        let words = berth(&berthing()).expect("a scenario").expect("it has a berth");
        assert!(words.starts_with("quay: "), "{words}");
        let text = new_exercise(&choices(6, Some("berthing.toml")), Some(&berthing()));
        assert!(text.expect("good choices").contains("the berth of berthing.toml"));
    }

    #[test]
    fn a_scenario_without_a_berth_offers_none() {
        let tug = include_str!("../../../scenarios/paper/experiment_2_4kn.toml");
        let source = Source { text: tug, file: "tug.toml", ..Source::default() };
        assert_eq!(berth(&source).expect("a scenario"), None);
    }

    #[test]
    fn bad_choices_are_answered_with_the_reason() {
        let refused = |choices: &str| new_exercise(choices, None).expect_err("refused");
        let none = refused(&choices(0, None));
        assert_eq!(
            (none.details().kind, none.details().message.as_str()),
            ("exercise", "a berth needs at least one fender")
        );
        let form = refused("{}");
        assert_eq!(form.details().kind, "call");
        assert!(form.details().message.contains("missing field"), "{form:?}");
        assert!(library().starts_with("{\"vessels\":["));
    }
}
