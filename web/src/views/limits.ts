/** What is fast towards a berth. A choice of the page that its user can change: berths publish their own limits. */

/** Of the limit at the fenders: amber from here. */
const CAUTION_SHARE = 2 / 3;
/** Further off it is what a ship may have that loses so much on her way to the fenders [m/s²]; the server's alarms do so. */
const SLOWING_MPS2 = 0.002;

export const DEFAULT_LIMIT_MPS = 0.15;

export type Light = "ok" | "caution" | "alarm";

/** The limit at a distance, from the one at the fenders [m/s]. */
export const limitAt = (off_m: number, at_fenders_mps: number): number =>
  Math.sqrt(at_fenders_mps ** 2 + 2 * SLOWING_MPS2 * Math.max(0, off_m));

/** The light for a closing speed at a distance; opening is never too fast. */
export function light(closing_mps: number, off_m: number, at_fenders_mps: number): Light {
  const share = closing_mps / limitAt(off_m, at_fenders_mps);
  if (share > 1) return "alarm";
  return share > CAUTION_SHARE ? "caution" : "ok";
}
