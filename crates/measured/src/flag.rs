//! What limits the quality of a measured berthing.

/// A remark about the quality of a berthing, for the table and the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Flag {
    /// A pause in the readings before the touch.
    Gap,
    /// The last reading of a sensor is well before the touch.
    Extrapolated,
    /// Readings far from the others were left out.
    Outliers,
    /// The clock jumped, and the rows after it were moved.
    ClockJump,
    /// A sensor did not see the hull in some rows.
    HullLost,
    /// The log's own speeds differ from the change of the distances.
    SpeedsDiffer,
    /// The log's own angle has the opposite sign.
    AngleOpposite,
    /// Residuals follow each other, as in waves.
    Waves,
    /// The track was moved so that the ship lies at the fenders at rest.
    ZeroedAtRest,
    /// The place along the quay was not measured.
    PlaceAssumed,
    /// The scenario's ship stands for a ship that the mapping does not know.
    ShipAssumed,
    /// AIS alone is coarse.
    Coarse,
    /// The hull has outlines at several heights, of which the touch uses one.
    OneOutline,
    /// The run from the measured state touched no fender or failed.
    RunFailed,
    /// The run met the fenders with another speed than the measured one: loads other than the water acted.
    Driven,
}

impl Flag {
    /// The word in the table.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Flag::Gap => "gap",
            Flag::Extrapolated => "extrapolated",
            Flag::Outliers => "outliers",
            Flag::ClockJump => "clock_jump",
            Flag::HullLost => "hull_lost",
            Flag::SpeedsDiffer => "speeds_differ",
            Flag::AngleOpposite => "angle_opposite",
            Flag::Waves => "waves",
            Flag::ZeroedAtRest => "zeroed_at_rest",
            Flag::PlaceAssumed => "place_assumed",
            Flag::ShipAssumed => "ship_assumed",
            Flag::Coarse => "coarse",
            Flag::OneOutline => "one_outline",
            Flag::RunFailed => "run_failed",
            Flag::Driven => "driven",
        }
    }

    /// What it means.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Flag::Gap => {
                "the readings pause for more than a third of the bandwidth before the touch"
            }
            Flag::Extrapolated => {
                "the last reading of a channel is more than a quarter of the bandwidth before the touch"
            }
            Flag::Outliers => "readings far from the others were left out",
            Flag::ClockJump => {
                "the clock jumped; the rows after the jump were moved to follow the row before it"
            }
            Flag::HullLost => "a sensor did not see the hull in some rows of the approach",
            Flag::SpeedsDiffer => {
                "the log's own speeds differ by more than a tenth from the change of the distances"
            }
            Flag::AngleOpposite => {
                "the log's own angle has the opposite sign of the distances: another convention, or sensors swapped"
            }
            Flag::Waves => {
                "what is left beside the parabola follows itself, as the motion in waves does; the deviations are widened"
            }
            Flag::ZeroedAtRest => {
                "the track was moved square to the quay so that the ship lies at the fenders at rest"
            }
            Flag::PlaceAssumed => {
                "the place along the quay was not measured; it is that of the scenario or the mapping"
            }
            Flag::ShipAssumed => {
                "the mapping does not know the ship; the scenario's ship stands for her"
            }
            Flag::Coarse => {
                "AIS alone: positions in steps of 0.2 m every 2 to 180 s, headings in steps of 1°"
            }
            Flag::OneOutline => {
                "the hull has outlines at several heights; the touch is computed with the outline in the plan"
            }
            Flag::RunFailed => "the run from the measured state met no fender, or failed",
            Flag::Driven => {
                "the run met the fenders with a speed that differs from the measured one by more than three deviations and 1 cm/s: tugs, wind or engine acted on the way"
            }
        }
    }
}
