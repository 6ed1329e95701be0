import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { packaged, pruned, rules, used } from "../scripts/openbridge.ts";
import { beaufort, currentArrows } from "../src/instruments/scales";

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
