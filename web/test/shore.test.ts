/** Marks, land and structures of the chart in the view out of the window. */
import { expect, test } from "vitest";
import { carriersOf, floats, lampHeight, mark } from "../src/bridge/marks";
import { Solids, linearOf } from "../src/bridge/solids";
import type { ChartInfo, Pair } from "../src/protocol";

const FEATURE: ChartInfo = {
  kind: "buoy",
  name: "1",
  depth_m: null,
  deepest_m: null,
  clearance_m: null,
  colour: "red",
  side: "port",
  meaning: "lateral",
  form: "spar",
  character: null,
  period_s: null,
  sector_rad: null,
  range_m: null,
  shape: "point",
  lines: [[[0, 0]]],
};

/** Whether a corner has a colour. */
const has = ({ colours }: Solids, colour: number) => {
  const [r, g, b] = linearOf(colour);
  return colours.some(
    (v, k) => k % 3 === 0 && v === r && colours[k + 1] === g && colours[k + 2] === b,
  );
};

test.each(["buoy", "beacon"] as const)(
  "a lateral %s of region B has a topmark of its own colour",
  (kind) => {
    for (const colour of ["red", "green"] as const)
      for (const side of ["port", "starboard"] as const) {
        const solids = new Solids();
        mark({ ...FEATURE, kind, colour, side }, [0, 0], solids);
        expect([has(solids, 0xb3262c), has(solids, 0x14703c)]).toEqual([
          colour === "red",
          colour === "green",
        ]);
      }
  },
);

const at = (kind: ChartInfo["kind"], place: Pair): ChartInfo => ({
  ...FEATURE,
  kind,
  lines: [[place]],
});

test("the light of an S-57 buoy or beacon is on the mark, not on a tower of its own", () => {
  const [buoy, beacon] = [at("buoy", [100, 200]), at("beacon", [500, -300])];
  const [ofBuoy, ofBeacon, sector] = [
    at("light", [100, 200]),
    at("light", [500.01, -300]),
    at("light", [500.01, -300]),
  ];
  const alone = at("light", [110, 200]);
  const carriers = carriersOf([ofBuoy, alone, buoy, beacon, ofBeacon, sector]);
  expect(carriers.get(ofBuoy)).toBe(buoy);
  expect([carriers.get(ofBeacon), carriers.get(sector)]).toEqual([beacon, beacon]);
  expect(carriers.has(alone)).toBe(false);
  // The lamp is as high as that of the mark, and rises with the water on a buoy alone.
  expect(lampHeight(carriers.get(ofBuoy) ?? ofBuoy)).toBe(5.2);
  expect([floats(buoy), floats(beacon), floats(alone)]).toEqual([true, false, false]);
});

test("a light belongs to the nearest of two marks, and to no area", () => {
  const [near, far] = [at("buoy", [0.4, 0]), at("beacon", [1.5, 0])];
  const light = at("light", [0, 0]);
  expect(carriersOf([far, near, light]).get(light)).toBe(near);
  expect(carriersOf([near, far, light]).get(light)).toBe(near);
  expect(carriersOf([{ ...near, shape: "area" }, light]).size).toBe(0);
});
