//! The data of an anchor with its chain and windlass that do not change in a run.

use super::error::AnchorError;
use super::windlass::Windlass;
use crate::chain::{ChainGrade, ChainLink, ChainSize};
use crate::constants::STANDARD_GRAVITY_MPS2;
use crate::range::{OutOfRange, within};

/// Length of a shackle of chain (m): 15 fathoms, as is usual today.
pub const SHACKLE_M: f64 = 27.5;

/// Density of the steel of anchor and chain (kg/m³).
const STEEL_KGPM3: f64 = 7850.0;
/// Mass per length of a chain with studs, divided by the square of the diameter of its bar (kg/m³), from Orcina's help.
const STUD_CHAIN_KGPM3: f64 = 21.9e3;
/// Load that the chain's inboard end (bitter end) holds, as a share of the chain's break load; the number is from
/// memory.
const BITTER_END_SHARE: f64 = 0.3;

/// The type of an anchor. The holding power of an anchor depends on its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnchorType {
    /// Ordinary stockless anchor, such as Hall or Spek.
    Stockless,
    /// High-holding-power anchor, such as AC-14.
    HighHoldingPower,
}

impl AnchorType {
    /// Holding power divided by the anchor's weight in air, if the chain lies along the bottom. The sources of the
    /// holding factors are in the documentation of [`super`].
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
    /// Grade of the anchor chain.
    pub chain_grade: ChainGrade,
    /// Length of the chain (m).
    pub chain_length_m: f64,
    /// Holding power of the anchor divided by its weight in air, if the chain lies along the bottom.
    pub holding_factor: f64,
    /// Holding power of the dragging anchor divided by its weight in air.
    pub dragging_factor: f64,
    /// Friction of the chain on the bottom, divided by the chain's weight in water.
    pub chain_friction: f64,
    /// The windlass of the anchor.
    pub windlass: Windlass,
}

impl AnchorGear {
    /// Resistance of a dragging anchor, divided by the anchor's weight in air; the number is from memory (see
    /// [`super`]).
    pub const DRAGGING_FACTOR: f64 = 1.5;
    /// Friction of a chain on the bottom, divided by the chain's weight.
    pub const CHAIN_FRICTION: f64 = 0.75;

    /// The anchor's chain, given by its size.
    #[must_use]
    pub fn chain(&self) -> ChainSize {
        ChainSize {
            diameter_m: self.chain_diameter_m,
            grade: self.chain_grade,
            link: ChainLink::Stud,
        }
    }

    /// Weight of the chain per length in water of the given density (N/m).
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

    /// Weight of the anchor in water of the given density (N).
    #[must_use]
    pub fn anchor_weight_in_water_n(&self, water_kgpm3: f64) -> f64 {
        self.anchor_weight_n() * in_water(water_kgpm3)
    }

    /// Pull at which the chain's inboard end (bitter end) gives way when all chain is out (N).
    #[must_use]
    pub fn bitter_end_n(&self) -> f64 {
        BITTER_END_SHARE * self.chain().break_load_n()
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// Fails at the first number out of its range, and names the anchor.
    pub fn check(&self) -> Result<(), AnchorError> {
        self.check_numbers()
            .map_err(|error| AnchorError::OutOfRange { anchor: self.name.clone(), error })
    }

    fn check_numbers(&self) -> Result<(), OutOfRange> {
        within("mass of the anchor [kg]", self.mass_kg, 10.0, 1e5)?;
        // Above a diameter of 0.3 m the formula gives a break load that falls with the diameter.
        within("diameter of the chain [m]", self.chain_diameter_m, 0.01, 0.25)?;
        within("length of the chain [m]", self.chain_length_m, 1.0, 5e3)?;
        within("holding factor", self.holding_factor, 0.0, 100.0)?;
        within("dragging factor", self.dragging_factor, 0.0, self.holding_factor)?;
        within("friction of the chain", self.chain_friction, 0.0, 5.0)?;
        self.windlass.check()
    }
}

/// Weight of steel in water divided by its weight in air.
fn in_water(water_kgpm3: f64) -> f64 {
    1.0 - water_kgpm3 / STEEL_KGPM3
}
