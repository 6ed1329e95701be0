//! The limits of an exercise.

use fenderline_contact::number::bounded;

use super::words::{angle, force_share, metres, seconds, speed};

/// The quantity that a limit of an exercise bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// Speed of the ship's bow and stern towards the berth (m/s).
    ApproachSpeed,
    /// Speed of the ship along her axis, relative to the berth (m/s).
    AheadSpeed,
    /// Angle between the ship and the berth (rad).
    Angle,
    /// Revolutions of the engine, divided by full revolutions.
    Engine,
    /// Peak energy or reaction of a fender of the berth, divided by the rated value; the larger of the two shares.
    Fender,
    /// Tension, divided by break load, of a line that is fast to the ship.
    Line,
    /// Tension, divided by break load, of an anchor chain of the ship.
    Chain,
    /// How far an anchor of the ship has dragged since it came to the bottom (m).
    Dragged,
    /// Distance of the ship's hull from fixed structures other than the berth (m).
    Clearance,
    /// Water under the ship's keel (m).
    UnderKeel,
    /// Distance of the ship's midship from the track of her passage plan, to either side (m). It counts between the first
    /// and the last waypoint.
    CrossTrack,
    /// 1 if the ship's hull touched a structure or another hull without a fender between them, else 0.
    Touch,
    /// Time until the goal of the exercise is reached (s).
    Time,
}

impl Measure {
    /// All measures.
    pub const ALL: [Measure; 13] = [
        Measure::ApproachSpeed,
        Measure::AheadSpeed,
        Measure::Angle,
        Measure::Engine,
        Measure::Fender,
        Measure::Line,
        Measure::Chain,
        Measure::Dragged,
        Measure::Clearance,
        Measure::UnderKeel,
        Measure::CrossTrack,
        Measure::Touch,
        Measure::Time,
    ];

    /// The key of the measure in scenarios and results.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Measure::ApproachSpeed => "approach_speed",
            Measure::AheadSpeed => "ahead_speed",
            Measure::Angle => "angle",
            Measure::Engine => "engine",
            Measure::Fender => "fender",
            Measure::Line => "line",
            Measure::Chain => "chain",
            Measure::Dragged => "dragged",
            Measure::Clearance => "clearance",
            Measure::UnderKeel => "under_keel",
            Measure::CrossTrack => "cross_track",
            Measure::Touch => "touch",
            Measure::Time => "time",
        }
    }

    /// The measure in words.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Measure::ApproachSpeed => "Speed towards the berth",
            Measure::AheadSpeed => "Speed ahead or astern",
            Measure::Angle => "Angle to the berth",
            Measure::Engine => "Engine",
            Measure::Fender => "Load of a fender",
            Measure::Line => "Load of a line",
            Measure::Chain => "Load of an anchor chain",
            Measure::Dragged => "Way of a dragging anchor",
            Measure::Clearance => "Distance from structures",
            Measure::UnderKeel => "Water under the keel",
            Measure::CrossTrack => "Distance from the planned track",
            Measure::Touch => "Touch without a fender",
            Measure::Time => "Time to the goal",
        }
    }

    /// A value in words.
    #[must_use]
    pub fn value_text(self, value: f64) -> String {
        match self {
            Measure::ApproachSpeed | Measure::AheadSpeed => speed(value),
            Measure::Angle => angle(value),
            Measure::Engine => format!("{:.0} % of full", 100.0 * value),
            Measure::Fender => format!("{:.0} % of rated", 100.0 * value),
            Measure::Line | Measure::Chain => force_share(value),
            Measure::Dragged | Measure::Clearance | Measure::UnderKeel | Measure::CrossTrack => {
                metres(value)
            }
            Measure::Touch if value > 0.0 => "touched".to_owned(),
            Measure::Touch => "none".to_owned(),
            Measure::Time => seconds(value),
        }
    }

    /// The unit of the measure's values in results; empty for a plain number.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Measure::ApproachSpeed | Measure::AheadSpeed => "m/s",
            Measure::Angle => "rad",
            Measure::Dragged | Measure::Clearance | Measure::UnderKeel | Measure::CrossTrack => "m",
            Measure::Time => "s",
            Measure::Engine | Measure::Fender | Measure::Line | Measure::Chain | Measure::Touch => {
                ""
            }
        }
    }

    /// Returns true if a value below the bound exceeds the limit, as for a clearance.
    #[must_use]
    pub fn is_least(self) -> bool {
        matches!(self, Measure::Clearance | Measure::UnderKeel)
    }

    /// Returns true if the measure counts only near the berth. A limit on such a measure gives the distance from the
    /// berth within which the measure counts.
    #[must_use]
    pub fn is_near_berth(self) -> bool {
        matches!(
            self,
            Measure::ApproachSpeed | Measure::AheadSpeed | Measure::Angle | Measure::Engine
        )
    }

    /// Returns true if the measure can only be evaluated at a berth.
    #[must_use]
    pub fn needs_berth(self) -> bool {
        self.is_near_berth() || self == Measure::Fender
    }

    /// Returns true if the measure is a present value, such as a speed, which can fall below its limit again: the time
    /// above the limit is then reported. Measures that are not momentary are peak values, which never fall.
    #[must_use]
    pub fn is_momentary(self) -> bool {
        !matches!(self, Measure::Fender | Measure::Dragged | Measure::Time)
    }
}

/// A limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The quantity that the limit bounds.
    pub measure: Measure,
    /// The bound of the limit, in the unit of its measure. No points are deducted up to this value; for a limit on a
    /// least value, down to this value.
    pub bound: f64,
    /// The value of the measure at which all points of the limit are deducted.
    pub worst: f64,
    /// The points that an excess of this limit can deduct from the score.
    pub points: f64,
    /// True if the exercise is failed when this limit is exceeded.
    pub fails: bool,
    /// The limit counts while the ship is abreast of the berth and one of her ends is this near to the berth (m);
    /// infinite if the limit counts everywhere.
    pub within_m: f64,
}

impl Limit {
    /// Returns true if a value of the measure exceeds the limit.
    #[must_use]
    pub fn is_exceeded_by(&self, value: f64) -> bool {
        if self.measure.is_least() { value < self.bound } else { value > self.bound }
    }

    /// Points that a value of the measure deducts: none at the bound, all at the worst value and beyond, and in
    /// proportion between these two values.
    #[must_use]
    pub fn points_at(&self, value: f64) -> f64 {
        if !self.is_exceeded_by(value) {
            return 0.0;
        }
        let span = self.worst - self.bound;
        if span == 0.0 {
            return self.points;
        }
        let share = (value - self.bound) / span;
        self.points * bounded(share, 0.0, 1.0)
    }

    /// The limit in words.
    #[must_use]
    pub fn words(&self) -> String {
        let bound = self.measure.value_text(self.bound);
        let rule = match self.measure {
            Measure::Touch => "not allowed".to_owned(),
            _ if self.measure.is_least() => format!("at least {bound}"),
            _ => format!("at most {bound}"),
        };
        if self.within_m.is_finite() {
            return format!("{rule} within {} of the berth", metres(self.within_m));
        }
        rule
    }
}
