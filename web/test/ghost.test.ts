import { expect, test } from "vitest";
import { ghostAt, ghostText } from "../src/ghost";
import type { Ghost } from "../src/protocol";

const ghost: Ghost = {
  ship: "Made_Up_Star",
  file: "log.csv",
  outline: [],
  points: [
    [10, 0, 0, 6.2],
    [20, 10, -20, 0.1],
    [40, 10, 0, 0.1],
  ],
  touch_s: 20,
};

test("the measured ship goes straight between the points of her track, the short way round", () => {
  const [t_s, north, east, heading] = ghostAt(ghost, 15) ?? [];
  expect([t_s, north, east]).toEqual([15, 5, -10]);
  expect(heading).toBeCloseTo(6.2 + (0.1 + 2 * Math.PI - 6.2) / 2, 9);
  expect(ghostAt(ghost, 20)?.slice(0, 3)).toEqual([20, 10, -20]);
  expect(ghostAt(ghost, 30)?.slice(0, 3)).toEqual([30, 10, -10]);
});

test("before and after her track she waits at its ends", () => {
  expect(ghostAt(ghost, 0)).toBe(ghost.points[0]);
  expect(ghostAt(ghost, 50)).toBe(ghost.points[2]);
  expect(ghostAt({ ...ghost, points: [] }, 0)).toBeNull();
});

test("her label says who she is and when she touches", () => {
  const at = (t_s: number) => ghostText(ghost, t_s);
  expect(at(0)).toBe("measured Made Up Star: begins in 0:00:10");
  expect(at(15)).toBe("measured Made Up Star: touch in 0:00:05");
  expect(at(32)).toBe("measured Made Up Star: touched 0:00:12 ago");
  expect(at(41)).toBe("measured Made Up Star: the log has ended");
  expect(ghostText({ ...ghost, ship: "", touch_s: null }, 30)).toBe(
    "measured: 0:00:20 since the start of the log",
  );
});
