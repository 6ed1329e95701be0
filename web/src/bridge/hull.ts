/**
 * The form of a hull. From outlines at several heights it is the surface that contact uses. From one outline, the draught and a
 * freeboard it is lofted: upright sides amidships, where the outline is kept to the centimetre, flare and rake at the bow, a
 * counter at the stern; below the water this form is ours.
 */
import { smooth } from "./axes";
import { ends } from "./hull_ends";
import { cornersAlong, reach, ringAt } from "./levels";
import type { Spot } from "./solids";
import type { LevelInfo, Pair } from "../protocol";

/** How far the outline reaches to port and to starboard at a distance forward of midship [m]. */
export type Breadth = (forward_m: number) => Pair;

/**
 * The breadth of an outline. Between the corners of a side the breadth is a monotone cubic (Fritsch and Carlson 1980, from
 * memory): it passes through each corner, stays straight along straight sides, and never swings out.
 */
export function breadthOf(outline: Pair[]): Breadth {
  const [aft, fore] = ends(outline);
  const half = (side: 1 | -1) => {
    const widest = new Map<number, number>();
    for (const [forward, starboard] of outline) {
      const wide = Math.max(0, starboard * side);
      // A corner of the other side says nothing of this side.
      if (starboard * side < -1e-6) continue;
      widest.set(forward, Math.max(widest.get(forward) ?? 0, wide));
    }
    for (const end of [aft, fore]) if (!widest.has(end)) widest.set(end, 0);
    return monotone([...widest].toSorted((a, b) => a[0] - b[0]));
  };
  const [port, starboard] = [half(-1), half(1)];
  return (forward_m) => [port(forward_m), starboard(forward_m)];
}

/** A monotone cubic through points in order of their first number; level beyond both ends. */
export function monotone(points: Pair[]): (at: number) => number {
  const n = points.length;
  const x = (i: number) => points[i]?.[0] ?? 0;
  const y = (i: number) => points[i]?.[1] ?? 0;
  const slope = (i: number) => (y(i + 1) - y(i)) / Math.max(1e-9, x(i + 1) - x(i));
  const tangent = points.map((_, i) => {
    if (i === 0) return n > 1 ? slope(0) : 0;
    if (i === n - 1) return slope(n - 2);
    const [before, after] = [slope(i - 1), slope(i)];
    if (before * after <= 0) return 0;
    const [h, k] = [x(i) - x(i - 1), x(i + 1) - x(i)];
    return (3 * (h + k)) / ((2 * k + h) / before + (k + 2 * h) / after);
  });
  return (at) => {
    if (n === 0 || at <= x(0)) return y(0);
    if (at >= x(n - 1)) return y(n - 1);
    let i = 0;
    while (i + 2 < n && at > x(i + 1)) i++;
    const h = x(i + 1) - x(i);
    const t = (at - x(i)) / h;
    const [m, k] = [tangent[i] ?? 0, tangent[i + 1] ?? 0];
    return (
      y(i) * (1 + 2 * t) * (1 - t) ** 2 +
      m * h * t * (1 - t) ** 2 +
      y(i + 1) * t * t * (3 - 2 * t) +
      k * h * t * t * (t - 1)
    );
  };
}

/** The main numbers of a hull. */
export interface HullForm {
  outline: Pair[];
  draught_m: number;
  /** Height of the deck at the side above the water, amidships [m]. */
  freeboard_m: number;
  /** Height of the forecastle's deck above the deck amidships [m]. */
  sheer_m: number;
  /** How far the stem at the waterline is behind the stem at the deck [m]. */
  rake_m: number;
  /** How far forward of the stern the keel ends [m]. */
  counter_m: number;
  /** Outlines at several heights, from the lowest up; above the highest the side is upright. Empty: one outline. */
  levels: LevelInfo[];
}

const SMOOTH_FROM = 0.62;
/** Top of the bottom paint above the water that the ship floats at [m]: her load line lies a little higher. */
export const BOOT_M = 0.35;
/** Heights between the bottom paint and the deck, as shares. */
const SHARES = [0.15, 0.4, 0.7, 1];

/** The shell between two outlines has corners at least so often [m]. */
const SHELL_STEP_M = 1.5;

/** Heights from one up to another, without the other. */
function between(low_m: number, high_m: number): number[] {
  // Under water nobody sees the shell.
  const parts = low_m < -1 ? 1 : Math.max(1, Math.ceil((high_m - low_m) / SHELL_STEP_M));
  return Array.from({ length: parts }, (_, i) => low_m + ((high_m - low_m) * i) / parts);
}

export class Hull {
  readonly breadth: Breadth;
  readonly aft_m: number;
  readonly fore_m: number;
  private readonly middle_m: number;
  private readonly half_m: number;

  constructor(readonly form: HullForm) {
    const top = form.levels.at(-1)?.outline;
    this.breadth = top
      ? (forward_m) => {
          const [port, starboard] = reach(top, forward_m);
          return [Math.max(0, -port), Math.max(0, starboard)];
        }
      : breadthOf(form.outline);
    [this.aft_m, this.fore_m] = ends(top ?? form.outline);
    this.middle_m = (this.aft_m + this.fore_m) / 2;
    this.half_m = (this.fore_m - this.aft_m) / 2;
  }

  /** Place along the hull: −1 at the stern, 1 at the stem. */
  private share(forward_m: number): number {
    return (forward_m - this.middle_m) / Math.max(1e-6, this.half_m);
  }

  /** Height of the deck above the water [m]. */
  deck_m(forward_m: number): number {
    return this.form.freeboard_m + this.form.sheer_m * smooth(0.84, 0.9, this.share(forward_m));
  }

  /** The place of the hull's side at a station of the outline, at a height above the water [m]. `side`: 1 to starboard. */
  side(forward_m: number, up_m: number, side: 1 | -1): Spot {
    return this.form.levels.length > 0
      ? this.sideByLevels(forward_m, up_m, side)
      : this.sideOfForm(forward_m, up_m, side);
  }

  private sideByLevels(forward_m: number, up_m: number, side: 1 | -1): Spot {
    const ring = ringAt(this.form.levels, up_m);
    const [aft, fore] = ends(ring);
    const along = (forward_m - this.aft_m) / Math.max(1e-6, this.fore_m - this.aft_m);
    // Rounding may not carry the end of a flat bow beyond the bow.
    const at = along >= 1 ? fore : Math.min(fore, aft + Math.max(0, along) * (fore - aft));
    const [port, starboard] = reach(ring, at);
    return [at, side > 0 ? starboard : port, up_m];
  }

  private sideOfForm(forward_m: number, up_m: number, side: 1 | -1): Spot {
    const { draught_m, rake_m, counter_m, freeboard_m, sheer_m } = this.form;
    const [port, starboard] = this.breadth(forward_m);
    const full = side > 0 ? starboard : port;
    const share = this.share(forward_m);
    const bow = smooth(SMOOTH_FROM, 1, share);
    const stern = smooth(SMOOTH_FROM, 1, -share);
    // 1 at the forecastle's deck, 0 at the water, −1 at the keel.
    const high =
      up_m >= 0 ? Math.min(1, up_m / (freeboard_m + sheer_m)) : Math.max(-1, up_m / draught_m);
    const low = Math.max(0, -high);
    const back = rake_m * (high >= 0 ? 1 - high : 1 + 0.15 * low);
    const forward = counter_m * (high >= 0 ? 0.12 * (1 - high) : 0.12 + 0.88 * low ** 1.4);
    // Above the water the bow flares; below, bow and stern become slender, and the bilge is round.
    const flare = 1 - (high >= 0 ? 0.34 * (1 - high) ** 1.3 : 0.34 + 0.46 * low) * bow;
    const tuck = 1 - (high >= 0 ? 0.05 * (1 - high) : 0.05 + 0.85 * low ** 1.5) * stern;
    const bilge_m = Math.min(0.12 * full, 0.25 * draught_m);
    const above_keel_m = up_m + draught_m;
    const round =
      above_keel_m < bilge_m
        ? bilge_m - Math.sqrt(Math.max(0, bilge_m ** 2 - (bilge_m - above_keel_m) ** 2))
        : 0;
    const wide = Math.max(0, full * flare * tuck - round);
    return [forward_m - back * bow ** 1.5 + forward * stern ** 1.5, side * wide, up_m];
  }

  /** Stations from the stern to the stem, closer towards both ends [m]. */
  stations(count: number): number[] {
    const even = Array.from(
      { length: count + 1 },
      (_, i) => this.middle_m - this.half_m * Math.cos((Math.PI * i) / count),
    );
    const corners = cornersAlong(this.form.levels).map(
      (share) => this.aft_m + share * 2 * this.half_m,
    );
    return [...new Set([...even, ...corners])].toSorted((a, b) => a - b);
  }

  /** Heights above the water at which the side has its own forms, from the keel to a height [m]. */
  heights(till_m: number): number[] {
    const { draught_m, levels } = this.form;
    if (levels.length > 0) {
      const given = [-draught_m, ...levels.map(({ height_m }) => height_m), 0, BOOT_M, till_m];
      const all = [...new Set(given)].filter((up) => up <= till_m).toSorted((a, b) => a - b);
      return all.flatMap((up, i) => between(up, all[i + 1] ?? up));
    }
    const bilge_m = 0.25 * draught_m;
    return [
      -draught_m,
      -draught_m + bilge_m * 0.3,
      -draught_m + bilge_m,
      -draught_m * 0.35,
      0,
      BOOT_M,
      ...SHARES.map((share) => BOOT_M + share * (till_m - BOOT_M)),
    ];
  }
}
