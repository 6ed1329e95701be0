/** The page as views and controls see it. */
import type { Live } from "./live";
import type { Action } from "./protocol";
import type { Trial } from "./trial";

export interface Page {
  live: Live;
  /** While it is on, `order` and `drag` put orders into it in place of giving them. */
  trial: Trial;
  /** Sends a command and shows the reason if it is refused. Resolves to whether it was carried out. */
  order(action: Action): Promise<boolean>;
  /** The same for a dragged control, at a limited rate; its last position is always sent. */
  drag(control: string, action: Action): void;
  /** Asks for a trial. Resolves to the reason of a refusal; the answers go to `trial`. */
  trialOf(action: Action): Promise<string | null>;
  /** Has the server make the report of the session up to now, and opens it in a new tab. */
  report(): Promise<void>;
  /** Shows a message for a while. */
  say(text: string, level?: "note" | "refusal"): void;
  /** Reports an action that a hint may wait for. */
  did(what: string): void;
}
