/** Day, dusk and night palettes. The document uses them as custom properties, canvases by name. */

export type PaletteName = "day" | "dusk" | "night";

export interface Palette {
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
  caution: string;
  alarm: string;
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

/** Day is for the sun: black on white, saturated signals. Night keeps eyes dark-adapted: red on black, no white or blue. */
export const PALETTES: Record<PaletteName, Palette> = {
  day: {
    bg: "#e4e9ed",
    panel: "#ffffff",
    edge: "#9fadb8",
    text: "#05101a",
    dim: "#3c4a56",
    button: "#eef2f5",
    button_edge: "#71818e",
    chosen: "#0b4f8a",
    chosen_text: "#ffffff",
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
    caution: "#a45600",
    alarm: "#c8102e",
    alarm_text: "#ffffff",
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
    bg: "#0b1116",
    panel: "#141d25",
    edge: "#354653",
    text: "#d3dde5",
    dim: "#93a5b3",
    button: "#1e2a34",
    button_edge: "#4b6070",
    chosen: "#3d87bd",
    chosen_text: "#04121d",
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
    ok: "#3cb869",
    caution: "#e8a317",
    alarm: "#ff5252",
    alarm_text: "#14060a",
    port: "#ff5252",
    starboard: "#3cb869",
    line: "#b9c7d2",
    force: "#c59bf0",
    wind: "#6fb4e6",
    current: "#4fc4c4",
    label: "#0b1116e6",
    fog: "#5a666f9c",
  },
  night: {
    bg: "#000000",
    panel: "#080201",
    edge: "#481610",
    text: "#ee7436",
    dim: "#e05a3c",
    button: "#150504",
    button_edge: "#65201a",
    chosen: "#4e150d",
    chosen_text: "#ee7436",
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
    caution: "#dc8200",
    alarm: "#ff2d1a",
    alarm_text: "#000000",
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

export const PALETTE_NAMES: PaletteName[] = ["day", "dusk", "night"];

/** Sets the document's palette. Canvases read `data-palette` on the root. */
export function applyPalette(name: PaletteName): void {
  const root = document.documentElement;
  root.dataset.palette = name;
  root.style.colorScheme = name === "day" ? "light" : "dark";
  for (const [key, colour] of Object.entries(PALETTES[name]))
    root.style.setProperty(`--${key.replace("_", "-")}`, colour);
  document.querySelector('meta[name="theme-color"]')?.setAttribute("content", PALETTES[name].bg);
}

export function palette(): Palette {
  return PALETTES[(document.documentElement.dataset.palette ?? "day") as PaletteName];
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
