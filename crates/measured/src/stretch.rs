//! Cuts a log into stretches without a long pause, each of one ship, and refuses what cannot be told apart.

use crate::log::{Log, LogKind};
use crate::remark::{Remarks, Tally, Weight};

/// A pause longer than this begins a new stretch (s).
const PAUSE_S: f64 = 600.0;
/// A row earlier than the row before it by more than this begins a new stretch (s); a smaller step back is a jump of
/// the clock.
const BACK_S: f64 = 3600.0;
/// Largest share of the rows of a stretch that may repeat the time of the row before with other readings.
const MOST_DOUBLE: f64 = 0.2;

/// Rows of one ship without a long pause, by their index in the log, in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stretch {
    /// Index of the ship's name in [`Log::names`].
    pub(crate) name: usize,
    pub(crate) rows: Vec<usize>,
}

/// The stretches of a log in the order of time.
pub(crate) fn stretches(log: &Log, remarks: &mut Remarks) -> Vec<Stretch> {
    let mut cut: Vec<Stretch> = Vec::new();
    let mut current: Vec<usize> = Vec::new();
    for index in 0..log.rows.len() {
        if let Some(&last) = current.last() {
            let step_s = log.rows[index].t_s - log.rows[last].t_s;
            if step_s <= -BACK_S {
                let hours = libm::round(-step_s / 360.0) / 10.0;
                let text = format!(
                    "the row is {hours} h earlier than the row above it: the days are out of order; each berthing is read by itself"
                );
                remarks.add(Weight::Rows, Some(log.rows[index].line), text);
            }
            if step_s > PAUSE_S || step_s <= -BACK_S {
                add(log, core::mem::take(&mut current), &mut cut, remarks);
            }
        }
        current.push(index);
    }
    add(log, current, &mut cut, remarks);
    cut.sort_by(|one, other| {
        let start = |stretch: &Stretch| log.rows[stretch.rows[0]].t_s;
        start(one).total_cmp(&start(other))
    });
    cut
}

/// Adds the stretches of rows without a pause: one, or one for each ship of which the rows follow each other.
fn add(log: &Log, rows: Vec<usize>, cut: &mut Vec<Stretch>, remarks: &mut Remarks) {
    let mut parts: Vec<Stretch> = Vec::new();
    for row in rows {
        let name = log.ship_of_row[row];
        match parts.last_mut() {
            Some(part) if part.name == name => part.rows.push(row),
            _ => parts.push(Stretch { name, rows: vec![row] }),
        }
    }
    let comes_back = (0..parts.len())
        .find(|index| parts[..*index].iter().any(|part| part.name == parts[*index].name));
    if let Some(index) = comes_back {
        let line = log.rows[parts[index].rows[0]].line;
        let mut names: Vec<&str> = Vec::new();
        for part in &parts {
            let name = log.names[part.name].as_str();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let text = format!(
            "two ships at once: the rows of {} take turns from here; the berthing is left out",
            names.join(" and ")
        );
        remarks.add(Weight::Refused, Some(line), text);
        return;
    }
    cut.extend(parts.into_iter().filter_map(|part| single(log, part, remarks)));
}

/// A stretch without rows that repeat a time; `None` if so many repeat it that two ships must be mixed up.
fn single(log: &Log, stretch: Stretch, remarks: &mut Remarks) -> Option<Stretch> {
    let mut rows: Vec<usize> = Vec::with_capacity(stretch.rows.len());
    let mut double = Tally::default();
    for &row in &stretch.rows {
        let own = &log.rows[row];
        match rows.last().map(|last| &log.rows[*last]) {
            Some(last) if last.t_s == own.t_s => {
                let differ =
                    last.readings.iter().zip(own.readings).any(|(a, b)| (a - b).abs() > 0.5);
                if differ {
                    double.add(own.line);
                }
            }
            _ => rows.push(row),
        }
    }
    // An AIS receiver tells ships apart, and may hear a report twice.
    if log.kind != LogKind::Ais && double.count as f64 > MOST_DOUBLE * stretch.rows.len() as f64 {
        let text = "two ships at once: rows of the same time have other readings from here; the berthing is left out";
        remarks.add(Weight::Refused, Some(double.first_line), text);
        return None;
    }
    double.tell(
        remarks,
        Weight::Rows,
        "row repeats the time of the row above with other readings, and is left out",
        "rows repeat the time of the row above with other readings, and are left out",
    );
    Some(Stretch { rows, ..stretch })
}
