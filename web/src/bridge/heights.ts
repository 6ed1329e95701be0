/** Heights that the view gives to land and quays: charts and many scenarios have outlines without heights. */
import { BIGHT_M, QUAY_M, isDolphin } from "./berth";
import type { Hello, Pair } from "../protocol";

/** Heights above datum of what has no height of its own [m]. */
export interface Heights {
  quay_m: number;
  /** Level ground, which lies a step below quays. */
  ground_m: number;
}

/** A fixed body on the earth, with the height of its deck above datum [m]. */
export interface Fixed {
  ring: Pair[];
  deck_m: number;
}

/** Where land and structures of a chart are drawn. */
export interface Site {
  fixed: Fixed[];
  /** All places are moved by the origin. */
  origin: Pair;
  heights: Heights;
  /** Level above datum from which the chart gives clearances [m]. */
  high_water_m: number;
}

/** Quays of the chart lie a hand below decks of bodies, so that two tops at one place do not flicker [m]. */
export const BELOW_DECKS_M = 0.05;

/** A quay stands at least so high above the highest water of the run [m]. */
const OVER_WATER_M = 2;
const STEP_M = 0.5;

/** Height of a deck under the lowest of its bollards and line ends [m]; `null`: the run has no height of them. */
export function deckUnder(heights: number[]): number | null {
  const given = heights.filter((height) => height !== 0);
  return given.length > 0 ? Math.max(0.5, Math.min(...given) - BIGHT_M) : null;
}

/**
 * Height of the deck of a fixed body above datum [m]: under its lowest bollard or line end of which the run has a height, or
 * over its highest panel. `heights`: those of bollards and line ends; `tops`: upper edges of panels.
 */
export const deckHeight = (heights: number[], tops: number[], quay_m: number): number =>
  deckUnder(heights) ?? Math.max(quay_m, ...tops.map((top) => top + 0.2));

/** Heights of bollards and line ends on a body above datum, 0 where the run has none [m]. */
export function endsOn({ bollards, lines }: Pick<Hello, "bollards" | "lines">, body: number) {
  const ends = lines.flatMap(({ end }) => (end && "body" in end ? [end] : []));
  return [...bollards, ...ends].filter((end) => end.body === body).map((end) => end.above_water_m);
}

/**
 * The run's water never covers land and quays, and both are no lower than the lowest quay of which the run has a height:
 * `decks`, see `knownQuays`.
 */
export function heightsOf(highest_water_m: number, decks: number[]): Heights {
  const lowest = decks.length > 0 ? Math.min(...decks) : QUAY_M;
  const quay_m = Math.max(QUAY_M, highest_water_m + OVER_WATER_M, lowest);
  return { quay_m, ground_m: quay_m - STEP_M };
}

/** Heights of the decks of quays of which the run has a height [m]. Dolphins stand as high as their ships need. */
export const knownQuays = (hello: Pick<Hello, "bodies" | "bollards" | "lines">): number[] =>
  hello.bodies.flatMap(({ fixed, outline }, body) => {
    if (!fixed || (outline.length > 0 && isDolphin(outline))) return [];
    return deckUnder(endsOn(hello, body)) ?? [];
  });
