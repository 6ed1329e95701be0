//! A folder of its own for each test, with a scenario in it, and the program run in it.
#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod limited;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A tug that runs bow-on into a quay.
pub(crate) const TUG: &str = r#"
title = "A tug at a quay"

[time]
step = "0.1 s"
duration = "10 s"

[contact]
method = "paper"

[material.rubber]
stiffness = "500 kN/m^2"
damping = "10 kN.s/m^2"
shear_stiffness = "3000 kN/m"
friction_static = 0.5
friction_dynamic = 0.4
restitution = 0.1

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 5], [-100, 5]]
position = [0, 20]

[body.tug]
outline = [[-16, -6.5], [8, -6.5], [16, -5], [16, 5], [8, 6.5], [-16, 6.5]]
mass = "930 t"
gyradius = "8 m"
added_mass = { surge = 0.08, sway = 0.8, yaw = 0.4 }
position = [3, 2]
heading = "90 deg"
velocity = { surge = "1 m/s" }

[[pair]]
bodies = ["quay", "tug"]
material = "rubber"
"#;

/// A ship that comes onto two cone fenders of a quay: the northern one is far too small, the southern one
/// is large and takes most. Rated energies by the cone's curve: 31 kJ and 3.9 MJ.
pub(crate) const BERTH: &str = r#"
title = "A ship onto two fenders"

[time]
step = "0.1 s"
duration = "60 s"

[material.concrete]
stiffness = "50 MN/m^2"
shear_stiffness = "10 MN/m"
friction_static = 0.5
friction_dynamic = 0.5
restitution = 0.1

[material.facing]
stiffness = "500 kN/m^2"
shear_stiffness = "3000 kN/m"
friction_static = 0.2
friction_dynamic = 0.2
restitution = 0.1

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 20], [-100, 20]]
position = [0, 0]

[body.ship]
outline = [[-90, -15], [70, -15], [90, 0], [70, 15], [-90, 15]]
mass = "20000 t"
gyradius = "45 m"
added_mass = { surge = 0.05, sway = 0.5, yaw = 0.5 }
position = [0, -18.5]
velocity = { sway = "0.2 m/s" }

[fender."small one"]
on = "quay"
position = [40, 0]
facing = "-90 deg"
width = "1 m"
projection = "2 m"
material = "facing"
type = "cone"
height = "0.5 m"
rated_reaction = "110 kN"

[fender.large]
on = "quay"
position = [-40, 0]
facing = "-90 deg"
width = "3 m"
face_height = "4 m"
material = "facing"
type = "cone"
height = "2 m"
rated_reaction = "3500 kN"
hull = "bulk carrier"

[fender.idle]
on = "quay"
position = [-97, 0]
facing = "-90 deg"
width = "1 m"
projection = "1 m"
material = "facing"
stiffness = "2 MN/m"

[[pair]]
bodies = ["quay", "ship"]
material = "concrete"

[[load]]
body = "ship"
force = ["0 kN", "50 kN"]

[berthing]
ship = "ship"
length_bp = "175 m"
beam = "30 m"
draught = "6 m"
under_keel_clearance = "2 m"
block_coefficient = 0.62
"#;

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_fenderline");

/// A test's own folder.
pub(crate) struct Workplace {
    root: PathBuf,
}

/// How a run of the program ended.
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Workplace {
    /// An empty folder but for `tug.toml` and `berth.toml`.
    pub(crate) fn new(name: &str) -> Workplace {
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&root);
        fs::create_dir_all(&root).expect("a folder for the test");
        let place = Workplace { root };
        place.write("tug.toml", TUG.as_bytes());
        place.write("berth.toml", BERTH.as_bytes());
        place
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.root.join(name)
    }

    pub(crate) fn exists(&self, name: &str) -> bool {
        self.path(name).exists()
    }

    pub(crate) fn write(&self, name: &str, content: &[u8]) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
        fs::write(path, content).expect("written");
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    pub(crate) fn text(&self, name: &str) -> String {
        String::from_utf8(self.read(name)).expect("UTF-8")
    }

    pub(crate) fn json(&self, name: &str) -> serde_json::Value {
        serde_json::from_slice(&self.read(name)).expect("JSON")
    }

    /// Names in a folder, sorted.
    pub(crate) fn files(&self, folder: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(folder)).expect("a folder");
        let mut names: Vec<String> = entries
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    /// Runs the program in the folder.
    pub(crate) fn run(&self, args: &[&str]) -> Run {
        finished(Command::new(PROGRAM).args(args).current_dir(&self.root))
    }

    /// Starts the program and does not wait.
    pub(crate) fn spawn(&self, args: &[&str]) -> Child {
        Command::new(PROGRAM)
            .args(args)
            .current_dir(&self.root)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts")
    }

    /// Runs a line of shell in the folder, with the program as `$FENDERLINE`.
    pub(crate) fn shell(&self, line: &str) -> Run {
        let mut shell = Command::new("bash");
        finished(shell.args(["-c", line]).env("FENDERLINE", PROGRAM).current_dir(&self.root))
    }

    /// Waits until a file is there and not empty.
    pub(crate) fn wait_for(&self, name: &str) {
        let start = Instant::now();
        while fs::metadata(self.path(name)).map_or(0, |m| m.len()) == 0 {
            assert!(start.elapsed() < Duration::from_secs(60), "{name} never came");
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

fn finished(command: &mut Command) -> Run {
    let output = limited::output(command);
    Run {
        code: output.status.code().unwrap_or(-1),
        stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
        stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

/// Asserts that `text` holds every one of `words`.
pub(crate) fn contains_all(text: &str, words: &[&str]) {
    for word in words {
        assert!(text.contains(word), "no {word:?} in:\n{text}");
    }
}
