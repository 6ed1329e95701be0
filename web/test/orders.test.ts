import { expect, test } from "vitest";
import { ON_PAGE, limits, unknownOrders } from "../src/orders";
import type { ArgumentInfo, Hello, OrderInfo } from "../src/protocol";

const angle: ArgumentInfo = {
  name: "angle_rad",
  kind: "number",
  unit: "rad",
  limits: [-1, 1],
  default: null,
  required: true,
  meaning: "rudder angle",
};
const order = (name: string): OrderInfo => ({
  name,
  target: "vessel",
  needs: null,
  meaning: name,
  arguments: name === "rudder" ? [angle] : [],
});
const hello = (names: string[]) => ({ orders: names.map(order) }) as Hello;

test("limits are those of the server", () => {
  expect(limits(hello(["rudder"]), "rudder", "angle_rad")).toEqual([-1, 1]);
  expect(() => limits(hello([]), "rudder", "angle_rad")).toThrow("no limits");
});

test("orders that only the page or only the server knows are found", () => {
  const all = Object.keys(ON_PAGE);
  expect(unknownOrders(hello(all))).toEqual([]);
  expect(unknownOrders(hello([...all, "fly"]))).toEqual(["fly"]);
  expect(unknownOrders(hello(all.filter((name) => name !== "rudder")))).toEqual(["rudder"]);
});
