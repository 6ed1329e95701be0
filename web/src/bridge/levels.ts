/**
 * Hulls that the scenario gives by outlines at several heights. Between two outlines the side is straight, from each corner to the
 * same corner of the next, as contact has it; above the highest and below the lowest the side is upright.
 */
import { ends } from "./hull_ends";
import type { LevelInfo, Pair } from "../protocol";

/** The outline at a height above the waterline at rest. `levels` are from the lowest up, each with as many corners. */
export function ringAt(levels: LevelInfo[], up_m: number): Pair[] {
  const above = levels.findIndex(({ height_m }) => height_m > up_m);
  const low = levels.at(above < 0 ? -1 : Math.max(0, above - 1));
  const high = above < 0 ? low : levels[above];
  if (!low || !high) return [];
  const span = high.height_m - low.height_m;
  const share = span > 0 ? Math.max(0, (up_m - low.height_m) / span) : 0;
  return low.outline.map(([f, s], i): Pair => {
    const [f2, s2] = high.outline[i] ?? [f, s];
    return [f + share * (f2 - f), s + share * (s2 - s)];
  });
}

/** How far an outline reaches at a station: its coordinates to starboard at the port side and at the starboard side [m]. */
export function reach(ring: Pair[], forward_m: number): Pair {
  let [port, starboard] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  const meet = (s: number) => {
    port = Math.min(port, s);
    starboard = Math.max(starboard, s);
  };
  ring.forEach(([f, s], i) => {
    const [f2, s2] = ring[(i + 1) % ring.length] ?? [f, s];
    if ((f - forward_m) * (f2 - forward_m) > 0) return;
    if (f === f2) {
      meet(s);
      meet(s2);
    } else meet(s + ((forward_m - f) / (f2 - f)) * (s2 - s));
  });
  return port <= starboard ? [port, starboard] : [0, 0];
}

/** Shares of the length, from 0 at the stern to 1 at the bow, at which outlines have corners. */
export function cornersAlong(levels: LevelInfo[]): number[] {
  const all = levels.flatMap(({ outline }) => {
    const [aft, fore] = ends(outline);
    return outline.map(([f]) => Math.round((1e4 * (f - aft)) / Math.max(1e-6, fore - aft)) / 1e4);
  });
  return [...new Set(all)].toSorted((a, b) => a - b);
}
