/** What every view can do; the page calls it at each tick, and at each drawing where it draws. */
import type { Frame, Hello } from "../protocol";

export interface View {
  root: HTMLElement;
  /** A tick has come. */
  tick(frame: Frame, hello: Hello): void;
  /** Claims have changed; the scenario is the same. */
  claims?(hello: Hello): void;
  /** Up to 60 times a second, only while it is shown. */
  draw?(now_ms: number): void;
}
