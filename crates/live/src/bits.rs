//! The fingerprint of a simulation's state: equal states have equal fingerprints.

use fenderline_contact::hash::Fnv1a;
use fenderline_sim::Simulation;

/// FNV-1a hash of the states of all bodies, the vessels' machinery, the lines, the anchors and the tugs. If a replay
/// differs anywhere from its recording, the fingerprint differs within a step or two. The hash gives no protection
/// against a forged recording.
pub(crate) fn fingerprint(simulation: &Simulation) -> u64 {
    let mut hash = Fnv1a::default();
    let mut add = |number: f64| hash.word(number.to_bits());
    for state in simulation.states() {
        add(state.position_m.x);
        add(state.position_m.y);
        add(state.heading_rad);
        add(state.velocity_mps.x);
        add(state.velocity_mps.y);
        add(state.yaw_rate_radps);
    }
    for vessel in simulation.vessels() {
        add(vessel.rudder.value);
        add(vessel.shaft.value);
        vessel.thrusters.iter().for_each(|lag| add(lag.value));
        for unit in &vessel.azimuths {
            add(unit.power.value);
            add(unit.direction.angle_rad);
        }
        add(vessel.attitude.roll.value);
    }
    for line in simulation.lines() {
        add(line.load.tension_n);
    }
    for anchor in simulation.anchors() {
        add(anchor.state.chain_m);
        add(anchor.load.tension_n);
        add(anchor.state.dragged_m);
    }
    for tug in simulation.tugs() {
        add(tug.state.force_n);
        add(tug.state.direction_rad);
    }
    hash.finish()
}
