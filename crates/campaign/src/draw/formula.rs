//! Formulas that the user writes. Formulas are computed with the functions of `libm`, so that a campaign has the same
//! bits on every platform.

use exmex::prelude::*;
use exmex::{
    BinOp, MakeOperators, MatchLiteral, Operator, literal_matcher_from_pattern, ops_factory,
};
use fenderline_contact::number::{greater, lesser};

/// The value of a comparison: 1 if the comparison holds, else 0; not a number if one of the two compared values is not
/// a number.
fn truth(a: f64, b: f64, holds: bool) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { f64::from(u8::from(holds)) }
}

ops_factory!(
    Operators,
    f64,
    Operator::make_bin("^", BinOp { apply: libm::pow, prio: 5, is_commutative: false }),
    Operator::make_bin("/", BinOp { apply: |a, b| a / b, prio: 4, is_commutative: false }),
    Operator::make_bin("*", BinOp { apply: |a, b| a * b, prio: 3, is_commutative: true }),
    Operator::make_bin_unary(
        "-",
        BinOp { apply: |a, b| a - b, prio: 2, is_commutative: false },
        |a| -a
    ),
    Operator::make_bin_unary(
        "+",
        BinOp { apply: |a, b| a + b, prio: 1, is_commutative: true },
        |a| a
    ),
    Operator::make_bin(
        "<=",
        BinOp { apply: |a, b| truth(a, b, a <= b), prio: 0, is_commutative: false }
    ),
    Operator::make_bin(
        ">=",
        BinOp { apply: |a, b| truth(a, b, a >= b), prio: 0, is_commutative: false }
    ),
    Operator::make_bin(
        "<",
        BinOp { apply: |a, b| truth(a, b, a < b), prio: 0, is_commutative: false }
    ),
    Operator::make_bin(
        ">",
        BinOp { apply: |a, b| truth(a, b, a > b), prio: 0, is_commutative: false }
    ),
    Operator::make_bin("min", BinOp { apply: lesser, prio: 1, is_commutative: true }),
    Operator::make_bin("max", BinOp { apply: greater, prio: 1, is_commutative: true }),
    Operator::make_unary("sqrt", libm::sqrt),
    Operator::make_unary("abs", libm::fabs),
    Operator::make_unary("floor", libm::floor),
    Operator::make_unary("exp", libm::exp),
    Operator::make_unary("ln", libm::log),
    Operator::make_unary("log10", libm::log10),
    Operator::make_unary("sin", libm::sin),
    Operator::make_unary("cos", libm::cos),
    Operator::make_unary("tan", libm::tan),
    Operator::make_unary("atan", libm::atan),
    Operator::make_constant("PI", core::f64::consts::PI)
);

// Numbers as TOML has them: 3, 0.5, .5, 2.5e6.
literal_matcher_from_pattern!(Numbers, r"^([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?");

/// A formula in which names stand for numbers.
#[derive(Clone, Debug)]
pub struct Formula {
    expression: FlatEx<f64, Operators, Numbers>,
    names: Vec<String>,
}

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// Gives the reason why the text is not a formula.
    pub fn parse(text: &str) -> Result<Formula, String> {
        let expression = FlatEx::<f64, Operators, Numbers>::parse(text)
            .map_err(|error| format!("\"{text}\": {error}"))?;
        let names = expression.var_names().to_vec();
        Ok(Formula { expression, names })
    }

    /// The names of the formula's numbers, in the order in which [`Formula::value`] takes them.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The formula's value; not a number if one of its numbers is not a number, or if the formula has no value, such as
    /// the root of a negative number.
    ///
    /// # Panics
    /// Panics if there is not one number for each name.
    #[must_use]
    pub fn value(&self, numbers: &[f64]) -> f64 {
        self.expression.eval(numbers).expect("a number for each name")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str, numbers: &[f64]) -> f64 {
        Formula::parse(text).expect("a formula").value(numbers)
    }

    #[test]
    fn values_by_hand() {
        assert_eq!(value("1 + 2 * 3", &[]), 7.0);
        assert_eq!(value("2 - 3 - 4", &[]), -5.0);
        assert_eq!(value("8 / 4 / 2", &[]), 1.0);
        assert_eq!(value("8 / 4 * 2", &[]), 4.0);
        assert_eq!(value("-2 ^ 2", &[]), 4.0);
        assert_eq!(value("2.5e3 + 1E-1 - .5", &[]), 2499.6);
        assert_eq!(value("2 * e3", &[5.0]), 10.0);
        assert_eq!(value("1 + 2 < 4", &[]), 1.0);
        assert_eq!(value("(x < 4) * (x >= 3)", &[3.0]), 1.0);
        assert_eq!(value("(x < 4) * (x > 3)", &[3.0]), 0.0);
        assert_eq!(value("x <= 3", &[3.0]), 1.0);
        assert_eq!(value("floor(-1.5)", &[]), -2.0);
        assert!(value("x < 3", &[f64::NAN]).is_nan());
        assert_eq!(value("0.5 * mass * speed ^ 2", &[3.0, 4.0]), 24.0);
        assert_eq!(value("sqrt(abs(x))", &[-9.0]), 3.0);
        assert_eq!(value("{fender.a.reaction} - 1", &[5.0]), 4.0);
        assert_eq!(value("max(1, x)", &[3.0]), 3.0);
        assert!((value("cos(PI)", &[]) + 1.0).abs() < 1e-15);
        assert!(value("sqrt(x)", &[-1.0]).is_nan());
        assert!(Formula::parse("1 +").is_err());
        assert!(Formula::parse("").is_err());
    }

    #[test]
    fn names_are_in_order() {
        let formula = Formula::parse("speed * angle + {fender.a.energy}").expect("a formula");
        assert_eq!(formula.names(), ["angle", "fender.a.energy", "speed"]);
    }
}
