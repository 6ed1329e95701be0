import { expect, test } from "vitest";
import { isLit } from "../src/character";
import { depthColour, limits } from "../src/draw/depths";
import { levelAt, thinned, written } from "../src/draw/soundings";
import { PALETTES } from "./palettes";
import type { Pair } from "../src/protocol";

/** The seconds of darkness and light of a character, as pairs of light and its length, by tenths of a second. */
function seen(character: string, period_s: number | null, for_s: number): [boolean, number][] {
  const runs: [boolean, number][] = [];
  for (let i = 0; i < for_s * 10; i++) {
    const lit = isLit(character, period_s, (i + 0.5) / 10);
    const last = runs.at(-1);
    if (last?.[0] === lit) last[1] = Math.round((last[1] + 0.1) * 10) / 10;
    else runs.push([lit, 0.1]);
  }
  return runs;
}
const flashes = (character: string, period_s: number) =>
  seen(character, period_s, period_s).filter(([lit]) => lit).length;

test("a light flashes by its character and its period", () => {
  expect(seen("Fl(2) R 6s", 6, 12)).toEqual([
    [true, 0.5],
    [false, 1],
    [true, 0.5],
    [false, 4],
    [true, 0.5],
    [false, 1],
    [true, 0.5],
    [false, 4],
  ]);
  expect(seen("Iso W 4s", 4, 8).map(([, s]) => s)).toEqual([2, 2, 2, 2]);
  expect(flashes("Q(6)+LFl W 15s", 15)).toBe(7);
  expect(flashes("Fl(2+1) G 10s", 10)).toBe(3);
  expect(flashes("VQ(9) 10s", 10)).toBe(9);
  expect(flashes("Q R", 10)).toBe(10);
  expect(flashes("IQ R 10s", 10)).toBe(5);
});

test("an occulting light is lit longer than it is dark, and Morse A is a dot and a dash", () => {
  const lit = seen("Oc W 5s", 5, 5).filter(([on]) => on);
  expect(lit.reduce((sum, [, s]) => sum + s, 0)).toBeCloseTo(4.5);
  expect(seen("Mo(A) W 8s", 8, 8).filter(([on]) => on)).toEqual([
    [true, 0.5],
    [true, 1.5],
  ]);
});

test("a fixed light and a light without a character are always lit", () => {
  for (const character of ["F R", "", "Al WR 10s"]) {
    expect(seen(character, null, 20), character).toEqual([[true, 20]]);
  }
});

test("flashes fit into a period that is shorter than they are", () => {
  expect(flashes("Fl(4) Y 2s", 2)).toBe(4);
});

test("four shades: by draught, draught and clearance, and twice the draught", () => {
  const colours = PALETTES.day;
  const of = limits(10, 1.5);
  expect([-1, 9.9, 10, 11.4, 11.5, 19.9, 20].map((m) => depthColour(m, of, colours))).toEqual([
    colours.drying,
    colours.shallow,
    colours.medium,
    colours.medium,
    colours.safe,
    colours.safe,
    colours.water,
  ]);
  // A large clearance never makes deep water of what is not safe.
  expect(limits(5, 20).deep_m).toBe(25);
});

test("of soundings that lie close together the shallowest is written", () => {
  const grid = Array.from({ length: 400 }, (_, i) => ({
    at: [(i % 20) * 10, Math.floor(i / 20) * 10] as Pair,
    depth_m: 5 + ((i * 37) % 101) / 10,
  }));
  const all = thinned(grid);
  expect(all.length).toBe(400);
  for (const pixels_per_m of [10, 1, 0.2]) {
    const shown = all.filter(({ level }) => level >= levelAt(pixels_per_m));
    const apart_m = 4 * 2 ** levelAt(pixels_per_m);
    for (const one of shown)
      for (const other of shown)
        if (one !== other)
          expect(
            Math.hypot(one.at[0] - other.at[0], one.at[1] - other.at[1]),
          ).toBeGreaterThanOrEqual(apart_m);
    expect(shown.map(({ depth_m }) => depth_m)).toContain(5);
    expect(apart_m * pixels_per_m).toBeGreaterThanOrEqual(52);
  }
});

test("a sounding is written with a decimal up to 31 m, and never deeper than it is", () => {
  expect(written(10.46)).toEqual(["10", "4"]);
  expect(written(9)).toEqual(["9", ""]);
  expect(written(31.9)).toEqual(["31", ""]);
  expect(written(-0.6)).toEqual(["0", "6"]);
});
