//! The data of a vessel for the simulation, relative to midship and in SI units.

use fenderline_contact::Vec2;
use fenderline_sim::environment::wind::ShipWindage;
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::vessels::{Origin, Vessel};
use fenderline_sim::hydro::{LowSpeedHull, Mmg, Polynomial, SternCoefficients};
use fenderline_sim::{AzimuthSetup, ThrusterSetup};

/// A vessel of the library, with all data that do not depend on the scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct VesselData {
    /// Key of the vessel.
    pub name: String,
    /// Name of the vessel in reports, and the source of every number.
    pub origin: Origin,
    /// True if the vessel is a model in a tank of fresh water.
    pub is_model: bool,
    /// Length of the model on which the resistance in `ship` was measured (m), if known.
    pub resistance_of_model_m: Option<f64>,
    /// Length overall (m), if known.
    pub length_overall_m: Option<f64>,
    /// Manoeuvring model of the vessel in deep water.
    pub ship: Mmg,
    /// Speed at which the vessel's standard manoeuvres begin (m/s), if known.
    pub approach_mps: Option<f64>,
    /// Rudder of the vessel, amidships, with its rate and its stop.
    pub rudder: RateLimited,
    /// Shaft of the vessel, if she has a propeller.
    pub shaft: Option<Shaft>,
    /// Tunnel thrusters of the vessel, in the order of the file.
    pub thrusters: Vec<ThrusterSetup>,
    /// Azimuth units of the vessel, in the order of the file.
    pub azimuths: Vec<AzimuthSetup>,
    /// Wind areas of the vessel, if known.
    pub windage: Option<ShipWindage>,
    /// Data of the vessel for heave, roll and pitch, if known.
    pub stability: Option<Stability>,
    /// Vertices of the vessel's outline, forward and to starboard of midship (m), if known.
    pub outline_m: Option<Vec<Vec2>>,
    /// Places where mooring lines leave the vessel.
    pub chocks: Vec<DeckPoint>,
    /// Places where lines of other vessels are made fast.
    pub bitts: Vec<DeckPoint>,
    /// Strips along the vessel on which a fender may lie.
    pub beltings: Vec<Belting>,
    /// Hydrodynamic coefficients that a geometrically similar vessel may use.
    pub(crate) coefficients: Coefficients,
}

/// A propeller's shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    /// Full revolutions (1/s).
    pub full_rps: f64,
    /// Time in which the shaft goes from full ahead to full astern (s).
    pub reversal_s: f64,
}

/// Data of a vessel for heave, roll and pitch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Metacentric height GM (m).
    pub gm_m: f64,
    /// Height KG of the centre of gravity above the keel (m).
    pub gravity_above_keel_m: f64,
    /// Waterplane area (m²).
    pub waterplane_m2: f64,
}

/// A chock or a pair of bitts.
#[derive(Clone, Debug, PartialEq)]
pub struct DeckPoint {
    /// Name of the point, unique among points of its kind on the vessel.
    pub name: String,
    /// Place of the chock or bitts, forward and to starboard of midship (m).
    pub at_m: Vec2,
    /// Height of the chock or bitts above the still water, at the vessel's draught (m).
    pub above_water_m: f64,
}

/// A straight strip of belting along the vessel, which faces away from midship.
#[derive(Clone, Debug, PartialEq)]
pub struct Belting {
    /// Name of the strip, unique on the vessel.
    pub name: String,
    /// Middle of the strip, forward and to starboard of midship (m).
    pub middle_m: Vec2,
    /// Direction in which the strip faces: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Length of the strip (m).
    pub width_m: f64,
    /// Height of the strip's middle above the still water, at the vessel's draught (m).
    pub above_water_m: f64,
    /// Vertical extent of the strip (m).
    pub extent_m: f64,
}

/// Hydrodynamic coefficients of a vessel, without dimension.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Coefficients {
    pub(crate) added_mass: Option<AddedMassForm>,
    pub(crate) polynomial: Option<Polynomial>,
    pub(crate) low_speed: Option<LowSpeedHull>,
    pub(crate) stern: SternCoefficients,
}

/// Added mass of a vessel, in one of the forms in which it is published.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum AddedMassForm {
    /// The coefficients m'x, m'y and J'z.
    Coefficients([f64; 3]),
    /// The values m_x, m_y and J_z divided by the density of the water (m³, m³, m⁵), and the length and draught of the
    /// ship for which they hold (m).
    Volumes([f64; 3], [f64; 2]),
}

impl VesselData {
    /// The data of the vessel that the program needs to simulate her standard manoeuvres.
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
