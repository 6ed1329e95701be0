//! A ship aground on a bottom that is not level.
//!
//! **Lift.** Where the bottom is above the keel of the ship as she floats, it lifts her: she rises, trims and, with
//! data of her stability, heels. The lift is quasi-static: each station under the lifted hull ([`super::soundings`]) is
//! at or above the bottom, and no other rise, trim and heel needs less energy. The energy E of the lift depends on the
//! ship's place alone. The bottom's horizontal force is minus the gradient of E: for each station, the load on the
//! station times the slope of the bottom under the station, towards deeper water. Rise and trim are those of a
//! rectangular waterplane of block coefficient × length × beam, about midship. Other parts of the program use the
//! draught, heel and trim of the ship without this lift.
//!
//! **Friction.** The friction is Coulomb's: 0.4 of the load that the bottom carries, as on a level bottom. It acts at
//! the centre of this load. The arm of friction against turning is the mean distance of the load from its centre along
//! the ship, so a ship with her bow on a bank swings about her bow. The slope of the bottom is taken to be small:
//! friction is horizontal, and is 0.4 of the vertical load.
//!
//! **The step.** The bottom's force is the mean over the ship's path in the step, and depends on the ship's velocity at
//! the end of the step (implicit). So the lift takes and returns the same energy with any time step, and friction never
//! reverses the ship.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Rotation, Vec2, vec2};
use fenderline_seakeeping::matrix;
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;
use fenderline_ship::hydro::Force;

use super::environment::{Bottom, Environment};
use super::soundings::{STATIONS, stations};
use super::vessel::{BOTTOM_FRICTION, SLOW_MPS, VesselSetup};

/// How much a station sinks into the bottom, divided by the rise of a ship on a level bottom. Because stations sink in,
/// the load is shared among several stations. The waterplane is stiffer by the same share, so that a level bottom
/// carries exactly the weight that the water does not carry. Our choice.
const YIELD: f64 = 0.001;
/// Places on the ship's path in a step, divided by the length of the path, and their weights: Simpson's rule on each
/// half of the path.
const WAY: [(f64, f64); 5] = [
    (0.0, 1.0 / 12.0),
    (0.25, 4.0 / 12.0),
    (0.5, 2.0 / 12.0),
    (0.75, 4.0 / 12.0),
    (1.0, 1.0 / 12.0),
];
/// Largest number of iterations for the velocity at the end of a step, and the change of velocity at which the
/// iteration ends (m/s).
const ITERATIONS: (usize, f64) = (60, 1e-10);
/// Places and depths may be rounded by as much (m).
const ROUNDING_M: f64 = 1e-3;
/// Largest number of changes of the set of stations that touch the bottom.
const CHANGES: usize = 40;

type Vector = [f64; 3];
type Matrix = [[f64; 3]; 3];

/// Solves linear equations with a positive definite matrix of stiffness or mass, which is never singular.
fn solve(matrix: &Matrix, right: &Vector) -> Vector {
    matrix::solve(matrix, right).expect("stiffness and mass are not singular")
}

fn dot(a: &Vector, b: &Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn add_outer(into: &mut Matrix, factor: f64, a: &Vector, b: &Vector) {
    for (row, a) in into.iter_mut().zip(a) {
        for (entry, b) in row.iter_mut().zip(b) {
            *entry += factor * a * b;
        }
    }
}

fn times(a: &Matrix, b: &Vector) -> Vector {
    [dot(&a[0], b), dot(&a[1], b), dot(&a[2], b)]
}

/// A hull whose keel may touch a bottom that is not level.
struct Keel<'a> {
    setup: &'a VesselSetup,
    environment: &'a Environment,
    /// Depth of the keel below datum (m) of the ship as she floats, with her squat.
    keel_m: f64,
    /// Stiffness of the waterplane against rise (N/m), trim and heel (N·m/rad). `bottom_npm` is the stiffness of the
    /// bottom under the whole hull (N/m).
    afloat: Vector,
    bottom_npm: f64,
    can_heel: bool,
}

/// The force of the bottom on a hull in one position.
#[derive(Clone, Copy, Default)]
struct Load {
    /// Energy that the lift of the hull takes (J).
    lift_j: f64,
    /// Horizontal force of the bottom by its slopes: forward and to starboard (N), and yaw moment about the centre of
    /// gravity (N·m), in the ship's axes at the start of the step.
    force: Vector,
    /// −∂force/∂(place, heading).
    stiffness: Matrix,
    /// Vertical load (N). `moment_nm` is this load times the distance of its centre forward and to starboard of the
    /// centre of gravity (N·m). `turning_nm` is this load times its mean distance from its centre, along the ship
    /// (N·m).
    vertical_n: f64,
    moment_nm: Vec2,
    turning_nm: f64,
}

impl<'a> Keel<'a> {
    fn new(
        setup: &'a VesselSetup,
        environment: &'a Environment,
        squat_m: f64,
        t_s: f64,
    ) -> Keel<'a> {
        let hull = &setup.ship.particulars;
        let specific_npm3 = environment.water_density_kgpm3 * STANDARD_GRAVITY_MPS2;
        let plane_m2 = hull.block_coefficient() * hull.length_m * hull.beam_m;
        let rise_npm = specific_npm3 * plane_m2;
        let heel_nm = setup.float.map(|float| float.hydrostatics.roll.restoring);
        let stiffer = 1.0 + YIELD;
        let trim_nm = rise_npm * hull.length_m * hull.length_m / 12.0;
        Keel {
            setup,
            environment,
            keel_m: hull.draught_m + squat_m - environment.level_m(t_s),
            // A ship that cannot heel has no column for heel; the entry is there for the solution alone.
            afloat: [rise_npm, trim_nm, heel_nm.unwrap_or(1.0)].map(|entry| stiffer * entry),
            bottom_npm: rise_npm * (1.0 + 1.0 / YIELD),
            can_heel: heel_nm.is_some(),
        }
    }

    /// Whether the bottom is below the keel all around a ship, so that no station touches on a way of this length (m). A
    /// few look-ups then replace the soundings under all stations along the way.
    fn is_clear_of(&self, bottom: &Bottom, state: &BodyState, way_m: f64) -> bool {
        let hull = &self.setup.ship.particulars;
        // The farthest station from the centre of gravity: a corner of the rectangle of length and beam.
        let ahead_m = 0.5 * hull.length_m + hull.centre_of_gravity_m.abs();
        let reach_m = libm::sqrt(ahead_m * ahead_m + 0.25 * hull.beam_m * hull.beam_m);
        let least_m = bottom.field.at_least_m(state.position_m, reach_m + way_m + ROUNDING_M);
        least_m.is_some_and(|least_m| least_m >= self.keel_m + ROUNDING_M)
    }

    /// The force of the bottom after the ship has moved forward and to starboard (m) and has turned (rad) from the
    /// state `from`, in the ship's axes in that state.
    fn load(&self, from: &BodyState, moved: &Vector) -> Load {
        let axes = Rotation::from_angle(from.heading_rad);
        let at_m = from.position_m + axes.apply(vec2(moved[0], moved[1]));
        let turn = Rotation::from_angle(from.heading_rad + moved[2]);
        let hull = &self.setup.ship.particulars;
        let mut touching = [Station::default(); STATIONS];
        let mut count = 0;
        for (station_m, weight, _) in stations(hull) {
            let about_gravity = station_m - vec2(hull.centre_of_gravity_m, 0.0);
            let arm_m = turn.apply(about_gravity);
            // A step may end beyond the data; the next step then ends the run with an error.
            let Some((depth_m, gradient)) =
                self.environment.bottom.as_ref().and_then(|bottom| bottom.sounding(at_m + arm_m))
            else {
                continue;
            };
            let sunk_m = self.keel_m - depth_m;
            if sunk_m <= 0.0 {
                continue;
            }
            let own = axes.apply_inverse(gradient);
            let own_arm_m = axes.apply_inverse(arm_m);
            touching[count] = Station {
                arm_m: own_arm_m,
                sunk_m,
                spring_npm: weight * self.bottom_npm,
                lifts: [1.0, station_m.x, if self.can_heel { -station_m.y } else { 0.0 }],
                slope: [own.x, own.y, own_arm_m.cross(own)],
                load_n: 0.0,
                touches: true,
            };
            count += 1;
        }
        if count == 0 {
            return Load::default();
        }
        self.lift(&mut touching[..count])
    }

    /// Finds the rise, trim and heel of the hull with the least energy, and sums the loads on the stations.
    fn lift(&self, stations: &mut [Station]) -> Load {
        let mut held = [[0.0; 3]; 3];
        let mut rise = [0.0; 3];
        for _ in 0..CHANGES {
            held = [
                [self.afloat[0], 0.0, 0.0],
                [0.0, self.afloat[1], 0.0],
                [0.0, 0.0, self.afloat[2]],
            ];
            let mut pushes = [0.0; 3];
            for of in stations.iter().filter(|of| of.touches) {
                add_outer(&mut held, of.spring_npm, &of.lifts, &of.lifts);
                for (push, lift) in pushes.iter_mut().zip(of.lifts) {
                    *push += of.spring_npm * of.sunk_m * lift;
                }
            }
            rise = solve(&held, &pushes);
            let mut is_same = true;
            for of in stations.iter_mut() {
                let pressed_m = of.sunk_m - dot(&of.lifts, &rise);
                let touches = pressed_m > 0.0;
                is_same &= touches == of.touches;
                of.touches = touches;
                of.load_n = if touches { of.spring_npm * pressed_m } else { 0.0 };
            }
            if is_same {
                break;
            }
        }
        let mut load = Load::default();
        let mut mixed = [[0.0; 3]; 3];
        for (stiff, up) in self.afloat.iter().zip(rise) {
            load.lift_j += 0.5 * stiff * up * up;
        }
        for of in stations.iter().filter(|of| of.touches) {
            load.lift_j += 0.5 * of.load_n * of.load_n / of.spring_npm;
            for (force, slope) in load.force.iter_mut().zip(of.slope) {
                *force += of.load_n * slope;
            }
            load.vertical_n += of.load_n;
            load.moment_nm += of.arm_m * of.load_n;
            add_outer(&mut load.stiffness, of.spring_npm, &of.slope, &of.slope);
            add_outer(&mut mixed, of.spring_npm, &of.slope, &of.lifts);
        }
        // The stiffness less the part by which the ship gives way: S − B H⁻¹ Bᵀ.
        let gives = mixed.map(|row| solve(&held, &row));
        for (row, mixed) in load.stiffness.iter_mut().zip(&mixed) {
            for (entry, gives) in row.iter_mut().zip(&gives) {
                *entry -= dot(mixed, gives);
            }
        }
        if load.vertical_n > 0.0 {
            let centre_m = load.moment_nm * (1.0 / load.vertical_n);
            let arms = stations.iter().map(|of| of.load_n * (of.arm_m.x - centre_m.x).abs());
            load.turning_nm = arms.sum();
        }
        load
    }
}

/// A point under the hull at which the bottom is above the keel of the ship as she floats.
#[derive(Clone, Copy, Default)]
struct Station {
    /// Distances of the station forward and to starboard of the centre of gravity (m).
    arm_m: Vec2,
    /// Height of the bottom above the keel of the ship as she floats (m).
    sunk_m: f64,
    /// Stiffness of the bottom under the station (N/m).
    spring_npm: f64,
    /// How much the station moves up per unit of the hull's rise, trim and heel.
    lifts: Vector,
    /// How much the depth under the station increases per unit of the ship's motion forward, to starboard and in yaw.
    slope: Vector,
    load_n: f64,
    touches: bool,
}

/// The ship's mass, the other forces on her and the times of a step, with which the bottom's force in the step is
/// found.
pub(super) struct Step {
    /// Mass matrix over surge, sway and yaw about the centre of gravity.
    pub(super) mass: Matrix,
    /// All other forces on the ship: forward and to starboard (N), and yaw moment about the centre of gravity (N·m).
    pub(super) given: Vector,
    /// Time for which forces change the ship's velocity in the step (s). `lag_s` is the time by which her velocity is
    /// older than her position (s).
    pub(super) acts_s: f64,
    pub(super) lag_s: f64,
}

impl VesselSetup {
    /// The force of a bottom that is not level, about midship: see the head of this file. The force is zero if no
    /// station touches the bottom in the step.
    pub(super) fn on_slope(
        &self,
        state: &BodyState,
        environment: &Environment,
        squat_m: f64,
        t_s: f64,
        step: &Step,
    ) -> Force {
        let Some(bottom) = &environment.bottom else { return Force::default() };
        let keel = Keel::new(self, environment, squat_m, t_s);
        if bottom.range_m()[0] >= keel.keel_m {
            return Force::default();
        }
        let axes = Rotation::from_angle(state.heading_rad);
        let own = axes.apply_inverse(state.velocity_mps);
        let before = [own.x, own.y, state.yaw_rate_radps];
        if keel.is_clear_of(bottom, state, way(&before, step)) {
            return Force::default();
        }
        let [surge_n, sway_n, yaw_nm] = mean_force(&keel, state, before, step);
        let ahead_m = self.ship.particulars.centre_of_gravity_m;
        Force { surge_n, sway_n, yaw_nm: yaw_nm + ahead_m * sway_n }
    }
}

/// The velocity at the end of a step without a load of the bottom.
fn after_without_load(before: &Vector, Step { mass, given, acts_s, .. }: &Step) -> Vector {
    let momentum = times(mass, before);
    solve(mass, &[0, 1, 2].map(|k| momentum[k] + acts_s * given[k]))
}

/// How far a ship comes from her place on the way of a step on which the bottom does not touch her (m).
fn way(before: &Vector, step: &Step) -> f64 {
    let after = after_without_load(before, step);
    let moved = |speed: &Vector, time_s: f64| {
        time_s.abs() * libm::sqrt(speed[0] * speed[0] + speed[1] * speed[1])
    };
    greater(moved(before, step.lag_s), moved(&after, step.acts_s - step.lag_s))
}

/// The mean force of the bottom over the ship's path from the time of her last velocity to the time of her next
/// velocity.
fn mean_force(keel: &Keel<'_>, state: &BodyState, before: Vector, step: &Step) -> Vector {
    let Step { mass, given, acts_s, lag_s } = step;
    let ahead_s = acts_s - lag_s;
    let from = before.map(|speed| -lag_s * speed);
    let momentum = times(mass, &before);
    let mut after = after_without_load(&before, step);
    let start = keel.load(state, &from);
    let mut force = [0.0; 3];
    for _ in 0..ITERATIONS.0 {
        let to = after.map(|speed| ahead_s * speed);
        let mut on_way = Load::default();
        for (share, weight) in WAY {
            let load = if share == 0.0 {
                start
            } else {
                keel.load(state, &[0, 1, 2].map(|k| from[k] + share * (to[k] - from[k])))
            };
            for k in 0..3 {
                on_way.force[k] += weight * load.force[k];
                for j in 0..3 {
                    on_way.stiffness[k][j] += weight * share * load.stiffness[k][j];
                }
            }
            on_way.vertical_n += weight * load.vertical_n;
            on_way.moment_nm += load.moment_nm * weight;
            on_way.turning_nm += weight * load.turning_nm;
        }
        if on_way.vertical_n <= 0.0 {
            return [0.0; 3];
        }
        let drag = friction(&on_way, &after);
        force = on_way.force;
        for (force, drag) in force.iter_mut().zip(times(&drag, &after)) {
            *force -= drag;
        }
        // One step of Newton's method for the velocity at the end of the step, with the friction's speed held.
        let mut slope = *mass;
        let mut off = [0.0; 3];
        for k in 0..3 {
            for j in 0..3 {
                slope[k][j] += acts_s * (ahead_s * on_way.stiffness[k][j] + drag[k][j]);
            }
            off[k] = momentum[k] + acts_s * (given[k] + force[k]) - dot(&mass[k], &after);
        }
        let change = solve(&slope, &off);
        for (after, change) in after.iter_mut().zip(change) {
            *after += change;
        }
        let hull = &keel.setup.ship.particulars;
        let most_mps = change[0].abs() + change[1].abs() + change[2].abs() * hull.length_m;
        if most_mps < ITERATIONS.1 {
            break;
        }
    }
    force
}

/// The matrix by which the velocity is multiplied to give the friction. Friction by this matrix always takes energy
/// from the ship.
fn friction(load: &Load, velocity: &Vector) -> Matrix {
    let centre_m = load.moment_nm * (1.0 / load.vertical_n);
    let arm_m = load.turning_nm / load.vertical_n;
    let [surge, sway, yaw] = *velocity;
    let at_centre = vec2(surge - centre_m.y * yaw, sway + centre_m.x * yaw);
    let turning = arm_m * yaw;
    let speed_mps = libm::sqrt(at_centre.length_squared() + turning * turning);
    let per_speed = BOTTOM_FRICTION * load.vertical_n / (speed_mps + SLOW_MPS);
    let mut drag = [[0.0; 3]; 3];
    for of in [[1.0, 0.0, -centre_m.y], [0.0, 1.0, centre_m.x], [0.0, 0.0, arm_m]] {
        add_outer(&mut drag, per_speed, &of, &of);
    }
    drag
}
