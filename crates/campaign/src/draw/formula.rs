//! Formulas of the user. Their functions are those of `libm`, so that a campaign has the same bits on every platform.

use exmex::prelude::*;
use exmex::{BinOp, MakeOperators, Operator, ops_factory};
use fenderline_contact::number::{greater, lesser};

ops_factory!(
    Operators,
    f64,
    Operator::make_bin("^", BinOp { apply: libm::pow, prio: 4, is_commutative: false }),
    Operator::make_bin("*", BinOp { apply: |a, b| a * b, prio: 2, is_commutative: true }),
    Operator::make_bin("/", BinOp { apply: |a, b| a / b, prio: 3, is_commutative: false }),
    Operator::make_bin_unary(
        "+",
        BinOp { apply: |a, b| a + b, prio: 0, is_commutative: true },
        |a| a
    ),
    Operator::make_bin_unary(
        "-",
        BinOp { apply: |a, b| a - b, prio: 1, is_commutative: false },
        |a| -a
    ),
    Operator::make_bin("min", BinOp { apply: lesser, prio: 0, is_commutative: true }),
    Operator::make_bin("max", BinOp { apply: greater, prio: 0, is_commutative: true }),
    Operator::make_unary("sqrt", libm::sqrt),
    Operator::make_unary("abs", libm::fabs),
    Operator::make_unary("exp", libm::exp),
    Operator::make_unary("ln", libm::log),
    Operator::make_unary("log10", libm::log10),
    Operator::make_unary("sin", libm::sin),
    Operator::make_unary("cos", libm::cos),
    Operator::make_unary("tan", libm::tan),
    Operator::make_unary("atan", libm::atan),
    Operator::make_constant("PI", core::f64::consts::PI)
);

/// A formula of named numbers.
#[derive(Clone, Debug)]
pub struct Formula {
    expression: FlatEx<f64, Operators>,
    names: Vec<String>,
}

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// Why it is none.
    pub fn parse(text: &str) -> Result<Formula, String> {
        let expression = FlatEx::<f64, Operators>::parse(text)
            .map_err(|error| format!("\"{text}\": {error}"))?;
        let names = expression.var_names().to_vec();
        Ok(Formula { expression, names })
    }

    /// The names of its numbers, in the order in which [`Formula::value`] takes them.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Its value; not a number where one of its numbers is none, or where it has no value, such as the root of a negative number.
    ///
    /// # Panics
    /// If there is not one number for each name.
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
