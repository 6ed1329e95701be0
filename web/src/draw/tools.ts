/** Draws the plan's measuring tools: range rings, electronic bearing line, and the distance between two points. */
import { type Camera, add, length, minus, times, toScreen } from "../geometry";
import type { Palette } from "../palette";
import type { BodyNow, Pair } from "../protocol";
import { NAUTICAL_MILE_M, distance, heading, sided, wrapped } from "../units";
import { type Label, Rank } from "./labels";
import { stroke } from "./marks";

/** A length between two rings is one of these, so that they are round in metres near the berth and in miles farther off. */
const RINGS_M = [10, 20, 50, 100, ...[0.1, 0.25, 0.5, 1, 2, 5, 10].map((n) => n * NAUTICAL_MILE_M)];
const BETWEEN_RINGS_PX = 70;
const MOST_RINGS = 6;
/** Radius of the knob at the end of the bearing line, and the share of the canvas at which it is. */
export const KNOB_PX = 9;
const KNOB_AT = 0.36;
const DASH = [8, 5];

export interface ToolsScene {
  to: CanvasRenderingContext2D;
  camera: Camera;
  colours: Palette;
  labels: Label[];
  /** The ship from which is measured. */
  ship: BodyNow;
}

const bearing = ([north, east]: Pair): number => Math.atan2(east, north);

/** From one place to another: bearing and distance. */
export const fromTo = (from: Pair, till: Pair): string =>
  `${heading(bearing(minus(till, from)))} ${distance(length(minus(till, from)))}`;

/** A label of the tools at a point. */
const written = (scene: ToolsScene, key: string, text: string, at: Pair): Label => ({
  key,
  text,
  rank: Rank.Measure,
  at,
  colour: scene.colours.text,
  size: 13,
});

/** Distance between two rings at a scale [m]. */
export const ringsApart = (pixels_per_m: number): number =>
  RINGS_M.find((m) => m * pixels_per_m >= BETWEEN_RINGS_PX) ?? RINGS_M.at(-1) ?? 1;

export function drawRings(scene: ToolsScene): void {
  const { to, camera, colours, ship, labels } = scene;
  const apart = ringsApart(camera.pixels_per_m);
  const [x, y] = toScreen(camera, [ship[0], ship[1]]);
  for (let i = 1; i <= MOST_RINGS; i++) {
    const radius = i * apart * camera.pixels_per_m;
    to.beginPath();
    to.arc(x, y, radius, 0, 2 * Math.PI);
    to.strokeStyle = colours.dim;
    to.lineWidth = 1;
    to.globalAlpha = 0.6;
    to.stroke();
    to.globalAlpha = 1;
    // Where the ring is on the canvas: above the ship, or below or beside her.
    const around: Pair[] = [
      [x, y - radius],
      [x, y + radius],
      [x - radius, y],
      [x + radius, y],
    ];
    const at = around.find(
      ([left, top]) => left > 0 && top > 0 && left < camera.width && top < camera.height,
    );
    if (!at) continue;
    labels.push({ ...written(scene, `ring ${i}`, distance(i * apart), at), off: [0, 0] });
  }
}

/** Where the knob of the bearing line is on the canvas. */
export function knob(camera: Camera, ship: BodyNow, bearing_rad: number): Pair {
  const far_m = (Math.min(camera.width, camera.height) * KNOB_AT) / camera.pixels_per_m;
  const toward: Pair = [Math.cos(bearing_rad), Math.sin(bearing_rad)];
  return toScreen(camera, add([ship[0], ship[1]], times(toward, far_m)));
}

export function drawBearingLine(scene: ToolsScene, bearing_rad: number): void {
  const { to, camera, colours, ship, labels } = scene;
  const from = toScreen(camera, [ship[0], ship[1]]);
  const at = knob(camera, ship, bearing_rad);
  const [dx, dy] = minus(at, from);
  // To beyond the canvas.
  const far = (camera.width + camera.height) / Math.hypot(dx, dy);
  stroke(to, from, [from[0] + dx * far, from[1] + dy * far], colours.wind, 2, DASH);
  to.beginPath();
  to.arc(...at, KNOB_PX, 0, 2 * Math.PI);
  to.fillStyle = colours.panel;
  to.fill();
  to.strokeStyle = colours.wind;
  to.lineWidth = 3;
  to.stroke();
  const relative = sided(wrapped(bearing_rad - ship[2]), 1);
  const text = `${heading(bearing_rad)} true, ${relative} relative`;
  const label = written(scene, "bearing line", text, at);
  labels.push({ ...label, off: [0, dy < 0 ? -24 : 24], bold: true, clamped: true });
}

/** The line between two points, with bearing and distance from the first. */
export function drawMeasured(scene: ToolsScene, from: Pair, till: Pair): void {
  const { to, camera, colours, labels } = scene;
  const ends = [from, till].map((place) => toScreen(camera, place)) as [Pair, Pair];
  stroke(to, ...ends, colours.text, 2);
  for (const at of ends) {
    stroke(to, [at[0] - 6, at[1] - 6], [at[0] + 6, at[1] + 6], colours.text, 2);
    stroke(to, [at[0] - 6, at[1] + 6], [at[0] + 6, at[1] - 6], colours.text, 2);
  }
  const middle = times(add(...ends), 0.5);
  labels.push({ ...written(scene, "measured", fromTo(from, till), middle), bold: true });
}
