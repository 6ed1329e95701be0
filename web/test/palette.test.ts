import { expect, test } from "vitest";
import { PALETTES, type Palette, loadColour } from "../src/palette";

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

test("text has the contrast for a screen in the sun by day, that of WCAG AA at dusk", () => {
  expect(contrast(PALETTES.day.text, PALETTES.day.panel)).toBeGreaterThan(15);
  expect(contrast(PALETTES.day.dim, PALETTES.day.panel)).toBeGreaterThan(7);
  for (const key of ["text", "dim", "ok", "caution", "alarm"] as const)
    expect(contrast(PALETTES.dusk[key], PALETTES.dusk.panel), key).toBeGreaterThan(4.5);
  for (const key of ["ok", "alarm"] as const)
    expect(contrast(PALETTES.day[key], PALETTES.day.panel), key).toBeGreaterThan(4.5);
});

test("at night nothing is white or blue, and text is readable", () => {
  for (const [key, hex] of Object.entries(PALETTES.night)) {
    const blue = Number.parseInt(hex.slice(5, 7), 16);
    expect(blue, `${key} ${hex}`).toBeLessThan(0x40);
    expect(luminance(hex), `${key} ${hex}`).toBeLessThan(0.32);
  }
  expect(contrast(PALETTES.night.text, PALETTES.night.panel)).toBeGreaterThan(4);
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
