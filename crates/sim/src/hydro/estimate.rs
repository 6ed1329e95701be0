//! What a manoeuvring model lacks, estimated from main particulars: for ships without tests of their own, or
//! with tests of a part. Every estimate is told with its formula, to be shown as such.
//!
//! | what | by | standing |
//! |---|---|---|
//! | added mass | Zhou's regression | *recalled* |
//! | linear derivatives | Clarke, Gedling & Hine (1983) | found in public implementations; KVLCC2's come out within 30 % |
//! | cross-flow drag | Hoerner's midship section | *recalled* |
//! | resistance | C_T = 0.004 on Mumford's wetted surface; astern as Esso Osaka | *recalled* |
//! | wake, thrust deduction | w = 0.5 Cb − 0.05 (Taylor), t = 0.6 w | *recalled* |
//! | propeller | Wageningen B4-70 | as [`super::Propeller`] |
//! | rudder and hull | f_α = 6.13Λ/(2.25 + Λ), interaction as of full ships | *recalled* |

use std::f64::consts::PI;

use super::added_mass::{AddedMass, zhou_added_mass};
use super::blend::Hull;
use super::error::{HydroError, within};
use super::low_speed::{CrossFlow, LowSpeedHull, hoerner_drag_coefficient};
use super::mmg::{Mmg, Polynomial, Propulsion, Wake};
use super::particulars::Particulars;
use super::propeller::{Propeller, Series};
use super::rudder::Rudder;
use super::vessels::{Figure, Source, Standing};

/// What is known of a ship.
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
    /// Propeller and rudder; without them she has none.
    pub gear: Option<SternGear>,
}

/// What must be known of a propeller and its rudder, and what may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SternGear {
    /// Diameter of the propeller [m].
    pub propeller_m: f64,
    /// Movable area of the rudder [m²].
    pub rudder_m2: f64,
    /// Diameter of the propeller over span of the rudder; at most 1 counts.
    pub propeller_to_span: f64,
    /// Span² over area of the rudder; needed where [`SternCoefficients::lift_gradient`] is not known.
    pub aspect_ratio: f64,
    /// What was measured.
    pub own: SternCoefficients,
}

/// What may be known of a propeller and its rudder behind the hull; named as in [`Propulsion`], [`Wake`] and
/// [`Rudder`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SternCoefficients {
    /// K_T = k₀ + k₁J + k₂J².
    pub thrust_polynomial: Option<[f64; 3]>,
    /// The series for what the polynomial does not cover.
    pub series: Option<Series>,
    /// t_P.
    pub thrust_deduction: Option<f64>,
    /// t_P of thrust astern.
    pub thrust_deduction_astern: Option<f64>,
    /// w₀.
    pub wake: Option<f64>,
    /// C₁, and C₂ for β_P below and above 0.
    pub wake_change: Option<(f64, [f64; 2])>,
    /// x'_P.
    pub propeller_place: Option<f64>,
    /// f_α.
    pub lift_gradient: Option<f64>,
    /// ε.
    pub wake_ratio: Option<f64>,
    /// κ.
    pub race_gain: Option<f64>,
    /// γ_R for β_R below and above 0.
    pub straightening: Option<[f64; 2]>,
    /// l'_R.
    pub straightening_place: Option<f64>,
    /// t_R.
    pub resistance_deduction: Option<f64>,
    /// a_H.
    pub hull_gain: Option<f64>,
    /// x'_H.
    pub hull_place: Option<f64>,
    /// x'_R.
    pub rudder_place: Option<f64>,
}

impl SternCoefficients {
    /// These, and the other's where these say nothing.
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

/// Total resistance coefficient on the wetted surface.
const TOTAL_RESISTANCE: f64 = 0.004;
/// Resistance astern over ahead: Esso Osaka's.
const ASTERN_OVER_AHEAD: f64 = 0.0319 / 0.0214;
/// Thrust deduction astern with which the series of pitch 0.8, −0.255 at bollard, gives the −0.175 ρn²D⁴
/// that Miyauchi et al. (2022) have for Esso Osaka (pitch 0.715) by the design sheet.
const DEDUCTION_ASTERN: f64 = 0.314;

/// The model of a ship from what is known of her, and what had to be estimated.
///
/// # Errors
/// Numbers that no ship has, or particulars for which the regressions do not hold.
pub fn estimated(known: &Known) -> Result<(Mmg, Vec<Source>), HydroError> {
    let ship = known.particulars.check()?;
    let mut told = Vec::new();
    let added_mass = match known.added_mass {
        Some(added_mass) => added_mass,
        None => added_mass(&ship, &mut told)?,
    };
    let hull = hull(known, &ship, &added_mass, &mut told);
    let propulsion = match &known.gear {
        Some(gear) => Some(propulsion(&ship, gear, &mut told)?),
        None => None,
    };
    let model = Mmg { particulars: ship, added_mass, hull, propulsion }.check()?;
    Ok((model, told))
}

fn told(group: &str, figures: Vec<Figure>, source: &str, standing: Standing) -> Source {
    Source {
        group: group.to_owned(),
        figures,
        source: source.to_owned(),
        standing,
        is_estimate: true,
    }
}

fn added_mass(ship: &Particulars, all: &mut Vec<Source>) -> Result<AddedMass, HydroError> {
    let added = zhou_added_mass(ship)?;
    all.push(told(
        "added mass",
        vec![
            Figure::of("m_x/m", added.surge_m3 / ship.volume_m3, ""),
            Figure::of("m_y/m", added.sway_m3 / ship.volume_m3, ""),
            Figure::of("J_z/I_z", added.yaw_m5 / ship.yaw_inertia_m5(), ""),
        ],
        "regression of Zhou, Sheng & Feng on Motora's charts",
        Standing::Recalled,
    ));
    Ok(added)
}

fn hull(known: &Known, ship: &Particulars, added: &AddedMass, all: &mut Vec<Source>) -> Hull {
    let (under_way, low_speed) = match (known.polynomial, known.low_speed) {
        (under_way, Some(low_speed)) => return Hull { under_way, low_speed },
        (Some(polynomial), None) => {
            let hull = Hull::from_polynomial(polynomial, ship, added);
            all.push(told(
                "hull at low speed",
                linear_figures(&hull.low_speed),
                "linear terms of her polynomial",
                Standing::Derived,
            ));
            (hull.under_way, hull.low_speed)
        }
        (None, None) => {
            let low_speed = low_speed(ship);
            all.push(told(
                "linear hull derivatives",
                linear_figures(&low_speed),
                "Clarke, Gedling & Hine (1983), as in public implementations",
                Standing::Found,
            ));
            all.push(told(
                "resistance ahead",
                vec![Figure::of("X'₀ ahead", low_speed.ahead, "")],
                "C_T = 0.004 on Mumford's wetted surface",
                Standing::Recalled,
            ));
            (None, low_speed)
        }
    };
    all.push(told(
        "resistance astern",
        vec![Figure::of("X'₀ astern", low_speed.astern, "")],
        "astern over ahead as of Esso Osaka, Miyauchi et al. (2022)",
        Standing::Assumed,
    ));
    all.push(told(
        "cross-flow drag",
        vec![Figure::of("C_D", low_speed.cross_flow.drag_coefficient, "")],
        "Hoerner's drag of the midship section as in Fossen's MSS toolbox; the yaw rate counts as it is",
        Standing::Recalled,
    ));
    Hull { under_way, low_speed }
}

fn linear_figures(hull: &LowSpeedHull) -> Vec<Figure> {
    vec![
        Figure::of("X'vr", hull.surge_vr, ""),
        Figure::of("Y'v", hull.sway_v, ""),
        Figure::of("Y'r", hull.sway_r, ""),
        Figure::of("N'v", hull.yaw_v, ""),
        Figure::of("N'r", hull.yaw_r, ""),
    ]
}

fn low_speed(ship: &Particulars) -> LowSpeedHull {
    let (length_m, beam_m, draught_m) = (ship.length_m, ship.beam_m, ship.draught_m);
    let block = ship.block_coefficient();
    let slender = draught_m / length_m;
    // Clarke's coefficients are over ½ρL²; ours over ½ρLd.
    let unit = PI * slender * slender * length_m / draught_m;
    let (broad, thick) = (beam_m / draught_m, beam_m / length_m);
    let wetted_m2 = 1.7 * length_m * draught_m + ship.volume_m3 / draught_m;
    let ahead = -TOTAL_RESISTANCE * wetted_m2 / (length_m * draught_m);
    LowSpeedHull {
        ahead,
        astern: ahead * ASTERN_OVER_AHEAD,
        surge_vr: 0.0,
        sway_v: -unit * (1.0 + 0.40 * block * broad),
        sway_r: -unit * (-0.5 + 2.2 * thick - 0.080 * broad),
        yaw_v: -unit * (0.5 + 2.4 * slender),
        yaw_r: -unit * (0.25 + 0.039 * broad - 0.56 * thick),
        cross_flow: CrossFlow {
            drag_coefficient: hoerner_drag_coefficient(beam_m, draught_m),
            yaw_gain_force: 1.0,
            yaw_gain_moment: 1.0,
        },
    }
}

/// Takes what is known, and collects what had to be assumed in its place.
struct Missing<'a> {
    all: &'a mut Vec<Source>,
}

impl Missing<'_> {
    /// A known number, or the formula's.
    fn number(
        &mut self,
        known: Option<f64>,
        (group, symbol): (&str, &str),
        formula: f64,
        (source, standing): (&str, Standing),
    ) -> f64 {
        known.unwrap_or_else(|| {
            let figures = vec![Figure::of(symbol, formula, "")];
            self.all.push(told(group, figures, source, standing));
            formula
        })
    }
}

fn propulsion(
    ship: &Particulars,
    gear: &SternGear,
    all: &mut Vec<Source>,
) -> Result<Propulsion, HydroError> {
    within("diameter of the propeller [m]", gear.propeller_m, 0.01, ship.length_m)?;
    within("area of the rudder [m²]", gear.rudder_m2, 1e-4, ship.length_m * ship.draught_m)?;
    let own = &gear.own;
    if own.thrust_polynomial.is_none() || own.series.is_none() {
        let pitch = Figure { name: "pitch ratio".to_owned(), text: "0.8".to_owned() };
        let figures = if own.series.is_none() { vec![pitch] } else { Vec::new() };
        all.push(told(
            "propeller, and its torque",
            figures,
            "Wageningen B4-70, Roddy et al. (2006), from a transcription",
            Standing::Recalled,
        ));
    } else {
        all.push(told(
            "propeller outside its first quadrant, and its torque",
            Vec::new(),
            "Wageningen B4-70 of the nearest pitch, Roddy et al. (2006), from a transcription",
            Standing::Recalled,
        ));
    }
    let mut missing = Missing { all };
    let taylor = (0.5 * ship.block_coefficient() - 0.05).max(0.05);
    let as_full = ("as usual of full ships", Standing::Recalled);
    let wake = missing.number(
        own.wake,
        ("wake", "w"),
        taylor,
        ("w = 0.5 Cb − 0.05, Taylor", Standing::Recalled),
    );
    let astern = match own.thrust_deduction {
        None => (0.6 * wake, ("as ahead", Standing::Assumed)),
        Some(_) => (
            DEDUCTION_ASTERN,
            ("Esso Osaka's force astern at bollard over the series' thrust", Standing::Derived),
        ),
    };
    let thrust_deduction = missing.number(
        own.thrust_deduction,
        ("thrust deduction", "t"),
        0.6 * wake,
        ("t = 0.6 w", Standing::Recalled),
    );
    let thrust_deduction_astern = missing.number(
        own.thrust_deduction_astern,
        ("thrust deduction astern", "t"),
        astern.0,
        astern.1,
    );
    let (rate, limits) = own.wake_change.unwrap_or_else(|| {
        let figures = vec![Figure::of("C₁", 0.0, "")];
        missing.all.push(told("wake in a turn", figures, "as straight ahead", Standing::Assumed));
        (0.0, [1.0, 1.0])
    });
    let fujii = 6.13 * gear.aspect_ratio / (2.25 + gear.aspect_ratio);
    let rudder = Rudder {
        area_m2: gear.rudder_m2,
        lift_gradient: missing.number(
            own.lift_gradient,
            ("lift gradient of the rudder", "f_α"),
            fujii,
            ("6.13 Λ/(2.25 + Λ), Fujii", Standing::Recalled),
        ),
        propeller_to_span: gear.propeller_to_span.min(1.0),
        wake_ratio: missing.number(own.wake_ratio, ("wake at the rudder", "ε"), 1.0, as_full),
        race_gain: missing.number(own.race_gain, ("race at the rudder", "κ"), 0.5, as_full),
        straightening: own.straightening.unwrap_or_else(|| {
            let figures = vec![Figure::of("γ_R", 0.4, ""), Figure::of("γ_R (β_R > 0)", 0.5, "")];
            missing.all.push(told("flow straightening", figures, as_full.0, as_full.1));
            [0.4, 0.5]
        }),
        straightening_place: missing.number(
            own.straightening_place,
            ("flow straightening", "l'_R"),
            -0.7,
            as_full,
        ),
        resistance_deduction: missing.number(
            own.resistance_deduction,
            ("steering resistance", "t_R"),
            0.3,
            as_full,
        ),
        hull_gain: missing.number(own.hull_gain, ("rudder and hull", "a_H"), 0.3, as_full),
        hull_place: missing.number(own.hull_place, ("rudder and hull", "x'_H"), -0.45, as_full),
        place: missing.number(
            own.rudder_place,
            ("place of the rudder", "x'_R"),
            -0.5,
            ("at the after perpendicular", Standing::Assumed),
        ),
    };
    // It matters only where the wake changes in a turn.
    let place = match own.wake_change {
        None => own.propeller_place.unwrap_or(-0.48),
        Some(_) => {
            missing.number(own.propeller_place, ("place of the propeller", "x'_P"), -0.48, as_full)
        }
    };
    Ok(Propulsion {
        propeller: Propeller {
            diameter_m: gear.propeller_m,
            thrust_polynomial: own.thrust_polynomial,
            series: own.series.unwrap_or(Series::B4Pitch08),
        },
        thrust_deduction,
        thrust_deduction_astern,
        wake: Wake { straight: wake, rate, limits, place },
        rudder,
    })
}
