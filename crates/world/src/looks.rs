//! What the pages' view out of the window needs and no force depends on: the type of a ship, the place of her bridge, rain,
//! and where and when the run is, for the sun.

use std::sync::Arc;

use fenderline_contact::Vec2;

use crate::chart::GeographicPlace;

/// The type of a ship, by which the view draws deck, house and cargo.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShipType {
    /// A ship with hatch covers: a bulk carrier or a general cargo ship.
    Bulk,
    /// A tanker or gas carrier.
    Tanker,
    /// A container ship.
    Container,
    /// A ferry or car carrier.
    RoRo,
    /// A passenger ship.
    Passenger,
    /// A tug.
    Tug,
}

impl ShipType {
    /// Every type.
    pub const ALL: [ShipType; 6] = [
        ShipType::Bulk,
        ShipType::Tanker,
        ShipType::Container,
        ShipType::RoRo,
        ShipType::Passenger,
        ShipType::Tug,
    ];

    /// The word of the type in scenarios and messages.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            ShipType::Bulk => "bulk",
            ShipType::Tanker => "tanker",
            ShipType::Container => "container",
            ShipType::RoRo => "ro-ro",
            ShipType::Passenger => "passenger",
            ShipType::Tug => "tug",
        }
    }
}

/// The place from which a ship is conned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conning {
    /// Place forward and to starboard of midship (m).
    pub at_m: Vec2,
    /// Height of the eye above the still water (m).
    pub eye_above_water_m: f64,
}

/// A model of a ship for the view, in place of the hull and the deck that the view draws: a binary glTF file (`.glb`).
/// Lengths of the model are metres, its y axis points up, its z axis points ahead, and its origin is amidships on the
/// waterline at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct ShipModel {
    /// Name of the file, as the scenario gives the name.
    pub file: String,
    /// Content of the file.
    pub bytes: Arc<[u8]>,
}

/// How the view shows a ship. No force depends on the looks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Looks {
    /// The type of the ship; `None`: the view takes the type from the words of the ship's title.
    pub ship_type: Option<ShipType>,
    /// The place from which the ship is conned; `None`: the view takes a usual place for the type.
    pub conning: Option<Conning>,
    /// The model of the ship; `None`: the view draws the ship by type and size.
    pub model: Option<ShipModel>,
}

/// Rain in the view. No force and no visibility depends on the rain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rain {
    /// Light rain, of some 2 mm in an hour.
    Light,
    /// Moderate rain, of some 5 mm in an hour.
    Moderate,
    /// Heavy rain, of 10 mm in an hour or more.
    Heavy,
}

impl Rain {
    /// Every rain.
    pub const ALL: [Rain; 3] = [Rain::Light, Rain::Moderate, Rain::Heavy];

    /// The word of the rain in scenarios and messages.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Rain::Light => "light",
            Rain::Moderate => "moderate",
            Rain::Heavy => "heavy",
        }
    }
}

/// Where and when a run begins, for the place of the sun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Daylight {
    /// Time at the start of the run: seconds since the start of 1970, universal time.
    pub start_unix_s: f64,
    /// Place of the scenario's origin on the earth.
    pub place: GeographicPlace,
}
