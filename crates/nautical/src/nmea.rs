//! Writes NMEA 0183 sentences of the own ship's instruments.

use core::f64::consts::TAU;

use crate::NAUTICAL_MILE_M;
use crate::chart::GeoPoint;
use crate::sentence::sentence;

/// A moment of UTC.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Year, all four digits.
    pub year: u32,
    /// Month, 1 to 12.
    pub month: u32,
    /// Day, 1 to 31.
    pub day: u32,
    /// Seconds since midnight.
    pub seconds: f64,
}

impl Moment {
    /// Date and time from seconds since the start of 1970, in the Gregorian calendar (Hinnant's days-to-civil
    /// algorithm).
    #[must_use]
    pub fn from_unix(seconds: f64) -> Moment {
        let days = libm::floor(seconds / 86_400.0);
        let from_march_0 = days as i64 + 719_468;
        let era = from_march_0.div_euclid(146_097);
        let of_era = from_march_0.rem_euclid(146_097);
        let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
        let day_of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
        let months = (5 * day_of_year + 2) / 153;
        let month = if months < 10 { months + 3 } else { months - 9 };
        let year = year_of_era + era * 400 + i64::from(month <= 2);
        Moment {
            year: year as u32,
            month: month as u32,
            day: (day_of_year - (153 * months + 2) / 5 + 1) as u32,
            seconds: seconds - days * 86_400.0,
        }
    }
}

/// A propeller's shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    /// Number of the propeller shaft; 0 for a ship with one shaft.
    pub number: u32,
    /// Revolutions, negative astern (1/s).
    pub rps: f64,
}

/// The values that the instruments of a ship measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Instruments {
    /// Time of the measurements.
    pub at: Moment,
    /// Position of the ship's antenna on the earth.
    pub place: GeoPoint,
    /// Heading from true north (rad).
    pub heading_rad: f64,
    /// Course over ground from true north (rad). The course over ground is used only while the ship moves.
    pub course_rad: f64,
    /// Rate of turn, positive to starboard (rad/s).
    pub turn_radps: f64,
    /// Velocity over ground, ahead and to starboard (m/s).
    pub ground_mps: [f64; 2],
    /// Velocity through the water, ahead and to starboard (m/s).
    pub water_mps: [f64; 2],
    /// Transverse velocity at the stern, to starboard, through the water and over ground (m/s).
    pub stern_mps: [f64; 2],
    /// Relative wind: direction from which it comes, clockwise from the bow (rad), and speed (m/s).
    pub wind_over_deck: (f64, f64),
    /// True wind: direction from which it comes, clockwise from the bow (rad), and speed (m/s).
    pub true_wind: (f64, f64),
    /// Depth of water below the transducer, and depth of the keel below the transducer (m); `None` in deep water.
    pub depth_m: Option<(f64, f64)>,
    /// Rudder angle, positive to starboard (rad); `None` without a rudder.
    pub rudder_rad: Option<f64>,
    /// Shafts.
    pub shafts: Vec<Shaft>,
}

const KNOT_MPS: f64 = NAUTICAL_MILE_M / 3600.0;

/// The sentences HDT, ROT, RMC, VTG, VBW, MWV (relative and true), DPT, RSA and RPM, with line ends.
///
/// Each sentence begins with its talker: `HE` gyro compass, `TI` rate-of-turn indicator, `GP` satellite receiver, `VW`
/// log, `WI` weather instruments, `SD` depth sounder, `AG` rudder, `ER` engine room.
#[must_use]
pub fn instruments(of: &Instruments) -> Vec<String> {
    let [ahead_mps, across_mps] = of.ground_mps;
    let speed_kn = libm::hypot(ahead_mps, across_mps) / KNOT_MPS;
    // A ship at rest has no course over ground; instruments show her heading.
    let course_rad = if speed_kn > 0.01 { of.course_rad } else { of.heading_rad };
    let heading_deg = degrees(of.heading_rad, 1);
    let course_deg = degrees(course_rad, 1);
    let mut all = vec![
        sentence('$', &format!("HEHDT,{heading_deg:.1},T")),
        sentence('$', &format!("TIROT,{:.1},A", 60.0 * of.turn_radps.to_degrees())),
        sentence('$', &rmc(of, speed_kn, course_deg)),
        sentence(
            '$',
            &format!("GPVTG,{course_deg:.1},T,,M,{speed_kn:.2},N,{:.2},K,S", speed_kn * 1.852),
        ),
        sentence('$', &vbw(of)),
        sentence('$', &mwv(of.wind_over_deck, 'R')),
        sentence('$', &mwv(of.true_wind, 'T')),
    ];
    if let Some((depth_m, keel_m)) = of.depth_m {
        all.push(sentence('$', &format!("SDDPT,{depth_m:.1},{:.1}", 0.0 - keel_m)));
    }
    if let Some(rudder_rad) = of.rudder_rad {
        all.push(sentence('$', &format!("AGRSA,{:.1},A,,V", rudder_rad.to_degrees())));
    }
    for shaft in &of.shafts {
        // The propeller's pitch is fixed: 100 %.
        let body = format!("ERRPM,S,{},{:.1},100.0,A", shaft.number, 60.0 * shaft.rps);
        all.push(sentence('$', &body));
    }
    all
}

/// An angle in [0, 360) in degrees, rounded so that 359.96 is not printed as 360.0.
fn degrees(angle_rad: f64, decimals: i32) -> f64 {
    let scale = libm::pow(10.0, f64::from(decimals));
    let turned = libm::fmod(libm::fmod(angle_rad, TAU) + TAU, TAU).to_degrees();
    libm::fmod(libm::round(turned * scale), 360.0 * scale) / scale
}

/// A latitude or longitude in degrees and minutes with the hemisphere: `4807.03800,N`.
fn angle(value_deg: f64, width: usize, sides: [char; 2]) -> String {
    // In units of the last digit, so that minutes are never rounded to 60.
    let units = libm::round(value_deg.abs() * 60.0 * 1e5) as u64;
    let (minutes, rest) = (units / 100_000, units % 100_000);
    let side = if value_deg < 0.0 { sides[1] } else { sides[0] };
    format!("{:0width$}{:02}.{rest:05},{side}", minutes / 60, minutes % 60)
}

fn rmc(of: &Instruments, speed_kn: f64, course_deg: f64) -> String {
    let Moment { year, month, day, seconds } = of.at;
    let hundredths = libm::floor(seconds * 100.0) as u64;
    let (whole, part) = (hundredths / 100, hundredths % 100);
    format!(
        "GPRMC,{:02}{:02}{:02}.{part:02},A,{},{},{speed_kn:.2},{course_deg:.1},{day:02}{month:02}{:02},,,S",
        whole / 3600,
        whole / 60 % 60,
        whole % 60,
        angle(of.place.latitude_deg, 2, ['N', 'S']),
        angle(of.place.longitude_deg, 3, ['E', 'W']),
        year % 100,
    )
}

fn vbw(of: &Instruments) -> String {
    let kn = |mps: f64| format!("{:.2}", mps / KNOT_MPS);
    let ([water, across], [ground, over]) = (of.water_mps, of.ground_mps);
    let [stern_water, stern_ground] = of.stern_mps;
    format!(
        "VWVBW,{},{},A,{},{},A,{},A,{},A",
        kn(water),
        kn(across),
        kn(ground),
        kn(over),
        kn(stern_water),
        kn(stern_ground)
    )
}

fn mwv((from_rad, speed_mps): (f64, f64), reference: char) -> String {
    format!("WIMWV,{:.1},{reference},{:.1},N,A", degrees(from_rad, 1), speed_mps / KNOT_MPS)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unix time 1,000,000,000 is 9 September 2001, 01:46:40.
    #[test]
    fn dates_from_unix_time() {
        let of = |seconds| {
            let Moment { year, month, day, seconds } = Moment::from_unix(seconds);
            (year, month, day, seconds)
        };
        assert_eq!(of(1e9), (2001, 9, 9, 6400.0));
        assert_eq!(of(0.0), (1970, 1, 1, 0.0));
        assert_eq!(of(951_782_400.0), (2000, 2, 29, 0.0));
        assert_eq!(of(1_735_689_599.5), (2024, 12, 31, 86_399.5));
    }

    #[test]
    fn minutes_of_a_position_are_never_rounded_to_sixty() {
        assert_eq!(angle(48.1173, 2, ['N', 'S']), "4807.03800,N");
        assert_eq!(angle(-11.516_666_67, 3, ['E', 'W']), "01131.00000,W");
        assert_eq!(angle(9.999_999_99, 3, ['E', 'W']), "01000.00000,E");
        assert_eq!(degrees(-0.0001, 1), 0.0);
        assert_eq!(degrees(-0.01, 1), 359.4);
    }
}
