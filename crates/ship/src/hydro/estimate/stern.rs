//! Estimates of propeller and rudder behind the hull: known coefficients are used, and a method's formulas for the
//! unknown ones.

use fenderline_contact::number::{greater, lesser};

use super::known::{SternCoefficients, SternGear};
use super::method::EstimateMethod;
use super::reported::estimate;
use super::yoshimura_masumoto;
use crate::hydro::error::{HydroError, within};
use crate::hydro::mmg::{Propulsion, Wake};
use crate::hydro::particulars::Particulars;
use crate::hydro::propeller::{Propeller, Series};
use crate::hydro::rudder::Rudder;
use crate::hydro::source::{Figure, Source, Standing};

/// Thrust deduction astern. With this thrust deduction, the propeller series of pitch ratio 0.8, whose thrust astern at
/// bollard is −0.255 ρn²D⁴, gives a force on the ship of −0.175 ρn²D⁴. Miyauchi et al. (2022) have this force for Esso
/// Osaka (pitch ratio 0.715).
const DEDUCTION_ASTERN: f64 = 0.314;

/// Position x'_P of the propeller if it is not known.
const PROPELLER_PLACE: f64 = -0.48;

/// The estimation method's values for the wake in a turn.
struct WakeChange {
    rate: f64,
    limit: f64,
    source: (&'static str, Standing),
}

impl WakeChange {
    /// With the rudder hard over, the propeller leaves the wake: C₂ = 1/(1 − w₀) removes all of the wake. The change of
    /// the wake in a turn is known for two ships: KVLCC2 loses 65 % of the wake (mean of both sides, C₁ 2.0), and Esso
    /// Osaka 111 % (C₁ 1.4). A ship whose wake is known, but not its change in a turn, has a set of coefficients that
    /// was derived without such a change.
    fn by(method: EstimateMethod, own_wake: Option<f64>, wake: f64) -> WakeChange {
        match method {
            EstimateMethod::YoshimuraMasumoto if own_wake.is_none() => WakeChange {
                rate: 2.0,
                limit: 1.0 / (1.0 - wake),
                source: (
                    "in a turn the propeller comes out of the wake, which falls to nothing, as it does \
                     by w = w₀ exp(−4 β_P²) in a public program (nikpau/mmgdynamics); how fast it \
                     falls (C₁) is KVLCC2's",
                    Standing::Derived,
                ),
            },
            _ => WakeChange {
                rate: 0.0,
                limit: 1.0,
                source: ("as straight ahead", Standing::Assumed),
            },
        }
    }
}

/// The estimation method's values for the interaction of rudder, propeller race and hull.
struct Interaction {
    wake_ratio: f64,
    race_gain: f64,
    straightening: [f64; 2],
    straightening_place: f64,
    resistance_deduction: f64,
    hull_gain: f64,
    hull_place: f64,
    source: (&'static str, Standing),
}

impl Interaction {
    fn by(method: EstimateMethod, ship: &Particulars, wake: f64) -> Interaction {
        match method {
            EstimateMethod::YoshimuraMasumoto => {
                let wake_ratio = yoshimura_masumoto::wake_ratio(wake);
                Interaction {
                    wake_ratio,
                    race_gain: yoshimura_masumoto::race_gain(wake_ratio),
                    straightening: [yoshimura_masumoto::straightening(ship); 2],
                    straightening_place: yoshimura_masumoto::STRAIGHTENING_PLACE,
                    resistance_deduction: yoshimura_masumoto::RESISTANCE_DEDUCTION,
                    hull_gain: yoshimura_masumoto::hull_gain(ship),
                    hull_place: yoshimura_masumoto::HULL_PLACE,
                    source: ("Yoshimura & Masumoto (2012), as in public programs", Standing::Found),
                }
            }
            EstimateMethod::Clarke => Interaction {
                wake_ratio: 1.0,
                race_gain: 0.5,
                straightening: [0.4, 0.5],
                straightening_place: -0.7,
                resistance_deduction: 0.3,
                hull_gain: 0.3,
                hull_place: -0.45,
                source: ("as usual for full ships", Standing::Recalled),
            },
        }
    }
}

/// True if every coefficient that depends on the estimation method is known.
pub(super) fn is_known(own: &SternCoefficients) -> bool {
    let numbers = [
        own.wake_ratio,
        own.race_gain,
        own.straightening_place,
        own.resistance_deduction,
        own.hull_gain,
        own.hull_place,
    ];
    own.straightening.is_some() && numbers.iter().all(Option::is_some)
}

/// Collects the reports of estimated numbers.
struct Missing<'a> {
    all: &'a mut Vec<Source>,
}

impl Missing<'_> {
    /// Returns the known number of a coefficient; if there is none, the number by the formula, which is then reported.
    fn number(
        &mut self,
        known: Option<f64>,
        (group, symbol): (&str, &str),
        formula: f64,
        (source, standing): (&str, Standing),
    ) -> f64 {
        known.unwrap_or_else(|| {
            let figures = vec![Figure::of(symbol, formula, "")];
            self.all.push(estimate(group, figures, source, standing));
            formula
        })
    }
}

/// Propeller and rudder. The reports of estimated numbers are appended to `all`.
///
/// # Errors
/// Fails if the propeller's diameter or the rudder's area is out of range for the size of the ship.
pub(super) fn propulsion(
    method: EstimateMethod,
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
        all.push(estimate(
            "propeller, and its torque",
            figures,
            "Wageningen B4-70, Roddy et al. (2006), from a public transcription",
            Standing::Found,
        ));
    } else {
        all.push(estimate(
            "propeller outside its first quadrant, and its torque",
            Vec::new(),
            "Wageningen B4-70 of the nearest pitch, Roddy et al. (2006), from a public transcription",
            Standing::Found,
        ));
    }
    let mut missing = Missing { all };
    let taylor = greater(0.5 * ship.block_coefficient() - 0.05, 0.05);
    let wake = missing.number(
        own.wake,
        ("wake", "w"),
        taylor,
        ("w = 0.5 Cb − 0.05, Taylor, as in public programs", Standing::Found),
    );
    let usual = Interaction::by(method, ship, wake);
    let by = usual.source;
    let astern = match own.thrust_deduction {
        None => (0.6 * wake, ("as ahead", Standing::Assumed)),
        Some(_) => (
            DEDUCTION_ASTERN,
            (
                "Esso Osaka's force astern at bollard, divided by the thrust of the series",
                Standing::Derived,
            ),
        ),
    };
    let thrust_deduction = missing.number(
        own.thrust_deduction,
        ("thrust deduction", "t"),
        0.6 * wake,
        ("t = 0.6 w, as in public programs", Standing::Found),
    );
    let thrust_deduction_astern = missing.number(
        own.thrust_deduction_astern,
        ("thrust deduction astern", "t"),
        astern.0,
        astern.1,
    );
    let (rate, limits) = own.wake_change.unwrap_or_else(|| {
        let WakeChange { rate, limit, source: (source, standing) } =
            WakeChange::by(method, own.wake, wake);
        let figures = vec![Figure::of("C₁", rate, ""), Figure::of("C₂", limit, "")];
        missing.all.push(estimate("wake in a turn", figures, source, standing));
        (rate, [limit; 2])
    });
    let fujii = 6.13 * gear.aspect_ratio / (2.25 + gear.aspect_ratio);
    let rudder = Rudder {
        area_m2: gear.rudder_m2,
        lift_gradient: missing.number(
            own.lift_gradient,
            ("lift gradient of the rudder", "f_α"),
            fujii,
            ("6.13 Λ/(2.25 + Λ), Fujii, as in public programs", Standing::Found),
        ),
        propeller_to_span: lesser(gear.propeller_to_span, 1.0),
        wake_ratio: missing.number(
            own.wake_ratio,
            ("wake at the rudder", "ε"),
            usual.wake_ratio,
            by,
        ),
        race_gain: missing.number(own.race_gain, ("race at the rudder", "κ"), usual.race_gain, by),
        straightening: own.straightening.unwrap_or_else(|| {
            let [below, above] = usual.straightening;
            let figures =
                vec![Figure::of("γ_R", below, ""), Figure::of("γ_R (β_R > 0)", above, "")];
            missing.all.push(estimate("flow straightening", figures, by.0, by.1));
            usual.straightening
        }),
        straightening_place: missing.number(
            own.straightening_place,
            ("flow straightening", "l'_R"),
            usual.straightening_place,
            by,
        ),
        resistance_deduction: missing.number(
            own.resistance_deduction,
            ("steering resistance", "t_R"),
            usual.resistance_deduction,
            by,
        ),
        hull_gain: missing.number(own.hull_gain, ("rudder and hull", "a_H"), usual.hull_gain, by),
        hull_place: missing.number(
            own.hull_place,
            ("rudder and hull", "x'_H"),
            usual.hull_place,
            by,
        ),
        place: missing.number(
            own.rudder_place,
            ("place of the rudder", "x'_R"),
            -0.5,
            ("at the after perpendicular", Standing::Assumed),
        ),
    };
    // The position of the propeller matters only if the wake changes in a turn.
    let place = if rate == 0.0 {
        own.propeller_place.unwrap_or(PROPELLER_PLACE)
    } else {
        missing.number(
            own.propeller_place,
            ("place of the propeller", "x'_P"),
            PROPELLER_PLACE,
            ("as usual for full ships", Standing::Recalled),
        )
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
