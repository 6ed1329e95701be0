/** Hulls and quays by outlines at several heights: the surface that contact uses is the surface that is drawn. */
import { expect, test } from "vitest";
import { arrangementOf } from "../src/bridge/arrangement";
import { fixedParts } from "../src/bridge/berth";
import { cut } from "../src/bridge/blocks";
import { reach, ringAt } from "../src/bridge/levels";
import { PAINTS, hullParts } from "../src/bridge/ship";
import { Solids } from "../src/bridge/solids";
import { TUG_PAINT } from "../src/bridge/tug";
import type { LevelInfo, Pair } from "../src/protocol";

const both = (starboard: Pair[]): Pair[] => [
  ...starboard.map(([f, s]): Pair => [f, -s]),
  ...starboard.toReversed(),
];
/** The ship of `scenarios/berth/bow_flare_on_a_fender.toml`: flare at the bow, a counter at the stern. */
const LEVELS: LevelInfo[] = [
  {
    height_m: -6,
    outline: both([
      [-78, 4],
      [-66, 10],
      [-40, 12.5],
      [30, 12.5],
      [55, 8],
      [70, 3.5],
      [82, 0.5],
    ]),
  },
  {
    height_m: 0,
    outline: both([
      [-82, 9],
      [-68, 12.5],
      [-40, 13.5],
      [30, 13.5],
      [55, 10],
      [72, 5],
      [82, 0.5],
    ]),
  },
  {
    height_m: 8,
    outline: both([
      [-84, 12.5],
      [-70, 13.5],
      [-40, 13.5],
      [30, 13.5],
      [55, 12.8],
      [73, 10],
      [86, 2.5],
    ]),
  },
];
const WATERLINE = LEVELS[1]?.outline ?? [];
const SHIP = arrangementOf(
  { title: "feeder", length_m: 160, beam_m: 27, draught_m: 8, is_tug: false, levels: LEVELS },
  WATERLINE,
);

/** Distance of a place from a ring [m]. */
function off(ring: Pair[], [f, s]: Pair): number {
  return Math.min(
    ...ring.map(([a, b], i) => {
      const [c, d] = ring[(i + 1) % ring.length] ?? [a, b];
      const long2 = (c - a) ** 2 + (d - b) ** 2;
      const share = Math.min(
        1,
        Math.max(0, ((f - a) * (c - a) + (s - b) * (d - b)) / (long2 || 1)),
      );
      return Math.hypot(f - a - share * (c - a), s - b - share * (d - b));
    }),
  );
}

test("an outline between two heights lies between both, and beyond them it stays", () => {
  expect(ringAt(LEVELS, 0)).toEqual(WATERLINE);
  expect(ringAt(LEVELS, 4)[5]).toEqual([72.5, -7.5]);
  expect(ringAt(LEVELS, 20)).toEqual(LEVELS[2]?.outline);
  expect(ringAt(LEVELS, -9)).toEqual(LEVELS[0]?.outline);
  expect(reach(WATERLINE, 0)).toEqual([-13.5, 13.5]);
  expect(reach(WATERLINE, -82)).toEqual([-9, 9]);
});

test("each corner of the drawn shell lies on the surface of the outlines, and no corner is missing", () => {
  const shell = new Solids();
  hullParts(SHIP, PAINTS[0] ?? TUG_PAINT, shell);
  const spots: [number, number, number][] = [];
  for (let i = 0; i < shell.positions.length; i += 3) {
    const [x = 0, y = 0, z = 0] = shell.positions.slice(i, i + 3);
    spots.push([-z, x, y]);
  }
  // The deck's middle and its corners inside the bulwark lie within the outline.
  const outer = spots.filter(([, , up]) => up < 7.99);
  expect(outer.length).toBeGreaterThan(500);
  for (const [f, s, up] of outer)
    expect(off(ringAt(LEVELS, up), [f, s]), `${f} ${s} ${up}`).toBeLessThan(0.02);
  for (const { height_m, outline } of LEVELS)
    for (const [f, s] of outline) {
      const nearest = Math.min(
        ...spots.map(([f2, s2, up]) => Math.hypot(f2 - f, s2 - s, up - height_m)),
      );
      expect(nearest, `${f} ${s} ${height_m}`).toBeLessThan(0.05);
    }
  expect(SHIP.deck_m).toBe(8);
  expect([SHIP.hull.aft_m, SHIP.hull.fore_m]).toEqual([-84, 86]);
});

test("the shell is flat between its corners, and nowhere far from the surface of the outlines", () => {
  const shell = new Solids();
  hullParts(SHIP, PAINTS[0] ?? TUG_PAINT, shell);
  let worst = 0;
  for (let i = 0; i < shell.positions.length; i += 9) {
    const middle = [0, 1, 2].map((axis) =>
      [0, 3, 6].reduce((sum, k) => sum + (shell.positions[i + axis + k] ?? 0) / 3, 0),
    );
    const [s = 0, up = 0, aft = 0] = middle;
    const ring = ringAt(LEVELS, up);
    // What lies well within the outline is deck, transom or the flat of the stem.
    const within = off(ring, [-aft, s]);
    if (up > -0.5 && up < 7.9 && within < 1) worst = Math.max(worst, within);
  }
  expect(worst).toBeGreaterThan(0);
  // Where a corner of the outlines wanders along the hull with the height, a column of the shell cuts the corner.
  expect(worst).toBeLessThan(0.16);
});

test("a flat bow keeps its width whatever the rounding of its coordinates", () => {
  // The end of the hull, by its share of the length, is beyond its foremost corner by one unit in the last place.
  const barge: Pair[] = [
    [-76.8, -9],
    [25.6, -9],
    [25.6, 9],
    [-76.8, 9],
  ];
  const levels = [-3, 0, 4].map((height_m) => ({ height_m, outline: barge }));
  const { hull } = arrangementOf(
    { title: "barge", length_m: 102.4, beam_m: 18, draught_m: 3, is_tug: false, levels },
    barge,
  );
  for (const f of [hull.aft_m, hull.fore_m])
    for (const up of [-3, 0, 2, 4, 9]) {
      expect(hull.side(f, up, 1)[1]).toBeCloseTo(9);
      expect(hull.side(f, up, -1)[1]).toBeCloseTo(-9);
    }
});

test("a quay wall that leans is drawn as it leans, up to its highest outline", () => {
  const square = (by: number): Pair[] => [
    [-50 - by, -10 - by],
    [50 + by, -10 - by],
    [50 + by, 10 + by],
    [-50 - by, 10 + by],
  ];
  const parts = new Solids();
  const levels = [
    { height_m: -4, outline: square(2) },
    { height_m: 3, outline: square(0) },
  ];
  fixedParts(square(1), 3, cut, parts, levels);
  const corners: number[][] = [];
  for (let i = 0; i < parts.positions.length; i += 3) {
    const [x = 0, y = 0, z = 0] = parts.positions.slice(i, i + 3);
    corners.push([-z, x, y]);
  }
  const widest = (up: number) =>
    Math.max(...corners.filter((at) => Math.abs((at[2] ?? 0) - up) < 1e-6).map((at) => at[0] ?? 0));
  expect(widest(-9)).toBe(52);
  expect(widest(-4)).toBe(52);
  expect(widest(3)).toBe(50);
});
