import { expect, test } from "vitest";
import type { Camera } from "../src/geometry";
import { toScreen } from "../src/geometry";
import { Placing, inside } from "../src/placing";
import type { BodyNow, Hello, OtherAction, Pair } from "../src/protocol";

const OUTLINE: Pair[] = [
  [-90, -15],
  [90, -15],
  [90, 15],
  [-90, 15],
];
const hello = {
  vessels: [{ name: "ship", body: 1 }],
  bodies: [{ outline: [] }, { outline: OUTLINE }],
} as unknown as Hello;
const ship: BodyNow = [100, 50, 0, 0, 0, 0];
const bodies = [null, ship];
const camera: Camera = { centre: [100, 50], pixels_per_m: 2, up_rad: 0, width: 800, height: 600 };

test("a point is inside a hull or not", () => {
  expect(inside(OUTLINE, [80, 10])).toBe(true);
  expect(inside(OUTLINE, [80, 16])).toBe(false);
  expect(inside(OUTLINE, [-91, 0])).toBe(false);
});

test("a drag places a ship from where she was gripped, and the knob turns her", async () => {
  const given: OtherAction[] = [];
  const placing = new Placing(
    (action) => {
      given.push(action);
      return Promise.resolve(true);
    },
    () => {},
  );
  placing.of(hello);
  const at = (place: Pair) => toScreen(camera, place);
  // Before the tab is shown nothing is gripped.
  expect(placing.takes(camera, hello, bodies, 1, at([100, 50]))).toBe(false);
  placing.on = true;
  expect(placing.takes(camera, hello, bodies, 1, at([170, 55]))).toBe(true);
  // Another finger drags nothing.
  expect(placing.move(camera, 2, at([0, 0]))).toBe(false);
  placing.move(camera, 1, at([180, 95]));
  expect(placing.end(1, true)).toBe(true);
  await Promise.resolve();
  expect(given).toEqual([{ do: "place", vessel: "ship", at_m: [110, 90], heading_rad: 0 }]);
  await new Promise((done) => setTimeout(done));
  const knob = placing.knob(camera, hello, bodies);
  expect(knob).not.toBeNull();
  expect(placing.takes(camera, hello, bodies, 1, knob ?? [0, 0])).toBe(true);
  placing.move(camera, 1, at([100, 250]));
  placing.end(1, true);
  expect(given[1]).toMatchObject({ at_m: [100, 50] });
  expect((given[1] as { heading_rad: number }).heading_rad).toBeCloseTo(Math.PI / 2, 6);
  // A cancelled drag gives nothing.
  placing.takes(camera, hello, bodies, 1, at([100, 50]));
  placing.end(1, false);
  expect(given).toHaveLength(2);
});
