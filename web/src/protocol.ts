/**
 * The messages between server and page over the websocket `/live?token=…`: JSON text, one message a frame.
 *
 * The server's side is `crates/live/src/message.rs`, `action.rs` and `request.rs`; `crates/live/tests/protocol.rs`
 * compares the names with this file. Orders are in `orders.ts`. Units are
 * SI: metres, seconds, radians, newtons, joules, kilograms. Earth-fixed places are [north, east]; headings and
 * bearings are from north, positive to starboard; body-fixed places are [forward, starboard].
 */

import type { Order } from "./orders";

// ---------------------------------------------------------------- server → page

export type FromServer =
  Hello | Frame | Prediction | Trial | Past | Planned | Ack | Refused | Notice;

/** Number of this protocol. */
export const PROTOCOL = 6;

/** A place or a vector: [north, east] or [forward, starboard]. */
export type Pair = [number, number];

/** Sent first, and again whenever the scenario, the branch or the claims change. */
export interface Hello {
  type: "hello";
  /** Another number than `PROTOCOL`: the page is of another version than the program. */
  protocol: number;
  role: Role;
  title: string;
  /** File name of the scenario, as in `gallery`. */
  file: string;
  step_s: number;
  bodies: BodyInfo[];
  vessels: VesselInfo[];
  fenders: FenderInfo[];
  lines: LineInfo[];
  anchors: AnchorInfo[];
  bollards: BollardInfo[];
  tugs: TugInfo[];
  traffic: TrafficInfo[];
  /** The table of orders: words, units and limits. */
  orders: OrderInfo[];
  /** The engine telegraph, from full astern to navigation full. */
  telegraph: TelegraphInfo[];
  /** The limits of other commands. */
  limits: CommandLimits;
  /** The controls that this page may use. */
  mine: Control[];
  /** The holder of each control; `null`: it is free. */
  claims: { control: Control; holder: string | null; connected: boolean }[];
  /** Scenarios that the instructor can open. */
  /** `berth`: what a new exercise can take of it, in words. */
  gallery: {
    file: string;
    title: string;
    text: string;
    berth: string | null;
    /** When the file of a recording was last written [s since 1970]; `null`: a scenario. */
    written_unix_s: number | null;
    /** Whether the instructor can rename and delete it: a recording, or an exercise that was saved from the page. */
    changeable: boolean;
  }[];
  /** The berth: a line [m] and the side of the water, on a body (a quay, a ship). Distances are to this line. */
  berth: { body: number; from: Pair; to: Pair; facing: Pair } | null;
  depth_m: number | null;
  /** What is drawn behind ships and quays. */
  chart: ChartInfo[];
  /** What the pilot is asked to do; `null`: the scenario has no exercise. */
  exercise: ExerciseInfo | null;
  /** For the instructor only: a link for each role, as a path on this server. */
  links?: { role: Role; path: string }[];
  /** For the instructor only: what a new exercise can be made of. */
  library?: LibraryInfo;
  /** For the instructor only: what was deleted and can be put back, the latest last. */
  deleted?: Hello["gallery"];
}

export interface LibraryInfo {
  vessels: LibraryVessel[];
  fenders: {
    name: string;
    /** None: a fender is given by height and rated reaction. */
    sizes: { designation: string; height_m: number; rated_reaction_n: number }[];
  }[];
}

export interface LibraryVessel {
  name: string;
  title: string;
  length_m: number;
  beam_m: number;
  draught_m: number;
  is_tug: boolean;
}

/** The choices of a new exercise. */
export interface NewExercise {
  title: string;
  berth: {
    length_m: number;
    depth_m: number;
    fender: string;
    size: string | null;
    height_m: number | null;
    rated_reaction_n: number | null;
    fenders: number;
    fender_spacing_m: number;
    bollard_spacing_m: number;
  };
  /** File of the gallery whose berth is taken in place of `berth`. */
  berth_of: string | null;
  ship: {
    vessel: string;
    side: "port" | "starboard";
    off_m: number;
    astern_m: number;
    speed_mps: number;
  };
  tugs: { vessel: string; number: number };
  weather: {
    wind_mps: number;
    wind_from_rad: number;
    gusts: boolean;
    current_mps: number;
    current_to_rad: number;
    visibility_m: number | null;
  };
}

export type Role =
  | { name: "instructor" }
  /** Of the scenario's first ship, or of another. */
  | { name: "pilot"; vessel?: string }
  | { name: "tugmaster"; tug: string }
  | { name: "observer" };

/** A control: a vessel or a tug, by name. One client holds it at a time. */
export type Control = { vessel: string } | { tug: string } | { session: true };

/** An exercise: a goal, and limits that cost points of a score of 100. */
export interface ExerciseInfo {
  task: string;
  /** Name of the ship. */
  ship: string;
  /** The conditions in words. They must hold together. */
  goal: string[];
  /** For this long. */
  hold_s: number;
  time_limit_s: number | null;
  /** The least score with which it is passed. */
  pass_mark: number;
  limits: LimitInfo[];
  /** Where an anchor must lie; `null` if the goal has no such place. */
  place: PlaceInfo | null;
}

/** A place of a goal, with how far from it is good enough. */
export interface PlaceInfo {
  at_m: Pair;
  within_m: number;
}

export interface LimitInfo {
  key: string;
  /** What it is about. */
  text: string;
  rule: string;
  /** The most that it costs. */
  points: number;
  /** The exercise is failed where it is exceeded. */
  fails: boolean;
}

export interface OrderInfo {
  /** The word in `do`. */
  name: string;
  /** The field that names the target. */
  target: "vessel" | "tug" | "line";
  /** The gear that the target must have. */
  needs: string | null;
  meaning: string;
  arguments: ArgumentInfo[];
}

export interface TelegraphInfo {
  /** The word in scenario files, such as `dead slow ahead`. */
  word: string;
  /** Revolutions over full revolutions, negative astern. */
  share: number;
}

export interface ArgumentInfo {
  /** The field. */
  name: string;
  kind: "number" | "place" | "name";
  /** Empty for a share and a name. */
  unit: string;
  /** The least and the greatest value. */
  limits: Pair | null;
  /** The value if it is not given. */
  default: number | null;
  required: boolean;
  meaning: string;
}

/** Least and greatest value. */
export interface CommandLimits {
  /** Force over a tug's bollard pull, in an order in words. */
  tug_power: Pair;
  wind_mps: Pair;
  current_mps: Pair;
  visibility_m: Pair;
  approach_limit_mps: Pair;
  /** Simulated time over wall time. */
  pace: Pair;
  /** Time over which wind or current changes [s]. */
  over_s: Pair;
  /** How far a trial looks ahead [s]. */
  trial_s: Pair;
}

/** A feature of the chart. */
export interface ChartInfo {
  kind:
    | "coverage"
    | "depth_area"
    | "dredged_area"
    | "unsurveyed_area"
    | "depth_contour"
    | "sounding"
    | "coast"
    | "quay"
    | "pontoon"
    | "building"
    | "berth"
    | "fairway"
    | "anchorage"
    | "leading_line"
    | "bridge"
    | "overhead_cable"
    | "rock"
    | "obstruction"
    | "wreck"
    | "mooring"
    | "landmark"
    | "light"
    | "beacon"
    | "buoy"
    | "name";
  /** Empty for none. */
  name: string;
  /** Below chart datum; of areas the least [m]. */
  depth_m: number | null;
  /** Of areas of depth: the greatest [m]. */
  deepest_m: number | null;
  /** Of bridges and overhead cables: height above the water [m]. */
  clearance_m: number | null;
  /** Of buoys, beacons and lights. */
  colour: "red" | "green" | "yellow" | "black" | "white" | null;
  /** The side of the fairway that a lateral mark is on, for a ship that enters. */
  side: "port" | "starboard" | null;
  /** Of buoys and beacons: what the mark says, by IALA's system. A cardinal mark has the direction of the safe water. */
  meaning:
    | "lateral"
    | "north"
    | "east"
    | "south"
    | "west"
    | "isolated_danger"
    | "safe_water"
    | "special"
    | "other"
    | null;
  /** Of buoys and beacons: the shape of the body; `null`: the chart does not give it. */
  form: "cone" | "can" | "ball" | "pillar" | "spar" | "barrel" | "tower" | null;
  /** Of lights: the character as on a chart, such as "Fl(2) R 6s". */
  character: string | null;
  /** Of lights [s]. */
  period_s: number | null;
  /** Of lights: directions from the light, clockwise from the first to the second; `null`: all round [rad]. */
  sector_rad: Pair | null;
  /** Of lights: nominal range [m]. */
  range_m: number | null;
  shape: "point" | "line" | "area";
  /** Earth-fixed [m]: one place, one line, or the rings of an area, each without a repeated last place. */
  lines: Pair[][];
}

export interface BodyInfo {
  name: string;
  fixed: boolean;
  /** Body-fixed [m]. */
  outline: Pair[];
}

export interface VesselInfo {
  name: string;
  /** Index into `bodies`. */
  body: number;
  title: string;
  length_m: number;
  beam_m: number;
  draught_m: number;
  /** `null`: she has none. */
  rudder_stop_rad: number | null;
  full_rps: number | null;
  thrusters: { name: string; along_m: number; force_n: number }[];
  azimuths: { name: string; at_m: Pair; bollard_n: number }[];
  /** She is a tug that assists the named vessel or the pilot's ship. */
  is_tug: boolean;
  /** For a tug, the index of the ship that she serves. */
  serves: number | null;
  /** She has a line to the ship that she serves. */
  has_towline: boolean;
  /** Places at her side where a tug may work; a tug has none. */
  places: Place[];
  /** The orders that she has the gear for. */
  orders: string[];
  /** Her passage plan. */
  plan: PlanInfo | null;
}

/** A passage plan. The server computes tracks and distances; the page draws them. */
export interface PlanInfo {
  name: string;
  waypoints: WaypointInfo[];
  wheel_overs: WheelOverInfo[];
  /** The planned track: legs and turns. */
  track: Pair[];
  /** For each leg with a corridor its edges to port and to starboard. */
  corridor: [Pair[], Pair[]][];
}

export interface WaypointInfo {
  /** Empty for none. */
  name: string;
  at_m: Pair;
  /** Planned speed on the leg that leads here [m/s]. */
  speed_mps: number | null;
}

/** Where the wheel goes over for the turn at a waypoint. */
export interface WheelOverInfo {
  /** Index into the plan's waypoints. */
  waypoint: number;
  at_m: Pair;
  /** Of the track there. */
  course_rad: number;
}

/** Where a ship is on her passage plan. */
export interface PlanNow {
  /** Index of the leg: the one from waypoint `leg` to the next. */
  leg: number;
  /** Distance from the track, positive to starboard of it [m]. */
  cross_track_m: number;
  /** Along the track to the waypoint at the end of the leg; negative after the last [m]. */
  to_waypoint_m: number;
  /** Along the track to the next wheel-over point [m]; `null`: no turn is left. */
  to_wheel_over_m: number | null;
  /** Course of the leg. */
  course_rad: number;
  /** Planned speed on the leg [m/s]. */
  speed_mps: number | null;
  /** Greatest cross-track distance that is planned; `null`: no corridor [m]. */
  half_width_m: number | null;
}

export interface FenderInfo {
  name: string;
  body: number;
  /** Of the mounting, body-fixed [m]. */
  at_m: Pair;
  facing_rad: number;
  width_m: number;
  projection_m: number;
  rated_deflection_m: number | null;
  rated_reaction_n: number | null;
  rated_energy_j: number | null;
}

export interface LineInfo {
  name: string;
  ship: number;
  fairlead_m: Pair;
  /** Its other end: a point on the earth or on a body; `null`: on board until it is sent to a bollard. */
  end: { place_m: Pair } | { body: number; at_m: Pair } | null;
  breaking_n: number;
  /** Tension at which an alarm is raised: half of the breaking load. */
  working_n: number;
  /** Rate of a manual order to its winch [m/s]; `null`: it has none. */
  winch_mps: number | null;
  /** The farthest bollard to which it can be sent [m]. */
  reach_m: number;
  /** What reaches no farther: a heaving line counts where there is no boat. */
  reach_by: "the rope" | "a heaving line";
}

/** An anchor with its chain. */
export interface AnchorInfo {
  name: string;
  /** The body of the ship that carries it. */
  ship: number;
  hawse_m: Pair;
  /** Length of its chain [m]. */
  chain_m: number;
  mass_kg: number;
  breaking_n: number;
  /** Tension at which the brake of the windlass renders. */
  brake_n: number;
}

/** A bollard to which lines can be sent. */
export interface BollardInfo {
  name: string;
  body: number;
  at_m: Pair;
  /** How many lines it takes at once. */
  most_lines: number;
}

/** A vector tug: only her force on the ship is simulated. Tugs that are vessels are in `vessels`. */
export interface TugInfo {
  name: string;
  /** Index into `vessels` of the ship that she serves. */
  vessel: number;
  length_m: number;
  beam_m: number;
  bollard_pull_n: number;
  push_at_m: Pair;
  pull_at_m: Pair;
}

/** A ship that passes on a track of her own: no order moves her, and she touches nothing. */
export interface TrafficInfo {
  name: string;
  /** About midship [m]. */
  outline: Pair[];
}

/** A ship that passes a vessel at rest, and what the flow about her does to the vessel. */
export interface PassageNow {
  /** Index into `Hello.vessels`. */
  vessel: number;
  /** Index into `Hello.traffic`. */
  ship: number;
  /** Clear distance between the outlines [m]. */
  gap_m: number;
  /** The nearest points of both outlines, the vessel's first: north and east [m]. */
  between_m: [Pair, Pair];
  /** Force of the flow of all other ships on the vessel, forward and to starboard [N]. */
  force_n: Pair;
  /** Its moment about midship, bow to starboard [N·m]. */
  yaw_nm: number;
}

/** One tick. The page interpolates between the last two. */
export interface Frame {
  type: "frame";
  tick: number;
  t_s: number;
  /** The server's clock when the tick was made [ms since 1970]. */
  at_ms: number;
  run: RunState;
  /** `null`: this page does not see it, as it lies beyond the visibility. */
  bodies: (BodyNow | null)[];
  vessels: VesselNow[];
  fenders: FenderNow[];
  contacts: ContactNow[];
  lines: LineNow[];
  anchors: AnchorNow[];
  tugs: TugNow[];
  /** Of each ship in `Hello.traffic`; she is where her track says. `null`: this page does not see her in the fog. */
  traffic: (BodyNow | null)[];
  /** Ships of the traffic that pass vessels at rest, at most one for each vessel; without those that this page does not see. */
  passages: PassageNow[];
  /** Wind at the pilot's ship: where it comes from, and its speed; 0 without wind. */
  wind: { speed_mps: number; from_rad: number };
  /** Current at the pilot's ship: where it flows to, and its speed. */
  current: { speed_mps: number; to_rad: number };
  waves: { height_m: number; period_s: number; from_rad: number } | null;
  /** How far people see [m]; `null`: clear. */
  visibility_m: number | null;
  /** The speed limit at the fenders, of docking board and alarms [m/s]. */
  approach_mps: number;
  alarms: Alarm[];
  /** On the run from its start to this tick. */
  verdict: VerdictNow;
  exercise: ExerciseNow | null;
  /** For the instructor only: the score of the exercise. */
  marks?: ExerciseMarks;
  /** Since the last frame. */
  events: { t_s: number; text: string }[];
}

export interface RunState {
  paused: boolean;
  /** Simulated time over wall time. */
  pace: number;
  /** Number of ticks that were late by more than half a step, and the largest delay [ms]. */
  late_ticks: number;
  latest_ms: number;
  branch: number;
  branches: { id: number; from_tick: number; ends_tick: number; parent: number | null }[];
  /** The last tick of this branch: beyond `tick` while rewound. */
  last_tick: number;
  clients: number;
  /** The file that is being opened, what the server does (`reads` it, or `plays` a recording again), and the share done. */
  opening: { file: string; at: "reads" | "plays"; share: number } | null;
}

/** [north, east, heading, velocity north, velocity east, yaw rate]. */
export type BodyNow = [number, number, number, number, number, number];

export interface VesselNow {
  rudder: { order_rad: number; now_rad: number };
  shaft: { order: number; now: number };
  thrusters: { order: number; now: number }[];
  azimuths: {
    power_order: number;
    power: number;
    direction_order_rad: number;
    direction_rad: number;
  }[];
  /** Mode of steering: `hands`, `course`, `speed`, `course+speed`, `station`, `assist`. */
  pilot: string;
  course_rad: number | null;
  speed_order_mps: number | null;
  /** Ahead and to starboard, over ground and through the water [m/s]. */
  ground_mps: Pair;
  water_mps: Pair;
  /** Lateral over ground at the ends, positive to starboard [m/s]. */
  bow_mps: number;
  stern_mps: number;
  heel_rad: number;
  trim_rad: number;
  squat_m: number;
  under_keel_m: number | null;
  aground: boolean;
  /** Her position at the berth, if there is one. */
  berth: BerthNow | null;
  /** Where she is on her passage plan; `null`: she has none. */
  plan: PlanNow | null;
  /** For a tug that is a vessel: her order at the ship. */
  assist: AssistNow | null;
  faults: Fault[];
  /** Thrusters and azimuth units that have tripped, by name. */
  tripped: string[];
}

/**
 * State of an end of a ship, the worst last: clear of the fenders; in contact with them; behind their line where there is
 * none; beyond the last one by more than their spacing; where a hull touched the structure and nobody has acknowledged
 * it; at a fender that was beyond its rating, and nobody has acknowledged it; at one that failed or is beyond its rating; with the hull on the structure.
 */
export type BerthEnd =
  | "off"
  | "at_fenders"
  | "no_fender"
  | "past_end"
  | "touched"
  | "was_over_rated"
  | "over_rated"
  | "structure";

/** The docking board's signal for an end: the worse of its speed and its state. */
export interface Lamp {
  light: "ok" | "caution" | "alarm";
  text: string;
}

/** A ship beside the berth's line of fenders: the two ends of the flat of her side. */
export interface BerthNow {
  bow: BerthEnd;
  stern: BerthEnd;
  /** The speed limit at the nearer end's distance [m/s]. */
  limit_mps: number;
  bow_lamp: Lamp;
  stern_lamp: Lamp;
  /** Distance from the line [m]. */
  bow_m: number;
  stern_m: number;
  /** Speed towards the berth [m/s]. */
  bow_mps: number;
  stern_mps: number;
  /** Speed along the berth, positive ahead [m/s]. */
  along_mps: number;
  /** Angle to the berth, positive with the bow nearer [rad]. */
  angle_rad: number;
}

export interface AssistNow {
  order: TugWord;
  /** Of the order, over her bollard pull. */
  power: number;
  /** Where she works, if that is one of the named places. */
  place: Place | null;
  /** Progress of her order. */
  state: "stands_off" | "comes_alongside" | "alongside" | "pushes" | "takes_up_slack" | "pulls";
  /** Force on the ship: her push, or the tension of her line. Not her thrust, part of which moves herself. */
  force_n: number;
}

export interface FenderNow {
  deflection_m: number;
  reaction_n: number;
  energy_j: number;
  /** Share of the rating; 0 if no rating is given. */
  of_energy: number;
  of_reaction: number;
  peak_of_energy: number;
  peak_of_reaction: number;
  failed: boolean;
  /** It has been loaded beyond its rating. */
  over_rated: boolean;
  /** Since the start. */
  touched: boolean;
}

export interface ContactNow {
  bodies: [number, number];
  fender: number | null;
  at_m: Pair;
  /** On the first body, earth-fixed [N]. */
  force_n: Pair;
  slips: boolean;
}

export interface LineNow {
  /** `ashore`: it will be made fast by itself; `aboard`: it can be sent to a bollard; `sent`: on its way there. */
  state: "ashore" | "aboard" | "sent" | "fast" | "parted";
  tension_n: number;
  /** The tension is above the working load. */
  over_working: boolean;
  /** The bollard at which it is or to which it was sent: an index into `bollards`. */
  bollard: number | null;
  /** Unstretched length outboard [m]. */
  length_m: number | null;
  /** Time until it is fast [s]; `null` while it waits for line handlers or is not under way. */
  fast_in_s: number | null;
  winch: "hold" | "heave" | "pay_out";
}

export interface AnchorNow {
  state: "housed" | "hanging" | "on_bottom" | "lost";
  /** Where it lies; `null` unless it is on the bottom. */
  place_m: Pair | null;
  /** Chain out [m]. */
  chain_m: number;
  /** At the hawse pipe. */
  tension_n: number;
  /** What anchor and chain hold against a horizontal pull. */
  holding_n: number;
  on_bottom_m: number;
  /** Direction of the chain from the bow; `null` where it leads straight down. */
  lead_rad: number | null;
  dragging: boolean;
  dragged_m: number;
  windlass: "hold" | "let_go" | "veer" | "heave";
  /** The chain that shall be out [m]; `null` while the brake holds. */
  to_m: number | null;
  /** The windlass cannot heave against the tension. */
  stalled: boolean;
  /** As the forecastle reports it: "2 shackles out, leads 11 o'clock, medium stay". */
  report: string;
  faults: AnchorFault[];
}

export interface TugNow {
  order: "push" | "pull" | "stop";
  /** Of the order, over her bollard pull. */
  power: number;
  order_n: number;
  order_direction_rad: number;
  force_n: number;
  /** Direction of the force on the ship, from the ship's bow. */
  direction_rad: number;
  limited: boolean;
  /** She has dropped out and carries out no orders. */
  out: boolean;
}

export interface Alarm {
  level: "caution" | "alarm";
  /** Kind and subject. At most one alarm with a key is active. */
  key: string;
  text: string;
  /** Time when it was raised, or became an alarm. */
  since_s: number;
  /** Its cause is present. Otherwise it only waits to be acknowledged. */
  stands: boolean;
  acknowledged: boolean;
}

/** An exercise at this tick. */
export interface ExerciseNow {
  state: "running" | "reached" | "time_over";
  ended_s: number | null;
  /** How long the goal has been fulfilled. */
  held_s: number;
  /** In the order of the goal. */
  conditions: { met: boolean; now: string }[];
}

/** The marks of an exercise up to this tick. */
export interface ExerciseMarks {
  score: number;
  /** `null`: still open. */
  passed: boolean | null;
  /** In the order of the limits. */
  limits: LimitNow[];
}

export interface LimitNow {
  /** The worst value so far. */
  worst: string | null;
  exceeded: boolean;
  /** What it cost so far. */
  points: number;
  /** What exceeded it, when and by how much. */
  why: string | null;
}

/** How grave a verdict or a finding is; `failed`: something broke or was struck, or the results are not valid. */
export type Gravity = "ok" | "note" | "attention" | "failed";

/** The worst that was found in the run, in the words of the terminal and the report. */
export interface VerdictNow {
  key: string;
  text: string;
  gravity: Gravity;
  /** The worst first. */
  findings: { key: string; gravity: Gravity; text: string }[];
}

/** [t_s, north, east, heading]. */
export type PathPoint = [t_s: number, north: number, east: number, heading: number];

export interface ShipPath {
  /** Index into `vessels`. */
  vessel: number;
  path: PathPoint[];
}

/**
 * Up to ten times a second: the predicted paths without further orders of up to three ships. The pilot's ship first, then the
 * other ships, then the tugs.
 */
export interface Prediction {
  type: "prediction";
  tick: number;
  paths: ShipPath[];
}

/** An answer to `trial`, first with what is known so far, at last complete. The ships are those of `prediction`. */
export interface Trial {
  type: "trial";
  /** Of the command. */
  id: number;
  /** The tick from which it begins. */
  tick: number;
  horizon_s: number;
  /** The paths reach the horizon. */
  complete: boolean;
  paths: ShipPath[];
  /** What would be struck or broken, in sentences without a full stop; once it has ended. */
  findings: string[];
}

/**
 * The answer to `history`, before its acknowledgement: what strip charts and log show of the last half hour before the
 * present tick, once a second, column by column. Loads are the greatest of each second.
 */
export interface Past {
  type: "history";
  /** Index of the vessel of which speeds and distances are; `null`: there is no vessel. */
  vessel: number | null;
  t_s: number[];
  /** At the berth if there is one, else sideways over ground at the ends; `null`: there is no vessel. */
  bow_mps: (number | null)[];
  stern_mps: (number | null)[];
  ahead_mps: number[];
  turn_radps: number[];
  /** Distance to the berth. */
  bow_m: (number | null)[];
  stern_m: (number | null)[];
  /** From the track of her passage plan, positive to starboard of it. */
  cross_track_m: (number | null)[];
  /** Greatest load of a fender over its rating, of a line over its working load. */
  of_energy: number[];
  of_reaction: number[];
  of_working: number[];
  /** The sizes of all contact forces together [N]. */
  contact_n: number[];
  /** With alarms that began; `level` is theirs. */
  events: Then[];
}

export interface Then {
  t_s: number;
  text: string;
  level: Alarm["level"] | null;
}

/** For instructors only: what is planned, by time, whenever it has changed. */
export interface Planned {
  type: "planned";
  events: PlannedNow[];
}

export interface PlannedNow {
  id: number;
  at_s: number;
  event: OtherAction;
  state: "waits" | "fired" | "cancelled" | "refused";
  /** Why it could not be carried out. */
  reason: string | null;
}

export interface Ack {
  type: "ack";
  id: number;
  /** The tick in which it takes effect. */
  tick: number;
}

export interface Refused {
  type: "refused";
  id: number | null;
  reason: string;
}

/** A text to be shown for a while: a client joined or left, the session was rewound. */
export interface Notice {
  type: "notice";
  text: string;
}

// ---------------------------------------------------------------- page → server

export interface Command {
  type: "command";
  /** Chosen by the page; the answer has the same. */
  id: number;
  action: Action;
}

/** Every command: an order of the table, or one of the others. */
export type Action = Order | OtherAction;

/** Words for a tug. `stop`: no force; `stand_off`: keep clear of the side. */
export type TugWord = "push" | "pull" | "stop" | "stand_off";
/** Direction of a tug: square to the side, or 45° towards the ship's bow or stern. */
export type Lead = "square" | "forward" | "aft";
/** Place of a tug at the ship's side. `VesselInfo.places` has those of each ship. */
export type Place =
  | "nearest"
  | "port shoulder"
  | "port midships"
  | "port quarter"
  | "starboard shoulder"
  | "starboard midships"
  | "starboard quarter";

/** What a trial takes: an order of the table, or one to a tug in words. */
export type TrialOrder = Order | TugOrder;

export interface TugOrder {
  do: "tug";
  tug: string;
  order: TugWord;
  power?: number;
  lead: Lead;
  place: Place;
}

export type OtherAction =
  /** To a tug of either kind, in words: the server finds force, direction and place. `power` is over her bollard pull; a push and a pull need it. */
  | TugOrder
  // Claims.
  | { do: "claim"; control: Control }
  | { do: "release"; control: Control }
  /** The name of the person at this page: 1 to 30 characters. */
  | { do: "name"; name: string }
  /** `key`: a secret of this page that it keeps over a reload, 32 hexadecimal digits. */
  | { do: "seat"; key: string }
  /**
   * Shows where orders would take the ships, on a copy of the run. `trial` messages with the number of this command follow. A new
   * trial of this page ends the one before.
   */
  | { do: "trial"; orders: TrialOrder[]; horizon_s: number }
  /** Gives up to 16 orders at once: all of them or none. */
  | { do: "give"; orders: TrialOrder[] }
  // For the instructor only.
  | { do: "pause" }
  | { do: "resume" }
  | { do: "single_step" }
  | { do: "pace"; pace: number }
  | { do: "rewind"; tick: number }
  /** Continues from the rewound state as a new branch. */
  | { do: "branch" }
  | { do: "show_branch"; id: number }
  /** Acknowledged when it begins. `run.opening` has the progress. If it fails, a `refused` without `id` has the reason. */
  | { do: "load"; file: string }
  | { do: "stop_opening" }
  | { do: "save"; name: string }
  /**
   * Renames a recording or a saved exercise; `name` is without ending. Never to a name that is taken. These three are acknowledged when
   * they are done.
   */
  | { do: "rename"; file: string; name: string }
  /** Moves it among the deleted files. Not what is being recorded or run. */
  | { do: "delete"; file: string }
  | { do: "put_back"; file: string }
  /** Sends `Past`, once a second: of the ship of the link, to the instructor of any ship. */
  | { do: "history"; vessel?: string }
  /**
   * Saves a new exercise in the gallery's folder, under a name without ending. A name that is taken is refused, unless it
   * may be replaced. It is acknowledged when it is saved.
   */
  | { do: "create"; of: { name: string; exercise: NewExercise; replace: boolean } }
  /** Makes the report of the session up to now. When it is acknowledged, `/report` with the instructor's token has it. */
  | { do: "report" }
  /** Acknowledges an alarm: pilot and instructor any, a tugmaster those of the own tug. Recorded. */
  | { do: "acknowledge"; key: string }
  /** The instructor's note for the debriefing: one line of at most 300 characters; without a text, a mark. Recorded. */
  | { do: "note"; text?: string }
  /** The speed limit at the fenders, of docking board and alarms: by pilot and instructor. */
  /** `null`: clear. */
  | { do: "visibility"; distance_m: number | null; over_s?: number }
  | { do: "approach_limit"; speed_mps: number }
  /** At once, or over a time. */
  | { do: "wind"; speed_mps: number; from_rad: number; over_s?: number }
  | { do: "current"; speed_mps: number; to_rad: number; over_s?: number }
  | { do: "part_line"; line: string }
  | { do: "anchor_fault"; anchor: string; fault: AnchorFault; on: boolean }
  /** A vector tug drops out, or comes back. */
  | { do: "tug_out"; tug: string; on: boolean }
  /** Plans weather or a fault for a time of the run. */
  | { do: "plan"; at_s: number; event: OtherAction }
  | { do: "cancel_planned"; id: number }
  | { do: "fault"; vessel: string; fault: Fault; on: boolean }
  /** One thruster or azimuth unit trips, or comes back. */
  | { do: "thruster_out"; vessel: string; thruster: string; on: boolean }
  /** Places a ship before the first step: her centre of gravity. Refused with the reason where she cannot be. */
  | { do: "place"; vessel: string; at_m: Pair; heading_rad: number; ahead_mps?: number }
  /** Saves the present state as an exercise of the gallery, as `create` does a new one. */
  | { do: "save_exercise"; name: string; title: string; replace: boolean };

export type AnchorFault = "windlass_failed" | "does_not_bite";

/** Those of frozen instruments are only sent to instructors: their own page shows the truth. */
export type Fault =
  | "rudder_stuck"
  | "follow_up_lost"
  | "engine_lost"
  | "thrusters_lost"
  | "blackout"
  | "heading_frozen"
  | "speed_frozen"
  | "position_frozen";
