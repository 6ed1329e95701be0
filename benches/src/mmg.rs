//! Times the steps a second of a ship in three degrees of freedom by the MMG model alone, on one core: under way in a
//! turn, crabbing, and going astern, where the propeller's force is a series that is summed up.

use std::hint::black_box;

use fenderline_scenario::VesselLibrary;
use fenderline_sim::hydro::{Controls, Force, Model3, Motion, Velocity, Water};

use crate::rounds::{Contender, median, nanoseconds_a_call};
use fenderline_bench_scenes::table::Table;

/// Steps of the ship in a round, which takes about 2 ms.
const STEPS: usize = 10_000;
const STEP_S: f64 = 0.1;

/// A ship's velocities, controls and outer force from which the steps begin.
struct Case {
    name: &'static str,
    model: Model3,
    velocity: Velocity,
    controls: Controls,
    push: Force,
}

fn cases() -> [Case; 4] {
    let library = VesselLibrary::built_in();
    let model = |name| {
        Model3::new(
            library.vessel(name).expect("the vessel is one of the program's own").ship,
            Water::SEA,
        )
    };
    let (tanker, container) = (model("kvlcc2"), model("kcs"));
    let ahead = Velocity { surge_mps: 7.9, ..Velocity::default() };
    let turning = Controls { shaft_rps: 1.78, rudder_rad: 0.6 };
    let slow_astern = Velocity { surge_mps: -1.0, sway_mps: 0.1, yaw_radps: 0.0 };
    let astern = Controls { shaft_rps: -0.8, rudder_rad: 0.0 };
    let push = Force { sway_n: 4e5, ..Force::default() };
    [
        Case {
            name: "KVLCC2, 35° turn",
            model: tanker,
            velocity: ahead,
            controls: turning,
            push: Force::default(),
        },
        Case {
            name: "KCS, 35° turn",
            model: container,
            velocity: ahead,
            controls: turning,
            push: Force::default(),
        },
        Case {
            name: "KVLCC2, crabbing, engine stopped",
            model: tanker,
            velocity: Velocity::default(),
            controls: Controls::default(),
            push,
        },
        Case {
            name: "KVLCC2, going astern",
            model: tanker,
            velocity: slow_astern,
            controls: astern,
            push: Force::default(),
        },
    ]
}

/// Times every case by both integrators, semi-implicit and Runge-Kutta.
pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&["ship", "semi-implicit [M steps/s]", "Runge-Kutta 4 [M steps/s]"]);
    for case in cases() {
        let mut contenders = [
            Contender::clocked(|| run(&case, Model3::semi_implicit), STEPS),
            Contender::clocked(|| run(&case, Model3::runge_kutta), STEPS),
        ];
        let times = nanoseconds_a_call(&mut contenders, rounds);
        let millions = |nanoseconds: &[f64]| format!("{:.2}", 1e3 / median(nanoseconds));
        table.row(vec![case.name.to_owned(), millions(&times[0]), millions(&times[1])]);
    }
    table.note("Figures are medians over the rounds on one core.");
    table.note(
        "In each step, the semi-implicit integrator computes the ship's forces once, and Runge-Kutta four times.",
    );
    table
}

type Step = fn(&Model3, &Motion, &Controls, Force, f64) -> Motion;

fn run(case: &Case, step: Step) {
    let mut motion = Motion { velocity: case.velocity, ..Motion::default() };
    for _ in 0..STEPS {
        motion = step(black_box(&case.model), &motion, &case.controls, case.push, STEP_S);
    }
    black_box(motion);
}
