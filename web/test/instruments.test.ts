import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { packaged, pruned, rules, used } from "../scripts/openbridge.ts";
import { beaufort, currentArrows } from "../src/instruments/scales";
import { LEAST_SCALE, speedShown } from "../src/instruments/speed_scale";
import type { VesselNow } from "../src/protocol";
import { KNOT_MPS } from "../src/units";

test("of OpenBridge's style sheet the colours of the components are kept, in every palette, and little more", () => {
  const css = pruned(readFileSync(packaged("openbridge.css"), "utf8"), used());
  expect(css.length).toBeLessThan(40_000);
  const kept = rules(css.replaceAll("{", "{\n").replaceAll("}", "\n}\n"));
  const palettes = kept.filter(({ selector }) => selector.includes("[data-obc-theme="));
  expect(palettes.length).toBe(4);
  for (const { selector, properties } of palettes) {
    const names = new Set(properties.map(([name]) => name));
    for (const name of [
      "--instrument-enhanced-secondary-color",
      "--instrument-port-primary-color",
      "--alert-alarm-color",
      "--container-background-color",
    ])
      expect(names.has(name), `${name} in ${selector}`).toBe(true);
  }
  // A component that this page does not have.
  expect(css).not.toContain("calendar");
});

test("the wind's symbol is that of Beaufort's scale", () => {
  const metres = [0.2, 1, 2.5, 4.5, 6.2, 9.5, 12, 15, 19, 22.5, 26.5, 30, 40];
  expect(metres.map(beaufort)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
});

test("a current has an arrow for each begun knot", () => {
  expect([0.01, 0.2, 0.6, 1.2, 4].map(currentArrows)).toEqual([0, 1, 2, 3, 4]);
});

/** A vessel with speeds over ground and through the water, and with an order [kn]. */
const going = (ground: number, water = ground, order: number | null = null) =>
  ({
    ground_mps: [ground * KNOT_MPS, 0],
    water_mps: [water * KNOT_MPS, 0],
    speed_order_mps: order === null ? null : order * KNOT_MPS,
  }) as unknown as VesselNow;

test("an order of 20 kn lay at 4 kn astern on the dial of the speed", () => {
  const { scale, order_kn } = speedShown(going(8, 8, 20), LEAST_SCALE);
  expect(scale.ahead_kn).toBe(20);
  expect(order_kn).toBeCloseTo(20, 6);
});

test("the scale of the speed is the least that holds speed and order, ahead and astern", () => {
  const ahead = (...of: Parameters<typeof going>) =>
    speedShown(going(...of), LEAST_SCALE).scale.ahead_kn;
  expect([0, 15, 15.1, 20.1, 26].map((kn) => ahead(kn))).toEqual([15, 15, 20, 25, 30]);
  expect(ahead(5, 5, 22)).toBe(25);
  expect(speedShown(going(-8), LEAST_SCALE).scale).toEqual({ astern_kn: -10, ahead_kn: 25 });
});

test("needle and order end at the ends of the largest scale", () => {
  const shown = (kn: number) => {
    const { now_kn, order_kn } = speedShown(going(kn, kn, kn), LEAST_SCALE);
    return [now_kn, order_kn];
  };
  expect(shown(58)).toEqual([30, 30]);
  expect(shown(-58)).toEqual([-10, -10]);
});

test("the scale of the speed does not go back when she slows down", () => {
  let scale = LEAST_SCALE;
  const seen = [14.9, 15.1, 14.9, 15.1, 3].map((kn) => {
    ({ scale } = speedShown(going(kn), scale));
    return scale.ahead_kn;
  });
  expect(seen).toEqual([15, 20, 20, 20, 20]);
});

test("the dial shows the speed that an order is about, and says which speed it is", () => {
  const free = speedShown(going(6, 8), LEAST_SCALE);
  expect([free.name, free.order_kn]).toEqual(["Ahead, over ground", null]);
  expect(free.now_kn).toBeCloseTo(6, 6);
  const kept = speedShown(going(6, 8, 8), LEAST_SCALE);
  expect(kept.name).toBe("Ahead, through water");
  expect(kept.now_kn).toBeCloseTo(8, 6);
  expect(kept.order_kn).toBeCloseTo(8, 6);
});
