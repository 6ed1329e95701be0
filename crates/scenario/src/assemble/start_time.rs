//! Reads date, time and place of the start of a run, for the sun in the pages' view.

use fenderline_sim::Daylight;
use fenderline_sim::chart::GeographicPlace;

use super::assembly::{Assembly, Checked};
use super::bottom::Charted;
use fenderline_keys::calendar::{days_from_1970, is_date, zone_s};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::keys::chart::ChartOriginKey;
use fenderline_keys::keys::environment::EnvironmentKey;

/// Years in which the formulas of the pages' sun hold to a small part of a degree.
const YEARS: core::ops::RangeInclusive<i64> = 1950..=2100;
const EXAMPLE: &str = "write start_time = \"2026-06-21T05:30+02:00\"";

impl Assembly<'_, '_> {
    /// Where and when the run begins; `None` if the scenario gives no `start_time`.
    pub(super) fn daylight(
        &self,
        table: Of<'_, EnvironmentKey>,
        charted: &Charted,
    ) -> Checked<Option<Daylight>> {
        let place = table.item(EnvironmentKey::PLACE);
        let Some(item) = table.item(EnvironmentKey::START_TIME) else {
            let Some(place) = place else { return Ok(None) };
            let message = "the place is for the sun at `start_time`, which is missing";
            return Err(self.refused(table, place, &message).with_help(EXAMPLE));
        };
        let start_unix_s = unix_s(item.text())
            .map_err(|why| self.refused(table, item, &why).with_help(EXAMPLE))?;
        let given = place.map(Entry::table).map(|place| {
            let angle = |key| *place.given(key).number();
            GeographicPlace {
                latitude_rad: angle(ChartOriginKey::LATITUDE),
                longitude_rad: angle(ChartOriginKey::LONGITUDE),
            }
        });
        let Some(place) = given.or(charted.chart.origin) else {
            let message = "the sun needs a place on the earth, and no chart gives one";
            return Err(self.refused(table, item, &message).with_help(
                "write place = { latitude = \"53.52 deg\", longitude = \"9.94 deg\" } beside it",
            ));
        };
        Ok(Some(Daylight { start_unix_s, place }))
    }
}

/// Seconds from the start of 1970 to a date and time of ISO 8601 with an offset, such as `2026-06-21T05:30:00+02:00`.
///
/// # Errors
/// Says what is wrong with the text.
fn unix_s(text: &str) -> Result<f64, String> {
    let form = || {
        format!(
            "\"{text}\" is not a date, a time and an offset from universal time (ISO 8601), such as \
             2026-06-21T05:30+02:00"
        )
    };
    let (date, rest) = text.split_once('T').ok_or_else(form)?;
    let [year, month, day] = numbers(date, '-', [4, 2, 2]).ok_or_else(form)?;
    let offset = rest.find(['Z', '+', '-']).ok_or_else(form)?;
    let (time, offset) = rest.split_at(offset);
    let offset_s = zone_s(offset)
        .ok_or_else(|| format!("{offset} is not an offset from universal time, such as +02:00"))?;
    let [hour, minute, second] = match numbers(time, ':', [2, 2, 2]) {
        Some(time) => time,
        None => {
            let [hour, minute] = numbers(time, ':', [2, 2]).ok_or_else(form)?;
            [hour, minute, 0]
        }
    };
    if !YEARS.contains(&year) {
        return Err(format!("the year must be from {} to {}", YEARS.start(), YEARS.end()));
    }
    if !is_date(year, month, day) {
        return Err(format!("there is no day {date}"));
    }
    if hour > 23 || minute > 59 || second > 59 {
        return Err(format!("there is no time of day {time}"));
    }
    let minutes = days_from_1970(year, month, day) * 24 * 60 + hour * 60 + minute;
    Ok((60 * minutes + second) as f64 - offset_s)
}

/// The numbers of a text with a sign between them, each with so many digits; `None` if the text is of another form.
fn numbers<const N: usize>(text: &str, between: char, digits: [usize; N]) -> Option<[i64; N]> {
    let mut parts = text.split(between);
    let mut all = [0; N];
    for (number, digits) in all.iter_mut().zip(digits) {
        let part = parts.next()?;
        if part.len() != digits || !part.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        *number = part.parse().ok()?;
    }
    parts.next().is_none().then_some(all)
}

#[cfg(test)]
mod tests {
    use super::unix_s;

    #[test]
    fn a_date_with_an_offset_is_the_time_of_the_unix_clock() {
        // `date -u -d TEXT +%s` of coreutils gives the numbers.
        for (text, seconds) in [
            ("1970-01-01T00:00Z", 0.0),
            ("2026-06-21T05:30+02:00", 1_782_012_600.0),
            ("2024-02-29T23:59:59-03:30", 1_709_263_799.0),
            ("2000-12-31T12:00:00Z", 978_264_000.0),
            ("1969-07-20T20:17:40+00:00", -14_182_940.0),
        ] {
            assert_eq!(unix_s(text), Ok(seconds), "{text}");
        }
    }

    #[test]
    fn a_date_that_is_none_is_refused() {
        for text in [
            "2026-06-21",
            "2026-06-21T05:30",
            "2026-06-21 05:30Z",
            "2026-02-29T00:00Z",
            "2026-13-01T00:00Z",
            "2026-06-21T24:00Z",
            "1900-06-21T05:30Z",
            "2026-06-21T05:30+20:00",
            "2026-6-21T05:30Z",
            "",
        ] {
            assert!(unix_s(text).is_err(), "{text}");
        }
    }
}
