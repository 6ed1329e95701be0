/**
 * Which lights a vessel shows and from where each is seen (COLREG rules 21 to 24 and 30, from memory; Annex I, 9: how far sidelights
 * are seen across the bow).
 */
import type { Arrangement } from "./arrangement";
import { type Triple, aboard } from "./axes";
import type { Conduct } from "./conduct";
import type { Pair } from "../protocol";
import { wrapped } from "../units";

const DEG = Math.PI / 180;

export type LampColour = "red" | "green" | "white" | "yellow" | "amber";

/** Over which bearings from a light it is seen: two directions, clockwise from the first to the second [rad]. */
export type Arc = [from_rad: number, to_rad: number];

/** A light aboard, in the axes of the ship. Bearings are from her bow. */
export interface Lamp {
  at: Triple;
  colour: LampColour;
  /** `null`: seen all round. */
  arc: Arc | null;
}

/** Whether a light is seen from a bearing [rad]. The ends of the arc are part of it. */
export function isSeen(arc: Arc | null, bearing_rad: number): boolean {
  if (!arc) return true;
  const turn = 2 * Math.PI;
  const clockwise = (from: number, to: number) => (((to - from) % turn) + turn) % turn;
  const whole = clockwise(arc[0], arc[1]) || turn;
  const at = clockwise(arc[0], bearing_rad);
  return at <= whole + 1e-9 || turn - at < 1e-9;
}

/**
 * A sidelight is seen as far across the bow. The lights stand at the ends of the wings: without this, an eye right ahead would see
 * neither. Annex I, 9 wants one to three degrees.
 */
const ACROSS_RAD = 2 * DEG;
/** Rule 21: masthead light 225°, sidelights 112.5° each, stern light and towing light 135°. */
export const ARCS = {
  masthead: [-112.5 * DEG, 112.5 * DEG],
  port: [-112.5 * DEG, ACROSS_RAD],
  starboard: [-ACROSS_RAD, 112.5 * DEG],
  stern: [112.5 * DEG, -112.5 * DEG],
} as const satisfies Record<string, Arc>;

/** From this length on a second masthead light abaft the first is a duty [m]. */
const SECOND_MASTHEAD_M = 50;
/** The after masthead light is so much higher than the forward one [m]. */
const HIGHER_M = 4.5;
/** Two red lights stand so far apart [m]. */
const APART_M = 2;

/** A light on the centreline: ahead of the body's origin, and above the water [m]. */
type OnMast = Pair;

/**
 * The two masthead lights of a long ship, the forward light first; `post`: whether the after light stands on a post. Annex I (from
 * memory) wants half a length between the lights, or 100 m. Where the bridge is so far forward that the mast on the bridge is near the
 * foremast, the mast on the bridge has the forward light, and a post abaft of it has the after light.
 */
export function mastheads(ship: Arrangement): { fore: OnMast; aft: OnMast; post: boolean } {
  const { hull, bridge, mast_m, length_m } = ship;
  const onBridge = (bridge.fore_m + bridge.aft_m) / 2;
  const onForemast = hull.aft_m + 0.93 * length_m;
  const apart_m = Math.min(100, length_m / 2);
  if (onForemast - onBridge >= 0.6 * apart_m) {
    const tall_m = hull.deck_m(onForemast) + Math.max(6, 0.055 * length_m);
    const fore_m = Math.min(tall_m, mast_m - HIGHER_M);
    return { fore: [onForemast + 0.35, fore_m], aft: [onBridge + 0.4, mast_m], post: false };
  }
  const abaft = Math.max(hull.aft_m + 2, onBridge - apart_m);
  return { fore: [onBridge + 0.4, mast_m], aft: [abaft, mast_m + HIGHER_M], post: true };
}

/** Whether a ship has two masthead lights. */
export const isLong = ({ length_m }: Arrangement): boolean => length_m >= SECOND_MASTHEAD_M;

/** Lights of a power-driven vessel under way; `tows`: she has a line to a ship. */
export function underWay(ship: Arrangement, tows: boolean): Lamp[] {
  const { hull, bridge, house, mast_m, length_m, deck_m } = ship;
  const aft = (bridge.fore_m + bridge.aft_m) / 2;
  const side_m = house.bridge_deck_m + (ship.kind === "tug" ? ship.bridge.height_m + 0.35 : 0.7);
  const sideAt = ship.kind === "tug" ? aft : bridge.fore_m - 1.4;
  const lamps: Lamp[] = [
    { at: aboard([sideAt, -bridge.wing_m - 0.15], side_m), colour: "red", arc: ARCS.port },
    { at: aboard([sideAt, bridge.wing_m + 0.15], side_m), colour: "green", arc: ARCS.starboard },
    {
      at: aboard([hull.aft_m - 0.1, 0], hull.deck_m(hull.aft_m) + 1.5),
      colour: "white",
      arc: ARCS.stern,
    },
  ];
  if (isLong(ship)) {
    const { fore, aft: after } = mastheads(ship);
    for (const [at, up] of [fore, after])
      lamps.push({ at: aboard([at, 0], up), colour: "white", arc: ARCS.masthead });
  } else {
    const at = ship.kind === "tug" ? aft - 0.018 * length_m + 0.2 : aft;
    lamps.push({ at: aboard([at, 0], mast_m - 0.3), colour: "white", arc: ARCS.masthead });
    // Rule 24: two masthead lights in a line, and a yellow light above the stern light.
    if (tows)
      lamps.push(
        { at: aboard([at, 0], mast_m - 2.1), colour: "white", arc: ARCS.masthead },
        {
          at: aboard([hull.aft_m - 0.1, 0], deck_m + 3.2),
          colour: "yellow",
          arc: ARCS.stern,
        },
      );
  }
  return lamps;
}

/** Rule 30: an all-round light forward and a lower one aft. */
export function atAnchor({ hull, length_m, mast_m }: Arrangement): Lamp[] {
  const fore = hull.aft_m + 0.93 * length_m;
  const high = Math.min(mast_m - 4, hull.deck_m(fore) + Math.max(6, 0.055 * length_m));
  return [
    { at: aboard([fore, 0], high), colour: "white", arc: null },
    { at: aboard([hull.aft_m + 1, 0], Math.max(3, high - 4.5)), colour: "white", arc: null },
  ];
}

/** Rule 30: aground she shows the lights of a ship at anchor and two red lights, one above the other. */
function aground(ship: Arrangement): Lamp[] {
  const { bridge, mast_m } = ship;
  const at = (bridge.fore_m + bridge.aft_m) / 2;
  const red = (up_m: number): Lamp => ({ at: aboard([at, 0], up_m), colour: "red", arc: null });
  return [...atAnchor(ship), red(mast_m), red(mast_m - APART_M)];
}

/** The lights for all that she may do. A ship that is made fast to a quay shows none. */
export const lampsOf = (ship: Arrangement): Record<Conduct, Lamp[]> => ({
  under_way: underWay(ship, false),
  tows: underWay(ship, true),
  at_anchor: atAnchor(ship),
  aground: aground(ship),
  made_fast: [],
});

/** Bearing of a place from a lamp, from the ship's bow [rad]; both in the axes of the ship. */
export const bearingFrom = (lamp: Triple, eye: Triple): number =>
  wrapped(Math.atan2(eye[0] - lamp[0], -(eye[2] - lamp[2])));
