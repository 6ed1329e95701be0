//! A set-up without everything that drives a ship but the water.

use fenderline_sim::Setup;

/// The set-up without loads, wind, waves, tugs, lines, anchors, engines, orders and approaches. Depth, current and the
/// hull's drag stay.
pub(crate) fn water_only(setup: &Setup) -> Setup {
    let mut setup = setup.clone();
    setup.loads.clear();
    setup.approaches.clear();
    let world = &mut setup.world;
    world.orders.clear();
    world.planned.clear();
    world.tugs.clear();
    world.lines.clear();
    world.anchors.clear();
    world.bollards.clear();
    world.providers.clear();
    world.statistics.from_s = None;
    world.statistics.limits.clear();
    world.environment.wind = None;
    world.environment.sea = None;
    world.environment.long_waves = None;
    for vessel in &mut world.vessels {
        vessel.shaft.value = 0.0;
        vessel.rudder.value = 0.0;
        vessel.plan = None;
    }
    if let Some(berthing) = &mut setup.berthing {
        berthing.design_speed_mps = None;
    }
    setup
}
