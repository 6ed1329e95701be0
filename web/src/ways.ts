/** The way of a ship to her berth, from farther away than the line of its fenders tells. */
import { dot, length, minus, nearestOn, onEarth } from "./geometry";
import type { BodyNow, Frame, Hello, Pair, VesselInfo } from "./protocol";

/** Way from an end of a ship to the nearest place of the berth. */
export interface Way {
  off_m: number;
  /** From north [rad]. */
  bearing_rad: number;
  /** Speed of the ship along this bearing [m/s]. */
  closing_mps: number;
}

/**
 * Ways from bow and stern to the berth, if the ship is farther than a length from the berth: there distances to the line of the
 * fenders say nothing. `null` nearer.
 */
export function waysToBerth(
  { from, to }: { from: Pair; to: Pair },
  quay: BodyNow,
  ship: BodyNow,
  { length_m }: Pick<VesselInfo, "length_m">,
): [bow: Way, stern: Way] | null {
  const way = (forward_m: number): Way => {
    const end = onEarth(ship, [forward_m, 0]);
    const across = minus(nearestOn(onEarth(quay, from), onEarth(quay, to), end), end);
    const off_m = length(across);
    return {
      off_m,
      bearing_rad: Math.atan2(across[1], across[0]),
      closing_mps: dot(across, [ship[3], ship[4]]) / (off_m || 1),
    };
  };
  const [bow, stern] = [way(length_m / 2), way(-length_m / 2)];
  return Math.min(bow.off_m, stern.off_m) > length_m ? [bow, stern] : null;
}

/** Ways from bow and stern of a vessel to the berth, where she is far from it; `null` near it, and without a berth. */
export function farFromBerth(
  frame: Frame,
  hello: Hello,
  vessel: number,
): [bow: Way, stern: Way] | null {
  const info = hello.vessels[vessel];
  const body = frame.bodies[info?.body ?? -1];
  const quay = frame.bodies[hello.berth?.body ?? -1];
  const at = frame.vessels[vessel]?.berth;
  const isPast = at?.bow === "past_end" && at.stern === "past_end";
  if (!isPast || !info || !body || !quay || !hello.berth) return null;
  return waysToBerth(hello.berth, quay, body, info);
}
