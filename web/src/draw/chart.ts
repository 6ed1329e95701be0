/** Draws the chart behind ships and quays: depths, coast, quays, fairways, bridges, dangers, marks, lights, names. */
import { type Camera, toScreen } from "../geometry";
import type { Palette } from "../palette";
import type { ChartInfo, Pair } from "../protocol";
import { fixed } from "../units";
import { MARK_PX, drawMark } from "./buoys";
import { Depths, type Limits, depthColour } from "./depths";
import { Rank } from "./labels";
import { drawLight } from "./lights";
import type { Scene } from "./scene";
import { drawSoundings, written } from "./soundings";

/** From these scales on, names of marks and depths of contours are written [px/m]. */
const NAMES_FROM = 0.25;
const DEPTHS_FROM = 0.08;
/** Most words of the chart in one picture: placing them takes time. */
const MOST_WORDS = 60;
/** Width of the safety contour [px]. */
const CONTOUR_PX = 2.6;

/** Lines and areas in earth axes (east to the right, north down), made once for each chart. */
const paths = new WeakMap<ChartInfo, Path2D>();

function pathOf(feature: ChartInfo): Path2D {
  const known = paths.get(feature);
  if (known) return known;
  const path = new Path2D();
  for (const line of feature.lines) {
    line.forEach(([north, east], i) =>
      i === 0 ? path.moveTo(east, north) : path.lineTo(east, north),
    );
    if (feature.shape === "area") path.closePath();
  }
  paths.set(feature, path);
  return path;
}

/** Sets the canvas so that a path in earth axes lies where the camera sees it. */
function lookDown(to: CanvasRenderingContext2D, camera: Camera): void {
  const { pixels_per_m: scale, up_rad, centre } = camera;
  const [cos, sin] = [scale * Math.cos(up_rad), scale * Math.sin(up_rad)];
  to.translate(camera.width / 2, camera.height / 2);
  to.transform(cos, -sin, -sin, -cos, 0, 0);
  to.translate(-centre[1], -centre[0]);
}

/** The depths of each chart. */
const depths = new WeakMap<readonly ChartInfo[], Depths>();

function depthsOf({ hello, to }: Scene): Depths {
  const known = depths.get(hello.chart);
  if (known) return known;
  const found = new Depths(hello.chart, pathOf, to);
  depths.set(hello.chart, found);
  return found;
}

/** Kinds of lines and areas, in the order in which they are drawn. */
const SHAPES = [
  "unsurveyed_area",
  "depth_contour",
  "coast",
  "building",
  "quay",
  "pontoon",
  "berth",
  "fairway",
  "anchorage",
  "obstruction",
  "wreck",
  "rock",
  "mooring",
  "landmark",
  "leading_line",
  "bridge",
  "overhead_cable",
] as const;

/** Areas that are land, or stand in the water. */
const SOLID: ReadonlySet<string> = new Set([
  "coast",
  "quay",
  "pontoon",
  "building",
  "mooring",
  "landmark",
]);
/** Lines and edges that are dashed. */
const DASHED: ReadonlySet<string> = new Set([
  "leading_line",
  "fairway",
  "anchorage",
  "berth",
  "dredged_area",
  "overhead_cable",
  "obstruction",
  "wreck",
  "rock",
]);

/** Lines and areas, below everything else. */
export function drawChart(scene: Scene): void {
  const { to, camera, colours, hello, limits } = scene;
  to.save();
  lookDown(to, camera);
  to.lineJoin = "round";
  const px = 1 / camera.pixels_per_m;
  const dash = [14 * px, 8 * px];
  drawDepths(scene, px, dash);
  for (const kind of SHAPES) {
    to.lineWidth = (kind === "bridge" ? 3 : kind === "quay" ? 2 : 1.2) * px;
    to.setLineDash(DASHED.has(kind) ? dash : []);
    to.strokeStyle = DASHED.has(kind)
      ? colours.dim
      : kind === "depth_contour"
        ? colours.grid
        : colours.land_edge;
    if (kind === "fairway" || kind === "leading_line") to.strokeStyle = colours.fairway;
    for (const feature of hello.chart) {
      if (feature.kind !== kind || feature.shape === "point") continue;
      const path = pathOf(feature);
      const fill = fillOf(feature, limits, colours);
      if (fill) {
        to.fillStyle = fill;
        to.fill(path, "evenodd");
      }
      if (kind !== "unsurveyed_area") to.stroke(path);
    }
    if (kind === "depth_contour") drawSafetyContour(scene, px);
  }
  to.restore();
}

/** Areas of depth, dredged areas with their edges. */
function drawDepths(scene: Scene, px: number, dash: number[]): void {
  const { to, colours, limits } = scene;
  const known = depthsOf(scene);
  for (const { feature, path } of known.areas) {
    to.fillStyle = depthColour(feature.depth_m ?? 0, limits, colours);
    to.fill(path, "evenodd");
    if (feature.kind !== "dredged_area") continue;
    to.strokeStyle = colours.dim;
    to.lineWidth = 1.2 * px;
    to.setLineDash(dash);
    to.stroke(path);
    to.setLineDash([]);
  }
}

/** The safety contour, over the other contours. */
function drawSafetyContour(scene: Scene, px: number): void {
  const { to, colours, limits } = scene;
  to.strokeStyle = colours.contour;
  to.lineWidth = CONTOUR_PX * px;
  to.lineCap = "round";
  to.stroke(depthsOf(scene).safetyContour(limits.safety_m));
  to.lineCap = "butt";
}

/** The colour of an area; `undefined`: only its edge is drawn. */
function fillOf(feature: ChartInfo, of: Limits, colours: Palette): string | undefined {
  if (feature.shape !== "area") return undefined;
  const { kind, depth_m } = feature;
  // A danger of unknown depth is as dangerous as a shallow one.
  if (kind === "rock" || kind === "obstruction" || kind === "wreck")
    return depthColour(depth_m ?? 0, of, colours);
  if (kind === "unsurveyed_area") return colours.grid;
  return SOLID.has(kind) ? colours.land : undefined;
}

/** Soundings, buoys, beacons, lights, dangers and words, over the chart and below ships. */
export function drawChartMarks(scene: Scene): void {
  const { to, camera, colours, hello, limits } = scene;
  drawSoundings(to, camera, colours, hello.chart, limits.safety_m);
  // Lamps over marks, as they stand on them.
  for (const isLamp of [false, true])
    for (const feature of hello.chart) {
      if (feature.shape !== "point" || (feature.kind === "light") !== isLamp) continue;
      const at = feature.lines[0]?.[0];
      const on = at && toScreen(camera, at);
      if (!on || !isNear(on, camera)) continue;
      if (isLamp)
        drawLight(to, on, feature, camera.up_rad, colours, {
          t_s: scene.t_s,
          isDark: colours.isDark,
        });
      else if (feature.kind === "buoy" || feature.kind === "beacon")
        drawMark(to, on, feature, colours);
      else drawPoint(to, on, feature, colours);
    }
  let words = 0;
  hello.chart.forEach((feature, index) => {
    const text = wordsOf(feature, camera);
    const at = text && words < MOST_WORDS ? middle(feature) : undefined;
    if (!at) return;
    const on = toScreen(camera, at);
    if (!isNear(on, camera)) return;
    words += 1;
    const isName = feature.kind === "name";
    const isMark = feature.kind === "buoy" || feature.kind === "beacon";
    scene.labels.push({
      key: `chart ${index}`,
      text,
      rank: Rank.Detail,
      at: on,
      off: feature.shape === "point" && !isName ? [0, MARK_PX + 8] : [0, 0],
      colour: isMark || isName ? colours.text : colours.dim,
      size: isName ? 13 : 11,
    });
  });
}

function isNear([x, y]: Pair, { width, height }: Camera): boolean {
  return x > -40 && y > -40 && x < width + 40 && y < height + 40;
}

const middles = new WeakMap<ChartInfo, Pair>();

/** Where a feature's words are: its place, the middle place of its line, or among the corners of its area. */
function middle(feature: ChartInfo): Pair | undefined {
  const line = feature.lines[0];
  if (!line) return undefined;
  if (feature.shape === "area") {
    let found = middles.get(feature);
    if (!found) {
      const sum = line.reduce<Pair>((all, [n, e]) => [all[0] + n, all[1] + e], [0, 0]);
      found = [sum[0] / line.length, sum[1] / line.length];
      middles.set(feature, found);
    }
    return found;
  }
  if (line.length !== 2) return line[Math.floor(line.length / 2)];
  const [[n1, e1], [n2, e2]] = line as [Pair, Pair];
  // Nearer to the beginning, where a ship comes from, than to the marks at its end.
  return [n1 + (n2 - n1) * 0.35, e1 + (e2 - e1) * 0.35];
}

function wordsOf(feature: ChartInfo, { pixels_per_m }: Camera): string {
  switch (feature.kind) {
    case "name":
      return pixels_per_m > DEPTHS_FROM ? feature.name : "";
    case "depth_contour":
      return pixels_per_m > DEPTHS_FROM ? `${fixed(feature.depth_m ?? 0, 0)} m` : "";
    case "leading_line":
    case "fairway":
    case "anchorage":
    case "berth":
      return pixels_per_m > DEPTHS_FROM ? feature.name : "";
    case "rock":
    case "wreck":
    case "obstruction":
      if (pixels_per_m <= NAMES_FROM || feature.depth_m === null) return "";
      return written(feature.depth_m).filter(Boolean).join(".");
    case "bridge":
    case "overhead_cable":
      if (pixels_per_m <= DEPTHS_FROM || feature.clearance_m === null) return "";
      return `${fixed(feature.clearance_m, 1)} m clear`;
    case "light":
      return pixels_per_m > NAMES_FROM ? (feature.character ?? "") : "";
    case "buoy":
    case "beacon":
    case "landmark":
      return pixels_per_m > NAMES_FROM ? feature.name : "";
    default:
      return "";
  }
}

/** Dangers and posts; names and soundings have words alone. */
function drawPoint(
  to: CanvasRenderingContext2D,
  [x, y]: Pair,
  feature: ChartInfo,
  colours: Palette,
): void {
  const s = MARK_PX;
  to.save();
  to.lineWidth = 1.2;
  to.strokeStyle = colours.text;
  to.beginPath();
  switch (feature.kind) {
    case "rock":
    case "wreck":
    case "obstruction":
      to.moveTo(x - s, y);
      to.lineTo(x + s, y);
      to.moveTo(x, y - s);
      to.lineTo(x, y + s);
      if (feature.kind === "wreck") {
        to.moveTo(x - s / 2, y - s / 2);
        to.lineTo(x - s / 2, y + s / 2);
        to.moveTo(x + s / 2, y - s / 2);
        to.lineTo(x + s / 2, y + s / 2);
      }
      to.stroke();
      if (feature.kind === "obstruction") {
        to.beginPath();
        to.setLineDash([2, 2]);
        to.arc(x, y, 1.3 * s, 0, 2 * Math.PI);
        to.stroke();
      }
      break;
    case "mooring":
    case "landmark":
    case "coast":
    case "quay":
    case "pontoon":
    case "building":
      to.fillStyle = colours.land;
      to.rect(x - s / 2, y - s / 2, s, s);
      to.fill();
      to.stroke();
      break;
    default:
      break;
  }
  to.restore();
}
