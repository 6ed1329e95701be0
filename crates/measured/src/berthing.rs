//! From logs to berthings.

use fenderline_keys::overrides::Override;
use fenderline_scenario::ScenarioError;
use fenderline_sim::{Setup, Verdict};

use crate::curves::{Curves, curves};
use crate::estimate::channels::Channels;
use crate::estimate::checks::check;
use crate::estimate::find::{Way, find};
use crate::estimate::touch::{Touch, touch};
use crate::flag::Flag;
use crate::geometry::BerthAxes;
use crate::log::{Log, LogKind, LogsRead};
use crate::mapping::Mapping;
use crate::remark::{Remark, Remarks, Weight};
use crate::run::{Followed, Rerun, follow, rerun};
use crate::stretch::{Stretch, stretches};

/// A scenario of the berth for some ship.
#[derive(Clone, Debug)]
pub struct Berth {
    /// The set-up with the ship.
    pub setup: Setup,
    /// Berth and hull.
    pub axes: BerthAxes,
}

impl Berth {
    /// The berth of a set-up.
    ///
    /// # Errors
    /// Says what the set-up lacks: a `[berthing]`, the body that the mapping names, or fenders on a fixed body.
    pub fn new(setup: Setup, mapping: &Mapping) -> Result<Berth, String> {
        let axes = BerthAxes::of(&setup, mapping.ship.as_deref())?;
        Ok(Berth { setup, axes })
    }

    /// Displacement of the ship (t).
    #[must_use]
    pub fn displacement_t(&self) -> f64 {
        self.setup.bodies[self.axes.ship].mass.map_or(f64::NAN, |mass| mass.mass_kg / 1e3)
    }

    /// Name of a fender.
    #[must_use]
    pub fn fender(&self, index: usize) -> &str {
        &self.setup.fenders[index].name
    }
}

/// A function that gives the berth with the scenario changed for a ship.
pub type BerthFor<'a> = &'a dyn Fn(&[Override]) -> Result<Berth, BerthError>;

/// Why there is no berth for a ship.
#[derive(Clone, Debug)]
pub enum BerthError {
    /// The scenario with the ship's changes is refused.
    Scenario(ScenarioError),
    /// The scenario lacks something.
    Lacks(String),
}

/// A measured berthing.
#[derive(Clone, Debug)]
pub struct Berthing {
    /// Name of the log.
    pub file: String,
    /// Line of the log at the touch.
    pub line: usize,
    /// What the log holds.
    pub kind: LogKind,
    /// Name of the ship.
    pub ship: String,
    /// Maritime mobile service identity of the ship.
    pub mmsi: Option<u32>,
    /// Whether the time has a date.
    pub is_dated: bool,
    /// The berth with this ship: an index into [`Berthings::berths`].
    pub berth: usize,
    /// State at the touch.
    pub touch: Touch,
    /// How far a track was moved (m).
    pub zero_m: Option<f64>,
    /// Flags, in their order, each once.
    pub flags: Vec<Flag>,
    /// The run from the measured state, or why there is none.
    pub run: Result<Rerun, String>,
    /// The run that a force kept on the measured path, or why there is none; `None` if the mapping asks for none.
    pub followed: Option<Result<Followed, String>>,
    /// Values of the columns to keep, at the touch.
    pub kept: Vec<String>,
    /// Curves of the approach for the report.
    pub curves: Curves,
    /// Line and time (s) of the last row of the way, for berthings of two ships at once.
    until_s: f64,
    /// Ends of the hull along the quay at the touch (m).
    ends_m: [f64; 2],
}

impl Berthing {
    /// The verdict of the run; `None` without a run.
    #[must_use]
    pub fn verdict(&self) -> Option<Verdict> {
        self.run.as_ref().ok().map(|run| run.verdict)
    }
}

/// All berthings of some logs.
#[derive(Clone, Debug, Default)]
pub struct Berthings {
    /// The berthings in the order of time.
    pub all: Vec<Berthing>,
    /// The berths with their ships; the first is that of the scenario as it is.
    pub berths: Vec<Berth>,
    /// Names of the columns to keep.
    pub kept: Vec<String>,
    /// What was guessed and left out.
    pub remarks: Vec<Remark>,
}

/// Finds and computes the berthings of logs that were read.
///
/// # Errors
/// Fails if the scenario is refused with the changes of a ship that the logs have.
pub fn berthings(
    read: Vec<LogsRead>,
    mapping: &Mapping,
    berth_for: BerthFor<'_>,
) -> Result<Berthings, BerthError> {
    let mut berths = Ships::new(mapping, berth_for)?;
    let mut all = Vec::new();
    let mut remarks = Vec::new();
    for logs in read {
        remarks.extend(logs.remarks);
        let mut of_file: Vec<Berthing> = Vec::new();
        let mut strangers: Vec<String> = Vec::new();
        let mut own = Remarks::of(logs.logs.first().map_or("", |log| log.file.as_str()));
        for log in &logs.logs {
            if log.kind == LogKind::Ais && !is_expected(log, mapping, &berths.plain().axes) {
                strangers.push(log.ship.clone());
                continue;
            }
            for stretch in stretches(log, &mut own) {
                of_file.extend(of_stretch(log, &stretch, mapping, &mut berths, &mut own)?);
            }
        }
        if !strangers.is_empty() {
            let why = match mapping.ships.is_empty() {
                true => "not known to be as long as the scenario's ship",
                false => "not named by the mapping",
            };
            let count = fenderline_report::plot::counted(strangers.len() as u64, "ship", "ships");
            let text = format!("left out: {count} of AIS, {why}: {}", strangers.join(", "));
            own.add(Weight::Rows, None, text);
        }
        let kept = without_two_at_once(of_file, &mut own);
        remarks.extend(own.all);
        all.extend(kept);
    }
    all.sort_by(|one, other| one.touch.t_s.total_cmp(&other.touch.t_s));
    Ok(Berthings { all, berths: berths.berths, kept: mapping.keep.clone(), remarks })
}

/// Whether a ship of AIS may be one that berths: the mapping names her, or she is as long as the scenario's ship.
pub(crate) fn is_expected(log: &Log, mapping: &Mapping, axes: &BerthAxes) -> bool {
    if !mapping.ships.is_empty() {
        return mapping.ship_called(&log.ship, log.mmsi).is_some();
    }
    let length_m = axes.hull_length_m();
    log.extent_m.is_some_and(|extent| (extent[0] + extent[1] - length_m).abs() < 0.15 * length_m)
}

/// The berths with the ships of the mapping, each made once.
struct Ships<'a> {
    mapping: &'a Mapping,
    berth_for: BerthFor<'a>,
    berths: Vec<Berth>,
    /// For each ship of the mapping, the index of her berth.
    known: Vec<Option<usize>>,
}

impl<'a> Ships<'a> {
    fn new(mapping: &'a Mapping, berth_for: BerthFor<'a>) -> Result<Ships<'a>, BerthError> {
        let berths = vec![berth_for(&[])?];
        Ok(Ships { mapping, berth_for, berths, known: vec![None; mapping.ships.len()] })
    }

    fn plain(&self) -> &Berth {
        &self.berths[0]
    }

    /// Index of the berth of a ship, and whether the scenario's ship stands for a ship with another name.
    fn of(&mut self, name: &str, mmsi: Option<u32>) -> Result<(usize, bool), BerthError> {
        let is_her = |(own, ship): &(String, crate::mapping::ShipOfLog)| {
            own.eq_ignore_ascii_case(name) || (mmsi.is_some() && ship.mmsi == mmsi)
        };
        let Some(place) = self.mapping.ships.iter().position(is_her) else {
            return Ok((0, !name.is_empty()));
        };
        if let Some(known) = self.known[place] {
            return Ok((known, false));
        }
        let set = &self.mapping.ships[place].1.set;
        let index = if set.is_empty() {
            0
        } else {
            self.berths.push((self.berth_for)(set)?);
            self.berths.len() - 1
        };
        self.known[place] = Some(index);
        Ok((index, false))
    }
}

/// The berthings of a stretch.
fn of_stretch(
    log: &Log,
    stretch: &Stretch,
    mapping: &Mapping,
    berths: &mut Ships<'_>,
    remarks: &mut Remarks,
) -> Result<Vec<Berthing>, BerthError> {
    let name = match log.names[stretch.name].as_str() {
        "" => log.ship.clone(),
        name => name.to_owned(),
    };
    let (index, is_assumed) = berths.of(&name, log.mmsi)?;
    let berth = &berths.berths[index];
    let channels = Channels::of(log, stretch, &berth.axes, mapping);
    for line in &channels.jumps {
        let text = "the clock jumps; the rows from here on are moved to follow the row above";
        remarks.add(Weight::Rows, Some(*line), text);
    }
    let found = find(&channels, &berth.axes);
    if found.ways.is_empty() {
        let (line, text) = no_touch(&channels, &found, &berth.axes, log.kind);
        remarks.add(Weight::Refused, Some(line), text);
    }
    let mut all = Vec::new();
    for way in &found.ways {
        let line = way.channels.lines[way.touch];
        match one(log, way, mapping, berth) {
            Err((line, why)) => {
                remarks.add(Weight::Refused, Some(line), format!("a berthing is left out: {why}"));
            }
            Ok(mut own) => {
                own.line = line;
                own.ship.clone_from(&name);
                own.berth = index;
                if is_assumed {
                    own.flags.push(Flag::ShipAssumed);
                }
                own.flags.sort_unstable();
                own.flags.dedup();
                all.push(own);
            }
        }
    }
    Ok(all)
}

/// Why a stretch has no touch, with the line.
fn no_touch(
    channels: &Channels,
    found: &crate::estimate::find::Found,
    axes: &BerthAxes,
    kind: LogKind,
) -> (usize, String) {
    let first = channels.lines[0];
    let fixed = |value: f64| fenderline_report::plot::fixed(value, 2);
    match found.nearest {
        None if kind == LogKind::Docking => {
            let why = "no touch: the sensors never both see the hull";
            (first, why.to_owned())
        }
        None => {
            let known = channels.readings.iter().filter(|readings| readings[0].is_finite());
            let far_m = known
                .map(|own| libm::hypot(own[0], own[1]))
                .fold(f64::INFINITY, fenderline_contact::number::lesser);
            let why = match far_m > 2.0 * (axes.length_m + axes.hull_length_m()) {
                true => format!(
                    "the track is of another berth: it stays {} m away from this one",
                    fixed(far_m)
                ),
                false => "no touch: the ship is never abreast of a fender".to_owned(),
            };
            (first, why)
        }
        Some(_) if found.is_alongside_at_start => {
            (first, "no approach: the ship lies at the fenders in the first rows".to_owned())
        }
        Some((row, gap_m)) => {
            let why = format!(
                "no touch: the hull comes no nearer than {} m to a fender; is the log of another berth, or `behind` of the sensors or the ship another?",
                fixed(gap_m)
            );
            (channels.lines[row], why)
        }
    }
}

/// One berthing.
///
/// # Errors
/// Line and reason why it is left out.
fn one(
    log: &Log,
    way: &Way,
    mapping: &Mapping,
    berth: &Berth,
) -> Result<Berthing, (usize, String)> {
    let axes = &berth.axes;
    let mut flags = check(way, log, mapping)?;
    let line = way.channels.lines[way.touch];
    let (touch, own, _) = touch(way, axes, mapping.bandwidth_s).map_err(|why| (line, why))?;
    flags.extend(own);
    if log.kind == LogKind::Ais {
        flags.push(Flag::Coarse);
    }
    if berth.setup.bodies[axes.ship].hull.is_some() {
        flags.push(Flag::OneOutline);
    }
    let run = rerun(&berth.setup, way, axes, &touch, mapping.run_from_m);
    match &run {
        Err(_) => flags.push(Flag::RunFailed),
        Ok(run) => {
            let by_mps = (run.speed_mps - touch.speed_mps.value).abs();
            if by_mps > 0.01 && by_mps > 3.0 * touch.speed_mps.sd {
                flags.push(Flag::Driven);
            }
        }
    }
    let followed =
        mapping.follow_from_m.map(|from_m| follow(&berth.setup, way, axes, &touch, from_m));
    let half_m = 0.5 * axes.hull_length_m();
    let middle_m = touch.motion.lie.along_m;
    Ok(Berthing {
        file: log.file.clone(),
        line,
        kind: log.kind,
        ship: String::new(),
        mmsi: log.mmsi,
        is_dated: log.is_dated,
        berth: 0,
        zero_m: way.zero_m,
        flags,
        run,
        followed,
        kept: log.kept[way.channels.rows[way.touch]].clone(),
        curves: curves(way, axes, &touch),
        until_s: way.channels.t_s[way.channels.t_s.len() - 1],
        ends_m: [middle_m - half_m, middle_m + half_m],
        touch,
    })
}

/// Leaves out berthings of two ships that lie in one place at one time.
fn without_two_at_once(all: Vec<Berthing>, remarks: &mut Remarks) -> Vec<Berthing> {
    let is_with = |one: &Berthing, other: &Berthing| {
        let is_other = one.mmsi != other.mmsi;
        let meets = one.touch.t_s < other.until_s && other.touch.t_s < one.until_s;
        let overlaps = one.ends_m[0] < other.ends_m[1] && other.ends_m[0] < one.ends_m[1];
        is_other && meets && overlaps
    };
    let with: Vec<Option<usize>> = (0..all.len())
        .map(|index| {
            (0..all.len()).find(|other| *other != index && is_with(&all[index], &all[*other]))
        })
        .collect();
    for (index, other) in with.iter().enumerate() {
        if let Some(other) = other {
            let text = format!(
                "two ships at once: {} is at the fenders where {} is; the berthing is left out",
                all[index].ship, all[*other].ship
            );
            remarks.add(Weight::Refused, Some(all[index].line), text);
        }
    }
    let own = all.into_iter().zip(with);
    own.filter(|(_, other)| other.is_none()).map(|(berthing, _)| berthing).collect()
}
