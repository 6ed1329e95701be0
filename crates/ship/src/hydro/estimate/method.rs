//! The methods that estimate a ship's coefficients, and the range of particulars in which the methods were validated.

use crate::hydro::particulars::Particulars;

/// A set of formulas for hull, propeller and rudder of a ship.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EstimateMethod {
    /// The whole set of regressions of Yoshimura & Masumoto (2012) for merchant ships.
    YoshimuraMasumoto,
    /// The method of linear derivatives by Clarke, Gedling & Hine (1983) with cross-flow drag. The method for hulls
    /// outside the regressions for merchant ships: tugs, barges, workboats.
    Clarke,
}

/// Smallest ratios L/B and B/d of a merchant ship. Below L/B 4 or B/d 1 the polynomials would be used far outside the
/// range of ships from which they were derived, and some terms would change their sign.
const MERCHANT_SHIP: [(Ratio, f64); 2] =
    [(Ratio::LengthOverBeam, 4.0), (Ratio::BeamOverDraught, 1.0)];

/// The range of ratios in which the estimate was validated: the particulars of KCS, KVLCC2, Esso Osaka, the S175, the
/// Mariner and a tanker of 190 000 dwt (Cb 0.56 to 0.83, L/B 5.5 to 7.1, B/d 2.4 to 3.1), rounded outwards. The range
/// that the authors of the regressions give could not be read.
pub const VALIDATED_RATIOS: [(Ratio, [f64; 2]); 3] = [
    (Ratio::BlockCoefficient, [0.55, 0.85]),
    (Ratio::LengthOverBeam, [5.3, 7.3]),
    (Ratio::BeamOverDraught, [2.2, 3.3]),
];

/// A ratio of main particulars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ratio {
    /// Block coefficient Cb.
    BlockCoefficient,
    /// Length over beam, L/B.
    LengthOverBeam,
    /// Beam over draught, B/d.
    BeamOverDraught,
}

impl Ratio {
    /// The value of the ratio for a ship.
    #[must_use]
    pub fn of(self, ship: &Particulars) -> f64 {
        match self {
            Ratio::BlockCoefficient => ship.block_coefficient(),
            Ratio::LengthOverBeam => ship.length_m / ship.beam_m,
            Ratio::BeamOverDraught => ship.beam_m / ship.draught_m,
        }
    }

    /// Name of the ratio, with the keys of the particulars in vessel files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Ratio::BlockCoefficient => "block_coefficient",
            Ratio::LengthOverBeam => "length_bp over beam",
            Ratio::BeamOverDraught => "beam over draught",
        }
    }
}

/// A ratio outside the range in which the estimate was validated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RatioOutOfRange {
    /// The ratio.
    pub ratio: Ratio,
    /// Value of the ratio.
    pub value: f64,
    /// The validated range of the ratio, both ends included.
    pub range: [f64; 2],
    /// The method used.
    pub method: EstimateMethod,
}

impl core::fmt::Display for RatioOutOfRange {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let RatioOutOfRange { ratio, value, range: [low, high], method } = self;
        write!(
            f,
            "{} is {value:.3}, outside {low} to {high}, the range in which the formulas for her manoeuvring were \
             validated; ",
            ratio.name()
        )?;
        f.write_str(match method {
            EstimateMethod::YoshimuraMasumoto => {
                "the formulas are used nevertheless, and the error of their results is not known"
            }
            EstimateMethod::Clarke => {
                "the ship is not a merchant ship: linear derivatives and cross-flow drag are used \
                 instead, and the error of their results is not known"
            }
        })
    }
}

impl EstimateMethod {
    /// Chooses the estimation method for a ship of the given particulars.
    #[must_use]
    pub fn of(ship: &Particulars) -> EstimateMethod {
        let is_merchant_ship = MERCHANT_SHIP.iter().all(|(ratio, least)| ratio.of(ship) >= *least);
        if is_merchant_ship { EstimateMethod::YoshimuraMasumoto } else { EstimateMethod::Clarke }
    }

    /// The ratios of a ship that are outside the validated range.
    #[must_use]
    pub fn outside(self, ship: &Particulars) -> Vec<RatioOutOfRange> {
        VALIDATED_RATIOS
            .iter()
            .map(|(ratio, range)| RatioOutOfRange {
                ratio: *ratio,
                value: ratio.of(ship),
                range: *range,
                method: self,
            })
            .filter(|RatioOutOfRange { value, range: [low, high], .. }| {
                !(*low..=*high).contains(value)
            })
            .collect()
    }
}
