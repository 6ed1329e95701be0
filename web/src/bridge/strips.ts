/** Strips along the lines of a chart: a line has no width, and what the line stands for has. */
import { add, dot, length, minus, times } from "../geometry";
import type { Pair } from "../protocol";

/** A quadrilateral for each segment of a line that has a width. */
export interface Strip {
  ring: Pair[];
  /** The segment along which the strip runs. */
  from: Pair;
  to: Pair;
}

/** How far a strip reaches from a segment: first to the side of `normalOf`, then to the other side [m]. */
export type Reach = [near_m: number, far_m: number];

/** Shortest segment that gets a strip [m]. */
const SHORTEST_M = 0.05;
/** Strips of two segments meet in common corners if the cosine of the turn between them is greater than this. */
const JOINED_COSINE = 0.5;

/** The normal of a segment, a quarter turn from its direction from north to east. */
export const normalOf = (from: Pair, to: Pair): Pair => {
  const [n, e] = minus(to, from);
  return times([-e, n], 1 / Math.hypot(n, e));
};

/**
 * The strips along a line, as the run makes lines solid (`crates/charts/src/shore/strip.rs`). `reachOf`: how far the strip of a
 * segment reaches; `null`: the segment gets no strip.
 */
export function stripsAlong(
  line: Pair[],
  reachOf: (from: Pair, to: Pair) => Reach | null,
): Strip[] {
  const points: Pair[] = [];
  for (const at of line) {
    const last = points.at(-1);
    if (!last || length(minus(at, last)) >= SHORTEST_M) points.push(at);
  }
  const segments = points.slice(1).map((to, i) => {
    const from = points[i] ?? to;
    return { from, to, normal: normalOf(from, to), reach: reachOf(from, to) };
  });
  type Segment = (typeof segments)[number];
  /** The direction across the line at an end of a segment, whose length makes the strip as wide as along the segment. */
  const across = (of: Segment, beside: Segment | undefined): Pair => {
    if (!beside || !of.reach || !beside.reach) return of.normal;
    const wide = of.reach[0] + of.reach[1];
    const isLong = (each: Segment) => length(minus(each.to, each.from)) > 2 * wide;
    const cosine = dot(of.normal, beside.normal);
    return cosine > JOINED_COSINE && isLong(of) && isLong(beside)
      ? times(add(of.normal, beside.normal), 1 / (1 + cosine))
      : of.normal;
  };
  return segments.flatMap((of, i): Strip[] => {
    const { from, to, reach } = of;
    if (!reach) return [];
    const [begin, end] = [across(of, segments[i - 1]), across(of, segments[i + 1])];
    const ring = [
      add(from, times(begin, -reach[1])),
      add(to, times(end, -reach[1])),
      add(to, times(end, reach[0])),
      add(from, times(begin, reach[0])),
    ];
    return [{ ring, from, to }];
  });
}
