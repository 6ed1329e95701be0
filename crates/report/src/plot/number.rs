//! Writes numbers in the form that a reader wants.

/// The sign between groups of three digits: a narrow space at which no line breaks.
const GROUP: char = '\u{202f}';
const MINUS: char = '\u{2212}';

/// Writes a number with its noun, in the singular or plural.
pub fn counted(count: u64, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// Writes an ordinal number: `first`, `second`, `21st`.
pub fn ordinal(number: u32) -> String {
    match (number, number % 10, number % 100) {
        (1, ..) => "first".to_owned(),
        (2, ..) => "second".to_owned(),
        (3, ..) => "third".to_owned(),
        (_, _, 11..=13) => format!("{number}th"),
        (_, 1, _) => format!("{number}st"),
        (_, 2, _) => format!("{number}nd"),
        (_, 3, _) => format!("{number}rd"),
        _ => format!("{number}th"),
    }
}

/// Writes how often something happened: `once`, `twice` or a number of times.
pub fn times(count: u64) -> String {
    if count == 1 { "once".to_owned() } else { format!("{count} times") }
}

/// Writes `value` with a true minus sign and grouped thousands, to `decimals` places; with a power of ten if there
/// would be too many digits.
pub fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let magnitude = value.abs();
    if magnitude >= 1e12 || decimals > 9 {
        return exponent(value);
    }
    let digits = format!("{magnitude:.decimals$}");
    let is_zero = digits.bytes().all(|b| b == b'0' || b == b'.');
    let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
    let mut text = String::with_capacity(digits.len() + 4);
    if value < 0.0 && !is_zero {
        text.push(MINUS);
    }
    for (i, digit) in whole.chars().enumerate() {
        // Four digits stay together, as in most engineering print.
        if i > 0 && whole.len() > 4 && (whole.len() - i).is_multiple_of(3) {
            text.push(GROUP);
        }
        text.push(digit);
    }
    if !fraction.is_empty() {
        text.push('.');
        text.push_str(fraction);
    }
    text
}

/// Writes `value` to about `digits` significant digits, with at most six decimals; zero is `0`.
pub fn significant(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return fixed(value, 0);
    }
    let order = order_of(value);
    let decimals = digits - 1 - order;
    if decimals > 9 {
        return exponent(value);
    }
    fixed(value, usize::try_from(decimals.max(0)).unwrap_or(0))
}

/// Writes a number like [`significant`], but without zeros at the end of the decimals, for values that a user gave.
pub fn plain(value: f64, digits: i32) -> String {
    let text = significant(value, digits);
    if !text.contains('.') || text.contains('e') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Cuts a name of the user to `longest` characters.
pub fn shortened(name: &str, longest: usize) -> String {
    if name.chars().count() <= longest {
        return name.to_owned();
    }
    name.chars().take(longest.saturating_sub(1)).chain(['…']).collect()
}

fn exponent(value: f64) -> String {
    format!("{value:.3e}").replace('-', "\u{2212}")
}

/// Number of decimals that distinguish multiples of `step`, one to four.
pub fn decimals_for(step: f64) -> usize {
    (1..4).find(|&n| is_whole(step * libm::exp10(f64::from(n)))).unwrap_or(4) as usize
}

fn is_whole(value: f64) -> bool {
    (value - libm::round(value)).abs() < 1e-6 && value > 0.5
}

/// The exponent of ten that belongs to the first digit of a number.
pub(super) fn order_of(value: f64) -> i32 {
    // Saturating cast: the argument is finite and non-zero at every caller.
    libm::floor(libm::log10(value.abs())) as i32
}

/// A prefix for a unit, such as kilo, that suits the largest value shown with the unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled {
    /// Factor by which values in SI units are multiplied.
    pub factor: f64,
    /// The prefix that is put before the unit.
    pub prefix: &'static str,
}

impl Scaled {
    /// The prefix for a quantity whose largest magnitude is `largest`, in SI.
    pub fn for_largest(largest: f64) -> Scaled {
        match largest {
            x if x >= 1e10 => Scaled { factor: 1e-9, prefix: "G" },
            x if x >= 1e7 => Scaled { factor: 1e-6, prefix: "M" },
            x if x >= 1e3 || x == 0.0 => Scaled { factor: 1e-3, prefix: "k" },
            _ => Scaled { factor: 1.0, prefix: "" },
        }
    }

    /// The text of a unit with its prefix.
    pub fn unit(self, base: &str) -> String {
        format!("{}{base}", self.prefix)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinals_are_words() {
        let words = [1, 2, 3, 4, 11, 12, 21, 22, 103, 113].map(ordinal);
        let expected =
            ["first", "second", "third", "4th", "11th", "12th", "21st", "22nd", "103rd", "113th"];
        assert_eq!(words, expected);
    }

    #[test]
    fn times_show_the_decimals_of_the_step() {
        let steps = [2.0, 0.1, 0.05, 0.125, 1e-9];
        assert_eq!(steps.map(decimals_for), [1, 1, 2, 3, 4]);
    }

    #[test]
    fn numbers_have_a_true_minus_and_grouped_thousands() {
        let table = [
            (fixed(1234.5, 1), "1234.5"),
            (fixed(12345.6, 0), "12\u{202f}346"),
            (fixed(-0.0001, 2), "0.00"),
            (fixed(-2.5, 1), "\u{2212}2.5"),
            (fixed(f64::NAN, 1), "–"),
            (significant(0.20579, 3), "0.206"),
            (significant(5012.3, 3), "5012"),
            (significant(1e-30, 3), "1.000e\u{2212}30"),
            (significant(0.0, 3), "0"),
            (significant(1e300, 3), "1.000e300"),
            (plain(10.0, 6), "10"),
            (plain(2.50, 3), "2.5"),
            (plain(298.0, 4), "298"),
            (shortened("a long name", 7), "a long…"),
        ];
        for (got, want) in table {
            assert_eq!(got, want);
        }
    }
}
