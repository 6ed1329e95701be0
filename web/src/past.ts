/** Asks the server for what was before: after the first frame, and after each jump in time. */
import type { Frame } from "./protocol";

/** More ticks than this between two frames are a gap in the charts. */
const GAP_TICKS = 50;
/** The server answers a page once a second. */
const BETWEEN_MS = 1200;
const MOST_TRIES = 3;

export class PastRequests {
  private last: { tick: number; branch: number } | null = null;
  private waiting = false;
  private asked_ms = -Infinity;

  /** `request`: sends the request; resolves to the reason if it was refused. */
  constructor(private readonly request: () => Promise<string | null>) {}

  /** The next frame is the first one: of another scenario, or of another connection. */
  forget(): void {
    this.last = null;
  }

  frame({ tick, run: { branch } }: Frame): void {
    const { last } = this;
    this.last = { tick, branch };
    const went = last && last.branch === branch ? tick - last.tick : -1;
    if (went < 0 || went > GAP_TICKS) this.ask();
  }

  /** Asks, at once or when the server answers again. Of several requests meanwhile one remains. */
  private ask(tries = MOST_TRIES): void {
    if (this.waiting) return;
    this.waiting = true;
    const wait_ms = Math.max(0, this.asked_ms + BETWEEN_MS - performance.now());
    setTimeout(async () => {
      this.waiting = false;
      this.asked_ms = performance.now();
      const refused = await this.request();
      if (refused !== null && tries > 1) this.ask(tries - 1);
    }, wait_ms);
  }
}
