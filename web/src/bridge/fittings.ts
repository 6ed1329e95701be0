/** Small parts that ships and tugs share: paint, rows of windows, railings. */
import { type Colour, Solids, type Spot } from "./solids";
import type { Pair } from "../protocol";

const RAIL = 0xd9dcda;

export interface Paint {
  bottom: Colour;
  side: Colour;
  deck: Colour;
  house: Colour;
  funnel: Colour;
}

/** A share from 0 to 1 that depends only on the numbers, so that each ship looks alike each time. */
export function chance(...of: number[]): number {
  let h = 2166136261;
  for (const n of of) h = Math.imul(h ^ Math.round(n * 64), 16777619) ^ (h >>> 13);
  return ((h ^ (h >>> 15)) >>> 0) / 4294967296;
}

export interface Parts {
  painted: Solids;
  /** Panes of windows, which are lit at night. */
  panes: Solids;
}

/** A band of windows round a wall: `panes` get panes, the wall keeps mullions between. */
export function windowBand(
  panes: Solids,
  from: Pair,
  to: Pair,
  outward: Pair,
  [low, high]: Pair,
  { wide = 1.2, gap = 0.35, colour = 0x18242c } = {},
): void {
  const long = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const count = Math.max(1, Math.floor((long - gap) / (wide + gap)));
  const pitch = long / count;
  for (let i = 0; i < count; i++) {
    const spot = (far: number, up: number): Spot => [
      from[0] + ((to[0] - from[0]) * far) / long + outward[0] * 0.04,
      from[1] + ((to[1] - from[1]) * far) / long + outward[1] * 0.04,
      up,
    ];
    const [a, b] = [pitch * i + gap / 2, pitch * (i + 1) - gap / 2];
    panes.face([spot(a, low), spot(b, low), spot(b, high), spot(a, high)], [...outward, 0], colour);
  }
}

/** A railing along a path: posts, and two bars. */
export function railing(to: Solids, path: Spot[], height = 1.1, colour: Colour = RAIL): void {
  for (let i = 0; i + 1 < path.length; i++) {
    const [a, b] = [path[i], path[i + 1]];
    if (!a || !b) continue;
    for (const share of [0.5, 1])
      to.post(
        [a[0], a[1], a[2] + height * share],
        [b[0], b[1], b[2] + height * share],
        0.03,
        colour,
        { sides: 3, caps: false },
      );
    const long = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const posts = Math.max(1, Math.round(long / 2.5));
    for (let k = 0; k <= posts; k++) {
      const at = (j: 0 | 1 | 2) => a[j] + ((b[j] - a[j]) * k) / posts;
      to.post([at(0), at(1), at(2)], [at(0), at(1), at(2) + height], 0.03, colour, {
        sides: 3,
        caps: false,
      });
    }
  }
}
