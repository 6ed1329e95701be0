import { expect, test } from "vitest";
import { type Box, type Label, Rank, nearest, overlap, place } from "../src/draw/labels";

const AREA: [number, number] = [800, 500];
/** Texts of equal letters. */
const width = ({ text, size }: Label) => text.length * size * 0.6;
const label = (key: string, at: [number, number], rank = Rank.Tug): Label => ({
  key,
  text: key,
  rank,
  at,
  colour: "#000000",
  size: 13,
});

/** Pairs of boxes that overlap. */
const overlaps = (boxes: Box[]) =>
  boxes.flatMap((a, i) => boxes.slice(i + 1).filter((b) => overlap(a, b)));

test("a label without neighbours is where it belongs", () => {
  const [only] = place([{ ...label("tug", [300, 200]), off: [0, 20] }], AREA, [], new Map(), width);
  expect(only?.place).toBe(0);
  expect(only && [only.box[0] + only.box[2] / 2, only.box[1] + only.box[3] / 2]).toEqual([
    300, 220,
  ]);
});

test("labels at one point lie beside each other, and those that matter most have the best places", () => {
  const all = ["a", "b", "c", "d", "e"].map((key) => label(`tug ${key}`, [300, 200]));
  const first = label("2.5 m", [300, 200], Rank.Distance);
  const placed = place([...all, first], AREA, [], new Map(), width);
  expect(placed.length).toBe(6);
  expect(overlaps(placed.map(({ box }) => box))).toEqual([]);
  expect(placed.find((p) => p.label.key === "2.5 m")?.place).toBe(0);
  // Those away from their point have a leader to it.
  for (const { box, leads } of placed) {
    const [x, y] = nearest(box, [300, 200]);
    expect(leads).toBe(Math.hypot(x - 300, y - 200) > 15);
  }
});

test("two hundred labels at random do not overlap, stay on the canvas, and only names are left out", () => {
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const many = Array.from({ length: 200 }, (_, i) =>
    label(`label ${i}`, [random() * 800, random() * 500], i % 8 === 0 ? Rank.Fender : Rank.Bollard),
  );
  const taken: Box[] = [[600, 440, 200, 60]];
  const placed = place(many, AREA, taken, new Map(), width);
  const boxes = placed.map(({ box }) => box);
  expect(overlaps([...boxes, ...taken])).toEqual([]);
  for (const [x, y, w, h] of boxes)
    expect(x >= 0 && y >= 0 && x + w <= 800 && y + h <= 500).toBe(true);
  expect(placed.filter((p) => p.label.rank === Rank.Fender).length).toBe(25);
  // The same labels have the same places.
  expect(place(many, AREA, taken, new Map(), width)).toEqual(placed);
});

test("a label keeps its place while that is free, so that it does not jump to and fro", () => {
  const [a, b] = [label("a", [300, 200], Rank.Distance), label("b", [300, 200])];
  const both = place([a, b], AREA, [], new Map(), width);
  const before = new Map(both.map((p) => [p.label.key, p.place]));
  expect(before.get("b")).toBeGreaterThan(0);
  const alone = place([b], AREA, [], before, width);
  expect(alone[0]?.place).toBe(before.get("b"));
  expect(place([b], AREA, [], new Map(), width)[0]?.place).toBe(0);
});

test("a clamped label near the edge is moved onto the canvas; one far off is not drawn", () => {
  const edge = { ...label("0.12 m/s", [-40, 250], Rank.Speed), clamped: true };
  const far = { ...label("far", [-400, 250], Rank.Speed), clamped: true };
  const placed = place([edge, far, label("off", [-1, 20])], AREA, [], new Map(), width);
  expect(placed.map((p) => p.label.key)).toEqual(["0.12 m/s"]);
  expect(placed[0]?.box[0]).toBeGreaterThanOrEqual(0);
});
