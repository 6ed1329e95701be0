import { expect, test } from "vitest";
import { firstOffered, fromFairlead } from "../src/lead";
import type { BodyNow, Pair } from "../src/protocol";

/** A ship of 200 m, heading east, port side to a quay 20 m north of her middle line, with bollards 25 m apart. */
const SHIP: BodyNow = [0, 0, Math.PI / 2, 0, 0, 0];
const BOLLARDS = Array.from({ length: 13 }, (_, i) => ({
  name: `b${i + 1}`,
  at: [20, -150 + 25 * i] as Pair,
}));

function offered(
  name: string,
  fairlead: Pair,
  reach_m = 200,
  ship = SHIP,
  before: string | null = null,
): string | undefined {
  const places = BOLLARDS.map(({ name, at }) => {
    const from_fairlead = fromFairlead(ship, fairlead, at);
    return { name, from_fairlead, m: Math.hypot(...from_fairlead) };
  }).toSorted((a, b) => a.m - b.m);
  return firstOffered(name, fairlead, places, (m) => m <= reach_m, before)?.name;
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

// A pilot's ship sprang off her fenders, and the offered bollards changed while he looked: the spring's became the breast line's.
test("an offer stays while the ship moves a little, and a spring never gets the breast line's bollard", () => {
  const off = (m: number): BodyNow => [-m, 0, Math.PI / 2, 0, 0, 0];
  for (const [name, fairlead] of [
    ["forward_spring", [75, -15]],
    ["aft_spring", [-75, -15]],
    ["head", [95, -15]],
    ["fore_breast", [75, -15]],
  ] as [string, Pair][]) {
    const first = offered(name, fairlead);
    for (const m of [2, 5, 8, 5, 2])
      expect(offered(name, fairlead, 200, off(m), first ?? null), `${name}, ${m} m off`).toBe(
        first,
      );
  }
  // 13 m off, with a heaving line of 35 m.
  expect(offered("forward_spring", [75, -15], 35, off(13))).not.toBe(
    offered("fore_breast", [75, -15], 35, off(13)),
  );
});
