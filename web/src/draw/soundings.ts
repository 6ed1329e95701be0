/**
 * Soundings that thin out with zoom: of those that lie close together the shallowest is written. Those that the ship must keep
 * clear of are dark, others grey. The decimal stands lower, as on charts.
 */
import { type Camera, toScreen } from "../geometry";
import type { Palette } from "../palette";
import type { ChartInfo, Pair } from "../protocol";
import { FONT } from "./marks";

/** Least distance between two soundings on the screen [px]. */
const APART_PX = 52;
/** Distance between soundings at level 0 [m]; doubled from level to level. */
const FINEST_M = 4;
const LEVELS = 14;

export interface Sounding {
  at: Pair;
  depth_m: number;
  /** The coarsest level at which it is written. */
  level: number;
}

/** Chooses the soundings of each level: the shallowest first, none nearer to another than the distance of the level. */
export function thinned(soundings: { at: Pair; depth_m: number }[]): Sounding[] {
  let rest: Sounding[] = soundings
    .map(({ at, depth_m }) => ({ at, depth_m, level: -1 }))
    .toSorted((a, b) => a.depth_m - b.depth_m);
  const all = rest;
  for (let level = 0; level < LEVELS && rest.length > 0; level++) {
    const apart_m = FINEST_M * 2 ** level;
    const cells = new Map<string, Pair[]>();
    rest = rest.filter((sounding) => {
      const [n, e] = sounding.at.map((x) => Math.floor(x / apart_m)) as Pair;
      for (let i = n - 1; i <= n + 1; i++)
        for (let j = e - 1; j <= e + 1; j++)
          if (
            cells
              .get(`${i} ${j}`)
              ?.some((o) => Math.hypot(o[0] - sounding.at[0], o[1] - sounding.at[1]) < apart_m)
          )
            return false;
      const own = cells.get(`${n} ${e}`);
      if (own) own.push(sounding.at);
      else cells.set(`${n} ${e}`, [sounding.at]);
      sounding.level = level;
      return true;
    });
  }
  return all.filter(({ level }) => level >= 0);
}

/** The level of which soundings are written at a scale. */
export const levelAt = (pixels_per_m: number): number =>
  Math.max(0, Math.ceil(Math.log2(APART_PX / (FINEST_M * pixels_per_m))));

/** A depth as charts write it: metres, and a decimal up to 31 m that stands lower. */
export function written(depth_m: number): [metres: string, decimal: string] {
  // A depth is rounded towards the shallow side.
  const tenths = Math.floor(Math.abs(depth_m) * 10 + 1e-6);
  if (Math.abs(depth_m) >= 31) return [String(Math.floor(tenths / 10)), ""];
  const decimal = tenths % 10;
  return [String(Math.floor(tenths / 10)), decimal ? String(decimal) : ""];
}

const kept = new WeakMap<readonly ChartInfo[], Sounding[]>();

export function drawSoundings(
  to: CanvasRenderingContext2D,
  camera: Camera,
  colours: Palette,
  chart: readonly ChartInfo[],
  safety_m: number,
): void {
  let soundings = kept.get(chart);
  if (!soundings) {
    soundings = thinned(
      chart.flatMap(({ kind, lines, depth_m }) => {
        const at = lines[0]?.[0];
        return kind === "sounding" && at && depth_m !== null ? [{ at, depth_m }] : [];
      }),
    );
    kept.set(chart, soundings);
  }
  const level = levelAt(camera.pixels_per_m);
  to.textAlign = "left";
  to.textBaseline = "middle";
  for (const sounding of soundings) {
    if (sounding.level < level) continue;
    const [x, y] = toScreen(camera, sounding.at);
    if (x < -20 || y < -20 || x > camera.width + 20 || y > camera.height + 20) continue;
    const isDangerous = sounding.depth_m <= safety_m;
    to.fillStyle = isDangerous ? colours.text : colours.sounding;
    const weight = isDangerous ? 700 : 400;
    const [metres, decimal] = written(sounding.depth_m);
    to.font = `${weight} 12px ${FONT}`;
    const wide = to.measureText(metres).width;
    to.fillText(metres, x - wide / 2, y);
    // What falls dry is underlined.
    if (sounding.depth_m < 0) to.fillRect(x - wide / 2, y + 6, wide, 1.2);
    if (!decimal) continue;
    to.font = `${weight} 9px ${FONT}`;
    to.fillText(decimal, x + wide / 2 + 1, y + 4);
  }
}
