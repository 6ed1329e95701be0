//! A mooring line: rope or cable, its two ends, and what holds it on board.

use fenderline_contact::number::{bounded, greater, lesser};

use super::catenary::{Cable, catenary};
use super::error::MooringError;
use super::rope::Rope;
use super::winch::{Winch, WinchOrder, WinchReport};
use crate::range::{OutOfRange, within};

/// A line before it is made fast.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSetup {
    /// Name, for messages.
    pub name: String,
    /// What it is made of.
    pub kind: LineKind,
    /// What holds it on board.
    pub inboard_end: InboardEnd,
    /// How much of it is outboard at the start.
    pub initial_length: InitialLength,
}

/// What a line is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum LineKind {
    /// A harbour line: straight from end to end, its weight neglected.
    Light {
        /// The rope on the winch.
        main: Rope,
        /// A softer tail in series at the shore end.
        tail: Option<Tail>,
    },
    /// A cable that hangs in a catenary.
    Heavy {
        /// Weight per unstretched length in water (N/m).
        weight_npm: f64,
        /// EA (N).
        axial_stiffness_n: f64,
        /// Break load (N).
        break_load_n: f64,
        /// The lower end lies on a level bottom: an anchor cable.
        on_bottom: bool,
    },
}

/// A tail in series with a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Tail {
    /// Its rope.
    pub rope: Rope,
    /// Its unstretched length (m).
    pub length_m: f64,
}

/// What holds a line on board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InboardEnd {
    /// Turned up on bitts: it holds until the line parts.
    Bitts,
    /// A winch.
    Winch(Winch),
}

/// How much of a line is outboard at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InitialLength {
    /// Unstretched length outboard, the tail included (m); not less than the distance of the ends.
    Outboard(f64),
    /// As much as gives this tension at the ship's end (N).
    FromPretension(f64),
}

/// Where the two ends of a line are: north, east, up (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineEnds {
    /// The ship's fairlead.
    pub ship_m: [f64; 3],
    /// Bollard, anchor, or another ship's bitts.
    pub shore_m: [f64; 3],
}

/// What changes of a line: plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineState {
    /// Unstretched length outboard, the tail included (m).
    pub length_m: f64,
    /// It has parted.
    pub parted: bool,
}

/// A line's forces in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineLoad {
    /// Tension at the ship's end (N).
    pub tension_n: f64,
    /// Force on the ship at her fairlead: north, east, up (N).
    pub on_ship_n: [f64; 3],
    /// Force on what the other end is fast to (N).
    pub on_shore_n: [f64; 3],
    /// What the winch did.
    pub winch: WinchReport,
    /// The tension at which the line parted in this step (N).
    pub parted_at_n: Option<f64>,
}

/// A checked line; its constant part.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    setup: LineSetup,
    /// Tensions at which a light line's rope or tail has a corner, increasing (N).
    corners_n: Vec<f64>,
    break_load_n: f64,
    /// Outboard with an empty drum (m).
    longest_m: f64,
}

impl Line {
    /// Checks a line and makes it fast between two points.
    ///
    /// # Errors
    /// A number that no line has, a length below the distance of the ends, a pretension that cannot be;
    /// each names the line.
    pub fn new(setup: LineSetup, ends: &LineEnds) -> Result<(Line, LineState), MooringError> {
        check(&setup, ends).map_err(|error| out_of_range(&setup, error))?;
        let corners_n = corners(&setup.kind);
        let break_load_n = break_load(&setup.kind);
        let mut line = Line { setup, corners_n, break_load_n, longest_m: 0.0 };
        let length_m = line.fitted_length_m(ends)?;
        let reserve_m = match line.setup.inboard_end {
            InboardEnd::Winch(winch) => winch.reserve_m,
            InboardEnd::Bitts => 0.0,
        };
        line.longest_m = length_m + reserve_m;
        Ok((line, LineState { length_m, parted: false }))
    }

    /// The set-up.
    #[must_use]
    pub fn setup(&self) -> &LineSetup {
        &self.setup
    }

    /// Least break load of rope and tail (N).
    #[must_use]
    pub fn break_load_n(&self) -> f64 {
        self.break_load_n
    }

    /// Forces with the ends where they are, after the winch has done in `step_s` what it was told. The
    /// brake renders as much as brings the tension down to its setting, and takes nothing back; what then
    /// is above the break load parts, for good.
    pub fn step(
        &self,
        state: &mut LineState,
        ends: &LineEnds,
        order: WinchOrder,
        step_s: f64,
    ) -> LineLoad {
        let mut winch = WinchReport::default();
        if state.parted {
            return LineLoad::default();
        }
        match &self.setup.inboard_end {
            InboardEnd::Winch(of) => self.work_winch(of, state, ends, (order, step_s), &mut winch),
            InboardEnd::Bitts => winch.no_winch = order != WinchOrder::Hold,
        }
        let load = LineLoad { winch, ..self.load(state.length_m, ends) };
        let greatest_n = greatest(&load);
        if greatest_n > self.break_load_n {
            state.parted = true;
            return LineLoad { winch, parted_at_n: Some(greatest_n), ..LineLoad::default() };
        }
        load
    }

    fn work_winch(
        &self,
        winch: &Winch,
        state: &mut LineState,
        ends: &LineEnds,
        (order, step_s): (WinchOrder, f64),
        notes: &mut WinchReport,
    ) {
        let wanted_m = state.length_m + winch.ordered_m(order, step_s, notes);
        if wanted_m < state.length_m {
            let shortest_m = match self.length_for(winch.stall_n, ends) {
                Some(stalled_m) => greater(stalled_m, self.shortest_m()),
                None => state.length_m,
            };
            notes.stalled = wanted_m < shortest_m;
            state.length_m = lesser(greater(wanted_m, shortest_m), state.length_m);
        } else {
            state.length_m = lesser(wanted_m, self.longest_m);
        }
        if self.load(state.length_m, ends).tension_n > winch.render_n {
            let rendered = self.length_for(winch.render_n, ends);
            let length_m =
                bounded(rendered.unwrap_or(self.longest_m), state.length_m, self.longest_m);
            notes.rendered_m = length_m - state.length_m;
            state.length_m = length_m;
        }
        notes.drum_empty = winch.reserve_m > 0.0 && state.length_m >= self.longest_m;
    }

    /// The tail and one metre of rope.
    fn shortest_m(&self) -> f64 {
        1.0 + match &self.setup.kind {
            LineKind::Light { tail: Some(tail), .. } => tail.length_m,
            LineKind::Light { tail: None, .. } | LineKind::Heavy { .. } => 0.0,
        }
    }

    fn fitted_length_m(&self, ends: &LineEnds) -> Result<f64, MooringError> {
        let line = || self.setup.name.clone();
        match self.setup.initial_length {
            InitialLength::Outboard(length_m) => {
                let span_m = Span::of(ends).distance_m;
                if length_m < span_m || length_m < self.shortest_m() {
                    return Err(MooringError::TooShort { line: line(), length_m, span_m });
                }
                Ok(length_m)
            }
            InitialLength::FromPretension(tension_n) => {
                let error = || MooringError::Pretension { line: line(), tension_n };
                let held_n = match self.setup.inboard_end {
                    InboardEnd::Winch(winch) => lesser(winch.render_n, self.break_load_n),
                    InboardEnd::Bitts => self.break_load_n,
                };
                let length_m = self.length_for(tension_n, ends).ok_or_else(error)?;
                if tension_n > held_n || length_m < self.shortest_m() {
                    return Err(error());
                }
                Ok(length_m)
            }
        }
    }

    fn load(&self, length_m: f64, ends: &LineEnds) -> LineLoad {
        let span = Span::of(ends);
        match &self.setup.kind {
            LineKind::Light { main, tail } => {
                let tension_n = self.light_tension_n(main, tail.as_ref(), length_m, &span);
                let on_ship_n = span.towards_shore.map(|share| share * tension_n);
                let on_shore_n = on_ship_n.map(|part| -part);
                LineLoad { tension_n, on_ship_n, on_shore_n, ..LineLoad::default() }
            }
            LineKind::Heavy { weight_npm, axial_stiffness_n, on_bottom, .. } => {
                let (weight_npm, axial_stiffness_n) = (*weight_npm, *axial_stiffness_n);
                let cable = Cable { length_m, axial_stiffness_n, weight_npm };
                heavy_load(&cable, &span, *on_bottom)
            }
        }
    }

    /// The tension at which rope and tail together reach from end to end: exact, because the stretch over
    /// tension is made of straight pieces.
    fn light_tension_n(&self, main: &Rope, tail: Option<&Tail>, length_m: f64, span: &Span) -> f64 {
        if span.distance_m <= length_m {
            return 0.0;
        }
        let tail_m = tail.map_or(0.0, |tail| tail.length_m);
        let reach_m = |tension_n: f64| {
            let main_m = (length_m - tail_m) * (1.0 + strain(main, tension_n));
            main_m + tail.map_or(0.0, |t| t.length_m * (1.0 + strain(&t.rope, tension_n)))
        };
        let last = self.corners_n.len() - 1;
        let upper = (1..last).find(|&k| reach_m(self.corners_n[k]) >= span.distance_m);
        let upper = upper.unwrap_or(last);
        let (low_n, high_n) = (self.corners_n[upper - 1], self.corners_n[upper]);
        let (low_m, high_m) = (reach_m(low_n), reach_m(high_n));
        low_n + (high_n - low_n) * (span.distance_m - low_m) / (high_m - low_m)
    }

    /// Unstretched length outboard that gives a tension at the ship's end, on the taut side: the tail
    /// alone where that reaches already. `None` where a cable's own weight is more at any length.
    fn length_for(&self, tension_n: f64, ends: &LineEnds) -> Option<f64> {
        let span = Span::of(ends);
        match &self.setup.kind {
            LineKind::Light { main, tail } => {
                let (tail_m, tail_reach_m) = tail.as_ref().map_or((0.0, 0.0), |t| {
                    (t.length_m, t.length_m * (1.0 + strain(&t.rope, tension_n)))
                });
                let main_m = (span.distance_m - tail_reach_m) / (1.0 + strain(main, tension_n));
                Some(greater(main_m, 0.0) + tail_m)
            }
            LineKind::Heavy { axial_stiffness_n, .. } => {
                // At this length the straight cable, without weight, has the tension; with weight more.
                let taut_m = span.distance_m / (1.0 + tension_n / axial_stiffness_n);
                self.heavy_length_m(tension_n, taut_m, ends)
            }
        }
    }

    /// From taut to slacker until the tension is reached, then by bisection.
    fn heavy_length_m(&self, tension_n: f64, taut_m: f64, ends: &LineEnds) -> Option<f64> {
        let tension_at = |length_m: f64| self.load(length_m, ends).tension_n;
        let (mut tight_m, mut tight_n) = (taut_m, tension_at(taut_m));
        let mut slack_m = taut_m;
        let mut growth = 1e-5;
        while tight_n > tension_n {
            slack_m = tight_m * (1.0 + growth);
            let slack_n = tension_at(slack_m);
            if slack_n <= tension_n {
                break;
            }
            if slack_n >= tight_n {
                // Beyond the least tension: its own weight is more than asked for.
                return None;
            }
            (tight_m, tight_n) = (slack_m, slack_n);
            growth *= 2.0;
        }
        for _ in 0..60 {
            let middle_m = tight_m.midpoint(slack_m);
            if tension_at(middle_m) > tension_n {
                tight_m = middle_m;
            } else {
                slack_m = middle_m;
            }
        }
        Some(slack_m)
    }
}

/// Where one end is seen from the other.
struct Span {
    distance_m: f64,
    horizontal_m: f64,
    /// Height of the shore end above the ship's (m).
    up_m: f64,
    /// Unit vector from the ship's end to the shore's; zero where they are in one place.
    towards_shore: [f64; 3],
    /// The same in the horizontal.
    horizontally: [f64; 2],
}

impl Span {
    fn of(ends: &LineEnds) -> Span {
        let [n, e, u] = std::array::from_fn(|k| ends.shore_m[k] - ends.ship_m[k]);
        let horizontal_m = libm::hypot(n, e);
        let distance_m = libm::hypot(horizontal_m, u);
        let unit = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
        Span {
            distance_m,
            horizontal_m,
            up_m: u,
            towards_shore: [n, e, u].map(|part| unit(part, distance_m)),
            horizontally: [n, e].map(|part| unit(part, horizontal_m)),
        }
    }
}

fn heavy_load(cable: &Cable, span: &Span, on_bottom: bool) -> LineLoad {
    let c = catenary(cable, span.horizontal_m, span.up_m.abs(), on_bottom);
    let [n, e] = span.horizontally.map(|part| part * c.horizontal_n);
    let (ship_up_n, shore_up_n) = if span.up_m <= 0.0 {
        (-c.upper_vertical_n, c.lower_vertical_n)
    } else {
        (c.lower_vertical_n, -c.upper_vertical_n)
    };
    LineLoad {
        tension_n: libm::hypot(c.horizontal_n, ship_up_n),
        on_ship_n: [n, e, ship_up_n],
        on_shore_n: [-n, -e, shore_up_n],
        ..LineLoad::default()
    }
}

/// The greater tension of the two ends (N).
fn greatest(load: &LineLoad) -> f64 {
    let [n, e, u] = load.on_shore_n;
    greater(load.tension_n, libm::hypot(libm::hypot(n, e), u))
}

fn strain(rope: &Rope, tension_n: f64) -> f64 {
    rope.curve.strain(tension_n / rope.break_load_n)
}

fn break_load(kind: &LineKind) -> f64 {
    match kind {
        LineKind::Light { main, tail } => {
            lesser(tail.as_ref().map_or(f64::INFINITY, |t| t.rope.break_load_n), main.break_load_n)
        }
        LineKind::Heavy { break_load_n, .. } => *break_load_n,
    }
}

fn corners(kind: &LineKind) -> Vec<f64> {
    let LineKind::Light { main, tail } = kind else { return vec![] };
    let ropes = [Some(main), tail.as_ref().map(|tail| &tail.rope)];
    let of = |rope: &Rope| -> Vec<f64> {
        rope.curve.corners().map(|share| share * rope.break_load_n).collect()
    };
    let mut corners_n: Vec<f64> = ropes.into_iter().flatten().flat_map(of).collect();
    corners_n.sort_by(f64::total_cmp);
    corners_n.dedup();
    corners_n
}

fn out_of_range(setup: &LineSetup, error: OutOfRange) -> MooringError {
    MooringError::OutOfRange { line: setup.name.clone(), error }
}

fn check(setup: &LineSetup, ends: &LineEnds) -> Result<(), OutOfRange> {
    for place_m in ends.ship_m.into_iter().chain(ends.shore_m) {
        within("place of an end [m]", place_m, -1e8, 1e8)?;
    }
    let span_m = Span::of(ends).distance_m;
    within("distance of the ends [m]", span_m, 0.0, 1e5)?;
    match &setup.kind {
        LineKind::Light { main, tail } => {
            within("break load of the rope [N]", main.break_load_n, 1.0, 1e9)?;
            if let Some(tail) = tail {
                within("break load of the tail [N]", tail.rope.break_load_n, 1.0, 1e9)?;
                within("length of the tail [m]", tail.length_m, 0.01, 1000.0)?;
            }
        }
        LineKind::Heavy { weight_npm, axial_stiffness_n, break_load_n, .. } => {
            within("weight of the cable in water [N/m]", *weight_npm, 0.1, 1e6)?;
            within("axial stiffness of the cable [N]", *axial_stiffness_n, 1e3, 1e13)?;
            within("break load of the cable [N]", *break_load_n, 1.0, 1e10)?;
        }
    }
    match setup.initial_length {
        InitialLength::Outboard(length_m) => within("length of the line [m]", length_m, 0.0, 1e5)?,
        InitialLength::FromPretension(tension_n) => within("pretension [N]", tension_n, 0.0, 1e9)?,
    };
    match &setup.inboard_end {
        InboardEnd::Winch(winch) => winch.check(),
        InboardEnd::Bitts => Ok(()),
    }
}
