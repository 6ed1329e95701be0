//! Times of logs.

use fenderline_keys::calendar::{days_from_1970, is_date, zone_s};

use crate::mapping::Mapping;

/// A time as a log gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Moment {
    /// Seconds since 1970 in UTC.
    Dated(f64),
    /// Seconds since midnight, or since the start of the log.
    Undated(f64),
}

/// How times of a log are read.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Clock {
    pub(super) zone_s: f64,
    pub(super) day_first: Option<bool>,
    /// Whether a time without a zone was read.
    pub(super) is_zone_assumed: bool,
}

impl Clock {
    /// A clock by the mapping; where the mapping does not state the order of dates, the dates of the log decide.
    pub(super) fn of<'t>(mapping: &Mapping, dates: impl Iterator<Item = &'t str>) -> Clock {
        let day_first = mapping.day_first.or_else(|| dates.into_iter().find_map(order_of));
        Clock { zone_s: mapping.zone_s.unwrap_or(0.0), day_first, is_zone_assumed: false }
    }

    /// Reads a time: `2025-01-31T23:00:05.2+01:00`, `31.01.2025 23:00:05`, `23:00:05`, or a number: seconds since 1970
    /// from a thousand million on, else seconds since the start of the log. `None` for another text, and for a date
    /// of which nobody knows whether day or month comes first.
    pub(super) fn read(&mut self, text: &str) -> Option<Moment> {
        let text = text.trim();
        if let Ok(number) = text.parse::<f64>() {
            return match number.is_finite() {
                true if number >= 1e9 => Some(Moment::Dated(number)),
                true if number >= 0.0 => Some(Moment::Undated(number)),
                _ => None,
            };
        }
        let (text, zone_s) = zoned(text);
        let Some((date, time)) = text.split_once(['T', ' ']) else {
            return seconds_of_day(text).map(Moment::Undated);
        };
        let [year, month, day] = self.date(date)?;
        let of_day_s = seconds_of_day(time.trim())?;
        let zone_s = zone_s.unwrap_or_else(|| {
            self.is_zone_assumed = true;
            self.zone_s
        });
        Some(Moment::Dated(days_from_1970(year, month, day) as f64 * 86_400.0 + of_day_s - zone_s))
    }

    fn date(&self, text: &str) -> Option<[i64; 3]> {
        let (separator, parts) = parts_of(text)?;
        let [a, b, c] = parts;
        let date = match (separator, a > 31) {
            (_, true) => [a, b, c],
            ('.', _) => [c, b, a],
            _ => match self.day_first? {
                true => [c, b, a],
                false => [c, a, b],
            },
        };
        let date = [if date[0] < 100 { date[0] + 2000 } else { date[0] }, date[1], date[2]];
        is_date(date[0], date[1], date[2]).then_some(date)
    }
}

/// Text of a time without its zone, and the zone in seconds.
fn zoned(text: &str) -> (&str, Option<f64>) {
    if let Some(rest) = text.strip_suffix(['Z', 'z']) {
        return (rest, Some(0.0));
    }
    if let Some(rest) = text.strip_suffix("UTC") {
        return (rest.trim_end(), Some(0.0));
    }
    // A minus sign may also stand in the date.
    let after_time = text.find(':').unwrap_or(text.len());
    let Some(at) = text[after_time..].find(['+', '-']) else { return (text, None) };
    let (time, zone) = text.split_at(after_time + at);
    match zone_s(zone) {
        Some(zone_s) => (time.trim_end(), Some(zone_s)),
        None => (text, None),
    }
}

/// Whether a date has its day first, if the date leaves no doubt.
fn order_of(text: &str) -> Option<bool> {
    let date = text.trim().split(['T', ' ']).next()?;
    match parts_of(date)? {
        (_, [a, _, _]) if a > 31 => None,
        ('.', _) => Some(true),
        (_, [a, _, _]) if a > 12 => Some(true),
        (_, [_, b, _]) if b > 12 => Some(false),
        _ => None,
    }
}

fn parts_of(date: &str) -> Option<(char, [i64; 3])> {
    let separator = ['-', '/', '.'].into_iter().find(|separator| date.contains(*separator))?;
    let parts: Option<Vec<i64>> = date
        .split(separator)
        .map(|part| {
            let is_good =
                !part.is_empty() && part.len() <= 4 && part.bytes().all(|b| b.is_ascii_digit());
            is_good.then(|| part.parse().ok())?
        })
        .collect();
    Some((separator, parts?.try_into().ok()?))
}

/// Seconds since midnight of `23:00`, `23:00:05` or `23:00:05.2`, also with a decimal comma.
fn seconds_of_day(text: &str) -> Option<f64> {
    let text = text.replace(',', ".");
    let parts: Vec<&str> = text.split(':').collect();
    let number = |text: &str| {
        let is_good = text.starts_with(|c: char| c.is_ascii_digit());
        is_good.then(|| text.parse::<f64>().ok())?
    };
    let (hours, minutes, seconds) = match parts[..] {
        [hours, minutes] => (number(hours)?, number(minutes)?, 0.0),
        [hours, minutes, seconds] => (number(hours)?, number(minutes)?, number(seconds)?),
        _ => return None,
    };
    let is_good = hours < 24.0 && minutes < 60.0 && seconds < 61.0;
    is_good.then_some(3600.0 * hours + 60.0 * minutes + seconds)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Option<Moment> {
        Clock { zone_s: 7200.0, ..Clock::default() }.read(text)
    }

    #[test]
    fn times_of_many_forms_are_the_same_moment() {
        // By `date -u -d 2025-01-31T23:00:05Z +%s`.
        let moment = Some(Moment::Dated(1_738_364_405.0));
        for text in [
            "2025-01-31T23:00:05Z",
            "2025-01-31 23:00:05.0 UTC",
            "2025-02-01T00:00:05+01:00",
            "2025-02-01 01:00:05",
            "01.02.2025 01:00:05",
            "2025/02/01 01:00:05",
            "1738364405",
        ] {
            assert_eq!(read(text), moment, "{text}");
        }
        assert_eq!(read("23:00:05"), Some(Moment::Undated(82_805.0)));
        assert_eq!(read("12.5"), Some(Moment::Undated(12.5)));
        for bad in
            ["", "2025-02-29 10:00", "yesterday", "25:00:00", "01/02/2025 10:00", "-5", "NaN"]
        {
            assert_eq!(read(bad), None, "{bad}");
        }
    }

    #[test]
    fn a_date_without_doubt_decides_the_order() {
        let mapping = Mapping::default();
        let of = |dates: &[&str]| Clock::of(&mapping, dates.iter().copied()).day_first;
        assert_eq!(of(&["01/02/2025 10:00", "13/02/2025 10:00"]), Some(true));
        assert_eq!(of(&["02/13/2025 10:00"]), Some(false));
        assert_eq!(of(&["02/03/2025 10:00"]), None);
        let mut clock = Clock { day_first: Some(false), ..Clock::default() };
        assert_eq!(clock.read("01/31/2025 23:00:05Z"), Some(Moment::Dated(1_738_364_405.0)));
    }
}
