//! The forces of passing ships and of other vessels on each vessel, in a step.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Pose, Vec2, vec2};

use fenderline_ship::distance::of_segments_m;
use fenderline_ship::hydro::Force;
use fenderline_ship::passing::{FlowHull, FlowSetup, PassingSetup, PassingShip, force_under_way};

use crate::world::{Environment, Soundings, VesselSetup};

/// Distance between the midships of two ships, divided by the mean of their lengths, at which a force begins to fade,
/// and at which the force is zero. At these distances the force is less than a thousandth of its peak abreast, so a
/// step need not calculate it.
const FADES: [f64; 2] = [8.0, 10.0];

/// Clear gap between vessels under way, divided by the mean of their beams. Below the first value the theory of slender
/// ships does not hold; from the second value on, the model uses the full flow of this theory. The values are our
/// choice. A tug at a ship's side is nearer than both values.
const TOO_NEAR: [f64; 2] = [0.25, FULL_FLOW_GAP];
/// The gap from which on the model uses the full flow (divided by the mean of the two beams).
pub const FULL_FLOW_GAP: f64 = 0.5;

/// All vessels of a set-up, with the states of all bodies.
#[derive(Clone, Copy, Debug)]
pub struct Vessels<'a> {
    /// The set-ups of the vessels.
    pub setups: &'a [VesselSetup],
    /// The states of all bodies, of which each vessel has one.
    pub states: &'a [BodyState],
}

/// A ship in the flow, with the hull, the position of midship and the velocity through the water (m/s).
pub(super) struct Afloat<'s> {
    pub(super) hull: &'s FlowHull,
    pose: Pose,
    velocity_mps: Vec2,
}

impl<'s> Afloat<'s> {
    fn of(
        hull: &'s FlowHull,
        pose: Pose,
        over_ground_mps: Vec2,
        environment: &Environment,
        t_s: f64,
    ) -> Afloat<'s> {
        let stream_mps = environment.current(pose.position_m, t_s, hull.draught_m);
        Afloat { hull, pose, velocity_mps: over_ground_mps - stream_mps }
    }

    /// A vessel of the set-up as a ship in the flow, about midship.
    pub(super) fn of_vessel(
        hull: &'s FlowHull,
        setup: &VesselSetup,
        states: &[BodyState],
        environment: &Environment,
        t_s: f64,
    ) -> Afloat<'s> {
        let state = &states[setup.body];
        let midship_m = vec2(-setup.ship.particulars.centre_of_gravity_m, 0.0);
        let pose = Pose { position_m: state.pose().apply(midship_m), ..state.pose() };
        Afloat::of(hull, pose, state.velocity_at(pose.position_m), environment, t_s)
    }

    pub(super) fn in_flow(&self) -> PassingShip<'_> {
        let &Afloat { hull, pose, velocity_mps } = self;
        PassingShip { sections: &hull.sections, pose, velocity_mps }
    }

    /// Positions of both ends of the ship's axis (m).
    pub(super) fn ends_m(&self) -> [Vec2; 2] {
        let half_m = 0.5 * self.hull.length_m;
        [-half_m, half_m].map(|x_m| self.pose.apply(vec2(x_m, 0.0)))
    }
}

/// Sets the force on each vessel about midship; `soundings` are the depths under each vessel. Passing ships are at
/// their places at the time `t_s`.
pub fn act(
    flow: &FlowSetup,
    Vessels { setups, states }: Vessels<'_>,
    environment: &Environment,
    soundings: &[Soundings],
    t_s: f64,
    into: &mut [Force],
) {
    let afloat = |vessel: usize| {
        Afloat::of_vessel(&flow.hulls[vessel], &setups[vessel], states, environment, t_s)
    };
    for (vessel, force) in into.iter_mut().enumerate() {
        *force = Force::default();
        if flow.hulls.is_empty() {
            continue;
        }
        let own = afloat(vessel);
        for ship in &flow.passing {
            let now = ship.track.at(t_s);
            let other = Afloat::of(&ship.hull, now.pose, now.velocity_mps, environment, t_s);
            let Some([surge_n, sway_n, yaw_nm]) = push(&own, &other, environment) else { continue };
            let across_m = own.pose.apply_inverse(other.pose.position_m).y;
            let factors = ship.factors(own.hull, soundings[vessel].mean_m, across_m);
            *force = *force
                + Force {
                    surge_n: factors[0] * surge_n,
                    sway_n: factors[1] * sway_n,
                    yaw_nm: factors[2] * yaw_nm,
                };
        }
        if !flow.between_vessels || !own.hull.is_slender() {
            continue;
        }
        for other in (0..setups.len()).filter(|&other| other != vessel) {
            let other = afloat(other);
            let share = if other.hull.is_slender() { share_of_gap(&own, &other) } else { 0.0 };
            if share == 0.0 {
                continue;
            }
            let Some([surge_n, sway_n, yaw_nm]) = push(&own, &other, environment) else { continue };
            *force = *force + Force { surge_n, sway_n, yaw_nm } * share;
        }
    }
}

/// The force of one ship on another in deep water; `None` if the ships are far from each other.
fn push(own: &Afloat<'_>, other: &Afloat<'_>, environment: &Environment) -> Option<[f64; 3]> {
    let mean_length_m = 0.5 * (own.hull.length_m + other.hull.length_m);
    let apart = (other.pose.position_m - own.pose.position_m).length() / mean_length_m;
    let share = 1.0 - smooth(apart, FADES);
    if share == 0.0 {
        return None;
    }
    let closest_m = 0.5 * (own.hull.beam_m + other.hull.beam_m);
    let density = environment.water_density_kgpm3;
    let force = force_under_way(&own.in_flow(), &other.in_flow(), density, closest_m);
    Some(force.map(|part| share * part))
}

/// The share of the flow between two vessels that the model uses, by the clear gap between the vessels.
fn share_of_gap(own: &Afloat<'_>, other: &Afloat<'_>) -> f64 {
    smooth(gap_between(own, other), TOO_NEAR)
}

/// The clear gap between two ships, divided by the mean of their beams.
fn gap_between(own: &Afloat<'_>, other: &Afloat<'_>) -> f64 {
    let mean_beam_m = 0.5 * (own.hull.beam_m + other.hull.beam_m);
    let apart_m = of_segments_m(own.ends_m(), other.ends_m());
    apart_m / mean_beam_m - 1.0
}

/// The clear gap between two vessels, divided by the mean of their beams. The vessels are given by their indices;
/// `None` if one of the vessels is too short for the theory of slender ships.
pub fn gap_in_beams(
    flow: &FlowSetup,
    Vessels { setups, states }: Vessels<'_>,
    environment: &Environment,
    t_s: f64,
    pair: [usize; 2],
) -> Option<f64> {
    let [one, other] = pair.map(|index| {
        Afloat::of_vessel(&flow.hulls[index], &setups[index], states, environment, t_s)
    });
    let is_slender = one.hull.is_slender() && other.hull.is_slender();
    is_slender.then(|| gap_between(&one, &other))
}

/// The least depth on the track of a passing ship (m), at the lowest water of the run; `None` for deep water. If the
/// depth differs by place, it is taken at the ship's midship at 512 times of the run, where it is known.
#[must_use]
pub fn shallowest_on_track_m(
    ship: &PassingSetup,
    environment: &Environment,
    duration_s: f64,
) -> Option<f64> {
    let Some(bottom) = &environment.bottom else {
        return environment.depth_range_m().map(|[shallowest_m, _]| shallowest_m);
    };
    let at_s = (0..=511).map(|part| duration_s * f64::from(part) / 511.0);
    let depths_m = at_s.filter_map(|t_s| bottom.depth_m(ship.track.at(t_s).pose.position_m));
    let least_m = depths_m.fold(f64::INFINITY, lesser);
    let [low_m, _] = environment.level_range_m();
    least_m.is_finite().then(|| greater(least_m + low_m, 0.0))
}

/// A smooth step: 0 below the first limit, 1 above the second, with a continuous slope.
pub(super) fn smooth(value: f64, [low, high]: [f64; 2]) -> f64 {
    let share = bounded((value - low) / (high - low), 0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
