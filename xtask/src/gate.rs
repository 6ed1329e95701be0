//! Runs the steps of `cargo xtask test` side by side: each step is a process of its own with its output in a file,
//! which is printed as a whole when the step ends. A table of the times of all steps follows at the end.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use crate::built;
use crate::step::Step;
use crate::virtual_environment::target_folder;

/// Folder below `target` for the output of each step.
const FOLDER: &str = "steps";
/// How many of its last lines a failed step prints once more at the end.
const LAST_LINES: usize = 60;
/// The exit code of a step whose tool is missing.
const NOT_RUN: u8 = 3;
/// The line with which a step tells its processor time.
const PROCESSOR: &str = "== processor ";
/// The line with which a step tells which tool is missing.
const MISSING: &str = "== not run: ";

/// A step among others.
pub(crate) struct Gated {
    /// Name of the step, as it is given on the command line.
    pub(crate) key: &'static str,
    /// What the step does.
    pub(crate) step: Step,
    /// Names of the steps that must end before this step begins, if they are part of the run.
    pub(crate) after: &'static [&'static str],
    /// What the step uses.
    pub(crate) uses: Uses,
    /// Whether the step goes before the others where both want a processor.
    pub(crate) pace: Pace,
}

/// Whether somebody waits for what a step does, second by second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pace {
    /// The step computes, and may be slow.
    Any,
    /// The step has pages that draw while a ship moves in real time: beside a compiler they would be late.
    RealTime,
}

/// What a step uses while it runs, so that no other step may use it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Uses {
    /// A processor.
    Processor,
    /// A processor, and a folder of builds, such as `debug`, into which only one cargo at a time may write.
    Builds(&'static str),
}

/// A step that runs.
struct Running {
    index: usize,
    child: Child,
    began: Instant,
}

/// A step that ended.
struct Ended {
    index: usize,
    began_s: f64,
    wall_s: f64,
    /// The end of what a step printed that is not good; empty for a good step.
    last_lines: String,
    /// The lines of tests that passed only when they were run again.
    retried: Vec<String>,
    /// Processor time that the step's programs have used (s); `None` where the system does not tell.
    processor_s: Option<f64>,
    outcome: Outcome,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Outcome {
    Good,
    /// What is missing.
    NotRun(String),
    Failed,
}

/// Runs `steps`. If the variable `CI` is set, a missing tool is a failure, so that no step is skipped unnoticed. Steps
/// that depend on a failed step do not begin; all other steps do, so that one run shows all failures.
pub(crate) fn run_gated(steps: &[Gated]) -> ExitCode {
    let before = processors_s();
    match run_steps(steps) {
        Ok(ended) => {
            print_table(steps, &ended);
            if let (Some(before), Some(after)) = (before, processors_s()) {
                println!(
                    "all programs on the machine: {:.0} s; the processors had nothing to do for {:.0} s",
                    after.busy_s - before.busy_s,
                    after.idle_s - before.idle_s
                );
            }
            conclude(steps, &ended)
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// Runs one step in this process, which [`run_gated`] has started from another process.
pub(crate) fn run_one(gated: &Gated) -> ExitCode {
    let done = (gated.step.run)();
    if let Some(seconds) = processor_time_of_children_s() {
        println!("{PROCESSOR}{seconds:.1} s");
    }
    match done {
        Ok(crate::step::Done::Good) => ExitCode::SUCCESS,
        Ok(crate::step::Done::NotRun(missing)) => {
            println!("{MISSING}{} is missing; install: {}", missing.tool, missing.install);
            ExitCode::from(NOT_RUN)
        }
        Err(why) => {
            println!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn run_steps(steps: &[Gated]) -> Result<Vec<Ended>, String> {
    let folder = target_folder().join(FOLDER);
    let program = copy_of_this_program(&folder)?;
    let at_once = std::thread::available_parallelism().map_or(1, usize::from);
    let began = Instant::now();
    let mut waiting: Vec<usize> = (0..steps.len()).collect();
    let mut running: Vec<Running> = Vec::new();
    let mut ended: Vec<Ended> = Vec::new();
    while !(waiting.is_empty() && running.is_empty()) {
        let failed = |key: &str| {
            ended.iter().any(|step| steps[step.index].key == key && is_failure(&step.outcome))
        };
        waiting.retain(|&index| !steps[index].after.iter().any(|key| failed(key)));
        while let Some(place) =
            waiting.iter().position(|&index| is_ready(steps, index, &waiting, &running, at_once))
        {
            let index = waiting.remove(place);
            println!("-- {:>5.0} s: {} begins", began.elapsed().as_secs_f64(), steps[index].key);
            let done = ended.iter().filter(|step| step.outcome == Outcome::Good);
            let done: Vec<&str> = done.map(|step| steps[step.index].key).collect();
            let output = output(&folder, &steps[index]);
            let child = start(&program, &steps[index], &done.join(","), &output)?;
            running.push(Running { index, child, began: Instant::now() });
        }
        if running.is_empty() {
            break;
        }
        std::thread::sleep(Duration::from_millis(100));
        let mut place = 0;
        while place < running.len() {
            let status = running[place].child.try_wait().map_err(|e| e.to_string())?;
            let Some(status) = status else {
                place += 1;
                continue;
            };
            let step = running.remove(place);
            let printed = output(&folder, &steps[step.index]);
            let printed =
                std::fs::read(&printed).map_err(|e| format!("{}: {e}", printed.display()))?;
            let printed = String::from_utf8_lossy(&printed);
            let last =
                |start| printed.lines().rev().take(2).find_map(|line| line.strip_prefix(start));
            let outcome = match status.code() {
                Some(0) => Outcome::Good,
                Some(code) if code == i32::from(NOT_RUN) => {
                    Outcome::NotRun(last(MISSING).unwrap_or_default().to_owned())
                }
                _ => Outcome::Failed,
            };
            let wall_s = step.began.elapsed().as_secs_f64();
            let processor_s = last(PROCESSOR)
                .and_then(|text| text.strip_suffix(" s"))
                .and_then(|text| text.parse().ok());
            println!(
                "\n== {}: {}\n{}",
                steps[step.index].key,
                steps[step.index].step.name,
                printed.trim_end()
            );
            println!("== {}, {wall_s:.1} s", word(&outcome));
            let began_s = began.elapsed().as_secs_f64() - wall_s;
            let last_lines = match outcome {
                Outcome::Good => String::new(),
                _ => last_lines(&printed),
            };
            ended.push(Ended {
                index: step.index,
                began_s,
                wall_s,
                last_lines,
                retried: retried(&printed),
                processor_s,
                outcome,
            });
        }
    }
    Ok(ended)
}

/// The last lines of `printed`, without colours. The end of a long log is often all that somebody sees of the log.
fn last_lines(printed: &str) -> String {
    let lines: Vec<&str> = printed.trim_end().lines().collect();
    let first = lines.len().saturating_sub(LAST_LINES);
    without_colours(&lines[first..].join("\n"))
}

/// The lines of `printed` in which Vitest names a test that was run again.
fn retried(printed: &str) -> Vec<String> {
    let named = printed.lines().filter(|line| line.contains("(retry x"));
    named.map(|line| without_colours(line).trim().to_owned()).collect()
}

/// `text` without the terminal's sequences, which begin with ESC and `[` and end with a letter.
fn without_colours(text: &str) -> String {
    let mut parts = text.split("\u{1b}[");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |plain, part| {
        let end = part.find(|c: char| c.is_ascii_alphabetic()).map_or(part.len(), |end| end + 1);
        plain + &part[end..]
    })
}

/// Whether the step may begin now: the steps that it waits for have ended, and what it uses is free.
fn is_ready(
    steps: &[Gated],
    index: usize,
    waiting: &[usize],
    running: &[Running],
    at_once: usize,
) -> bool {
    let to_come = waiting.iter().copied().chain(running.iter().map(|step| step.index));
    let is_before = |other: usize| steps[index].after.contains(&steps[other].key);
    if to_come.into_iter().any(is_before) {
        return false;
    }
    let uses = steps[index].uses;
    let busy = running.len();
    let same_folder = |step: &Running| steps[step.index].uses == uses;
    match uses {
        Uses::Processor => busy < at_once,
        Uses::Builds(_) => busy < at_once && !running.iter().any(same_folder),
    }
}

/// Copies this program, because cargo may build it anew while the steps run, and returns the copy's path.
fn copy_of_this_program(folder: &Path) -> Result<PathBuf, String> {
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let own = std::env::current_exe().map_err(|e| format!("this program: {e}"))?;
    let copy = folder.join(format!("xtask{}", std::env::consts::EXE_SUFFIX));
    std::fs::copy(&own, &copy).map_err(|e| format!("{}: {e}", copy.display()))?;
    Ok(copy)
}

fn output(folder: &Path, step: &Gated) -> PathBuf {
    folder.join(step.key).with_extension("txt")
}

/// Starts a step in a process of its own; `done` names the steps that are done.
fn start(program: &Path, step: &Gated, done: &str, output: &Path) -> Result<Child, String> {
    let failed = |e| format!("{}: {e}", output.display());
    let file = File::create(output).map_err(failed)?;
    let errors = file.try_clone().map_err(failed)?;
    let mut command = match step.pace {
        Pace::Any => behind_others(program),
        Pace::RealTime => Command::new(program),
    };
    command
        .args(["step", step.key])
        .env(built::DONE, done)
        .stdin(Stdio::null())
        .stdout(file)
        .stderr(errors);
    command.spawn().map_err(|e| format!("{}: {e}", step.key))
}

/// A command that runs `program` with a tenth of the claim to a processor that other programs have, by Unix's `nice`.
/// Other systems share their processors evenly.
fn behind_others(program: &Path) -> Command {
    if cfg!(unix) {
        let mut nice = Command::new("nice");
        nice.args(["-n", "10"]).arg(program);
        nice
    } else {
        Command::new(program)
    }
}

/// Linux counts processor time in hundredths of a second for programs, whatever the kernel's own clock.
const TICKS_PER_S: f64 = 100.0;

/// Time of all processors together since the machine started.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Processors {
    busy_s: f64,
    idle_s: f64,
}

/// Time of all processors, by Linux's `/proc`. Programs that leave the step that starts them, as those of a browser do,
/// are in this time and not in the time of the step.
fn processors_s() -> Option<Processors> {
    read_processors(&std::fs::read_to_string("/proc/stat").ok()?)
}

fn read_processors(stat: &str) -> Option<Processors> {
    // user, nice, system, idle, waiting for a disk, interrupts in two kinds; guests are in the first two.
    let line = stat.lines().next()?.strip_prefix("cpu ")?;
    let ticks: Result<Vec<f64>, _> = line.split_whitespace().take(7).map(str::parse).collect();
    let [user, nice, system, idle, disk, interrupts, soft] = ticks.ok()?.try_into().ok()?;
    Some(Processors {
        busy_s: (user + nice + system + interrupts + soft) / TICKS_PER_S,
        idle_s: (idle + disk) / TICKS_PER_S,
    })
}

/// Processor time of all programs that this process has started and waited for (s), by Linux's `/proc`.
fn processor_time_of_children_s() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The name of the program stands in parentheses and may have spaces. Fields 16 and 17 are the children's times; the
    // first after the name is field 3.
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |field: usize| fields.get(field - 3)?.parse::<f64>().ok();
    Some((ticks(16)? + ticks(17)?) / TICKS_PER_S)
}

fn is_strict() -> bool {
    std::env::var_os("CI").is_some_and(|value| !value.is_empty() && value != "false")
}

fn is_failure(outcome: &Outcome) -> bool {
    match outcome {
        Outcome::Good => false,
        Outcome::NotRun(_) => is_strict(),
        Outcome::Failed => true,
    }
}

fn word(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Good => "good",
        Outcome::NotRun(_) => "not run",
        Outcome::Failed => "failed",
    }
}

fn print_table(steps: &[Gated], ended: &[Ended]) {
    println!("\n{:<24} {:>8} {:>8} {:>10}", "step", "began", "took", "processor");
    let mut processors_s = 0.0;
    for step in ended {
        let processor = step.processor_s.map_or_else(String::new, |time| format!("{time:.0} s"));
        println!(
            "{:<24} {:>6.0} s {:>6.0} s {processor:>10}  {}",
            steps[step.index].key,
            step.began_s,
            step.wall_s,
            word(&step.outcome)
        );
        processors_s += step.processor_s.unwrap_or(0.0);
    }
    // Steps stand in the order in which they ended.
    let whole_s = ended.last().map_or(0.0, |step| step.began_s + step.wall_s);
    println!("{:<24} {:>8} {whole_s:>6.0} s {processors_s:>8.0} s", "all", "");
    if let Ok(load) = std::fs::read_to_string("/proc/loadavg") {
        println!("the machine's load at the end: {}", load.trim());
    }
}

fn conclude(steps: &[Gated], ended: &[Ended]) -> ExitCode {
    let good = ended.iter().filter(|step| step.outcome == Outcome::Good).count();
    println!("\n== {good} of {} steps good", steps.len());
    for step in ended {
        for line in &step.retried {
            println!("== good when run again: {}: {line}", steps[step.index].key);
        }
        match &step.outcome {
            Outcome::Good => {}
            Outcome::NotRun(why) => println!("== not run: {}: {why}", steps[step.index].step.name),
            Outcome::Failed => println!(
                "== failed: {}; `cargo xtask test {}` runs it alone; its last lines:\n{}",
                steps[step.index].step.name, steps[step.index].key, step.last_lines
            ),
        }
    }
    if ended.iter().any(|step| is_failure(&step.outcome)) || ended.len() < steps.len() {
        ExitCode::FAILURE
    } else {
        ExitCode::SUCCESS
    }
}

#[cfg(test)]
mod tests {
    use super::{
        Gated, LAST_LINES, Pace, Processors, Uses, is_ready, last_lines, read_processors, retried,
    };
    use crate::step::{Done, Step};

    const fn step(key: &'static str, after: &'static [&'static str], uses: Uses) -> Gated {
        Gated {
            key,
            step: Step { name: key, run: || Ok(Done::Good) },
            after,
            uses,
            pace: Pace::Any,
        }
    }

    const STEPS: [Gated; 3] = [
        step("build", &[], Uses::Builds("debug")),
        step("tests", &["build"], Uses::Processor),
        step("browser", &["absent"], Uses::Processor),
    ];

    #[test]
    fn a_step_waits_for_what_it_comes_after_and_not_for_what_is_not_run() {
        assert!(is_ready(&STEPS, 0, &[1, 2], &[], 2));
        assert!(!is_ready(&STEPS, 1, &[0, 2], &[], 2));
        assert!(is_ready(&STEPS, 1, &[2], &[], 2));
        assert!(is_ready(&STEPS, 2, &[0, 1], &[], 2));
    }

    #[test]
    fn no_step_begins_without_a_processor() {
        assert!(!is_ready(&STEPS, 1, &[2], &[], 0));
        assert!(!is_ready(&STEPS, 2, &[1], &[], 0));
    }

    #[test]
    fn a_failed_step_says_its_last_lines_without_colours() {
        let long = "first\n".to_owned()
            + &"\u{1b}[31m×\u{1b}[39m it failed\u{1b}[2;33m 3 s\n".repeat(LAST_LINES);
        assert_eq!(last_lines(&long), ["× it failed 3 s"; LAST_LINES].join("\n"));
        assert_eq!(last_lines("only this\n\n"), "only this");
    }

    #[test]
    fn a_test_that_was_run_again_is_named() {
        let printed =
            "good\n   \u{1b}[32m✓\u{1b}[39m the view films\u{1b}[33m (retry x1)\u{1b}[39m\n";
        assert_eq!(retried(printed), ["✓ the view films (retry x1)"]);
    }

    #[test]
    fn the_time_of_all_processors_is_read() {
        let stat = "cpu  100 200 300 4000 500 60 70 0 0 0\ncpu0 1 2 3 4 5 6 7 0 0 0\n";
        assert_eq!(read_processors(stat), Some(Processors { busy_s: 7.3, idle_s: 45.0 }));
        assert_eq!(read_processors("cpu0 1 2 3"), None);
    }
}
