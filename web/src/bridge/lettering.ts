/**
 * What is painted on a hull: her name at both bows and on the transom, and her draught marks at stem, midship and stern. Each letter
 * is a quad that lies on the plating.
 */
import type { Arrangement } from "./arrangement";
import type { Hull } from "./hull";
import type { Spot } from "./solids";

/** A letter and its corners: lower left, lower right, upper right, upper left, as somebody reads it [m]. */
export interface Letter {
  character: string;
  corners: [Spot, Spot, Spot, Spot];
}

/** Width of a character over its height. */
export type WidthOf = (character: string) => number;

/** Characters of draught marks. */
export const FIGURES = "0123456789M";

/**
 * Draught marks (their form is from memory, not from a source): figures 0.1 m high at each 0.2 m of draught, whole metres with
 * an M; the lower edge of a figure is at the draught that the figure names.
 */
const FIGURE_M = 0.1;
const BETWEEN_M = 0.2;
/** How far below and above the draught at rest the marks reach [m]. */
const BELOW_M = 3;
const ABOVE_M = 4;
/** How far letters stand off the plating, so that the plates' flat parts do not cover them [m]. */
const OFF_M = 0.06;
/** Steps towards a station. */
const STEPS = 12;
/** Height of a name over the length of the ship, and its limits [m]. */
const NAME_SHARE = 0.008;
const NAME_LEAST_M = 0.45;
const NAME_MOST_M = 1.6;

/** The name as it is painted: capitals, and words apart. */
export const painted = (name: string): string => name.replaceAll("_", " ").toUpperCase().trim();

/** All letters of a ship with a name. */
export function letteringOf(ship: Arrangement, name: string, widthOf: WidthOf): Letter[] {
  return [
    ...bows(ship, painted(name), widthOf),
    ...transom(ship, painted(name), widthOf),
    ...marks(ship, widthOf),
  ];
}

const widthOfAll = (text: string, widthOf: WidthOf): number =>
  [...text].reduce((sum, character) => sum + widthOf(character), 0);

/** Letters of a text about its middle; `at` gives the place of a way along the text and a height above its foot [m]. */
function written(
  text: string,
  high_m: number,
  widthOf: WidthOf,
  at: (along_m: number, up_m: number) => Spot,
): Letter[] {
  let from = -0.5 * high_m * widthOfAll(text, widthOf);
  return [...text].flatMap((character): Letter[] => {
    const [left, right] = [from, from + high_m * widthOf(character)];
    from = right;
    if (character === " ") return [];
    return [
      { character, corners: [at(left, 0), at(right, 0), at(right, high_m), at(left, high_m)] },
    ];
  });
}

/**
 * A place on the plating of a side, a little off it. Who reads from outside sees the bow at the right of the starboard side. The
 * plating leans at the ends: a few steps find the station that has this place, so that letters stand upright.
 */
function onSide(hull: Hull, forward_m: number, up_m: number, side: 1 | -1): Spot {
  let station = forward_m;
  for (let i = 0; i < STEPS; i++) station += forward_m - hull.side(station, up_m, side)[0];
  const [forward, starboard, up] = hull.side(station, up_m, side);
  return [forward, starboard + side * OFF_M, up];
}

/** The name at both bows, below the deck's edge; on a tug's bulwark, over her fendering. */
function bows(ship: Arrangement, name: string, widthOf: WidthOf): Letter[] {
  const { hull, length_m, kind } = ship;
  const wide = Math.max(1, widthOfAll(name, widthOf));
  const middle = hull.aft_m + (kind === "tug" ? 0.66 : 0.9) * length_m;
  const most = Math.min(NAME_MOST_M, Math.max(NAME_LEAST_M, NAME_SHARE * length_m));
  // A long name becomes smaller, so that it ends before the stem.
  const high = Math.min(most, (0.12 * length_m) / wide);
  const half = 0.5 * high * wide;
  const deck = Math.min(hull.deck_m(middle - half), hull.deck_m(middle + half));
  const foot = kind === "tug" ? deck + 0.2 : deck - 0.6 - high;
  return ([1, -1] as const).flatMap((side) =>
    written(name, high, widthOf, (along, up) =>
      onSide(hull, middle + side * along, foot + up, side),
    ),
  );
}

/** The name on the transom, where there is room. */
function transom({ hull, length_m, kind }: Arrangement, name: string, widthOf: WidthOf): Letter[] {
  const wide = Math.max(1, widthOfAll(name, widthOf));
  const deck = hull.deck_m(hull.aft_m);
  const [, half] = hull.side(hull.aft_m, deck, 1);
  const [, other] = hull.side(hull.aft_m, deck, -1);
  const room = half - other;
  const most = Math.min(NAME_MOST_M, Math.max(NAME_LEAST_M, NAME_SHARE * length_m));
  const high = Math.min(0.75 * most, (0.7 * room) / wide, 0.3 * deck);
  if (high < 0.25) return [];
  const foot = kind === "tug" ? deck + 0.2 : deck - 0.7 - high;
  // Who reads from astern has starboard at the right.
  return written(name, high, widthOf, (along, up) => {
    const [forward] = hull.side(hull.aft_m, foot + up, 1);
    return [forward - OFF_M, 0.5 * (half + other) + along, foot + up];
  });
}

/** The draughts that have a figure, and the figures [m]. */
export function figuresAbout(draught_m: number, most_m: number): [number, string][] {
  const found: [number, string][] = [];
  const last = Math.round(Math.min(draught_m + ABOVE_M, most_m) / BETWEEN_M);
  for (let i = Math.max(1, Math.ceil((draught_m - BELOW_M) / BETWEEN_M)); i <= last; i++) {
    const tenths = 2 * i;
    found.push([tenths / 10, tenths % 10 === 0 ? `${tenths / 10}M` : String(tenths % 10)]);
  }
  return found;
}

/** Draught marks on both sides at stem, midship and stern; a tug has none amidships, where tyres hang. */
function marks({ hull, length_m, kind }: Arrangement, widthOf: WidthOf): Letter[] {
  const { draught_m, freeboard_m } = hull.form;
  const shares = kind === "tug" ? [0.05, 0.96] : [0.035, 0.5, 0.97];
  // Below the name and a tug's fendering.
  const most = draught_m + 0.55 * freeboard_m;
  return shares.flatMap((share) =>
    figuresAbout(draught_m, most).flatMap(([depth, text]) =>
      ([1, -1] as const).flatMap((side) =>
        written(text, FIGURE_M, widthOf, (along, up) => {
          // The column of figures follows the stem.
          const foot = depth - draught_m;
          const [middle] = hull.side(hull.aft_m + share * length_m, foot, side);
          return onSide(hull, middle + side * along, foot + up, side);
        }),
      ),
    ),
  );
}
