//! `fenderline init`: example scenarios to begin with.

use core::fmt::Write as _;
use std::path::{Path, PathBuf};

use fenderline_author::NewHarbour;
use fenderline_scenario::read_text;
use serde_json::json;

use crate::cli::{Example, InitArgs, Start};
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

/// Lists the examples, prints one, or writes one to a new file; or does so with a scenario at a berth of a chart.
///
/// # Errors
/// Fails if the file exists already or cannot be written, and if the chart has no such berth.
pub(crate) fn init(args: &InitArgs) -> Result<(), Failure> {
    if args.list {
        return list(args.json);
    }
    let example = match args.start {
        Start::Harbour => return harbour(args),
        Start::Example(example) => example,
    };
    if args.chart.is_some() || args.berth.is_some() {
        let why = "error: --chart and --berth are for `fenderline init harbour`";
        return Err(Failure::input(why));
    }
    let [name, _, text] = example.parts();
    let Some(path) = &args.out else { return answer(text) };
    write_new(path, text.as_bytes())?;
    say(&format!("{}: the example `{name}`\n", path.display()))
}

/// Writes a scenario at a berth of the user's chart.
fn harbour(args: &InitArgs) -> Result<(), Failure> {
    let (Some(folder), Some(berth)) = (&args.chart, &args.berth) else {
        return Err(Failure::input("error: `fenderline init harbour` needs --chart and --berth"));
    };
    let name = folder.display().to_string();
    let tables = read_text(&folder.join("chart.toml")).map_err(|why| {
        Failure::input(format!(
            "error: cannot read {why}\n  = help: --chart is a folder that `python -m fenderline.charts CELL.000 -o {name}` has written"
        ))
    })?;
    let beside = args.out.as_deref().and_then(Path::parent).unwrap_or(Path::new(""));
    let harbour = NewHarbour {
        chart: name,
        tables,
        prefix: prefix(beside, folder),
        berth: berth.clone(),
        water: args.water.clone(),
        vessel: args.vessel.clone(),
    };
    let mut read = |file: &str| read_text(&beside.join(file));
    let text = harbour.text(&mut read).map_err(|why| Failure::input(format!("error: {why}")))?;
    let Some(path) = &args.out else { return answer(&text) };
    write_new(path, text.as_bytes())?;
    say(&format!("{}: a berth of the chart in {}\n", path.display(), folder.display()))
}

/// The path from one folder to files in another folder, with a slash at the end; empty for the same folder.
fn prefix(from: &Path, to: &Path) -> String {
    let here = |path: &Path| -> PathBuf {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        path.canonicalize().unwrap_or_else(|_| path.to_owned())
    };
    let (from, to) = (here(from), here(to));
    let (from, to): (Vec<_>, Vec<_>) = (from.components().collect(), to.components().collect());
    let shared = from.iter().zip(&to).take_while(|(one, other)| one == other).count();
    let up = from[shared..].iter().map(|_| "..".to_owned());
    let down = to[shared..].iter().map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).map(|part| part + "/").collect()
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
    let [name, what] = Start::HARBOUR;
    let _ = writeln!(text, "{name:<14}{what}");
    answer(&text)
}
