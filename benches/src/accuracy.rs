//! Answers of contact engines at time steps from 0.01 to 2 s beside the right answers: our engine by both methods, and
//! rapier2d-f64.
//!
//! A force is the mean over a step, found from the change of momentum in the same way for all engines; peaks within the
//! step are given only for an engine that reports them. Every scene is turned by 0.4 rad and 1 km from the chart's
//! origin, so that nothing is right because its numbers are round.

use fenderline_contact::{BodyState, Material, Pose, Vec2, vec2};
use serde_json::json;

use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::scenes::{Mass, Plan, RUBBER, block};
use fenderline_bench_scenes::table::Table;
use fenderline_bench_scenes::world::World;

use crate::world::Engine;

const STEPS_S: [f64; 5] = [0.01, 0.1, 0.5, 1.0, 2.0];

/// Time step at which the coupled method's answer is taken as converged (s).
const CONVERGED_S: f64 = 1e-4;

const HEADING_RAD: f64 = 0.4;

/// Mass of the tug: a block of 32 × 13 m with a flat bow, which pushes against a wall.
const TUG: Mass = Mass { mass_kg: 920e3, yaw_inertia_kgm2: 920e3 * 8.0 * 8.0 };
const BOW_M: f64 = 13.0;
const HALF_TUG_M: f64 = 16.0;
const TUG_MPS: f64 = 2.06;
const PUSH_N: f64 = 500e3;
/// Width of the wall, which is also its thickness (m).
const WALL_M: f64 = 60.0;

/// Mass of the ship: a block of 200 × 32 m on eight fenders of 4 × 4 m.
const SHIP: Mass = Mass { mass_kg: 1e8, yaw_inertia_kgm2: 1e8 * 50.0 * 50.0 };
const ONTO_FENDERS_N: f64 = 800e3;
const ALONG_FENDERS_N: f64 = 200e3;

/// A quantity that is measured in a scene, and its right value.
#[derive(Clone, Copy)]
struct Quantity {
    case: &'static str,
    name: &'static str,
    unit: &'static str,
    /// In closed form.
    right: f64,
    /// Factor by which the quantity is multiplied before it is printed.
    scale: f64,
}

/// A quantity with the values that one engine finds for it.
pub(crate) struct Figure {
    quantity: Quantity,
    engine: Engine,
    /// The value by the coupled method at the step [`CONVERGED_S`]; `None` where that run would take too long.
    converged: Option<f64>,
    /// At each of [`STEPS_S`].
    values: [f64; 5],
}

/// All figures of the accuracy table; finding them takes a few seconds.
pub(crate) fn figures() -> Vec<Figure> {
    let impact = table_of(&impact_quantities(), impact, true);
    let push = table_of(&[depth_of_push()], |engine, step_s| [push(engine, step_s)], true);
    let held = table_of(&[creep_of_ship()], |engine, step_s| [creep_mps(engine, step_s)], false);
    impact.into_iter().chain(push).chain(held).collect()
}

/// Figures quantity by quantity.
fn table_of<const N: usize>(
    quantities: &[Quantity; N],
    play: impl Fn(Engine, f64) -> [f64; N],
    converge: bool,
) -> Vec<Figure> {
    let converged = converge.then(|| play(Engine::Own(Variant::Coupled), CONVERGED_S));
    let played = Engine::ALL.map(|engine| STEPS_S.map(|step_s| play(engine, step_s)));
    let mut figures = Vec::new();
    for (which, &quantity) in quantities.iter().enumerate() {
        for (engine, answers) in Engine::ALL.into_iter().zip(&played) {
            figures.push(Figure {
                quantity,
                engine,
                converged: converged.map(|answers| answers[which]),
                values: answers.map(|answers| answers[which]),
            });
        }
    }
    figures
}

/// The right answers for a flat bow of width w that hits the wall: ω = √(kw/m), force v√(kwm), depth v/ω, rebound γv,
/// no spin.
fn impact_quantities() -> [Quantity; 4] {
    let stiffness_npm = RUBBER.stiffness_npm2 * BOW_M;
    let omega = libm::sqrt(stiffness_npm / TUG.mass_kg);
    let depth_m = TUG_MPS / omega;
    let case = "tug head-on";
    let of = |name, unit, right, scale| Quantity { case, name, unit, right, scale };
    [
        of("peak force", "MN", stiffness_npm * depth_m, 1e-6),
        of("peak depth", "m", depth_m, 1.0),
        of("rebound", "m/s", RUBBER.restitution * TUG_MPS, 1.0),
        of("spin", "rad/s", 0.0, 1.0),
    ]
}

/// The four quantities of the impact, each the worst of eight values, for eight gaps between tug and wall at the start.
/// The gap matters: at two seconds a step the tug goes 4.12 m, and touches the wall early or late in a step.
fn impact(engine: Engine, step_s: f64) -> [f64; 4] {
    let quantities = impact_quantities();
    let mut worst = quantities.map(|quantity| quantity.right);
    for gap in 0..8 {
        let gap_m = 1.0 + TUG_MPS * 2.0 / 8.0 * f64::from(gap);
        for ((worst, quantity), now) in
            worst.iter_mut().zip(&quantities).zip(impact_from(engine, step_s, gap_m))
        {
            if (now - quantity.right).abs() > (*worst - quantity.right).abs() {
                *worst = now;
            }
        }
    }
    worst
}

fn impact_from(engine: Engine, step_s: f64, gap_m: f64) -> [f64; 4] {
    // Without a shear spring: friction is no matter in a symmetric hit.
    let material = Material { shear_stiffness_npm: 0.0, ..RUBBER };
    let mut tug = TugAtWall::new(engine, material, step_s, gap_m, TUG_MPS, 0.0);
    tug.play(gap_m / TUG_MPS + 6.0);
    let end = tug.world.state(0);
    let rebound_mps = -chart().rotation.apply_inverse(end.velocity_mps).x;
    [tug.peak_force_n, tug.peak_depth_m, rebound_mps, end.yaw_rate_radps.abs()]
}

/// F/(kw).
fn depth_of_push() -> Quantity {
    Quantity {
        case: "tug pushing 500 kN",
        name: "depth after 300 s",
        unit: "m",
        right: PUSH_N / (RUBBER.stiffness_npm2 * BOW_M),
        scale: 1.0,
    }
}

fn push(engine: Engine, step_s: f64) -> f64 {
    let mut tug = TugAtWall::new(engine, RUBBER, step_s, 0.0, 0.0, PUSH_N);
    tug.play(300.0);
    tug.depth_m()
}

/// A tug whose bow pushes against a wall.
struct TugAtWall {
    world: Box<dyn World>,
    step_s: f64,
    gap_m: f64,
    load_n: f64,
    peak_force_n: f64,
    peak_depth_m: f64,
}

impl TugAtWall {
    fn new(
        engine: Engine,
        material: Material,
        step_s: f64,
        gap_m: f64,
        speed_mps: f64,
        load_n: f64,
    ) -> TugAtWall {
        let chart = chart();
        let mut plan = Plan::new(material);
        let state = BodyState {
            position_m: chart.position_m,
            heading_rad: HEADING_RAD,
            velocity_mps: chart.rotation.apply(vec2(speed_mps, 0.0)),
            yaw_rate_radps: 0.0,
        };
        let force_n = chart.rotation.apply(vec2(load_n, 0.0));
        plan.floating(block(2.0 * HALF_TUG_M, BOW_M), TUG, state, force_n);
        let wall = vec2(HALF_TUG_M + gap_m + 0.5 * WALL_M, 0.0);
        plan.fixed(block(WALL_M, WALL_M), chart.apply(wall), HEADING_RAD);
        TugAtWall {
            world: engine.world(&plan, step_s),
            step_s,
            gap_m,
            load_n,
            peak_force_n: 0.0,
            peak_depth_m: 0.0,
        }
    }

    fn play(&mut self, duration_s: f64) {
        for _ in 0..steps_in(duration_s, self.step_s) {
            let before = self.world.state(0);
            self.world.step();
            let gained = self.world.state(0).velocity_mps - before.velocity_mps;
            let along_mps = chart().rotation.apply_inverse(gained).x;
            let mean_n = self.load_n - TUG.mass_kg * along_mps / self.step_s;
            let (force_n, depth_m) = self.world.peaks().unwrap_or((mean_n, self.depth_m()));
            self.peak_force_n = self.peak_force_n.max(force_n);
            self.peak_depth_m = self.peak_depth_m.max(depth_m);
        }
    }

    /// How deep the bow is in the wall (m); negative for a gap.
    fn depth_m(&self) -> f64 {
        chart().apply_inverse(self.world.state(0).position_m).x - self.gap_m
    }
}

/// The speed along the fenders of a ship that friction holds, whose right value is zero.
fn creep_of_ship() -> Quantity {
    Quantity {
        case: "ship held by friction",
        name: "creep along",
        unit: "m/s",
        right: 0.0,
        scale: 1.0,
    }
}

/// Mean speed of the ship along eight fenders over five minutes of steady loads, after five minutes in which the loads
/// rise and five minutes to settle. The loads rise slowly, and the speed is the slope of a line through all positions,
/// so that a swing about a fixed place does not count as speed.
fn creep_mps(engine: Engine, step_s: f64) -> f64 {
    const RISE_S: f64 = 300.0;
    const SETTLE_S: f64 = 300.0;
    const HOLD_S: f64 = 300.0;
    let chart = chart();
    let mut plan = Plan::new(RUBBER);
    let afloat = BodyState {
        position_m: chart.position_m,
        heading_rad: HEADING_RAD,
        ..BodyState::default()
    };
    plan.floating(block(200.0, 32.0), SHIP, afloat, Vec2::ZERO);
    for k in 0..8 {
        let place = vec2(-80.0 + 160.0 / 7.0 * f64::from(k), 18.0);
        plan.fixed(block(4.0, 4.0), chart.apply(place), HEADING_RAD);
    }
    let mut world = engine.world(&plan, step_s);
    let load = chart.rotation.apply(vec2(ALONG_FENDERS_N, ONTO_FENDERS_N));
    let rise = steps_in(RISE_S, step_s);
    for step in 1..=rise {
        let share = step as f64 / rise as f64;
        world.load(0, load * (share * share * (3.0 - 2.0 * share)));
        world.step();
    }
    for _ in 0..steps_in(SETTLE_S, step_s) {
        world.step();
    }
    let held = (0..steps_in(HOLD_S, step_s)).map(|step| {
        world.step();
        (step as f64 * step_s, chart.apply_inverse(world.state(0).position_m).x)
    });
    slope(&held.collect::<Vec<_>>()).abs()
}

/// Slope of the straight line through points, by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let share = 1.0 / points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() * share;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let sum = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>();
    sum(&|p| (p.0 - x) * (p.1 - y)) / sum(&|p| (p.0 - x) * (p.0 - x))
}

fn steps_in(duration_s: f64, step_s: f64) -> usize {
    libm::ceil(duration_s / step_s) as usize
}

fn chart() -> Pose {
    Pose::new(vec2(1000.0, -700.0), HEADING_RAD)
}

/// Makes the printed table: for each figure the values at all time steps and, where the right answer is not zero, the
/// errors of these values.
pub(crate) fn table(figures: &[Figure]) -> Table {
    let steps = STEPS_S.map(|step_s| format!("Δt {step_s} s"));
    let mut head = vec!["case", "quantity", "right", "converged", "engine"];
    head.extend(steps.iter().map(String::as_str));
    let mut table = Table::new(&head);
    let mut last = None;
    for figure in figures {
        let Quantity { case, name, unit, right, .. } = figure.quantity;
        let first = last != Some((case, name));
        last = Some((case, name));
        let shown = |text: String| if first { text } else { String::new() };
        let converged = figure.converged.map_or(String::from("-"), |v| figure.quantity.shown(v));
        let mut row = vec![
            shown(case.to_owned()),
            shown(format!("{name} [{unit}]")),
            shown(figure.quantity.shown(right)),
            shown(converged),
            figure.engine.name().to_owned(),
        ];
        row.extend(figure.values.map(|value| figure.quantity.judged(value)));
        table.row(row);
    }
    table.note("right: the exact answer, in closed form.");
    table.note("converged: the answer of the coupled method at a time step of 1e-4 s.");
    table.note("tug head-on: the worst of eight answers, each for another gap between bow and wall at the start.");
    table.note(
        "rapier2d has rigid contacts with its default setting of softness, and reports no forces within a step.",
    );
    table.note("rapier2d's force is the change of momentum over a step divided by Δt; its depth is the depth at the end of the step.");
    table
}

impl Quantity {
    fn shown(&self, value: f64) -> String {
        let shown = value * self.scale;
        match (self.right == 0.0, shown == 0.0) {
            (true, true) => String::from("0"),
            (true, false) => format!("{shown:.1e}"),
            (false, _) => format!("{shown:.4}"),
        }
    }

    fn judged(&self, value: f64) -> String {
        if self.right == 0.0 {
            return self.shown(value);
        }
        let error = 100.0 * (value / self.right - 1.0);
        if self.unit == "m" && value > WALL_M {
            return String::from("through the wall");
        }
        // No minus before a zero.
        let error = if error.abs() < 0.05 { 0.0 } else { error };
        format!("{} ({error:+.1} %)", self.shown(value))
    }
}

/// The figures as JSON, in SI units.
pub(crate) fn json(figures: &[Figure]) -> String {
    let rows: Vec<serde_json::Value> = figures
        .iter()
        .map(|figure| {
            json!({
                "case": figure.quantity.case,
                "quantity": figure.quantity.name,
                "right": figure.quantity.right,
                "converged": figure.converged,
                "engine": figure.engine.name(),
                "step_s": STEPS_S,
                "values": figure.values,
            })
        })
        .collect();
    format!("{:#}\n", serde_json::Value::from(rows))
}
