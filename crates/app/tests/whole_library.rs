//! Everything that the program ships, through each command: every vessel, every size of every family of fenders, every rope, every example
//! of `init` and every scenario. The list is generated, so that what is added later is tried too.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use crate::support::{Run, Workplace, contains_all};
use fenderline_scenario::{FenderLibrary, VesselLibrary, schema};

/// Something to try: a scenario with its name.
struct Tried {
    name: String,
    /// The file, within the place or as a whole path.
    file: String,
    /// Overrides that make the run short, as `KEY=VALUE`.
    set: Vec<&'static str>,
}

/// A command beside `run` with tables in CSV.
#[derive(Clone, Copy)]
enum Command {
    Check,
    Parquet,
    Report,
    Fmu,
}

impl Command {
    const ALL: [Command; 4] = [Command::Check, Command::Parquet, Command::Report, Command::Fmu];
}

/// Forces of other programs need them at the master's machine: an FMU refuses such a scenario.
const NO_FMU: &str = "drag_in_python";

/// The shortest scenario with a vessel: no environment, nothing to touch.
fn bare_vessel(vessel: &str, has_outline: bool, [length_m, beam_m]: [f64; 2]) -> String {
    let (l, b) = (0.5 * length_m, 0.5 * beam_m);
    let outline = match has_outline {
        true => String::new(),
        false => format!("outline = [[-{l}, -{b}], [{l}, -{b}], [{l}, {b}], [-{l}, {b}]]\n"),
    };
    format!(
        "[time]\nstep = \"0.5 s\"\nduration = \"2 s\"\n\n[body.ship]\nvessel = \"{vessel}\"\nposition = [0, 0]\n{outline}"
    )
}

/// A barge that comes onto a fender of a height (m), 0.2 m off it at the start.
fn bare_fender(fender: &str, height_m: f64) -> String {
    let off_m = 10.2 + height_m;
    format!(
        r#"[time]
step = "0.1 s"
duration = "2 s"

[material.facing]
stiffness = "50 MN/m^2"
shear_stiffness = "3 MN/m"
friction_static = 0.2
friction_dynamic = 0.2

[body.quay]
fixed = true
outline = [[-50, 0], [50, 0], [50, 10], [-50, 10]]

[body.barge]
outline = [[-40, -10], [40, -10], [40, 10], [-40, 10]]
mass = "2000 t"
gyradius = "20 m"
position = [0, -{off_m}]
velocity = {{ sway = "0.4 m/s" }}

[fender.one]
on = "quay"
position = [0, 0]
facing = "-90 deg"
width = "2 m"
material = "facing"
{fender}

[[pair]]
bodies = ["quay", "barge"]
material = "facing"
"#
    )
}

/// A ship on a line.
fn bare_rope(rope: &str) -> String {
    format!(
        "{}\n[body.quay]\nfixed = true\noutline = [[-50, 0], [50, 0], [50, 10], [-50, 10]]\nposition = [0, 40]\n\n[line.one]\nfrom = \"ship\"\nfairlead = [0, 10]\nto = \"quay\"\nbollard = [0, 2]\nrope = \"{rope}\"\nbreak_load = \"1000 kN\"\npretension = \"50 kN\"\n",
        bare_vessel("container-ship", true, [0.0; 2])
    )
}

/// What the library holds, as scenarios in the place.
fn of_library(place: &Workplace) -> Vec<Tried> {
    let mut texts: BTreeMap<String, String> = BTreeMap::new();
    for vessel in VesselLibrary::built_in().vessels() {
        let hull = &vessel.ship.particulars;
        let size_m = [hull.length_m, hull.beam_m];
        let text = bare_vessel(&vessel.name, vessel.outline_m.is_some(), size_m);
        texts.insert(format!("vessel {}", vessel.name), text);
    }
    for family in FenderLibrary::built_in().families() {
        for size in &family.sizes {
            let of = format!("type = \"{}\"\nsize = \"{}\"", family.name, size.designation);
            texts.insert(
                format!("fender {} {}", family.name, size.designation),
                bare_fender(&of, size.height_m),
            );
        }
        // Where there is no size of that family, its curve with a rating.
        let of =
            format!("type = \"{}\"\nheight = \"1.2 m\"\nrated_reaction = \"900 kN\"", family.name);
        texts.insert(format!("fender {} by rating", family.name), bare_fender(&of, 1.2));
    }
    let schema = schema();
    let ropes = schema["properties"]["line"]["additionalProperties"]["properties"]["rope"]["oneOf"]
        .as_array()
        .expect("the words of ropes");
    for rope in ropes {
        let word = rope["const"].as_str().expect("a word");
        let mut text = bare_rope(word);
        if word == "own" {
            text += "axial_stiffness = \"50 MN\"\n";
        }
        texts.insert(format!("rope {word}"), text);
    }
    assert!(texts.len() > 20, "the library holds more than that: {:?}", texts.keys());
    let tried = texts.into_iter().map(|(name, text)| {
        let file = format!("{}.toml", name.replace([' ', '/'], "_"));
        place.write(&file, text.as_bytes());
        Tried { name, file, set: Vec::new() }
    });
    tried.collect()
}

/// Overrides that let a scenario run for 2 s alone.
fn shorter(text: &str) -> Vec<&'static str> {
    let has = |line: &str| text.lines().any(|own| own.starts_with(line));
    let mut set = vec!["time.duration=2 s"];
    if has("[statistics]") {
        set.push("statistics.from=0 s");
    }
    if has("interval = ") {
        set.push("output.interval=0");
    }
    set
}

/// The examples of `init`, written by it.
fn of_examples(place: &Workplace) -> Vec<Tried> {
    let listed = place.run(&["init", "--list", "--json"]);
    let listed: serde_json::Value = serde_json::from_str(&listed.stdout).expect("JSON");
    let names = listed.as_array().expect("a list").iter().map(|of| of["name"].as_str());
    let write = |name: Option<&str>| {
        let name = name.expect("a name");
        let file = format!("example_{name}.toml");
        let run = place.run(&["init", name, "-o", &file]);
        assert_eq!(run.code, 0, "{name}: {}", run.stderr);
        let set = shorter(&place.text(&file));
        Tried { name: format!("example {name}"), file, set }
    };
    names.map(write).collect()
}

/// Every scenario of the repository.
fn of_scenarios() -> Vec<Tried> {
    fn below(folder: &Path, into: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            match path.extension().and_then(|of| of.to_str()) {
                _ if path.is_dir() => below(&path, into),
                Some("toml") => into.push(path),
                _ => {}
            }
        }
    }
    let mut files = Vec::new();
    below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios"), &mut files);
    files.sort();
    let tried = files.into_iter().map(|path| {
        let file = path.to_str().expect("UTF-8").to_owned();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let set = shorter(&std::fs::read_to_string(&path).expect("a scenario"));
        Tried { name, file, set }
    });
    tried.collect()
}

impl Tried {
    /// The command on this scenario.
    fn run(&self, place: &Workplace, command: &str, more: &[&str]) -> Run {
        let set: Vec<&str> = self.set.iter().flat_map(|set| ["--set", set]).collect();
        place.run(&[&[command, &self.file], &set[..], more].concat())
    }

    /// What is wrong with it; nothing in a sound repository. Besides a run, which checks it, the commands of `more` are given it.
    fn faults(&self, place: &Workplace, more: &[Command]) -> Vec<String> {
        let mut faults = Vec::new();
        let mut expect = |what: &str, run: &Run, codes: &[i32]| {
            if !codes.contains(&run.code) {
                let Tried { name, .. } = self;
                faults.push(format!("{name}: {what}: exit code {}: {}", run.code, run.stderr));
            }
            codes.contains(&run.code)
        };
        let stem: String = self.name.replace([' ', '/'], "_");
        let out = |kind: &str| format!("out_{stem}_{kind}");
        // A verdict may be bad: the run is complete.
        let csv = out("csv");
        let told = self.run(place, "run", &["--out", &csv, "--allow-failures"]);
        if expect("run", &told, &[0]) {
            let summary = place.json(&format!("{csv}/summary.json"));
            assert!(summary["verdict"]["key"].is_string(), "{}: no verdict", self.name);
            contains_all(&place.text(&format!("{csv}/bodies.csv")), &["t_s,"]);
            contains_all(&place.text(&format!("{csv}/report.html")), &["</html>"]);
        }
        for command in more {
            match command {
                Command::Check => {
                    expect("check", &place.run(&["check", &self.file]), &[0]);
                }
                Command::Parquet => {
                    let parquet = out("parquet");
                    let options =
                        ["--out", &parquet, "--format", "parquet", "--allow-failures", "--json"];
                    let told = self.run(place, "run", &options);
                    if expect("run --format parquet --json", &told, &[0]) {
                        let printed: serde_json::Value =
                            serde_json::from_str(&told.stdout).expect("the summary is JSON");
                        assert!(printed["bodies"].is_array(), "{}", self.name);
                    }
                }
                Command::Report => {
                    let page = format!("{stem}.html");
                    let told = self.run(place, "report", &["--html", &page, "--allow-failures"]);
                    expect("report", &told, &[0]);
                }
                Command::Fmu => {
                    let fmu = format!("{stem}.fmu");
                    let told = self.run(place, "fmu", &["--kind", "simulation", "-o", &fmu]);
                    expect("fmu", &told, if self.name == NO_FMU { &[2] } else { &[0] });
                }
            }
        }
        faults
    }
}

/// Tries everything; `more` tells the commands for the item of a number.
fn try_everything(name: &str, more: impl Fn(usize) -> Vec<Command> + Sync) {
    let place = Workplace::new(name);
    let mut all = of_library(&place);
    all.extend(of_examples(&place));
    all.extend(of_scenarios());
    let left = Mutex::new(all.iter().enumerate());
    let faults = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(2, usize::from) {
            scope.spawn(|| {
                loop {
                    let Some((number, tried)) = left.lock().expect("no panic").next() else {
                        break;
                    };
                    let found = tried.faults(&place, &more(number));
                    faults.lock().expect("no panic").extend(found);
                }
            });
        }
    });
    let faults = faults.into_inner().expect("no panic");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// The small form: everything is run, and given one command more in turn.
#[test]
fn everything_in_the_library_runs_and_goes_through_a_command_in_turn() {
    try_everything("library_in_turn", |number| vec![Command::ALL[number % Command::ALL.len()]]);
}

/// `cargo test -p fenderline --test all whole_library:: -- --ignored`
#[test]
#[ignore = "long: the full form of the test above"]
fn everything_in_the_library_goes_through_each_command() {
    try_everything("whole_library", |_| Command::ALL.to_vec());
}
