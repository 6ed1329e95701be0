//! Bodies on piles, at steps of 0.01 to 2 s, compared with closed forms, with an independent integration of two masses,
//! and with the energy ledger.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use fenderline_contact::*;

const STEPS_S: [f64; 4] = [0.01, 0.1, 1.0, 2.0];
const MASS_KG: f64 = 60e3;
const STIFFNESS_NPM: f64 = 4e6;
const PLACE_M: Vec2 = vec2(100.0, -40.0);

fn outline(points: &[(f64, f64)]) -> Outline {
    let vertices: Vec<Vec2> = points.iter().map(|&(x, y)| vec2(x, y)).collect();
    Outline::new(&vertices).expect("a good outline").0
}

/// Angular frequency ω of the dolphin (rad/s). Its period is 0.77 s.
fn rate_radps() -> f64 {
    (STIFFNESS_NPM / MASS_KG).sqrt()
}

fn pile(damping: f64, yield_n: f64) -> Pile {
    let damping_nspm = 2.0 * damping * MASS_KG * rate_radps();
    Pile { place_m: PLACE_M, stiffness_npm: STIFFNESS_NPM, damping_nspm, yield_n }
}

fn dolphin(pile: Pile) -> Body {
    Body {
        name: "dolphin".into(),
        key: 0,
        outline: outline(&[(-3.0, -3.0), (0.0, -3.0), (0.0, 3.0), (-3.0, 3.0)]),
        mobility: Mobility::OnPile { mass_kg: MASS_KG, pile },
    }
}

struct Run {
    model: Model,
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
    loads: Vec<Wrench>,
}

impl Run {
    fn new(model: Model, states: &[BodyState]) -> Run {
        let (memory, work) = (Memory::new(&model), Workspace::new(&model));
        let loads = vec![Wrench::default(); states.len()];
        Run { model, memory, work, states: states.to_vec(), loads }
    }

    /// A dolphin alone.
    fn alone(pile: Pile, deflection_m: Vec2, velocity_mps: Vec2) -> Run {
        let mut builder = Model::builder();
        builder.body(dolphin(pile));
        let state =
            BodyState { position_m: PLACE_M + deflection_m, velocity_mps, ..BodyState::default() };
        Run::new(builder.build().expect("a good model"), &[state])
    }

    fn step(&mut self, step_s: f64) -> PileMotion {
        let Run { model, memory, work, states, loads } = self;
        advance_in_place(model, memory, work, states, loads, step_s).expect("a good step");
        work.piles()[0]
    }
}

/// A dolphin that is released at rest moves as e^(−ζωt) (cos ω′t + ζω/ω′ sin ω′t).
#[test]
fn a_released_pile_swings_with_its_period_and_its_damping() {
    let rate = rate_radps();
    for damping in [0.0, 0.02, 0.2] {
        let damped = rate * (1.0_f64 - damping * damping).sqrt();
        for step_s in STEPS_S {
            let mut run = Run::alone(pile(damping, f64::INFINITY), vec2(0.3, -0.4), Vec2::ZERO);
            for step in 1..=(10.0 / step_s) as u32 {
                run.step(step_s);
                let t_s = f64::from(step) * step_s;
                let (sin, cos) = (damped * t_s).sin_cos();
                let share = (-damping * rate * t_s).exp() * (cos + damping * rate / damped * sin);
                let off_m = run.states[0].position_m - PLACE_M - vec2(0.3, -0.4) * share;
                // Sub-steps have ωh = 0.02 at most. The relative error of the period is (ωh)²/12. A position is half a
                // sub-step ahead of the deflection, so its relative error is (ωh/2)²/2.
                let most_m = 0.5 * (3.4e-5 * rate * t_s + 1e-4);
                assert!(off_m.length() < most_m, "{damping} {step_s} {t_s}: {off_m:?}");
                assert_eq!(run.states[0].heading_rad, 0.0);
            }
        }
    }
}

#[test]
fn a_loaded_pile_settles_at_load_over_stiffness() {
    for step_s in STEPS_S {
        let mut run = Run::alone(pile(0.1, f64::INFINITY), Vec2::ZERO, Vec2::ZERO);
        run.loads[0].force_n = vec2(1e6, 5e5);
        let mut last = PileMotion::default();
        for _ in 0..(40.0 / step_s) as u32 {
            last = run.step(step_s);
        }
        let off_m = last.deflection_m - vec2(0.25, 0.125);
        assert!(off_m.length() < 1e-9, "{step_s}: {off_m:?}");
        let load_n = last.force_n + vec2(1e6, 5e5);
        assert!(load_n.length() < 1e-2, "{step_s}: {load_n:?}");
    }
}

/// By ½ m v² = F²/2K + F p, the energy that the spring cannot take goes into the permanent deflection p. The sub-step
/// that passes the limit is still elastic, which is 2 per mille of p.
#[test]
fn a_pile_that_yields_keeps_what_the_spring_cannot_take() {
    let yield_n = 1.2e6;
    for step_s in STEPS_S {
        let velocity_mps = vec2(-4.8, 3.6);
        let mut run = Run::alone(pile(0.0, yield_n), Vec2::ZERO, velocity_mps);
        let (mut yield_j, mut peak_n, mut last) = (0.0, 0.0_f64, PileMotion::default());
        for _ in 0..(6.0 / step_s) as u32 {
            last = run.step(step_s);
            yield_j += last.yield_j;
            peak_n = peak_n.max(last.peak_load_n);
        }
        let kinetic_j = 0.5 * MASS_KG * velocity_mps.length_squared();
        let elastic_j = 0.5 * yield_n * yield_n / STIFFNESS_NPM;
        let wanted_m = (kinetic_j - elastic_j) / yield_n;
        let off_m = last.offset_m - vec2(-0.8, 0.6) * wanted_m;
        println!("{step_s}: {:?} for {wanted_m}", last.offset_m);
        assert!(off_m.length() < 2e-3 * wanted_m, "{step_s}: {:?} for {wanted_m}", last.offset_m);
        assert!((peak_n / yield_n - 1.0).abs() < 1e-9, "{peak_n}");
        // The remaining swing is elastic.
        let left_j = 0.5 * MASS_KG * run.states[0].velocity_mps.length_squared() + last.stored_j;
        assert!((left_j + yield_j - kinetic_j).abs() < 1e-9 * kinetic_j, "{step_s}: {left_j}");
        // If the motion turns at the yield load, up to (ωh/2)² of the energy may be left in addition.
        assert!(left_j < elastic_j * (1.0 + 1e-4), "{left_j} for {elastic_j}");
    }
}

const FENDER_NPM: f64 = 2e6;
const SHIP_KG: f64 = 5e6;

/// A barge side on to a linear fender on a dolphin, 0.2 m off its face.
fn berthing(pile: Pile, speed_mps: f64) -> Run {
    let mut builder = Model::builder();
    let dolphin = builder.body(dolphin(pile));
    let barge = builder.body(Body {
        name: "barge".into(),
        key: 1,
        outline: outline(&[(-10.0, -30.0), (10.0, -30.0), (10.0, 30.0), (-10.0, 30.0)]),
        mobility: Mobility::Free { mass_kg: SHIP_KG, yaw_inertia_kgm2: 1.5e9 },
    });
    let material = builder.material(Material {
        stiffness_npm2: 400e3,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 0.0,
        friction_static: 0.0,
        friction_dynamic: 0.0,
        restitution: 1.0,
    });
    builder.fender(Fender {
        name: "fender".into(),
        key: 0,
        body: dolphin,
        position_m: vec2(0.0, 0.0),
        facing_rad: 0.0,
        width_m: 3.0,
        projection_m: 2.0,
        law: FenderLaw::Curve(vec![[0.0, 0.0], [1.8, 1.8 * FENDER_NPM]]),
        unloading: None,
        material,
        rated_deflection_m: 1.5,
        stop: None,
        factors: ReactionFactors::default(),
        panel: None,
    });
    builder.pair(Pair { bodies: [dolphin, barge], material });
    let model = builder.build().expect("a good model");
    let dolphin = BodyState { position_m: PLACE_M, ..BodyState::default() };
    let barge = BodyState {
        position_m: PLACE_M + vec2(12.2, 0.0),
        velocity_mps: vec2(-speed_mps, 0.0),
        ..BodyState::default()
    };
    Run::new(model, &[dolphin, barge])
}

/// Peaks of the reaction and of the deflections of pile and fender, from two masses with steps of 1e-5 s.
fn two_masses(pile: &Pile, speed_mps: f64) -> [f64; 3] {
    let h = 1e-5;
    let (mut ship_m, mut ship_mps, mut pile_m, mut pile_mps) = (-0.2, speed_mps, 0.0, 0.0);
    let mut peaks = [0.0_f64; 3];
    for _ in 0..600_000 {
        let squeeze_m = f64::max(ship_m - pile_m, 0.0);
        let force_n = FENDER_NPM * squeeze_m;
        peaks = [peaks[0].max(force_n), peaks[1].max(pile_m), peaks[2].max(squeeze_m)];
        ship_mps -= h * force_n / SHIP_KG;
        let held_n = pile.stiffness_npm * pile_m + pile.damping_nspm * pile_mps;
        pile_mps += h * (force_n - held_n) / MASS_KG;
        ship_m += h * ship_mps;
        pile_m += h * pile_mps;
    }
    peaks
}

struct Totals {
    peaks: [f64; 3],
    pile_j: f64,
    damping_j: f64,
    contact_j: f64,
    last: PileMotion,
}

fn berthed(run: &mut Run, step_s: f64, duration_s: f64) -> Totals {
    let mut totals = Totals {
        peaks: [0.0; 3],
        pile_j: 0.0,
        damping_j: 0.0,
        contact_j: 0.0,
        last: PileMotion::default(),
    };
    for _ in 0..(duration_s / step_s) as u32 {
        let pile = run.step(step_s);
        totals.pile_j += pile.work_j;
        totals.damping_j += pile.damping_j;
        totals.peaks[1] = totals.peaks[1].max(pile.peak_deflection_m);
        for contact in run.work.contacts() {
            totals.contact_j += contact.work.normal_j + contact.work.tangential_j;
            totals.peaks[0] = totals.peaks[0].max(contact.peak_normal_force_n);
            totals.peaks[2] = totals.peaks[2].max(contact.peak_depth_m);
        }
        totals.last = pile;
    }
    totals
}

fn kinetic_j(run: &Run) -> f64 {
    let masses = [MASS_KG, SHIP_KG];
    run.states.iter().zip(masses).map(|(s, kg)| 0.5 * kg * s.velocity_mps.length_squared()).sum()
}

/// The peaks are compared with those of two masses integrated at 1e-5 s, for all steps. The tolerance of 1 per mille is
/// for the phase of the sub-steps, ωh = 0.1.
#[test]
fn a_berthing_has_the_peaks_of_two_masses() {
    for damping in [0.02, 0.1] {
        let pile = pile(damping, f64::INFINITY);
        let wanted = two_masses(&pile, 0.3);
        for step_s in STEPS_S {
            let totals = berthed(&mut berthing(pile, 0.3), step_s, 6.0);
            println!("{damping} {step_s}: {:?} for {wanted:?}", totals.peaks);
            for (got, wanted) in totals.peaks.iter().zip(wanted) {
                assert!(
                    (got / wanted - 1.0).abs() < 1e-3,
                    "{damping} {step_s}: {got} for {wanted}"
                );
            }
        }
    }
}

/// The energy that the bodies lose equals the energy that pile and contact take. The pile stores its part or turns it
/// to heat. Both hold to rounding.
#[test]
fn the_ledger_of_a_berthing_on_a_pile_closes() {
    for (damping, yield_n) in [(0.0, f64::INFINITY), (0.05, f64::INFINITY), (0.05, 4e5)] {
        for step_s in STEPS_S {
            let mut run = berthing(pile(damping, yield_n), 0.3);
            let start_j = kinetic_j(&run);
            let totals = berthed(&mut run, step_s, 20.0);
            let off_j = kinetic_j(&run) - start_j - totals.pile_j - totals.contact_j;
            assert!(off_j.abs() < 1e-9 * start_j, "{damping} {step_s}: {off_j} J of {start_j}");
            assert!(kinetic_j(&run) + totals.last.stored_j < start_j * (1.0 + 1e-9));
        }
    }
}

/// At rest, R/K and R/k_f are in series. The energies are in the ratio of 1/K to 1/k_f.
#[test]
fn fender_and_pile_share_the_energy_by_their_stiffness() {
    for step_s in STEPS_S {
        let mut run = berthing(pile(0.3, f64::INFINITY), 0.0);
        run.loads[1].force_n = vec2(-8e5, 0.0);
        // A drag that lets her settle.
        let mut last = PileMotion::default();
        for _ in 0..(120.0 / step_s) as u32 {
            run.loads[1].force_n = vec2(-8e5, 0.0) - run.states[1].velocity_mps * 1.5e6;
            last = run.step(step_s);
        }
        let contact = run.work.contacts()[0];
        let (fender_j, wanted_m) = (contact.energy.stored_j, 8e5 / STIFFNESS_NPM);
        assert!((last.deflection_m.x / -wanted_m - 1.0).abs() < 1e-6, "{step_s}: {last:?}");
        let share = last.stored_j / fender_j;
        assert!((share / (FENDER_NPM / STIFFNESS_NPM) - 1.0).abs() < 1e-6, "{step_s}: {share}");
    }
}

#[test]
fn a_yielded_pile_is_restored_with_its_offset() {
    let mut run = berthing(pile(0.02, 4e5), 0.3);
    for _ in 0..40 {
        run.step(0.1);
    }
    let bytes = run.memory.snapshot();
    let mut other = Run::new(run.model.clone(), &run.states);
    other.memory.restore(&run.model, &bytes).expect("its own snapshot");
    for _ in 0..40 {
        let (one, two) = (run.step(0.1), other.step(0.1));
        assert!(one.offset_m.length() > 0.1, "{one:?}");
        assert_eq!(one, two);
    }
    assert_eq!(run.states, other.states);
    assert_eq!(run.memory, other.memory);
}

#[test]
fn hosts_that_move_their_bodies_and_the_papers_method_are_refused() {
    let mut run = berthing(pile(0.02, 4e5), 0.3);
    let Run { model, memory, work, states, loads } = &mut run;
    let before = memory.clone();
    let refused = Err(StepError::OnPile { body: "dolphin".into() });
    assert_eq!(step(model, memory, work, states, 0.1), refused);
    assert_eq!(advance(model, memory, work, states, loads, 0.1), refused);
    assert_eq!(*memory, before);
    let mut builder = Model::builder();
    builder.body(dolphin(Pile { stiffness_npm: 0.0, ..pile(0.0, 1.0) }));
    let error = builder.build().expect_err("a pile without stiffness");
    assert!(error.to_string().starts_with("pile stiffness of `dolphin` is 0"), "{error}");
}
