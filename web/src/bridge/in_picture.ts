/**
 * Marks in the picture, on request: distances and speeds at the berth, the predicted path on the water, arrows of forces, and
 * labels. Numbers are those of the frames; here they only get a place and a form.
 */
import { type Triple, plus, scaled } from "./axes";
import { PIECES } from "./catenary";
import type { Colour } from "./solids";
import type { BerthEnd, Frame, Hello, Pair, PathPoint, ShipPath } from "../protocol";
import { onEarth } from "../geometry";
import { farFromBerth } from "../ways";
import {
  distance,
  fixed,
  force,
  heading,
  knots,
  rateOfTurn,
  spoken,
  toKnots,
  tonnes,
} from "../units";

/** A line of the picture through `PIECES` + 1 places. */
export interface Stroke {
  points: Triple[];
  colour: Colour;
  radius_m: number;
}

/** A word at a place of the picture. */
export interface Label {
  at: Triple;
  text: string;
  level: "plain" | "caution" | "alarm";
}

/** Colours of loads over their limit: little, some, much, over. */
export const LOADS: Colour[] = [0x7fd0ff, 0x62e08a, 0xffc83a, 0xff4a3a];
export function colourOf(share: number): Colour {
  const step = share >= 1 ? 3 : share >= 0.8 ? 2 : share >= 0.3 ? 1 : 0;
  return LOADS[step] ?? 0xffffff;
}
const levelOf = (share: number): Label["level"] =>
  share >= 1 ? "alarm" : share >= 0.8 ? "caution" : "plain";

const PATH: Colour = 0xffb347;
/** Times between two outlines of the ship along the predicted path [s]. */
const GHOSTS_S = 60;
/** A predicted way that is shorter is not drawn [m]. */
const STILL_M = 5;
/** Strokes of a predicted path at most: the path and outlines on it. */
export const MOST_GHOSTS = 24;
const MEASURED: Colour = 0xf4f1ff;
/** Heights of the outline of a measured ship above the water: at the waterline, and about at her deck [m]. */
const MEASURED_UP_M: Pair = [0.4, 6];
/** Strokes of a measured ship: two outlines, and posts between them. */
export const MEASURED_STROKES = 6;
/** Length of an arrow for a force of a meganewton, and its limits [m]. */
const PER_MN_M = 14;
const ARROW_LIMITS_M: Pair = [2, 22];

/** A way through any places, as `PIECES` + 1 places at equal shares of its corners' numbers. */
export function resampled(points: Triple[]): Triple[] {
  const last = points.length - 1;
  const first = points[0];
  if (!first) return [];
  return Array.from({ length: PIECES + 1 }, (_, i) => {
    const at = (last * i) / PIECES;
    const [a, b] = [points[Math.floor(at)] ?? first, points[Math.ceil(at)] ?? first];
    return plus(scaled(a, 1 - (at % 1)), scaled(b, at % 1));
  });
}

/**
 * An arrow of a force in the axes of the picture, level [N]. Its point is at a place, or its tail if the force `pulls` there.
 */
export function arrow(place: Triple, [x, z]: Pair, colour: Colour, pulls = false): Stroke[] {
  const size_n = Math.hypot(x, z);
  if (size_n <= 0) return [];
  const long = Math.min(ARROW_LIMITS_M[1], Math.max(ARROW_LIMITS_M[0], (size_n / 1e6) * PER_MN_M));
  const way: Triple = [x / size_n, 0, z / size_n];
  const side: Triple = [-way[2], 0, way[0]];
  const tip = pulls ? plus(place, scaled(way, long)) : place;
  const from = plus(tip, scaled(way, -long));
  const head = Math.min(1.8, 0.35 * long);
  const barb = (turn: number) =>
    plus(tip, plus(scaled(way, -head), scaled(side, 0.5 * turn * head)));
  return [
    { points: resampled([from, tip]), colour, radius_m: 0.16 },
    { points: resampled([barb(1), tip, barb(-1)]), colour, radius_m: 0.16 },
  ];
}

/** The predicted path of a ship on the water, with her outline each minute. `place`: a place on the earth, a hand above it. */
export function pathStrokes(
  { path }: ShipPath,
  outline: Pair[],
  place: (at: Pair) => Triple,
): Stroke[] {
  const [begin, end] = [path[0], path.at(-1)];
  if (!begin || !end || path.length < 2) return [];
  // A ship that lies still has no way to show.
  if (Math.hypot(end[1] - begin[1], end[2] - begin[2]) < STILL_M) return [];
  const strokes: Stroke[] = [
    {
      points: resampled(path.map(([, north, east]) => place([north, east]))),
      colour: PATH,
      radius_m: 0.22,
    },
  ];
  const start_s = path[0]?.[0] ?? 0;
  const end_s = path.at(-1)?.[0] ?? 0;
  // A long path has fewer outlines.
  const every_s =
    GHOSTS_S * Math.max(1, Math.ceil((end_s - start_s) / GHOSTS_S / (MOST_GHOSTS - 2)));
  for (let t_s = start_s + every_s; t_s <= end_s + 1; t_s += every_s) {
    const point = path.reduce((best, next) =>
      Math.abs(next[0] - t_s) < Math.abs(best[0] - t_s) ? next : best,
    );
    const ring = outlineAt(outline, point).map(place);
    const [first] = ring;
    if (first) strokes.push({ points: resampled([...ring, first]), colour: PATH, radius_m: 0.1 });
  }
  return strokes;
}

/** The corners of an outline on the earth. */
function outlineAt(outline: Pair[], [, north, east, heading_rad]: PathPoint): Pair[] {
  const body: [number, number, number, number, number, number] = [
    north,
    east,
    heading_rad,
    0,
    0,
    0,
  ];
  return outline.map((corner) => onEarth(body, corner));
}

/** A measured ship as a cage: she takes part in nothing, so what is behind her stays in sight. `place`: of the earth, and a height. */
export function measuredStrokes(
  outline: Pair[],
  now: PathPoint,
  place: (at: Pair, up_m: number) => Triple,
): Stroke[] {
  const corners = outlineAt(outline, now);
  const [first] = corners;
  if (!first) return [];
  const rings = MEASURED_UP_M.map((up_m) => [...corners, first].map((at) => place(at, up_m)));
  const count = MEASURED_STROKES - rings.length;
  const posts = Array.from({ length: count }, (_, i) => {
    const at = corners[Math.floor((corners.length * i) / count)] ?? first;
    return MEASURED_UP_M.map((up_m) => place(at, up_m));
  });
  return [...rings, ...posts].map((points) => ({
    points: resampled(points),
    colour: MEASURED,
    radius_m: 0.14,
  }));
}

/** Speeds over ground in words; what is shown as 0.0 is left out. */
function speeds(ahead_mps: number, starboard_mps: number): string {
  const words = (mps: number, plus: string, minus: string) =>
    toKnots(Math.abs(mps)) < 0.05 ? [] : [`${knots(Math.abs(mps))} ${mps < 0 ? minus : plus}`];
  const all = [
    ...words(ahead_mps, "ahead", "astern"),
    ...words(starboard_mps, "to starboard", "to port"),
  ];
  return all.length > 0 ? all.join(", ") : "at rest";
}

/** Wind, and the water under the keel. */
function around({ wind }: Frame, under_keel_m: number | null): string {
  const water = under_keel_m === null ? "" : `; ${fixed(under_keel_m, 1)} m under the keel`;
  return `Wind ${fixed(toKnots(wind.speed_mps), 0)} kn from ${heading(wind.from_rad, 0)}${water}`;
}

/** A smaller deflection is not told: figures have steps of 0.1 m [m]. */
const SEEN_M = 0.05;

/** Where an end of the ship is, from the line of the undeflected fenders. */
function off(end: BerthEnd, m: number): string {
  if (m > -SEEN_M) return `${distance(Math.max(0, m))} off`;
  return `${fixed(-m, 1)} m ${end === "at_fenders" ? "pressed in" : "behind the fender line"}`;
}

/** The lines of figures over the picture. */
export function figures(
  frame: Frame,
  hello: Hello,
  vessel: number,
  /** The ship that is berthed: that of a tug. */
  ship = vessel,
  /** Where the page shows the motion of this vessel beside the picture: only the distances at the berth. */
  berthOnly = false,
): string[] {
  const now = frame.vessels[vessel];
  const body = frame.bodies[hello.vessels[vessel]?.body ?? -1];
  if (!now || !body) return [];
  const turns = rateOfTurn(body[5]);
  const rate =
    Math.abs(turns) < 0.05
      ? "steady"
      : `${turns < 0 ? "port" : "starboard"} ${fixed(Math.abs(turns), 1)}°/min`;
  const [ahead, starboard] = now.ground_mps;
  const first = `${heading(body[2])}, ${rate}; ${speeds(ahead, starboard)}`;
  const berth = frame.vessels[ship]?.berth ?? null;
  const last = around(frame, now.under_keel_m);
  if (!berth) return berthOnly ? [] : [first, last];
  const whose = ship === vessel ? "" : `${spoken(hello.vessels[ship]?.name ?? "")}: `;
  const far = farFromBerth(frame, hello, ship);
  if (far) {
    // As on the docking board: far from the berth the distance to the line of the fenders says nothing.
    const [{ bearing_rad, off_m, closing_mps: mps }] = far;
    const closing =
      Math.abs(mps) < 0.05
        ? "still"
        : `${fixed(Math.abs(mps), 1)} m/s ${mps < 0 ? "opening" : "closing"}`;
    const way = `${whose}${whose ? "berth" : "Berth"} bears ${heading(bearing_rad, 0)}, ${distance(off_m)} off, ${closing}`;
    return berthOnly ? [way] : [first, way, last];
  }
  const end = (name: string, at: BerthEnd, m: number, mps: number) =>
    `${name} ${off(at, m)}, ${Math.abs(mps) < 0.005 ? "still" : `${fixed(Math.abs(mps), 2)} m/s ${mps < 0 ? "opening" : "closing"}`}`;
  const ends = `${whose}${end(whose ? "bow" : "Bow", berth.bow, berth.bow_m, berth.bow_mps)}; ${end("stern", berth.stern, berth.stern_m, berth.stern_mps)}`;
  return berthOnly ? [ends] : [first, ends, last];
}

/** Labels of forces: what a fender or a line bears, and what a tug does. */
export const fenderLabel = (at: Triple, newtons: number, share: number): Label => ({
  at,
  text: force(newtons),
  level: levelOf(share),
});
/** Tensions are in tonnes, as on the tab of the lines. */
export const lineLabel = (at: Triple, newtons: number, share: number): Label => ({
  at,
  text: tonnes(newtons),
  level: levelOf(share),
});
export const tugLabel = (at: Triple, name: string, newtons: number): Label => ({
  at,
  text: `${spoken(name)} ${tonnes(newtons)}`,
  level: "plain",
});
