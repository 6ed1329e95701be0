import { expect, test } from "vitest";
import { firstLook } from "../src/draw/scene";
import type { Live } from "../src/live";
import type { BodyNow, Hello, Pair } from "../src/protocol";

const SHIP: Pair[] = [
  [-90, -15],
  [90, -15],
  [90, 15],
  [-90, 15],
];

/** A ship at the origin, heading north; fenders to the north of her, so far from her. */
function seen(berth_m: number | null, all: boolean, leg = 0, to_waypoint_m = 100): Pair[] {
  const waypoint = (north: number) => ({ name: "", at_m: [north, 0] as Pair, speed_mps: null });
  const plan = { waypoints: [waypoint(-500), waypoint(800), waypoint(9000)] };
  const hello = {
    bodies: [
      { name: "ship", fixed: false, outline: SHIP },
      { name: "quay", fixed: true, outline: [] },
    ],
    vessels: [{ name: "ship", body: 0, length_m: 180, is_tug: false, plan }],
    fenders: berth_m === null ? [] : [{ body: 1, at_m: [berth_m, 30] }],
    tugs: [],
    lines: [],
    berth: null,
    chart: [],
  } as unknown as Hello;
  const frame = { vessels: [{ plan: { leg, to_waypoint_m } }], lines: [] };
  const live = { frame, ship: () => 0 } as unknown as Live;
  const bodies: BodyNow[] = [
    [0, 0, 0, 0, 0, 0],
    [0, 0, 0, 0, 0, 0],
  ];
  return firstLook(hello, bodies, live, all);
}
const farthest = (places: Pair[]) => Math.max(...places.map(([north]) => north));

test("the first view has the berth, and so the water between, up to 25 lengths away", () => {
  expect(farthest(seen(900, false))).toBe(900);
  expect(farthest(seen(4400, false))).toBe(4400);
});

test("where the berth is farther, or there is none, the first view has the water ahead and the next waypoint", () => {
  expect(farthest(seen(6000, false))).toBe(4 * 180);
  expect(farthest(seen(null, false))).toBe(4 * 180);
  expect(farthest(seen(null, false, 1))).toBe(9000);
});

test("Fit has the berth wherever it is, and what is left of the passage plan", () => {
  expect(farthest(seen(6000, true))).toBe(9000);
  expect(farthest(seen(6000, true, 1, -50))).toBe(6000);
  // Waypoints that she has passed are not shown.
  expect(Math.min(...seen(6000, true).map(([north]) => north))).toBe(-90);
});
