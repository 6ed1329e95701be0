/** Buoys, beacons and leading marks by IALA's colours, shapes and topmarks, at sizes that are usual at sea. */
import { bands, formOf } from "../draw/buoys";
import { QUAY_M } from "./berth";
import type { Heights } from "./heights";
import { length, minus } from "../geometry";
import type { ChartInfo, Pair } from "../protocol";
import { type Colour, Solids, type Spot } from "./solids";

const RED = "#b3262c";
const GREEN = "#14703c";
const COLOURS = {
  port: RED,
  starboard: GREEN,
  mark_yellow: "#dcae1e",
  mark_white: "#e8e8e4",
  mark_black: "#17191b",
};
const number = (colour: string): Colour => Number.parseInt(colour.slice(1), 16);

/** Height of the light of a buoy above the water; of a beacon and of a tower above datum, where tides are small [m]. */
export const BUOY_LIGHT_M = 5.2;
export const BEACON_LIGHT_M = 9.5;
const TOWER_LIGHT_M = 14;
/** Height of the light of a mooring buoy above the water, and of a dolphin above the dolphin [m]. */
const MOORING_BUOY_LIGHT_M = 1.6;
export const OVER_DOLPHIN_M = 1;
/** How far below datum beacons and towers reach [m]. */
const FOOT_M = -3;

/** How much higher than where tides are small beacons and towers stand: the water never covers them [m]. */
export const riseOf = ({ quay_m }: Heights): number => quay_m - QUAY_M;

/** Mooring points of a chart are dolphins and mooring buoys, which alone have a mark. */
export const isMooringBuoy = ({ kind, meaning }: ChartInfo): boolean =>
  kind === "mooring" && meaning !== null;

/** Buoys rise with the water; beacons, dolphins and lights stand on the ground. */
export const floats = (feature: ChartInfo): boolean =>
  feature.kind === "buoy" || isMooringBuoy(feature);

/** Height of a mark's light above the water, or above datum if the mark stands on the ground [m]. */
export function lampHeight(feature: ChartInfo, rise_m: number): number {
  if (feature.kind === "buoy") return BUOY_LIGHT_M;
  if (isMooringBuoy(feature)) return MOORING_BUOY_LIGHT_M;
  if (feature.kind === "mooring") return rise_m + QUAY_M + OVER_DOLPHIN_M;
  return rise_m + (feature.kind === "beacon" ? BEACON_LIGHT_M : TOWER_LIGHT_M);
}

/** A light stands no farther from the mark that carries the light: charts round places [m]. */
const CARRIED_M = 2;

/**
 * The buoy, beacon, dolphin or mooring buoy that carries each light. In charts of S-57 the light of a mark is a feature of its own at the place of the
 * mark; a light without a mark stands on a tower.
 */
export function carriersOf(chart: ChartInfo[]): Map<ChartInfo, ChartInfo> {
  const placed = (kinds: ChartInfo["kind"][]) =>
    chart.flatMap((feature): { feature: ChartInfo; at: Pair }[] => {
      const at = feature.shape === "point" && kinds.includes(feature.kind) && feature.lines[0]?.[0];
      return at ? [{ feature, at }] : [];
    });
  const marks = placed(["buoy", "beacon", "mooring"]);
  const carriers = new Map<ChartInfo, ChartInfo>();
  for (const light of placed(["light"])) {
    let nearest_m = CARRIED_M;
    for (const { feature, at } of marks) {
      const off_m = length(minus(at, light.at));
      if (off_m > nearest_m) continue;
      nearest_m = off_m;
      carriers.set(light.feature, feature);
    }
  }
  return carriers;
}

/** The colour of a mark that has one. */
export const ownColour = (feature: ChartInfo): Colour =>
  number(bands(feature, COLOURS)[0] ?? COLOURS.mark_white);

/** Draws a mark at a place [north, east] about the origin; `rise_m`: how much higher what stands on the ground is. */
export function mark(feature: ChartInfo, at: Pair, to: Solids, rise_m = 0): void {
  const layers = bands(feature, COLOURS).map(number);
  if (feature.kind === "buoy") buoy(feature, at, layers, to);
  else if (feature.kind === "beacon") beacon(feature, at, layers, to, rise_m);
  else if (feature.kind === "light") tower(at, to, rise_m);
}

const above = ([n, e]: Pair, up: number): Spot => [n, e, up];

/** Colour of a height, from bands that run from the top down. */
function layered(
  at: Pair,
  [low, high]: Pair,
  radius: (share: number) => number,
  layers: Colour[],
  to: Solids,
): void {
  const steps = layers.length === 1 ? 2 : layers.length * 2;
  for (let i = 0; i < steps; i++) {
    const [a, b] = [i / steps, (i + 1) / steps];
    const colour = layers[layers.length - 1 - Math.floor(((i + 0.5) / steps) * layers.length)] ?? 0;
    to.post(
      above(at, low + (high - low) * a),
      above(at, low + (high - low) * b),
      radius(a),
      colour,
      {
        sides: 14,
        upper_m: radius(b),
        caps: i === steps - 1,
      },
    );
  }
}

function buoy(feature: ChartInfo, at: Pair, layers: Colour[], to: Solids): void {
  const form = formOf(feature);
  const foot = layers.at(-1) ?? 0xdddddd;
  to.post(above(at, -0.8), above(at, 0.55), 1.35, foot, { sides: 18 });
  to.post(above(at, 0.55), above(at, 0.8), 1.35, foot, { sides: 18, upper_m: 1 });
  if (feature.meaning === "safe_water") {
    // Upright stripes of red and white.
    for (let i = 0; i < 8; i++) {
      const angle = (Math.PI / 4) * i;
      const spot = (up: number): Spot => [
        at[0] + 0.5 * Math.cos(angle),
        at[1] + 0.5 * Math.sin(angle),
        up,
      ];
      to.post(spot(0.7), spot(3.6), 0.24, i % 2 === 0 ? number(RED) : number(COLOURS.mark_white), {
        sides: 6,
      });
    }
  } else if (form === "can") layered(at, [0.7, 3.6], () => 0.85, layers, to);
  else if (form === "cone")
    layered(at, [0.7, 3.9], (share) => 1.05 * (1 - 0.86 * share), layers, to);
  else if (form === "ball") {
    to.ball([...at, 1.5], 1.25, layers[0] ?? 0xdddddd);
    layered(at, [2.5, 3.6], () => 0.16, layers, to);
  } else if (form === "spar") layered(at, [0.3, 4.2], () => 0.3, layers, to);
  else layered(at, [0.7, 3.7], (share) => 0.75 - 0.4 * share, layers, to);
  to.post(above(at, 3.5), above(at, BUOY_LIGHT_M - 0.35), 0.07, 0x33383b, { sides: 5 });
  to.post(above(at, BUOY_LIGHT_M - 0.35), above(at, BUOY_LIGHT_M), 0.16, 0x30363a);
  topmark(feature, at, 4.15, to, layers[0]);
}

/** `own`: the mark's own colour, which lateral topmarks have: red is to port in region A, to starboard in region B. */
function topmark(
  { meaning, side }: ChartInfo,
  at: Pair,
  foot: number,
  to: Solids,
  own: Colour = 0xdddddd,
): void {
  const black = number(COLOURS.mark_black);
  const cone = (low: number, up: boolean, colour: Colour) =>
    to.post(above(at, low), above(at, low + 0.65), up ? 0.45 : 0.02, colour, {
      sides: 12,
      upper_m: up ? 0.02 : 0.45,
    });
  if (side === "port") to.post(above(at, foot), above(at, foot + 0.6), 0.36, own, { sides: 14 });
  else if (side === "starboard") cone(foot, true, own);
  else if (meaning === "safe_water") to.ball([...at, foot + 0.4], 0.4, number(RED), 5);
  else if (meaning === "isolated_danger")
    for (const up of [0.35, 1.1]) to.ball([...at, foot + up], 0.35, black, 5);
  else if (meaning === "special")
    for (const turn of [-1, 1])
      to.post(
        [at[0], at[1] - 0.4 * turn, foot],
        [at[0], at[1] + 0.4 * turn, foot + 0.75],
        0.08,
        number(COLOURS.mark_yellow),
        { sides: 4 },
      );
  else {
    const cones = {
      north: [true, true],
      south: [false, false],
      east: [false, true],
      west: [true, false],
    }[meaning as "north"] as boolean[] | undefined;
    cones?.forEach((up, i) => cone(foot + 0.75 * i, up, black));
  }
}

/** A round tower of stone or steel on a base. */
function beacon(feature: ChartInfo, at: Pair, layers: Colour[], to: Solids, rise_m: number): void {
  const up = (height_m: number) => above(at, rise_m + height_m);
  to.post(above(at, FOOT_M), up(3.4), 2.6, 0x8b8880, { sides: 16, upper_m: 2.2 });
  layered(at, [rise_m + 3.4, rise_m + 8], (share) => 1.15 - 0.35 * share, layers, to);
  to.post(up(8), up(8.15), 1.25, 0xd8d8d4, { sides: 14 });
  to.post(up(8.15), up(BEACON_LIGHT_M), 0.42, 0x2c3338, { sides: 10 });
  topmark(feature, at, rise_m + BEACON_LIGHT_M + 0.2, to, layers[0]);
}

function tower(at: Pair, to: Solids, rise_m: number): void {
  const up = (height_m: number) => above(at, rise_m + height_m);
  to.post(above(at, FOOT_M), up(3), 2.4, 0x8b8880, { sides: 16 });
  layered(at, [rise_m + 3, rise_m + 12.6], (share) => 1.6 - 0.5 * share, [0xe6e4dd], to);
  to.post(up(12.6), up(12.85), 1.8, 0x4b5154, { sides: 16 });
  to.post(up(12.85), up(14.6), 0.85, 0x2a3136, { sides: 12 });
  to.post(up(14.6), up(15.6), 1.05, 0x8c2b24, { sides: 12, upper_m: 0.1 });
}
