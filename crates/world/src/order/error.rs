//! Reasons why an order cannot be carried out.

use core::fmt;

use fenderline_contact::DisplayNumber;

use fenderline_ship::anchor::{LostBy, SHACKLE_M};

use super::table::{Argument, Gear, OrderName, TargetKind};
use crate::world::NotAtTheSide;

/// The reason why an order cannot be carried out. An order with such an error changes nothing.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OrderError {
    /// No vessel, tug, line or anchor has this index.
    NoTarget {
        /// Kind of target of the order.
        kind: TargetKind,
        /// The index.
        index: usize,
    },
    /// A required argument of the order is missing.
    Missing {
        /// The order.
        order: OrderName,
        /// The argument's name.
        argument: &'static str,
    },
    /// The order has no argument of this name, or has the argument with another kind of value.
    Unknown {
        /// The order.
        order: OrderName,
        /// Name of the argument that was given.
        argument: String,
    },
    /// The value is of another kind than the argument needs.
    WrongKind {
        /// The argument.
        argument: &'static Argument,
    },
    /// The number given for an argument is outside the argument's limits.
    OutOfRange {
        /// The argument.
        argument: &'static Argument,
        /// The number.
        value: f64,
        /// The least value allowed.
        low: f64,
        /// The greatest value allowed.
        high: f64,
    },
    /// No object that the argument can name has this index.
    NoIndex {
        /// The argument.
        argument: &'static Argument,
        /// The index.
        index: usize,
    },
    /// No body has this index.
    NoBody(usize),
    /// The target does not have the gear that the order needs.
    NoGear {
        /// The target.
        who: String,
        /// The gear that the target does not have.
        gear: Gear,
    },
    /// The order to an azimuth unit gives neither a power nor a direction.
    Nothing,
    /// The place at which the tug must push is not at the ship's side.
    NotAtTheSide(NotAtTheSide),
    /// The order asks a tug to assist herself.
    TugHerself {
        /// The tug.
        tug: String,
    },
    /// The scenario has no pair of the tug and the ship, so the two cannot touch.
    NoPair {
        /// The ship.
        ship: String,
    },
    /// The line is not between the tug and a ship.
    LineElsewhere {
        /// The line.
        line: String,
    },
    /// The force that the order asks for is more than the tug's bollard pull.
    BeyondBollardPull {
        /// The force that the order asks for (N).
        force_n: f64,
        /// The tug's bollard pull (N).
        pull_n: f64,
    },
    /// The ship has no side at the place that the words of the order name.
    NoPlace {
        /// The ship.
        ship: String,
    },
    /// The tug has no line to the ship.
    NoTowline {
        /// The ship.
        ship: String,
    },
    /// The line is on board, so the ship cannot heave it, pay it out or let it go.
    LineAboard {
        /// The line.
        line: String,
    },
    /// The line is on its way to a bollard.
    LineUnderWay {
        /// The line.
        line: String,
    },
    /// The line has parted.
    LineParted {
        /// The line.
        line: String,
    },
    /// The line is already fast, or line handlers will make it fast without an order.
    LineInUse {
        /// The line.
        line: String,
    },
    /// The bollard is on the body that holds the line.
    OwnBollard {
        /// The line.
        line: String,
        /// The bollard.
        bollard: String,
    },
    /// The bollard already has as many lines as it can take.
    BollardTaken {
        /// The bollard.
        bollard: String,
        /// Number of lines that the bollard can take.
        most_lines: usize,
    },
    /// The bollard is farther from the fairlead than the rope reaches or, if the scenario has no line boat, than a
    /// heaving line reaches.
    OutOfReach {
        /// The line.
        line: String,
        /// The bollard.
        bollard: String,
        /// Distance from fairlead to bollard (m).
        distance_m: f64,
        /// Reach of the rope or of the heaving line (m).
        reach_m: f64,
        /// Word for the rope or heaving line that does not reach the bollard.
        by: &'static str,
    },
    /// The order asks for more chain than the anchor has.
    ChainTooShort {
        /// The anchor.
        anchor: String,
        /// Length of chain that the order asks for (m).
        chain_m: f64,
        /// Length of the anchor's chain (m).
        length_m: f64,
    },
    /// The order lets an anchor go in deep water: the scenario gives no depth.
    NoBottom {
        /// The anchor.
        anchor: String,
    },
    /// The order lets an anchor go where the hawse pipe is higher above the bottom than the chain is long.
    TooDeep {
        /// The anchor.
        anchor: String,
        /// Height of the hawse pipe above the bottom (m).
        reach_m: f64,
        /// Length of the anchor's chain (m).
        length_m: f64,
    },
    /// The ship has lost the anchor.
    AnchorLost {
        /// The anchor.
        anchor: String,
        /// How the ship lost the anchor.
        by: LostBy,
    },
    /// The anchor is home in the hawse pipe, so the ship cannot heave, hold or slip its chain.
    AnchorHome {
        /// The anchor.
        anchor: String,
    },
    /// The anchor is already on the bottom.
    AnchorDown {
        /// The anchor.
        anchor: String,
    },
    /// The order moves no chain. An order to veer asks for no more chain than is already out, or an order to heave asks
    /// for no less.
    NoChainToMove {
        /// The anchor.
        anchor: String,
        /// Length of chain that is out (m).
        out_m: f64,
        /// True if the order must ask for more chain than is out; false if the order must ask for less.
        more: bool,
    },
    /// The windlass of the anchor has no power.
    WindlassFailed {
        /// The anchor.
        anchor: String,
    },
    /// A pilot that keeps the ship on her station uses the tug.
    TugOfStation {
        /// The ship.
        ship: String,
    },
}

impl OrderError {
    /// The wrong argument, if the error is about an argument.
    #[must_use]
    pub fn argument(&self) -> Option<&str> {
        match self {
            OrderError::Missing { argument, .. } => Some(argument),
            OrderError::Unknown { argument, .. } => Some(argument),
            OrderError::WrongKind { argument }
            | OrderError::OutOfRange { argument, .. }
            | OrderError::NoIndex { argument, .. } => Some(argument.name),
            OrderError::NotAtTheSide(_) => Some("at"),
            OrderError::NoBody(_) | OrderError::TugHerself { .. } | OrderError::NoPair { .. } => {
                Some("ship")
            }
            OrderError::LineElsewhere { .. } => Some("line"),
            OrderError::ChainTooShort { .. } => Some("chain"),
            OrderError::OwnBollard { .. }
            | OrderError::BollardTaken { .. }
            | OrderError::OutOfReach { .. } => Some("bollard"),
            OrderError::BeyondBollardPull { .. } => Some("force"),
            OrderError::NoTarget { .. }
            | OrderError::NoGear { .. }
            | OrderError::Nothing
            | OrderError::NoPlace { .. }
            | OrderError::NoTowline { .. }
            | OrderError::LineAboard { .. }
            | OrderError::LineUnderWay { .. }
            | OrderError::LineParted { .. }
            | OrderError::NoBottom { .. }
            | OrderError::TooDeep { .. }
            | OrderError::AnchorLost { .. }
            | OrderError::AnchorHome { .. }
            | OrderError::AnchorDown { .. }
            | OrderError::NoChainToMove { .. }
            | OrderError::WindlassFailed { .. }
            | OrderError::LineInUse { .. }
            | OrderError::TugOfStation { .. } => None,
        }
    }
}

impl fmt::Display for OrderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OrderError::NoTarget { kind, index } => {
                write!(f, "there is no {} of index {index}", kind.word())
            }
            OrderError::Missing { order, argument } => {
                write!(f, "the order `{}` needs the argument `{argument}`", order.spec().word)
            }
            OrderError::Unknown { order, argument } => {
                write!(
                    f,
                    "the order `{}` has no argument `{argument}` of this kind",
                    order.spec().word
                )
            }
            OrderError::WrongKind { argument } => {
                write!(f, "the value of the {} is of the wrong kind", argument.meaning)
            }
            OrderError::OutOfRange { argument, value, low, high } => {
                let unit = match argument.kind {
                    super::ArgumentKind::Number { unit, .. } => unit.symbol(),
                    _ => "m",
                };
                let space = if unit.is_empty() { "" } else { " " };
                let [value, low, high] = [*value, *low, *high].map(DisplayNumber);
                write!(
                    f,
                    "the {} must be between {low} and {high}{space}{unit}, but is {value}",
                    argument.meaning
                )
            }
            OrderError::NoIndex { argument, index } => {
                write!(f, "there is no {} of index {index}", argument.meaning)
            }
            OrderError::NoBody(index) => write!(f, "there is no body of index {index}"),
            OrderError::NoGear { who, gear } => write!(f, "`{who}` has no {}", gear.missing()),
            OrderError::Nothing => {
                f.write_str("the order asks for nothing: give a power, a direction or both")
            }
            OrderError::NotAtTheSide(error) => error.fmt(f),
            OrderError::TugHerself { tug } => {
                write!(f, "`{tug}` is the tug herself, but a tug can assist only another body")
            }
            OrderError::NoPair { ship } => {
                write!(f, "no pair in the scenario lets the tug touch `{ship}`")
            }
            OrderError::LineElsewhere { line } => {
                write!(f, "line `{line}` is not between the tug and a ship")
            }
            OrderError::BeyondBollardPull { force_n, pull_n } => write!(
                f,
                "the force must be at most the tug's bollard pull of {} kN, but is {} kN",
                pull_n / 1e3,
                force_n / 1e3
            ),
            OrderError::NoPlace { ship } => write!(f, "`{ship}` has no side at this place"),
            OrderError::NoTowline { ship } => write!(f, "the tug has no line to `{ship}`"),
            OrderError::LineAboard { line } => write!(f, "line `{line}` is on board"),
            OrderError::LineUnderWay { line } => {
                write!(f, "line `{line}` is on its way to a bollard")
            }
            OrderError::LineParted { line } => write!(f, "line `{line}` has parted"),
            OrderError::LineInUse { line } => {
                write!(f, "line `{line}` is not on board: let it go first")
            }
            OrderError::OwnBollard { line, bollard } => {
                write!(f, "bollard `{bollard}` is on the body that holds line `{line}`")
            }
            OrderError::BollardTaken { bollard, most_lines } => write!(
                f,
                "bollard `{bollard}` takes {most_lines} line{} and already has as many",
                if *most_lines == 1 { "" } else { "s" }
            ),
            OrderError::OutOfReach { line, bollard, distance_m, reach_m, by } => write!(
                f,
                "bollard `{bollard}` is {distance_m:.0} m from the fairlead of line `{line}`, but \
                 {by} reaches {reach_m:.0} m"
            ),
            OrderError::ChainTooShort { anchor, chain_m, length_m } => write!(
                f,
                "the chain of anchor `{anchor}` is {length_m:.1} m long ({}), less than \
                 {chain_m:.1} m",
                shackles(*length_m)
            ),
            OrderError::NoBottom { anchor } => write!(
                f,
                "anchor `{anchor}` finds no bottom: the water is deep, because the scenario gives \
                 no depth"
            ),
            OrderError::TooDeep { anchor, reach_m, length_m } => write!(
                f,
                "the water is too deep for anchor `{anchor}`: the hawse pipe is {reach_m:.1} m above the \
                 bottom, and the chain is {length_m:.1} m long ({})",
                shackles(*length_m)
            ),
            OrderError::AnchorLost { anchor, by } => {
                let how = match by {
                    LostBy::Slipped => "its chain was slipped",
                    LostBy::Parted => "its chain parted",
                    LostBy::RanOut => "its chain ran out",
                };
                write!(f, "anchor `{anchor}` is lost: {how}")
            }
            OrderError::AnchorHome { anchor } => {
                write!(f, "anchor `{anchor}` is home in its hawse pipe")
            }
            OrderError::AnchorDown { anchor } => {
                write!(f, "anchor `{anchor}` is already on the bottom: veer chain instead")
            }
            OrderError::NoChainToMove { anchor, out_m, more } => write!(
                f,
                "anchor `{anchor}` has {out_m:.1} m of chain out ({}): ask for {} than this length",
                shackles(*out_m),
                if *more { "more" } else { "less" }
            ),
            OrderError::WindlassFailed { anchor } => write!(
                f,
                "the windlass of anchor `{anchor}` has no power: the anchor can only be let go, \
                 held or slipped"
            ),
            OrderError::TugOfStation { ship } => write!(
                f,
                "`{ship}` keeps her station by herself and orders her tugs: the tugs obey when the \
                 pilot steers the ship by hand"
            ),
        }
    }
}

/// A length of chain as text in shackles.
fn shackles(length_m: f64) -> String {
    format!("{:.1} shackles", length_m / SHACKLE_M)
}

impl std::error::Error for OrderError {}
