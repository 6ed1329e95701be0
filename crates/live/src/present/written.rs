//! Writes numbers and texts as a scenario file has them.

use fenderline_contact::Vec2;

/// Puts a text in quotation marks. Quotation marks are the same in TOML and JSON.
pub(super) fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// Rounds a number to `decimals` decimals, for a file that people read.
pub(super) fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = libm::pow(10.0, f64::from(decimals));
    // Adding 0 turns −0 into 0.
    libm::round(value * scale) / scale + 0.0
}

/// Writes an angle in degrees from 0 to 360, with the unit.
pub(super) fn degrees(angle_rad: f64) -> String {
    let turn = libm::fmod(angle_rad.to_degrees(), 360.0);
    let turn = rounded(if turn < 0.0 { turn + 360.0 } else { turn }, 7);
    format!("\"{turn} deg\"")
}

/// Formats a position (m).
pub(super) fn place(at_m: Vec2) -> String {
    format!("[{}, {}]", rounded(at_m.x, 4), rounded(at_m.y, 4))
}
