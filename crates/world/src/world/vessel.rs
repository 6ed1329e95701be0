//! A ship in water and wind: the forces and moments on the ship's body from the ship's state and controls.

use fenderline_contact::number::bounded;
use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;

use super::azimuth::{AzimuthOrder, AzimuthSetup, AzimuthState, ThrusterSetup};
use super::bank_walls::Walls;
use super::current_table::CurrentTable;
use super::environment::{Environment, NoDepth};
use super::fault::Faults;
use super::inputs::{Moving, StepTimes, Surroundings};
use super::pilots::Pilots;
use super::seaway_state::SeawayState;
use super::soundings::Soundings;
use crate::looks::Looks;
use fenderline_seakeeping::Seakeeping;
use fenderline_ship::attitude::{Attitude, AttitudeLoad, Hydrostatics, Motion};
use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::waves::{
    DriftHull, FirstOrderMotion, MotionResponse, ShipInWaves, first_order_motion, mean_drift,
};
use fenderline_ship::environment::wind::{RelativeWind, ShipGusts, ShipWindage};
use fenderline_ship::environment::{BankMethod, BankWater, ShipAtBank, Tide};
use fenderline_ship::hydro::actuator::{Lag, Order, RateLimited};
use fenderline_ship::hydro::shallow::SHALLOWEST_RATIO;
use fenderline_ship::hydro::vessels::Origin;
use fenderline_ship::hydro::{Controls, Force, Mmg, Velocity};
use fenderline_ship::step_time::StepTime;
use fenderline_ship::track::{OnPlan, PassagePlan};

/// Under-keel clearance from which a ship that was aground is afloat again (m); our choice.
const REFLOATED_M: f64 = 0.02;

/// Coulomb's friction of a bottom (recalled, for sand).
pub(super) const BOTTOM_FRICTION: f64 = 0.4;
/// Speed below which the friction of the bottom fades out (m/s), so that the friction never drives a ship; our choice.
pub(super) const SLOW_MPS: f64 = 0.01;

/// A vessel of a set-up: a body with hull, propulsion and their forces.
#[derive(Clone, Debug, PartialEq)]
pub struct VesselSetup {
    /// Index of the vessel's body in [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Name of the vessel, and the sources of the vessel's data.
    pub origin: Origin,
    /// Data of hull, propeller and rudder, about midship, in the depth at the start of the run. In the whole run, the
    /// engine moves the vessel with the mass at the start.
    pub ship: Mmg,
    /// Data of hull, propeller and rudder in deep water. With a tide, the model calculates the hull at each depth from
    /// this data.
    pub deep: Mmg,
    /// Rudder: angle at the start, rate and stop (rad).
    pub rudder: RateLimited,
    /// Shaft: revolutions at the start, rate, and full revolutions as the stop (1/s).
    pub shaft: RateLimited,
    /// Tunnel thrusters.
    pub thrusters: Vec<ThrusterSetup>,
    /// Azimuth units.
    pub azimuths: Vec<AzimuthSetup>,
    /// The user's own current coefficients, which give the force on the hull at low speed.
    pub current_table: Option<CurrentTable>,
    /// Areas of the ship for the wind.
    pub windage: Option<ShipWindage>,
    /// Heave, roll and pitch.
    pub float: Option<Float>,
    /// First-order response to waves, which adds to all other motion.
    pub response: Option<MotionResponse>,
    /// Data of the hull for mean wave drift.
    pub drift: Option<DriftHull>,
    /// Hydrodynamic data, with which the vessel moves in six degrees of freedom. A vessel with such data has no
    /// `response`, and the vessel's `float` gives the height of the centre of gravity. Hydrodynamic data need the
    /// coupled method with the semi-implicit integrator.
    pub seakeeping: Option<Seakeeping>,
    /// Her passage plan. The plan moves nothing: results and pages compare her way with the plan.
    pub plan: Option<PassagePlan>,
    /// How the pages' view shows the vessel. No force depends on the looks.
    pub looks: Looks,
}

/// Data for heave, roll and pitch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Float {
    /// The three oscillators.
    pub hydrostatics: Hydrostatics,
    /// Height of the centre of gravity above the still waterline (m); negative if the centre of gravity is below the
    /// waterline.
    pub gravity_above_water_m: f64,
    /// Draught (m).
    pub draught_m: f64,
}

/// The present orders to rudder, engine and thrusters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VesselOrders {
    /// Order to the rudder (rad).
    pub rudder_rad: f64,
    /// Order to the engine: revolutions divided by full revolutions.
    pub shaft: f64,
    /// Order to each thruster, −1 (to port) to 1 (to starboard).
    pub thrusters: Vec<f64>,
    /// Order to each azimuth unit.
    pub azimuths: Vec<AzimuthOrder>,
}

impl VesselOrders {
    fn copy_from(&mut self, other: &VesselOrders) {
        let VesselOrders { rudder_rad, shaft, thrusters, azimuths } = self;
        (*rudder_rad, *shaft) = (other.rudder_rad, other.shaft);
        thrusters.clone_from(&other.thrusters);
        azimuths.clone_from(&other.azimuths);
    }
}

/// The variable state of a vessel, except the state of the vessel's body in the plane, as plain data.
#[derive(Clone, Debug, PartialEq)]
pub struct VesselState {
    /// Present orders.
    pub orders: VesselOrders,
    /// Rudder.
    pub rudder: RateLimited,
    /// Shaft.
    pub shaft: RateLimited,
    /// Tunnel thrusters.
    pub thrusters: Vec<Lag>,
    /// Azimuth units.
    pub azimuths: Vec<AzimuthState>,
    /// Active pilots.
    pub pilots: Pilots,
    /// Heave, roll and pitch, without first-order wave motion.
    pub attitude: Attitude,
    /// First-order wave motion, which adds to the other motion.
    pub wave_motion: FirstOrderMotion,
    /// The memory of the water for a vessel with hydrodynamic data.
    pub seaway: Option<SeawayState>,
    /// Squat (m): additional sinkage under way in shallow water.
    pub squat_m: f64,
    /// Under-keel clearance with squat (m); `None` in deep water. The clearance is negative if the vessel is aground.
    pub under_keel_m: Option<f64>,
    /// True if the vessel is aground.
    pub aground: bool,
    /// True if the water is shallower than the range of the shallow-water formulas. In such water, the model uses the
    /// values at the end of the range.
    pub held: bool,
    /// Faults of the vessel.
    pub faults: Faults,
}

/// Heave, roll and pitch of a hull, squat and first-order wave motion included.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HullMotion {
    /// Heave, positive down (m).
    pub heave_m: f64,
    /// Roll, positive to starboard (rad).
    pub roll_rad: f64,
    /// Pitch, positive bow up (rad).
    pub pitch_rad: f64,
}

impl HullMotion {
    /// How much lower a place on the hull is than the same place at rest (m), for small angles.
    pub fn sinkage_m(&self, place_m: Vec2) -> f64 {
        self.heave_m - place_m.x * self.pitch_rad + place_m.y * self.roll_rad
    }
}

/// The forces on a vessel by source, in the vessel's axes about midship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VesselForces {
    /// Force on the hull, with the effect of current.
    pub hull: Force,
    /// Force of the propeller.
    pub propeller: Force,
    /// Rudder.
    pub rudder: Force,
    /// Force of the thrusters, azimuth units included.
    pub thrusters: Force,
    /// Wind.
    pub wind: Force,
    /// Force of mean wave drift; for a vessel with hydrodynamic data also of slow drift.
    pub waves: Force,
    /// Exciting force of the waves on a vessel with hydrodynamic data.
    pub excitation: Force,
    /// Reaction of the water to the motion of a vessel with hydrodynamic data, and the effect of heave, roll and pitch
    /// on the motion in the plane. This reaction is the difference from the reaction to a body with the engine's
    /// constant mass.
    pub radiation: Force,
    /// Force of banks. The model of banks is not validated.
    pub banks: Force,
    /// Force of the flow of passing ships and of other vessels.
    pub passing: Force,
    /// Force of the bottom, if the vessel is aground.
    pub bottom: Force,
}

/// Forces from the inertia of the water that are not in [`VesselForces`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WaterInertia {
    /// Minus the Coriolis terms of the added mass in the hull's force, about midship, in the vessel's axes. The
    /// integrators apply these Coriolis terms themselves.
    pub coriolis: Force,
    /// Velocity of the current at the vessel (m/s).
    pub current_mps: Vec2,
    /// Wrench (force and moment) from the acceleration of the water, about the vessel's centre of gravity, earth-fixed.
    pub acceleration: Wrench,
}

impl VesselForces {
    /// The disturbance that the pilots balance: the forces of hull, wind and waves.
    pub fn disturbance(&self) -> Force {
        self.hull + self.wind + self.waves
    }

    /// The sum of all forces except excitation and radiation, which `world/seaway.rs` adds.
    pub fn sum(&self) -> Force {
        self.hull
            + self.propeller
            + self.rudder
            + self.thrusters
            + self.wind
            + self.waves
            + self.banks
            + self.passing
            + self.bottom
    }
}

impl VesselState {
    /// Becomes a copy of another state. The copy does not allocate if both are states of the same vessel.
    pub fn copy_from(&mut self, other: &VesselState) {
        let (mut orders, mut thrusters, mut azimuths, mut seaway) = (
            std::mem::take(&mut self.orders),
            std::mem::take(&mut self.thrusters),
            std::mem::take(&mut self.azimuths),
            std::mem::take(&mut self.seaway),
        );
        match (&mut seaway, &other.seaway) {
            (Some(own), Some(other)) => own.copy_from(other),
            (own, other) => own.clone_from(other),
        }
        orders.copy_from(&other.orders);
        thrusters.clone_from(&other.thrusters);
        azimuths.clone_from(&other.azimuths);
        *self = VesselState { orders, thrusters, azimuths, seaway, ..*other };
    }

    /// The state of the vessel at the start of a run.
    pub fn new(setup: &VesselSetup) -> VesselState {
        VesselState {
            orders: VesselOrders {
                rudder_rad: setup.rudder.value,
                shaft: setup.shaft.value / setup.shaft.stop,
                thrusters: vec![0.0; setup.thrusters.len()],
                azimuths: vec![AzimuthOrder::default(); setup.azimuths.len()],
            },
            rudder: setup.rudder,
            shaft: setup.shaft,
            thrusters: setup
                .thrusters
                .iter()
                .map(|thruster| Lag { value: 0.0, time_constant_s: thruster.lag_s })
                .collect(),
            azimuths: setup.azimuths.iter().map(AzimuthState::new).collect(),
            pilots: Pilots::default(),
            attitude: Attitude::default(),
            wave_motion: FirstOrderMotion::default(),
            seaway: None,
            squat_m: 0.0,
            under_keel_m: None,
            aground: false,
            held: false,
            faults: Faults::default(),
        }
    }

    /// Heave, roll and pitch at a time after this state (s), from the present rates.
    pub fn motion_after(&self, seconds: f64) -> HullMotion {
        let Attitude { heave, roll, pitch } = self.attitude;
        let FirstOrderMotion { motion, rate } = self.wave_motion;
        let at = |own: Motion, k: usize| (own.value + motion[k]) + (own.rate + rate[k]) * seconds;
        HullMotion {
            heave_m: at(heave, 2) + self.squat_m,
            roll_rad: at(roll, 3),
            pitch_rad: at(pitch, 4),
        }
    }

    /// Moves rudder, shaft and thrusters towards their orders; devices that have failed do not move. Returns true if
    /// the vessel limited an order.
    pub fn act(&mut self, step_s: f64) -> bool {
        let faults = self.faults;
        let order_rad = self.orders.rudder_rad;
        let rudder_rad = if faults.steering_failed() || faults.follow_up_lost && order_rad == 0.0 {
            self.rudder.value
        } else if faults.follow_up_lost {
            self.rudder.stop.copysign(order_rad)
        } else {
            order_rad
        };
        let mut clamped = self.rudder.step(rudder_rad, step_s) == Order::Clamped;
        let shaft_rps =
            if faults.engine_failed() { 0.0 } else { self.orders.shaft * self.shaft.stop };
        clamped |= self.shaft.step(shaft_rps, step_s) == Order::Clamped;
        let tunnels = self.thrusters.len();
        for (unit, (lag, &order)) in
            self.thrusters.iter_mut().zip(&self.orders.thrusters).enumerate()
        {
            let failed = faults.thrusters_failed() || faults.tripped.has(unit);
            let order = if failed { 0.0 } else { order };
            let within = if order.is_nan() { lag.value } else { bounded(order, -1.0, 1.0) };
            clamped |= within != order;
            lag.step(within, step_s);
        }
        let units = self.azimuths.iter_mut().zip(&self.orders.azimuths);
        for (number, (unit, order)) in units.enumerate() {
            let mut order = *order;
            if faults.engine_failed() || faults.tripped.has(tunnels + number) {
                order.power = 0.0;
            }
            if faults.steering_failed() {
                order.direction_rad = unit.direction.angle_rad;
            }
            clamped |= unit.act(&order, step_s);
        }
        clamped
    }
}

impl VesselSetup {
    /// The place of midship when the vessel's body is in `state`, north and east (m).
    #[must_use]
    pub fn midship_m(&self, state: &BodyState) -> Vec2 {
        state.pose().apply(vec2(-self.ship.particulars.centre_of_gravity_m, 0.0))
    }

    /// Where midship is on the vessel's passage plan when her body is in `state`; `None` without a plan.
    #[must_use]
    pub fn on_plan(&self, state: &BodyState) -> Option<OnPlan> {
        Some(self.plan.as_ref()?.at(self.midship_m(state)))
    }

    /// Thrust of all azimuth units at rest and full power (N).
    #[must_use]
    pub fn bollard_pull_n(&self) -> f64 {
        self.azimuths.iter().map(|azimuth| azimuth.bollard_n).sum()
    }

    /// The names of the vessel's thrusters, and then of the vessel's azimuth units. [`crate::world::Tripped`] numbers
    /// units in this order.
    pub fn unit_names(&self) -> impl Iterator<Item = &str> + Clone {
        let thrusters = self.thrusters.iter().map(|thruster| thruster.name.as_str());
        thrusters.chain(self.azimuths.iter().map(|azimuth| azimuth.name.as_str()))
    }

    /// True if only azimuth units propel and steer the vessel: the vessel has no propeller and no rudder.
    #[must_use]
    pub fn steers_with_azimuths(&self) -> bool {
        self.ship.propulsion.is_none() && !self.azimuths.is_empty()
    }

    /// The forces in a step, from the state at the start of the step. Stores the force of each azimuth unit in the unit.
    pub fn forces(
        &self,
        vessel: &mut VesselState,
        Moving { state, velocity }: Moving<'_>,
        Surroundings { environment, gusts, soundings }: Surroundings<'_>,
        StepTimes { t_s, velocity_t_s, step_s, .. }: StepTimes,
    ) -> VesselForces {
        let water = environment.density();
        let controls = Controls { shaft_rps: vessel.shaft.value, rudder_rad: vessel.rudder.value };
        let ship = self.ship_now(environment, soundings);
        let mut parts = ship.parts(velocity, &controls, water);
        if let Some(table) = &self.current_table {
            let draught_m = ship.particulars.draught_m;
            let ratio = soundings.still_m.map(|depth_m| depth_m / draught_m);
            parts.hull = table.hull(&ship, parts.hull, velocity, water, ratio);
        }
        let mut thrusters = Force::default();
        for (thruster, lag) in self.thrusters.iter().zip(&vessel.thrusters) {
            thrusters = thrusters + thruster.tunnel.force(lag.value, velocity);
        }
        for (azimuth, now) in self.azimuths.iter().zip(&mut vessel.azimuths) {
            thrusters = thrusters + now.compute_force(azimuth, velocity, water);
        }
        VesselForces {
            hull: parts.hull,
            propeller: parts.propeller,
            rudder: parts.rudder,
            thrusters,
            wind: self.wind(state, environment, gusts, t_s),
            waves: self.drift(state, environment, velocity_t_s),
            excitation: Force::default(),
            radiation: Force::default(),
            banks: self.banks(Moving { state, velocity }, environment, soundings, t_s),
            passing: Force::default(),
            // `World::step` adds the force of a bottom that is not level, which depends on all other forces.
            bottom: match soundings.is_level {
                true => self.bottom(vessel, state, environment, step_s),
                false => Force::default(),
            },
        }
    }

    /// The data of hull, propeller and rudder in the depth that `soundings` gives. The added mass is that of this
    /// depth, and gives the Coriolis terms in the hull's force. The mass with which the engine moves the vessel stays
    /// the mass at the start of the run.
    fn ship_now(&self, environment: &Environment, soundings: &Soundings) -> Mmg {
        let is_constant =
            matches!(environment.tide, Tide::Level(_)) && environment.bottom.is_none();
        match soundings.still_m {
            Some(depth_m) if !is_constant => self.deep.at_depth(depth_m),
            _ => self.ship,
        }
    }

    /// The depths under the vessel at a time, with her body in this state.
    ///
    /// # Errors
    /// Fails if no depth is known under a station of the hull: see [`Soundings::under`].
    pub fn soundings(
        &self,
        state: &BodyState,
        environment: &Environment,
        t_s: f64,
    ) -> Result<Soundings, NoDepth> {
        Soundings::under(&self.ship.particulars, state, environment, t_s)
    }

    /// True if the water is shallower than the range of the shallow-water formulas.
    pub fn is_held(&self, soundings: &Soundings) -> bool {
        let least_m = SHALLOWEST_RATIO * self.ship.particulars.draught_m;
        soundings.mean_m.is_some_and(|depth_m| depth_m < least_m)
    }

    /// Velocity through the water at midship, and the rate of turn through the water: a stream that is stronger across
    /// the bow than across the stern acts as if the vessel turned the other way.
    #[must_use]
    pub fn velocity(&self, state: &BodyState, environment: &Environment, t_s: f64) -> Velocity {
        let (current, turning_radps) = self.stream(state, environment, t_s);
        let own =
            Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps - current);
        let sway_mps = own.y - self.ship.particulars.centre_of_gravity_m * state.yaw_rate_radps;
        Velocity { surge_mps: own.x, sway_mps, yaw_radps: state.yaw_rate_radps - turning_radps }
    }

    /// Mean velocity of the water over the hull's length (m/s), and the rate of turn of the water (rad/s), which is the
    /// slope of its velocity across the hull along the length. A current that differs by place is taken at three
    /// stations, those of Gauss's rule over the length, so that a linear shear is exact; any other current is the same
    /// along the hull.
    fn stream(&self, state: &BodyState, environment: &Environment, t_s: f64) -> (Vec2, f64) {
        let hull = &self.ship.particulars;
        if !matches!(environment.current, Some(Current::Grid(_))) {
            return (environment.current(state.position_m, t_s, hull.draught_m), 0.0);
        }
        let axes = Rotation::from_angle(state.heading_rad);
        let out_m = 0.5 * hull.length_m * libm::sqrt(0.6);
        let at = |x_m: f64| {
            let arm_m = axes.apply(vec2(x_m - hull.centre_of_gravity_m, 0.0));
            environment.current(state.position_m + arm_m, t_s, hull.draught_m)
        };
        let [aft, middle, fore] = [-out_m, 0.0, out_m].map(at);
        // Differences from midship: a uniform current gives its velocity to the last bit.
        let mean = middle + ((aft - middle) + (fore - middle)) * (5.0 / 18.0);
        let turning_radps = axes.apply_inverse(fore - aft).y / (2.0 * out_m);
        (mean, turning_radps)
    }

    fn drift(&self, state: &BodyState, environment: &Environment, t_s: f64) -> Force {
        if self.seakeeping.is_some() {
            return Force::default();
        }
        let (Some(sea), Some(hull)) = (&environment.sea, &self.drift) else {
            return Force::default();
        };
        let density = environment.water_density_kgpm3;
        let draught_m = self.ship.particulars.draught_m;
        let stream_mps = environment.current(state.position_m, t_s, draught_m);
        let going = (state.heading_rad, state.velocity_mps - stream_mps);
        let [surge_n, sway_n, yaw_nm] = mean_drift(sea, hull, going, density);
        Force { surge_n, sway_n, yaw_nm }
    }

    /// Force and moment of all banks by Norrbin's formulas: straight banks, and the walls for the sections of the bottom.
    fn banks(
        &self,
        Moving { state, velocity }: Moving<'_>,
        environment: &Environment,
        soundings: &Soundings,
        t_s: f64,
    ) -> Force {
        let mut banks =
            environment.banks.iter().filter(|bank| bank.method() == BankMethod::Norrbin).peekable();
        let of_bottom = environment
            .bottom
            .as_ref()
            .filter(|bottom| bottom.banks == Some(BankMethod::Norrbin))
            .filter(|_| velocity.surge_mps != 0.0);
        if banks.peek().is_none() && of_bottom.is_none() {
            return Force::default();
        }
        let hull = &self.ship.particulars;
        let ship = ShipAtBank {
            length_m: hull.length_m,
            beam_m: hull.beam_m,
            draught_m: hull.draught_m,
            position_m: state.pose().apply(vec2(-hull.centre_of_gravity_m, 0.0)),
            heading_rad: state.heading_rad,
            surge_mps: velocity.surge_mps,
        };
        let water =
            BankWater { density_kgpm3: environment.water_density_kgpm3, depth_m: soundings.mean_m };
        let straight = banks.fold(Force::default(), |sum, bank| {
            let [surge_n, sway_n, yaw_nm] = bank.force(&ship, &water);
            sum + Force { surge_n, sway_n, yaw_nm }
        });
        let (Some(bottom), Some(depth_m)) = (of_bottom, soundings.mean_m) else { return straight };
        let walls = Walls::beside(hull, state, bottom, environment.level_m(t_s), depth_m);
        let [surge_n, sway_n, yaw_nm] = ship.between_walls(walls.per_m, &water);
        straight + Force { surge_n, sway_n, yaw_nm }
    }

    /// The vessel's squat in the mean depth under her (m), and by a formula for channels in the cross-section of the
    /// water at midship; 0 in deep water.
    pub fn squat_m(
        &self,
        state: &BodyState,
        environment: &Environment,
        soundings: &Soundings,
        t_s: f64,
    ) -> f64 {
        let (Some(squat), Some(depth_m)) = (environment.squat, soundings.mean_m) else {
            return 0.0;
        };
        let surge_mps = self.velocity(state, environment, t_s).surge_mps;
        let hull = &self.ship.particulars;
        let section_m2 = match (&environment.bottom, squat.width_m(hull)) {
            (Some(bottom), Some(width_m)) => {
                let midship_m = state.pose().apply(vec2(-hull.centre_of_gravity_m, 0.0));
                let ahead = Rotation::from_angle(state.heading_rad).apply(vec2(1.0, 0.0));
                bottom.section_m2(midship_m, ahead, environment.level_m(t_s), 0.5 * width_m)
            }
            _ => f64::INFINITY,
        };
        squat.sinkage_in_m(hull, depth_m, section_m2, surge_mps)
    }

    /// The under-keel clearance below which a live session cautions (m): a tenth of the draught, which is our choice.
    #[must_use]
    pub fn under_keel_caution_m(&self) -> f64 {
        0.1 * self.ship.particulars.draught_m
    }

    /// The least under-keel clearance with a squat (m); `None` in deep water.
    #[must_use]
    pub fn under_keel_m(&self, squat_m: f64, soundings: &Soundings) -> Option<f64> {
        self.clearance_m(squat_m, soundings.least_m)
    }

    /// The least under-keel clearances with a squat (m) under the forward and under the after half; `None` in deep
    /// water. The keel is level: the vessel's trim is not taken into account.
    #[must_use]
    pub fn clearances_m(&self, squat_m: f64, soundings: &Soundings) -> [Option<f64>; 2] {
        [soundings.fore_m, soundings.aft_m].map(|depth_m| self.clearance_m(squat_m, depth_m))
    }

    fn clearance_m(&self, squat_m: f64, depth_m: Option<f64>) -> Option<f64> {
        let draught_m = self.ship.particulars.draught_m;
        depth_m.map(|depth_m| depth_m - draught_m - squat_m)
    }

    /// True if the vessel is aground. A ship that was aground needs a clearance of `REFLOATED_M` to be afloat again.
    /// Otherwise, a ship whose squat brings the keel to the bottom would change between afloat and aground in every
    /// step.
    pub fn is_aground(vessel: &VesselState) -> bool {
        let least_m = if vessel.aground { REFLOATED_M } else { 0.0 };
        vessel.under_keel_m.is_some_and(|clearance_m| clearance_m <= least_m)
    }

    /// The drag of a level bottom on a ship aground. The bottom carries the weight that the water no longer carries,
    /// with Coulomb's friction ([`BOTTOM_FRICTION`]). The drag acts against the ship's motion and fades out below
    /// [`SLOW_MPS`], so that it never drives her. `world/grounding.rs` computes the force of a bottom that is not
    /// level.
    fn bottom(
        &self,
        vessel: &VesselState,
        state: &BodyState,
        environment: &Environment,
        step_s: f64,
    ) -> Force {
        let sunk_m = vessel.under_keel_m.map(|clearance_m| -clearance_m);
        let Some(sunk_m) = sunk_m.filter(|&sunk_m| sunk_m > 0.0) else {
            return Force::default();
        };
        let ship = &self.ship.particulars;
        let specific_npm3 = environment.water_density_kgpm3 * STANDARD_GRAVITY_MPS2;
        let waterplane_m2 = ship.block_coefficient() * ship.length_m * ship.beam_m;
        let weight_n = specific_npm3 * waterplane_m2 * sunk_m;
        let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
        let ends_mps = 0.25 * ship.length_m * state.yaw_rate_radps;
        let speed_mps = libm::sqrt(own.length_squared() + ends_mps * ends_mps);
        let per_speed = BOTTOM_FRICTION * weight_n / (speed_mps + SLOW_MPS);
        // The drag is implicit: its value at the end of the step, from the mass that it decelerates. So a step cannot
        // reverse the ship's motion.
        let [[surge_kg, ..], [_, sway_kg, _], [.., yaw_kgm2]] =
            mass_matrix(&self.ship, environment.water_density_kgpm3);
        let braked = |drag: f64, inertia: f64| drag / (1.0 + drag * step_s / inertia);
        let arm_m = 0.25 * ship.length_m;
        Force {
            surge_n: -braked(per_speed, surge_kg) * own.x,
            sway_n: -braked(per_speed, sway_kg) * own.y,
            yaw_nm: -braked(per_speed * arm_m * arm_m, yaw_kgm2) * state.yaw_rate_radps,
        }
    }

    /// First-order motion of the vessel at the end of a step.
    pub fn wave_motion(
        &self,
        state: &BodyState,
        environment: &Environment,
        t_s: f64,
    ) -> FirstOrderMotion {
        let (Some(sea), Some(response)) = (&environment.sea, &self.response) else {
            return FirstOrderMotion::default();
        };
        let ahead_m = self.ship.particulars.centre_of_gravity_m;
        let place = ShipInWaves {
            position_m: state.pose().apply(vec2(-ahead_m, 0.0)),
            velocity_mps: state.velocity_mps,
            heading_rad: state.heading_rad,
        };
        first_order_motion(sea, response, &place, t_s)
    }

    /// The gusts of the wind at the vessel; `None` if there are no gusts, or if no wind acts on the vessel.
    pub fn gusts(&self, environment: &Environment) -> Option<ShipGusts> {
        let gusts = environment.wind.as_ref()?.gusts()?;
        self.windage.as_ref().map(|windage| ShipGusts::new(gusts, windage))
    }

    fn wind(
        &self,
        state: &BodyState,
        environment: &Environment,
        gusts: Option<&ShipGusts>,
        t_s: f64,
    ) -> Force {
        let (Some(windage), Some(wind)) = (&self.windage, &environment.wind) else {
            return Force::default();
        };
        // Gusts act as their mean over the front that the vessel turns to the mean wind.
        let (_, from_rad) = wind.mean_at(t_s);
        let gust = |gusts: &ShipGusts| {
            gusts.speed_over_mps(&windage.front(from_rad - state.heading_rad), t_s)
        };
        let height_m = windage.reference_height_m();
        let air = wind.velocity_in(gusts.map_or(0.0, gust), height_m, t_s);
        let relative = RelativeWind::of(air, state.velocity_mps, state.heading_rad);
        let [surge_n, sway_n, yaw_nm] = windage.force(&relative, environment.air_density_kgpm3);
        Force { surge_n, sway_n, yaw_nm }
    }

    /// The forces from the inertia of the water. With [`VesselForces`] and the Coriolis terms of the integrators
    /// ([`crate::turning`]), these forces give the equations of motion of the MMG method.
    ///
    /// The hull's force about midship contains the Coriolis terms of the added mass, (m_y v r, −m_x u r), and, as part
    /// of N_v, Munk's moment (m_x − m_y) u v. The integrators apply the Coriolis terms of ship and added mass
    /// themselves, about the centre of gravity, so this function subtracts the terms of the hull's force. The Coriolis
    /// terms together do no work.
    ///
    /// Accelerating water accelerates the vessel: M (v̇ − DU/Dt) = W. The pressure gradient gives the force that would
    /// accelerate the displaced water with the rest of the water, and the added mass resists the acceleration relative
    /// to the water (Auton, Hunt & Prud'homme 1988, recalled, for a body that is small compared with the scale of the
    /// current). So the function adds M·DU/Dt, with the `mass` that the engine moves. This force is zero in a steady
    /// uniform current.
    pub fn water_inertia(
        &self,
        Moving { state, velocity }: Moving<'_>,
        environment: &Environment,
        mass: &[[f64; 3]; 3],
        step: StepTime,
    ) -> WaterInertia {
        let &Velocity { surge_mps: u, sway_mps: v, yaw_radps: r } = velocity;
        let density = environment.density().density_kgpm3;
        let added = &self.ship.added_mass;
        let (surge_kg, sway_kg) = (density * added.surge_m3, density * added.sway_m3);
        let coriolis = Force {
            surge_n: -sway_kg * v * r,
            sway_n: surge_kg * u * r,
            yaw_nm: (sway_kg - surge_kg) * u * v,
        };
        let draught_m = self.ship.particulars.draught_m;
        let acceleration = environment.water_acceleration(state.position_m, step, draught_m);
        let attitude = Rotation::from_angle(state.heading_rad);
        let own = attitude.apply_inverse(acceleration);
        let [[surge_kg, ..], [_, sway_kg, _], [_, coupling_kgm, _]] = *mass;
        WaterInertia {
            coriolis,
            current_mps: self.stream(state, environment, step.t_s).0,
            acceleration: Wrench {
                force_n: attitude.apply(vec2(surge_kg * own.x, sway_kg * own.y)),
                moment_nm: coupling_kgm * own.y,
            },
        }
    }

    /// The sum of all forces as an earth-fixed wrench (force and moment) about the centre of gravity, without the
    /// Coriolis terms of the integrators.
    pub fn wrench(
        &self,
        forces: &VesselForces,
        water_inertia: &WaterInertia,
        state: &BodyState,
    ) -> Wrench {
        let Force { surge_n, sway_n, yaw_nm } = forces.sum() + water_inertia.coriolis;
        let ahead_m = self.ship.particulars.centre_of_gravity_m;
        let attitude = Rotation::from_angle(state.heading_rad);
        Wrench {
            force_n: attitude.apply(vec2(surge_n, sway_n)) + water_inertia.acceleration.force_n,
            moment_nm: yaw_nm - ahead_m * sway_n + water_inertia.acceleration.moment_nm,
        }
    }

    /// The load on heave, roll and pitch. Forces of hull and appendages act at half the draught. The wind acts at the
    /// height of the centroid of the vessel's lateral area.
    pub fn attitude_load(&self, forces: &VesselForces, float: &Float) -> AttitudeLoad {
        let mut load = AttitudeLoad::default();
        for (part, above_gravity_m) in self.forces_by_height(forces, float) {
            load.add(part.surge_n, part.sway_n, above_gravity_m);
        }
        load
    }

    /// The vessel's own forces, each with its height above the centre of gravity (m). Forces of hull and appendages act
    /// at half the draught, and the force of the bottom acts at the keel. The wind acts at the height of the centroid
    /// of the lateral area.
    pub fn forces_by_height(
        &self,
        forces: &VesselForces,
        float: &Float,
    ) -> impl Iterator<Item = (Force, f64)> {
        let gravity_m = float.gravity_above_water_m;
        let water_m = -0.5 * float.draught_m - gravity_m;
        let below = [
            forces.hull,
            forces.propeller,
            forces.rudder,
            forces.thrusters,
            forces.waves,
            forces.banks,
            forces.passing,
        ];
        let air_m = self.windage.as_ref().map_or(0.0, |w| w.centroid_height_m) - gravity_m;
        let keel_m = -float.draught_m - gravity_m;
        let ends = [(forces.bottom, keel_m), (forces.wind, air_m)];
        below.into_iter().map(move |part| (part, water_m)).chain(ends)
    }
}

/// Mass matrix over surge, sway and yaw about the centre of gravity (kg, kg·m, kg·m²).
#[must_use]
pub fn mass_matrix(ship: &Mmg, density_kgpm3: f64) -> [[f64; 3]; 3] {
    let hull = &ship.particulars;
    let mass_kg = density_kgpm3 * hull.volume_m3;
    let added = &ship.added_mass;
    let (surge_kg, sway_kg) = (density_kgpm3 * added.surge_m3, density_kgpm3 * added.sway_m3);
    let ahead_m = hull.centre_of_gravity_m;
    let coupling = -sway_kg * ahead_m;
    let yaw = density_kgpm3 * (hull.yaw_inertia_m5() + added.yaw_m5) + sway_kg * ahead_m * ahead_m;
    [[mass_kg + surge_kg, 0.0, 0.0], [0.0, mass_kg + sway_kg, coupling], [0.0, coupling, yaw]]
}
