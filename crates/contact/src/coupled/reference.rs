//! Compares the solver, for islands of several floating bodies, with a reference: a quadratic programme that a library
//! solves.
//!
//! Without friction the velocities v that the solver finds are the minimum of ½ (v − v*)ᵀ M (v − v*) + κ Σ f max(0,
//! V_n + γ v_ref). The gradient of the minimised function is the balance of momentum with N = mid(0, N at which the
//! bound is tight, f). With a variable for each max, finding the minimum is a quadratic programme.

#![allow(
    clippy::disallowed_methods,
    reason = "the numbers are expected values of a test, not results of the engine"
)]

use alloc::vec;
use alloc::vec::Vec;

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver as _, SolverStatus, SupportedConeT,
};

use crate::coupled::constraint::{Constraint, Forces, Laws, Side};
use crate::coupled::newton::NewtonBuffers;
use crate::coupled::solve::{REPORTED_MPS, solve_island};
use crate::law::friction::Slide;
use crate::maths::vec2::{Vec2, vec2};
use crate::model::mass::InverseMatrix;
use crate::model::material::Material;
use crate::state::body_state::Velocity;
use crate::state::memory::PatchMemory;
use crate::state::report::Friction;
use crate::touch::Touch;

const H: f64 = 0.05;
const MASS_KG: f64 = 1e6;
const YAW_INERTIA_KGM2: f64 = 1.4e8;
/// Length and width of a barge (m).
const LONG_M: f64 = 40.0;
const WIDE_M: f64 = 11.0;

/// A raft of barges between a quay ahead and a quay to starboard. The two quays are one body, which is the last body in
/// the lists. Neighbouring barges of the raft touch at two places.
struct Raft {
    before: Vec<Velocity>,
    inverses: Vec<InverseMatrix>,
    constraints: Vec<Constraint>,
}

/// Random numbers between 0 and 1.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        f64::from((self.0 >> 40) as u32) / f64::from(1_u32 << 24)
    }
}

impl Raft {
    fn new(side: u32, friction: f64, seed: u64) -> Raft {
        let mut noise = Noise(seed);
        let quay = side * side;
        let mut inverses = vec![InverseMatrix::isotropic(MASS_KG, YAW_INERTIA_KGM2); quay as usize];
        inverses.push(InverseMatrix::default());
        let mut before: Vec<Velocity> = (0..quay)
            .map(|_| {
                let pushed = vec2(0.05 * noise.next(), 0.05 * noise.next());
                (pushed, 1e-3 * (noise.next() - 0.5))
            })
            .collect();
        before.push(Velocity::default());
        let material = Material {
            stiffness_npm2: 0.0,
            damping_nspm2: 0.0,
            shear_stiffness_npm: 3e6,
            friction_static: friction,
            friction_dynamic: friction,
            restitution: 0.1,
        };
        let mut constraints = Vec::new();
        let mut touch = |a: u32, b: u32, normal: Vec2, half_m: f64, reach_m: f64| {
            for sign in [-0.8, 0.8] {
                let along = normal.quarter_turn() * (sign * half_m);
                let arms = [normal * reach_m + along, normal * -reach_m + along];
                let touch =
                    Touch { shear_m: 2e-3 * (noise.next() - 0.5), ..Touch::at(normal, arms) };
                let laws = Laws {
                    material: &material,
                    law_n: 4e5 * noise.next(),
                    rebound_mps: 2e-3 * noise.next(),
                    available_j: f64::MAX,
                    shear_available_j: f64::MAX,
                    unbalanced_j: 0.0,
                    slide: Slide::Begins,
                    was_limited: false,
                    h: H,
                    kick_s: H,
                };
                let (of_a, of_b) = (&inverses[a as usize], &inverses[b as usize]);
                constraints.push(Constraint::new(
                    (a, of_a),
                    (b, of_b),
                    &touch,
                    &laws,
                    Forces::default(),
                ));
            }
        };
        for row in 0..side {
            for column in 0..side {
                let own = row * side + column;
                let ahead = if row == 0 { quay } else { own - side };
                touch(own, ahead, vec2(1.0, 0.0), 0.5 * WIDE_M, 0.5 * LONG_M);
                let abeam = if column == 0 { quay } else { own - 1 };
                touch(own, abeam, vec2(0.0, 1.0), 0.5 * LONG_M, 0.5 * WIDE_M);
            }
        }
        Raft { before, inverses, constraints }
    }

    /// Number of floating bodies.
    fn bodies(&self) -> usize {
        self.before.len() - 1
    }

    /// Solves the raft by the engine, and returns velocities and forces.
    fn solved(&self) -> (Vec<Velocity>, Vec<Constraint>) {
        let (mut bodies, mut constraints) = (self.before.clone(), self.constraints.clone());
        let memories = vec![PatchMemory::default(); constraints.len()];
        let mut buffers = NewtonBuffers::default();
        let last_mps =
            solve_island(&mut bodies, &self.inverses, &mut constraints, &memories, &mut buffers, H);
        assert!(last_mps < REPORTED_MPS, "{last_mps}");
        (bodies, constraints)
    }

    /// The rows of the Jacobian, which give V_n and V_t of the contacts from all velocities.
    fn rows(&self, constraint: &Constraint) -> [Vec<f64>; 2] {
        let mut rows = [vec![0.0; 3 * self.bodies()], vec![0.0; 3 * self.bodies()]];
        for side in [Side::A, Side::B] {
            let rank = if side == Side::A { constraint.a } else { constraint.b } as usize;
            if rank == self.bodies() {
                continue;
            }
            let of = constraint.jacobian(side);
            let directions =
                [(of.normal, of.levers.n_m), (of.normal.quarter_turn(), of.levers.t_m)];
            for (row, (direction, lever_m)) in rows.iter_mut().zip(directions) {
                row[3 * rank] = side.sign() * direction.x;
                row[3 * rank + 1] = side.sign() * direction.y;
                row[3 * rank + 2] = side.sign() * lever_m;
            }
        }
        rows
    }

    /// The minimum that the library finds: the velocities, and the normal force N of each contact. The units in this
    /// calculation are m, s and 1,000 t.
    fn by_quadratic_programme(&self) -> (Vec<f64>, Vec<f64>) {
        const UNIT_KG: f64 = 1e6;
        let (count, contacts) = (3 * self.bodies(), self.constraints.len());
        let all = count + contacts;
        let mut quadratic = vec![vec![0.0; all]; all];
        let mut linear = vec![0.0; all];
        for (rank, &(velocity, turn)) in self.before[..self.bodies()].iter().enumerate() {
            let masses = [MASS_KG, MASS_KG, YAW_INERTIA_KGM2].map(|mass| mass / UNIT_KG);
            for (axis, (mass, before)) in
                masses.iter().zip([velocity.x, velocity.y, turn]).enumerate()
            {
                quadratic[3 * rank + axis][3 * rank + axis] = *mass;
                linear[3 * rank + axis] = -mass * before;
            }
        }
        // First V_n − s ≤ −γ v_ref, then −s ≤ 0.
        let mut limits = vec![vec![0.0; all]; 2 * contacts];
        let mut bounds = vec![0.0; 2 * contacts];
        for (index, constraint) in self.constraints.iter().enumerate() {
            let [normal, _] = self.rows(constraint);
            linear[count + index] = H * constraint.law_n / UNIT_KG;
            limits[index][..count].copy_from_slice(&normal);
            limits[index][count + index] = -1.0;
            bounds[index] = -constraint.rebound_mps;
            limits[contacts + index][count + index] = -1.0;
        }
        let settings = DefaultSettings {
            verbose: false,
            tol_gap_abs: 1e-13,
            tol_gap_rel: 1e-13,
            tol_feas: 1e-13,
            ..DefaultSettings::default()
        };
        let mut solver = DefaultSolver::new(
            &CscMatrix::from(&quadratic).to_triu(),
            &linear,
            &CscMatrix::from(&limits),
            &bounds,
            &[SupportedConeT::NonnegativeConeT(2 * contacts)],
            settings,
        )
        .expect("a good programme");
        solver.solve();
        let status = solver.solution.status;
        assert!(matches!(status, SolverStatus::Solved | SolverStatus::AlmostSolved), "{status}");
        let normal_n = solver.solution.z[..contacts].iter().map(|z| z * UNIT_KG / H).collect();
        (solver.solution.x[..count].to_vec(), normal_n)
    }

    /// The momentum that these contact forces give to each body, in the direction of each velocity component.
    fn momenta(&self, forces: &[[f64; 2]]) -> Vec<f64> {
        let mut momenta = vec![0.0; 3 * self.bodies()];
        for (constraint, [normal_n, tangential_n]) in self.constraints.iter().zip(forces) {
            let [normal, tangential] = self.rows(constraint);
            for ((sum, n), t) in momenta.iter_mut().zip(normal).zip(tangential) {
                *sum += H * (tangential_n * t - normal_n * n);
            }
        }
        momenta
    }
}

fn flat(velocities: &[Velocity]) -> Vec<f64> {
    velocities.iter().flat_map(|(velocity, turn)| [velocity.x, velocity.y, *turn]).collect()
}

/// The velocities and the sums of forces on each body must agree within 1e-6. Where two bodies touch at two places and
/// other contacts hold the bodies too, a single normal force N need not be unique, but the sums are.
#[test]
fn rafts_have_the_forces_of_a_quadratic_programme() {
    for (side, seed) in [(2, 1), (3, 2), (4, 3), (5, 4), (6, 5)] {
        let raft = Raft::new(side, 0.0, seed);
        let (bodies, constraints) = raft.solved();
        let (wanted, wanted_n) = raft.by_quadratic_programme();
        let fastest = wanted.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        for (is, wanted) in flat(&bodies).iter().zip(&wanted) {
            assert!(
                (is - wanted).abs() < 1e-7 * fastest,
                "side {side}: speed {is} m/s instead of {wanted} m/s"
            );
        }
        let own: Vec<[f64; 2]> =
            constraints.iter().map(|c| [c.forces.normal_n, c.forces.tangential_n]).collect();
        let by_programme: Vec<[f64; 2]> =
            wanted_n.iter().map(|&normal_n| [normal_n, 0.0]).collect();
        let (own, by_programme) = (raft.momenta(&own), raft.momenta(&by_programme));
        for axis in 0..3 {
            let of_axis =
                |of: &[f64]| of.iter().skip(axis).step_by(3).copied().collect::<Vec<f64>>();
            let (own, wanted) = (of_axis(&own), of_axis(&by_programme));
            let most = wanted.iter().fold(0.0, |most: f64, p| most.max(p.abs()));
            for (own, wanted) in own.iter().zip(&wanted) {
                assert!((own - wanted).abs() < 1e-6 * most, "{side}: {own} for {wanted} N·s");
            }
        }
    }
}

/// With friction that slides, the solution is no minimum, because Coulomb's limit follows N. But each contact can be
/// checked by itself: the balance of momentum, N against its bounds, T against spring and Coulomb.
#[test]
fn rafts_that_slide_fulfil_the_law_of_each_contact() {
    let mut slipping = 0;
    for (side, seed) in [(2, 11), (3, 12), (4, 13), (5, 14), (10, 15)] {
        let raft = Raft::new(side, 0.1, seed);
        let (bodies, constraints) = raft.solved();
        let forces: Vec<[f64; 2]> =
            constraints.iter().map(|c| [c.forces.normal_n, c.forces.tangential_n]).collect();
        let masses = [MASS_KG, MASS_KG, YAW_INERTIA_KGM2];
        let (before, after) = (flat(&raft.before), flat(&bodies));
        for (index, momentum) in raft.momenta(&forces).iter().enumerate() {
            let speed = before[index] + momentum / masses[index % 3];
            assert!((speed - after[index]).abs() < 1e-12, "{speed} {}", after[index]);
        }
        for constraint in &constraints {
            let Forces { normal_n, tangential_n, friction } = constraint.forces;
            let [normal, tangential] = raft.rows(constraint);
            let along = |row: &[f64]| row.iter().zip(&after).map(|(j, v)| j * v).sum::<f64>();
            let room_mps = along(&normal) + constraint.rebound_mps;
            // The sweeps end at 1e-9 of the largest speed, some 0.05 m/s. Twice this allows for what neighbours still
            // pass on.
            let close_mps = 2e-9;
            assert!((0.0..=constraint.law_n).contains(&normal_n), "{normal_n}");
            if normal_n < constraint.law_n {
                assert!(room_mps < close_mps, "{normal_n} N: {room_mps} m/s");
            }
            if normal_n > 0.0 {
                assert!(room_mps > -close_mps, "{normal_n} N: {room_mps} m/s");
            }
            let spring_n = constraint.shear.force_n(along(&tangential));
            let limit_n = 0.1 * normal_n;
            let wanted_n = spring_n.clamp(-limit_n, limit_n);
            let within_n = constraint.shear.slope * close_mps;
            assert!((tangential_n - wanted_n).abs() <= within_n, "{tangential_n} for {wanted_n} N");
            slipping += u32::from(friction == Friction::Slip);
        }
    }
    assert!(slipping > 30, "{slipping} contacts slip");
}
