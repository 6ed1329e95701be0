import { describe, expect, test } from "vitest";
import {
  type Camera,
  between,
  fitted,
  onEarth,
  roundLength,
  toEarth,
  toScreen,
  zoomed,
} from "../src/geometry";
import type { BodyNow, Pair, Frame, Hello } from "../src/protocol";
import { figures } from "../src/bridge/in_picture";
import { waysToBerth } from "../src/ways";

const camera = (up_rad: number): Camera => ({
  centre: [100, 50],
  pixels_per_m: 2,
  up_rad,
  width: 800,
  height: 600,
});
const near = (a: Pair, b: Pair) => {
  expect(a[0]).toBeCloseTo(b[0], 9);
  expect(a[1]).toBeCloseTo(b[1], 9);
};

test("bodies are placed by their heading, from north, positive to starboard", () => {
  const eastward: BodyNow = [10, 20, Math.PI / 2, 0, 0, 0];
  near(onEarth(eastward, [5, 0]), [10, 25]);
  near(onEarth(eastward, [0, 5]), [5, 20]);
});

test("between two ticks a heading turns the short way through north", () => {
  const at = (heading: number): BodyNow => [0, 0, heading, 0, 0, 0];
  const half = between(at(6.2), at(0.1), 0.5)[2];
  expect(Math.cos(half)).toBeCloseTo(Math.cos((6.2 - 2 * Math.PI + 0.1) / 2), 12);
  expect(Math.sin(half)).toBeCloseTo(Math.sin((6.2 - 2 * Math.PI + 0.1) / 2), 12);
});

describe("the camera", () => {
  test("north up: north is up, east is right", () => {
    near(toScreen(camera(0), [110, 50]), [400, 280]);
    near(toScreen(camera(0), [100, 60]), [420, 300]);
  });

  test("head up: the chosen bearing is at the top", () => {
    near(toScreen(camera(Math.PI / 2), [100, 60]), [400, 280]);
  });

  test("the map from earth to screen has an exact inverse at any bearing", () => {
    for (const up of [0, 1, 2.5, -2])
      near(toEarth(camera(up), toScreen(camera(up), [123, -45])), [123, -45]);
  });

  test("zooming keeps the place under the finger", () => {
    for (const up of [0, 1.2]) {
      const before = toEarth(camera(up), [700, 100]);
      near(toEarth(zoomed(camera(up), 3, [700, 100]), [700, 100]), before);
    }
  });

  test("a fitted camera shows all points within the margins", () => {
    const places: Pair[] = [
      [0, 0],
      [230, 10],
      [100, -60],
    ];
    for (const up of [0, 0.7, 3]) {
      const fit = fitted(camera(up), places, [40, 50, 80]);
      for (const place of places) {
        const [x, y] = toScreen(fit, place);
        expect(x).toBeGreaterThan(49.9);
        expect(x).toBeLessThan(750.1);
        expect(y).toBeGreaterThan(39.9);
        expect(y).toBeLessThan(520.1);
      }
    }
  });
});

test("a scale bar has a round length", () => {
  expect([0.9, 1.5, 3, 99, 100, 730].map(roundLength)).toEqual([0.5, 1, 2, 50, 100, 500]);
});

test("far from the berth the board has the way to its nearest place", () => {
  const quay: BodyNow = [0, 0, 0, 0, 0, 0];
  const berth = { from: [-50, 0] as Pair, to: [50, 0] as Pair };
  // 400 m south of the berth's end, heading for it at 2 m/s.
  const ways = waysToBerth(berth, quay, [-450, 0, 0, 2, 0, 0], { length_m: 100 });
  expect(ways?.[0].off_m).toBeCloseTo(350, 9);
  expect(ways?.[1].off_m).toBeCloseTo(450, 9);
  expect(ways?.[0].bearing_rad).toBeCloseTo(0, 9);
  expect(ways?.[0].closing_mps).toBeCloseTo(2, 9);
  // Within a length of the berth distances to the line of the fenders count.
  expect(waysToBerth(berth, quay, [-180, 0, 0, 2, 0, 0], { length_m: 100 })).toBeNull();
});

// The figures over the view had the distance to the line of the fenders, two miles off, where the docking board had the way there.
test("far from the berth the figures have the way to it, as the docking board has", () => {
  const vessel = (bow: string) => ({
    ground_mps: [3, 0],
    under_keel_m: 5,
    berth: { bow, stern: "past_end", bow_m: 20, stern_m: 20, bow_mps: 0, stern_mps: 0 },
  });
  const frame = (bow: string) =>
    ({
      bodies: [
        [-3000, 0, 0, 3, 0, 0],
        [0, 0, 0, 0, 0, 0],
      ],
      vessels: [vessel(bow)],
      wind: { speed_mps: 0, from_rad: 0 },
    }) as unknown as Frame;
  const hello = {
    vessels: [{ body: 0, name: "ship", length_m: 100 }],
    berth: { body: 1, from: [0, 0], to: [200, 0] },
  } as unknown as Hello;
  expect(figures(frame("past_end"), hello, 0, 0, true)).toEqual([
    "Berth bears 000°, 1.59 NM off, 3.0 m/s closing",
  ]);
  expect(figures(frame("off"), hello, 0, 0, true)[0]).toMatch(/^Bow 20 m off/);
  // From a tug, whose own figures come first, the line says that it is about the ship.
  const tug = { ...hello, vessels: [...hello.vessels, { body: 0, name: "tug", length_m: 30 }] };
  const both = {
    ...frame("past_end"),
    vessels: [vessel("past_end"), vessel("off")],
  } as unknown as Frame;
  expect(figures(both, tug as Hello, 1, 0, true)).toEqual([
    "ship: berth bears 000°, 1.59 NM off, 3.0 m/s closing",
  ]);
});
