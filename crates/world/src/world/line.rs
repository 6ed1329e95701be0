//! Mooring lines of a simulation: the ends of the lines on bodies, and the times at which lines are made fast.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Vec2, Wrench, vec2};

use super::afloat::Lever;
use super::bollard::BollardSetup;
use super::event::{WorldEvent, WorldEventKind};
use super::line_end::LineEnd;
use super::shore::Shore;
use crate::rigid_body::initial_state;
use crate::setup::body::BodySetup;
use fenderline_ship::mooring::{
    InboardEnd, InitialLength, Line, LineEnds, LineLoad, LineSetup, LineState, WinchOrder,
};
use fenderline_ship::step_time::StepTime;

/// Slack that a line on a winch gets when line handlers make it fast at a bollard: a share of the distance, plus a
/// length (m).
const SLACK: (f64, f64) = (0.02, 1.0);
/// Rate at which a crew hauls in a line on bitts by hand (m/s); our assumption.
const BY_HAND_MPS: f64 = 0.5;

/// A mooring line of a set-up.
#[derive(Clone, Debug, PartialEq)]
pub struct MooringSetup {
    /// The line.
    pub line: LineSetup,
    /// Index of the body that has the winch or the bitts.
    pub ship: usize,
    /// Fairlead in the frame of the body `ship` (m).
    pub fairlead_m: Vec2,
    /// Height of the fairlead above the still water (m), or above datum if the body is fixed.
    pub fairlead_above_water_m: f64,
    /// The end at which the line is made fast without an order; `None` if the line is on board until an order sends it
    /// to a bollard.
    pub end: Option<LineEnd>,
    /// Time at which the line is made fast without an order (s).
    pub from_s: f64,
    /// Length of the rope, for a line that an order sends to a bollard (m).
    pub rope_m: f64,
}

/// The state of a line, as plain data.
#[derive(Clone, Debug, PartialEq)]
pub struct Mooring {
    /// The line and its state; `None` until the line is first made fast.
    pub line: Option<(Line, LineState)>,
    /// The order to the winch of the line.
    pub order: WinchOrder,
    /// Forces of the line in the last step.
    pub load: LineLoad,
    /// True if the line is on board: nobody has sent it yet, it was let go, or it could not be made fast.
    pub aboard: bool,
    /// The bollard at which the line is fast or to which an order sent it, as an index in
    /// [`crate::world::WorldSetup::bollards`]. With `None`, the line has the end that the set-up gives.
    pub bollard: Option<usize>,
    /// The way of the line to the bollard; `None` if the line is not under way.
    pub sent: Option<Sent>,
    /// Time at which the line is completely hauled in after it was let go (s).
    hauled_in_s: f64,
    rendering: bool,
    /// Places where the line pulled at the bodies at its two ends in the last step.
    levers: [Lever; 2],
}

/// A line on its way to a bollard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent {
    /// Time at which an order sent the line (s).
    pub since_s: f64,
    /// Time at which the line will be fast (s); `None` while the line waits for line handlers.
    pub fast_at_s: Option<f64>,
}

/// The mooring lines of a set-up, with their present states.
#[derive(Clone, Copy, Debug)]
pub struct MooringLines<'a> {
    /// The set-ups of the lines.
    pub setups: &'a [MooringSetup],
    /// The lines now.
    pub now: &'a [Mooring],
}

/// The bodies and bollards at the ends of mooring lines in a step.
#[derive(Clone, Copy, Debug)]
pub struct LineWorld<'a> {
    /// The bollards of the set-up.
    pub bollards: &'a [BollardSetup],
    /// The states of all bodies at the start of the step.
    pub states: &'a [BodyState],
    /// The states of all bodies with which the lines pull. The states of bodies with hydrodynamic data are later than
    /// the start of the step.
    pub met: &'a [BodyState],
    /// Which bodies stand on the ground, and the level of the water.
    pub shore: Shore<'a>,
}

impl Mooring {
    /// Becomes a copy of another state. The copy does not allocate if both are states of the same line, and the line
    /// was made fast before.
    pub fn copy_from(&mut self, other: &Mooring) {
        let mut line = self.line.take();
        match (&mut line, &other.line) {
            (Some((own, state)), Some((line, now))) if own == line => *state = *now,
            _ => line.clone_from(&other.line),
        }
        *self = Mooring { line, ..*other };
    }

    /// The state of the line at the start of a run.
    pub fn new(setup: &MooringSetup) -> Mooring {
        Mooring {
            line: None,
            order: WinchOrder::Hold,
            load: LineLoad::default(),
            aboard: setup.end.is_none(),
            bollard: None,
            sent: None,
            hauled_in_s: 0.0,
            rendering: false,
            levers: [Lever::default(); 2],
        }
    }

    /// True if the line has parted.
    #[must_use]
    pub fn has_parted(&self) -> bool {
        self.line.as_ref().is_some_and(|(_, state)| state.parted)
    }

    /// The place of the line's far end, now or when the line is made fast; `None` while the line is on board.
    #[must_use]
    pub fn end(&self, setup: &MooringSetup, bollards: &[BollardSetup]) -> Option<LineEnd> {
        match self.bollard {
            Some(bollard) => Some(bollards[bollard].end()),
            None if self.aboard => None,
            None => setup.end,
        }
    }

    /// Lets the line go at time `t_s`. The crew then hauls the line in.
    pub fn let_go(&mut self, setup: &MooringSetup, t_s: f64) {
        let outboard_m = self.line.as_ref().map_or(0.0, |(_, state)| state.length_m);
        let rate_mps = match setup.line.inboard_end {
            InboardEnd::Winch(winch) => greater(winch.rate_mps, 0.01),
            InboardEnd::Bitts => BY_HAND_MPS,
        };
        *self = Mooring {
            aboard: true,
            hauled_in_s: t_s + outboard_m / rate_mps,
            ..Mooring::new(setup)
        };
    }

    /// Sends the line to a bollard.
    pub fn send(&mut self, bollard: usize, t_s: f64) {
        self.aboard = false;
        self.order = WinchOrder::Hold;
        self.bollard = Some(bollard);
        self.sent = Some(Sent { since_s: t_s, fast_at_s: None });
    }

    /// True if line handlers can take the line: an order has sent the line, and the crew has hauled in the part that
    /// was outboard before.
    pub fn waits_for_handlers(&self, t_s: f64) -> bool {
        self.sent.is_some_and(|sent| sent.fast_at_s.is_none()) && t_s >= self.hauled_in_s
    }

    /// Makes the line fast at its time, moves the winch, and adds the line's forces to the bodies at both ends. The
    /// line pulls between the places of the bodies in [`LineWorld::met`].
    pub fn step(
        &mut self,
        index: usize,
        setup: &MooringSetup,
        LineWorld { bollards, states, met, shore }: LineWorld<'_>,
        StepTime { t_s, step_s }: StepTime,
        loads: &mut [Wrench],
        events: &mut Vec<WorldEvent>,
    ) {
        if self.aboard || (self.bollard.is_none() && t_s + step_s <= setup.from_s) {
            return;
        }
        let Some(end) = self.end(setup, bollards) else { return };
        let ends = setup.ends(end, met, shore);
        if let Some(sent) = self.sent {
            if sent.fast_at_s.is_none_or(|at_s| t_s + step_s <= at_s) {
                return;
            }
            self.sent = None;
        }
        if self.line.is_none() {
            let made = match self.bollard {
                Some(_) => setup.at_bollard(&ends).map(|line| Line::new(line, &ends)),
                None => Some(Line::new(setup.line.clone(), &ends)),
            };
            let Some(Ok(made)) = made else {
                (self.aboard, self.bollard) = (true, None);
                events.push(WorldEvent { who: index, kind: WorldEventKind::LineNotMadeFast });
                return;
            };
            self.line = Some(made);
            if self.bollard.is_some() {
                events.push(WorldEvent { who: index, kind: WorldEventKind::LineMadeFast });
            }
        }
        let Some((line, state)) = &mut self.line else { return };
        let was_parted = state.parted;
        self.load = line.step(state, &ends, self.order, step_s);
        if state.parted && !was_parted {
            events.push(WorldEvent { who: index, kind: WorldEventKind::LineParted });
        }
        let renders = self.load.winch.rendered_m > 0.0;
        if renders && !self.rendering {
            events.push(WorldEvent { who: index, kind: WorldEventKind::LineRenders });
        }
        self.rendering = renders;
        self.levers = setup.levers(end, shore);
        for (body, lever, [north_n, east_n, _]) in setup.pulls(self, bollards) {
            let force_n = vec2(north_n, east_n);
            let arm_m = states[body].pose().rotation.apply(lever.at_m);
            loads[body].force_n += force_n;
            loads[body].moment_nm += arm_m.cross(force_n);
        }
    }
}

impl MooringSetup {
    /// The bodies at both ends of the line. Each has the lever of the line's force, and the line's force on the body in
    /// the last step: north, east, up (N).
    pub fn pulls(
        &self,
        mooring: &Mooring,
        bollards: &[BollardSetup],
    ) -> impl Iterator<Item = (usize, Lever, [f64; 3])> {
        let LineLoad { on_ship_n, on_shore_n, .. } = mooring.load;
        let [near, far] = mooring.levers;
        let far = match mooring.end(self, bollards) {
            Some(LineEnd::OnBody { body, .. }) => Some((body, far, on_shore_n)),
            Some(LineEnd::Fixed(_)) | None => None,
        };
        core::iter::once((self.ship, near, on_ship_n)).chain(far)
    }

    /// The levers of both ends of the line, for the present attitude of the bodies. Nothing uses the lever of a fixed
    /// end.
    fn levers(&self, end: LineEnd, shore: Shore<'_>) -> [Lever; 2] {
        let near = shore.lever(self.ship, self.fairlead_m, self.fairlead_above_water_m);
        let far = match end {
            LineEnd::Fixed(_) => Lever::default(),
            LineEnd::OnBody { body, at_m, above_water_m } => shore.lever(body, at_m, above_water_m),
        };
        [near, far]
    }

    /// Positions of both ends. The places include heave, roll and pitch of vessels with hydrodynamic data. Other bodies
    /// count as upright.
    pub fn ends(&self, end: LineEnd, states: &[BodyState], shore: Shore<'_>) -> LineEnds {
        let at = |body: usize, at_m: Vec2, above_m: f64| {
            let (at_m, above_m) = shore.place(body, at_m, above_m);
            let place = states[body].pose().apply(at_m);
            [place.x, place.y, above_m]
        };
        LineEnds {
            ship_m: at(self.ship, self.fairlead_m, self.fairlead_above_water_m),
            shore_m: match end {
                LineEnd::Fixed([north, east, up]) => [north, east, up - shore.level_m],
                LineEnd::OnBody { body, at_m, above_water_m } => at(body, at_m, above_water_m),
            },
        }
    }

    /// The line as it is when line handlers make it fast at a bollard: with a little slack on a winch, hand-tight on
    /// bitts. `None` if the rope is too short.
    fn at_bollard(&self, ends: &LineEnds) -> Option<LineSetup> {
        let span_m = ends.distance_m();
        let mut line = self.line.clone();
        let length_m = match &mut line.inboard_end {
            InboardEnd::Winch(winch) => {
                let length_m = span_m * (1.0 + SLACK.0) + SLACK.1;
                winch.reserve_m = greater(self.rope_m - length_m, 0.0);
                length_m
            }
            InboardEnd::Bitts => span_m,
        };
        line.initial_length = InitialLength::Outboard(greater(length_m, line.kind.shortest_m()));
        (length_m <= self.rope_m).then_some(line)
    }

    /// The greatest distance of a bollard that the rope reaches (m).
    #[must_use]
    pub fn reach_m(&self) -> f64 {
        match self.line.inboard_end {
            InboardEnd::Winch(_) => (self.rope_m - SLACK.1) / (1.0 + SLACK.0),
            InboardEnd::Bitts => self.rope_m,
        }
    }

    /// Checks that the line can be made fast at the start of a run. A line on board needs no such check.
    ///
    /// # Errors
    /// Returns the reason why the line cannot be made fast, with the name of the line.
    ///
    /// # Panics
    /// Panics if the line refers to bodies that do not exist.
    pub fn check_at_start(
        &self,
        bodies: &[BodySetup],
        level_m: f64,
    ) -> Result<(), fenderline_ship::mooring::MooringError> {
        let states: Vec<BodyState> = bodies.iter().map(initial_state).collect();
        let fixed: Vec<bool> = bodies.iter().map(BodySetup::is_fixed).collect();
        let shore = Shore { fixed: &fixed, level_m, afloat: &[] };
        let Some(end) = self.end else { return self.line.check_alone() };
        Line::new(self.line.clone(), &self.ends(end, &states, shore)).map(|_| ())
    }
}
