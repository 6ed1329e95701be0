//! Counts the contact engine's instructions in the scenes of the benches.
//!
//! ```text
//! cargo run --release -p fenderline-bench-scenes
//! cargo run --release -p fenderline-bench-scenes -- steps SCENE METHOD anew|steady N
//! ```

mod callgrind;

use std::process::ExitCode;

use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::play::{Play, STEP_S, steps};
use fenderline_bench_scenes::scenes::Scene;
use fenderline_bench_scenes::table::Style;

const USAGE: &str = "\
usage: fenderline-instructions                           instructions a warm step, by valgrind
       fenderline-instructions steps SCENE METHOD PLAY N
                                                         N warm steps, to be counted by a profiler; PLAY is anew
                                                         (a restart every 17 steps) or steady
SCENE is a scene of fenderline-bench; METHOD is coupled or paper, either with -brief";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments.iter().map(String::as_str).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &[&str]) -> Result<(), String> {
    match arguments {
        [] => println!("{}", callgrind::bench()?.printed(Style::Plain)),
        ["steps", scene, method, play, count] => {
            let scene =
                Scene::named(scene).ok_or_else(|| format!("no scene `{scene}`\n{USAGE}"))?;
            let variant = Variant::ALL.into_iter().find(|known| known.name() == *method);
            let variant = variant.ok_or_else(|| format!("no method `{method}`\n{USAGE}"))?;
            let play = Play::named(play).map_err(|why| format!("{why}\n{USAGE}"))?;
            let count = count.parse().map_err(|_| format!("`{count}` is no number\n{USAGE}"))?;
            steps(&mut variant.world(&scene.plan(), STEP_S), count, play);
        }
        _ => return Err(USAGE.to_owned()),
    }
    Ok(())
}
