/** The bollard that is offered first for a line: where a line of this name usually leads. */
import { minus, onEarth, turned } from "./geometry";
import type { BodyNow, Pair } from "./protocol";

/** Where a line leads from its fairlead: towards the bow (1) or the stern (−1), by at least a multiple of its way across. */
interface Lead {
  to: 1 | -1;
  along: number;
}

/** A spring leads along the ship by at least this multiple of its way across. */
const SPRING_ALONG = 2;
/** A head line or a stern line leads beyond its fairlead by at least this multiple of its way across. */
const END_ALONG = 0.5;

export interface Place {
  name: string;
  /** From the fairlead, ahead and to starboard in the ship's axes [m]. */
  from_fairlead: Pair;
  m: number;
}

/** A position on the earth, from the fairlead in the ship's axes [m]. */
export const fromFairlead = (ship: BodyNow, fairlead_m: Pair, at: Pair): Pair =>
  turned(-ship[2], minus(at, onEarth(ship, fairlead_m)));

/** The way that a line leads, by its name and by the end of the ship where its fairlead is; `null`: across to the quay. */
function lead(name: string, fairlead_m: Pair): Lead | null {
  const words = name.replaceAll("_", " ");
  const toBow = fairlead_m[0] > 0;
  // A spring leads towards the other end of the ship.
  if (/spring/i.test(words)) return { to: toBow ? -1 : 1, along: SPRING_ALONG };
  // A breast line may be called by the end of the ship too.
  if (/breast/i.test(words) || !/\b(head|bow|stern)/i.test(words)) return null;
  return { to: toBow ? 1 : -1, along: END_ALONG };
}

/**
 * The nearest bollard within reach to which the line leads as its name says; the nearest of all, where there is none. `places` come
 * the nearest first.
 */
export function firstOffered(
  name: string,
  fairlead_m: Pair,
  places: Place[],
  reaches: (m: number) => boolean,
): Place | undefined {
  const leads = lead(name, fairlead_m);
  if (leads === null) return places[0];
  const fits = ({ from_fairlead: [ahead, starboard], m }: Place) => {
    const along = leads.to * ahead;
    return reaches(m) && along > 0 && along >= leads.along * Math.abs(starboard);
  };
  return places.find(fits) ?? places[0];
}
