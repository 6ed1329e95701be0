//! NMEA 0183 logs of one ship, and AIS logs of all ships in reach.

use std::collections::BTreeMap;

use fenderline_keys::calendar::days_from_1970;
use fenderline_nautical::read::{
    AisReader, ClockTime, Fix, Reading, Report, SentenceFault, Static, Told, body_of, reading,
};
use fenderline_nautical::{ChartOrigin, GeoPoint};

use super::clock::{Clock, Moment};
use super::row::{Log, LogKind, LogRow};
use super::table::NO_ORIGIN;
use crate::mapping::Mapping;
use crate::remark::{Remarks, Tally, Weight};

/// Step of a position of AIS (°): a ten-thousandth of a minute.
const AIS_STEP_DEG: f64 = 1.0 / 600_000.0;
/// Step of a heading of AIS (°).
const AIS_HEADING_STEP_DEG: f64 = 1.0;
/// A heading is used for a position that came at most this long after it (s).
const HEADING_HOLDS_S: f64 = 3.0;

/// What a text holds, if it holds sentences.
pub(super) fn kind_of(text: &str) -> Option<LogKind> {
    let mut bodies = text.lines().take(200).filter_map(|line| body_of(line).ok());
    let (_, first) = bodies.next()?;
    let is_ais = first.get(2..5).is_some_and(|kind| kind == "VDM" || kind == "VDO");
    Some(if is_ais { LogKind::Ais } else { LogKind::Nmea })
}

/// Reads the sentences of a log.
pub(super) fn read(
    text: &str,
    file: &str,
    kind: LogKind,
    mapping: &Mapping,
    origin: Option<&ChartOrigin>,
    remarks: &mut Remarks,
) -> Vec<Log> {
    let Some(origin) = origin else {
        remarks.add(Weight::Refused, None, NO_ORIGIN);
        return Vec::new();
    };
    let mut faults = Faults::default();
    let logs = match kind {
        LogKind::Ais => ais(text, file, mapping, origin, &mut faults, remarks),
        _ => nmea(text, file, origin, &mut faults),
    };
    faults.tell(remarks);
    if logs.is_empty() {
        remarks.add(Weight::Refused, None, "the log has no position that can be used");
    }
    logs
}

#[derive(Default)]
struct Faults {
    damaged: Tally,
    fields: Tally,
    undated: Tally,
    no_heading: Tally,
}

impl Faults {
    fn note(&mut self, fault: &SentenceFault, line: usize) {
        match fault {
            SentenceFault::Field(_) => self.fields.add(line),
            _ => self.damaged.add(line),
        }
    }

    fn tell(self, remarks: &mut Remarks) {
        let rows = Weight::Rows;
        self.damaged.tell(
            remarks,
            rows,
            "line without a whole sentence: no or a wrong check sum",
            "lines without a whole sentence: no or a wrong check sum",
        );
        self.fields.tell(
            remarks,
            rows,
            "sentence with a field that cannot be read",
            "sentences with a field that cannot be read",
        );
        self.undated.tell(
            remarks,
            rows,
            "position without a known time",
            "positions without a known time",
        );
        self.no_heading.tell(
            remarks,
            rows,
            "position without a heading",
            "positions without a heading",
        );
    }
}

fn new_log(file: &str, kind: LogKind) -> Log {
    Log {
        file: file.to_owned(),
        kind,
        ship: String::new(),
        mmsi: None,
        extent_m: None,
        is_dated: true,
        steps: [f64::INFINITY; 3],
        rows: Vec::new(),
        kept: Vec::new(),
        ship_of_row: Vec::new(),
        names: vec![String::new()],
    }
}

fn push(log: &mut Log, row: LogRow) {
    log.rows.push(row);
    log.kept.push(Vec::new());
    log.ship_of_row.push(0);
}

/// The track of the ship whose instruments the sentences are of.
fn nmea(text: &str, file: &str, origin: &ChartOrigin, faults: &mut Faults) -> Vec<Log> {
    let mut log = new_log(file, LogKind::Nmea);
    log.steps = [0.0, 0.0, 0.1_f64.to_radians()];
    let mut date = None;
    let mut last_of_day_s = f64::NEG_INFINITY;
    let mut heading: Option<(f64, f64)> = None;
    let mut waiting: Option<(usize, f64, Fix)> = None;
    let mut now_s = f64::NEG_INFINITY;
    // A heading belongs to the position before it, or, if a log begins with a heading, to the position after it.
    let mut is_heading_first = None;
    for (index, line) in text.lines().enumerate() {
        let number = index + 1;
        if line.trim().is_empty() {
            continue;
        }
        let read = body_of(line).and_then(|(_, body)| reading(body));
        match read {
            Err(fault) => faults.note(&fault, number),
            Ok(Reading::Heading(Some(deg))) => {
                is_heading_first.get_or_insert(true);
                heading = Some((now_s, deg.to_radians()));
                if let Some((line, t_s, fix)) = waiting.take() {
                    push_fix(&mut log, line, t_s, &fix, deg.to_radians(), origin);
                }
            }
            Ok(Reading::Position(Some(fix))) => {
                let ClockTime { seconds, date: own } = fix.at;
                date = own.or(date);
                let Some((year, month, day)) = date else {
                    faults.undated.add(number);
                    continue;
                };
                is_heading_first.get_or_insert(false);
                let mut t_s = days_from_1970(year.into(), month.into(), day.into()) as f64
                    * 86_400.0
                    + seconds;
                // The date comes with RMC; GGA alone may already be past midnight.
                if own.is_none() && seconds < last_of_day_s - 43_200.0 {
                    t_s += 86_400.0;
                } else {
                    last_of_day_s = seconds;
                }
                // GGA and RMC of one moment tell the same position.
                if t_s == now_s {
                    continue;
                }
                if let Some((line, ..)) = waiting.take() {
                    faults.no_heading.add(line);
                }
                let before =
                    heading.filter(|(at_s, _)| t_s - at_s <= HEADING_HOLDS_S || !at_s.is_finite());
                match before {
                    Some((_, rad)) if is_heading_first == Some(true) => {
                        push_fix(&mut log, number, t_s, &fix, rad, origin);
                    }
                    None if is_heading_first == Some(true) => faults.no_heading.add(number),
                    _ => waiting = Some((number, t_s, fix)),
                }
                now_s = t_s;
            }
            Ok(_) => {}
        }
    }
    if let Some((line, ..)) = waiting {
        faults.no_heading.add(line);
    }
    if log.rows.is_empty() { Vec::new() } else { vec![log] }
}

fn push_fix(
    log: &mut Log,
    line: usize,
    t_s: f64,
    fix: &Fix,
    heading_rad: f64,
    origin: &ChartOrigin,
) {
    let [north_m, east_m] = origin.metres(fix.place);
    push(
        log,
        LogRow {
            line,
            t_s,
            readings: [north_m, east_m, heading_rad],
            speeds_mps: [f64::NAN; 2],
            angle_rad: f64::NAN,
        },
    );
}

/// Tracks of all ships of an AIS log.
fn ais(
    text: &str,
    file: &str,
    mapping: &Mapping,
    origin: &ChartOrigin,
    faults: &mut Faults,
    remarks: &mut Remarks,
) -> Vec<Log> {
    let mut reader = AisReader::default();
    let mut clock = Clock { zone_s: mapping.zone_s.unwrap_or(0.0), ..Clock::default() };
    let mut logs: BTreeMap<u32, Log> = BTreeMap::new();
    let mut ships: BTreeMap<u32, Static> = BTreeMap::new();
    for (index, line) in text.lines().enumerate() {
        let number = index + 1;
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        let told = body_of(line).and_then(|(before, body)| Ok((before, reader.read(body)?)));
        match told {
            Err(fault) => faults.note(&fault, number),
            Ok((_, Told::Static(own))) => {
                ships.insert(own.mmsi, own);
            }
            Ok((before, Told::Report(report))) => {
                let received_s = stamp_s(before, &mut clock);
                let Some(place) = report.place else { continue };
                let Some(received_s) = received_s else {
                    faults.undated.add(number);
                    continue;
                };
                let Some(heading_deg) = report.heading_deg else {
                    faults.no_heading.add(number);
                    continue;
                };
                let log = logs.entry(report.mmsi).or_insert_with(|| ais_log(file, &report, origin));
                let [north_m, east_m] = origin.metres(place);
                push(
                    log,
                    LogRow {
                        line: number,
                        t_s: sent_s(received_s, report.second),
                        readings: [north_m, east_m, heading_deg.to_radians()],
                        speeds_mps: [f64::NAN; 2],
                        angle_rad: f64::NAN,
                    },
                );
            }
            Ok(_) => {}
        }
    }
    if clock.is_zone_assumed && mapping.zone_s.is_none() {
        let text = "guessed: the times before the sentences are UTC; the mapping's `time_zone` gives another zone";
        remarks.add(Weight::Guess, None, text);
    }
    for (mmsi, own) in ships {
        if let Some(log) = logs.get_mut(&mmsi) {
            log.ship = own.name;
            log.extent_m = Some(own.extent_m).filter(|extent| extent[0] + extent[1] > 0.0);
        }
    }
    let named = logs.into_values().map(|mut log| {
        if log.ship.is_empty() {
            log.ship = format!("MMSI {}", log.mmsi.unwrap_or(0));
        }
        log.names = vec![log.ship.clone()];
        log
    });
    named.collect()
}

fn ais_log(file: &str, report: &Report, origin: &ChartOrigin) -> Log {
    let mut log = new_log(file, LogKind::Ais);
    log.mmsi = Some(report.mmsi);
    let at = report.place.unwrap_or(GeoPoint { latitude_deg: 0.0, longitude_deg: 0.0 });
    let [north_m, east_m] = origin.metres(at);
    let beside = GeoPoint {
        latitude_deg: at.latitude_deg + AIS_STEP_DEG,
        longitude_deg: at.longitude_deg + AIS_STEP_DEG,
    };
    let [north, east] = origin.metres(beside);
    log.steps = [north - north_m, east - east_m, AIS_HEADING_STEP_DEG.to_radians()];
    log
}

/// The time that a logger wrote before a sentence: as a time, or in a tag block `\c:1609841515*hh\`.
fn stamp_s(before: &str, clock: &mut Clock) -> Option<f64> {
    if let Some((_, rest)) = before.split_once("c:") {
        let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
        let seconds: f64 = digits.parse().ok()?;
        // Some receivers count milliseconds.
        return Some(if seconds > 1e11 { seconds / 1e3 } else { seconds });
    }
    let text = before.trim().trim_end_matches([',', ';', '|']).trim();
    match clock.read(text)? {
        Moment::Dated(s) => Some(s),
        Moment::Undated(_) => None,
    }
}

/// The moment of the measurement: the second of the minute that the report states, at or before the moment at which it
/// was received.
fn sent_s(received_s: f64, second: Option<u32>) -> f64 {
    let Some(second) = second else { return received_s };
    let minute_s = libm::floor(received_s / 60.0) * 60.0;
    let sent_s = minute_s + f64::from(second);
    // The report may state a second of the minute before, and the logger's clock may be a little late.
    match sent_s - received_s {
        ahead if ahead > 30.0 => sent_s - 60.0,
        ahead if ahead < -30.0 => sent_s + 60.0,
        _ => sent_s,
    }
}
