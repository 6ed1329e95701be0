//! Hydrodynamic data with mistakes: each is refused or warned of with file, line and reason, and a ship with data that are accepted never has
//! more energy than went in.
//!
//! The mistakes are made in the barge's data of the repository, one at a time.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use crate::data_with_mistakes;

use std::f64::consts::{PI, TAU};

use data_with_mistakes::{Answer, MISTAKES, Row, STEP_S, data_file, edited, read};
use fenderline_contact::{Wrench, vec2};
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;
use fenderline_sim::attitude::{Attitude, AttitudeLoad};
use fenderline_sim::seakeeping::{Motion, Seakeeping, StepLoad};

/// Data with a mistake that are accepted, and the data without one.
fn accepted() -> Vec<(&'static str, Scenario)> {
    let mut all = vec![("no mistake", read(&data_file(), STEP_S).expect("good data"))];
    for mistake in MISTAKES {
        if !matches!(mistake.answer, Answer::Refused(_)) {
            let text = (mistake.make)(&data_file());
            all.push((mistake.name, read(&text, STEP_S).expect(mistake.name)));
        }
    }
    all
}

#[test]
fn each_mistake_is_answered_with_file_line_and_reason() {
    for mistake in MISTAKES {
        let text = (mistake.make)(&data_file());
        assert_ne!(text, data_file(), "{}: nothing was changed", mistake.name);
        let answer = read(&text, STEP_S);
        let said: Vec<String> = match (&mistake.answer, answer) {
            (Answer::Refused(_), Ok(_)) => panic!("{}: it is accepted", mistake.name),
            (Answer::Refused(_), Err(error)) => vec![error.to_string()],
            (_, Err(error)) => panic!("{}: {error}", mistake.name),
            (_, Ok(scenario)) => scenario.notices.iter().map(|notice| notice.to_string()).collect(),
        };
        println!("{}:\n    {}", mistake.name, said.join("\n    "));
        let fragments = match mistake.answer {
            Answer::Refused(fragments) | Answer::WarnedOf(fragments) => fragments,
            Answer::WithinTheFit => continue,
        };
        let is_answer = |said: &String| {
            said.contains("barge_20m.hydro:") && fragments.iter().all(|part| said.contains(part))
        };
        assert!(said.iter().any(is_answer), "{}: {fragments:?} in {said:#?}", mistake.name);
    }
}

#[test]
fn good_data_have_no_notice() {
    let notices = read(&data_file(), STEP_S).expect("good data").notices;
    let about_data = notices.iter().map(|notice| notice.to_string());
    let said: Vec<String> = about_data.filter(|said| said.contains("hydro")).collect();
    assert!(said.is_empty(), "{said:?}");
}

/// A step that her own motions cannot be followed in: heave and pitch of 3.6 s.
#[test]
fn a_step_beyond_her_own_periods_is_refused() {
    let stiff = |text: &str| {
        edited(text, "ship", |row: &mut Row| {
            for name in ["c33", "c55"] {
                row.change(name, |c| 5.0 * c);
            }
        })
    };
    let text = stiff(&data_file());
    let message = read(&text, 1.5).expect_err("a long step").to_string();
    assert!(message.contains("too long for these data"), "{message}");
    assert!(read(&text, STEP_S).is_ok());
}

/// A step that is too long for the highest frequency of the data: a tanker's pitch was 17 % wrong without a word.
#[test]
fn a_step_beyond_the_highest_frequency_is_refused() {
    let message = read(&data_file(), 1.2).expect_err("a long step").to_string();
    assert!(message.contains("whose highest frequency is"), "{message}");
    assert!(message.contains("take a step of at most"), "{message}");
}

/// Periods on the springs (s), longer than that of the slowest wave of the data. On springs of 60 s the barge in surge, with her added mass of slow
/// waves, swings at 0.1002 rad/s, and the first frequency of the data is 0.1: with next to no damping there she gathers energy that the waves do
/// give, for hours, as the square of the time.
const SLOW_S: f64 = 90.0;

/// A ship on linear springs, stepped by hand around [`Motion`] without drag and viscous damping.
struct Moored {
    motion: Motion,
    springs: [f64; 6],
    place: [f64; 6],
    velocity: [f64; 6],
    /// What the forces gave her (J).
    given_j: f64,
}

impl Moored {
    fn new(ship: &Seakeeping) -> Moored {
        let ship = Seakeeping { data: ship.data.clone(), roll_damping: 0.0 };
        let motion = Motion::new(&ship, STEP_S);
        let soft = |k: usize| motion.mass()[k][k] * (TAU / SLOW_S) * (TAU / SLOW_S);
        let springs = [soft(0), soft(1), 0.0, 0.0, 0.0, soft(5)];
        Moored { motion, springs, place: [0.0; 6], velocity: [0.0; 6], given_j: 0.0 }
    }

    /// Half a step's mean of the potential energy, and the kinetic energy within the step.
    fn energy_j(&self, ship: &Seakeeping, before: &[f64; 6]) -> f64 {
        let form = |matrix: &[[f64; 6]; 6], one: &[f64; 6], other: &[f64; 6]| -> f64 {
            (0..6).map(|i| one[i] * (0..6).map(|j| matrix[i][j] * other[j]).sum::<f64>()).sum()
        };
        let held: f64 = (0..6).map(|k| self.springs[k] * before[k] * self.place[k]).sum();
        let restored = form(ship.data.restoring(), before, &self.place);
        0.5 * (form(self.motion.mass(), &self.velocity, &self.velocity) + restored + held)
    }

    /// Steps for a time under a force; `look` gets her energy and what was given, in each step.
    fn run(
        &mut self,
        ship: &Seakeeping,
        duration_s: f64,
        force: impl Fn(f64) -> [f64; 6],
        mut look: impl FnMut(f64, f64),
    ) {
        let mut state = self.motion.start([0.0; 3]);
        let mut attitude = Attitude::default();
        for (motion, place) in [&mut attitude.heave, &mut attitude.roll, &mut attitude.pitch]
            .into_iter()
            .zip(&self.place[2..5])
        {
            motion.value = *place;
        }
        for n in 0..(duration_s / STEP_S) as usize {
            let acts_s = if n == 0 { 0.5 * STEP_S } else { STEP_S };
            let pushed = force(STEP_S * n as f64);
            let mut all = pushed;
            for (k, sum) in all.iter_mut().enumerate() {
                *sum -= self.springs[k] * self.place[k];
            }
            let now = |v: &[f64; 6]| [v[0], v[1], v[5]];
            let load = StepLoad { force: all, acts_s };
            let load = self.motion.predict(&mut state, &attitude, now(&self.velocity), &load);
            let change = fenderline_sim::seakeeping::matrix::solve(self.motion.plane_mass(), &load)
                .expect("mass");
            let (old, before) = (self.velocity, self.place);
            for (k, index) in [0, 1, 5].into_iter().enumerate() {
                self.velocity[index] += acts_s * change[k];
                self.place[index] += STEP_S * self.velocity[index];
            }
            let none = AttitudeLoad::default();
            self.motion.settle(&mut state, &mut attitude, now(&self.velocity), &none, acts_s);
            for (k, motion) in [attitude.heave, attitude.roll, attitude.pitch].iter().enumerate() {
                self.velocity[2 + k] = motion.rate;
                self.place[2 + k] = motion.value;
            }
            let work: f64 =
                (0..6).map(|k| pushed[k] * 0.5 * (old[k] + self.velocity[k])).sum::<f64>();
            self.given_j += acts_s * work;
            look(self.energy_j(ship, &before), self.given_j);
        }
    }
}

/// Let go out of her place in all six motions, for an hour in calm water: her energy, without that of the water, is never more than at the start,
/// and the motions that radiate have lost nearly all of it. 2 %: the energy of a step is that of the equation to the second order.
#[test]
fn in_calm_water_a_moored_ship_never_gains_energy() {
    for (name, scenario) in accepted() {
        let ship = scenario.setup.world.vessels[0].seakeeping.clone().expect("data");
        let mut moored = Moored::new(&ship);
        moored.place = [2.0, 1.0, 0.5, 0.1, 0.02, 0.02];
        let start_j = moored.energy_j(&ship, &moored.place.clone());
        let (mut most_j, mut last_j) = (0.0_f64, 0.0);
        moored.run(
            &ship,
            3600.0,
            |_| [0.0; 6],
            |energy_j, _| {
                most_j = most_j.max(energy_j);
                last_j = energy_j;
            },
        );
        println!("{name}: most {:.4}, at the end {:.4}", most_j / start_j, last_j / start_j);
        assert!(start_j > 0.0 && most_j <= 1.02 * start_j, "{name}: {most_j} of {start_j}");
        assert!(last_j < 0.5 * start_j, "{name}: {last_j} of {start_j}");
    }
}

/// An hour in waves of all frequencies of the data at two headings: her energy is never more than the waves gave. 1 % of the most.
#[test]
fn in_waves_a_moored_ship_never_has_more_energy_than_they_gave() {
    for (name, scenario) in accepted() {
        let ship = scenario.setup.world.vessels[0].seakeeping.clone().expect("data");
        for towards_deg in [30.0_f64, 90.0] {
            let frequencies: Vec<f64> = ship.data.radiation().map(|(w, ..)| w).collect();
            let towards_rad = towards_deg.to_radians();
            let forces: Vec<_> =
                frequencies.iter().map(|w| ship.data.excitation_towards(*w, towards_rad)).collect();
            let force = |t_s: f64| {
                let mut sum = [0.0; 6];
                for (k, (w, force)) in frequencies.iter().zip(&forces).enumerate() {
                    // Phases that are as good as random.
                    let phase = w * t_s + 2.4 * PI * (k * k) as f64 / 7.0;
                    for (sum, part) in sum.iter_mut().zip(force) {
                        *sum += 0.2 * (part.re * phase.cos() - part.im * phase.sin());
                    }
                }
                sum
            };
            let (mut most_j, mut over_j, mut first_half_j) = (0.0_f64, f64::MIN, 0.0_f64);
            let mut step = 0;
            Moored::new(&ship).run(&ship, 3600.0, force, |energy_j, given_j| {
                most_j = most_j.max(energy_j);
                over_j = over_j.max(energy_j - given_j);
                step += 1;
                if f64::from(step) * STEP_S < 1800.0 {
                    first_half_j = first_half_j.max(energy_j);
                }
            });
            println!(
                "{name}, heading {towards_deg}: over {:.2e}, most {most_j:.3e} J, {:.3} of the first half",
                over_j / most_j,
                most_j / first_half_j
            );
            assert!(over_j <= 0.01 * most_j, "{name}: {over_j} J more than were given");
            assert!(most_j <= 3.0 * first_half_j, "{name}: {most_j} J after {first_half_j} J");
        }
    }
}

/// The same hour by the whole simulation, in a sea and in calm water after it: the ledger closes, and no motion grows.
#[test]
fn an_hour_by_the_simulation_stays_bounded_with_all_data_that_are_accepted() {
    for (name, scenario) in accepted() {
        let mass_kg =
            scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data").data.mass_kg();
        let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
        let mut most = [0.0_f64; 2];
        while !simulation.is_done() {
            let state = simulation.states()[0];
            let w = TAU / 60.0;
            let spring = |x: f64, v: f64| -mass_kg * (w * w * x + 0.02 * w * v);
            let turning =
                mass_kg * 500.0 * (w * w * state.heading_rad + 0.02 * w * state.yaw_rate_radps);
            let force_n = vec2(
                spring(state.position_m.x, state.velocity_mps.x),
                spring(state.position_m.y, state.velocity_mps.y),
            );
            simulation.set_external(&[Wrench { force_n, moment_nm: -turning }]);
            simulation.step().expect("a good step");
            let (state, attitude) = (simulation.states()[0], simulation.vessels()[0].attitude);
            let size = state.position_m.length()
                + attitude.heave.value.abs()
                + 40.0 * (state.heading_rad.abs() + attitude.pitch.value.abs())
                + 10.0 * attitude.roll.value.abs();
            assert!(size.is_finite(), "{name}");
            let half = usize::from(simulation.time_s() > 1800.0);
            most[half] = most[half].max(size);
        }
        let energy = simulation.energy();
        println!("{name}: {most:.3?} m, residual {:.1e} J", energy.residual_j);
        assert!(energy.residual_j.abs() < 1e-3 * energy.exchanged_j(), "{name}");
        assert!(most[1] < 2.0 * most[0] && most[0] < 30.0, "{name}: {most:?}");
    }
}
