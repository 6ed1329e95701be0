//! The set-up of a mooring line.

use fenderline_contact::number::lesser;

use super::ends::{LineEnds, Span};
use super::error::MooringError;
use super::rope::{Rope, RopeCurve};
use super::winch::Winch;
use crate::range::{OutOfRange, within};

/// The set-up of a mooring line.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSetup {
    /// Name, used in messages.
    pub name: String,
    /// Type and material.
    pub kind: LineKind,
    /// The device that holds the inboard end of the line.
    pub inboard_end: InboardEnd,
    /// Length of line outboard at the start.
    pub initial_length: InitialLength,
}

/// Type and material of a mooring line.
#[derive(Clone, Debug, PartialEq)]
pub enum LineKind {
    /// A mooring rope: straight between its ends, apart from the sag by its weight if the weight is given.
    Light {
        /// The main rope, which is on the winch.
        main: Rope,
        /// A softer tail in series with the rope, at the shore end.
        tail: Option<Tail>,
        /// Further data of the rope, such as its weight and the rope on deck.
        details: LineDetails,
    },
    /// A heavy cable that hangs in a catenary.
    Heavy {
        /// Weight of the cable per unstretched length in water (N/m).
        weight_npm: f64,
        /// EA (N).
        axial_stiffness_n: f64,
        /// Break load (N).
        break_load_n: f64,
        /// True if the lower end of the cable lies on a level bottom, as for an anchor cable.
        on_bottom: bool,
    },
}

/// Further data of a rope, beside its load curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineDetails {
    /// The rope on deck, between winch or bitts and the chock.
    pub on_deck: Option<OnDeck>,
    /// Weight of rope and tail outboard per unstretched length (N/m); 0 neglects the weight.
    ///
    /// A rope with weight hangs in a flat parabola. The rope's stretched length S and the distance c of its ends, of
    /// which h is horizontal, satisfy S = c (1 + (W h/S)²/(24 T²)). In this equation W is the weight outboard, and T
    /// the tension along the chord, at the middle of the chord. Each end of the rope bears half of its weight. The
    /// error of the flat parabola is of the next order, about (W/T)⁴/1920 of the length.
    pub weight_npm: f64,
    /// Working load of the rope (N); `None` for the share of the break load by OCIMF's guideline MEG4.
    pub working_load_n: Option<f64>,
}

/// The rope on deck between winch or bitts and the chock.
///
/// The rope on deck stretches with the tension that reaches it over the chock: T e^(−μφ), by the capstan's equation for
/// a rope that is hauled outboard, as it is when the tension rises. When the tension falls, the rope on deck keeps a
/// higher tension. The hysteresis of the rope on deck is left out, so that the rope stays elastic. Brake and stall of a
/// winch are compared with the tension of the line outboard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnDeck {
    /// Unstretched length of the rope on deck (m).
    pub length_m: f64,
    /// Share of the tension that reaches the rope on deck, e^(−μφ): above 0, at most 1.
    pub share: f64,
}

impl OnDeck {
    /// Makes the rope on deck with a length (m) behind a chock. The rope bends round the chock by an angle φ (rad),
    /// with a coefficient of friction μ.
    #[must_use]
    pub fn behind_chock(length_m: f64, friction: f64, wrap_rad: f64) -> OnDeck {
        OnDeck { length_m, share: libm::exp(-friction * wrap_rad) }
    }
}

/// A tail in series with a mooring line.
#[derive(Clone, Debug, PartialEq)]
pub struct Tail {
    /// Rope of the tail.
    pub rope: Rope,
    /// Unstretched length of the tail (m).
    pub length_m: f64,
}

/// The device that holds the inboard end of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InboardEnd {
    /// Bitts: the line is held until it parts.
    Bitts,
    /// A winch.
    Winch(Winch),
}

/// Length of a line outboard at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InitialLength {
    /// The line has this unstretched length outboard at the start, tail included (m); it is at least the distance
    /// between the ends.
    Outboard(f64),
    /// The line has the length outboard that gives this tension at the ship's end (N).
    FromPretension(f64),
}

impl LineSetup {
    /// Checks the numbers of a mooring line that is not made fast yet.
    ///
    /// # Errors
    /// Fails for a number out of range; the error names the line.
    pub fn check_alone(&self) -> Result<(), MooringError> {
        let ends = LineEnds { ship_m: [0.0; 3], shore_m: [0.0; 3] };
        let name = || self.name.clone();
        check(self, &ends).map_err(|error| MooringError::OutOfRange { line: name(), error })
    }
}

impl LineKind {
    /// The shortest length of line outboard: the tail and one metre of rope (m).
    pub fn shortest_m(&self) -> f64 {
        1.0 + match self {
            LineKind::Light { tail: Some(tail), .. } => tail.length_m,
            LineKind::Light { tail: None, .. } | LineKind::Heavy { .. } => 0.0,
        }
    }

    /// The smaller break load of rope and tail (N).
    #[must_use]
    pub fn break_load_n(&self) -> f64 {
        match self {
            LineKind::Light { main, tail, .. } => lesser(
                tail.as_ref().map_or(f64::INFINITY, |t| t.rope.break_load_n),
                main.break_load_n,
            ),
            LineKind::Heavy { break_load_n, .. } => *break_load_n,
        }
    }

    /// Working load of a mooring rope (N): 55 % of the rope's break load for wire, 50 % for others (public summaries of
    /// OCIMF's MEG4), unless the set-up gives another working load. The working load is `None` for a cable, because the
    /// guideline gives none for cables.
    #[must_use]
    pub fn working_load_n(&self) -> Option<f64> {
        match self {
            LineKind::Light {
                details: LineDetails { working_load_n: Some(load_n), .. }, ..
            } => Some(*load_n),
            LineKind::Light { main, .. } => {
                let share = if main.curve == RopeCurve::wire() { 0.55 } else { 0.5 };
                Some(share * main.break_load_n)
            }
            LineKind::Heavy { .. } => None,
        }
    }

    /// Tensions at which the load curve of rope or tail has a corner, in rising order (N); none for a cable.
    pub(super) fn corners_n(&self) -> Vec<f64> {
        let LineKind::Light { main, tail, details } = self else { return vec![] };
        let ropes = [Some(main), tail.as_ref().map(|tail| &tail.rope)];
        let of = |rope: &Rope| -> Vec<f64> {
            rope.curve.corners().map(|share| share * rope.break_load_n).collect()
        };
        let mut corners_n: Vec<f64> = ropes.into_iter().flatten().flat_map(of).collect();
        if let Some(on_deck) = &details.on_deck {
            corners_n.extend(of(main).into_iter().map(|corner_n| corner_n / on_deck.share));
        }
        corners_n.sort_by(f64::total_cmp);
        corners_n.dedup();
        corners_n
    }
}

/// Checks the numbers of a line and of its ends.
pub(super) fn check(setup: &LineSetup, ends: &LineEnds) -> Result<(), OutOfRange> {
    for place_m in ends.ship_m.into_iter().chain(ends.shore_m) {
        within("position of an end [m]", place_m, -1e8, 1e8)?;
    }
    let span_m = Span::of(ends).distance_m;
    within("distance between the ends [m]", span_m, 0.0, 1e5)?;
    match &setup.kind {
        LineKind::Light { main, tail, details } => {
            if let Some(on_deck) = &details.on_deck {
                within("length of the rope on deck [m]", on_deck.length_m, 0.0, 5000.0)?;
                within("share of the tension on deck", on_deck.share, 1e-3, 1.0)?;
            }
            within("weight of the rope [N/m]", details.weight_npm, 0.0, 1e6)?;
            if let Some(load_n) = details.working_load_n {
                within("working load of the rope [N]", load_n, 1.0, 1e9)?;
            }
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
