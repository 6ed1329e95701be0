/**
 * General arrangement of a vessel: what stands where on her deck. The messages give length, beam, draught, outline and title;
 * freeboard, house and bridge are ours, in proportions that are usual for the type (from memory, not from a source).
 */
import { Hull } from "./hull";
import { ends } from "./hull_ends";
import { USUAL_EYE_M } from "./look";
import type { ConningInfo, LevelInfo, Pair } from "../protocol";

export type Kind = "bulk" | "tanker" | "container" | "ro-ro" | "passenger" | "tug";

export interface Arrangement {
  kind: Kind;
  hull: Hull;
  beam_m: number;
  /** Length between the ends of the outline [m]. */
  length_m: number;
  /** Height of the deck amidships above the water [m]. */
  deck_m: number;
  /** The house: from aft to fore, half its breadth, and the height of its roof, which is the bridge deck [m]. */
  house: { aft_m: number; fore_m: number; half_m: number; bridge_deck_m: number };
  /** The wheelhouse: its front, half its breadth without and with wings, and its height [m]. */
  bridge: { fore_m: number; aft_m: number; half_m: number; wing_m: number; height_m: number };
  /** Where the eye stands on the bridge: forward, starboard, and height above the waterline; `null`: as usual [m]. */
  conning: [forward: number, starboard: number, up: number] | null;
  /** Height of the lower masthead light above the water [m]. */
  mast_m: number;
}

/** What a vessel is known by. */
export interface Vessel {
  title: string;
  length_m: number;
  beam_m: number;
  draught_m: number;
  is_tug: boolean;
  /** The type that the scenario gives. */
  kind?: Kind | null;
  /** The place of the eye on the bridge that the scenario gives. */
  conning?: ConningInfo | null;
  /** Her outlines at several heights, if the scenario gives them. */
  levels?: LevelInfo[];
}

const KINDS: [RegExp, Kind][] = [
  [/container|\bKCS\b|feeder/i, "container"],
  [/tanker|VLCC|crude|\bLNG\b|\bLPG\b|esso|product carrier|mother|daughter/i, "tanker"],
  [/ro-?ro|ferry|car carrier|PCTC|ro-?pax/i, "ro-ro"],
  [/cruise|passenger/i, "passenger"],
];

/** The type of a vessel: as the scenario says, or by the words of her title; a bulk carrier if the title says nothing. */
export function kindOf({ title, is_tug, kind }: Pick<Vessel, "title" | "is_tug" | "kind">): Kind {
  if (kind) return kind;
  if (is_tug || /\btug\b/i.test(title)) return "tug";
  return KINDS.find(([words]) => words.test(title))?.[1] ?? "bulk";
}

/** Height of a deck in a house [m]. */
export const STOREY_M = 2.8;
/** Height of an eye above the deck [m]. */
export const EYE_M = USUAL_EYE_M;
/** How far before the front of the wheelhouse the eye is, so that no window frame is in the way [m]. */
export const AHEAD_M = 0.4;

/** Freeboard over beam, and storeys of the house below the bridge deck. */
const PROPORTIONS: Record<Kind, { freeboard: number; storeys(length_m: number): number }> = {
  bulk: { freeboard: 0.17, storeys: (l) => (l < 100 ? 2 : l < 150 ? 3 : 5) },
  tanker: { freeboard: 0.17, storeys: (l) => (l < 100 ? 2 : l < 150 ? 3 : l < 250 ? 5 : 6) },
  container: { freeboard: 0.27, storeys: (l) => (l < 150 ? 5 : l < 250 ? 7 : 9) },
  "ro-ro": { freeboard: 0.75, storeys: () => 1 },
  passenger: { freeboard: 0.32, storeys: (l) => (l < 150 ? 4 : 6) },
  tug: { freeboard: 0.15, storeys: () => 2 },
};

/** The arrangement of a vessel with an outline [forward, starboard]. */
export function arrangementOf(vessel: Vessel, outline: Pair[]): Arrangement {
  const kind = kindOf(vessel);
  const { levels = [], beam_m } = vessel;
  // The deck of a hull by outlines at several heights has the form of the highest.
  const [aft, fore] = ends(levels.at(-1)?.outline ?? outline);
  const length_m = fore - aft;
  const { freeboard, storeys } = PROPORTIONS[kind];
  // Above the highest outline the side is upright, for contact too.
  const deck_m = Math.max(0.6, freeboard * beam_m, levels.at(-1)?.height_m ?? 0);
  const isTug = kind === "tug";
  const hull = new Hull({
    outline,
    draught_m: vessel.draught_m,
    freeboard_m: deck_m,
    levels,
    sheer_m: levels.length > 0 ? 0 : isTug ? 0.1 * beam_m : kind === "ro-ro" ? 0 : 0.016 * length_m,
    rake_m: isTug ? 0.02 * length_m : 0.025 * length_m,
    counter_m: isTug ? 0.12 * length_m : 0.085 * length_m,
  });
  const along = (share: number) => aft + share * length_m;
  const small = Math.min(1, length_m / 90);
  const storey_m = STOREY_M * small;
  const half = Math.max(...hull.breadth(along(0.5)));
  const conning = vessel.conning ?? null;
  const bridge_deck_m = conning
    ? Math.max(deck_m, conning.eye_above_water_m - EYE_M)
    : deck_m + storeys(length_m) * storey_m;
  const houses: Record<Kind, Pair> = {
    bulk: [0.055, 0.135],
    tanker: [0.06, 0.15],
    container: length_m > 260 ? [0.58, 0.63] : [0.12, 0.2],
    "ro-ro": [0.84, 0.93],
    passenger: [0.1, 0.86],
    tug: [0.42, 0.7],
  };
  const [usual, front] = houses[kind].map(along) as Pair;
  // The house stands under the bridge.
  const shift = conning && !isTug ? conning.at_m[0] - AHEAD_M - front : 0;
  const from = Math.max(aft + 0.5, usual + shift);
  const to = Math.min(fore - 1, front + shift);
  const eye: Arrangement["conning"] = conning && [...conning.at_m, conning.eye_above_water_m];
  if (isTug) {
    const floor_m = deck_m + 0.12 * length_m;
    return {
      kind,
      hull,
      beam_m,
      length_m,
      deck_m,
      house: { aft_m: from, fore_m: to, half_m: 0.62 * half, bridge_deck_m: floor_m },
      bridge: {
        fore_m: along(0.665),
        aft_m: along(0.5),
        half_m: 0.4 * half,
        wing_m: 0.4 * half,
        height_m: 0.095 * length_m,
      },
      mast_m: floor_m + 0.28 * length_m,
      conning: eye,
    };
  }
  return {
    kind,
    hull,
    beam_m,
    length_m,
    deck_m,
    house: {
      aft_m: from,
      fore_m: to,
      half_m: kind === "ro-ro" || kind === "passenger" ? half - 0.4 : 0.72 * half,
      bridge_deck_m,
    },
    bridge: {
      fore_m: to + (kind === "passenger" ? 1.5 : 0),
      aft_m: Math.max(from, to - 7 * small),
      half_m: 0.62 * half,
      wing_m: half + (kind === "passenger" || kind === "ro-ro" ? 0.6 : 0),
      height_m: storey_m,
    },
    mast_m: bridge_deck_m + storey_m + 5 * small,
    conning: eye,
  };
}

/** Height of a fairlead above the water where no height is given: on a tug her staple, else a hand above the deck [m]. */
export const fairleadHeight = ({ hull, kind, length_m }: Arrangement, forward_m: number): number =>
  hull.deck_m(forward_m) + (kind === "tug" ? 0.05 * length_m : 0.35);
