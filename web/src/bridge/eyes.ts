/** Places from which the view is seen: where an eye is aboard or ashore, and where it looks at first. */
import { AHEAD_M, type Arrangement, EYE_M } from "./arrangement";
import { STEM_M } from "./berth";
import type { Eye } from "./look";
import type { Pair } from "../protocol";

/** An eye on a body: its place [forward, starboard], its height above the waterline, and where it looks. */
export interface Seat {
  at: Pair;
  up_m: number;
  /** From the bow, positive to starboard [rad]. */
  bearing_rad: number;
  /** Positive upwards [rad]. */
  elevation_rad: number;
  /** Vertical angle of view [rad]. */
  view_rad: number;
}

const DEG = Math.PI / 180;

/** Where an eye is on a ship. */
export function seatOn(ship: Arrangement, eye: Exclude<Eye, "bollard" | "free">): Seat {
  const { bridge, house, hull, length_m, beam_m } = ship;
  const up_m = house.bridge_deck_m + EYE_M;
  const looks = (bearing: number, elevation: number, view: number) => ({
    bearing_rad: bearing * DEG,
    elevation_rad: elevation * DEG,
    view_rad: view * DEG,
  });
  switch (eye) {
    case "tug":
    case "bridge":
      if (ship.conning) {
        const [forward, starboard, up] = ship.conning;
        return {
          at: [forward, starboard],
          up_m: up,
          ...looks(0, -5, ship.kind === "tug" ? 55 : 42),
        };
      }
      return ship.kind === "tug"
        ? // In the middle of the wheelhouse's front, over the winch.
          {
            at: [bridge.fore_m + 0.3, 0],
            up_m: house.bridge_deck_m + 0.62 * bridge.height_m,
            ...looks(0, -6, 55),
          }
        : { at: [bridge.fore_m + AHEAD_M, 0], up_m, ...looks(0, -5, 42) };
    case "port-wing":
    case "starboard-wing": {
      const side = eye === "port-wing" ? -1 : 1;
      if (ship.kind === "tug")
        return {
          at: [(bridge.fore_m + bridge.aft_m) / 2, side * (bridge.half_m + 0.4)],
          up_m: house.bridge_deck_m + 0.62 * bridge.height_m,
          ...looks(side * 70, -18, 55),
        };
      // Over the bulwark at the wing's end: the ship's side runs to the bow in the picture.
      return {
        at: [bridge.fore_m + 0.25, side * (bridge.wing_m + 0.15)],
        up_m: up_m + 0.1,
        ...looks(side * 14, -20, 52),
      };
    }
    case "bow": {
      // Behind the bulwark of the forecastle, high enough to see the water before the stem.
      const at = hull.fore_m - (ship.kind === "tug" ? 0.16 : 0.03) * length_m;
      return {
        at: [at, 0],
        up_m: hull.deck_m(at) + (ship.kind === "tug" ? 2.4 : 3.4),
        ...looks(0, -12, 54),
      };
    }
    case "stern": {
      const at = hull.aft_m + 0.035 * length_m;
      return {
        at: [at, 0],
        up_m: hull.deck_m(at) + Math.max(2.4, 0.12 * beam_m),
        ...looks(180, -13, 54),
      };
    }
  }
}

/** An eye beside a bollard, which looks along `facing_rad`, from north. */
export const seatAtBollard = (at: Pair, deck_m: number, facing_rad: number): Seat => ({
  at,
  up_m: deck_m + STEM_M + 1.4,
  bearing_rad: facing_rad,
  elevation_rad: -9 * DEG,
  view_rad: 54 * DEG,
});

/** A horizontal angle of view as the vertical one of a picture with this width over height [rad]. */
export const vertical = (horizontal_rad: number, aspect: number): number =>
  2 * Math.atan(Math.tan(horizontal_rad / 2) / aspect);
