//! Docking logs and tracks as tables of text.

use fenderline_nautical::{ChartOrigin, GeoPoint};

use super::clock::{Clock, Moment};
use super::column::number;
use super::columns::Columns;
use super::row::{Log, LogKind, LogRow, Quantity};
use crate::mapping::Mapping;
use crate::remark::{Remarks, Tally, Weight};

/// What is needed of each kind of table.
const DOCKING: [Quantity; 3] = [Quantity::Time, Quantity::BowDistance, Quantity::SternDistance];
const TRACK: [Quantity; 4] =
    [Quantity::Time, Quantity::Latitude, Quantity::Longitude, Quantity::Heading];

/// A record of a table, with its line.
type Record = (usize, csv::StringRecord);

/// What was counted while the rows were read.
#[derive(Default)]
struct Counted {
    times: Tally,
    undated: Tally,
    lost: Tally,
    outside: Tally,
    elsewhere: Tally,
}

/// Reads a table; `kind` is that of the mapping.
pub(super) fn read(
    text: &str,
    file: &str,
    kind: Option<LogKind>,
    mapping: &Mapping,
    origin: Option<&ChartOrigin>,
    remarks: &mut Remarks,
) -> Vec<Log> {
    match try_read(text, file, kind, mapping, origin, remarks) {
        Ok(log) => vec![log],
        Err((line, why)) => {
            remarks.add(Weight::Refused, line, why);
            Vec::new()
        }
    }
}

type Refusal = (Option<usize>, String);

fn try_read(
    text: &str,
    file: &str,
    kind: Option<LogKind>,
    mapping: &Mapping,
    origin: Option<&ChartOrigin>,
    remarks: &mut Remarks,
) -> Result<Log, Refusal> {
    let is_head = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
    let head = text.lines().find(is_head).ok_or((None, "the log is empty".to_owned()))?;
    let separator = [';', '\t', ','].into_iter().find(|c| head.contains(*c)).unwrap_or(',');
    let has_comma = separator == ';';
    let mut records = records(text, separator)?.into_iter();
    let (head_line, head) = records.next().ok_or((None, "the log is empty".to_owned()))?;
    let heads: Vec<String> = head.iter().map(|cell| cell.trim().to_owned()).collect();
    if heads.iter().filter(|head| number(head, has_comma).is_some()).count() * 2 > heads.len() {
        let why = "the first line must name the columns, but it holds numbers";
        return Err((Some(head_line), why.to_owned()));
    }
    let columns =
        Columns::find(&heads, mapping, remarks, head_line).map_err(|why| (Some(head_line), why))?;
    let kind = kind.unwrap_or(match columns.has(Quantity::Latitude) {
        true => LogKind::Track,
        false => LogKind::Docking,
    });
    let needed: &[Quantity] = if kind == LogKind::Track { &TRACK } else { &DOCKING };
    if let Some(missing) = columns.lacks(needed) {
        let why = format!(
            "the log has no column of the {missing}; name it in the mapping, under [columns]"
        );
        return Err((Some(head_line), why));
    }
    if kind == LogKind::Docking && mapping.sensors.is_none() {
        let why = "nobody knows where the sensors stand; the mapping says so, as \
                   bow_sensor = { place = \"45 m\" } and stern_sensor = { place = \"-45 m\" }";
        return Err((None, why.to_owned()));
    }
    if kind == LogKind::Track && origin.is_none() {
        return Err((None, NO_ORIGIN.to_owned()));
    }
    let records: Vec<Record> = records.collect();
    let mut reader = RowReader::new(&columns, kind, mapping, origin, has_comma, &records);
    let mut log = Log {
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
        names: Vec::new(),
    };
    for (line, record) in &records {
        reader.add(&mut log, *line, record);
    }
    reader.finish(&mut log, mapping, remarks)?;
    Ok(log)
}

/// Why a track cannot be read without an origin.
pub(super) const NO_ORIGIN: &str = "the scenario has no [chart] with an origin in latitude and longitude; the mapping \
    gives one, as origin = { latitude = \"51.95 deg\", longitude = \"4.05 deg\" }";

fn records(text: &str, separator: char) -> Result<Vec<Record>, Refusal> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .delimiter(separator as u8)
        .from_reader(text.as_bytes());
    let mut all = Vec::new();
    // The reader's positions do not count empty lines.
    for record in reader.records() {
        let record = record.map_err(|why| (None, why.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line) as usize;
        all.push((line, record));
    }
    Ok(all)
}

struct RowReader<'a> {
    columns: &'a Columns,
    kind: LogKind,
    mapping: &'a Mapping,
    origin: Option<&'a ChartOrigin>,
    has_comma: bool,
    clock: Clock,
    counted: Counted,
    /// Names of other berths.
    others: Vec<String>,
    /// Midnights that have passed in a log without dates.
    midnights_s: f64,
    last_s: f64,
}

impl<'a> RowReader<'a> {
    fn new(
        columns: &'a Columns,
        kind: LogKind,
        mapping: &'a Mapping,
        origin: Option<&'a ChartOrigin>,
        has_comma: bool,
        records: &[Record],
    ) -> RowReader<'a> {
        let column = columns.get(Quantity::Date).or(columns.get(Quantity::Time));
        let dates = records.iter().filter_map(|(_, record)| record.get(column?.place));
        RowReader {
            columns,
            kind,
            mapping,
            origin,
            has_comma,
            clock: Clock::of(mapping, dates),
            counted: Counted::default(),
            others: Vec::new(),
            midnights_s: 0.0,
            last_s: f64::NEG_INFINITY,
        }
    }

    fn cell<'r>(&self, record: &'r csv::StringRecord, quantity: Quantity) -> Option<&'r str> {
        record.get(self.columns.get(quantity)?.place).map(str::trim)
    }

    /// A number in SI and the step of its last digit.
    fn number(&self, record: &csv::StringRecord, quantity: Quantity) -> Option<(f64, f64)> {
        let factor = self.columns.get(quantity)?.factor;
        let cell = self.cell(record, quantity)?;
        if self.mapping.lost.iter().any(|lost| lost == cell) {
            return None;
        }
        number(cell, self.has_comma).map(|(value, step)| (value * factor, step * factor))
    }

    fn moment(&mut self, record: &csv::StringRecord) -> Option<f64> {
        let time = self.cell(record, Quantity::Time)?.to_owned();
        let text = match self.cell(record, Quantity::Date) {
            Some(date) => format!("{date} {time}"),
            None => time,
        };
        match self.clock.read(&text)? {
            Moment::Dated(s) => Some(s),
            Moment::Undated(s) => {
                if s + self.midnights_s < self.last_s - 43_200.0 {
                    self.midnights_s += 86_400.0;
                }
                self.last_s = s + self.midnights_s;
                Some(self.last_s)
            }
        }
    }

    fn add(&mut self, log: &mut Log, line: usize, record: &csv::StringRecord) {
        if let (Some(wanted), Some(berth)) =
            (&self.mapping.berth, self.cell(record, Quantity::Berth))
            && !berth.eq_ignore_ascii_case(wanted)
        {
            self.counted.elsewhere.add(line);
            return;
        }
        if let Some(berth) = self.cell(record, Quantity::Berth)
            && self.others.iter().all(|other| other != berth)
        {
            self.others.push(berth.to_owned());
        }
        let Some(t_s) = self.moment(record) else {
            self.counted.times.add(line);
            return;
        };
        if t_s < 1e8 {
            self.counted.undated.add(line);
        }
        let (readings, steps) = match self.kind {
            LogKind::Docking => self.distances(line, record),
            _ => self.place(line, record),
        };
        for (step, own) in log.steps.iter_mut().zip(steps) {
            if own < *step {
                *step = own;
            }
        }
        let of = |quantity| self.number(record, quantity).map_or(f64::NAN, |(value, _)| value);
        log.rows.push(LogRow {
            line,
            t_s,
            readings,
            speeds_mps: [of(Quantity::BowSpeed), of(Quantity::SternSpeed)],
            angle_rad: of(Quantity::Angle),
        });
        let kept = self.columns.kept.iter();
        log.kept.push(
            kept.map(|place| record.get(*place).unwrap_or_default().trim().to_owned()).collect(),
        );
        let name = self.cell(record, Quantity::Ship).unwrap_or_default();
        let index = log.names.iter().position(|own| own == name).unwrap_or_else(|| {
            log.names.push(name.to_owned());
            log.names.len() - 1
        });
        log.ship_of_row.push(index);
    }

    fn distances(&mut self, line: usize, record: &csv::StringRecord) -> ([f64; 3], [f64; 3]) {
        let farthest_m = self.mapping.farthest_m;
        let mut is_lost = false;
        let mut one = |quantity| match self.number(record, quantity) {
            Some((value, step)) if value > -20.0 && value <= farthest_m => (value, step),
            _ => {
                is_lost = true;
                (f64::NAN, f64::INFINITY)
            }
        };
        let (bow, stern) = (one(Quantity::BowDistance), one(Quantity::SternDistance));
        if is_lost {
            self.counted.lost.add(line);
        }
        let along = self.number(record, Quantity::Along).unwrap_or((f64::NAN, f64::INFINITY));
        ([bow.0, stern.0, along.0], [bow.1, stern.1, along.1])
    }

    fn place(&mut self, line: usize, record: &csv::StringRecord) -> ([f64; 3], [f64; 3]) {
        let nothing = ([f64::NAN; 3], [f64::INFINITY; 3]);
        let Some(origin) = self.origin else { return nothing };
        let quantities = [Quantity::Latitude, Quantity::Longitude, Quantity::Heading];
        let [Some(latitude), Some(longitude), Some(heading)] =
            quantities.map(|quantity| self.number(record, quantity))
        else {
            self.counted.lost.add(line);
            return nothing;
        };
        let place = GeoPoint {
            latitude_deg: latitude.0.to_degrees(),
            longitude_deg: longitude.0.to_degrees(),
        };
        if place.latitude_deg.abs() > 90.0 || place.longitude_deg.abs() > 360.0 {
            self.counted.outside.add(line);
            return nothing;
        }
        let [north_m, east_m] = origin.metres(place);
        let step = |beside: GeoPoint| {
            let [north, east] = origin.metres(beside);
            libm::hypot(north - north_m, east - east_m)
        };
        let steps = [
            step(GeoPoint { latitude_deg: place.latitude_deg - latitude.1.to_degrees(), ..place }),
            step(GeoPoint {
                longitude_deg: place.longitude_deg - longitude.1.to_degrees(),
                ..place
            }),
            heading.1,
        ];
        ([north_m, east_m, heading.0], steps)
    }

    /// Tells what was counted.
    ///
    /// # Errors
    /// Fails for a log without a usable row, and for one of several berths where the mapping does not say which.
    fn finish(
        self,
        log: &mut Log,
        mapping: &Mapping,
        remarks: &mut Remarks,
    ) -> Result<(), Refusal> {
        let counted = self.counted;
        let rows = Weight::Rows;
        let slashes = "row has a time that cannot be read";
        let help = match self.clock.day_first {
            None => {
                "rows have a time that cannot be read; the mapping's `dates` says whether day or month comes first"
            }
            Some(_) => "rows have a time that cannot be read",
        };
        counted.times.tell(remarks, rows, slashes, help);
        let (one, many) = match log.kind {
            LogKind::Docking => {
                ("row without the distance of a sensor", "rows without the distance of a sensor")
            }
            _ => ("row without a position or heading", "rows without a position or heading"),
        };
        counted.lost.tell(remarks, rows, one, many);
        counted.outside.tell(
            remarks,
            rows,
            "position outside the earth",
            "positions outside the earth",
        );
        let of = mapping.berth.as_deref().unwrap_or_default();
        counted.elsewhere.tell(
            remarks,
            rows,
            &format!("row of another berth than {of}"),
            &format!("rows of another berth than {of}"),
        );
        if mapping.berth.is_none() && self.others.len() > 1 {
            let why = format!(
                "the log has rows of the berths {}; the mapping's `berth` says which to read",
                self.others.join(", ")
            );
            return Err((None, why));
        }
        let Some(first) = log.rows.first() else {
            let line = counted.elsewhere.count.max(counted.times.count);
            let first = [counted.elsewhere, counted.times].into_iter().find(|own| own.count > 0);
            let why = match line {
                0 => "the log has no rows",
                _ => "no row of the log can be used",
            };
            return Err((first.map(|own| own.first_line), why.to_owned()));
        };
        log.is_dated = first.t_s >= 1e8;
        if self.clock.is_zone_assumed && mapping.zone_s.is_none() {
            let text = "guessed: the times are UTC; the mapping's `time_zone` gives another zone";
            remarks.add(Weight::Guess, Some(first.line), text);
        }
        if !log.is_dated {
            remarks.add(Weight::Guess, Some(first.line), "the times have no date");
        }
        Ok(())
    }
}
