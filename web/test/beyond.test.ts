import { expect, test } from "vitest";
import { leaving } from "../src/draw/beyond";

const PLAN = { width: 800, height: 500 };

test("what is on the plan has no pointer", () => {
  expect(leaving(PLAN, [400, 250], 0)).toBeNull();
  expect(leaving(PLAN, [0, 500], 0)).toBeNull();
});

test("what is off the plan is pointed at from the edge on its side, clear of the buttons below", () => {
  const right = leaving(PLAN, [2000, 232], 0);
  expect(right?.tip[0]).toBeCloseTo(790);
  expect(right?.tip[1]).toBeCloseTo(232);
  expect(right?.along[0]).toBeCloseTo(1);
  const below = leaving(PLAN, [400, 5000], 0);
  expect(below?.tip[1]).toBeCloseTo(422);
  expect(below?.along[1]).toBeCloseTo(1);
  const corner = leaving(PLAN, [-390, -206], 40);
  expect(corner?.tip[0]).toBeGreaterThanOrEqual(10);
  expect(corner?.tip[1]).toBeGreaterThanOrEqual(82 - 1e-9);
});
