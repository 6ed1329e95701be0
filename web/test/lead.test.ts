import { expect, test } from "vitest";
import { firstOffered, fromFairlead } from "../src/lead";
import type { BodyNow, Pair } from "../src/protocol";

/** A ship of 200 m, heading east, port side to a quay 20 m north of her middle line, with bollards 25 m apart. */
const SHIP: BodyNow = [0, 0, Math.PI / 2, 0, 0, 0];
const BOLLARDS = Array.from({ length: 13 }, (_, i) => ({
  name: `b${i + 1}`,
  at: [20, -150 + 25 * i] as Pair,
}));

function offered(name: string, fairlead: Pair, reach_m = 200): string | undefined {
  const places = BOLLARDS.map(({ name, at }) => {
    const from_fairlead = fromFairlead(SHIP, fairlead, at);
    return { name, from_fairlead, m: Math.hypot(...from_fairlead) };
  }).toSorted((a, b) => a.m - b.m);
  return firstOffered(name, fairlead, places, (m) => m <= reach_m)?.name;
}

test("head and stern lines are offered a bollard beyond their fairlead", () => {
  expect(offered("head_line", [95, -15])).toBe("b11");
  expect(offered("stern_line", [-95, -15])).toBe("b3");
});

test("a spring is offered a bollard towards the other end of the ship, another than the breast line's", () => {
  expect(offered("forward_spring", [75, -15])).toBe("b9");
  expect(offered("aft_spring", [-75, -15])).toBe("b5");
  expect(offered("aft_breast", [-75, -15])).toBe("b4");
});

test("a breast line that is called by an end of the ship is offered the nearest bollard", () => {
  expect(offered("bow_breast", [75, -15])).toBe("b10");
  expect(offered("stern breast", [-75, -15])).toBe("b4");
});

test("without a bollard within reach in this direction the nearest is offered", () => {
  expect(offered("aft_spring", [-75, -15], 8)).toBe("b4");
});
