//! Dates of the Gregorian calendar and offsets of time zones, for keys and columns that hold times.

/// Number of days from 1970-01-01 to a date, negative before (Hinnant's algorithm). The date must exist.
#[must_use]
pub fn days_from_1970(year: i64, month: i64, day: i64) -> i64 {
    // Counted from March on, a leap day is the last day of a year.
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let of_era = year.rem_euclid(400);
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468
}

/// Whether the calendar has a date.
#[must_use]
pub fn is_date(year: i64, month: i64, day: i64) -> bool {
    let last = match month {
        1 | 3 | 5 | 7 | 8 | 10 | 12 => 31,
        4 | 6 | 9 | 11 => 30,
        2 if (year % 4 == 0 && year % 100 != 0) || year % 400 == 0 => 29,
        2 => 28,
        _ => 0,
    };
    (1..=last).contains(&day)
}

/// Seconds by which a clock of the zone is ahead of UTC: `+02:00`, `-0330`, `+2`, `Z`, `UTC`; `None` for another text.
#[must_use]
pub fn zone_s(text: &str) -> Option<f64> {
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
    use super::*;

    #[test]
    fn days_are_counted_in_the_calendar() {
        let days = days_from_1970;
        assert_eq!((days(1970, 1, 1), days(2000, 3, 1), days(2024, 2, 29)), (0, 11_017, 19_782));
        assert!(is_date(2024, 2, 29) && !is_date(2025, 2, 29) && !is_date(1900, 2, 29));
        assert!(!is_date(2025, 13, 1) && !is_date(2025, 4, 31) && !is_date(2025, 1, 0));
    }

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
