/** Marks in the view out of the window: their numbers are those of the frame. */
import { describe, expect, test } from "vitest";
import {
  MOST_GHOSTS,
  arrow,
  colourOf,
  MEASURED_STROKES,
  figures,
  measuredStrokes,
  pathStrokes,
  resampled,
} from "../src/bridge/in_picture";
import { arrangementOf } from "../src/bridge/arrangement";
import type { Triple } from "../src/bridge/axes";
import { PIECES } from "../src/bridge/catenary";
import { blocksOf, hides } from "../src/bridge/hidden";
import { broken } from "../src/bridge/written";
import { type Placed, placed } from "../src/bridge/labels";
import { History } from "../src/history";
import type { Frame, Hello, Pair, PathPoint } from "../src/protocol";

const DEG = Math.PI / 180;

test("an arrow points where the force points, its tip where the force acts", () => {
  const [shaft, head] = arrow([10, 2, -5], [0, -1e6], 0xffffff);
  if (!shaft || !head) throw new Error("shaft and head");
  expect(shaft.points.at(-1)).toEqual([10, 2, -5]);
  const [x, y, z] = shaft.points[0] ?? [0, 0, 0];
  // To the north is −z: the tail of a meganewton is 14 m south.
  expect([x, y]).toEqual([10, 2]);
  expect(z).toBeCloseTo(-5 + 14, 9);
  expect(head.points[PIECES / 2]).toEqual([10, 2, -5]);
  expect(arrow([0, 0, 0], [0, 0], 0)).toEqual([]);
});

test("a measured ship is a cage about her outline at the place and heading of the log", () => {
  const outline: Pair[] = [
    [50, 0],
    [-50, 8],
    [-50, -8],
  ];
  const east = 90 * DEG;
  const strokes = measuredStrokes(outline, [0, 100, 200, east], ([n, e], up) => [e, up, -n]);
  expect(strokes.length).toBe(MEASURED_STROKES);
  const [x, y, z] = strokes[0]?.points[0] ?? [0, 0, 0];
  // Her bow is 50 m east of her middle, at the waterline first.
  expect(x).toBeCloseTo(250, 9);
  expect(y).toBeLessThan(1);
  expect(z).toBeCloseTo(-100, 9);
  const post = strokes.at(-1)?.points ?? [];
  expect([post[0]?.[0], post[0]?.[2]]).toEqual([post.at(-1)?.[0], post.at(-1)?.[2]]);
  expect(measuredStrokes([], [0, 0, 0, 0], () => [0, 0, 0])).toEqual([]);
});

test("the arrow of a pull begins where the line holds, so that the ship does not hide the arrow", () => {
  const [shaft] = arrow([10, 2, -5], [0, -1e6], 0xffffff, true);
  expect(shaft?.points[0]).toEqual([10, 2, -5]);
  expect(shaft?.points.at(-1)?.[2]).toBeCloseTo(-5 - 14, 9);
});

test("a word is not written where a hull or a house hides its place", () => {
  const outline: Pair[] = [
    [-90, -15],
    [90, -15],
    [90, 15],
    [-90, 15],
  ];
  const vessel = { title: "bulker", length_m: 180, beam_m: 30, draught_m: 10, is_tug: false };
  const ship = arrangementOf(vessel, outline);
  const blocks = blocksOf(ship);
  // In the axes of the ship: to starboard, up, astern.
  const seen = (eye: Triple, at: Triple) => !blocks.some((block) => hides(block, eye, at));
  // From a boat to port: what is to starboard is hidden below the deck and behind the house, not above the hatches.
  expect(seen([-100, 2, 0], [60, 2, 0])).toBe(false);
  expect(seen([-100, 2, 0], [60, ship.deck_m + 12, 0])).toBe(true);
  const house = -(ship.house.aft_m + ship.house.fore_m) / 2;
  expect(seen([-100, 12, house], [60, 12, house])).toBe(false);
  // Round the bow and round the stern the way is free.
  expect(seen([-100, 2, -95], [60, 2, -95])).toBe(true);
  expect(seen([-100, 2, 95], [60, 2, 95])).toBe(true);
  // From the port wing: a fender at the port side is seen, one at the starboard side is not.
  const wing: Triple = [-15.3, ship.house.bridge_deck_m + 1.8, -ship.bridge.fore_m];
  expect(seen(wing, [-15, 3, -40])).toBe(true);
  expect(seen(wing, [15, 3, -40])).toBe(false);
  // A line from the deck to a bollard ashore, as the bollard sees it.
  expect(seen([-45, 6, 0], [-30, 7, -20])).toBe(true);
});

test("loads below, near and over their limit have different colours", () => {
  expect(new Set([0.1, 0.5, 0.9, 1].map(colourOf)).size).toBe(4);
  expect(colourOf(7)).toBe(colourOf(1));
});

test("a predicted path lies on the water with the ship's outline each minute", () => {
  const path: PathPoint[] = Array.from({ length: 37 }, (_, i) => [100 + 10 * i, 5 * i, 0, 0]);
  const outline: Pair[] = [
    [-10, -3],
    [10, -3],
    [10, 3],
    [-10, 3],
  ];
  const strokes = pathStrokes({ vessel: 0, path }, outline, ([n, e]) => [e, 0.4, -n]);
  // Six minutes: the path and six outlines.
  expect(strokes.length).toBe(7);
  for (const { points } of strokes) expect(points.length).toBe(PIECES + 1);
  expect(strokes[0]?.points.at(-1)).toEqual([0, 0.4, -180]);
  const bow = Math.min(...(strokes[1]?.points ?? []).map(([, , z]) => z));
  expect(bow).toBeCloseTo(-(30 + 10), 9);
  const long: PathPoint[] = Array.from({ length: 400 }, (_, i) => [60 * i, i, 0, 0]);
  expect(
    pathStrokes({ vessel: 0, path: long }, outline, () => [0, 0, 0]).length,
  ).toBeLessThanOrEqual(MOST_GHOSTS);
  expect(pathStrokes({ vessel: 0, path: [] }, outline, () => [0, 0, 0])).toEqual([]);
  expect(resampled([])).toEqual([]);
});

describe("figures", () => {
  const hello = { vessels: [{ body: 0 }] } as unknown as Hello;
  const frame = (berth: object | null, turn = 0.001): Frame =>
    ({
      bodies: [[0, 0, 20 * DEG, 0, 0, turn]],
      vessels: [{ ground_mps: [1, -0.2], berth, under_keel_m: berth ? 3.25 : null }],
      wind: { speed_mps: 10, from_rad: Math.PI },
    }) as unknown as Frame;

  test("have heading, rate of turn and speeds, and at a berth distances and closing speeds", () => {
    expect(figures(frame(null), hello, 0)).toEqual([
      "020.0°, starboard 3.4°/min; 1.9 kn ahead, 0.4 kn to port",
      "Wind 19 kn from 180°",
    ]);
    const ends = { bow: "off", stern: "at_fenders" };
    const berth = { ...ends, bow_m: 34.2, stern_m: -0.4, bow_mps: 0.12, stern_mps: -0.034 };
    expect(figures(frame(berth, 0), hello, 0)).toEqual([
      "020.0°, steady; 1.9 kn ahead, 0.4 kn to port",
      "Bow 34.2 m off, 0.12 m/s closing; stern 0.4 m pressed in, 0.03 m/s opening",
      "Wind 19 kn from 180°; 3.3 m under the keel",
    ]);
    // The row above the picture has the rest.
    expect(figures(frame(berth, 0), hello, 0, 0, true)).toEqual([
      "Bow 34.2 m off, 0.12 m/s closing; stern 0.4 m pressed in, 0.03 m/s opening",
    ]);
    expect(figures(frame(null), hello, 0, 0, true)).toEqual([]);
    const past = { ...berth, stern: "no_fender" };
    expect(figures(frame(past, 0), hello, 0)[1]).toContain("stern 0.4 m behind the fender line");
    const there = { ...berth, stern_m: -0.04 };
    expect(figures(frame(there, 0), hello, 0)[1]).toContain("stern 0 m off");
  });

  test("are none of a vessel that fog hides", () => {
    const hidden = { bodies: [null], vessels: [{}] } as unknown as Frame;
    expect(figures(hidden, hello, 0)).toEqual([]);
    expect(figures(frame(null), hello, 3)).toEqual([]);
  });
});

test("the moment of the largest fender load is that of the charts", () => {
  const history = new History();
  expect(history.largest_s()).toBeNull();
  const sample = (t_s: number, of_energy: number, of_reaction: number, contact_mn: number) =>
    ({ t_s, of_energy, of_reaction, contact_mn }) as unknown as History["samples"][number];
  history.samples = [sample(0, 0, 0, 0)];
  expect(history.largest_s()).toBeNull();
  history.samples.push(sample(10, 20, 55, 1), sample(20, 61, 40, 2), sample(30, 10, 10, 9));
  expect(history.largest_s()).toBe(20);
  // Fenders without rating: the forces alone.
  history.samples = [sample(0, 0, 0, 0.2), sample(5, 0, 0, 0.9), sample(9, 0, 0, 0.1)];
  expect(history.largest_s()).toBe(5);
});

describe("labels in the picture", () => {
  const label = (text: string, x: number, y: number, level: Placed["level"] = "plain") => ({
    text,
    x,
    y,
    level,
  });

  test("one that would lie under the words is below them", () => {
    const all = placed([label("under", 100, 40), label("free", 500, 40)], [300, 80]);
    expect(all.map(({ text, y }) => [text, y])).toEqual([
      ["under", 104],
      ["free", 40],
    ]);
  });

  // Once labels were moved after those that lie on each other had been left out: a plain one hid an alarm.
  test("of two that are moved to the same place the gravest is written", () => {
    const all = placed([label("plain", 100, 30), label("alarm", 110, 70, "alarm")], [300, 80]);
    expect(all.map(({ text }) => text)).toEqual(["alarm"]);
  });

  test("of two that lie on each other the gravest is written", () => {
    const all = placed([label("plain", 500, 200), label("caution", 520, 210, "caution")], [0, 0]);
    expect(all.map(({ text }) => text)).toEqual(["caution"]);
  });
});

// In a narrow page the figures stand in several lines, and ran out of their box in a saved picture.
test("words that are written into a picture are broken where they would leave their box", () => {
  const width = (text: string) => text.length;
  expect(broken("Bow 40.5 m off; stern 44.9 m off", 16, width)).toEqual([
    "Bow 40.5 m off;",
    "stern 44.9 m off",
  ]);
  expect(broken("short", 16, width)).toEqual(["short"]);
  expect(broken("a word that-is-wider-than-its-box", 10, width)).toEqual([
    "a word",
    "that-is-wider-than-its-box",
  ]);
});
