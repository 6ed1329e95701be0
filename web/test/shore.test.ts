/** Marks, land and structures of the chart in the view out of the window. */
import { expect, test } from "vitest";
import { heightsOf, knownQuays } from "../src/bridge/heights";
import { landOf } from "../src/bridge/land";
import { cablesOf } from "../src/bridge/structures";
import { stripsAlong } from "../src/bridge/strips";
import { area2 } from "../src/bridge/berth";
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

test("the light of a dolphin stands over the dolphin, that of a mooring buoy floats", () => {
  const buoy = at("mooring", [0, 0]);
  const dolphin = { ...at("mooring", [50, 0]), meaning: null };
  const [first, second] = [at("light", [0, 0]), at("light", [50, 0])];
  const carriers = carriersOf([buoy, dolphin, first, second]);
  expect([carriers.get(first), carriers.get(second)]).toEqual([buoy, dolphin]);
  expect([floats(buoy), floats(dolphin)]).toEqual([true, false]);
  expect([lampHeight(buoy, 2), lampHeight(dolphin, 2)]).toEqual([1.6, 6.5]);
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
  landOf(chart, {
    fixed: [],
    origin: [0, 0],
    heights: heightsOf(highest_water_m, decks),
    high_water_m: highest_water_m,
  });

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

const line = (kind: ChartInfo["kind"], places: Pair[], clearance_m: number | null = null) =>
  ({ ...FEATURE, kind, clearance_m, shape: "line", lines: [places] }) satisfies ChartInfo;

/** Least and greatest coordinate of a part: north, east and up [m]. */
function box({ positions }: Solids): Pair[] {
  const axis = (k: number, sign: number): Pair => {
    const all = positions.filter((_, i) => i % 3 === k).map((v) => sign * v);
    return [Math.min(...all), Math.max(...all)];
  };
  return [axis(2, -1), axis(0, 1), axis(1, 1)];
}

/** Whether each edge of the triangles has a triangle on its other side: no hole. */
function isClosed({ positions }: Solids): boolean {
  const edges = new Map<string, number>();
  const corner = (k: number) =>
    positions
      .slice(3 * k, 3 * k + 3)
      .map((v) => Math.round(v * 1e4) / 1e4 + 0)
      .join();
  for (let k = 0; k < positions.length / 3; k += 3)
    for (let i = 0; i < 3; i++) {
      const [a, b] = [corner(k + i), corner(k + ((i + 1) % 3))];
      edges.set(`${a}>${b}`, (edges.get(`${a}>${b}`) ?? 0) + 1);
    }
  return [...edges].every(([edge, count]) => {
    const [a, b] = edge.split(">");
    return edges.get(`${b}>${a}`) === count;
  });
}

const closeTo = (found: Pair[], wanted: Pair[]) => {
  expect(found.length).toBe(wanted.length);
  found.flat().forEach((v, i) => expect(v).toBeCloseTo(wanted.flat()[i] ?? Number.NaN, 6));
};

test("a line has strips that meet in common corners, and straight ends at sharp turns", () => {
  const bent = stripsAlong(
    [
      [0, 0],
      [0, 100],
      [0, 100.01],
      [50, 200],
      [-100, 200],
    ],
    () => [2, 2],
  );
  expect(bent.length).toBe(3);
  const [first, second, third] = bent.map(({ ring }) => ring);
  if (!first || !second || !third) throw new Error("three strips");
  expect(second[0]).toEqual(first[1]);
  expect(second[3]).toEqual(first[2]);
  // At right angles and more the strip ends straight: its area is length by width.
  expect(Math.abs(area2(third)) / 2).toBeCloseTo(4 * 150, 6);
  for (const ring of [first, second, third]) expect(area2(ring)).toBeGreaterThan(0);
  expect(stripsAlong([[0, 0]], () => [2, 2])).toEqual([]);
  expect(
    stripsAlong(
      [
        [0, 0],
        [0, 9],
      ],
      () => null,
    ),
  ).toEqual([]);
});

test("a pier of which the chart has only the line is a closed wall as wide as the run makes it solid", () => {
  const pier: Pair[] = [
    [0, 0],
    [0, 100],
  ];
  const { built } = partsOf([line("quay", pier)], 3.3);
  closeTo(box(built), [
    [-1.95, 1.95],
    [0, 100],
    [-9, 5.25],
  ]);
  const { afloat } = partsOf([line("pontoon", pier)], 3.3);
  closeTo(box(afloat), [
    [-1.95, 1.95],
    [0, 100],
    [-1, 0.9],
  ]);
});

test("a quay line along a coast has its face on the line and reaches over the bank, not into the water", () => {
  // The line is a part of an edge of the coast, as in `scenarios/harbours/bend.toml`.
  const land = area("coast", square(0, -500, 1000));
  const front: Pair[] = [
    [0, -100],
    [0, 100],
  ];
  for (const [coast, quay] of [
    [land.lines[0] ?? [], front],
    [(land.lines[0] ?? []).toReversed(), front],
    [land.lines[0] ?? [], front.toReversed()],
  ] as const) {
    const { built } = partsOf([area("coast", coast), line("quay", quay)], 0);
    // A bank of 7 m, and half a metre over its crest.
    closeTo(box(built), [
      [0.05, 7.5],
      [-100, 100],
      [-9, 3.45],
    ]);
  }
  // In a dock in the land the water is inside the ring.
  const dock = { ...land, lines: [square(-500, -1000, 2000), square(-400, -400, 400)] };
  const { built } = partsOf([dock, line("quay", front)], 0);
  expect(box(built)[0]?.[0]).toBeCloseTo(0.05, 6);
  // A pier that leaves the coast is a wall to both sides.
  const pier = partsOf(
    [
      land,
      line("quay", [
        [0, 0],
        [-3, 0],
      ]),
    ],
    0,
  );
  closeTo(box(pier.built).slice(0, 2), [
    [-3, 0],
    [-1.95, 1.95],
  ]);
});

test("a quay line along a quay area, and a pontoon line along a pontoon, are drawn once", () => {
  const front: Pair[] = [
    [0, 10],
    [0, 50],
  ];
  for (const kind of ["quay", "pontoon"] as const) {
    const whole = area(kind, square(0, 0, 60));
    const [once, both] = [partsOf([whole], 0), partsOf([whole, line(kind, front)], 0)];
    expect(both.built.triangles).toBe(once.built.triangles);
    expect(both.afloat.triangles).toBe(once.afloat.triangles);
  }
});

test("a quay line is no higher than the deck of a body that stands on it", () => {
  const ring = square(-1, 20, 30);
  const { built } = landOf(
    [
      line("quay", [
        [0, 0],
        [0, 100],
      ]),
    ],
    { fixed: [{ ring, deck_m: 2.4 }], origin: [0, 0], heights: heightsOf(0, []), high_water_m: 0 },
  );
  expect(reach(built)[1]).toBeCloseTo(2.35, 9);
});

test("a mooring point is a dolphin above the highest water, but not on a body of the run", () => {
  const dolphin = { ...at("mooring", [40, 60]), meaning: null, side: null, colour: null };
  const { built } = partsOf([dolphin], 4);
  closeTo(box(built), [
    [38.5, 41.5],
    [58.5, 61.5],
    [-9, 6],
  ]);
  // A mooring buoy floats.
  const buoy = partsOf([{ ...dolphin, meaning: "other", side: null, colour: "yellow" }], 4);
  expect(buoy.built.triangles).toBe(0);
  expect(reach(buoy.afloat)).toEqual([-0.6, 1.3]);
  const fixed = [{ ring: square(35, 55, 10), deck_m: 5 }];
  const site = { fixed, origin: [0, 0] as Pair, heights: heightsOf(4, []), high_water_m: 4 };
  expect(landOf([dolphin], site).built.triangles).toBe(0);
  const cap = partsOf([area("mooring", square(0, 0, 8))], 4);
  expect(reach(cap.built)[1]).toBeCloseTo(6.02, 9);
});

test("a bridge is a closed slab whose underside is its clearance above high water", () => {
  const across: Pair[] = [
    [0, -200],
    [0, 200],
  ];
  const { built } = partsOf([line("bridge", across, 30)], 2);
  closeTo(box(built), [
    [-5, 5],
    [-200, 200],
    [32, 33.8],
  ]);
  const bent: Pair[] = [
    [0, 0],
    [0, 90],
    [30, 90],
    [30, 30],
    [60, 30],
    [60, 0],
  ];
  const slab = partsOf([{ ...area("bridge", bent), clearance_m: 30 }], 2);
  expect(isClosed(slab.built)).toBe(true);
  expect(reach(slab.built)).toEqual([32, 33.8]);
  // The chart does not tell how high it is.
  expect(partsOf([line("bridge", across)], 2).built.triangles).toBe(0);
});

test("an overhead cable hangs at its clearance above high water", () => {
  const across: Pair[] = [
    [1000, -200],
    [1010, 200],
  ];
  const site = { fixed: [], origin: [1000, 0] as Pair, heights: heightsOf(1, []), high_water_m: 2 };
  expect(
    cablesOf([line("overhead_cable", across, 44), line("overhead_cable", across)], site),
  ).toEqual([
    [
      [1000, -200, 46],
      [1010, 200, 46],
    ],
  ]);
});
