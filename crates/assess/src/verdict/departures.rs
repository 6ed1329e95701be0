//! Finds, step by step, where a run leaves the range of its physical laws or of its data.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Contact, EventKind, combined_angle_rad};

use super::law::{Departure, Law, Subject};
use crate::gain::REPORTED_GAIN;
use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::waves::MotionResponse;
use fenderline_ship::hydro::shallow::{PUBLISHED_RATIO, SHALLOWEST_RATIO};
use fenderline_ship::hydro::{FASTEST_FROUDE, critical_mps};
use fenderline_ship::passing::{HARDLY_SLENDER, NEARLY_CRITICAL};
use fenderline_world::fender::FenderSetup;
use fenderline_world::hull::HullTouch;
use fenderline_world::record::StepRecord;
use fenderline_world::rigid_body::initial_state;
use fenderline_world::setup::Setup;
use fenderline_world::world::Environment;
use fenderline_world::world::passing::Vessels;
use fenderline_world::world::passing::{FULL_FLOW_GAP, gap_in_beams, shallowest_on_track_m};

/// The share of the sea's energy that may be at frequencies outside a vessel's data without a finding; we chose it. A
/// JONSWAP sea has 2 % of its energy at frequencies above 2.9 times the peak frequency.
const WAVES_OUTSIDE: f64 = 0.02;
/// The least squat (m) for which a run may be found outside the range of the squat formula; we chose it.
const SQUAT_M: f64 = 0.01;

/// A physical law whose range the run has left.
#[derive(Clone, Debug)]
struct Left {
    law: Law,
    subject: Subject,
    first_s: f64,
    /// Time of the last step in which the law was left (s); with this time a step is counted only once.
    last_s: f64,
    /// Number of steps in which the law was left; `None` if the law is left for the whole run.
    steps: Option<u32>,
    extent: [f64; 2],
}

/// A contact of a fender that has not ended.
#[derive(Clone, Debug, Default)]
struct Met {
    /// Number of the last step in which the fender had this contact.
    last_step: Option<u64>,
    /// For the angle and for the compression time: the value in the run and the end of the range of the factors, if the
    /// factors do not cover the value.
    beyond: [Option<[f64; 2]>; 2],
}

/// All laws and data whose range the run has left so far. The memory for this list does not grow with the run.
#[derive(Clone, Debug)]
pub(super) struct Departures {
    left: Vec<Left>,
    /// Area of each body's outline (m²).
    areas_m2: Vec<f64>,
    smallest_m2: f64,
    met: Vec<Met>,
}

impl Departures {
    /// Starts the list: before the first step it has only what holds for the whole run.
    pub(super) fn new(setup: &Setup) -> Departures {
        let areas_m2: Vec<f64> = setup.bodies.iter().map(|body| body.outline.area_m2()).collect();
        let smallest_m2 = areas_m2.iter().copied().fold(f64::INFINITY, lesser);
        let met = vec![Met::default(); setup.fenders.len()];
        let mut all = Departures { left: Vec::new(), areas_m2, smallest_m2, met };
        all.note_what_holds_always(setup);
        all
    }

    /// Clears the list, for a new run.
    pub(super) fn restart(&mut self, setup: &Setup) {
        self.left.clear();
        self.met.fill(Met::default());
        self.note_what_holds_always(setup);
    }

    /// Adds one step. `taken_j` is the energy that contacts absorbed, and `gained_j` the energy that contacts returned
    /// beyond the absorbed energy.
    pub(super) fn add(
        &mut self,
        setup: &Setup,
        step: &StepRecord<'_>,
        [taken_j, gained_j]: [f64; 2],
    ) {
        let t_s = step.t_s;
        self.add_contacts(setup, step);
        for event in step.events {
            let bodies = event.bodies.map(|body| body.0 as usize);
            match event.kind {
                EventKind::NotConverged => {
                    self.note(Law::NotConverged, Subject::Run, t_s, [0.0; 2]);
                }
                EventKind::PlacedInOverlap => {
                    self.note(Law::PlacedInOverlap, Subject::Bodies(bodies), t_s, [0.0; 2]);
                }
                // Deep overlaps are found from the contacts, for as long as they last.
                EventKind::DeepOverlap | EventKind::Contained => {}
                EventKind::ContactBegan
                | EventKind::ContactEnded
                | EventKind::PatchSplit
                | EventKind::PatchesMerged
                | EventKind::Teleported
                | EventKind::FenderRatingExceeded(_)
                | EventKind::FenderFailed(_)
                | EventKind::MassMismatch => {}
            }
        }
        if gained_j > REPORTED_GAIN * taken_j {
            self.note(Law::EnergyGained, Subject::Run, t_s, [gained_j, taken_j]);
        }
        if !setup.world.vessels.is_empty() {
            self.add_environment(setup, t_s);
            self.add_vessels(setup, step);
            self.add_flow(setup, step);
        }
    }

    /// The laws whose range the run has left, in the order of [`Law::TABLE`]. `run_s` is the simulated time of the run
    /// so far (s). `gain` is true if the contacts of the run have gained energy in total.
    pub(super) fn departures(&self, setup: &Setup, run_s: f64, gain: bool) -> Vec<Departure> {
        let departure = |left: &Left| {
            let lasting_s = left.steps.map_or(run_s, |steps| f64::from(steps) * setup.step_s);
            let share_of_run = if run_s > 0.0 { lesser(lasting_s / run_s, 1.0) } else { 1.0 };
            let &Left { law, subject, first_s, extent, .. } = left;
            Departure { law, subject, first_s, lasting_s, share_of_run, extent }
        };
        // Surplus energy of one contact is not reported if other contacts lose more.
        let is_told = |left: &&Left| left.law != Law::EnergyGained || gain;
        let mut all: Vec<Departure> = self.left.iter().filter(is_told).map(departure).collect();
        // The sort is stable: departures from one law keep the order in which they began.
        all.sort_by_key(|departure| departure.law as usize);
        all
    }

    /// Counts a step. `extent` keeps, of all steps, the value that is farthest outside the range of the law.
    fn note(&mut self, law: Law, subject: Subject, t_s: f64, extent: [f64; 2]) {
        let same = |left: &&mut Left| left.law == law && left.subject == subject;
        match self.left.iter_mut().find(same) {
            None => self.left.push(Left {
                law,
                subject,
                first_s: t_s,
                last_s: t_s,
                steps: Some(1),
                extent,
            }),
            Some(left) => {
                if left.last_s != t_s {
                    left.last_s = t_s;
                    left.steps = left.steps.map(|steps| steps + 1);
                }
                left.extent = law.farther(left.extent, extent);
            }
        }
    }

    /// Notes the laws whose range the run leaves from its start to its end.
    fn note_what_holds_always(&mut self, setup: &Setup) {
        let environment = &setup.world.environment;
        let mut always = |law, subject, extent| {
            let (first_s, last_s) = (0.0, f64::NEG_INFINITY);
            self.left.push(Left { law, subject, first_s, last_s, steps: None, extent });
        };
        for (index, vessel) in setup.world.vessels.iter().enumerate() {
            let subject = Subject::Vessel(index);
            for ratio in 0..vessel.origin.outside.len() {
                always(Law::EstimateOutside, Subject::Ratio { vessel: index, ratio }, [0.0; 2]);
            }
            if let Some(seakeeping) = &vessel.seakeeping {
                let draught_m = vessel.ship.particulars.draught_m;
                let state = initial_state(&setup.bodies[vessel.body]);
                // A vessel off the data of the bottom has refused the set-up.
                let Ok(soundings) = vessel.soundings(&state, environment, 0.0) else { continue };
                let depths_m = [seakeeping.data.depth_m(), soundings.mean_m];
                if !seakeeping.is_for_depth(depths_m[1], draught_m) {
                    let extent = depths_m.map(|depth_m| depth_m.unwrap_or(f64::INFINITY));
                    always(Law::DepthOfHydrodynamics, subject, extent);
                }
            }
            let Some(sea) = &environment.sea else { continue };
            let range = match (&vessel.seakeeping, &vessel.response) {
                (Some(of), _) => Some((Law::WavesOfHydrodynamics, of.data.wave_range_radps())),
                (None, Some(MotionResponse::Table(table))) => {
                    Some((Law::WavesOfResponse, table.range_radps()))
                }
                (None, Some(MotionResponse::Estimate(_)) | None) => None,
            };
            if let Some((law, range_radps)) = range {
                let share = sea.share_outside(range_radps);
                if share > WAVES_OUTSIDE {
                    always(law, subject, [share, 0.0]);
                }
            }
        }
        for (index, ship) in setup.world.flow.passing.iter().enumerate() {
            let subject = Subject::Passing(index);
            let slender = ship.hull.length_m / ship.hull.beam_m;
            if slender < HARDLY_SLENDER {
                always(Law::PassingShape, subject, [slender, HARDLY_SLENDER]);
            }
            let Some(shallowest_m) = shallowest_on_track_m(ship, environment, setup.duration_s)
            else {
                continue;
            };
            let share = ship.track.pace.fastest_mps() / critical_mps(shallowest_m);
            if share > NEARLY_CRITICAL {
                always(Law::PassingSpeed, subject, [share, NEARLY_CRITICAL]);
            }
        }
    }

    /// Notes the laws whose range is left in this step by overlaps of outlines or by contacts of fenders.
    fn add_contacts(&mut self, setup: &Setup, step: &StepRecord<'_>) {
        for (index, contact) in step.contacts.iter().enumerate() {
            let Some(fender) = contact.fender else {
                // Shortcut for most contacts: their area is less than half of any body's area.
                if contact.area_m2 > 0.5 * self.smallest_m2 {
                    self.add_overlap(contact, step.t_s);
                }
                continue;
            };
            let fender = fender.0 as usize;
            let met = &mut self.met[fender];
            let lasts = met.last_step.is_some_and(|last| last + 1 >= step.index);
            met.last_step = Some(step.index);
            if !lasts {
                let touch = step.hull_touches.get(index).copied().flatten();
                met.beyond = beyond(&setup.fenders[fender], contact, touch);
            }
            let beyond = met.beyond;
            for (law, extent) in [Law::FenderAngle, Law::FenderSpeed].into_iter().zip(beyond) {
                if let Some(extent) = extent {
                    self.note(law, Subject::Fender(fender), step.t_s, extent);
                }
            }
        }
    }

    fn add_overlap(&mut self, contact: &Contact, t_s: f64) {
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        let [one_m2, other_m2] = bodies.map(|body| self.areas_m2[body]);
        let share = contact.area_m2 / lesser(one_m2, other_m2);
        if share > 0.5 {
            let extent = [lesser(share, 1.0), contact.peak_depth_m];
            self.note(Law::DeepOverlap, Subject::Bodies(bodies), t_s, extent);
        }
    }

    /// Notes each series of wind, tide or long waves that does not cover the time of the step: before its first time or
    /// after its last time, the series keeps the value at that end.
    fn add_environment(&mut self, setup: &Setup, t_s: f64) {
        let Environment { wind, tide, long_waves, .. } = &setup.world.environment;
        for (law, is_held) in [
            (Law::WindHeld, wind.as_ref().is_some_and(|wind| wind.is_held(t_s))),
            (Law::TideHeld, tide.is_held(t_s)),
            (Law::LongWavesHeld, long_waves.as_ref().is_some_and(|waves| waves.is_held(t_s))),
        ] {
            if is_held {
                self.note(law, Subject::Run, t_s, [0.0; 2]);
            }
        }
    }

    /// Notes the vessels that are off the grid of the current or in shallow water.
    fn add_vessels(&mut self, setup: &Setup, step: &StepRecord<'_>) {
        let environment = &setup.world.environment;
        for (index, vessel) in setup.world.vessels.iter().enumerate() {
            let subject = Subject::Vessel(index);
            let state = &step.states[vessel.body];
            if let Some(Current::Grid(grid)) = &environment.current
                && grid.is_held(state.position_m, step.t_s)
            {
                self.note(Law::CurrentHeld, subject, step.t_s, [0.0; 2]);
            }
            let Some(depth_m) = step.soundings[index].mean_m else { continue };
            let ratio = depth_m / vessel.ship.particulars.draught_m;
            if ratio < SHALLOWEST_RATIO {
                self.note(Law::ShallowHeld, subject, step.t_s, [ratio, SHALLOWEST_RATIO]);
            } else if ratio < PUBLISHED_RATIO {
                self.note(Law::ShallowExtrapolated, subject, step.t_s, [ratio, PUBLISHED_RATIO]);
            }
            let Some(squat) = environment.squat.filter(|_| step.vessels[index].squat_m >= SQUAT_M)
            else {
                continue;
            };
            if let Some([_, high]) = squat.depth_ratios().filter(|[_, high]| ratio > *high) {
                self.note(Law::SquatDepth, subject, step.t_s, [ratio, high]);
            }
            let surge_mps = vessel.velocity(state, environment, step.t_s).surge_mps.abs();
            // As in the formulas of squat: in less water, the values at 1.1 draughts are used.
            let draught_m = vessel.ship.particulars.draught_m;
            let froude = surge_mps / critical_mps(greater(depth_m, SHALLOWEST_RATIO * draught_m));
            if froude > FASTEST_FROUDE {
                self.note(Law::SquatSpeed, subject, step.t_s, [froude, FASTEST_FROUDE]);
            }
        }
    }
}

impl Departures {
    /// Notes that an external program that gives forces did not reply in this step.
    pub(super) fn note_silent_provider(&mut self, provider: usize, t_s: f64) {
        self.note(Law::ProviderSilent, Subject::Provider(provider), t_s, [0.0; 2]);
    }

    /// Notes the vessels so near each other that the flow between them is left out.
    fn add_flow(&mut self, setup: &Setup, step: &StepRecord<'_>) {
        let world = &setup.world;
        if !world.flow.between_vessels {
            return;
        }
        for one in 0..world.vessels.len() {
            for other in one + 1..world.vessels.len() {
                let pair = [one, other];
                let vessels = Vessels { setups: &world.vessels, states: step.states };
                let gap = gap_in_beams(&world.flow, vessels, &world.environment, step.t_s, pair);
                if let Some(gap) = gap.filter(|gap| *gap < FULL_FLOW_GAP) {
                    let bodies = pair.map(|vessel| world.vessels[vessel].body);
                    let subject = Subject::Bodies(bodies);
                    self.note(
                        Law::FlowLeftOut,
                        subject,
                        step.t_s,
                        [greater(gap, 0.0), FULL_FLOW_GAP],
                    );
                }
            }
        }
    }
}

impl Law {
    /// Of two extents, returns the extent that is farther outside the range of the law.
    fn farther(self, one: [f64; 2], other: [f64; 2]) -> [f64; 2] {
        match self {
            Law::EnergyGained => other,
            Law::DeepOverlap => [greater(one[0], other[0]), greater(one[1], other[1])],
            Law::FenderSpeed | Law::ShallowHeld | Law::ShallowExtrapolated | Law::FlowLeftOut => {
                [lesser(one[0], other[0]), one[1]]
            }
            _ => [greater(one[0], other[0]), one[1]],
        }
    }
}

/// For a contact of a fender that the fender's factors do not cover: the angle (rad) and the compression time (s) at
/// the start of the contact, each with the end of the range of the factors.
fn beyond(
    fender: &FenderSetup,
    contact: &Contact,
    touch: Option<HullTouch>,
) -> [Option<[f64; 2]>; 2] {
    let angle_rad =
        combined_angle_rad(contact.tilt_rad, touch.map_or(0.0, |touch| touch.slope)).abs();
    let last = |points: &[[f64; 2]]| points.last().filter(|_| points.len() > 1).map(|of| of[0]);
    let angle = [&fender.factors.by_angle, &fender.energy_by_angle]
        .into_iter()
        .filter_map(|points| last(points))
        .reduce(lesser)
        .filter(|last_rad| angle_rad > *last_rad)
        .map(|last_rad| [angle_rad, last_rad]);
    let times = &fender.factors.by_compression_time;
    let first_s = times.first().filter(|_| times.len() > 1).map(|of| of[0]);
    let time_s = fender.compression_time_s(contact.v_normal_mps);
    let speed = first_s.zip(time_s).filter(|(first_s, time_s)| time_s < first_s);
    [angle, speed.map(|(first_s, time_s)| [time_s, first_s])]
}
