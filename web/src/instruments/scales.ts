/** Scales in which OpenBridge's symbols count. */
import { toKnots } from "../units";

/** Beaufort's number of a wind, from v = 0.836 B^1.5 m/s (WMO's scale, CMM-IV 1946, recalled). */
export const beaufort = (mps: number): number =>
  Math.min(12, Math.round((Math.max(0, mps) / 0.836) ** (2 / 3)));

/** Arrows of a current: none below a tenth of a knot, then one for each begun knot, at most four. */
export const currentArrows = (mps: number): number =>
  toKnots(mps) < 0.1 ? 0 : Math.min(4, Math.ceil(toKnots(mps)));
