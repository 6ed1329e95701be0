//! Estimates of the coefficients of a manoeuvring model from main particulars, for ships without model tests or with
//! incomplete tests. Every estimated coefficient is reported with its formula. Particulars outside the range in which
//! the formulas were validated are reported too.
//!
//! | quantity | method | standing |
//! |---|---|---|
//! | added mass | Zhou's regression | found in public programs |
//! | hull under way, effect of the rudder on the hull | [`EstimateMethod`]: Yoshimura & Masumoto (2012) for merchant ships | found in public programs, with the signs that fit KCS and KVLCC2 |
//! | hull of any other vessel | [`EstimateMethod`]: Clarke, Gedling & Hine (1983) with cross-flow drag | found in a public toolbox |
//! | cross-flow drag | Hoerner's midship section | found in a public toolbox |
//! | resistance ahead | total resistance coefficient C_T = 0.004 on the wetted surface by Mumford | *recalled* |
//! | resistance astern | UFC 4-159-03 (`resistance.rs`) | found in a stored copy of the manual |
//! | wake, thrust deduction | wake fraction w = 0.5 Cb − 0.05 (Taylor), thrust deduction t = 0.6 w | found in public programs |
//! | propeller | Wageningen B4-70 | as [`super::Propeller`] |
//! | rudder | lift gradient f_α = 6.13Λ/(2.25 + Λ) for the aspect ratio Λ | found in public programs |
//!
//! `fenderline validate` compares both estimation methods with six ships, measure by measure
//! (`validation/estimated_ships.toml`).

mod clarke;
mod known;
mod method;
mod reported;
mod resistance;
mod stern;
mod yoshimura_masumoto;

use super::added_mass::{AddedMass, zhou_added_mass};
use super::blend::Hull;
use super::error::HydroError;
use super::low_speed::LowSpeedHull;
use super::mmg::{Mmg, Polynomial};
use super::particulars::Particulars;
use super::source::{Figure, Source, Standing};

use self::reported::estimate;
pub use known::{Known, SternCoefficients, SternGear};
pub use method::{EstimateMethod, Ratio, RatioOutOfRange, VALIDATED_RATIOS};

/// The result of an estimate.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimated {
    /// The ship's manoeuvring model.
    pub model: Mmg,
    /// The estimated quantities, and the formula for each.
    pub sources: Vec<Source>,
    /// The method whose formulas were used for hull, propeller or rudder; `None` if all of them are known.
    pub method: Option<EstimateMethod>,
    /// Ratios of the ship that are outside the range in which the formulas were validated.
    pub outside: Vec<RatioOutOfRange>,
}

/// Makes the manoeuvring model of a ship from known data, by the method that suits her particulars.
///
/// # Errors
/// Fails for a number out of range, or for particulars outside the regression of added mass.
pub fn estimated(known: &Known) -> Result<Estimated, HydroError> {
    estimated_by(EstimateMethod::of(&known.particulars), known)
}

/// Makes the manoeuvring model of a ship from known data, by a given method.
///
/// # Errors
/// See [`estimated`].
pub fn estimated_by(method: EstimateMethod, known: &Known) -> Result<Estimated, HydroError> {
    let ship = known.particulars.check()?;
    let mut sources = Vec::new();
    let added_mass = match known.added_mass {
        Some(added_mass) => added_mass,
        None => added_mass(&ship, &mut sources)?,
    };
    let hull = hull(method, known, &ship, &added_mass, &mut sources);
    let propulsion = match &known.gear {
        Some(gear) => Some(stern::propulsion(method, &ship, gear, &mut sources)?),
        None => None,
    };
    let model = Mmg { particulars: ship, added_mass, hull, propulsion }.check()?;
    let hull_is_known = known.polynomial.is_some() || known.low_speed.is_some();
    let stern_is_known = known.gear.as_ref().is_none_or(|gear| stern::is_known(&gear.own));
    let used = (!(hull_is_known && stern_is_known)).then_some(method);
    let outside = used.map_or_else(Vec::new, |method| method.outside(&ship));
    Ok(Estimated { model, sources, method: used, outside })
}

fn added_mass(ship: &Particulars, all: &mut Vec<Source>) -> Result<AddedMass, HydroError> {
    let added = zhou_added_mass(ship)?;
    all.push(estimate(
        "added mass",
        vec![
            Figure::of("m_x/m", added.surge_m3 / ship.volume_m3, ""),
            Figure::of("m_y/m", added.sway_m3 / ship.volume_m3, ""),
            Figure::of("J_z/I_z", added.yaw_m5 / ship.yaw_inertia_m5(), ""),
        ],
        "regression of Zhou, Sheng & Feng on Motora's charts, as in public programs",
        Standing::Found,
    ));
    Ok(added)
}

fn hull(
    method: EstimateMethod,
    known: &Known,
    ship: &Particulars,
    added: &AddedMass,
    all: &mut Vec<Source>,
) -> Hull {
    let hull = match (known.polynomial, known.low_speed) {
        (under_way, Some(low_speed)) => return Hull::deep(under_way, low_speed),
        (Some(polynomial), None) => Hull::from_polynomial(polynomial, ship, added),
        (None, None) => estimated_hull(method, ship, added, all),
    };
    if hull.under_way.is_some() {
        all.push(estimate(
            "hull at low speed",
            linear_figures(&hull.low_speed),
            "linear terms of the ship's polynomial",
            Standing::Derived,
        ));
    }
    if known.polynomial.is_none() {
        all.push(estimate(
            "resistance astern",
            vec![Figure::of("X'₀ astern", hull.low_speed.astern, "")],
            "UFC 4-159-03 (2005), 4-5.2: form drag 0.1 on the midship section, and friction",
            Standing::Found,
        ));
        all.push(estimate(
            "cross-flow drag",
            vec![Figure::of("C_D", hull.low_speed.cross_flow.drag_coefficient, "")],
            "Hoerner's drag of the midship section as in Fossen's MSS toolbox; the yaw rate is \
             used without a factor",
            Standing::Found,
        ));
    }
    hull
}

/// The hull of a ship of which only the particulars are known.
fn estimated_hull(
    method: EstimateMethod,
    ship: &Particulars,
    added: &AddedMass,
    all: &mut Vec<Source>,
) -> Hull {
    let ahead = resistance::ahead(ship);
    let mut hull = match method {
        EstimateMethod::YoshimuraMasumoto => {
            let polynomial = Polynomial::Drift(yoshimura_masumoto::polynomial(ship, added, ahead));
            all.push(estimate(
                "hull under way",
                polynomial_figures(&polynomial),
                "Yoshimura & Masumoto (2012), as in public programs, with the signs that fit the \
                 sets of KCS and KVLCC2",
                Standing::Found,
            ));
            Hull::from_polynomial(polynomial, ship, added)
        }
        EstimateMethod::Clarke => {
            let low_speed = LowSpeedHull::from_linear(&clarke::linear(ship, ahead), ship);
            all.push(estimate(
                "linear hull derivatives",
                linear_figures(&low_speed),
                "Clarke, Gedling & Hine (1983), as in public implementations",
                Standing::Found,
            ));
            Hull::deep(None, low_speed)
        }
    };
    hull.low_speed.astern = resistance::astern(ship);
    all.push(estimate(
        "resistance ahead",
        vec![Figure::of("X'₀ ahead", ahead, "")],
        "C_T = 0.004 on Mumford's wetted surface",
        Standing::Recalled,
    ));
    hull
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

/// Lists the terms of an estimated polynomial, except the resistance.
fn polynomial_figures(polynomial: &Polynomial) -> Vec<Figure> {
    const NAMES: [&str; 16] = [
        "X'ββ",
        "X'βr",
        "X'rr",
        "X'ββββ",
        "Y'β",
        "Y'r",
        "Y'βββ",
        "Y'ββr",
        "Y'βrr",
        "Y'rrr",
        "N'β",
        "N'r",
        "N'βββ",
        "N'ββr",
        "N'βrr",
        "N'rrr",
    ];
    let terms = polynomial.coefficients();
    NAMES.iter().zip(&terms[1..]).map(|(name, term)| Figure::of(name, *term, "")).collect()
}
