/** Marks, land and structures of the chart in the view out of the window. */
import { expect, test } from "vitest";
import { heightsOf, knownQuays } from "../src/bridge/heights";
import { landOf } from "../src/bridge/land";
import { carriersOf, floats, lampHeight, mark, riseOf } from "../src/bridge/marks";
import { Solids, linearOf } from "../src/bridge/solids";
import type { ChartInfo, Hello, Pair } from "../src/protocol";

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
  expect(lampHeight(carriers.get(ofBuoy) ?? ofBuoy, 0)).toBe(5.2);
  expect([floats(buoy), floats(beacon), floats(alone)]).toEqual([true, false, false]);
});

test("a light belongs to the nearest of two marks, and to no area", () => {
  const [near, far] = [at("buoy", [0.4, 0]), at("beacon", [1.5, 0])];
  const light = at("light", [0, 0]);
  expect(carriersOf([far, near, light]).get(light)).toBe(near);
  expect(carriersOf([near, far, light]).get(light)).toBe(near);
  expect(carriersOf([{ ...near, shape: "area" }, light]).size).toBe(0);
});

/** Lowest and highest corner of a part [m]. */
function reach({ positions }: Solids): [low: number, high: number] {
  const up = positions.filter((_, i) => i % 3 === 1);
  return [Math.min(...up), Math.max(...up)];
}

const square = (n: number, e: number, side: number): Pair[] => [
  [n, e],
  [n, e + side],
  [n + side, e + side],
  [n + side, e],
];
const area = (kind: ChartInfo["kind"], ring: Pair[]): ChartInfo => ({
  ...FEATURE,
  kind,
  shape: "area",
  lines: [ring],
});
const partsOf = (chart: ChartInfo[], highest_water_m: number, decks: number[] = []) =>
  landOf(chart, { fixed: [], origin: [0, 0], heights: heightsOf(highest_water_m, decks) });

test("a tide of 3.3 m covers neither land nor quays of a chart", () => {
  const coast = partsOf([area("coast", square(0, 0, 300))], 3.3);
  expect(reach(coast.ground)[1]).toBeCloseTo(4.8, 9);
  const quay = partsOf([area("quay", square(0, 0, 60))], 3.3);
  expect(reach(quay.built)[1]).toBeCloseTo(5.25, 9);
  const bank: ChartInfo = { ...FEATURE, kind: "coast", shape: "line", lines: [square(0, 0, 300)] };
  expect(reach(partsOf([bank], 3.3).ground)[1]).toBeGreaterThan(3.3);
  // Buildings stand on the ground.
  const house = partsOf([area("building", square(0, 0, 20))], 3.3);
  expect(reach(house.built)[1]).toBeGreaterThan(4.8 + 8);
});

test("a pontoon keeps its height above the water", () => {
  for (const highest_water_m of [0, 1, 6]) {
    const { afloat, built, ground } = partsOf([area("pontoon", square(0, 0, 20))], highest_water_m);
    expect(reach(afloat)).toEqual([-1, 0.9]);
    expect([built.triangles, ground.triangles]).toEqual([0, 0]);
  }
});

test("land and quays of a chart are as high as where tides are small, or as the lowest known quay", () => {
  expect(heightsOf(0, [])).toEqual({ quay_m: 3.5, ground_m: 3 });
  expect(heightsOf(-2, [])).toEqual({ quay_m: 3.5, ground_m: 3 });
  expect(heightsOf(4, [])).toEqual({ quay_m: 6, ground_m: 5.5 });
  expect(heightsOf(1, [7, 5.2])).toEqual({ quay_m: 5.2, ground_m: 4.7 });
  expect(heightsOf(1, [2])).toEqual({ quay_m: 3.5, ground_m: 3 });
});

test("a dolphin, a ship and a quay without bollards tell nothing about the height of the land", () => {
  const bollard = (body: number, above_water_m: number) => ({ body, above_water_m });
  const hello = {
    bodies: [
      { fixed: true, outline: square(0, 0, 200) },
      { fixed: true, outline: square(0, 0, 15) },
      { fixed: false, outline: square(0, 0, 100) },
      { fixed: true, outline: square(0, 0, 200) },
      { fixed: true, outline: [] },
    ],
    bollards: [bollard(0, 5.4), bollard(0, 5), bollard(1, 9), bollard(2, 3), bollard(3, 0)],
    lines: [{ end: { body: 4, at_m: [0, 0], above_water_m: 6.4 } }, { end: null }],
  } as unknown as Hello;
  const [quay, shore, ...more] = knownQuays(hello);
  expect(quay).toBeCloseTo(4.6, 9);
  expect(shore).toBeCloseTo(6, 9);
  expect(more).toEqual([]);
});

test("high water covers no lamp of a beacon, and beacons are as ever where tides are small", () => {
  const top = (highest_water_m: number) => {
    const solids = new Solids();
    const rise_m = riseOf(heightsOf(highest_water_m, []));
    mark({ ...FEATURE, kind: "beacon" }, [0, 0], solids, rise_m);
    return [...reach(solids), lampHeight({ ...FEATURE, kind: "beacon" }, rise_m)];
  };
  const [foot = 0, high = 0, lamp = 0] = top(0);
  expect(lamp).toBe(9.5);
  const [lower, higher, lifted] = top(7);
  expect(lower).toBeCloseTo(foot, 9);
  expect(higher).toBeCloseTo(high + 5.5, 9);
  expect(lifted).toBeCloseTo(lamp + 5.5, 9);
  expect(lampHeight(FEATURE, 5.5)).toBe(5.2);
});
