/** The data of the strip charts: values of the ship twice a second, from the time when the page was opened. */
import { turned } from "./geometry";
import type { Frame, Hello } from "./protocol";
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
  of_energy: number;
  of_reaction: number;
  tension: number;
  /** The sizes of all contact forces together. */
  contact_mn: number;
}

export class History {
  samples: Sample[] = [];

  constructor(private readonly every_s = EVERY_S) {}

  /** `body`: that which the charts are about, the ship's if she is a vessel. */
  add(frame: Frame, hello: Hello, ship: number, of: number): void {
    const last = this.samples.at(-1);
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

  clear(): void {
    this.samples = [];
  }
}
