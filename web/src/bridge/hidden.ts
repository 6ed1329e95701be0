/** Which places hulls and houses hide from the eye: words of the marks are not written there. */
import type { Arrangement } from "./arrangement";
import type { Triple } from "./axes";
import { inset, isInside } from "./berth";
import { baysOf, hiddenBelow_m } from "./containers";
import type { Pair } from "../protocol";

/** An upright block in the axes of a ship: its outline [forward, starboard], and the height of its roof [m]. */
export interface Block {
  outline: Pair[];
  roof_m: number;
}

/** A block is so much narrower than what it stands for, so that a place at the ship's side is not within it [m]. */
const NARROWER_M = 1;

/** The hull up to the deck, the house up to the bridge deck, and the cargo of a container ship. */
export function blocksOf(ship: Arrangement): Block[] {
  const { hull, deck_m, house, kind } = ship;
  const { aft_m, fore_m, half_m, bridge_deck_m } = house;
  const bays = kind === "container" ? baysOf(ship) : [];
  return [
    { outline: inset(hull.form.outline, NARROWER_M), roof_m: deck_m },
    {
      outline: [
        [aft_m, -half_m],
        [fore_m, -half_m],
        [fore_m, half_m],
        [aft_m, half_m],
      ],
      roof_m: bridge_deck_m - 0.3,
    },
    ...bays.map((bay): Block => {
      const half = bay.half_m - NARROWER_M;
      return {
        outline: [
          [bay.aft_m, -half],
          [bay.fore_m, -half],
          [bay.fore_m, half],
          [bay.aft_m, half],
        ],
        roof_m: hiddenBelow_m(bay),
      };
    }),
  ];
}

/** Whether a block stands between an eye and a place; both in the axes of the ship. */
export function hides({ outline, roof_m }: Block, eye: Triple, at: Triple): boolean {
  const [high, low] = eye[1] > at[1] ? [eye, at] : [at, eye];
  if (low[1] >= roof_m) return false;
  // The part of the way that is below the roof.
  const share = high[1] <= roof_m ? 1 : (roof_m - low[1]) / (high[1] - low[1]);
  const from: Pair = [-low[2], low[0]];
  const to: Pair = [-low[2] - share * (high[2] - low[2]), low[0] + share * (high[0] - low[0])];
  if (isInside(outline, from) || isInside(outline, to)) return true;
  return outline.some((corner, i) => cross(from, to, corner, outline[(i + 1) % outline.length]));
}

/** Whether two straight ways cross. */
function cross(a: Pair, b: Pair, c: Pair, d: Pair = c): boolean {
  const side = (p: Pair, q: Pair, r: Pair) =>
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}
