/** Draws the chart behind ships and quays: depths, coast, quays, leading lines, buoys, beacons, names. */
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

/** Lines and areas, below everything else. */
export function drawChart(scene: Scene): void {
  const { to, camera, colours, hello } = scene;
  const draught_m = draught(scene);
  for (const kind of ["depth_area", "depth_contour", "coast", "quay", "leading_line"] as const) {
    for (const feature of hello.chart) {
      if (feature.kind !== kind) continue;
      to.save();
      lookDown(to, camera);
      const path = pathOf(feature);
      to.lineJoin = "round";
      to.lineWidth = (kind === "quay" ? 2 : 1.2) / camera.pixels_per_m;
      if (feature.shape === "area") {
        to.fillStyle =
          kind === "depth_area"
            ? depthColour(feature.depth_m ?? 0, draught_m, colours)
            : colours.land;
        to.fill(path, "evenodd");
      }
      if (kind === "leading_line") {
        to.setLineDash([14 / camera.pixels_per_m, 8 / camera.pixels_per_m]);
        to.strokeStyle = colours.dim;
      } else {
        to.strokeStyle = kind === "coast" || kind === "quay" ? colours.land_edge : colours.grid;
      }
      if (kind !== "depth_area") to.stroke(path);
      to.restore();
    }
  }
}

/** Buoys, beacons and words, over the chart and below ships. */
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
    const text = wordsOf(feature, camera);
    if (!text || words === MOST_WORDS) return;
    words += 1;
    scene.labels.push({
      key: `chart ${index}`,
      text,
      rank: Rank.Detail,
      at: on,
      off: isMark ? [0, -MARK_PX - 12] : [0, 0],
      colour: isMark || feature.kind === "name" ? colours.text : colours.dim,
      size: feature.kind === "name" ? 13 : 11,
    });
  });
}

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
    case "buoy":
    case "beacon":
      return pixels_per_m > NAMES_FROM ? feature.name : "";
    default:
      return "";
  }
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
