//! AIS messages from their sentences.

use super::fields::SentenceFault;
use crate::NAUTICAL_MILE_M;
use crate::chart::GeoPoint;

/// A position report: message 1, 2, 3 or 18. A value that the message says is not available is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// Maritime mobile service identity.
    pub mmsi: u32,
    /// Position of the antenna.
    pub place: Option<GeoPoint>,
    /// Whether the ship says that the position is better than 10 m.
    pub is_accurate: bool,
    /// Speed over ground (m/s), in steps of 0.1 kn.
    pub speed_mps: Option<f64>,
    /// Course over ground (°), in steps of 0.1°.
    pub course_deg: Option<f64>,
    /// Heading from true north (°), in steps of 1°.
    pub heading_deg: Option<f64>,
    /// Rate of turn, positive to starboard (°/min); only of ships with a rate-of-turn indicator.
    pub turn_deg_per_min: Option<f64>,
    /// Second of the minute in UTC, 0 to 59.
    pub second: Option<u32>,
}

/// Static data of a ship: message 5.
#[derive(Clone, Debug, PartialEq)]
pub struct Static {
    /// Maritime mobile service identity.
    pub mmsi: u32,
    /// Name of the ship.
    pub name: String,
    /// Distances from the antenna to bow, stern, port and starboard side (m); all 0 if not given.
    pub extent_m: [f64; 4],
    /// Draught (m); 0 if not given.
    pub draught_m: f64,
}

/// What a sentence of an AIS receiver told.
#[derive(Clone, Debug, PartialEq)]
pub enum Told {
    /// A position report.
    Report(Report),
    /// Static data.
    Static(Static),
    /// A part of a message whose other parts are missing as yet.
    Part,
    /// A message of another kind, or a sentence that is not of AIS.
    Other,
}

/// The parts of a message of several sentences that have come.
#[derive(Clone, Debug)]
struct Parts {
    key: (String, String),
    of: usize,
    letters: String,
    next: usize,
}

/// Largest number of messages whose parts are kept at a time.
const MOST_OPEN: usize = 16;

/// Reads the sentences of an AIS receiver, and puts messages of several sentences together.
#[derive(Clone, Debug, Default)]
pub struct AisReader {
    open: Vec<Parts>,
}

impl AisReader {
    /// Reads the body of a sentence, as [`super::body_of`] returns it.
    ///
    /// # Errors
    /// Names a field that does not hold what the format says, and a part without the parts before it.
    pub fn read(&mut self, body: &str) -> Result<Told, SentenceFault> {
        let fields: Vec<&str> = body.split(',').collect();
        if !matches!(fields[0].get(2..), Some("VDM" | "VDO")) {
            return Ok(Told::Other);
        }
        let [_, of, number, sequence, channel, letters, _fill] = fields[..] else {
            return Err(SentenceFault::Field("number of fields"));
        };
        let whole = |text: &str, name| match text.parse::<usize>() {
            Ok(value @ 1..=9) => Ok(value),
            _ => Err(SentenceFault::Field(name)),
        };
        let (of, number) = (whole(of, "number of parts")?, whole(number, "number of part")?);
        if of == 1 {
            return told(letters);
        }
        let key = (sequence.to_owned(), channel.to_owned());
        if number == 1 {
            self.open.retain(|parts| parts.key != key);
            if self.open.len() == MOST_OPEN {
                self.open.remove(0);
            }
            self.open.push(Parts { key, of, letters: letters.to_owned(), next: 2 });
            return Ok(Told::Part);
        }
        let place = self
            .open
            .iter()
            .position(|parts| parts.key == key && parts.of == of && parts.next == number);
        let place = place.ok_or(SentenceFault::Field("part without the parts before it"))?;
        let parts = &mut self.open[place];
        parts.letters.push_str(letters);
        parts.next += 1;
        if number < of {
            return Ok(Told::Part);
        }
        told(&self.open.remove(place).letters)
    }
}

/// The bits of a message, most significant first.
struct Bits(Vec<bool>);

impl Bits {
    /// The bits of the characters of a sentence.
    fn of(letters: &str) -> Result<Bits, SentenceFault> {
        let mut bits = Vec::with_capacity(6 * letters.len());
        for byte in letters.bytes() {
            let value = match byte {
                48..=87 => byte - 48,
                96..=119 => byte - 56,
                _ => return Err(SentenceFault::Field("payload")),
            };
            bits.extend((0..6).rev().map(|bit| value >> bit & 1 == 1));
        }
        Ok(Bits(bits))
    }

    fn unsigned(&self, from: usize, width: usize) -> Result<u32, SentenceFault> {
        let bits = self.0.get(from..from + width).ok_or(SentenceFault::Field("length"))?;
        Ok(bits.iter().fold(0, |value, bit| value << 1 | u32::from(*bit)))
    }

    fn signed(&self, from: usize, width: usize) -> Result<i32, SentenceFault> {
        let value = self.unsigned(from, width)? << (32 - width);
        Ok(value as i32 >> (32 - width))
    }

    fn text(&self, from: usize, letters: usize) -> Result<String, SentenceFault> {
        let mut text = String::new();
        for letter in 0..letters {
            let value = self.unsigned(from + 6 * letter, 6)? as u8;
            text.push(char::from(if value < 32 { value + 64 } else { value }));
        }
        // `@` ends a text.
        Ok(text.split('@').next().unwrap_or_default().trim_end().to_owned())
    }
}

fn told(letters: &str) -> Result<Told, SentenceFault> {
    let bits = Bits::of(letters)?;
    let mmsi = bits.unsigned(8, 30)?;
    match bits.unsigned(0, 6)? {
        1..=3 => {
            let turn = bits.signed(42, 8)?;
            let report = report(&bits, mmsi, 50)?;
            // ±127: turns faster than a limit, without an indicator; −128: not available.
            let known = (-126..=126).contains(&turn).then(|| {
                let root = f64::from(turn) / 4.733;
                root * root.abs()
            });
            Ok(Told::Report(Report { turn_deg_per_min: known, ..report }))
        }
        18 => report(&bits, mmsi, 46).map(Told::Report),
        5 => {
            let metres = |from, width| bits.unsigned(from, width).map(f64::from);
            Ok(Told::Static(Static {
                mmsi,
                name: bits.text(112, 20)?,
                extent_m: [metres(240, 9)?, metres(249, 9)?, metres(258, 6)?, metres(264, 6)?],
                draught_m: metres(294, 8)? / 10.0,
            }))
        }
        _ => Ok(Told::Other),
    }
}

/// The fields that the position reports share, from the speed at bit `from`.
fn report(bits: &Bits, mmsi: u32, from: usize) -> Result<Report, SentenceFault> {
    let speed = bits.unsigned(from, 10)?;
    let longitude_deg = f64::from(bits.signed(from + 11, 28)?) / 600_000.0;
    let latitude_deg = f64::from(bits.signed(from + 39, 27)?) / 600_000.0;
    let is_known = latitude_deg.abs() <= 90.0 && longitude_deg.abs() <= 180.0;
    let course = bits.unsigned(from + 66, 12)?;
    let heading = bits.unsigned(from + 78, 9)?;
    let second = bits.unsigned(from + 87, 6)?;
    Ok(Report {
        mmsi,
        place: is_known.then_some(GeoPoint { latitude_deg, longitude_deg }),
        is_accurate: bits.unsigned(from + 10, 1)? == 1,
        // 1023: not available; 1022: 102.2 kn or more.
        speed_mps: (speed < 1022).then(|| f64::from(speed) * NAUTICAL_MILE_M / 36_000.0),
        course_deg: (course < 3600).then(|| f64::from(course) / 10.0),
        heading_deg: (heading < 360).then(|| f64::from(heading)),
        turn_deg_per_min: None,
        second: (second < 60).then_some(second),
    })
}

#[cfg(test)]
mod tests {
    use super::super::fields::body_of;
    use super::*;
    use crate::{PositionReport, ShipData, ais_position, ais_ship_data};

    fn read(lines: &[String]) -> Told {
        let mut reader = AisReader::default();
        let mut last = Told::Other;
        for line in lines {
            last = reader.read(body_of(line).expect("whole").1).expect("read");
        }
        last
    }

    /// The published messages of the tests of the writer, with the fields that gpsd's description gives.
    #[test]
    fn published_messages_are_read() {
        let told = read(&["!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C".into()]);
        let Told::Report(report) = told else { panic!("a report") };
        assert_eq!((report.mmsi, report.second), (477_553_000, Some(15)));
        let place = report.place.expect("a place");
        assert!((place.latitude_deg - 47.582_833_333).abs() < 1e-6);
        assert!((place.longitude_deg + 122.345_833_333).abs() < 1e-6);
        assert_eq!((report.speed_mps, report.course_deg), (Some(0.0), Some(51.0)));
        assert_eq!((report.heading_deg, report.turn_deg_per_min), (Some(181.0), Some(0.0)));
        let told = read(&[
            "!AIVDM,2,1,1,A,55?MbV02;H;s<HtKR20EHE:0@T4@Dn2222222216L961O5Gf0NSQEp6ClRp8,0*1C"
                .into(),
            "!AIVDM,2,2,1,A,88888888880,2*25".into(),
        ]);
        let Told::Static(data) = told else { panic!("static data") };
        assert_eq!((data.mmsi, data.name.as_str()), (351_759_000, "EVER DIADEM"));
        assert_eq!((data.extent_m, data.draught_m), ([225.0, 70.0, 1.0, 31.0], 12.2));
    }

    #[test]
    fn what_the_writer_writes_is_read_back() {
        let own = PositionReport {
            mmsi: 244_000_123,
            status: 0,
            turn_radps: -0.002,
            speed_mps: 1.5 * NAUTICAL_MILE_M / 3600.0,
            place: GeoPoint { latitude_deg: -51.95, longitude_deg: 4.123_45 },
            course_rad: 5.0,
            heading_rad: 4.9,
            second: 7,
            radio: 0,
        };
        let Told::Report(report) = read(&ais_position(&own, false)) else { panic!("a report") };
        let place = report.place.expect("a place");
        assert!((place.latitude_deg + 51.95).abs() < 1e-6);
        assert!((place.longitude_deg - 4.123_45).abs() < 1e-6);
        assert!((report.speed_mps.expect("a speed") - own.speed_mps).abs() < 1e-9);
        // AIS rounds 4.733 times the root of the rate, here in steps of 1.1° a minute: half a step.
        assert!((report.turn_deg_per_min.expect("a turn") + 6.9).abs() < 0.56);
        let data = ShipData {
            mmsi: 244_000_123,
            imo: 0,
            call_sign: "PA1".into(),
            name: "MADE UP".into(),
            kind: 80,
            extent_m: [200.0, 50.0, 20.0, 12.0],
            device: 1,
            arrival: (0, 0, 24, 60),
            draught_m: 11.3,
            destination: String::new(),
        };
        let Told::Static(read) = read(&ais_ship_data(&data, false, 3)) else { panic!("static") };
        assert_eq!((read.name.as_str(), read.extent_m), ("MADE UP", data.extent_m));
        assert!((read.draught_m - 11.3).abs() < 1e-9);
    }

    /// A class B report from gpsd's description of AIVDM, as pyais reads it.
    #[test]
    fn a_report_of_class_b_is_read() {
        let told = read(&["!AIVDM,1,1,,A,B52K>;h00Fc>jpUlNV@ikwpUoP06,0*4C".into()]);
        let Told::Report(report) = told else { panic!("a report") };
        assert_eq!(report.mmsi, 338_087_471);
        let place = report.place.expect("a place");
        assert!((place.latitude_deg - 40.684_54).abs() < 1e-5, "{place:?}");
        assert!((place.longitude_deg + 74.072_132).abs() < 1e-5, "{place:?}");
        assert_eq!((report.course_deg, report.heading_deg), (Some(79.6), None));
    }

    #[test]
    fn a_second_part_alone_and_a_short_message_are_refused() {
        let mut reader = AisReader::default();
        let alone = reader.read("AIVDM,2,2,1,A,88888888880,2");
        assert_eq!(alone, Err(SentenceFault::Field("part without the parts before it")));
        assert_eq!(reader.read("AIVDM,1,1,,B,177K,0"), Err(SentenceFault::Field("length")));
        assert_eq!(reader.read("AIVDM,1,1,,B,1~~,0"), Err(SentenceFault::Field("payload")));
        assert_eq!(reader.read("AIVDM,1"), Err(SentenceFault::Field("number of fields")));
        assert_eq!(reader.read("GPGSV,1,1,00"), Ok(Told::Other));
    }
}
