/** The palettes of the page, with the colours of the installed OpenBridge. */
import { readFileSync } from "node:fs";
import { packaged, rules } from "../scripts/openbridge.ts";
import { type Palette, THEMES, type ThemeName, paletteOf } from "../src/palette";

const sheet = rules(readFileSync(packaged("openbridge.css"), "utf8"));

function themed(name: ThemeName): Palette {
  const rule = sheet.find(({ selector }) => selector.includes(`[data-obc-theme="${name}"]`));
  const properties = new Map(rule?.properties);
  return paletteOf(name, (property) => {
    const value = properties.get(property);
    if (value === undefined) throw new Error(`OpenBridge's ${name} has no ${property}`);
    return value;
  });
}

export const PALETTES = Object.fromEntries(THEMES.map((name) => [name, themed(name)])) as Record<
  ThemeName,
  Palette
>;
