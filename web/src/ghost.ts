/** The measured ship beside the simulated ones: where she is, and her words. */
import type { Ghost, PathPoint } from "./protocol";
import { clock, spoken, wrapped } from "./units";

/** Where the measured ship is: straight between the points around the time; before the first and after the last she waits there. */
export function ghostAt({ points }: Ghost, t_s: number): PathPoint | null {
  let [low, high] = [0, points.length - 1];
  const [first, last] = [points[low], points[high]];
  if (!first || !last || t_s <= first[0]) return first ?? null;
  if (t_s >= last[0]) return last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((points[middle]?.[0] ?? Infinity) <= t_s) low = middle;
    else high = middle;
  }
  const [from, to] = [points[low] ?? first, points[high] ?? last];
  const share = (t_s - from[0]) / (to[0] - from[0]);
  return [
    t_s,
    from[1] + share * (to[1] - from[1]),
    from[2] + share * (to[2] - from[2]),
    from[3] + share * wrapped(to[3] - from[3]),
  ];
}

/** Whom the outline shows, and when. */
export function ghostText({ ship, points, touch_s }: Ghost, t_s: number): string {
  const name = ship ? `measured ${spoken(ship)}` : "measured";
  const [first_s, last_s] = [points[0]?.[0] ?? 0, points.at(-1)?.[0] ?? 0];
  if (t_s < first_s) return `${name}: begins in ${clock(first_s - t_s)}`;
  if (t_s > last_s) return `${name}: the log has ended`;
  if (touch_s === null) return `${name}: ${clock(t_s - first_s)} since the start of the log`;
  return t_s < touch_s
    ? `${name}: touch in ${clock(touch_s - t_s)}`
    : `${name}: touched ${clock(t_s - touch_s)} ago`;
}
