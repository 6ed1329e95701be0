//! How a scene is played: begun anew every few steps, or going on.

use std::time::{Duration, Instant};

use crate::world::World;

/// Time step of all scenes (s).
pub const STEP_S: f64 = 0.1;

/// Number of steps after each restart whose time counts: in these steps the bodies come on and are pressed together,
/// and no contact ends.
pub const BURST: usize = 16;

/// Steps of a scene that plays steadily before the clock starts.
pub const SETTLING: usize = 200;

/// Whether a scene is restarted all the time or goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Play {
    /// The scene begins anew every 17 steps.
    Anew,
    /// The scene goes on without restarts, and the clock starts [`SETTLING`] steps after its start.
    Steady,
}

impl Play {
    /// Both ways.
    pub const ALL: [Play; 2] = [Play::Anew, Play::Steady];

    /// The way with the given name on the command line.
    ///
    /// # Errors
    /// The error says which names there are.
    pub fn named(name: &str) -> Result<Play, &'static str> {
        let play = Play::ALL.into_iter().find(|known| known.name() == name);
        play.ok_or("a scene plays `anew` or `steady`, nothing else")
    }

    /// The name on the command line and in tables.
    pub fn name(self) -> &'static str {
        match self {
            Play::Anew => "anew",
            Play::Steady => "steady",
        }
    }
}

/// Restarts a world off the clock, and times the steps after the restart.
pub fn burst(world: &mut dyn World) -> Duration {
    world.restart();
    on_clock(world, BURST)
}

/// Takes so many steps and returns how long they took.
pub fn on_clock(world: &mut dyn World, steps: usize) -> Duration {
    let start = Instant::now();
    for _ in 0..steps {
        world.step();
    }
    start.elapsed()
}

/// Takes `count` warm steps of a world, so that a profiler can count them: [`Play::Anew`] with its restarts and their
/// copying, [`Play::Steady`] after [`SETTLING`] steps.
pub fn steps(world: &mut dyn World, count: usize, play: Play) {
    if play == Play::Steady {
        (0..SETTLING).for_each(|_| world.step());
    }
    for step in 0..count {
        if play == Play::Anew && step % BURST == 0 {
            world.restart();
        }
        world.step();
    }
}
