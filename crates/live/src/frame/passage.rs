//! Finds ships that pass vessels at rest: how near and how fast each ship passes, and what force the flow around the
//! passing ship exerts on the vessel. From these passages people learn why a moored ship surges and why her lines part.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Pose, Vec2};
use fenderline_sim::distance::{nearest_points, of_outlines_m};
use fenderline_sim::hydro::Force;
use fenderline_sim::passing::PassingSetup;
use fenderline_sim::{Simulation, WorldEvent, WorldEventKind};

use crate::info::Info;
use crate::message::PassageNow;
use crate::pair::pair;

/// A vessel counts as at rest if her speed over the ground is below this number (m/s). The speed below which a vessel
/// is at rest is our choice.
const AT_REST_MPS: f64 = 0.5;
/// A ship passes a vessel only if her speed is above this number (m/s). The speed above which a ship passes is our
/// choice.
const PASSES_MPS: f64 = 0.5;
/// A ship passes a vessel while the distance between midships is less than this factor times the mean of both lengths.
/// Beyond that distance between midships, the force of the ship's flow is a few hundredths of its largest value. The
/// factor for the greatest distance of a passage is our choice.
const IN_REACH: f64 = 2.0;
/// For this long after a ship has passed (s), texts still name her as a cause of the load in lines: a moored ship
/// swings for minutes. The time for which a passage counts as a cause is our choice.
const LINGERS_S: f64 = 300.0;
/// A ship that will pass is announced this long before she is abreast of the vessel (s). The time of the announcement
/// is our choice.
const ANNOUNCED_S: f64 = 300.0;
/// A ship that will pass is announced only if the clear distance will be less than this factor times the mean of both
/// lengths. The factor for announcing a ship is our choice.
const NEAR: f64 = 0.75;
/// A passing ship is left out if her displacement is less than this share of the vessel's: the flow around her moves
/// the vessel little. The smallest share of displacement that counts is our choice.
const SMALLEST_SHARE: f64 = 0.05;
const KNOT_MPS: f64 = 1852.0 / 3600.0;

/// A ship that is passing a vessel.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Passage {
    /// Index of the vessel that is passed, among the vessels of the set-up.
    vessel: usize,
    /// The body of the vessel that is passed.
    body: usize,
    /// Index of the ship that passes, among the passing ships.
    ship: usize,
    gap_m: f64,
    between_m: [Vec2; 2],
    speed_mps: f64,
    /// True if the ship goes away and is a ship's length off. When the ship goes away and is a length off, the passage
    /// is over.
    is_past: bool,
    /// The force on the vessel by the flow around all passing ships.
    force: Force,
}

/// A ship that will pass a vessel if she keeps her course and speed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Announced {
    vessel: usize,
    ship: usize,
    in_s: f64,
    gap_m: f64,
    speed_mps: f64,
}

/// The largest values during a ship's passage.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Largest {
    vessel: usize,
    body: usize,
    ship: usize,
    /// When the passage ended (s); `None` while it goes on.
    ended_s: Option<f64>,
    least_gap_m: f64,
    fastest_mps: f64,
    ahead_n: f64,
    astern_n: f64,
    across_n: f64,
}

/// The ships that pass vessels at rest. For each vessel, only the nearest passing ship is kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Passages {
    now: Vec<Passage>,
    announced: Vec<Announced>,
    largest: Vec<Largest>,
    /// Texts for the log about the passages that ended in the last step.
    ended: Vec<String>,
    /// For each line that parted, the text of how it parted.
    parted: Vec<(usize, String)>,
}

impl Passages {
    /// Updates all passages after a step, in which the forces `flow` of passing ships acted on the vessels.
    pub(super) fn note(
        &mut self,
        simulation: &Simulation,
        info: &Info,
        flow: &[Force],
        events: &[WorldEvent],
    ) {
        self.now.clear();
        self.announced.clear();
        for (vessel, of) in info.vessels.iter().enumerate() {
            let (state, is_tug) = (&simulation.states()[of.body], of.is_tug);
            if is_tug || state.velocity_mps.length() > AT_REST_MPS {
                continue;
            }
            let mut nearest: Option<Passage> = None;
            for (ship, setup) in simulation.setup().world.flow.passing.iter().enumerate() {
                let meeting = Meeting::of(simulation, (vessel, of.body), (ship, setup));
                let Some(meeting) = meeting else { continue };
                let passage = meeting.passage(flow.get(vessel).copied().unwrap_or_default());
                if let Some(passage) = passage {
                    if nearest.is_none_or(|other| passage.gap_m < other.gap_m) {
                        nearest = Some(passage);
                    }
                } else {
                    self.announced.extend(meeting.announced());
                }
            }
            self.now.extend(nearest);
        }
        self.note_largest(simulation);
        self.note_parted(simulation, events);
    }

    /// Updates the largest values of each passage. A passage that has ended becomes a text for the log.
    fn note_largest(&mut self, simulation: &Simulation) {
        let t_s = simulation.time_s();
        self.ended.clear();
        for largest in self.largest.iter_mut().filter(|largest| largest.ended_s.is_none()) {
            if !self.now.iter().any(|passage| passage.is_of(largest)) {
                largest.ended_s = Some(t_s);
                self.ended.push(largest.text(simulation));
            }
        }
        self.largest.retain(|largest| largest.ended_s.is_none_or(|at_s| t_s < at_s + LINGERS_S));
        for passage in &self.now {
            let goes_on =
                |largest: &&mut Largest| largest.ended_s.is_none() && passage.is_of(largest);
            match self.largest.iter_mut().find(goes_on) {
                Some(largest) => largest.raise(passage),
                None => {
                    let mut largest = Largest::none(passage);
                    largest.raise(passage);
                    self.largest.push(largest);
                }
            }
        }
    }

    /// Keeps the texts of how lines parted in the last step, and of which passing ship pushed the vessel.
    fn note_parted(&mut self, simulation: &Simulation, events: &[WorldEvent]) {
        for event in events.iter().filter(|event| event.kind == WorldEventKind::LineParted) {
            let (line, setup) =
                (&simulation.lines()[event.who], &simulation.setup().world.lines[event.who]);
            let Some(at_n) = line.load.parted_at_n else { continue };
            let breaking_n = setup.line.kind.break_load_n();
            let pushing = self.pushing(simulation, setup.ship);
            let text = format!(
                " at {:.0} kN (breaking load {:.0} kN){pushing}",
                at_n / 1e3,
                breaking_n / 1e3
            );
            self.parted.retain(|(parted, _)| *parted != event.who);
            self.parted.push((event.who, text));
        }
    }

    /// The text of how a line parted: its tension, and the ship that passed. The text is empty for a line that did not
    /// part.
    pub(super) fn why_parted(&self, line: usize) -> &str {
        let found = self.parted.iter().find(|(parted, _)| *parted == line);
        found.map_or("", |(_, text)| text)
    }

    /// Names the ship that passes a vessel, or has passed lately, and the force of her flow on the vessel. The text
    /// stands at the end of a sentence, after a comma. The text is empty if no ship passes or has passed lately.
    pub(super) fn pushing(&self, simulation: &Simulation, body: usize) -> String {
        let of_ship = |ship: usize| &*simulation.setup().world.flow.passing[ship].name;
        let passing = |passage: &&Passage| passage.body == body && !passage.is_past;
        if let Some(passage) = self.now.iter().find(passing) {
            return format!(
                ", as {} passes {:.0} m off at {:.1} kn and pushes {}",
                of_ship(passage.ship),
                passage.gap_m,
                passage.speed_mps / KNOT_MPS,
                pushes(passage.force)
            );
        }
        let Some(lately) = self.largest.iter().rev().find(|largest| largest.body == body) else {
            return String::new();
        };
        format!(
            ", as {} has passed {:.0} m off at {:.1} kn and pushed up to {:.0} kN ahead, {:.0} kN astern",
            of_ship(lately.ship),
            lately.least_gap_m,
            lately.fastest_mps / KNOT_MPS,
            lately.ahead_n / 1e3,
            lately.astern_n / 1e3
        )
    }

    /// The cautions for ships that pass and ships that are announced: vessel, ship and text of each.
    pub(super) fn cautions<'s>(
        &self,
        simulation: &'s Simulation,
    ) -> impl Iterator<Item = (&'s str, &'s str, String)> {
        let announced = self.announced.iter().map(move |of| {
            let [vessel, ship] = names(simulation, of.vessel, of.ship);
            let knots = of.speed_mps / KNOT_MPS;
            let text = format!(
                "Ship {ship} will pass {vessel} in {}, {:.0} m off at {knots:.1} kn",
                minutes(of.in_s),
                of.gap_m
            );
            (vessel, ship, text)
        });
        let now = self.now.iter().map(move |of| {
            let [vessel, ship] = names(simulation, of.vessel, of.ship);
            let knots = of.speed_mps / KNOT_MPS;
            let text = format!(
                "Ship {ship} passes {vessel} {:.0} m off at {knots:.1} kn and pushes her {}",
                of.gap_m,
                pushes(of.force)
            );
            (vessel, ship, text)
        });
        announced.chain(now)
    }

    /// Texts for the log about the passages that ended in the last step.
    pub(super) fn ended(&self) -> &[String] {
        &self.ended
    }

    /// The passages for pages.
    pub(super) fn messages(&self) -> Vec<PassageNow> {
        let message = |of: &Passage| PassageNow {
            vessel: of.vessel,
            ship: of.ship,
            gap_m: of.gap_m,
            between_m: of.between_m.map(pair),
            force_n: [of.force.surge_n, of.force.sway_n],
            yaw_nm: of.force.yaw_nm,
        };
        self.now.iter().map(message).collect()
    }
}

impl Passage {
    fn is_of(&self, largest: &Largest) -> bool {
        (self.vessel, self.ship) == (largest.vessel, largest.ship)
    }
}

impl Largest {
    fn none(of: &Passage) -> Largest {
        let Passage { vessel, body, ship, .. } = *of;
        Largest {
            vessel,
            body,
            ship,
            ended_s: None,
            least_gap_m: f64::INFINITY,
            fastest_mps: 0.0,
            ahead_n: 0.0,
            astern_n: 0.0,
            across_n: 0.0,
        }
    }

    fn raise(&mut self, by: &Passage) {
        self.least_gap_m = lesser(self.least_gap_m, by.gap_m);
        self.fastest_mps = greater(self.fastest_mps, by.speed_mps);
        self.ahead_n = greater(self.ahead_n, by.force.surge_n);
        self.astern_n = greater(self.astern_n, -by.force.surge_n);
        self.across_n = greater(self.across_n, by.force.sway_n.abs());
    }

    fn text(&self, simulation: &Simulation) -> String {
        let [vessel, ship] = names(simulation, self.vessel, self.ship);
        format!(
            "ship {ship} has passed {vessel}, {:.0} m off at the nearest, at {:.1} kn: {ship} pushed {vessel} \
             with up to {:.0} kN ahead, {:.0} kN astern and {:.0} kN across",
            self.least_gap_m,
            self.fastest_mps / KNOT_MPS,
            self.ahead_n / 1e3,
            self.astern_n / 1e3,
            self.across_n / 1e3
        )
    }
}

/// A vessel at rest and a moving ship, with what both need for the question whether the ship passes.
struct Meeting<'s> {
    vessel: usize,
    body: usize,
    ship: usize,
    setup: &'s PassingSetup,
    outline_m: &'s [Vec2],
    pose: Pose,
    ship_pose: Pose,
    ship_mps: Vec2,
    mean_length_m: f64,
}

impl Meeting<'_> {
    /// The result is `None` if the ship does not move, or is too small to matter.
    fn of<'s>(
        simulation: &'s Simulation,
        (vessel, body): (usize, usize),
        (ship, setup): (usize, &'s PassingSetup),
    ) -> Option<Meeting<'s>> {
        let all = simulation.setup();
        let hull = all.world.flow.hulls.get(vessel)?;
        let now = setup.track.at(simulation.time_s());
        let share = setup.hull.sections.volume_m3() / hull.sections.volume_m3();
        if now.velocity_mps.length() < PASSES_MPS || share < SMALLEST_SHARE {
            return None;
        }
        Some(Meeting {
            vessel,
            body,
            ship,
            setup,
            outline_m: all.bodies[body].outline.vertices(),
            pose: simulation.states()[body].pose(),
            ship_pose: now.pose,
            ship_mps: now.velocity_mps,
            mean_length_m: 0.5 * (hull.length_m + setup.hull.length_m),
        })
    }

    fn outlines_m(&self, ship_pose: Pose) -> [Vec<Vec2>; 2] {
        let [own, ship] = [(self.pose, self.outline_m), (ship_pose, &self.setup.outline_m)];
        [own, ship].map(|(pose, outline)| outline.iter().map(|&at| pose.apply(at)).collect())
    }

    /// The passage of the ship past the vessel; `None` if the ship is not near enough.
    fn passage(&self, force: Force) -> Option<Passage> {
        let from_m = self.ship_pose.position_m - self.pose.position_m;
        let apart_m = from_m.length();
        if apart_m > IN_REACH * self.mean_length_m {
            return None;
        }
        let [own, ship] = self.outlines_m(self.ship_pose);
        Some(Passage {
            vessel: self.vessel,
            body: self.body,
            ship: self.ship,
            gap_m: of_outlines_m(&own, &ship),
            between_m: nearest_points(&own, &ship),
            speed_mps: self.ship_mps.length(),
            is_past: apart_m > self.mean_length_m && from_m.dot(self.ship_mps) > 0.0,
            force,
        })
    }

    /// When the ship will be abreast of the vessel and at what distance, on a straight course at her present speed.
    fn announced(&self) -> Option<Announced> {
        let from_m = self.ship_pose.position_m - self.pose.position_m;
        let speed_mps = self.ship_mps.length();
        let in_s = -from_m.dot(self.ship_mps) / (speed_mps * speed_mps);
        if in_s <= 0.0 || in_s > ANNOUNCED_S {
            return None;
        }
        let position_m = self.ship_pose.position_m + self.ship_mps * in_s;
        let [own, ship] = self.outlines_m(Pose { position_m, ..self.ship_pose });
        let gap_m = of_outlines_m(&own, &ship);
        (gap_m < NEAR * self.mean_length_m).then_some(Announced {
            vessel: self.vessel,
            ship: self.ship,
            in_s,
            gap_m,
            speed_mps,
        })
    }
}

/// The names of a vessel and of the ship that passes her.
fn names(simulation: &Simulation, vessel: usize, ship: usize) -> [&str; 2] {
    let setup = simulation.setup();
    let body = setup.world.vessels[vessel].body;
    [&setup.bodies[body].name, &setup.world.flow.passing[ship].name]
}

/// A force in words: its components along and across the vessel.
fn pushes(force: Force) -> String {
    let along = if force.surge_n < 0.0 { "astern" } else { "ahead" };
    let across = if force.sway_n < 0.0 { "to port" } else { "to starboard" };
    format!(
        "{:.0} kN {along}, {:.0} kN {across}",
        force.surge_n.abs() / 1e3,
        force.sway_n.abs() / 1e3
    )
}

/// A time as text in minutes and seconds, rounded to ten seconds.
fn minutes(t_s: f64) -> String {
    // At most ANNOUNCED_S.
    let tens = libm::round(t_s / 10.0) as u32;
    match (tens / 6, 10 * (tens % 6)) {
        (0, seconds) => format!("{seconds} s"),
        (minutes, 0) => format!("{minutes} min"),
        (minutes, seconds) => format!("{minutes} min {seconds} s"),
    }
}
