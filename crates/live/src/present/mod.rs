//! Writes the present state of a session as a scenario file: an exercise that begins in this state. The file is the
//! session's scenario with other starting values for bodies, lines, weather, orders and events.

mod anchors;
mod bodies;
mod lines;
mod orders;
mod timed;
mod weather;
mod written;

use self::written::quoted;
use fenderline_author::{Edit, rewritten};
use fenderline_scenario::{Override, Scenario};

use crate::refusal::Refusal;
use crate::session::Session;
use crate::source::Source;
use crate::world_change;

/// A scenario file of a session's present state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PresentFile {
    /// The text of the scenario file.
    pub text: String,
    /// What the file leaves out of the present state, in sentences. The first comment of the file has the same
    /// sentences.
    pub notes: Vec<String>,
}

/// Words in the first comment of every scenario file of a present state. By these words the program tells a scenario
/// file of a present state from a file that was written by hand.
pub const INTO_A_SESSION: &str = "into a session of";

/// What every scenario file of a present state leaves out, in sentences.
const ALWAYS: &str = "Positions in this file are rounded to 0.1 mm, and speeds to 0.001 mm/s. Rudders, thrusters and azimuth units \
                      begin at rest and move to their orders. Fenders are as new. Gusts and waves begin anew, and the exercise is \
                      marked anew.";

impl Session {
    /// Writes a scenario file, with a title, that begins in the present state of the session. The file contains the
    /// ships' places and speeds, lines, weather, faults, and the orders and events to come. `fenderline run` and
    /// `fenderline serve` can run the file if the files that the scenario names are beside it.
    ///
    /// # Errors
    /// Fails for a title of more than one line. Fails for a state that a scenario file cannot describe, such as a line
    /// between ships that no key can express.
    pub fn present_file(&self, title: &str) -> Result<PresentFile, Refusal> {
        let of_session = self.source();
        let failed = |why: &dyn std::fmt::Display| {
            Refusal::new(format_args!("the present state makes no scenario file: {why}"))
        };
        let began = of_session.scenario().map_err(|why| failed(&why))?;
        let simulation = self.simulation();
        let mut notes = Vec::new();
        let mut edits = vec![Edit::set(&["title"], quoted(title))];
        bodies::edit(simulation, &mut edits);
        lines::edit(simulation, &mut edits, &mut notes);
        anchors::edit(simulation, &mut edits, &mut notes);
        weather::edit(simulation, &began.setup, &mut edits, &mut notes);
        timed::edit(simulation, &mut edits);
        edits.push(list("order", orders::all(simulation)));
        let mut waiting = Vec::new();
        for (at_s, event) in self.now().script.waiting() {
            match world_change::resolve(event, self.cast(), simulation.setup())? {
                Some(change) => waiting.push((at_s - simulation.time_s(), change)),
                None => {
                    notes.push("A planned fault of an anchor is left out of the file.".to_owned())
                }
            }
        }
        let events = timed::events(simulation, waiting);
        edits.push(list("event", events));
        let overrides = of_session.set.iter().map(|set| Override::parse(set));
        let overrides = overrides.collect::<Result<Vec<_>, _>>().map_err(|why| failed(&why))?;
        let body = rewritten(&of_session.text, &of_session.file, &overrides, &edits)
            .map_err(|why| failed(&why))?;
        let text = format!("{}\n{body}", self.comment(&notes));
        let mut read = |name: &str| {
            let file = of_session.files.get(name).cloned();
            file.ok_or_else(|| format!("{name} is not in the session"))
        };
        Scenario::parse_among(&text, "exercise.toml", &[], &mut read)
            .map_err(|why| failed(&why.message()))?;
        Ok(PresentFile { text, notes })
    }

    /// The first comment of the file: the description of the scenario, where the state comes from, and what the file
    /// leaves out.
    fn comment(&self, notes: &[String]) -> String {
        let about = Source::leading_comment(&self.source().text);
        let t_s = self.simulation().time_s();
        let saved = format!("Saved {} {INTO_A_SESSION} {:?}.", clock(t_s), self.title());
        let all = [about, saved, ALWAYS.to_owned()];
        let paragraphs = all.iter().chain(notes).filter(|text| !text.is_empty());
        paragraphs.map(|text| wrapped(text)).collect()
    }
}

/// Formats a time as hours, minutes and seconds.
fn clock(t_s: f64) -> String {
    // A session lasts some days at most.
    let seconds = libm::round(t_s) as u64;
    format!("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60)
}

/// Formats a paragraph as the lines of a comment.
fn wrapped(text: &str) -> String {
    const WIDTH: usize = 118;
    let mut lines = vec!["#".to_owned()];
    for word in text.split_whitespace() {
        let last = lines.len() - 1;
        if lines[last].chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push("#".to_owned());
        }
        let last = lines.len() - 1;
        lines[last].push(' ');
        lines[last].push_str(word);
    }
    lines.join("\n") + "\n"
}

/// Sets a key to a list of inline tables, or removes the key if there are no items.
fn list(key: &str, items: Vec<String>) -> Edit {
    match items.is_empty() {
        true => Edit::remove(&[key]),
        false => Edit::set(&[key], format!("[{}]", items.join(", "))),
    }
}
