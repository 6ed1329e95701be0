//! Counts the processor's instructions in a warm step: this program runs itself under valgrind for two numbers of steps
//! and takes the difference, which leaves the start-up out.

use std::io::ErrorKind;
use std::process::Command;

use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::play::Play;
use fenderline_bench_scenes::table::Table;

/// Name of the scene, number of contacts in the scene, and the two numbers of steps. Both are multiples of the number
/// of counted steps between two restarts of the scene.
const SCENES: [(&str, u64, u64, u64); 4] = [
    ("tug", 1, 640, 6400),
    ("ship", 8, 640, 3200),
    ("faces", 8, 640, 3200),
    ("pairs-1000", 1000, 16, 48),
];

pub(crate) fn bench() -> Result<Table, String> {
    let mut table =
        Table::new(&["scene", "plays", "method", "contacts", "instructions a step", "a contact"]);
    for (scene, contacts, few, many) in SCENES {
        for play in Play::ALL {
            for variant in Variant::ALL {
                let method = variant.name();
                let counted = |steps| instructions(scene, method, play, steps);
                let step = (counted(many)? - counted(few)?) / (many - few);
                table.row(vec![
                    scene.to_owned(),
                    play.name().to_owned(),
                    method.to_owned(),
                    contacts.to_string(),
                    step.to_string(),
                    (step / contacts).to_string(),
                ]);
            }
        }
    }
    Ok(table)
}

fn instructions(scene: &str, method: &str, play: Play, steps: u64) -> Result<u64, String> {
    let this = std::env::current_exe()
        .map_err(|e| format!("the path of this program is not known: {e}"))?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(this)
        .args(["steps", scene, method, play.name(), &steps.to_string()])
        .output()
        .map_err(|error| match error.kind() {
            ErrorKind::NotFound => {
                "valgrind is not installed: counting instructions needs it (package `valgrind`)"
                    .to_owned()
            }
            _ => format!("could not run valgrind: {error}"),
        })?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("valgrind failed ({}):\n{said}", output.status));
    }
    collected(&said)
        .ok_or_else(|| format!("valgrind's output has no count of instructions:\n{said}"))
}

/// The number of instructions in valgrind's line `==123== Collected : 4567`.
fn collected(said: &str) -> Option<u64> {
    said.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok())
}
