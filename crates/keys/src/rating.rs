//! Checks whether a rated reaction fits the size of a fender.

use crate::printable::printable_number;

/// Expected range of a fender's rated reaction divided by the square of its height (N/m²). Rubber and pneumatic fenders
/// of catalogues have 60 to 1500 kN/m² for each metre of length, or for a cone; the range that we chose is wide enough
/// for soft fenders and for long fenders.
const REACTION_OVER_HEIGHT_SQUARED: [f64; 2] = [10e3, 100e6];
/// A message if a rated reaction does not fit the size of a fender; `None` if it fits.
pub fn odd_reaction(reaction_n: f64, size_m: f64, what: &str) -> Option<String> {
    let [low_n, high_n] = REACTION_OVER_HEIGHT_SQUARED.map(|each| each * size_m * size_m);
    if (low_n..=high_n).contains(&reaction_n) {
        return None;
    }
    let kilo = |newtons: f64| printable_number(libm::round(newtons) / 1e3);
    let mut message = format!(
        "a rated reaction of {} kN at {what} of {} m; from {} to {} kN was expected",
        kilo(reaction_n),
        libm::round(size_m * 1e3) / 1e3,
        kilo(low_n),
        kilo(high_n)
    );
    if (low_n..=high_n).contains(&(reaction_n * 1e3)) {
        let number = printable_number(reaction_n);
        message += &format!(": \"{number} kN\" in place of {number} N?");
    }
    Some(message)
}
