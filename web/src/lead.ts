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

/** An offered bollard stays while the ship moves, until the line leads only this share of what it should. */
const STAYS = 0.5;
/** The bollard of a breast line stays until another is nearer by this [m]. */
const NEARER_M = 10;

/**
 * The nearest bollard within reach to which the line leads as its name says. Where there is none, the bollard within reach that is
 * farthest in this direction, else the nearest of all. `before`: the bollard that was offered before; it stays as long as the line still
 * leads there. `places` come the nearest first.
 */
export function firstOffered(
  name: string,
  fairlead_m: Pair,
  places: Place[],
  reaches: (m: number) => boolean,
  before: string | null = null,
): Place | undefined {
  const inReach = places.filter(({ m }) => reaches(m));
  const kept = inReach.find((place) => place.name === before);
  const leads = lead(name, fairlead_m);
  if (leads === null) {
    const nearest = places[0];
    return kept && nearest && kept.m < nearest.m + NEARER_M ? kept : nearest;
  }
  const along = ({ from_fairlead: [ahead] }: Place) => leads.to * ahead;
  const fits = (place: Place, share: number) =>
    along(place) > 0 && along(place) >= share * leads.along * Math.abs(place.from_fairlead[1]);
  if (kept && fits(kept, STAYS)) return kept;
  const farthest = inReach.toSorted((a, b) => along(b) - along(a))[0];
  return (
    inReach.find((place) => fits(place, 1)) ??
    (farthest && along(farthest) > 0 ? farthest : places[0])
  );
}
