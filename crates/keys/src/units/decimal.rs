//! Decimal numbers and exact unit factors.

use super::error::UnitError;

/// A decimal number as written: `mantissa · 10^exponent`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Decimal {
    negative: bool,
    /// All digits of the number, without the decimal point.
    digits: String,
    exponent: i32,
}

/// An exact factor of a unit: numerator / denominator · 10^ten · π^pi.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Scale {
    pub(super) numerator: u128,
    pub(super) denominator: u128,
    pub(super) ten: i32,
    pub(super) pi: i32,
}

impl Scale {
    pub(super) const ONE: Scale = Scale { numerator: 1, denominator: 1, ten: 0, pi: 0 };

    /// The product `self · other^power`; `None` if its fraction does not fit 128 bits.
    pub(super) fn times(self, other: Scale, power: i32) -> Option<Scale> {
        let mut product = self;
        for _ in 0..power.unsigned_abs() {
            let (over, under) = if power > 0 {
                (other.numerator, other.denominator)
            } else {
                (other.denominator, other.numerator)
            };
            product.numerator = product.numerator.checked_mul(over)?;
            product.denominator = product.denominator.checked_mul(under)?;
            let common = greatest_common_divisor(product.numerator, product.denominator);
            product.numerator /= common;
            product.denominator /= common;
        }
        product.ten += other.ten * power;
        product.pi += other.pi * power;
        Some(product)
    }
}

fn greatest_common_divisor(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

impl Decimal {
    /// The number that `text` starts with, and the rest of the text.
    pub(super) fn split(text: &str) -> Result<(Decimal, &str), UnitError> {
        let unsigned = text.strip_prefix(['+', '-', '\u{2212}']);
        let negative = text.starts_with(['-', '\u{2212}']);
        let unsigned = unsigned.unwrap_or(text);
        let (whole, rest) = split_digits(unsigned);
        let (fraction, rest) = match rest.strip_prefix('.') {
            // "4.kn" has no digits after its point: the point then belongs to the unit, which refuses it.
            Some(after) if !split_digits(after).0.is_empty() => split_digits(after),
            _ => ("", rest),
        };
        if whole.is_empty() {
            return Err(no_number(unsigned));
        }
        if rest.starts_with(',') {
            return Err(UnitError::with_help(
                "a comma is not a decimal point",
                "write a point: 0.5",
            ));
        }
        let (exponent, rest) = split_exponent(rest)?;
        let digits = [whole, fraction].concat();
        let exponent = exponent - fraction.len() as i32;
        Ok((Decimal { negative, digits, exponent }, rest))
    }

    /// The product of the number and a unit's factor; infinite if the product overflows.
    pub(super) fn times(&self, scale: &Scale) -> f64 {
        let ten = self.exponent + scale.ten;
        let rational = self.exact_times(scale, ten).unwrap_or_else(|| {
            let shifted: f64 =
                format!("{}e{ten}", self.digits).parse().expect("digits make a number");
            shifted * scale.numerator as f64 / scale.denominator as f64
        });
        let mut value = if self.negative { -rational } else { rational };
        for _ in 0..scale.pi.unsigned_abs() {
            value = if scale.pi > 0 {
                value * core::f64::consts::PI
            } else {
                value / core::f64::consts::PI
            };
        }
        value
    }

    /// The correctly rounded product of number and factor, computed by one division of two integers that `f64` holds
    /// exactly; `None` if the integers are too long.
    fn exact_times(&self, scale: &Scale, ten: i32) -> Option<f64> {
        const EXACT: u128 = 1 << 53;
        let power_of_ten = 10_u128.checked_pow(ten.unsigned_abs())?;
        let (over, under) = if ten > 0 { (power_of_ten, 1) } else { (1, power_of_ten) };
        let mantissa: u128 = self.digits.parse().ok()?;
        let numerator = mantissa.checked_mul(scale.numerator)?.checked_mul(over)?;
        let denominator = scale.denominator.checked_mul(under)?;
        (numerator <= EXACT && denominator <= EXACT).then(|| numerator as f64 / denominator as f64)
    }
}

fn split_digits(text: &str) -> (&str, &str) {
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    text.split_at(end)
}

/// The exponent after an `e`, or 0 if the text has no exponent, and the rest of the text.
fn split_exponent(text: &str) -> Result<(i32, &str), UnitError> {
    let Some(after) = text.strip_prefix(['e', 'E']) else { return Ok((0, text)) };
    let sign_length = usize::from(after.starts_with(['+', '-']));
    let (digits, rest) = split_digits(&after[sign_length..]);
    if digits.is_empty() {
        return Ok((0, text));
    }
    match after[..sign_length + digits.len()].parse::<i32>() {
        Ok(exponent) if exponent.abs() <= 999 => Ok((exponent, rest)),
        _ => Err(UnitError::new("the number is too large to compute with")),
    }
}

fn no_number(text: &str) -> UnitError {
    let lower = text.to_ascii_lowercase();
    if lower.starts_with("nan") || lower.starts_with("inf") {
        UnitError::new("NaN and infinity are not allowed")
    } else if text.starts_with('.') {
        UnitError::with_help("a number starts with a digit", "write 0.5, not .5")
    } else {
        UnitError::new("the text does not start with a number")
    }
}
