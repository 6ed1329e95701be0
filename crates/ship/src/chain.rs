//! Break load and stiffness of a chain, from the diameter of its bar.
//!
//! For anchor chain of grades 1 to 3, the break load is c d² (44 − 0.08 d) kN with the bar's diameter d in mm (IACS UR
//! W18; the factors c were compared with a maker's table, see the test). For short-link chain of grades 30 to 80, the
//! grade is a tenth of the stress at the break load in N/mm², over both bars of a link (National Association of Chain
//! Manufacturers, Welded Steel Chain Specifications, 2010, annex A).
//!
//! Stiffness of a chain: EA = 0.854e8 d² kN without studs and 1.01e8 d² kN with studs, with d in m (Orcina, OrcaFlex
//! help, "Chain: Axial and bending stiffness", from catalogue data). A short-link chain is somewhat stiffer than this
//! formula says.

use core::f64::consts::PI;

/// Grade of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChainGrade {
    /// Anchor chain, grade 1.
    U1,
    /// Anchor chain, grade 2.
    U2,
    /// Anchor chain, grade 3.
    U3,
    /// Short-link chain, grade 30.
    G30,
    /// Short-link chain, grade 40.
    G40,
    /// Short-link chain, grade 80.
    G80,
}

/// Form of the links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChainLink {
    /// Without studs.
    Open,
    /// With studs.
    Stud,
}

/// Size, grade and links of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainSize {
    /// Diameter of the bar of the chain's links (m).
    pub diameter_m: f64,
    /// Grade.
    pub grade: ChainGrade,
    /// Form of the links.
    pub link: ChainLink,
}

/// The number of a grade of chain from which its break load follows.
enum Strength {
    /// Factor c in the break load of anchor chain (kN/mm²).
    Anchor(f64),
    /// Stress at the break load of a short-link chain, over both bars of a link (N/m²).
    Stress(f64),
}

impl ChainGrade {
    fn strength(self) -> Strength {
        match self {
            ChainGrade::U1 => Strength::Anchor(9.81e-3),
            ChainGrade::U2 => Strength::Anchor(13.73e-3),
            ChainGrade::U3 => Strength::Anchor(19.61e-3),
            ChainGrade::G30 => Strength::Stress(300e6),
            ChainGrade::G40 => Strength::Stress(400e6),
            ChainGrade::G80 => Strength::Stress(800e6),
        }
    }

    /// Whether this grade is one of short-link chain, which has no studs.
    #[must_use]
    pub fn is_short_link(self) -> bool {
        matches!(self.strength(), Strength::Stress(_))
    }
}

impl ChainSize {
    /// Break load of the chain: tension at which it parts (N).
    #[must_use]
    pub fn break_load_n(&self) -> f64 {
        match self.grade.strength() {
            Strength::Anchor(factor) => {
                let d_mm = 1e3 * self.diameter_m;
                1e3 * factor * d_mm * d_mm * (44.0 - 0.08 * d_mm)
            }
            Strength::Stress(stress_npm2) => {
                stress_npm2 * 0.5 * PI * self.diameter_m * self.diameter_m
            }
        }
    }

    /// Stiffness of a chain of the given length: tension divided by elongation (N/m).
    #[must_use]
    pub fn stiffness_npm(&self, length_m: f64) -> f64 {
        let per_square_npm2 = match self.link {
            ChainLink::Open => 0.854e11,
            ChainLink::Stud => 1.01e11,
        };
        per_square_npm2 * self.diameter_m * self.diameter_m / length_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn load_kn(diameter_m: f64, grade: ChainGrade) -> f64 {
        1e-3 * ChainSize { diameter_m, grade, link: ChainLink::Open }.break_load_n()
    }

    /// Stud-link anchor chain of Atlantic Group, break test in pounds. The results agree within 1 %, the rounding of
    /// the table.
    #[test]
    fn anchor_chain_breaks_as_in_a_makers_table() {
        const KN_PER_LBF: f64 = 4.448_221_615e-3;
        for (inches, pounds) in [
            (1.0, [59_700.0, 83_600.0, 119_500.0]),
            (1.25, [92_200.0, 129_000.0, 184_000.0]),
            (1.5, [131_000.0, 183_500.0, 262_000.0]),
            (1.875, [201_000.0, 281_000.0, 402_000.0]),
        ] {
            for (grade, pounds) in
                [ChainGrade::U1, ChainGrade::U2, ChainGrade::U3].iter().zip(pounds)
            {
                let (got, wanted) = (load_kn(0.0254 * inches, *grade), KN_PER_LBF * pounds);
                assert!(
                    (got / wanted - 1.0).abs() < 0.01,
                    "{inches} {grade:?}: {got} for {wanted}"
                );
            }
        }
    }

    /// Short-link chain to DIN 766 and ISO 4565 in a table of Cox Engineering, in kN. The table rounds to whole numbers
    /// and more: the results agree within 4 %.
    #[test]
    fn short_link_chain_breaks_as_in_a_table() {
        for (grade, mm, kn) in [
            (ChainGrade::G30, 8.0, 30.0),
            (ChainGrade::G30, 12.0, 70.0),
            (ChainGrade::G40, 8.0, 40.0),
            (ChainGrade::G40, 10.0, 62.0),
            (ChainGrade::G40, 12.0, 90.0),
        ] {
            let got = load_kn(1e-3 * mm, grade);
            assert!((got / kn - 1.0).abs() < 0.04, "{grade:?} {mm}: {got} for {kn}");
        }
    }

    /// By hand: 0.854e8 times 0.03² is 76,860 kN, and 2 m of this chain have 38.43 MN/m. With studs it is 90,900 kN.
    #[test]
    fn a_longer_chain_is_softer() {
        let chain = ChainSize { diameter_m: 0.03, grade: ChainGrade::U2, link: ChainLink::Open };
        assert!((chain.stiffness_npm(2.0) - 38.43e6).abs() < 1.0);
        let chain = ChainSize { link: ChainLink::Stud, ..chain };
        assert!((chain.stiffness_npm(1.0) - 90.9e6).abs() < 1.0);
    }
}
