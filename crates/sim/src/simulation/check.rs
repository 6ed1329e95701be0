//! Checks of a set-up that concern several of its parts.

use fenderline_assess::berthing::{ShallowFactor, Study};
use fenderline_contact::BodyState;
use fenderline_ship::environment::{Bank, BankMethod};
use fenderline_world::error::{NoDepthUnder, SetupError};
use fenderline_world::rigid_body::initial_state;
use fenderline_world::setup::{Load, Setup};
use fenderline_world::world::LineEnd;

/// The number of steps in a time: the time divided by Δt, rounded up. A ratio within 1e-9 of a whole number is taken as
/// this number, so 20 s in steps of 0.1 s are 200 steps.
pub(super) fn whole_steps(ratio: f64) -> u64 {
    let whole = libm::round(ratio);
    let steps = if (ratio - whole).abs() <= 1e-9 * whole { whole } else { libm::ceil(ratio) };
    steps as u64
}

/// Number of steps of the run, at least one.
pub(super) fn count_steps(setup: &Setup) -> Result<u64, SetupError> {
    let positive = |field, value: f64| {
        if value > 0.0 && value.is_finite() {
            return Ok(());
        }
        Err(SetupError::OutOfRange { field, value })
    };
    positive("the time step", setup.step_s)?;
    positive("the duration", setup.duration_s)?;
    let ratio = setup.duration_s / setup.step_s;
    if ratio > 1e12 {
        return Err(SetupError::OutOfRange { field: "the number of steps", value: ratio });
    }
    Ok(whole_steps(ratio).max(1))
}

/// Checks that a load acts on a floating body and has finite numbers.
pub(super) fn check_load(load: &Load, setup: &Setup) -> Result<(), SetupError> {
    if setup.bodies.get(load.body).is_none_or(|b| b.mass.is_none()) {
        return Err(SetupError::BadBody { owner: "load", body: load.body });
    }
    for (field, value) in [
        ("a load's north force", load.force_n.x),
        ("a load's east force", load.force_n.y),
        ("a load's moment", load.moment_nm),
    ] {
        if !value.is_finite() {
            return Err(SetupError::OutOfRange { field, value });
        }
    }
    if load.from_s.is_nan() || load.until_s.is_nan() {
        return Err(SetupError::OutOfRange { field: "a load's time", value: f64::NAN });
    }
    Ok(())
}

/// Checks the hulls of the set-up for the flow between ships: there is one for every vessel, or there is none and no
/// force needs one.
pub(super) fn check_flow(setup: &Setup) -> Result<(), SetupError> {
    let hulls = setup.world.flow.hulls.len();
    let by_image = |bank: &Bank| bank.method() == BankMethod::Image;
    let environment = &setup.world.environment;
    let of_bottom = environment.bottom.as_ref().and_then(|bottom| bottom.banks);
    let are_needed = environment.banks.iter().any(by_image) || of_bottom == Some(BankMethod::Image);
    if hulls == setup.world.vessels.len() || hulls == 0 && !are_needed {
        return Ok(());
    }
    Err(SetupError::OutOfRange { field: "the number of hulls in the flow", value: hulls as f64 })
}

/// Checks that every line joins existing bodies, and that lines that are fast at the start fit between their ends.
pub(super) fn check_lines(setup: &Setup) -> Result<(), SetupError> {
    for line in &setup.world.lines {
        let far = match line.end {
            Some(LineEnd::OnBody { body, .. }) => body,
            Some(LineEnd::Fixed(_)) | None => line.ship,
        };
        for body in [line.ship, far] {
            if body >= setup.bodies.len() {
                return Err(SetupError::BadBody { owner: "line", body });
            }
        }
        if line.from_s <= 0.0 {
            let level_m = setup.world.environment.level_m(0.0);
            line.check_at_start(&setup.bodies, level_m).map_err(SetupError::Line)?;
        }
        if !(1.0..=1e5).contains(&line.rope_m) {
            return Err(SetupError::OutOfRange { field: "rope length [m]", value: line.rope_m });
        }
    }
    for bollard in &setup.world.bollards {
        if bollard.body >= setup.bodies.len() {
            return Err(SetupError::BadBody { owner: "bollard", body: bollard.body });
        }
    }
    let out_of_range = |error| SetupError::LineHandling { error };
    setup.world.line_handling.check().map_err(out_of_range)?;
    Ok(())
}

/// Checks that the depth under each vessel is known at the start.
pub(super) fn check_depths(setup: &Setup, states: &[BodyState]) -> Result<(), SetupError> {
    for vessel in &setup.world.vessels {
        let state = &states[vessel.body];
        vessel.soundings(state, &setup.world.environment, 0.0).map_err(|place| {
            let body = setup.bodies[vessel.body].name.clone();
            SetupError::NoDepth(NoDepthUnder { body, place })
        })?;
    }
    Ok(())
}

/// Checks the anchors and the vessels that carry them.
pub(super) fn check_anchors(setup: &Setup) -> Result<(), SetupError> {
    let world = &setup.world;
    for anchor in &world.anchors {
        let vessel = world.vessels.get(anchor.vessel);
        let vessel = vessel.ok_or(SetupError::BadBody { owner: "anchor", body: anchor.vessel })?;
        let body = &setup.bodies[vessel.body];
        anchor.check(body, &world.environment).map_err(SetupError::Anchor)?;
    }
    Ok(())
}

/// Makes the comparison of a berthing with the berthing formulas, if the set-up asks for it.
pub(super) fn berthing_study(setup: &Setup) -> Result<Option<Study>, SetupError> {
    let Some(berthing) = setup.berthing else { return Ok(None) };
    let ship = setup.bodies.get(berthing.ship).and_then(|body| body.mass);
    let Some(_) = ship else {
        return Err(SetupError::BadBody { owner: "berthing", body: berthing.ship });
    };
    berthing.check().map_err(SetupError::Berthing)?;
    let displacements_kg = setup.bodies.iter().map(|body| body.mass.map(|mass| mass.mass_kg));
    Ok(Some(Study::new(berthing, displacements_kg.collect(), shallow_factor(setup, berthing.ship))))
}

/// Factor of shallow water on a vessel's added mass in sway, for the depth of water at the start.
fn shallow_factor(setup: &Setup, ship: usize) -> Option<ShallowFactor> {
    let vessel = setup.world.vessels.iter().find(|vessel| vessel.body == ship)?;
    let state = initial_state(&setup.bodies[ship]);
    let depth_m = vessel.soundings(&state, &setup.world.environment, 0.0).ok()?.mean_m?;
    let deep_m3 = vessel.deep.added_mass.sway_m3;
    (deep_m3 > 0.0).then(|| ShallowFactor {
        factor: vessel.ship.added_mass.sway_m3 / deep_m3,
        depth_over_draught: depth_m / vessel.deep.particulars.draught_m,
    })
}

/// Checks the planned changes of a set-up.
pub(super) fn check_planned(setup: &Setup) -> Result<(), SetupError> {
    for planned in &setup.world.planned {
        if !planned.at_s.is_finite() {
            return Err(SetupError::OutOfRange {
                field: "the time of a planned change [s]",
                value: planned.at_s,
            });
        }
        planned.change.check(setup).map_err(SetupError::Change)?;
    }
    Ok(())
}
