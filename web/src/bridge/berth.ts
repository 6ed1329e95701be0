/**
 * Quays, dolphins and bollards. A fixed body has an outline and no height: quays are drawn with the height that is usual
 * where tides are small. Faces reach below the water; the colour of concrete is made by the material.
 */
import type { Colour, Spot } from "./solids";
import { Solids } from "./solids";
import type { Pair } from "../protocol";

/** Height of a quay above the still water [m]. */
export const QUAY_M = 3.5;
/** Height of a bollard [m]. */
export const STEM_M = 0.55;
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

/** A fixed body, in its own axes. `cut`: splits a ring without holes into triangles of indices. */
export function fixedParts(outline: Pair[], cut: (ring: Pair[]) => number[][], to: Solids): void {
  if (isDolphin(outline)) dolphin(outline, to);
  else quay(outline, cut, to);
}

function walls(ring: Pair[], from_m: number, to_m: number, colour: Colour, to: Solids): void {
  const sign = area2(ring) > 0 ? 1 : -1;
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

function quay(outline: Pair[], cut: (ring: Pair[]) => number[][], to: Solids): void {
  const kerb = inset(outline, 0.35);
  const cope = inset(outline, 1.1);
  walls(outline, BELOW_M, QUAY_M + 0.25, CONCRETE, to);
  band(outline, kerb, QUAY_M + 0.25, EDGE, to);
  // The kerb's back.
  const back = kerb.toReversed();
  walls(back, QUAY_M, QUAY_M + 0.25, COPE, to);
  band(kerb, cope, QUAY_M, COPE, to);
  lid(cope, cut, QUAY_M, DECK, to);
}

function dolphin(outline: Pair[], to: Solids): void {
  const middle: Pair = [
    outline.reduce((sum, p) => sum + p[0], 0) / outline.length,
    outline.reduce((sum, p) => sum + p[1], 0) / outline.length,
  ];
  to.prism(outline, QUAY_M - 1.6, QUAY_M, CONCRETE, DECK, CONCRETE);
  const cap = inset(outline, 0.3);
  band(outline, cap, QUAY_M + 0.02, EDGE, to);
  // Piles lean outwards.
  for (const at of inset(outline, 1)) {
    const foot: Spot = [
      at[0] + (at[0] - middle[0]) * 0.35,
      at[1] + (at[1] - middle[1]) * 0.35,
      BELOW_M,
    ];
    to.post(foot, [at[0], at[1], QUAY_M - 1.5], 0.55, 0x4a4f4e, { sides: 10, caps: false });
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
