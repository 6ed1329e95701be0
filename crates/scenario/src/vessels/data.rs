//! The data of a vessel for the simulation, about midship and in SI.

use fenderline_contact::Vec2;
use fenderline_sim::environment::wind::ShipWindage;
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::vessels::{Origin, Vessel};
use fenderline_sim::hydro::{LowSpeedHull, Mmg, Polynomial, SternCoefficients};
use fenderline_sim::{AzimuthSetup, ThrusterSetup};

/// A vessel of the library: everything that does not depend on the scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct VesselData {
    /// Key of the vessel.
    pub name: String,
    /// Name of the vessel in reports, and the source of every number.
    pub origin: Origin,
    /// A model in a tank of fresh water.
    pub is_model: bool,
    /// Length of the model on which the resistance in `ship` was measured (m), if known.
    pub resistance_of_model_m: Option<f64>,
    /// Length overall (m), if known.
    pub length_overall_m: Option<f64>,
    /// Manoeuvring model of the vessel in deep water.
    pub ship: Mmg,
    /// Speed at which standard manoeuvres begin (m/s).
    pub approach_mps: Option<f64>,
    /// Rudder amidships, with its rate and stop.
    pub rudder: RateLimited,
    /// Shaft of the vessel, if she has a propeller.
    pub shaft: Option<Shaft>,
    /// Tunnel thrusters, in the order of the file.
    pub thrusters: Vec<ThrusterSetup>,
    /// Azimuth units, in the order of the file.
    pub azimuths: Vec<AzimuthSetup>,
    /// Wind areas.
    pub windage: Option<ShipWindage>,
    /// Data for heave, roll and pitch.
    pub stability: Option<Stability>,
    /// Outline of the vessel, forward and to starboard of midship (m).
    pub outline_m: Option<Vec<Vec2>>,
    /// Places where lines leave the vessel.
    pub chocks: Vec<DeckPoint>,
    /// Places where lines of other vessels are made fast.
    pub bitts: Vec<DeckPoint>,
    /// Strips on which a fender may lie.
    pub beltings: Vec<Belting>,
    /// Coefficients that a geometrically similar vessel may use.
    pub(crate) coefficients: Coefficients,
}

/// A propeller's shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    /// Full revolutions (1/s).
    pub full_rps: f64,
    /// Time from full ahead to full astern (s).
    pub reversal_s: f64,
}

/// Data for heave, roll and pitch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Metacentric height GM (m).
    pub gm_m: f64,
    /// Centre of gravity above the keel KG (m).
    pub gravity_above_keel_m: f64,
    /// Waterplane area (m²).
    pub waterplane_m2: f64,
}

/// A chock or a pair of bitts.
#[derive(Clone, Debug, PartialEq)]
pub struct DeckPoint {
    /// Name of the point, unique among points of its kind on the vessel.
    pub name: String,
    /// Forward and to starboard of midship (m).
    pub at_m: Vec2,
    /// Height above the still water at the vessel's draught (m).
    pub above_water_m: f64,
}

/// A straight strip of belting, facing away from midship.
#[derive(Clone, Debug, PartialEq)]
pub struct Belting {
    /// Unique on the vessel.
    pub name: String,
    /// Middle of the strip, forward and to starboard of midship (m).
    pub middle_m: Vec2,
    /// Direction in which the strip faces: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Length of the strip (m).
    pub width_m: f64,
    /// Middle of the strip above the still water at her draught (m).
    pub above_water_m: f64,
    /// Its extent up and down (m).
    pub extent_m: f64,
}

/// Coefficients without dimension.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Coefficients {
    pub(crate) added_mass: Option<AddedMassForm>,
    pub(crate) polynomial: Option<Polynomial>,
    pub(crate) low_speed: Option<LowSpeedHull>,
    pub(crate) stern: SternCoefficients,
}

/// Added mass as published.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum AddedMassForm {
    /// m'x, m'y and J'z.
    Coefficients([f64; 3]),
    /// m_x, m_y and J_z over the density (m³, m³, m⁵), of a ship of this length and draught (m).
    Volumes([f64; 3], [f64; 2]),
}

impl VesselData {
    /// The vessel for standard manoeuvres.
    #[must_use]
    pub fn trial(&self) -> Vessel {
        Vessel {
            origin: self.origin.clone(),
            ship: self.ship,
            approach_mps: self.approach_mps,
            steering: self.rudder,
            is_model: self.is_model,
            resistance_of_model_m: self.resistance_of_model_m,
        }
    }
}
