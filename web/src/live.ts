/** What the page knows: the scenario, the last two ticks, the way that is predicted, and how late it all is. */
import { between } from "./geometry";
import type { BodyNow, Control, Frame, Hello, Prediction, VesselInfo } from "./protocol";

/** Frames that fail to come for so long while the run goes are a fault that the page shows. */
export const STALE_MS = 1500;
const FORGET_AFTER = 200;

export class Latency {
  private recent: number[] = [];

  add(ms: number): void {
    this.recent.push(ms);
    if (this.recent.length > FORGET_AFTER) this.recent.shift();
  }

  /**
   * Median and 99th percentile [ms] over the last frames. `clocks`: the two clocks differ by more than a second, so
   * that only the spread over the quickest frame is known.
   */
  figures(): { median: number; p99: number; clocks: boolean } | null {
    if (this.recent.length === 0) return null;
    const sorted = this.recent.toSorted((a, b) => a - b);
    const least = sorted[0] ?? 0;
    const clocks = Math.abs(least) > 1000;
    const at = (share: number) =>
      (sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * share))] ?? 0) -
      (clocks ? least : 0);
    return { median: Math.max(0, at(0.5)), p99: Math.max(0, at(0.99)), clocks };
  }
}

export class Live {
  hello: Hello | null = null;
  frame: Frame | null = null;
  previous: Frame | null = null;
  prediction: Prediction | null = null;
  /** From the tick to its first drawing. */
  readonly latency = new Latency();
  private received_ms = 0;
  private interval_ms = 100;
  private undrawn = false;

  welcome(hello: Hello): void {
    if (this.hello?.file !== hello.file) {
      this.frame = this.previous = this.prediction = null;
    }
    this.hello = hello;
  }

  tick(frame: Frame, now_ms: number): void {
    const went = frame.tick - (this.frame?.tick ?? frame.tick);
    // After a rewind, a branch or a gap there is nothing to draw between.
    this.previous =
      went > 0 && went <= 50 && frame.bodies.length === this.frame?.bodies.length
        ? this.frame
        : null;
    if (this.previous) {
      const since = now_ms - this.received_ms;
      this.interval_ms += 0.2 * (Math.min(250, Math.max(16, since)) - this.interval_ms);
    }
    this.frame = frame;
    this.received_ms = now_ms;
    this.undrawn = true;
  }

  /** Called by the first drawing after a frame: how long ago its tick was. */
  drawn(wall_ms: number): void {
    if (!this.undrawn || !this.frame) return;
    this.undrawn = false;
    if (!this.frame.run.paused) this.latency.add(wall_ms - this.frame.at_ms);
  }

  /** How far it is from the last tick but one to the last. */
  share(now_ms: number): number {
    return this.previous
      ? Math.min(1, Math.max(0, (now_ms - this.received_ms) / this.interval_ms))
      : 1;
  }

  /** Bodies where they are drawn now. */
  bodies(now_ms: number): BodyNow[] {
    const { frame, previous } = this;
    if (!frame) return [];
    if (!previous) return frame.bodies;
    const share = this.share(now_ms);
    return frame.bodies.map((to, i) => between(previous.bodies[i] ?? to, to, share));
  }

  /** Silence while the run goes [ms], or `null` where all is well. */
  silence(now_ms: number): number | null {
    if (!this.frame || this.frame.run.paused) return null;
    const silent = now_ms - this.received_ms;
    return silent > STALE_MS ? silent : null;
  }

  /** Index of the vessel whose helm this page has: a tugmaster's own where she is a vessel, or else the ship. */
  conned(): number {
    const role = this.hello?.role;
    const own =
      role?.name === "tugmaster"
        ? (this.hello?.vessels.findIndex((v) => v.name === role.tug) ?? -1)
        : -1;
    return own >= 0 ? own : this.ship();
  }

  /** Index of the ship that everything is about: the pilot's. */
  ship(): number {
    const vessels = this.hello?.vessels ?? [];
    const own = vessels.findIndex((v) => !v.is_tug);
    return Math.max(0, own);
  }

  vessel(index: number): VesselInfo | null {
    return this.hello?.vessels[index] ?? null;
  }

  mine(control: Control): boolean {
    return this.hello?.mine.some((mine) => same(mine, control)) ?? false;
  }

  holder(control: Control): { holder: string | null; connected: boolean } | null {
    return this.hello?.claims.find((claim) => same(claim.control, control)) ?? null;
  }
}

export function same(a: Control, b: Control): boolean {
  if ("vessel" in a) return "vessel" in b && a.vessel === b.vessel;
  if ("tug" in a) return "tug" in b && a.tug === b.tug;
  return "session" in b;
}

/** What the page is built from: where it changes, the page is built anew, and not when a claim does. */
export function structure(hello: Hello): string {
  const { role, file, bodies, vessels, fenders, lines, tugs, gallery, links } = hello;
  return JSON.stringify([role, file, bodies, vessels, fenders, lines, tugs, gallery, links]);
}
