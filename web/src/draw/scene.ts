/** Draws the scene of the plan: grid, hulls, fenders, lines, tugs, forces, the predicted path. */
import {
  type Camera,
  add,
  clamp,
  dot,
  length,
  minus,
  onEarth,
  times,
  toScreen,
  turned,
} from "../geometry";
import { type Live, isOfTug } from "../live";
import { type Palette, loadColour } from "../palette";
import type { BodyNow, Frame, Hello, LineInfo, LineNow, Pair, PathPoint } from "../protocol";
import { fenderLoad, fixed, spoken, tonnes } from "../units";
import { TOW_M, WORKS_N, tugOutline, tugPlace } from "../vector_tug";
import type { Limits } from "./depths";
import { type Label, Rank } from "./labels";
import { arrow, polygon, stroke } from "./marks";

export interface Scene {
  to: CanvasRenderingContext2D;
  camera: Camera;
  colours: Palette;
  hello: Hello;
  frame: Frame;
  bodies: (BodyNow | null)[];
  live: Live;
  /** Time of the run at this drawing. */
  t_s: number;
  /** Depths at which the shades of the chart change. */
  limits: Limits;
  /** Drawn last, so that none lies over another. */
  labels: Label[];
}

/** Length of a force arrow per meganewton [px]. */
export const PX_PER_MN = 70;
/** A ship of at least this length has the speeds of her ends beside her [px]. */
const ENDS_FROM_PX = 30;
/** Length of a lateral-speed arrow per metre a second [px]. */
const PX_PER_MPS = 220;

export function drawWater({ to, camera, colours, hello }: Scene): void {
  // Where a chart of depths has none, the depth is not known.
  const isCharted = hello.chart.some(({ kind }) => kind === "depth_area");
  to.fillStyle = isCharted ? colours.unknown : colours.water;
  to.fillRect(0, 0, camera.width, camera.height);
}

export function drawGrid({ to, camera, colours }: Scene): void {
  const pitch =
    [10, 20, 50, 100, 200, 500, 1000, 2000, 5000].find((m) => m * camera.pixels_per_m >= 70) ??
    10_000;
  const reach = Math.hypot(camera.width, camera.height) / 2 / camera.pixels_per_m;
  to.lineWidth = 1;
  for (const axis of [0, 1] as const) {
    const from = Math.ceil((camera.centre[axis] - reach) / pitch) * pitch;
    for (let at = from; at <= camera.centre[axis] + reach; at += pitch) {
      const other = camera.centre[axis === 0 ? 1 : 0];
      const ends: Pair[] = [other - reach, other + reach].map((o) =>
        axis === 0 ? [at, o] : [o, at],
      );
      if (ends[0] && ends[1])
        stroke(to, toScreen(camera, ends[0]), toScreen(camera, ends[1]), colours.grid, 1);
    }
  }
}

const outlineOnScreen = ({ camera, hello, bodies }: Scene, body: number): Pair[] => {
  const [info, now] = [hello.bodies[body], bodies[body]];
  return info && now ? info.outline.map((at) => toScreen(camera, onEarth(now, at))) : [];
};

export function drawLand(scene: Scene): void {
  const { to, colours, hello } = scene;
  hello.bodies.forEach((body, i) => {
    if (!body.fixed) return;
    polygon(to, outlineOnScreen(scene, i));
    to.fillStyle = colours.land;
    to.fill();
    to.strokeStyle = colours.land_edge;
    to.lineWidth = 2;
    to.stroke();
  });
}

/** The part of the predicted path that is still ahead, and the hull of that ship. */
function way({
  hello,
  live,
}: Scene): { path: PathPoint[]; outline: Pair[]; from_s: number } | null {
  const { prediction, frame } = live;
  const own = prediction?.paths.find(({ vessel }) => vessel === live.ship());
  const outline = hello.bodies[hello.vessels[own?.vessel ?? -1]?.body ?? -1]?.outline;
  if (!own || !frame || !outline) return null;
  return { path: own.path.filter(([t]) => t >= frame.t_s), outline, from_s: frame.t_s };
}

/** The first point of each minute ahead. */
function minutes(path: PathPoint[], from_s: number): { minute: number; point: PathPoint }[] {
  const found: { minute: number; point: PathPoint }[] = [];
  for (const point of path) {
    const minute = Math.floor((point[0] - from_s) / 60 + 1e-6);
    if (minute > (found.at(-1)?.minute ?? 0)) found.push({ minute, point });
  }
  return found;
}

/** The predicted path without further orders: the swept area, the track of the centre, the hull at every minute. */
export function drawPrediction(scene: Scene): void {
  const { to, camera, colours } = scene;
  const ahead = way(scene);
  if (!ahead) return;
  const { path, outline, from_s } = ahead;
  const trace = ([, n, e, heading]: PathPoint) =>
    outline.forEach((at, i) => {
      const place = toScreen(camera, add([n, e], turned(heading, at)));
      if (i === 0) to.moveTo(...place);
      else to.lineTo(...place);
    });
  to.save();
  // All hulls are one path of one winding, so that their union is filled evenly.
  to.beginPath();
  for (const point of path) {
    trace(point);
    to.closePath();
  }
  to.fillStyle = colours.path;
  to.globalAlpha = 0.14;
  to.fill("nonzero");
  to.strokeStyle = colours.path;
  to.globalAlpha = 0.8;
  to.lineWidth = 1.5;
  to.setLineDash([6, 4]);
  for (const { point } of minutes(path, from_s)) {
    to.beginPath();
    trace(point);
    to.closePath();
    to.stroke();
  }
  to.restore();
}

/** The track of the centre with its minutes. It is drawn over the hulls, so that it can be read under the ship. */
export function drawMinutes(scene: Scene): void {
  const { to, camera, colours, labels } = scene;
  const ahead = way(scene);
  if (!ahead) return;
  to.strokeStyle = colours.path;
  to.lineWidth = 2;
  to.beginPath();
  ahead.path.forEach(([, n, e], i) =>
    i === 0 ? to.moveTo(...toScreen(camera, [n, e])) : to.lineTo(...toScreen(camera, [n, e])),
  );
  to.stroke();
  let last: Pair | null = null;
  for (const { minute, point } of minutes(ahead.path, ahead.from_s)) {
    const at = toScreen(camera, [point[1], point[2]]);
    to.beginPath();
    to.arc(at[0], at[1], 3, 0, 2 * Math.PI);
    to.fillStyle = colours.path;
    to.fill();
    // A ship that hardly moves has her minutes at one point.
    if (last && length(minus(at, last)) < 22) continue;
    last = at;
    labels.push({
      key: `minute ${minute}`,
      text: `${minute} min`,
      rank: Rank.Minute,
      at,
      off: [28, 0],
      colour: colours.path,
      size: 12,
    });
  }
}

/** The tracks of the other ships whose paths are predicted, each with her hull at the end. */
export function drawOtherPaths(scene: Scene): void {
  const { to, camera, colours, hello, live, frame } = scene;
  to.save();
  to.strokeStyle = colours.path;
  to.lineWidth = 1.5;
  for (const { vessel, path } of live.prediction?.paths ?? []) {
    const ahead = path.filter(([t_s]) => t_s >= frame.t_s);
    const [outline, last] = [
      hello.bodies[hello.vessels[vessel]?.body ?? -1]?.outline,
      ahead.at(-1),
    ];
    if (vessel === live.ship() || !outline || !last) continue;
    to.globalAlpha = 0.7;
    to.setLineDash([3, 4]);
    to.beginPath();
    ahead.forEach(([, north, east], i) => {
      const at = toScreen(camera, [north, east]);
      if (i === 0) to.moveTo(...at);
      else to.lineTo(...at);
    });
    to.stroke();
    polygon(
      to,
      outline.map((at) => toScreen(camera, add([last[1], last[2]], turned(last[3], at)))),
    );
    to.stroke();
  }
  to.restore();
}

export function drawHulls(scene: Scene): void {
  const { to, colours, hello, bodies, camera, labels } = scene;
  const ownBody = scene.live.body();
  hello.bodies.forEach((body, i) => {
    const now = bodies[i];
    if (body.fixed || !now) return;
    const vessel = hello.vessels.find((v) => v.body === i);
    const tug = vessel?.is_tug ?? false;
    polygon(to, outlineOnScreen(scene, i));
    to.fillStyle = tug ? colours.tug : colours.own;
    to.globalAlpha = 0.85;
    to.fill();
    to.globalAlpha = 1;
    to.strokeStyle = tug ? colours.tug_edge : colours.own_edge;
    to.lineWidth = i === ownBody ? 2.5 : 1.5;
    to.stroke();
    if (!vessel) return;
    // Her centre line, extended beyond the bow.
    const half = vessel.length_m / 2;
    stroke(
      to,
      toScreen(camera, onEarth(now, [half, 0])),
      toScreen(camera, onEarth(now, [half * (tug ? 1.3 : 1.5), 0])),
      tug ? colours.tug_edge : colours.own_edge,
      1.5,
    );
    if (tug)
      labels.push({
        key: `vessel ${vessel.name}`,
        text: spoken(vessel.name),
        rank: Rank.Tug,
        at: toScreen(camera, onEarth(now, [-half, 0])),
        off: minus(
          toScreen(camera, onEarth(now, [-half - 6, 0])),
          toScreen(camera, onEarth(now, [-half, 0])),
        ),
        colour: colours.text,
        size: 13,
      });
  });
}

export function drawFenders(scene: Scene): void {
  const { to, camera, colours, hello, frame, bodies, labels } = scene;
  hello.fenders.forEach((info, i) => {
    const [now, body] = [frame.fenders[i], bodies[info.body]];
    if (!now || !body) return;
    const out = Math.max(0.15, info.projection_m - now.deflection_m);
    const half = Math.max(info.width_m / 2, 3 / camera.pixels_per_m);
    const deep = Math.max(out, 3 / camera.pixels_per_m);
    const corner = (across: number, ahead: number) =>
      toScreen(camera, onEarth(body, add(info.at_m, turned(info.facing_rad, [ahead, across]))));
    const load = Math.max(now.of_energy, now.of_reaction);
    polygon(to, [
      corner(-half, 0),
      corner(half, 0),
      corner(half * 1.1, deep),
      corner(-half * 1.1, deep),
    ]);
    to.fillStyle = now.failed
      ? colours.alarm
      : now.reaction_n > 0
        ? loadColour(load, colours)
        : colours.land_edge;
    to.fill();
    to.strokeStyle = colours.text;
    to.lineWidth = 1;
    to.stroke();
    if (now.failed) {
      stroke(to, corner(-half, 0), corner(half, deep), colours.text, 2);
      stroke(to, corner(half, 0), corner(-half, deep), colours.text, 2);
    }
    if (now.reaction_n <= 0 || camera.pixels_per_m < 0.6) return;
    // Behind it, on its mounting.
    const written = {
      at: corner(0, 0),
      off: minus(corner(0, -16 / camera.pixels_per_m), corner(0, 0)),
    };
    if (info.rated_reaction_n === null && info.rated_energy_j === null) {
      labels.push({
        key: `fender ${info.name}`,
        text: fenderLoad(now.reaction_n, isOfTug(info, hello)),
        rank: Rank.Fender,
        ...written,
        colour: colours.text,
        size: 12,
      });
      return;
    }
    const text = camera.pixels_per_m > 1.8 ? `${fixed(load * 100, 0)} %` : fixed(load * 100, 0);
    labels.push({
      key: `fender ${info.name}`,
      text,
      rank: Rank.Fender,
      ...written,
      colour: loadColour(load, colours),
      size: 13,
      bold: true,
    });
    if (camera.pixels_per_m > 3.2) {
      labels.push({
        key: `reaction ${info.name}`,
        text: fenderLoad(now.reaction_n, isOfTug(info, hello)),
        rank: Rank.Detail,
        at: written.at,
        off: minus(corner(0, -37 / camera.pixels_per_m), written.at),
        colour: colours.text,
        size: 12,
      });
    }
  });
}

/** Contact forces: a disc for a contact that sticks, a ring with a cross stroke for one that slips. */
export function drawContacts({ to, camera, colours, frame }: Scene): void {
  for (const contact of frame.contacts) {
    const size = length(contact.force_n);
    if (size < 1e3) continue;
    const from = toScreen(camera, contact.at_m);
    const long = clamp((size / 1e6) * PX_PER_MN, 10, 140);
    arrow(
      to,
      from,
      toScreen(
        camera,
        add(contact.at_m, times(contact.force_n, long / size / camera.pixels_per_m)),
      ),
      colours.force,
      3,
    );
    to.beginPath();
    to.arc(from[0], from[1], 4.5, 0, 2 * Math.PI);
    to.strokeStyle = colours.force;
    to.lineWidth = 2;
    to.fillStyle = contact.slips ? colours.panel : colours.force;
    to.fill();
    to.stroke();
    if (contact.slips)
      stroke(to, [from[0] - 7, from[1] + 3], [from[0] + 7, from[1] - 3], colours.force, 1.5);
  }
}

/** Where a line's far end is or will be. */
function farEnd(
  hello: Hello,
  info: LineInfo,
  now: LineNow,
  bodies: (BodyNow | null | undefined)[],
): Pair | undefined {
  const end = now.bollard === null ? info.end : hello.bollards[now.bollard];
  if (!end) return undefined;
  if ("place_m" in end) return end.place_m;
  const body = bodies[end.body];
  return body ? onEarth(body, end.at_m) : undefined;
}

/** Bollards to which lines can be sent, with their names where there is room. */
export function drawBollards({ to, camera, colours, hello, bodies, labels }: Scene): void {
  for (const { name, body, at_m } of hello.bollards) {
    const on = bodies[body];
    if (!on) continue;
    const at = toScreen(camera, onEarth(on, at_m));
    to.beginPath();
    to.arc(...at, 3.5, 0, 2 * Math.PI);
    to.fillStyle = colours.panel;
    to.fill();
    to.strokeStyle = colours.text;
    to.lineWidth = 1.5;
    to.stroke();
    if (camera.pixels_per_m <= 1.2) continue;
    labels.push({
      key: `bollard ${name}`,
      text: spoken(name),
      rank: Rank.Bollard,
      at,
      colour: colours.text,
      size: 11,
    });
  }
}

export function drawLines(scene: Scene): void {
  const { to, camera, colours, hello, frame, bodies, labels } = scene;
  hello.lines.forEach((info, i) => {
    const [now, ship] = [frame.lines[i], bodies[info.ship]];
    if (!now || !ship || now.state === "aboard") return;
    const end = farEnd(hello, info, now, bodies);
    if (!end) return;
    const [from, till] = [toScreen(camera, onEarth(ship, info.fairlead_m)), toScreen(camera, end)];
    to.beginPath();
    to.arc(till[0], till[1], 3.5, 0, 2 * Math.PI);
    to.fillStyle = colours.text;
    to.fill();
    if (now.state === "ashore") return;
    if (now.state === "sent") {
      stroke(to, from, till, colours.line, 1.2, [3, 6]);
      return;
    }
    const share = now.tension_n / Math.max(1, info.working_n);
    const colour =
      now.state === "parted"
        ? colours.alarm
        : share > 0.1
          ? loadColour(share * 0.95, colours)
          : colours.line;
    stroke(to, from, till, colour, share > 0.1 ? 3 : 1.8, now.state === "parted" ? [4, 8] : []);
    const middle: Label = {
      key: `line ${info.name}`,
      text: tonnes(now.tension_n),
      rank: Rank.Line,
      at: [(from[0] + till[0]) / 2, (from[1] + till[1]) / 2],
      off: [0, 0],
      colour,
      size: 13,
    };
    if (now.state === "parted")
      labels.push({ ...middle, text: "PARTED", rank: Rank.Parted, size: 12, bold: true });
    else if (share > 0.1 && camera.pixels_per_m > 1.2) labels.push(middle);
  });
}

/** Vector tugs, at the place of their force. Tugs that are vessels are drawn with the other hulls. */
export function drawVectorTugs(scene: Scene): void {
  const { to, camera, colours, hello, frame, bodies, labels } = scene;
  hello.tugs.forEach((info, i) => {
    const now = frame.tugs[i];
    const ship = bodies[hello.vessels[info.vessel]?.body ?? -1];
    if (!now || !ship) return;
    const pulls = now.order === "pull";
    const { place, heading_rad, at, toward_rad, works } = tugPlace(info, now, ship);
    const half = info.length_m / 2;
    polygon(
      to,
      tugOutline(info).map((corner) => toScreen(camera, add(place, turned(heading_rad, corner)))),
    );
    to.fillStyle = colours.tug;
    to.globalAlpha = works ? 0.9 : 0.45;
    to.fill();
    to.globalAlpha = 1;
    to.strokeStyle = colours.tug_edge;
    to.lineWidth = 1.5;
    to.stroke();
    if (pulls)
      stroke(
        to,
        toScreen(camera, onEarth(ship, at)),
        toScreen(camera, onEarth(ship, add(at, turned(toward_rad, [TOW_M, 0])))),
        colours.line,
        2,
      );
    const working = onEarth(ship, at);
    if (now.force_n > WORKS_N) {
      const long = clamp((now.force_n / 1e6) * PX_PER_MN, 14, 120) / camera.pixels_per_m;
      arrow(
        to,
        toScreen(camera, working),
        toScreen(camera, add(working, turned(ship[2] + toward_rad, [long, 0]))),
        colours.force,
        4,
      );
    }
    const text =
      now.force_n > WORKS_N
        ? `${spoken(info.name)} ${tonnes(now.force_n)}${now.limited ? " max" : ""}`
        : spoken(info.name);
    const stern = (beyond_px: number) =>
      toScreen(
        camera,
        add(place, turned(heading_rad, [-half - beyond_px / camera.pixels_per_m, 0])),
      );
    labels.push({
      key: `tug ${info.name}`,
      text,
      rank: Rank.Tug,
      at: stern(0),
      off: minus(stern(9), stern(0)),
      colour: colours.text,
      size: 13,
    });
  });
}

/** Lateral speed at bow and stern as arrows with values, and the distances to the berth. */
export function drawBowAndStern(scene: Scene): void {
  const { to, camera, colours, hello, frame, bodies, live, labels } = scene;
  const index = live.ship();
  const [info, now] = [hello.vessels[index], frame.vessels[index]];
  const body = bodies[info?.body ?? -1];
  const outline = hello.bodies[info?.body ?? -1]?.outline;
  if (!info || !now || !body || !outline) return;
  // Beside a small ship on the screen the values would hide the chart; board and conning display have them.
  if (info.length_m * camera.pixels_per_m < ENDS_FROM_PX) return;
  const half = info.length_m / 2;
  const quay = hello.berth && bodies[hello.berth.body];
  const towardShore = hello.berth && quay ? turned(quay[2], times(hello.berth.facing, -1)) : null;
  for (const [end, speed, berthDistance] of [
    [1, now.bow_mps, now.berth?.bow_m],
    [-1, now.stern_mps, now.berth?.stern_m],
  ] as const) {
    const place = onEarth(body, [end * half * 0.92, 0]);
    const side = Math.sign(speed) || 1;
    const across = turned(body[2], [0, side]);
    const long = clamp(Math.abs(speed) * PX_PER_MPS, 0, 130);
    const tip = add(place, times(across, long / camera.pixels_per_m));
    if (long > 2) arrow(to, toScreen(camera, place), toScreen(camera, tip), colours.path, 5);
    const name = end === 1 ? "bow" : "stern";
    const textAt = add(place, turned(body[2], [end * (34 / camera.pixels_per_m), 0]));
    labels.push({
      key: `speed ${name}`,
      text: `${fixed(Math.abs(speed), 2)} m/s`,
      rank: Rank.Speed,
      at: toScreen(camera, place),
      off: minus(toScreen(camera, textAt), toScreen(camera, place)),
      colour: colours.path,
      size: 16,
      bold: true,
      clamped: true,
    });
    if (!towardShore || berthDistance === undefined || berthDistance > 400) continue;
    const nearest = outline
      .filter(([along]) => along * end > half * 0.25)
      .map((at) => onEarth(body, at))
      .reduce<Pair | null>(
        (best, at) =>
          best === null || dot(at, towardShore) > dot(best, towardShore) + 1e-6 ? at : best,
        null,
      );
    if (!nearest) continue;
    const shore = add(nearest, times(towardShore, Math.max(0, berthDistance)));
    stroke(to, toScreen(camera, nearest), toScreen(camera, shore), colours.text, 1.5, [5, 4]);
    const inland = add(shore, times(towardShore, 62 / camera.pixels_per_m));
    labels.push({
      key: `distance ${name}`,
      text: `${fixed(berthDistance, 1)} m`,
      rank: Rank.Distance,
      at: toScreen(camera, shore),
      off: minus(toScreen(camera, inland), toScreen(camera, shore)),
      colour: colours.text,
      size: 17,
      bold: true,
      clamped: true,
    });
  }
}

/** The line of the berth, along the faces of its fenders. Distances are to this line. */
export function drawBerth({ to, camera, colours, hello, bodies }: Scene): void {
  const on = hello.berth && bodies[hello.berth.body];
  if (!hello.berth || !on) return;
  stroke(
    to,
    toScreen(camera, onEarth(on, hello.berth.from)),
    toScreen(camera, onEarth(on, hello.berth.to)),
    colours.land_edge,
    4,
  );
}

/** The berth is in the first view if it is within this many lengths of the ship; nearer fenders than the second all count. */
const BERTH_LENGTHS = 25;
const ROW_LENGTHS = 3;
/** Without a berth so many lengths ahead of the ship are in the first view. */
const AHEAD_LENGTHS = 4;

/**
 * Points that the first view includes: the ship, the berth if she is not far from it, and so the water between; her tugs and
 * the ends of her lines. `all`: the berth wherever it is. Without a vessel: all that floats, and the fenders.
 */
export function firstLook(
  hello: Hello,
  bodies: (BodyNow | null)[],
  live: Live,
  all: boolean,
): Pair[] {
  const { frame } = live;
  const info = hello.vessels[live.ship()];
  const now = bodies[info?.body ?? -1];
  const outline = hello.bodies[info?.body ?? -1]?.outline ?? [];
  if (!info || !now) return allAfloat(hello, bodies);
  const places = outline.map((at) => onEarth(now, at));
  const here: Pair = [now[0], now[1]];
  const far = (at: Pair) => length(minus(at, here));
  const berth = berthOf(hello, bodies, info.body);
  const nearest = Math.min(...berth.map(far));
  const isShown = all || nearest <= BERTH_LENGTHS * info.length_m;
  const shown = isShown
    ? berth.filter((at) => far(at) <= nearest + ROW_LENGTHS * info.length_m)
    : [];
  // Without a berth: the water ahead.
  const ahead: Pair[] = shown.length > 0 ? [] : [[AHEAD_LENGTHS * info.length_m, 0]];
  const tugs = hello.vessels
    .filter((v) => v.is_tug)
    .flatMap(({ body }): Pair[] => {
      const tug = bodies[body];
      if (!tug || far([tug[0], tug[1]]) > info.length_m * 0.75) return [];
      return hello.bodies[body]?.outline.map((at) => onEarth(tug, at)) ?? [];
    });
  // Vector tugs are drawn about one tug length off the side.
  const alongside = hello.tugs.map((t) =>
    onEarth(now, add(t.push_at_m, [0, Math.sign(t.push_at_m[1]) * (t.length_m + 14)])),
  );
  const moored = hello.lines.flatMap((l, i): Pair[] =>
    l.end && "place_m" in l.end && frame?.lines[i]?.state === "fast" ? [l.end.place_m] : [],
  );
  // Another ship as berth is included whole.
  const other = hello.berth && !hello.bodies[hello.berth.body]?.fixed ? hello.berth.body : -1;
  const mother = bodies[other];
  const hull = mother ? (hello.bodies[other]?.outline ?? []).map((at) => onEarth(mother, at)) : [];
  // *Fit* has the rest of the passage plan too, the first view the next waypoint where there is no berth near.
  const on = frame?.vessels[live.ship()]?.plan;
  const isAhead = (i: number) => on && on.to_waypoint_m >= 0 && i > on.leg;
  const planned = (info.plan?.waypoints ?? [])
    .filter((_, i) => isAhead(i) && (all || (shown.length === 0 && i === (on?.leg ?? 0) + 1)))
    .map(({ at_m }) => at_m);
  return [
    ...places,
    ...shown,
    ...planned,
    ...ahead.map((at) => onEarth(now, at)),
    ...tugs,
    ...alongside,
    ...moored,
    ...hull,
  ];
}

/** Places of the berth: the fenders that are no tug's; without fenders the structures; without those the quays of the chart. */
export function berthOf(hello: Hello, bodies: (BodyNow | null)[], own: number): Pair[] {
  const fenders = hello.fenders.flatMap((fender): Pair[] => {
    const on = bodies[fender.body];
    return on && fender.body !== own && !isOfTug(fender, hello) ? [onEarth(on, fender.at_m)] : [];
  });
  if (fenders.length > 0) return fenders;
  const fixed = hello.bodies.flatMap(({ fixed: isFixed, outline }, i): Pair[] => {
    const on = bodies[i];
    return isFixed && on ? outline.map((at) => onEarth(on, at)) : [];
  });
  if (fixed.length > 0) return fixed;
  return hello.chart.flatMap(({ kind, lines }) => (kind === "quay" ? lines.flat() : []));
}

function allAfloat(hello: Hello, bodies: (BodyNow | null)[]): Pair[] {
  const hulls = hello.bodies.flatMap(({ fixed, outline }, i): Pair[] => {
    const now = bodies[i];
    return fixed || !now ? [] : outline.map((at) => onEarth(now, at));
  });
  const fenders = hello.fenders.flatMap(({ body, at_m }): Pair[] => {
    const now = bodies[body];
    return now ? [onEarth(now, at_m)] : [];
  });
  return [...hulls, ...fenders];
}
