/**
 * The axes of the picture, as `three` has them: x to the east, y up, z to the south, in metres about an origin near the ship, so
 * that single-precision numbers keep millimetres. Aboard a ship x is to starboard, y up and z astern.
 */
import type { Pair } from "../protocol";

/** A place in the axes of the picture, or aboard a ship [m]. */
export type Triple = [x: number, y: number, z: number];

/** A place [north, east] on the earth at a height above the still water [m], in the axes of the picture. */
export const toPicture = (origin: Pair, [north, east]: Pair, up_m: number): Triple => [
  east - origin[1],
  up_m,
  origin[0] - north,
];

/** A place [forward, starboard] aboard at a height above the waterline [m], in the axes of the ship. */
export const aboard = ([forward, starboard]: Pair, up_m: number): Triple => [
  starboard,
  up_m,
  -forward,
];

export const plus = (a: Triple, b: Triple): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const less = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Triple, by: number): Triple => [a[0] * by, a[1] * by, a[2] * by];
export const inner = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const size = (a: Triple): number => Math.hypot(...a);

/** The vector of length 1 in the same direction; a vector of no length stays. */
export const unit = (a: Triple): Triple => {
  const long = size(a);
  return long > 0 ? scaled(a, 1 / long) : a;
};

/** From `a` to `b` by a share. */
export const mixed = (a: Triple, b: Triple, share: number): Triple =>
  plus(a, scaled(less(b, a), share));

/** 0 below `from`, 1 above `to`, smooth between. */
export function smooth(from: number, to: number, value: number): number {
  const share = Math.min(1, Math.max(0, (value - from) / (to - from)));
  return share * share * (3 - 2 * share);
}
