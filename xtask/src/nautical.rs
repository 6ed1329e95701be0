//! Lets independent parsers, two for NMEA and two for AIS, read the sentences for chart programs.

use std::path::Path;
use std::process::{Command, Stdio};

use crate::built;
use crate::command::{run, run_quietly};
use crate::step::{Done, Step};
use crate::tools::{self, Missing};
use crate::virtual_environment::install;

/// The parsers of NMEA and AIS sentences, from Python's package index.
const PARSERS: [&str; 4] =
    ["pynmea2==1.19.0", "pynmeagps==1.1.8", "pyais==3.3.1", "simpleais==0.7.3"];
/// Folder below the build folder in which the parsers are installed.
const FOLDER: &str = "target/nautical-python";

/// The step that lets parsers read NMEA and AIS sentences, as a part of `cargo xtask test all` or alone.
pub(crate) const STEP: Step =
    Step { name: "sentences for chart programs, by two parsers each", run: parsers };

/// Runs `crates/nautical/check.py` on the sentences that the example of the crate prints.
fn parsers() -> Result<Done, String> {
    let python = match tools::python() {
        Ok(python) => python,
        Err(missing) => return Ok(Done::NotRun(missing)),
    };
    let own =
        Path::new(FOLDER).join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !has_parsers(&own) {
        let made = run_quietly(Command::new(python).args(["-m", "venv", FOLDER]));
        if made.and_then(|_| install(&own, &PARSERS)).is_err() {
            return Ok(Done::NotRun(Missing {
                tool: "pynmea2, pynmeagps, pyais and simpleais",
                install: "pip install pynmea2 pynmeagps pyais simpleais",
            }));
        }
    }
    let sentences = run_quietly(&mut Command::new(built::example("dev", "sentences")?))?;
    let file = Path::new(FOLDER).join("sentences.txt");
    std::fs::write(&file, sentences).map_err(|e| format!("{}: {e}", file.display()))?;
    let input = std::fs::File::open(&file).map_err(|e| format!("{}: {e}", file.display()))?;
    let mut check = Command::new(&own);
    let status = check.args(["-B", "crates/nautical/check.py"]).stdin(Stdio::from(input)).status();
    let status = status.map_err(|e| format!("{check:?}: {e}"))?;
    if status.success() { Ok(Done::Good) } else { Err(format!("{check:?}: {status}")) }
}

fn has_parsers(python: &Path) -> bool {
    python.is_file()
        && run(Command::new(python).args(["-c", "import pynmea2, pynmeagps, pyais, simpleais"]))
            .is_ok()
}
