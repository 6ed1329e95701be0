/**
 * Trial manoeuvre: while it is on, orders from the page's controls are not given but collected, and the server shows where they
 * would take the ships. "Give" then sends them.
 */
import { isOrder } from "./orders";
import type { Action, Trial as Answer, TrialOrder } from "./protocol";

/** The server's limit. */
const MOST_ORDERS = 16;

export const isTried = (action: Action): action is TrialOrder =>
  isOrder(action.do) || action.do === "tug";

/** Orders with one key replace each other: those to one engine, rudder, thruster, tug or line. */
export function keyOf(order: TrialOrder): string {
  switch (order.do) {
    case "tug":
      return `tug ${order.tug}`;
    case "push":
    case "pull":
    case "stand_by":
      return `tug ${order.tug}`;
    case "thruster":
    case "azimuth":
      return `${order.do} ${order.vessel} ${order.name}`;
    // A course takes the rudder from the hand, and the other way round.
    case "rudder":
    case "course":
      return `steering ${order.vessel}`;
    case "engine":
    case "speed":
      return `engine ${order.vessel}`;
    case "heave":
    case "pay_out":
    case "hold":
    case "send":
    case "let_go":
      return `line ${order.line}`;
    case "let_go_anchor":
    case "veer":
    case "heave_in":
    case "hold_chain":
    case "slip":
      return `anchor ${order.anchor}`;
    default:
      return `whole ${order.vessel}`;
  }
}

export class Trial {
  on = false;
  horizon_s = 300;
  orders: TrialOrder[] = [];
  /** The last answer of the server to the present orders. */
  answer: Answer | null = null;
  /** Why the server refused the present orders. */
  refused: string | null = null;

  /** Takes an order in place of giving it. Returns whether it was taken: not while there is no trial. */
  take(action: Action): boolean {
    if (!this.on || !isTried(action)) return false;
    const key = keyOf(action);
    const others = this.orders.filter((order) => keyOf(order) !== key);
    this.orders = [...others, action].slice(-MOST_ORDERS);
    this.refused = null;
    return true;
  }

  /** Takes an answer of the server. One to earlier orders may come late. */
  heard(answer: Answer): void {
    if (!this.on || this.orders.length === 0 || answer.id < (this.answer?.id ?? 0)) return;
    // The first answer to new orders may hold a few seconds only: the last one stays until there is more.
    if (answer.paths.every(({ path }) => path.length < 2)) return;
    this.answer = answer;
  }

  drop(order: TrialOrder): void {
    this.orders = this.orders.filter((other) => other !== order);
    if (this.orders.length === 0) this.answer = null;
    this.refused = null;
  }

  clear(): void {
    this.orders = [];
    this.answer = null;
    this.refused = null;
  }

  end(): void {
    this.on = false;
    this.clear();
  }
}
