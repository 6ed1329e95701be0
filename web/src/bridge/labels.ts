/** Where labels stand in the picture: none under the words over the picture, and none on another. */
import type { Label } from "./in_picture";
import type { Pair } from "../protocol";

/** A label in the picture; `x`: its middle, `y`: its lower edge, from the upper left corner of the picture [px]. */
export interface Placed extends Pick<Label, "text" | "level"> {
  x: number;
  y: number;
}

/** Width and height of a label, about [px]. */
export const LABEL_PX: Pair = [90, 24];
const LEVELS: Record<Label["level"], number> = { plain: 0, caution: 1, alarm: 2 };

/**
 * The labels that are written. A label that would lie under the words is below them. Of labels that lie on each other the gravest
 * is written. `wordsTo`: right and lower edge of the words [px].
 */
export function placed(labels: Placed[], [right, bottom]: Pair): Placed[] {
  const [wide, high] = LABEL_PX;
  const shown: Placed[] = [];
  for (const label of labels.toSorted((a, b) => LEVELS[b.level] - LEVELS[a.level])) {
    const isUnder = label.x - wide / 2 < right && label.y - high < bottom;
    const moved = isUnder ? { ...label, y: bottom + high } : label;
    if (shown.every(({ x, y }) => Math.abs(x - moved.x) > wide || Math.abs(y - moved.y) > high))
      shown.push(moved);
  }
  return shown;
}
