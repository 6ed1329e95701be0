//! The table of orders: the only place that gives the word, the arguments, the units, the limits, the defaults and the
//! gear of an order.

use core::f64::consts::FRAC_PI_2;

use crate::setup::Setup;
use fenderline_ship::constants::KNOT_MPS;
use fenderline_ship::mooring::InboardEnd;

/// Kind of the target of an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetKind {
    /// A vessel.
    Vessel,
    /// A vector tug.
    Tug,
    /// A mooring line or towline.
    Line,
    /// An anchor.
    Anchor,
}

/// The equipment that the target of an order must have to carry the order out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gear {
    /// No special gear.
    None,
    /// Propeller and rudder.
    PropellerAndRudder,
    /// Propeller and rudder, or azimuth units.
    Steering,
    /// The target must have at least one tunnel thruster.
    Thrusters,
    /// The target must have at least one azimuth unit.
    AzimuthUnits,
    /// A winch.
    Winch,
}

/// Unit of a number in an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// No unit: a share of the greatest value.
    Share,
    /// Radians.
    Radian,
    /// Metres.
    Metre,
    /// Metres per second.
    MetrePerSecond,
    /// Newtons.
    Newton,
}

/// What an argument holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ArgumentKind {
    /// A number between two limits; both limits are allowed.
    Number {
        /// Unit of the number.
        unit: Unit,
        /// The least value.
        low: f64,
        /// The greatest value.
        high: f64,
    },
    /// Two coordinates (m), each with a greatest magnitude.
    Place {
        /// The greatest magnitude of a coordinate (m).
        most_m: f64,
        /// The axes of the coordinates.
        frame: Frame,
    },
    /// The name of an object of the scenario.
    Name(Named),
}

/// The axes of the coordinates of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The coordinates are north and east.
    Earth,
    /// The coordinates are forward and to starboard of a body's origin.
    Body,
}

/// The kind of object that a name refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Named {
    /// The object is one of the vessel's tunnel thrusters.
    Thruster,
    /// The object is one of the vessel's azimuth units.
    AzimuthUnit,
    /// The object is any body of the scenario.
    Body,
    /// The object is any line of the scenario.
    Line,
    /// The object is any bollard of the scenario.
    Bollard,
}

/// What an order means if an argument is absent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Absent {
    /// The argument is required.
    Refused,
    /// The argument then has this value. The text gives the value with its unit.
    Is(f64, &'static str),
    /// The text says what the order then means.
    Means(&'static str),
}

/// One argument of an order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Argument {
    /// Name of the argument, without the unit.
    pub name: &'static str,
    /// Kind of the argument.
    pub kind: ArgumentKind,
    /// Default of the argument.
    pub absent: Absent,
    /// Meaning of the argument, as messages give it.
    pub meaning: &'static str,
}

/// One row of the table of orders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrderSpec {
    /// The word that scenario files and pages use.
    pub word: &'static str,
    /// Kind of target of the order.
    pub target: TargetKind,
    /// The gear that the target must have.
    pub gear: Gear,
    /// Arguments of the order.
    pub arguments: &'static [Argument],
    /// Meaning of the order, as messages give it.
    pub meaning: &'static str,
}

macro_rules! orders {
    ($(
        #[doc = $meaning:literal]
        $name:ident = $word:literal to $target:ident with $gear:ident: $arguments:expr;
    )*) => {
        /// All orders. [`OrderName::spec`] gives the row of an order in the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum OrderName {
            $(#[doc = $meaning] $name,)*
        }

        impl OrderName {
            /// All orders, in the sequence of the rows of the table.
            pub const ALL: &'static [OrderName] = &[$(OrderName::$name),*];
        }

        const TABLE: &[OrderSpec] = &[$(OrderSpec {
            word: $word,
            target: TargetKind::$target,
            gear: Gear::$gear,
            arguments: $arguments,
            meaning: $meaning.trim_ascii(),
        }),*];
    };
}

orders! {
    /// Put the rudder to an angle. A positive angle turns a ship that goes ahead to starboard.
    Rudder = "rudder" to Vessel with PropellerAndRudder:
        &[number("angle", Unit::Radian, -FRAC_PI_2, FRAC_PI_2, "rudder angle")];
    /// Set the engine to a share of full revolutions, positive ahead.
    Engine = "engine" to Vessel with PropellerAndRudder: &[share("share", "revolutions divided by full revolutions")];
    /// Set a tunnel thruster to a share of its greatest thrust, positive to starboard.
    Thruster = "thruster" to Vessel with Thrusters: &[
        name("name", Named::Thruster, "thruster"),
        share("power", "thrust divided by the greatest thrust"),
    ];
    /// Set an azimuth unit to a power, a direction or both.
    Azimuth = "azimuth" to Vessel with AzimuthUnits: &[
        name("name", Named::AzimuthUnit, "azimuth unit"),
        Argument { absent: UNCHANGED, ..number("power", Unit::Share, 0.0, 1.0,
            "thrust divided by the thrust at rest and full power") },
        Argument { absent: UNCHANGED, ..angle("direction", "direction of the thrust, measured from the bow") },
    ];
    /// Keep a heading.
    Course = "course" to Vessel with Steering: &[angle("heading", "heading")];
    /// Keep a speed ahead through the water.
    Speed = "speed" to Vessel with Steering: &[
        number("speed", Unit::MetrePerSecond, -30.0, 30.0, "speed ahead through the water"),
    ];
    /// Go to a place and stay at this place with engine, thrusters and tugs.
    Station = "station" to Vessel with None: &[
        place("position", Frame::Earth, 1e8, "position of the ship's centre of gravity"),
        angle("heading", "heading"),
        Argument { absent: Absent::Is(0.5, "0.5 m/s"), ..fastest("surge", "greatest surge velocity of the ship") },
        Argument { absent: Absent::Is(0.2, "0.2 m/s"), ..fastest("sway", "greatest sway velocity of the ship") },
    ];
    /// Go to a ship's side and push at this side.
    PushShip = "push_ship" to Vessel with AzimuthUnits: &[
        name("ship", Named::Body, "ship"),
        place("at", Frame::Body, FARTHEST_BESIDE_M, "place at the ship's side"),
        force("force"),
        Argument { absent: Absent::Is(2.0 * KNOT_MPS, "2 kn"), ..fastest("speed",
            "greatest speed of the tug beside the ship") },
    ];
    /// Pull on a line to a ship.
    PullShip = "pull_ship" to Vessel with AzimuthUnits: &[
        name("line", Named::Line, "line"),
        force("force"),
        angle("direction", "direction of the pull, measured from the ship's bow"),
        Argument { absent: Absent::Is(2.0 * KNOT_MPS, "2 kn"), ..fastest("speed",
            "greatest speed of the tug beside the ship") },
    ];
    /// Keep a place and a heading beside a ship.
    FollowShip = "follow_ship" to Vessel with AzimuthUnits: &[
        name("ship", Named::Body, "ship"),
        place("at", Frame::Body, FARTHEST_BESIDE_M, "place beside the ship"),
        Argument { absent: Absent::Is(0.0, "the ship's heading"), ..angle("heading",
            "heading of the tug, measured from the ship's heading") },
        Argument { absent: Absent::Is(4.0 * KNOT_MPS, "4 kn"), ..fastest("speed",
            "greatest speed of the tug beside the ship") },
    ];
    /// Steer by hand: switch off all pilots, and leave the controls as they are.
    Hands = "hands" to Vessel with None: &[];
    /// Push at the hull.
    Push = "push" to Tug with None: TUG_FORCE;
    /// Pull on the line.
    Pull = "pull" to Tug with None: TUG_FORCE;
    /// Stand by without force.
    StandBy = "stand_by" to Tug with None: &[];
    /// Heave the line in with the winch.
    Heave = "heave" to Line with Winch: WINCH_RATE;
    /// Pay the line out with the winch.
    PayOut = "pay_out" to Line with Winch: WINCH_RATE;
    /// Hold the line on the winch's brake.
    Hold = "hold" to Line with Winch: &[];
    /// Send the line to a bollard. Line handlers make the line fast at this bollard.
    Send = "send" to Line with None: &[name("bollard", Named::Bollard, "bollard")];
    /// Let the line go. The line is then hauled in.
    LetGo = "let_go" to Line with None: &[];
    /// Let the anchor go, and hold on the brake when this length of chain is out.
    LetGoAnchor = "let_go_anchor" to Anchor with None: CHAIN_OUT;
    /// Veer: pay chain out under power until this length of chain is out.
    Veer = "veer" to Anchor with None: CHAIN_OUT;
    /// Heave chain in until this length of chain is out; 0 brings the anchor home.
    HeaveIn = "heave_in" to Anchor with None: CHAIN_OUT;
    /// Hold the chain on the windlass's brake.
    HoldChain = "hold_chain" to Anchor with None: &[];
    /// Slip the chain: anchor and chain are lost.
    Slip = "slip" to Anchor with None: &[];
}

/// Largest distance of a position from a ship's centre of gravity, along the ship and across it (m).
const FARTHEST_BESIDE_M: f64 = 1e4;
const UNCHANGED: Absent = Absent::Means("unchanged");
const TUG_FORCE: &[Argument] = &[
    force("force"),
    Argument {
        absent: Absent::Means(
            "square to the hull: away from the side at which the tug works for a push, towards \
             this side for a pull",
        ),
        ..angle("direction", "direction of the force, measured from the ship's bow")
    },
];
/// Length of chain out, measured from the hawse pipe.
const CHAIN_OUT: &[Argument] = &[number("chain", Unit::Metre, 0.0, 5000.0, "chain out")];
const WINCH_RATE: &[Argument] = &[number("rate", Unit::MetrePerSecond, 0.0, 20.0, "winch's rate")];

const fn number(
    name: &'static str,
    unit: Unit,
    low: f64,
    high: f64,
    meaning: &'static str,
) -> Argument {
    Argument {
        name,
        kind: ArgumentKind::Number { unit, low, high },
        absent: Absent::Refused,
        meaning,
    }
}

const fn share(name: &'static str, meaning: &'static str) -> Argument {
    number(name, Unit::Share, -1.0, 1.0, meaning)
}

/// An argument for an angle. Any angle is allowed, even more than a full turn.
const fn angle(name: &'static str, meaning: &'static str) -> Argument {
    number(name, Unit::Radian, -100.0, 100.0, meaning)
}

const fn fastest(name: &'static str, meaning: &'static str) -> Argument {
    number(name, Unit::MetrePerSecond, 0.01, 10.0, meaning)
}

const fn force(name: &'static str) -> Argument {
    number(name, Unit::Newton, 0.0, 1e8, "tug's force")
}

const fn place(name: &'static str, frame: Frame, most_m: f64, meaning: &'static str) -> Argument {
    Argument { name, kind: ArgumentKind::Place { most_m, frame }, absent: Absent::Refused, meaning }
}

const fn name(name: &'static str, named: Named, meaning: &'static str) -> Argument {
    Argument { name, kind: ArgumentKind::Name(named), absent: Absent::Refused, meaning }
}

impl OrderName {
    /// Row of the order in the table of orders.
    #[must_use]
    pub const fn spec(self) -> &'static OrderSpec {
        &TABLE[self as usize]
    }

    /// The order with this word; `None` if no order has it.
    #[must_use]
    pub fn of_word(word: &str) -> Option<OrderName> {
        OrderName::ALL.iter().copied().find(|name| name.spec().word == word)
    }

    /// The limits of an argument that is a number or a place. In a constant, a wrong name is a compile error.
    ///
    /// # Panics
    /// Panics if the order has no number and no place of this name.
    #[must_use]
    pub const fn limits(self, argument: &str) -> [f64; 2] {
        let all = self.spec().arguments;
        let mut index = 0;
        while index < all.len() {
            if is_same(all[index].name, argument) {
                return match all[index].kind {
                    ArgumentKind::Number { low, high, .. } => [low, high],
                    ArgumentKind::Place { most_m, .. } => [-most_m, most_m],
                    ArgumentKind::Name(_) => panic!("a name has no limits"),
                };
            }
            index += 1;
        }
        panic!("the order has no such argument")
    }
}

/// True if two texts are equal. Constants can use this function.
const fn is_same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    if one.len() != other.len() {
        return false;
    }
    let mut index = 0;
    while index < one.len() {
        if one[index] != other[index] {
            return false;
        }
        index += 1;
    }
    true
}

impl OrderSpec {
    /// The argument with this name; `None` if the order has no such argument.
    #[must_use]
    pub fn argument(&self, name: &str) -> Option<&'static Argument> {
        self.arguments.iter().find(|argument| argument.name == name)
    }
}

impl Argument {
    /// Name of the argument with its unit, as used in messages to and from pages: `angle_rad`.
    #[must_use]
    pub fn field(&self) -> String {
        let suffix = match self.kind {
            ArgumentKind::Number { unit, .. } => unit.suffix(),
            ArgumentKind::Place { .. } => "_m",
            ArgumentKind::Name(_) => "",
        };
        format!("{}{suffix}", self.name)
    }
}

impl TargetKind {
    /// The word for the kind of target.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            TargetKind::Vessel => "vessel",
            TargetKind::Tug => "tug",
            TargetKind::Line => "line",
            TargetKind::Anchor => "anchor",
        }
    }
}

impl Unit {
    /// The ending of the names of numbers with this unit.
    #[must_use]
    pub const fn suffix(self) -> &'static str {
        match self {
            Unit::Share => "",
            Unit::Radian => "_rad",
            Unit::Metre => "_m",
            Unit::MetrePerSecond => "_mps",
            Unit::Newton => "_n",
        }
    }

    /// Symbol of the unit; empty for a share.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Unit::Share => "",
            Unit::Radian => "rad",
            Unit::Metre => "m",
            Unit::MetrePerSecond => "m/s",
            Unit::Newton => "N",
        }
    }
}

impl Gear {
    /// Words for the gear that the target does not have; in the message they follow "has no".
    #[must_use]
    pub const fn missing(self) -> &'static str {
        match self {
            Gear::None => "gear",
            Gear::PropellerAndRudder => "propeller and rudder",
            Gear::Steering => "propeller with rudder and no azimuth units",
            Gear::Thrusters => "thrusters",
            Gear::AzimuthUnits => "azimuth units",
            Gear::Winch => "winch",
        }
    }

    /// True if a target has the gear. The target is the index of a line if the gear is a winch; otherwise the target is
    /// the index of a vessel.
    #[must_use]
    pub fn is_on(self, target: usize, setup: &Setup) -> bool {
        let vessel = || setup.world.vessels.get(target);
        match self {
            Gear::None => true,
            Gear::PropellerAndRudder => vessel().is_some_and(|v| v.ship.propulsion.is_some()),
            Gear::Steering => {
                vessel().is_some_and(|v| v.ship.propulsion.is_some() || v.steers_with_azimuths())
            }
            Gear::Thrusters => vessel().is_some_and(|v| !v.thrusters.is_empty()),
            Gear::AzimuthUnits => vessel().is_some_and(|v| !v.azimuths.is_empty()),
            Gear::Winch => {
                let line = setup.world.lines.get(target);
                line.is_some_and(|line| matches!(line.line.inboard_end, InboardEnd::Winch(_)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_names_of_arguments_are_unique() {
        for (index, order) in OrderName::ALL.iter().enumerate() {
            assert_eq!(*order as usize, index);
            assert_eq!(OrderName::of_word(order.spec().word), Some(*order));
            let names: Vec<_> = order.spec().arguments.iter().map(|a| a.name).collect();
            let mut once = names.clone();
            once.sort_unstable();
            once.dedup();
            assert_eq!(once.len(), names.len(), "{names:?}");
        }
    }

    #[test]
    fn defaults_lie_within_limits() {
        for order in OrderName::ALL {
            for argument in order.spec().arguments {
                if let Absent::Is(value, _) = argument.absent {
                    let [low, high] = order.limits(argument.name);
                    assert!((low..=high).contains(&value), "{order:?} {}", argument.name);
                }
            }
        }
    }
}
