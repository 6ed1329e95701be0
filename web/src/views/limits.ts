/** What is fast towards a berth. A choice of the page that its user can change: berths publish their own limits. */

/** Of the limit at the fenders: amber from here. */
const CAUTION_SHARE = 2 / 3;
/** Up to so far off, the limit at the fenders holds [m]; */
const NEAR_M = 10;
/** beyond, it grows by so much for each metre [m/s]. */
const GROWTH_MPS_PER_M = 0.008;

export const DEFAULT_LIMIT_MPS = 0.15;

export type Light = "ok" | "caution" | "alarm";

/** The limit at a distance, from the one at the fenders [m/s]. */
export const limitAt = (off_m: number, at_fenders_mps: number): number =>
  at_fenders_mps + Math.max(0, off_m - NEAR_M) * GROWTH_MPS_PER_M;

/** The light for a closing speed at a distance; opening is never too fast. */
export function light(closing_mps: number, off_m: number, at_fenders_mps: number): Light {
  const share = closing_mps / limitAt(off_m, at_fenders_mps);
  if (share > 1) return "alarm";
  return share > CAUTION_SHARE ? "caution" : "ok";
}
