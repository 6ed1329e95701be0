/** The page as views and controls see it. */
import type { Live } from "./live";
import type { Action } from "./protocol";

export interface Page {
  live: Live;
  /** Sends a command and shows the reason if it is refused. Resolves to whether it was carried out. */
  order(action: Action): Promise<boolean>;
  /** The same for a dragged control, at a limited rate; its last position is always sent. */
  drag(control: string, action: Action): void;
  /** Has the server make the report of the session up to now, and opens it in a new tab. */
  report(): Promise<void>;
  /** Shows a message for a while. */
  say(text: string, level?: "note" | "refusal"): void;
  /** Reports an action that a hint may wait for. */
  did(what: string): void;
}
