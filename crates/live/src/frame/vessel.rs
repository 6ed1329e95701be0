//! A vessel as she is now.

use fenderline_contact::Rotation;
use fenderline_sim::{Job, Pilots, Simulation};

use crate::action::Fault;
use crate::berth::Berth;
use crate::message::{AssistNow, AzimuthNow, RudderNow, ShareNow, VesselNow};

/// The vessel of an index. Speeds over ground and through the water are those of midship; lateral speeds those of
/// the foremost and aftmost point of her outline.
pub(super) fn now(simulation: &Simulation, index: usize, berth: Option<&Berth>) -> VesselNow {
    let setup = simulation.setup();
    let environment = &setup.world.environment;
    let (of, vessel) = (&setup.world.vessels[index], &simulation.vessels()[index]);
    let (body, state) = (&setup.bodies[of.body], &simulation.states()[of.body]);
    let ahead_m = of.ship.particulars.centre_of_gravity_m;
    let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
    let lateral_mps = |along_m: f64| own.y + along_m * state.yaw_rate_radps;
    let (aftmost, foremost) = body.outline.bounds();
    let water = of.velocity(state, environment, simulation.time_s());
    let azimuths =
        vessel.azimuths.iter().zip(&vessel.orders.azimuths).map(|(now, order)| AzimuthNow {
            power_order: order.power,
            power: now.power.value,
            direction_order_rad: order.direction_rad,
            direction_rad: now.direction.angle_rad,
        });
    let thrusters = vessel.thrusters.iter().zip(&vessel.orders.thrusters);
    let shaft = if of.shaft.stop > 0.0 { vessel.shaft.value / of.shaft.stop } else { 0.0 };
    let [_, _, _, roll, pitch, _] = vessel.wave_motion.motion;
    VesselNow {
        rudder: RudderNow { order_rad: vessel.orders.rudder_rad, now_rad: vessel.rudder.value },
        shaft: ShareNow { order: vessel.orders.shaft, now: shaft },
        thrusters: thrusters.map(|(lag, &order)| ShareNow { order, now: lag.value }).collect(),
        azimuths: azimuths.collect(),
        pilot: pilot_text(&vessel.pilots),
        course_rad: vessel.pilots.course.map(|course| course.heading_rad),
        speed_order_mps: vessel.pilots.speed.map(|speed| speed.speed_mps),
        ground_mps: [own.x, lateral_mps(-ahead_m)],
        water_mps: [water.surge_mps, water.sway_mps],
        bow_mps: lateral_mps(foremost.x),
        stern_mps: lateral_mps(aftmost.x),
        heel_rad: vessel.attitude.roll.value + roll,
        trim_rad: vessel.attitude.pitch.value + pitch,
        squat_m: vessel.squat_m,
        under_keel_m: vessel.under_keel_m,
        aground: vessel.aground,
        // From the body that it is on there is no distance to it.
        berth: berth
            .filter(|berth| berth.body != of.body)
            .map(|berth| berth.seen_from(&simulation.states()[berth.body], &body.outline, state)),
        assist: vessel.pilots.assist.as_ref().map(|pilot| assist_now(&pilot.order.job)),
        faults: Fault::standing(&vessel.faults),
    }
}

fn assist_now(job: &Job) -> AssistNow {
    match job {
        Job::Follow { .. } => AssistNow { job: "follow", force_n: 0.0 },
        Job::Push(push) => AssistNow { job: "push", force_n: push.force_n },
        Job::Pull { force_n, .. } => AssistNow { job: "pull", force_n: *force_n },
    }
}

fn pilot_text(pilots: &Pilots) -> &'static str {
    match pilots {
        Pilots { assist: Some(_), .. } => "assist",
        Pilots { station: Some(_), .. } => "station",
        Pilots { course: Some(_), speed: Some(_), .. } => "course+speed",
        Pilots { course: Some(_), .. } => "course",
        Pilots { speed: Some(_), .. } => "speed",
        _ => "hands",
    }
}
