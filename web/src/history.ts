/**
 * The data of the strip charts: values of the ship twice a second since the page was opened, and those that the server kept
 * from before.
 */
import { turned } from "./geometry";
import type { Frame, Hello, Past } from "./protocol";
import { rateOfTurn, toKnots } from "./units";

const EVERY_S = 0.5;
const KEPT_S = 1800;

export interface Sample {
  t_s: number;
  bow_mps: number | null;
  stern_mps: number | null;
  ahead_kn: number;
  rot: number;
  bow_m: number | null;
  stern_m: number | null;
  cross_track_m: number | null;
  under_keel_m: number | null;
  of_energy: number;
  of_reaction: number;
  tension: number;
  /** The sizes of all contact forces together. */
  contact_mn: number;
}

/** The limit of the ship's exercise; without one, the clearance below which the server cautions. */
function underKeelLimit({ exercise, vessels }: Hello, ship: number): number | null {
  const own = vessels[ship];
  const limits = exercise && exercise.ship === own?.name ? exercise.limits : [];
  const limit = limits.find(({ key }) => key === "under_keel");
  return limit?.bound ?? own?.under_keel_limit_m ?? null;
}

export class History {
  samples: Sample[] = [];
  /** Least clearance below the keel that the ship may have [m]; `null`: she is no vessel. */
  under_keel_limit_m: number | null = null;

  constructor(private readonly every_s = EVERY_S) {}

  /** `body`: that which the charts are about, the ship's if she is a vessel. */
  add(frame: Frame, hello: Hello, ship: number, of: number): void {
    const last = this.samples.at(-1);
    this.under_keel_limit_m = underKeelLimit(hello, ship);
    // After a rewind later samples belong to another branch.
    if (last && frame.t_s < last.t_s) this.samples = this.samples.filter((s) => s.t_s < frame.t_s);
    if (last && frame.t_s >= last.t_s && frame.t_s - last.t_s < this.every_s - 1e-6) return;
    const now = frame.vessels[ship];
    const body = frame.bodies[of];
    if (!body) return;
    const [, , heading, north, east] = body;
    const [ahead_mps] = now?.ground_mps ?? turned(-heading, [north, east]);
    this.samples.push({
      t_s: frame.t_s,
      bow_mps: now?.berth?.bow_mps ?? now?.bow_mps ?? null,
      stern_mps: now?.berth?.stern_mps ?? now?.stern_mps ?? null,
      ahead_kn: toKnots(ahead_mps),
      rot: rateOfTurn(body[5]),
      bow_m: now?.berth?.bow_m ?? null,
      stern_m: now?.berth?.stern_m ?? null,
      cross_track_m: now?.plan && now.plan.to_waypoint_m >= 0 ? now.plan.cross_track_m : null,
      under_keel_m: now?.under_keel_m ?? null,
      of_energy: Math.max(0, ...frame.fenders.map((f) => f.of_energy)) * 100,
      of_reaction: Math.max(0, ...frame.fenders.map((f) => f.of_reaction)) * 100,
      tension:
        Math.max(
          0,
          ...frame.lines.map((l, i) => l.tension_n / Math.max(1, hello.lines[i]?.working_n ?? 1)),
        ) * 100,
      contact_mn: frame.contacts.reduce((sum, c) => sum + Math.hypot(...c.force_n), 0) / 1e6,
    });
    const from = frame.t_s - KEPT_S;
    if ((this.samples[0]?.t_s ?? 0) < from - 60)
      this.samples = this.samples.filter((s) => s.t_s >= from);
  }

  /** Puts what the server kept before the page's own values. */
  restore(past: Past): void {
    const till = past.t_s.at(-1) ?? -Infinity;
    const at = <T>(column: T[], i: number): T | null => column[i] ?? null;
    const before = past.t_s.map((t_s, i): Sample => ({
      t_s,
      bow_mps: at(past.bow_mps, i),
      stern_mps: at(past.stern_mps, i),
      ahead_kn: toKnots(past.ahead_mps[i] ?? 0),
      rot: rateOfTurn(past.turn_radps[i] ?? 0),
      bow_m: at(past.bow_m, i),
      stern_m: at(past.stern_m, i),
      cross_track_m: at(past.cross_track_m, i),
      under_keel_m: at(past.under_keel_m, i),
      of_energy: (past.of_energy[i] ?? 0) * 100,
      of_reaction: (past.of_reaction[i] ?? 0) * 100,
      tension: (past.of_working[i] ?? 0) * 100,
      contact_mn: (past.contact_n[i] ?? 0) / 1e6,
    }));
    this.samples = [...before, ...this.samples.filter(({ t_s }) => t_s > till)];
  }

  clear(): void {
    this.samples = [];
  }

  /** When a fender had the largest load over its rating, or all contacts together the largest force [s]; `null`: never. */
  largest_s(): number | null {
    let most: Sample | null = null;
    for (const next of this.samples) if (!most || isMore(next, most)) most = next;
    return most && (loadOf(most) > 0 || most.contact_mn > 0) ? most.t_s : null;
  }
}

/** Fenders that buckle have all of their reaction early: their energy tells how far they are pressed. */
const loadOf = ({ of_energy, of_reaction }: Sample): number =>
  of_energy > 0 ? of_energy : of_reaction;

/** Without ratings the forces decide. */
const isMore = (next: Sample, most: Sample): boolean =>
  loadOf(next) > loadOf(most) ||
  (loadOf(most) === 0 && loadOf(next) === 0 && next.contact_mn > most.contact_mn);
