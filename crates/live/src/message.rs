//! Messages to pages. The file `web/src/protocol.ts` has the same fields as these messages and explains each of them.
//! `tests/protocol.rs` compares the names.
#![allow(missing_docs, reason = "protocol.ts explains every field")]

use serde::{Deserialize, Serialize};

use crate::action::{AnchorFault, CommandLimits, OtherAction};
use crate::approach::Light;
pub use crate::pair::Pair;
use crate::request::Control;

/// Version number of the protocol between server and page. A page with another version of the protocol asks the user to
/// reload the page.
pub const PROTOCOL: u32 = 6;

#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "type", rename = "hello")]
pub struct Hello<'a> {
    pub protocol: u32,
    pub role: &'a Role,
    pub title: &'a str,
    pub file: &'a str,
    pub step_s: f64,
    pub bodies: &'a [BodyInfo],
    pub vessels: &'a [VesselInfo],
    pub fenders: &'a [FenderInfo],
    pub lines: &'a [LineInfo],
    pub anchors: &'a [AnchorInfo],
    pub bollards: &'a [BollardInfo],
    pub tugs: &'a [TugInfo],
    pub traffic: &'a [TrafficInfo],
    pub orders: &'a [OrderInfo],
    pub telegraph: &'a [TelegraphInfo],
    pub limits: CommandLimits,
    pub mine: Vec<Control>,
    pub claims: &'a [Claim],
    pub gallery: &'a [GalleryEntry],
    pub berth: Option<BerthInfo>,
    pub depth_m: Option<f64>,
    pub chart: &'a [ChartInfo],
    pub exercise: Option<ExerciseInfo>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub links: Option<&'a [Link]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub library: Option<&'a LibraryInfo>,
    /// Deleted files that can be put back. Only instructors get the list of deleted files.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deleted: Option<&'a [GalleryEntry]>,
}

/// The ships, tugs and fenders among which an instructor chooses for a new exercise.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LibraryInfo {
    pub vessels: Vec<LibraryVessel>,
    pub fenders: Vec<FamilyInfo>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LibraryVessel {
    pub name: String,
    pub title: String,
    pub length_m: f64,
    pub beam_m: f64,
    pub draught_m: f64,
    pub is_tug: bool,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FamilyInfo {
    pub name: String,
    pub sizes: Vec<SizeInfo>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SizeInfo {
    pub designation: String,
    pub height_m: f64,
    pub rated_reaction_n: f64,
}

/// The goal of an exercise and its limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExerciseInfo {
    pub task: String,
    pub ship: String,
    pub goal: Vec<String>,
    pub hold_s: f64,
    pub time_limit_s: Option<f64>,
    pub pass_mark: f64,
    pub limits: Vec<LimitInfo>,
    /// Where an anchor must lie; `None` if the goal asks for no place of an anchor.
    pub place: Option<PlaceInfo>,
}

/// A place that a goal asks for, and the distance from this place that is still good enough.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlaceInfo {
    pub at_m: Pair,
    pub within_m: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LimitInfo {
    pub key: &'static str,
    pub text: &'static str,
    pub rule: String,
    pub points: f64,
    pub fails: bool,
}

/// An order in the table of orders of `fenderline_sim`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OrderInfo {
    pub name: &'static str,
    pub target: &'static str,
    pub needs: Option<&'static str>,
    pub meaning: &'static str,
    pub arguments: Vec<ArgumentInfo>,
}

/// An order that the engine telegraph can give.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TelegraphInfo {
    pub word: &'static str,
    pub share: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ArgumentInfo {
    pub name: String,
    pub kind: &'static str,
    pub unit: &'static str,
    pub limits: Option<Pair>,
    pub default: Option<f64>,
    pub required: bool,
    pub meaning: &'static str,
}

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(tag = "name", rename_all = "snake_case")]
pub enum Role {
    Instructor,
    /// The pilot of the scenario's own ship, or of another ship that `vessel` names.
    Pilot {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        vessel: Option<String>,
    },
    Tugmaster {
        tug: String,
    },
    Observer,
}

impl Role {
    /// The pilot of the scenario's own ship.
    pub const PILOT: Role = Role::Pilot { vessel: None };
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Claim {
    pub control: Control,
    pub holder: Option<String>,
    pub connected: bool,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct GalleryEntry {
    pub file: String,
    pub title: String,
    pub text: String,
    /// The berth of the listed scenario in words, if a new exercise can use the berth.
    pub berth: Option<String>,
    /// Time at which the recording's file was last written (seconds since the start of 1970). `None` for a scenario.
    pub written_unix_s: Option<u64>,
    /// True if the instructor can rename and delete the listed file. A file can be changed if it is a recording, or an
    /// exercise saved from the page, and lies in the server's folders.
    pub changeable: bool,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Link {
    pub role: Role,
    pub path: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BerthInfo {
    pub body: usize,
    pub from: Pair,
    pub to: Pair,
    pub facing: Pair,
}

/// A feature of the chart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ChartInfo {
    pub kind: &'static str,
    pub name: String,
    pub depth_m: Option<f64>,
    pub deepest_m: Option<f64>,
    pub clearance_m: Option<f64>,
    pub colour: Option<&'static str>,
    pub side: Option<&'static str>,
    pub meaning: Option<&'static str>,
    pub form: Option<&'static str>,
    pub character: Option<String>,
    pub period_s: Option<f64>,
    pub sector_rad: Option<Pair>,
    pub range_m: Option<f64>,
    pub shape: &'static str,
    pub lines: Vec<Vec<Pair>>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyInfo {
    pub name: String,
    pub fixed: bool,
    pub outline: Vec<Pair>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VesselInfo {
    pub name: String,
    pub body: usize,
    pub title: String,
    pub length_m: f64,
    pub beam_m: f64,
    pub draught_m: f64,
    pub rudder_stop_rad: Option<f64>,
    pub full_rps: Option<f64>,
    pub thrusters: Vec<ThrusterInfo>,
    pub azimuths: Vec<AzimuthInfo>,
    pub is_tug: bool,
    /// Index of the ship that the tug serves.
    pub serves: Option<usize>,
    pub has_towline: bool,
    pub places: Vec<&'static str>,
    pub orders: Vec<&'static str>,
    pub plan: Option<PlanInfo>,
}

/// The passage plan of a vessel.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlanInfo {
    pub name: String,
    pub waypoints: Vec<WaypointInfo>,
    pub wheel_overs: Vec<WheelOverInfo>,
    pub track: Vec<Pair>,
    pub corridor: Vec<[Vec<Pair>; 2]>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WaypointInfo {
    pub name: String,
    pub at_m: Pair,
    pub speed_mps: Option<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WheelOverInfo {
    pub waypoint: usize,
    pub at_m: Pair,
    pub course_rad: f64,
}

/// Where a vessel is on her passage plan.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PlanNow {
    pub leg: usize,
    pub cross_track_m: f64,
    pub to_waypoint_m: f64,
    pub to_wheel_over_m: Option<f64>,
    pub course_rad: f64,
    pub speed_mps: Option<f64>,
    pub half_width_m: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThrusterInfo {
    pub name: String,
    pub along_m: f64,
    pub force_n: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AzimuthInfo {
    pub name: String,
    pub at_m: Pair,
    pub bollard_n: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FenderInfo {
    pub name: String,
    pub body: usize,
    pub at_m: Pair,
    pub facing_rad: f64,
    pub width_m: f64,
    pub projection_m: f64,
    pub rated_deflection_m: Option<f64>,
    pub rated_reaction_n: Option<f64>,
    pub rated_energy_j: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LineInfo {
    pub name: String,
    pub ship: usize,
    pub fairlead_m: Pair,
    /// The place where the line is made fast if nobody orders another. The place is `null` for a line that stays on
    /// board until it is sent to a bollard.
    pub end: Option<LineEndInfo>,
    pub breaking_n: f64,
    pub working_n: f64,
    pub winch_mps: Option<f64>,
    /// Distance to the farthest bollard that the line can reach (m).
    pub reach_m: f64,
    /// The thing that limits how far the line reaches: the rope, or a heaving line where there is no boat.
    pub reach_by: &'static str,
}

/// An anchor with its chain.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AnchorInfo {
    pub name: String,
    pub ship: usize,
    pub hawse_m: Pair,
    pub chain_m: f64,
    pub mass_kg: f64,
    pub breaking_n: f64,
    pub brake_n: f64,
}

/// A bollard to which lines can be sent.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BollardInfo {
    pub name: String,
    pub body: usize,
    pub at_m: Pair,
    pub most_lines: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum LineEndInfo {
    Fixed { place_m: Pair },
    OnBody { body: usize, at_m: Pair },
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TugInfo {
    pub name: String,
    pub vessel: usize,
    pub length_m: f64,
    pub beam_m: f64,
    pub bollard_pull_n: f64,
    pub push_at_m: Pair,
    pub pull_at_m: Pair,
}

/// A ship that passes on a track of her own. No order moves the passing ship, and she touches nothing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TrafficInfo {
    pub name: String,
    pub outline: Vec<Pair>,
}

/// A frame without its `events`, because each client gets other events.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "type", rename = "frame")]
pub struct Frame {
    pub tick: u64,
    pub t_s: f64,
    pub at_ms: u64,
    pub run: RunState,
    /// Position and motion of each body; `None` if fog hides the body.
    pub bodies: Vec<Option<[f64; 6]>>,
    pub vessels: Vec<VesselNow>,
    pub fenders: Vec<FenderNow>,
    pub contacts: Vec<ContactNow>,
    pub lines: Vec<LineNow>,
    pub anchors: Vec<AnchorNow>,
    pub tugs: Vec<TugNow>,
    /// Position and motion of each passing ship; `None` if fog hides the ship.
    pub traffic: Vec<Option<[f64; 6]>>,
    pub passages: Vec<PassageNow>,
    pub wind: WindNow,
    pub current: CurrentNow,
    pub waves: Option<WavesNow>,
    pub visibility_m: Option<f64>,
    pub approach_mps: f64,
    pub alarms: Vec<AlarmNow>,
    pub verdict: VerdictNow,
    pub exercise: Option<ExerciseNow>,
}

/// The state of an exercise as everybody gets it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExerciseNow {
    pub state: &'static str,
    pub ended_s: Option<f64>,
    pub held_s: f64,
    pub conditions: Vec<ConditionNow>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ConditionNow {
    pub met: bool,
    pub now: String,
}

/// The marks of an exercise. Only the frames of instructors contain the marks of the exercise.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExerciseMarks {
    pub score: f64,
    pub passed: Option<bool>,
    pub limits: Vec<LimitNow>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LimitNow {
    pub worst: Option<String>,
    pub exceeded: bool,
    pub points: f64,
    pub why: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct VerdictNow {
    pub key: &'static str,
    pub text: &'static str,
    pub gravity: &'static str,
    pub findings: Vec<FindingNow>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FindingNow {
    pub key: &'static str,
    pub gravity: &'static str,
    pub text: String,
}

#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct RunState {
    pub paused: bool,
    pub pace: f64,
    pub late_ticks: u64,
    pub latest_ms: f64,
    pub branch: usize,
    pub branches: Vec<BranchNow>,
    pub last_tick: u64,
    pub clients: usize,
    pub opening: Option<OpeningNow>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OpeningNow {
    pub file: String,
    pub at: &'static str,
    pub share: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct BranchNow {
    pub id: usize,
    pub from_tick: u64,
    pub ends_tick: u64,
    pub parent: Option<usize>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VesselNow {
    pub rudder: RudderNow,
    pub shaft: ShareNow,
    pub thrusters: Vec<ShareNow>,
    pub azimuths: Vec<AzimuthNow>,
    pub pilot: &'static str,
    pub course_rad: Option<f64>,
    pub speed_order_mps: Option<f64>,
    pub ground_mps: Pair,
    pub water_mps: Pair,
    pub bow_mps: f64,
    pub stern_mps: f64,
    pub heel_rad: f64,
    pub trim_rad: f64,
    pub squat_m: f64,
    pub under_keel_m: Option<f64>,
    pub aground: bool,
    pub berth: Option<BerthNow>,
    pub plan: Option<PlanNow>,
    pub assist: Option<AssistNow>,
    pub faults: Vec<&'static str>,
    pub tripped: Vec<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RudderNow {
    pub order_rad: f64,
    pub now_rad: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ShareNow {
    pub order: f64,
    pub now: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AzimuthNow {
    pub power_order: f64,
    pub power: f64,
    pub direction_order_rad: f64,
    pub direction_rad: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AssistNow {
    pub order: &'static str,
    pub power: f64,
    pub place: Option<&'static str>,
    pub state: AssistState,
    pub force_n: f64,
}

/// What a tug that is a vessel is doing to carry out her order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum AssistState {
    StandsOff,
    ComesAlongside,
    Alongside,
    Pushes,
    TakesUpSlack,
    Pulls,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BerthNow {
    pub bow: BerthEnd,
    pub stern: BerthEnd,
    pub limit_mps: f64,
    pub bow_lamp: Lamp,
    pub stern_lamp: Lamp,
    pub bow_m: f64,
    pub stern_m: f64,
    pub bow_mps: f64,
    pub stern_mps: f64,
    pub along_mps: f64,
    pub angle_rad: f64,
}

/// The signal of the docking board for an end of a ship: the worse of two signals, one for the speed of the end and one
/// for its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Lamp {
    pub light: Light,
    pub text: &'static str,
}

/// How an end of a ship lies at the berth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum BerthEnd {
    Off,
    AtFenders,
    NoFender,
    PastEnd,
    Touched,
    WasOverRated,
    OverRated,
    Structure,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct FenderNow {
    pub deflection_m: f64,
    pub reaction_n: f64,
    pub energy_j: f64,
    pub of_energy: f64,
    pub of_reaction: f64,
    pub peak_of_energy: f64,
    pub peak_of_reaction: f64,
    pub failed: bool,
    pub over_rated: bool,
    pub touched: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ContactNow {
    pub bodies: [usize; 2],
    pub fender: Option<usize>,
    pub at_m: Pair,
    pub force_n: Pair,
    pub slips: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LineNow {
    pub state: &'static str,
    pub tension_n: f64,
    pub over_working: bool,
    /// Index of the bollard to which the line is fast or on its way.
    pub bollard: Option<usize>,
    /// Unstretched length of the line outboard (m).
    pub length_m: Option<f64>,
    /// Time until the line is fast (s). The time is `null` while the line waits for line handlers or is not under way.
    pub fast_in_s: Option<f64>,
    pub winch: &'static str,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AnchorNow {
    pub state: &'static str,
    /// Position of the anchor on the bottom; `null` if the anchor does not lie there.
    pub place_m: Option<Pair>,
    pub chain_m: f64,
    pub tension_n: f64,
    pub holding_n: f64,
    pub on_bottom_m: f64,
    /// Direction of the chain from the bow; `null` if the chain leads straight down.
    pub lead_rad: Option<f64>,
    pub dragging: bool,
    pub dragged_m: f64,
    pub windlass: &'static str,
    /// Length of chain that the windlass shall put out (m); `null` while the brake holds.
    pub to_m: Option<f64>,
    pub stalled: bool,
    /// The report from the forecastle about the anchor.
    pub report: String,
    pub faults: Vec<AnchorFault>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TugNow {
    pub order: &'static str,
    pub power: f64,
    pub order_n: f64,
    pub order_direction_rad: f64,
    pub force_n: f64,
    pub direction_rad: f64,
    pub limited: bool,
    pub out: bool,
}

/// A ship that passes a vessel at rest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PassageNow {
    pub vessel: usize,
    pub ship: usize,
    pub gap_m: f64,
    pub between_m: [Pair; 2],
    pub force_n: Pair,
    pub yaw_nm: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct WindNow {
    pub speed_mps: f64,
    pub from_rad: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct CurrentNow {
    pub speed_mps: f64,
    pub to_rad: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WavesNow {
    pub height_m: f64,
    pub period_s: f64,
    pub from_rad: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AlarmNow {
    pub level: &'static str,
    pub key: String,
    pub text: String,
    pub since_s: f64,
    pub stands: bool,
    pub acknowledged: bool,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EventNow {
    pub t_s: f64,
    pub text: String,
}

/// The past of a session up to the present tick. Each field of the past is a column of values over time.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(tag = "type", rename = "history")]
pub struct History {
    /// Index of the vessel to which the speeds and distances of the past belong.
    pub vessel: Option<usize>,
    pub t_s: Vec<f64>,
    pub bow_mps: Vec<Option<f64>>,
    pub stern_mps: Vec<Option<f64>>,
    pub ahead_mps: Vec<f64>,
    pub turn_radps: Vec<f64>,
    pub bow_m: Vec<Option<f64>>,
    pub stern_m: Vec<Option<f64>>,
    pub cross_track_m: Vec<Option<f64>>,
    pub of_energy: Vec<f64>,
    pub of_reaction: Vec<f64>,
    pub of_working: Vec<f64>,
    pub contact_n: Vec<f64>,
    pub events: Vec<Then>,
}

/// An event of the past, or an alarm that began; an alarm has its level.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Then {
    pub t_s: f64,
    pub text: String,
    pub level: Option<&'static str>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Reply {
    Prediction {
        tick: u64,
        paths: Vec<ShipPath>,
    },
    Trial {
        id: i64,
        tick: u64,
        horizon_s: f64,
        complete: bool,
        paths: Vec<ShipPath>,
        findings: Vec<String>,
    },
    Planned {
        events: Vec<PlannedNow>,
    },
    Ack {
        id: i64,
        tick: u64,
    },
    Refused {
        id: Option<i64>,
        reason: String,
    },
    Notice {
        text: String,
    },
}

/// A planned event of the instructor, and what became of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlannedNow {
    pub id: u64,
    pub at_s: f64,
    pub event: OtherAction,
    pub state: &'static str,
    pub reason: Option<String>,
}

/// The predicted path of a vessel. Each point of the path has time (s), north and east (m), and heading (rad).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShipPath {
    pub vessel: usize,
    pub path: Vec<[f64; 4]>,
}

/// The JSON text of a message.
///
/// # Panics
/// Never. All maps in the messages have text keys, and a number that is not finite becomes `null`.
#[must_use]
pub fn text(message: &impl Serialize) -> String {
    serde_json::to_string(message).unwrap_or_else(|e| unreachable!("{e}"))
}

/// The JSON of a frame together with the events since the client's last frame. For an instructor, the JSON also gets
/// the text `marks`, which holds the marks of the exercise.
#[must_use]
pub fn with_events(frame: &str, events: &[EventNow], marks: Option<&str>) -> String {
    let open = frame.strip_suffix('}').unwrap_or(frame);
    let events = text(&events);
    match marks {
        Some(marks) => format!("{open},\"events\":{events},\"marks\":{marks}}}"),
        None => format!("{open},\"events\":{events}}}"),
    }
}
