//! Copies the program alone into an empty folder, in a mount namespace where the sources, cargo and Node are hidden,
//! and checks that each of its commands works there.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::Duration;

use crate::command::run_quietly;
use crate::program::program;
use crate::step::{Done, Step, run_all};

const NAME: &str = "the program alone in an empty folder";

/// This step belongs to `cargo xtask test all`. The step tests the program as users build it.
pub(crate) const STEP: Step = Step { name: NAME, run: || alone("release") };

/// `cargo xtask alone`.
pub(crate) fn alone_command(profile: &str) -> ExitCode {
    run_all(&[if profile == "dev" { Step { name: NAME, run: || alone("dev") } } else { STEP }])
}

/// A scenario that needs the fender library, and one that needs the vessel library.
const BERTHING: &str = "scenarios/berth/eight_cones_at_5_deg.toml";
const VESSELS: &str = "scenarios/berth/alongside_with_two_tugs.toml";
/// Rows of a fender's measured curve for the command `fender fit`.
const CURVE: &str =
    "deflection_m,reaction_kn\n0,0\n0.1,200\n0.2,300\n0.3,360\n0.4,400\n0.5,430\n0.6,450\n";

/// A study of two cases for the command `campaign`.
const STUDY: &str = "scenario = \"berthing.toml\"\n\
    [variable.duration]\nkey = \"time.duration\"\nvalues = [\"5 s\", \"10 s\"]\n";

/// Berthing speeds for `statistics`.
const SPEEDS: &str = "speed [cm/s]\n4.1\n5.2\n6.0\n6.3\n7.1\n7.4\n8.8\n9.9\n11.5\n15.2\n16.0\n";

/// A log of berthings, and what `berthings` needs beside it.
const MEASURED: [(&str, &str); 3] = [
    ("examples/measured/laser.csv", "laser.csv"),
    ("examples/measured/laser.toml", "laser.toml"),
    ("examples/measured/berth.toml", "berth.toml"),
];

/// Commands of the program with their arguments, and the files that each command must write.
const COMMANDS: [(&[&str], &[&str]); 22] = [
    (&["--version"], &[]),
    (&["run", "berthing.toml", "--out", "run"], &["run/report.html", "run/summary.json"]),
    (&["run", "vessels.toml", "--out", "vessels", "--format", "parquet"], &["vessels/report.html"]),
    (&["report", "berthing.toml", "--html", "r.html", "--xlsx", "r.xlsx"], &["r.html", "r.xlsx"]),
    (&["check", "berthing.toml"], &[]),
    (&["validate", "--out", "validation"], &["validation/validation.html"]),
    (
        &["campaign", "study.toml", "--out", "study", "--xlsx", "study.xlsx"],
        &["study/cases.csv", "study/figure.html", "study/report.html", "study.xlsx"],
    ),
    (
        &["statistics", "speeds.csv", "--column", "speed", "--per-year", "60", "--out", "speeds"],
        &["speeds/statistics.html", "speeds/statistics.json"],
    ),
    (
        &[
            "berthings",
            "laser.csv",
            "--berth",
            "berth.toml",
            "--mapping",
            "laser.toml",
            "-o",
            "laser.parquet",
            "--report",
            "laser.html",
        ],
        &["laser.parquet", "laser.html"],
    ),
    (&["limit", "berthing.toml", "--key", "time.duration", "--from", "5 s", "--to", "10 s"], &[]),
    (&["manoeuvre", "kvlcc2", "turning"], &[]),
    (&["vessels"], &[]),
    (&["fenders"], &[]),
    (&["init", "berthing", "-o", "example.toml"], &["example.toml"]),
    (&["completions", "bash"], &[]),
    (&["man", "--out", "man"], &["man/fenderline.1", "man/fenderline-fender-fit.1"]),
    (
        &[
            "fender",
            "fit",
            "curve.csv",
            "-o",
            "fender.toml",
            "--height",
            "1",
            "--length",
            "1",
            "--tolerance",
            "20",
        ],
        &["fender.toml"],
    ),
    (&["fmu", "berthing.toml", "--kind", "engine", "-o", "engine.fmu"], &["engine.fmu"]),
    (
        &["fmu", "vessels.toml", "--kind", "simulation", "--fmi", "3", "-o", "simulation.fmu"],
        &["simulation.fmu"],
    ),
    (&["columns"], &[]),
    (&["schema"], &[]),
    (&["help"], &[]),
];

/// Commands that this module tests in another way.
const OTHERS: [&str; 2] = ["serve", "replay"];

/// An exit code that is no failure: 1 stands for a verdict on a run, which is a result.
const VERDICT: i32 = 1;

fn alone(profile: &str) -> Result<Done, String> {
    let place = Place::new()?;
    if let Err(why) = place.namespace(&["true"]).and_then(|mut command| run_quietly(&mut command)) {
        println!("not run: mount namespaces are not permitted here: {}", why.trim());
        return Ok(Done::Good);
    }
    let program = program(profile)?;
    let copy = |from: &Path, name: &str| {
        std::fs::copy(from, place.folder.join(name)).map_err(|e| format!("{}: {e}", from.display()))
    };
    copy(&program, "fenderline")?;
    copy(Path::new(BERTHING), "berthing.toml")?;
    copy(Path::new(VESSELS), "vessels.toml")?;
    for (from, name) in MEASURED {
        copy(Path::new(from), name)?;
    }
    for (name, text) in [("curve.csv", CURVE), ("study.toml", STUDY), ("speeds.csv", SPEEDS)] {
        std::fs::write(place.folder.join(name), text).map_err(|e| format!("{name}: {e}"))?;
    }
    place.is_hidden()?;
    for (arguments, files) in COMMANDS {
        place.call(arguments)?;
        for file in files {
            if !place.folder.join(file).is_file() {
                return Err(format!("{arguments:?} has not written {file}"));
            }
        }
    }
    place.serve()?;
    place.all_were_called()?;
    println!("each command of the program works alone, `serve` with its pages");
    Ok(Done::Good)
}

/// The empty folder of the test, and what is hidden from it. The folder is removed when this value is dropped.
struct Place {
    folder: PathBuf,
    /// Folders and files that are hidden, by mounting an empty folder or file over each.
    hidden_folders: Vec<PathBuf>,
    hidden_files: Vec<PathBuf>,
}

impl Place {
    fn new() -> Result<Place, String> {
        let folder = std::env::temp_dir().join(format!("fenderline-alone-{}", std::process::id()));
        std::fs::create_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let mut hidden_folders =
            vec![std::env::current_dir().map_err(|e| format!("this folder: {e}"))?];
        hidden_folders.push(crate::virtual_environment::target_folder());
        let home = std::env::var_os("HOME").map(PathBuf::from);
        for (variable, default) in [("CARGO_HOME", ".cargo"), ("RUSTUP_HOME", ".rustup")] {
            let default = || home.as_ref().map(|home| home.join(default));
            hidden_folders.extend(std::env::var_os(variable).map(PathBuf::from).or_else(default));
        }
        hidden_folders.retain(|folder| folder.is_dir());
        let path = std::env::var_os("PATH").unwrap_or_default();
        let programs = std::env::split_paths(&path)
            .flat_map(|folder| ["cargo", "rustc", "node", "npm"].map(|name| folder.join(name)));
        let hidden_files = programs.filter(|program| program.is_file()).collect();
        Ok(Place { folder, hidden_folders, hidden_files })
    }

    /// A command that runs in the namespace and the empty folder, with no environment variables. The command keeps the
    /// process id that it starts with.
    fn namespace(&self, arguments: &[&str]) -> Result<Command, String> {
        let quoted = |path: &PathBuf| {
            let path = path.to_str().ok_or_else(|| format!("{}: not Unicode", path.display()))?;
            Ok::<String, String>(format!("'{}'", path.replace('\'', r"'\''")))
        };
        let mut script = String::from("set -e\n");
        // Files first: a folder may hide the place of a file.
        for file in &self.hidden_files {
            script += &format!("mount --bind /dev/null {}\n", quoted(file)?);
        }
        for folder in &self.hidden_folders {
            let folder = quoted(folder)?;
            // One hidden folder may be within another.
            script += &format!("if [ -d {folder} ]; then mount -t tmpfs none {folder}; fi\n");
        }
        script += &format!("cd {}\nexec env -i \"$@\"\n", quoted(&self.folder)?);
        let mut command = Command::new("unshare");
        if !is_root() {
            command.args(["--user", "--map-root-user"]);
        }
        command.args(["--mount", "sh", "-c", &script, "sh"]).args(arguments);
        Ok(command)
    }

    /// Checks that the namespace hides the sources, cargo and Node.
    fn is_hidden(&self) -> Result<(), String> {
        for hidden in self.hidden_folders.iter().map(|folder| folder.join("Cargo.toml")) {
            let hidden = hidden.display().to_string();
            let mut test = self.namespace(&["sh", "-c", "! test -e \"$0\"", &hidden])?;
            run_quietly(&mut test).map_err(|_| format!("{hidden} is not hidden"))?;
        }
        for tool in ["cargo", "node", "npm"] {
            let script = format!("PATH=/usr/local/bin:/usr/bin:/bin; ! {tool} --version");
            run_quietly(&mut self.namespace(&["sh", "-c", &script])?)
                .map_err(|_| format!("{tool} is not hidden"))?;
        }
        Ok(())
    }

    fn call(&self, arguments: &[&str]) -> Result<String, String> {
        let mut command = self.namespace(&[&["./fenderline"], arguments].concat())?;
        let output = command.stdin(Stdio::null()).output().map_err(|e| format!("unshare: {e}"))?;
        let is_run = matches!(arguments.first(), Some(&("run" | "report")));
        let is_good = output.status.success() || is_run && output.status.code() == Some(VERDICT);
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        if !is_good {
            let (out, err) = (text(&output.stdout), text(&output.stderr));
            return Err(format!("fenderline {arguments:?}: {}\n{out}{err}", output.status));
        }
        println!("fenderline {}", arguments.join(" "));
        Ok(text(&output.stdout))
    }

    /// Starts the live server, fetches its pages, stops it as Ctrl-C does, and replays the session.
    fn serve(&self) -> Result<(), String> {
        let mut command = self.namespace(&[
            "./fenderline",
            "serve",
            "vessels.toml",
            "--port",
            "0",
            "--sessions",
            "s",
        ])?;
        let mut server = Server(
            command
                .stdin(Stdio::null())
                .stdout(Stdio::piped())
                .spawn()
                .map_err(|e| format!("unshare: {e}"))?,
        );
        let stdout = server.0.stdout.take().expect("piped");
        let mut lines = BufReader::new(stdout).lines().map_while(Result::ok);
        let address = lines
            .find_map(|line| {
                let (_, rest) = line.split_once("http://")?;
                Some(rest.split(['/', ' ']).next()?.trim_end_matches('.').to_owned())
            })
            .ok_or("`serve` has printed no address")?;
        let page = get(&address, "/")?;
        let script = page
            .split('"')
            .find(|text| text.starts_with("./assets/") && text.ends_with(".js"))
            .ok_or_else(|| format!("the page that `serve` shows has no script:\n{page}"))?;
        let script = get(&address, &script[1..])?;
        if !script.starts_with("HTTP/1.1 200") || script.len() < 10_000 {
            return Err(format!("the script of the page: {} bytes", script.len()));
        }
        run_quietly(Command::new("kill").args(["-INT", &server.0.id().to_string()]))?;
        let status = server.0.wait().map_err(|e| format!("serve: {e}"))?;
        if !status.success() {
            return Err(format!("serve, interrupted: {status}"));
        }
        println!(
            "fenderline serve: the page was fetched, and its script of {} kB",
            script.len() / 1000
        );
        let sessions = self.folder.join("s");
        let recorded = std::fs::read_dir(&sessions)
            .map_err(|e| format!("{}: {e}", sessions.display()))?
            .flatten()
            .next()
            .ok_or("`serve` has recorded no session")?;
        let recorded = format!("s/{}", recorded.file_name().to_string_lossy());
        self.call(&["replay", &recorded]).map(|_| ())
    }

    /// Checks that the test has called each command that the program's help lists.
    fn all_were_called(&self) -> Result<(), String> {
        let help = self.call(&["--help"])?;
        let commands = help.split_once("Commands:").map_or("", |(_, rest)| rest);
        let names = commands
            .lines()
            .skip(1)
            .take_while(|line| !line.trim().is_empty())
            .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
            .filter_map(|line| line.split_whitespace().next());
        let called = |name: &str| COMMANDS.iter().any(|(arguments, _)| arguments[0] == name);
        let missing: Vec<&str> =
            names.filter(|name| !called(name) && !OTHERS.contains(name)).collect();
        if missing.is_empty() {
            Ok(())
        } else {
            Err(format!("add these commands to xtask/src/alone.rs: {missing:?}"))
        }
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// A running live server, which is killed when this value is dropped.
struct Server(Child);

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn is_root() -> bool {
    run_quietly(Command::new("id").arg("-u")).is_ok_and(|id| id.trim() == "0")
}

/// Fetches a file of the server, with the head of the answer.
fn get(address: &str, path: &str) -> Result<String, String> {
    let failed = |e: std::io::Error| format!("http://{address}{path}: {e}");
    let mut stream = TcpStream::connect(address).map_err(failed)?;
    stream.set_read_timeout(Some(Duration::from_secs(20))).map_err(failed)?;
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n")
        .map_err(failed)?;
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).map_err(failed)?;
    Ok(String::from_utf8_lossy(&answer).into_owned())
}
