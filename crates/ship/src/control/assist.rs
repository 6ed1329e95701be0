//! Control laws of a tug that is a vessel of her own and assists a ship. A tug that assists a ship keeps a position
//! relative to the ship, comes alongside and pushes, or pulls on a line. Each control law takes the states of tug and
//! ship, and gives a velocity and a heading, or a thrust. The tug's thrusters follow the velocity, the heading and the
//! thrust that the control law gives.
//!
//! The control laws of the tug are simple, and our own: we found no published law. A tug does not find her way round a
//! ship, so bring the tug to the right side of the ship first.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Rotation, Vec2};

use super::station::Demand;
use super::thrust::Sway;
use super::turn_to;

/// Speed at which a tug makes contact (m/s), unless a lower speed is ordered.
pub const TOUCH_MPS: f64 = 0.1;
/// With errors of heading (rad) and of position along the ship's side (m) as large as these, a tug waits at the
/// stand-off distance.
const WAIT_ERRORS: [f64; 2] = [0.25, 3.0];
/// Share of [`WAIT_ERRORS`] below which errors do not make the tug wait.
const NEAR_ENOUGH: f64 = 0.3;
/// Stand-off distance from the ship's side, divided by the tug's length.
const STAND_OFF: f64 = 0.5;
/// Greatest error of heading with which a tug pushes (rad).
const ASKEW_RAD: f64 = 0.6;
/// Share of the ordered force from which on friction holds the tug's bow in place along the ship's side.
const HELD_SHARE: f64 = 0.25;
/// Factor by which the yaw gain is multiplied while friction holds the tug's bow. While friction holds a tug's bow, the
/// tug turns about her bow instead of her centre of gravity, with more inertia.
const HELD_YAW_GAIN: f64 = 6.0;
/// Distance from her position, divided by the tug's length, and speed (m/s), from which on a tug goes bow first.
const FAR: f64 = 0.75;
const BOW_FIRST_MPS: f64 = 0.5;
/// Factor by which the time constant of position is multiplied for the last metres to the ship, because the thrusters
/// lag.
const PATIENCE: f64 = 1.6;
/// Speeds ahead at which a tug begins to correct her position by steering, and at which she corrects it by steering
/// alone (m/s).
const STEERS_MPS: [f64; 2] = [0.5, 1.5];
/// Largest change of heading with which a tug corrects her position by steering (rad).
const MOST_STEERED_RAD: f64 = 0.5;
/// A tug that steers pushes ahead with at least this share of her resistance, and with at least her yaw moment over her
/// length, so that her units stay within some 70° of ahead. Units that pushed astern instead would turn through the
/// stream, which gives them side forces that turn the tug. A small excess of speed is left to her resistance.
const LEAST_AHEAD: f64 = 0.1;
/// A tug at speed brakes by her units if she is faster than her task asks for by this much (m/s).
const BRAKES_MPS: f64 = 1.5;
/// Speed away from the ship while the tug takes up the last slack of a line (m/s).
const TAKE_UP_MPS: f64 = 0.3;

/// Constants for the control of a tug: her inertia, time constants and greatest rate of turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handling {
    /// Mass in surge and sway and inertia in yaw of the vessel, with added mass (kg, kg, kg·m²).
    pub inertia: [f64; 3],
    /// Time constant with which the control corrects errors of speed (s).
    pub speed_time_s: f64,
    /// Time constant with which the control corrects errors of position and heading (s).
    pub place_time_s: f64,
    /// Greatest rate of turn that the control asks for (rad/s).
    pub fastest_turn_radps: f64,
    /// Length of the vessel (m).
    pub length_m: f64,
}

impl Handling {
    /// Control constants from the vessel's length: time constants of 5 s and 20 s for a tug of 32 m, scaled by Froude's
    /// law. The control constants for a tug of 32 m are our own values.
    #[must_use]
    pub fn of(inertia: [f64; 3], length_m: f64) -> Handling {
        let scale = libm::sqrt(length_m / 32.0);
        Handling {
            inertia,
            speed_time_s: 5.0 * scale,
            place_time_s: 20.0 * scale,
            fastest_turn_radps: 0.08 / scale,
            length_m,
        }
    }

    /// The heading for a tug that is far from her wanted position. A tug goes to a far position bow first, because the
    /// azimuth units at her stern move her sideways only slowly.
    fn bow_first(&self, off: Vec2, going_mps: Vec2) -> Option<f64> {
        let far = off.length() > FAR * self.length_m && going_mps.length() > BOW_FIRST_MPS;
        far.then(|| libm::atan2(going_mps.y, going_mps.x))
    }

    /// The moment (N·m) that turns the vessel to a heading, minus the known moment of a disturbance.
    #[must_use]
    pub fn turning_moment(&self, state: &BodyState, heading_rad: f64, disturbance_nm: f64) -> f64 {
        let turn = turn_to(state.heading_rad, heading_rad) / self.place_time_s;
        let turn = bounded(turn, -self.fastest_turn_radps, self.fastest_turn_radps);
        self.inertia[2] / self.speed_time_s * (turn - state.yaw_rate_radps) - disturbance_nm
    }
}

/// The task of a tug in a step, with positions and velocities of points of the ship, earth-fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Task {
    /// The tug keeps a position that moves with the ship.
    Follow {
        /// The position (m).
        place_m: Vec2,
        /// Velocity of the position that the tug keeps (m/s).
        velocity_mps: Vec2,
        /// The heading (rad).
        heading_rad: f64,
    },
    /// Push with her bow.
    Push {
        /// Point of the ship's side on which the tug pushes (m).
        place_m: Vec2,
        /// Velocity of the point of the ship's side on which the tug pushes (m/s).
        velocity_mps: Vec2,
        /// Unit vector from the pushed point into the ship.
        inward: Vec2,
        /// Distance from the tug's centre of gravity to the tip of her bow, bow fender included (m).
        bow_m: f64,
        /// Ordered force (N).
        force_n: f64,
        /// Contact force between tug and ship in the last step (N).
        contact_n: f64,
    },
    /// Pull on a line.
    Pull {
        /// Position of the ship's end of the line (m).
        place_m: Vec2,
        /// Velocity of the ship's end of the line (m/s).
        velocity_mps: Vec2,
        /// Unit vector in the direction in which the line pulls the ship.
        outward: Vec2,
        /// True if the line leads over the tug's bow: the tug then faces the ship and pulls astern.
        over_bow: bool,
        /// Slack of the line: its length minus the distance between its ends (m).
        slack_m: f64,
        /// Ordered force (N).
        force_n: f64,
        /// Tension of the line in the last step (N).
        tension_n: f64,
    },
}

/// How a tug uses her azimuth units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitUse {
    /// At rest or slow: the units push in any direction.
    AnyDirection,
    /// At speed: the units push ahead and steer, like rudders.
    Steering,
    /// At speed, and much too fast: the units push against each other and astern.
    Braking,
}

/// What the tug's task demands of her thrusters in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AssistDemand {
    /// Force and moment demanded.
    pub demand: Demand,
    /// Whether the thrusters must meet the demanded sway force.
    pub sway: Sway,
    /// How the tug uses her azimuth units.
    pub units: UnitUse,
}

/// How much of the position error a tug corrects by steering, 0 to 1, and the change of heading with which she does so
/// (rad). A tug at speed is turned by the azimuth units at her stern long before they move her sideways.
fn steered(going_mps: Vec2, heading_rad: f64) -> (f64, f64) {
    let own = Rotation::from_angle(heading_rad).apply_inverse(going_mps);
    let [begins_mps, whole_mps] = STEERS_MPS;
    let share = bounded((own.x - begins_mps) / (whole_mps - begins_mps), 0.0, 1.0);
    // Without speed ahead a tug cannot steer, and the angle is undefined.
    let angle_rad = if share > 0.0 { libm::atan2(own.y, own.x) } else { 0.0 };
    (share, share * bounded(angle_rad, -MOST_STEERED_RAD, MOST_STEERED_RAD))
}

/// What is demanded of the tug's thrusters, in her axes about her centre of gravity.
///
/// `disturbance` is the force of hull, wind and waves on the tug in the last step, for which the demand compensates.
/// `fastest_mps` limits the tug's speed relative to the ship. `steady_nm` is the moment that the integral part of the
/// yaw control gives.
#[must_use]
pub fn assist(
    task: &Task,
    handling: &Handling,
    state: &BodyState,
    disturbance: &Demand,
    fastest_mps: f64,
    steady_nm: f64,
) -> AssistDemand {
    let (mut sway, mut steers) = (Sway::Held, false);
    let (mut thrust_n, mut yaw_gain) = (None, 1.0);
    let (velocity_mps, heading_rad) = match *task {
        Task::Follow { place_m, velocity_mps, heading_rad } => {
            let off = place_m - state.position_m;
            let going = velocity_mps + limited(off * (1.0 / handling.place_time_s), fastest_mps);
            let (share, steered_rad) = steered(going, heading_rad);
            steers = share >= 1.0;
            if steers {
                sway = Sway::Free;
            }
            (going, handling.bow_first(off, going).unwrap_or(heading_rad + steered_rad))
        }
        Task::Push { place_m, velocity_mps, inward, bow_m, force_n, contact_n } => {
            let heading_rad = libm::atan2(inward.y, inward.x);
            let turn = turn_to(state.heading_rad, heading_rad);
            if contact_n > 0.0 && turn.abs() < ASKEW_RAD {
                thrust_n = Some(force_n);
                yaw_gain = HELD_YAW_GAIN;
                if contact_n > HELD_SHARE * force_n {
                    sway = Sway::Free;
                }
            }
            let beside_m = place_m - inward * bow_m;
            let way = alongside(state, handling, beside_m, inward, fastest_mps);
            let going = velocity_mps + way;
            let off = beside_m - inward * (STAND_OFF * handling.length_m) - state.position_m;
            (going, handling.bow_first(off, going).unwrap_or(heading_rad))
        }
        Task::Pull { place_m, velocity_mps, outward, over_bow, slack_m, force_n, tension_n } => {
            let facing = if over_bow { -outward } else { outward };
            let off = place_m - state.position_m;
            let across = off - outward * off.dot(outward);
            let way = limited(across * (1.0 / handling.place_time_s), fastest_mps);
            let out_mps = if tension_n > 0.0 {
                // On a taut line the tug damps her speed.
                let along = Rotation::from_angle(state.heading_rad).apply_inverse(facing).x;
                let out_mps = (state.velocity_mps - velocity_mps).dot(outward);
                let eased_n = force_n - handling.inertia[0] / handling.speed_time_s * out_mps;
                thrust_n = Some(along * if over_bow { -eased_n } else { eased_n });
                0.0
            } else {
                lesser(greater(slack_m / handling.place_time_s, TAKE_UP_MPS), fastest_mps)
            };
            (velocity_mps + way + outward * out_mps, libm::atan2(facing.y, facing.x))
        }
    };
    let attitude = Rotation::from_angle(state.heading_rad);
    let error = attitude.apply_inverse(velocity_mps - state.velocity_mps);
    let stiff = 1.0 / handling.speed_time_s;
    let [surge_kg, sway_kg, _] = handling.inertia;
    let yaw_nm = yaw_gain * handling.turning_moment(state, heading_rad, 0.0) - disturbance.yaw_nm
        + steady_nm;
    let surge_n = thrust_n.unwrap_or(surge_kg * stiff * error.x) - disturbance.surge_n;
    let units = if !steers {
        UnitUse::AnyDirection
    } else if error.x < -BRAKES_MPS {
        UnitUse::Braking
    } else {
        UnitUse::Steering
    };
    let surge_n = if units == UnitUse::Steering {
        let turning_n = yaw_nm.abs() / handling.length_m;
        greater(surge_n, greater(-LEAST_AHEAD * disturbance.surge_n, turning_n))
    } else {
        surge_n
    };
    let sway_n = sway_kg * stiff * error.y - disturbance.sway_n;
    AssistDemand { demand: Demand { surge_n, sway_n, yaw_nm }, sway, units }
}

/// Velocity of the tug relative to the ship while she comes alongside. The tug goes to the stand-off distance until her
/// heading and her position along the side are right, and then on until she makes contact with the ship.
fn alongside(
    state: &BodyState,
    handling: &Handling,
    place_m: Vec2,
    inward: Vec2,
    fastest_mps: f64,
) -> Vec2 {
    let off = place_m - state.position_m;
    let gap_m = off.dot(inward);
    let across = off - inward * gap_m;
    let turn = turn_to(state.heading_rad, libm::atan2(inward.y, inward.x));
    let astray = greater(turn.abs() / WAIT_ERRORS[0], across.length() / WAIT_ERRORS[1]);
    let waits = bounded((astray - NEAR_ENOUGH) / (1.0 - NEAR_ENOUGH), 0.0, 1.0);
    let to_go_m = gap_m - waits * STAND_OFF * handling.length_m;
    let touch_mps = lesser(TOUCH_MPS, fastest_mps);
    let closing = to_go_m / (PATIENCE * handling.place_time_s) + touch_mps * (1.0 - waits);
    // At the side, the tug moves no faster than the contact speed.
    let most_mps = if gap_m <= 0.0 { touch_mps } else { fastest_mps };
    inward * bounded(closing, -fastest_mps, most_mps)
        + limited(across * (1.0 / handling.place_time_s), fastest_mps)
}

/// Returns a vector, shortened to the length `longest` if the vector is longer.
fn limited(vector: Vec2, longest: f64) -> Vec2 {
    let length = vector.length();
    if length > longest { vector * (longest / length) } else { vector }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fenderline_contact::vec2;

    const HANDLING: Handling = Handling {
        inertia: [1e6, 1.6e6, 8e7],
        speed_time_s: 5.0,
        place_time_s: 20.0,
        fastest_turn_radps: 0.08,
        length_m: 30.0,
    };

    fn push(place_m: Vec2, contact_n: f64) -> Task {
        Task::Push {
            place_m,
            velocity_mps: Vec2::ZERO,
            inward: vec2(1.0, 0.0),
            bow_m: 16.0,
            force_n: 3e5,
            contact_n,
        }
    }

    #[test]
    fn a_tug_that_points_the_wrong_way_stands_off_and_turns() {
        let away = BodyState { heading_rad: 2.0, ..BodyState::default() };
        let asked =
            assist(&push(vec2(18.0, 0.0), 0.0), &HANDLING, &away, &Demand::default(), 1.0, 0.0);
        let ahead =
            Rotation::from_angle(2.0).apply(vec2(asked.demand.surge_n, asked.demand.sway_n));
        assert!(ahead.x < 0.0, "off the ship: {ahead:?}");
        assert!(asked.demand.yaw_nm < 0.0);
    }

    #[test]
    fn she_approaches_slowly_and_pushes_on_contact() {
        let state = BodyState { velocity_mps: vec2(TOUCH_MPS, 0.0), ..BodyState::default() };
        let near =
            assist(&push(vec2(16.0, 0.0), 0.0), &HANDLING, &state, &Demand::default(), 1.0, 0.0);
        assert!(near.demand.surge_n.abs() < 1e-6, "as fast as she may: {near:?}");
        let on =
            assist(&push(vec2(15.9, 0.0), 1e5), &HANDLING, &state, &Demand::default(), 1.0, 0.0);
        assert_eq!((on.demand.surge_n, on.sway), (3e5, Sway::Free));
    }
}
