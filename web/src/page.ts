/** What views and controls may use of the page. */
import type { Live } from "./live";
import type { Action } from "./protocol";

export interface Page {
  live: Live;
  /** Sends a command; shows the reason where it is refused. Resolves to whether it counts. */
  order(action: Action): Promise<boolean>;
  /** The same for a control that is being dragged: sent now and then, and its last place always. */
  drag(control: string, action: Action): void;
  /** A message that goes by itself. */
  say(text: string, level?: "note" | "refusal"): void;
  /** Something that a hint waits for was done. */
  did(what: string): void;
}
