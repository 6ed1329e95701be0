import { expect, test } from "vitest";
import {
  clock,
  distance,
  fenderLoad,
  fixed,
  force,
  heading,
  knots,
  rateOfTurn,
  sided,
  tonnes,
  spokenFinding,
  wrapped,
  relative,
} from "../src/units";

const RAD = Math.PI / 180;

test("a heading has three digits and is never 360", () => {
  expect(heading(0)).toBe("000.0°");
  expect(heading(7.25 * RAD, 1)).toMatch(/^007\.[23]°$/);
  expect(heading(359.97 * RAD)).toBe("000.0°");
  expect(heading(-10 * RAD, 0)).toBe("350°");
  expect(heading(359.6 * RAD, 0)).toBe("000°");
});

test("angles are wrapped into (−π, π]", () => {
  expect(wrapped(3 * Math.PI)).toBeCloseTo(Math.PI, 12);
  expect(wrapped(-1.5 * Math.PI)).toBeCloseTo(0.5 * Math.PI, 12);
  expect(wrapped(0.1)).toBeCloseTo(0.1, 12);
});

test("zero has no minus sign", () => {
  expect(fixed(-0.04, 1)).toBe("0.0");
  expect(fixed(-0.06, 1)).toBe("-0.1");
});

test("rudder angles have a side, midships has none", () => {
  expect(sided(-10 * RAD)).toBe("P 10°");
  expect(sided(20 * RAD)).toBe("S 20°");
  expect(sided(-0.2 * RAD)).toBe("0°");
});

test("values are in the units of a bridge", () => {
  expect(knots(1852 / 3600)).toBe("1.0 kn");
  expect(tonnes(9806.65)).toBe("1.0 t");
  expect(tonnes(60 * 9806.65)).toBe("60 t");
  expect(force(999e3)).toBe("999 kN");
  expect(force(1.5e6)).toBe("1.50 MN");
  expect(rateOfTurn(RAD / 60)).toBeCloseTo(1, 12);
  expect(clock(3725.9)).toBe("1:02:05");
});

test("a distance is in metres near by, with cables farther off, and in miles at sea", () => {
  expect(distance(7.34)).toBe("7.3 m");
  expect(distance(99.96)).toBe("100 m (0.5 cables)");
  expect(distance(185.2)).toBe("185 m (1.0 cables)");
  expect(distance(1500)).toBe("1500 m (8.1 cables)");
  expect(distance(1852)).toBe("1.00 NM");
  expect(distance(4630)).toBe("2.50 NM");
});

test("the load of a tug's own fender has the unit of her push", () => {
  expect(fenderLoad(30 * 9806.65, true)).toBe(tonnes(30 * 9806.65));
  expect(fenderLoad(300e3, false)).toBe("300 kN");
});

test("a sentence of the verdict has the times of the page's clock, and no names of keys", () => {
  expect(spokenFinding("Line aft_spring parted at 636.0 s under 1204 kN")).toBe(
    "Line aft spring parted at 0:10:36 under 1204 kN",
  );
  expect(spokenFinding("ship was aground from 61.5 s for 12.0 s")).toBe(
    "ship was aground from 0:01:01 for 12.0 s",
  );
});

test("a direction from the bow is never read as south", () => {
  const DEG = Math.PI / 180;
  expect([0, 90, -90, 180, -179.8].map((degrees) => relative(degrees * DEG))).toEqual([
    "ahead",
    "stb 90°",
    "port 90°",
    "astern",
    "astern",
  ]);
});
