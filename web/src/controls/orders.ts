/** What the pilot's words to a tug mean as directions and places. Pure. */
import { sideAt } from "../geometry";
import type { BodyInfo, Pair } from "../protocol";
import { wrapped } from "../units";

/** How a tug lays herself: square to the side, or leading 45° towards the ship's bow or stern. */
export type Lead = -1 | 0 | 1;

/** A tug whose place is within so much of the half-beam works on the centre line, at bow or stern. */
const CENTRE_SHARE = 0.3;

/**
 * Direction of the force on the ship, from her bow, positive to starboard [rad], of a tug that works at a place of hers.
 * At a side a push goes in and a pull
 * out; on the centre line a tug astern pushes ahead and pulls astern, one ahead the other way about.
 */
export function tugDirection(
  [along, across]: Pair,
  order: "push" | "pull",
  lead: Lead,
  beam_m: number,
): number {
  if (Math.abs(across) < (CENTRE_SHARE * beam_m) / 2) {
    const outward = along < 0 ? Math.PI : 0;
    // On the centre line a lead is to starboard (1) or to port (−1).
    return wrapped(
      (order === "pull" ? outward : outward + Math.PI) +
        lead * (Math.PI / 4) * (outward === 0 ? 1 : -1),
    );
  }
  const side = Math.sign(across) * (order === "pull" ? 1 : -1);
  return side * (Math.PI / 2) * (1 - lead * 0.5);
}

export interface Station {
  name: string;
  at_m: Pair;
  side: -1 | 1;
}

/** Places on a ship's side where a tug may be told to push: shoulder, midships and quarter of either side. */
export function stations(outline: BodyInfo["outline"], length_m: number): Station[] {
  return ([-1, 1] as const).flatMap((side) =>
    (
      [
        ["shoulder", 0.3],
        ["midships", 0],
        ["quarter", -0.3],
      ] as const
    ).flatMap(([name, share]) => {
      const across = sideAt(outline, share * length_m, side);
      return across === null
        ? []
        : [
            {
              name: `${side < 0 ? "port" : "starboard"} ${name}`,
              at_m: [share * length_m, across] as Pair,
              side,
            },
          ];
    }),
  );
}
