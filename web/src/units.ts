/** Values as they are written on a ship's bridge. */

export const KNOT_MPS = 1852 / 3600;
/** Forces of tugs and lines are given in tonnes. */
export const TONNE_N = 9806.65;
const DEG = 180 / Math.PI;

export const toKnots = (mps: number): number => mps / KNOT_MPS;
export const toDegrees = (rad: number): number => rad * DEG;
export const toRadians = (deg: number): number => deg / DEG;

/** An angle in (−π, π]. */
export function wrapped(rad: number): number {
  const turn = 2 * Math.PI;
  const rest = ((rad % turn) + turn) % turn;
  return rest > Math.PI ? rest - turn : rest;
}

/** A heading or a bearing: three digits before the point, never 360. */
export function heading(rad: number, decimals = 1): string {
  const degrees = (((rad * DEG) % 360) + 360) % 360;
  const text = degrees.toFixed(decimals);
  const shown = Number(text) >= 360 ? (0).toFixed(decimals) : text;
  const width = decimals > 0 ? 4 + decimals : 3;
  return `${shown.padStart(width, "0")}°`;
}

/** A number without a minus before zero. */
export function fixed(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

export const knots = (mps: number, decimals = 1): string => `${fixed(toKnots(mps), decimals)} kn`;
export const tonnes = (newtons: number): string =>
  `${fixed(newtons / TONNE_N, newtons < 10 * TONNE_N ? 1 : 0)} t`;
export const percent = (share: number): string => `${fixed(share * 100, 0)} %`;

/** A shackle of anchor chain [m]. */
export const SHACKLE_M = 27.5;
/** A length of chain in shackles, as it is reported from the forecastle. */
export function shackles(length_m: number): string {
  const text = fixed(length_m / SHACKLE_M, 1);
  const whole = text.endsWith(".0") ? text.slice(0, -2) : text;
  return `${whole} shackle${whole === "1" ? "" : "s"}`;
}

/** An angle as its size and its side. */
export function sided(rad: number, decimals = 0): string {
  const text = Math.abs(rad * DEG).toFixed(decimals);
  if (Number(text) === 0) return `${text}°`;
  return `${rad < 0 ? "P" : "S"} ${text}°`;
}

/** A direction from the bow in words, where `S` could be read as south. */
export function relative(rad: number): string {
  const text = Math.abs(rad * DEG).toFixed(0);
  if (text === "0") return "ahead";
  if (text === "180") return "astern";
  return `${rad < 0 ? "port" : "stb"} ${text}°`;
}

/** Rate of turn, degrees a minute. */
export const rateOfTurn = (radPerS: number): number => radPerS * DEG * 60;

/** Kilonewtons up to a thousand, then meganewtons. */
export function force(newtons: number): string {
  return Math.abs(newtons) < 1e6
    ? `${fixed(newtons / 1e3, 0)} kN`
    : `${fixed(newtons / 1e6, 2)} MN`;
}

/** The load of a fender: that of a tug's own fender is what she pushes with, in tonnes like all forces of tugs. */
export const fenderLoad = (newtons: number, ofTug: boolean): string =>
  ofTug ? tonnes(newtons) : force(newtons);

export const energy = (joules: number): string => `${fixed(joules / 1e3, 0)} kJ`;

export const NAUTICAL_MILE_M = 1852;
const CABLE_M = NAUTICAL_MILE_M / 10;

/** A distance: metres, from half a cable on with cables, from a nautical mile on in miles. */
export function distance(m: number): string {
  if (m >= NAUTICAL_MILE_M - 0.5) return `${fixed(m / NAUTICAL_MILE_M, 2)} NM`;
  const round = m >= 99.95 || Math.abs(m - Math.round(m)) < 0.05;
  const metres = `${fixed(m, round ? 0 : 1)} m`;
  return m < CABLE_M / 2 ? metres : `${metres} (${fixed(m / CABLE_M, 1)} cables)`;
}

/** A name of a scenario as it is shown. */
export const spoken = (name: string): string => name.replaceAll("_", " ");

/** A tug in a sentence: "tug forward", but not "tug tug 1". */
export const tugCalled = (name: string): string =>
  /\btug\b/i.test(spoken(name)) ? spoken(name) : `tug ${spoken(name)}`;

/** Simulated time as h:mm:ss. */
export function clock(t_s: number): string {
  const all = Math.max(0, Math.floor(t_s));
  const two = (n: number) => String(n).padStart(2, "0");
  return `${Math.floor(all / 3600)}:${two(Math.floor(all / 60) % 60)}:${two(all % 60)}`;
}

/**
 * A sentence of the verdict as the page shows it. The server counts the seconds of the run and writes names as files have them; the
 * page has a clock.
 */
export const spokenFinding = (text: string): string =>
  spoken(text.replaceAll("length_bp", "length between perpendiculars")).replaceAll(
    /\b(at|from) (\d+(?:\.\d+)?) s\b/g,
    (_, word: string, s: string) => `${word} ${clock(Number(s))}`,
  );
