/** Plane geometry: positions of bodies on the earth, and the plan's camera. */
import type { BodyNow, Pair } from "./protocol";
import { wrapped } from "./units";

export const add = (a: Pair, b: Pair): Pair => [a[0] + b[0], a[1] + b[1]];
export const minus = (a: Pair, b: Pair): Pair => [a[0] - b[0], a[1] - b[1]];
export const times = (a: Pair, by: number): Pair => [a[0] * by, a[1] * by];
export const dot = (a: Pair, b: Pair): number => a[0] * b[0] + a[1] * b[1];
export const length = (a: Pair): number => Math.hypot(a[0], a[1]);

export const clamp = (value: number, least: number, most: number): number =>
  Math.min(most, Math.max(least, value));

/** Turns by an angle, positive to starboard: from body axes to earth axes. */
export function turned(by_rad: number, [x, y]: Pair): Pair {
  const [c, s] = [Math.cos(by_rad), Math.sin(by_rad)];
  return [x * c - y * s, x * s + y * c];
}

/** The earth-fixed position of a body-fixed point. */
export const onEarth = (body: BodyNow, at: Pair): Pair =>
  add([body[0], body[1]], turned(body[2], at));

/** The place on a straight line from `a` to `b` that is nearest to a place. */
export function nearestOn(a: Pair, b: Pair, at: Pair): Pair {
  const along = minus(b, a);
  const share = dot(minus(at, a), along) / (dot(along, along) || 1);
  return add(a, times(along, clamp(share, 0, 1)));
}

/** A body between two ticks; its heading turns the short way. */
export function between(from: BodyNow, to: BodyNow, share: number): BodyNow {
  const mix = (a: number, b: number) => a + (b - a) * share;
  return [
    mix(from[0], to[0]),
    mix(from[1], to[1]),
    from[2] + wrapped(to[2] - from[2]) * share,
    mix(from[3], to[3]),
    mix(from[4], to[4]),
    mix(from[5], to[5]),
  ];
}

/** The part of the earth that the plan shows. */
export interface Camera {
  centre: Pair;
  pixels_per_m: number;
  /** The bearing at the top of the screen [rad]. */
  up_rad: number;
  width: number;
  height: number;
}

export function toScreen(camera: Camera, place: Pair): Pair {
  const [ahead, right] = turned(-camera.up_rad, minus(place, camera.centre));
  return [
    camera.width / 2 + right * camera.pixels_per_m,
    camera.height / 2 - ahead * camera.pixels_per_m,
  ];
}

export function toEarth(camera: Camera, [x, y]: Pair): Pair {
  const ahead = (camera.height / 2 - y) / camera.pixels_per_m;
  const right = (x - camera.width / 2) / camera.pixels_per_m;
  return add(camera.centre, turned(camera.up_rad, [ahead, right]));
}

/** The camera zoomed by a factor about a point of the screen, which keeps its place on the earth. */
export function zoomed(camera: Camera, by: number, about: Pair): Camera {
  const pixels_per_m = Math.min(60, Math.max(0.01, camera.pixels_per_m * by));
  const place = toEarth(camera, about);
  const after = { ...camera, pixels_per_m };
  return { ...after, centre: add(after.centre, minus(place, toEarth(after, about))) };
}

/** The camera that shows all points, with margins in pixels above, at the sides and below. */
export function fitted(
  camera: Camera,
  places: Pair[],
  [above, sides, below]: [number, number, number],
): Camera {
  const local = places.map((place) => turned(-camera.up_rad, place));
  const range = (axis: 0 | 1): Pair => {
    const all = local.map((p) => p[axis]);
    return [Math.min(...all), Math.max(...all)];
  };
  if (local.length === 0) return camera;
  const [ahead, right] = [range(0), range(1)];
  const pixels_per_m = Math.min(
    20,
    Math.max(40, camera.width - 2 * sides) / Math.max(1, right[1] - right[0]),
    Math.max(40, camera.height - above - below) / Math.max(1, ahead[1] - ahead[0]),
  );
  const lower = (above - below) / 2 / pixels_per_m;
  const middle: Pair = [(ahead[0] + ahead[1]) / 2 + lower, (right[0] + right[1]) / 2];
  return { ...camera, pixels_per_m, centre: turned(camera.up_rad, middle) };
}

/** The places that are near one, and their mirror images about it, so that it is in the middle of them. */
export function around(middle: Pair, places: Pair[], near_m: number): Pair[] {
  const near = places.filter((place) => length(minus(place, middle)) <= near_m);
  return near.flatMap((place) => [place, add(middle, minus(middle, place))]);
}

/** The largest round length (1, 2 or 5 times a power of ten) for a scale bar of at most this many metres. */
export function roundLength(most_m: number): number {
  const power = 10 ** Math.floor(Math.log10(most_m));
  return [5, 2, 1].map((n) => n * power).find((n) => n <= most_m) ?? power;
}
