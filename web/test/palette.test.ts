import { expect, test } from "vitest";
import { type ColourName, type Palette, loadColour } from "../src/palette";
import { PALETTES } from "./palettes";

/** Relative luminance of sRGB, WCAG 2. */
function luminance(hex: string): number {
  const [r, g, b] = [1, 3, 5].map((i) => {
    const x = Number.parseInt(hex.slice(i, i + 2), 16) / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(a: string, b: string): number {
  const [low, high] = [luminance(a), luminance(b)].toSorted((x, y) => x - y) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

/** `rgb(r g b)` as `#rrggbb`; others as they are. */
const hex = (colour: string) =>
  colour.startsWith("#")
    ? colour
    : `#${[...colour.matchAll(/\d+/g)].map(([x]) => Number(x).toString(16).padStart(2, "0")).join("")}`;

test("text has the contrast for a screen in the sun in the bright palette and by day", () => {
  for (const { text, dim, panel } of [PALETTES.bright, PALETTES.day]) {
    expect(contrast(text, panel)).toBeGreaterThan(15);
    expect(contrast(dim, panel)).toBeGreaterThan(7);
  }
});

/** What is written on what, in the document and on canvases. */
const WRITTEN: [texts: ColourName[], on: ColourName[]][] = [
  [
    ["text", "dim"],
    ["panel", "button", "bg"],
  ],
  [
    ["ok", "caution", "alarm", "port", "starboard"],
    ["panel", "button"],
  ],
  [["alarm_text"], ["alarm_fill"]],
  [["caution_text"], ["caution_fill"]],
  [["panel"], ["port", "starboard"]],
  [["chosen_text"], ["chosen"]],
  [["trial_text"], ["trial"]],
  [["panel"], ["text"]],
  [["path", "wind", "current"], ["panel"]],
];
/** What lies below the labels of the plan. */
const BELOW: ColourName[] = ["water", "unknown", "safe", "medium", "shallow", "land", "own", "tug"];
/** WCAG AA; ours for large texts too. */
const LEAST = 4.5;

/** A colour with a share of cover (`#rrggbbaa`) over another. */
function over(cover: string, ground: string): string {
  const share = Number.parseInt(cover.slice(7), 16) / 255;
  const part = (hex: string, i: number) => Number.parseInt(hex.slice(i, i + 2), 16);
  return `#${[1, 3, 5]
    .map((i) => Math.round(part(cover, i) * share + part(ground, i) * (1 - share)))
    .map((x) => x.toString(16).padStart(2, "0"))
    .join("")}`;
}

test("every text has a contrast of 4.5:1 on what it is written on, in each palette", () => {
  for (const [name, colours] of Object.entries(PALETTES)) {
    for (const [texts, grounds] of WRITTEN)
      for (const text of texts)
        for (const ground of grounds)
          expect
            .soft(contrast(colours[text], colours[ground]), `${name}: ${text} on ${ground}`)
            .toBeGreaterThan(LEAST);
    const loads = Array.from({ length: 41 }, (_, i) => hex(loadColour(i / 40, colours)));
    for (const below of BELOW) {
      const ground = over(colours.label, colours[below]);
      for (const text of ["text", "path", "trial", "alarm", "line"] as const)
        expect
          .soft(contrast(colours[text], ground), `${name}: ${text} on a label over ${below}`)
          .toBeGreaterThan(LEAST);
      for (const [i, load] of loads.entries())
        expect
          .soft(contrast(load, ground), `${name}: load ${i / 40} on a label over ${below}`)
          .toBeGreaterThan(LEAST);
    }
  }
});

test("at night nothing is white or blue, and text is readable", () => {
  const { isDark, ...colours } = PALETTES.night;
  expect(isDark).toBe(true);
  for (const [key, hex] of Object.entries(colours)) {
    // White is written on OpenBridge's alarms alone.
    if (key === "alarm_text") continue;
    const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((i) =>
      Number.parseInt(hex.slice(i, i + 2), 16),
    );
    expect(blue, `${key} ${hex}`).toBeLessThanOrEqual(Math.max(red, green) * 0.85);
    expect(luminance(hex), `${key} ${hex}`).toBeLessThan(0.5);
  }
});

test("loads change from green over amber to red in each palette", () => {
  for (const colours of Object.values(PALETTES) as Palette[]) {
    expect(loadColour(0, colours)).toBe(colours.ok);
    const rgb = (hex: string) =>
      `rgb(${[1, 3, 5].map((i) => Number.parseInt(hex.slice(i, i + 2), 16)).join(" ")})`;
    expect(loadColour(0.7, colours)).toBe(rgb(colours.caution));
    expect(loadColour(1, colours)).toBe(rgb(colours.alarm));
    expect(loadColour(9, colours)).toBe(rgb(colours.alarm));
  }
});
