/** The websocket: opened with the token of the link and reopened when it breaks; commands and their answers. */
import type { Action, Command, FromServer } from "./protocol";

export type LinkState = "connecting" | "open" | "broken";

export interface Heard {
  message(message: FromServer): void;
  /** `why`: the reason that the server gave for closing; else empty. */
  link(state: LinkState, why: string): void;
}

const FIRST_WAIT_MS = 400;
const LONGEST_WAIT_MS = 4000;
/** Time between two commands of a dragged control. Its last position is always sent. */
const DRAG_MS = 100;
const ANSWER_MS = 5000;
/** The same for what the server works on for a while. */
const WORK_MS = 600_000;

interface Waiting {
  answer(reason: string | null): void;
  timer: number;
}

export class Connection {
  private socket: WebSocket | null = null;
  private wait_ms = FIRST_WAIT_MS;
  private nextId = 1;
  private waiting = new Map<number, Waiting>();
  private dragged = new Map<string, { action: Action | null }>();
  /** Failed attempts since the connection was last open. */
  failures = 0;

  constructor(
    private readonly url: string,
    private readonly heard: Heard,
  ) {}

  open(): void {
    this.heard.link("connecting", "");
    const socket = new WebSocket(this.url);
    this.socket = socket;
    socket.addEventListener("open", () => {
      this.heard.link("open", "");
    });
    socket.addEventListener("message", (event) => {
      if (typeof event.data !== "string") return;
      // A connection that is closed at once is no success: only a message is.
      this.wait_ms = FIRST_WAIT_MS;
      this.failures = 0;
      const message = JSON.parse(event.data) as FromServer;
      if (message.type === "ack") this.answered(message.id, null);
      else if (message.type === "refused" && message.id !== null)
        this.answered(message.id, message.reason);
      else this.heard.message(message);
    });
    socket.addEventListener("close", (event) => {
      this.failures += 1;
      for (const id of this.waiting.keys())
        this.answered(id, "the connection broke before an answer came");
      this.heard.link("broken", event.reason);
      setTimeout(() => this.open(), this.wait_ms);
      this.wait_ms = Math.min(LONGEST_WAIT_MS, this.wait_ms * 2);
    });
  }

  /** Sends a command. Resolves to `null` if it was carried out, to the reason if it was refused. */
  send(action: Action): Promise<string | null> {
    const socket = this.socket;
    if (socket?.readyState !== WebSocket.OPEN)
      return Promise.resolve("there is no connection to the server");
    const id = this.nextId++;
    const command: Command = { type: "command", id, action };
    return new Promise((answer) => {
      const timer = window.setTimeout(
        () => this.answered(id, "the server did not answer"),
        action.do === "report" || action.do === "save" ? WORK_MS : ANSWER_MS,
      );
      this.waiting.set(id, { answer, timer });
      socket.send(JSON.stringify(command));
    });
  }

  /** Sends commands of one control at a limited rate; the last one is always sent. */
  drag(control: string, action: Action, answered: (reason: string | null) => void): void {
    const slot = this.dragged.get(control);
    if (slot) {
      slot.action = action;
      return;
    }
    const fresh: { action: Action | null } = { action: null };
    this.dragged.set(control, fresh);
    void this.send(action).then(answered);
    setTimeout(() => {
      this.dragged.delete(control);
      if (fresh.action) this.drag(control, fresh.action, answered);
    }, DRAG_MS);
  }

  private answered(id: number, reason: string | null): void {
    const waiting = this.waiting.get(id);
    if (!waiting) return;
    this.waiting.delete(id);
    clearTimeout(waiting.timer);
    waiting.answer(reason);
  }
}
