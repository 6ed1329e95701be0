//! Reasons why an order cannot be carried out.

use core::fmt;

use fenderline_contact::DisplayNumber;

use fenderline_ship::anchor::{LostBy, SHACKLE_M};

use super::table::{Argument, Gear, OrderName, TargetKind};
use crate::world::NotAtTheSide;

/// The reason why an order cannot be carried out. Nothing was changed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OrderError {
    /// There is no vessel, tug, line or anchor of this index.
    NoTarget {
        /// The kind of target.
        kind: TargetKind,
        /// The index.
        index: usize,
    },
    /// A required argument is missing.
    Missing {
        /// The order.
        order: OrderName,
        /// The argument's name.
        argument: &'static str,
    },
    /// The order has no such argument, or has it with another kind.
    Unknown {
        /// The order.
        order: OrderName,
        /// The name that was given.
        argument: String,
    },
    /// The value is of another kind than the argument.
    WrongKind {
        /// The argument.
        argument: &'static Argument,
    },
    /// A number is not within its limits.
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
    /// The index does not exist.
    NoIndex {
        /// The argument.
        argument: &'static Argument,
        /// The index.
        index: usize,
    },
    /// There is no body of this index.
    NoBody(usize),
    /// The target lacks the gear that the order needs.
    NoGear {
        /// The target.
        who: String,
        /// The gear that the target lacks.
        gear: Gear,
    },
    /// An azimuth unit is given neither a power nor a direction.
    Nothing,
    /// The place to push is not at the ship's side.
    NotAtTheSide(NotAtTheSide),
    /// A tug is ordered to assist herself.
    TugHerself {
        /// The tug.
        tug: String,
    },
    /// No pair of the scenario lets tug and ship touch.
    NoPair {
        /// The ship.
        ship: String,
    },
    /// The line is not between the tug and a ship.
    LineElsewhere {
        /// The line.
        line: String,
    },
    /// The force is more than the tug's bollard pull.
    BeyondBollardPull {
        /// The force (N).
        force_n: f64,
        /// The tug's bollard pull (N).
        pull_n: f64,
    },
    /// The ship has no side at the place that the words name.
    NoPlace {
        /// The ship.
        ship: String,
    },
    /// The tug has no line to the ship.
    NoTowline {
        /// The ship.
        ship: String,
    },
    /// The line is on board, so there is nothing to heave, to pay out or to let go.
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
    /// The line is already fast, or will be made fast without an order.
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
    /// The bollard has as many lines as it takes.
    BollardTaken {
        /// The bollard.
        bollard: String,
        /// How many lines the bollard takes.
        most_lines: usize,
    },
    /// The bollard is too far away: farther than the rope reaches or, if there is no boat, farther than a heaving line
    /// reaches.
    OutOfReach {
        /// The line.
        line: String,
        /// The bollard.
        bollard: String,
        /// Distance from fairlead to bollard (m).
        distance_m: f64,
        /// The reach (m).
        reach_m: f64,
        /// The rope or heaving line that reaches no farther.
        by: &'static str,
    },
    /// The order asks for more chain than the anchor has.
    ChainTooShort {
        /// The anchor.
        anchor: String,
        /// The chain that the order asks for (m).
        chain_m: f64,
        /// Length of the anchor's chain (m).
        length_m: f64,
    },
    /// An anchor is let go in deep water: the scenario gives no depth.
    NoBottom {
        /// The anchor.
        anchor: String,
    },
    /// An anchor is let go in water that is deeper than its chain is long.
    TooDeep {
        /// The anchor.
        anchor: String,
        /// Height of the hawse pipe above the bottom (m).
        reach_m: f64,
        /// Length of the anchor's chain (m).
        length_m: f64,
    },
    /// The anchor is lost.
    AnchorLost {
        /// The anchor.
        anchor: String,
        /// How the anchor was lost.
        by: LostBy,
    },
    /// The anchor is home: there is nothing to heave, to hold or to slip.
    AnchorHome {
        /// The anchor.
        anchor: String,
    },
    /// The anchor is on the bottom already.
    AnchorDown {
        /// The anchor.
        anchor: String,
    },
    /// There is no chain to move. An order to veer asks for no more chain than is already out, or an order to heave for
    /// no less.
    NoChainToMove {
        /// The anchor.
        anchor: String,
        /// Chain out (m).
        out_m: f64,
        /// Whether more chain than is out must be asked for; false: less.
        more: bool,
    },
    /// The windlass has no power.
    WindlassFailed {
        /// The anchor.
        anchor: String,
    },
    /// A station pilot of the ship uses the tug.
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
                write!(f, "the order `{}` needs `{argument}`", order.spec().word)
            }
            OrderError::Unknown { order, argument } => {
                write!(
                    f,
                    "the order `{}` has no argument `{argument}` of this kind",
                    order.spec().word
                )
            }
            OrderError::WrongKind { argument } => {
                write!(f, "the {} is not of its kind", argument.meaning)
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
            OrderError::TugHerself { tug } => write!(f, "`{tug}` is the tug herself"),
            OrderError::NoPair { ship } => {
                write!(f, "no pair in the scenario lets her touch `{ship}`")
            }
            OrderError::LineElsewhere { line } => {
                write!(f, "line `{line}` is not between her and a ship")
            }
            OrderError::BeyondBollardPull { force_n, pull_n } => write!(
                f,
                "the force must be at most her bollard pull of {} kN, but is {} kN",
                pull_n / 1e3,
                force_n / 1e3
            ),
            OrderError::NoPlace { ship } => write!(f, "`{ship}` has no side there"),
            OrderError::NoTowline { ship } => write!(f, "she has no line to `{ship}`"),
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
                "bollard `{bollard}` takes {most_lines} line{} and has as many",
                if *most_lines == 1 { "" } else { "s" }
            ),
            OrderError::OutOfReach { line, bollard, distance_m, reach_m, by } => write!(
                f,
                "bollard `{bollard}` is {distance_m:.0} m from the fairlead of line `{line}`, but {by} reaches {reach_m:.0} m"
            ),
            OrderError::ChainTooShort { anchor, chain_m, length_m } => write!(
                f,
                "the chain of anchor `{anchor}` is {length_m:.1} m long ({}), less than {chain_m:.1} m",
                shackles(*length_m)
            ),
            OrderError::NoBottom { anchor } => write!(
                f,
                "anchor `{anchor}` finds no bottom: the water is deep, as the scenario gives no depth"
            ),
            OrderError::TooDeep { anchor, reach_m, length_m } => write!(
                f,
                "the water is too deep for anchor `{anchor}`: its hawse pipe is {reach_m:.1} m above the bottom, and its \
                 chain is {length_m:.1} m long ({})",
                shackles(*length_m)
            ),
            OrderError::AnchorLost { anchor, by } => {
                let how = match by {
                    LostBy::Slipped => "its chain was slipped",
                    LostBy::Parted => "its chain parted",
                    LostBy::RanOut => "its chain ran out",
                };
                write!(f, "anchor `{anchor}` is gone: {how}")
            }
            OrderError::AnchorHome { anchor } => {
                write!(f, "anchor `{anchor}` is home in its hawse pipe")
            }
            OrderError::AnchorDown { anchor } => {
                write!(f, "anchor `{anchor}` is on the bottom already: veer chain instead")
            }
            OrderError::NoChainToMove { anchor, out_m, more } => write!(
                f,
                "anchor `{anchor}` has {out_m:.1} m of chain out ({}) already: ask for {} than that",
                shackles(*out_m),
                if *more { "more" } else { "less" }
            ),
            OrderError::WindlassFailed { anchor } => write!(
                f,
                "the windlass of anchor `{anchor}` has no power: the anchor can only be let go, held or slipped"
            ),
            OrderError::TugOfStation { ship } => write!(
                f,
                "the pilot that keeps `{ship}` on her station uses her tugs: steer her by hand first"
            ),
        }
    }
}

/// A length of chain in shackles.
fn shackles(length_m: f64) -> String {
    format!("{:.1} shackles", length_m / SHACKLE_M)
}

impl std::error::Error for OrderError {}
