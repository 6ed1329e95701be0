/**
 * The surface of the sea as a sum of long-crested components. The messages give height, period and direction of the waves, not
 * the run's components: the components here have the same height, period and direction, and other phases than the run.
 */
import { chance } from "./fittings";
import type { WavesNow } from "../protocol";

/** One component: amplitude [m], wave number north and east [rad/m], circular frequency [rad/s], phase [rad]. */
export interface Component {
  amplitude_m: number;
  north_radpm: number;
  east_radpm: number;
  omega_radps: number;
  phase_rad: number;
}

const G = 9.80665;
/** Most components that the picture draws. */
export const MOST = 8;

/** Components of a sea about the period of its peak: a narrow spectrum, spread by 20° to both sides. */
export function components(waves: WavesNow | null): Component[] {
  if (!waves || waves.height_m < 0.02 || waves.period_s <= 0) return [];
  const shares = Array.from({ length: MOST }, (_, i) => (i - (MOST - 1) / 2) / MOST);
  const weights = shares.map((share) => Math.exp(-((share / 0.35) ** 2)));
  const sum = weights.reduce((all, w) => all + w, 0);
  return shares.map((share, i): Component => {
    // Significant height is four times the root of the variance.
    const variance = ((waves.height_m / 4) ** 2 * (weights[i] ?? 0)) / sum;
    const omega = ((2 * Math.PI) / waves.period_s) * (1 + 0.5 * share);
    const number = omega ** 2 / G;
    // Waves run to where they do not come from.
    const to = waves.from_rad + Math.PI + (chance(i, 3) - 0.5) * 0.7;
    return {
      amplitude_m: Math.sqrt(2 * variance),
      north_radpm: number * Math.cos(to),
      east_radpm: number * Math.sin(to),
      omega_radps: omega,
      phase_rad: 2 * Math.PI * chance(i, 11),
    };
  });
}

/** Height of the surface at a place and a time [m]. */
export const surface = (all: Component[], north_m: number, east_m: number, t_s: number): number =>
  all.reduce(
    (sum, c) =>
      sum +
      c.amplitude_m *
        Math.cos(
          c.north_radpm * north_m + c.east_radpm * east_m - c.omega_radps * t_s + c.phase_rad,
        ),
    0,
  );
