/** The toy's motion: three degrees of freedom a ship, springs for fenders and lines. Deterministic; see `world`. */
import type { Action, Alarm, BodyNow, ContactNow, Fault, FenderNow, LineNow, Pair, TugNow, VesselNow } from "../src/protocol";
import { ASD, BERTH, BODIES, DEPTH_M, FENDERS, LINES, SHIP, STEP_S, TUGS, VESSELS } from "./world";

type Actuator = { order: number; now: number };
interface Azimuth { power_order: number; power: number; direction_order_rad: number; direction_rad: number }
type Job =
  | { kind: "follow"; at_m: Pair; heading_rad: number }
  | { kind: "push"; at_m: Pair; force_n: number };

export interface ToyVessel {
  /** [north, east, heading, surge, sway, yaw rate]. */
  state: [number, number, number, number, number, number];
  rudder: { order_rad: number; now_rad: number };
  shaft: Actuator;
  thrusters: Actuator[];
  azimuths: Azimuth[];
  course_rad: number | null;
  speed_mps: number | null;
  job: Job | null;
  faults: Fault[];
}

export interface ToyState {
  tick: number;
  vessels: ToyVessel[];
  tugs: TugNow[];
  /** Slack length; 0 before it is made fast. */
  lines: (LineNow & { length_m: number; rate_mps: number })[];
  fenders: FenderNow[];
  contacts: ContactNow[];
  wind: { speed_mps: number; from_rad: number };
  current: { speed_mps: number; to_rad: number };
}

export const initialState = (): ToyState => ({
  tick: 0,
  vessels: [
    vessel([4, -52, 0.035, 0, 0, 0], 2, 0),
    vessel([-40, -120, Math.PI / 2, 0, 0, 0], 0, 2),
  ],
  tugs: TUGS.map(() => ({ order: "stand_by", order_n: 0, order_direction_rad: 0, force_n: 0, direction_rad: 0, limited: false })),
  lines: LINES.map(() => ({ state: "ashore", tension_n: 0, winch: "hold", length_m: 0, rate_mps: 0 })),
  fenders: FENDERS.map(() => ({
    deflection_m: 0, reaction_n: 0, energy_j: 0, of_energy: 0, of_reaction: 0, peak_of_energy: 0, peak_of_reaction: 0, failed: false,
  })),
  contacts: [],
  wind: { speed_mps: 6, from_rad: (70 * Math.PI) / 180 },
  current: { speed_mps: 0.1, to_rad: Math.PI },
});

function vessel(state: ToyVessel["state"], thrusters: number, azimuths: number): ToyVessel {
  const azimuth = () => ({ power_order: 0, power: 0, direction_order_rad: 0, direction_rad: 0 });
  return {
    state,
    rudder: { order_rad: 0, now_rad: 0 },
    shaft: { order: 0, now: 0 },
    thrusters: Array.from({ length: thrusters }, () => ({ order: 0, now: 0 })),
    azimuths: Array.from({ length: azimuths }, azimuth),
    course_rad: null,
    speed_mps: null,
    job: null,
    faults: [],
  };
}

const clamp = (x: number, low: number, high: number) => Math.min(high, Math.max(low, x));
const wrap = (a: number) => Math.atan2(Math.sin(a), Math.cos(a));
const toward = (now: number, order: number, most: number) => now + clamp(order - now, -most, most);

const at = (v: ToyVessel, [x, y]: Pair): Pair => {
  const [n, e, h] = v.state;
  return [n + x * Math.cos(h) - y * Math.sin(h), e + x * Math.sin(h) + y * Math.cos(h)];
};
const turned = (h: number, [x, y]: Pair): Pair => [x * Math.cos(h) - y * Math.sin(h), x * Math.sin(h) + y * Math.cos(h)];
const back = (h: number, [n, e]: Pair): Pair => [n * Math.cos(h) + e * Math.sin(h), -n * Math.sin(h) + e * Math.cos(h)];

/** One force, at a body-fixed place, in body axes. */
type Load = [force: Pair, at: Pair];

const HULL = [
  { mass_kg: 52e6, surge: 1.05, sway: 1.8, inertia: 52e6 * 62 * 62 * 1.6, drag: [6e4, 1.2e6, 9e9 * 3], linear: [2e4, 1e5, 4e9], area_m2: 5200 },
  { mass_kg: 650e3, surge: 1.1, sway: 1.7, inertia: 650e3 * 80 * 1.4, drag: [1.4e4, 9e4, 2e7], linear: [4e3, 2e4, 4e7], area_m2: 130 },
] as const;

/** Goes on by one step; returns what happened. */
export function step(s: ToyState): string[] {
  const events: string[] = [];
  s.tick += 1;
  s.contacts = [];
  const loads: Load[][] = [[], []];
  s.vessels.forEach((v, i) => {
    keepers(v, s);
    actuators(v);
    loads[i]?.push(...thrust(v, i), ...weather(v, i, s));
  });
  fenders(s, loads[SHIP] ?? []);
  tugs(s, loads[SHIP] ?? []);
  lines(s, loads[SHIP] ?? [], events);
  tugContact(s, loads);
  s.vessels.forEach((v, i) => {
    move(v, loads[i] ?? [], i);
  });
  return events;
}

function keepers(v: ToyVessel, s: ToyState) {
  const [, , heading, surge, , rate] = v.state;
  if (v.course_rad !== null) v.rudder.order_rad = clamp(1.5 * wrap(v.course_rad - heading) - 40 * rate, -0.6, 0.6);
  if (v.speed_mps !== null) v.shaft.order = clamp((v.speed_mps - surge) * 1.2 + v.speed_mps / 8, -1, 1);
  const ship = s.vessels[SHIP];
  if (!v.job || !ship) return;
  const side = Math.sign(v.job.at_m[1]) || -1;
  const pushing = v.job.kind === "push";
  const place = pushing ? at(ship, [v.job.at_m[0], v.job.at_m[1] + side * 15.4]) : at(ship, v.job.at_m);
  const wanted = ship.state[2] + (v.job.kind === "push" ? (-side * Math.PI) / 2 : v.job.heading_rad);
  const off = back(heading, [place[0] - v.state[0], place[1] - v.state[1]]);
  const force: Pair = [clamp(off[0] * 3e4 - surge * 1.6e5, -4e5, 4e5), clamp(off[1] * 2e4 - v.state[4] * 1.6e5, -2e5, 2e5)];
  if (v.job.kind === "push" && Math.hypot(...off) < 2.5) force[0] = Math.max(2e4, v.job.force_n);
  // Her pilot turns her as if by hand of God, and her units work at her middle: a toy's shiphandling.
  v.state[5] = toward(rate, clamp(wrap(wanted - heading) * 0.4, -0.08, 0.08), 0.05 * STEP_S);
  const total = clamp(Math.hypot(...force) / 600e3, 0, 1);
  for (const a of v.azimuths) {
    a.power_order = total;
    a.direction_order_rad = total < 0.02 ? a.direction_order_rad : Math.atan2(force[1], force[0]);
  }
}

function actuators(v: ToyVessel) {
  const dead = v.faults.includes("blackout");
  if (!dead && !v.faults.includes("rudder_stuck")) v.rudder.now_rad = toward(v.rudder.now_rad, v.rudder.order_rad, 0.045 * STEP_S);
  v.shaft.now = toward(v.shaft.now, dead || v.faults.includes("engine_lost") ? 0 : v.shaft.order, 0.05 * STEP_S);
  for (const t of v.thrusters) t.now = toward(t.now, dead || v.faults.includes("thrusters_lost") ? 0 : t.order, 0.12 * STEP_S);
  for (const a of v.azimuths) {
    a.power = toward(a.power, dead || v.faults.includes("thrusters_lost") ? 0 : a.power_order, 0.15 * STEP_S);
    a.direction_rad = wrap(a.direction_rad + clamp(wrap(a.direction_order_rad - a.direction_rad), -1.2 * STEP_S, 1.2 * STEP_S));
  }
}

function thrust(v: ToyVessel, index: number): Load[] {
  const loads: Load[] = [];
  if (index === SHIP) {
    const x = v.shaft.now;
    loads.push([[x * Math.abs(x) * (x > 0 ? 1.6e6 : 1.0e6), x < 0 ? -4e4 * Math.abs(x) : 0], [-110, 0]]);
    const wash = Math.max(0, x) ** 2 * 60 + v.state[3] * Math.abs(v.state[3]) * 1.2;
    loads.push([[-Math.abs(v.rudder.now_rad) * wash * 3e3, -v.rudder.now_rad * wash * 1.4e4], [-112, 0]]);
  }
  v.thrusters.forEach((t, i) => {
    const info = VESSELS[index]?.thrusters[i];
    if (info) loads.push([[0, t.now * info.force_n], [info.along_m, 0]]);
  });
  v.azimuths.forEach((a, i) => {
    const info = VESSELS[index]?.azimuths[i];
    if (info) loads.push([turned(a.direction_rad, [a.power * info.bollard_n, 0]), v.job ? [0, 0] : info.at_m]);
  });
  return loads;
}

function weather(v: ToyVessel, index: number, s: ToyState): Load[] {
  const hull = HULL[index] ?? HULL[0];
  const gust = 1 + 0.08 * Math.sin(s.tick / 47) + 0.05 * Math.sin(s.tick / 17);
  const q = 0.6 * (s.wind.speed_mps * gust) ** 2;
  const to = back(v.state[2], [-Math.cos(s.wind.from_rad), -Math.sin(s.wind.from_rad)]);
  return [[[to[0] * q * hull.area_m2 * 0.18, to[1] * q * hull.area_m2], [index === SHIP ? -6 : 0, 0]]];
}

function fenders(s: ToyState, loads: Load[]) {
  const ship = s.vessels[SHIP];
  if (!ship) return;
  FENDERS.forEach((info, i) => {
    const now = s.fenders[i];
    if (!now) return;
    const here = back(ship.state[2], [info.at_m[0] - ship.state[0], info.at_m[1] - ship.state[1]]);
    const half = halfBeam(here[0]);
    const depth = half === null ? 0 : half - (Math.abs(here[1]) - info.projection_m);
    now.deflection_m = clamp(depth, 0, info.projection_m);
    const share = now.deflection_m / (info.rated_deflection_m ?? 1);
    const curve = share < 0.35 ? share / 0.35 : share < 1 ? 1 : 1 + (share - 1) * 4;
    now.reaction_n = now.failed ? 0.3e6 * share : curve * (info.rated_reaction_n ?? 0);
    now.energy_j = share * share * (info.rated_energy_j ?? 0);
    now.of_energy = now.energy_j / (info.rated_energy_j ?? 1);
    now.of_reaction = now.reaction_n / (info.rated_reaction_n ?? 1);
    now.peak_of_energy = Math.max(now.peak_of_energy, now.of_energy);
    now.peak_of_reaction = Math.max(now.peak_of_reaction, now.of_reaction);
    if (now.of_energy > 1.6) now.failed = true;
    if (now.reaction_n <= 0) return;
    const along = ship.state[3];
    const friction = -0.2 * now.reaction_n * clamp(along / 0.02, -1, 1);
    const side = Math.sign(here[1]);
    const damping = -8e5 * ship.state[4];
    const force: Pair = [friction, -side * now.reaction_n + damping];
    loads.push([force, [here[0], half === null ? here[1] : side * half]]);
    s.contacts.push({ bodies: [SHIP, 2], fender: i, at_m: [info.at_m[0], -info.projection_m + now.deflection_m], force_n: turned(ship.state[2], force), slips: Math.abs(along) > 0.02 });
  });
}

/** Half of the ship's beam at a place along her, `null` beyond her ends. */
function halfBeam(x: number): number | null {
  const side = (BODIES[SHIP]?.outline ?? []).filter(([, y]) => y >= 0).toSorted((a, b) => a[0] - b[0]);
  for (let i = 1; i < side.length; i++) {
    const [a, b] = [side[i - 1], side[i]];
    if (a && b && x >= a[0] && x <= b[0]) return a[1] + ((b[1] - a[1]) * (x - a[0])) / Math.max(1e-9, b[0] - a[0]);
  }
  return null;
}

function tugs(s: ToyState, loads: Load[]) {
  s.tugs.forEach((t, i) => {
    const info = TUGS[i];
    if (!info) return;
    t.force_n = toward(t.force_n, t.order === "stand_by" ? 0 : Math.min(t.order_n, info.bollard_pull_n), 6e4 * STEP_S);
    t.limited = t.order_n > info.bollard_pull_n;
    if (t.order !== "stand_by") t.direction_rad = t.order_direction_rad;
    if (t.force_n > 0) loads.push([turned(t.direction_rad, [t.force_n, 0]), t.order === "pull" ? info.pull_at_m : info.push_at_m]);
  });
}

function lines(s: ToyState, loads: Load[], events: string[]) {
  const ship = s.vessels[SHIP];
  if (!ship) return;
  const settled = s.contacts.length >= 3 && Math.abs(ship.state[4]) < 0.03 && Math.abs(ship.state[3]) < 0.05;
  s.lines.forEach((now, i) => {
    const info = LINES[i];
    if (!info || !("place_m" in info.end)) return;
    const from = at(ship, info.fairlead_m);
    const span: Pair = [info.end.place_m[0] - from[0], info.end.place_m[1] - from[1]];
    const length = Math.hypot(...span);
    if (now.state === "ashore" && settled && s.tick % 40 === i) {
      now.state = "fast";
      now.length_m = length - 0.25;
      events.push(`${info.name} line made fast`);
    }
    if (now.state !== "fast") {
      now.tension_n = 0;
      return;
    }
    if (now.winch === "heave" && now.tension_n < 0.4 * info.working_n) now.length_m -= now.rate_mps * STEP_S;
    if (now.winch === "pay_out") now.length_m += now.rate_mps * STEP_S;
    now.tension_n = Math.max(0, ((length - now.length_m) / now.length_m) * 2.2e7);
    if (now.tension_n > info.breaking_n) {
      now.state = "parted";
      events.push(`${info.name} line parted`);
      return;
    }
    loads.push([back(ship.state[2], [(span[0] / length) * now.tension_n, (span[1] / length) * now.tension_n]), info.fairlead_m]);
  });
}

function tugContact(s: ToyState, loads: Load[][]) {
  const [ship, tug] = s.vessels;
  if (!ship || !tug) return;
  const tip = at(tug, [15, 0]);
  const here = back(ship.state[2], [tip[0] - ship.state[0], tip[1] - ship.state[1]]);
  const half = halfBeam(here[0]);
  if (half === null) return;
  const depth = half + 0.4 - Math.abs(here[1]);
  if (depth <= 0 || depth > 8) return;
  const side = Math.sign(here[1]);
  const closing = side * (ship.state[4] - back(ship.state[2], turned(tug.state[2], [tug.state[3], tug.state[4]]))[1]);
  const force = Math.max(0, depth * 1.6e6 + closing * 8e5);
  const onShip: Pair = [0, -side * force];
  loads[SHIP]?.push([onShip, [here[0], side * half]]);
  loads[ASD]?.push([back(tug.state[2], turned(ship.state[2], [0, side * force])), [15, 0]]);
  s.contacts.push({ bodies: [SHIP, ASD], fender: null, at_m: tip, force_n: turned(ship.state[2], onShip), slips: false });
}

function move(v: ToyVessel, loads: Load[], index: number) {
  const hull = HULL[index] ?? HULL[0];
  let [n, e, h, u, w, r] = v.state;
  let [fx, fy, moment] = [0, 0, 0];
  for (const [force, place] of loads) {
    fx += force[0];
    fy += force[1];
    moment += place[0] * force[1] - place[1] * force[0];
  }
  fx -= u * (hull.linear[0] + hull.drag[0] * Math.abs(u));
  fy -= w * (hull.linear[1] + hull.drag[1] * Math.abs(w));
  moment -= r * (hull.linear[2] + hull.drag[2] * 40 * Math.abs(r));
  u += (fx / (hull.mass_kg * hull.surge) + w * r) * STEP_S;
  w += (fy / (hull.mass_kg * hull.sway) - u * r) * STEP_S;
  r += (moment / hull.inertia) * STEP_S;
  h += r * STEP_S;
  const go = turned(h, [u, w]);
  n += go[0] * STEP_S;
  e += go[1] * STEP_S;
  v.state = [n, e, h, u, w, r];
}

// ------------------------------------------------------------------------------------------------ what is shown

export const bodiesNow = (s: ToyState): BodyNow[] =>
  BODIES.map((body, i) => {
    const v = s.vessels[i];
    if (body.fixed || !v) return [0, 0, 0, 0, 0, 0];
    const [n, e, h, u, w, r] = v.state;
    const go = turned(h, [u, w]);
    return [n, e, wrapPositive(h), go[0], go[1], r];
  });

const wrapPositive = (h: number) => ((h % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);

export const vesselsNow = (s: ToyState): VesselNow[] =>
  s.vessels.map((v, i) => {
    const [, , , u, w, r] = v.state;
    const info = VESSELS[i];
    const half = (info?.length_m ?? 0) / 2;
    const current = back(v.state[2], turned(s.current.to_rad, [s.current.speed_mps, 0]));
    const squat = 0.02 * u * u;
    return {
      rudder: v.rudder,
      shaft: v.shaft,
      thrusters: v.thrusters,
      azimuths: v.azimuths,
      pilot: v.job ? "assist" : v.course_rad !== null ? (v.speed_mps !== null ? "course+speed" : "course") : v.speed_mps !== null ? "speed" : "hands",
      course_rad: v.course_rad,
      speed_order_mps: v.speed_mps,
      ground_mps: [u, w],
      water_mps: [u - current[0], w - current[1]],
      bow_mps: w + r * half,
      stern_mps: w - r * half,
      heel_rad: 0,
      trim_rad: 0,
      squat_m: squat,
      under_keel_m: DEPTH_M - (info?.draught_m ?? 0) - squat,
      aground: false,
      berth: i === SHIP ? berth(v) : null,
      faults: v.faults,
    };
  });

function berth(v: ToyVessel): VesselNow["berth"] {
  const face = -(FENDERS[0]?.projection_m ?? 0);
  const [, , h, , , r] = v.state;
  const end = (x: number) => {
    const corner = at(v, [x, 16.1]);
    const speed = turned(h, [v.state[3], v.state[4] + r * x])[1];
    return { off: face - corner[1], speed };
  };
  const [bow, stern] = [end(62), end(-88)];
  return { bow_m: bow.off, stern_m: stern.off, bow_mps: bow.speed, stern_mps: stern.speed, angle_rad: wrap(h) };
}

export function alarms(s: ToyState): Alarm[] {
  const list: Alarm[] = [];
  const near = vesselsNow(s)[SHIP]?.berth;
  if (near) {
    const fast = Math.max(near.bow_mps, near.stern_mps);
    const off = Math.min(near.bow_m, near.stern_m);
    if (off < 20 && fast > 0.15) list.push({ level: fast > 0.25 ? "alarm" : "caution", key: "approach", text: `Approach ${fast.toFixed(2)} m/s at ${off.toFixed(1)} m` });
  }
  s.fenders.forEach((f, i) => {
    const name = FENDERS[i]?.name ?? "";
    if (f.failed) list.push({ level: "alarm", key: `failed-${name}`, text: `Fender ${name} has failed` });
    else if (Math.max(f.of_energy, f.of_reaction) > 1) list.push({ level: "alarm", key: `fender-${name}`, text: `Fender ${name} over rated` });
  });
  s.lines.forEach((l, i) => {
    const info = LINES[i];
    if (!info) return;
    if (l.state === "parted") list.push({ level: "alarm", key: `line-${info.name}`, text: `Line ${info.name} has parted` });
    else if (l.tension_n > info.working_n) list.push({ level: "caution", key: `line-${info.name}`, text: `Line ${info.name} over its working load` });
  });
  s.vessels.forEach((v, i) => {
    for (const fault of v.faults) list.push({ level: "alarm", key: `${fault}-${i}`, text: `${VESSELS[i]?.title ?? ""}: ${fault.replaceAll("_", " ")}` });
  });
  return list;
}

export function predict(s: ToyState): [number, number, number, number][] {
  const ahead = structuredClone(s);
  const path: [number, number, number, number][] = [];
  for (let i = 0; i <= 1800; i++) {
    const state = ahead.vessels[SHIP]?.state;
    if (i % 100 === 0 && state) path.push([s.tick * STEP_S + i * STEP_S, state[0], state[1], state[2]]);
    step(ahead);
  }
  return path;
}

// ------------------------------------------------------------------------------------------------------- orders

/** Carries out an action; a text says why it cannot be. */
export function obey(s: ToyState, action: Action): string | null {
  for (const value of Object.values(action)) {
    if (typeof value === "number" && !Number.isFinite(value)) return "a number is none";
  }
  if ("vessel" in action) {
    const index = VESSELS.findIndex((v) => v.name === action.vessel);
    const [v, info] = [s.vessels[index], VESSELS[index]];
    if (!v || !info) return `there is no vessel ${action.vessel}`;
    switch (action.do) {
      case "rudder":
        v.course_rad = null;
        v.rudder.order_rad = clamp(action.angle_rad, -(info.rudder_stop_rad ?? 0), info.rudder_stop_rad ?? 0);
        return null;
      case "engine":
        v.speed_mps = null;
        v.shaft.order = clamp(action.share, -1, 1);
        return null;
      case "thruster": {
        const t = v.thrusters[info.thrusters.findIndex((t) => t.name === action.thruster)];
        if (!t) return `${action.vessel} has no thruster ${action.thruster}`;
        t.order = clamp(action.share, -1, 1);
        return null;
      }
      case "azimuth": {
        const a = v.azimuths[info.azimuths.findIndex((a) => a.name === action.unit)];
        if (!a) return `${action.vessel} has no unit ${action.unit}`;
        v.job = null;
        if (action.power !== null) a.power_order = clamp(action.power, 0, 1);
        if (action.direction_rad !== null) a.direction_order_rad = action.direction_rad;
        return null;
      }
      case "course":
        if (!info.rudder_stop_rad) return `${action.vessel} has no rudder`;
        v.course_rad = action.heading_rad;
        return null;
      case "speed":
        v.speed_mps = action.speed_mps;
        return null;
      case "hands":
        v.course_rad = v.speed_mps = v.job = null;
        return null;
      case "push_ship":
        v.job = { kind: "push", at_m: action.at_m, force_n: action.force_n };
        return null;
      case "follow_ship":
        v.job = { kind: "follow", at_m: action.at_m, heading_rad: action.heading_rad };
        return null;
      case "fault":
        v.faults = v.faults.filter((f) => f !== action.fault).concat(action.on ? [action.fault] : []);
        return null;
    }
  }
  switch (action.do) {
    case "tug": {
      const t = s.tugs[TUGS.findIndex((t) => t.name === action.tug)];
      if (!t) return `there is no tug ${action.tug}`;
      t.order = action.order;
      t.order_n = action.order === "stand_by" ? 0 : action.force_n;
      if (action.order !== "stand_by") t.order_direction_rad = action.direction_rad;
      return null;
    }
    case "winch":
    case "let_go": {
      const l = s.lines[LINES.findIndex((l) => l.name === action.line)];
      if (!l) return `there is no line ${action.line}`;
      if (l.state !== "fast") return `line ${action.line} is not fast`;
      if (action.do === "let_go") l.state = "gone";
      else [l.winch, l.rate_mps] = [action.order, action.rate_mps];
      return null;
    }
    case "wind":
      s.wind = { speed_mps: action.speed_mps, from_rad: action.from_rad };
      return null;
    case "current":
      s.current = { speed_mps: action.speed_mps, to_rad: action.to_rad };
      return null;
    default:
      return `the mock does not know ${action.do}`;
  }
}

export const berthLine = BERTH;
