/**
 * The orders of the table in `crates/world/src/order/table.rs`: their arguments as types, and what the page does with each.
 * Limits, units and words come from the server, in `Hello.orders`. `crates/live/tests/protocol.rs` compares names and
 * fields with the program's table; an order that is missing below does not compile.
 */
import type { Hello, Pair } from "./protocol";

/** Each order with its target and its arguments; units are SI. */
export interface Orders {
  rudder: { vessel: string; angle_rad: number };
  engine: { vessel: string; share: number };
  thruster: { vessel: string; name: string; power: number };
  azimuth: { vessel: string; name: string; power: number | null; direction_rad: number | null };
  course: { vessel: string; heading_rad: number };
  speed: { vessel: string; speed_mps: number };
  // prettier-ignore
  station: { vessel: string; position_m: Pair; heading_rad: number; surge_mps?: number; sway_mps?: number };
  // prettier-ignore
  push_ship: { vessel: string; ship: string; at_m: Pair; force_n: number; speed_mps?: number };
  // prettier-ignore
  pull_ship: { vessel: string; line: string; force_n: number; direction_rad: number; speed_mps?: number };
  // prettier-ignore
  follow_ship: { vessel: string; ship: string; at_m: Pair; heading_rad?: number; speed_mps?: number };
  hands: { vessel: string };
  push: { tug: string; force_n: number; direction_rad?: number };
  pull: { tug: string; force_n: number; direction_rad?: number };
  stand_by: { tug: string };
  heave: { line: string; rate_mps: number };
  pay_out: { line: string; rate_mps: number };
  hold: { line: string };
  send: { line: string; bollard: string };
  let_go: { line: string };
  let_go_anchor: { anchor: string; chain_m: number };
  veer: { anchor: string; chain_m: number };
  heave_in: { anchor: string; chain_m: number };
  hold_chain: { anchor: string };
  slip: { anchor: string };
}

export type OrderName = keyof Orders;

/** An order as it is sent. */
export type Order = { [Name in OrderName]: { do: Name } & Orders[Name] }[OrderName];

/** Cards of the helm that may show a button for an order to the vessel. */
export type Card = "rudder" | "engine" | "thrusters";

interface OnPage {
  /** The hint that ends with this order. */
  hint: string | null;
  button?: { card: Card; text: string };
}

/**
 * How the page uses each order. A `button` is for an order to a vessel without further arguments; it is shown if the
 * vessel has the gear for it. Another order with a `button` does not compile.
 */
export const ON_PAGE: {
  [Name in OrderName]: Name extends PlainOrder
    ? OnPage
    : Omit<OnPage, "button"> & { button?: never };
} = {
  rudder: { hint: "rudder" },
  engine: { hint: "engine" },
  thruster: { hint: "thruster" },
  azimuth: { hint: "tug" },
  course: { hint: "course" },
  speed: { hint: "speed" },
  station: { hint: null },
  push_ship: { hint: "tug" },
  pull_ship: { hint: "tug" },
  follow_ship: { hint: "tug" },
  hands: { hint: "hands" },
  push: { hint: "tug" },
  pull: { hint: "tug" },
  stand_by: { hint: "tug" },
  heave: { hint: null },
  pay_out: { hint: null },
  hold: { hint: null },
  send: { hint: null },
  let_go: { hint: null },
  let_go_anchor: { hint: null },
  veer: { hint: null },
  heave_in: { hint: null },
  hold_chain: { hint: null },
  slip: { hint: null },
};

export const isOrder = (word: string): word is OrderName => Object.hasOwn(ON_PAGE, word);

/** Orders to a vessel without further arguments. */
type PlainOrder = {
  [Name in OrderName]: { vessel: string } extends Orders[Name] ? Name : never;
}[OrderName];

/** The orders to a vessel that have a button on a card. */
export function buttonsOn(card: Card): { order: PlainOrder; text: string }[] {
  return Object.entries<OnPage>(ON_PAGE).flatMap(([name, { button }]) =>
    button?.card === card ? [{ order: name as PlainOrder, text: button.text }] : [],
  );
}

/** The server's limits for a number of an order. */
export function limits<Name extends OrderName>(
  hello: Hello,
  order: Name,
  field: keyof Orders[Name] & string,
): Pair {
  const info = hello.orders.find(({ name }) => name === order);
  const found = info?.arguments.find(({ name }) => name === field)?.limits;
  if (!found) throw new Error(`the server has no limits for ${field} of ${order}`);
  return found;
}

/** Names of orders that only the page or only the server has; none if both are of one version. */
export function unknownOrders(hello: Hello): string[] {
  const theirs = hello.orders.map(({ name }) => name);
  return [
    ...theirs.filter((name) => !isOrder(name)),
    ...Object.keys(ON_PAGE).filter((name) => !theirs.includes(name)),
  ];
}
