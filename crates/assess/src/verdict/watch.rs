//! The totals of a run from which the findings of its verdict follow. The memory for these totals does not grow with
//! the run.

use fenderline_contact::number::greater;

use super::departures::Departures;
use super::factored::factored;
use super::fender::{above_catalogue, chains_parted, fender_finding};
use super::finding::Finding;
use fenderline_ship::anchor::{AnchorPosition, LostBy};
use fenderline_ship::track::OnPlan;
use fenderline_world::dolphin::DolphinSummary;
use fenderline_world::fender::FenderSummary;
use fenderline_world::hull::SideMissed;
use fenderline_world::overhead::AirClearance;
use fenderline_world::record::StepRecord;
use fenderline_world::setup::Setup;
use fenderline_world::world::{AnchorAtWork, Mooring, WorldEventKind};

/// The time at which a condition first held, and the number of steps in which the condition held.
#[derive(Clone, Copy, Debug, Default)]
struct Lasting {
    first_s: Option<f64>,
    steps: u32,
}

impl Lasting {
    fn count(&mut self, t_s: f64) {
        self.first_s.get_or_insert(t_s);
        self.steps += 1;
    }

    /// Time at which the condition first held, and for how long it held (s); `None` if the condition never held.
    fn first_and_lasting(self, step_s: f64) -> Option<(f64, f64)> {
        self.first_s.map(|first_s| (first_s, f64::from(self.steps) * step_s))
    }
}

/// Contact of two bodies without a fender between them.
#[derive(Clone, Debug)]
struct Touch {
    bodies: [usize; 2],
    lasting: Lasting,
    peak_force_n: f64,
    peak_depth_m: f64,
}

#[derive(Clone, Debug, Default)]
struct LineWatch {
    over_working: Lasting,
    peak_n: f64,
    rendered_m: f64,
    /// Time at which the line parted (s), and its tension then (N).
    parted: Option<(f64, f64)>,
    /// Time at which the line could not be made fast (s).
    not_made_fast_s: Option<f64>,
}

/// Distance (m) beyond which the dragging of an anchor is a finding. A few metres of dragging are usual while a ship
/// brings up to her anchor or heaves in most of her chain. Our choice.
const DRAGGED_M: f64 = 10.0;

/// How a vessel left the corridor of her passage plan.
#[derive(Clone, Copy, Debug, Default)]
struct CorridorWatch {
    outside: Lasting,
    /// The farthest that she was outside (m), and where she was then.
    farthest_m: f64,
    at: Option<OnPlan>,
}

impl CorridorWatch {
    fn add(&mut self, now: OnPlan, t_s: f64) {
        let Some(outside_m) = now.outside_m() else { return };
        self.outside.count(t_s);
        if outside_m > self.farthest_m {
            (self.farthest_m, self.at) = (outside_m, Some(now));
        }
    }

    fn finding(self, vessel: usize, step_s: f64) -> Option<Finding> {
        let (first_s, lasting_s) = self.outside.first_and_lasting(step_s)?;
        let OnPlan { leg, cross_track_m, half_width_m, .. } = self.at?;
        let half_width_m = half_width_m?;
        Some(Finding::LeftCorridor { vessel, leg, first_s, lasting_s, cross_track_m, half_width_m })
    }
}

/// How a vessel met bridges and cables that were too low for her.
#[derive(Clone, Copy, Debug, Default)]
struct OverheadWatch {
    struck: Lasting,
    /// The least clearance, which is negative.
    least: Option<AirClearance>,
}

impl OverheadWatch {
    fn add(&mut self, now: AirClearance, t_s: f64) {
        if now.clearance_m >= 0.0 {
            return;
        }
        self.struck.count(t_s);
        if self.least.is_none_or(|least| now.clearance_m < least.clearance_m) {
            self.least = Some(now);
        }
    }

    fn finding(self, vessel: usize, step_s: f64) -> Option<Finding> {
        let (first_s, lasting_s) = self.struck.first_and_lasting(step_s)?;
        let AirClearance { structure, clearance_m, at_m } = self.least?;
        Some(Finding::TooHigh { vessel, structure, first_s, lasting_s, clearance_m, at_m })
    }
}

#[derive(Clone, Debug, Default)]
struct AnchorWatch {
    /// Time at which the anchor first dragged (s), and how far the anchor dragged in all (m).
    first_s: Option<f64>,
    dragged_m: f64,
    /// Time at which the anchor was lost (s), how it was lost, and the tension of its chain then (N).
    lost: Option<(f64, LostBy, f64)>,
}

/// The totals.
#[derive(Clone, Debug)]
pub struct Watch {
    /// For each body, whether a contact of the body without a fender counts as a strike.
    protected: Vec<bool>,
    starts: Vec<Finding>,
    touches: Vec<Touch>,
    aground: Vec<Lasting>,
    corridors: Vec<CorridorWatch>,
    overheads: Vec<OverheadWatch>,
    lines: Vec<LineWatch>,
    anchors: Vec<AnchorWatch>,
    departures: Departures,
}

/// The bodies that fenders protect: bodies that carry fenders, and all fixed bodies if one of them carries fenders.
fn protected(setup: &Setup) -> Vec<bool> {
    let mut all = vec![false; setup.bodies.len()];
    for fender in &setup.fenders {
        all[fender.body] = true;
    }
    let is_berth = all.iter().zip(&setup.bodies).any(|(carries, body)| *carries && body.is_fixed());
    for (own, body) in all.iter_mut().zip(&setup.bodies) {
        *own |= is_berth && body.is_fixed();
    }
    all
}

impl Watch {
    /// The totals of a run before its first step. `starts_inside` finds the bodies that overlap at the start.
    pub fn new(
        setup: &Setup,
        starts_inside: impl FnOnce(&dyn Fn([usize; 2]) -> bool) -> Vec<Finding>,
    ) -> Watch {
        let protected = protected(setup);
        let starts = starts_inside(&|bodies: [usize; 2]| bodies.iter().any(|&b| protected[b]));
        Watch {
            starts,
            touches: Vec::new(),
            aground: vec![Lasting::default(); setup.world.vessels.len()],
            corridors: vec![CorridorWatch::default(); setup.world.vessels.len()],
            overheads: vec![OverheadWatch::default(); setup.world.vessels.len()],
            lines: vec![LineWatch::default(); setup.world.lines.len()],
            anchors: vec![AnchorWatch::default(); setup.world.anchors.len()],
            departures: Departures::new(setup),
            protected,
        }
    }

    /// Clears the totals for a new run. `starts_inside` finds the bodies that overlap at the start of the next run.
    pub fn restart(
        &mut self,
        setup: &Setup,
        starts_inside: impl FnOnce(&dyn Fn([usize; 2]) -> bool) -> Vec<Finding>,
    ) {
        let Watch {
            protected,
            starts,
            touches,
            aground,
            corridors,
            overheads,
            lines,
            anchors,
            departures,
        } = self;
        *starts = starts_inside(&|bodies: [usize; 2]| bodies.iter().any(|&b| protected[b]));
        touches.clear();
        aground.fill(Lasting::default());
        corridors.fill(CorridorWatch::default());
        overheads.fill(OverheadWatch::default());
        lines.fill(LineWatch::default());
        anchors.fill(AnchorWatch::default());
        departures.restart(setup);
    }

    /// Notes that an external program that gives forces did not reply in this step.
    pub fn note_silent_provider(&mut self, provider: usize, t_s: f64) {
        self.departures.note_silent_provider(provider, t_s);
    }

    /// The findings that were known before the first step.
    pub fn starts(&self) -> &[Finding] {
        &self.starts
    }

    /// The largest tension of each line so far (N).
    pub fn peak_tensions_n(&self) -> Vec<f64> {
        self.lines.iter().map(|line| line.peak_n).collect()
    }

    /// Adds one step. `energies_j` are the energy that contacts absorbed so far, and the energy that contacts returned
    /// beyond the absorbed energy.
    pub fn add(&mut self, setup: &Setup, step: &StepRecord<'_>, energies_j: [f64; 2]) {
        self.add_touches(step);
        if setup.world.changes() {
            self.add_world(setup, step);
        }
        self.departures.add(setup, step, energies_j);
    }

    /// Adds what this step tells about vessels, lines and anchors.
    fn add_world(&mut self, setup: &Setup, step: &StepRecord<'_>) {
        for (own, now) in self.aground.iter_mut().zip(step.vessels) {
            if now.aground {
                own.count(step.t_s);
            }
        }
        for (own, vessel) in self.corridors.iter_mut().zip(&setup.world.vessels) {
            if let Some(now) = vessel.on_plan(&step.states[vessel.body]) {
                own.add(now, step.t_s);
            }
        }
        if !setup.world.overhead.structures.is_empty() {
            let level_m = setup.world.environment.level_m(step.t_s);
            let vessels = setup.world.vessels.iter().zip(step.vessels).enumerate();
            for (own, (index, (vessel, now))) in self.overheads.iter_mut().zip(vessels) {
                let state = &step.states[vessel.body];
                if let Some(now) = setup.world.overhead.over(index, state, level_m, now.squat_m) {
                    own.add(now, step.t_s);
                }
            }
        }
        for ((own, line), now) in self.lines.iter_mut().zip(&setup.world.lines).zip(step.lines) {
            own.add(line.line.kind.working_load_n(), now, step.t_s);
        }
        for (own, now) in self.anchors.iter_mut().zip(step.anchors) {
            own.add(now, step.t_s);
        }
        for event in step.world_events {
            if event.kind == WorldEventKind::LineNotMadeFast {
                self.lines[event.who].not_made_fast_s.get_or_insert(step.t_s);
            }
        }
    }

    /// Adds contacts without fenders. The patches of a pair of bodies are adjacent in the list, and their forces in a
    /// step are added.
    fn add_touches(&mut self, step: &StepRecord<'_>) {
        let mut last: Option<(usize, f64)> = None;
        for contact in step.contacts.iter().filter(|contact| contact.fender.is_none()) {
            let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
            let found = self.touches.iter().position(|touch| touch.bodies == bodies);
            let index = found.unwrap_or_else(|| {
                let lasting = Lasting::default();
                self.touches.push(Touch { bodies, lasting, peak_force_n: 0.0, peak_depth_m: 0.0 });
                self.touches.len() - 1
            });
            let touch = &mut self.touches[index];
            let force_n = match last {
                Some((same, force_n)) if same == index => force_n + contact.peak_normal_force_n,
                _ => {
                    touch.lasting.count(step.t_s);
                    contact.peak_normal_force_n
                }
            };
            touch.peak_force_n = greater(touch.peak_force_n, force_n);
            touch.peak_depth_m = greater(touch.peak_depth_m, contact.peak_depth_m);
            last = Some((index, force_n));
        }
    }

    /// The findings so far, the worst first. Findings of one kind are in the order of the set-up, and findings on
    /// contacts in the order of first touch. `run_s` is the simulated time of the run so far (s). `has_gained` is true
    /// if the contacts have gained energy in total.
    pub fn findings<'a>(
        &self,
        setup: &Setup,
        (fenders, missed): (
            impl Iterator<Item = &'a FenderSummary>,
            impl Iterator<Item = &'a SideMissed>,
        ),
        dolphins: &[DolphinSummary],
        (run_s, has_gained): (f64, bool),
    ) -> Vec<Finding> {
        let step_s = setup.step_s;
        let mut all = self.starts.clone();
        let touches = self.touches.iter().filter(|touch| touch.peak_force_n > 0.0);
        all.extend(touches.map(|touch| self.touch_finding(touch, step_s)));
        let touched: Vec<&FenderSummary> = fenders.collect();
        for summary in &touched {
            all.extend(fender_finding(summary, &setup.fenders[summary.fender]));
            all.extend(chains_parted(summary));
        }
        all.extend(above_catalogue(&setup.fenders, touched.iter().copied()));
        all.extend(dolphins.iter().filter_map(pile_yielded));
        if touched.is_empty() && !setup.fenders.is_empty() {
            all.push(Finding::NoFenderTouched);
        }
        all.extend(missed.map(|&SideMissed { fender, body, first_s, off_m }| {
            Finding::NoSideAtFender { fender, body, first_s, off_m }
        }));
        for (vessel, own) in self.aground.iter().enumerate() {
            let found = own.first_and_lasting(step_s);
            all.extend(found.map(|(first_s, lasting_s)| Finding::Aground {
                vessel,
                first_s,
                lasting_s,
            }));
        }
        for (vessel, own) in self.corridors.iter().enumerate() {
            all.extend(own.finding(vessel, step_s));
        }
        for (vessel, own) in self.overheads.iter().enumerate() {
            all.extend(own.finding(vessel, step_s));
        }
        for (line, own) in self.lines.iter().enumerate() {
            let working_n = setup.world.lines[line].line.kind.working_load_n();
            all.extend(own.finding(line, working_n, step_s));
        }
        let peaks_n = self.lines.iter().map(|own| own.peak_n);
        all.extend(factored(setup, &touched, peaks_n));
        for (anchor, own) in self.anchors.iter().enumerate() {
            all.extend(own.finding(anchor));
        }
        let departures = self.departures.departures(setup, run_s, has_gained).into_iter();
        all.extend(departures.map(Finding::OutsideLaw));
        // The sort is stable: findings of one kind keep their order.
        all.sort_by_key(|finding| core::cmp::Reverse(finding.verdict()));
        all
    }

    fn touch_finding(&self, touch: &Touch, step_s: f64) -> Finding {
        let Touch { bodies, lasting, peak_force_n, peak_depth_m } = *touch;
        match lasting.first_and_lasting(step_s) {
            Some((first_s, lasting_s)) if bodies.iter().any(|&body| self.protected[body]) => {
                Finding::StructureStruck { bodies, first_s, lasting_s, peak_force_n, peak_depth_m }
            }
            _ => Finding::ContactNotRated { bodies, peak_force_n },
        }
    }
}

/// The finding that the pile of a dolphin yielded; `None` if the pile did not yield.
fn pile_yielded(dolphin: &DolphinSummary) -> Option<Finding> {
    let (first_s, share) = (dolphin.yielded_at_s?, dolphin.share_of_yield_load?);
    let DolphinSummary { body, peak_load_n, .. } = *dolphin;
    Some(Finding::PileYielded {
        body,
        first_s,
        load_n: peak_load_n / share,
        offset_m: dolphin.offset_m,
    })
}

impl AnchorWatch {
    fn add(&mut self, now: &AnchorAtWork, t_s: f64) {
        let moved_m = now.load.moved_m;
        if moved_m > 0.0 {
            self.first_s.get_or_insert(t_s);
            self.dragged_m += moved_m;
        }
        if let (AnchorPosition::Lost(by), Some(tension_n)) =
            (now.state.position, now.load.lost_at_n)
        {
            self.lost.get_or_insert((t_s, by, tension_n));
        }
    }

    fn finding(&self, anchor: usize) -> Option<Finding> {
        if let Some((at_s, by, tension_n)) = self.lost {
            return Some(Finding::AnchorLost { anchor, at_s, by, tension_n });
        }
        let dragged_m = self.dragged_m;
        let is_told = dragged_m > DRAGGED_M;
        let first_s = self.first_s.filter(|_| is_told);
        first_s.map(|first_s| Finding::AnchorDragged { anchor, first_s, dragged_m })
    }
}

impl LineWatch {
    fn add(&mut self, working_n: Option<f64>, now: &Mooring, t_s: f64) {
        let Some((_, state)) = &now.line else { return };
        let tension_n = greater(now.load.tension_n, now.load.parted_at_n.unwrap_or(0.0));
        self.peak_n = greater(self.peak_n, tension_n);
        if state.parted && self.parted.is_none() {
            self.parted = Some((t_s, now.load.parted_at_n.unwrap_or(self.peak_n)));
        }
        if working_n.is_some_and(|limit_n| now.load.tension_n > limit_n) {
            self.over_working.count(t_s);
        }
        self.rendered_m += now.load.winch.rendered_m;
    }

    fn finding(&self, line: usize, working_n: Option<f64>, step_s: f64) -> Option<Finding> {
        if let Some((at_s, tension_n)) = self.parted {
            return Some(Finding::LineParted { line, at_s, tension_n });
        }
        if let (Some((first_s, lasting_s)), Some(working_n)) =
            (self.over_working.first_and_lasting(step_s), working_n)
        {
            let share = self.peak_n / working_n;
            return Some(Finding::LineOverWorking { line, first_s, lasting_s, share });
        }
        if let Some(at_s) = self.not_made_fast_s {
            return Some(Finding::LineNotMadeFast { line, at_s });
        }
        let rendered_m = self.rendered_m;
        (rendered_m > 0.0).then_some(Finding::LineRendered { line, rendered_m })
    }
}
