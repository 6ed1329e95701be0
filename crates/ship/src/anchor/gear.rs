//! An anchor with its chain and windlass: the constant part.

use super::error::AnchorError;
use super::windlass::Windlass;
use crate::chain::{ChainGrade, ChainLink, ChainSize};
use crate::constants::STANDARD_GRAVITY_MPS2;
use crate::range::{OutOfRange, within};

/// Length of a shackle of chain (m): 15 fathoms, as anchor chain is made today.
pub const SHACKLE_M: f64 = 27.5;

/// Density of the steel of anchor and chain (kg/m³).
const STEEL_KGPM3: f64 = 7850.0;
/// Mass per length of chain with studs over the square of its bar's diameter (kg/m³): Orcina.
const STUD_CHAIN_KGPM3: f64 = 21.9e3;
/// What the bitter end holds over the chain's break load: recalled.
const BITTER_END_SHARE: f64 = 0.3;

/// The type of an anchor, which says how much it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnchorType {
    /// Ordinary stockless anchor, as Hall or Spek.
    Stockless,
    /// High-holding-power anchor, as AC-14.
    HighHoldingPower,
}

impl AnchorType {
    /// Holding power over weight in air, with the chain along the bottom: see [`super`] for the sources.
    #[must_use]
    pub fn holding_factor(self) -> f64 {
        match self {
            AnchorType::Stockless => 3.0,
            AnchorType::HighHoldingPower => 6.0,
        }
    }
}

/// An anchor, its chain and its windlass.
#[derive(Clone, Debug, PartialEq)]
pub struct AnchorGear {
    /// Name, used in messages.
    pub name: String,
    /// Mass of the anchor (kg).
    pub mass_kg: f64,
    /// Diameter of the bar of the chain's links (m).
    pub chain_diameter_m: f64,
    /// Grade of the chain: one of anchor chain.
    pub chain_grade: ChainGrade,
    /// Length of the chain (m).
    pub chain_length_m: f64,
    /// Holding power of the anchor over its weight in air, with the chain along the bottom.
    pub holding_factor: f64,
    /// The same while it drags.
    pub dragging_factor: f64,
    /// Friction of the chain on the bottom over its weight in water.
    pub chain_friction: f64,
    /// Windlass.
    pub windlass: Windlass,
}

impl AnchorGear {
    /// Resistance of a dragging anchor over its weight in air (recalled, see [`super`]).
    pub const DRAGGING_FACTOR: f64 = 1.5;
    /// Friction of chain on the bottom over its weight.
    pub const CHAIN_FRICTION: f64 = 0.75;

    /// The chain by its size.
    #[must_use]
    pub fn chain(&self) -> ChainSize {
        ChainSize {
            diameter_m: self.chain_diameter_m,
            grade: self.chain_grade,
            link: ChainLink::Stud,
        }
    }

    /// Weight of the chain per length in water of a density (N/m).
    #[must_use]
    pub fn chain_weight_npm(&self, water_kgpm3: f64) -> f64 {
        let mass_kgpm = STUD_CHAIN_KGPM3 * self.chain_diameter_m * self.chain_diameter_m;
        mass_kgpm * STANDARD_GRAVITY_MPS2 * in_water(water_kgpm3)
    }

    /// Weight of the anchor in air (N).
    #[must_use]
    pub fn anchor_weight_n(&self) -> f64 {
        self.mass_kg * STANDARD_GRAVITY_MPS2
    }

    /// Weight of the anchor in water of a density (N).
    #[must_use]
    pub fn anchor_weight_in_water_n(&self, water_kgpm3: f64) -> f64 {
        self.anchor_weight_n() * in_water(water_kgpm3)
    }

    /// Pull at which the bitter end gives way when all chain is out (N).
    #[must_use]
    pub fn bitter_end_n(&self) -> f64 {
        BITTER_END_SHARE * self.chain().break_load_n()
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// The first out of its range, with the name of the anchor.
    pub fn check(&self) -> Result<(), AnchorError> {
        self.check_numbers()
            .map_err(|error| AnchorError::OutOfRange { anchor: self.name.clone(), error })
    }

    fn check_numbers(&self) -> Result<(), OutOfRange> {
        within("mass of the anchor [kg]", self.mass_kg, 10.0, 1e5)?;
        // Beyond 0.3 m the formula of the break load falls with the diameter.
        within("diameter of the chain [m]", self.chain_diameter_m, 0.01, 0.25)?;
        within("length of the chain [m]", self.chain_length_m, 1.0, 5e3)?;
        within("holding factor", self.holding_factor, 0.0, 100.0)?;
        within("dragging factor", self.dragging_factor, 0.0, self.holding_factor)?;
        within("friction of the chain", self.chain_friction, 0.0, 5.0)?;
        self.windlass.check()
    }
}

/// Weight in water over weight in air.
fn in_water(water_kgpm3: f64) -> f64 {
    1.0 - water_kgpm3 / STEEL_KGPM3
}
