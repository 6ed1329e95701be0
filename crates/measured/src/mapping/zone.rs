//! Time zones as hours and minutes east of Greenwich.

/// Seconds by which a clock of the zone is ahead of UTC: `+02:00`, `-0330`, `+2`, `Z`, `UTC`; `None` for another text.
pub(crate) fn zone_s(text: &str) -> Option<f64> {
    let text = text.trim();
    if text.eq_ignore_ascii_case("z") || text.eq_ignore_ascii_case("utc") {
        return Some(0.0);
    }
    let text = text.strip_prefix("UTC").unwrap_or(text);
    let (sign, rest) = match text.split_at_checked(1)? {
        ("+", rest) => (1.0, rest),
        ("-", rest) => (-1.0, rest),
        _ => return None,
    };
    let (hours, minutes) = match rest.split_once(':') {
        Some(parts) => parts,
        None if rest.len() == 4 => rest.split_at_checked(2)?,
        None => (rest, "0"),
    };
    let whole = |text: &str, most: u32| {
        let is_good = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        is_good.then(|| text.parse::<u32>().ok()).flatten().filter(|value| *value <= most)
    };
    let seconds = 3600 * whole(hours, 14)? + 60 * whole(minutes, 59)?;
    Some(sign * f64::from(seconds))
}

#[cfg(test)]
mod tests {
    use super::zone_s;

    #[test]
    fn zones_are_hours_and_minutes_east() {
        for (text, seconds) in
            [("+02:00", 7200.0), ("-0330", -12_600.0), ("UTC+1", 3600.0), ("Z", 0.0), ("utc", 0.0)]
        {
            assert_eq!(zone_s(text), Some(seconds), "{text}");
        }
        for text in ["CET", "", "+", "+25", "+02:60", "2", "+2:x", "+é"] {
            assert_eq!(zone_s(text), None, "{text}");
        }
    }
}
