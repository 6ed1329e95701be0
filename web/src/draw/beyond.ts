/** What is off the plan: pointers at its edge, with distances, and an overview with the part that the plan shows. */
import { type Camera, fitted, length, minus, onEarth, toEarth, toScreen } from "../geometry";
import type { Pair } from "../protocol";
import { distance, spoken } from "../units";
import { type Box, Rank } from "./labels";
import { polygon } from "./marks";
import { drawPassagePlan } from "./passage_plan";
import { type Scene, berthOf, drawLand, drawWater, firstLook } from "./scene";

/** From a pointer's tip to the edges of the plan; above is the scale, below are the buttons [px]. */
const EDGE = { sides: 10, above: 42, below: 78, below_two_rows: 124 };
/** On a narrower plan the buttons stand in two rows [px]. */
const ONE_ROW_PX = 790;
const POINTER_PX = 15;
/** Half the height of a pointer's words, and half the breadth of a letter, with room [px]. */
const WORDS_PX = { high: 16, letter: 4.2, room: 8 };
/** The overview, and the least plan that has room for one [px]. */
const OVERVIEW = { width: 168, height: 112, from_width: 560, from_height: 300 };

interface Target {
  name: string;
  /** It is on the plan if one of these places is. */
  places: Pair[];
}

/** What a mariner looks for: own ship, tugs and other ships, the berth, the next waypoint. */
function targets({ hello, frame, bodies, live }: Scene): Target[] {
  const ships = hello.vessels.flatMap(({ name, body }): Target[] => {
    const now = bodies[body];
    const outline = hello.bodies[body]?.outline ?? [];
    return now ? [{ name: spoken(name), places: outline.map((at) => onEarth(now, at)) }] : [];
  });
  const own = hello.vessels[live.ship()];
  const berth = berthOf(hello, bodies, own?.body ?? -1);
  const on = frame.vessels[live.ship()]?.plan;
  const next = on && on.to_waypoint_m >= 0 ? own?.plan?.waypoints[on.leg + 1] : undefined;
  return [
    ...ships,
    ...(berth.length > 0 ? [{ name: "berth", places: berth }] : []),
    ...(next ? [{ name: next.name || "next waypoint", places: [next.at_m] }] : []),
  ];
}

/** Where the way from the middle of a camera's picture to a point leaves the picture, and the way's direction. */
export function leaving(
  { width, height }: Pick<Camera, "width" | "height">,
  [x, y]: Pair,
  above: number,
): { tip: Pair; along: Pair } | null {
  if (x >= 0 && x <= width && y >= 0 && y <= height) return null;
  const [left, right] = [EDGE.sides, width - EDGE.sides];
  const below = width < ONE_ROW_PX ? EDGE.below_two_rows : EDGE.below;
  const [top, bottom] = [above + EDGE.above, height - below];
  const middle: Pair = [(left + right) / 2, (top + bottom) / 2];
  const way = minus([x, y], middle);
  const reach = Math.min(
    Math.abs((right - left) / 2 / (way[0] || 1e-9)),
    Math.abs((bottom - top) / 2 / (way[1] || 1e-9)),
  );
  const far = length(way);
  return {
    tip: [middle[0] + way[0] * reach, middle[1] + way[1] * reach],
    along: [way[0] / far, way[1] / far],
  };
}

interface Pointer {
  name: string;
  tip: Pair;
  along: Pair;
  /** How far it is to the nearest place. */
  off_m: number;
}

/** The pointers to what is off the plan. `from`: the place from which distances are told. */
function pointers(scene: Scene, from: Pair, above: number): Pointer[] {
  return targets(scene).flatMap(({ name, places }): Pointer[] => {
    const ways = places.map((place) => leaving(scene.camera, toScreen(scene.camera, place), above));
    const far = places.map((place) => length(minus(place, from)));
    const off_m = Math.min(...far);
    const way = ways[far.indexOf(off_m)];
    return way && !ways.includes(null) ? [{ name, ...way, off_m }] : [];
  });
}

/** The tip of a pointer beside the overview, if it would be below it. */
function clearOf([left, top, width, height]: Box, [x, y]: Pair, along: Pair): Pair {
  const isBelow = x > left - 8 && y < top + height + 8;
  if (!isBelow) return [x, y];
  return along[0] > Math.abs(along[1]) ? [left + width, top + height + 14] : [left - 14, y];
}

function drawPointer({ to, colours, labels }: Scene, tip: Pair, { name, along, off_m }: Pointer) {
  const base: Pair = [tip[0] - along[0] * POINTER_PX, tip[1] - along[1] * POINTER_PX];
  polygon(to, [
    tip,
    [base[0] - along[1] * 8, base[1] + along[0] * 8],
    [base[0] + along[1] * 8, base[1] - along[0] * 8],
  ]);
  to.fillStyle = colours.text;
  to.fill();
  const text = off_m < 1 ? name : `${name} ${distance(off_m)}`;
  // Inwards of the pointer: beside one that points sideways, else above or below.
  const isSideways = Math.abs(along[1]) < 0.35;
  const aside = POINTER_PX + WORDS_PX.room + text.length * WORDS_PX.letter;
  labels.push({
    key: `beyond ${name}`,
    text,
    rank: Rank.Distance,
    at: tip,
    off: isSideways
      ? [-Math.sign(along[0]) * aside, 0]
      : [0, -Math.sign(along[1]) * (POINTER_PX + WORDS_PX.high)],
    colour: colours.text,
    size: 13,
    bold: true,
  });
}

/** Draws the overview in the upper right corner. Returns its box. */
function drawOverview(scene: Scene, above: number): Box {
  const { to, camera, colours, hello, bodies, live } = scene;
  const { width, height } = OVERVIEW;
  const [left, top] = [camera.width - width - 8, above + 8];
  const corners = [
    [0, 0],
    [camera.width, 0],
    [camera.width, camera.height],
    [0, camera.height],
  ].map(([x = 0, y = 0]) => toEarth(camera, [x, y]));
  const all = [...firstLook(hello, bodies, live, true), ...corners];
  const small = fitted({ ...camera, width, height }, all, [8, 8, 8]);
  const inset: Scene = { ...scene, camera: small, labels: [] };
  to.save();
  to.translate(left, top);
  to.beginPath();
  to.rect(0, 0, width, height);
  to.clip();
  drawWater(inset);
  drawLand(inset);
  drawPassagePlan(inset);
  for (const { body, is_tug } of hello.vessels) {
    const now = bodies[body];
    const outline = hello.bodies[body]?.outline ?? [];
    if (!now) continue;
    polygon(
      to,
      outline.map((at) => toScreen(small, onEarth(now, at))),
    );
    const [x, y] = toScreen(small, [now[0], now[1]]);
    // A ship that is smaller than a dot is a dot.
    to.moveTo(x + 3, y);
    to.arc(x, y, is_tug ? 2 : 3, 0, 2 * Math.PI);
    to.fillStyle = is_tug ? colours.tug : colours.own_edge;
    to.fill();
  }
  polygon(
    to,
    corners.map((corner) => toScreen(small, corner)),
  );
  to.strokeStyle = colours.path;
  to.lineWidth = 2;
  to.stroke();
  to.restore();
  to.strokeStyle = colours.text;
  to.lineWidth = 1;
  to.strokeRect(left, top, width, height);
  return [left, top, width, height];
}

/** Draws overview and pointers where something is off the plan. Returns the boxes that labels keep clear of. */
export function drawBeyond(scene: Scene, from: Pair, above: number): Box[] {
  const { width, height } = scene.camera;
  const all = pointers(scene, from, above);
  if (all.length === 0) return [];
  const hasRoom = width >= OVERVIEW.from_width && height >= OVERVIEW.from_height + above;
  const box = hasRoom ? drawOverview(scene, above) : null;
  for (const each of all)
    drawPointer(scene, box ? clearOf(box, each.tip, each.along) : each.tip, each);
  return box ? [box] : [];
}
