//! A mooring line during a simulation: its length, tension and winch, step by step.

use fenderline_contact::number::{bounded, greater, lesser};

use super::catenary::{Cable, catenary};
use super::ends::{LineEnds, Span};
use super::error::MooringError;
use super::rope::Rope;
use super::sag::sagging_tension_n;
use super::setup::{InboardEnd, InitialLength, LineDetails, LineKind, LineSetup, Tail, check};
use super::winch::{ConstantTension, Winch, WinchOrder, WinchReport};
use crate::range::OutOfRange;

/// The state of a mooring line, as plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineState {
    /// Unstretched length of line outboard, tail included (m).
    pub length_m: f64,
    /// True if the mooring line has parted.
    pub parted: bool,
}

/// Forces of a mooring line in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineLoad {
    /// Tension of the line at the ship's end (N).
    pub tension_n: f64,
    /// Force of the line on the ship at her fairlead: north, east, up (N).
    pub on_ship_n: [f64; 3],
    /// Force of the line on the bollard, anchor or ship at the other end: north, east, up (N).
    pub on_shore_n: [f64; 3],
    /// Report of the line's winch in the step.
    pub winch: WinchReport,
    /// The tension at which the line parted in this step (N); `None` if it did not part.
    pub parted_at_n: Option<f64>,
}

/// The part of a mooring line that does not change in a run, after its checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    setup: LineSetup,
    /// Tensions at which the load curve of rope or tail has a corner, in rising order (N).
    corners_n: Vec<f64>,
    break_load_n: f64,
    /// Length of line outboard when the winch's drum is empty (m).
    longest_m: f64,
}

impl Line {
    /// Checks a mooring line and makes it fast between two points.
    ///
    /// # Errors
    /// Fails for a number out of range, a length below the distance between the ends, or a pretension that cannot be
    /// reached. The error of a line that is refused names the line.
    pub fn new(setup: LineSetup, ends: &LineEnds) -> Result<(Line, LineState), MooringError> {
        check(&setup, ends).map_err(|error| out_of_range(&setup, error))?;
        let corners_n = setup.kind.corners_n();
        let break_load_n = setup.kind.break_load_n();
        let mut line = Line { setup, corners_n, break_load_n, longest_m: 0.0 };
        let length_m = line.initial_length_m(ends)?;
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

    /// The smaller break load of rope and tail (N).
    #[must_use]
    pub fn break_load_n(&self) -> f64 {
        self.break_load_n
    }

    /// Takes one step of the line: carries out the winch order for `step_s`, then computes the forces for the present
    /// positions of the ends.
    ///
    /// The winch's brake renders until the tension is down to its setting, and does not take line back in. If the
    /// tension is still above the break load after the brake has rendered, the line parts for good.
    pub fn step(
        &self,
        state: &mut LineState,
        ends: &LineEnds,
        order: WinchOrder,
        step_s: f64,
    ) -> LineLoad {
        if state.parted {
            return LineLoad::default();
        }
        let winch = match &self.setup.inboard_end {
            InboardEnd::Winch(winch) => self.run_winch(winch, state, ends, order, step_s),
            InboardEnd::Bitts => {
                WinchReport { no_winch: order != WinchOrder::Hold, ..WinchReport::default() }
            }
        };
        let load = LineLoad { winch, ..self.load(state.length_m, ends) };
        let greatest_n = greatest(&load);
        if greatest_n > self.break_load_n {
            state.parted = true;
            return LineLoad { winch, parted_at_n: Some(greatest_n), ..LineLoad::default() };
        }
        load
    }

    /// Carries out a winch order, which changes the length of line outboard.
    fn run_winch(
        &self,
        winch: &Winch,
        state: &mut LineState,
        ends: &LineEnds,
        order: WinchOrder,
        step_s: f64,
    ) -> WinchReport {
        let mut report = WinchReport::default();
        if order == WinchOrder::Hold
            && let Some(automatic) = &winch.constant_tension
        {
            self.hold_tension(automatic, state, ends, step_s);
        }
        let wanted_m = state.length_m + winch.ordered_m(order, step_s, &mut report);
        if wanted_m < state.length_m {
            let shortest_m = match self.length_for(winch.stall_n, ends) {
                Some(stalled_m) => greater(stalled_m, self.setup.kind.shortest_m()),
                None => state.length_m,
            };
            report.stalled = wanted_m < shortest_m;
            state.length_m = lesser(greater(wanted_m, shortest_m), state.length_m);
        } else {
            state.length_m = lesser(wanted_m, self.longest_m);
        }
        if self.load(state.length_m, ends).tension_n > winch.render_n {
            let rendered = self.length_for(winch.render_n, ends);
            let length_m =
                bounded(rendered.unwrap_or(self.longest_m), state.length_m, self.longest_m);
            report.rendered_m = length_m - state.length_m;
            state.length_m = length_m;
        }
        report.drum_empty = winch.reserve_m > 0.0 && state.length_m >= self.longest_m;
        report
    }

    /// Heaves or pays out a line on a constant-tension winch towards the band of tension, as fast as the winch can.
    fn hold_tension(
        &self,
        automatic: &ConstantTension,
        state: &mut LineState,
        ends: &LineEnds,
        step_s: f64,
    ) {
        let tension_n = self.load(state.length_m, ends).tension_n;
        let [low_n, high_n] = automatic.edges_n();
        if tension_n > high_n {
            let most_m = lesser(state.length_m + automatic.pay_out_mps * step_s, self.longest_m);
            let wanted_m = self.length_for(high_n, ends).unwrap_or(most_m);
            state.length_m = bounded(wanted_m, state.length_m, greater(most_m, state.length_m));
        } else if tension_n < low_n {
            let least_m = greater(
                state.length_m - automatic.heave_mps * step_s,
                self.setup.kind.shortest_m(),
            );
            let wanted_m = self.length_for(low_n, ends).unwrap_or(state.length_m);
            state.length_m = bounded(wanted_m, lesser(least_m, state.length_m), state.length_m);
        }
    }

    /// Length of line outboard at the start (m).
    fn initial_length_m(&self, ends: &LineEnds) -> Result<f64, MooringError> {
        let line = || self.setup.name.clone();
        match self.setup.initial_length {
            InitialLength::Outboard(length_m) => {
                let span_m = Span::of(ends).distance_m;
                if length_m < span_m || length_m < self.setup.kind.shortest_m() {
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
                if tension_n > held_n || length_m < self.setup.kind.shortest_m() {
                    return Err(error());
                }
                Ok(length_m)
            }
        }
    }

    /// Forces of the line for a length outboard and the positions of its ends.
    fn load(&self, length_m: f64, ends: &LineEnds) -> LineLoad {
        let span = Span::of(ends);
        match &self.setup.kind {
            LineKind::Light { main, tail, details } => {
                let rope = LightRope { main, tail: tail.as_ref(), details, length_m };
                let tension_n = self.light_tension_n(&rope, &span);
                if details.weight_npm > 0.0 {
                    return rope.sagging_load(tension_n, &span);
                }
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

    /// The tension at which rope and tail together span the distance between the ends (N). The computed tension is
    /// exact, because the stretch is a piecewise linear function of the tension.
    fn light_tension_n(&self, rope: &LightRope<'_>, span: &Span) -> f64 {
        if span.distance_m <= rope.length_m {
            return 0.0;
        }
        let reach_m = |tension_n: f64| rope.reach_m(tension_n);
        let last = self.corners_n.len() - 1;
        let upper = (1..last).find(|&k| reach_m(self.corners_n[k]) >= span.distance_m);
        let upper = upper.unwrap_or(last);
        let (low_n, high_n) = (self.corners_n[upper - 1], self.corners_n[upper]);
        let (low_m, high_m) = (reach_m(low_n), reach_m(high_n));
        low_n + (high_n - low_n) * (span.distance_m - low_m) / (high_m - low_m)
    }

    /// Finds the unstretched length of line outboard that gives a tension at the ship's end, on the taut side. The
    /// length is that of the tail alone if the tail is long enough to reach. Returns `None` if the weight of a cable
    /// gives more tension at every length.
    fn length_for(&self, tension_n: f64, ends: &LineEnds) -> Option<f64> {
        let span = Span::of(ends);
        match &self.setup.kind {
            LineKind::Light { main, tail, details } => {
                let (tail_m, tail_reach_m) = tail.as_ref().map_or((0.0, 0.0), |t| {
                    (t.length_m, t.length_m * (1.0 + strain(&t.rope, tension_n)))
                });
                let rest_m =
                    span.distance_m - tail_reach_m - stretch_on_deck_m(main, details, tension_n);
                let main_m = rest_m / (1.0 + strain(main, tension_n));
                let taut_m = greater(main_m, 0.0) + tail_m;
                if details.weight_npm > 0.0 {
                    return self.heavy_length_m(tension_n, taut_m, ends);
                }
                Some(taut_m)
            }
            LineKind::Heavy { axial_stiffness_n, .. } => {
                // At this length a straight cable without weight has the wanted tension; the real cable has more.
                let taut_m = span.distance_m / (1.0 + tension_n / axial_stiffness_n);
                self.heavy_length_m(tension_n, taut_m, ends)
            }
        }
    }

    /// Finds the length of a cable, or of a rope with weight, for a tension. The search lengthens a taut cable until
    /// the tension falls below the wanted tension, then bisects.
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
                // The tension is past its minimum: the weight alone gives more than the wanted tension.
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

/// A mooring rope with its length outboard.
struct LightRope<'l> {
    main: &'l Rope,
    tail: Option<&'l Tail>,
    details: &'l LineDetails,
    /// Unstretched length of the rope outboard, tail included (m).
    length_m: f64,
}

impl LightRope<'_> {
    /// Length of the rope outboard when stretched by a tension (m), with the stretch of the rope on deck added.
    fn reach_m(&self, tension_n: f64) -> f64 {
        let tail_m = self.tail.map_or(0.0, |tail| tail.length_m);
        let main_m = (self.length_m - tail_m) * (1.0 + strain(self.main, tension_n));
        let of_tail = |t: &Tail| t.length_m * (1.0 + strain(&t.rope, tension_n));
        main_m
            + self.tail.map_or(0.0, of_tail)
            + stretch_on_deck_m(self.main, self.details, tension_n)
    }

    /// Forces at the two ends of a rope that sags by its weight. `least_n` is the tension that the rope would have
    /// without weight.
    fn sagging_load(&self, least_n: f64, span: &Span) -> LineLoad {
        let weight_n = self.details.weight_npm * self.length_m;
        let spans_m = [span.distance_m, span.horizontal_m];
        let chord_n = sagging_tension_n(|n| self.reach_m(n), weight_n, spans_m, least_n);
        let [n, e, up] = span.towards_shore.map(|share| share * chord_n);
        let on_ship_n = [n, e, up - 0.5 * weight_n];
        LineLoad {
            tension_n: libm::hypot(libm::hypot(n, e), on_ship_n[2]),
            on_ship_n,
            on_shore_n: [-n, -e, -up - 0.5 * weight_n],
            ..LineLoad::default()
        }
    }
}

/// Stretch of the rope on deck (m) at a given tension outboard.
fn stretch_on_deck_m(main: &Rope, details: &LineDetails, tension_n: f64) -> f64 {
    details.on_deck.map_or(0.0, |deck| deck.length_m * strain(main, deck.share * tension_n))
}

/// Forces of a cable.
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

/// The larger of the tensions at the line's two ends (N).
fn greatest(load: &LineLoad) -> f64 {
    let [n, e, u] = load.on_shore_n;
    greater(load.tension_n, libm::hypot(libm::hypot(n, e), u))
}

/// Strain of a rope at a tension.
fn strain(rope: &Rope, tension_n: f64) -> f64 {
    rope.curve.strain(tension_n / rope.break_load_n)
}

fn out_of_range(setup: &LineSetup, error: OutOfRange) -> MooringError {
    MooringError::OutOfRange { line: setup.name.clone(), error }
}
