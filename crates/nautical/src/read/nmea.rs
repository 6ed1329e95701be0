//! Sentences of instruments.

use super::fields::{Fields, SentenceFault, number};
use crate::NAUTICAL_MILE_M;
use crate::chart::GeoPoint;

/// Time of day in UTC of a sentence, and the date where the sentence has a date.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClockTime {
    /// Seconds since midnight.
    pub seconds: f64,
    /// Year, month, day.
    pub date: Option<(u32, u32, u32)>,
}

/// A position of an antenna.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fix {
    /// When.
    pub at: ClockTime,
    /// Where.
    pub place: GeoPoint,
    /// Speed over ground (m/s) and course over ground (°), where the sentence has them.
    pub way: Option<(f64, f64)>,
    /// Quality of the fix as in GGA: 1 satellites alone, 2 with corrections, 4 fixed and 5 floating phase.
    pub quality: Option<u32>,
}

/// The content of a sentence that a track needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    /// GGA or RMC: a position; `None` while the receiver has no valid position.
    Position(Option<Fix>),
    /// HDT or THS: heading from true north (°); `None` while the compass gives none.
    Heading(Option<f64>),
    /// ROT: rate of turn, positive to starboard (°/min); `None` while it is not valid.
    Turn(Option<f64>),
    /// VTG: speed (m/s) and course (°) over ground, as far as they are given.
    Way(Option<f64>, Option<f64>),
    /// A sentence of another kind.
    Other,
}

/// Reads the body of a sentence, as [`super::body_of`] returns it.
///
/// # Errors
/// Names a field that does not hold what the format says.
pub fn reading(body: &str) -> Result<Reading, SentenceFault> {
    let (kind, fields) = Fields::of(body);
    match kind {
        "GGA" => gga(&fields).map(Reading::Position),
        "RMC" => rmc(&fields).map(Reading::Position),
        "HDT" => fields.number(0, "heading").map(Reading::Heading),
        "THS" => {
            let heading = fields.number(0, "heading")?;
            Ok(Reading::Heading(heading.filter(|_| fields.at(1) != "V")))
        }
        "ROT" => {
            let turn = fields.number(0, "rate of turn")?;
            Ok(Reading::Turn(turn.filter(|_| fields.at(1) == "A")))
        }
        "VTG" => {
            let knots = fields.number(4, "speed")?;
            let is_valid = fields.at(8) != "N";
            let speed_mps = knots.map(|kn| kn * NAUTICAL_MILE_M / 3600.0);
            let course = fields.number(0, "course")?;
            Ok(Reading::Way(speed_mps.filter(|_| is_valid), course.filter(|_| is_valid)))
        }
        _ => Ok(Reading::Other),
    }
}

fn gga(fields: &Fields<'_>) -> Result<Option<Fix>, SentenceFault> {
    let quality = match fields.at(5) {
        "" => 0,
        text => text.parse().map_err(|_| SentenceFault::Field("quality"))?,
    };
    if quality == 0 || fields.at(1).is_empty() {
        return Ok(None);
    }
    let at = ClockTime { seconds: seconds(fields.at(0))?, date: None };
    Ok(Some(Fix { at, place: place(fields, 1)?, way: None, quality: Some(quality) }))
}

fn rmc(fields: &Fields<'_>) -> Result<Option<Fix>, SentenceFault> {
    if fields.at(1) != "A" || fields.at(2).is_empty() {
        return Ok(None);
    }
    let at = ClockTime { seconds: seconds(fields.at(0))?, date: Some(date(fields.at(8))?) };
    let knots = fields.number(6, "speed")?;
    let speed_mps = knots.map(|kn| kn * NAUTICAL_MILE_M / 3600.0);
    let way = speed_mps.zip(fields.number(7, "course")?);
    Ok(Some(Fix { at, place: place(fields, 2)?, way, quality: None }))
}

/// Seconds since midnight, from `123519.00`.
fn seconds(text: &str) -> Result<f64, SentenceFault> {
    let bad = SentenceFault::Field("time");
    let two = |from: usize| {
        let digits = text.get(from..from + 2)?;
        digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse::<u32>().ok())?
    };
    let (Some(hours), Some(minutes)) = (two(0), two(2)) else { return Err(bad) };
    let seconds = number(text.get(4..).unwrap_or_default(), "time")?;
    let is_good = hours < 24 && minutes < 60 && (0.0..61.0).contains(&seconds);
    if is_good { Ok(f64::from(hours * 3600 + minutes * 60) + seconds) } else { Err(bad) }
}

/// Year, month and day, from `230394`; years from 80 are of the last century.
fn date(text: &str) -> Result<(u32, u32, u32), SentenceFault> {
    let bad = || SentenceFault::Field("date");
    if text.len() != 6 || !text.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(bad());
    }
    let two = |from: usize| text[from..from + 2].parse::<u32>().map_err(|_| bad());
    let (day, month, year) = (two(0)?, two(2)?, two(4)?);
    let year = if year < 80 { 2000 + year } else { 1900 + year };
    if (1..=31).contains(&day) && (1..=12).contains(&month) {
        Ok((year, month, day))
    } else {
        Err(bad())
    }
}

/// A position from the four fields that begin at `from`.
fn place(fields: &Fields<'_>, from: usize) -> Result<GeoPoint, SentenceFault> {
    let angle = |index: usize, digits: usize, sides: [&str; 2], most, name| {
        let text = fields.at(from + index);
        let (degrees, minutes) = text.split_at_checked(digits).ok_or(SentenceFault::Field(name))?;
        let value = number(degrees, name)? + number(minutes, name)? / 60.0;
        let side = fields.at(from + index + 1);
        match value {
            value if !(0.0..=most).contains(&value) => Err(SentenceFault::Field(name)),
            value if side == sides[0] => Ok(value),
            value if side == sides[1] => Ok(-value),
            _ => Err(SentenceFault::Field(name)),
        }
    };
    Ok(GeoPoint {
        latitude_deg: angle(0, 2, ["N", "S"], 90.0, "latitude")?,
        longitude_deg: angle(2, 3, ["E", "W"], 180.0, "longitude")?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The usual example of NMEA 0183, whose fields gpsd's description gives.
    #[test]
    fn the_usual_position_is_read() {
        let body = "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W";
        let Ok(Reading::Position(Some(fix))) = reading(body) else { panic!("a position") };
        assert_eq!(fix.at, ClockTime { seconds: 45_319.0, date: Some((1994, 3, 23)) });
        assert!((fix.place.latitude_deg - 48.1173).abs() < 1e-9);
        assert!((fix.place.longitude_deg - 11.516_666_666_7).abs() < 1e-9);
        let (speed_mps, course_deg) = fix.way.expect("a way");
        assert!((speed_mps - 11.523_555_6).abs() < 1e-6 && course_deg == 84.4);
        let body = "GPGGA,092750.000,5321.6802,N,00630.3372,W,4,8,1.03,61.7,M,55.2,M,,";
        let Ok(Reading::Position(Some(fix))) = reading(body) else { panic!("a position") };
        assert_eq!((fix.at.seconds, fix.quality), (34_070.0, Some(4)));
        assert!((fix.place.longitude_deg + 6.505_62).abs() < 1e-9);
    }

    #[test]
    fn a_sentence_without_validity_gives_no_value() {
        assert_eq!(reading("GPRMC,123519,V,,,,,,,230394,,"), Ok(Reading::Position(None)));
        assert_eq!(reading("GPGGA,123519,,,,,0,00,,,M,,M,,"), Ok(Reading::Position(None)));
        assert_eq!(reading("HEHDT,274.1,T"), Ok(Reading::Heading(Some(274.1))));
        assert_eq!(reading("HETHS,274.1,V"), Ok(Reading::Heading(None)));
        assert_eq!(reading("HETHS,274.1,A"), Ok(Reading::Heading(Some(274.1))));
        assert_eq!(reading("TIROT,-4.5,A"), Ok(Reading::Turn(Some(-4.5))));
        assert_eq!(reading("TIROT,-4.5,V"), Ok(Reading::Turn(None)));
        let way = reading("GPVTG,054.7,T,034.4,M,3600.0,N,6667.2,K,A");
        assert_eq!(way, Ok(Reading::Way(Some(1852.0), Some(54.7))));
        assert_eq!(reading("GPGSV,1,1,00"), Ok(Reading::Other));
        assert_eq!(reading(""), Ok(Reading::Other));
    }

    #[test]
    fn a_field_of_another_form_is_named() {
        for (body, name) in [
            ("GPRMC,1235,A,4807.038,N,01131.000,E,1,1,230394,,", "time"),
            ("GPRMC,123519,A,48O7.038,N,01131.000,E,1,1,230394,,", "latitude"),
            ("GPRMC,123519,A,4807.038,N,01131.000,X,1,1,230394,,", "longitude"),
            ("GPRMC,123519,A,4807.038,N,01131.000,E,1,1,2303,,", "date"),
            ("GPRMC,123519,A,4807.038,N,01131.000,E,inf,1,230394,,", "speed"),
            ("HEHDT,north,T", "heading"),
        ] {
            assert_eq!(reading(body), Err(SentenceFault::Field(name)), "{body}");
        }
    }
}
