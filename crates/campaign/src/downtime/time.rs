//! Reads the times of a weather series, such as 2025-01-31T23:00.

/// English names of the months.
pub(super) const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];

/// A time in UTC.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Time {
    /// Seconds since 1970.
    pub(super) s: i64,
    /// Month, from 0.
    pub(super) month: usize,
}

impl Time {
    /// Reads `2025-01-31T23:00`, with seconds and a `Z` or without, and with a space in place of the `T`.
    pub(super) fn parse(text: &str) -> Option<Time> {
        let text = text.trim();
        let text = text.strip_suffix('Z').unwrap_or(text);
        let (date, clock) = text.split_once(['T', ' '])?;
        let date: Vec<i64> = numbers(date, '-', &[4, 2, 2])?;
        let clock: Vec<i64> =
            numbers(clock, ':', &[2, 2]).or_else(|| numbers(clock, ':', &[2, 2, 2]))?;
        let [year, month, day] = date[..] else { return None };
        let (hour, minute) = (clock[0], clock[1]);
        let second = clock.get(2).copied().unwrap_or(0);
        let is_good = (1..=12).contains(&month)
            && (1..=days_of(year, month)).contains(&day)
            && hour < 24
            && minute < 60
            && second < 60;
        is_good.then(|| Time {
            s: ((days(year, month, day) * 24 + hour) * 60 + minute) * 60 + second,
            month: (month - 1) as usize,
        })
    }
}

/// Reads whole numbers with given counts of digits, between separators.
fn numbers(text: &str, separator: char, digits: &[usize]) -> Option<Vec<i64>> {
    let parts: Vec<&str> = text.split(separator).collect();
    let is_good = parts.len() == digits.len()
        && parts.iter().zip(digits).all(|(part, digits)| {
            part.len() == *digits && part.bytes().all(|byte| byte.is_ascii_digit())
        });
    if !is_good {
        return None;
    }
    parts.iter().map(|part| part.parse().ok()).collect()
}

fn is_leap(year: i64) -> bool {
    (year % 4 == 0 && year % 100 != 0) || year % 400 == 0
}

fn days_of(year: i64, month: i64) -> i64 {
    match month {
        4 | 6 | 9 | 11 => 30,
        2 if is_leap(year) => 29,
        2 => 28,
        _ => 31,
    }
}

/// Number of days from 1970-01-01 to a date, in the Gregorian calendar.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let before = year - 1;
    let leaps = |year: i64| year / 4 - year / 100 + year / 400;
    let of_years = 365 * (year - 1970) + leaps(before) - leaps(1969);
    of_years + (1..month).map(|month| days_of(year, month)).sum::<i64>() + day - 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_count_seconds_of_the_calendar() {
        let s = |text: &str| Time::parse(text).map(|time| time.s);
        assert_eq!(s("1970-01-01T00:00"), Some(0));
        // By `date -u -d ... +%s`.
        assert_eq!(s("2025-01-31T23:00"), Some(1_738_364_400));
        assert_eq!(s("2024-02-29 12:30:15Z"), Some(1_709_209_815));
        assert_eq!(s("2000-03-01T00:00"), Some(951_868_800));
        assert_eq!(Time::parse("2025-12-01T00:00").map(|time| time.month), Some(11));
        for bad in [
            "2025-02-29T00:00",
            "2025-13-01T00:00",
            "2025-01-01",
            "1.1.2025 00:00",
            "2025-01-01T24:00",
        ] {
            assert_eq!(s(bad), None, "{bad}");
        }
    }
}
