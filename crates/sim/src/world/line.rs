//! Mooring lines of a simulation: their ends on bodies, and when they are made fast.

use fenderline_contact::{BodyState, Vec2, Wrench, vec2};

use super::event::{WorldEvent, WorldEventKind};
use super::shore::Shore;
use crate::environment::Tide;
use crate::mooring::{Line, LineEnds, LineLoad, LineSetup, LineState, WinchOrder};

/// A mooring line of a set-up.
#[derive(Clone, Debug, PartialEq)]
pub struct MooringSetup {
    /// The line itself.
    pub line: LineSetup,
    /// Index of the body that has the winch or the bitts.
    pub ship: usize,
    /// Fairlead in that body's frame (m).
    pub fairlead_m: Vec2,
    /// Height of the fairlead above the still water (m); above datum where that body is fixed.
    pub fairlead_above_water_m: f64,
    /// The other end.
    pub end: LineEnd,
    /// When it is made fast (s).
    pub from_s: f64,
}

/// The far end of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineEnd {
    /// A bollard or an anchor: north, east and above datum (m).
    Fixed([f64; 3]),
    /// A point on another body, which may be a quay.
    OnBody {
        /// Index into [`crate::Setup::bodies`].
        body: usize,
        /// Position in the body's frame (m).
        at_m: Vec2,
        /// Height above the still water (m); above datum where the body is fixed.
        above_water_m: f64,
    },
}

/// The state of a line: plain data.
#[derive(Clone, Debug, PartialEq)]
pub struct Mooring {
    /// The line, once it is made fast.
    pub line: Option<(Line, LineState)>,
    /// The order to its winch.
    pub order: WinchOrder,
    /// Its forces in the last step.
    pub load: LineLoad,
    /// It was let go, or could not be made fast.
    pub gone: bool,
    rendering: bool,
}

impl Mooring {
    /// Becomes a copy of another, without allocation where both are of one line that was made fast once.
    pub(crate) fn copy_from(&mut self, other: &Mooring) {
        let mut line = self.line.take();
        match (&mut line, &other.line) {
            (Some((own, state)), Some((line, now))) if own == line => *state = *now,
            _ => line.clone_from(&other.line),
        }
        *self = Mooring { line, ..*other };
    }

    pub(crate) fn new() -> Mooring {
        Mooring {
            line: None,
            order: WinchOrder::Hold,
            load: LineLoad::default(),
            gone: false,
            rendering: false,
        }
    }

    /// Lets the line go.
    pub(crate) fn let_go(&mut self) {
        (self.line, self.gone, self.load) = (None, true, LineLoad::default());
    }

    /// Makes the line fast at its time, moves the winch, and adds its forces to the bodies at both ends.
    pub(crate) fn step(
        &mut self,
        index: usize,
        setup: &MooringSetup,
        (states, shore): (&[BodyState], Shore<'_>),
        (t_s, step_s): (f64, f64),
        loads: &mut [Wrench],
        events: &mut Vec<WorldEvent>,
    ) {
        if self.gone || t_s + step_s <= setup.from_s {
            return;
        }
        let ends = setup.ends(states, shore);
        if self.line.is_none() {
            match Line::new(setup.line.clone(), &ends) {
                Ok(made) => self.line = Some(made),
                Err(_) => {
                    self.gone = true;
                    events.push(WorldEvent { who: index, kind: WorldEventKind::LineNotMadeFast });
                    return;
                }
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
        for (body, at_m, force_n) in setup.ends_on(self) {
            let arm_m = states[body].pose().rotation.apply(at_m);
            loads[body].force_n += force_n;
            loads[body].moment_nm += arm_m.cross(force_n);
        }
    }
}

impl MooringSetup {
    /// The bodies at both ends, with position in the body's frame (m) and force on the body in the last step (N).
    pub(crate) fn ends_on(&self, mooring: &Mooring) -> impl Iterator<Item = (usize, Vec2, Vec2)> {
        let LineLoad { on_ship_n, on_shore_n, .. } = mooring.load;
        let flat = |force_n: [f64; 3]| vec2(force_n[0], force_n[1]);
        let far = match self.end {
            LineEnd::OnBody { body, at_m, .. } => Some((body, at_m, flat(on_shore_n))),
            LineEnd::Fixed(_) => None,
        };
        core::iter::once((self.ship, self.fairlead_m, flat(on_ship_n))).chain(far)
    }

    /// Positions of both ends. Heave and roll are neglected: they are small compared with the length of a line.
    fn ends(&self, states: &[BodyState], shore: Shore<'_>) -> LineEnds {
        let at = |body: usize, at_m: Vec2, above_m: f64| {
            let place = states[body].pose().apply(at_m);
            [place.x, place.y, shore.above_water_m(body, above_m)]
        };
        LineEnds {
            ship_m: at(self.ship, self.fairlead_m, self.fairlead_above_water_m),
            shore_m: match self.end {
                LineEnd::Fixed([north, east, up]) => [north, east, up - shore.level_m],
                LineEnd::OnBody { body, at_m, above_water_m } => at(body, at_m, above_water_m),
            },
        }
    }

    /// Checks that the line can be made fast at the start of a run.
    ///
    /// # Errors
    /// Why it cannot, with the name of the line.
    ///
    /// # Panics
    /// If it refers to bodies that do not exist.
    pub fn check_at_start(
        &self,
        bodies: &[crate::BodySetup],
        tide: &Tide,
    ) -> Result<(), crate::mooring::MooringError> {
        let states: Vec<BodyState> = bodies.iter().map(crate::rigid_body::initial_state).collect();
        let fixed: Vec<bool> = bodies.iter().map(crate::BodySetup::is_fixed).collect();
        let shore = Shore { fixed: &fixed, level_m: tide.level_m(0.0) };
        Line::new(self.line.clone(), &self.ends(&states, shore)).map(|_| ())
    }
}
