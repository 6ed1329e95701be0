/**
 * Places the labels of a drawing so that none lies over another: the most important first, each where it belongs if that
 * is free, else beside it, else farther away with a leader; what finds no room is left out if it may be.
 */
import type { Pair } from "../protocol";

/** [left, top, width, height], px. */
export type Box = [number, number, number, number];

/** Which labels are placed first; those from `Bollard` on are left out where there is no room near their point. */
export enum Rank {
  Speed,
  Distance,
  Parted,
  Fender,
  Tug,
  Measure,
  Line,
  Anchor,
  Bollard,
  Minute,
  Detail,
}

export interface Label {
  /** The same from drawing to drawing, so that a label keeps its place. */
  key: string;
  text: string;
  rank: Rank;
  /** The point that it is about. */
  at: Pair;
  /** From that point to the middle of the label where it belongs; above it if there is none. */
  off?: Pair;
  colour: string;
  size: number;
  bold?: boolean;
  /** Drawn although its point is off the canvas by up to `NEAR_PX`. */
  clamped?: boolean;
}

export interface Placed {
  label: Label;
  box: Box;
  /** Number of its place among those that were tried. */
  place: number;
  /** It is away from its point: a line leads there. */
  leads: boolean;
}

/** A clamped label is drawn while its point is off the canvas by no more than this. */
const NEAR_PX = 60;
/** Distance of a label's edge from its point. */
const BESIDE_PX = 6;
/** Distances with a leader, for what is not left out. */
const AWAY_PX = [22, 44, 70, 105];
const MARGIN_PX = 2;
const DIRECTIONS: Pair[] = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [
  Math.sin((i * Math.PI) / 4),
  -Math.cos((i * Math.PI) / 4),
]);

export const overlap = (a: Box, b: Box): boolean =>
  a[0] < b[0] + b[2] && b[0] < a[0] + a[2] && a[1] < b[1] + b[3] && b[1] < a[1] + a[3];

/** The size of a label's box. */
const sizeOf = (label: Label, width: (label: Label) => number): Pair => [
  width(label) + 8,
  label.size + 6,
];

/** Where the middle of a label may be, in the order of preference, as offsets from its point. */
function* places(label: Label, [w, h]: Pair): Generator<{ off: Pair; leads: boolean }> {
  const wanted: Pair = label.off ?? [0, -(h / 2 + BESIDE_PX)];
  yield { off: wanted, leads: false };
  const length = Math.hypot(...wanted) || 1;
  const toward = ([x, y]: Pair) => (x * wanted[0] + y * wanted[1]) / length;
  // The nearest to the wanted direction first; the sort keeps the order of equals.
  const directions = DIRECTIONS.toSorted((a, b) => toward(b) - toward(a));
  const gaps = [BESIDE_PX, ...(label.rank >= Rank.Bollard ? [] : AWAY_PX)];
  for (const [i, gap] of gaps.entries())
    for (const [x, y] of directions)
      yield { off: [x * (w / 2 + gap), y * (h / 2 + gap)], leads: i > 0 };
}

function boxAt(label: Label, [w, h]: Pair, off: Pair, area: Pair): Box | null {
  const box: Box = [label.at[0] + off[0] - w / 2, label.at[1] + off[1] - h / 2, w, h];
  if (label.clamped) {
    box[0] = Math.min(area[0] - w - MARGIN_PX, Math.max(MARGIN_PX, box[0]));
    box[1] = Math.min(area[1] - h - MARGIN_PX, Math.max(MARGIN_PX, box[1]));
    return box;
  }
  const inside = box[0] >= 0 && box[1] >= 0 && box[0] + w <= area[0] && box[1] + h <= area[1];
  return inside ? box : null;
}

/**
 * Places labels on a canvas of the size `area`. `taken`: boxes that are kept free. `before`: by key, the place of each
 * label in the drawing before, which it keeps while that is free. `width`: the width of a label's text (px).
 */
export function place(
  labels: readonly Label[],
  area: Pair,
  taken: readonly Box[],
  before: ReadonlyMap<string, number>,
  width: (label: Label) => number,
): Placed[] {
  const done: Placed[] = [];
  const boxes = [...taken];
  const sorted = labels.toSorted((a, b) => a.rank - b.rank);
  for (const label of sorted) {
    const slack = label.clamped ? NEAR_PX : 0;
    const [x, y] = label.at;
    if (x < -slack || y < -slack || x > area[0] + slack || y > area[1] + slack) continue;
    const size = sizeOf(label, width);
    const free = (off: Pair): Box | null => {
      const box = boxAt(label, size, off, area);
      return box && !boxes.some((other) => overlap(box, other)) ? box : null;
    };
    const last = before.get(label.key) ?? 0;
    const found =
      (last > 0 && first(places(label, size), free, last)) || first(places(label, size), free);
    if (!found) continue;
    boxes.push(found.box);
    done.push({ label, ...found });
  }
  return done;
}

/** The first place that is free; `only`: the place of that number, if it is free. */
function first(
  tried: Generator<{ off: Pair; leads: boolean }>,
  free: (off: Pair) => Box | null,
  only?: number,
): Omit<Placed, "label"> | null {
  let index = 0;
  for (const { off, leads } of tried) {
    const box = only === undefined || only === index ? free(off) : null;
    if (box) return { box, place: index, leads };
    if (only === index) return null;
    index += 1;
  }
  return null;
}

/** The end of a leader: the point of a box that is nearest to another point. */
export const nearest = ([left, top, w, h]: Box, [x, y]: Pair): Pair => [
  Math.min(left + w, Math.max(left, x)),
  Math.min(top + h, Math.max(top, y)),
];
