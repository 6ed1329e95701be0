//! The present state as a scenario file: an exercise that begins where the session is. The file is the session's scenario with other
//! starts of the bodies, lines, weather, orders and events.

mod anchors;
mod bodies;
mod lines;
mod orders;
mod timed;
mod weather;

use fenderline_author::{Edit, rewritten};
use fenderline_scenario::{Override, Scenario};

use crate::refusal::Refusal;
use crate::session::Session;
use crate::source::Source;
use crate::world_change;

/// A scenario file of the present state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PresentFile {
    /// Its text.
    pub text: String,
    /// What it leaves out of the present state, in sentences; they are in its first comment too.
    pub notes: Vec<String>,
}

/// Words of the first comment of every such file, by which it can be told from one that was written by hand.
pub const INTO_A_SESSION: &str = "into a session of";

/// What every file leaves out.
const ALWAYS: &str = "Positions are rounded to 0.1 mm and speeds to 0.001 mm/s. Rudders, thrusters and azimuth units begin at rest and \
                      move to the orders. Fenders are as new, gusts and waves begin anew, an exercise is marked anew.";

impl Session {
    /// The scenario of the present state, under a title: ships' places and speeds, lines, weather, faults, and orders and events to
    /// come. `fenderline run` and `fenderline serve` take it where the files are that the scenario names.
    ///
    /// # Errors
    /// A title that is no single line, or what cannot be written as a scenario, as a line between ships that the scenario has no
    /// words for.
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
                None => notes.push("A planned fault of an anchor is left out.".to_owned()),
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

    /// The first comment: the description of the scenario, where the state is from, and what is left out.
    fn comment(&self, notes: &[String]) -> String {
        let about = Source::leading_comment(&self.source().text);
        let t_s = self.simulation().time_s();
        let saved = format!("Saved {} {INTO_A_SESSION} {:?}.", clock(t_s), self.title());
        let all = [about, saved, ALWAYS.to_owned()];
        let paragraphs = all.iter().chain(notes).filter(|text| !text.is_empty());
        paragraphs.map(|text| wrapped(text)).collect()
    }
}

/// A time as hours, minutes and seconds.
fn clock(t_s: f64) -> String {
    // A session lasts days at most.
    let seconds = libm::round(t_s) as u64;
    format!("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60)
}

/// A paragraph as lines of a comment.
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

/// A text in quotes: those of JSON are those of TOML.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// Rounded to so many decimals, for a file that people read.
fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = libm::pow(10.0, f64::from(decimals));
    // Adding 0 makes 0 of −0.
    libm::round(value * scale) / scale + 0.0
}

/// An angle in degrees, from 0 to 360, with its unit.
fn degrees(angle_rad: f64) -> String {
    let turn = libm::fmod(angle_rad.to_degrees(), 360.0);
    let turn = rounded(if turn < 0.0 { turn + 360.0 } else { turn }, 7);
    format!("\"{turn} deg\"")
}

/// A position (m).
fn place(at_m: fenderline_contact::Vec2) -> String {
    format!("[{}, {}]", rounded(at_m.x, 4), rounded(at_m.y, 4))
}

/// A list of inline tables under a key; none without items.
fn list(key: &str, items: Vec<String>) -> Edit {
    match items.is_empty() {
        true => Edit::remove(&[key]),
        false => Edit::set(&[key], format!("[{}]", items.join(", "))),
    }
}
