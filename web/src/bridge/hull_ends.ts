import type { Pair } from "../protocol";

/** Ends of an outline: aftmost and foremost [m]. */
export function ends(outline: Pair[]): Pair {
  const all = outline.map(([forward]) => forward);
  return [Math.min(...all), Math.max(...all)];
}
