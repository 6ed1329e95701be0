//! Places vessels by hand before the first step of a session. A vessel is never placed in another hull, a structure, a
//! fender, or on land.

use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::chart::{Chart, ChartKind, ChartShape};
use fenderline_sim::distance::{contains, of_outlines_m};
use fenderline_sim::exercise::Assessment;
use fenderline_sim::{BodyStart, FenderSetup, LineEnd, Simulation};

use crate::cast::Cast;
use crate::frame::seen::Seen;
use crate::frozen::Frozen;
use crate::now::Now;
use crate::pair::Pair;
use crate::refusal::Refusal;

/// Greatest distance from the origin at which a vessel can be placed (m).
const FARTHEST_M: f64 = 1e6;
/// Greatest heading, in either direction, that is accepted (rad).
const LARGEST_ANGLE_RAD: f64 = 100.0;
/// Greatest speed at which a vessel can begin, ahead or astern (m/s).
const FASTEST_MPS: f64 = 15.0;

/// Places a vessel. Tugs that lines join to the ship move with her, so that the lengths of the lines do not change.
///
/// # Errors
/// Fails if a step was taken already, if a number is beyond its limits, or if something is in the way, which the error
/// names.
pub(crate) fn place(
    vessel: usize,
    (at_m, heading_rad): (Pair, f64),
    ahead_mps: Option<f64>,
    cast: &Cast,
    now: &mut Now,
) -> Result<(), Refusal> {
    if now.tick > 0 {
        return Err(Refusal::new(
            "ships are placed before the start: go back to 0:00 and begin a branch at 0:00, or open the scenario again",
        ));
    }
    let in_reach = at_m.iter().all(|coordinate| coordinate.abs() <= FARTHEST_M)
        && heading_rad.abs() <= LARGEST_ANGLE_RAD;
    let can_begin = ahead_mps.is_none_or(|speed_mps| speed_mps.abs() <= FASTEST_MPS);
    if !in_reach || !can_begin {
        return Err(Refusal::new(format_args!(
            "a ship is placed within {} km of the origin, and begins with at most {FASTEST_MPS} m/s",
            FARTHEST_M / 1000.0
        )));
    }
    let setup = now.simulation.setup();
    let body = setup.world.vessels[vessel].body;
    let states = now.simulation.states();
    let pose = Pose::new(vec2(at_m[0], at_m[1]), heading_rad);
    let mut places = vec![(body, pose, heading_rad)];
    if !cast.is_tug[vessel] {
        let (before, turn_rad) = (states[body].pose(), heading_rad - states[body].heading_rad);
        places.extend(companions(vessel, cast, &now.simulation).map(|other| {
            let position_m = pose.apply(before.apply_inverse(states[other].position_m));
            let heading_rad = states[other].heading_rad + turn_rad;
            (other, Pose::new(position_m, heading_rad), heading_rad)
        }));
    }
    if let Some(what) = in_the_way(&places, &now.simulation) {
        return Err(Refusal::new(what));
    }
    let starts = places.iter().map(|&(other, pose, heading_rad)| {
        let mut velocity = setup.bodies[other].velocity;
        if let Some(ahead_mps) = ahead_mps.filter(|_| other == body) {
            velocity.surge_mps = ahead_mps;
        }
        (other, BodyStart { position_m: pose.position_m, heading_rad, velocity })
    });
    let starts: Vec<(usize, BodyStart)> = starts.collect();
    let name = setup.bodies[body].name.clone();
    now.simulation.place(&starts).map_err(|why| {
        Refusal::new(format_args!("{name} cannot be placed at this point: {why}"))
    })?;
    let simulation = &now.simulation;
    now.seen = Seen::before_the_first_step(simulation);
    now.frozen = Frozen::none(simulation);
    crate::frozen::renew(&mut now.frozen, simulation);
    if let Some(exercise) = &now.exercise {
        now.exercise = Some(Assessment::new(exercise.setup().clone(), simulation));
    }
    Ok(())
}

/// The bodies of the tugs that lines join to a ship from the start.
fn companions(ship: usize, cast: &Cast, simulation: &Simulation) -> impl Iterator<Item = usize> {
    let world = &simulation.setup().world;
    let own = world.vessels[ship].body;
    let joined = move |body: usize| {
        world.lines.iter().any(|line| match line.end {
            Some(LineEnd::OnBody { body: far, .. }) => {
                [line.ship, far] == [own, body] || [line.ship, far] == [body, own]
            }
            Some(LineEnd::Fixed(_)) | None => false,
        })
    };
    let tugs = world.vessels.iter().zip(&cast.is_tug).filter(|(_, is_tug)| **is_tug);
    tugs.map(|(tug, _)| tug.body).filter(move |&body| joined(body))
}

/// The body or land on which a placed vessel would lie, in words; `None` if nothing is in the way.
fn in_the_way(places: &[(usize, Pose, f64)], simulation: &Simulation) -> Option<String> {
    let setup = simulation.setup();
    let pose = |body: usize| {
        let placed = places.iter().find(|(other, ..)| *other == body);
        placed.map_or_else(|| simulation.states()[body].pose(), |(_, pose, _)| *pose)
    };
    let hull = |body: usize| on_earth(setup.bodies[body].outline.vertices(), pose(body));
    let fender = |fender: &FenderSetup| on_earth(&face(fender), pose(fender.body));
    for &(body, ..) in places {
        let (name, own) = (&setup.bodies[body].name, hull(body));
        for (index, other) in setup.bodies.iter().enumerate() {
            // Whether she would lie on the shore follows from the chart: see `ashore`.
            let is_shore = other.outline.is_of_parts();
            if index != body && !is_shore && of_outlines_m(&own, &hull(index)) <= 0.0 {
                return Some(match other.is_fixed() {
                    true => format!("{name} would be ashore on {}", other.name),
                    false => format!("the hull of {name} would overlap that of {}", other.name),
                });
            }
        }
        for of in &setup.fenders {
            // A fender on the ship moves with her. It must not lie in another body either.
            if of.body != body && of_outlines_m(&own, &fender(of)) <= 0.0 {
                return Some(format!("{name} would lie in the fender {}", of.name));
            }
            let met = (of.body == body).then(|| {
                let others = (0..setup.bodies.len())
                    .filter(|&other| other != body && !setup.bodies[other].outline.is_of_parts());
                others.into_iter().find(|&other| of_outlines_m(&fender(of), &hull(other)) <= 0.0)
            });
            if let Some(Some(other)) = met {
                let other = &setup.bodies[other].name;
                return Some(format!("the fender {} of {name} would lie in {other}", of.name));
            }
        }
        if let Some(land) = ashore(&setup.world.chart, &own) {
            return Some(format!("{name} would be ashore{land}"));
        }
    }
    None
}

/// The coast or quay of the chart on which a placed hull would lie.
fn ashore(chart: &Chart, hull: &[Vec2]) -> Option<String> {
    let overlaps = |outline: &[Vec2]| of_outlines_m(hull, outline) <= 0.0;
    let is_land = |kind: ChartKind| matches!(kind, ChartKind::Coast | ChartKind::Quay);
    let mut land = chart.features.iter().filter(|feature| is_land(feature.kind));
    let feature = land.find(|feature| match &feature.shape {
        ChartShape::Area(rings) => {
            let Some((land, basins)) = rings.split_first() else { return false };
            overlaps(land) && !basins.iter().any(|basin| lies_within(hull, basin))
        }
        ChartShape::Line(line) => line.windows(2).any(overlaps),
        ChartShape::Point(_) => false,
    })?;
    Some(match feature.name.as_str() {
        "" => String::new(),
        name => format!(" on {name}"),
    })
}

/// True if a hull lies wholly within a basin of the chart.
fn lies_within(hull: &[Vec2], basin: &[Vec2]) -> bool {
    hull.iter().all(|&corner| contains(basin, corner))
        && !basin.iter().any(|&corner| contains(hull, corner))
}

/// The rectangle that a fender covers, in the axes of the fender's body.
fn face(fender: &FenderSetup) -> [Vec2; 4] {
    let (out, along) = (
        vec2(libm::cos(fender.facing_rad), libm::sin(fender.facing_rad)),
        vec2(-libm::sin(fender.facing_rad), libm::cos(fender.facing_rad)),
    );
    let (half, tip) = (along * (0.5 * fender.width_m), out * fender.projection_m);
    let at = fender.position_m;
    [at - half, at + half, at + half + tip, at - half + tip]
}

fn on_earth(outline: &[Vec2], pose: Pose) -> Vec<Vec2> {
    outline.iter().map(|&corner| pose.apply(corner)).collect()
}
