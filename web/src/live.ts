/** The page's data: the scenario, the last two ticks, the predicted path, and the delay of frames. */
import { between } from "./geometry";
import type {
  BodyNow,
  Control,
  FenderInfo,
  Frame,
  Hello,
  Prediction,
  VesselInfo,
} from "./protocol";

/** A running session without frames for this long is reported as a fault. */
export const STALE_MS = 1500;
const FORGET_AFTER = 200;
/** The longest time between two frames over which the page moves the ships: half a second's steps at a quarter of the pace [ms]. */
const SELDOM_MS = 2000;

export class Latency {
  private recent: number[] = [];

  add(ms: number): void {
    this.recent.push(ms);
    if (this.recent.length > FORGET_AFTER) this.recent.shift();
  }

  /**
   * Median and 99th percentile of the delay of the last frames [ms]. `clocks`: the two clocks differ by more than a
   * second, so that delays are relative to that of the quickest frame.
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
  /** From the tick to its first drawing [ms]. */
  readonly latency = new Latency();
  /** The ship that the instructor has chosen, by name; `null`: the scenario's own ship. */
  private chosen: string | null = null;
  private received_ms = 0;
  private interval_ms = 100;
  private undrawn = false;
  /** The body that is followed where there is no vessel. */
  private moving: number | null = null;

  welcome(hello: Hello): void {
    if (this.hello?.file !== hello.file) {
      this.frame = this.previous = this.prediction = null;
      this.moving = this.chosen = null;
    }
    this.hello = hello;
  }

  tick(frame: Frame, now_ms: number): void {
    const went = frame.tick - (this.frame?.tick ?? frame.tick);
    // After a rewind, a new branch or a gap the page does not interpolate.
    this.previous =
      went > 0 && went <= 50 && frame.bodies.length === this.frame?.bodies.length
        ? this.frame
        : null;
    if (this.previous) {
      const since = now_ms - this.received_ms;
      this.interval_ms += 0.2 * (Math.min(SELDOM_MS, Math.max(16, since)) - this.interval_ms);
    }
    this.frame = frame;
    this.moving ??= fastest(this.hello, frame);
    this.received_ms = now_ms;
    this.undrawn = true;
  }

  /** Called by the first drawing after a frame: notes the age of its tick. */
  drawn(wall_ms: number): void {
    if (!this.undrawn || !this.frame) return;
    this.undrawn = false;
    if (!this.frame.run.paused) this.latency.add(wall_ms - this.frame.at_ms);
  }

  /** Position between the last two ticks, from 0 to 1. */
  share(now_ms: number): number {
    return this.previous
      ? Math.min(1, Math.max(0, (now_ms - this.received_ms) / this.interval_ms))
      : 1;
  }

  /** Time of the run at the position of this drawing [s]. */
  time(now_ms: number): number {
    const [till, from] = [this.frame?.t_s ?? 0, this.previous?.t_s];
    return from === undefined ? till : from + (till - from) * this.share(now_ms);
  }

  /** The bodies at the position of this drawing, as the instruments show them. */
  bodies(now_ms: number): (BodyNow | null)[] {
    return this.interpolated(({ bodies }) => bodies, now_ms);
  }

  /** The bodies at the position of this drawing, as the eye sees them: no instrument comes between. */
  seenBodies(now_ms: number): (BodyNow | null)[] {
    return this.interpolated(seenIn, now_ms);
  }

  private interpolated(
    bodiesIn: (frame: Frame) => (BodyNow | null)[],
    now_ms: number,
  ): (BodyNow | null)[] {
    const { frame, previous } = this;
    if (!frame) return [];
    const [from, till] = [previous && bodiesIn(previous), bodiesIn(frame)];
    if (!from) return till;
    const share = this.share(now_ms);
    return till.map((to, i) => to && between(from[i] ?? to, to, share));
  }

  /** The ships that pass, at the position of this drawing. */
  traffic(now_ms: number): (BodyNow | null)[] {
    const { frame, previous } = this;
    if (!frame) return [];
    if (!previous) return frame.traffic;
    const share = this.share(now_ms);
    return frame.traffic.map((to, i) => to && between(previous.traffic[i] ?? to, to, share));
  }

  /** Time without frames while the session runs [ms]; `null` if there is no fault. */
  silence(now_ms: number): number | null {
    if (!this.frame || this.frame.run.paused) return null;
    const silent = now_ms - this.received_ms;
    return silent > STALE_MS ? silent : null;
  }

  /** Index of the vessel that this page steers: the tugmaster's own if she is a vessel, otherwise the ship. */
  conned(): number {
    const role = this.hello?.role;
    const own =
      role?.name === "tugmaster"
        ? (this.hello?.vessels.findIndex((v) => v.name === role.tug) ?? -1)
        : -1;
    return own >= 0 ? own : this.ship();
  }

  /** The ships among which the instructor chooses; none for other roles. */
  choice(): VesselInfo[] {
    const { role, vessels } = this.hello ?? {};
    return role?.name === "instructor" ? (vessels ?? []).filter((v) => !v.is_tug) : [];
  }

  /** Makes the instructor's page one about this ship. */
  choose(name: string): void {
    this.chosen = name;
  }

  /**
   * Index of the ship that the page is about: that of the pilot, the one that a tug serves, the one that the instructor has
   * chosen; else the scenario's own ship.
   */
  ship(): number {
    const { role, vessels = [], tugs = [] } = this.hello ?? {};
    const called = (name: string | null) => vessels.findIndex((v) => v.name === name);
    let named = -1;
    if (role?.name === "pilot") named = called(role.vessel ?? null);
    else if (role?.name === "instructor") named = called(this.chosen);
    else if (role?.name === "tugmaster")
      named =
        tugs.find(({ name }) => name === role.tug)?.vessel ??
        vessels[called(role.tug)]?.serves ??
        -1;
    return Math.max(0, named >= 0 ? named : vessels.findIndex((v) => !v.is_tug));
  }

  /** Index of the body whose motion is read off: that of the vessel that this page steers. */
  readBody(): number {
    return this.hello?.vessels[this.conned()]?.body ?? this.body();
  }

  /** Index of the body that the page is about: the pilot's ship, else the floating body that moved first; -1 if none floats. */
  body(): number {
    return this.hello?.vessels[this.ship()]?.body ?? this.moving ?? -1;
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

/** The bodies of a frame as the eye sees them: an instrument of the own vessel may be frozen. */
const seenIn = ({ bodies, eyes }: Frame): (BodyNow | null)[] =>
  eyes ? bodies.with(eyes.body, eyes.now) : bodies;

/** The fastest floating body. */
function fastest(hello: Hello | null, { bodies }: Frame): number | null {
  let [found, most]: [number | null, number] = [null, -1];
  hello?.bodies.forEach(({ fixed }, i) => {
    const [, , , north, east] = bodies[i] ?? [0, 0, 0, 0, 0];
    const speed = Math.hypot(north, east);
    if (!fixed && speed > most) [found, most] = [i, speed];
  });
  return found;
}

/** Whether a fender is a tug's own: its load is what she pushes with. */
export const isOfTug = ({ body }: FenderInfo, { vessels }: Hello): boolean =>
  vessels.some((vessel) => vessel.is_tug && vessel.body === body);

export function same(a: Control, b: Control): boolean {
  if ("vessel" in a) return "vessel" in b && a.vessel === b.vessel;
  if ("tug" in a) return "tug" in b && a.tug === b.tug;
  return "session" in b;
}

/** The part of the greeting that the page is built from. If it changes, the page is rebuilt; a change of claims does not. */
export function structure(hello: Hello): string {
  const { role, file, bodies, vessels, fenders, lines, tugs, traffic } = hello;
  const { gallery, deleted, links, exercise } = hello;
  return JSON.stringify([
    role,
    file,
    bodies,
    vessels,
    fenders,
    lines,
    tugs,
    traffic,
    gallery,
    deleted,
    links,
    exercise,
  ]);
}
