/** Drops of rain fall with the wind, and marks of the current drift with the water, forward and back in time. */
import { type ShaderMaterial, Vector3 } from "three";
import { describe, expect, test } from "vitest";
import { Drift, MOST_MARKS } from "../src/bridge/drift";
import { RainFall, fall } from "../src/bridge/rain";
import { skyUniforms } from "../src/bridge/sky";

test("drops are carried to where the wind blows", () => {
  // A wind from the west blows to the east, along x; from the north to the south, along z.
  const [east, down, south] = fall({ speed_mps: 10, from_rad: 1.5 * Math.PI });
  expect([east, south].map((v) => Math.round(v))).toEqual([8, -0]);
  expect(down).toBeLessThan(0);
  expect(fall({ speed_mps: 10, from_rad: 0 })[2]).toBeCloseTo(8);
});

test("a gust does not move the drops of a long run", () => {
  const rain = new RainFall(skyUniforms(), false);
  rain.rain("heavy");
  const moved = () => (rain.lines.material as ShaderMaterial).uniforms.uMoved?.value as Vector3;
  const eye = new Vector3();
  const wind = { speed_mps: 10, from_rad: 0 };
  rain.tick(eye, 36_000, wind);
  rain.tick(eye, 36_000.1, wind);
  const before = moved().clone();
  rain.tick(eye, 36_000.2, { speed_mps: 10.5, from_rad: 0.02 });
  expect(moved().distanceTo(before)).toBeLessThan(1.5);
  expect(moved().distanceTo(before)).toBeGreaterThan(0.5);
});

describe("marks of the current", () => {
  const current = { speed_mps: 0.8, to_rad: Math.PI / 2 };
  const heads = (drift: Drift, t_s: number) =>
    drift.marks([1000, 2000], t_s, current).map(([, head]) => head);
  const near = (all: [number, number][], to: [number, number]) =>
    Math.min(...all.map(([n, e]) => Math.hypot(n - to[0], e - to[1])));

  test("a mark drifts with the current, and is back when the run is rewound", () => {
    const drift = new Drift();
    const before = heads(drift, 100);
    expect(before.length).toBeGreaterThan(40);
    expect(before.length).toBeLessThanOrEqual(MOST_MARKS);
    const [n, e] = before[20] ?? [0, 0];
    expect(near(heads(drift, 110), [n, e + 8])).toBeLessThan(1e-6);
    expect(near(heads(drift, 100), [n, e])).toBeLessThan(1e-6);
    for (let t_s = 101; t_s < 500; t_s += 7) heads(drift, t_s);
    expect(near(heads(drift, 100), [n, e])).toBeLessThan(1e-6);
  });

  test("a mark trails its way of ten seconds, and still water has none", () => {
    const [mark] = new Drift().marks([0, 0], 0, current);
    const [tail, head] = mark ?? [
      [0, 0],
      [0, 0],
    ];
    expect(head[1] - tail[1]).toBeCloseTo(8);
    expect(head[0] - tail[0]).toBeCloseTo(0);
    expect(new Drift().marks([0, 0], 0, { speed_mps: 0, to_rad: 1 })).toEqual([]);
  });
});
