//! Forces of a passing ship on a ship at rest, such as a ship at her berth.
//!
//! The method is the potential flow about slender ships (Wang, Dynamic effects of ship passage on moored vessels,
//! Journal of the Waterways, Harbors and Coastal Engineering Division 101, 1975). In the method, the passing ship is a
//! row of sources along her axis. The strength of the sources follows from the passing ship's speed and from the change
//! of her sectional area. Where the passing ship's flow accelerates the water, it pushes the ship at rest together with
//! the water that she displaces. Across the axis of the ship at rest, the accelerated water also pushes her added mass,
//! which for slender ships is that of a half circle of the same area. The formulas of the paper have the passing speed
//! U, x along the ships, and S' as the slope of a sectional area along x:
//!
//! - surge force X = ρU²/(2π) ∬ S₁'S₂' (x₂−x₁+ξ)/r³,
//! - sway force Y = ρU²η/π ∬ S₁'S₂'/r³,
//! - yaw moment N = ρU²η/π ∬ (S₁'x₁+S₁) S₂'/r³,
//!
//! these formulas hold for parallel ships in deep water, at a distance ξ along and η across, with r² = (x₂−x₁+ξ)²+η².
//! The function [`force`] gives the same flow for ships at any angle. A wall beside a ship under way acts as a mirror:
//! [`force_of_wall`] has the flow of the ship's image.
//!
//! The sources that stand for the ship make no waves, and the flow follows the ships at once. The formulas are
//! therefore for ship speeds well below the speed of long waves in the depth. The method assumes that the ship at rest
//! does not disturb the flow of the passing ship. In model tests the forces of a passing ship grow with U^2.32
//! (Swiegers, Calculation of the forces on a moored ship due to a passing container ship, Stellenbosch 2011).

mod bank;
mod flow;
mod nearest;
mod restricted;
mod sections;
mod setup;

pub use bank::force_of_wall;
pub use flow::{PassingShip, force, force_under_way};
pub use nearest::Nearest;
pub use restricted::{Berth, factors};
pub use sections::{Sections, SectionsError};
pub use setup::{DepthFactors, FlowHull, FlowSetup, HARDLY_SLENDER, NEARLY_CRITICAL, PassingSetup};
