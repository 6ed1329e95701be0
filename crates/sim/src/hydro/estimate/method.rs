//! Which formulas estimate a ship, and the particulars within which they were held against ships.

use crate::hydro::particulars::Particulars;

/// The formulas by which hull, propeller and rudder of a ship are estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EstimateMethod {
    /// The whole set of regressions of Yoshimura & Masumoto (2012) for merchant ships.
    YoshimuraMasumoto,
    /// Linear derivatives of Clarke, Gedling & Hine (1983) with cross-flow drag. For hulls to which the regressions
    /// of merchant ships say nothing: tugs, barges, workboats.
    Clarke,
}

/// The stubbiest and the deepest hull that is taken for a merchant ship: below L/B 4 or B/d 1 the polynomials would be
/// asked far outside every ship they were made from, where single terms change their sign.
const MERCHANT_SHIP: [(Ratio, f64); 2] =
    [(Ratio::LengthOverBeam, 4.0), (Ratio::BeamOverDraught, 1.0)];

/// Within which the estimate was held against ships: the particulars of KCS, KVLCC2, Esso Osaka, the S175, the Mariner and a
/// tanker of 190 000 dwt (Cb 0.56 to 0.83, L/B 5.5 to 7.1, B/d 2.4 to 3.1), rounded outwards. The regressions' own
/// range could not be read.
pub const VALIDATED_RATIOS: [(Ratio, [f64; 2]); 3] = [
    (Ratio::BlockCoefficient, [0.55, 0.85]),
    (Ratio::LengthOverBeam, [5.3, 7.3]),
    (Ratio::BeamOverDraught, [2.2, 3.3]),
];

/// A ratio of main particulars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ratio {
    /// Cb.
    BlockCoefficient,
    /// L/B.
    LengthOverBeam,
    /// B/d.
    BeamOverDraught,
}

impl Ratio {
    /// Of a ship.
    #[must_use]
    pub fn of(self, ship: &Particulars) -> f64 {
        match self {
            Ratio::BlockCoefficient => ship.block_coefficient(),
            Ratio::LengthOverBeam => ship.length_m / ship.beam_m,
            Ratio::BeamOverDraught => ship.beam_m / ship.draught_m,
        }
    }

    /// In words, by the names that the particulars have in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Ratio::BlockCoefficient => "block_coefficient",
            Ratio::LengthOverBeam => "length_bp over beam",
            Ratio::BeamOverDraught => "beam over draught",
        }
    }
}

/// A ratio of a ship outside the range in which her estimate was held against ships.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RatioOutOfRange {
    /// Which.
    pub ratio: Ratio,
    /// Hers.
    pub value: f64,
    /// The range, both ends included.
    pub range: [f64; 2],
    /// By which formulas she is estimated all the same.
    pub method: EstimateMethod,
}

impl core::fmt::Display for RatioOutOfRange {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let RatioOutOfRange { ratio, value, range: [low, high], method } = self;
        write!(
            f,
            "{} is {value:.3}, outside {low} to {high}, within which the formulas that estimate her manoeuvring were \
             held against ships; ",
            ratio.name()
        )?;
        f.write_str(match method {
            EstimateMethod::YoshimuraMasumoto => "they are used all the same, and their error is not known",
            EstimateMethod::Clarke => {
                "she is no merchant ship: linear derivatives and cross-flow drag are used instead, and their error \
                 is not known"
            }
        })
    }
}

impl EstimateMethod {
    /// The one for a ship of these particulars.
    #[must_use]
    pub fn of(ship: &Particulars) -> EstimateMethod {
        let is_merchant_ship = MERCHANT_SHIP.iter().all(|(ratio, least)| ratio.of(ship) >= *least);
        if is_merchant_ship { EstimateMethod::YoshimuraMasumoto } else { EstimateMethod::Clarke }
    }

    /// Every ratio of a ship that is outside the range.
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
