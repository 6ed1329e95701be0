//! Computes the present value of each measure of an exercise.

use fenderline_contact::number::{greater, lesser};

use super::ExerciseSetup;
use super::clearance::distance_m;
use super::limit::{Limit, Measure};
use crate::berth::Lie;
use crate::simulation::Simulation;
use fenderline_ship::track::OnPlan;
use fenderline_world::setup::Setup;
use fenderline_world::world::{AnchorAtWork, LineEnd};

/// The subject of a measured value: the ship, a part of her, a fender, a line, an anchor or a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The ship as a whole.
    Ship,
    /// The ship's bow.
    Bow,
    /// The ship's stern.
    Stern,
    /// A fender, by its index in [`Setup::fenders`].
    Fender(usize),
    /// A line, by its index in [`crate::WorldSetup::lines`].
    Line(usize),
    /// An anchor, by its index in [`crate::WorldSetup::anchors`].
    Anchor(usize),
    /// A body, by its index in [`Setup::bodies`].
    Body(usize),
}

impl Subject {
    /// Name of the subject.
    #[must_use]
    pub fn name(self, setup: &Setup) -> String {
        match self {
            Subject::Ship => "ship".to_owned(),
            Subject::Bow => "bow".to_owned(),
            Subject::Stern => "stern".to_owned(),
            Subject::Fender(fender) => setup.fenders[fender].name.clone(),
            Subject::Line(line) => setup.world.lines[line].line.name.clone(),
            Subject::Anchor(anchor) => setup.world.anchors[anchor].gear.name.clone(),
            Subject::Body(body) => setup.bodies[body].name.clone(),
        }
    }
}

/// The worst present value of the quantity that a limit bounds, and the ship, line or fender that has this value.
/// `None` if the quantity has no value, for example far from the berth.
pub(super) fn worst_now(
    limit: &Limit,
    exercise: &ExerciseSetup,
    simulation: &Simulation,
    lie: Option<&Lie>,
) -> Option<(f64, Subject)> {
    if limit.within_m.is_finite() && !is_near(limit.within_m, exercise, simulation, lie?) {
        return None;
    }
    let body = simulation.setup().world.vessels[exercise.vessel].body;
    let vessel = &simulation.vessels()[exercise.vessel];
    match limit.measure {
        Measure::ApproachSpeed => {
            let lie = lie?;
            let ends = [Subject::Bow, Subject::Stern].into_iter().enumerate();
            let near = ends.filter(|(end, _)| lie.off_m[*end] < limit.within_m);
            largest(near.map(|(end, subject)| (lie.closing_mps[end], subject)))
        }
        Measure::AheadSpeed => Some((lie?.ahead_mps.abs(), Subject::Ship)),
        Measure::Angle => Some((lie?.angle_rad.abs(), Subject::Ship)),
        Measure::Engine => {
            let stop = simulation.setup().world.vessels[exercise.vessel].shaft.stop;
            let azimuths = vessel.azimuths.iter().map(|unit| unit.power.value.abs());
            let shaft = if stop > 0.0 { (vessel.shaft.value / stop).abs() } else { 0.0 };
            Some((azimuths.fold(shaft, greater), Subject::Ship))
        }
        Measure::Fender => fender(exercise, simulation),
        Measure::Line => line(body, simulation),
        Measure::Chain => {
            largest(own_anchors(exercise.vessel, simulation).map(|(index, anchor)| {
                // A chain that parts has no tension afterwards.
                let load = &anchor.load;
                let tension_n = load.lost_at_n.unwrap_or(load.tension_n);
                let chain = simulation.setup().world.anchors[index].gear.chain();
                (tension_n / chain.break_load_n(), Subject::Anchor(index))
            }))
        }
        Measure::Dragged => largest(
            own_anchors(exercise.vessel, simulation)
                .map(|(index, anchor)| (anchor.state.dragged_m, Subject::Anchor(index))),
        ),
        Measure::Clearance => clearance(body, exercise, simulation),
        Measure::UnderKeel => Some((vessel.under_keel_m?, Subject::Ship)),
        Measure::CrossTrack => {
            let ship = &simulation.setup().world.vessels[exercise.vessel];
            let on = ship.on_plan(&simulation.states()[body]).filter(OnPlan::is_on_leg)?;
            Some((on.cross_track_m.abs(), Subject::Ship))
        }
        Measure::Touch => Some(touch(body, simulation)),
        Measure::Time => Some((simulation.time_s(), Subject::Ship)),
    }
}

fn largest(of: impl Iterator<Item = (f64, Subject)>) -> Option<(f64, Subject)> {
    // Of equal values the first is taken.
    of.reduce(|best, next| if next.0 > best.0 { next } else { best })
}

/// Returns true if the ship is abreast of the berth and one of her ends is within `within_m` of the berth.
fn is_near(within_m: f64, exercise: &ExerciseSetup, simulation: &Simulation, lie: &Lie) -> bool {
    let Some(berth) = &exercise.berth else { return false };
    let setup = simulation.setup();
    let body = setup.world.vessels[exercise.vessel].body;
    let states = simulation.states();
    let (on, outline) = (&states[berth.body], &setup.bodies[body].outline);
    lesser(lie.off_m[0], lie.off_m[1]) < within_m
        && berth.is_near(on, outline, &states[body], f64::INFINITY)
}

/// The largest share of its rating that a fender on the body of the berth has reached so far.
fn fender(exercise: &ExerciseSetup, simulation: &Simulation) -> Option<(f64, Subject)> {
    let on = exercise.berth?.body;
    let fenders = &simulation.setup().fenders;
    let at_berth = simulation.fender_summaries().filter(|of| fenders[of.fender].body == on);
    largest(at_berth.map(|of| {
        let shares = of.share_of_rated_energy.into_iter().chain(of.share_of_largest_reaction);
        (shares.fold(0.0, greater), Subject::Fender(of.fender))
    }))
}

/// The largest tension of a line that is fast to the ship, divided by the break load of the line.
fn line(body: usize, simulation: &Simulation) -> Option<(f64, Subject)> {
    let world = &simulation.setup().world;
    let lines = simulation.lines().iter().zip(&world.lines).enumerate();
    let fast = lines.filter(|(_, (line, setup))| {
        let far = match line.end(setup, &world.bollards) {
            Some(LineEnd::OnBody { body, .. }) => Some(body),
            Some(LineEnd::Fixed(_)) | None => None,
        };
        line.line.is_some() && (setup.ship == body || far == Some(body))
    });
    largest(fast.map(|(index, (line, setup))| {
        (line.load.tension_n / setup.line.kind.break_load_n(), Subject::Line(index))
    }))
}

/// The anchors of a vessel, with their indices in the set-up.
fn own_anchors(
    vessel: usize,
    simulation: &Simulation,
) -> impl Iterator<Item = (usize, &AnchorAtWork)> {
    let anchors = simulation.anchors().iter().zip(&simulation.setup().world.anchors).enumerate();
    let own = anchors.filter(move |(_, (_, setup))| setup.vessel == vessel);
    own.map(|(index, (anchor, _))| (index, anchor))
}

/// The least distance of the ship's hull from a fixed body that is not her berth.
fn clearance(
    body: usize,
    exercise: &ExerciseSetup,
    simulation: &Simulation,
) -> Option<(f64, Subject)> {
    let (setup, states) = (simulation.setup(), simulation.states());
    let berth = exercise.berth.map(|berth| berth.body);
    let own = (&setup.bodies[body].outline, states[body].pose());
    let mut best: Option<(f64, Subject)> = None;
    for (index, other) in setup.bodies.iter().enumerate() {
        if !other.is_fixed() || Some(index) == berth {
            continue;
        }
        let nearer_m = best.map_or(f64::INFINITY, |(least_m, _)| least_m);
        let found_m = distance_m(own, (&other.outline, states[index].pose()), nearer_m);
        if found_m < nearer_m {
            best = Some((found_m, Subject::Body(index)));
        }
    }
    best
}

/// Returns 1 and the body that the ship's hull touches in this step without a fender between them; returns 0 without
/// such a touch.
fn touch(body: usize, simulation: &Simulation) -> (f64, Subject) {
    for contact in simulation.contacts().iter().filter(|contact| contact.fender.is_none()) {
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        if let Some(at) = bodies.iter().position(|&of| of == body) {
            return (1.0, Subject::Body(bodies[1 - at]));
        }
    }
    (0.0, Subject::Ship)
}
