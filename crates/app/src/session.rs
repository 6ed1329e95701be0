//! Makes a run from a recorded session: the session is replayed and compared with the recorded states, then stepped
//! through again.

use std::path::Path;

use fenderline_live::{
    Action, AnchorFault, Fault, Level, OtherAction, Repeat, Session, SessionLog,
};
use fenderline_report::plot::{fixed, plain};
use fenderline_report::run_page::{addressee, order_text};
use fenderline_results::{LogKind, LogLine, RecordedSession};
use fenderline_scenario::{Override, Scenario};
use fenderline_serve::Replayed;
use fenderline_sim::Setup;
use fenderline_sim::exercise::Assessment;
use fenderline_sim::order::{Lead, SidePlace, TugWord, Word as _};

use crate::failure::Failure;
use crate::load::file_name;
use crate::progress::with_progress;

/// Names of those tables of a scenario file that say what is written, not what happens in the simulation.
const OF_RESULTS: [&str; 2] = ["output", "report"];

/// A recorded session before it is stepped through.
pub(crate) struct Recorded {
    /// Scenario of the session, with the user's changes of `output` and `report`.
    pub(crate) scenario: Scenario,
    /// Name of the scenario's file.
    pub(crate) scenario_file: String,
    pub(crate) repeat: Repeat,
    /// The whole session, for its other branches.
    pub(crate) session: Session,
    /// Description of the session, still without its log and its other branches.
    pub(crate) about: RecordedSession,
}

impl Recorded {
    /// Replays the recording at `path`, and goes to the start of a branch: by default the branch that was steered last.
    ///
    /// # Errors
    /// Fails if the recording is damaged or lacks the branch, if a change would alter what happened, or if the replay
    /// differs in any bit.
    pub(crate) fn load(
        path: &Path,
        branch: Option<usize>,
        overrides: &[Override],
    ) -> Result<Recorded, Failure> {
        refuse_changes(overrides)?;
        let replayed = with_progress(|progress| fenderline_serve::replay(path, progress))?;
        Recorded::of(replayed, &path.display().to_string(), branch, overrides)
    }

    /// Goes to the start of a branch of a replayed recording: by default the branch that was steered last. `file` is
    /// the file name of the recording, with a path or without.
    ///
    /// # Errors
    /// Fails if the recording lacks the branch, or if a change cannot be applied.
    pub(crate) fn of(
        replayed: Replayed,
        file: &str,
        branch: Option<usize>,
        overrides: &[Override],
    ) -> Result<Recorded, Failure> {
        let Replayed { session, branches, incomplete, .. } = replayed;
        let mut scenario = session.source().scenario_with(overrides).map_err(Failure::input)?;
        let scenario_file = session.source().file.clone();
        let branch = branch.unwrap_or(session.current_branch());
        let repeat = Repeat::of(session.clone(), branch)
            .map_err(|why| Failure::input(format_args!("error: {file}: {why}")))?;
        scenario.output = scenario.output_of_steps(repeat.steps_total());
        let about = RecordedSession {
            file: file_name(Path::new(file)).to_string_lossy().into_owned(),
            branch,
            branches,
            missing_at_end: incomplete,
            log: Vec::new(),
            beside: Vec::new(),
        };
        Ok(Recorded { scenario, scenario_file, repeat, session, about })
    }
}

/// Refuses changes of keys that would alter what happened in a recorded session.
fn refuse_changes(overrides: &[Override]) -> Result<(), Failure> {
    let changes = overrides.iter().map(|change| change.path());
    let physical = changes.filter(|path| !OF_RESULTS.contains(&path[0].as_str()));
    match physical.map(|path| path.join(".")).next() {
        None => Ok(()),
        Some(key) => Err(Failure::input(format_args!(
            "error: `{key}` cannot be changed: a recorded session is replayed without changes; \
             only keys of `output` and `report` can be set"
        ))),
    }
}

/// The lines of the session's log in words, in the order of time.
pub(crate) fn lines_of(
    log: &SessionLog,
    exercise: Option<&Assessment>,
    setup: &Setup,
) -> Vec<LogLine> {
    let commands = log.commands.iter().map(|command| {
        line(command.t_s, LogKind::Command, &command.who, words_of(&command.action, setup))
    });
    let acknowledgements = log.acknowledgements.iter();
    let acknowledgements =
        acknowledgements.map(|of| line(of.t_s, LogKind::Acknowledgement, &of.who, of.text.clone()));
    let notes = log.notes.iter().map(|note| {
        let text = if note.text.is_empty() { "mark".to_owned() } else { note.text.clone() };
        line(note.t_s, LogKind::Note, &note.who, text)
    });
    let alarms = log.alarms.iter().map(|alarm| LogLine {
        until_s: alarm.until_s,
        acknowledged: alarm.acknowledged.clone(),
        key: alarm.key.clone(),
        ..line(
            alarm.t_s,
            match alarm.level {
                Level::Alarm => LogKind::Alarm,
                Level::Caution => LogKind::Caution,
            },
            "",
            alarm.text.clone(),
        )
    });
    let events = log.events.iter().map(|(t_s, text)| line(*t_s, LogKind::Event, "", text.clone()));
    let people = commands.chain(acknowledgements).chain(notes);
    let deductions = exercise.into_iter().flat_map(Assessment::deductions).map(|of| {
        let text = format!("−{} points: {}", fixed(of.points, 1), of.sentence(setup));
        line(of.mark.first_s.unwrap_or(of.at_s), LogKind::Deduction, "", text)
    });
    let mut lines: Vec<LogLine> = people.chain(alarms).chain(deductions).chain(events).collect();
    // A stable sort: of one moment, what people did comes first.
    lines.sort_by(|one, other| one.t_s.total_cmp(&other.t_s));
    lines
}

/// Makes a line of the session's log for a moment of time.
fn line(t_s: f64, kind: LogKind, who: &str, text: String) -> LogLine {
    let (who, key) = (who.to_owned(), String::new());
    LogLine { t_s, until_s: None, kind, who, text, acknowledged: None, key }
}

/// A command in words.
fn words_of(action: &Action, setup: &Setup) -> String {
    match action {
        Action::Order(named) => match named.resolve(setup) {
            Ok(order) => format!("{}: {}", addressee(&order, setup), order_text(&order, setup)),
            // It was carried out when it was given; names do not change.
            Err(why) => unreachable!("an order that was already carried out is refused: {why}"),
        },
        Action::Other(OtherAction::Tug { tug, order, power, lead, place }) => {
            tug_words(tug, *order, *power, *lead, *place)
        }
        Action::Other(OtherAction::Wind { speed_mps, from_rad, over_s }) => {
            let over = over_words(*over_s);
            format!("wind {} m/s from {}{over}", plain(*speed_mps, 3), degrees(*from_rad))
        }
        Action::Other(OtherAction::Current { speed_mps, to_rad, over_s }) => {
            let over = over_words(*over_s);
            format!("current {} m/s towards {}{over}", plain(*speed_mps, 3), degrees(*to_rad))
        }
        Action::Other(OtherAction::PartLine { line }) => format!("line {line} parts"),
        Action::Other(OtherAction::AnchorFault { anchor, fault, on }) => {
            let what = match fault {
                AnchorFault::WindlassFailed => "the windlass has no power",
                AnchorFault::DoesNotBite => "does not bite",
            };
            format!("anchor {anchor}: {what}, {}", if *on { "begins" } else { "ends" })
        }
        Action::Other(OtherAction::TugOut { tug, on }) => {
            format!("{tug}: {}", if *on { "drops out" } else { "comes back" })
        }
        Action::Other(OtherAction::Plan { at_s, event }) => {
            let event = words_of(&Action::Other((**event).clone()), setup);
            format!("plans for {} s: {event}", plain(*at_s, 1))
        }
        Action::Other(OtherAction::CancelPlanned { id }) => format!("cancels planned event {id}"),
        Action::Other(OtherAction::Fault { vessel, fault, on }) => {
            let ends = if *on { "" } else { " ends" };
            format!("{vessel}: {}{ends}", fault_words(*fault))
        }
        Action::Other(OtherAction::Visibility { distance_m, over_s }) => {
            let over = over_words(*over_s);
            match distance_m {
                Some(distance_m) => format!("visibility {distance_m:.0} m{over}"),
                None => format!("visibility clear{over}"),
            }
        }
        Action::Other(OtherAction::ThrusterOut { vessel, thruster, on }) => {
            format!("{vessel}: thruster {thruster} {}", if *on { "trips" } else { "comes back" })
        }
        Action::Other(OtherAction::Place {
            vessel, at_m: [north_m, east_m], heading_rad, ..
        }) => {
            let (north, east) = (fixed(*north_m, 1), fixed(*east_m, 1));
            format!(
                "{vessel} placed at {north} m north, {east} m east, heading {}",
                degrees(*heading_rad)
            )
        }
        Action::Other(OtherAction::ApproachLimit { speed_mps }) => {
            format!("speed limit at the fenders {} m/s", plain(*speed_mps, 3))
        }
        Action::Other(OtherAction::Acknowledge { .. } | OtherAction::Note { .. }) => {
            unreachable!("the log keeps acknowledgements and notes apart from commands")
        }
    }
}

fn tug_words(
    tug: &str,
    order: TugWord,
    power: Option<f64>,
    lead: Lead,
    place: SidePlace,
) -> String {
    let mut text = format!("{tug}: {}", order.word().replace('_', " "));
    if matches!(order, TugWord::Push | TugWord::Pull) {
        let power = power.unwrap_or_default();
        text += &format!(" {} %, {}", fixed(100.0 * power, 0), lead.word());
        if place != SidePlace::Nearest {
            text += &format!(", at the {}", place.word());
        }
    }
    text
}

fn fault_words(fault: Fault) -> &'static str {
    match fault {
        Fault::RudderStuck => "rudder stuck",
        Fault::FollowUpLost => "rudder does not follow",
        Fault::EngineLost => "engine lost",
        Fault::ThrustersLost => "thrusters lost",
        Fault::Blackout => "blackout",
        Fault::HeadingFrozen => "heading frozen",
        Fault::SpeedFrozen => "speeds frozen",
        Fault::PositionFrozen => "position frozen",
    }
}

/// Words for the time over which the weather changes; empty if it changes at once.
fn over_words(over_s: f64) -> String {
    if over_s > 0.0 { format!(" over {} s", plain(over_s, 0)) } else { String::new() }
}

/// A direction in degrees with three digits, as mariners say it.
fn degrees(angle_rad: f64) -> String {
    format!("{:03.0}°", libm::round(angle_rad.to_degrees()).rem_euclid(360.0))
}
