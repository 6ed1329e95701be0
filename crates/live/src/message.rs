//! Messages to pages. The test of `typescript.rs` writes the types of these messages into `web/src/protocol.ts`.
#![allow(missing_docs, reason = "most fields say by name and unit what they are")]

use serde::{Deserialize, Serialize};
#[cfg(test)]
use ts_rs::TS;

use crate::action::{AnchorFault, CommandLimits, OtherAction};
use crate::approach::Light;
use crate::ghost::Ghost;
pub use crate::pair::Pair;
use crate::request::Control;

/// Version number of the protocol between server and page. A page with another version of the protocol asks the
/// user to reload the page.
pub const PROTOCOL: u32 = 9;

/// The data from which a page is built. The server sends this message first, and again whenever the scenario, the
/// branch of the session or the holders of the helms change.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
#[serde(tag = "type", rename = "hello")]
pub struct Hello<'a> {
    /// Version number of the server's protocol. If the number differs from `PROTOCOL`, page and program are of
    /// different versions.
    pub protocol: u32,
    pub role: &'a Role,
    pub title: &'a str,
    /// File name of the scenario; the entry of the scenario in `gallery` has the same name.
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
    /// The orders that a page can give, with their words, units and limits.
    pub orders: &'a [OrderInfo],
    /// The positions of the engine telegraph, from full astern to navigation full.
    pub telegraph: &'a [TelegraphInfo],
    /// The limits of commands that are not in the table of orders.
    pub limits: CommandLimits,
    /// The helms that this page may take.
    pub mine: Vec<Control>,
    /// For each helm, who holds the helm.
    pub claims: &'a [Claim],
    /// The scenarios and recordings that the instructor can open.
    pub gallery: &'a [GalleryEntry],
    /// The berth to which the docking board measures distances.
    pub berth: Option<BerthInfo>,
    pub depth_m: Option<f64>,
    /// A level above datum that the water of the run does not exceed, waves apart (m).
    pub highest_water_m: f64,
    /// Height above datum of the level of high water from which the chart gives clearances (m); `null` if the scenario
    /// does not give the level.
    pub clearance_datum_m: Option<f64>,
    /// The harmonics of the run's waves; empty without waves.
    #[cfg_attr(test, ts(type = "Wave[]"))]
    pub sea: &'a [[f64; 5]],
    /// Where and when the run begins, for the sun; `null` if the scenario gives no time.
    pub daylight: Option<DaylightInfo>,
    /// Rain in the view; `null`: no rain.
    #[cfg_attr(test, ts(type = "Rain | null"))]
    pub rain: Option<&'static str>,
    /// The features of the chart, which pages draw behind ships and quays.
    pub chart: &'a [ChartInfo],
    /// A measured ship, which takes part in nothing physical; absent if the session has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub ghost: Option<&'a Ghost>,
    /// The exercise of the pilot; `null` if the scenario has no exercise.
    pub exercise: Option<ExerciseInfo>,
    /// The link of each role, as a path on this server. Only instructors get the links.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub links: Option<&'a [Link]>,
    /// The vessels and fenders of which a new exercise can be made. Only instructors get the library.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub library: Option<&'a LibraryInfo>,
    /// Deleted files that can be put back. Only instructors get the list of deleted files.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub deleted: Option<&'a [GalleryEntry]>,
}

/// Where and when a run begins, for the sun.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct DaylightInfo {
    /// Time at the start of the run: seconds since the start of 1970, universal time.
    pub start_unix_s: f64,
    /// Latitude of the scenario's origin, north positive (rad).
    pub latitude_rad: f64,
    /// Longitude of the scenario's origin, east positive (rad).
    pub longitude_rad: f64,
}

/// The ships, tugs and fenders among which an instructor chooses for a new exercise.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct LibraryInfo {
    pub vessels: Vec<LibraryVessel>,
    pub fenders: Vec<FamilyInfo>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct LibraryVessel {
    pub name: String,
    pub title: String,
    pub length_m: f64,
    pub beam_m: f64,
    pub draught_m: f64,
    pub is_tug: bool,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct FamilyInfo {
    pub name: String,
    pub sizes: Vec<SizeInfo>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct SizeInfo {
    pub designation: String,
    pub height_m: f64,
    pub rated_reaction_n: f64,
}

/// The goal of an exercise and its limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ExerciseInfo {
    pub task: String,
    /// Name of the ship whose berthing is judged.
    pub ship: String,
    /// The conditions of the goal in words. All conditions must hold at the same time.
    pub goal: Vec<String>,
    /// The lines of which the goal asks a tension; `null` if it asks none.
    pub tension: Option<TensionInfo>,
    /// Time for which all conditions of the goal must hold (s).
    pub hold_s: f64,
    pub time_limit_s: Option<f64>,
    /// The least score with which the exercise is passed.
    pub pass_mark: f64,
    pub limits: Vec<LimitInfo>,
    /// Where an anchor must lie; `None` if the goal asks for no place of an anchor.
    pub place: Option<PlaceInfo>,
    /// Name of the mark of the berth; `null` if the exercise has no mark.
    pub mark: Option<String>,
    /// False if the view shows marks to the instructor alone.
    pub view_marks: bool,
}

/// The tension that a goal asks of lines.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct TensionInfo {
    /// Indices of the lines.
    pub lines: Vec<usize>,
    /// Least tension (N).
    pub least_n: f64,
    /// Greatest tension (N); `null` if the goal has no greatest tension.
    pub most_n: Option<f64>,
}

/// A place that a goal asks for, and the distance from this place that is still good enough.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct PlaceInfo {
    pub at_m: Pair,
    pub within_m: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct LimitInfo {
    pub key: &'static str,
    /// The quantity that the limit bounds, in words.
    pub text: &'static str,
    pub rule: String,
    /// The value of the quantity beyond which points are lost (unit SI).
    pub bound: f64,
    /// The largest number of points that the limit can cost.
    pub points: f64,
    /// True if the exercise is failed when the limit is exceeded.
    pub fails: bool,
}

/// An order in the table of orders of `fenderline_sim`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct OrderInfo {
    /// The word of the order in the field `do` of a command.
    pub name: &'static str,
    /// The field of a command that names the vessel, tug or line to which the order goes.
    #[cfg_attr(test, ts(type = "\"vessel\" | \"tug\" | \"line\""))]
    pub target: &'static str,
    /// The gear that the vessel, tug or line must have for the order; `null` if the order needs no gear.
    pub needs: Option<&'static str>,
    pub meaning: &'static str,
    pub arguments: Vec<ArgumentInfo>,
}

/// An order that the engine telegraph can give.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct TelegraphInfo {
    /// The telegraph's position as scenario files write it, such as `dead slow ahead`.
    pub word: &'static str,
    /// Revolutions ordered by the telegraph's position, over full revolutions; negative astern.
    pub share: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ArgumentInfo {
    /// Name of the argument's field in a command.
    pub name: String,
    #[cfg_attr(test, ts(type = "\"number\" | \"place\" | \"name\""))]
    pub kind: &'static str,
    /// Unit of the argument; empty for a share and for a name.
    pub unit: &'static str,
    /// The least and the greatest value of the argument.
    pub limits: Option<Pair>,
    /// The value that counts if a command leaves the argument out.
    pub default: Option<f64>,
    pub required: bool,
    pub meaning: &'static str,
}

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(test, derive(TS))]
#[serde(tag = "name", rename_all = "snake_case")]
pub enum Role {
    Instructor,
    /// The pilot of the scenario's own ship, or of another ship that `vessel` names.
    Pilot {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, ts(optional))]
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
#[cfg_attr(test, derive(TS))]
pub struct Claim {
    pub control: Control,
    pub holder: Option<String>,
    pub connected: bool,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct GalleryEntry {
    pub file: String,
    pub title: String,
    pub text: String,
    /// The berth of the listed scenario in words, if a new exercise can use the berth.
    pub berth: Option<String>,
    /// Time at which the recording's file was last written (seconds since the start of 1970). `None` for a scenario.
    pub written_unix_s: Option<u64>,
    /// True if the instructor can rename and delete the listed file. A file can be changed if it is a recording, or
    /// an exercise saved from the page, and lies in the server's folders.
    pub changeable: bool,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct Link {
    pub role: Role,
    pub path: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct BerthInfo {
    pub body: usize,
    pub from: Pair,
    pub to: Pair,
    pub facing: Pair,
}

/// A feature of the chart.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ChartInfo {
    #[cfg_attr(test, ts(type = "ChartKind"))]
    pub kind: &'static str,
    /// Name of the feature; empty if the feature has no name.
    pub name: String,
    /// Depth of the water below chart datum (m); for an area, the least depth.
    pub depth_m: Option<f64>,
    /// The greatest depth of an area of depth (m).
    pub deepest_m: Option<f64>,
    /// Height of a bridge or an overhead cable above the level of high water of the chart (m).
    pub clearance_m: Option<f64>,
    /// Colour of a buoy, beacon, mooring buoy or light.
    #[cfg_attr(test, ts(type = "MarkColour | null"))]
    pub colour: Option<&'static str>,
    /// The side of the fairway on which a lateral mark is, for a ship that enters.
    #[cfg_attr(test, ts(type = "MarkSide | null"))]
    pub side: Option<&'static str>,
    /// What a buoy or beacon says, by IALA's system. A cardinal mark has the direction of the safe water, a mooring buoy
    /// has `other`, and other moorings have none.
    #[cfg_attr(test, ts(type = "MarkMeaning | null"))]
    pub meaning: Option<&'static str>,
    /// Shape of the body of a buoy or beacon; `null` if the chart does not give the shape.
    #[cfg_attr(test, ts(type = "MarkShape | null"))]
    pub form: Option<&'static str>,
    /// Character of a light as charts write it, such as "Fl(2) R 6s".
    pub character: Option<String>,
    /// Period of a light (s).
    pub period_s: Option<f64>,
    /// Sector of a light: two directions seen from the light, clockwise from the first to the second (rad); `null`
    /// if the light shines all round.
    pub sector_rad: Option<Pair>,
    /// Nominal range of a light (m).
    pub range_m: Option<f64>,
    #[cfg_attr(test, ts(type = "\"point\" | \"line\" | \"area\""))]
    pub shape: &'static str,
    /// Places on the earth (m): one place, one line, or the rings of an area. A ring does not repeat its first place.
    pub lines: Vec<Vec<Pair>>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct BodyInfo {
    pub name: String,
    pub fixed: bool,
    /// Corners of the body's outline, in the axes of the body (m).
    pub outline: Vec<Pair>,
    /// The outlines of a body whose outline differs with height, from the lowest up; empty for other bodies.
    pub levels: Vec<LevelInfo>,
}

/// The outline of a body at a height. Between two outlines the side is straight, from each corner of one outline to the
/// same corner of the next outline.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct LevelInfo {
    /// Height above the waterline of a floating body at rest, or above datum on a fixed body (m).
    pub height_m: f64,
    /// Corners of the outline, in the axes of the body (m).
    pub outline: Vec<Pair>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct VesselInfo {
    pub name: String,
    /// Index of the vessel's body in `bodies`.
    pub body: usize,
    pub title: String,
    pub length_m: f64,
    pub beam_m: f64,
    pub draught_m: f64,
    /// Type of ship by which the view draws her; `null`: the words of the title say the type.
    #[cfg_attr(test, ts(type = "ShipType | null"))]
    pub kind: Option<&'static str>,
    /// Place of the eye on the bridge; `null`: the usual place for her type.
    pub conning: Option<ConningInfo>,
    /// The user's model of the ship for the view; `null`: the view draws the ship.
    pub model: Option<ModelInfo>,
    /// Least under-keel clearance of the vessel without a caution (m).
    pub under_keel_limit_m: f64,
    /// Largest angle of the rudder (rad); `null` if the vessel has no rudder.
    pub rudder_stop_rad: Option<f64>,
    pub full_rps: Option<f64>,
    pub thrusters: Vec<ThrusterInfo>,
    pub azimuths: Vec<AzimuthInfo>,
    /// True if the vessel is a tug that assists another vessel.
    pub is_tug: bool,
    /// Index of the ship that the tug serves.
    pub serves: Option<usize>,
    /// True if the tug has a line to the ship that the tug serves.
    pub has_towline: bool,
    /// Places at the ship's side where a tug may work; empty for a tug.
    #[cfg_attr(test, ts(type = "Place[]"))]
    pub places: Vec<&'static str>,
    /// The orders for which the vessel has the gear.
    pub orders: Vec<&'static str>,
    /// The vessel's passage plan; `null` if the vessel has no plan.
    pub plan: Option<PlanInfo>,
}

/// A model of a ship: a binary glTF file, which the server sends for `/model?token=…&vessel=N`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ModelInfo {
    /// Name of the file, as the scenario gives the name.
    pub file: String,
    /// Check sum of the file (CRC-32): a changed file has another.
    pub crc32: u32,
    /// Place of the model's origin, which is amidships on the waterline, in the axes of the body (m).
    pub origin_m: Pair,
}

/// The place from which a ship is conned.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ConningInfo {
    /// Place of the eye, forward and to starboard in the axes of the body (m).
    pub at_m: Pair,
    /// Height of the eye above the still water (m).
    pub eye_above_water_m: f64,
}

/// A passage plan of a vessel. The program computes tracks and distances, and the page draws them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct PlanInfo {
    pub name: String,
    pub waypoints: Vec<WaypointInfo>,
    pub wheel_overs: Vec<WheelOverInfo>,
    /// The planned track: legs, and arcs between the legs.
    pub track: Vec<Pair>,
    /// For each leg with a corridor, the edge to port and the edge to starboard.
    pub corridor: Vec<[Vec<Pair>; 2]>,
}

/// A waypoint of a passage plan.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct WaypointInfo {
    /// Name of the waypoint; empty if the waypoint has no name.
    pub name: String,
    pub at_m: Pair,
    /// Planned speed on the leg that leads to the waypoint (m/s).
    pub speed_mps: Option<f64>,
}

/// A place at which the wheel goes over for the turn at a waypoint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct WheelOverInfo {
    /// Index of the waypoint among the waypoints of the plan.
    pub waypoint: usize,
    pub at_m: Pair,
    /// Course of the track at the place (rad).
    pub course_rad: f64,
}

/// Where a vessel is on her passage plan.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct PlanNow {
    /// Index of the leg, which leads from the waypoint with the same index to the next waypoint.
    pub leg: usize,
    /// Distance from the track, positive to starboard of the track (m).
    pub cross_track_m: f64,
    /// Distance along the track to the waypoint at the end of the leg; negative after the last waypoint (m).
    pub to_waypoint_m: f64,
    /// Distance along the track to the next wheel-over point; `null` if no turn is left (m).
    pub to_wheel_over_m: Option<f64>,
    /// Course of the leg (rad).
    pub course_rad: f64,
    /// Planned speed on the leg (m/s).
    pub speed_mps: Option<f64>,
    /// Largest planned cross-track distance; `null` if the leg has no corridor (m).
    pub half_width_m: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ThrusterInfo {
    pub name: String,
    pub along_m: f64,
    pub force_n: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct AzimuthInfo {
    pub name: String,
    pub at_m: Pair,
    pub bollard_n: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct FenderInfo {
    pub name: String,
    pub body: usize,
    /// Position of the fender's mounting, in the axes of the body (m).
    pub at_m: Pair,
    pub facing_rad: f64,
    pub width_m: f64,
    pub projection_m: f64,
    /// Height of the fender's face (m).
    pub height_m: f64,
    /// Height of the middle of the face above the still water, or above datum on a fixed body (m). 0 where the scenario
    /// gives no height.
    pub above_water_m: f64,
    /// True if the fender floats: `above_water_m` is then above the water on a fixed body, too.
    pub floating: bool,
    /// Name of the fender's family in the library; `null` if the scenario gives the fender's reaction itself.
    pub family: Option<String>,
    /// Places of the cones behind the panel, along the face from its middle (m), positive to the right of a viewer who
    /// faces the panel; empty for a fender with a single element.
    pub cones_m: Vec<f64>,
    pub rated_deflection_m: Option<f64>,
    pub rated_reaction_n: Option<f64>,
    pub rated_energy_j: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct LineInfo {
    pub name: String,
    pub ship: usize,
    pub fairlead_m: Pair,
    /// Height of the fairlead above the still water, or above datum on a fixed body (m). 0 where the scenario gives no
    /// height.
    pub fairlead_above_water_m: f64,
    /// The place where the line is made fast if nobody orders another. The place is `null` for a line that stays on
    /// board until it is sent to a bollard.
    pub end: Option<LineEndInfo>,
    /// Whether the line goes between a tug and a ship.
    pub is_towline: bool,
    pub breaking_n: f64,
    /// Tension at which the line raises an alarm: half of the breaking load (N).
    pub working_n: f64,
    /// Rate at which the line's winch carries out a manual order (m/s); `null` if the line has no winch.
    pub winch_mps: Option<f64>,
    /// Distance to the farthest bollard that the line can reach (m).
    pub reach_m: f64,
    /// The thing that limits how far the line reaches: the rope, or a heaving line where there is no boat.
    #[cfg_attr(test, ts(type = "\"the rope\" | \"a heaving line\""))]
    pub reach_by: &'static str,
}

/// An anchor with its chain.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct AnchorInfo {
    pub name: String,
    /// Index of the body of the ship that carries the anchor.
    pub ship: usize,
    pub hawse_m: Pair,
    /// Height of the hawse pipe above the still water (m).
    pub hawse_above_water_m: f64,
    /// Length of the anchor's chain (m).
    pub chain_m: f64,
    pub mass_kg: f64,
    pub breaking_n: f64,
    /// Tension at which the brake of the windlass renders (N).
    pub brake_n: f64,
}

/// A bollard to which lines can be sent.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct BollardInfo {
    pub name: String,
    pub body: usize,
    pub at_m: Pair,
    /// Height of the bollard above the still water, or above datum on a fixed body (m). 0 where the scenario gives no
    /// height.
    pub above_water_m: f64,
    /// The largest number of lines that the bollard takes at the same time.
    pub most_lines: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
#[serde(untagged)]
pub enum LineEndInfo {
    /// `above_datum_m`: height of the end above datum (m).
    Fixed { place_m: Pair, above_datum_m: f64 },
    /// `above_water_m`: height of the end above the still water, or above datum on a fixed body (m).
    OnBody { body: usize, at_m: Pair, above_water_m: f64 },
}

/// A vector tug: only her force on the ship is simulated. Tugs that are vessels are in `vessels`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct TugInfo {
    pub name: String,
    /// Index in `vessels` of the ship that the tug serves.
    pub vessel: usize,
    pub length_m: f64,
    pub beam_m: f64,
    pub bollard_pull_n: f64,
    pub push_at_m: Pair,
    pub pull_at_m: Pair,
}

/// A ship that passes on a track of her own. No order moves the passing ship, and she touches nothing.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct TrafficInfo {
    pub name: String,
    /// Corners of the ship's outline about midship (m).
    pub outline: Vec<Pair>,
}

/// A frame without its `events`, because each client gets other events.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
#[serde(tag = "type", rename = "frame")]
pub struct Frame {
    pub tick: u64,
    pub t_s: f64,
    /// The server's clock when the tick was made (ms since the start of 1970).
    pub at_ms: u64,
    pub run: RunState,
    /// Position and motion of each body; `None` if fog hides the body.
    #[cfg_attr(test, ts(type = "(BodyNow | null)[]"))]
    pub bodies: Vec<Option<[f64; 6]>>,
    /// The own vessel as the eye sees her out of the window. `null` while `bodies` and `vessels` have her true motion:
    /// they have what her instruments show, and an instrument may be frozen.
    pub eyes: Option<EyesNow>,
    pub vessels: Vec<VesselNow>,
    pub fenders: Vec<FenderNow>,
    pub contacts: Vec<ContactNow>,
    pub lines: Vec<LineNow>,
    pub anchors: Vec<AnchorNow>,
    pub tugs: Vec<TugNow>,
    /// Position and motion of each passing ship; `None` if fog hides the ship.
    #[cfg_attr(test, ts(type = "(BodyNow | null)[]"))]
    pub traffic: Vec<Option<[f64; 6]>>,
    /// Passing ships that are near a vessel at rest, at most one passing ship for each vessel. Passing ships in the
    /// fog are left out.
    pub passages: Vec<PassageNow>,
    /// Wind at the pilot's ship; a speed of 0 means no wind.
    pub wind: WindNow,
    /// Current at the pilot's ship.
    pub current: CurrentNow,
    pub waves: Option<WavesNow>,
    /// Level of the water above datum (m): heights on fixed bodies count from datum, heights on ships from the water.
    pub water_level_m: f64,
    /// Visibility (m); `null` if the air is clear.
    pub visibility_m: Option<f64>,
    /// The limit of the closing speed at the fenders, which docking board and alarms use (m/s).
    pub approach_mps: f64,
    pub alarms: Vec<AlarmNow>,
    /// The verdict on the run from the start to this tick.
    pub verdict: VerdictNow,
    pub exercise: Option<ExerciseNow>,
}

/// The true motion of a vessel whose instruments are frozen. Only the frames of her own pilot or master contain this: the
/// view out of the window shows it, and the instruments do not.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct EyesNow {
    /// Index of the vessel's body in `bodies`.
    pub body: usize,
    /// True position and motion of the body.
    #[cfg_attr(test, ts(type = "BodyNow"))]
    pub now: [f64; 6],
    /// True speed of the vessel through the water, ahead and to starboard (m/s), which her wake shows.
    pub water_mps: Pair,
}

/// The state of an exercise as everybody gets it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ExerciseNow {
    #[cfg_attr(test, ts(type = "\"running\" | \"reached\" | \"time_over\""))]
    pub state: &'static str,
    pub ended_s: Option<f64>,
    /// Time for which all conditions of the goal have held (s).
    pub held_s: f64,
    /// The conditions of the goal, in the order of `ExerciseInfo.goal`.
    pub conditions: Vec<ConditionNow>,
    /// Distance along the berth that the ship has to go ahead to the mark of the berth (m), negative astern; `null` if the
    /// exercise has no mark.
    pub to_go_m: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ConditionNow {
    pub met: bool,
    pub now: String,
}

/// The marks of an exercise: its score, and the state of its limits. Only the frames of instructors contain the marks.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ExerciseMarks {
    pub score: f64,
    /// True if the exercise is passed; `null` while this is still open.
    pub passed: Option<bool>,
    /// The limits, in the order of `ExerciseInfo.limits`.
    pub limits: Vec<LimitNow>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct LimitNow {
    /// The worst value of the limited quantity so far, with its unit.
    pub worst: Option<String>,
    pub exceeded: bool,
    /// Number of points that the limit has cost so far.
    pub points: f64,
    /// The event that exceeded the limit, with its time and the excess.
    pub why: Option<String>,
}

/// The verdict on the run: its worst finding, in the words of the terminal and of the report.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct VerdictNow {
    pub key: &'static str,
    pub text: &'static str,
    #[cfg_attr(test, ts(type = "Gravity"))]
    pub gravity: &'static str,
    /// All findings of the run, the worst finding first.
    pub findings: Vec<FindingNow>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct FindingNow {
    pub key: &'static str,
    #[cfg_attr(test, ts(type = "Gravity"))]
    pub gravity: &'static str,
    pub text: String,
}

#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct RunState {
    pub paused: bool,
    /// Pace of the run: simulated time over wall time.
    pub pace: f64,
    /// Number of ticks that were late by more than half a step.
    pub late_ticks: u64,
    pub latest_ms: f64,
    pub branch: usize,
    pub branches: Vec<BranchNow>,
    /// The last tick of the branch that is shown. While the run is rewound, the last tick lies beyond `Frame.tick`.
    pub last_tick: u64,
    pub clients: usize,
    /// The file that the server is opening; `null` if the server opens no file.
    pub opening: Option<OpeningNow>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct OpeningNow {
    pub file: String,
    /// What the server does with the file: it reads a scenario, or plays a recording again.
    #[cfg_attr(test, ts(type = "\"reads\" | \"plays\""))]
    pub at: &'static str,
    pub share: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct BranchNow {
    pub id: usize,
    pub from_tick: u64,
    pub ends_tick: u64,
    pub parent: Option<usize>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct VesselNow {
    pub rudder: RudderNow,
    pub shaft: ShareNow,
    pub thrusters: Vec<ShareNow>,
    pub azimuths: Vec<AzimuthNow>,
    /// The vessel's mode of steering: `hands`, `course`, `speed`, `course+speed`, `station` or `assist`.
    pub pilot: &'static str,
    pub course_rad: Option<f64>,
    pub speed_order_mps: Option<f64>,
    /// Speed of the vessel over ground, ahead and to starboard (m/s).
    pub ground_mps: Pair,
    pub water_mps: Pair,
    /// Lateral speed of the bow over ground, positive to starboard (m/s).
    pub bow_mps: f64,
    pub stern_mps: f64,
    pub heel_rad: f64,
    pub trim_rad: f64,
    /// Heave, positive down, without squat (m).
    pub heave_m: f64,
    pub squat_m: f64,
    pub under_keel_m: Option<f64>,
    pub aground: bool,
    /// Position of the vessel at the berth; `null` if the scenario has no berth.
    pub berth: Option<BerthNow>,
    /// Place of the vessel on her passage plan; `null` if the vessel has no plan.
    pub plan: Option<PlanNow>,
    /// The order that a tug carries out at her ship; `null` for other vessels.
    pub assist: Option<AssistNow>,
    #[cfg_attr(test, ts(type = "Fault[]"))]
    pub faults: Vec<&'static str>,
    /// Thrusters and azimuth units that have tripped, by name.
    pub tripped: Vec<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct RudderNow {
    pub order_rad: f64,
    pub now_rad: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ShareNow {
    pub order: f64,
    pub now: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct AzimuthNow {
    pub power_order: f64,
    pub power: f64,
    pub direction_order_rad: f64,
    pub direction_rad: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct AssistNow {
    #[cfg_attr(test, ts(type = "TugWord"))]
    pub order: &'static str,
    /// Force of the order, as a share of the tug's bollard pull.
    pub power: f64,
    /// The place where the tug works; `null` if this place has no name.
    #[cfg_attr(test, ts(type = "Place | null"))]
    pub place: Option<&'static str>,
    /// How far the tug has come with her order.
    pub state: AssistState,
    /// Distance of the tug from the place of her order (m): of the tip of her bow while she is to push or to lie
    /// alongside, of her centre of gravity while she is to stand off. `null` while she is to pull.
    pub away_m: Option<f64>,
    /// While the tug is to pull and her line is slack: how much longer the line is than the way between its ends (m).
    pub slack_m: Option<f64>,
    /// Force of the tug on the ship: the push of the tug, or the tension of her line (N). The thrust of the tug is
    /// larger while part of the thrust moves the tug.
    pub force_n: f64,
}

/// What a tug that is a vessel is doing to carry out her order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
#[serde(rename_all = "snake_case")]
pub enum AssistState {
    StandsOff,
    ComesAlongside,
    Alongside,
    Pushes,
    TakesUpSlack,
    Pulls,
}

/// A ship beside the berth's line of fenders. Bow and stern mean the two ends of the flat part of the ship's side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct BerthNow {
    pub bow: BerthEnd,
    pub stern: BerthEnd,
    /// The limit of the closing speed at the distance of the bow (m/s).
    pub bow_limit_mps: f64,
    pub stern_limit_mps: f64,
    pub bow_lamp: Lamp,
    pub stern_lamp: Lamp,
    /// Distance of the bow from the line of fenders (m).
    pub bow_m: f64,
    pub stern_m: f64,
    /// Speed of the bow towards the berth (m/s).
    pub bow_mps: f64,
    pub stern_mps: f64,
    /// Speed of the ship along the berth, positive ahead (m/s).
    pub along_mps: f64,
    /// Angle between ship and berth, positive if the bow is nearer (rad).
    pub angle_rad: f64,
}

/// The signal of the docking board for an end of a ship: the worse of two signals, one for the speed of the end and
/// one for its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct Lamp {
    pub light: Light,
    pub text: &'static str,
    /// Whether the signal is that of the speed.
    pub by_speed: bool,
}

/// How an end of a ship lies at the berth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(test, derive(TS))]
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
#[cfg_attr(test, derive(TS))]
pub struct FenderNow {
    pub deflection_m: f64,
    pub reaction_n: f64,
    pub energy_j: f64,
    /// Energy of the fender as a share of the rated energy; 0 if the fender has no rating.
    pub of_energy: f64,
    pub of_reaction: f64,
    pub peak_of_energy: f64,
    pub peak_of_reaction: f64,
    pub failed: bool,
    /// True if the fender was loaded beyond its rating at any time.
    pub over_rated: bool,
    /// True if the fender was touched at any time since the start.
    pub touched: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ContactNow {
    pub bodies: [usize; 2],
    pub fender: Option<usize>,
    pub at_m: Pair,
    /// Force on the first body, north and east (N).
    pub force_n: Pair,
    pub slips: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct LineNow {
    /// A line that is `ashore` will be made fast without an order. A line that is `aboard` can be sent to a
    /// bollard, and a line that is `sent` is on the way to a bollard.
    #[cfg_attr(test, ts(type = "\"ashore\" | \"aboard\" | \"sent\" | \"fast\" | \"parted\""))]
    pub state: &'static str,
    pub tension_n: f64,
    /// True if the tension is above the working load.
    pub over_working: bool,
    /// Index of the bollard to which the line is fast or on its way.
    pub bollard: Option<usize>,
    /// Unstretched length of the line outboard (m).
    pub length_m: Option<f64>,
    /// Time until the line is fast (s). The time is `null` while the line waits for line handlers or is not under
    /// way.
    pub fast_in_s: Option<f64>,
    #[cfg_attr(test, ts(type = "\"hold\" | \"heave\" | \"pay_out\""))]
    pub winch: &'static str,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct AnchorNow {
    #[cfg_attr(test, ts(type = "\"housed\" | \"hanging\" | \"on_bottom\" | \"lost\""))]
    pub state: &'static str,
    /// Position of the anchor on the bottom; `null` if the anchor does not lie there.
    pub place_m: Option<Pair>,
    /// Length of the chain that is out (m).
    pub chain_m: f64,
    /// Tension of the chain at the hawse pipe (N).
    pub tension_n: f64,
    /// The largest horizontal pull that anchor and chain hold (N).
    pub holding_n: f64,
    pub on_bottom_m: f64,
    /// Direction of the chain from the bow; `null` if the chain leads straight down.
    pub lead_rad: Option<f64>,
    pub dragging: bool,
    pub dragged_m: f64,
    #[cfg_attr(test, ts(type = "\"hold\" | \"let_go\" | \"veer\" | \"heave\""))]
    pub windlass: &'static str,
    /// Length of chain that the windlass shall put out (m); `null` while the brake holds.
    pub to_m: Option<f64>,
    /// True if the windlass cannot heave against the tension.
    pub stalled: bool,
    /// The report from the forecastle about the anchor.
    pub report: String,
    pub faults: Vec<AnchorFault>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct TugNow {
    #[cfg_attr(test, ts(type = "\"push\" | \"pull\" | \"stop\""))]
    pub order: &'static str,
    /// Force of the order, as a share of the tug's bollard pull.
    pub power: f64,
    pub order_n: f64,
    pub order_direction_rad: f64,
    pub force_n: f64,
    /// Direction of the tug's force on the ship, from the ship's bow (rad).
    pub direction_rad: f64,
    pub limited: bool,
    /// True if the tug has dropped out and carries out no orders.
    pub out: bool,
}

/// A ship that passes a vessel at rest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct PassageNow {
    /// Index of the vessel at rest in `Hello.vessels`.
    pub vessel: usize,
    /// Index of the passing ship in `Hello.traffic`.
    pub ship: usize,
    /// Clear distance between the outlines of both ships (m).
    pub gap_m: f64,
    /// The nearest points of both outlines, north and east (m): first the point of the vessel at rest.
    pub between_m: [Pair; 2],
    /// Force of the flow of all passing ships on the vessel, forward and to starboard (N).
    pub force_n: Pair,
    /// Moment of this flow on the vessel about midship, positive bow to starboard (N·m).
    pub yaw_nm: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct WindNow {
    pub speed_mps: f64,
    pub from_rad: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct CurrentNow {
    pub speed_mps: f64,
    pub to_rad: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct WavesNow {
    pub height_m: f64,
    pub period_s: f64,
    pub from_rad: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
#[cfg_attr(test, ts(rename = "Alarm"))]
pub struct AlarmNow {
    #[cfg_attr(test, ts(type = "\"caution\" | \"alarm\""))]
    pub level: &'static str,
    /// Kind and subject of the alarm. At most one alarm with a key is active.
    pub key: String,
    pub text: String,
    /// Time when the caution was raised, or became an alarm (s).
    pub since_s: f64,
    /// True while the cause of the alarm is present. Otherwise the alarm only waits to be acknowledged.
    pub stands: bool,
    pub acknowledged: bool,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct EventNow {
    pub t_s: f64,
    pub text: String,
}

/// The past of a session up to the present tick. Each field of the past is a column of values over time.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
#[serde(tag = "type", rename = "history")]
pub struct History {
    /// Index of the vessel to which the speeds and distances of the past belong.
    pub vessel: Option<usize>,
    pub t_s: Vec<f64>,
    /// Speed of the bow towards the berth, or sideways over ground if there is no berth (m/s); `null` if there is
    /// no vessel.
    pub bow_mps: Vec<Option<f64>>,
    pub stern_mps: Vec<Option<f64>>,
    pub ahead_mps: Vec<f64>,
    pub turn_radps: Vec<f64>,
    /// Distance of the bow from the berth (m).
    pub bow_m: Vec<Option<f64>>,
    pub stern_m: Vec<Option<f64>>,
    /// Distance from the track of the vessel's passage plan, positive to starboard of the track (m).
    pub cross_track_m: Vec<Option<f64>>,
    /// Least under-keel clearance, squat included (m); `null` in deep water.
    pub under_keel_m: Vec<Option<f64>>,
    /// Largest energy of any fender as a share of its rated energy.
    pub of_energy: Vec<f64>,
    pub of_reaction: Vec<f64>,
    pub of_working: Vec<f64>,
    /// Sum of the sizes of all contact forces (N).
    pub contact_n: Vec<f64>,
    /// Events and alarms of the past. For an alarm, `level` is the level of the alarm.
    pub events: Vec<Then>,
}

/// An event of the past, or an alarm that began; an alarm has its level.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct Then {
    pub t_s: f64,
    pub text: String,
    #[cfg_attr(test, ts(type = "Alarm[\"level\"] | null"))]
    pub level: Option<&'static str>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
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
#[cfg_attr(test, derive(TS))]
pub struct PlannedNow {
    pub id: u64,
    pub at_s: f64,
    pub event: OtherAction,
    #[cfg_attr(test, ts(type = "\"waits\" | \"fired\" | \"cancelled\" | \"refused\""))]
    pub state: &'static str,
    /// The reason why the planned event could not be carried out.
    pub reason: Option<String>,
}

/// The predicted path of a vessel. Each point of the path has time (s), north and east (m), and heading (rad).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct ShipPath {
    /// Index of the vessel in `Hello.vessels`.
    pub vessel: usize,
    #[cfg_attr(test, ts(type = "PathPoint[]"))]
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
/// the text `marks`, which holds score and limits of the exercise.
#[must_use]
pub fn with_events(frame: &str, events: &[EventNow], marks: Option<&str>) -> String {
    let open = frame.strip_suffix('}').unwrap_or(frame);
    let events = text(&events);
    match marks {
        Some(marks) => format!("{open},\"events\":{events},\"marks\":{marks}}}"),
        None => format!("{open},\"events\":{events}}}"),
    }
}
