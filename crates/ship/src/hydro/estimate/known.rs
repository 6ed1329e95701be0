//! Known data of a ship, the input of an estimate.

use crate::hydro::added_mass::AddedMass;
use crate::hydro::low_speed::LowSpeedHull;
use crate::hydro::mmg::Polynomial;
use crate::hydro::particulars::Particulars;
use crate::hydro::propeller::Series;

/// Known data of a ship; data that are to be estimated are `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Main particulars.
    pub particulars: Particulars,
    /// Added mass.
    pub added_mass: Option<AddedMass>,
    /// Hull polynomial under way.
    pub polynomial: Option<Polynomial>,
    /// Hull at low speed.
    pub low_speed: Option<LowSpeedHull>,
    /// Propeller and rudder of the ship; `None` if she has none.
    pub gear: Option<SternGear>,
}

/// Data of a propeller and its rudder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SternGear {
    /// Diameter of the propeller (m).
    pub propeller_m: f64,
    /// Movable area of the rudder (m²).
    pub rudder_m2: f64,
    /// Diameter of the propeller divided by the span of the rudder. A ratio of propeller diameter to rudder span above
    /// 1 counts as 1.
    pub propeller_to_span: f64,
    /// Square of the rudder's span divided by its area; needed if [`SternCoefficients::lift_gradient`] is not known.
    pub aspect_ratio: f64,
    /// Measured coefficients.
    pub own: SternCoefficients,
}

/// Coefficients of a propeller and its rudder behind the hull, named as in
/// [`Propulsion`](crate::hydro::mmg::Propulsion), [`Wake`](crate::hydro::mmg::Wake) and
/// [`Rudder`](crate::hydro::rudder::Rudder).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SternCoefficients {
    /// Coefficients of the thrust polynomial K_T = k₀ + k₁J + k₂J².
    pub thrust_polynomial: Option<[f64; 3]>,
    /// Propeller series for conditions that the thrust polynomial does not cover.
    pub series: Option<Series>,
    /// Thrust deduction t_P.
    pub thrust_deduction: Option<f64>,
    /// Thrust deduction t_P of the propeller for thrust astern.
    pub thrust_deduction_astern: Option<f64>,
    /// Wake fraction w₀ of a ship that goes straight ahead.
    pub wake: Option<f64>,
    /// Change of the wake in a turn: the coefficient C₁, and C₂ for an inflow angle β_P below and above 0.
    pub wake_change: Option<(f64, [f64; 2])>,
    /// Position x'_P of the propeller, used in its inflow angle β_P.
    pub propeller_place: Option<f64>,
    /// Lift gradient f_α of the rudder.
    pub lift_gradient: Option<f64>,
    /// Wake ratio ε.
    pub wake_ratio: Option<f64>,
    /// Share κ of the propeller race's speed that reaches the rudder.
    pub race_gain: Option<f64>,
    /// Flow straightening coefficient γ_R for a rudder inflow angle β_R below and above 0.
    pub straightening: Option<[f64; 2]>,
    /// Effective position l'_R of the rudder, used in its inflow angle β_R.
    pub straightening_place: Option<f64>,
    /// Steering resistance deduction t_R.
    pub resistance_deduction: Option<f64>,
    /// Ratio a_H of the lateral force on the hull due to steering to that of the rudder.
    pub hull_gain: Option<f64>,
    /// Position x'_H of the lateral force on the hull due to steering.
    pub hull_place: Option<f64>,
    /// Position x'_R of the rudder, divided by the ship's length.
    pub rudder_place: Option<f64>,
}

impl SternCoefficients {
    /// Returns these coefficients, where the coefficients of `other` replace those that are `None`.
    #[must_use]
    pub fn or(self, other: SternCoefficients) -> SternCoefficients {
        SternCoefficients {
            thrust_polynomial: self.thrust_polynomial.or(other.thrust_polynomial),
            series: self.series.or(other.series),
            thrust_deduction: self.thrust_deduction.or(other.thrust_deduction),
            thrust_deduction_astern: self.thrust_deduction_astern.or(other.thrust_deduction_astern),
            wake: self.wake.or(other.wake),
            wake_change: self.wake_change.or(other.wake_change),
            propeller_place: self.propeller_place.or(other.propeller_place),
            lift_gradient: self.lift_gradient.or(other.lift_gradient),
            wake_ratio: self.wake_ratio.or(other.wake_ratio),
            race_gain: self.race_gain.or(other.race_gain),
            straightening: self.straightening.or(other.straightening),
            straightening_place: self.straightening_place.or(other.straightening_place),
            resistance_deduction: self.resistance_deduction.or(other.resistance_deduction),
            hull_gain: self.hull_gain.or(other.hull_gain),
            hull_place: self.hull_place.or(other.hull_place),
            rudder_place: self.rudder_place.or(other.rudder_place),
        }
    }
}
