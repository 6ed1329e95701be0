//! AIS messages: position reports and ship data, encoded in sentences of six-bit characters.

use core::f64::consts::TAU;

use crate::NAUTICAL_MILE_M;
use crate::chart::GeoPoint;
use crate::sentence::sentence;

/// A position report of a ship (AIS message 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionReport {
    /// Maritime mobile service identity, nine digits.
    pub mmsi: u32,
    /// Navigational status of the ship: 0 under way with her engine, 5 moored, 8 under sail, 15 not defined.
    pub status: u8,
    /// Rate of turn, positive to starboard (rad/s).
    pub turn_radps: f64,
    /// Speed over ground (m/s).
    pub speed_mps: f64,
    /// Position of her antenna.
    pub place: GeoPoint,
    /// Course over ground (rad).
    pub course_rad: f64,
    /// Heading from true north (rad).
    pub heading_rad: f64,
    /// Second of the minute in UTC, 0 to 59.
    pub second: u8,
    /// Radio status, 19 bits; receivers ignore it in reports that no radio sent.
    pub radio: u32,
}

/// Static and voyage data of a ship (AIS message 5).
#[derive(Clone, Debug, PartialEq)]
pub struct ShipData {
    /// Maritime mobile service identity, nine digits.
    pub mmsi: u32,
    /// IMO number of the ship; 0: not available.
    pub imo: u32,
    /// Up to 7 characters.
    pub call_sign: String,
    /// Name of the ship, up to 20 characters; a character that AIS does not have becomes `?`.
    pub name: String,
    /// Type of ship and cargo: 52 a tug, 70 a cargo ship, 80 a tanker.
    pub kind: u8,
    /// Distances from the antenna to bow, stern, port and starboard side (m).
    pub extent_m: [f64; 4],
    /// Position fixing device: 1 GPS, 0 undefined.
    pub device: u8,
    /// Estimated time of arrival of the ship: month, day, hour, minute; (0, 0, 24, 60): not available.
    pub arrival: (u8, u8, u8, u8),
    /// Draught (m).
    pub draught_m: f64,
    /// Up to 20 characters.
    pub destination: String,
}

/// The bits of an AIS message, most significant first.
#[derive(Default)]
struct Bits(Vec<bool>);

impl Bits {
    fn unsigned(&mut self, value: u32, width: u32) {
        for bit in (0..width).rev() {
            self.0.push(value >> bit & 1 == 1);
        }
    }

    fn signed(&mut self, value: i32, width: u32) {
        self.unsigned(value as u32, width);
    }

    /// Writes a text in characters of six bits: `@` to `_`, space to `?`; lower case becomes upper case, and `@` fills
    /// the end.
    fn text(&mut self, text: &str, letters: usize) {
        let mut all = text.chars().map(|c| match c.to_ascii_uppercase() {
            c @ '@'..='_' => c as u32 - 64,
            c @ ' '..='?' => c as u32,
            _ => '?' as u32,
        });
        for _ in 0..letters {
            self.unsigned(all.next().unwrap_or(0), 6);
        }
    }

    /// The bits of a message as characters of a sentence, and the number of bits that fill up the last character.
    fn armoured(&self) -> (String, usize) {
        let letter = |bits: &[bool]| {
            let value =
                (0..6).fold(0_u8, |value, at| value << 1 | u8::from(bits.get(at) == Some(&true)));
            char::from(if value < 40 { value + 48 } else { value + 56 })
        };
        let text = self.0.chunks(6).map(letter).collect();
        (text, (6 - self.0.len() % 6) % 6)
    }
}

/// Largest number of characters of a message in one sentence: a sentence has at most 82 characters, of which 62 are
/// left for the message.
const LETTERS: usize = 60;

/// The sentences of an AIS message: `AIVDM` for other ships, `AIVDO` for the own ship.
fn sentences(bits: &Bits, own: bool, channel: char, sequence: u8) -> Vec<String> {
    let (text, fill) = bits.armoured();
    let talker = if own { "AIVDO" } else { "AIVDM" };
    let count = text.len().div_ceil(LETTERS);
    let parts = text.as_bytes().chunks(LETTERS).enumerate();
    let part = |(index, letters): (usize, &[u8])| {
        let letters: String = letters.iter().map(|&letter| char::from(letter)).collect();
        let number = if count > 1 { (sequence % 10).to_string() } else { String::new() };
        let fill = if index + 1 == count { fill } else { 0 };
        let body = format!("{talker},{count},{},{number},{channel},{letters},{fill}", index + 1);
        sentence('!', &body)
    };
    parts.map(part).collect()
}

/// A rate of turn in AIS's form: 4.733 √|°/min| with the sign of the turn, at most ±126.
fn turn(turn_radps: f64) -> i32 {
    let deg_per_min = 60.0 * turn_radps.to_degrees();
    let size = libm::fmin(libm::round(4.733 * libm::sqrt(deg_per_min.abs())), 126.0);
    (size as i32) * if deg_per_min < 0.0 { -1 } else { 1 }
}

/// An angle in [0, 360°), as a whole number of units of 1/`per_deg` degree.
fn bearing(angle_rad: f64, per_deg: f64) -> u32 {
    let turned = libm::fmod(libm::fmod(angle_rad, TAU) + TAU, TAU).to_degrees();
    libm::fmod(libm::round(turned * per_deg), 360.0 * per_deg) as u32
}

/// The sentences of a position report; `own` says that the report is the own ship's.
#[must_use]
pub fn ais_position(of: &PositionReport, own: bool) -> Vec<String> {
    let mut bits = Bits::default();
    bits.unsigned(1, 6);
    bits.unsigned(0, 2);
    bits.unsigned(of.mmsi, 30);
    bits.unsigned(u32::from(of.status), 4);
    bits.signed(turn(of.turn_radps), 8);
    // Tenths of a knot; 1022 stands for 102.2 and more.
    bits.unsigned((libm::round(of.speed_mps * 36_000.0 / NAUTICAL_MILE_M) as u32).min(1022), 10);
    bits.unsigned(0, 1);
    bits.signed(libm::round(of.place.longitude_deg * 600_000.0) as i32, 28);
    bits.signed(libm::round(of.place.latitude_deg * 600_000.0) as i32, 27);
    bits.unsigned(bearing(of.course_rad, 10.0), 12);
    bits.unsigned(bearing(of.heading_rad, 1.0), 9);
    bits.unsigned(u32::from(of.second), 6);
    // Special manoeuvre not available, spare, no integrity monitoring.
    bits.unsigned(0, 6);
    bits.unsigned(of.radio, 19);
    sentences(&bits, own, 'B', 0)
}

/// The two sentences of a ship's static and voyage data. `sequence` links the two sentences and changes from message to
/// message.
#[must_use]
pub fn ais_ship_data(of: &ShipData, own: bool, sequence: u8) -> Vec<String> {
    let mut bits = Bits::default();
    bits.unsigned(5, 6);
    bits.unsigned(0, 2);
    bits.unsigned(of.mmsi, 30);
    bits.unsigned(0, 2);
    bits.unsigned(of.imo, 30);
    bits.text(&of.call_sign, 7);
    bits.text(&of.name, 20);
    bits.unsigned(u32::from(of.kind), 8);
    let [bow, stern, port, starboard] = of.extent_m.map(libm::round);
    bits.unsigned((bow as u32).min(511), 9);
    bits.unsigned((stern as u32).min(511), 9);
    bits.unsigned((port as u32).min(63), 6);
    bits.unsigned((starboard as u32).min(63), 6);
    bits.unsigned(u32::from(of.device), 4);
    let (month, day, hour, minute) = of.arrival;
    bits.unsigned(u32::from(month), 4);
    bits.unsigned(u32::from(day), 5);
    bits.unsigned(u32::from(hour), 5);
    bits.unsigned(u32::from(minute), 6);
    bits.unsigned((libm::round(of.draught_m * 10.0) as u32).min(255), 8);
    bits.text(&of.destination, 20);
    // Data terminal ready; spare.
    bits.unsigned(0, 2);
    sentences(&bits, own, 'A', sequence)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of the AIVDM article of Wikipedia and of gpsd, with its decoded fields. `check.py` reads the
    /// sentences with two parsers.
    #[test]
    fn a_published_position_report_is_reproduced() {
        let report = PositionReport {
            mmsi: 477_553_000,
            status: 5,
            turn_radps: 0.0,
            speed_mps: 0.0,
            place: GeoPoint { latitude_deg: 47.582_833_333, longitude_deg: -122.345_833_333 },
            course_rad: 51.0_f64.to_radians(),
            heading_rad: 181.0_f64.to_radians(),
            second: 15,
            radio: 149_208,
        };
        let text = "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\r\n";
        assert_eq!(ais_position(&report, false), [text]);
    }

    #[test]
    fn published_ship_data_are_reproduced() {
        let data = ShipData {
            mmsi: 351_759_000,
            imo: 9_134_270,
            // The published message is padded with spaces, not with `@`.
            call_sign: "3FOF8  ".into(),
            name: format!("{:20}", "EVER DIADEM"),
            kind: 70,
            extent_m: [225.0, 70.0, 1.0, 31.0],
            device: 1,
            arrival: (5, 15, 14, 0),
            draught_m: 12.2,
            destination: format!("{:20}", "NEW YORK"),
        };
        let first =
            "!AIVDM,2,1,1,A,55?MbV02;H;s<HtKR20EHE:0@T4@Dn2222222216L961O5Gf0NSQEp6ClRp8,0*1C\r\n";
        let second = "!AIVDM,2,2,1,A,88888888880,2*25\r\n";
        assert_eq!(ais_ship_data(&data, false, 1), [first, second]);
    }

    #[test]
    fn rates_of_turn_follow_the_formula_up_to_its_limit() {
        let at = |deg_per_min: f64| turn((deg_per_min / 60.0).to_radians());
        assert_eq!(
            (at(0.0), at(10.0), at(-10.0), at(5000.0), at(-5000.0)),
            (0, 15, -15, 126, -126)
        );
    }
}
