import { expect, test } from "vitest";
import { stations, tugDirection } from "../src/controls/orders";
import type { Pair } from "../src/protocol";

const DEG = Math.PI / 180;
const degrees = (rad: number) => Math.round(rad / DEG);

test("at the port side a push is to starboard and a pull to port, and leads turn them towards bow or stern", () => {
  const port: Pair = [70, -16];
  expect(degrees(tugDirection(port, "push", 0, 32))).toBe(90);
  expect(degrees(tugDirection(port, "pull", 0, 32))).toBe(-90);
  expect(degrees(tugDirection(port, "push", 1, 32))).toBe(45);
  expect(degrees(tugDirection(port, "push", -1, 32))).toBe(135);
});

test("at the starboard side all is mirrored", () => {
  const starboard: Pair = [-70, 16];
  expect(degrees(tugDirection(starboard, "push", 0, 32))).toBe(-90);
  expect(degrees(tugDirection(starboard, "pull", 1, 32))).toBe(45);
});

test("on the centre line she pushes along the ship, and pulls away from the end where she is", () => {
  const astern: Pair = [-110, 0];
  expect(degrees(tugDirection(astern, "push", 0, 32))).toBe(0);
  expect(Math.abs(degrees(tugDirection(astern, "pull", 0, 32)))).toBe(180);
  expect(degrees(tugDirection(astern, "pull", 1, 32))).toBe(135);
  expect(degrees(tugDirection([110, 1], "pull", 1, 32))).toBe(45);
});

test("places to push at lie on the hull's outline", () => {
  const outline: Pair[] = [
    [-100, -15],
    [70, -15],
    [100, 0],
    [70, 15],
    [-100, 15],
  ];
  const found = stations(outline, 200);
  expect(found.map((s) => s.name)).toEqual([
    "port shoulder",
    "port midships",
    "port quarter",
    "starboard shoulder",
    "starboard midships",
    "starboard quarter",
  ]);
  for (const { at_m, side } of found) expect(at_m[1] * side).toBe(15);
});
