/** The form of a line between two places: a catenary, by the line's length or by its tension. */
import { type Triple, less } from "./axes";

/** Pieces into which the picture divides a line. */
export const PIECES = 28;
/** Gravity [m/s²]. */
const G = 9.80665;

/**
 * Parameter of the catenary of a given length between two places: horizontal tension over weight per length [m]. `null` if the
 * length is no more than the distance, so that the line is straight. Newton's method on x = span / (2 a), with
 * sinh(x) / x = √(length² − rise²) / span.
 */
export function parameterByLength(span_m: number, rise_m: number, length_m: number): number | null {
  const free2 = length_m ** 2 - rise_m ** 2;
  if (span_m < 1e-6 || free2 <= (span_m * 1.000001) ** 2) return null;
  const ratio = Math.sqrt(free2) / span_m;
  // Below about 3 the series is near, above it the logarithm.
  let x =
    ratio < 3 ? Math.sqrt(6 * (ratio - 1)) : Math.log(2 * ratio) + Math.log(Math.log(2 * ratio));
  for (let i = 0; i < 50; i++) {
    const error = Math.sinh(x) / x - ratio;
    const slope = (x * Math.cosh(x) - Math.sinh(x)) / x ** 2;
    const next = Math.max(x / 2, x - error / slope);
    if (Math.abs(next - x) < 1e-12 * x) break;
    x = next;
  }
  return span_m / (2 * x);
}

/** Weight of a rope by its breaking load [N/m]. A rope of 1 MN weighs about 4 kg/m: from memory, between steel and fibre. */
export const weightOf = (breaking_n: number): number => ((4 * breaking_n) / 1e6) * G;

export interface Hanging {
  tension_n: number;
  /** Length of the line that is out [m]; `null` if unknown. */
  length_m: number | null;
  weight_npm: number;
}

/**
 * Places along a line from `from` to `to`, both included. A line with tension hangs as its tension says, a slack line as its
 * length says. A tension so small that the line would hang lower than its length allows does not count.
 */
export function catenary(from: Triple, to: Triple, line: Hanging, pieces: number): Triple[] {
  const [east, rise_m, south] = less(to, from);
  const span_m = Math.hypot(east, south);
  const at = (i: number): [share: number, straight: Triple] => {
    const share = i / pieces;
    return [share, [from[0] + east * share, from[1] + rise_m * share, from[2] + south * share]];
  };
  const straight = () => Array.from({ length: pieces + 1 }, (_, i) => at(i)[1]);
  const distance_m = Math.hypot(span_m, rise_m);
  if (span_m < 0.05 || distance_m < 1e-6) return hangingDown(from, to, line, pieces);
  const taut_m = (line.tension_n / line.weight_npm) * (span_m / distance_m);
  // A line that is stretched is longer than the message says.
  const slack_m = line.length_m === null ? null : parameterByLength(span_m, rise_m, line.length_m);
  const parameter_m = Math.max(taut_m, slack_m ?? 0);
  if (parameter_m <= 0 || (slack_m === null && line.length_m !== null && taut_m <= 0))
    return straight();
  if (parameter_m > 1e5 * span_m) return straight();
  // y = a cosh((x − m) / a) + c with the lowest point at m.
  const a = parameter_m;
  const lowest_m = span_m / 2 - a * Math.asinh(rise_m / (2 * a * Math.sinh(span_m / (2 * a))));
  // a (cosh u − 1), written so that a taut line loses no digits.
  const height = (x_m: number) => 2 * a * Math.sinh((x_m - lowest_m) / (2 * a)) ** 2;
  const first = height(0);
  return Array.from({ length: pieces + 1 }, (_, i): Triple => {
    const [share, [x, , z]] = at(i);
    return [x, from[1] + height(span_m * share) - first, z];
  });
}

/** A line as it lies on a quay: no place of the line that is over the quay is below the quay's top. */
export const draped = (
  points: Triple[],
  isOverQuay: (at: Triple) => boolean,
  top_m: number,
): Triple[] => points.map((at) => (at[1] < top_m && isOverQuay(at) ? [at[0], top_m, at[2]] : at));

/** A line whose ends are above each other hangs down as a loop. */
function hangingDown(from: Triple, to: Triple, line: Hanging, pieces: number): Triple[] {
  const rise_m = to[1] - from[1];
  const spare_m = Math.max(0, ((line.length_m ?? 0) - Math.abs(rise_m)) / 2);
  const low = Math.min(from[1], to[1]) - (line.tension_n > 0 ? 0 : spare_m);
  const way = Math.max(1e-9, from[1] - low + (to[1] - low));
  return Array.from({ length: pieces + 1 }, (_, i): Triple => {
    const gone = (way * i) / pieces;
    const down = from[1] - low;
    const share = i / pieces;
    return [
      from[0] + (to[0] - from[0]) * share,
      gone < down ? from[1] - gone : low + gone - down,
      from[2] + (to[2] - from[2]) * share,
    ];
  });
}
