//! A simulated berthing, compared with the berthing formulas.

use fenderline_ship::hydro::shallow::{PUBLISHED_RATIO, SHALLOWEST_RATIO};
use fenderline_world::berthing::AddedMass;

/// The first contact of the ship with fenders: energies by the formulas, and energies of the simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct BerthingOutcome {
    /// Start of the step in which the ship first touches a fender (s).
    pub first_touch_s: f64,
    /// The fenders that the ship meets together, by their index in [`fenderline_world::setup::Setup::fenders`]. These fenders are the
    /// first fender touched, and the fenders touched before the first is compressed by a tenth of its rated deflection
    /// (or of its projection, if it has no rating).
    pub fenders: Vec<usize>,
    /// Speed of the ship's centre of gravity square to the face of the fender, relative to the body that carries the
    /// fender (m/s). If another ship carries the fender, this speed is the closing speed of the two hulls at the
    /// contact.
    pub speed_mps: f64,
    /// Design speed square to the berth (m/s), [`fenderline_world::berthing::BerthingSetup::design_speed_mps`]. If a
    /// design speed is given, the formula uses the design speed instead of the speed of the run. On the way to the
    /// first touch, drag slows the ship, and wind or a tug may make her faster.
    pub design_speed_mps: Option<f64>,
    /// Berthing angle (rad): the angle between the ship's centre line and the fender's face, positive if her bow points
    /// towards the face.
    pub angle_rad: f64,
    /// Point of contact along the hull from the centre of gravity, positive forward (m). For one fender the point of
    /// contact is the middle of the fender's face. For several fenders the point of contact is the point nearest to the
    /// centre of gravity on the stretch of hull that the fenders cover. If this stretch includes the centre of gravity,
    /// the point of contact is at 0, and a ship that comes parallel to the berth loses all her energy: Ce = 1. (A body
    /// that is stopped dead at several points that can only push gets its final impulse from the nearest point alone,
    /// or from points on both sides of its centre of gravity.)
    pub along_m: f64,
    /// M, the ship's displacement without added mass (kg). If another ship carries the fender, M is the reduced mass of
    /// the two displacements, M₁M₂/(M₁ + M₂).
    pub displacement_kg: f64,
    /// The ship that carries the fender; `None` if the fender is on no other ship.
    pub other: Option<OtherShip>,
    /// Added mass coefficient Cm by each formula, in the order of
    /// [`fenderline_world::berthing::AddedMassFormula::ALL`]; `None` if the formula does not apply to the ship.
    pub added_mass: [Option<f64>; 4],
    /// The source of the added mass coefficient Cm in `energy_j`: a formula, or a value of the user.
    pub chosen: AddedMass,
    /// The added mass coefficient Cm in `energy_j`.
    pub chosen_added_mass: f64,
    /// The ship's mass normal to the fender's face in the simulation, added mass included, divided by her displacement.
    pub added_mass_simulated: f64,
    /// The parts of `added_mass_simulated`.
    pub added_sway: AddedSway,
    /// K, the ship's radius of gyration by the formula (m).
    pub gyradius_m: f64,
    /// K, the ship's radius of gyration in the simulation, added mass included (m).
    pub gyradius_simulated_m: f64,
    /// Eccentricity coefficient Ce, computed with the formula's radius of gyration.
    pub eccentricity: f64,
    /// Eccentricity coefficient Ce, computed with the simulation's radius of gyration.
    pub eccentricity_of_run: f64,
    /// Cs.
    pub softness: f64,
    /// Cc.
    pub configuration: f64,
    /// Berthing energy ½ M V² Cm Ce Cs Cc (J) with the chosen Cm, and with the design speed if one is given.
    pub energy_j: f64,
    /// Berthing energy by the formula of `energy_j`, but with the speed that the ship has in the run at the first touch (J).
    pub energy_at_touch_j: f64,
    /// Berthing energy by the formula of `energy_j`, but with the Cm of each added mass formula in turn (J).
    pub energies_j: [Option<f64>; 4],
    /// Abnormal berthing energy (J): `energy_j` times the abnormal berthing factor.
    pub abnormal_energy_j: Option<f64>,
    /// The ship's kinetic energy normal to the fender's face at the first touch in the simulation, ½ M Cm V² (J).
    pub kinetic_j: f64,
    /// Largest energy that the ship's fenders together absorbed during the first hit (J), hysteresis losses included.
    /// The hit lasts from the first touch until the fenders store less than half of the largest energy that they
    /// stored. Work that other loads did on the ship during the hit is included.
    pub fender_energy_j: f64,
    /// Largest energy that bent the piles of the flexible dolphins that the ship touched during the first hit (J); 0
    /// without such dolphins.
    pub pile_energy_j: f64,
    /// Eccentricity coefficient Ce of the simulation: the sum of `fender_energy_j` and `pile_energy_j`, divided by
    /// `kinetic_j`.
    pub eccentricity_measured: f64,
    /// End of the step in which the first hit was over (s); `None` while the hit lasts.
    pub first_hit_until_s: Option<f64>,
    /// The hit after the first one in which the fenders absorbed the most energy: the ship swings in, or the loads
    /// bring her back. `None` if there was no later hit.
    pub later: Option<LaterHit>,
}

/// The ship's added mass in sway in the run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AddedSway {
    /// The ship's added mass in sway in deep water, divided by her displacement. For a body whose added mass is given
    /// directly, this is the given added mass.
    pub deep: f64,
    /// The factor on `deep` for the depth of water at the start of the run. `None` in deep water, and for a body whose
    /// added mass is given directly.
    pub shallow: Option<ShallowFactor>,
}

/// The ship that carries the fender, if another ship berths on the fender.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OtherShip {
    /// Her displacement (kg).
    pub displacement_kg: f64,
    /// The mass of this ship normal to the fender's face in the simulation, added mass included, divided by her
    /// displacement.
    pub added_mass: f64,
}

/// The factor by which shallow water raises the ship's added mass in sway.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShallowFactor {
    /// The factor.
    pub factor: f64,
    /// Depth of the water, divided by the ship's draught.
    pub depth_over_draught: f64,
}

/// A hit of the ship on her fenders after the first hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaterHit {
    /// Number of the hit in the run: 2 for the second hit. Hits in which the fenders absorb less than a twentieth of
    /// the kinetic energy at the first touch are not counted.
    pub number: u32,
    /// Start of the step in which the hit began (s).
    pub from_s: f64,
    /// End of the step in which the hit was over (s); `None` while the hit lasts.
    pub until_s: Option<f64>,
    /// Largest energy that the ship's fenders together absorbed during the later hit (J), computed as for the first
    /// hit.
    pub energy_j: f64,
    /// Start of the step in which the fenders had absorbed the most energy (s).
    pub at_s: f64,
}

/// Smallest relative difference at which both energies are shown: the energy by the design speed, and the energy by the
/// speed at the first touch.
const ENERGIES_DIFFER: f64 = 0.01;

impl BerthingOutcome {
    /// The speed in the formula of `energy_j` (m/s): the design speed, or else the speed at the first touch.
    #[must_use]
    pub fn formula_speed_mps(&self) -> f64 {
        self.design_speed_mps.unwrap_or(self.speed_mps.abs())
    }

    /// Returns true if the energy by the speed at the first touch differs so much from the energy by the design speed
    /// that a reader must see both.
    #[must_use]
    pub fn energies_differ(&self) -> bool {
        let difference_j = (self.energy_at_touch_j - self.energy_j).abs();
        difference_j > ENERGIES_DIFFER * self.energy_j
    }

    /// Says in words why the speed at the first touch is not the design speed.
    #[must_use]
    pub fn why_speeds_differ(&self) -> &'static str {
        if self.speed_mps.abs() < self.formula_speed_mps() {
            "water and loads slowed the ship on her way to the fender"
        } else {
            "wind or other loads made the ship faster on her way to the fender"
        }
    }

    /// Says in one sentence of which parts the Cm of the run consists.
    #[must_use]
    pub fn mass_of_run(&self) -> String {
        let AddedSway { deep, shallow } = self.added_sway;
        let added = 1.0 + deep * shallow.map_or(1.0, |shallow| shallow.factor);
        let mut text = format!("Cm {:.2} of the run: ", self.added_mass_simulated);
        if let Some(other) = self.other {
            text += &format!(
                "reduced mass of the two ships with added mass, divided by the reduced mass of their displacements; \
                 Cm of the other ship alone {:.2}; Cm of this ship alone {added:.2}, ",
                other.added_mass
            );
        }
        text += &match shallow {
            Some(ShallowFactor { factor, depth_over_draught }) => format!(
                "1 + {deep:.2} × {factor:.2}, her added mass in sway in deep water over her displacement, times the factor for \
                 water of {depth_over_draught:.2} draughts{}",
                if depth_over_draught < SHALLOWEST_RATIO {
                    " (the factor for 1.1 draughts is used, because no formula covers less water; from 1.2 to 1.1 \
                     draughts the factor is our extrapolation, because published tests end at 1.2)"
                } else if depth_over_draught < PUBLISHED_RATIO {
                    " (the factor is our extrapolation, because published tests end at 1.2 draughts)"
                } else {
                    ""
                }
            ),
            None => format!("1 + {deep:.2}, her added mass in sway over her displacement"),
        };
        let is_less = self.added_mass_simulated < added - 0.005;
        if self.other.is_none() && is_less {
            let angle_deg = self.angle_rad.to_degrees().abs();
            text += &format!(
                "; at {angle_deg:.1}° to the face a little less, because she also moves along it"
            );
        }
        text
    }

    /// Says in one sentence why the Cm of the run differs from the Cm of the formula.
    #[must_use]
    pub fn why_masses_differ(&self) -> &'static str {
        if self.added_sway.shallow.is_some() {
            "in the run the ship moves the water beside and under her, and the mass of this water grows as the \
             under-keel clearance shrinks: a tanker model in water of 1.2 draughts had 2.9 times her deep-water added \
             mass; PIANC's Cm is a design value between 1.5 and 1.8"
        } else {
            "the run has the added mass of the ship in the scenario, whatever the clearance; the Cm of the formula is a design value \
             from draught, beam and clearance"
        }
    }

    /// The number of the hit that lasts at the time `t_s` (s): 1 for the first hit. `None` if the time lies neither in
    /// the first hit nor in the largest later hit.
    #[must_use]
    pub fn hit_at(&self, t_s: f64) -> Option<u32> {
        let is_before = |until_s: Option<f64>| until_s.is_none_or(|until_s| t_s < until_s);
        if t_s >= self.first_touch_s && is_before(self.first_hit_until_s) {
            return Some(1);
        }
        let later = self.later.filter(|later| t_s >= later.from_s && is_before(later.until_s));
        later.map(|later| later.number)
    }
}
