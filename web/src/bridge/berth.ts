/**
 * Quays, dolphins and bollards. A fixed body has an outline and no height: `heights.ts` tells the height of its deck. Heights
 * count from datum. Faces reach below the water; the colour of concrete is made by the
 * material.
 */
import type { Colour, Spot } from "./solids";
import { Solids } from "./solids";
import { add, dot, length, minus, times, turned } from "../geometry";
import type { FenderInfo, LevelInfo, Pair } from "../protocol";
import { wrapped } from "../units";

/** Height of a quay above datum where nothing tells it and tides are small [m]. */
export const QUAY_M = 3.5;
/** Height of a bollard [m]. */
export const STEM_M = 0.55;
/** Height of the bight of a line on a bollard above its foot [m]. */
export const BIGHT_M = STEM_M - 0.15;
const BELOW_M = -9;
/** A fixed body whose ends are no farther apart is a dolphin [m]. */
const DOLPHIN_M = 22;

export const CONCRETE: Colour = 0xa9a59b;
const DECK: Colour = 0x8f8c84;
const COPE: Colour = 0xbdb8aa;
const EDGE: Colour = 0xc9a227;
const IRON: Colour = 0x23282b;

/** Twice the signed area of a ring. */
export function area2(ring: Pair[]): number {
  return ring.reduce((sum, a, i) => {
    const b = ring[(i + 1) % ring.length] ?? a;
    return sum + a[0] * b[1] - a[1] * b[0];
  }, 0);
}

/** A ring moved inwards by a distance, corner by corner; corners as sharp as needles are cut. */
export function inset(ring: Pair[], by_m: number): Pair[] {
  const sign = area2(ring) > 0 ? 1 : -1;
  const n = ring.length;
  return ring.map((at, i) => {
    const [before, after] = [ring[(i + n - 1) % n] ?? at, ring[(i + 1) % n] ?? at];
    const normal = (a: Pair, b: Pair): Pair => {
      const long = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
      return [(-sign * (b[1] - a[1])) / long, (sign * (b[0] - a[0])) / long];
    };
    const [p, q] = [normal(before, at), normal(at, after)];
    const mean: Pair = [p[0] + q[0], p[1] + q[1]];
    const share = Math.max(0.25, (mean[0] ** 2 + mean[1] ** 2) / 2);
    return [at[0] + (mean[0] / share) * by_m, at[1] + (mean[1] / share) * by_m];
  });
}

export const isDolphin = (outline: Pair[]): boolean => {
  const span = (axis: 0 | 1) => {
    const all = outline.map((p) => p[axis]);
    return Math.max(...all) - Math.min(...all);
  };
  return Math.max(span(0), span(1)) <= DOLPHIN_M;
};

/**
 * A fixed body, in its own axes. `cut`: splits a ring without holes into triangles of indices. `levels`: its outlines at several
 * heights above datum, where there are some.
 */
export function fixedParts(
  outline: Pair[],
  deck_m: number,
  cut: (ring: Pair[]) => number[][],
  to: Solids,
  levels: LevelInfo[] = [],
): void {
  const top = levels.at(-1);
  if (top) {
    faces(levels, to);
    quay(top.outline, deck_m, cut, to, top.height_m);
  } else if (isDolphin(outline)) dolphin(outline, deck_m, to);
  else quay(outline, deck_m, cut, to);
}

/** The sides of a body between its outlines, and upright below the lowest. */
function faces(levels: LevelInfo[], to: Solids): void {
  const [lowest] = levels;
  if (lowest) walls(lowest.outline, [BELOW_M, lowest.height_m], CONCRETE, "outside", to);
  levels.slice(1).forEach((high, i) => {
    const low = levels[i] ?? high;
    sides(low.outline, high.outline, low.height_m, high.height_m, CONCRETE, to);
  });
}

/** Walls along a ring, to another ring of as many corners. */
export function sides(
  ring: Pair[],
  over: Pair[],
  from_m: number,
  to_m: number,
  colour: number,
  to: Solids,
) {
  const sign = area2(ring) > 0 ? 1 : -1;
  ring.forEach((a, i) => {
    const k = (i + 1) % ring.length;
    const [b, c, d] = [ring[k], over[k], over[i]];
    if (!b || !c || !d) return;
    const corners: Spot[] = [
      [...a, from_m],
      [...b, from_m],
      [...c, to_m],
      [...d, to_m],
    ];
    to.face(corners, [sign * (b[1] - a[1]), -sign * (b[0] - a[0]), 0.01], colour);
  });
}

/** Walls along a ring, seen from outside the ring, or from inside. */
function walls(
  ring: Pair[],
  [from_m, to_m]: Pair,
  colour: Colour,
  seenFrom: "outside" | "inside",
  to: Solids,
): void {
  const sign = area2(ring) > 0 === (seenFrom === "outside") ? 1 : -1;
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length] ?? a;
    const out: Spot = [sign * (b[1] - a[1]), -sign * (b[0] - a[0]), 0];
    to.face(
      [
        [...a, from_m],
        [...b, from_m],
        [...b, to_m],
        [...a, to_m],
      ],
      out,
      colour,
    );
  });
}

/** A level top of any ring. */
export function lid(
  ring: Pair[],
  cut: (ring: Pair[]) => number[][],
  up_m: number,
  colour: Colour,
  to: Solids,
): void {
  for (const three of cut(ring)) {
    const corners = three.flatMap((k): Spot[] => {
      const at = ring[k];
      return at ? [[...at, up_m]] : [];
    });
    if (corners.length === 3) to.face(corners, [0, 0, 1], colour);
  }
}

/** A level band between two rings of as many corners. */
function band(outer: Pair[], inner: Pair[], up_m: number, colour: Colour, to: Solids): void {
  outer.forEach((a, i) => {
    const k = (i + 1) % outer.length;
    const [b, c, d] = [outer[k], inner[k], inner[i]];
    if (b && c && d)
      to.face(
        [
          [...a, up_m],
          [...b, up_m],
          [...c, up_m],
          [...d, up_m],
        ],
        [0, 0, 1],
        colour,
      );
  });
}

export function quay(
  outline: Pair[],
  deck_m: number,
  cut: (ring: Pair[]) => number[][],
  to: Solids,
  /** Where the upright wall begins [m]. */
  from_m = BELOW_M,
): void {
  const kerb = inset(outline, 0.35);
  const cope = inset(outline, 1.1);
  walls(outline, [from_m, deck_m + 0.25], CONCRETE, "outside", to);
  band(outline, kerb, deck_m + 0.25, EDGE, to);
  // The kerb's back.
  walls(kerb, [deck_m, deck_m + 0.25], COPE, "inside", to);
  band(kerb, cope, deck_m, COPE, to);
  lid(cope, cut, deck_m, DECK, to);
}

function dolphin(outline: Pair[], deck_m: number, to: Solids): void {
  const middle: Pair = [
    outline.reduce((sum, p) => sum + p[0], 0) / outline.length,
    outline.reduce((sum, p) => sum + p[1], 0) / outline.length,
  ];
  to.prism(outline, deck_m - 1.6, deck_m, CONCRETE, DECK, CONCRETE);
  const cap = inset(outline, 0.3);
  band(outline, cap, deck_m + 0.02, EDGE, to);
  // Piles lean outwards.
  for (const at of inset(outline, 1)) {
    const foot: Spot = [
      at[0] + (at[0] - middle[0]) * 0.35,
      at[1] + (at[1] - middle[1]) * 0.35,
      BELOW_M,
    ];
    to.post(foot, [at[0], at[1], deck_m - 1.5], 0.55, 0x4a4f4e, { sides: 10, caps: false });
  }
}

/** A bollard with a head that leans from the water. */
export function bollard([f, s]: Pair, foot_m: number, to: Solids): void {
  to.post([f, s, foot_m], [f, s, foot_m + 0.08], 0.5, 0x6c6a63, { sides: 12 });
  to.post([f, s, foot_m], [f, s, foot_m + STEM_M - 0.12], 0.24, IRON, { sides: 12, upper_m: 0.19 });
  to.post([f, s, foot_m + STEM_M - 0.14], [f, s, foot_m + STEM_M], 0.36, IRON, {
    sides: 12,
    upper_m: 0.3,
  });
}

/** Where a fender is mounted on a shore, and where it faces. */
export type Mounted = Pick<FenderInfo, "at_m" | "facing_rad">;

/** Fenders farther apart than this, or that face farther apart, are of different fronts. */
const FRONT_GAP_M = 80;
const FRONT_TURN_RAD = 0.6;
/** How far a front reaches past its last fender [m]. */
const PAST_M = 12;
/** A quay reaches at least so far behind its front, over the bank of the coast [m]. */
const APRON_M = 9;
/** Half the side of the footing of a bollard that stands on no front [m]. */
const FOOTING_M = 2;

/**
 * Quays of a shore. The session has no outline of the shore: the quays are those on which its fenders and bollards stand. A front
 * runs along the fenders, in their order, and the quay reaches behind the front as far as the bollards stand.
 */
export function quaysOf(fenders: Mounted[], bollards: Pair[]): Pair[][] {
  const quays = frontsOf(fenders).map((front): Pair[] => {
    const [first, last] = [front[0], front.at(-1)];
    if (!first || !last) return [];
    // From the first fender to the last; of a single fender across its facing.
    const way = minus(last.at_m, first.at_m);
    const along =
      length(way) > 0 ? times(way, 1 / length(way)) : turned(0.5 * Math.PI, outward(first));
    const ends: Mounted[] = [
      { ...first, at_m: add(first.at_m, times(along, -PAST_M)) },
      ...front,
      { ...last, at_m: add(last.at_m, times(along, PAST_M)) },
    ];
    const deep_m = Math.max(APRON_M, ...bollards.map((at) => behind(front, at) + 2));
    const back = ends.map((fender) => minus(fender.at_m, times(outward(fender), deep_m)));
    return [...ends.map(({ at_m }) => at_m), ...back.toReversed()];
  });
  for (const at of bollards)
    if (!quays.some((ring) => isInside(ring, at)))
      quays.push(
        [
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([n = 0, e = 0]): Pair => [at[0] + n * FOOTING_M, at[1] + e * FOOTING_M]),
      );
  return quays;
}

const outward = ({ facing_rad }: Mounted): Pair => [Math.cos(facing_rad), Math.sin(facing_rad)];

/** Fenders side by side that face the same way, in their order. */
function frontsOf(fenders: Mounted[]): Mounted[][] {
  const fronts: Mounted[][] = [];
  for (const fender of fenders) {
    const front = fronts.at(-1);
    const last = front?.at(-1);
    const isNext =
      last !== undefined &&
      length(minus(fender.at_m, last.at_m)) <= FRONT_GAP_M &&
      Math.abs(wrapped(fender.facing_rad - last.facing_rad)) <= FRONT_TURN_RAD;
    if (front && isNext) front.push(fender);
    else fronts.push([fender]);
  }
  return fronts;
}

/** How far a bollard stands behind the nearest fender of a front; 0 if it belongs to no fender of the front [m]. */
function behind(front: Mounted[], at: Pair): number {
  const off = (fender: Mounted) => length(minus(at, fender.at_m));
  const nearest = front.reduce((best, next) => (off(next) < off(best) ? next : best));
  return off(nearest) < FRONT_GAP_M ? dot(minus(nearest.at_m, at), outward(nearest)) : 0;
}

/** Whether a place lies in a ring. */
export function isInside(ring: Pair[], [n, e]: Pair): boolean {
  let inside = false;
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length] ?? a;
    if (a[1] > e !== b[1] > e && n < ((b[0] - a[0]) * (e - a[1])) / (b[1] - a[1]) + a[0])
      inside = !inside;
  });
  return inside;
}
