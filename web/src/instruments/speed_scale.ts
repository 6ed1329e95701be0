/** The speed dial: its scale, and which speed it shows. */
import { inSteps } from "./instrument";
import { clamp } from "../geometry";
import type { VesselNow } from "../protocol";
import { toKnots } from "../units";

/** Ends of a scale, in whole steps of its figures [kn]. */
export interface SpeedScale {
  astern_kn: number;
  ahead_kn: number;
}

/** The first scale of a ship; each further scale holds the one before. */
export const LEAST_SCALE: SpeedScale = { astern_kn: -5, ahead_kn: 15 };
const LARGEST_SCALE: SpeedScale = { astern_kn: -10, ahead_kn: 30 };
const SCALES: SpeedScale[] = [
  LEAST_SCALE,
  { astern_kn: -5, ahead_kn: 20 },
  { astern_kn: -10, ahead_kn: 25 },
  LARGEST_SCALE,
];
/** Between two figures of a scale [kn]. */
export const FIGURES_KN = 5;
const STEP_KN = 0.05;

/** The least scale that holds the speeds. It is never less than the scale before: a scale that goes and comes is misread. */
function scaleFor(speeds_kn: number[], before: SpeedScale): SpeedScale {
  const holds = ({ astern_kn, ahead_kn }: SpeedScale) =>
    speeds_kn.every((kn) => astern_kn <= kn && kn <= ahead_kn);
  return SCALES.find((scale) => scale.ahead_kn >= before.ahead_kn && holds(scale)) ?? LARGEST_SCALE;
}

/** What the dial shows: its name, and needle and order within its scale [kn]. */
export interface SpeedShown {
  name: string;
  scale: SpeedScale;
  now_kn: number;
  order_kn: number | null;
}

/**
 * The dial of a vessel. It shows the speed over ground; while a speed is ordered, the speed through the water, because the order is
 * about this speed.
 */
export function speedShown(
  { ground_mps, water_mps, speed_order_mps }: VesselNow,
  before: SpeedScale,
): SpeedShown {
  const isOrdered = speed_order_mps !== null;
  const now_kn = toKnots(isOrdered ? water_mps[0] : ground_mps[0]);
  const order_kn = isOrdered ? toKnots(speed_order_mps) : null;
  const scale = scaleFor([now_kn, order_kn ?? 0], before);
  const within = (kn: number) => inSteps(clamp(kn, scale.astern_kn, scale.ahead_kn), STEP_KN);
  return {
    name: isOrdered ? "Ahead, through water" : "Ahead, over ground",
    scale,
    now_kn: within(now_kn),
    order_kn: order_kn === null ? null : within(order_kn),
  };
}
