/**
 * The palettes bright, day, dusk and night. Surfaces, texts, buttons and alerts are OpenBridge's; the colours of the chart, and of
 * texts that tell port from starboard or good from bad, are ours. The document uses them as custom properties, canvases by name.
 */

/** The palettes of the view out of the window. */
export type PaletteName = "day" | "dusk" | "night";

/** The palettes of the page: bright is for a screen in the sun. */
export type ThemeName = "bright" | PaletteName;

interface Colours {
  bg: string;
  panel: string;
  edge: string;
  text: string;
  dim: string;
  button: string;
  button_edge: string;
  chosen: string;
  chosen_text: string;
  /** Water so deep that the ship hardly feels the bottom, and all water without a chart of depths. */
  water: string;
  /** Where a chart of depths has no depth. */
  unknown: string;
  /** Water with the clearance that the mariner asks for, and more. */
  safe: string;
  /** Water in which the ship floats, without that clearance. */
  medium: string;
  /** Water that is shallower than her draught. */
  shallow: string;
  /** Ground that falls dry. */
  drying: string;
  land: string;
  land_edge: string;
  grid: string;
  /** The safety contour. */
  contour: string;
  /** Soundings deeper than the safety depth. */
  sounding: string;
  fairway: string;
  /** Buoys and beacons that are neither red nor green, and the edge of all. */
  mark_yellow: string;
  mark_white: string;
  mark_black: string;
  mark_edge: string;
  /** A white light. */
  lamp: string;
  /** The passage plan. */
  plan: string;
  own: string;
  own_edge: string;
  tug: string;
  tug_edge: string;
  path: string;
  /** The ghost of a trial manoeuvre. */
  trial: string;
  trial_text: string;
  ok: string;
  /** Texts and edges of what needs care. */
  caution: string;
  /** What fills an area that warns, and what is written on it. */
  caution_fill: string;
  caution_text: string;
  /** Texts and edges of what is wrong. */
  alarm: string;
  alarm_fill: string;
  alarm_text: string;
  port: string;
  starboard: string;
  line: string;
  force: string;
  wind: string;
  current: string;
  label: string;
  /** What lies beyond the visibility, over the chart. */
  fog: string;
}

export type ColourName = keyof Colours;

export interface Palette extends Colours {
  isDark: boolean;
}

/** The custom properties of OpenBridge that some colours are. */
export const OPENBRIDGE = {
  bg: "--container-backdrop-color",
  panel: "--container-background-color",
  edge: "--border-divider-color",
  text: "--element-active-color",
  dim: "--element-neutral-color",
  button: "--normal-enabled-background-color",
  button_edge: "--normal-enabled-border-color",
  chosen: "--selected-enabled-background-color",
  chosen_text: "--on-selected-active-color",
  caution: "--alert-warning-text-color",
  caution_fill: "--alert-warning-color",
  caution_text: "--on-warning-active-color",
  alarm_fill: "--alert-alarm-color",
  alarm_text: "--on-alarm-active-color",
} as const satisfies Partial<Record<keyof Colours, string>>;

type Own = Omit<Colours, keyof typeof OPENBRIDGE>;

/**
 * Texts in our colours have a contrast of 4.5:1 on OpenBridge's surfaces; OpenBridge's own red and green, made for fills, have
 * less.
 */
const OWN: Record<PaletteName, Own> = {
  day: {
    water: "#eef6fb",
    unknown: "#d4d9dc",
    safe: "#d3e7f5",
    medium: "#a5cfec",
    shallow: "#7ab2dd",
    drying: "#bcc98f",
    land: "#dccb94",
    land_edge: "#6b5a22",
    grid: "#a9c7dc",
    contour: "#3b4a57",
    sounding: "#68788a",
    fairway: "#8a3f84",
    mark_yellow: "#e2b500",
    mark_white: "#ffffff",
    mark_black: "#10161c",
    mark_edge: "#05101a",
    lamp: "#b8860b",
    plan: "#b03a06",
    own: "#71808c",
    own_edge: "#05101a",
    tug: "#e08a2c",
    tug_edge: "#5b3000",
    path: "#b0106a",
    trial: "#0057c8",
    trial_text: "#ffffff",
    ok: "#0a7a33",
    alarm: "#c8102e",
    port: "#c8102e",
    starboard: "#0a7a33",
    line: "#23313d",
    force: "#6a1bb0",
    wind: "#0b4f8a",
    current: "#00727a",
    label: "#fffffff0",
    fog: "#8d9aa59c",
  },
  dusk: {
    water: "#0b1a26",
    unknown: "#15191c",
    safe: "#0f2536",
    medium: "#163a59",
    shallow: "#1f4f79",
    drying: "#3a4a22",
    land: "#453d22",
    land_edge: "#8d7d48",
    grid: "#1b394d",
    contour: "#8fa9bb",
    sounding: "#7f93a3",
    fairway: "#c084bb",
    mark_yellow: "#e8c53a",
    mark_white: "#d3dde5",
    mark_black: "#05090d",
    mark_edge: "#b9c7d2",
    lamp: "#f2e2a0",
    plan: "#ff9a5c",
    own: "#5c6d7a",
    own_edge: "#d3dde5",
    tug: "#b5722a",
    tug_edge: "#f0b878",
    path: "#e060a8",
    trial: "#5ab0ff",
    trial_text: "#05101a",
    ok: "#6fcf9c",
    alarm: "#ff9a92",
    port: "#ff9a92",
    starboard: "#6fcf9c",
    line: "#b9c7d2",
    force: "#c59bf0",
    wind: "#6fb4e6",
    current: "#4fc4c4",
    label: "#0b1116e6",
    fog: "#5a666f9c",
  },
  night: {
    water: "#030000",
    unknown: "#0d0a07",
    safe: "#0c0302",
    medium: "#1f0b05",
    shallow: "#331609",
    drying: "#22180a",
    land: "#1c0c04",
    land_edge: "#5c2c12",
    grid: "#210807",
    contour: "#a34a2a",
    sounding: "#8a3a24",
    fairway: "#8a4a2e",
    mark_yellow: "#a58a00",
    mark_white: "#c98a3c",
    mark_black: "#1a0704",
    mark_edge: "#c0552e",
    lamp: "#c98e2c",
    plan: "#e0601f",
    own: "#3a0f0b",
    own_edge: "#ee7436",
    tug: "#3a1a08",
    tug_edge: "#a85a1a",
    path: "#f0603a",
    trial: "#a58a00",
    trial_text: "#000000",
    ok: "#838f26",
    alarm: "#ff2d1a",
    port: "#e84a34",
    starboard: "#838f26",
    line: "#e05a3c",
    force: "#e0601f",
    wind: "#e0601f",
    current: "#b8741f",
    label: "#000000e6",
    fog: "#3010089c",
  },
};

export const THEMES: ThemeName[] = ["bright", "day", "dusk", "night"];

/** `rgb(r, g, b)` as `#rrggbb`. */
const hex = (colour: string): string =>
  colour.startsWith("#")
    ? colour
    : `#${[...colour.matchAll(/\d+/g)]
        .slice(0, 3)
        .map(([part]) => Number(part).toString(16).padStart(2, "0"))
        .join("")}`;

/** The palette of that name. `read`: the value of a custom property of OpenBridge. */
export function paletteOf(name: ThemeName, read: (property: string) => string): Palette {
  const theirs = Object.entries(OPENBRIDGE).map(([key, property]) => [key, hex(read(property))]);
  return {
    ...OWN[name === "bright" ? "day" : name],
    ...(Object.fromEntries(theirs) as Record<keyof typeof OPENBRIDGE, string>),
    isDark: name === "dusk" || name === "night",
  };
}

let shown: Palette | null = null;

/** Sets the document's palette. */
export function applyPalette(name: ThemeName): void {
  const root = document.documentElement;
  root.dataset.palette = name;
  root.dataset.obcTheme = name;
  const style = getComputedStyle(root);
  const { isDark, ...colours } = paletteOf(name, (property) => style.getPropertyValue(property));
  shown = { ...colours, isDark };
  root.style.colorScheme = isDark ? "dark" : "light";
  for (const [key, colour] of Object.entries(colours))
    root.style.setProperty(`--${key.replace("_", "-")}`, colour);
  document.querySelector('meta[name="theme-color"]')?.setAttribute("content", colours.bg);
}

/** The document's palette, for canvases. */
export function palette(): Palette {
  if (!shown) throw new Error("the page sets its palette before it draws");
  return shown;
}

function mixed(a: string, b: string, share: number): string {
  const parts = (hex: string) => [1, 3, 5].map((i) => Number.parseInt(hex.slice(i, i + 2), 16));
  const [from, to] = [parts(a), parts(b)];
  return `rgb(${from.map((x, i) => Math.round(x + ((to[i] ?? x) - x) * share)).join(" ")})`;
}

/** The colour of a load as a share of its limit: green to 0.3, amber at 0.7, red from 1. */
export function loadColour(share: number, colours: Palette): string {
  if (share <= 0.3) return colours.ok;
  if (share <= 0.7) return mixed(colours.ok, colours.caution, (share - 0.3) / 0.4);
  return mixed(colours.caution, colours.alarm, Math.min(1, (share - 0.7) / 0.3));
}
