/** Rings of a chart with walls and tops. */
import { ShapeUtils, Vector2 } from "three";
import { area2, lid, sides } from "./berth";
import type { Colour, Solids } from "./solids";
import type { Pair } from "../protocol";

/** How far below datum the banks of coasts reach [m]. */
export const BANK_FOOT_M = -3;
/** Breadth of a bank over its height. */
export const BANK = 7 / 6;

/** Triangles of a ring with holes, as indices into all their corners one after the other. */
export const cut = (ring: Pair[], holes: Pair[][] = []): number[][] => {
  const points = (of: Pair[]) => of.map(([n, e]) => new Vector2(n, e));
  return ShapeUtils.triangulateShape(points(ring), holes.map(points));
};

/** Mean width of an area: twice its area over its circumference [m]. */
export function width(ring: Pair[]): number {
  const around = ring.reduce((sum, a, i) => {
    const b = ring[(i + 1) % ring.length] ?? a;
    return sum + Math.hypot(b[0] - a[0], b[1] - a[1]);
  }, 0);
  return around > 0 ? Math.abs(area2(ring)) / around : 0;
}

/** Breadth of the bank of a coast: that of its height, but on a narrow mole less [m]. */
export const bankOf = (ring: Pair[], ground_m: number): number =>
  Math.min(BANK * (ground_m - BANK_FOOT_M), 0.45 * width(ring));

/** Walls along a ring and a level top. */
export function block(
  ring: Pair[],
  [from_m, to_m]: Pair,
  wall: Colour,
  top: Colour,
  to: Solids,
): void {
  sides(ring, ring, from_m, to_m, wall, to);
  lid(ring, cut, to_m, top, to);
}
