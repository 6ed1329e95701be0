/**
 * Puts boxes, prisms, posts and curved plates into one list of triangles with a colour for each corner, so that a ship or a
 * berth is drawn by one call. Places are [forward, starboard, up] aboard, or [north, east, up] ashore [m].
 */
import { type Triple, cross, inner, less, plus, scaled, size, unit } from "./axes";
import type { Pair } from "../protocol";

/** A place [forward, starboard, up], or [north, east, up] [m]. */
export type Spot = [forward: number, starboard: number, up: number];
/** A colour as a screen shows it, such as 0x1b2733. */
export type Colour = number;

const spotted = ([f, s, u]: Spot): Triple => [s, u, -f];

/** Linear share of a colour's channel, from 0 to 255. */
const linear = (channel: number): number => {
  const c = channel / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
};
export const linearOf = (colour: Colour): Triple => [
  linear((colour >> 16) & 255),
  linear((colour >> 8) & 255),
  linear(colour & 255),
];

export class Solids {
  readonly positions: number[] = [];
  readonly normals: number[] = [];
  readonly colours: number[] = [];

  get triangles(): number {
    return this.positions.length / 9;
  }

  private corner(at: Triple, normal: Triple, colour: Triple): void {
    this.positions.push(...at);
    this.normals.push(...normal);
    this.colours.push(...colour);
  }

  /** A flat face with its front towards `outward`. */
  private flat(corners: Triple[], outward: Triple, colour: Colour): void {
    const [a, b, c] = corners;
    if (!a || !b || !c) return;
    // Two corners may coincide, as at the tip of a cone.
    let normal = cross(less(b, a), less(c, a));
    const d = corners[3];
    if (size(normal) < 1e-9 && d) normal = cross(less(c, a), less(d, a));
    normal = unit(normal);
    const turned = inner(normal, outward) < 0;
    if (turned) normal = scaled(normal, -1);
    const tint = linearOf(colour);
    for (let i = 1; i + 1 < corners.length; i++) {
      const [p, q] = [corners[i], corners[i + 1]];
      if (!p || !q) continue;
      for (const at of turned ? [a, q, p] : [a, p, q]) this.corner(at, normal, tint);
    }
  }

  /** A flat face; `outward` is [forward, starboard, up]. */
  face(corners: Spot[], outward: Spot, colour: Colour): void {
    this.flat(corners.map(spotted), spotted(outward), colour);
  }

  /** A box between two corners. `top`: another colour for the upper face. */
  box(from: Spot, to: Spot, colour: Colour, top: Colour = colour): void {
    const [f, s, u] = [0, 1, 2].map((i): Pair => [
      Math.min(from[i] ?? 0, to[i] ?? 0),
      Math.max(from[i] ?? 0, to[i] ?? 0),
    ]) as [Pair, Pair, Pair];
    const ring: Pair[] = [
      [f[0], s[0]],
      [f[1], s[0]],
      [f[1], s[1]],
      [f[0], s[1]],
    ];
    this.prism(ring, u[0], u[1], colour, top, colour);
  }

  /** Walls and roof over a ring of corners [forward, starboard]; `below`: a colour for the floor, if it can be seen. */
  prism(
    ring: Pair[],
    from_m: number,
    to_m: number,
    colour: Colour,
    top: Colour = colour,
    below?: Colour,
  ): void {
    this.frustum(ring, ring, from_m, to_m, colour, top, below);
  }

  /** The same with another ring at the top, of as many corners. The rings are convex. */
  frustum(
    ring: Pair[],
    over: Pair[],
    from_m: number,
    to_m: number,
    colour: Colour,
    top: Colour = colour,
    below?: Colour,
  ): void {
    const middle: Pair = [
      ring.reduce((sum, p) => sum + p[0], 0) / ring.length,
      ring.reduce((sum, p) => sum + p[1], 0) / ring.length,
    ];
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length];
      const [c, d] = [over[(i + 1) % over.length], over[i]];
      if (!b || !c || !d) return;
      const out: Spot = [(a[0] + b[0]) / 2 - middle[0], (a[1] + b[1]) / 2 - middle[1], 0];
      this.face(
        [
          [...a, from_m],
          [...b, from_m],
          [...c, to_m],
          [...d, to_m],
        ],
        out,
        colour,
      );
    });
    this.face(
      over.map((p): Spot => [...p, to_m]),
      [0, 0, 1],
      top,
    );
    if (below !== undefined)
      this.face(
        ring.map((p): Spot => [...p, from_m]),
        [0, 0, -1],
        below,
      );
  }

  /** A round post, cone or pipe between two places. */
  post(
    from: Spot,
    to: Spot,
    radius_m: number,
    colour: Colour,
    { sides = 8, upper_m = radius_m, caps = true } = {},
  ): void {
    const [a, b] = [spotted(from), spotted(to)];
    const along = unit(less(b, a));
    const across = unit(cross(along, Math.abs(along[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
    const other = cross(along, across);
    const out = (i: number): Triple => {
      const angle = (2 * Math.PI * i) / sides;
      return plus(scaled(across, Math.cos(angle)), scaled(other, Math.sin(angle)));
    };
    const tint = linearOf(colour);
    for (let i = 0; i < sides; i++) {
      const [p, q] = [out(i), out(i + 1)];
      const quad: [Triple, Triple][] = [
        [plus(a, scaled(p, radius_m)), p],
        [plus(a, scaled(q, radius_m)), q],
        [plus(b, scaled(q, upper_m)), q],
        [plus(b, scaled(p, upper_m)), p],
      ];
      // With `across`, `other` and `along` right-handed this order has its front outward.
      for (const k of [0, 1, 2, 0, 2, 3]) {
        const each = quad[k];
        if (each) this.corner(each[0], each[1], tint);
      }
    }
    if (!caps) return;
    const rim = (at: Triple, radius: number) =>
      Array.from({ length: sides }, (_, i) => plus(at, scaled(out(i), radius)));
    if (upper_m > 0) this.flat(rim(b, upper_m), along, colour);
    if (radius_m > 0) this.flat(rim(a, radius_m), scaled(along, -1), colour);
  }

  /** A ball. */
  ball(at: Spot, radius_m: number, colour: Colour, rings = 6): void {
    const grid = Array.from({ length: rings + 1 }, (_, j) => {
      const up = -Math.PI / 2 + (Math.PI * j) / rings;
      return Array.from({ length: 2 * rings + 1 }, (_, i): Spot => {
        const round = (Math.PI * i) / rings;
        return [
          at[0] + radius_m * Math.cos(up) * Math.cos(round),
          at[1] + radius_m * Math.cos(up) * Math.sin(round),
          at[2] + radius_m * Math.sin(up),
        ];
      });
    });
    this.plate(
      grid,
      () => colour,
      (spot) => [spot[0] - at[0], spot[1] - at[1], spot[2] - at[2]],
    );
  }

  /**
   * A curved plate through rows of places, with smooth normals. `tint`: the colour of the patch after row `j` and column `i`;
   * `outward`: a direction on the front side at a place.
   */
  plate(
    grid: Spot[][],
    tint: (j: number, i: number) => Colour,
    outward: (spot: Spot) => Spot,
  ): void {
    const at = (j: number, i: number): Triple => {
      const row = grid[Math.min(grid.length - 1, Math.max(0, j))] ?? [];
      return spotted(row[Math.min(row.length - 1, Math.max(0, i))] ?? [0, 0, 0]);
    };
    const normal = (j: number, i: number): Triple => {
      const found = unit(cross(less(at(j, i + 1), at(j, i - 1)), less(at(j + 1, i), at(j - 1, i))));
      const out = spotted(outward(grid[j]?.[i] ?? [0, 0, 0]));
      if (size(found) < 0.5) return unit(out);
      return inner(found, out) < 0 ? scaled(found, -1) : found;
    };
    const normals = grid.map((row, j) => row.map((_, i) => normal(j, i)));
    for (let j = 0; j + 1 < grid.length; j++)
      for (let i = 0; i + 1 < (grid[j]?.length ?? 0); i++) {
        const colour = linearOf(tint(j, i));
        const keys: [number, number][] = [
          [j, i],
          [j, i + 1],
          [j + 1, i + 1],
          [j + 1, i],
        ];
        for (const three of [
          [0, 1, 2],
          [0, 2, 3],
        ]) {
          const corners = three.map((k) => keys[k] ?? keys[0] ?? [0, 0]) as [number, number][];
          const [a, b, c] = corners.map(([row, column]) => at(row, column)) as [
            Triple,
            Triple,
            Triple,
          ];
          const front = cross(less(b, a), less(c, a));
          if (size(front) < 1e-9) continue;
          const mean = corners.reduce<Triple>(
            (sum, [row, column]) => plus(sum, normals[row]?.[column] ?? [0, 0, 0]),
            [0, 0, 0],
          );
          const ordered = inner(front, mean) < 0 ? corners.toReversed() : corners;
          for (const [row, column] of ordered)
            this.corner(at(row, column), normals[row]?.[column] ?? [0, 1, 0], colour);
        }
      }
  }
}
