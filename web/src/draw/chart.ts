/** Draws the chart behind ships and quays: depths, coast, quays, fairways, bridges, dangers, marks, lights, names. */
import { type Camera, toScreen } from "../geometry";
import type { Palette } from "../palette";
import type { ChartInfo, Pair } from "../protocol";
import { fixed } from "../units";
import { Rank } from "./labels";
import { polygon } from "./marks";
import type { Scene } from "./scene";

/** Half the size of a buoy [px]. */
const MARK_PX = 6;
/** From these scales on, names of marks and depths of contours are written [px/m]. */
const NAMES_FROM = 0.25;
const DEPTHS_FROM = 0.08;
/** Most words of the chart in one picture: placing them takes time. */
const MOST_WORDS = 60;
/** Water of less depth than this many draughts of the pilot's ship has a colour of its own. */
const MEDIUM_DRAUGHTS = 1.5;

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

/** The deepest draught of ships that are no tugs: the water that is shallow for them is shown so. */
const draught = (scene: Scene): number =>
  Math.max(0, ...scene.hello.vessels.filter((v) => !v.is_tug).map((v) => v.draught_m));

function depthColour(depth_m: number, draught_m: number, colours: Palette): string {
  if (depth_m < 0) return colours.drying;
  if (depth_m < draught_m) return colours.shallow;
  return depth_m < MEDIUM_DRAUGHTS * draught_m ? colours.medium : colours.water;
}

/** Kinds of lines and areas, in the order in which they are drawn. */
const SHAPES = [
  "depth_area",
  "unsurveyed_area",
  "dredged_area",
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
  const { to, camera, colours, hello } = scene;
  const draught_m = draught(scene);
  for (const kind of SHAPES) {
    for (const feature of hello.chart) {
      if (feature.kind !== kind || feature.shape === "point") continue;
      to.save();
      lookDown(to, camera);
      const path = pathOf(feature);
      to.lineJoin = "round";
      const width_px = kind === "bridge" ? 3 : kind === "quay" ? 2 : 1.2;
      to.lineWidth = width_px / camera.pixels_per_m;
      const fill = fillOf(feature, draught_m, colours);
      if (fill) {
        to.fillStyle = fill;
        to.fill(path, "evenodd");
      }
      if (DASHED.has(kind)) {
        to.setLineDash([14 / camera.pixels_per_m, 8 / camera.pixels_per_m]);
        to.strokeStyle = colours.dim;
      } else {
        to.strokeStyle = kind === "depth_contour" ? colours.grid : colours.land_edge;
      }
      if (kind !== "depth_area" && kind !== "unsurveyed_area") to.stroke(path);
      to.restore();
    }
  }
}

/** The colour of an area; `undefined`: only its edge is drawn. */
function fillOf(feature: ChartInfo, draught_m: number, colours: Palette): string | undefined {
  if (feature.shape !== "area") return undefined;
  const { kind, depth_m } = feature;
  if (kind === "depth_area" || kind === "dredged_area")
    return depthColour(depth_m ?? 0, draught_m, colours);
  // A danger of unknown depth is as dangerous as a shallow one.
  if (kind === "rock" || kind === "obstruction" || kind === "wreck")
    return depthColour(depth_m ?? 0, draught_m, colours);
  if (kind === "unsurveyed_area") return colours.grid;
  return SOLID.has(kind) ? colours.land : undefined;
}

/** Buoys, beacons, lights, dangers and words, over the chart and below ships. */
export function drawChartMarks(scene: Scene): void {
  const { to, camera, colours, hello } = scene;
  let words = 0;
  hello.chart.forEach((feature, index) => {
    const at = middle(feature);
    if (!at) return;
    const on = toScreen(camera, at);
    if (!isNear(on, camera)) return;
    const isMark = feature.kind === "buoy" || feature.kind === "beacon";
    if (isMark) drawMark(to, on, feature, colours);
    else if (feature.shape === "point") drawPoint(to, on, feature, camera, colours);
    const text = wordsOf(feature, camera);
    if (!text || words === MOST_WORDS) return;
    words += 1;
    scene.labels.push({
      key: `chart ${index}`,
      text,
      rank: Rank.Detail,
      at: on,
      off: feature.shape === "point" && !isText(feature) ? [0, -MARK_PX - 12] : [0, 0],
      colour: isMark || feature.kind === "name" ? colours.text : colours.dim,
      size: feature.kind === "name" ? 13 : 11,
    });
  });
}

/** Features that are words alone. */
const isText = ({ kind }: ChartInfo): boolean => kind === "name" || kind === "sounding";

function isNear([x, y]: Pair, { width, height }: Camera): boolean {
  return x > -40 && y > -40 && x < width + 40 && y < height + 40;
}

/** Where a feature's mark or words are: its place, or the middle place of its line. Areas have no words. */
function middle(feature: ChartInfo): Pair | undefined {
  const line = feature.lines[0];
  if (!line || feature.shape === "area") return undefined;
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
      return pixels_per_m > DEPTHS_FROM ? feature.name : "";
    case "sounding":
      return pixels_per_m > DEPTHS_FROM ? sounding(feature.depth_m ?? 0) : "";
    case "rock":
    case "wreck":
    case "obstruction":
      return pixels_per_m > NAMES_FROM && feature.depth_m !== null ? sounding(feature.depth_m) : "";
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

/** A depth as charts write it: with a decimal up to 31 m. */
const sounding = (depth_m: number): string => fixed(depth_m, depth_m < 31 ? 1 : 0);

/** Lights with their sectors, dangers, and posts; names and soundings have words alone. */
function drawPoint(
  to: CanvasRenderingContext2D,
  [x, y]: Pair,
  feature: ChartInfo,
  { up_rad }: Camera,
  colours: Palette,
): void {
  const s = MARK_PX;
  to.save();
  to.lineWidth = 1.2;
  to.strokeStyle = colours.text;
  to.beginPath();
  switch (feature.kind) {
    case "light": {
      to.strokeStyle = to.fillStyle = {
        red: colours.port,
        green: colours.starboard,
        yellow: colours.caution,
        black: colours.text,
        white: colours.caution,
      }[feature.colour ?? "white"];
      to.arc(x, y, 0.4 * s, 0, 2 * Math.PI);
      to.fill();
      if (feature.sector_rad) {
        // A direction from north is an angle from east on the screen; both run clockwise.
        const [from, until] = feature.sector_rad.map((of) => of - up_rad - Math.PI / 2) as Pair;
        to.beginPath();
        to.lineWidth = 3;
        to.arc(x, y, 4 * s, from, until <= from ? until + 2 * Math.PI : until);
      }
      to.stroke();
      break;
    }
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

/** A can for port, a cone for starboard, otherwise a ball; a beacon stands on a base. */
function drawMark(
  to: CanvasRenderingContext2D,
  [x, y]: Pair,
  feature: ChartInfo,
  colours: Palette,
): void {
  const s = MARK_PX;
  to.strokeStyle = colours.text;
  to.lineWidth = 1.2;
  if (feature.kind === "beacon") {
    to.beginPath();
    to.moveTo(x - s, y + s + 3);
    to.lineTo(x + s, y + s + 3);
    to.moveTo(x, y + s);
    to.lineTo(x, y + s + 3);
    to.stroke();
  }
  if (feature.side === "port")
    polygon(to, [
      [x - s * 0.8, y - s],
      [x + s * 0.8, y - s],
      [x + s * 0.8, y + s],
      [x - s * 0.8, y + s],
    ]);
  else if (feature.side === "starboard")
    polygon(to, [
      [x, y - s * 1.1],
      [x + s, y + s],
      [x - s, y + s],
    ]);
  else {
    to.beginPath();
    to.arc(x, y, s * 0.85, 0, 2 * Math.PI);
  }
  to.fillStyle = {
    red: colours.port,
    green: colours.starboard,
    yellow: colours.caution,
    black: colours.text,
    white: colours.panel,
  }[feature.colour ?? "white"];
  to.fill();
  to.stroke();
}
