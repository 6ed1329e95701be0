//! Writes values of an exercise in words.

pub(super) fn metres(value_m: f64) -> String {
    if value_m.abs() < 10.0 { format!("{value_m:.2} m") } else { format!("{value_m:.0} m") }
}

pub(super) fn speed(value_mps: f64) -> String {
    format!("{value_mps:.2} m/s")
}

pub(super) fn angle(value_rad: f64) -> String {
    format!("{:.1}°", value_rad.to_degrees())
}

/// Engineers have tensions of lines in kilonewtons, and mariners in tonnes.
pub(super) fn tension(value_n: f64) -> String {
    format!("{:.0} kN ({:.1} t)", value_n / 1e3, value_n / TONNE_N)
}

/// The weight of a tonne (N).
const TONNE_N: f64 = 9806.65;

pub(super) fn force_share(value: f64) -> String {
    format!("{:.0} % of break load", 100.0 * value)
}

/// Minutes and seconds.
pub(super) fn seconds(value_s: f64) -> String {
    let whole = libm::round(value_s);
    let minutes = libm::floor(whole / 60.0);
    format!("{minutes:.0}:{:02.0} min", whole - 60.0 * minutes)
}
