//! `fenderline init`: example scenarios to begin with.

use core::fmt::Write as _;

use serde_json::json;

use crate::cli::{Example, InitArgs};
use crate::failure::Failure;
use crate::output::write_new;
use crate::terminal::{answer, say, say_json};

impl Example {
    /// Name, description and text of the example scenario. The example needs no other file.
    pub(crate) fn parts(self) -> [&'static str; 3] {
        macro_rules! example {
            ($name:literal, $file:literal, $what:literal) => {
                [
                    $name,
                    $what,
                    include_str!(concat!(env!("FENDERLINE_SCENARIOS"), "/", $file, ".toml")),
                ]
            };
        }
        match self {
            Example::Berthing => example!(
                "berthing",
                "berth/eight_cones_at_5_deg",
                "a ship comes alongside eight cone fenders at an angle of 5°"
            ),
            Example::Dolphins => example!(
                "dolphins",
                "berth/flexible_dolphins",
                "a ship comes onto flexible breasting dolphins"
            ),
            Example::ShipToShip => example!(
                "ship-to-ship",
                "berth/two_ships_on_pneumatic_fenders",
                "two ships come alongside each other with pneumatic fenders between them"
            ),
            Example::Tugs => example!(
                "tugs",
                "berth/alongside_with_two_tugs",
                "two tugs bring a ship alongside, with wind and current"
            ),
            Example::Moored => example!(
                "moored",
                "berth/moored_three_hours_in_gusts",
                "a moored ship on lines and fenders for three hours in gusts"
            ),
            Example::Flare => example!(
                "flare",
                "berth/bow_flare_on_a_fender",
                "a flared bow meets a fender, with the hull by outlines at heights"
            ),
        }
    }
}

/// Lists the examples, prints one, or writes one to a new file.
///
/// # Errors
/// Fails if the file exists already or cannot be written.
pub(crate) fn init(args: &InitArgs) -> Result<(), Failure> {
    if args.list {
        return list(args.json);
    }
    let [name, _, text] = args.example.parts();
    let Some(path) = &args.out else { return answer(text) };
    write_new(path, text.as_bytes())?;
    say(&format!("{}: the example `{name}`\n", path.display()))
}

fn list(as_json: bool) -> Result<(), Failure> {
    let all = Example::ALL.map(Example::parts);
    if as_json {
        let all = all.map(|[name, what, _]| json!({ "name": name, "description": what }));
        return say_json(&format!("{:#}\n", json!(all)));
    }
    let mut text = String::new();
    for [name, what, _] in all {
        let _ = writeln!(text, "{name:<14}{what}");
    }
    answer(&text)
}
