//! A body: its outline and its mass.

use alloc::string::String;

use crate::model::outline::Outline;
use crate::model::pile::Pile;

/// Mass and inertia of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mobility {
    /// A fixed body, such as a quay: infinite mass.
    Fixed,
    /// A floating body with the same mass in all directions.
    Free {
        /// Displacement plus the smallest added mass (§3.1 of the paper) (kg).
        mass_kg: f64,
        /// Moment of inertia about the vertical through the centre of gravity (kg·m²).
        yaw_inertia_kgm2: f64,
    },
    /// A floating body with its full mass matrix, for the coupled method. The paper's method uses the smaller of the
    /// masses in surge and sway for all directions.
    FullMatrix {
        /// Matrix of rigid-body and added mass for surge, sway and yaw, about the centre of gravity, symmetric (kg,
        /// kg·m, kg·m²).
        matrix: [[f64; 3]; 3],
    },
    /// A floating body whose mass differs between surge and sway. If the engine moves the body, the engine adds the
    /// Coriolis and centripetal terms (Kirchhoff's equations, with the Munk moment), and the host's loads must not
    /// contain them. In all other respects the body is treated as with [`Mobility::FullMatrix`].
    SurgeSway {
        /// Displacement and added mass in surge (kg).
        surge_kg: f64,
        /// Displacement and added mass in sway (kg).
        sway_kg: f64,
        /// Moment of inertia about the vertical, added mass included (kg·m²).
        yaw_inertia_kgm2: f64,
    },
    /// A body on a pile, such as a flexible dolphin. A body on a pile does not turn, and the pile's spring pulls the
    /// body back to its place. Only the engine moves bodies on piles, by the coupled method.
    OnPile {
        /// Mass that moves with the top of the pile (kg).
        mass_kg: f64,
        /// The pile.
        pile: Pile,
    },
}

impl Mobility {
    /// The mass matrix of the body for surge, sway and yaw (kg, kg·m, kg·m²). Returns `None` for a fixed body, and for
    /// a body on a pile, which does not turn.
    #[must_use]
    pub fn matrix(&self) -> Option<[[f64; 3]; 3]> {
        let diagonal = |surge, sway, yaw| [[surge, 0.0, 0.0], [0.0, sway, 0.0], [0.0, 0.0, yaw]];
        match *self {
            Mobility::Fixed | Mobility::OnPile { .. } => None,
            Mobility::Free { mass_kg, yaw_inertia_kgm2 } => {
                Some(diagonal(mass_kg, mass_kg, yaw_inertia_kgm2))
            }
            Mobility::FullMatrix { matrix } => Some(matrix),
            Mobility::SurgeSway { surge_kg, sway_kg, yaw_inertia_kgm2 } => {
                Some(diagonal(surge_kg, sway_kg, yaw_inertia_kgm2))
            }
        }
    }
}

/// A body: a ship, a tug, a quay.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name, used in errors.
    pub name: String,
    /// Key of the body, unique in a model. Sums run and snapshots are written in the order of the keys, so the order in
    /// which bodies are added does not matter.
    pub key: u64,
    /// Outline in the frame of the body, whose origin is the centre of gravity.
    pub outline: Outline,
    /// Mass and inertia.
    pub mobility: Mobility,
}
