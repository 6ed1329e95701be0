//! One time step of Cummins' equation in six degrees of freedom, around the contact engine's step in the plane.
//!
//! The equation of motion is (M + A∞)ξ̈ + ∫K(t − τ) ξ̇ dτ + D ξ̇ + Cξ = F. The step of the motion is a leapfrog like
//! the contact engine's: velocities v belong to the middle between positions x. The water's memory and the damping D
//! act with the mean of the velocities before and after the step. The restoring matrix C acts with Numerov's weights,
//! which put a part of C on the left side:
//!
//! the step of length h solves (M + A∞ + h²C/12 + ½h(G + D)) v⁺ = (M + A∞ + h²C/12 − ½hD) v + h(F − Cx − ½(w + w′)),
//!
//! where w is the memory's force in the middle of the last step, and w′ + G v⁺ the memory's force in the middle of this
//! step. The step of the motion is stable for h² < 6M/C. For linear forces the step of the motion is of the fourth
//! order, with the memory of `Bank` and with excitation that has the same weights.
//!
//! The step of the motion has two parts, before and after contact. [`Motion::predict`], before contact, finds the new
//! velocities v⁺ under all forces except contact, and the load in the horizontal plane with which the contact engine's
//! mass matrix gives v⁺. [`Motion::settle`], after contact, finds heave, roll and pitch with the effects of contact:
//! the change of the velocities in the horizontal plane, and the moments of fenders by their heights. The effect of the
//! settled heave, roll and pitch on the motion in the plane acts in the next step.

use super::Seakeeping;
use super::matrix::{Matrix6, Six, plus, solve, times};
use super::matrix::{PLANE, UPRIGHT};
use super::memory::{Bank, Memory};
use fenderline_ship::attitude::{Attitude, AttitudeLoad};

/// The largest part of a contact's impulse that is guessed one step ahead of the contact. If a third of the impulse
/// were guessed, the motion would ring under a rigid contact.
const SMALL_PART: f64 = 0.25;

/// The equation of motion of a ship for one time step.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    mass: Matrix6,
    restoring: Matrix6,
    damping: Matrix6,
    bank: Bank,
    plane_mass: [[f64; 3]; 3],
    step_s: f64,
}

/// State of a ship's motion that one step leaves for the next: plain numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MotionState {
    memory: Memory,
    /// Velocities of the ship before the step, and the velocities that she would have after the step without contact.
    before: Six,
    without_contact: Six,
    /// Impulses in the horizontal plane that the last step left for this step (N·s, N·m·s).
    left: [f64; 3],
    /// The part of the impulses `left` that was guessed before contact was computed.
    ahead: [f64; 3],
}

impl MotionState {
    /// Copies another state into this state, without taking new memory.
    pub fn copy_from(&mut self, other: &MotionState) {
        let MotionState { memory, before, without_contact, left, ahead } = self;
        memory.copy_from(&other.memory);
        (*before, *without_contact) = (other.before, other.without_contact);
        (*left, *ahead) = (other.left, other.ahead);
    }
}

/// The load on a ship in a step, without the water's reaction to her motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepLoad {
    /// Force and moments on the ship in her axes about her centre of gravity.
    pub force: Six,
    /// The time for which forces change the velocities (s): the length of the step, but half of it in the first step.
    pub acts_s: f64,
}

impl Motion {
    /// Makes the equation of motion of a ship for a time step (s).
    #[must_use]
    pub fn new(ship: &Seakeeping, step_s: f64) -> Motion {
        let data = &*ship.data;
        let bank = Bank::new(data, step_s);
        let mass = plus(&data.total_mass(), 1.0, &bank.mass);
        let mut damping = bank.rest;
        let critical = 2.0 * (data.restoring[3][3] * mass[3][3]).sqrt();
        damping[3][3] += ship.roll_damping * critical;
        let restoring = data.restoring;
        let mut motion =
            Motion { mass, restoring, damping, bank, plane_mass: [[0.0; 3]; 3], step_s };
        motion.plane_mass = free_plane_mass(&motion.sides(step_s).0);
        motion
    }

    /// The mass matrix over surge, sway and yaw with which the contact engine moves the ship (kg, kg·m, kg·m²). The
    /// plane mass is the resistance to a push in the horizontal plane of a ship that is free to heave, roll and pitch.
    /// The plane mass includes the water's reaction within the step.
    #[must_use]
    pub fn plane_mass(&self) -> &[[f64; 3]; 3] {
        &self.plane_mass
    }

    /// The state of motion of a ship that has moved with a steady velocity for long: `velocity` is surge, sway and yaw
    /// through the water.
    #[must_use]
    pub fn start(&self, velocity: [f64; 3]) -> MotionState {
        let [surge, sway, yaw] = velocity;
        let memory = self.bank.steady([surge, sway, 0.0, 0.0, 0.0, yaw]);
        MotionState { memory, ..MotionState::default() }
    }

    /// The radiation damping, and the added mass less that at infinite frequency, for two motions at a frequency
    /// (rad/s), in steps of the motion's length.
    #[must_use]
    pub fn answer(&self, entry: [usize; 2], frequency_radps: f64) -> [f64; 2] {
        self.bank.answer(entry, frequency_radps)
    }

    /// The force of the water's memory against a motion that starts from rest, at the end of each step. The given
    /// velocities belong to the middles of steps. The part of the memory's force that acts as mass is subtracted,
    /// because it is in [`Motion::mass`].
    #[must_use]
    pub fn memory_force(&self, velocities: &[Six]) -> Vec<Six> {
        let mut memory = self.bank.steady([0.0; 6]);
        let force = |velocity: &Six| {
            let (now, ahead) = (self.bank.force(&memory), self.bank.force_ahead(&memory));
            let at_once = times(&self.bank.at_once, velocity);
            self.bank.advance(&mut memory, velocity);
            std::array::from_fn(|k| 0.5 * (now[k] + ahead[k] + at_once[k]))
        };
        velocities.iter().map(force).collect()
    }

    /// Mass matrix of the ship, with the part of the water's reaction that acts as mass in steps of this length.
    #[must_use]
    pub fn mass(&self) -> &Matrix6 {
        &self.mass
    }

    /// The small damping in place of the damping that the fit of the water's memory lacks.
    #[must_use]
    pub fn rest(&self) -> &Matrix6 {
        &self.bank.rest
    }

    /// The load in the horizontal plane that brings the contact engine's body to where the ship is without contact.
    /// `velocity` is the ship's velocity through the water in her axes: surge, sway, yaw.
    pub fn predict(
        &self,
        state: &mut MotionState,
        attitude: &Attitude,
        velocity: [f64; 3],
        load: &StepLoad,
    ) -> [f64; 3] {
        let Attitude { heave, roll, pitch } = attitude;
        let [surge, sway, yaw] = velocity;
        state.before = [surge, sway, heave.rate, roll.rate, pitch.rate, yaw];
        let mut impulse = self.impulse(state, attitude, load);
        for (index, left) in PLANE.into_iter().zip(state.left) {
            impulse[index] += left;
        }
        let (left_side, kept) = self.sides(load.acts_s);
        let right: Six = {
            let kept = times(&kept, &state.before);
            std::array::from_fn(|k| kept[k] + impulse[k])
        };
        state.without_contact =
            solve(&left_side, &right).unwrap_or_else(|| unreachable!("mass is positive"));
        let change = PLANE.map(|k| state.without_contact[k] - state.before[k]);
        self.plane_mass.map(|row| {
            row.iter().zip(change).map(|(mass, change)| mass * change).sum::<f64>() / load.acts_s
        })
    }

    /// Moves the ship's heave, roll and pitch over the step. `velocity` is the ship's velocity through the water after
    /// the step, in her axes before the step. `contact` is the load that contact puts on heave, roll and pitch.
    pub fn settle(
        &self,
        state: &mut MotionState,
        attitude: &mut Attitude,
        velocity: [f64; 3],
        contact: &AttitudeLoad,
        acts_s: f64,
    ) {
        let (left_side, _) = self.sides(acts_s);
        let by_contact: [f64; 3] =
            std::array::from_fn(|k| velocity[k] - state.without_contact[PLANE[k]]);
        let own: [[f64; 3]; 3] =
            std::array::from_fn(|i| std::array::from_fn(|j| left_side[UPRIGHT[i]][UPRIGHT[j]]));
        let loads = [contact.heave_n, contact.roll_nm, contact.pitch_nm];
        let right: [f64; 3] = std::array::from_fn(|i| {
            let coupled: f64 =
                (0..3).map(|j| left_side[UPRIGHT[i]][PLANE[j]] * by_contact[j]).sum();
            acts_s * loads[i] - coupled
        });
        let upright = solve(&own, &right).unwrap_or_else(|| unreachable!("mass is positive"));
        // The part of both changes that the engine's matrix does not include.
        let left: [f64; 3] = std::array::from_fn(|i| {
            let row = &left_side[PLANE[i]];
            (0..3)
                .map(|j| {
                    (self.plane_mass[i][j] - row[PLANE[j]]) * by_contact[j]
                        - row[UPRIGHT[j]] * upright[j]
                })
                .sum()
        });
        self.leave(state, left, by_contact);
        let mut after = state.without_contact;
        for k in 0..3 {
            after[PLANE[k]] = velocity[k];
            after[UPRIGHT[k]] += upright[k];
        }
        self.bank.advance(&mut state.memory, &after);
        let Attitude { heave, roll, pitch } = attitude;
        for (motion, index) in [heave, roll, pitch].into_iter().zip(UPRIGHT) {
            motion.rate = after[index];
            motion.value += self.step_s * after[index];
        }
    }

    /// Leaves an impulse in the horizontal plane to the next step, if contact changed the ship's velocities.
    ///
    /// The impulse that a step leaves acts one step late. A late impulse would add energy, because the moments of
    /// fenders are mostly restoring. If the impulse that is left is a small part of the contact's effect, the next step
    /// is therefore assumed to need the same change again, and any excess is taken back in the step after. If a large
    /// part of the contact's impulse were guessed ahead, the motion would ring.
    fn leave(&self, state: &mut MotionState, left: [f64; 3], by_contact: [f64; 3]) {
        let size = |impulse: [f64; 3]| -> f64 {
            (0..3).map(|k| impulse[k] * impulse[k] / self.plane_mass[k][k]).sum()
        };
        let contact = self
            .plane_mass
            .map(|row| row.iter().zip(by_contact).map(|(mass, change)| mass * change).sum::<f64>());
        let is_small = size(left) <= SMALL_PART * SMALL_PART * size(contact);
        let ahead = if is_small { left } else { [0.0; 3] };
        state.left = std::array::from_fn(|k| left[k] + ahead[k] - state.ahead[k]);
        state.ahead = ahead;
    }

    /// The matrices of the equation of motion that multiply the velocities after and before the step.
    fn sides(&self, acts_s: f64) -> (Matrix6, Matrix6) {
        let stiff = acts_s * self.step_s / 12.0;
        let inert = plus(&self.mass, stiff, &self.restoring);
        let after = plus(&inert, 0.5 * acts_s, &self.bank.at_once);
        (plus(&after, 0.5 * acts_s, &self.damping), plus(&inert, -0.5 * acts_s, &self.damping))
    }

    /// The impulse on the ship of the load, the restoring and the memory in a step.
    fn impulse(&self, state: &MotionState, attitude: &Attitude, load: &StepLoad) -> Six {
        let Attitude { heave, roll, pitch } = attitude;
        let stiff = times(&self.restoring, &[0.0, 0.0, heave.value, roll.value, pitch.value, 0.0]);
        let (now, ahead) = (self.bank.force(&state.memory), self.bank.force_ahead(&state.memory));
        std::array::from_fn(|k| {
            load.acts_s * (load.force[k] - stiff[k] - 0.5 * (now[k] + ahead[k]))
        })
    }
}

/// The mass matrix in the horizontal plane of a ship that is free in heave, roll and pitch (M_pp − M_pq M_qq⁻¹ M_qp; p:
/// plane, q: upright motions). The coupling of surge with sway and yaw is left out of the plane mass, because the
/// contact engine has none.
fn free_plane_mass(total: &Matrix6) -> [[f64; 3]; 3] {
    let block = |rows: [usize; 3], columns: [usize; 3]| -> [[f64; 3]; 3] {
        rows.map(|row| columns.map(|column| total[row][column]))
    };
    let (own, couplings) = (block(UPRIGHT, UPRIGHT), block(UPRIGHT, PLANE));
    let mut mass = block(PLANE, PLANE);
    for column in 0..3 {
        let coupling = couplings.map(|row| row[column]);
        let follows = solve(&own, &coupling).unwrap_or_else(|| unreachable!("mass is positive"));
        for (row, mass) in mass.iter_mut().enumerate() {
            let lost: f64 = (0..3).map(|k| total[PLANE[row]][UPRIGHT[k]] * follows[k]).sum();
            mass[column] -= lost;
        }
    }
    let coupling = 0.5 * (mass[1][2] + mass[2][1]);
    [[mass[0][0], 0.0, 0.0], [0.0, mass[1][1], coupling], [0.0, coupling, mass[2][2]]]
}
