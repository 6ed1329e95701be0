/**
 * The rhythm of a light, from its character as charts write it, such as `Fl(2) R 6s`. A chart gives the period, not how long a
 * flash lasts: those times are ours, within what IALA's recommendation asks of each character (from memory, not from the text).
 */

/** Times at which a light is lit in a period: pairs of beginning and end [s]. */
interface Rhythm {
  period_s: number;
  lit: [number, number][];
}

/** For each character: time of a flash, and of the darkness between two flashes of a group [s]. */
const FLASHES: Record<string, [lit_s: number, dark_s: number]> = {
  Fl: [0.5, 1],
  FFl: [0.5, 1],
  LFl: [2, 2],
  Q: [0.4, 0.6],
  IQ: [0.4, 0.6],
  VQ: [0.2, 0.3],
  IVQ: [0.2, 0.3],
  UQ: [0.1, 0.1],
  IUQ: [0.1, 0.1],
};
const MORSE =
  ".- -... -.-. -.. . ..-. --. .... .. .--- -.- .-.. -- -. --- .--. --.- .-. ... - ..- ...- .-- -..- -.-- --..";
const DOT_S = 0.5;

const known = new Map<string, Rhythm | null>();

/** Whether a light of this character is lit at a time [s]. A fixed light, and one that the chart does not describe, always is. */
export function isLit(character: string, period_s: number | null, t_s: number): boolean {
  const key = `${character}|${period_s}`;
  let rhythm = known.get(key);
  if (rhythm === undefined) known.set(key, (rhythm = rhythmOf(character, period_s)));
  if (!rhythm) return true;
  const now = ((t_s % rhythm.period_s) + rhythm.period_s) % rhythm.period_s;
  return rhythm.lit.some(([from, until]) => now >= from && now < until);
}

function rhythmOf(character: string, given_s: number | null): Rhythm | null {
  const [, kind = "", group = "", long = ""] =
    /^([A-Za-z]+)(?:\(([^)]*)\))?(\+LFl)?/.exec(character.trim()) ?? [];
  if (kind === "Iso") {
    const period_s = given_s || 4;
    return { period_s, lit: [[0, period_s / 2]] };
  }
  // Quick lights without a group flash without a pause, interrupted ones for about half of their period.
  const isQuick = /^[QVU]+$/.test(kind) && !group && !long;
  const [lit_s, dark_s] = FLASHES[kind] ?? [0, 0];
  const interrupted =
    kind.startsWith("I") && lit_s ? String(Math.round((given_s || 10) / 2 / (lit_s + dark_s))) : "";
  const times =
    kind === "Mo" ? morse(group) : flashes(kind === "Oc" ? "Fl" : kind, group || interrupted, long);
  if (!times.length) return null;
  const end_s = times.at(-1)?.[1] ?? 0;
  const period_s = isQuick ? end_s + dark_s : given_s || end_s + 3;
  // A chart may give a period that is shorter than our flashes: they are shortened.
  const by = Math.min(1, (0.8 * period_s) / end_s);
  const lit = times.map(([from, until]): [number, number] => [from * by, until * by]);
  if (kind !== "Oc") return { period_s, lit };
  // An occulting light is dark where a flashing one is lit.
  const turns = [...lit.flat(), period_s];
  return {
    period_s,
    lit: lit.map((_, i): [number, number] => [turns[2 * i + 1] ?? 0, turns[2 * i + 2] ?? 0]),
  };
}

/** The flashes of a group, such as 2, or 2+1. */
function flashes(kind: string, group: string, long: string): [number, number][] {
  const [lit_s, dark_s] = FLASHES[kind] ?? [0, 0];
  if (!lit_s) return [];
  const times: [number, number][] = [];
  let at = 0;
  for (const part of (group || "1").split("+")) {
    for (let i = 0; i < Math.min(20, Number.parseInt(part, 10) || 1); i++) {
      times.push([at, at + lit_s]);
      at += lit_s + dark_s;
    }
    at += 2 * dark_s;
  }
  if (long) times.push([at, at + 2]);
  return times;
}

function morse(letters: string): [number, number][] {
  const times: [number, number][] = [];
  let at = 0;
  for (const letter of letters.toUpperCase()) {
    for (const sign of MORSE.split(" ")[letter.charCodeAt(0) - 65] ?? "") {
      const long = sign === "-" ? 3 * DOT_S : DOT_S;
      times.push([at, at + long]);
      at += long + DOT_S;
    }
    at += 2 * DOT_S;
  }
  return times;
}
