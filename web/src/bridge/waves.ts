/**
 * The surface of the sea: the sum of the run's own harmonics, so that the water at the hull is the water that moves her. A
 * machine without a graphics card draws the strongest harmonics alone.
 */
import type { Wave } from "../protocol";

/** Harmonics that a machine without a graphics card draws. */
export const FEW = 128;

/** Height of the surface above the still water at a place and a time [m]. */
export const surface = (sea: Wave[], north_m: number, east_m: number, t_s: number): number =>
  sea.reduce(
    (sum, [a, north, east, omega, phase]) =>
      sum + a * Math.cos(omega * t_s - north * north_m - east * east_m + phase),
    0,
  );

/** Significant height: four times the root of the variance [m]. */
export const significant = (sea: Wave[]): number =>
  4 * Math.sqrt(sea.reduce((sum, [a]) => sum + a ** 2 / 2, 0));

const number = ([, north, east]: Wave): number => Math.hypot(north, east);

/** The strongest harmonics, the longest first: far from the eye the shorter ones are left out. */
export const drawnOf = (sea: Wave[], most: number): Wave[] =>
  sea
    .toSorted((a, b) => b[0] - a[0])
    .slice(0, most)
    .toSorted((a, b) => number(a) - number(b));
