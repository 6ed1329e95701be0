/** The current as marks that float on the water and drift with it, each with the way of some seconds behind it. */
import type { CurrentNow, Pair } from "../protocol";

/** Distance from mark to mark, and how far off marks are [m]. */
const EVERY_M = 32;
const REACH_M = 150;
/** The way that a mark trails behind it [s], and its least length [m]. */
const TRAIL_S = 10;
const LEAST_M = 1.5;
/** A slower current has no marks [m/s]. */
const LEAST_MPS = 0.03;
/** Marks at most: those of a square of cells about the middle. */
export const MOST_MARKS = (2 * Math.ceil(REACH_M / EVERY_M) + 1) ** 2;

/** A mark from its tail to its head, north and east [m]. */
export type Floating = [tail: Pair, head: Pair];

export class Drift {
  /** How far the water has moved since the beginning [m]. */
  private moved: Pair = [0, 0];
  private t_s: number | null = null;

  /** The marks about a place at a time. They go back when the time does. */
  marks([north, east]: Pair, t_s: number, { speed_mps, to_rad }: CurrentNow): Floating[] {
    const [n, e]: Pair = [speed_mps * Math.cos(to_rad), speed_mps * Math.sin(to_rad)];
    const since_s = t_s - (this.t_s ?? t_s);
    this.t_s = t_s;
    this.moved = [(this.moved[0] + n * since_s) % EVERY_M, (this.moved[1] + e * since_s) % EVERY_M];
    if (speed_mps < LEAST_MPS) return [];
    const trail = Math.max(TRAIL_S, LEAST_M / speed_mps);
    const cells = Math.ceil(REACH_M / EVERY_M);
    // A grid that floats: of its marks those about the place.
    const first = (at: number, moved: number) =>
      Math.round((at - moved) / EVERY_M) * EVERY_M + moved;
    const from: Pair = [first(north, this.moved[0]), first(east, this.moved[1])];
    const found: Floating[] = [];
    for (let i = -cells; i <= cells; i++)
      for (let j = -cells; j <= cells; j++) {
        const head: Pair = [from[0] + i * EVERY_M, from[1] + j * EVERY_M];
        if (Math.hypot(head[0] - north, head[1] - east) > REACH_M) continue;
        found.push([[head[0] - trail * n, head[1] - trail * e], head]);
      }
    return found;
  }
}
