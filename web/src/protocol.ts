/**
 * The messages between server and page over the websocket `/live?token=…`: JSON text, one message a frame.
 *
 * Written from the messages in `crates/live/src` by `cargo xtask protocol`: change them there, not here.
 * Orders are in `orders.ts`. Units are SI: metres, seconds, radians, newtons, joules, kilograms. Earth-fixed places are
 * [north, east]; headings and bearings are from north, positive to starboard; body-fixed places are [forward, starboard].
 */

import type { Order } from "./orders";

/** A place or a vector: [north, east] or [forward, starboard]. */
export type Pair = [number, number];

/** State of a body: [north, east, heading, velocity north, velocity east, yaw rate]. */
export type BodyNow = [number, number, number, number, number, number];

/**
 * A harmonic of the sea: amplitude a [m], wave number k north and east [rad/m], angular frequency ω [rad/s], phase ε [rad]. The
 * height of the surface is the sum of a cos(ωt − k·x + ε).
 */
export type Wave = [a: number, north: number, east: number, omega: number, phase: number];

/** A point of a path: [t_s, north, east, heading]. */
export type PathPoint = [t_s: number, north: number, east: number, heading: number];

export type FromServer = Hello | Frame | Past | Reply;

/** Up to ten times a second: the predicted paths of up to three ships without further orders. */
export type Prediction = Extract<Reply, { type: "prediction" }>;
/** An answer to the command `trial`. */
export type Trial = Extract<Reply, { type: "trial" }>;
/** For instructors only: what is planned, by time, whenever the plan has changed. */
export type Planned = Extract<Reply, { type: "planned" }>;
export type Ack = Extract<Reply, { type: "ack" }>;
export type Refused = Extract<Reply, { type: "refused" }>;
export type Notice = Extract<Reply, { type: "notice" }>;

/** A tick as pages get it. The page interpolates between the last two frames. */
export type Frame = FrameOfAll & {
  /** For the instructor only: the marks of the exercise. */
  marks?: ExerciseMarks;
  /** The events since the last frame. */
  events: EventNow[];
};

/** What a page sends. */
export interface Command {
  type: "command";
  /** The page chooses the number; the answer has the same number. */
  id: number;
  action: Action;
}

/** Every command: an order of the table, or one of the others. */
export type Action = Order | OtherAction;
export type OtherAction = RecordedAction | Conduct;
/** An order to a tug in words. */
export type TugOrder = Extract<RecordedAction, { do: "tug" }>;
/** What a trial takes: an order of the table, or an order to a tug in words. */
export type TrialOrder = Order | TugOrder;

/** How grave a verdict or a finding is; `failed`: something broke or was struck, or the results are not valid. */
export type Gravity = "ok" | "note" | "attention" | "failed";

/** Number of this protocol. */
export const PROTOCOL = 9;

/** Words for a tug. `stop`: no force; `stand_off`: she keeps clear of the side. */
export type TugWord = "push" | "pull" | "stop" | "stand_off";

/** Direction of a tug: square to the ship's side, or 45° towards the ship's bow or stern. */
export type Lead = "square" | "forward" | "aft";

/** Place of a tug at a ship's side. `VesselInfo.places` has the places of each ship. */
export type Place =
  | "nearest"
  | "port shoulder"
  | "port midships"
  | "port quarter"
  | "starboard shoulder"
  | "starboard midships"
  | "starboard quarter";

/** Faults of a vessel. Only instructors are told of frozen instruments. */
export type Fault =
  | "rudder_stuck"
  | "follow_up_lost"
  | "engine_lost"
  | "thrusters_lost"
  | "blackout"
  | "heading_frozen"
  | "speed_frozen"
  | "position_frozen";

/** Types of ships, by which the view draws them. */
export type ShipType = "bulk" | "tanker" | "container" | "ro-ro" | "passenger" | "tug";

/** Rain in the view out of the window. */
export type Rain = "light" | "moderate" | "heavy";

/** Kinds of features of a chart. */
export type ChartKind =
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

/** Colours of buoys, beacons and lights. */
export type MarkColour = "red" | "green" | "yellow" | "black" | "white";

/** The side of the fairway on which a lateral mark is, for a ship that enters. */
export type MarkSide = "port" | "starboard";

/** What a buoy or beacon says, by IALA's system. */
export type MarkMeaning =
  | "lateral"
  | "north"
  | "east"
  | "south"
  | "west"
  | "isolated_danger"
  | "safe_water"
  | "special"
  | "other";

/** Shapes of buoys and beacons. */
export type MarkShape = "cone" | "can" | "ball" | "pillar" | "spar" | "barrel" | "tower";

/**
 * The data from which a page is built. The server sends this message first, and again whenever the scenario, the
 * branch of the session or the holders of the helms change.
 */
export type Hello = {
  type: "hello";
  /**
   * Version number of the server's protocol. If the number differs from `PROTOCOL`, page and program are of
   * different versions.
   */
  protocol: number;
  role: Role;
  title: string;
  /** File name of the scenario; the entry of the scenario in `gallery` has the same name. */
  file: string;
  step_s: number;
  bodies: Array<BodyInfo>;
  vessels: Array<VesselInfo>;
  fenders: Array<FenderInfo>;
  lines: Array<LineInfo>;
  anchors: Array<AnchorInfo>;
  bollards: Array<BollardInfo>;
  tugs: Array<TugInfo>;
  traffic: Array<TrafficInfo>;
  /** The orders that a page can give, with their words, units and limits. */
  orders: Array<OrderInfo>;
  /** The positions of the engine telegraph, from full astern to navigation full. */
  telegraph: Array<TelegraphInfo>;
  /** The limits of commands that are not in the table of orders. */
  limits: CommandLimits;
  /** The helms that this page may take. */
  mine: Array<Control>;
  /** For each helm, who holds the helm. */
  claims: Array<Claim>;
  /** The scenarios and recordings that the instructor can open. */
  gallery: Array<GalleryEntry>;
  /** The berth to which the docking board measures distances. */
  berth: BerthInfo | null;
  depth_m: number | null;
  /** A level above datum that the water of the run does not exceed, waves apart (m). */
  highest_water_m: number;
  /**
   * Height above datum of the level of high water from which the chart gives clearances (m); `null` if the scenario
   * does not give the level.
   */
  clearance_datum_m: number | null;
  /** The harmonics of the run's waves; empty without waves. */
  sea: Wave[];
  /** Where and when the run begins, for the sun; `null` if the scenario gives no time. */
  daylight: DaylightInfo | null;
  /** Rain in the view; `null`: no rain. */
  rain: Rain | null;
  /** The features of the chart, which pages draw behind ships and quays. */
  chart: Array<ChartInfo>;
  /** A measured ship, which takes part in nothing physical; absent if the session has none. */
  ghost?: Ghost;
  /** The exercise of the pilot; `null` if the scenario has no exercise. */
  exercise: ExerciseInfo | null;
  /** The link of each role, as a path on this server. Only instructors get the links. */
  links?: Array<Link>;
  /** The vessels and fenders of which a new exercise can be made. Only instructors get the library. */
  library?: LibraryInfo;
  /** Deleted files that can be put back. Only instructors get the list of deleted files. */
  deleted?: Array<GalleryEntry>;
};

export type Role =
  | { name: "instructor" }
  | { name: "pilot"; vessel?: string }
  | { name: "tugmaster"; tug: string }
  | { name: "observer" };

/** A helm that a page can hold: that of a vessel or a vector tug, by her name, or that of the session. */
export type Control = { vessel: string } | { tug: string } | { session: true };

export type Claim = { control: Control; holder: string | null; connected: boolean };

export type Link = { role: Role; path: string };

export type GalleryEntry = {
  file: string;
  title: string;
  text: string;
  /** The berth of the listed scenario in words, if a new exercise can use the berth. */
  berth: string | null;
  /** Time at which the recording's file was last written (seconds since the start of 1970). `None` for a scenario. */
  written_unix_s: number | null;
  /**
   * True if the instructor can rename and delete the listed file. A file can be changed if it is a recording, or
   * an exercise saved from the page, and lies in the server's folders.
   */
  changeable: boolean;
};

/** Where and when a run begins, for the sun. */
export type DaylightInfo = {
  /** Time at the start of the run: seconds since the start of 1970, universal time. */
  start_unix_s: number;
  /** Latitude of the scenario's origin, north positive (rad). */
  latitude_rad: number;
  /** Longitude of the scenario's origin, east positive (rad). */
  longitude_rad: number;
};

/** The ships, tugs and fenders among which an instructor chooses for a new exercise. */
export type LibraryInfo = { vessels: Array<LibraryVessel>; fenders: Array<FamilyInfo> };

export type LibraryVessel = {
  name: string;
  title: string;
  length_m: number;
  beam_m: number;
  draught_m: number;
  is_tug: boolean;
};

export type FamilyInfo = { name: string; sizes: Array<SizeInfo> };

export type SizeInfo = { designation: string; height_m: number; rated_reaction_n: number };

/** The goal of an exercise and its limits. */
export type ExerciseInfo = {
  task: string;
  /** Name of the ship whose berthing is judged. */
  ship: string;
  /** The conditions of the goal in words. All conditions must hold at the same time. */
  goal: Array<string>;
  /** The lines of which the goal asks a tension; `null` if it asks none. */
  tension: TensionInfo | null;
  /** Time for which all conditions of the goal must hold (s). */
  hold_s: number;
  time_limit_s: number | null;
  /** The least score with which the exercise is passed. */
  pass_mark: number;
  limits: Array<LimitInfo>;
  /** Where an anchor must lie; `None` if the goal asks for no place of an anchor. */
  place: PlaceInfo | null;
  /** Name of the mark of the berth; `null` if the exercise has no mark. */
  mark: string | null;
  /** False if the view shows marks to the instructor alone. */
  view_marks: boolean;
};

/** A place that a goal asks for, and the distance from this place that is still good enough. */
export type PlaceInfo = { at_m: [number, number]; within_m: number };

/** The tension that a goal asks of lines. */
export type TensionInfo = {
  /** Indices of the lines. */
  lines: Array<number>;
  /** Least tension (N). */
  least_n: number;
  /** Greatest tension (N); `null` if the goal has no greatest tension. */
  most_n: number | null;
};

export type LimitInfo = {
  key: string;
  /** The quantity that the limit bounds, in words. */
  text: string;
  rule: string;
  /** The value of the quantity beyond which points are lost (unit SI). */
  bound: number;
  /** The largest number of points that the limit can cost. */
  points: number;
  /** True if the exercise is failed when the limit is exceeded. */
  fails: boolean;
};

/** An order in the table of orders of `fenderline_sim`. */
export type OrderInfo = {
  /** The word of the order in the field `do` of a command. */
  name: string;
  /** The field of a command that names the vessel, tug or line to which the order goes. */
  target: "vessel" | "tug" | "line";
  /** The gear that the vessel, tug or line must have for the order; `null` if the order needs no gear. */
  needs: string | null;
  meaning: string;
  arguments: Array<ArgumentInfo>;
};

export type ArgumentInfo = {
  /** Name of the argument's field in a command. */
  name: string;
  kind: "number" | "place" | "name";
  /** Unit of the argument; empty for a share and for a name. */
  unit: string;
  /** The least and the greatest value of the argument. */
  limits: [number, number] | null;
  /** The value that counts if a command leaves the argument out. */
  default: number | null;
  required: boolean;
  meaning: string;
};

/** An order that the engine telegraph can give. */
export type TelegraphInfo = {
  /** The telegraph's position as scenario files write it, such as `dead slow ahead`. */
  word: string;
  /** Revolutions ordered by the telegraph's position, over full revolutions; negative astern. */
  share: number;
};

/**
 * Limits of the commands that are not in the table of orders: the least and the greatest value of each number. Pages
 * of the browser get these limits in the message `hello`.
 */
export type CommandLimits = {
  /** Force in an order in words to a tug, as a share of her bollard pull. */
  tug_power: [number, number];
  /** Speed of a wind (m/s). */
  wind_mps: [number, number];
  /** Speed of a current (m/s). */
  current_mps: [number, number];
  /** Visibility (m). */
  visibility_m: [number, number];
  /** Limit of the closing speed at the fenders (m/s). */
  approach_limit_mps: [number, number];
  /** Pace of the exercise: simulated time over wall time. */
  pace: [number, number];
  /** Time over which wind, current or visibility changes (s). */
  over_s: [number, number];
  /** Time that a trial looks ahead (s). */
  trial_s: [number, number];
};

export type BerthInfo = {
  body: number;
  from: [number, number];
  to: [number, number];
  facing: [number, number];
};

/** A feature of the chart. */
export type ChartInfo = {
  kind: ChartKind;
  /** Name of the feature; empty if the feature has no name. */
  name: string;
  /** Depth of the water below chart datum (m); for an area, the least depth. */
  depth_m: number | null;
  /** The greatest depth of an area of depth (m). */
  deepest_m: number | null;
  /** Height of a bridge or an overhead cable above the level of high water of the chart (m). */
  clearance_m: number | null;
  /** Colour of a buoy, beacon, mooring buoy or light. */
  colour: MarkColour | null;
  /** The side of the fairway on which a lateral mark is, for a ship that enters. */
  side: MarkSide | null;
  /**
   * What a buoy or beacon says, by IALA's system. A cardinal mark has the direction of the safe water, a mooring buoy
   * has `other`, and other moorings have none.
   */
  meaning: MarkMeaning | null;
  /** Shape of the body of a buoy or beacon; `null` if the chart does not give the shape. */
  form: MarkShape | null;
  /** Character of a light as charts write it, such as "Fl(2) R 6s". */
  character: string | null;
  /** Period of a light (s). */
  period_s: number | null;
  /**
   * Sector of a light: two directions seen from the light, clockwise from the first to the second (rad); `null`
   * if the light shines all round.
   */
  sector_rad: [number, number] | null;
  /** Nominal range of a light (m). */
  range_m: number | null;
  shape: "point" | "line" | "area";
  /** Places on the earth (m): one place, one line, or the rings of an area. A ring does not repeat its first place. */
  lines: Array<Array<[number, number]>>;
};

export type BodyInfo = {
  name: string;
  fixed: boolean;
  /** Corners of the body's outline, in the axes of the body (m). */
  outline: Array<[number, number]>;
  /** The outlines of a body whose outline differs with height, from the lowest up; empty for other bodies. */
  levels: Array<LevelInfo>;
};

/**
 * The outline of a body at a height. Between two outlines the side is straight, from each corner of one outline to the
 * same corner of the next outline.
 */
export type LevelInfo = {
  /** Height above the waterline of a floating body at rest, or above datum on a fixed body (m). */
  height_m: number;
  /** Corners of the outline, in the axes of the body (m). */
  outline: Array<[number, number]>;
};

/** A model of a ship: a binary glTF file, which the server sends for `/model?token=…&vessel=N`. */
export type ModelInfo = {
  /** Name of the file, as the scenario gives the name. */
  file: string;
  /** Check sum of the file (CRC-32): a changed file has another. */
  crc32: number;
  /** Place of the model's origin, which is amidships on the waterline, in the axes of the body (m). */
  origin_m: [number, number];
};

export type VesselInfo = {
  name: string;
  /** Index of the vessel's body in `bodies`. */
  body: number;
  title: string;
  length_m: number;
  beam_m: number;
  draught_m: number;
  /** Type of ship by which the view draws her; `null`: the words of the title say the type. */
  kind: ShipType | null;
  /** Place of the eye on the bridge; `null`: the usual place for her type. */
  conning: ConningInfo | null;
  /** The user's model of the ship for the view; `null`: the view draws the ship. */
  model: ModelInfo | null;
  /** Least under-keel clearance of the vessel without a caution (m). */
  under_keel_limit_m: number;
  /** Largest angle of the rudder (rad); `null` if the vessel has no rudder. */
  rudder_stop_rad: number | null;
  full_rps: number | null;
  thrusters: Array<ThrusterInfo>;
  azimuths: Array<AzimuthInfo>;
  /** True if the vessel is a tug that assists another vessel. */
  is_tug: boolean;
  /** Index of the ship that the tug serves. */
  serves: number | null;
  /** True if the tug has a line to the ship that the tug serves. */
  has_towline: boolean;
  /** Places at the ship's side where a tug may work; empty for a tug. */
  places: Place[];
  /** The orders for which the vessel has the gear. */
  orders: Array<string>;
  /** The vessel's passage plan; `null` if the vessel has no plan. */
  plan: PlanInfo | null;
};

/** The place from which a ship is conned. */
export type ConningInfo = {
  /** Place of the eye, forward and to starboard in the axes of the body (m). */
  at_m: [number, number];
  /** Height of the eye above the still water (m). */
  eye_above_water_m: number;
};

/** A passage plan of a vessel. The program computes tracks and distances, and the page draws them. */
export type PlanInfo = {
  name: string;
  waypoints: Array<WaypointInfo>;
  wheel_overs: Array<WheelOverInfo>;
  /** The planned track: legs, and arcs between the legs. */
  track: Array<[number, number]>;
  /** For each leg with a corridor, the edge to port and the edge to starboard. */
  corridor: Array<[Array<[number, number]>, Array<[number, number]>]>;
};

/** A waypoint of a passage plan. */
export type WaypointInfo = {
  /** Name of the waypoint; empty if the waypoint has no name. */
  name: string;
  at_m: [number, number];
  /** Planned speed on the leg that leads to the waypoint (m/s). */
  speed_mps: number | null;
};

/** A place at which the wheel goes over for the turn at a waypoint. */
export type WheelOverInfo = {
  /** Index of the waypoint among the waypoints of the plan. */
  waypoint: number;
  at_m: [number, number];
  /** Course of the track at the place (rad). */
  course_rad: number;
};

export type ThrusterInfo = { name: string; along_m: number; force_n: number };

export type AzimuthInfo = { name: string; at_m: [number, number]; bollard_n: number };

export type FenderInfo = {
  name: string;
  body: number;
  /** Position of the fender's mounting, in the axes of the body (m). */
  at_m: [number, number];
  facing_rad: number;
  width_m: number;
  projection_m: number;
  /** Height of the fender's face (m). */
  height_m: number;
  /**
   * Height of the middle of the face above the still water, or above datum on a fixed body (m). 0 where the scenario
   * gives no height.
   */
  above_water_m: number;
  /** True if the fender floats: `above_water_m` is then above the water on a fixed body, too. */
  floating: boolean;
  /** Name of the fender's family in the library; `null` if the scenario gives the fender's reaction itself. */
  family: string | null;
  /**
   * Places of the cones behind the panel, along the face from its middle (m), positive to the right of a viewer who
   * faces the panel; empty for a fender with a single element.
   */
  cones_m: Array<number>;
  rated_deflection_m: number | null;
  rated_reaction_n: number | null;
  rated_energy_j: number | null;
};

export type LineInfo = {
  name: string;
  ship: number;
  fairlead_m: [number, number];
  /**
   * Height of the fairlead above the still water, or above datum on a fixed body (m). 0 where the scenario gives no
   * height.
   */
  fairlead_above_water_m: number;
  /**
   * The place where the line is made fast if nobody orders another. The place is `null` for a line that stays on
   * board until it is sent to a bollard.
   */
  end: LineEndInfo | null;
  /** Whether the line goes between a tug and a ship. */
  is_towline: boolean;
  breaking_n: number;
  /** Tension at which the line raises an alarm: half of the breaking load (N). */
  working_n: number;
  /** Rate at which the line's winch carries out a manual order (m/s); `null` if the line has no winch. */
  winch_mps: number | null;
  /** Distance to the farthest bollard that the line can reach (m). */
  reach_m: number;
  /** The thing that limits how far the line reaches: the rope, or a heaving line where there is no boat. */
  reach_by: "the rope" | "a heaving line";
};

export type LineEndInfo =
  | { place_m: [number, number]; above_datum_m: number }
  | { body: number; at_m: [number, number]; above_water_m: number };

/** An anchor with its chain. */
export type AnchorInfo = {
  name: string;
  /** Index of the body of the ship that carries the anchor. */
  ship: number;
  hawse_m: [number, number];
  /** Height of the hawse pipe above the still water (m). */
  hawse_above_water_m: number;
  /** Length of the anchor's chain (m). */
  chain_m: number;
  mass_kg: number;
  breaking_n: number;
  /** Tension at which the brake of the windlass renders (N). */
  brake_n: number;
};

/** A bollard to which lines can be sent. */
export type BollardInfo = {
  name: string;
  body: number;
  at_m: [number, number];
  /**
   * Height of the bollard above the still water, or above datum on a fixed body (m). 0 where the scenario gives no
   * height.
   */
  above_water_m: number;
  /** The largest number of lines that the bollard takes at the same time. */
  most_lines: number;
};

/** A vector tug: only her force on the ship is simulated. Tugs that are vessels are in `vessels`. */
export type TugInfo = {
  name: string;
  /** Index in `vessels` of the ship that the tug serves. */
  vessel: number;
  length_m: number;
  beam_m: number;
  bollard_pull_n: number;
  push_at_m: [number, number];
  pull_at_m: [number, number];
};

/** A ship that passes on a track of her own. No order moves the passing ship, and she touches nothing. */
export type TrafficInfo = {
  name: string;
  /** Corners of the ship's outline about midship (m). */
  outline: Array<[number, number]>;
};

/** The track of a measured ship on the clock of the session. The recording of the session keeps the track. */
export type Ghost = {
  /** Name of the ship in the log; empty if the log names none. */
  ship: string;
  /** Name of the log, without folders. */
  file: string;
  /** Corners of the hull in the ship's axes. */
  outline: Array<[number, number]>;
  /** The track, by time; pages go straight from point to point. */
  points: PathPoint[];
  /** Time of the first touch of a fender (s); `null` if the track has none. */
  touch_s: number | null;
};

/** A frame without its `events`, because each client gets other events. */
export type FrameOfAll = {
  type: "frame";
  tick: number;
  t_s: number;
  /** The server's clock when the tick was made (ms since the start of 1970). */
  at_ms: number;
  run: RunState;
  /** Position and motion of each body; `None` if fog hides the body. */
  bodies: (BodyNow | null)[];
  /**
   * The own vessel as the eye sees her out of the window. `null` while `bodies` and `vessels` have her true motion:
   * they have what her instruments show, and an instrument may be frozen.
   */
  eyes: EyesNow | null;
  vessels: Array<VesselNow>;
  fenders: Array<FenderNow>;
  contacts: Array<ContactNow>;
  lines: Array<LineNow>;
  anchors: Array<AnchorNow>;
  tugs: Array<TugNow>;
  /** Position and motion of each passing ship; `None` if fog hides the ship. */
  traffic: (BodyNow | null)[];
  /**
   * Passing ships that are near a vessel at rest, at most one passing ship for each vessel. Passing ships in the
   * fog are left out.
   */
  passages: Array<PassageNow>;
  /** Wind at the pilot's ship; a speed of 0 means no wind. */
  wind: WindNow;
  /** Current at the pilot's ship. */
  current: CurrentNow;
  waves: WavesNow | null;
  /** Level of the water above datum (m): heights on fixed bodies count from datum, heights on ships from the water. */
  water_level_m: number;
  /** Visibility (m); `null` if the air is clear. */
  visibility_m: number | null;
  /** The limit of the closing speed at the fenders, which docking board and alarms use (m/s). */
  approach_mps: number;
  alarms: Array<Alarm>;
  /** The verdict on the run from the start to this tick. */
  verdict: VerdictNow;
  exercise: ExerciseNow | null;
};

export type RunState = {
  paused: boolean;
  /** Pace of the run: simulated time over wall time. */
  pace: number;
  /** Number of ticks that were late by more than half a step. */
  late_ticks: number;
  latest_ms: number;
  branch: number;
  branches: Array<BranchNow>;
  /** The last tick of the branch that is shown. While the run is rewound, the last tick lies beyond `Frame.tick`. */
  last_tick: number;
  clients: number;
  /** The file that the server is opening; `null` if the server opens no file. */
  opening: OpeningNow | null;
};

export type OpeningNow = {
  file: string;
  /** What the server does with the file: it reads a scenario, or plays a recording again. */
  at: "reads" | "plays";
  share: number;
};

export type BranchNow = { id: number; from_tick: number; ends_tick: number; parent: number | null };

export type VesselNow = {
  rudder: RudderNow;
  shaft: ShareNow;
  thrusters: Array<ShareNow>;
  azimuths: Array<AzimuthNow>;
  /** The vessel's mode of steering: `hands`, `course`, `speed`, `course+speed`, `station` or `assist`. */
  pilot: string;
  course_rad: number | null;
  speed_order_mps: number | null;
  /** Speed of the vessel over ground, ahead and to starboard (m/s). */
  ground_mps: [number, number];
  water_mps: [number, number];
  /** Lateral speed of the bow over ground, positive to starboard (m/s). */
  bow_mps: number;
  stern_mps: number;
  heel_rad: number;
  trim_rad: number;
  /** Heave, positive down, without squat (m). */
  heave_m: number;
  squat_m: number;
  under_keel_m: number | null;
  aground: boolean;
  /** Position of the vessel at the berth; `null` if the scenario has no berth. */
  berth: BerthNow | null;
  /** Place of the vessel on her passage plan; `null` if the vessel has no plan. */
  plan: PlanNow | null;
  /** The order that a tug carries out at her ship; `null` for other vessels. */
  assist: AssistNow | null;
  faults: Fault[];
  /** Thrusters and azimuth units that have tripped, by name. */
  tripped: Array<string>;
};

/** Where a vessel is on her passage plan. */
export type PlanNow = {
  /** Index of the leg, which leads from the waypoint with the same index to the next waypoint. */
  leg: number;
  /** Distance from the track, positive to starboard of the track (m). */
  cross_track_m: number;
  /** Distance along the track to the waypoint at the end of the leg; negative after the last waypoint (m). */
  to_waypoint_m: number;
  /** Distance along the track to the next wheel-over point; `null` if no turn is left (m). */
  to_wheel_over_m: number | null;
  /** Course of the leg (rad). */
  course_rad: number;
  /** Planned speed on the leg (m/s). */
  speed_mps: number | null;
  /** Largest planned cross-track distance; `null` if the leg has no corridor (m). */
  half_width_m: number | null;
};

export type RudderNow = { order_rad: number; now_rad: number };

export type ShareNow = { order: number; now: number };

export type AzimuthNow = {
  power_order: number;
  power: number;
  direction_order_rad: number;
  direction_rad: number;
};

export type AssistNow = {
  order: TugWord;
  /** Force of the order, as a share of the tug's bollard pull. */
  power: number;
  /** The place where the tug works; `null` if this place has no name. */
  place: Place | null;
  /** How far the tug has come with her order. */
  state: AssistState;
  /**
   * Distance of the tug from the place of her order (m): of the tip of her bow while she is to push or to lie
   * alongside, of her centre of gravity while she is to stand off. `null` while she is to pull.
   */
  away_m: number | null;
  /** While the tug is to pull and her line is slack: how much longer the line is than the way between its ends (m). */
  slack_m: number | null;
  /**
   * Force of the tug on the ship: the push of the tug, or the tension of her line (N). The thrust of the tug is
   * larger while part of the thrust moves the tug.
   */
  force_n: number;
};

/** What a tug that is a vessel is doing to carry out her order. */
export type AssistState =
  "stands_off" | "comes_alongside" | "alongside" | "pushes" | "takes_up_slack" | "pulls";

/** A ship beside the berth's line of fenders. Bow and stern mean the two ends of the flat part of the ship's side. */
export type BerthNow = {
  bow: BerthEnd;
  stern: BerthEnd;
  /** The limit of the closing speed at the distance of the bow (m/s). */
  bow_limit_mps: number;
  stern_limit_mps: number;
  bow_lamp: Lamp;
  stern_lamp: Lamp;
  /** Distance of the bow from the line of fenders (m). */
  bow_m: number;
  stern_m: number;
  /** Speed of the bow towards the berth (m/s). */
  bow_mps: number;
  stern_mps: number;
  /** Speed of the ship along the berth, positive ahead (m/s). */
  along_mps: number;
  /** Angle between ship and berth, positive if the bow is nearer (rad). */
  angle_rad: number;
};

/** How an end of a ship lies at the berth. */
export type BerthEnd =
  | "off"
  | "at_fenders"
  | "no_fender"
  | "past_end"
  | "touched"
  | "was_over_rated"
  | "over_rated"
  | "structure";

/**
 * The signal of the docking board for an end of a ship: the worse of two signals, one for the speed of the end and
 * one for its position.
 */
export type Lamp = {
  light: Light;
  text: string;
  /** Whether the signal is that of the speed. */
  by_speed: boolean;
};

/** A signal of the docking board. */
export type Light = "ok" | "caution" | "alarm";

export type FenderNow = {
  deflection_m: number;
  reaction_n: number;
  energy_j: number;
  /** Energy of the fender as a share of the rated energy; 0 if the fender has no rating. */
  of_energy: number;
  of_reaction: number;
  peak_of_energy: number;
  peak_of_reaction: number;
  failed: boolean;
  /** True if the fender was loaded beyond its rating at any time. */
  over_rated: boolean;
  /** True if the fender was touched at any time since the start. */
  touched: boolean;
};

export type ContactNow = {
  bodies: [number, number];
  fender: number | null;
  at_m: [number, number];
  /** Force on the first body, north and east (N). */
  force_n: [number, number];
  slips: boolean;
};

export type LineNow = {
  /**
   * A line that is `ashore` will be made fast without an order. A line that is `aboard` can be sent to a
   * bollard, and a line that is `sent` is on the way to a bollard.
   */
  state: "ashore" | "aboard" | "sent" | "fast" | "parted";
  tension_n: number;
  /** True if the tension is above the working load. */
  over_working: boolean;
  /** Index of the bollard to which the line is fast or on its way. */
  bollard: number | null;
  /** Unstretched length of the line outboard (m). */
  length_m: number | null;
  /**
   * Time until the line is fast (s). The time is `null` while the line waits for line handlers or is not under
   * way.
   */
  fast_in_s: number | null;
  winch: "hold" | "heave" | "pay_out";
};

export type AnchorNow = {
  state: "housed" | "hanging" | "on_bottom" | "lost";
  /** Position of the anchor on the bottom; `null` if the anchor does not lie there. */
  place_m: [number, number] | null;
  /** Length of the chain that is out (m). */
  chain_m: number;
  /** Tension of the chain at the hawse pipe (N). */
  tension_n: number;
  /** The largest horizontal pull that anchor and chain hold (N). */
  holding_n: number;
  on_bottom_m: number;
  /** Direction of the chain from the bow; `null` if the chain leads straight down. */
  lead_rad: number | null;
  dragging: boolean;
  dragged_m: number;
  windlass: "hold" | "let_go" | "veer" | "heave";
  /** Length of chain that the windlass shall put out (m); `null` while the brake holds. */
  to_m: number | null;
  /** True if the windlass cannot heave against the tension. */
  stalled: boolean;
  /** The report from the forecastle about the anchor. */
  report: string;
  faults: Array<AnchorFault>;
};

/** A fault of an anchor. [`fenderline_sim::anchor::AnchorFaults`] describes the faults. */
export type AnchorFault = "windlass_failed" | "does_not_bite";

export type TugNow = {
  order: "push" | "pull" | "stop";
  /** Force of the order, as a share of the tug's bollard pull. */
  power: number;
  order_n: number;
  order_direction_rad: number;
  force_n: number;
  /** Direction of the tug's force on the ship, from the ship's bow (rad). */
  direction_rad: number;
  limited: boolean;
  /** True if the tug has dropped out and carries out no orders. */
  out: boolean;
};

/** A ship that passes a vessel at rest. */
export type PassageNow = {
  /** Index of the vessel at rest in `Hello.vessels`. */
  vessel: number;
  /** Index of the passing ship in `Hello.traffic`. */
  ship: number;
  /** Clear distance between the outlines of both ships (m). */
  gap_m: number;
  /** The nearest points of both outlines, north and east (m): first the point of the vessel at rest. */
  between_m: [[number, number], [number, number]];
  /** Force of the flow of all passing ships on the vessel, forward and to starboard (N). */
  force_n: [number, number];
  /** Moment of this flow on the vessel about midship, positive bow to starboard (N·m). */
  yaw_nm: number;
};

export type WindNow = { speed_mps: number; from_rad: number };

export type CurrentNow = { speed_mps: number; to_rad: number };

export type WavesNow = { height_m: number; period_s: number; from_rad: number };

export type Alarm = {
  level: "caution" | "alarm";
  /** Kind and subject of the alarm. At most one alarm with a key is active. */
  key: string;
  text: string;
  /** Time when the caution was raised, or became an alarm (s). */
  since_s: number;
  /** True while the cause of the alarm is present. Otherwise the alarm only waits to be acknowledged. */
  stands: boolean;
  acknowledged: boolean;
};

export type EventNow = { t_s: number; text: string };

/** The verdict on the run: its worst finding, in the words of the terminal and of the report. */
export type VerdictNow = {
  key: string;
  text: string;
  gravity: Gravity;
  /** All findings of the run, the worst finding first. */
  findings: Array<FindingNow>;
};

export type FindingNow = { key: string; gravity: Gravity; text: string };

/**
 * The true motion of a vessel whose instruments are frozen. Only the frames of her own pilot or master contain this: the
 * view out of the window shows it, and the instruments do not.
 */
export type EyesNow = {
  /** Index of the vessel's body in `bodies`. */
  body: number;
  /** True position and motion of the body. */
  now: BodyNow;
  /** True speed of the vessel through the water, ahead and to starboard (m/s), which her wake shows. */
  water_mps: [number, number];
};

/** The state of an exercise as everybody gets it. */
export type ExerciseNow = {
  state: "running" | "reached" | "time_over";
  ended_s: number | null;
  /** Time for which all conditions of the goal have held (s). */
  held_s: number;
  /** The conditions of the goal, in the order of `ExerciseInfo.goal`. */
  conditions: Array<ConditionNow>;
  /**
   * Distance along the berth that the ship has to go ahead to the mark of the berth (m), negative astern; `null` if the
   * exercise has no mark.
   */
  to_go_m: number | null;
};

export type ConditionNow = { met: boolean; now: string };

/** The marks of an exercise: its score, and the state of its limits. Only the frames of instructors contain the marks. */
export type ExerciseMarks = {
  score: number;
  /** True if the exercise is passed; `null` while this is still open. */
  passed: boolean | null;
  /** The limits, in the order of `ExerciseInfo.limits`. */
  limits: Array<LimitNow>;
};

export type LimitNow = {
  /** The worst value of the limited quantity so far, with its unit. */
  worst: string | null;
  exceeded: boolean;
  /** Number of points that the limit has cost so far. */
  points: number;
  /** The event that exceeded the limit, with its time and the excess. */
  why: string | null;
};

/** The past of a session up to the present tick. Each field of the past is a column of values over time. */
export type Past = {
  type: "history";
  /** Index of the vessel to which the speeds and distances of the past belong. */
  vessel: number | null;
  t_s: Array<number>;
  /**
   * Speed of the bow towards the berth, or sideways over ground if there is no berth (m/s); `null` if there is
   * no vessel.
   */
  bow_mps: Array<number | null>;
  stern_mps: Array<number | null>;
  ahead_mps: Array<number>;
  turn_radps: Array<number>;
  /** Distance of the bow from the berth (m). */
  bow_m: Array<number | null>;
  stern_m: Array<number | null>;
  /** Distance from the track of the vessel's passage plan, positive to starboard of the track (m). */
  cross_track_m: Array<number | null>;
  /** Least under-keel clearance, squat included (m); `null` in deep water. */
  under_keel_m: Array<number | null>;
  /** Largest energy of any fender as a share of its rated energy. */
  of_energy: Array<number>;
  of_reaction: Array<number>;
  of_working: Array<number>;
  /** Sum of the sizes of all contact forces (N). */
  contact_n: Array<number>;
  /** Events and alarms of the past. For an alarm, `level` is the level of the alarm. */
  events: Array<Then>;
};

/** An event of the past, or an alarm that began; an alarm has its level. */
export type Then = { t_s: number; text: string; level: Alarm["level"] | null };

export type Reply =
  | { type: "prediction"; tick: number; paths: Array<ShipPath> }
  | {
      type: "trial";
      id: number;
      tick: number;
      horizon_s: number;
      complete: boolean;
      paths: Array<ShipPath>;
      findings: Array<string>;
    }
  | { type: "planned"; events: Array<PlannedNow> }
  | { type: "ack"; id: number; tick: number }
  | { type: "refused"; id: number | null; reason: string }
  | { type: "notice"; text: string };

/** A planned event of the instructor, and what became of it. */
export type PlannedNow = {
  id: number;
  at_s: number;
  event: RecordedAction;
  state: "waits" | "fired" | "cancelled" | "refused";
  /** The reason why the planned event could not be carried out. */
  reason: string | null;
};

/** The predicted path of a vessel. Each point of the path has time (s), north and east (m), and heading (rad). */
export type ShipPath = {
  /** Index of the vessel in `Hello.vessels`. */
  vessel: number;
  path: PathPoint[];
};

/** A command that is not in the table of orders. */
export type RecordedAction =
  | {
      do: "tug";
      tug: string;
      order: TugWord;
      /** Force as a share of the tug's bollard pull. An order to push or pull needs a force. */
      power?: number;
      lead: Lead;
      place: Place;
    }
  | { do: "wind"; speed_mps: number; from_rad: number; over_s?: number }
  | { do: "current"; speed_mps: number; to_rad: number; over_s?: number }
  | { do: "part_line"; line: string }
  | { do: "anchor_fault"; anchor: string; fault: AnchorFault; on: boolean }
  | { do: "tug_out"; tug: string; on: boolean }
  | { do: "plan"; at_s: number; event: RecordedAction }
  | { do: "cancel_planned"; id: number }
  | { do: "visibility"; distance_m: number | null; over_s?: number }
  | { do: "fault"; vessel: string; fault: Fault; on: boolean }
  | { do: "thruster_out"; vessel: string; thruster: string; on: boolean }
  | { do: "place"; vessel: string; at_m: [number, number]; heading_rad: number; ahead_mps?: number }
  | { do: "approach_limit"; speed_mps: number }
  | { do: "acknowledge"; key: string }
  | { do: "note"; text?: string };

/**
 * A command to the session itself: about helms, time, branches or files. The recording keeps only what a
 * command to the session causes.
 */
export type Conduct =
  | { do: "claim"; control: Control }
  | { do: "release"; control: Control }
  | { do: "pause" }
  | { do: "resume" }
  | { do: "single_step" }
  | { do: "pace"; pace: number }
  | { do: "rewind"; tick: number }
  | { do: "branch" }
  | { do: "show_branch"; id: number }
  | { do: "load"; file: string }
  | { do: "stop_opening" }
  | { do: "name"; name: string }
  | { do: "seat"; key: string }
  | { do: "trial"; orders: TrialOrder[]; horizon_s: number }
  | { do: "give"; orders: TrialOrder[] }
  | { do: "history"; vessel?: string }
  | { do: "report" }
  | { do: "save"; name: string }
  | { do: "save_exercise"; name: string; title: string; replace: boolean }
  | { do: "rename"; file: string; name: string }
  | { do: "delete"; file: string }
  | { do: "put_back"; file: string }
  | { do: "create"; of: Creation };

/** An exercise that is to be made from the user's choices, and its name in the gallery. */
export type Creation = {
  /** Name of the exercise's file, without the ending. */
  name: string;
  /** The choices. */
  exercise: NewExercise;
  /** True if the exercise may replace an exercise of the same name. */
  replace: boolean;
};

/** The choices. */
export type NewExercise = {
  /** Title of the scenario. */
  title: string;
  /** The straight berth, which is not used if `berth_of` names another scenario. */
  berth: NewBerth;
  /** File name of the scenario whose berth is taken, for [`NewExercise::text_at`]. */
  berth_of: string | null;
  /** The ship. */
  ship: NewShip;
  /** The tugs. */
  tugs: NewTugs;
  /** The weather. */
  weather: NewWeather;
};

/** A straight quay with a row of equal fenders. The quay's face runs north, with the water to the west. */
export type NewBerth = {
  /** Length of the quay (m). */
  length_m: number;
  /** Depth of the water (m). */
  depth_m: number;
  /** Family of the fenders in the library. */
  fender: string;
  /** Size of the fenders in the library; if `None`, height and reaction are given. */
  size: string | null;
  /** Height of a fender (m), where no size is given. */
  height_m: number | null;
  /** Rated reaction of a fender (N), where no size is given. */
  rated_reaction_n: number | null;
  /** Number of fenders. */
  fenders: number;
  /** Distance between fenders (m). */
  fender_spacing_m: number;
  /** Distance between bollards (m). */
  bollard_spacing_m: number;
};

/** A ship of the library on her way to the berth. */
export type NewShip = {
  /** Name in the library. */
  vessel: string;
  /** The side of the ship that is to lie at the berth. */
  side: BerthingSide;
  /** Distance from the ship's side to the face of the quay at the start (m). */
  off_m: number;
  /** Distance of the ship at the start, astern of the middle of the berth (m). */
  astern_m: number;
  /** Speed ahead of the ship at the start (m/s). */
  speed_mps: number;
};

/** Sides of a ship. */
export type BerthingSide = "port" | "starboard";

/** Equal tugs of the library, each on a line at the ship's side towards the water. */
export type NewTugs = {
  /** Name in the library. */
  vessel: string;
  /** How many. */
  number: number;
};

/** Wind, current and visibility. */
export type NewWeather = {
  /** Speed of the wind (m/s). */
  wind_mps: number;
  /** Direction from which the wind comes (rad). */
  wind_from_rad: number;
  /** Whether the wind has gusts. */
  gusts: boolean;
  /** Speed of the current (m/s). */
  current_mps: number;
  /** Direction to which the current runs (rad). */
  current_to_rad: number;
  /** Visibility (m); `None`: clear. */
  visibility_m: number | null;
};
