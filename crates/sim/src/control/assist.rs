//! What a tug that is a vessel of her own does at a ship: keeps beside her, comes to her side and pushes,
//! pulls on a line. Each law turns where both are into a velocity, a heading or a plain thrust; thrusters do
//! the rest.
//!
//! They are simple and ours: no published tug master's law was found. A tug does not find her way round a
//! ship: bring her to the right side first.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Rotation, Vec2};

use super::station::Demand;
use super::thrust::Sway;
use super::turn_to;

/// The speed at which a tug touches (m/s), unless she is told to come slower.
pub const TOUCH_MPS: f64 = 0.1;
/// Heading (rad) and way along the side (m) by which she may be off before she waits to come alongside.
const OFF: [f64; 2] = [0.25, 3.0];
/// What part of it does not count: near enough is there.
const NEAR_ENOUGH: f64 = 0.3;
/// She waits so far off, in her own lengths.
const STAND_OFF: f64 = 0.5;
/// Beyond this heading off the ship's normal she does not push on (rad).
const ASKEW_RAD: f64 = 0.6;
/// With this part of the ordered force on her bow, friction holds it along the side.
const HOLDS: f64 = 0.25;
/// A tug whose bow is held turns about it, not about her centre of gravity: so much heavier is she to turn with
/// thrusters at her stern, and so much less is it to leave to chance that friction drags her bow along.
const LEANING: f64 = 6.0;
/// So far off, in her own lengths, and from this speed on (m/s), she goes bow first.
const FAR: f64 = 0.75;
const BOW_FIRST_MPS: f64 = 0.5;
/// On the last metres she takes so much longer than elsewhere: her thrusters lag behind.
const PATIENCE: f64 = 1.6;
/// Ahead at these speeds she begins to steer back to her place, and does nothing else (m/s).
const STEERS_MPS: [f64; 2] = [0.5, 1.5];
/// By no more than this (rad).
const MOST_STEERED_RAD: f64 = 0.5;
/// Outwards on a line that is about to come tight (m/s).
const TAKE_UP_MPS: f64 = 0.3;

/// How a vessel is handled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handling {
    /// Mass in surge and sway, inertia in yaw, added mass included (kg, kg, kg·m²).
    pub inertia: [f64; 3],
    /// Time in which an error of speed is taken off (s).
    pub speed_time_s: f64,
    /// Time in which an error of place or heading is (s).
    pub place_time_s: f64,
    /// The fastest turn that is asked for (rad/s).
    pub fastest_turn_radps: f64,
    /// Her length (m).
    pub length_m: f64,
}

impl Handling {
    /// Of a vessel by her length: 5 s and 20 s for a tug of 32 m, by Froude's law for others. Ours.
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

    /// The heading of one who is still far from where she shall be: she goes there bow first, as units at her
    /// stern drive her sideways only slowly.
    fn bow_first(&self, off: Vec2, going_mps: Vec2) -> Option<f64> {
        let far = off.length() > FAR * self.length_m && going_mps.length() > BOW_FIRST_MPS;
        far.then(|| libm::atan2(going_mps.y, going_mps.x))
    }

    /// The moment (N·m) that brings her to a heading, against one that she feels.
    #[must_use]
    pub fn turning_moment(&self, state: &BodyState, heading_rad: f64, felt_nm: f64) -> f64 {
        let turn = turn_to(state.heading_rad, heading_rad) / self.place_time_s;
        let turn = bounded(turn, -self.fastest_turn_radps, self.fastest_turn_radps);
        self.inertia[2] / self.speed_time_s * (turn - state.yaw_rate_radps) - felt_nm
    }
}

/// What she is to do, and where the ship and her side are now, earth-fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Task {
    /// Be at a place that moves with the ship.
    Follow {
        /// The place (m).
        place_m: Vec2,
        /// Its velocity (m/s).
        velocity_mps: Vec2,
        /// The heading (rad).
        heading_rad: f64,
    },
    /// Push with her bow.
    Push {
        /// Point of the ship's side (m).
        place_m: Vec2,
        /// Its velocity (m/s).
        velocity_mps: Vec2,
        /// Unit vector into the ship.
        inward: Vec2,
        /// From her centre of gravity to the tip of her bow, fender included (m).
        bow_m: f64,
        /// Force (N).
        force_n: f64,
        /// The force between them in the last step (N).
        touch_n: f64,
    },
    /// Pull on a line.
    Pull {
        /// The ship's end of the line (m).
        place_m: Vec2,
        /// Its velocity (m/s).
        velocity_mps: Vec2,
        /// Unit vector of the pull on the ship.
        outward: Vec2,
        /// Whether the line leads over her bow: she faces the ship then and pulls astern.
        over_bow: bool,
        /// So much longer is the line than the way between its ends (m).
        slack_m: f64,
        /// Force (N).
        force_n: f64,
        /// Tension of the line in the last step (N).
        tension_n: f64,
    },
}

/// What a task comes to in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// For her thrusters.
    pub demand: Demand,
    /// Whether the side force matters.
    pub sway: Sway,
}

/// By how much she turns off a heading so that her way ahead takes her where she is going (rad), and what part steering
/// has in keeping her place: at speed, units at her stern push her bow round long before they push her sideways.
fn steered(going_mps: Vec2, heading_rad: f64) -> (f64, f64) {
    let own = Rotation::from_angle(heading_rad).apply_inverse(going_mps);
    let [begins_mps, whole_mps] = STEERS_MPS;
    let share = bounded((own.x - begins_mps) / (whole_mps - begins_mps), 0.0, 1.0);
    // Without way there is nothing to steer with, and the angle would mean nothing.
    let angle_rad = if share > 0.0 { libm::atan2(own.y, own.x) } else { 0.0 };
    (share, share * bounded(angle_rad, -MOST_STEERED_RAD, MOST_STEERED_RAD))
}

/// What her thrusters should give, in her own axes about her centre of gravity.
///
/// `felt` is what hull, wind and waves put on her in the last step: she makes up for it. `fastest_mps` bounds
/// her speed beside that of the ship. `steady_nm` is a moment learnt against what leans on her bow.
#[must_use]
pub fn assist(
    task: &Task,
    handling: &Handling,
    state: &BodyState,
    felt: &Demand,
    fastest_mps: f64,
    steady_nm: f64,
) -> Asked {
    let mut sway = Sway::Held;
    let (mut thrust_n, mut stiffer) = (None, 1.0);
    let (velocity_mps, heading_rad) = match *task {
        Task::Follow { place_m, velocity_mps, heading_rad } => {
            let off = place_m - state.position_m;
            let going = velocity_mps + cut(off * (1.0 / handling.place_time_s), fastest_mps);
            let (share, steered_rad) = steered(going, heading_rad);
            if share >= 1.0 {
                sway = Sway::Free;
            }
            (going, handling.bow_first(off, going).unwrap_or(heading_rad + steered_rad))
        }
        Task::Push { place_m, velocity_mps, inward, bow_m, force_n, touch_n } => {
            let heading_rad = libm::atan2(inward.y, inward.x);
            let turn = turn_to(state.heading_rad, heading_rad);
            if touch_n > 0.0 && turn.abs() < ASKEW_RAD {
                thrust_n = Some(force_n);
                stiffer = LEANING;
                if touch_n > HOLDS * force_n {
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
            let way = cut(across * (1.0 / handling.place_time_s), fastest_mps);
            let out_mps = if tension_n > 0.0 {
                // She works against the spring of the line, and takes her way off it.
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
    let surge_n = thrust_n.unwrap_or(surge_kg * stiff * error.x);
    Asked {
        demand: Demand {
            surge_n: surge_n - felt.surge_n,
            sway_n: sway_kg * stiff * error.y - felt.sway_n,
            yaw_nm: stiffer * handling.turning_moment(state, heading_rad, 0.0) - felt.yaw_nm
                + steady_nm,
        },
        sway,
    }
}

/// Velocity beside the ship's on the way to her side: up to a stand-off until heading and place along the
/// side are right, then on until she touches.
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
    let astray = greater(turn.abs() / OFF[0], across.length() / OFF[1]);
    let waits = bounded((astray - NEAR_ENOUGH) / (1.0 - NEAR_ENOUGH), 0.0, 1.0);
    let to_go_m = gap_m - waits * STAND_OFF * handling.length_m;
    let touch_mps = lesser(TOUCH_MPS, fastest_mps);
    let closing = to_go_m / (PATIENCE * handling.place_time_s) + touch_mps * (1.0 - waits);
    // Once she is that far, no harder into the ship than she may touch.
    let most_mps = if gap_m <= 0.0 { touch_mps } else { fastest_mps };
    inward * bounded(closing, -fastest_mps, most_mps)
        + cut(across * (1.0 / handling.place_time_s), fastest_mps)
}

/// The vector, no longer than this.
fn cut(vector: Vec2, longest: f64) -> Vec2 {
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

    fn push(place_m: Vec2, touch_n: f64) -> Task {
        Task::Push {
            place_m,
            velocity_mps: Vec2::ZERO,
            inward: vec2(1.0, 0.0),
            bow_m: 16.0,
            force_n: 3e5,
            touch_n,
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
    fn she_comes_on_slowly_and_pushes_when_she_touches() {
        let state = BodyState { velocity_mps: vec2(TOUCH_MPS, 0.0), ..BodyState::default() };
        let near =
            assist(&push(vec2(16.0, 0.0), 0.0), &HANDLING, &state, &Demand::default(), 1.0, 0.0);
        assert!(near.demand.surge_n.abs() < 1e-6, "as fast as she may: {near:?}");
        let on =
            assist(&push(vec2(15.9, 0.0), 1e5), &HANDLING, &state, &Demand::default(), 1.0, 0.0);
        assert_eq!((on.demand.surge_n, on.sway), (3e5, Sway::Free));
    }
}
