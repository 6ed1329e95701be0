/** A view. The page calls it at each tick and, if it draws, at each drawing. */
import type { Frame, Hello } from "../protocol";

export interface View {
  root: HTMLElement;
  /** A new tick. */
  tick(frame: Frame, hello: Hello): void;
  /** Claims have changed; the scenario is the same. */
  claims?(hello: Hello): void;
  /** Draws; up to 60 times a second while the view is shown. */
  draw?(now_ms: number): void;
}
