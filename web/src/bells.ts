/** Which sound is due: alarms until they are acknowledged, and the answer to an engine order. */
import type { Alarm } from "./protocol";

export interface Tone {
  hz: number;
  /** From the beginning of the sound, and for how long [s]. */
  at_s: number;
  for_s: number;
}

/** An alarm: three short tones; a caution: one low one; each again after this time [ms]. */
const ALARM: Tone[] = [0, 0.22, 0.44].map((at_s) => ({ hz: 880, at_s, for_s: 0.14 }));
const CAUTION: Tone[] = [{ hz: 440, at_s: 0, for_s: 0.3 }];
const AGAIN_MS: Record<Alarm["level"], number> = { alarm: 2000, caution: 8000 };
/** The bell of an engine telegraph. */
const ANSWER: Tone[] = [
  { hz: 1320, at_s: 0, for_s: 0.1 },
  { hz: 990, at_s: 0.13, for_s: 0.22 },
];
const ANSWERS_APART_MS = 400;
/** Orders that differ by less are one [share of full revolutions]. */
const SAME_ORDER = 0.005;

export class Bells {
  private level: Alarm["level"] | null = null;
  private rung_ms = -Infinity;
  private order: number | null = null;
  private answered_ms = -Infinity;

  /** For another scenario. */
  forget(): void {
    this.order = null;
  }

  /** `worst`: the worst level of the alarms that nobody has acknowledged. */
  alarm(worst: Alarm["level"] | null, now_ms: number): Tone[] | null {
    const graver = worst === "alarm" && this.level !== "alarm";
    this.level = worst;
    if (worst === null || (!graver && now_ms - this.rung_ms < AGAIN_MS[worst])) return null;
    this.rung_ms = now_ms;
    return worst === "alarm" ? ALARM : CAUTION;
  }

  /** `order`: the engine order that the server has; `byHand`: no pilot keeps her speed by it. */
  engine(order: number | null, byHand: boolean, now_ms: number): Tone[] | null {
    const before = this.order;
    this.order = order;
    if (before === null || order === null || !byHand) return null;
    if (Math.abs(order - before) < SAME_ORDER || now_ms - this.answered_ms < ANSWERS_APART_MS)
      return null;
    this.answered_ms = now_ms;
    return ANSWER;
  }
}
