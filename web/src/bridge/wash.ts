/**
 * The water that thrusters and azimuth units throw away from a ship: each jet begins at its unit, and goes against the force of the
 * unit. The sea draws jets as foam. How wide they are and how far they are seen is ours, by the look of the water.
 */
import type { Arrangement } from "./arrangement";
import type { Pair, VesselInfo, VesselNow } from "../protocol";

/** A jet in the axes of the ship. */
export interface Jet {
  /** Where the water comes up: forward and to starboard [m]. */
  at_m: Pair;
  /** Where the water goes, from the bow, positive to starboard [rad]. */
  to_rad: number;
  /** Share of the unit's full power, 0 to 1. */
  power: number;
  /** Breadth of the jet where it begins [m]. */
  wide_m: number;
}

/** A weaker jet is not seen. */
const LEAST_POWER = 0.04;
/** Breadth of a jet over the beam of the ship: of an azimuth unit, and of a tunnel. */
const AZIMUTH_SHARE = 0.28;
const TUNNEL_SHARE = 0.1;

/** All jets of a vessel. */
export function jetsOf(
  { hull, beam_m }: Arrangement,
  { thrusters, azimuths }: Pick<VesselInfo, "thrusters" | "azimuths">,
  now: Pick<VesselNow, "thrusters" | "azimuths">,
): Jet[] {
  const tunnels = thrusters.flatMap(({ along_m }, i): Jet[] => {
    const push = now.thrusters[i]?.now ?? 0;
    // A push to starboard throws the water out of the port side.
    const side = push > 0 ? -1 : 1;
    const [forward, starboard] = hull.side(along_m, 0, side);
    const to_rad = (side * Math.PI) / 2;
    return [
      { at_m: [forward, starboard], to_rad, power: Math.abs(push), wide_m: TUNNEL_SHARE * beam_m },
    ];
  });
  const units = azimuths.map(({ at_m }, i): Jet => {
    const { power, direction_rad } = now.azimuths[i] ?? { power: 0, direction_rad: 0 };
    return { at_m, to_rad: direction_rad + Math.PI, power, wide_m: AZIMUTH_SHARE * beam_m };
  });
  return [...tunnels, ...units].filter(({ power }) => power > LEAST_POWER);
}

/** The jet of a tug that is a force alone: her bow is to the ship, and she throws the water against her force. */
export function jetOfTug(
  { hull, beam_m }: Arrangement,
  { force_n, pulls }: { force_n: number; pulls: boolean },
  bollard_pull_n: number,
): Jet[] {
  const power = Math.min(1, force_n / Math.max(1, bollard_pull_n));
  if (power <= LEAST_POWER) return [];
  const at_m: Pair = [hull.aft_m + (pulls ? 0.3 : 0.1) * (hull.fore_m - hull.aft_m), 0];
  return [{ at_m, to_rad: pulls ? 0 : Math.PI, power, wide_m: 2 * AZIMUTH_SHARE * beam_m }];
}
