//! What attacks share: for how long, with which seed, and a program that is watched.
//!
//! `FENDERLINE_ATTACK_SECONDS` and `FENDERLINE_ATTACK_SEED` say more than a plain test run does: see `cargo xtask attack`.
#![allow(dead_code, reason = "each test file uses its own part")]

use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Random numbers with a seed: splitmix64 (Steele, Lea & Flood, OOPSLA 2014).
pub(crate) struct Draw(u64);

impl Draw {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Below `count`, which is above 0.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    pub(crate) fn of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}

/// An attack under way.
pub(crate) struct Attack {
    pub(crate) draw: Draw,
    name: &'static str,
    seed: u64,
    until: Instant,
    tried: u64,
}

impl Attack {
    /// Begins one.
    pub(crate) fn begin(name: &'static str) -> Attack {
        let number = |key: &str, otherwise: u64| {
            std::env::var(key).map_or(otherwise, |text| text.parse().expect("a whole number"))
        };
        let seconds = number("FENDERLINE_ATTACK_SECONDS", 3);
        let seed = number("FENDERLINE_ATTACK_SEED", 20_261_122);
        let until = Instant::now() + Duration::from_secs(seconds);
        Attack { draw: Draw(seed), name, seed, until, tried: 0 }
    }

    /// Counts another try; none where the time is over.
    pub(crate) fn next_try(&mut self) -> Option<u64> {
        if Instant::now() >= self.until {
            return None;
        }
        self.tried += 1;
        Some(self.tried)
    }

    /// What a failure says, so that it can be had again.
    pub(crate) fn here(&self) -> String {
        format!("{}, seed {}, try {}", self.name, self.seed, self.tried)
    }

    /// Prints what was tried and survived.
    pub(crate) fn end(self, of: &str) {
        assert!(self.tried > 0, "{}: nothing was tried", self.name);
        println!(
            "attack {}: {} tried and survived, seed {}; {of}",
            self.name, self.tried, self.seed
        );
    }
}

/// The program under test with at most 4 GB of address space, so that it fails rather than the machine.
pub(crate) fn program(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", "ulimit -v 4000000; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_fenderline")]);
    command.args(arguments).current_dir(folder);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// How a program ended that was watched.
pub(crate) enum Ended {
    /// By itself, in time.
    ByItself(Output),
    /// It had to be killed.
    Hangs,
}

/// Waits for its end; after `patience` it is asked by an interrupt, and after five more seconds killed. What it prints
/// goes to files, so that no full pipe holds it up.
pub(crate) fn watch(mut command: Command, folder: &Path, patience: Duration) -> Ended {
    let open = |name: &str| std::fs::File::create(folder.join(name)).expect("a file");
    command.stdout(open("stdout.txt")).stderr(open("stderr.txt"));
    let mut child = command.spawn().expect("the program starts");
    let began = Instant::now();
    let mut asked = false;
    let status = loop {
        if let Some(status) = child.try_wait().expect("it can be waited for") {
            break status;
        }
        let waited = began.elapsed();
        if waited > patience && !asked {
            asked = true;
            let _ = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
        }
        if waited > patience + Duration::from_secs(5) {
            let _ = child.kill();
            let _ = child.wait();
            return Ended::Hangs;
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    let read = |name: &str| std::fs::read(folder.join(name)).expect("what it printed");
    Ended::ByItself(Output { status, stdout: read("stdout.txt"), stderr: read("stderr.txt") })
}
